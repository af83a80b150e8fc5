//! Operations: everything a user can do to a document.
//!
//! One operation per file, named after it. Each is a small struct whose fields are those of the JSON
//! object `{"op": "<name>", ...fields}`, with a [`Spec`] that everything else is made from: menus, the
//! palette, forms, keys, greying, previews, the operations reference and `meshwright --help`.
//!
//! To add one: write its file, and name it in `operations!` below.

mod action;
mod bezier;
mod choice;
mod command;
mod elements;
mod facts;
mod field;
mod json;
mod object;
mod refs;
mod spec;
mod target;
mod whole;

pub(crate) use action::{
    Action, Commit, DocumentEdit, Input, LocalEdit, Operation, Output, Place, WholeMesh, edit_all,
    refuse_bezier,
};
pub use bezier::*;
pub use choice::Choice;
pub use command::Command;
pub use elements::*;
pub use facts::{Amount, Counted, Estimate, Facts};
pub use field::{
    Arity, Default, Drag, Field, FieldKind, Fill, Selected, Suggestion, Unit, four_digits, sentence_case,
};
use json::Fields;
pub use object::*;
pub use refs::{EdgeRef, FaceRef, HalfedgeRef, VertexRef};
pub use spec::{Family, Scope, Spec};
pub(crate) use target::{Slot, Target};
pub use whole::*;

use crate::error::Problem;
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
                Self { object: None, op: op.into() }
            }
        })*

        impl OpId {
            /// Every operation, in the order menus list them.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// The operation's name, texts, keys and fields.
            pub fn spec(self) -> &'static Spec {
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

            pub(crate) fn action(&self) -> Action<'_> {
                match self {
                    $(Self::$name(op) => op.action(),)*
                }
            }
        }
    };
}

operations! {
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
    FillHole,
    Bridge,
    MergeVertices,
    WeldEdges,
    RipEdges,
    FlipOrientation,
    SetCrease,
    SubdivideCatmullClark,
    SubdivideLoop,
    SubdivideLinear,
    Simplify,
    Remesh,
    Smooth,
    MergeByDistance,
    RepairImport,
    New,
    BezierTessellate,
    BezierMovePoint,
    BezierInsertPoint,
    BezierDeletePoint,
    BezierElevateDegree,
    BezierSplit,
    ActivateObject,
    RenameObject,
    SetObjectVisible,
    DeleteObject,
    JoinObjects,
    Separate,
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
            Action::Local(_) | Action::Document(_) => None,
        }
    }
}

impl OpId {
    /// The operation of this name in JSON.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|id| id.spec().name == name)
    }
}
