//! The vertex streams: correct for a mesh, the same after edits as after a rebuild, and cheap to update.

mod support;

use glam::{Vec3, vec3};
use halfedge::attribute::Column;
use halfedge::edit::{Connect, Triangulation, split_edge, triangulate_face};
use halfedge::{Budget, Color, EdgeId, FaceId, Mesh, NONE, PolygonSoup, Touched, VertexId, keys};
use proptest::prelude::*;
use std::sync::Arc;
use support::{cube, grid, mesh, paint, sphere, torus};
use viewport::buffers::{Buffers, Corners, Sink, TRIANGLE_BYTES};
use viewport::{ColorBy, Coloring, Legend, MaterialLook, Materials, Ramp, Shading, Texture};

/// The GPU's side as plain arrays.
#[derive(Clone, Default)]
struct Mirror {
    corners: Corners,
    written: usize,
    resets: usize,
}

impl Sink for Mirror {
    fn reset(&mut self, _triangles: u32, _with_uvs: bool) {
        self.corners = Corners::default();
        self.resets += 1;
    }

    fn write(&mut self, first_triangle: u32, corners: &Corners) {
        let start = first_triangle as usize * 3;
        let end = start + corners.positions.len();
        let all = &mut self.corners;
        if all.positions.len() < end {
            all.positions.resize(end, [f32::NAN; 3]);
            all.normals.resize(end, [0; 4]);
            all.colors.resize(end, [0; 4]);
        }
        if !corners.uvs.is_empty() {
            all.uvs.resize(all.positions.len(), [f32::NAN; 2]);
            all.uvs[start..end].copy_from_slice(&corners.uvs);
        }
        all.positions[start..end].copy_from_slice(&corners.positions);
        all.normals[start..end].copy_from_slice(&corners.normals);
        all.colors[start..end].copy_from_slice(&corners.colors);
        self.written += corners.triangles() * TRIANGLE_BYTES;
    }
}

type Triangle = [([f32; 3], [i16; 4], [u8; 4]); 3];

impl Mirror {
    fn triangle(&self, t: u32) -> Triangle {
        std::array::from_fn(|i| {
            let at = t as usize * 3 + i;
            (self.corners.positions[at], self.corners.normals[at], self.corners.colors[at])
        })
    }
}

fn of_face(buffers: &Buffers, mirror: &Mirror, face: FaceId) -> Vec<Triangle> {
    let range = buffers.range(face);
    (range.first..range.first + range.count).map(|t| mirror.triangle(t)).collect()
}

fn uvs_of_face<'m>(buffers: &Buffers, mirror: &'m Mirror, face: FaceId) -> &'m [[f32; 2]] {
    let range = buffers.range(face);
    let corners = range.first as usize * 3..(range.first + range.count) as usize * 3;
    if mirror.corners.uvs.is_empty() { &[] } else { &mirror.corners.uvs[corners] }
}

/// Checks that each face has the triangles of a rebuild, that no two faces share one, and that no other triangle
/// has an area.
fn assert_as_rebuilt(mesh: &Mesh, buffers: &Buffers, mirror: &Mirror) {
    let mut fresh = Buffers::default();
    let mut expected = Mirror::default();
    fresh.set_hidden(buffers.hidden());
    fresh.rebuild(mesh, buffers.origin(), buffers.shading(), buffers.coloring().clone(), &mut expected);
    let mut owned = vec![false; buffers.triangles() as usize];
    for face in mesh.faces() {
        assert_eq!(of_face(buffers, mirror, face), of_face(&fresh, &expected, face), "{face}");
        assert_eq!(uvs_of_face(buffers, mirror, face), uvs_of_face(&fresh, &expected, face), "{face}");
        let range = buffers.range(face);
        let is_hidden = buffers.hidden().contains(face.index());
        assert_eq!(range.count as usize, if is_hidden { 0 } else { mesh.face_degree(face) - 2 }, "{face}");
        for t in range.first..range.first + range.count {
            assert!(!std::mem::replace(&mut owned[t as usize], true), "triangle {t} twice");
        }
    }
    for (t, _) in owned.iter().enumerate().filter(|(_, owned)| !**owned) {
        let [a, b, c] = mirror.triangle(t as u32).map(|corner| corner.0);
        assert!(a == b && b == c, "stray triangle {t}");
    }
}

fn rebuilt(mesh: &Mesh, shading: Shading) -> (Buffers, Mirror) {
    rebuilt_colored(mesh, shading, ColorBy::Paint)
}

fn rebuilt_colored(mesh: &Mesh, shading: Shading, by: ColorBy) -> (Buffers, Mirror) {
    let mut buffers = Buffers::default();
    let mut mirror = Mirror::default();
    let coloring = Coloring::new(mesh, by, false, &Arc::default());
    buffers.rebuild(mesh, Vec3::ZERO, shading, coloring, &mut mirror);
    mirror.written = 0;
    (buffers, mirror)
}

fn touched(mesh: &mut Mesh, edit: impl FnOnce(&mut Mesh)) -> Touched {
    mesh.start_recording();
    edit(mesh);
    mesh.finish_recording().touched()
}

#[test]
fn a_quad_has_two_triangles_with_its_colour_normal_and_edges() {
    let mut square =
        mesh(vec![vec3(0., 0., 0.), vec3(2., 0., 0.), vec3(2., 2., 0.), vec3(0., 2., 0.)], &[[0, 1, 2, 3]]);
    paint(&mut square, 0, [9, 8, 7]);
    let mut buffers = Buffers::default();
    let mut mirror = Mirror::default();
    buffers.rebuild(&square, Vec3::ONE, Shading::Flat, Coloring::default(), &mut mirror);
    let up = [0, 0, 32767, 0];
    // The first triangle's last side and the second's first are the diagonal.
    assert_eq!(
        mirror.triangle(0),
        [[-1., -1., -1.], [1., -1., -1.], [1., 1., -1.]].map(|p| (p, up, [9, 8, 7, 0b011]))
    );
    assert_eq!(
        mirror.triangle(1),
        [[-1., -1., -1.], [1., 1., -1.], [-1., 1., -1.]].map(|p| (p, up, [9, 8, 7, 0b110]))
    );
    assert_eq!(buffers.triangles(), 2);
}

#[test]
fn each_edge_of_a_face_is_marked_on_one_side_of_its_triangles() {
    // A concave polygon of twelve corners.
    let points: Vec<Vec3> = (0..12)
        .map(|i| {
            let angle = i as f32 / 12.0 * std::f32::consts::TAU;
            let r = if i % 2 == 0 { 2.0 } else { 0.7 };
            vec3(angle.cos() * r, 0.0, -angle.sin() * r)
        })
        .collect();
    let star = mesh(points.clone(), &[(0..12).collect::<Vec<u32>>()]);
    let (buffers, mirror) = rebuilt(&star, Shading::Flat);
    let mut sides = Vec::new();
    for triangle in of_face(&buffers, &mirror, FaceId::new(0)) {
        for i in 0..3 {
            if triangle[i].2[3] & (1 << i) != 0 {
                let at = |p: [f32; 3]| points.iter().position(|q| q.to_array() == p).expect("a corner");
                sides.push((at(triangle[i].0), at(triangle[(i + 1) % 3].0)));
            }
        }
    }
    sides.sort_unstable();
    assert_eq!(sides, (0..12).map(|i| (i, (i + 1) % 12)).collect::<Vec<_>>());
}

#[test]
fn smooth_corners_have_area_weighted_vertex_normals() {
    let cube = cube();
    let (_, mirror) = rebuilt(&cube, Shading::Smooth);
    // Three squares of one size meet at each corner: its normal is along the diagonal.
    for (position, normal) in mirror.corners.positions.iter().zip(&mirror.corners.normals) {
        let expected = (Vec3::from(*position).normalize() * 32767.0).round().to_array().map(|c| c as i16);
        assert_eq!(normal[..3], expected);
    }
}

/// A strip of squares, each turned against the one before by an angle, about the y axis.
fn bent_strip(degrees: &[f32]) -> Mesh {
    let (mut at, mut direction) = (Vec3::ZERO, 0.0_f32);
    let mut columns = vec![at];
    for turn in std::iter::once(&0.0).chain(degrees) {
        direction += turn.to_radians();
        at += vec3(direction.cos(), 0.0, -direction.sin());
        columns.push(at);
    }
    let positions = columns.iter().flat_map(|p| [*p, *p + Vec3::Y]).collect();
    let quad = |i: u32| [2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1];
    mesh(positions, &(0..columns.len() as u32 - 1).map(quad).collect::<Vec<_>>())
}

#[test]
fn automatic_smoothing_keeps_edges_hard_above_its_angle() {
    let strip = bent_strip(&[20.0, 40.0, 29.0]);
    let at_edge = |shading: Shading, edge: u32, face: u32| {
        let (buffers, mirror) = rebuilt(&strip, shading);
        let seam = strip.position(VertexId::new(2 * edge as usize + 2)).to_array();
        let corners = of_face(&buffers, &mirror, FaceId::new(face as usize));
        let normal = corners.iter().flatten().find(|corner| corner.0 == seam).expect("a corner").1;
        vec3(normal[0].into(), normal[1].into(), normal[2].into()) / 32767.0
    };
    for (edge, degrees) in [(0, 20.0_f32), (1, 40.0), (2, 29.0)] {
        let [a, b] = [at_edge(Shading::Auto(30.0), edge, edge), at_edge(Shading::Auto(30.0), edge, edge + 1)];
        let apart = a.dot(b).clamp(-1.0, 1.0).acos().to_degrees();
        let expected = if degrees < 30.0 { 0.0 } else { degrees };
        assert!((apart - expected).abs() < 0.5, "{degrees}: {apart}");
        let smooth = [at_edge(Shading::Smooth, edge, edge), at_edge(Shading::Smooth, edge, edge + 1)];
        assert_eq!(smooth[0], smooth[1]);
    }
    // A crease that ends: around its end the faces are one, as they are without a crease.
    let cube = cube();
    let (_, hard) = rebuilt(&cube, Shading::Auto(89.0));
    assert!(hard.corners.normals == rebuilt(&cube, Shading::Flat).1.corners.normals);
    let (_, soft) = rebuilt(&cube, Shading::Auto(91.0));
    assert!(soft.corners.normals == rebuilt(&cube, Shading::Smooth).1.corners.normals);
}

/// Without hard edges automatic smoothing is smooth shading, and at an angle of 0 it is flat.
#[test]
fn automatic_smoothing_is_between_flat_and_smooth() {
    let ball = sphere(9, 7);
    let normals = |shading| rebuilt(&ball, shading).1.corners.normals;
    for (extreme, same) in [(Shading::Auto(180.0), Shading::Smooth), (Shading::Auto(0.0), Shading::Flat)] {
        for (a, b) in normals(extreme).into_iter().zip(normals(same)) {
            assert!((0..3).all(|i| a[i].abs_diff(b[i]) <= 1), "{extreme:?}: {a:?} {b:?}");
        }
    }
}

#[test]
fn painted_faces_show_their_paint_and_others_their_vertices_colours() {
    let (red, blue, kd) = (Color([250, 0, 0]), Vec3::new(0.0, 0.0, 1.0), Color([90, 91, 92]));
    let plane = grid(3, 1, false);
    let faces: Vec<[u32; 4]> = (0..3).map(|i| [i, i + 1, i + 5, i + 4]).collect();
    let mut soup = PolygonSoup::new(plane.positions().to_vec(), &faces);
    let mut materials = Column::with_values(keys::FACE_MATERIAL, vec![NONE, 0, NONE]);
    materials.labels.push("stone".into());
    soup.face_columns = vec![materials];
    let mut plane = Mesh::build(soup).expect("a plane").mesh;
    for v in 0..4 {
        plane.set(keys::VERTEX_COLOR, v, blue);
    }
    plane.set(keys::FACE_COLOR, 0, red);
    plane.set(keys::FACE_COLOR, 1, kd);
    let grey = Color::UNPAINTED.0;
    let shown = |by, materials: &Arc<Materials>| -> Vec<Vec<[u8; 3]>> {
        let (mut buffers, mut mirror) = (Buffers::default(), Mirror::default());
        let coloring = Coloring::new(&plane, by, false, materials);
        buffers.rebuild(&plane, Vec3::ZERO, Shading::Flat, coloring, &mut mirror);
        let colors = |f: FaceId| {
            let corners = of_face(&buffers, &mirror, f).into_iter().flatten();
            let mut colors: Vec<_> = corners.map(|(.., [r, g, b, _])| [r, g, b]).collect();
            colors.sort_unstable();
            colors.dedup();
            colors
        };
        plane.faces().map(colors).collect()
    };
    let stone = MaterialLook { name: "stone".to_owned(), color: Some(kd), texture: None };
    let stone = Arc::new(Materials::new([stone]));
    let blue = [0, 0, 255];
    // Only the lower four vertices have colours.
    assert_eq!(shown(ColorBy::Paint, &stone), [vec![red.0], vec![blue, kd.0], vec![blue, grey]]);
    assert_eq!(
        shown(ColorBy::Paint, &Arc::default()),
        [vec![red.0], vec![kd.0], vec![blue, grey]],
        "a colour that isn't its material's is paint"
    );
    assert_eq!(shown(ColorBy::Face, &stone), [vec![red.0], vec![kd.0], vec![grey]]);
    assert_eq!(shown(ColorBy::Vertex, &stone), [vec![blue, grey], vec![blue, grey], vec![blue, grey]]);
    assert_eq!(shown(ColorBy::Uniform, &stone), [vec![grey], vec![grey], vec![grey]]);
}

#[test]
fn curvature_is_measured_in_parts_and_coloured_by_its_sign() {
    let torus = torus(24, 12);
    let colors = |by| -> Vec<([f32; 3], [u8; 4])> {
        let (_, mirror) = rebuilt_colored(&torus, Shading::Flat, by);
        mirror.corners.positions.into_iter().zip(mirror.corners.colors).collect()
    };
    for ([x, _, z], [r, _, b, _]) in colors(ColorBy::GaussianCurvature) {
        let from_axis = x.hypot(z);
        if from_axis > 1.1 {
            assert!(r > b + 20, "the outside bulges: {r} {b}");
        } else if from_axis < 0.9 {
            assert!(b > r + 20, "the inside is a saddle: {r} {b}");
        }
    }
    for (_, [r, _, b, _]) in colors(ColorBy::MeanCurvature) {
        assert!(r > b, "a tube thinner than its hole bulges everywhere");
    }

    let (mut buffers, mut mirror) = (Buffers::default(), Mirror::default());
    let coloring = Coloring::new(&torus, ColorBy::GaussianCurvature, false, &Arc::default());
    let mut rebuilding = buffers.begin_rebuild(&torus, Vec3::ZERO, Shading::Flat, coloring);
    assert_eq!(buffers.coloring().legend(), None, "nothing is measured yet");
    let mut parts = 1;
    while buffers.rebuild_faces(&torus, &mut rebuilding, &mut Budget::new(100), &mut mirror) {
        parts += 1;
    }
    assert!(parts >= 288 * 4 / 100, "{parts}");
    let whole = rebuilt_colored(&torus, Shading::Flat, ColorBy::GaussianCurvature);
    assert!(mirror.corners == whole.1.corners);
    let Some(Legend::Ramp(ramp)) = buffers.coloring().legend() else { panic!("numbers") };
    // The outermost circle has 1 / (r R), the innermost the same of the other sign with R - r.
    assert!(ramp.low == -ramp.high && (2.0..4.5).contains(&ramp.high), "{ramp:?}");
}

#[test]
fn valences_and_qualities_have_colours_of_their_own() {
    let mut plane = grid(4, 4, false);
    halfedge::edit::delete_faces(&mut plane, &[FaceId::new(0)]).expect("a face");
    let (_, mirror) = rebuilt_colored(&plane, Shading::Flat, ColorBy::Valence);
    let Some(Legend::Ramp(ramp)) = Coloring::new(&plane, ColorBy::Valence, false, &Arc::default()).legend()
    else {
        panic!("numbers")
    };
    assert_eq!((ramp.low, ramp.high), (1.0, 7.0), "four is regular among quads");
    for v in plane.vertices() {
        let expected = ramp.color(plane.valence(v) as f32).0;
        let at = plane.position(v).to_array();
        for (position, [r, g, b, _]) in mirror.corners.positions.iter().zip(&mirror.corners.colors) {
            assert!(*position != at || [*r, *g, *b] == expected, "{v}");
        }
    }
    let (_, mirror) = rebuilt_colored(&plane, Shading::Flat, ColorBy::Quality);
    let best = Ramp::sequential(0.0, 1.0).color(1.0).0;
    assert!(mirror.corners.colors.iter().all(|[r, g, b, _]| [*r, *g, *b] == best), "squares are regular");
}

#[test]
fn a_local_edit_uploads_what_its_valence_says_whatever_the_mesh() {
    let sizes = [20_u32, 200].map(|n| {
        let mut mesh = grid(n, n, true);
        let middle = VertexId::new(((n + 1) * n / 2 + n / 2) as usize);
        let edge = mesh.outgoing(middle).next().expect("an edge").edge();
        let mut sizes = Vec::new();
        for (step, shading) in [Shading::Flat, Shading::Smooth, Shading::default()].into_iter().enumerate() {
            let (mut buffers, mut mirror) = rebuilt(&mesh, shading);
            // Different values each time: equal ones are no change.
            let (height, color) = (step as f32 * 0.1 + 0.1, [step as u8 + 1, 2, 3]);
            let moved = touched(&mut mesh, |mesh| mesh.set_position(middle, vec3(0.0, 0.0, height)));
            buffers.update(&mesh, &moved, &mut mirror);
            sizes.push(mirror.written);
            mirror.written = 0;
            let painted = touched(&mut mesh, |mesh| paint(mesh, 3, color));
            // The first colour adds the column, which changes everything; the second doesn't.
            buffers.update(&mesh, &painted, &mut mirror);
            mirror.written = 0;
            let painted = touched(&mut mesh, |mesh| paint(mesh, 4, color));
            buffers.update(&mesh, &painted, &mut mirror);
            sizes.push(mirror.written);
            assert_as_rebuilt(&mesh, &buffers, &mirror);
        }
        let (mut buffers, mut mirror) = rebuilt(&mesh, Shading::Flat);
        mesh.start_recording();
        split_edge(&mut mesh, edge, 0.5, Connect::Triangles).expect("an edge");
        let journal = mesh.finish_recording();
        buffers.update(&mesh, &journal.touched(), &mut mirror);
        sizes.push(mirror.written);
        assert_as_rebuilt(&mesh, &buffers, &mirror);
        let redo = mesh.undo(journal);
        mirror.written = 0;
        buffers.update(&mesh, &redo.touched(), &mut mirror);
        assert_as_rebuilt(&mesh, &buffers, &mirror);
        assert_eq!(mirror.resets, 1);
        sizes
    });
    assert_eq!(sizes[0], sizes[1]);
    // A moved vertex of valence six: its faces, and with smooth normals those around their corners.
    assert_eq!(sizes[0][0], 6 * TRIANGLE_BYTES);
    assert_eq!(sizes[0][1], TRIANGLE_BYTES);
    assert_eq!(sizes[0][2], 24 * TRIANGLE_BYTES);
    assert_eq!(sizes[0][4], 24 * TRIANGLE_BYTES);
    assert!(sizes[0][6] <= 16 * TRIANGLE_BYTES, "{sizes:?}");
}

#[test]
fn a_mesh_may_be_edited_during_a_rebuild() {
    for shading in [Shading::Flat, Shading::Smooth, Shading::default()] {
        let mut mesh = grid(20, 15, true);
        let (mut buffers, mut mirror) = (Buffers::default(), Mirror::default());
        let mut rebuilding = buffers.begin_rebuild(&mesh, Vec3::ZERO, shading, Coloring::default());
        let mut is_left = true;
        while is_left && mirror.written < 300 * TRIANGLE_BYTES {
            is_left = buffers.rebuild_faces(&mesh, &mut rebuilding, &mut Budget::new(80), &mut mirror);
        }
        assert!(is_left && mirror.written < 400 * TRIANGLE_BYTES, "{}", mirror.written);
        // Among the faces that are written, and among those that aren't.
        let edit = touched(&mut mesh, |mesh| {
            for e in [3, 500, 900] {
                split_edge(mesh, EdgeId::new(e), 0.5, Connect::All).expect("splits");
            }
            for v in [5, 300] {
                mesh.set_position(VertexId::new(v), mesh.positions()[v] + Vec3::Z);
            }
            halfedge::edit::delete_faces(mesh, &[FaceId::new(40), FaceId::new(550)]).expect("faces");
        });
        while buffers.rebuild_faces(&mesh, &mut rebuilding, &mut Budget::new(80), &mut mirror) {}
        buffers.update(&mesh, &edit, &mut mirror);
        assert_eq!(mirror.resets, 1, "no rebuild");
        assert_as_rebuilt(&mesh, &buffers, &mirror);
    }
}

#[test]
fn an_edit_of_everything_is_a_rebuild() {
    let mut mesh = grid(100, 100, false);
    let (mut buffers, mut mirror) = rebuilt(&mesh, Shading::Flat);
    let moved = touched(&mut mesh, |mesh| {
        let up = mesh.positions().iter().map(|p| *p + Vec3::Z).collect();
        mesh.set_positions(up).expect("as many");
    });
    buffers.update(&mesh, &moved, &mut mirror);
    assert_eq!(mirror.resets, 2);
    assert_as_rebuilt(&mesh, &buffers, &mirror);
    let moved = touched(&mut mesh, |mesh| {
        for v in 0..mesh.vertex_capacity() {
            mesh.set_position(VertexId::new(v), mesh.positions()[v] * 2.0);
        }
    });
    buffers.update(&mesh, &moved, &mut mirror);
    assert_as_rebuilt(&mesh, &buffers, &mirror);
}

#[test]
fn an_empty_mesh_has_no_triangles() {
    let (mut buffers, mut mirror) = rebuilt(&Mesh::new(), Shading::Smooth);
    buffers.update(&Mesh::new(), &Touched::default(), &mut mirror);
    assert_eq!((buffers.triangles(), mirror.written), (0, 0));
}

#[derive(Clone, Debug)]
enum Edit {
    Split(u32, Connect),
    Triangulate(u32),
    Move(u32, [f32; 3]),
    Paint(u32, [u8; 3]),
    PaintVertex(u32, [f32; 3]),
    /// Hides a face, or shows it again.
    Hide(u32),
    Undo,
    Redo,
}

fn edits() -> impl Strategy<Value = Vec<Edit>> {
    let connect = prop_oneof![Just(Connect::None), Just(Connect::Triangles), Just(Connect::All)];
    let edit = prop_oneof![
        4 => (any::<u32>(), connect).prop_map(|(e, c)| Edit::Split(e, c)),
        2 => any::<u32>().prop_map(Edit::Triangulate),
        2 => (any::<u32>(), prop::array::uniform3(-2.0_f32..2.0)).prop_map(|(v, p)| Edit::Move(v, p)),
        1 => (any::<u32>(), any::<[u8; 3]>()).prop_map(|(f, c)| Edit::Paint(f, c)),
        1 => (any::<u32>(), prop::array::uniform3(0.0_f32..1.0)).prop_map(|(v, c)| Edit::PaintVertex(v, c)),
        2 => any::<u32>().prop_map(Edit::Hide),
        2 => Just(Edit::Undo),
        1 => Just(Edit::Redo),
    ];
    prop::collection::vec(edit, 1..30)
}

fn shadings() -> impl Strategy<Value = Shading> {
    prop_oneof![Just(Shading::Flat), Just(Shading::Smooth), Just(Shading::default())]
}

fn colors() -> impl Strategy<Value = ColorBy> {
    prop::sample::select(&ColorBy::ALL[..])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// After any sequence of edits, undos and redos the streams are the same as after a rebuild.
    #[test]
    fn streams_follow_edits(edits in edits(), which in 0..3, shading in shadings(), by in colors()) {
        let mut mesh = match which { 0 => cube(), 1 => grid(4, 3, false), _ => sphere(8, 6) };
        let (mut buffers, mut mirror) = rebuilt_colored(&mesh, shading, by);
        let (mut undo, mut redo) = (Vec::new(), Vec::new());
        for edit in edits {
            let touched = match edit {
                Edit::Hide(f) => {
                    let face = FaceId::new(f as usize % mesh.face_capacity());
                    let mut hidden = (**buffers.hidden()).clone();
                    hidden.toggle_with(&[face.index()].into_iter().collect());
                    buffers.set_hidden(&Arc::new(hidden));
                    Touched { faces: vec![face], ..Touched::default() }
                }
                Edit::Undo | Edit::Redo => {
                    let (from, to) = if matches!(edit, Edit::Undo) {
                        (&mut undo, &mut redo)
                    } else {
                        (&mut redo, &mut undo)
                    };
                    let Some(journal) = from.pop() else { continue };
                    let back = mesh.undo(journal);
                    let touched = back.touched();
                    to.push(back);
                    touched
                }
                edit => {
                    mesh.start_recording();
                    match edit {
                        Edit::Split(e, connect) => {
                            let e = EdgeId::new(e as usize % mesh.edge_capacity());
                            let _refused = split_edge(&mut mesh, e, 0.4, connect);
                        }
                        Edit::Triangulate(f) => {
                            let f = FaceId::new(f as usize % mesh.face_capacity());
                            let _refused = triangulate_face(&mut mesh, f, Triangulation::Fan);
                        }
                        Edit::Move(v, p) => {
                            let v = VertexId::new(v as usize % mesh.vertex_capacity());
                            mesh.set_position(v, Vec3::from(p));
                        }
                        Edit::Paint(f, color) => {
                            let f = f as usize % mesh.face_capacity();
                            paint(&mut mesh, f, color);
                        }
                        Edit::PaintVertex(v, color) => {
                            let v = v as usize % mesh.vertex_capacity();
                            mesh.set(keys::VERTEX_COLOR, v, Vec3::from(color));
                        }
                        Edit::Undo | Edit::Redo | Edit::Hide(_) => {}
                    }
                    let journal = mesh.finish_recording();
                    let touched = journal.touched();
                    undo.push(journal);
                    redo.clear();
                    touched
                }
            };
            prop_assert!(mesh.validate().is_ok());
            buffers.update(&mesh, &touched, &mut mirror);
            assert_as_rebuilt(&mesh, &buffers, &mirror);
        }
    }
}

/// A plane whose faces have texture coordinates, and all but the last a material with a picture.
fn textured_plane() -> (Mesh, Arc<Materials>) {
    let mut plane = grid(5, 4, false);
    for h in plane.halfedges().collect::<Vec<_>>() {
        let at = plane.position(plane.from(h));
        plane.set(keys::CORNER_UV, h.index(), at.truncate() * 0.5);
    }
    let mut labels = vec![0; plane.face_capacity()];
    labels[19] = NONE;
    plane.insert_column(
        halfedge::Element::Face,
        Column { labels: vec!["wood".to_owned()], ..Column::with_values(keys::FACE_MATERIAL, labels) },
    );
    let wood = MaterialLook { name: "wood".to_owned(), color: None, texture: Some(Texture::new(1)) };
    (plane, Arc::new(Materials::new([wood])))
}

#[test]
fn texture_coordinates_and_marks_follow_edits() {
    let (mut plane, materials) = textured_plane();
    let (mut buffers, mut mirror) = (Buffers::default(), Mirror::default());
    let coloring = Coloring::new(&plane, ColorBy::Paint, true, &materials);
    buffers.rebuild(&plane, Vec3::ZERO, Shading::Flat, coloring, &mut mirror);
    let of = |buffers: &Buffers, mirror: &Mirror, face| {
        let [(_, normal, [r, ..]), ..] = of_face(buffers, mirror, FaceId::new(face))[0];
        (normal[3], r)
    };
    assert_eq!(of(&buffers, &mirror, 0), (2, 255), "the picture in no other colour");
    assert_eq!(of(&buffers, &mirror, 19), (1, Color::UNPAINTED.0[0]), "no picture");
    assert_eq!(uvs_of_face(&buffers, &mirror, FaceId::new(0))[0], [-0.5, 1.5], "v from the top");
    let resets = mirror.resets;
    let edits: [&dyn Fn(&mut Mesh); 4] = [
        &|mesh| drop(split_edge(mesh, EdgeId::new(3), 0.25, Connect::All)),
        &|mesh| paint(mesh, 2, [1, 2, 3]),
        &|mesh| {
            let corner = mesh.face_halfedges(FaceId::new(7)).next().expect("a corner");
            mesh.set(keys::CORNER_UV, corner.index(), glam::vec2(f32::NAN, 0.0));
        },
        &|mesh| drop(triangulate_face(mesh, FaceId::new(8), Triangulation::Fan)),
    ];
    for edit in edits {
        let touched = touched(&mut plane, edit);
        buffers.update(&plane, &touched, &mut mirror);
        assert_as_rebuilt(&plane, &buffers, &mirror);
    }
    assert_eq!(of(&buffers, &mirror, 2), (2, 1), "paint colours the picture");
    assert_eq!(of(&buffers, &mirror, 7).0, 0, "a corner has no coordinates");
    assert_eq!(mirror.resets, resets, "local edits write what they changed");
}
