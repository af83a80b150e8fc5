//! Curvatures at vertices, from the angles and edges around them.
//!
//! Meyer, Desbrun, Schröder and Barr: Discrete differential-geometry operators for triangulated 2-manifolds (2003) for
//! the angle defect; Cohen-Steiner and Morvan: Restricted Delaunay triangulations and normal cycle (2003) for the mean
//! curvature of edges. A vertex has an equal share of each of its faces' areas.

use glam::DVec3;
use halfedge::geometry::face_area_vector;
use halfedge::{HalfedgeId, Mesh, VertexId};
use std::f64::consts::TAU;

/// The Gaussian curvature at a vertex, in 1 / mesh units²: positive where the surface is like a ball or a bowl,
/// negative at saddles. Not a number at boundaries and where there is no area. Costs O(corners of its faces).
pub fn gaussian_curvature(mesh: &Mesh, vertex: VertexId) -> f64 {
    let Some(area) = area_around(mesh, vertex) else { return f64::NAN };
    let angles: f64 = mesh.outgoing(vertex).map(|h| corner_angle(mesh, h)).sum();
    (TAU - angles) / area
}

/// The mean curvature at a vertex, in 1 / mesh units: positive where the surface bulges out, negative where it is
/// hollow. Not a number at boundaries and where there is no area. Costs O(corners of its faces).
pub fn mean_curvature(mesh: &Mesh, vertex: VertexId) -> f64 {
    let Some(area) = area_around(mesh, vertex) else { return f64::NAN };
    // Half an edge's angle times its length is the integral over it; each end has half of that.
    mesh.outgoing(vertex).map(|h| bend(mesh, h)).sum::<f64>() / (4.0 * area)
}

/// The vertex's share of the area around it; none at a boundary and where there is no area.
fn area_around(mesh: &Mesh, vertex: VertexId) -> Option<f64> {
    if mesh.is_boundary_vertex(vertex) {
        return None;
    }
    let shares =
        mesh.vertex_faces(vertex).map(|f| face_area_vector(mesh, f).length() / mesh.face_degree(f) as f64);
    Some(shares.sum()).filter(|area: &f64| *area > 0.0)
}

fn at(mesh: &Mesh, vertex: VertexId) -> DVec3 {
    mesh.position(vertex).as_dvec3()
}

/// The angle between two directions, in radians.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// The angle of the corner at the start of a half-edge.
fn corner_angle(mesh: &Mesh, h: HalfedgeId) -> f64 {
    let corner = at(mesh, mesh.from(h));
    angle(at(mesh, mesh.to(h)) - corner, at(mesh, mesh.from(mesh.prev(h))) - corner)
}

/// The length of an edge times the angle by which its faces turn away from each other.
fn bend(mesh: &Mesh, h: HalfedgeId) -> f64 {
    let (Some(left), Some(right)) = (mesh.face_of(h), mesh.face_of(h.twin())) else { return 0.0 };
    let (left, right) = (face_area_vector(mesh, left), face_area_vector(mesh, right));
    let along = at(mesh, mesh.to(h)) - at(mesh, mesh.from(h));
    let bulges = left.cross(right).dot(along);
    angle(left, right) * along.length() * bulges.signum()
}
