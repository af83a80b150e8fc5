//! Operations: everything a user can do to a document.
//!
//! One operation per file, named after it. Each is a small struct whose fields are those of the JSON
//! object `{"op": "<name>", ...fields}`, with a [`Spec`] that everything else is made from: menus, the
//! palette, forms, greying, previews, the operations reference and `meshwright --help`.
//!
//! To add one: write its file in the folder of its group, and name it in `operations!` below. Its place
//! there is its place in menus.

mod action;
mod choice;
mod command;
mod facts;
mod field;
mod json;
mod refs;
mod spec;
mod symmetry;
mod target;
mod wording;

pub(crate) use action::{
    Action, Commit, DocumentEdit, LocalEdit, Operation, Place, SelectEdit, WholeMesh, edges_between_created,
    edit_all, refuse_bezier,
};
pub use choice::Choice;
pub use command::Command;
pub use facts::{Amount, Counted, Estimate, Facts};
pub use field::{Arity, DefaultValue, Drag, Ends, Field, FieldKind, Fill, Selected, Suggestion, Unit};
pub(crate) use formats::NamedMesh;
use json::Fields;
pub(crate) use json::in_plain_words;
pub use refs::{EdgeRef, FaceRef, HalfedgeRef, VertexRef};
pub use spec::{Family, Scope, Spec};
pub use symmetry::Symmetry;
pub(crate) use symmetry::{Mirror, Mirroring, Reflection, SYMMETRY, edit_symmetric};
pub(crate) use target::{Slot, Target};
pub use wording::{four_digits, sentence_case};

use crate::error::Problem;
use halfedge::Mesh;
use serde_json::{Map, Value};
use surface::MirrorImages;

macro_rules! operations {
    ($($(#[$doc:meta])* $group:ident [$($helper:ident),*] { $($module:ident::$name:ident),* $(,)? })*) => {
        $($(#[$doc])*
        pub mod $group {
            $(mod $helper;)*
            $(mod $module;
            pub use $module::*;)*
        }
        pub use $group::*;)*

        enumerate! { $($($name),*),* }
    };
}

macro_rules! enumerate {
    ($($name:ident),* $(,)?) => {
        /// An operation with its fields.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Op {
            $(#[doc = concat!("See [`", stringify!($name), "`].")] $name($name),)*
        }

        /// Which operation, without its fields.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum OpId {
            $(#[doc = concat!("See [`", stringify!($name), "`].")] $name,)*
        }

        $(impl From<$name> for Op {
            fn from(op: $name) -> Self {
                Self::$name(op)
            }
        }

        impl From<$name> for Command {
            fn from(op: $name) -> Self {
                Self { object: None, symmetry: Symmetry::None, op: op.into() }
            }
        })*

        impl OpId {
            /// Every operation, in the order menus list them.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// The operation's name, texts and fields.
            pub const fn spec(self) -> &'static Spec {
                match self {
                    $(Self::$name => const { &<$name as Operation>::SPEC },)*
                }
            }

            pub(crate) fn parse(self, fields: Map<String, Value>) -> Result<Op, Problem> {
                match self {
                    $(Self::$name => <$name as Fields>::parse(fields).map(Op::$name),)*
                }
            }

            fn check_selection(self, target: &Target<'_>) -> Result<(), Problem> {
                match self {
                    $(Self::$name => target::check_selection::<$name>(target),)*
                }
            }
        }

        impl Op {
            /// Which operation it is.
            pub fn id(&self) -> OpId {
                match self {
                    $(Self::$name(_) => OpId::$name,)*
                }
            }

            fn to_fields(&self) -> Value {
                match self {
                    $(Self::$name(op) => op.to_fields(),)*
                }
            }

            /// Whether it takes what it works on from the selection.
            pub(crate) fn is_open(&self) -> bool {
                match self {
                    $(Self::$name(op) => target::is_open(op),)*
                }
            }

            pub(crate) fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
                match self {
                    $(Self::$name(op) => {
                        Ok(target::resolve(op, target)?.into_iter().map(Self::$name).collect())
                    })*
                }
            }

            /// How it is mirrored.
            pub(crate) fn mirroring(&self) -> Mirroring {
                match self {
                    $(Self::$name(_) => <$name as Operation>::MIRRORING,)*
                }
            }

            /// The mirror images of operations of one kind.
            pub(crate) fn mirror(ops: Vec<Self>, mesh: &Mesh, images: &mut MirrorImages) -> symmetry::Images<Self> {
                match ops.first() {
                    $(Some(Self::$name(_)) => {
                        let own = |op| if let Self::$name(op) = op { Some(op) } else { None };
                        symmetry::mirror(ops.into_iter().filter_map(own).collect(), mesh, images).map(Self::$name)
                    })*
                    None => symmetry::Images { own: Vec::new(), others: Vec::new(), alone: 0 },
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
    #[doc = "Operations on a few elements of a mesh."]
    elements [sized] {
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
        slide_edges::SlideEdges,
        slide_vertices::SlideVertices,
        fill_hole::FillHole,
        bridge::Bridge,
        merge_vertices::MergeVertices,
        weld_edges::WeldEdges,
        rip_edges::RipEdges,
        flip_orientation::FlipOrientation,
        set_crease::SetCrease,
    }
    #[doc = "Operations on whole meshes."]
    whole [each_mesh, subdivide] {
        subdivide_catmull_clark::SubdivideCatmullClark,
        subdivide_loop::SubdivideLoop,
        subdivide_linear::SubdivideLinear,
        simplify::Simplify,
        remesh::Remesh,
        smooth::Smooth,
        merge_by_distance::MergeByDistance,
    }
    #[doc = "Operations on what is selected and what is hidden."]
    selecting [hiding, naming] {
        select_elements::SelectElements,
        select_all::SelectAll,
        select_related::SelectRelated,
        select_boundary::SelectBoundary,
        select_sharp_edges::SelectSharpEdges,
        select_by_corners::SelectByCorners,
        select_by_valence::SelectByValence,
        select_by_area::SelectByArea,
        select_by_length::SelectByLength,
        select_non_planar::SelectNonPlanar,
        select_degenerate::SelectDegenerate,
        select_isolated::SelectIsolated,
        select_facing::SelectFacing,
        select_similar::SelectSimilar,
        select_named::SelectNamed,
        name_selection::NameSelection,
        rename_named_selection::RenameNamedSelection,
        delete_named_selection::DeleteNamedSelection,
        hide::Hide,
        reveal::Reveal,
        isolate::Isolate,
    }
    #[doc = "Operations on objects: which there are, what they are called, and what they are made of."]
    object [] {
        repair_import::RepairImport,
        new::New,
        activate_object::ActivateObject,
        rename_object::RenameObject,
        set_object_visible::SetObjectVisible,
        delete_object::DeleteObject,
        join_objects::JoinObjects,
        separate::Separate,
    }
    #[doc = "Operations on the control points of Bezier curves and surfaces."]
    bezier [control_points] {
        tessellate::BezierTessellate,
        move_point::BezierMovePoint,
        insert_point::BezierInsertPoint,
        delete_point::BezierDeletePoint,
        elevate_degree::BezierElevateDegree,
        split::BezierSplit,
    }
}

impl Op {
    /// The operation's name, texts, keys and fields.
    pub fn spec(&self) -> &'static Spec {
        self.id().spec()
    }

    /// Refuses an operation whose elements the selection can't stand in for. Costs O(1).
    pub(crate) fn check_selection(&self, target: &Target<'_>) -> Result<(), Problem> {
        self.id().check_selection(target)
    }

    /// How large its result would be; none where that is not worth saying.
    pub fn result(&self, facts: &Facts) -> Option<Estimate> {
        match self.action() {
            Action::WholeMesh(whole) => whole.result(facts),
            Action::Local(_) | Action::Document(_) | Action::Select(_) => None,
        }
    }
}

impl OpId {
    /// The operation of this name in JSON.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|id| id.spec().name == name)
    }
}
