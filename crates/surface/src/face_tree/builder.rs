//! Building a tree, at once or some faces at a time.

use super::{FACES_PER_LEAF, FaceTree, face_bounds};
use crate::measure::Bounds;
use crate::morton;
use glam::Vec3;
use halfedge::{Budget, FaceId, InParts, Mesh, NONE};

/// The order of face ids is kept where leaves in that order are on average smaller than this many faces; otherwise
/// faces are sorted along a space-filling curve.
const MAX_LEAF_EXTENT_FACES: f64 = 12.0;
/// Leaves that are sampled to decide that.
const SAMPLED_LEAVES: usize = 1024;

/// Builds a tree some faces at a time, so that no call takes long. The mesh must not change meanwhile.
#[derive(Clone, Debug)]
pub struct FaceTreeBuilder {
    order: Vec<u32>,
    /// The number of faces in `order` that the current stage has processed.
    done: usize,
    stage: Stage,
}

#[derive(Clone, Debug)]
enum Stage {
    /// Computing the boxes of leaves in order of id; the leaves are sorted then.
    LeavesInTurn(Vec<Bounds>),
    /// Computing the centres of faces; the faces are sorted then.
    Centers(Vec<Vec3>),
    /// Computing the boxes of leaves of sorted faces.
    Leaves(Vec<Bounds>),
}

impl FaceTreeBuilder {
    /// Begins a tree of all faces. Costs O(face ids), little for each.
    pub fn new(mesh: &Mesh) -> Self {
        let order: Vec<u32> = mesh.faces().map(FaceId::raw).collect();
        let stage = match is_coherent(mesh, &order) {
            true => Stage::LeavesInTurn(Vec::with_capacity(order.len().div_ceil(FACES_PER_LEAF))),
            false => Stage::Centers(Vec::with_capacity(order.len())),
        };
        Self { order, done: 0, stage }
    }
}

/// The budget counts faces. Each is processed once or twice. At the end of a stage a part costs O(mesh) besides, little
/// for each face.
impl InParts for FaceTreeBuilder {
    type Input<'a> = &'a Mesh;
    type Output = FaceTree;

    fn step(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<FaceTree> {
        let count = self.order.len();
        let end = (self.done + budget.take(count - self.done)).next_multiple_of(FACES_PER_LEAF).min(count);
        let slice = &self.order[self.done..end];
        let bounds = |&face: &u32| face_bounds(mesh, FaceId::new(face as usize));
        let leaf_of = |chunk: &[u32]| chunk.iter().map(bounds).fold(Bounds::EMPTY, Bounds::union);
        match &mut self.stage {
            Stage::LeavesInTurn(leaves) | Stage::Leaves(leaves) => {
                leaves.extend(slice.chunks(FACES_PER_LEAF).map(leaf_of));
            }
            Stage::Centers(centers) => centers.extend(slice.iter().map(|face| bounds(face).center())),
        }
        self.done = end;
        if end < count {
            return None;
        }
        let leaves = match &mut self.stage {
            Stage::LeavesInTurn(leaves) => sort_leaves(&mut self.order, leaves),
            Stage::Leaves(leaves) => std::mem::take(leaves),
            Stage::Centers(centers) => {
                self.order = morton::order(self.order.iter().copied().zip(centers.iter().copied()));
                self.done = 0;
                self.stage = Stage::Leaves(Vec::with_capacity(self.order.len().div_ceil(FACES_PER_LEAF)));
                // Sorting took about as long as the faces that are left would.
                budget.take(count);
                return None;
            }
        };
        let order = std::mem::take(&mut self.order);
        let mut place = vec![NONE; mesh.face_capacity()];
        for (at, &face) in order.iter().enumerate() {
            place[face as usize] = at as u32;
        }
        let sorted = order.len();
        let mut tree = FaceTree { order, place, levels: vec![leaves], sorted, hidden: Default::default() };
        tree.fit_levels();
        Some(tree)
    }
}

/// Sorts leaves with their faces along the curve; returns the boxes in that order.
fn sort_leaves(order: &mut Vec<u32>, in_turn: &[Bounds]) -> Vec<Bounds> {
    // Only full leaves are sorted; the last one, which may not be full, stays last.
    let whole = order.len() / FACES_PER_LEAF;
    let mut sorted = morton::order((0u32..).zip(in_turn[..whole].iter().map(|b| b.center())));
    sorted.extend(whole as u32..in_turn.len() as u32);
    *order = (sorted.iter())
        .flat_map(|&leaf| {
            let start = leaf as usize * FACES_PER_LEAF;
            &order[start..order.len().min(start + FACES_PER_LEAF)]
        })
        .copied()
        .collect();
    sorted.iter().map(|&leaf| in_turn[leaf as usize]).collect()
}

fn extent(bounds: Bounds) -> f64 {
    let size = bounds.max.as_dvec3() - bounds.min.as_dvec3();
    size.x + size.y + size.z
}

/// Whether consecutive faces are close to each other, estimated from samples.
fn is_coherent(mesh: &Mesh, order: &[u32]) -> bool {
    let chunks = order.len().div_ceil(FACES_PER_LEAF);
    let (mut faces_extent, mut leaves_extent, mut faces, mut leaves) = (0.0, 0.0, 0usize, 0usize);
    for chunk in order.chunks(FACES_PER_LEAF).step_by(chunks.div_ceil(SAMPLED_LEAVES).max(1)) {
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
    leaves_extent * faces as f64 <= MAX_LEAF_EXTENT_FACES * faces_extent * leaves as f64
}
