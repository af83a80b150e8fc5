//! Polygons to triangles for drawing.

use crate::normals;
use glam::{DVec2, Vec3};

/// Concave polygons of more corners than this are drawn as fans: clipping ears takes quadratic time.
const MAX_EARS: usize = 2048;

/// Cuts polygons into triangles between their own corners, keeping its memory between polygons.
#[derive(Default)]
pub struct Triangulator {
    triangles: Vec<[u32; 3]>,
    flat: Vec<DVec2>,
    rest: Vec<u32>,
}

impl Triangulator {
    /// The triangles of a polygon as numbers of its corners, turning the same way: always two fewer
    /// than corners. A convex polygon becomes a fan in O(n), a concave one is cut ear by ear
    /// (Meisters 1975) in O(n²) as seen along its area vector; of one that crosses itself some
    /// triangles overlap.
    pub fn run(&mut self, points: &[Vec3]) -> &[[u32; 3]] {
        self.triangles.clear();
        let corners = points.len() as u32;
        if corners == 3 {
            self.triangles.push([0, 1, 2]);
        } else if corners > 3 {
            self.flatten(points);
            match self.fan_start() {
                Some(start) => {
                    let corner = |i: u32| (start + i) % corners;
                    self.triangles.extend((1..corners - 1).map(|i| [corner(0), corner(i), corner(i + 1)]));
                }
                None => self.clip_ears(),
            }
        }
        &self.triangles
    }

    /// The polygon seen along its area vector, counter-clockwise.
    fn flatten(&mut self, points: &[Vec3]) {
        let normal = normals::area_vector(points).normalize_or(glam::DVec3::Z);
        let (x, y) = normal.any_orthonormal_pair();
        let first = points.first().copied().unwrap_or_default().as_dvec3();
        self.flat.clear();
        self.flat.extend(points.iter().map(|p| {
            let p = p.as_dvec3() - first;
            DVec2::new(p.dot(x), p.dot(y))
        }));
    }

    fn turn(&self, a: u32, b: u32, c: u32) -> f64 {
        let at = |i: u32| self.flat.get(i as usize).copied().unwrap_or_default();
        (at(b) - at(a)).perp_dot(at(c) - at(a))
    }

    /// Where a fan of the polygon may start; none when it has to be cut another way.
    fn fan_start(&self) -> Option<u32> {
        let n = self.flat.len() as u32;
        if self.flat.len() > MAX_EARS {
            return Some(0);
        }
        let reflex = |&i: &u32| self.turn((i + n - 1) % n, i, (i + 1) % n) < 0.0;
        let mut reflex = (0..n).filter(reflex);
        let (first, more) = (reflex.next(), reflex.next());
        if n == 4 {
            // From the corner that points inward; else along the shorter diagonal, the first corner's
            // on a tie.
            let at = |i: usize| self.flat.get(i).copied().unwrap_or_default();
            let shorter = u32::from(at(1).distance_squared(at(3)) < at(0).distance_squared(at(2)) * 0.9999);
            return Some(first.unwrap_or(shorter));
        }
        (first.is_none() && more.is_none()).then_some(0)
    }

    fn clip_ears(&mut self) {
        self.rest.clear();
        self.rest.extend(0..self.flat.len() as u32);
        let mut at = 0;
        let mut failed = 0;
        while self.rest.len() > 3 {
            let n = self.rest.len();
            let corner = |i: usize| self.rest.get(i % n).copied().unwrap_or_default();
            let (a, b, c) = (corner(at + n - 1), corner(at), corner(at + 1));
            // A polygon without an ear crosses itself: cut anyway.
            if failed > n || self.is_ear(a, b, c) {
                self.triangles.push([a, b, c]);
                self.rest.remove(at % n);
                failed = 0;
                // Going on two corners further spreads the cuts, for less slender triangles.
                at = (at + 1) % (n - 1);
            } else {
                failed += 1;
                at = (at + 1) % n;
            }
        }
        if let &[a, b, c] = self.rest.as_slice() {
            self.triangles.push([a, b, c]);
        }
    }

    fn is_ear(&self, a: u32, b: u32, c: u32) -> bool {
        if self.turn(a, b, c) <= 0.0 {
            return false;
        }
        let at = |i: u32| self.flat.get(i as usize).copied().unwrap_or_default();
        self.rest.iter().all(|&p| {
            let is_corner = [a, b, c].into_iter().any(|q| q == p || at(q) == at(p));
            is_corner || self.turn(a, b, p) < 0.0 || self.turn(b, c, p) < 0.0 || self.turn(c, a, p) < 0.0
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;
    use proptest::prelude::*;

    fn area(points: &[Vec3], triangles: &[[u32; 3]]) -> Vec<f64> {
        let at = |i: u32| points[i as usize];
        triangles.iter().map(|t| normals::area_vector(&t.map(at)).z).collect()
    }

    #[test]
    fn a_concave_quad_is_cut_at_its_inward_corner() {
        let points = [vec3(0., 0., 0.), vec3(4., 0., 0.), vec3(1., 1., 0.), vec3(0., 4., 0.)];
        let mut triangulator = Triangulator::default();
        assert_eq!(triangulator.run(&points), [[2, 3, 0], [2, 0, 1]]);
        assert_eq!(triangulator.run(&points[..3]), [[0, 1, 2]]);
        assert!(triangulator.run(&points[..2]).is_empty());
    }

    #[test]
    fn a_comb_is_covered_once() {
        // Teeth pointing up from a bar: every second top corner is an inward one.
        let mut points = vec![vec3(0., 0., 0.), vec3(10., 0., 0.)];
        for tooth in (0..10).rev() {
            points.push(vec3(tooth as f32 + 0.5, 3.0, 0.0));
            points.push(vec3(tooth as f32, 1.0, 0.0));
        }
        let mut triangulator = Triangulator::default();
        let areas = area(&points, triangulator.run(&points));
        assert_eq!(areas.len(), points.len() - 2);
        assert!(areas.iter().all(|&a| a >= 0.0), "{areas:?}");
        let whole = normals::area_vector(&points).z;
        assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-9);
    }

    proptest! {
        /// Star-shaped polygons of any size: areas are positive and add up.
        #[test]
        fn stars_are_covered_once(radii in prop::collection::vec(0.2_f32..2.0, 3..40)) {
            let n = radii.len() as f32;
            let points: Vec<Vec3> = radii.iter().enumerate().map(|(i, r)| {
                let angle = i as f32 / n * std::f32::consts::TAU;
                vec3(angle.cos() * r, angle.sin() * r, 0.0)
            }).collect();
            let mut triangulator = Triangulator::default();
            let areas = area(&points, triangulator.run(&points));
            prop_assert_eq!(areas.len(), points.len() - 2);
            prop_assert!(areas.iter().all(|&a| a > -1e-6));
            let whole = normals::area_vector(&points).z;
            prop_assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-4);
        }
    }
}
