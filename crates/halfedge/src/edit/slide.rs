//! Slides: the second half of an interactive edit. The first half makes new vertices where old ones are; the slide
//! moves them by an amount, any number of times.

use crate::VertexId;
use crate::edit::shared::Followers;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use glam::Vec3;
use rustc_hash::FxHashMap;

/// A vertex that a [`Slide`] moves to `from + amount * by`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlideVertex {
    /// The vertex.
    pub vertex: VertexId,
    /// The position at amount 0.
    pub from: Vec3,
    /// The movement per unit of the amount.
    pub by: Vec3,
}

/// The moves of an interactive edit as a function of one amount.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slide {
    /// The vertices that move.
    pub vertices: Vec<SlideVertex>,
    /// The largest amount at which no edge is reversed; larger amounts are clamped to it. Infinite if there is no
    /// such limit.
    pub limit: f32,
    /// The values that follow the vertices.
    followers: Followers,
}

impl Slide {
    /// A slide with no limit.
    pub(crate) fn unlimited(vertices: Vec<SlideVertex>, followers: Followers) -> Self {
        Self { vertices, limit: f32::INFINITY, followers }
    }

    /// A slide that ends where the first edge of the mesh would lose its length and be reversed. Edges without
    /// length at amount 0, where the edit has just cut a corner, set no limit.
    pub(crate) fn limited(mesh: &Mesh, vertices: Vec<SlideVertex>, followers: Followers) -> Self {
        let by: FxHashMap<VertexId, Vec3> = vertices.iter().map(|slide| (slide.vertex, slide.by)).collect();
        let mut limit = f32::INFINITY;
        for slide in &vertices {
            for v in mesh.neighbors(slide.vertex) {
                // The square of a length may be out of the range of single precision.
                let along = mesh.position(v).as_dvec3() - slide.from.as_dvec3();
                let length = along.length();
                let other = by.get(&v).copied().unwrap_or_default();
                let shrinks = (slide.by - other).as_dvec3().dot(along) / length;
                if length > 0.0 && shrinks > 0.0 {
                    limit = limit.min((length / shrinks) as f32);
                }
            }
        }
        Self { vertices, limit, followers }
    }

    /// The amount that [`Slide::apply`] uses in place of this one.
    pub fn clamp(&self, amount: f32) -> f32 {
        amount.min(self.limit)
    }

    /// The position of each vertex at this amount, clamped.
    pub fn positions(&self, amount: f32) -> impl Iterator<Item = (VertexId, Vec3)> + '_ {
        let amount = self.clamp(amount);
        self.vertices.iter().map(move |slide| (slide.vertex, slide.from + slide.by * amount))
    }

    /// Moves the vertices to their positions at this amount, clamped to the limit; returns the amount used. Corner
    /// values (texture coordinates, normals, colours) and vertex values follow: they become those that the faces
    /// had at the new places before the edit. Extruded faces take theirs along instead. The result doesn't depend
    /// on earlier calls. Costs O(moved vertices + corners of the faces there).
    ///
    /// # Errors
    /// [`Refusal::TooFarAway`] if a position would not be finite; nothing moves.
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

/// An interactive edit: its topology exists at size zero, and its slide gives it its size.
#[derive(Clone, Debug, PartialEq)]
pub struct SlidingEdit {
    /// What was added and removed.
    pub made: Made,
    /// The moves of the vertices.
    pub slide: Slide,
}
