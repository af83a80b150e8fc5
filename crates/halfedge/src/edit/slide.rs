//! Slide: the second half of an interactive edit. The first makes its new vertices where old ones
//! are; the slide moves them by an amount, as often as a drag likes.

use crate::VertexId;
use crate::edit::follow::Followers;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use glam::Vec3;
use rustc_hash::FxHashMap;

/// A vertex that a [`Slide`] moves: to `from + amount * by`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlideVertex {
    /// The vertex.
    pub vertex: VertexId,
    /// Where it is at amount 0.
    pub from: Vec3,
    /// How far it moves per unit of the amount.
    pub by: Vec3,
}

/// The moves of an interactive edit: a pure function of one amount. Corner values of the faces that are cut
/// and the attributes of the vertices follow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slide {
    /// The vertices that move.
    pub vertices: Vec<SlideVertex>,
    /// The largest amount that turns no edge round; larger ones are clamped to it. Infinite where
    /// there is no such limit.
    pub limit: f32,
    /// The corner values that follow the vertices.
    followers: Followers,
}

impl Slide {
    /// A slide with no limit.
    pub(crate) fn unlimited(vertices: Vec<SlideVertex>, followers: Followers) -> Self {
        Self { vertices, limit: f32::INFINITY, followers }
    }

    /// A slide limited to where the first edge of the mesh would lose its length and turn round.
    /// Edges that have no length at amount 0, where the edit has just cut a corner, do not limit.
    pub(crate) fn limited(mesh: &Mesh, vertices: Vec<SlideVertex>, followers: Followers) -> Self {
        let by: FxHashMap<VertexId, Vec3> = vertices.iter().map(|slide| (slide.vertex, slide.by)).collect();
        let mut limit = f32::INFINITY;
        for slide in &vertices {
            for v in mesh.neighbors(slide.vertex) {
                let along = mesh.position(v) - slide.from;
                let length = along.length();
                let other = by.get(&v).copied().unwrap_or_default();
                let shrinks = (slide.by - other).dot(along) / length;
                if length > 0.0 && shrinks > 0.0 {
                    limit = limit.min(length / shrinks);
                }
            }
        }
        Self { vertices, limit, followers }
    }

    /// The amount that [`Slide::apply`] uses for this one.
    pub fn clamp(&self, amount: f32) -> f32 {
        amount.min(self.limit)
    }

    /// Where each vertex is at this amount, clamped.
    pub fn positions(&self, amount: f32) -> impl Iterator<Item = (VertexId, Vec3)> + '_ {
        let amount = self.clamp(amount);
        self.vertices.iter().map(move |slide| (slide.vertex, slide.from + slide.by * amount))
    }

    /// Moves the vertices to where they are at this amount, clamped to the limit, and gives the
    /// amount used. Corner values (texture coordinates, normals, colours) and vertex colours follow: they
    /// become those that the faces had at the new places before the edit, but for extruded faces, which
    /// take theirs along. Costs O(vertices that move + corners of the faces there), and depends on no
    /// earlier call.
    ///
    /// # Errors
    /// [`Refusal::TooFarAway`] where a position would not be finite; nothing moves.
    pub fn apply(&self, mesh: &mut Mesh, amount: f32) -> Result<f32, Refusal> {
        if let Some((v, _)) = self.positions(amount).find(|(_, position)| !position.is_finite()) {
            return Err(Refusal::TooFarAway(v));
        }
        for (v, position) in self.positions(amount) {
            mesh.set_position(v, position);
        }
        self.followers.update(mesh);
        Ok(self.clamp(amount))
    }
}

/// An interactive edit whose topology is made, at size zero; its slide gives it its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Live {
    /// What was made and taken away.
    pub made: Made,
    /// How the vertices move.
    pub slide: Slide,
}
