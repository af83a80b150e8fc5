//! Which triangles of an object's buffers belong to which face.
//!
//! Each face owns a contiguous range of triangles. A face that needs a different number of triangles
//! gets another range: a free one of exactly that size, else one at the end. A local edit therefore
//! moves only the faces it touches, whatever the size of the mesh.

use std::collections::{HashMap, HashSet};

/// The triangles of one face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Range {
    /// The index of the first triangle.
    pub first: u32,
    /// The number of triangles; 0 for an id without a face.
    pub count: u32,
}

/// The ranges of all faces by face id, and the free ranges between them.
#[derive(Clone, Debug, Default)]
pub struct Slots {
    faces: Vec<Range>,
    end: u32,
    live: u32,
    free: HashMap<u32, Vec<u32>>,
    /// Ranges released since the last [`Slots::take_abandoned`].
    released: HashSet<Range>,
}

impl Slots {
    /// Starts over, with room for this many face ids.
    pub fn clear(&mut self, faces: usize) {
        *self = Self { faces: Vec::with_capacity(faces), ..Self::default() };
    }

    /// One more than the index of the last triangle in use.
    pub fn end(&self) -> u32 {
        self.end
    }

    /// The number of triangles that belong to faces.
    pub fn live(&self) -> u32 {
        self.live
    }

    /// The triangles of a face.
    pub fn of(&self, face: usize) -> Range {
        self.faces.get(face).copied().unwrap_or_default()
    }

    /// Approximate heap bytes in use.
    pub fn bytes(&self) -> usize {
        self.faces.capacity() * size_of::<Range>()
            + self.free.values().map(|f| f.capacity() * 4).sum::<usize>()
    }

    /// Frees the range of a face that needs another number of triangles now.
    pub fn release(&mut self, face: usize, wanted: u32) {
        let Some(range) = self.faces.get_mut(face) else { return };
        if range.count == wanted || range.count == 0 {
            return;
        }
        let old = std::mem::take(range);
        self.live -= old.count;
        self.free.entry(old.count).or_default().push(old.first);
        self.released.insert(old);
    }

    /// Returns the face's range of `wanted` triangles, allocating it if needed. A range of another size
    /// must have been released before.
    #[expect(clippy::indexing_slicing, reason = "the column is made long enough first")]
    pub fn acquire(&mut self, face: usize, wanted: u32) -> Range {
        if self.faces.len() <= face {
            self.faces.resize(face + 1, Range::default());
        }
        if self.faces[face].count == wanted {
            return self.faces[face];
        }
        let reused = self.free.get_mut(&wanted).and_then(Vec::pop);
        let first = reused.unwrap_or(self.end);
        if reused.is_none() {
            self.end += wanted;
        }
        let range = Range { first, count: wanted };
        self.released.remove(&range);
        self.live += wanted;
        self.faces[face] = range;
        range
    }

    /// The ranges that were released and not allocated again since the last call: their triangles have to
    /// be blanked.
    pub fn take_abandoned(&mut self) -> Vec<Range> {
        let mut ranges: Vec<Range> = self.released.drain().collect();
        ranges.sort_unstable();
        ranges
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_that_grows_moves_to_the_end_and_its_old_place_is_reused() {
        let mut slots = Slots::default();
        for face in 0..3 {
            slots.acquire(face, 1);
        }
        slots.release(1, 2);
        assert_eq!(slots.acquire(1, 2), Range { first: 3, count: 2 });
        assert_eq!(slots.take_abandoned(), [Range { first: 1, count: 1 }]);
        assert_eq!(slots.acquire(3, 1), Range { first: 1, count: 1 });
        assert_eq!((slots.end(), slots.live()), (5, 5));
        assert!(slots.take_abandoned().is_empty());
    }

    #[test]
    fn a_range_freed_and_taken_at_once_is_not_blanked() {
        let mut slots = Slots::default();
        slots.acquire(0, 2);
        slots.release(0, 0);
        assert_eq!(slots.acquire(1, 2), Range { first: 0, count: 2 });
        assert!(slots.take_abandoned().is_empty());
        assert_eq!(slots.of(0), Range::default());
        assert_eq!(slots.of(9), Range::default());
    }
}
