//! Operations: everything a user can do to a document.
//!
//! One operation per file, named after it. Each is a small struct whose fields are those of the JSON
//! object `{"op": "<name>", ...fields}`, with a [`Spec`] that everything else is made from: menus, the
//! palette, forms, greying, previews, the operations reference and `meshwright --help`.
//!
//! To add one: write its file in the folder of its group, name it in the group's `mod.rs`, and list it in
//! `operations!` below. Its place there is its place in menus.

mod action;
pub mod bezier;
mod choice;
mod command;
pub mod elements;
mod facts;
mod field;
mod json;
pub mod object;
mod refs;
pub mod selecting;
mod spec;
mod symmetry;
mod target;
pub mod whole;
mod wording;

pub(crate) use action::{
    Action, Commit, DocumentEdit, LocalEdit, Operation, Place, SelectEdit, WholeMesh, edges_between_created,
    edit_local, refuse_bezier, with_pieces,
};
pub use bezier::*;
pub use choice::Choice;
pub use command::Command;
pub use elements::*;
pub use facts::{Amount, Counted, Estimate, Facts};
pub(crate) use field::{ANGLE_RANGE, INDEX_RANGE};
pub use field::{Arity, DefaultValue, Drag, Field, FieldKind, Fill, Selected, Suggestion, Unit};
pub(crate) use formats::NamedMesh;
use json::Fields;
pub use object::*;
pub use refs::{EdgeRef, FaceRef, HalfedgeRef, VertexRef};
pub use selecting::*;
pub use spec::{Family, Scope, Spec};
pub use symmetry::Symmetry;
pub(crate) use symmetry::{Mirror, Mirroring, Reflection, SYMMETRY};
pub(crate) use target::{Slot, Target};
pub use whole::*;
pub use wording::{four_digits, sentence_case};

use crate::error::Problem;
use halfedge::Mesh;
use serde_json::{Map, Value};

macro_rules! operations {
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

            /// See [`Operation::elements`].
            fn elements(&mut self) -> Vec<Slot<'_>> {
                match self {
                    $(Self::$name(op) => op.elements(),)*
                }
            }

            /// See [`Operation::reflect`].
            fn reflect(&mut self, reflection: Reflection) {
                match self {
                    $(Self::$name(op) => op.reflect(reflection),)*
                }
            }

            /// See [`Operation::pair`].
            fn pair(&mut self, image: Self, mesh: &Mesh) -> Option<Self> {
                match (self, image) {
                    $((Self::$name(op), Self::$name(image)) => op.pair(image, mesh).map(Self::$name),)*
                    (_, image) => Some(image),
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
    // Operations on a few elements of a mesh.
    SetVertexPosition,
    Transform,
    SetFaceColor,
    SplitEdge,
    FlipEdge,
    CollapseEdge,
    CollapseFace,
    SplitVertex,
    DissolveVertex,
    DissolveEdge,
    DeleteFaces,
    DeleteVertices,
    TriangulateFaces,
    PokeFaces,
    ConnectVertices,
    ExtrudeFaces,
    ExtrudeEdges,
    InsetFaces,
    BevelEdges,
    BevelVertices,
    LoopCut,
    SlideEdges,
    SlideVertices,
    FillHole,
    Bridge,
    MergeVertices,
    WeldEdges,
    RipEdges,
    FlipOrientation,
    SetCrease,
    // Operations on whole meshes.
    SubdivideCatmullClark,
    SubdivideLoop,
    SubdivideLinear,
    Simplify,
    Remesh,
    Smooth,
    MergeByDistance,
    // Operations on what is selected and what is hidden.
    SelectElements,
    SelectAll,
    SelectRelated,
    SelectBoundary,
    SelectSharpEdges,
    SelectByCorners,
    SelectByValence,
    SelectByArea,
    SelectByLength,
    SelectNonPlanar,
    SelectDegenerate,
    SelectIsolated,
    SelectSmallerComponents,
    SelectFacing,
    SelectSimilar,
    SelectNamed,
    NameSelection,
    RenameNamedSelection,
    DeleteNamedSelection,
    Hide,
    Reveal,
    Isolate,
    // Operations on objects: which there are, what they are called, and what they are made of.
    RepairImport,
    New,
    ActivateObject,
    RenameObject,
    SetObjectVisible,
    DeleteObject,
    JoinObjects,
    Separate,
    // Operations on the control points of Bezier curves and surfaces.
    BezierTessellate,
    BezierMovePoint,
    BezierInsertPoint,
    BezierDeletePoint,
    BezierElevateDegree,
    BezierSplit,
}

impl Op {
    /// The operation's name, texts and fields.
    pub fn spec(&self) -> &'static Spec {
        self.id().spec()
    }

    /// What the operation is called with these fields, in the history and where it is undone.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Transform(transform) => transform.label(),
            _ => self.spec().label,
        }
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
