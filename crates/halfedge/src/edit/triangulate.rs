//! Triangulate: a polygon cut into triangles between its own corners.
//!
//! A cut may not join corners that an edge joins already. A fan joins the first corner to all others, so it is possible
//! exactly if no edge joins it to any but its neighbours. The other methods find a way around the existing edges if
//! there is one: see [`PolygonTriangulator`].

use crate::edit::Refusal;
use crate::geometry::PolygonTriangulator;
use crate::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};
use glam::Vec3;

/// How to cut a face into triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Triangulation {
    /// As the face is drawn, picked and saved: by the rule of [`PolygonTriangulator`].
    #[default]
    Auto,
    /// A fan from the face's first corner.
    Fan,
    /// Ear by ear.
    Ears,
}

/// The result of triangulating a face, which keeps its id as one of the triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Triangulated {
    /// The cuts.
    pub edges: Vec<EdgeId>,
    /// The new triangles.
    pub faces: Vec<FaceId>,
}

/// Whether [`triangulate_face`] would succeed.
pub fn can_triangulate_face(mesh: &Mesh, face: FaceId, by: Triangulation) -> Result<(), Refusal> {
    find_triangles(mesh, face, by).map(drop)
}

/// Cuts a face with n corners into n - 2 triangles, with no new vertex. A triangle is left as it is.
///
/// All ids survive. A fan costs O(n * valence of the first corner). The others cost O(n²); a face that
/// touches or crosses itself or has existing edges in the way costs a bounded O(n³) up to 128 corners.
/// Attributes: triangles copy the face's, corners those of the corners they came from.
///
/// # Errors
/// [`Refusal::AlreadyJoined`] if an edge is in the way of the fan; [`Refusal::NoTriangulation`] if every triangulation
/// would duplicate an edge, or none was found for more than 128 corners.
pub fn triangulate_face(mesh: &mut Mesh, face: FaceId, by: Triangulation) -> Result<Triangulated, Refusal> {
    let triangles = find_triangles(mesh, face, by)?;
    let mut made = Triangulated::default();
    let Some((_, cut_off)) = triangles.split_last() else { return Ok(made) };
    let mut sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
    let count = sides.len() as u32;
    let mut next: Vec<u32> = (1..count).chain([0]).collect();
    for &[a, b, c] in cut_off {
        // The tip is the corner between two sides of what is left.
        let is_ear =
            |[before, tip, after]: [u32; 3]| next[before as usize] == tip && next[tip as usize] == after;
        let ear = [[a, b, c], [b, c, a], [c, a, b]].into_iter().find(|&ear| is_ear(ear));
        let Some([before, _, after]) = ear.map(|ear| ear.map(|i| i as usize)) else { continue };
        let (across, triangle) = mesh.cut_face(sides[before], sides[after]);
        sides[before] = across;
        next[before] = after as u32;
        made.edges.push(across.edge());
        made.faces.push(triangle);
    }
    Ok(made)
}

/// The triangles as numbers of corners, each an ear of what is left by those before it.
fn find_triangles(mesh: &Mesh, face: FaceId, by: Triangulation) -> Result<Vec<[u32; 3]>, Refusal> {
    mesh.require_face(face)?;
    let corners: Vec<VertexId> = mesh.face_vertices(face).collect();
    let count = corners.len() as u32;
    if by == Triangulation::Fan {
        // A fan joins the first corner to all but its neighbours in the face.
        let inner = corners.get(2..corners.len().saturating_sub(1)).unwrap_or_default();
        return match inner.iter().find(|&&v| mesh.find_halfedge_between(corners[0], v).is_some()) {
            Some(&v) => Err(Refusal::AlreadyJoined(corners[0], v)),
            None => Ok((2..count).map(|i| [0, i - 1, i]).collect()),
        };
    }
    let positions: Vec<Vec3> = corners.iter().map(|&v| mesh.position(v)).collect();
    let allowed =
        |i: u32, j: u32| mesh.find_halfedge_between(corners[i as usize], corners[j as usize]).is_none();
    PolygonTriangulator::new()
        .triangulate_with(&positions, by == Triangulation::Auto, allowed)
        .map(<[_]>::to_vec)
        .ok_or(Refusal::NoTriangulation(face))
}
