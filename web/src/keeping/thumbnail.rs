//! The small pictures of kept documents.

use editor::{Document, Object};
use glam::{Vec3, vec3};
use halfedge::Mesh;

use crate::panels::welcome::picture::{Figure, draw};

/// The size of a picture in pixels.
const SIZE: [usize; 2] = [168, 112];

/// More faces than this are drawn as larger ones around some of them.
const MAX_FACES: usize = 6_000;

/// How much larger the faces are that stand for others: so they overlap.
const OVERLAP: f32 = 1.5;

/// The colour of faces without one.
const PLAIN: Vec3 = vec3(0.72, 0.78, 0.88);

/// A picture: rows of red, green, blue and opacity, premultiplied.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Thumbnail {
    pub size: [usize; 2],
    pub pixels: Vec<u8>,
}

impl Thumbnail {
    /// Draws the visible objects of a document. Costs some milliseconds, whatever the document's size.
    pub fn of(document: &Document) -> Self {
        let visible = || document.objects().iter().filter(|object| object.visible()).map(Object::mesh);
        let faces: usize = visible().map(Mesh::face_count).sum();
        let every = faces.div_ceil(MAX_FACES).max(1);
        let mut figure = Figure::default();
        visible().for_each(|mesh| add(mesh, every, &mut figure));
        let [width, height] = SIZE;
        Self { size: SIZE, pixels: draw(&figure, width, height) }
    }

    /// The width and the height as `u16`, little-endian, then the pixels.
    pub fn to_bytes(&self) -> Vec<u8> {
        let size = self.size.map(|side| (side as u16).to_le_bytes()).concat();
        [size.as_slice(), &self.pixels].concat()
    }

    /// Reads what [`Thumbnail::to_bytes`] wrote; none for anything else.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (width, rest) = bytes.split_first_chunk::<2>()?;
        let (height, pixels) = rest.split_first_chunk::<2>()?;
        let size = [width, height].map(|side| usize::from(u16::from_le_bytes(*side)));
        (size[0] > 0 && pixels.len() == size[0] * size[1] * 4).then(|| Self { size, pixels: pixels.to_vec() })
    }
}

/// Adds some faces of a mesh.
fn add(mesh: &Mesh, every: usize, figure: &mut Figure) {
    let first = figure.positions.len() as u32;
    if every == 1 {
        figure.positions.extend_from_slice(mesh.positions());
        let corners = |face| mesh.face_vertices(face).map(|vertex| first + vertex.raw()).collect();
        figure.polygons.extend(mesh.faces().map(|face| (corners(face), PLAIN)));
        return;
    }
    let scale = OVERLAP * (every as f32).sqrt();
    for face in mesh.faces().step_by(every) {
        let corners: Vec<Vec3> = mesh.face_vertices(face).map(|vertex| mesh.position(vertex)).collect();
        let middle = corners.iter().sum::<Vec3>() / corners.len().max(1) as f32;
        let first = figure.positions.len() as u32;
        let ids = (first..first + corners.len() as u32).collect();
        figure.positions.extend(corners.into_iter().map(|corner| middle + (corner - middle) * scale));
        figure.polygons.push((ids, PLAIN));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use editor::{Command, Editor};

    #[test]
    fn a_picture_shows_the_document_and_comes_back_from_its_bytes() {
        let mut editor = Editor::new();
        let command =
            Command::from_json(r#"{"op": "new", "shape": "uv-sphere", "segments": 256, "rings": 128}"#);
        editor.run(command.expect("a command")).expect("a sphere");
        let picture = Thumbnail::of(editor.document());
        assert_eq!(Thumbnail::from_bytes(&picture.to_bytes()), Some(picture.clone()));
        assert_eq!(Thumbnail::from_bytes(&picture.to_bytes()[1..]), None);
        let at = |x: usize, y: usize| picture.pixels[(y * SIZE[0] + x) * 4 + 3];
        let opaque = (20..90).filter(|&y| at(SIZE[0] / 2, y) == 255).count();
        assert!(opaque > 60, "the sphere has no holes: {opaque}");
        assert_eq!(at(0, 0), 0, "around it there is nothing");
    }
}
