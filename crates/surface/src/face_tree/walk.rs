//! Walking over the faces in some of the tree's boxes, some at a time.

use super::{FACES_PER_LEAF, FaceTree};
use crate::measure::Bounds;
use halfedge::{Budget, FaceId, Mesh};

/// A walk over the faces of a tree, without hidden ones, in the boxes that a test accepts. It finds every face whose box and all the boxes
/// around it are accepted, and others that share a box with one.
#[derive(Clone, Debug)]
pub struct FaceWalk {
    /// The boxes that are still to be tested: levels and numbers.
    stack: Vec<(usize, usize)>,
}

impl FaceTree {
    /// Begins a walk over the faces.
    pub fn walk(&self) -> FaceWalk {
        let top = self.levels.len().saturating_sub(1);
        let count = self.levels.last().map_or(0, Vec::len);
        FaceWalk { stack: (0..count).rev().map(|node| (top, node)).collect() }
    }
}

impl FaceWalk {
    /// Continues until the budget, which counts faces found, is spent; returns whether boxes are left. `accepts` tests a
    /// box, `face` gets each face found. The mesh and the tree must not change during the walk. Costs O(boxes whose
    /// parent is accepted).
    pub fn step(
        &mut self,
        tree: &FaceTree,
        mesh: &Mesh,
        budget: &mut Budget,
        mut accepts: impl FnMut(&Bounds) -> bool,
        mut face: impl FnMut(FaceId),
    ) -> bool {
        while !budget.is_spent() {
            let Some((level, node)) = self.stack.pop() else { return false };
            if !accepts(&tree.levels[level][node]) {
                continue;
            }
            let children = tree.children(level, node);
            if level == 0 {
                budget.take(FACES_PER_LEAF);
                tree.faces(mesh, children).filter(|f| !tree.hidden.contains(f.index())).for_each(&mut face);
            } else {
                self.stack.extend(children.rev().map(|child| (level - 1, child)));
            }
        }
        !self.stack.is_empty()
    }
}
