//! `new`: a shape to start from.

use super::{
    Action, Commit, Field, FieldKind, Input, Operation, OperationKind, Output, Place, Spec, WholeMesh,
};
use crate::document::ObjectId;
use crate::error::Problem;
use halfedge::Progress;
use serde_json::{Map, Value};
use surface::{Shape, SurfaceError};

/// Starts a new document with a shape, or adds the shape to the document.
#[derive(Clone, Debug, PartialEq)]
pub struct New {
    /// The shape with its sizes.
    pub shape: Shape,
    /// Whether the document stays and the shape becomes another object of it.
    pub add: bool,
}

const NUMBER: FieldKind = FieldKind::Number { min: 1e-6, max: 1e6 };
const COUNT: FieldKind = FieldKind::Integer { min: 0, max: 4096 };

impl Operation for New {
    const SPEC: Spec = Spec {
        name: "new",
        label: "New",
        description: "Starts a new document with a shape, or adds the shape to this one.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new(
                "shape",
                FieldKind::Choice(&[
                    "cube",
                    "tetrahedron",
                    "octahedron",
                    "icosahedron",
                    "dodecahedron",
                    "uv-sphere",
                    "ico-sphere",
                    "torus",
                    "cylinder",
                    "cone",
                    "plane",
                    "grid",
                    "teapot",
                ]),
                "Which shape",
            ),
            Field::new("add", FieldKind::Flag, "Whether it is added to the document").or("false"),
            Field::new("size", NUMBER, "The length of its sides").or("by shape"),
            Field::new("radius", NUMBER, "How far it goes from its centre or axis").or("by shape"),
            Field::new("tube_radius", NUMBER, "The radius of a torus' tube").or("by shape"),
            Field::new("height", NUMBER, "How high it is").or("by shape"),
            Field::new("segments", COUNT, "How many faces there are around").or("by shape"),
            Field::new("tube_segments", COUNT, "How many faces there are around a tube").or("by shape"),
            Field::new("rings", COUNT, "How many rows of faces there are").or("by shape"),
            Field::new("subdivisions", COUNT, "How often an icosahedron is subdivided").or("by shape"),
            Field::new("columns", COUNT, "How many faces there are in a row").or("by shape"),
            Field::new("rows", COUNT, "How many rows of faces there are").or("by shape"),
        ],
    };

    fn parse(mut fields: Map<String, Value>) -> Result<Self, Problem> {
        let names = || Shape::names().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let mut shape = match fields.remove("shape") {
            None => return Err(Problem::field("shape", format!("is missing; it is one of {}", names()))),
            Some(Value::String(name)) => Shape::named(&name).ok_or_else(|| {
                Problem::field("shape", format!("`{name}` is not a shape; it is one of {}", names()))
            })?,
            Some(other) => {
                return Err(Problem::field(
                    "shape",
                    format!("{other} is not the name of a shape, in quotes"),
                ));
            }
        };
        let add = match fields.remove("add") {
            None => false,
            Some(Value::Bool(add)) => add,
            Some(other) => return Err(Problem::field("add", format!("{other} is not true or false"))),
        };
        for (field, value) in fields {
            if shape.get(&field).is_none() {
                let known: Vec<String> = shape.fields().iter().map(|f| format!("`{}`", f.name)).collect();
                let known = known.join(", ");
                let text = format!("is not a field of the shape `{}`; it has `shape`, `add`, {known}", shape.name());
                return Err(Problem::field(field, text));
            }
            let number =
                value.as_f64().ok_or_else(|| Problem::field(&*field, format!("{value} is not a number")))?;
            shape.set(&field, number)?;
        }
        Ok(Self { shape, add })
    }

    fn to_fields(&self) -> Value {
        let mut fields = Map::new();
        fields.insert("shape".into(), self.shape.name().into());
        if self.add {
            fields.insert("add".into(), true.into());
        }
        for field in self.shape.fields() {
            let value = self.shape.get(field.name).unwrap_or(field.default);
            let value = if field.whole { Value::from(value as u64) } else { Value::from(value) };
            fields.insert(field.name.into(), value);
        }
        Value::Object(fields)
    }

    fn is_for_whole_meshes(&self) -> bool {
        false
    }

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for New {
    fn compute(
        &self,
        _inputs: &[Input],
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem> {
        if progress(0.0).is_break() {
            return Err(Problem::cancelled());
        }
        let mesh = self.shape.build().map_err(|error| match error {
            SurfaceError::TooManyFaces { faces, limit } => Problem::new(format!(
                "the shape would have {faces} faces, more than the {limit} that fit; give smaller counts"
            )),
            other => other.into(),
        })?;
        Ok(vec![Output::new(title(self.shape.name()), mesh)])
    }

    fn cost(&self, _inputs: &[Input]) -> usize {
        usize::try_from(self.shape.face_count()).unwrap_or(usize::MAX)
    }

    fn objects(&self, place: &Place<'_>) -> Result<Vec<ObjectId>, Problem> {
        match place.object {
            Some(_) => Err(Problem::field("object", "does not go with this op, which makes an object")),
            None => Ok(Vec::new()),
        }
    }

    fn commit(&self) -> Commit {
        if self.add { Commit::NewObject } else { Commit::NewDocument }
    }
}

/// What the object is called: "Ico sphere".
fn title(shape: &str) -> String {
    let words = shape.replace('-', " ").replace("uv ", "UV ");
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
