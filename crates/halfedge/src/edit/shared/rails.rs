//! Rails: the lines along which vertices slide over the surface.

use super::{Follower, Followers};
use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{HalfedgeId, NumberRange, VertexId};
use glam::Vec3;

/// The line along which a vertex slides, from where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rail {
    /// The vertex.
    pub vertex: VertexId,
    /// Where the rail ends.
    pub to: Vec3,
    /// What it runs along.
    pub(crate) along: Along,
}

/// What a rail runs along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Along {
    /// The edge of this half-edge, which leaves the vertex.
    Edge(HalfedgeId),
    /// The face at this corner of the vertex.
    Face(HalfedgeId),
}

impl Rail {
    /// The rail along the edge of a half-edge, from the vertex that it leaves to its end.
    pub(crate) fn along_edge(mesh: &Mesh, h: HalfedgeId) -> Self {
        Self { vertex: mesh.from(h), to: mesh.position(mesh.to(h)), along: Along::Edge(h) }
    }

    /// Whether the rail lies in the face at this corner of its vertex.
    fn is_in_face_of(&self, mesh: &Mesh, corner: HalfedgeId) -> bool {
        match self.along {
            Along::Edge(h) => corner == h || corner == mesh.next(h.twin()),
            Along::Face(own) => corner == own,
        }
    }
}

/// The amounts of a slide: fractions of the way to the neighbours on one side or the other.
pub const SLIDE_AMOUNT_RANGE: NumberRange = NumberRange::new(-1.0, 1.0);

/// Refuses an amount of a slide that is out of range.
///
/// # Errors
/// [`Refusal::OutOfRange`].
pub fn check_amount(amount: f32) -> Result<(), Refusal> {
    SLIDE_AMOUNT_RANGE.require("amount", amount)
}

/// Moves each vertex by the fraction `t` along its rail, of which it has one. Corner values and vertex values become those
/// that the faces had at the new places.
pub(crate) fn slide_along(mesh: &mut Mesh, rails: &[Rail], t: f32) {
    if t == 0.0 {
        return;
    }
    let mut followers = Vec::new();
    if Followers::has_columns(mesh) {
        for rail in rails {
            for corner in mesh.outgoing(rail.vertex).filter(|&h| mesh.face_of(h).is_some()) {
                // The faces that the vertex slides over know the values there; the others only continue theirs.
                let rank = usize::from(rail.is_in_face_of(mesh, corner));
                followers.push(Follower { corner, vertex: rail.vertex, side: Some(corner), rank });
            }
        }
    }
    let followers = Followers::new(mesh, followers, |_, _| true);
    for rail in rails {
        // In double precision the ends are exact, and the difference of two coordinates is finite.
        let from = mesh.position(rail.vertex).as_dvec3();
        mesh.set_position(rail.vertex, from.lerp(rail.to.as_dvec3(), f64::from(t)).as_vec3());
    }
    followers.update(mesh);
}
