//! Elements by their properties, and finding them some at a time.

mod common;

use common::*;
use glam::{DVec3, Vec3};
use halfedge::geometry::BitSet;
use halfedge::{
    Budget, Color, EdgeId, Element, FaceId, HalfedgeId, InParts, Mesh, PolygonSoup, VertexId, keys,
};
use proptest::prelude::*;
use std::sync::Arc;
use surface::selecting::*;
use surface::{Shape, join_meshes};

fn found(mesh: &Mesh, kind: Element, criterion: Criterion) -> Vec<usize> {
    Finding::by(kind, criterion).finish(mesh).iter().collect()
}

fn build(positions: &[[f32; 3]], faces: &[&[u32]]) -> Mesh {
    let soup = PolygonSoup::new(positions.iter().copied().map(Vec3::from_array).collect(), faces);
    Mesh::build(soup).expect("small").mesh
}

/// Two unit squares that meet at an edge and an angle in degrees: flat at 0.
fn hinge(degrees: f32) -> Mesh {
    let (sin, cos) = degrees.to_radians().sin_cos();
    build(
        &[[0., 0., 0.], [0., 1., 0.], [-1., 0., 0.], [-1., 1., 0.], [cos, 0., sin], [cos, 1., sin]],
        &[&[0, 1, 3, 2], &[1, 0, 4, 5]],
    )
}

#[test]
fn sharp_edges_are_those_above_an_angle() {
    for degrees in [0.0_f32, 20.0, 89.0, 91.0, 170.0] {
        let mesh = hinge(degrees);
        let sharp = |limit: f64| found(&mesh, Element::Edge, Criterion::Sharp { degrees: limit });
        let angles: Vec<f64> = mesh.edges().filter_map(|e| dihedral_angle(&mesh, e)).collect();
        assert_eq!(angles.len(), 1, "one edge has two faces");
        assert!((angles[0] - f64::from(degrees)).abs() < 1e-4, "{angles:?}");
        assert!(sharp(f64::from(degrees) + 0.01).is_empty());
        assert_eq!(sharp(f64::from(degrees) - 0.01).len(), 1);
        let sides = found(&mesh, Element::Halfedge, Criterion::Sharp { degrees: f64::from(degrees) - 0.01 });
        assert_eq!(sides.len(), 2, "both half-edges of it");
    }
    assert_eq!(found(&cube(), Element::Edge, Criterion::Sharp { degrees: 89.9 }).len(), 12);
    assert!(found(&cube(), Element::Edge, Criterion::Sharp { degrees: 90.1 }).is_empty());
}

#[test]
fn a_bent_quad_is_not_planar() {
    // Folded along a diagonal, so that the planes of its triangles meet at 90 degrees: 45 from the mean.
    let bent = build(&[[0., 0., 0.], [1., 0., 1.], [1., 1., 0.], [0., 1., 1.]], &[&[0, 1, 2, 3]]);
    let normal = (Vec3::new(1., 0., 1.)).cross(Vec3::new(1., 1., 0.)).as_dvec3();
    let mean = halfedge::geometry::face_area_vector(&bent, FaceId::new(0));
    let bend = normal.angle_between(mean).to_degrees();
    let is_bent = |degrees| found(&bent, Element::Face, Criterion::NonPlanar { degrees }).len() == 1;
    assert!(is_bent(bend - 0.01) && !is_bent(bend + 0.01), "{bend}");
    for shape in ["cube", "dodecahedron", "icosahedron"] {
        let mesh = Shape::named(shape).expect("listed").build().expect("fits");
        assert!(found(&mesh, Element::Face, Criterion::NonPlanar { degrees: 0.01 }).is_empty(), "{shape}");
    }
}

#[test]
fn degenerate_faces_and_edges_have_no_size() {
    let mesh = build(
        &[[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [1., 1., 0.], [1., 1., 0.]],
        &[&[0, 1, 2], &[0, 2, 3], &[3, 2, 4]],
    );
    let zero = Criterion::Degenerate { at_most: 0.0 };
    assert_eq!(found(&mesh, Element::Face, zero), [0, 2]);
    assert_eq!(found(&mesh, Element::Edge, zero).len(), 1);
    assert_eq!(found(&mesh, Element::Halfedge, zero).len(), 2);
    assert!(found(&mesh, Element::Vertex, zero).is_empty());
    assert_eq!(found(&mesh, Element::Face, Criterion::Degenerate { at_most: 2.0 }), [0, 1, 2]);
}

#[test]
fn the_boundary_and_isolated_vertices() {
    let mesh = build(
        &[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [5., 5., 5.], [0.5, 0.5, 1.]],
        &[&[0, 1, 5], &[1, 2, 5], &[2, 3, 5], &[3, 0, 5]],
    );
    let count = |kind, criterion| found(&mesh, kind, criterion).len();
    assert_eq!(Element::ALL.map(|kind| count(kind, Criterion::Boundary)), [4, 4, 4, 4]);
    assert_eq!(found(&mesh, Element::Vertex, Criterion::Isolated), [4]);
    assert_eq!(count(Element::Face, Criterion::Isolated), 0);
    let valence = |is, than| count(Element::Vertex, Criterion::Count { is, than });
    assert_eq!(valence(Comparison::Equal, 3), 4);
    assert_eq!(valence(Comparison::More, 3), 1);
    assert_eq!(valence(Comparison::Less, 3), 1);
    assert_eq!(valence(Comparison::Different, 3), 2);
}

#[test]
fn faces_by_corners_size_side_and_colour() {
    let mut mesh = join_meshes([&cube(), &Shape::named("tetrahedron").expect("it").build().expect("fits")])
        .expect("small");
    let count = |mesh: &Mesh, criterion| found(mesh, Element::Face, criterion).len();
    let corners = |is, than| Criterion::Count { is, than };
    assert_eq!(count(&mesh, corners(Comparison::Equal, 4)), 6);
    assert_eq!(count(&mesh, corners(Comparison::Less, 4)), 4);
    assert_eq!(count(&mesh, corners(Comparison::More, 4)), 0);
    let area = surface::measure::face_area(&cube(), FaceId::new(0));
    assert_eq!(count(&cube(), Criterion::Near { size: area * 1.05, tolerance: 0.06 }), 6);
    assert_eq!(count(&cube(), Criterion::Near { size: area * 1.05, tolerance: 0.04 }), 0);
    assert_eq!(count(&cube(), Criterion::Size { is: Comparison::Less, than: area * 1.001 }), 6);
    assert_eq!(count(&cube(), Criterion::Size { is: Comparison::More, than: area * 1.001 }), 0);
    let facing = |degrees| Criterion::Facing { direction: DVec3::new(0.0, 0.0, 9.0), degrees };
    assert_eq!([1.0, 89.0, 91.0, 180.0].map(|degrees| count(&cube(), facing(degrees))), [1, 1, 5, 6]);
    assert_eq!(count(&cube(), Criterion::Facing { direction: DVec3::ZERO, degrees: 180.0 }), 0);
    mesh.set(keys::FACE_COLOR, 3, Color([100, 0, 0]));
    let red = |level, tolerance| Criterion::Colored { color: Color([level, 0, 0]), tolerance };
    assert_eq!(count(&mesh, red(100, 0.0)), 1);
    assert_eq!(count(&mesh, red(110, 0.0)), 0);
    assert_eq!(count(&mesh, red(110, 0.04)), 1);
    assert_eq!(count(&mesh, red(110, 1.0)), 10);
}

/// A mesh with gaps: some faces of two shapes, the others deleted.
fn any_mesh() -> impl Strategy<Value = Mesh> {
    (0..4_usize, prop::collection::vec(0_u32..40, 0..6)).prop_map(|(which, gone)| {
        let shape = |name| Shape::named(name).expect("listed").build().expect("fits");
        let mut mesh = match which {
            0 => grid(4),
            1 => join_meshes([&cube(), &grid(3)]).expect("small"),
            2 => shape("icosahedron"),
            _ => shape("dodecahedron"),
        };
        for face in gone.into_iter().filter_map(|f| mesh.face(f)).collect::<Vec<_>>() {
            if mesh.has_face(face) {
                let _ = mesh.transaction(|mesh| halfedge::edit::delete_faces(mesh, &[face]));
            }
        }
        mesh
    })
}

fn any_set(mesh: &Mesh, kind: Element, ids: &[u32]) -> BitSet {
    ids.iter().filter(|&&id| mesh.exists(kind, id)).map(|&id| id as usize).collect()
}

/// The faces that an element belongs to.
fn faces_of(mesh: &Mesh, kind: Element, id: usize) -> Vec<FaceId> {
    let has = |f: &FaceId| {
        let mut sides = mesh.face_halfedges(*f);
        match kind {
            Element::Vertex => sides.any(|h| mesh.from(h) == VertexId::new(id)),
            Element::Edge => sides.any(|h| h.edge().index() == id),
            Element::Halfedge => sides.any(|h| h.index() == id),
            Element::Face => f.index() == id,
        }
    };
    mesh.faces().filter(has).collect()
}

proptest! {
    #[test]
    fn some_at_a_time_finds_the_same(
        mesh in any_mesh(),
        chosen in prop::collection::vec(0_u32..90, 0..20),
        hide in prop::collection::vec(0_u32..40, 0..8),
        [from, to] in prop::array::uniform2(0..4_usize),
        which in 0..11_usize,
        part in 1..40_usize,
    ) {
        let [from, to] = [from, to].map(|at| Element::ALL[at]);
        let set = any_set(&mesh, from, &chosen);
        let hidden = Arc::new(any_set(&mesh, Element::Face, &hide));
        let mut finding = match which {
            0 => Finding::grow(from, set),
            1 => Finding::shrink(from, set),
            2 => Finding::linked(from, set),
            3 => Finding::convert(from, to, set),
            4 => Finding::expand(from, to, set),
            5 => Finding::outline(any_set(&mesh, Element::Face, &chosen)),
            6 => Finding::outside(from, set),
            7 => Finding::by(from, Criterion::Boundary),
            8 => Finding::known(from, set),
            9 => Finding::smaller_components(from),
            _ => Finding::by(from, Criterion::Count { is: Comparison::More, than: 3 }),
        };
        let kind = finding.kind();
        let all = finding.clone().finish(&mesh);
        let visible = finding.clone().shown(&hidden).finish(&mesh);
        let mut steps = 0;
        let stepped = loop {
            steps += 1;
            let mut budget = Budget::new(part);
            if let Some(found) = finding.step(&mesh, &mut budget) {
                break found;
            }
            prop_assert!(budget.is_spent());
            prop_assert!(steps < 10_000);
        };
        prop_assert_eq!(&stepped, &all);
        prop_assert!(all.iter().all(|id| mesh.exists(kind, id as u32)));
        // Hidden is what has faces and only hidden ones.
        let hidden_by_hand = |id: usize| {
            let own = faces_of(&mesh, kind, id);
            let faces = match kind {
                Element::Halfedge if own.is_empty() => faces_of(&mesh, Element::Edge, id / 2),
                _ => own,
            };
            !faces.is_empty() && faces.iter().all(|f| hidden.contains(f.index()))
        };
        let expected: BitSet = all.iter().filter(|&id| !hidden_by_hand(id)).collect();
        prop_assert_eq!(visible, expected);
    }

    #[test]
    fn smaller_components_are_all_but_the_one_with_the_most_faces(mesh in any_mesh(), more in any_mesh()) {
        let mesh = join_meshes([&mesh, &more]).expect("small");
        let (numbers, count) = mesh.components();
        let piece = |f: FaceId| numbers[mesh.from(mesh.halfedge_of(f)).index()] as usize;
        let size = |number: &usize| {
            let faces = mesh.faces().filter(|&f| piece(f) == *number).count();
            let vertices = mesh.vertices().filter(|v| numbers[v.index()] as usize == *number).count();
            (faces, vertices, std::cmp::Reverse(*number))
        };
        let largest = (0..count).max_by_key(size);
        for kind in Element::ALL {
            let of = |id: usize| match kind {
                Element::Vertex => numbers[id] as usize,
                Element::Edge => numbers[mesh.ends(EdgeId::new(id))[0].index()] as usize,
                Element::Halfedge => numbers[mesh.from(HalfedgeId::new(id)).index()] as usize,
                Element::Face => piece(FaceId::new(id)),
            };
            let all = (0..mesh.capacity(kind)).filter(|&id| mesh.exists(kind, id as u32));
            let expected: BitSet = all.filter(|&id| Some(of(id)) != largest).collect();
            prop_assert_eq!(Finding::smaller_components(kind).finish(&mesh), expected);
        }
    }

    #[test]
    fn criteria_hold_as_defined(
        mesh in any_mesh(),
        number in 0.01_f64..4.0,
    ) {
        let mesh = &mesh;
        let all = |kind| (0..mesh.capacity(kind)).filter(move |&id| mesh.exists(kind, id as u32));
        let of = |kind, id| faces_of(mesh, kind, id);
        let point = |v: VertexId| mesh.position(v).as_dvec3();
        let points = |f: FaceId| mesh.face_vertices(f).map(point).collect::<Vec<_>>();
        // Half the sum of the cross products of corners that follow each other.
        let area = |f: FaceId| {
            let points = points(f);
            let next = points.iter().cycle().skip(1);
            points.iter().zip(next).map(|(a, b)| a.cross(*b)).sum::<DVec3>() * 0.5
        };
        let length = |e: usize| mesh.vertices()
            .filter(|&v| mesh.vertex_edges(v).any(|other| other.index() == e))
            .map(point)
            .reduce(|a, b| a - b)
            .map_or(0.0, DVec3::length);
        let check = |kind, criterion, holds: &dyn Fn(usize) -> bool| {
            prop_assert_eq!(found(mesh, kind, criterion), all(kind).filter(|&id| holds(id)).collect::<Vec<_>>());
            Ok(())
        };
        let on_boundary = |e: usize| of(Element::Edge, e).len() == 1;
        check(Element::Edge, Criterion::Boundary, &on_boundary)?;
        check(Element::Halfedge, Criterion::Boundary, &|h| of(Element::Halfedge, h).is_empty())?;
        check(Element::Vertex, Criterion::Boundary, &|v| {
            all(Element::Edge).filter(|&e| on_boundary(e)).any(|e| {
                mesh.ends(halfedge::EdgeId::new(e)).contains(&VertexId::new(v))
            })
        })?;
        check(Element::Face, Criterion::Boundary, &|f| {
            all(Element::Edge).any(|e| on_boundary(e) && of(Element::Edge, e) == [FaceId::new(f)])
        })?;
        check(Element::Vertex, Criterion::Isolated, &|v| of(Element::Vertex, v).is_empty())?;
        let than = number as usize + 2;
        check(Element::Face, Criterion::Count { is: Comparison::More, than }, &|f| {
            points(FaceId::new(f)).len() > than
        })?;
        check(Element::Vertex, Criterion::Count { is: Comparison::Less, than }, &|v| {
            mesh.edges().filter(|&e| mesh.ends(e).contains(&VertexId::new(v))).count() < than
        })?;
        check(Element::Face, Criterion::Size { is: Comparison::Less, than: number }, &|f| {
            area(FaceId::new(f)).length() < number
        })?;
        check(Element::Edge, Criterion::Degenerate { at_most: number }, &|e| length(e) <= number)?;
        check(Element::Edge, Criterion::Near { size: number, tolerance: 0.3 }, &|e| {
            (length(e) / number - 1.0).abs() <= 0.3
        })?;
        check(Element::Edge, Criterion::Sharp { degrees: number * 40.0 }, &|e| match of(Element::Edge, e)[..] {
            [a, b] => area(a).normalize().dot(area(b).normalize()) < (number * 40.0).to_radians().cos(),
            _ => false,
        })?;
        let direction = DVec3::new(1.0, number, 0.5);
        check(Element::Face, Criterion::Facing { direction, degrees: number * 40.0 }, &|f| {
            area(FaceId::new(f)).normalize().dot(direction.normalize()) >= (number * 40.0).to_radians().cos()
        })?;
    }
}
