//! The four kinds of element id.

use std::fmt;
use std::num::NonZeroU32;

/// Stands for "none" in a `u32` column: no element has this id.
pub const NONE: u32 = u32::MAX;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident, $word:literal) => {
        $(#[$doc])*
        ///
        /// A `u32` with a niche, so that `Option` of it takes four bytes too. It stores the complement of the
        /// id, so that id 0 exists and [`NONE`](crate::NONE) doesn't.
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        #[repr(transparent)]
        pub struct $name(NonZeroU32);

        impl $name {
            /// The id with this number; none for [`NONE`](crate::NONE).
            #[inline]
            pub const fn from_raw(raw: u32) -> Option<Self> {
                match NonZeroU32::new(!raw) {
                    Some(inner) => Some(Self(inner)),
                    None => None,
                }
            }

            /// The id with this number. Numbers from `u32::MAX` up, which no mesh has, give the largest
            /// id, which no mesh has either.
            #[inline]
            pub const fn new(index: usize) -> Self {
                let raw = if index >= NONE as usize { NONE - 1 } else { index as u32 };
                match NonZeroU32::new(!raw) {
                    Some(inner) => Self(inner),
                    None => Self(NonZeroU32::MIN),
                }
            }

            /// The number, as shown in lists and stored in raw columns.
            #[inline]
            pub const fn raw(self) -> u32 {
                !self.0.get()
            }

            /// The number as an index into columns.
            #[inline]
            pub const fn index(self) -> usize {
                self.raw() as usize
            }
        }

        impl PartialOrd for $name {
            fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
                Some(self.cmp(other))
            }
        }

        impl Ord for $name {
            fn cmp(&self, other: &Self) -> std::cmp::Ordering {
                self.raw().cmp(&other.raw())
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($word, " {}"), self.raw())
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Debug::fmt(self, f)
            }
        }
    };
}

id!(
    /// A vertex.
    VertexId, "vertex"
);
id!(
    /// A half-edge: one side of an edge, directed.
    HalfedgeId, "half-edge"
);
id!(
    /// An edge: two half-edges, `2e` and `2e + 1`.
    EdgeId, "edge"
);
id!(
    /// A face: a polygon with three corners or more.
    FaceId, "face"
);

impl HalfedgeId {
    /// The other side of the same edge.
    #[inline]
    #[must_use]
    pub const fn twin(self) -> Self {
        // `raw ^ 1`, on the complement.
        match NonZeroU32::new(self.0.get() ^ 1) {
            Some(inner) => Self(inner),
            // Half-edge u32::MAX - 1 has no twin; no mesh is that large (see `Mesh::MAX_EDGES`).
            None => self,
        }
    }

    /// The edge of this half-edge.
    #[inline]
    pub const fn edge(self) -> EdgeId {
        EdgeId::new(self.index() >> 1)
    }
}

impl EdgeId {
    /// The two half-edges, the even one first.
    #[inline]
    pub const fn halfedges(self) -> [HalfedgeId; 2] {
        [HalfedgeId::new(self.index() * 2), HalfedgeId::new(self.index() * 2 + 1)]
    }

    /// The even half-edge.
    #[inline]
    pub const fn halfedge(self) -> HalfedgeId {
        HalfedgeId::new(self.index() * 2)
    }
}

/// The kinds of element.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, PartialOrd, Ord)]
pub enum Element {
    /// Vertices: points with a position.
    Vertex,
    /// Half-edges: directed sides of edges. An attribute of a half-edge belongs to the corner that it leaves.
    Halfedge,
    /// Edges.
    Edge,
    /// Faces: polygons.
    Face,
}

impl Element {
    /// All kinds, in the order of lists.
    pub const ALL: [Self; 4] = [Self::Vertex, Self::Edge, Self::Halfedge, Self::Face];
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Vertex => "vertex",
            Self::Halfedge => "half-edge",
            Self::Edge => "edge",
            Self::Face => "face",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_optional_id_takes_four_bytes() {
        assert_eq!(size_of::<Option<VertexId>>(), 4);
        assert_eq!(VertexId::from_raw(NONE), None);
        assert_eq!(VertexId::from_raw(0), Some(VertexId::new(0)));
    }

    #[test]
    fn twins_and_edges() {
        let h = HalfedgeId::new(6);
        assert_eq!(h.twin(), HalfedgeId::new(7));
        assert_eq!(h.twin().twin(), h);
        assert_eq!(h.edge(), EdgeId::new(3));
        assert_eq!(h.edge().halfedges(), [h, h.twin()]);
    }

    #[test]
    fn ids_order_by_number() {
        assert!(FaceId::new(1) < FaceId::new(2));
        assert_eq!(format!("{} {:?}", EdgeId::new(4), HalfedgeId::new(5)), "edge 4 half-edge 5");
    }
}
