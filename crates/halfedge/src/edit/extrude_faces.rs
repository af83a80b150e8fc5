//! Extrude faces: they move along their normals and leave walls behind.
//!
//! Always possible for existing faces; the text of `shared/walls.rs` says why. Regions may have holes, consist of several
//! pieces, touch themselves at a vertex and reach the boundary. A whole closed piece has no outline: it moves, without
//! walls.

use crate::FaceId;
use crate::edit::shared::{Followers, walls};
use crate::edit::{Grouping, Refusal, Slide, SlideVertex, SlidingEdit};
use crate::mesh::Mesh;

/// Whether [`extrude_faces`] would succeed.
pub fn can_extrude_faces(mesh: &Mesh, faces: &[FaceId], grouping: Grouping) -> Result<(), Refusal> {
    walls(mesh, faces, grouping)?.patch.plan(mesh).map(drop)
}

/// Puts a wall of quads round faces, without height: the slide's amount is the distance outward, in mesh units. Vertices
/// of a region move along the mean normal of its faces there, individual faces along their own.
///
/// The faces and the edges between them keep their ids; the outline's edges stay where they were. Costs O(n log n) in the
/// corners of the faces and the valences of their vertices. Attributes: new vertices and corners copy the old ones, moved
/// outline edges those that stayed, and walls the face that they belong to. Edges from outline to outline have default
/// values.
pub fn extrude_faces(mesh: &mut Mesh, faces: &[FaceId], grouping: Grouping) -> Result<SlidingEdit, Refusal> {
    let walls = walls(mesh, faces, grouping)?;
    let outline = walls.vertices.iter().map(|wall| (wall.vertex, mesh.from(wall.leaves), wall.normal));
    let inner = walls.inner.iter().map(|&(v, normal)| (v, v, normal));
    let moves = outline
        .chain(inner)
        .map(|(vertex, old, by)| SlideVertex { vertex, from: mesh.position(old), by })
        .collect();
    let made = walls.patch.plan(mesh)?.apply(mesh);
    Ok(SlidingEdit { made, slide: Slide::unlimited(moves, Followers::default()) })
}
