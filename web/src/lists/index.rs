//! The mapping between rows and the ids of elements.

use halfedge::{Element, Mesh, Touched};

/// The rows for one kind of element of a mesh: one row for every existing id, in order.
///
/// Removed ids are kept in a sorted list. Both directions are a binary search over those few ids, and an
/// update costs what the edit touched, whatever the size of the mesh.
#[derive(Clone, Debug, Default)]
pub struct RowIndex {
    removed: Vec<u32>,
    capacity: usize,
}

impl RowIndex {
    /// Indexes a mesh from scratch. Costs O(1) if no ids were removed, else O(ids).
    pub fn new(mesh: &Mesh, kind: Element) -> Self {
        let capacity = mesh.capacity(kind);
        let mut removed = Vec::new();
        if mesh.count(kind) != capacity {
            removed.extend((0..capacity as u32).filter(|&id| !mesh.exists(kind, id)));
        }
        Self { removed, capacity }
    }

    /// Updates the index to an edit that added, removed or restored ids. Costs O(touched · log removed),
    /// plus moving the removed ids that follow.
    pub fn follow(&mut self, mesh: &Mesh, kind: Element, touched: &Touched) {
        match kind {
            Element::Vertex => self.update(mesh, kind, touched.vertices.iter().map(|v| v.raw())),
            Element::Edge => self.update(mesh, kind, touched.edges.iter().map(|e| e.raw())),
            // An edge's mark applies to both its half-edges.
            Element::Halfedge => {
                let sides = touched.edges.iter().flat_map(|e| e.halfedges());
                self.update(mesh, kind, sides.map(|h| h.raw()));
            }
            Element::Face => self.update(mesh, kind, touched.faces.iter().map(|f| f.raw())),
        }
    }

    fn update(&mut self, mesh: &Mesh, kind: Element, touched: impl Iterator<Item = u32>) {
        let capacity = mesh.capacity(kind);
        self.removed.truncate(self.removed.partition_point(|&id| (id as usize) < capacity));
        let grown = self.capacity as u32..capacity as u32;
        self.capacity = capacity;
        for id in touched.chain(grown).filter(|&id| (id as usize) < capacity) {
            match (self.removed.binary_search(&id), mesh.exists(kind, id)) {
                (Ok(at), true) => {
                    self.removed.remove(at);
                }
                (Err(at), false) => self.removed.insert(at, id),
                _ => {}
            }
        }
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.capacity - self.removed.len()
    }

    /// Whether there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The id shown in a row.
    pub fn id_of(&self, row: usize) -> Option<u32> {
        if row >= self.len() {
            return None;
        }
        // The k-th removed id has `removed[k] - k` existing ids before it.
        let before = self.partition(|id, k| id as usize - k <= row);
        u32::try_from(row + before).ok()
    }

    /// The row that shows an id.
    pub fn row_of(&self, id: u32) -> Option<usize> {
        if id as usize >= self.capacity {
            return None;
        }
        match self.removed.binary_search(&id) {
            Ok(_) => None,
            Err(before) => Some(id as usize - before),
        }
    }

    /// The number of removed ids at the start of the list that satisfy a condition, which must be true only
    /// for a prefix.
    fn partition(&self, holds: impl Fn(u32, usize) -> bool) -> usize {
        let (mut low, mut high) = (0, self.removed.len());
        while low < high {
            let middle = low + (high - low) / 2;
            if self.removed.get(middle).is_some_and(|&id| holds(id, middle)) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_removed(capacity: usize, removed: &[u32]) -> RowIndex {
        RowIndex { removed: removed.to_vec(), capacity }
    }

    #[test]
    fn rows_skip_removed_ids() {
        let index = with_removed(8, &[0, 3, 4, 7]);
        let ids: Vec<_> = (0..5).map(|row| index.id_of(row)).collect();
        assert_eq!(ids, [Some(1), Some(2), Some(5), Some(6), None]);
        assert_eq!(index.row_of(5), Some(2));
        assert_eq!(index.row_of(3), None);
        assert_eq!(index.row_of(8), None);
    }

    #[test]
    fn an_edit_updates_what_it_touched() {
        let grid = surface::Shape::named("grid").expect("a shape");
        let mut mesh = grid.build().expect("a mesh");
        let mut rows = Element::ALL.map(|kind| RowIndex::new(&mesh, kind));
        let mut journals = Vec::new();
        for face in [5, 17, 2, 40] {
            let face = mesh.face(face).expect("a face");
            let edit = |mesh: &mut Mesh| halfedge::edit::delete_faces(mesh, &[face]);
            let (_, journal) = mesh.transaction(edit).expect("faces can be deleted");
            check(&mesh, &mut rows, &journal.touched());
            journals.push(journal);
        }
        while let Some(journal) = journals.pop() {
            let redo = mesh.undo(journal);
            check(&mesh, &mut rows, &redo.touched());
        }
        assert!(rows.iter().all(|index| index.removed.is_empty()));
    }

    fn check(mesh: &Mesh, rows: &mut [RowIndex; 4], touched: &halfedge::Touched) {
        for (kind, index) in Element::ALL.into_iter().zip(rows) {
            index.follow(mesh, kind, touched);
            let fresh = RowIndex::new(mesh, kind);
            assert_eq!((&index.removed, index.capacity), (&fresh.removed, fresh.capacity), "{kind}");
        }
    }

    #[test]
    fn row_of_and_id_of_are_inverse() {
        // Every subset of eleven ids is removed once.
        for marks in 0_u32..1 << 11 {
            let (removed, kept): (Vec<u32>, Vec<u32>) = (0..11).partition(|id| marks >> id & 1 == 1);
            let index = with_removed(11, &removed);
            assert_eq!(index.len(), kept.len());
            for (row, &id) in kept.iter().enumerate() {
                assert_eq!((index.id_of(row), index.row_of(id)), (Some(id), Some(row)), "{marks:b}");
            }
            assert!(removed.iter().all(|&id| index.row_of(id).is_none()), "{marks:b}");
        }
    }
}
