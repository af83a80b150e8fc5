//! Making a tree, all at once or a slice at a time.

use super::{FaceTree, LEAF, face_bounds};
use crate::measure::Bounds;
use crate::morton;
use glam::Vec3;
use halfedge::{FaceId, Mesh, NONE};

/// Faces in order of id are taken as they come when those that share a box are within this many face
/// sizes of each other on average; else they are sorted along a curve through space.
const COHERENT: f64 = 12.0;
/// How many boxes are looked at to find that out.
const SAMPLES: usize = 1024;

/// A tree that is being made, for callers that can't wait for all of it. The mesh must stay the same
/// meanwhile.
#[derive(Clone, Debug)]
pub struct FaceTreeBuilder {
    order: Vec<u32>,
    /// How many faces of `order` the present stage has looked at.
    done: usize,
    stage: Stage,
}

#[derive(Clone, Debug)]
enum Stage {
    /// Boxes of leaves as they come, which are then sorted.
    LeavesInTurn(Vec<Bounds>),
    /// The middles of the faces, which are then sorted.
    Centers(Vec<Vec3>),
    /// Boxes of leaves of sorted faces.
    Leaves(Vec<Bounds>),
}

impl FaceTreeBuilder {
    /// Starts a tree of all faces. Costs O(face ids), little for each.
    pub fn new(mesh: &Mesh) -> Self {
        let order: Vec<u32> = mesh.faces().map(FaceId::raw).collect();
        let stage = match is_coherent(mesh, &order) {
            true => Stage::LeavesInTurn(Vec::with_capacity(order.len().div_ceil(LEAF))),
            false => Stage::Centers(Vec::with_capacity(order.len())),
        };
        Self { order, done: 0, stage }
    }

    /// Makes the rest of the tree. Costs O(mesh).
    pub fn finish(mut self, mesh: &Mesh) -> FaceTree {
        loop {
            if let Some(tree) = self.step(mesh, usize::MAX) {
                return tree;
            }
        }
    }

    /// Looks at about so many faces more, each of which is looked at once or twice; gives the tree when
    /// it is done. Costs that, and at the ends of stages O(mesh), little for each face.
    pub fn step(&mut self, mesh: &Mesh, faces: usize) -> Option<FaceTree> {
        let count = self.order.len();
        let end = self.done.saturating_add(faces.max(1)).min(count).next_multiple_of(LEAF).min(count);
        let slice = &self.order[self.done..end];
        let bounds = |&face: &u32| face_bounds(mesh, FaceId::new(face as usize));
        let leaf_of = |chunk: &[u32]| chunk.iter().map(bounds).fold(Bounds::EMPTY, Bounds::union);
        match &mut self.stage {
            Stage::LeavesInTurn(leaves) | Stage::Leaves(leaves) => {
                leaves.extend(slice.chunks(LEAF).map(leaf_of));
            }
            Stage::Centers(centers) => centers.extend(slice.iter().map(|face| bounds(face).center())),
        }
        self.done = end;
        if end < self.order.len() {
            return None;
        }
        let leaves = match &mut self.stage {
            Stage::LeavesInTurn(leaves) => sort_leaves(&mut self.order, leaves),
            Stage::Leaves(leaves) => std::mem::take(leaves),
            Stage::Centers(centers) => {
                self.order = morton::order(self.order.iter().copied().zip(centers.iter().copied()));
                self.done = 0;
                self.stage = Stage::Leaves(Vec::with_capacity(self.order.len().div_ceil(LEAF)));
                return None;
            }
        };
        let order = std::mem::take(&mut self.order);
        let mut place = vec![NONE; mesh.face_capacity()];
        for (at, &face) in order.iter().enumerate() {
            place[face as usize] = at as u32;
        }
        let sorted = order.len();
        let mut tree = FaceTree { order, place, levels: vec![leaves], sorted };
        tree.fit_levels();
        Some(tree)
    }
}

/// Sorts leaves along the curve, and with them their faces; gives the boxes in that order.
fn sort_leaves(order: &mut Vec<u32>, in_turn: &[Bounds]) -> Vec<Bounds> {
    // Only whole leaves change places; the last, which may be short, stays last.
    let whole = order.len() / LEAF;
    let mut sorted = morton::order((0u32..).zip(in_turn[..whole].iter().map(|b| b.center())));
    sorted.extend(whole as u32..in_turn.len() as u32);
    *order = (sorted.iter())
        .flat_map(|&leaf| {
            let start = leaf as usize * LEAF;
            &order[start..order.len().min(start + LEAF)]
        })
        .copied()
        .collect();
    sorted.iter().map(|&leaf| in_turn[leaf as usize]).collect()
}

fn extent(bounds: Bounds) -> f64 {
    let size = bounds.max.as_dvec3() - bounds.min.as_dvec3();
    size.x + size.y + size.z
}

/// Whether faces that follow each other are near each other, as far as some of them tell.
fn is_coherent(mesh: &Mesh, order: &[u32]) -> bool {
    let chunks = order.len().div_ceil(LEAF);
    let (mut faces_extent, mut leaves_extent, mut faces, mut leaves) = (0.0, 0.0, 0usize, 0usize);
    for chunk in order.chunks(LEAF).step_by(chunks.div_ceil(SAMPLES).max(1)) {
        let mut leaf = Bounds::EMPTY;
        for &face in chunk {
            let bounds = face_bounds(mesh, FaceId::new(face as usize));
            faces_extent += extent(bounds);
            leaf = leaf.union(bounds);
        }
        leaves_extent += extent(leaf);
        faces += chunk.len();
        leaves += 1;
    }
    leaves_extent * faces as f64 <= COHERENT * faces_extent * leaves as f64
}
