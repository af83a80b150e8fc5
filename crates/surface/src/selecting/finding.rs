//! Finding sets of elements, at once or some elements at a time.

use super::criterion::Criterion;
use super::related::{Part, is_hidden, is_within, parts, touching, vertices};
use super::smaller::SmallerComponents;
use halfedge::geometry::{BitSet, PolygonTriangulator};
use halfedge::{Budget, Element, InParts, Mesh, VertexId};
use std::sync::Arc;

/// Finds elements by a criterion, or those that follow from a set. The mesh must not change meanwhile.
///
/// It is a list of steps, each of which makes a set from the one before.
#[derive(Clone, Debug)]
pub struct Finding {
    kind: Element,
    /// The set that it began with.
    origin: BitSet,
    /// The steps that are left, the next one last.
    steps: Vec<Step>,
    /// The set that the next step reads, and the number from which on it is still to be read.
    current: BitSet,
    at: usize,
    /// What the next step has found so far.
    found: BitSet,
    /// Vertices whose neighbours are still to be reached.
    front: Vec<VertexId>,
    smaller: SmallerComponents,
    triangulator: PolygonTriangulator,
}

#[derive(Clone, Debug)]
enum Step {
    /// From elements of a kind to their vertices.
    Vertices(Element),
    /// From vertices to the elements of a kind that have one of them.
    Touching(Element),
    /// From vertices to those that share a face or an edge with one of them, and themselves.
    Around,
    /// From vertices to all that edges lead to.
    Spread,
    /// From nothing to the vertices of all components but the largest.
    Smaller,
    /// From elements to a part of them, or to what they are a part of.
    Part(Part),
    /// Keeps the elements of a kind that have all their vertices in the first set; of faces from edges or half-edges, all
    /// of those.
    Within(Element, Element),
    /// Removes the first set.
    WithoutOrigin,
    /// Removes the set from the first one.
    FromOrigin,
    /// From nothing to all elements with a property.
    Every(Criterion),
    /// Keeps the elements that aren't hidden with these faces.
    Shown(Element, Arc<BitSet>),
}

impl Step {
    /// What reading an element costs, in elements: how long it takes beside the cheapest.
    fn weight(&self) -> usize {
        match self {
            Self::Spread | Self::Smaller => 4,
            Self::Around => 3,
            Self::Every(Criterion::NonPlanar { .. }) => 8,
            Self::Every(Criterion::Sharp { .. }) => 4,
            Self::Every(
                Criterion::Any | Criterion::Boundary | Criterion::Isolated | Criterion::Colored { .. },
            ) => 1,
            Self::Every(_) => 2,
            _ => 1,
        }
    }
}

impl Finding {
    fn new(kind: Element, origin: BitSet, steps: Vec<Step>) -> Self {
        let current = origin.clone();
        let steps = steps.into_iter().rev().collect();
        Self {
            kind,
            origin,
            steps,
            current,
            at: 0,
            found: BitSet::new(),
            front: Vec::new(),
            smaller: SmallerComponents::default(),
            triangulator: PolygonTriangulator::new(),
        }
    }

    /// The elements of a kind with a property.
    pub fn by(kind: Element, criterion: Criterion) -> Self {
        Self::new(kind, BitSet::new(), vec![Step::Every(criterion)])
    }

    /// The elements of a kind outside a set.
    pub fn outside(kind: Element, ids: BitSet) -> Self {
        Self::new(kind, ids, vec![Step::Every(Criterion::Any), Step::WithoutOrigin])
    }

    /// A set that is known.
    pub fn known(kind: Element, ids: BitSet) -> Self {
        Self::new(kind, ids, Vec::new())
    }

    /// [`super::grow`].
    pub fn grow(kind: Element, ids: BitSet) -> Self {
        Self::new(kind, ids, grown(kind))
    }

    /// [`super::shrink`].
    pub fn shrink(kind: Element, ids: BitSet) -> Self {
        let mut steps = grown(kind);
        steps.push(Step::WithoutOrigin);
        steps.extend(grown(kind));
        steps.push(Step::FromOrigin);
        Self::new(kind, ids, steps)
    }

    /// [`super::linked`].
    pub fn linked(kind: Element, ids: BitSet) -> Self {
        let mut steps = vec![Step::Vertices(kind), Step::Spread];
        steps.extend((kind != Element::Vertex).then_some(Step::Touching(kind)));
        Self::new(kind, ids, steps)
    }

    /// The elements of a kind that belong to any connected component but the one with the most faces.
    pub fn smaller_components(kind: Element) -> Self {
        let mut steps = vec![Step::Smaller];
        steps.extend((kind != Element::Vertex).then_some(Step::Touching(kind)));
        Self::new(kind, BitSet::new(), steps)
    }

    /// [`super::convert`].
    pub fn convert(from: Element, to: Element, ids: BitSet) -> Self {
        use Element as E;
        let mut steps = expanded(from, to);
        // Of parts, all must be in the set.
        if matches!(
            (from, to),
            (E::Vertex, E::Edge | E::Halfedge | E::Face) | (E::Edge | E::Halfedge, E::Face)
        ) {
            steps.push(Step::Within(from, to));
        }
        Self::new(to, ids, steps)
    }

    /// [`super::expand`].
    pub fn expand(from: Element, to: Element, ids: BitSet) -> Self {
        Self::new(to, ids, expanded(from, to))
    }

    /// [`super::outline`].
    pub fn outline(faces: BitSet) -> Self {
        Self::new(Element::Edge, faces, vec![Step::Part(Part::Outline)])
    }

    /// Leaves out elements that are hidden: these faces, and edges and vertices all of whose faces are among them.
    #[must_use]
    pub fn shown(mut self, hidden: &Arc<BitSet>) -> Self {
        if !hidden.is_empty() {
            self.steps.insert(0, Step::Shown(self.kind, hidden.clone()));
        }
        self
    }

    /// The kind of elements that it finds.
    pub fn kind(&self) -> Element {
        self.kind
    }

    /// About how many elements it looks at, as far as that is known beforehand.
    pub fn cost(&self, mesh: &Mesh) -> usize {
        let all = self.steps.iter().any(|step| matches!(step, Step::Every(_) | Step::Spread | Step::Smaller));
        if all { mesh.capacity(self.kind) } else { self.origin.len() * self.steps.len() }
    }
}

/// The steps to the neighbours of a set and itself.
fn grown(kind: Element) -> Vec<Step> {
    match kind {
        Element::Vertex => vec![Step::Around],
        _ => vec![Step::Vertices(kind), Step::Touching(kind)],
    }
}

/// The steps from one kind to everything of another that has an element or belongs to it.
fn expanded(from: Element, to: Element) -> Vec<Step> {
    match (from, to) {
        (Element::Vertex, Element::Vertex)
        | (Element::Edge, Element::Edge)
        | (Element::Halfedge, Element::Halfedge)
        | (Element::Face, Element::Face) => Vec::new(),
        (_, Element::Vertex) => vec![Step::Vertices(from)],
        (Element::Vertex, _) => vec![Step::Touching(to)],
        (Element::Halfedge, Element::Edge) => vec![Step::Part(Part::EdgeOf)],
        (Element::Edge, Element::Halfedge) => vec![Step::Part(Part::Sides)],
        (Element::Face, Element::Edge) => vec![Step::Part(Part::Edges)],
        (Element::Face, Element::Halfedge) => vec![Step::Part(Part::Halfedges)],
        (Element::Edge, Element::Face) => vec![Step::Part(Part::FacesOfEdge)],
        (Element::Halfedge, Element::Face) => vec![Step::Part(Part::FaceOf)],
    }
}

/// The result is the set found. The budget counts the elements that steps read, those of slow steps several times.
impl InParts for Finding {
    type Input<'a> = &'a Mesh;
    type Output = BitSet;

    fn step(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<BitSet> {
        while let Some(step) = self.steps.last() {
            if budget.is_spent() {
                return None;
            }
            let weight = step.weight();
            let part = budget.left().div_ceil(weight);
            let mut left = Budget::new(part);
            let is_done = match step {
                Step::Every(criterion) => every(
                    mesh,
                    self.kind,
                    criterion,
                    &mut self.triangulator,
                    &mut self.at,
                    &mut self.found,
                    &mut left,
                ),
                Step::Spread => {
                    spread(mesh, &self.current, &mut self.at, &mut self.front, &mut self.found, &mut left)
                }
                Step::Smaller => self.smaller.advance(mesh, &mut self.found, &mut left),
                Step::WithoutOrigin => {
                    self.found = std::mem::take(&mut self.current);
                    self.found.subtract(&self.origin);
                    true
                }
                Step::FromOrigin => {
                    self.found = self.origin.clone();
                    self.found.subtract(&self.current);
                    true
                }
                step => {
                    each(mesh, step, &self.origin, &self.current, &mut self.at, &mut self.found, &mut left)
                }
            };
            budget.take((part - left.left()).saturating_mul(weight));
            if !is_done {
                return None;
            }
            self.steps.pop();
            self.current = std::mem::take(&mut self.found);
            self.at = 0;
        }
        Some(std::mem::take(&mut self.current))
    }
}

/// Reads more of a set; returns whether that was the last of it.
fn each(
    mesh: &Mesh,
    step: &Step,
    origin: &BitSet,
    current: &BitSet,
    at: &mut usize,
    found: &mut BitSet,
    budget: &mut Budget,
) -> bool {
    let start = *at;
    for id in current.iter_from(start) {
        if budget.take(1) == 0 {
            *at = id;
            return false;
        }
        follow(mesh, step, origin, id, found);
    }
    true
}

/// Adds what an element leads to.
fn follow(mesh: &Mesh, step: &Step, origin: &BitSet, id: usize, found: &mut BitSet) {
    let mut add = |id: usize| {
        found.insert(id);
    };
    match step {
        Step::Vertices(kind) => vertices(mesh, *kind, id, |v| add(v.index())),
        Step::Touching(kind) => touching(mesh, *kind, VertexId::new(id), add),
        Step::Around => {
            let v = VertexId::new(id);
            add(id);
            mesh.neighbors(v).for_each(|w| add(w.index()));
            mesh.vertex_faces(v).flat_map(|f| mesh.face_vertices(f)).for_each(|w| add(w.index()));
        }
        Step::Part(part) => parts(mesh, *part, origin, id, add),
        Step::Within(of, kind) => {
            if is_within(mesh, *of, *kind, id, origin) {
                add(id);
            }
        }
        Step::Shown(kind, hidden) => {
            if !is_hidden(mesh, *kind, id, hidden) {
                add(id);
            }
        }
        Step::Spread | Step::Smaller | Step::WithoutOrigin | Step::FromOrigin | Step::Every(_) => {}
    }
}

/// Tests more elements of a mesh; returns whether those were the last.
fn every(
    mesh: &Mesh,
    kind: Element,
    criterion: &Criterion,
    triangulator: &mut PolygonTriangulator,
    at: &mut usize,
    found: &mut BitSet,
    budget: &mut Budget,
) -> bool {
    let capacity = mesh.capacity(kind);
    let end = *at + budget.take(capacity - *at);
    for id in *at..end {
        if mesh.exists(kind, id as u32) && criterion.holds(mesh, kind, id, triangulator) {
            found.insert(id);
        }
    }
    *at = end;
    end == capacity
}

/// Reaches more vertices along edges; returns whether those were the last.
fn spread(
    mesh: &Mesh,
    current: &BitSet,
    at: &mut usize,
    front: &mut Vec<VertexId>,
    found: &mut BitSet,
    budget: &mut Budget,
) -> bool {
    loop {
        while let Some(v) = front.pop() {
            if budget.take(1) == 0 {
                front.push(v);
                return false;
            }
            for w in mesh.neighbors(v) {
                if found.insert(w.index()) {
                    front.push(w);
                }
            }
        }
        // A vertex of another piece, or one that was reached already.
        let Some(next) = current.iter_from(*at).next() else { return true };
        *at = next + 1;
        if budget.take(1) == 0 {
            *at = next;
            return false;
        }
        if found.insert(next) {
            front.push(VertexId::new(next));
        }
    }
}
