//! Polygon soup: polygons as files hold them, which need not form a mesh.

use crate::attribute::Column;
use glam::Vec3;

/// Positions, polygons that refer to them by number, and attribute columns with the same numbering. The
/// polygons need not form a manifold.
#[derive(Clone, Debug, PartialEq)]
pub struct PolygonSoup {
    /// The positions, in the file's order.
    pub positions: Vec<Vec3>,
    /// Per face the index of its first corner in `corners`, and at the end the number of corners. The first
    /// entry is 0.
    pub face_starts: Vec<u32>,
    /// The vertices of all corners, face by face.
    pub corners: Vec<u32>,
    /// Columns with a value per position.
    pub vertex_columns: Vec<Column>,
    /// Columns with a value per corner.
    pub corner_columns: Vec<Column>,
    /// Columns with a value per face.
    pub face_columns: Vec<Column>,
}

impl Default for PolygonSoup {
    fn default() -> Self {
        Self {
            positions: Vec::new(),
            face_starts: vec![0],
            corners: Vec::new(),
            vertex_columns: Vec::new(),
            corner_columns: Vec::new(),
            face_columns: Vec::new(),
        }
    }
}

impl PolygonSoup {
    /// A soup of these polygons without attributes.
    pub fn new<F: AsRef<[u32]>>(positions: Vec<Vec3>, faces: &[F]) -> Self {
        let mut soup = Self { positions, ..Self::default() };
        for face in faces {
            soup.push_face(face.as_ref().iter().copied());
        }
        soup
    }

    /// Adds a face.
    pub fn push_face(&mut self, corners: impl IntoIterator<Item = u32>) {
        self.corners.extend(corners);
        self.face_starts.push(self.corners.len() as u32);
    }

    /// The number of faces.
    pub fn face_count(&self) -> usize {
        self.face_starts.len().saturating_sub(1)
    }

    /// The range of a face's corners in `corners`.
    pub fn face_range(&self, face: usize) -> std::ops::Range<usize> {
        let end = |i: usize| self.face_starts.get(i).map_or(self.corners.len(), |&s| s as usize);
        let stop = end(face + 1).min(self.corners.len());
        end(face).min(stop)..stop
    }

    /// The vertices of a face.
    pub fn face(&self, face: usize) -> &[u32] {
        &self.corners[self.face_range(face)]
    }

    /// All faces in order.
    pub fn faces(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.face_count()).map(|face| self.face(face))
    }
}
