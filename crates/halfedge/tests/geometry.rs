//! Bit sets, disjoint sets, loops and components, compared with slow reference implementations.

use glam::Vec3;
use halfedge::edit::{delete_faces, delete_vertices};
use halfedge::geometry::{BitSet, UnionFind};
use halfedge::{Budget, HalfedgeId, InParts, Mesh, NONE, PolygonSoup, Topology, TopologyCounter, VertexId};
use proptest::prelude::*;
use std::collections::{BTreeSet, HashSet};

proptest! {
    #[test]
    fn a_bit_set_is_a_set(steps in prop::collection::vec((any::<bool>(), 0usize..300), 0..200)) {
        let mut set = BitSet::new();
        let mut model = BTreeSet::new();
        for (add, index) in steps {
            if add {
                prop_assert_eq!(set.insert(index), model.insert(index));
            } else {
                prop_assert_eq!(set.remove(index), model.remove(&index));
            }
            prop_assert_eq!(set.len(), model.len());
            prop_assert_eq!(set.is_empty(), model.is_empty());
            prop_assert_eq!(set.largest(), model.last().copied());
        }
        prop_assert!((0..310).all(|index| set.contains(index) == model.contains(&index)));
        prop_assert_eq!(set.iter().collect::<Vec<_>>(), model.iter().copied().collect::<Vec<_>>());
        for (rank, &index) in model.iter().enumerate() {
            prop_assert_eq!((set.rank(index), set.nth(rank)), (rank, Some(index)));
        }
        prop_assert_eq!(set.nth(model.len()), None);
        for (start, end) in [(0, 0), (0, 64), (1, 63), (5, 200), (63, 65), (100, 90), (128, 1000)] {
            let inside = model.iter().filter(|index| (start..end).contains(*index)).count();
            prop_assert_eq!(set.count_in(start, end), inside, "{}..{}", start, end);
            prop_assert_eq!(BitSet::up_to(end), (0..end).collect::<BitSet>());
        }
        // Whatever room was taken.
        prop_assert_eq!(&set, &model.iter().copied().collect::<BitSet>());
        set.insert(1000);
        prop_assert_ne!(&set, &model.into_iter().collect::<BitSet>());
    }

    #[test]
    fn joined_numbers_are_one_set_named_by_its_smallest(pairs in prop::collection::vec((0u32..40, 0u32..40), 0..50)) {
        let mut sets = UnionFind::new(40);
        let mut model: Vec<u32> = (0..40).collect();
        for (a, b) in pairs {
            let (x, y) = (model[a as usize], model[b as usize]);
            prop_assert_eq!(sets.union(a, b), x != y);
            model.iter_mut().filter(|set| **set == x.max(y)).for_each(|set| *set = x.min(y));
        }
        prop_assert_eq!((0..40).map(|id| sets.find(id)).collect::<Vec<_>>(), model);
    }

    #[test]
    fn loops_and_components_are_those_of_walks(
        quads: bool,
        faces in prop::collection::vec(0u32..64, 0..50),
        vertices in prop::collection::vec(0u32..90, 0..8),
        slice in 1usize..40,
    ) {
        let mesh = holed_grid(quads, &faces, &vertices);
        let expected = walk(&mesh);
        prop_assert_eq!(mesh.topology(), expected);
        let mut counter = TopologyCounter::new(&mesh);
        let counted = (0..100_000).find_map(|_| counter.step(&mesh, &mut Budget::new(slice)));
        prop_assert_eq!(counted, Some(expected));
        let (numbers, count) = mesh.components();
        prop_assert_eq!(count, expected.components);
        // Numbered by the smallest vertex, and one over each edge.
        let mut next = 0;
        for (v, &number) in numbers.iter().enumerate() {
            let vertex = VertexId::new(v);
            prop_assert_eq!(number == NONE, !mesh.has_vertex(vertex));
            if number != NONE {
                prop_assert!(number <= next);
                next = next.max(number + 1);
                prop_assert!(mesh.neighbors(vertex).all(|w| numbers[w.index()] == number));
            }
        }
        prop_assert_eq!(next as usize, count);
        let loops = mesh.boundary_loops();
        prop_assert!(loops.is_sorted());
        prop_assert!(loops.iter().all(|&h| mesh.loop_of(h).all(|side| side >= h)));
    }
}

/// A grid of 8 x 8 faces or, if not of quads, twice as many, without some of them, with two vertices apart.
fn holed_grid(quads: bool, faces: &[u32], vertices: &[u32]) -> Mesh {
    let at = |i: u32| Vec3::new((i % 9) as f32, (i / 9) as f32, 0.0);
    let mut soup = PolygonSoup { positions: (0..83).map(at).collect(), ..PolygonSoup::default() };
    for i in (0..8).flat_map(|y| (0..8).map(move |x| y * 9 + x)) {
        let [a, b, c, d] = [i, i + 1, i + 10, i + 9];
        if quads {
            soup.push_face([a, b, c, d]);
        } else {
            soup.push_face([a, b, c]);
            soup.push_face([a, c, d]);
        }
    }
    let mut mesh = Mesh::build(soup).expect("small").mesh;
    for f in faces {
        // Some are gone already.
        let _ = mesh.face(*f).map(|f| delete_faces(&mut mesh, &[f]));
    }
    for v in vertices {
        let _ = mesh.vertex(*v).map(|v| delete_vertices(&mut mesh, &[v]));
    }
    mesh
}

fn walk(mesh: &Mesh) -> Topology {
    let mut found =
        Topology { triangles_only: mesh.faces().all(|f| mesh.face_degree(f) == 3), ..Topology::default() };
    let mut met: HashSet<HalfedgeId> = HashSet::new();
    for h in mesh.halfedges().filter(|&h| mesh.is_boundary_halfedge(h)) {
        found.boundary_halfedges += 1;
        if !met.contains(&h) {
            found.boundary_loops += 1;
            met.extend(mesh.loop_of(h));
        }
    }
    let mut met: HashSet<VertexId> = HashSet::new();
    for start in mesh.vertices() {
        let mut stack = if met.insert(start) { vec![start] } else { continue };
        found.components += 1;
        while let Some(v) = stack.pop() {
            stack.extend(mesh.neighbors(v).filter(|&w| met.insert(w)));
        }
    }
    found
}
