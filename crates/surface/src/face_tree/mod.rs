//! A bounding box hierarchy over the faces of a mesh, for rays and closest points.

mod builder;
mod queries;
mod triangle;
mod walk;

pub use builder::FaceTreeBuilder;
pub(crate) use triangle::{along_segment, closest_in_triangle};
pub use walk::FaceWalk;

use crate::measure::Bounds;
use glam::Vec3;
use halfedge::geometry::BitSet;
use halfedge::{FaceId, HalfedgeId, InParts, Mesh, NONE};
use std::sync::Arc;

/// Faces in a box at the bottom of the tree.
const FACES_PER_LEAF: usize = 16;
/// Boxes in a box of the level above.
const CHILDREN_PER_NODE: usize = 8;

/// A ray in mesh coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The start.
    pub origin: Vec3,
    /// The direction, of any length except zero.
    pub direction: Vec3,
}

/// A point on a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The face.
    pub face: FaceId,
    /// The distance from the query's start, in mesh units.
    pub distance: f64,
    /// The position.
    pub point: Vec3,
    /// The corners of the face's triangle with the point, as the half-edges that leave them.
    pub corners: [HalfedgeId; 3],
    /// The barycentric coordinates for those corners; their sum is 1.
    pub barycentric: [f32; 3],
}

/// A hierarchy of bounding boxes over the faces of a mesh, which follows edits.
///
/// The faces have a fixed order that keeps neighbours together; 16 share a box, and 8 boxes share one on the
/// level above. The tree refers to the mesh by ids: pass the same mesh each time, and all changes between to
/// [`FaceTree::update`].
#[derive(Clone, Debug, Default)]
pub struct FaceTree {
    /// Face ids in the tree's order.
    order: Vec<u32>,
    /// Per face id its index in `order`, or [`NONE`].
    place: Vec<u32>,
    /// The boxes of each level, starting with the leaves.
    levels: Vec<Vec<Bounds>>,
    /// The number of faces when the order was made.
    sorted: usize,
    /// Faces that queries leave out.
    hidden: Arc<BitSet>,
}

fn face_bounds(mesh: &Mesh, face: FaceId) -> Bounds {
    let links = mesh.connectivity();
    let positions = mesh.positions();
    let first = links.face_halfedge[face.index()];
    let mut bounds = Bounds::EMPTY;
    let mut h = first;
    loop {
        bounds = bounds.with(positions[links.to[h as usize] as usize]);
        h = links.next[h as usize];
        if h == first {
            return bounds;
        }
    }
}

impl FaceTree {
    /// The tree of all faces. Costs O(mesh).
    pub fn new(mesh: &Mesh) -> Self {
        FaceTreeBuilder::new(mesh).finish(mesh)
    }

    /// Makes queries leave out these faces and no others. Costs O(1): boxes keep their size.
    pub fn set_hidden(&mut self, faces: &Arc<BitSet>) {
        self.hidden.clone_from(faces);
    }

    /// The faces that queries leave out.
    pub fn hidden(&self) -> &Arc<BitSet> {
        &self.hidden
    }

    /// Heap bytes in use.
    pub fn bytes(&self) -> usize {
        (self.order.len() + self.place.len()) * 4
            + self.levels.iter().map(|level| level.len() * size_of::<Bounds>()).sum::<usize>()
    }

    /// Updates the tree for faces that were added, removed, or have a corner that moved. Costs O(log mesh) for
    /// each. After so many new faces that the order is of no use any more, the tree is rebuilt.
    pub fn update(&mut self, mesh: &Mesh, faces: impl IntoIterator<Item = FaceId>) {
        let mut dirty = Vec::new();
        for face in faces {
            if self.place.len() <= face.index() {
                if !mesh.has_face(face) {
                    continue;
                }
                self.place.resize(mesh.face_capacity(), NONE);
            }
            let mut at = self.place[face.index()];
            if at == NONE {
                if !mesh.has_face(face) {
                    continue;
                }
                at = self.order.len() as u32;
                self.order.push(face.raw());
                self.place[face.index()] = at;
            }
            dirty.push(at as usize / FACES_PER_LEAF);
        }
        if self.order.len() > self.sorted + self.sorted / 2 + 1024 {
            *self = Self { hidden: std::mem::take(&mut self.hidden), ..Self::new(mesh) };
            return;
        }
        self.fit_levels();
        for level in 0..self.levels.len() {
            dirty.sort_unstable();
            dirty.dedup();
            for node in &mut dirty {
                self.refresh(mesh, level, *node);
                *node /= CHILDREN_PER_NODE;
            }
        }
    }

    /// Fits the length of each level to the one below, up to a level of at most eight boxes.
    fn fit_levels(&mut self) {
        let mut len = self.order.len().div_ceil(FACES_PER_LEAF);
        let mut level = 0;
        loop {
            match self.levels.get_mut(level) {
                Some(boxes) => boxes.resize(len, Bounds::EMPTY),
                None => {
                    self.levels.push(vec![Bounds::EMPTY; len]);
                    // All boxes of a new level are computed, not only the dirty ones.
                    if let [.., below, top] = self.levels.as_mut_slice() {
                        for (node, children) in top.iter_mut().zip(below.chunks(CHILDREN_PER_NODE)) {
                            *node = children.iter().copied().fold(Bounds::EMPTY, Bounds::union);
                        }
                    }
                }
            }
            if len <= CHILDREN_PER_NODE {
                self.levels.truncate(level + 1);
                return;
            }
            len = len.div_ceil(CHILDREN_PER_NODE);
            level += 1;
        }
    }

    fn children(&self, level: usize, node: usize) -> std::ops::Range<usize> {
        let (width, len) = match level {
            0 => (FACES_PER_LEAF, self.order.len()),
            _ => (CHILDREN_PER_NODE, self.levels[level - 1].len()),
        };
        node * width..len.min((node + 1) * width)
    }

    fn refresh(&mut self, mesh: &Mesh, level: usize, node: usize) {
        let children = self.children(level, node);
        self.levels[level][node] = if level == 0 {
            self.faces(mesh, children).map(|f| face_bounds(mesh, f)).fold(Bounds::EMPTY, Bounds::union)
        } else {
            self.levels[level - 1][children].iter().copied().fold(Bounds::EMPTY, Bounds::union)
        };
    }

    fn faces<'a>(
        &'a self,
        mesh: &'a Mesh,
        places: std::ops::Range<usize>,
    ) -> impl Iterator<Item = FaceId> + 'a {
        self.order[places].iter().filter_map(|&raw| mesh.face(raw))
    }

    /// Visits the faces in boxes nearer than the bound, near boxes first. `near` gives a box's distance; `face`
    /// processes a face and returns the new bound.
    fn visit(
        &self,
        mesh: &Mesh,
        near: impl Fn(&Bounds) -> f64,
        mut bound: f64,
        mut face: impl FnMut(FaceId, f64) -> f64,
    ) {
        let Some(top) = self.levels.len().checked_sub(1) else { return };
        let mut stack: Vec<(f64, usize, usize)> = Vec::with_capacity(8 * self.levels.len());
        let push = |stack: &mut Vec<(f64, usize, usize)>,
                    level: usize,
                    nodes: std::ops::Range<usize>,
                    bound: f64| {
            let start = stack.len();
            for node in nodes {
                let distance = near(&self.levels[level][node]);
                if distance <= bound {
                    stack.push((distance, level, node));
                }
            }
            stack[start..].sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        };
        push(&mut stack, top, 0..self.levels[top].len(), bound);
        while let Some((distance, level, node)) = stack.pop() {
            if distance > bound {
                continue;
            }
            let children = self.children(level, node);
            if level == 0 {
                for f in self.faces(mesh, children).filter(|f| !self.hidden.contains(f.index())) {
                    bound = face(f, bound);
                }
            } else {
                push(&mut stack, level - 1, children, bound);
            }
        }
    }
}
