//! Polygons that touch themselves in many ways but don't cross themselves.

use std::collections::HashSet;

type Point = [i32; 2];

/// The counter-clockwise outline of squares of side 2 that hang together at corners. Squares may also touch along whole
/// sides. Slits run from corners to the middles of squares, spikes to the middles of empty places, and some sides have a
/// corner in the middle.
pub struct Growth {
    outline: Vec<Point>,
    squares: HashSet<Point>,
}

/// The direction in eighths of a turn, counter-clockwise from the x axis.
fn direction(from: Point, to: Point) -> i32 {
    match [to[0] - from[0], to[1] - from[1]].map(i32::signum) {
        [1, 0] => 0,
        [1, 1] => 1,
        [0, 1] => 2,
        [-1, 1] => 3,
        [-1, 0] => 4,
        [-1, -1] => 5,
        [0, -1] => 6,
        _ => 7,
    }
}

fn plus([x, y]: Point, [u, v]: Point) -> Point {
    [x + u, y + v]
}

impl Growth {
    /// Grows from one square. Any number is a move: the first half adds squares, the others slits, spikes and corners.
    pub fn new(moves: &[u32]) -> Self {
        let mut this =
            Self { outline: vec![[0, 0], [2, 0], [2, 2], [0, 2]], squares: HashSet::from([[0, 0]]) };
        let (squares, rest) = moves.split_at(moves.len().div_ceil(2));
        for &m in squares {
            this.add(m as usize / 4, (m % 4) as i32, true);
        }
        for &m in rest {
            match m % 3 {
                0 => this.add(m as usize / 12, (m / 3 % 4) as i32, false),
                1 => this.add_slit(m as usize / 3),
                _ => this.add_middle(m as usize / 3),
            }
        }
        this
    }

    pub fn area(&self) -> f32 {
        4.0 * self.squares.len() as f32
    }

    pub fn points(&self) -> Vec<[f32; 2]> {
        self.outline.iter().map(|p| p.map(|c| c as f32)).collect()
    }

    /// A corner's index, and the corner between its neighbours.
    fn corner(&self, at: usize) -> (usize, [Point; 3]) {
        let n = self.outline.len();
        let at = at % n;
        (at, [self.outline[(at + n - 1) % n], self.outline[at], self.outline[(at + 1) % n]])
    }

    /// Adds a square in a quarter of the plane at a corner, or a spike to the quarter's middle, if the quarter is empty
    /// and outside at that corner.
    fn add(&mut self, at: usize, quarter: i32, square: bool) {
        let (at, [before, here, after]) = self.corner(at);
        let (from, to) = (direction(here, before), direction(here, after));
        let start = (2 * quarter - from).rem_euclid(8);
        let (u, v) =
            [([2, 0], [0, 2]), ([0, 2], [-2, 0]), ([-2, 0], [0, -2]), ([0, -2], [2, 0])][quarter as usize];
        let far = plus(plus(here, u), v);
        let place = [here[0].min(far[0]), here[1].min(far[1])];
        // Corners of squares have even coordinates, their middles odd ones.
        let is_outside = start + 2 <= (to - from).rem_euclid(8);
        let is_free = here.iter().all(|c| c % 2 == 0) && !self.squares.contains(&place);
        match (is_outside && is_free, square) {
            (false, _) => {}
            (true, true) => {
                self.squares.insert(place);
                self.outline.splice(at + 1..at + 1, [plus(here, u), far, plus(here, v), here]);
            }
            (true, false) => {
                self.outline.splice(at + 1..at + 1, [plus(place, [1, 1]), here]);
            }
        }
    }

    /// Adds a slit from a corner to the middle of the square left of the side after it.
    fn add_slit(&mut self, at: usize) {
        let (at, [_, here, after]) = self.corner(at);
        let [u, v] = [after[0] - here[0], after[1] - here[1]];
        if here.iter().all(|c| c % 2 == 0) && (u == 0 || v == 0) {
            let [u, v] = [u.signum(), v.signum()];
            self.outline.splice(at + 1..at + 1, [plus(here, [u - v, u + v]), here]);
        }
    }

    /// Adds a corner in the middle of the side after a corner.
    fn add_middle(&mut self, at: usize) {
        let (at, [_, here, after]) = self.corner(at);
        let [u, v] = [after[0] - here[0], after[1] - here[1]];
        if u.abs() + v.abs() == 2 && (u == 0 || v == 0) {
            self.outline.insert(at + 1, plus(here, [u / 2, v / 2]));
        }
    }
}

/// A comb of teeth side by side, which touch along their sides.
pub fn comb(heights: &[u8]) -> Vec<[f32; 2]> {
    let mut points = vec![[0.0, 0.0], [heights.len() as f32, 0.0]];
    for (i, &height) in heights.iter().enumerate().rev() {
        let (x, y) = (i as f32, 2.0 + f32::from(height));
        points.extend([[x + 1.0, y], [x, y], [x, 1.0]]);
    }
    points
}
