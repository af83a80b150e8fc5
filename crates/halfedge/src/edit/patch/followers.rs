//! The corners of a patch whose values follow vertices that the edit moves.

use super::Plan;
use crate::edit::shared::{Blend, Follower, Followers};
use crate::{FaceId, HalfedgeId, Mesh, VertexId};
use rustc_hash::FxHashSet;

impl Plan {
    /// The corners at these vertices in the result, each with the corners that it gets its value from. Empty if
    /// the mesh has no columns that follow.
    pub(crate) fn followers(&self, mesh: &Mesh, vertices: impl Iterator<Item = VertexId>) -> Vec<Follower> {
        let mut followers = Vec::new();
        if !Followers::has_columns(mesh) {
            return followers;
        }
        let vertices: FxHashSet<VertexId> = vertices.collect();
        let mut sides = self.sides.iter();
        for face in &self.patch.faces {
            for (corner, &side) in face.corners.iter().zip(&mut sides) {
                let sources = match &corner.value {
                    Blend::Copy(h) => std::slice::from_ref(h),
                    Blend::Mean(all) => all.as_slice(),
                    Blend::Mix(..) | Blend::Weighted(_) => &[],
                };
                if !vertices.contains(&corner.vertex) {
                    continue;
                }
                for &h in sources {
                    let source = HalfedgeId::new(h as usize);
                    // A face that stays counts before one that is added beside it, and among those that stay the
                    // ones that lose most corners.
                    let stays = face.id.is_some() && mesh.face_of(source) == face.id;
                    let rank = if stays { sources.len() } else { 0 };
                    let (corner, vertex, side) = (source, corner.vertex, Some(side));
                    followers.push(Follower { corner, vertex, side, rank });
                }
            }
        }
        let removed: FxHashSet<FaceId> = self.patch.remove.iter().copied().collect();
        for &v in vertices.iter().filter(|&&v| mesh.has_vertex(v)) {
            for h in mesh.outgoing(v) {
                if mesh.face_of(h).is_some_and(|face| !removed.contains(&face)) {
                    followers.push(Follower { corner: h, vertex: v, side: Some(h), rank: 1 });
                }
            }
        }
        followers
    }
}
