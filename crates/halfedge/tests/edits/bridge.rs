//! Bridge: what it joins, and how.

use crate::random::Random;
use crate::zoo::{self, counts};
use glam::{Quat, Vec3};
use halfedge::edit::*;
use halfedge::{Element, FaceId, HalfedgeId, Mesh, Refusal};

/// A polygon of n corners, some of them pulled in or out at random.
fn ring(random: &mut Random, n: usize, place: impl Fn(Vec3) -> Vec3) -> Vec<Vec3> {
    let start = random.unit();
    let corner = |i: usize, radius: f32| {
        let angle = (i as f32 / n as f32 + start) * std::f32::consts::TAU;
        place(Vec3::new(angle.cos(), angle.sin(), 0.0) * radius)
    };
    (0..n).map(|i| corner(i, 0.7 + 0.6 * random.unit())).collect()
}

/// Polygons as single faces.
fn plates(rings: &[Vec<Vec3>]) -> Mesh {
    let mut first = 0;
    let faces: Vec<Vec<u32>> = rings
        .iter()
        .map(|ring| {
            first += ring.len() as u32;
            (first - ring.len() as u32..first).collect()
        })
        .collect();
    zoo::mesh(rings.concat(), &faces)
}

fn length_across(mesh: &Mesh, made: &Made) -> f64 {
    let ends = made.edges.iter().map(|&e| mesh.ends(e).map(|v| mesh.position(v).as_dvec3()));
    ends.map(|[a, b]| a.distance(b)).sum()
}

/// The least sum of the lengths of edges between two loops, of the ways to go evenly along both.
fn shortest_even_pairing(a: &[Vec3], b: &[Vec3]) -> f64 {
    let steps = a.len().max(b.len());
    let sum = |turn: usize| -> f64 {
        let pairs = (0..steps).map(|k| (a[k * a.len() / steps], b[(k * b.len() / steps + turn) % b.len()]));
        pairs.map(|(a, b)| a.as_dvec3().distance(b.as_dvec3())).sum()
    };
    (0..b.len()).map(sum).fold(f64::INFINITY, f64::min)
}

#[test]
fn edges_across_are_as_short_as_the_pairing_allows() {
    let mut random = Random::new(1);
    for case in 0..300 {
        let [n, m] = [0, 0].map(|_| 3 + random.below(9));
        let offset = Vec3::new(random.unit(), random.unit(), random.unit()) * 4.0;
        let turn = Quat::from_rotation_y(random.unit() * 3.0 - 1.5);
        let a = ring(&mut random, n, |at| at);
        // In one plane, in parallel planes, or tilted against each other.
        let b = match case % 3 {
            0 => ring(&mut random, m, |at| at + Vec3::X * 4.0),
            1 => ring(&mut random, m, |at| at + offset),
            _ => ring(&mut random, m, |at| turn * at + offset),
        };
        let mesh = plates(&[a, b]);
        let loops = mesh.boundary_loops();
        let across = |bands: Bands| {
            let mut mesh = mesh.clone();
            let made = bridge(&mut mesh, &loops, bands).unwrap();
            counts(&mesh);
            assert_eq!(made.faces.len(), n.max(m));
            length_across(&mesh, &made)
        };
        let best = across(Bands::default());
        // Seen from the band, the second loop runs backward.
        let walk = |h| mesh.loop_of(h).map(|h| mesh.position(mesh.from(h))).collect::<Vec<_>>();
        let [one, mut other] = [walk(loops[0]), walk(loops[1])];
        other.reverse();
        assert!(best <= shortest_even_pairing(&one, &other) * (1.0 + 1e-6), "{n} and {m}, case {case}");
        if n == m {
            let twisted = (1..n as i32).map(|twist| across(Bands { twist, cuts: 0, smoothness: 0.0 }));
            assert!(twisted.fold(f64::INFINITY, f64::min) >= best * (1.0 - 1e-6), "{n}, case {case}");
        }
    }
}

#[test]
fn plates_side_by_side_are_joined_without_a_crossing() {
    // The edges between the sides that face each other are as short as the gap.
    for n in [4, 6, 8, 12] {
        let corner = |i: usize, x: f32| {
            let angle = (i as f32 + 0.5) / n as f32 * std::f32::consts::TAU;
            Vec3::new(angle.cos() + x, angle.sin(), 0.0)
        };
        let ring = |x: f32| (0..n).map(|i| corner(i, x)).collect::<Vec<_>>();
        let mut mesh = plates(&[ring(0.0), ring(3.0)]);
        let loops = mesh.boundary_loops();
        let made = bridge(&mut mesh, &loops, Bands::default()).unwrap();
        for &edge in &made.edges {
            let [a, b] = mesh.ends(edge).map(|v| mesh.position(v));
            assert!((a.y - b.y).abs() < 1e-5, "{n}: an edge goes from {a} to {b}");
        }
    }
}

#[test]
fn a_twist_shifts_the_pairing_by_whole_vertices() {
    let mut random = Random::new(2);
    let mesh = plates(&[ring(&mut random, 7, |at| at), ring(&mut random, 7, |at| at + Vec3::Z * 3.0)]);
    let loops = mesh.boundary_loops();
    let joined = |twist: i32| {
        let mut mesh = mesh.clone();
        let made = bridge(&mut mesh, &loops, Bands { twist, cuts: 0, smoothness: 0.0 }).unwrap();
        let mut pairs: Vec<[usize; 2]> = made
            .edges
            .iter()
            .map(|&e| {
                let [a, b] = mesh.ends(e).map(|v| v.index());
                [a.min(b), a.max(b)]
            })
            .collect();
        pairs.sort_unstable();
        pairs
    };
    let plain = joined(0);
    assert_eq!(joined(7), plain);
    assert_eq!(joined(-14), plain);
    assert_eq!(joined(i32::MAX), joined(i32::MAX % 7));
    let shifted = |by: usize| plain.iter().map(|&[a, b]| [a, 7 + (b - 7 + by) % 7]).collect::<Vec<_>>();
    // The ids of the second ring run in one direction or the other.
    let step = [1, 6].into_iter().find(|&by| joined(1) == shifted(by)).expect("shifted by one vertex");
    assert_eq!(joined(-1), shifted(7 - step));
    assert_eq!(joined(3), shifted(3 * step));
}

#[test]
fn cuts_lie_evenly_on_the_edges_across() {
    for (n, m) in [(5, 5), (4, 9), (9, 4)] {
        let mut random = Random::new(3);
        let plain = plates(&[ring(&mut random, n, |at| at), ring(&mut random, m, |at| at + Vec3::Z * 3.0)]);
        let loops = plain.boundary_loops();
        for cuts in [1, 2, 5] {
            let mut mesh = plain.clone();
            let made = bridge(&mut mesh, &loops, Bands { twist: 1, cuts, smoothness: 0.0 }).unwrap();
            let (steps, cuts) = (n.max(m), cuts as usize);
            assert_eq!(made.vertices.len(), steps * cuts);
            assert_eq!(made.faces.len(), steps * (cuts + 1));
            let after = counts(&mesh);
            assert_eq!(after[2], 2 + steps * (cuts + 1));
            assert!(mesh.boundary_loops().is_empty());
            let triangles = made.faces.iter().filter(|&&f| mesh.face_degree(f) == 3).count();
            assert_eq!(triangles, n.abs_diff(m), "triangles lie only at the shorter loop");
            // Loops are 3 apart, and straight lines between them are cut evenly.
            for &v in &made.vertices {
                let row = mesh.position(v).z / 3.0 * (cuts as f32 + 1.0);
                assert!((row - row.round()).abs() < 1e-4, "{row}");
                assert_eq!(mesh.vertex_edges(v).count(), 4);
            }
        }
    }
    let mesh =
        plates(&[ring(&mut Random::new(1), 4, |at| at), ring(&mut Random::new(1), 4, |at| at + Vec3::Z)]);
    let refused = can_bridge(&mesh, &mesh.boundary_loops(), Bands { twist: 0, cuts: 1001, smoothness: 0.0 });
    assert!(matches!(refused, Err(Refusal::OutOfRange { field: "cuts", .. })));
}

#[test]
fn the_closest_of_many_loops_are_joined() {
    let mut random = Random::new(4);
    // In a row with gaps 3, 1.5, 3, 1: the last two are closest, then the second and third.
    let at = [0.0, 6.0, 7.5, 20.0, 30.0, 31.0].map(|z| Vec3::Z * z);
    let rings: Vec<Vec<Vec3>> = at.iter().map(|&to| ring(&mut random, 5, |at| at + to)).collect();
    let mut mesh = plates(&rings);
    let mut loops = mesh.boundary_loops();
    // Other half-edges of the same loops say the same.
    loops.extend(mesh.boundary_loops().into_iter().map(|h| mesh.next(h)));
    let made = bridge(&mut mesh, &loops, Bands::default()).unwrap();
    counts(&mesh);
    assert!(mesh.boundary_loops().is_empty());
    assert_eq!(made.edges.len(), 15);
    for edge in made.edges {
        let mut pair = mesh.ends(edge).map(|v| v.index() / 5);
        pair.sort_unstable();
        assert!([[1, 2], [4, 5], [0, 3]].contains(&pair), "{pair:?}");
    }

    let odd = plates(&rings[..3]);
    assert_eq!(can_bridge(&odd, &odd.boundary_loops(), Bands::default()), Err(Refusal::NotInPairs(3)));
    let faces: Vec<FaceId> = odd.faces().collect();
    assert_eq!(can_bridge_faces(&odd, &faces, Bands::default()), Err(Refusal::NotInPairs(3)));
    let nothing: [HalfedgeId; 0] = [];
    assert_eq!(can_bridge(&odd, &nothing, Bands::default()), Err(Refusal::NothingGiven(Element::Halfedge)));
}

#[test]
fn regions_of_faces_are_replaced_with_what_is_inside_them() {
    // Two parallel grids of 5 by 5 quads that face away from each other; 3 by 3 quads in the middle of each.
    let grid = zoo::grid(5, 5);
    let corners: Vec<Vec<u32>> =
        grid.faces().map(|f| grid.face_vertices(f).map(|v| v.raw()).collect()).collect();
    let count = grid.vertex_count() as u32;
    let above = |f: &Vec<u32>| f.iter().map(|&v| v + count).collect::<Vec<u32>>();
    let below = |f: &Vec<u32>| f.iter().rev().copied().collect::<Vec<u32>>();
    let faces: Vec<Vec<u32>> = corners.iter().map(below).chain(corners.iter().map(above)).collect();
    let positions: Vec<Vec3> = grid
        .positions()
        .iter()
        .copied()
        .chain(grid.positions().iter().map(|&at| at + Vec3::Z * 2.0))
        .collect();
    let start = zoo::mesh(positions, &faces);
    let inner =
        |first: usize| [6, 7, 8, 11, 12, 13, 16, 17, 18].map(|at: usize| FaceId::new(first + at)).to_vec();
    let chosen = [inner(0), inner(25)].concat();
    let mut mesh = start.clone();
    let before = counts(&mesh);
    let made = bridge_faces(&mut mesh, &chosen, Bands { twist: 0, cuts: 1, smoothness: 0.0 }).unwrap();
    assert_eq!(made.removed_faces.len(), 18);
    assert_eq!(made.removed_vertices.len(), 8, "the four vertices inside each region");
    assert_eq!(made.faces.len(), 12 * 2);
    assert_eq!(counts(&mesh)[2], before[2] - 18 + 24);
    assert_eq!((mesh.components().1, mesh.boundary_loops().len(), mesh.euler_characteristic()), (1, 2, 0));
    for &v in &made.vertices {
        assert!((mesh.position(v).z - 1.0).abs() < 1e-6);
    }

    // One region, regions that meet at a corner, and one with a hole.
    let one = inner(0);
    assert!(matches!(can_bridge_faces(&start, &one, Bands::default()), Err(Refusal::FacesTouch(..))));
    let diagonal = [FaceId::new(0), FaceId::new(6)];
    assert!(matches!(can_bridge_faces(&start, &diagonal, Bands::default()), Err(Refusal::FacesTouch(..))));
    let mut holed = [inner(0), inner(25)].concat();
    holed.retain(|&f| f != FaceId::new(12));
    assert!(matches!(can_bridge_faces(&start, &holed, Bands::default()), Err(Refusal::NotADisc(_))));
    let single = can_bridge_faces(&start, &one[..1], Bands::default());
    assert_eq!(single, Err(Refusal::OnlyOne(Element::Face, one[0].raw())));
}

#[test]
fn a_smooth_band_leaves_both_surfaces_in_their_directions() {
    // Two tubes along z, from 0 to 1 and from 3 to 4, open at both ends; the upper one is shifted along x.
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let tubes = |shift: f32| {
        let levels = [(0.0, 0.0), (1.0, 0.0), (3.0, shift), (4.0, shift)];
        let positions =
            levels.iter().flat_map(|(z, x)| corners.map(|c| Vec3::new(c[0] + x, c[1], *z))).collect();
        let wall =
            |first: u32, i: u32| vec![first + i, first + (i + 1) % 4, first + 4 + (i + 1) % 4, first + 4 + i];
        let faces: Vec<Vec<u32>> =
            [0, 8].iter().flat_map(|first| (0..4).map(move |i| wall(*first, i))).collect();
        zoo::mesh(positions, &faces)
    };
    let joined = |shift: f32, smoothness: f32| {
        let mut mesh = tubes(shift);
        let inner = |h: &HalfedgeId| [1.0, 3.0].contains(&mesh.position(mesh.from(*h)).z);
        let loops: Vec<HalfedgeId> = mesh.boundary_loops().into_iter().filter(inner).collect();
        let made = bridge(&mut mesh, &loops, Bands { twist: 0, cuts: 3, smoothness }).expect("possible");
        counts(&mesh);
        let mut lines: Vec<Vec3> = made.vertices.iter().map(|v| mesh.position(*v)).collect();
        lines.retain(|at| at.y == 0.0);
        lines.sort_by(|a, b| a.z.total_cmp(&b.z));
        lines
    };
    // In line, the curve is the straight line, with the same spacing where its control points are thirds.
    for smoothness in [0.0, 1.0] {
        for (at, z) in joined(0.0, smoothness).chunks(2).zip([1.5, 2.0, 2.5]) {
            assert!(at.iter().all(|at| (at.z - z).abs() < 1e-6), "{smoothness}: {at:?}, not {z}");
        }
    }
    // Shifted, it leaves both tubes along them: the slope at a quarter is less than that of the straight line.
    let [straight, smooth] = [0.0, 1.0].map(|smoothness| joined(1.0, smoothness));
    // Half of the way is half of the shift either way, and a quarter 5/32 of it.
    let left = |lines: &[Vec3], z: f32| {
        let near = lines.iter().filter(|at| (at.z - z).abs() < 0.3).map(|at| at.x);
        near.fold(f32::INFINITY, f32::min)
    };
    assert!((left(&straight, 1.5) - 0.25).abs() < 1e-6, "{straight:?}");
    assert!((left(&smooth, 2.0) - 0.5).abs() < 1e-6, "{smooth:?}");
    assert!((left(&smooth, 1.5) - 5.0 / 32.0).abs() < 0.02, "{smooth:?}");
    let refused =
        can_bridge(&tubes(0.0), &tubes(0.0).boundary_loops(), Bands { smoothness: 4.5, ..Bands::default() });
    assert!(matches!(refused, Err(Refusal::OutOfRange { field: "smoothness", .. })), "{refused:?}");
}

#[test]
fn faces_that_face_each_other_are_joined_by_a_round_handle() {
    // The outer two of three quads in a row.
    let positions: Vec<Vec3> = (0..8).map(|i| Vec3::new((i / 2) as f32, (i % 2) as f32, 0.0)).collect();
    let faces: Vec<Vec<u32>> = (0..3).map(|i| vec![2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]).collect();
    let mut mesh = zoo::mesh(positions, &faces);
    let ends = [FaceId::new(0), FaceId::new(2)];
    let made =
        bridge_faces(&mut mesh, &ends, Bands { twist: 0, cuts: 1, smoothness: 2.0 }).expect("possible");
    assert_eq!(made.vertices.len(), 4);
    assert!(made.vertices.iter().all(|v| mesh.position(*v).z > 0.2), "above the strip");
    counts(&mesh);
}
