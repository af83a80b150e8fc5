//! Why an edit can't be made.

use crate::{Element, VertexId};
use std::fmt;

/// The reason an edit was refused, in words a user can read. The mesh is as it was.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// There is no such element.
    NoSuchElement(Element, u32),
    /// The edit would join two vertices that an edge joins already.
    AlreadyJoined(VertexId, VertexId),
    /// Two cuts from a new vertex would end at the same vertex.
    CutsMeet(VertexId),
    /// A parameter is out of its range.
    OutOfRange {
        /// The parameter's name in commands.
        field: &'static str,
        /// What it was.
        value: f32,
        /// What it may be.
        range: &'static str,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchElement(element, id) => write!(f, "there is no {element} {id}"),
            Self::AlreadyJoined(a, b) => {
                write!(f, "this would join {a} and {b}, which an edge joins already")
            }
            Self::CutsMeet(v) => {
                write!(f, "the cuts on both sides would end at {v}: two edges would join the same vertices")
            }
            Self::OutOfRange { field, value, range } => {
                write!(f, "`{field}` is {value}, but must be {range}")
            }
        }
    }
}

impl std::error::Error for Refusal {}
