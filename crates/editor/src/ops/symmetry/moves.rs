//! Mirroring operations that only move vertices.

use crate::error::Problem;
use crate::ops::Op;
use crate::ops::action::edit_all;
use glam::Vec3;
use halfedge::{Mesh, Progress, VertexId};
use std::collections::BTreeMap;
use surface::{MirrorImages, mirrored};

/// Makes the edits, and moves the images of the vertices that they move. The edits for images move vertices too, so that
/// corner values follow on both sides; where the vertices go is what their mirror images say.
pub(super) fn edit(
    ops: &[Op],
    others: &[Op],
    images: &mut MirrorImages,
    mesh: &mut Mesh,
    notes: &mut Vec<String>,
    progress: &mut Progress<'_>,
) -> Result<(), Problem> {
    edit_all(ops, mesh, notes, progress)?;
    let moves: Vec<Move> = mesh
        .recorded_moves()
        .into_iter()
        .map(|(vertex, from)| Move { vertex, from, to: mesh.position(vertex) })
        .collect();
    put_back(mesh, &moves);
    // Soft selections move vertices that are not among the operations' elements.
    images.look_up(mesh, moves.iter().map(|moved| moved.vertex));
    if !others.is_empty() {
        let mut of_images = Vec::new();
        if edit_all(others, mesh, &mut of_images, progress).is_ok() {
            let again = mesh.recorded_moves().into_iter();
            let again = again.map(|(vertex, from)| Move { vertex, from, to: from }).collect::<Vec<_>>();
            put_back(mesh, &again);
        }
    }
    for (v, to) in mirrored_moves(mesh, images, &moves) {
        mesh.set_position(v, to);
    }
    Ok(())
}

/// A movement of a vertex.
struct Move {
    vertex: VertexId,
    from: Vec3,
    to: Vec3,
}

fn put_back(mesh: &mut Mesh, moves: &[Move]) {
    for moved in moves {
        mesh.set_position(moved.vertex, moved.from);
    }
}

/// Where vertices and their images go. Vertices in the mirror's plane stay in it; where a vertex and its image both move, the
/// one that moves farther leads.
fn mirrored_moves(mesh: &Mesh, images: &MirrorImages, moves: &[Move]) -> BTreeMap<VertexId, Vec3> {
    let axis = images.axis();
    let by: BTreeMap<VertexId, Vec3> = moves.iter().map(|m| (m.vertex, m.to - m.from)).collect();
    let mut all: BTreeMap<VertexId, Vec3> = moves.iter().map(|m| (m.vertex, m.to)).collect();
    for Move { vertex, from, to } in moves {
        let Some(image) = images.vertex(*vertex) else { continue };
        let at = mesh.position(image);
        if image == *vertex {
            // Half the sum with the mirror image is exact: the coordinate across stays as it was.
            let across = (*from - mirrored(*from, axis)) * 0.5;
            all.insert(image, (*to + mirrored(*to, axis)) * 0.5 + across);
            continue;
        }
        let own = (*to - *from).length_squared();
        let is_positive = from.to_array().get(axis).is_some_and(|at| *at > 0.0);
        let leads = by.get(&image).is_none_or(|other| {
            let other = other.length_squared();
            own > other || (own == other && is_positive)
        });
        if leads {
            let is_exact = mirrored(*from, axis) == at;
            let to = if is_exact { mirrored(*to, axis) } else { at + mirrored(*to - *from, axis) };
            all.insert(image, to);
        }
    }
    all
}
