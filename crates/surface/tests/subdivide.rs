//! Subdivision against exact results, by hand and by property.

mod common;

use common::*;
use fixtures::{fixture, shared};
use glam::{DVec3, Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, Mesh, VertexId};
use proptest::prelude::*;
use std::ops::ControlFlow;
use std::path::Path;
use surface::measure::{surface_area, volume};
use surface::*;

fixtures::shared_tests!(models_subdivide_as_in_opensubdiv);

fn cc(mesh: &Mesh, levels: u32, boundary: BoundaryRule) -> Mesh {
    let options = CatmullClark { levels, boundary, ..CatmullClark::default() };
    subdivide_catmull_clark(mesh, &options, &mut never_cancel).expect("fits")
}

fn lp(mesh: &Mesh, levels: u32) -> Mesh {
    subdivide_loop(mesh, &Loop { levels, ..Loop::default() }, &mut never_cancel).expect("triangles")
}

/// Checks counts, and that points are within 1e-6 of the diagonal in both directions.
fn assert_equals_reference(result: &Mesh, reference: &Path) {
    result.validate().expect("valid");
    let (positions, faces) = read_obj(reference);
    let reference = reference.display();
    assert_eq!((result.vertex_count(), result.face_count()), (positions.len(), faces.len()), "{reference}");
    let ours = points(result);
    let error = farthest(&ours, &positions).max(farthest(&positions, &ours)) / diagonal(&positions);
    assert!(error < 1e-6, "{reference}: {error:e}");
}

#[test]
fn catmull_clark_equals_opensubdiv() {
    for (name, suffix, boundary, levels) in [
        ("cube", "", BoundaryRule::EdgeOnly, 3),
        ("grid4_open", "_edgeonly", BoundaryRule::EdgeOnly, 3),
        ("grid4_open", "_edgecorner", BoundaryRule::EdgeAndCorner, 3),
        ("prism5_ngon", "", BoundaryRule::EdgeOnly, 3),
        ("prism5_ngon", "", BoundaryRule::EdgeAndCorner, 3),
        ("spotctl", "", BoundaryRule::EdgeOnly, 1),
    ] {
        let input = load(&fixture(&format!("opensubdiv/in/{name}.obj")));
        for level in 1..=levels {
            assert_equals_reference(
                &cc(&input, level, boundary),
                &fixture(&format!("opensubdiv/cc/{name}{suffix}_L{level}.obj")),
            );
        }
    }
}

#[test]
fn loop_equals_opensubdiv() {
    for (name, levels) in [("tetrahedron", 2), ("octahedron", 3), ("disc7_open", 3)] {
        let input = load(&fixture(&format!("opensubdiv/in/{name}.obj")));
        for level in 1..=levels {
            assert_equals_reference(
                &lp(&input, level),
                &fixture(&format!("opensubdiv/loop/{name}_L{level}.obj")),
            );
        }
    }
}

fn models_subdivide_as_in_opensubdiv() {
    let spot = load(&shared("references/in/spotctl.obj"));
    assert_equals_reference(&cc(&spot, 2, BoundaryRule::EdgeOnly), &shared("references/cc/spotctl_L2.obj"));
    let bunny = load(&shared("references/in/bunny_small.obj"));
    assert_equals_reference(&lp(&bunny, 1), &shared("references/loop/bunny_small_L1.obj"));
}

#[test]
fn creases_equal_opensubdiv() {
    let mut input = load(&fixture("opensubdiv/in/cube.obj"));
    for (a, b) in [(0, 1), (1, 3), (3, 2), (2, 0)] {
        let e = input.find_edge(VertexId::new(a), VertexId::new(b)).expect("edge");
        input.set(keys::EDGE_CREASE, e.index(), 2.0);
    }
    for level in 1..=3 {
        assert_equals_reference(
            &cc(&input, level, BoundaryRule::EdgeOnly),
            &fixture(&format!("opensubdiv/cc/cube_semisharp2_L{level}.obj")),
        );
    }
}

fn at(mesh: &Mesh, v: usize) -> DVec3 {
    mesh.position(VertexId::new(v)).as_dvec3()
}

fn assert_near(a: DVec3, b: DVec3) {
    assert!(a.distance(b) < 1e-6, "{a} is not {b}");
}

#[test]
fn a_cube_by_hand() {
    let input = cube();
    let result = cc(&input, 1, BoundaryRule::EdgeOnly);
    result.validate().expect("valid");
    assert_eq!((result.vertex_count(), result.edge_count(), result.face_count()), (26, 48, 24));
    // P/3 + (3 mean of neighbours)/9 + (3 mean of centroids)/9.
    assert_near(at(&result, 0), DVec3::splat(-5.0 / 9.0));
    for e in input.edges() {
        let [a, b] = input.ends(e).map(|v| input.position(v).as_dvec3());
        assert_near(at(&result, 8 + e.index()), (a + b) * 0.375);
    }
    let smoothed = subdivide_catmull_clark(
        &input,
        &CatmullClark { vertex_rule: VertexRule::SmoothedMidpoints, ..CatmullClark::default() },
        &mut never_cancel,
    )
    .expect("fits");
    // P/3 + 1/9 of three edge points (-3/4, -3/4, 0) and three centroids (-1, 0, 0).
    assert_near(at(&smoothed, 0), DVec3::splat(-1.0 / 3.0 - 1.5 / 9.0 - 1.0 / 9.0));
}

#[test]
fn fractional_sharpness_mixes_the_rules() {
    let smooth = cc(&cube(), 1, BoundaryRule::EdgeOnly);
    let mut input = cube();
    let e = input.find_edge(VertexId::new(0), VertexId::new(1)).expect("edge");
    input.set(keys::EDGE_CREASE, e.index(), 0.25);
    let edge_point = 8 + e.index();
    let result = cc(&input, 1, BoundaryRule::EdgeOnly);
    let [a, b] = input.ends(e).map(|v| input.position(v).as_dvec3());
    assert_near(at(&result, edge_point), (a + b) * 0.125 + at(&smooth, edge_point) * 0.75);
    // One sharp edge at a vertex makes a dart, which follows the smooth rule.
    assert_near(at(&result, 0), at(&smooth, 0));
    assert!(result.attribute(keys::EDGE_CREASE).is_none());

    // Two sharp edges at vertex 0, one of them only for half of this level: crease mixed with dart.
    let f = input.find_edge(VertexId::new(0), VertexId::new(2)).expect("edge");
    input.set(keys::EDGE_CREASE, e.index(), 0.5);
    input.set(keys::EDGE_CREASE, f.index(), 3.0);
    let result = cc(&input, 1, BoundaryRule::EdgeOnly);
    let crease = at(&input, 0) * 0.75 + (at(&input, 1) + at(&input, 2)) * 0.125;
    assert_near(at(&result, 0), (crease + at(&smooth, 0)) * 0.5);

    // A corner of sharpness 0.4 holds 0.4 of the vertex; sharpness above 1 all of it.
    let mut input = cube();
    input.set(keys::VERTEX_CREASE, 0, 0.4);
    input.set(keys::VERTEX_CREASE, 7, 1.5);
    let result = cc(&input, 1, BoundaryRule::EdgeOnly);
    assert_near(at(&result, 0), at(&input, 0) * 0.4 + at(&smooth, 0) * 0.6);
    assert_near(at(&result, 7), at(&input, 7));
    assert_eq!(result.get(keys::VERTEX_CREASE, 7), 0.5);
    assert_eq!(result.get(keys::VERTEX_CREASE, 8), 0.0);
}

#[test]
fn infinite_creases_keep_a_cube_a_cube() {
    for (loops, infinite) in [(false, 10.0), (false, 12.5), (true, 10.0)] {
        let mut input = if loops { tetrahedron() } else { cube() };
        let edges: Vec<_> = input.edges().collect();
        for e in edges {
            input.set(keys::EDGE_CREASE, e.index(), infinite);
        }
        let before = points(&input);
        let result = if loops { lp(&input, 3) } else { cc(&input, 3, BoundaryRule::EdgeOnly) };
        result.validate().expect("valid");
        assert_eq!(&points(&result)[..before.len()], &before[..], "corners of three creases stay");
        let creased = result.attribute(keys::EDGE_CREASE).expect("kept");
        assert_eq!(creased.iter().filter(|&&s| s == infinite).count(), input.edge_count() * 8);
        assert_eq!(
            creased.iter().filter(|&&s| s == 0.0).count(),
            result.edge_count() - input.edge_count() * 8
        );
    }
}

#[test]
fn loop_weights_by_hand() {
    let input = tetrahedron();
    let options = Loop { weights: LoopWeights::Warren, ..Loop::default() };
    let warren = subdivide_loop(&input, &options, &mut never_cancel).expect("triangles");
    // 7/16 P + 3/16 of three neighbours that sum to -P.
    assert_near(at(&warren, 0), at(&input, 0) * 0.25);
    // Loop at valence 3: cos is -1/2, beta (5/8 - 1/16) / 3 = 3/16: the same.
    assert_near(at(&lp(&input, 1), 0), at(&input, 0) * 0.25);
    let edge = input.find_edge(VertexId::new(0), VertexId::new(1)).expect("edge");
    // 3/8 of the ends, 1/8 of the other two, whose sum is minus the ends'.
    assert_near(at(&warren, 4 + edge.index()), (at(&input, 0) + at(&input, 1)) * 0.25);
    assert_eq!((warren.vertex_count(), warren.edge_count(), warren.face_count()), (10, 24, 16));
}

#[test]
fn loop_refuses_triangles_that_meet_twice() {
    let pair = mesh(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[&[0, 1, 2], &[2, 1, 0]]);
    let refused =
        subdivide_loop(&pair, &Loop::default(), &mut never_cancel).expect_err("would join midpoints twice");
    assert!(refused.to_string().contains("meet along both edges of vertex"), "{refused}");
    // At a corner of the boundary two edges are not between the same triangles.
    let fold = mesh(
        &[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]],
        &[&[0, 1, 2], &[1, 0, 3], &[0, 2, 4]],
    );
    assert_eq!(lp(&fold, 1).face_count(), 12);
}

#[test]
fn a_flat_grid_stays_flat_and_linear_keeps_its_outline() {
    let input = grid(3);
    let linear = subdivide_linear(&input, &Linear { levels: 2 }, &mut never_cancel).expect("fits");
    linear.validate().expect("valid");
    assert_eq!(linear.face_count(), 9 * 16);
    let mut found = points(&linear);
    found.sort_by(|a, b| (a.y, a.x).partial_cmp(&(b.y, b.x)).expect("finite"));
    let expected: Vec<DVec3> =
        (0..13 * 13).map(|i| DVec3::new(f64::from(i % 13), f64::from(i / 13), 0.0) / 4.0).collect();
    assert_eq!(found, expected);
    assert!(points(&cc(&input, 2, BoundaryRule::EdgeOnly)).iter().all(|p| p.z == 0.0));
    // A corner with one face: smoothed along its two boundary edges, or held.
    assert_near(at(&cc(&input, 1, BoundaryRule::EdgeOnly), 0), DVec3::new(0.125, 0.125, 0.0));
    assert_near(at(&cc(&input, 1, BoundaryRule::EdgeAndCorner), 0), DVec3::ZERO);
}

#[test]
fn attributes_are_carried_to_the_children() {
    let mut input = grid(2);
    input.set(keys::FACE_COLOR, 1, Color([255, 0, 0]));
    let mut groups = Column::with_values(keys::FACE_GROUP, vec![0, 1, 0, 1]);
    groups.labels = vec!["left".to_owned(), "right".to_owned()];
    input.insert_column(Element::Face, groups);
    let halfedges: Vec<_> = input.halfedges().collect();
    for h in halfedges {
        if !input.is_boundary_halfedge(h) {
            let p = input.position(input.from(h));
            input.set(keys::CORNER_UV, h.index(), Vec2::new(p.x, p.y));
            input.set(keys::CORNER_NORMAL, h.index(), Vec3::Z);
        }
    }
    input.set(keys::VERTEX_COLOR, 0, Vec3::ONE);
    let linear = subdivide_linear(&input, &Linear { levels: 2 }, &mut never_cancel).expect("fits");
    linear.validate().expect("valid");
    for f in linear.faces() {
        let center: Vec3 = linear.face_vertices(f).map(|v| linear.position(v)).sum::<Vec3>() / 4.0;
        let right = center.x > 1.0;
        let red = right && center.y < 1.0;
        assert_eq!(linear.get(keys::FACE_COLOR, f.index()) == Color([255, 0, 0]), red);
        assert_eq!(linear.get(keys::FACE_GROUP, f.index()), u32::from(right));
        for h in linear.face_halfedges(f) {
            let p = linear.position(linear.from(h));
            assert_eq!(linear.get(keys::CORNER_UV, h.index()), Vec2::new(p.x, p.y));
            assert_eq!(linear.get(keys::CORNER_NORMAL, h.index()), Vec3::Z);
        }
    }
    let labels = &linear.column(Element::Face, "group").expect("kept").labels;
    assert_eq!(labels, &["left", "right"]);
    for h in linear.halfedges().filter(|&h| linear.is_boundary_halfedge(h)) {
        assert!(linear.get(keys::CORNER_UV, h.index()).is_nan());
    }
    let smooth = cc(&input, 1, BoundaryRule::EdgeOnly);
    assert!(smooth.attribute(keys::CORNER_NORMAL).is_none(), "no longer fits");
    assert_eq!(smooth.get(keys::VERTEX_COLOR, 0), Vec3::ONE);
}

#[test]
fn refuses_bad_meshes_and_stops_when_cancelled() {
    let input = cube();
    let refused = subdivide_catmull_clark(
        &input,
        &CatmullClark { levels: 12, ..CatmullClark::default() },
        &mut never_cancel,
    );
    assert_eq!(refused, Err(SurfaceError::TooManyFaces { faces: 24 << 22, limit: MAX_SUBDIVIDED_FACES }));
    let refused = subdivide_linear(&input, &Linear { levels: u32::MAX }, &mut never_cancel);
    assert!(matches!(refused, Err(SurfaceError::TooManyFaces { .. })));
    let refused = subdivide_loop(&input, &Loop::default(), &mut never_cancel).expect_err("quads");
    assert_eq!(
        refused.to_string(),
        "face 0 has 4 corners; this works on triangles only, so triangulate the faces first"
    );
    let mut asked = 0;
    let mut stop = |_: f32| {
        asked += 1;
        if asked > 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let options = CatmullClark { levels: 3, ..CatmullClark::default() };
    assert_eq!(subdivide_catmull_clark(&input, &options, &mut stop), Err(SurfaceError::Cancelled));
    let empty = Mesh::new();
    assert_eq!(cc(&empty, 2, BoundaryRule::EdgeOnly), empty);
    assert_eq!(lp(&empty, 2), empty);
    assert_eq!(cc(&input, 0, BoundaryRule::EdgeOnly), input);
}

/// Checks that a split gives a valid mesh with the same components, boundary loops and Euler characteristic, and
/// with the counts that follow from the parent's.
fn assert_split_of(parent: &Mesh, child: &Mesh, quads: bool) {
    child.validate().expect("valid");
    assert_eq!(child.euler_characteristic(), parent.euler_characteristic());
    assert_eq!(child.boundary_loops().len(), parent.boundary_loops().len());
    assert_eq!(child.components().1, parent.components().1);
    let corners: usize = parent.faces().map(|f| parent.face_degree(f)).sum();
    let (v, e, f) = (parent.vertex_count(), parent.edge_count(), parent.face_count());
    let expected = if quads { (v + e + f, 2 * e + corners, corners) } else { (v + e, 2 * e + 3 * f, 4 * f) };
    assert_eq!((child.vertex_count(), child.edge_count(), child.face_count()), expected);
    assert!(child.is_compact());
    assert!(child.faces().all(|f| child.face_degree(f) == if quads { 4 } else { 3 }));
}

/// Gives some edges and vertices a sharpness.
fn sharpen(mesh: &mut Mesh, sharpness: &[f32]) {
    let mut values = sharpness.iter().cycle().map(|&s| if s < 0.0 { 0.0 } else { s });
    for e in mesh.edges().collect::<Vec<_>>() {
        mesh.set(keys::EDGE_CREASE, e.index(), values.next().unwrap_or(0.0));
    }
    for v in mesh.vertices().collect::<Vec<_>>() {
        let value = values.next().unwrap_or(0.0) - 3.0;
        mesh.set(keys::VERTEX_CREASE, v.index(), value.max(0.0));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn catmull_clark_splits_any_polygons(
        mesh in random_mesh(false),
        sharpness in prop::collection::vec(-8f32..4.0, 0..7),
        corner in any::<bool>(),
        smoothed in any::<bool>(),
        shift in -2f32..2.0,
    ) {
        let mut mesh = mesh;
        sharpen(&mut mesh, &sharpness);
        let options = CatmullClark {
            levels: 1,
            boundary: if corner { BoundaryRule::EdgeAndCorner } else { BoundaryRule::EdgeOnly },
            vertex_rule: if smoothed { VertexRule::SmoothedMidpoints } else { VertexRule::Standard },
        };
        let once = subdivide_catmull_clark(&mesh, &options, &mut never_cancel).expect("fits");
        assert_split_of(&mesh, &once, true);
        // Two levels are one level twice, creases included.
        let twice = subdivide_catmull_clark(&once, &options, &mut never_cancel).expect("fits");
        let both = CatmullClark { levels: 2, ..options };
        prop_assert_eq!(&twice, &subdivide_catmull_clark(&mesh, &both, &mut never_cancel).expect("fits"));
        assert_split_of(&once, &twice, true);
        // All weights sum to one: a moved mesh gives the moved result.
        let offset = Vec3::new(shift, -shift, 2.0 * shift);
        let mut moved = mesh.clone();
        moved.set_positions(mesh.positions().iter().map(|&p| p + offset).collect()).expect("as long");
        let moved = subdivide_catmull_clark(&moved, &options, &mut never_cancel).expect("fits");
        for (a, b) in once.positions().iter().zip(moved.positions()) {
            prop_assert!((*a + offset).distance(*b) < 1e-4);
        }
        // Old vertices and edge points of boundary edges stay within the parent's box.
        let (min, max) = mesh.positions().iter().fold(
            (Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), &p| (min.min(p), max.max(p)));
        prop_assert!(once.positions().iter().all(|p| p.cmpge(min - 1e-4).all() && p.cmple(max + 1e-4).all()));
    }

    #[test]
    fn loop_splits_any_triangles(
        mesh in random_mesh(true),
        sharpness in prop::collection::vec(-8f32..4.0, 0..7),
        warren in any::<bool>(),
    ) {
        let mut mesh = mesh;
        sharpen(&mut mesh, &sharpness);
        let weights = if warren { LoopWeights::Warren } else { LoopWeights::Loop };
        let options = Loop { weights, ..Loop::default() };
        let once = subdivide_loop(&mesh, &options, &mut never_cancel).expect("triangles");
        assert_split_of(&mesh, &once, false);
        let twice = subdivide_loop(&once, &options, &mut never_cancel).expect("triangles");
        prop_assert_eq!(&twice, &subdivide_loop(&mesh, &Loop { levels: 2, ..options }, &mut never_cancel).expect("triangles"));
    }

    #[test]
    fn linear_keeps_vertices(mesh in random_mesh(false)) {
        let result = subdivide_linear(&mesh, &Linear { levels: 1 }, &mut never_cancel).expect("fits");
        assert_split_of(&mesh, &result, true);
        prop_assert_eq!(&result.positions()[..mesh.vertex_count()], mesh.positions());
    }
    /// Flat faces are only divided.
    #[test]
    fn linear_keeps_area_and_volume(mesh in random_mesh(true), levels in 1u32..3) {
        let result = subdivide_linear(&mesh, &Linear { levels }, &mut never_cancel).expect("fits");
        let (before, after) = (surface_area(&mesh), surface_area(&result));
        prop_assert!((after - before).abs() <= 1e-5 * before, "area from {} to {}", before, after);
        let change = (volume(&result) - volume(&mesh)).abs();
        prop_assert!(change <= 1e-5 * before, "volume by {}, of area {}", change, before);
    }
}
