//! Sliding edges and vertices along their neighbours: by example, and at random.

use crate::random::Random;
use crate::zoo::{self, he, v};
use glam::{Vec2, Vec3};
use halfedge::edit::*;
use halfedge::{EdgeId, Element, FaceId, Mesh, Refusal, VertexId, keys};

/// The edges between the vertices of a path.
fn path(mesh: &Mesh, vertices: &[usize]) -> Vec<EdgeId> {
    vertices.windows(2).map(|pair| he(mesh, pair[0], pair[1]).edge()).collect()
}

/// The amount that moves the line to the left of its first edge's direction along the path.
fn to_the_left(mesh: &Mesh, edges: &[EdgeId], start: usize, amount: f32) -> f32 {
    if mesh.from(edges[0].halfedge()) == v(start) { amount } else { -amount }
}

/// The mesh after a path of edges has slid to the left of its direction.
fn slid(mesh: &Mesh, vertices: &[usize], amount: f32) -> Mesh {
    let mut mesh = mesh.clone();
    let edges = path(&mesh, vertices);
    let amount = to_the_left(&mesh, &edges, vertices[0], amount);
    slide_edges(&mut mesh, &edges, amount).unwrap();
    mesh.validate().unwrap();
    mesh
}

/// Where vertices of a mesh are, as (x, y).
fn places<const N: usize>(mesh: &Mesh, vertices: [usize; N]) -> [(f32, f32); N] {
    vertices.map(|at| (mesh.position(v(at)).x, mesh.position(v(at)).y))
}

#[test]
fn a_line_across_a_grid_reaches_both_neighbours() {
    let grid = zoo::grid(3, 4);
    let line = [8, 9, 10, 11];
    let left = slid(&grid, &line, 0.25);
    assert_eq!(places(&left, line), [(0.0, 2.25), (1.0, 2.25), (2.0, 2.25), (3.0, 2.25)]);
    let right = slid(&grid, &line, -0.5);
    assert_eq!(places(&right, line), [(0.0, 1.5), (1.0, 1.5), (2.0, 1.5), (3.0, 1.5)]);
    for (amount, first) in [(1.0, 12), (-1.0, 4)] {
        let all = slid(&grid, &line, amount);
        for at in 0..4 {
            assert_eq!(all.position(v(8 + at)), grid.position(v(first + at)), "exactly at the neighbour");
        }
    }
    // The direction is that of the first edge given, whatever comes after.
    let mut reversed = path(&grid, &line);
    reversed[1..].reverse();
    let mut mesh = grid.clone();
    let amount = to_the_left(&grid, &reversed, 8, 0.25);
    slide_edges(&mut mesh, &reversed, amount).unwrap();
    assert!(mesh == left);
}

#[test]
fn a_closed_loop_moves_to_one_side_all_round() {
    // Vertex 4i + j is the j-th of the i-th ring round the tube.
    let torus = zoo::torus(6, 4);
    let edges = path(&torus, &[0, 4, 8, 12, 16, 20, 0]);
    let rings = [1.0, -1.0].map(|amount| {
        let mut mesh = torus.clone();
        assert_eq!(slide_edges(&mut mesh, &edges, amount), Ok(6));
        let is_at = |by: usize| (0..6).all(|i| mesh.position(v(i * 4)) == torus.position(v(i * 4 + by)));
        [1, 3].map(is_at)
    });
    assert!(rings == [[true, false], [false, true]] || rings == [[false, true], [true, false]], "{rings:?}");
}

#[test]
fn several_lines_move_the_same_way() {
    let grid = zoo::grid(3, 4);
    // Given against each other.
    let edges = [path(&grid, &[4, 5, 6, 7]), path(&grid, &[15, 14, 13, 12])].concat();
    let mut mesh = grid.clone();
    let amount = to_the_left(&grid, &edges, 4, 0.5);
    slide_edges(&mut mesh, &edges, amount).unwrap();
    assert_eq!(places(&mesh, [5, 13]), [(1.0, 1.5), (1.0, 3.5)]);
}

#[test]
fn a_boundary_slides_inwards_only() {
    let grid = zoo::grid(3, 2);
    let rim = [0, 1, 2, 3];
    let inner = slid(&grid, &rim, 0.5);
    assert_eq!(places(&inner, rim), [(0.0, 0.5), (1.0, 0.5), (2.0, 0.5), (3.0, 0.5)]);
    assert!(slid(&grid, &rim, -0.5) == grid, "there is nothing on the other side");
    // All round: corners go across their face.
    let frame = [0, 1, 2, 3, 7, 11, 10, 9, 8, 4, 0];
    let smaller = slid(&grid, &frame, 0.5);
    assert_eq!(places(&smaller, [0, 1, 3, 11]), [(0.5, 0.5), (1.0, 0.5), (2.5, 0.5), (2.5, 1.5)]);
}

#[test]
fn a_corner_crosses_the_face_on_either_side() {
    let grid = zoo::grid(4, 4);
    // From the left edge to the middle, then up.
    let bent = [10, 11, 12, 17, 22];
    assert_eq!(places(&slid(&grid, &bent, 1.0), [11, 12, 17]), [(1.0, 3.0), (1.0, 3.0), (1.0, 3.0)]);
    assert_eq!(places(&slid(&grid, &bent, -0.5), [11, 12, 17]), [(1.0, 1.5), (2.5, 1.5), (2.5, 3.0)]);
}

#[test]
fn of_several_edges_the_most_perpendicular_counts() {
    let grid = zoo::triangle_grid(4, 4);
    let line = [10, 11, 12, 13, 14];
    let left = slid(&grid, &line, 0.5);
    assert_eq!(places(&left, [11, 12, 13]), [(1.0, 2.5), (2.0, 2.5), (3.0, 2.5)]);
    let right = slid(&grid, &line, -0.5);
    assert_eq!(places(&right, [11, 12, 13]), [(1.0, 1.5), (2.0, 1.5), (3.0, 1.5)]);
}

#[test]
fn vertices_that_slide_towards_each_other_meet() {
    let grid = zoo::grid(3, 1);
    // Three sides of the middle quad: its fourth side is the rail of both ends.
    let cup = [5, 1, 2, 6];
    let mesh = slid(&grid, &cup, 1.0);
    assert_eq!(places(&mesh, cup), [(1.5, 1.0), (1.5, 0.5), (1.5, 0.5), (1.5, 1.0)]);
    // All four: the middle of the face.
    let mesh = slid(&grid, &[5, 1, 2, 6, 5], 0.5);
    assert_eq!(places(&mesh, [5, 1, 2, 6]), [(1.25, 0.75), (1.25, 0.25), (1.75, 0.25), (1.75, 0.75)]);
}

#[test]
fn ends_of_lines_take_the_edge_beside_them() {
    let cube = zoo::cube();
    let edge = he(&cube, 0, 1).edge();
    for (amount, to) in [(1.0, [2, 3]), (-1.0, [4, 5])] {
        let mesh = slid(&cube, &[0, 1], amount);
        let ends = [0, 1].map(|at| mesh.position(v(at)));
        let expected = to.map(|at| cube.position(v(at)));
        let other = if amount > 0.0 { [4, 5] } else { [2, 3] }.map(|at| cube.position(v(at)));
        assert!(ends == expected || ends == other, "{ends:?}");
        assert_eq!(mesh.find_edge(v(0), v(1)), Some(edge));
    }
    // An edge whose ends have one other edge each, which only continues it.
    let coin = zoo::coin(7);
    assert_eq!(
        can_slide_edges(&coin, &path(&coin, &[0, 1]), 0.5),
        Err(Refusal::NoRail(he(&coin, 0, 1).edge()))
    );
    assert_eq!(
        can_slide_edges(&coin, &path(&coin, &[0, 1, 2]), 0.5),
        Ok(()),
        "the middle one crosses a face"
    );
}

#[test]
fn branches_and_bad_fields_are_refused() {
    let cube = zoo::cube();
    let star = [(0, 1), (0, 2), (0, 4)].map(|(a, b)| he(&cube, a, b).edge());
    assert_eq!(can_slide_edges(&cube, &star, 0.5), Err(Refusal::Branches(v(0))));
    assert_eq!(can_slide_edges(&cube, &star[..2], 0.5), Ok(()));
    assert_eq!(can_slide_edges(&cube, &[star[0], star[0], star[1]], 0.5), Ok(()), "given twice is given");
    for amount in [1.1, -1.5, f32::NAN, f32::INFINITY] {
        assert!(matches!(can_slide_edges(&cube, &star[..1], amount), Err(Refusal::OutOfRange { .. })));
        let vertices = can_slide_vertices(&cube, &[v(0)], Vec3::X, amount);
        assert!(matches!(vertices, Err(Refusal::OutOfRange { .. })));
    }
    assert_eq!(can_slide_vertices(&cube, &[v(0)], Vec3::ZERO, 0.5), Err(Refusal::NoDirection));
    assert_eq!(can_slide_vertices(&cube, &[], Vec3::X, 0.5), Err(Refusal::NothingGiven(Element::Vertex)));
}

#[test]
fn a_vertex_takes_the_edge_that_points_most_in_the_direction() {
    let grid = zoo::grid(3, 3);
    let slid = |direction: Vec3, amount: f32| {
        let mut mesh = grid.clone();
        let moved = slide_vertices(&mut mesh, &[v(5), v(0)], direction, amount).unwrap();
        (moved, places(&mesh, [5, 0]))
    };
    assert_eq!(slid(Vec3::new(1.0, 0.4, 0.0), 0.25), (2, [(1.25, 1.0), (0.25, 0.0)]));
    assert_eq!(slid(Vec3::new(0.3, 9.0, 5.0), 1.0), (2, [(1.0, 2.0), (0.0, 1.0)]));
    // Nothing leads down from the corner.
    assert_eq!(slid(Vec3::new(-0.1, -1.0, 0.0), 0.5), (1, [(1.0, 0.5), (0.0, 0.0)]));
    assert_eq!(slid(Vec3::new(1.0, 0.4, 0.0), -0.25), (1, [(0.75, 1.0), (0.0, 0.0)]), "the other way");
    assert_eq!(slid(Vec3::Z, 0.5), (0, [(1.0, 1.0), (0.0, 0.0)]), "no edge points out of the plane");
    assert_eq!(slid(Vec3::new(f32::MAX, 0.0, 0.0), 0.5).0, 2);
}

#[test]
fn both_sides_of_a_symmetric_mesh_are_mirror_images() {
    let mirrored = |p: Vec3| Vec3::new(p.x, 4.0 - p.y, p.z);
    for mut grid in [zoo::grid(4, 4), zoo::triangle_grid(4, 2)] {
        if grid.vertex_count() == 15 {
            // Mirror the diagonals of the lower row.
            let ends = |edge: EdgeId| grid.ends(edge).map(|at| grid.position(at));
            let is_lower = |&edge: &EdgeId| {
                let [a, b] = ends(edge);
                a.y.min(b.y) == 0.0 && (a - b).length_squared() > 1.5
            };
            let diagonals: Vec<EdgeId> = grid.edges().filter(is_lower).collect();
            assert_eq!(diagonals.len(), 4);
            diagonals.into_iter().for_each(|edge| flip_edge(&mut grid, edge).unwrap());
        }
        let rows = if grid.vertex_count() == 15 { 1.0 } else { 2.0 };
        for at in grid.vertices().collect::<Vec<_>>() {
            let p = grid.position(at);
            let up = p.y - rows;
            let bent = Vec3::new(p.x + up * up * 0.1, 2.0 + up, (p.x * 1.3).sin() + up * up * 0.3);
            grid.set_position(at, bent);
        }
        let middle: Vec<usize> =
            (0..grid.vertex_count()).filter(|&at| grid.position(v(at)).y == 2.0).collect();
        assert_eq!(middle.len(), 5);
        for amount in [0.25, 0.7, 1.0] {
            let [up, down] = [amount, -amount].map(|amount| slid(&grid, &middle, amount));
            for at in &middle {
                let [up, down] = [&up, &down].map(|mesh| mesh.position(v(*at)));
                assert!(up.distance(mirrored(down)) < 1e-5, "vertex {at} by {amount}: {up} and {down}");
            }
        }
    }
}

#[test]
fn values_follow_along_the_rails() {
    // Values that no plane describes, the same in all faces.
    let mut random = Random::new(7);
    let mut grid = zoo::grid(3, 3);
    let values: Vec<Vec2> = (0..16).map(|_| Vec2::new(random.unit(), random.unit())).collect();
    for h in grid.halfedges().collect::<Vec<_>>() {
        if grid.face_of(h).is_some() {
            grid.set(keys::CORNER_UV, h.index(), values[grid.from(h).index()]);
        }
    }
    for (at, value) in values.iter().enumerate() {
        grid.set(keys::VERTEX_COLOR, at, value.extend(0.5));
    }
    grid.set(keys::EDGE_CREASE, he(&grid, 5, 6).edge().index(), 3.0);
    let line = [4, 5, 6, 7];
    let mesh = slid(&grid, &line, 0.3);
    for at in line {
        let expected = values[at].lerp(values[at + 4], 0.3);
        for h in mesh.outgoing(v(at)).filter(|&h| mesh.face_of(h).is_some()) {
            let uv = mesh.get(keys::CORNER_UV, h.index());
            assert!(uv.distance(expected) < 1e-5, "corner {h}: {uv}, not {expected}");
        }
        let color = mesh.get(keys::VERTEX_COLOR, at);
        assert!(color.distance(expected.extend(0.5)) < 1e-5);
    }
    assert_eq!(mesh.get(keys::EDGE_CREASE, he(&mesh, 5, 6).edge().index()), 3.0);
    let mut mesh = grid.clone();
    slide_vertices(&mut mesh, &[v(5)], Vec3::X, 0.5).unwrap();
    let expected = values[5].lerp(values[6], 0.5);
    assert!(mesh.outgoing(v(5)).all(|h| mesh.get(keys::CORNER_UV, h.index()).distance(expected) < 1e-5));
}

#[test]
fn values_on_the_two_sides_of_a_seam_stay_apart() {
    // The texture's place is the mesh's; the lower row has it a tile further up.
    let mut grid = zoo::grid(3, 3);
    let shift = |face: FaceId| if face.index() < 3 { Vec2::Y } else { Vec2::ZERO };
    for h in grid.halfedges().collect::<Vec<_>>() {
        if let Some(face) = grid.face_of(h) {
            let uv = grid.position(grid.from(h)).truncate() / 3.0 + shift(face);
            grid.set(keys::CORNER_UV, h.index(), uv);
        }
    }
    for amount in [0.4, -0.4] {
        let mesh = slid(&grid, &[4, 5, 6, 7], amount);
        for f in mesh.faces() {
            for h in mesh.face_halfedges(f) {
                let expected = mesh.position(mesh.from(h)).truncate() / 3.0 + shift(f);
                assert!(mesh.get(keys::CORNER_UV, h.index()).distance(expected) < 1e-5);
            }
        }
    }
}

/// Lines of edges without branches, at random.
fn random_lines(mesh: &Mesh, random: &mut Random) -> Vec<EdgeId> {
    let mut uses = vec![0; mesh.vertex_capacity()];
    let mut edges: Vec<EdgeId> = mesh.edges().collect();
    let mut lines = Vec::new();
    let wanted = 1 + random.below(edges.len());
    while let (false, true) = (edges.is_empty(), lines.len() < wanted) {
        let edge = edges.swap_remove(random.below(edges.len()));
        let ends = mesh.ends(edge).map(VertexId::index);
        if ends.iter().all(|&end| uses[end] < 2) {
            ends.iter().for_each(|&end| uses[end] += 1);
            lines.push(edge);
        }
    }
    lines
}

/// Checks a slide: `rails` are those of the vertices that may move.
fn check_slide(start: &Mesh, rails: &[Rail], amount: f32, slide: impl Fn(&mut Mesh, f32) -> usize) {
    let mut mesh = start.clone();
    mesh.start_recording();
    let moved = slide(&mut mesh, amount);
    let journal = mesh.finish_recording();
    mesh.validate().unwrap();
    assert_eq!(moved, if amount == 0.0 { 0 } else { rails.len() });
    for at in start.vertices() {
        let (old, new) = (start.position(at), mesh.position(at));
        let mut own = rails.iter().filter(|rail| rail.vertex == at);
        let to = own.next().map_or(old, |rail| rail.to);
        assert!(own.next().is_none(), "{at} has two rails");
        assert!(
            new.distance(old.lerp(to, amount.abs())) <= 1e-5 * (1.0 + old.length() + to.length()),
            "{at} left its rail"
        );
        if amount.abs() == 1.0 {
            assert_eq!(new, to, "{at} is not at its rail's end");
        }
    }
    mesh.undo(journal);
    assert!(mesh == *start, "undo does not give the mesh back");
    slide(&mut mesh, 0.0);
    assert!(mesh == *start, "no amount changes something");
}

#[test]
fn random_lines_slide_on_all_meshes() {
    let mut random = Random::new(11);
    let mut slid = 0;
    for (name, mut mesh) in zoo::all() {
        zoo::paint(&mut mesh);
        for round in 0..60 {
            let edges = random_lines(&mesh, &mut random);
            let amount = [0.0, 1.0, -1.0, random.unit() * 2.0 - 1.0][round % 4];
            match edge_rails(&mesh, &edges) {
                Ok([left, right]) => {
                    slid += 1;
                    let rails = if amount < 0.0 { right } else { left };
                    let ends: Vec<VertexId> = edges.iter().flat_map(|&e| mesh.ends(e)).collect();
                    assert!(rails.iter().all(|rail| ends.contains(&rail.vertex)), "{name}");
                    check_slide(&mesh, &rails, amount, |mesh, amount| {
                        slide_edges(mesh, &edges, amount).unwrap()
                    });
                }
                Err(refusal) => assert!(matches!(refusal, Refusal::NoRail(_)), "{name}: {refusal}"),
            }
        }
    }
    assert!(slid > 800, "only {slid} slid");
}

#[test]
fn random_vertices_slide_on_all_meshes() {
    let mut random = Random::new(13);
    for (_, mut mesh) in zoo::all() {
        zoo::paint(&mut mesh);
        let all: Vec<VertexId> = mesh.vertices().collect();
        for round in 0..40 {
            let some: Vec<VertexId> =
                all.iter().copied().filter(|_| random.below(3) == 0).chain([all[0]]).collect();
            let direction = Vec3::from([0; 3].map(|_| random.unit() - 0.5));
            let amount = [0.0, 1.0, -1.0, random.unit() * 2.0 - 1.0][round % 4];
            let way = if amount < 0.0 { -direction } else { direction };
            let rails = vertex_rails(&mesh, &some, way).unwrap();
            check_slide(&mesh, &rails, amount, |mesh, amount| {
                slide_vertices(mesh, &some, direction, amount).unwrap()
            });
        }
    }
}

#[test]
fn a_face_with_a_hundred_thousand_sides_shrinks() {
    let n = 100_000;
    let circle = |i: usize| Vec2::from_angle(i as f32 / n as f32 * std::f32::consts::TAU).extend(0.0);
    let mut mesh = zoo::mesh((0..n).map(circle).collect(), &[(0..n as u32).collect::<Vec<u32>>()]);
    let edges: Vec<EdgeId> = mesh.edges().collect();
    let [left, right] = edge_rails(&mesh, &edges).unwrap();
    let inwards = if left.is_empty() { -0.5 } else { 0.5 };
    assert_eq!(left.len() + right.len(), n);
    slide_edges(&mut mesh, &edges, inwards).unwrap();
    assert!(mesh.vertices().all(|at| (mesh.position(at).length() - 0.5).abs() < 1e-3));
}
