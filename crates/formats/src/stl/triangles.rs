//! The triangles of an STL, before they are made a mesh.

use crate::model::labels::Names;
use crate::soup::weld::Weld;
use glam::Vec3;
use halfedge::attribute::Column;
use halfedge::{Color, NONE, PolygonSoup, keys};

/// Triangles with vertices at equal positions merged.
pub(super) struct Triangles {
    weld: Weld,
    soup: PolygonSoup,
    /// Per face, the number of its solid's name; as far as any has one.
    solids: Vec<u32>,
    names: Names,
    /// Per face, as far as any has one.
    pub colors: Vec<Color>,
}

impl Triangles {
    pub(super) fn new() -> Self {
        Self {
            weld: Weld::new(),
            soup: PolygonSoup::default(),
            solids: Vec::new(),
            names: Names::default(),
            colors: Vec::new(),
        }
    }

    /// Adds a face; polygons are met in files, although the format has none.
    pub(super) fn push(&mut self, corners: &[Vec3]) {
        let weld = &mut self.weld;
        self.soup.push_face(corners.iter().map(|&corner| weld.vertex(corner)));
    }

    /// Names the solid of the face added last.
    pub(super) fn name_solid(&mut self, name: &str) {
        self.solids.resize(self.count() - 1, NONE);
        self.solids.push(self.names.number(name));
    }

    /// Colours the face added last.
    pub(super) fn paint(&mut self, color: Color) {
        self.colors.resize(self.count() - 1, Color::UNPAINTED);
        self.colors.push(color);
    }

    /// How many faces there are.
    pub(super) fn count(&self) -> usize {
        self.soup.face_count()
    }

    /// The soup with all attributes. The name of a solid becomes the group of its faces, unless it is the only
    /// one and called like the file.
    pub(super) fn finish(mut self, stem: &str) -> PolygonSoup {
        let faces = self.count();
        self.soup.positions = self.weld.positions;
        self.solids.resize(faces, NONE);
        let is_file = |solid: &u32| self.names.name(*solid) == Some(stem);
        if self.solids.iter().any(|&solid| solid != NONE) && !self.solids.iter().all(is_file) {
            self.soup.face_columns.push(self.names.column(keys::FACE_GROUP, self.solids));
        }
        if self.colors.iter().any(|&color| color != Color::UNPAINTED) {
            self.colors.resize(faces, Color::UNPAINTED);
            self.soup.face_columns.push(Column::with_values(keys::FACE_COLOR, self.colors));
        }
        self.soup
    }
}
