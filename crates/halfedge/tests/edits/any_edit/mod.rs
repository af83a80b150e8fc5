//! One edit of any kind, at random elements with random parameters.

mod many;

use crate::random::Random;
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, Mesh, VertexId};

/// The kinds of edits.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    SplitEdge,
    FlipEdge,
    CollapseEdge,
    CollapseFace,
    SplitVertex,
    DissolveVertex,
    DissolveEdges,
    DeleteFaces,
    DeleteVertices,
    TriangulateFace,
    PokeFaces,
    ConnectVertices,
    ExtrudeFaces,
    InsetFaces,
    ExtrudeEdges,
    BevelEdges,
    BevelVertices,
    LoopCut,
    SlideEdges,
    SlideVertices,
    FillHole,
    Bridge,
    SmoothBridge,
    MergeVertices,
    WeldEdges,
    RipEdges,
    FlipOrientation,
    SetCrease,
}

impl Kind {
    pub const ALL: [Self; 28] = [
        Self::SplitEdge,
        Self::FlipEdge,
        Self::CollapseEdge,
        Self::CollapseFace,
        Self::SplitVertex,
        Self::DissolveVertex,
        Self::DissolveEdges,
        Self::DeleteFaces,
        Self::DeleteVertices,
        Self::TriangulateFace,
        Self::PokeFaces,
        Self::ConnectVertices,
        Self::ExtrudeFaces,
        Self::InsetFaces,
        Self::ExtrudeEdges,
        Self::BevelEdges,
        Self::BevelVertices,
        Self::LoopCut,
        Self::SlideEdges,
        Self::SlideVertices,
        Self::FillHole,
        Self::Bridge,
        Self::SmoothBridge,
        Self::MergeVertices,
        Self::WeldEdges,
        Self::RipEdges,
        Self::FlipOrientation,
        Self::SetCrease,
    ];
}

/// The elements of a mesh.
struct Elements {
    vertices: Vec<VertexId>,
    edges: Vec<EdgeId>,
    faces: Vec<FaceId>,
}

impl Elements {
    fn of(mesh: &Mesh) -> Self {
        Self {
            vertices: mesh.vertices().collect(),
            edges: mesh.edges().collect(),
            faces: mesh.faces().collect(),
        }
    }
}

/// How an edit says that it changed the mesh; none where it says nothing.
#[derive(Default)]
pub struct Said {
    /// The change of the Euler characteristic.
    pub euler: Option<i64>,
    /// The change of the number of boundary loops.
    pub loops: Option<i64>,
    /// The changes of the numbers of vertices, edges and faces.
    pub counts: Option<[i64; 3]>,
}

impl Said {
    fn made(made: &Made) -> Self {
        let change = |a: usize, b: usize| a as i64 - b as i64;
        Self {
            euler: Some(made.euler_change()),
            loops: None,
            counts: Some([
                change(made.vertices.len(), made.removed_vertices.len()),
                change(made.edges.len(), made.removed_edges.len()),
                change(made.faces.len(), made.removed_faces.len()),
            ]),
        }
    }

    /// The topology stays the same.
    fn same_topology(self) -> Self {
        assert!(self.euler.is_none_or(|change| change == 0), "the edit keeps the Euler characteristic");
        Self { euler: Some(0), loops: Some(0), ..self }
    }
}

pub type Tried = Result<Said, Refusal>;

/// Runs a check and its edit, which must agree.
fn check_and_edit<T>(
    mesh: &mut Mesh,
    can: impl Fn(&Mesh) -> Result<(), Refusal>,
    edit: impl FnOnce(&mut Mesh) -> Result<T, Refusal>,
    said: impl FnOnce(&T) -> Said,
) -> Tried {
    let allowed = can(mesh);
    match edit(mesh) {
        Ok(made) => {
            allowed.expect("the edit did what the check refused");
            Ok(said(&made))
        }
        Err(refusal) => {
            assert_eq!(allowed, Err(refusal.clone()), "the check and the edit disagree");
            Err(refusal)
        }
    }
}

/// Makes an edit of this kind, or tries to.
pub fn edit_any(mesh: &mut Mesh, random: &mut Random, kind: Kind) -> Tried {
    let all = Elements::of(mesh);
    let nothing = Refusal::NothingGiven(halfedge::Element::Face);
    let edge = random.pick(&all.edges).ok_or(nothing.clone())?;
    let face = random.pick(&all.faces).ok_or(nothing.clone())?;
    let vertex = random.pick(&all.vertices).ok_or(nothing)?;
    let t = random.unit();
    match kind {
        Kind::SplitEdge => {
            let connect = [Connect::None, Connect::Triangles, Connect::All][random.below(3)];
            check_and_edit(
                mesh,
                |m| can_split_edge(m, edge, t, connect),
                |m| split_edge(m, edge, t, connect),
                |made| {
                    let [edges, faces] = [made.edges.len() as i64, made.faces.len() as i64];
                    Said { counts: Some([1, edges, faces]), ..Said::default() }.same_topology()
                },
            )
        }
        Kind::FlipEdge => check_and_edit(
            mesh,
            |m| can_flip_edge(m, edge),
            |m| flip_edge(m, edge),
            |()| Said { counts: Some([0, 0, 0]), ..Said::default() }.same_topology(),
        ),
        Kind::CollapseEdge => check_and_edit(
            mesh,
            |m| can_collapse_edge(m, edge, t),
            |m| collapse_edge(m, edge, t),
            |made| {
                let [edges, faces] = [made.removed_edges.len() as i64, made.removed_faces.len() as i64];
                Said { counts: Some([-1, -edges, -faces]), ..Said::default() }.same_topology()
            },
        ),
        Kind::CollapseFace => {
            check_and_edit(mesh, |m| can_collapse_face(m, face), |m| collapse_face(m, face), Said::made)
        }
        Kind::SplitVertex => {
            let edges: Vec<EdgeId> = mesh.vertex_edges(vertex).collect();
            let (Some(a), Some(b)) = (random.pick(&edges), random.pick(&edges)) else {
                return Ok(unchanged());
            };
            check_and_edit(
                mesh,
                |m| can_split_vertex(m, vertex, [a, b], None),
                |m| split_vertex(m, vertex, [a, b], None),
                |made| Said::made(made).same_topology(),
            )
        }
        Kind::DissolveVertex => check_and_edit(
            mesh,
            |m| can_dissolve_vertex(m, vertex),
            |m| dissolve_vertex(m, vertex),
            |made| Said::made(made).same_topology(),
        ),
        Kind::DissolveEdges => {
            let inner: Vec<EdgeId> =
                all.edges.iter().copied().filter(|&e| !mesh.is_boundary_edge(e)).collect();
            let from = if random.below(10) == 0 { &all.edges } else { &inner };
            let edges: Vec<EdgeId> = (0..=random.below(4)).filter_map(|_| random.pick(from)).collect();
            let keep_vertices = random.below(2) == 0;
            check_and_edit(
                mesh,
                |m| can_dissolve_edges(m, &edges),
                |m| dissolve_edges(m, &edges, keep_vertices),
                |made| Said::made(made).same_topology(),
            )
        }
        Kind::DeleteFaces => {
            let some: Vec<FaceId> = if all.faces.len() > 100 {
                all.faces.iter().copied().filter(|_| random.below(2) == 0).collect()
            } else {
                (0..=random.below(3)).filter_map(|_| random.pick(&all.faces)).collect()
            };
            check_and_edit(mesh, |m| can_delete_faces(m, &some), |m| delete_faces(m, &some), Said::made)
        }
        Kind::DeleteVertices => check_and_edit(
            mesh,
            |m| can_delete_vertices(m, &[vertex]),
            |m| delete_vertices(m, &[vertex]),
            Said::made,
        ),
        Kind::TriangulateFace => {
            let count = |made: &Triangulated| {
                let [edges, faces] = [made.edges.len() as i64, made.faces.len() as i64];
                Said { counts: Some([0, edges, faces]), ..Said::default() }.same_topology()
            };
            let by = [Triangulation::Auto, Triangulation::Fan, Triangulation::Ears][random.below(3)];
            check_and_edit(
                mesh,
                |m| can_triangulate_face(m, face, by),
                |m| triangulate_face(m, face, by),
                count,
            )
        }
        Kind::PokeFaces => {
            let some: Vec<FaceId> = (0..=random.below(3)).filter_map(|_| random.pick(&all.faces)).collect();
            check_and_edit(
                mesh,
                |m| can_poke_faces(m, &some),
                |m| poke_faces(m, &some),
                |made| Said::made(made).same_topology(),
            )
        }
        Kind::ConnectVertices => {
            let corners: Vec<VertexId> = mesh.face_vertices(face).collect();
            let (Some(a), Some(b)) = (random.pick(&corners), random.pick(&corners)) else {
                return Ok(unchanged());
            };
            check_and_edit(
                mesh,
                |m| can_connect_vertices(m, a, b),
                |m| connect_vertices(m, a, b),
                |_| Said { counts: Some([0, 1, 1]), ..Said::default() }.same_topology(),
            )
        }
        _ => many::edit_many(mesh, random, kind, &all, t),
    }
}

fn unchanged() -> Said {
    Said { counts: Some([0, 0, 0]), ..Said::default() }.same_topology()
}
