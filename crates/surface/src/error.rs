//! Errors of whole-mesh operations.

use halfedge::words::thousands;
use halfedge::{FaceId, NumberRange, VertexId};
use std::fmt;

/// Why a whole-mesh operation returned no mesh. The input is always unchanged.
#[derive(Clone, Debug, PartialEq)]
pub enum SurfaceError {
    /// The progress callback cancelled the operation.
    Cancelled,
    /// The result wouldn't fit in memory.
    TooManyFaces {
        /// The number of faces that it would have.
        faces: u64,
        /// The most faces that it may have.
        limit: u64,
    },
    /// The operation works on triangles only.
    NotTriangles {
        /// The first face that isn't one.
        face: FaceId,
        /// The number of its corners.
        corners: usize,
    },
    /// Two triangles share two edges: after both are split in four, two edges would join the same midpoints.
    MeetTwice {
        /// The vertex between the edges, which has no other edges.
        vertex: VertexId,
        /// The triangles.
        faces: [FaceId; 2],
    },
    /// A field has a value that the operation doesn't take.
    BadField {
        /// The field's name in the command.
        field: &'static str,
        /// The requirement, to follow "must be".
        must_be: String,
    },
}

impl SurfaceError {
    /// A field out of range.
    pub(crate) fn field(field: &'static str, must_be: impl Into<String>) -> Self {
        Self::BadField { field, must_be: must_be.into() }
    }
}

/// Refuses a value that is out of its field's range.
pub(crate) fn require(field: &'static str, value: f64, range: NumberRange) -> Result<(), SurfaceError> {
    if range.contains(value) { Ok(()) } else { Err(SurfaceError::field(field, range.to_string())) }
}

impl fmt::Display for SurfaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("cancelled"),
            Self::TooManyFaces { faces, limit } => write!(
                f,
                "the result would have {} faces, more than the {} that fit in memory",
                count(*faces),
                thousands(limit)
            ),
            Self::NotTriangles { face, corners } => write!(
                f,
                "{face} has {corners} corners; this works on triangles only, so triangulate the faces first"
            ),
            Self::MeetTwice { vertex, faces: [a, b] } => write!(
                f,
                "{a} and {b} meet along both edges of {vertex}; dissolve that vertex or delete one of the faces \
                 first"
            ),
            Self::BadField { field, must_be } => write!(f, "{field} must be {must_be}"),
        }
    }
}

impl std::error::Error for SurfaceError {}

/// The number in digits, or in words if it is too large to matter.
fn count(number: u64) -> String {
    if number < 1_000_000_000_000 { thousands(number) } else { "more than a million million".to_owned() }
}
