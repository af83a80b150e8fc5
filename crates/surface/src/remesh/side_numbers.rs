//! Numbers for a few sides of triangles.

use crate::trimesh::{Renumbering, make_room};
use halfedge::NONE;

/// A number or [`NONE`] per half-edge. Only kept edges have numbers, and they are few: this takes 4 bytes per
/// triangle, and 12 more for triangles with a number.
#[derive(Default)]
pub(super) struct SideNumbers {
    /// Per triangle: its index in `rows`, or [`NONE`].
    row: Vec<u32>,
    rows: Vec<[u32; 3]>,
}

impl SideNumbers {
    /// No numbers for this many triangles.
    pub fn new(triangles: usize) -> Self {
        Self { row: vec![NONE; triangles], rows: Vec::new() }
    }

    #[inline]
    pub fn get(&self, h: u32) -> u32 {
        match self.row[h as usize / 3] {
            NONE => NONE,
            row => self.rows[row as usize][h as usize % 3],
        }
    }

    pub fn set(&mut self, h: u32, number: u32) {
        let row = &mut self.row[h as usize / 3];
        if *row == NONE {
            if number == NONE {
                return;
            }
            *row = self.rows.len() as u32;
            self.rows.push([NONE; 3]);
        }
        self.rows[*row as usize][h as usize % 3] = number;
    }

    /// Adds triangles without numbers, up to this many in all.
    pub fn extend_to(&mut self, triangles: usize) {
        let more = triangles.saturating_sub(self.row.len());
        make_room(&mut self.row, more);
        self.row.resize(triangles, NONE);
    }

    /// Reorders the triangles, and drops rows without numbers.
    pub fn reorder(&mut self, triangles: &Renumbering) {
        triangles.apply(&mut self.row);
        let mut rows = Vec::new();
        for row in self.row.iter_mut().filter(|row| **row != NONE) {
            let numbers = self.rows[*row as usize];
            *row = NONE;
            if numbers != [NONE; 3] {
                *row = rows.len() as u32;
                rows.push(numbers);
            }
        }
        self.rows = rows;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_have_the_numbers_they_were_given_in_any_order() {
        let mut sides = SideNumbers::new(3);
        sides.set(1, NONE);
        sides.set(4, 7);
        sides.set(8, 9);
        sides.extend_to(4);
        sides.set(9, 3);
        sides.set(8, NONE);
        let all = |sides: &SideNumbers, count: u32| (0..count).map(|h| sides.get(h)).collect::<Vec<_>>();
        let none = NONE;
        assert_eq!(all(&sides, 12), [none, none, none, none, 7, none, none, none, none, 3, none, none]);
        sides.reorder(&Renumbering(vec![3, 2, 1]));
        assert_eq!(all(&sides, 9), [3, none, none, none, none, none, none, 7, none]);
        assert_eq!(sides.rows.len(), 2);
    }
}
