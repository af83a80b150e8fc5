//! Why an edit can't be made.

use crate::words::thousands;
use crate::{EdgeId, Element, FaceId, HalfedgeId, Mesh, NumberRange, VertexId};
use std::fmt;

/// The reason why an edit was refused, in words for the user. The mesh is unchanged.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// There is no such element.
    NoSuchElement(Element, u32),
    /// The edit acts on elements of this kind, and none was given.
    NothingGiven(Element),
    /// The edit needs different elements, and this one was given twice.
    GivenTwice(Element, u32),
    /// The edit makes one of several elements, and only this one was given.
    OnlyOne(Element, u32),
    /// A parameter is out of its range.
    OutOfRange {
        /// The parameter's name in commands.
        field: &'static str,
        /// Its value.
        value: f32,
        /// The range.
        range: NumberRange,
    },
    /// A vertex would get a position that is not finite.
    TooFarAway(VertexId),
    /// The mesh would have more edges than ids can number.
    TooManyEdges,
    /// The edit would join two vertices that an edge joins already.
    AlreadyJoined(VertexId, VertexId),
    /// Two cuts from a new vertex would end at this vertex.
    CutsMeet(VertexId),
    /// A face would be left with fewer than three corners.
    TooFewCorners(Option<FaceId>),
    /// A face would have this vertex at two corners.
    RepeatedCorner(VertexId),
    /// Two faces would lie on the same side of the edge between these vertices.
    SideTaken(VertexId, VertexId),
    /// The faces at this vertex would no longer form one fan.
    Pinched(VertexId),
    /// This vertex would be left without a face.
    LeftWithoutFace(VertexId),
    /// The edge is on the boundary, and the edit needs a face on both sides.
    BoundaryEdge(EdgeId),
    /// The edge has faces on both sides, and the edit is for boundary edges.
    NotOnBoundary(EdgeId),
    /// The half-edge has a face, and the edit is for boundary half-edges.
    NotABoundaryHalfedge(HalfedgeId),
    /// The edge runs from boundary to boundary through the inside.
    JoinsBoundaries(EdgeId),
    /// The vertex has too few edges to lose one.
    ValenceTooLow(VertexId, usize),
    /// The edge doesn't end at the vertex.
    NotAtVertex(EdgeId, VertexId),
    /// No face has both vertices.
    NotInOneFace(VertexId, VertexId),
    /// The faces of a region are no disc: there is a hole, or they meet in more than one place.
    NotADisc(FaceId),
    /// All neighbours of the given faces were given too, so there is no outline.
    NoOutline(FaceId),
    /// No quad lies beside the edge, so no ring of quads goes through it.
    NoRing(EdgeId),
    /// Three or more of the given edges meet at this vertex.
    Branches(VertexId),
    /// No vertex of this edge, or of the other given ones, has anything to slide along.
    NoRail(EdgeId),
    /// The direction has no length.
    NoDirection,
    /// Loops or regions are joined in pairs, and there are this many of them.
    NotInPairs(usize),
    /// Both half-edges lie on the same boundary loop.
    SameLoop(HalfedgeId, HalfedgeId),
    /// Both faces have this vertex.
    FacesTouch(FaceId, FaceId, VertexId),
    /// Ripping this edge would leave its two sides joined at both ends.
    StaysJoined(EdgeId),
    /// Neighbours of this face were not given, and the edit is for whole pieces.
    NotAWholePiece(FaceId),
    /// Every way of cutting the face into triangles would duplicate an edge.
    NoTriangulation(FaceId),
}

impl NumberRange {
    /// Refuses a parameter that is out of the range.
    pub(crate) fn require(self, field: &'static str, value: f32) -> Result<(), Refusal> {
        if self.contains(value.into()) {
            Ok(())
        } else {
            Err(Refusal::OutOfRange { field, value, range: self })
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchElement(element, id) => write!(f, "there is no {element} {id}"),
            Self::NothingGiven(element) => write!(f, "no {element} was given; select one or more"),
            Self::GivenTwice(element, id) => {
                write!(f, "{element} {id} was given twice; choose two different ones")
            }
            Self::OnlyOne(element, id) => write!(f, "only {element} {id} is given; choose two or more"),
            Self::OutOfRange { field, value, range } => {
                write!(f, "`{field}` is {value}, but must be {range}")
            }
            Self::TooFarAway(v) => {
                write!(f, "this would move {v} beyond the largest coordinates; move it less far")
            }
            Self::TooManyEdges => {
                write!(f, "the mesh would have more than {} edges", thousands(Mesh::MAX_EDGES))
            }
            Self::AlreadyJoined(a, b) => {
                write!(f, "this would add a second edge between {a} and {b}")
            }
            Self::CutsMeet(v) => {
                write!(f, "the cuts on both sides would end at {v}, with two edges between the same vertices")
            }
            Self::TooFewCorners(Some(face)) => {
                write!(f, "this would leave {face} with fewer than three corners")
            }
            Self::TooFewCorners(None) => write!(f, "this would make a face with fewer than three corners"),
            Self::RepeatedCorner(v) => write!(f, "this would make a face with {v} at two of its corners"),
            Self::SideTaken(a, b) => {
                write!(f, "more than two faces would meet at the edge between {a} and {b}")
            }
            Self::Pinched(v) => {
                write!(f, "this would pinch the surface at {v}, where faces would meet only at a point")
            }
            Self::LeftWithoutFace(v) => {
                write!(f, "this would leave {v} without a face; delete faces instead")
            }
            Self::BoundaryEdge(e) => {
                write!(f, "{e} is on the boundary; choose an edge with a face on both sides")
            }
            Self::NotOnBoundary(e) => {
                write!(f, "{e} has a face on both sides; choose an edge on the boundary")
            }
            Self::NotABoundaryHalfedge(h) => {
                write!(f, "{h} has a face; choose a half-edge of a boundary loop")
            }
            Self::JoinsBoundaries(e) => {
                write!(f, "{e} runs from boundary to boundary; collapsing it would pinch the surface there")
            }
            Self::ValenceTooLow(v, valence) => write!(f, "{v} has only {valence} edges and can't lose one"),
            Self::NotAtVertex(e, v) => write!(f, "{e} doesn't end at {v}; choose an edge that does"),
            Self::NotInOneFace(a, b) => {
                write!(f, "no face has both {a} and {b}; choose two corners of one face")
            }
            Self::NotADisc(face) => {
                write!(f, "{face} and the faces joined to it are no disc: they meet in more than one place")
            }
            Self::NoOutline(face) => {
                write!(f, "{face} and the other given faces have no outline; leave out some of the piece")
            }
            Self::NoRing(e) => {
                write!(
                    f,
                    "no quad lies beside {e}, so no ring of quads goes through it; choose an edge of a quad"
                )
            }
            Self::Branches(v) => {
                write!(
                    f,
                    "three or more of the given edges meet at {v}; choose lines of edges that don't branch"
                )
            }
            Self::NoRail(e) => {
                write!(f, "no other edge leads away from {e} to slide along; choose an edge that others meet")
            }
            Self::NoDirection => write!(f, "the direction is too short; give one with a length"),
            Self::NotInPairs(count) => {
                write!(
                    f,
                    "loops are joined in pairs, and there are {count}; choose an even number, up to 2000"
                )
            }
            Self::SameLoop(a, b) => {
                write!(f, "{a} and {b} are on the same boundary loop; choose one of each of two loops")
            }
            Self::FacesTouch(a, b, v) => {
                write!(f, "{a} and {b} both have {v}; choose faces that don't touch")
            }
            Self::StaysJoined(e) => {
                write!(f, "ripping {e} would leave its sides joined at both ends; rip a longer line of edges")
            }
            Self::NotAWholePiece(face) => {
                write!(f, "{face} is connected to faces that were not given; choose whole connected pieces")
            }
            Self::NoTriangulation(face) => {
                write!(
                    f,
                    "{face} can't be cut into triangles: too many of its corners are joined by edges already"
                )
            }
        }
    }
}

impl std::error::Error for Refusal {}
