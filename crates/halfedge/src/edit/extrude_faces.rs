//! Extrude faces: they move along their normals and leave walls behind.
//!
//! Always possible for faces that exist; [`walls`](super::walls) says why. Regions may have holes,
//! be several pieces, touch themselves at a vertex and reach the boundary. A whole closed piece has
//! no outline: it moves, and no walls are made.

use crate::FaceId;
use crate::edit::shared::{Followers, walls};
use crate::edit::{Grouping, Live, Refusal, Slide, SlideVertex};
use crate::mesh::Mesh;

/// Whether [`extrude_faces`] would succeed.
pub fn can_extrude_faces(mesh: &Mesh, faces: &[FaceId], grouping: Grouping) -> Result<(), Refusal> {
    walls(mesh, faces, grouping)?.patch.plan(mesh).map(drop)
}

/// Puts a wall of quads at the outline of faces, of no height yet: the slide's amount is the
/// distance, in mesh units and outward. In a region each vertex moves along the mean of its faces'
/// normals; individual faces move along their own.
///
/// The faces keep their ids, as do edges within them; the outline's edges stay where they were.
/// Costs O(n log n) in the corners of the faces and the valences of their vertices. Attributes: new
/// vertices and corners copy the old, the moved outline edges copy those they left, walls copy the
/// face they belong to; the edges between outlines have default values.
pub fn extrude_faces(mesh: &mut Mesh, faces: &[FaceId], grouping: Grouping) -> Result<Live, Refusal> {
    let walls = walls(mesh, faces, grouping)?;
    let outline = walls.vertices.iter().map(|wall| (wall.vertex, mesh.from(wall.leaves), wall.normal));
    let inner = walls.inner.iter().map(|&(v, normal)| (v, v, normal));
    let moves = outline
        .chain(inner)
        .map(|(vertex, old, by)| SlideVertex { vertex, from: mesh.position(old), by })
        .collect();
    let made = walls.patch.plan(mesh)?.apply(mesh);
    Ok(Live { made, slide: Slide::unlimited(moves, Followers::default()) })
}
