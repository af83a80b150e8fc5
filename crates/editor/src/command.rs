//! Commands: everything a user can do to a document, as values with a JSON form.
//!
//! One operation per file, named after it. Each is a small struct whose fields are those of the
//! JSON object `{"op": "<name>", ...fields}`, with a [`Spec`] that menus, the palette, panels and
//! the documentation are generated from.

mod bezier;
mod fields;
mod live;
mod run;
mod spec;
mod subdivide;
mod whole;

pub use fields::{EdgeRef, FaceRef, HalfedgeRef, VertexRef};
pub use live::Mode;
pub(crate) use run::{
    Action, Commit, DocumentEdit, Input, LocalEdit, Output, Place, Target, WholeMesh, edit_all, refuse_bezier,
};
pub use separate::By;
pub use smooth::SmoothMethod;
pub use spec::{Field, FieldKind, OperationKind, Spec};
pub use split_edge::Connect;
pub use subdivide::Boundary;
pub use subdivide_catmull_clark::VertexRule;
pub use subdivide_loop::Weights;
pub use transform::{Rotate, Scale};
pub use triangulate_faces::Method;

use crate::error::{CommandError, Problem};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// What every operation is.
pub(crate) trait Operation: Sized {
    /// Its name, texts and fields.
    const SPEC: Spec;

    /// Reads its fields from JSON.
    fn parse(fields: Map<String, Value>) -> Result<Self, Problem>;

    /// Its fields as a JSON object.
    fn to_fields(&self) -> Value;

    /// Fills in what was left out from the selection. An operation on one element that several
    /// selected ones stand in for becomes several operations, made in one step.
    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        let _ = target;
        Ok(vec![self])
    }

    /// Whether it is for all of one mesh, rather than for some of its elements or for the document.
    fn is_for_whole_meshes(&self) -> bool {
        Self::SPEC.kind == OperationKind::WholeMesh
    }

    /// How it is carried out.
    fn action(&self) -> Action<'_>;
}

/// How an operation that is a plain `serde` struct reads and writes its fields.
macro_rules! fields_by_serde {
    () => {
        fn parse(fields: serde_json::Map<String, serde_json::Value>) -> Result<Self, $crate::error::Problem> {
            $crate::command::from_fields(fields)
        }

        fn to_fields(&self) -> serde_json::Value {
            // Plain data with text keys: this can't fail.
            serde_json::to_value(self).unwrap_or_default()
        }
    };
}

macro_rules! operations {
    ($($module:ident :: $name:ident),* $(,)?) => {
        $(mod $module;)*
        $(pub use $module::$name;)*

        /// An operation with its fields.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Op {
            $(#[doc = concat!("`", stringify!($module), "`, with hyphens.")] $name($name),)*
        }

        $(impl From<$name> for Op {
            fn from(op: $name) -> Self {
                Self::$name(op)
            }
        }

        impl From<$name> for Command {
            fn from(op: $name) -> Self {
                Self { object: None, op: op.into() }
            }
        })*

        /// Every operation there is, in the order menus list them.
        pub static OPERATIONS: &[&Spec] = &[$(&<$name as Operation>::SPEC),*];

        impl Op {
            /// The operation's name, texts and fields.
            pub fn spec(&self) -> &'static Spec {
                match self {
                    $(Self::$name(_) => &<$name as Operation>::SPEC,)*
                }
            }

            fn parse(name: &str, fields: Map<String, Value>) -> Option<Result<Self, Problem>> {
                $(if name == <$name as Operation>::SPEC.name {
                    return Some(<$name as Operation>::parse(fields).map(Self::$name));
                })*
                None
            }

            fn to_fields(&self) -> Value {
                match self {
                    $(Self::$name(op) => op.to_fields(),)*
                }
            }

            pub(crate) fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
                match self {
                    $(Self::$name(op) => Ok(op.resolve(target)?.into_iter().map(Self::$name).collect()),)*
                }
            }

            fn is_for_whole_meshes(&self) -> bool {
                match self {
                    $(Self::$name(op) => op.is_for_whole_meshes(),)*
                }
            }

            pub(crate) fn action(&self) -> Action<'_> {
                match self {
                    $(Self::$name(op) => op.action(),)*
                }
            }
        }
    };
}

operations! {
    set_vertex_position::SetVertexPosition,
    transform::Transform,
    set_face_color::SetFaceColor,
    split_edge::SplitEdge,
    flip_edge::FlipEdge,
    collapse_edge::CollapseEdge,
    collapse_face::CollapseFace,
    split_vertex::SplitVertex,
    dissolve_vertex::DissolveVertex,
    dissolve_edge::DissolveEdge,
    delete_faces::DeleteFaces,
    delete_vertices::DeleteVertices,
    triangulate_faces::TriangulateFaces,
    poke_faces::PokeFaces,
    connect_vertices::ConnectVertices,
    extrude_faces::ExtrudeFaces,
    extrude_edges::ExtrudeEdges,
    inset_faces::InsetFaces,
    bevel_edges::BevelEdges,
    bevel_vertices::BevelVertices,
    loop_cut::LoopCut,
    fill_hole::FillHole,
    bridge::Bridge,
    merge_vertices::MergeVertices,
    weld_edges::WeldEdges,
    rip_edges::RipEdges,
    flip_orientation::FlipOrientation,
    set_crease::SetCrease,
    subdivide_catmull_clark::SubdivideCatmullClark,
    subdivide_loop::SubdivideLoop,
    subdivide_linear::SubdivideLinear,
    simplify::Simplify,
    remesh::Remesh,
    smooth::Smooth,
    merge_by_distance::MergeByDistance,
    repair_import::RepairImport,
    new::New,
    bezier_tessellate::BezierTessellate,
    bezier_move_point::BezierMovePoint,
    bezier_insert_point::BezierInsertPoint,
    bezier_delete_point::BezierDeletePoint,
    bezier_elevate_degree::BezierElevateDegree,
    bezier_split::BezierSplit,
    activate_object::ActivateObject,
    rename_object::RenameObject,
    set_object_visible::SetObjectVisible,
    delete_object::DeleteObject,
    join_objects::JoinObjects,
    separate::Separate,
}

/// A command: an operation, and which object it is for.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// The place of the object in the document's list; none for the active one.
    pub object: Option<usize>,
    /// What to do.
    pub op: Op,
}

impl Command {
    /// Reads a command's JSON.
    ///
    /// # Errors
    /// Names the op, and the field where one is missing, unknown, of the wrong type or not finite.
    pub fn from_json(text: &str) -> Result<Self, CommandError> {
        let value = serde_json::from_str(text)
            .map_err(|error| CommandError::refused("command", format!("this is not JSON: {error}")))?;
        Self::from_value(value)
    }

    /// Reads a command from parsed JSON; see [`Command::from_json`].
    pub fn from_value(value: Value) -> Result<Self, CommandError> {
        let Value::Object(mut fields) = value else {
            return Err(CommandError::refused(
                "command",
                "a command is a JSON object such as {\"op\": \"split-edge\", \"edge\": 3}",
            ));
        };
        let fail =
            |op: &str, field: &str, text: String| Err(CommandError::of(op, Problem::field(field, text)));
        let name = match fields.remove("op") {
            Some(Value::String(name)) => name,
            Some(other) => {
                return fail("command", "op", format!("{other} is not the name of an op, in quotes"));
            }
            None => return fail("command", "op", "is missing: it names what to do".into()),
        };
        let object = match fields.remove("object") {
            None => None,
            Some(value) => match value.as_u64().and_then(|at| usize::try_from(at).ok()) {
                Some(at) => Some(at),
                None => {
                    return fail(&name, "object", format!("{value} is not the place of an object (0, 1, …)"));
                }
            },
        };
        match Op::parse(&name, fields) {
            Some(Ok(op)) => Ok(Self { object, op }),
            Some(Err(problem)) => Err(CommandError::of(name, problem)),
            None => Err(CommandError::refused(&*name, unknown(&name))),
        }
    }

    /// The command's JSON, which reads back as the same command.
    pub fn to_value(&self) -> Value {
        let mut object = Map::new();
        object.insert("op".into(), self.name().into());
        if let Some(at) = self.object {
            object.insert("object".into(), at.into());
        }
        if let Value::Object(fields) = self.op.to_fields() {
            object.extend(fields);
        }
        Value::Object(object)
    }

    /// The command's JSON as text.
    pub fn to_json(&self) -> String {
        self.to_value().to_string()
    }

    /// The op's name.
    pub fn name(&self) -> &'static str {
        self.op.spec().name
    }

    /// Whether the command names no object and is for all of a mesh rather than for some of its
    /// elements or for the list of objects: the command line runs such a command on every object.
    pub fn is_for_whole_meshes(&self) -> bool {
        self.object.is_none() && self.op.is_for_whole_meshes()
    }

    /// The same command for the object at this place of the document's list.
    #[must_use]
    pub fn on(self, object: usize) -> Self {
        Self { object: Some(object), ..self }
    }
}

/// Says that an op is not known, with the names that look like it.
fn unknown(name: &str) -> String {
    let near = OPERATIONS
        .iter()
        .map(|spec| spec.name)
        .find(|known| known.contains(name) || name.contains(known) || known.replace('-', "_") == name);
    match near {
        Some(near) if !name.is_empty() => format!("there is no such op; did you mean `{near}`?"),
        _ => "there is no such op".to_owned(),
    }
}

/// Reads an operation's fields, naming the one at fault.
fn from_fields<T: DeserializeOwned>(fields: Map<String, Value>) -> Result<T, Problem> {
    serde_path_to_error::deserialize(Value::Object(fields)).map_err(|error| {
        let path = error.path().to_string();
        let text = error.into_inner().to_string();
        let quoted = |prefix: &str| Some(text.strip_prefix(prefix)?.split('`').next()?.to_owned());
        if let Some(field) = quoted("missing field `") {
            let field = if path == "." { field } else { format!("{path}.{field}") };
            return Problem::field(field, "is missing");
        }
        if quoted("unknown field `").is_some() {
            let known = text.split_once("expected ").map_or("", |(_, known)| known);
            let text = match known {
                "" => "is not a field of this op, which has none".to_owned(),
                known => format!("is not a field of this op; expected {known}"),
            };
            return Problem::field(path, text);
        }
        if let Some((given, known)) =
            text.strip_prefix("unknown variant ").and_then(|rest| rest.split_once(", expected "))
        {
            return Problem::field(path, format!("{given} is not a choice; expected {known}"));
        }
        let text = in_plain_words(&text).unwrap_or(text);
        if path == "." { Problem::new(text) } else { Problem::field(path, text) }
    })
}

/// What serde says about a value that doesn't fit, without the names of Rust's types.
fn in_plain_words(text: &str) -> Option<String> {
    if let Some(rest) = text.strip_prefix("invalid length ") {
        let (length, expected) = rest.split_once(", expected ")?;
        return Some(match expected.strip_prefix("an array of length ") {
            Some(wanted) => format!("a list of {length} values; expected {wanted}"),
            None if expected == "fewer elements in array" => {
                format!("a list of {length} values is too long")
            }
            None => format!("a list of {length} values; expected {expected}"),
        });
    }
    let rest = text.strip_prefix("invalid type: ").or_else(|| text.strip_prefix("invalid value: "))?;
    let (given, expected) = rest.split_once(", expected ")?;
    let given = match given.split_once(' ').unwrap_or((given, "")) {
        ("map", _) => "an object",
        ("sequence", _) => "a list",
        ("integer" | "boolean", value) => value.trim_matches('`'),
        ("floating", value) => value.trim_start_matches("point ").trim_matches('`'),
        ("string", value) => value,
        _ => given,
    };
    let expected = match expected {
        "f64" | "f32" => "a number",
        "a sequence" => "a list",
        "a boolean" => "true or false",
        "a map" => "an object",
        "unit" | "unit variant" => "a name alone",
        other => match other.strip_prefix("an array of length ") {
            Some(length) => return Some(format!("{given} is not a list of {length} numbers")),
            None => other,
        },
    };
    Some(format!("{given} is not {expected}"))
}
