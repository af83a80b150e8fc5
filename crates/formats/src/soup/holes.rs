//! Triangulating polygons with holes: a face of a mesh has one outline.
//!
//! Each hole is joined to the outline by a bridge to a corner that it sees (D. Eberly,
//! "Triangulation by Ear Clipping", 2002), which gives one polygon that touches itself along the
//! bridges; that one is cut ear by ear.

use glam::{DVec3, Vec2, Vec3};
use halfedge::geometry::{PolygonTriangulator, polygon_area_vector};

/// Corners of the largest polygon with holes that is triangulated: the time grows with their square.
const MAX_CORNERS: usize = 1000;

/// Triangulates a polygon with holes. Corners are numbered outline first, then hole by hole. `None` if a
/// hole crosses the outline or another hole or lies outside, if the outline crosses itself, or if there
/// are more than [`MAX_CORNERS`].
pub(crate) fn cut(outline: &[Vec3], holes: &[Vec<Vec3>]) -> Option<Vec<[u32; 3]>> {
    let corners = outline.len() + holes.iter().map(Vec::len).sum::<usize>();
    if outline.len() < 3 || corners > MAX_CORNERS {
        return None;
    }
    let normal = polygon_area_vector(outline.iter().copied()).try_normalize().unwrap_or(DVec3::Z);
    let (u, v) = normal.as_vec3().any_orthonormal_pair();
    let origin = outline.first().copied().unwrap_or_default();
    let project = |&p: &Vec3| Vec2::new((p - origin).dot(u), (p - origin).dot(v));
    let points: Vec<Vec2> = outline.iter().chain(holes.iter().flatten()).map(project).collect();
    let point = |i: u32| points.get(i as usize).copied().unwrap_or_default();
    let mut ring: Vec<u32> = (0..outline.len() as u32).collect();
    let mut area = twice_area(&ring, point);
    // Holes run the opposite way to the outline. The one farthest along x is joined first, so that no
    // other hole blocks its view.
    let mut start = outline.len() as u32;
    let mut inner: Vec<Vec<u32>> = Vec::with_capacity(holes.len());
    for hole in holes {
        let mut hole_ring: Vec<u32> = (start..start + hole.len() as u32).collect();
        start += hole.len() as u32;
        let own = twice_area(&hole_ring, point);
        if hole.len() < 3 || own == 0.0 {
            continue;
        }
        area -= own.abs();
        if own > 0.0 {
            hole_ring.reverse();
        }
        let x = |&i: &u32| point(i).x;
        let far = (0..hole_ring.len()).max_by(|&a, &b| {
            let at = |place: usize| hole_ring.get(place).map_or(f32::MIN, x);
            at(a).total_cmp(&at(b))
        })?;
        hole_ring.rotate_left(far);
        inner.push(hole_ring);
    }
    let first_x = |ring: &Vec<u32>| ring.first().map_or(f32::MIN, |&i| point(i).x);
    inner.sort_by(|a, b| first_x(b).total_cmp(&first_x(a)));
    for hole in inner {
        join(&mut ring, &hole, point)?;
    }
    let flat: Vec<Vec3> = ring.iter().map(|&i| point(i).extend(0.0)).collect();
    let triangles: Vec<[u32; 3]> = PolygonTriangulator::new()
        .cut_ears(&flat)?
        .iter()
        .map(|triangle| triangle.map(|i| ring.get(i as usize).copied().unwrap_or_default()))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    // Check the result: no triangle is flipped, and together they cover the right area.
    let covered: Vec<f32> =
        triangles.iter().map(|&[a, b, c]| (point(b) - point(a)).perp_dot(point(c) - point(a))).collect();
    let tolerance = 1e-3 * area.abs();
    let right = area > 0.0
        && covered.iter().all(|&part| part >= -tolerance)
        && (covered.iter().sum::<f32>() - area).abs() <= tolerance;
    right.then_some(triangles)
}

/// Twice the signed area of a ring, positive if it runs counter-clockwise.
fn twice_area(ring: &[u32], point: impl Fn(u32) -> Vec2) -> f32 {
    let origin = ring.first().map_or(Vec2::ZERO, |&i| point(i));
    ring.windows(2)
        .map(|pair| match pair {
            &[a, b] => (point(a) - origin).perp_dot(point(b) - origin),
            _ => 0.0,
        })
        .sum()
}

/// Joins a hole to a ring with a bridge from the hole's first corner, its farthest along x, to a visible
/// corner of the ring. `None` if no corner is visible.
fn join(ring: &mut Vec<u32>, hole: &[u32], point: impl Fn(u32) -> Vec2) -> Option<()> {
    let from = point(*hole.first()?);
    let n = ring.len();
    let at = |i: usize| ring.get(i % n).map_or(Vec2::ZERO, |&i| point(i));
    // The nearest side to the right that runs upward has the inside, where `from` is, on its left.
    let mut hit: Option<(f32, usize)> = None;
    for i in 0..n {
        let (a, b) = (at(i), at(i + 1));
        if a.y > from.y || b.y < from.y || a.y == b.y {
            continue;
        }
        let x = a.x + (b.x - a.x) * ((from.y - a.y) / (b.y - a.y));
        if x >= from.x && hit.is_none_or(|(best, _)| x < best) {
            hit = Some((x, i));
        }
    }
    let (x, side) = hit?;
    let hit = Vec2::new(x, from.y);
    let mut best = if at(side).x > at(side + 1).x { side } else { (side + 1) % n };
    // Corners inside the triangle between would block the view: of those the one nearest in angle to
    // the line is visible.
    let corner = at(best);
    let triangle = if corner.y < from.y { [from, corner, hit] } else { [from, hit, corner] };
    let inside = |p: Vec2| {
        let [a, b, c] = triangle;
        (b - a).perp_dot(p - a) >= 0.0 && (c - b).perp_dot(p - b) >= 0.0 && (a - c).perp_dot(p - c) >= 0.0
    };
    let slope = |p: Vec2| ((p.y - from.y).abs() / (p.x - from.x).max(f32::MIN_POSITIVE), p.distance(from));
    let sees = |i: usize| {
        // The bridge leaves the corner into the inside of the ring.
        let (before, here, after) = (at(i + n - 1), at(i), at(i + 1));
        let left_of = |a: Vec2, b: Vec2| (b - a).perp_dot(from - a) > 0.0;
        let reflex = (here - before).perp_dot(after - here) < 0.0;
        match reflex {
            false => left_of(before, here) && left_of(here, after),
            true => left_of(before, here) || left_of(here, after),
        }
    };
    let mut least = if sees(best) { slope(corner) } else { (f32::INFINITY, f32::INFINITY) };
    for i in 0..n {
        let p = at(i);
        if p.x >= from.x && inside(p) && sees(i) && slope(p) < least {
            (best, least) = (i, slope(p));
        }
    }
    let to = ring.get(best).copied()?;
    let bridge = hole.iter().copied().chain(hole.first().copied()).chain([to]);
    ring.splice(best + 1..best + 1, bridge);
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square(x: f32, y: f32, size: f32) -> Vec<Vec3> {
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(u, v)| Vec3::new(x + u * size, y + v * size, 0.0))
            .to_vec()
    }

    fn area(outline: &[Vec3], holes: &[Vec<Vec3>], triangles: &[[u32; 3]]) -> f32 {
        let points: Vec<Vec3> = outline.iter().chain(holes.iter().flatten()).copied().collect();
        let of = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| points[i as usize]);
            (b - a).cross(c - a).length() / 2.0
        };
        triangles.iter().map(of).sum()
    }

    #[test]
    fn a_square_with_a_square_hole_is_eight_triangles() {
        for reversed in [false, true] {
            let outline = square(0.0, 0.0, 4.0);
            let mut hole = square(1.0, 1.0, 2.0);
            if reversed {
                hole.reverse();
            }
            let holes = [hole];
            let triangles = cut(&outline, &holes).expect("simple");
            assert_eq!(triangles.len(), 8);
            assert!((area(&outline, &holes, &triangles) - 12.0).abs() < 1e-4);
        }
    }

    #[test]
    fn several_holes_in_any_plane() {
        let tilt = |p: &Vec3| Vec3::new(p.x, p.y, 2.0 * p.x - p.y);
        let outline: Vec<Vec3> = square(0.0, 0.0, 9.0).iter().map(tilt).collect();
        let holes: Vec<Vec<Vec3>> = [(1.0, 1.0), (1.0, 6.0), (6.0, 1.0), (6.0, 6.0), (3.5, 3.5)]
            .iter()
            .map(|&(x, y)| square(x, y, 2.0).iter().map(tilt).collect())
            .collect();
        let triangles = cut(&outline, &holes).expect("simple");
        assert_eq!(triangles.len(), 4 + 20 + 2 * 5 - 2);
        let expected = (81.0 - 5.0 * 4.0) * 6f32.sqrt();
        assert!((area(&outline, &holes, &triangles) - expected).abs() < 1e-2);
    }

    #[test]
    fn what_is_no_polygon_with_holes_is_left_alone() {
        let outline = square(0.0, 0.0, 4.0);
        assert_eq!(cut(&outline, &[square(9.0, 0.0, 1.0)]), None, "outside");
        assert_eq!(cut(&outline, &[square(3.0, 1.0, 2.0)]), None, "across");
        assert_eq!(cut(&outline, &[square(1.0, 1.0, 2.0), square(2.0, 2.0, 1.5)]), None, "into each other");
        assert_eq!(cut(&outline[..2], &[]), None);
        assert_eq!(cut(&[Vec3::ZERO; 4], &[square(0.0, 0.0, 1.0)]), None);
        assert_eq!(cut(&[Vec3::NAN; 4], &[square(0.0, 0.0, 1.0)]), None);
        // A hole without area is none.
        assert_eq!(cut(&outline, &[vec![Vec3::ONE; 3]]).map(|t| t.len()), Some(2));
    }

    proptest! {
        #[test]
        fn random_stars_with_holes_are_covered(
            radii in prop::collection::vec(6.0f32..12.0, 5..24),
            holes in prop::collection::vec((0usize..16, 0.1f32..0.45, 3usize..7), 0..8),
        ) {
            let n = radii.len() as f32;
            let outline: Vec<Vec3> = radii
                .iter()
                .enumerate()
                .map(|(i, r)| {
                    let turn = i as f32 / n * std::f32::consts::TAU;
                    Vec3::new(r * turn.cos(), r * turn.sin(), 0.0)
                })
                .collect();
            // One in each of some cells, so that they never meet.
            let mut cells: Vec<usize> = Vec::new();
            let mut rings = Vec::new();
            for (cell, size, corners) in holes {
                if !cells.contains(&cell) {
                    cells.push(cell);
                    let middle = Vec3::new((cell % 4) as f32 - 1.5, (cell / 4) as f32 - 1.5, 0.0);
                    rings.push((0..corners).map(|i| {
                        let turn = i as f32 / corners as f32 * std::f32::consts::TAU;
                        middle + Vec3::new(turn.cos(), turn.sin(), 0.0) * size
                    }).collect::<Vec<_>>());
                }
            }
            let ring_area = |ring: &[Vec3]| -> f32 {
                let next = ring.iter().cycle().skip(1);
                (ring.iter().zip(next).map(|(a, b)| a.x * b.y - a.y * b.x).sum::<f32>() / 2.0).abs()
            };
            let expected = ring_area(&outline) - rings.iter().map(|ring| ring_area(ring)).sum::<f32>();
            let triangles = cut(&outline, &rings).expect("simple");
            prop_assert!((area(&outline, &rings, &triangles) - expected).abs() < 0.01 * expected);
        }
    }
}
