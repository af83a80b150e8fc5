//! The mapping between rows and the ids of elements.

use super::ranked_set::RankedSet;
use halfedge::geometry::BitSet;
use halfedge::{Budget, EdgeId, Element, FaceId, HalfedgeId, InParts, Mesh, Touched, VertexId};
use surface::selecting::{is_hidden, vertices};

/// The rows for one kind of element of a mesh: one row for every id that exists and isn't hidden, in order.
///
/// After an edit, an update costs what the edit touched; after anything else the rows are found anew, in parts. Until they
/// are, they stay as they were.
#[derive(Clone, Debug, Default)]
pub struct RowIndex {
    rows: Rows,
    finding: Option<Finding>,
}

#[derive(Clone, Debug)]
enum Rows {
    /// All ids below this one.
    All(usize),
    /// Some of the ids below this one.
    Some(RankedSet, usize),
}

impl Default for Rows {
    fn default() -> Self {
        Self::All(0)
    }
}

/// Rows that are being found.
#[derive(Clone, Debug, Default)]
struct Finding {
    found: BitSet,
    next: usize,
}

/// A mesh, the kind of its elements that have rows, and the faces that are hidden.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The kind of element.
    pub kind: Element,
    /// The hidden faces.
    pub hidden: &'a BitSet,
}

impl Source<'_> {
    /// Whether an element exists and isn't hidden.
    fn shows(&self, id: usize) -> bool {
        self.mesh.exists(self.kind, id as u32) && !is_hidden(self.mesh, self.kind, id, self.hidden)
    }

    fn capacity(&self) -> usize {
        self.mesh.capacity(self.kind)
    }

    /// So many ids are looked at in the time that another element takes.
    fn ids_per_element(&self) -> usize {
        if self.kind == Element::Vertex { 2 } else { 8 }
    }

    /// Visits the elements that an edit may have added, removed, shown or hidden.
    fn visit_touched(&self, touched: &Touched, mut visit: impl FnMut(usize)) {
        let (mesh, hides) = (self.mesh, !self.hidden.is_empty());
        // Whether an element is hidden depends on its faces.
        let relinked = || touched.halfedges.iter().copied().filter(|h| hides && mesh.has_halfedge(*h));
        match self.kind {
            Element::Vertex => {
                touched.vertices.iter().copied().map(VertexId::index).for_each(&mut visit);
                relinked().flat_map(|h| [mesh.from(h), mesh.to(h)]).for_each(|v| visit(v.index()));
                let faces = touched.faces.iter().filter(|f| hides && mesh.has_face(**f));
                faces.for_each(|f| vertices(mesh, Element::Face, f.index(), |v| visit(v.index())));
            }
            Element::Edge => {
                touched.edges.iter().copied().map(EdgeId::index).for_each(&mut visit);
                relinked().for_each(|h| visit(h.edge().index()));
            }
            // An edge's mark applies to both its half-edges.
            Element::Halfedge => {
                let sides = touched.edges.iter().flat_map(|e| e.halfedges());
                let sides = sides.chain(relinked().flat_map(|h| [h, h.twin()]));
                sides.map(HalfedgeId::index).for_each(visit);
            }
            Element::Face => touched.faces.iter().copied().map(FaceId::index).for_each(visit),
        }
    }
}

/// The budget counts elements of which each stands for several ids. The result is the set of ids with a row.
impl InParts for Finding {
    type Input<'a> = Source<'a>;
    type Output = BitSet;

    fn step(&mut self, source: Source<'_>, budget: &mut Budget) -> Option<BitSet> {
        let left = source.capacity().saturating_sub(self.next);
        let end = self.next + budget.take_light(left, source.ids_per_element());
        for id in self.next..end {
            if source.shows(id) {
                self.found.insert(id);
            }
        }
        self.next = end;
        (end >= source.capacity()).then(|| std::mem::take(&mut self.found))
    }
}

impl RowIndex {
    /// Begins to find the rows; [`RowIndex::step`] goes on. If all elements have rows, that is known at once.
    pub fn restart(&mut self, source: Source<'_>) {
        self.finding = None;
        if source.hidden.is_empty() && source.mesh.count(source.kind) == source.capacity() {
            self.rows = Rows::All(source.capacity());
        } else {
            self.finding = Some(Finding::default());
        }
    }

    /// Finds more of the rows, as many as the budget allows; returns whether there are any left.
    pub fn step(&mut self, source: Source<'_>, budget: &mut Budget) -> bool {
        let Some(finding) = &mut self.finding else { return false };
        if budget.is_spent() {
            return true;
        }
        if let Some(found) = finding.step(source, budget) {
            self.rows = Rows::Some(RankedSet::new(found), source.capacity());
            self.finding = None;
        }
        self.finding.is_some()
    }

    /// Updates the rows to an edit that added, removed or restored ids.
    pub fn follow(&mut self, source: Source<'_>, touched: &Touched) {
        let capacity = source.capacity();
        let put = |set: &mut BitSet, id: usize| {
            if id < capacity && source.shows(id) { set.insert(id) } else { set.remove(id) }
        };
        if let Some(Finding { found, next }) = &mut self.finding {
            *next = (*next).min(capacity);
            let end = *next;
            source.visit_touched(touched, |id| {
                if id < end {
                    put(found, id);
                }
            });
            let beyond: Vec<usize> = found.iter_from(end).collect();
            for id in beyond {
                found.remove(id);
            }
        }
        if let Rows::All(rows) = self.rows {
            let mut all = source.hidden.is_empty();
            source.visit_touched(touched, |id| all &= id >= capacity || source.shows(id));
            if all && (rows..capacity).all(|id| source.shows(id)) {
                self.rows = Rows::All(capacity);
                return;
            }
            self.rows = Rows::Some(RankedSet::new(BitSet::up_to(rows)), rows);
        }
        if let Rows::Some(set, known) = &mut self.rows {
            set.change(|set| {
                let mut changed = false;
                source.visit_touched(touched, |id| changed |= put(set, id));
                // Added at the end of the mesh, or dropped with it.
                let (low, high) = (capacity.min(*known), capacity.max(*known));
                (low..high).for_each(|id| changed |= put(set, id));
                changed
            });
            *known = capacity;
            if set.len() == capacity {
                self.rows = Rows::All(capacity);
            }
        }
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        match &self.rows {
            Rows::All(rows) => *rows,
            Rows::Some(set, _) => set.len(),
        }
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The id shown in a row.
    pub fn id_of(&self, row: usize) -> Option<u32> {
        let id = match &self.rows {
            Rows::All(rows) => (row < *rows).then_some(row),
            Rows::Some(set, _) => set.nth(row),
        };
        id.and_then(|id| u32::try_from(id).ok())
    }

    /// The row that shows an id.
    pub fn row_of(&self, id: u32) -> Option<usize> {
        let id = id as usize;
        match &self.rows {
            Rows::All(rows) => (id < *rows).then_some(id),
            Rows::Some(set, _) => set.contains(id).then(|| set.rank(id)),
        }
    }

    /// The id of the row after or before that of an id, whether it has one or not; the first or the last row beyond the
    /// end, and for no id.
    pub fn beside(&self, id: Option<u32>, forward: bool) -> Option<u32> {
        let rank = |id: usize| match &self.rows {
            Rows::All(rows) => id.min(*rows),
            Rows::Some(set, _) => set.rank(id),
        };
        let row = match (id, forward) {
            (None, true) => Some(0),
            (None, false) => None,
            (Some(id), true) => Some(rank(id as usize + 1)).filter(|row| *row < self.len()).or(Some(0)),
            (Some(id), false) => rank(id as usize).checked_sub(1),
        };
        self.id_of(row.or(self.len().checked_sub(1))?)
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use halfedge::edit::{Connect, split_edge};
    use proptest::prelude::*;

    fn grid() -> Mesh {
        surface::Shape::named("grid").expect("a shape").build().expect("a mesh")
    }

    fn found(source: Source<'_>) -> RowIndex {
        let mut index = RowIndex::default();
        index.restart(source);
        while index.step(source, &mut Budget::new(3)) {}
        index
    }

    /// The rows are those of a list made from scratch, in both directions.
    fn check(index: &RowIndex, source: Source<'_>) {
        let ids: Vec<u32> =
            (0..source.capacity()).filter(|id| source.shows(*id)).map(|id| id as u32).collect();
        assert_eq!(index.len(), ids.len(), "{}", source.kind);
        for (row, &id) in ids.iter().enumerate() {
            assert_eq!((index.id_of(row), index.row_of(id)), (Some(id), Some(row)), "{}", source.kind);
            let next = ids.get(row + 1).or(ids.first()).copied();
            assert_eq!(index.beside(Some(id), true), next);
            assert_eq!(index.beside(next, false), Some(id));
        }
        assert_eq!(index.id_of(ids.len()), None);
        for id in 0..source.capacity() as u32 + 3 {
            assert_eq!(index.row_of(id).is_some(), ids.binary_search(&id).is_ok(), "{} {id}", source.kind);
        }
        assert_eq!(
            (index.beside(None, true), index.beside(None, false)),
            (ids.first().copied(), ids.last().copied())
        );
    }

    #[derive(Clone, Debug)]
    enum Edit {
        Delete(usize),
        Split(usize),
        Undo,
    }

    fn any_edit() -> impl Strategy<Value = Edit> {
        prop_oneof![
            (0usize..100).prop_map(Edit::Delete),
            (0usize..200).prop_map(Edit::Split),
            Just(Edit::Undo)
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn rows_follow_edits_and_leave_out_what_is_hidden(
            hidden in prop::collection::vec(0usize..100, 0..40),
            edits in prop::collection::vec(any_edit(), 1..12),
            parts in 0usize..8,
        ) {
            let mut mesh = grid();
            let hidden: BitSet = hidden.into_iter().collect();
            let indices = Element::ALL.map(|kind| found(Source { mesh: &mesh, kind, hidden: &hidden }));
            // Some are in the middle of being found.
            let unfinished = Element::ALL.map(|kind| {
                let (source, mut index) = (Source { mesh: &mesh, kind, hidden: &hidden }, RowIndex::default());
                index.restart(source);
                for _ in 0..parts {
                    index.step(source, &mut Budget::new(3));
                }
                index
            });
            let mut all = [indices, unfinished];
            let mut journals = Vec::new();
            for edit in edits {
                let journal = match edit {
                    Edit::Undo => journals.pop().map(|journal| mesh.undo(journal)),
                    Edit::Delete(face) => mesh.face(face as u32).and_then(|face| {
                        let done = mesh.transaction(|mesh| halfedge::edit::delete_faces(mesh, &[face]));
                        done.ok().map(|(_, journal)| journal)
                    }),
                    Edit::Split(edge) => mesh.edge(edge as u32).and_then(|edge| {
                        let done = mesh.transaction(|mesh| split_edge(mesh, edge, 0.5, Connect::All));
                        done.ok().map(|(_, journal)| journal)
                    }),
                };
                let Some(journal) = journal else { continue };
                for indices in &mut all {
                    for (kind, index) in Element::ALL.into_iter().zip(indices) {
                        index.follow(Source { mesh: &mesh, kind, hidden: &hidden }, &journal.touched());
                    }
                }
                for (kind, index) in Element::ALL.into_iter().zip(&all[0]) {
                    check(index, Source { mesh: &mesh, kind, hidden: &hidden });
                }
                if !matches!(edit, Edit::Undo) {
                    journals.push(journal);
                }
            }
            for (kind, index) in Element::ALL.into_iter().zip(&mut all[1]) {
                let source = Source { mesh: &mesh, kind, hidden: &hidden };
                while index.step(source, &mut Budget::new(3)) {}
                check(index, source);
            }
        }
    }
}
