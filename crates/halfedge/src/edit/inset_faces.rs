//! Inset faces: a ring of quads inside each face, or inside the outline of several.
//!
//! Always possible for faces with an outline; the text of `shared/walls.rs` says why. A whole closed piece, inset as one
//! region, has none and is refused. An inset wider than the face is *clamped* to where the first edge of the inner
//! outline would lose its length: [`Slide::limit`].

use crate::edit::shared::{Followers, Walls, miter, walls};
use crate::edit::{Grouping, Refusal, Slide, SlideVertex, SlidingEdit};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId};
use glam::Vec3;

/// Whether [`inset_faces`] would succeed.
pub fn can_inset_faces(mesh: &Mesh, faces: &[FaceId], grouping: Grouping) -> Result<(), Refusal> {
    inset_walls(mesh, faces, grouping)?.patch.plan(mesh).map(drop)
}

fn inset_walls(mesh: &Mesh, faces: &[FaceId], grouping: Grouping) -> Result<Walls, Refusal> {
    let walls = walls(mesh, faces, grouping)?;
    match faces.first() {
        Some(&face) if walls.vertices.is_empty() => Err(Refusal::NoOutline(face)),
        _ => Ok(walls),
    }
}

/// Puts a ring of quads inside the outline of faces, without width: the slide's amount is the width, in mesh units. Each
/// outline edge moves inward in the plane of its face. At corners they meet in a mitre, which is cut off at four times
/// the width where they nearly double back. Vertices inside a region stay where they are.
///
/// Ids, costs and attributes are as for [`extrude_faces`](super::extrude_faces), except that vertex and corner values
/// follow the slide over the faces.
pub fn inset_faces(mesh: &mut Mesh, faces: &[FaceId], grouping: Grouping) -> Result<SlidingEdit, Refusal> {
    let walls = inset_walls(mesh, faces, grouping)?;
    let inward = |h: HalfedgeId| {
        let normal = mesh.face_of(h).and_then(|face| walls.normals.get(&face)).copied().unwrap_or(Vec3::ZERO);
        normal.cross(mesh.direction(h)).normalize_or_zero()
    };
    let moves: Vec<SlideVertex> = walls
        .vertices
        .iter()
        .map(|wall| SlideVertex {
            vertex: wall.vertex,
            from: mesh.position(mesh.from(wall.leaves)),
            by: miter(inward(wall.arrives), inward(wall.leaves)),
        })
        .collect();
    let plan = walls.patch.plan(mesh)?;
    let followers = plan.followers(mesh, moves.iter().map(|slide| slide.vertex));
    let followers = Followers::new(mesh, followers, |_, _| true);
    let made = plan.apply(mesh);
    Ok(SlidingEdit { made, slide: Slide::limited(mesh, moves, followers) })
}
