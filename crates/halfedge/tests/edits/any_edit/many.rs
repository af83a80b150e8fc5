//! Edits of many elements or of large parts of the mesh.

use super::{Elements, Kind, Said, Tried, check_and_edit, unchanged};
use crate::random::Random;
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};
use std::collections::BTreeSet;

/// A few of the elements, many or all.
fn some<T: Copy>(random: &mut Random, from: &[T]) -> Vec<T> {
    match random.below(8) {
        0 => from.to_vec(),
        1 | 2 => from.iter().copied().filter(|_| random.below(2) == 0).collect(),
        _ => (0..=random.below(5)).filter_map(|_| random.pick(from)).collect(),
    }
}

/// Makes an interactive edit and slides it by this amount.
fn slide(mesh: &mut Mesh, live: Result<SlidingEdit, Refusal>, amount: f32) -> Result<SlidingEdit, Refusal> {
    let live = live?;
    let used = live.slide.apply(mesh, amount)?;
    assert!(used <= amount && used <= live.slide.limit);
    Ok(live)
}

/// Makes an edit of this kind, or tries to.
pub(super) fn edit_many(mesh: &mut Mesh, random: &mut Random, kind: Kind, all: &Elements, t: f32) -> Tried {
    let edge = all.edges[random.below(all.edges.len())];
    let boundary: Vec<EdgeId> = all.edges.iter().copied().filter(|&e| mesh.is_boundary_edge(e)).collect();
    let loops = mesh.boundary_loops();
    let grouping = [Grouping::Region, Grouping::Individual][random.below(2)];
    let live = |live: &SlidingEdit| Said::made(&live.made).same_topology();
    match kind {
        Kind::ExtrudeFaces | Kind::InsetFaces => {
            let faces = some(random, &all.faces);
            if kind == Kind::ExtrudeFaces {
                let edit = |m: &mut Mesh| slide_extrusion(m, &faces, grouping, t - 0.5);
                check_and_edit(mesh, |m| can_extrude_faces(m, &faces, grouping), edit, live)
            } else {
                let edit = |m: &mut Mesh| {
                    let live = inset_faces(m, &faces, grouping);
                    slide(m, live, t)
                };
                check_and_edit(mesh, |m| can_inset_faces(m, &faces, grouping), edit, live)
            }
        }
        Kind::ExtrudeEdges => {
            let edges = some(random, &boundary);
            let edit = |m: &mut Mesh| {
                let live = extrude_edges(m, &edges, Vec3::new(t, 1.0, -t));
                slide(m, live, 1.0)
            };
            check_and_edit(mesh, |m| can_extrude_edges(m, &edges), edit, live)
        }
        Kind::BevelEdges => {
            let inner: Vec<EdgeId> =
                all.edges.iter().copied().filter(|&e| !mesh.is_boundary_edge(e)).collect();
            let from = if random.below(10) == 0 { &all.edges } else { &inner };
            let edges = some(random, from);
            let segments = random.below(4) as u32;
            let edit = |m: &mut Mesh| {
                let live = bevel_edges(m, &edges, segments);
                slide(m, live, t)
            };
            check_and_edit(mesh, |m| can_bevel_edges(m, &edges, segments), edit, live)
        }
        Kind::BevelVertices => {
            let vertices = some(random, &all.vertices);
            let edit = |m: &mut Mesh| {
                let live = bevel_vertices(m, &vertices);
                slide(m, live, t)
            };
            check_and_edit(mesh, |m| can_bevel_vertices(m, &vertices), edit, live)
        }
        Kind::LoopCut => {
            let cuts = random.below(4) as u32;
            check_and_edit(
                mesh,
                |m| can_loop_cut(m, edge, cuts, t),
                |m| loop_cut(m, edge, cuts, t),
                |made| Said::made(made).same_topology(),
            )
        }
        Kind::SlideEdges => {
            let edges = some(random, &all.edges);
            let amount = t * 2.0 - 1.0;
            check_and_edit(
                mesh,
                |m| can_slide_edges(m, &edges, amount),
                |m| slide_edges(m, &edges, amount),
                |_| unchanged(),
            )
        }
        Kind::SlideVertices => {
            let vertices = some(random, &all.vertices);
            let direction = Vec3::new(random.unit() - 0.5, 0.2, random.unit() - 0.5);
            let amount = t * 2.0 - 1.0;
            check_and_edit(
                mesh,
                |m| can_slide_vertices(m, &vertices, direction, amount),
                |m| slide_vertices(m, &vertices, direction, amount),
                |_| unchanged(),
            )
        }
        Kind::FillHole => {
            let side = random.pick(&loops).unwrap_or(edge.halfedge());
            check_and_edit(
                mesh,
                |m| can_fill_hole(m, side),
                |m| fill_hole(m, side),
                |made| Said { euler: Some(1), loops: Some(-1), ..Said::made(made) },
            )
        }
        Kind::Bridge | Kind::SmoothBridge => {
            let bands = Bands {
                twist: random.below(9) as i32 - 4,
                cuts: random.below(3) as u32,
                smoothness: if kind == Kind::Bridge { 0.0 } else { 1.0 + random.below(2) as f32 },
            };
            // Often more loops or regions than two.
            let count = 2 + 2 * random.below(2);
            if random.below(2) == 0 {
                let faces: Vec<FaceId> = (0..count).filter_map(|_| random.pick(&all.faces)).collect();
                check_and_edit(
                    mesh,
                    |m| can_bridge_faces(m, &faces, bands),
                    |m| bridge_faces(m, &faces, bands),
                    |made| Said { loops: Some(0), ..Said::made(made) },
                )
            } else {
                let pick = |_| random.pick(&loops).unwrap_or(edge.halfedge());
                let sides: Vec<HalfedgeId> = (0..count).map(pick).collect();
                let joined: BTreeSet<HalfedgeId> = sides.iter().copied().collect();
                check_and_edit(
                    mesh,
                    |m| can_bridge(m, &sides, bands),
                    |m| bridge(m, &sides, bands),
                    |made| Said { euler: Some(0), loops: Some(-(joined.len() as i64)), ..Said::made(made) },
                )
            }
        }
        Kind::MergeVertices => {
            let vertices: Vec<VertexId> = if random.below(2) == 0 {
                mesh.ends(edge).to_vec()
            } else {
                (0..=random.below(4)).filter_map(|_| random.pick(&all.vertices)).collect()
            };
            let position = [None, Some(Vec3::splat(t))][random.below(2)];
            check_and_edit(
                mesh,
                |m| can_merge_vertices(m, &vertices, position),
                |m| merge_vertices(m, &vertices, position),
                Said::made,
            )
        }
        Kind::WeldEdges => {
            // Often neighbours on a boundary loop, else any two.
            let first = random.pick(&boundary).unwrap_or(edge);
            let side = first.halfedges().into_iter().find(|&h| mesh.is_boundary_halfedge(h));
            let other = match (random.below(2), side) {
                (0, Some(side)) => mesh.next(side).edge(),
                _ => random.pick(&boundary).unwrap_or(edge),
            };
            check_and_edit(
                mesh,
                |m| can_weld_edges(m, [first, other]),
                |m| weld_edges(m, [first, other]),
                Said::made,
            )
        }
        Kind::RipEdges => {
            let edges = some(random, &all.edges);
            check_and_edit(mesh, |m| can_rip_edges(m, &edges), |m| rip_edges(m, &edges), Said::made)
        }
        Kind::FlipOrientation => {
            // Mostly a whole piece.
            let (piece, _) = mesh.components();
            let chosen = piece[mesh.ends(edge)[0].index()];
            let mut faces: Vec<FaceId> = all
                .faces
                .iter()
                .copied()
                .filter(|&f| piece[mesh.from(mesh.halfedge_of(f)).index()] == chosen)
                .collect();
            if random.below(4) == 0 {
                faces.pop();
            }
            check_and_edit(
                mesh,
                |m| can_flip_orientation(m, &faces),
                |m| flip_orientation(m, &faces),
                |()| unchanged(),
            )
        }
        Kind::SetCrease => {
            let (edges, vertices) = (some(random, &all.edges), some(random, &all.vertices));
            check_and_edit(
                mesh,
                |m| can_set_crease(m, &edges, &vertices, t * 10.0),
                |m| set_crease(m, &edges, &vertices, t * 10.0),
                |()| unchanged(),
            )
        }
        _ => unreachable!("{kind:?} is an edit of few elements"),
    }
}

fn slide_extrusion(
    mesh: &mut Mesh,
    faces: &[FaceId],
    grouping: Grouping,
    amount: f32,
) -> Result<SlidingEdit, Refusal> {
    let live = extrude_faces(mesh, faces, grouping);
    slide(mesh, live, amount)
}
