//! Polygons cut into triangles, for formats that hold nothing else.

use glam::{Vec2, Vec3};
use halfedge::edit::polygon_ears;

/// Cuts a polygon into triangles of its corners' numbers: a fan where that is right, else ear by
/// ear in the plane that fits it best, at O(n^2). A polygon that crosses itself is cut somehow.
pub(crate) fn triangulate(points: &[Vec3], out: &mut Vec<[u32; 3]>) {
    out.clear();
    let count = points.len() as u32;
    if count == 3 {
        out.push([0, 1, 2]);
        return;
    }
    let plane = Plane::of(points);
    let flat: Vec<Vec2> = points.iter().map(|&p| plane.flat(p)).collect();
    let fan = (2..count).map(|i| [0, i - 1, i]);
    let is_fan = fan.clone().all(|triangle| area(&flat, triangle) > 0.0);
    match if is_fan { None } else { polygon_ears(points) } {
        Some(ears) => out.extend(ears.iter().map(|ear| ear.map(|i| i as u32))),
        None => out.extend(fan),
    }
}

/// Twice the area of a triangle of these points; more than zero where it runs counter-clockwise.
fn area(flat: &[Vec2], [a, b, c]: [u32; 3]) -> f32 {
    let point = |i: u32| flat.get(i as usize).copied().unwrap_or_default();
    (point(b) - point(a)).perp_dot(point(c) - point(a))
}

/// The plane that fits a polygon best, in which it runs counter-clockwise.
pub(crate) struct Plane {
    origin: Vec3,
    u: Vec3,
    v: Vec3,
}

impl Plane {
    /// By the polygon's normal (Newell's).
    pub(crate) fn of(points: &[Vec3]) -> Self {
        let origin = points.first().copied().unwrap_or_default();
        let next = points.iter().cycle().skip(1);
        let normal: Vec3 = points.iter().zip(next).map(|(&a, &b)| (a - origin).cross(b - origin)).sum();
        let (u, v) = normal.try_normalize().unwrap_or(Vec3::Z).any_orthonormal_pair();
        Self { origin, u, v }
    }

    /// A point as seen along the normal.
    pub(crate) fn flat(&self, point: Vec3) -> Vec2 {
        let from = point - self.origin;
        Vec2::new(from.dot(self.u), from.dot(self.v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn total_area(points: &[Vec3], triangles: &[[u32; 3]]) -> f32 {
        triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| points[i as usize]);
                (b - a).cross(c - a).length() / 2.0
            })
            .sum()
    }

    #[test]
    fn concave_polygons_are_cut_inside() {
        // An arrowhead whose first corner sees not all others, in a tilted plane.
        let flat = [(0.0, 0.0), (4.0, -3.0), (1.0, 0.0), (4.0, 3.0)];
        for turn in 0..4 {
            let points: Vec<Vec3> =
                (0..4).map(|i| flat[(i + turn) % 4]).map(|(x, y)| Vec3::new(x, y, x + 2.0 * y)).collect();
            let mut out = Vec::new();
            triangulate(&points, &mut out);
            assert_eq!(out.len(), 2);
            // Its area in the plane is 3, the tilt makes that sqrt(6) times as much.
            assert!((total_area(&points, &out) - 3.0 * 6f32.sqrt()).abs() < 1e-4, "{turn} {out:?}");
        }
    }

    #[test]
    fn polygons_that_touch_themselves_are_covered_once() {
        // Two squares that touch at a corner, and corners that touch.
        let squares = [(0., 0.), (1., 0.), (1., 1.), (2., 1.), (2., 2.), (1., 2.), (1., 1.), (0., 1.)];
        let waist = [(0., 0.), (2., 1.), (4., 0.), (4., 4.), (2., 1.), (0., 4.)];
        for (flat, expected) in [(&squares[..], 2.0), (&waist, 8.0)] {
            let points: Vec<Vec3> = flat.iter().map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
            let mut out = Vec::new();
            triangulate(&points, &mut out);
            assert_eq!(out.len(), points.len() - 2);
            assert_eq!(total_area(&points, &out), expected);
        }
    }

    #[test]
    fn convex_polygons_are_fans_and_degenerate_ones_end() {
        let ring: Vec<Vec3> =
            (0..7).map(|i| Vec3::new((i as f32 * 0.9).cos(), (i as f32 * 0.9).sin(), 0.0)).collect();
        let mut out = Vec::new();
        triangulate(&ring, &mut out);
        assert_eq!(out, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5], [0, 5, 6]]);
        triangulate(&[Vec3::ONE; 9], &mut out);
        assert_eq!(out.len(), 7);
        triangulate(&[Vec3::ONE; 2], &mut out);
        assert_eq!(out.len(), 0);
    }
}
