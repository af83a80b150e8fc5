//! Triangulate: a polygon cut into triangles between its own corners.
//!
//! A fan joins the first corner to all others: possible exactly where none of those it is not
//! beside in the face is joined to it already. Ears are cut one after the other by
//! `geometry::ears`: right on concave and self-touching polygons, and around edges that exist.

use crate::edit::Refusal;
use crate::geometry::{Ear, ears};
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, VertexId};
use glam::Vec3;

/// What triangulating a face made; the face itself keeps its id as one of the triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Triangulated {
    /// The cuts.
    pub edges: Vec<EdgeId>,
    /// The new triangles.
    pub faces: Vec<FaceId>,
}

/// Whether [`triangulate_face`] would succeed.
pub fn can_triangulate_face(mesh: &Mesh, face: FaceId) -> Result<(), Refusal> {
    mesh.need_face(face)?;
    let corners: Vec<_> = mesh.face_vertices(face).collect();
    // A fan joins the first corner to all but its neighbours in the face.
    let inner = corners.get(2..corners.len().saturating_sub(1)).unwrap_or_default();
    match inner.iter().find(|&&v| mesh.joined(corners[0], v).is_some()) {
        Some(&v) => Err(Refusal::AlreadyJoined(corners[0], v)),
        None => Ok(()),
    }
}

/// Cuts a face with n corners into a fan of n - 2 triangles from its first corner, with no new
/// vertex. A triangle is left as it is.
///
/// All ids survive. Costs O(n * valence of the first corner). Attributes: triangles copy the
/// face's, corners those of the corners they came from.
pub fn triangulate_face(mesh: &mut Mesh, face: FaceId) -> Result<Triangulated, Refusal> {
    can_triangulate_face(mesh, face)?;
    let mut made = Triangulated::default();
    for _ in 3..mesh.face_degree(face) {
        // Cut off the corner after the first: the new face is the triangle, the old one the rest.
        let start = mesh.halfedge_of(face);
        let third = mesh.next(mesh.next(start));
        made.cut(mesh, start, third);
    }
    Ok(made)
}

/// Whether [`triangulate_face_ears`] would succeed.
pub fn can_triangulate_face_ears(mesh: &Mesh, face: FaceId) -> Result<(), Refusal> {
    find_ears(mesh, face).map(drop)
}

fn find_ears(mesh: &Mesh, face: FaceId) -> Result<Vec<Ear>, Refusal> {
    mesh.need_face(face)?;
    let corners: Vec<VertexId> = mesh.face_vertices(face).collect();
    let positions: Vec<_> = corners.iter().map(|&v| mesh.position(v).as_dvec3()).collect();
    ears(&positions, |i, j| mesh.joined(corners[i], corners[j]).is_none())
        .ok_or(Refusal::NoTriangulation(face))
}

/// The triangles that ears cut a polygon into, as numbers of its corners: what
/// [`triangulate_face_ears`] does to a face that no edge is in the way of, at the same cost. None of
/// fewer than three corners, and none where one of more than 128 that crosses itself can't be cut.
pub fn polygon_ears(corners: &[Vec3]) -> Option<Vec<[usize; 3]>> {
    if corners.len() < 3 {
        return None;
    }
    let positions: Vec<_> = corners.iter().map(|corner| corner.as_dvec3()).collect();
    let mut triangles = ears(&positions, |_, _| true)?;
    let mut is_left = vec![true; corners.len()];
    triangles.iter().for_each(|&[_, tip, _]| is_left[tip] = false);
    let mut left = (0..corners.len()).filter(|&i| is_left[i]);
    triangles.push([left.next()?, left.next()?, left.next()?]);
    Some(triangles)
}

/// Cuts a face with n corners into n - 2 triangles by its ears: right on concave faces too, and on
/// faces that touch themselves. No new vertex; a triangle is left as it is.
///
/// All ids survive. Costs O(n²), or a bounded O(n³) for faces of up to 128 corners that touch or cross
/// themselves. Attributes: as by [`triangulate_face`].
///
/// # Errors
/// [`Refusal::NoTriangulation`] where every triangulation would duplicate an edge.
pub fn triangulate_face_ears(mesh: &mut Mesh, face: FaceId) -> Result<Triangulated, Refusal> {
    let ears = find_ears(mesh, face)?;
    let mut sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
    let mut made = Triangulated::default();
    for [before, _, after] in ears {
        sides[before] = made.cut(mesh, sides[before], sides[after]);
    }
    Ok(made)
}

impl Triangulated {
    fn cut(&mut self, mesh: &mut Mesh, from: HalfedgeId, to: HalfedgeId) -> HalfedgeId {
        let (across, triangle) = mesh.cut_face(from, to);
        self.edges.push(across.edge());
        self.faces.push(triangle);
        across
    }
}
