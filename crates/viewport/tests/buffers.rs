//! The vertex streams: correct for a mesh, the same after edits as after a rebuild, and cheap to update.

mod support;

use glam::{Vec3, vec3};
use halfedge::edit::{Connect, Triangulation, split_edge, triangulate_face};
use halfedge::{Budget, EdgeId, FaceId, Mesh, Touched, VertexId};
use proptest::prelude::*;
use support::{cube, grid, mesh, paint, sphere};
use viewport::buffers::{Buffers, Corners, Sink, TRIANGLE_BYTES};

/// The GPU's side as plain arrays.
#[derive(Clone, Default)]
struct Mirror {
    corners: Corners,
    written: usize,
    resets: usize,
}

impl Sink for Mirror {
    fn reset(&mut self, _triangles: u32) {
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

/// Checks that each face has the triangles of a rebuild, that no two faces share one, and that no other triangle
/// has an area.
fn assert_as_rebuilt(mesh: &Mesh, buffers: &Buffers, mirror: &Mirror) {
    let mut fresh = Buffers::default();
    let mut expected = Mirror::default();
    fresh.rebuild(mesh, buffers.origin(), buffers.smooth(), &mut expected);
    let mut owned = vec![false; buffers.triangles() as usize];
    for face in mesh.faces() {
        assert_eq!(of_face(buffers, mirror, face), of_face(&fresh, &expected, face), "{face}");
        let range = buffers.range(face);
        assert_eq!(range.count as usize, mesh.face_degree(face) - 2, "{face}");
        for t in range.first..range.first + range.count {
            assert!(!std::mem::replace(&mut owned[t as usize], true), "triangle {t} twice");
        }
    }
    for (t, _) in owned.iter().enumerate().filter(|(_, owned)| !**owned) {
        let [a, b, c] = mirror.triangle(t as u32).map(|corner| corner.0);
        assert!(a == b && b == c, "stray triangle {t}");
    }
}

fn rebuilt(mesh: &Mesh, smooth: bool) -> (Buffers, Mirror) {
    let mut buffers = Buffers::default();
    let mut mirror = Mirror::default();
    buffers.rebuild(mesh, Vec3::ZERO, smooth, &mut mirror);
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
    buffers.rebuild(&square, Vec3::ONE, false, &mut mirror);
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
    let (buffers, mirror) = rebuilt(&star, false);
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
    let (_, mirror) = rebuilt(&cube, true);
    // Three squares of one size meet at each corner: its normal is along the diagonal.
    for (position, normal) in mirror.corners.positions.iter().zip(&mirror.corners.normals) {
        let expected = (Vec3::from(*position).normalize() * 32767.0).round().to_array().map(|c| c as i16);
        assert_eq!(normal[..3], expected);
    }
}

#[test]
fn a_local_edit_uploads_what_its_valence_says_whatever_the_mesh() {
    let sizes = [20_u32, 200].map(|n| {
        let mut mesh = grid(n, n, true);
        let middle = VertexId::new(((n + 1) * n / 2 + n / 2) as usize);
        let edge = mesh.outgoing(middle).next().expect("an edge").edge();
        let mut sizes = Vec::new();
        for smooth in [false, true] {
            let (mut buffers, mut mirror) = rebuilt(&mesh, smooth);
            // Different values each time: equal ones are no change.
            let (height, color) = if smooth { (0.2, [4, 5, 6]) } else { (0.1, [1, 2, 3]) };
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
        let (mut buffers, mut mirror) = rebuilt(&mesh, false);
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
    assert!(sizes[0][4] <= 16 * TRIANGLE_BYTES, "{sizes:?}");
}

#[test]
fn a_mesh_may_be_edited_during_a_rebuild() {
    for smooth in [false, true] {
        let mut mesh = grid(20, 15, true);
        let (mut buffers, mut mirror) = (Buffers::default(), Mirror::default());
        let mut rebuilding = buffers.begin_rebuild(&mesh, Vec3::ZERO, smooth, &mut mirror);
        let mut parts = 1;
        while parts < 5 && buffers.rebuild_faces(&mesh, &mut rebuilding, &mut Budget::new(80), &mut mirror) {
            parts += 1;
        }
        assert_eq!((parts, mirror.written), (5, 4 * 80 * TRIANGLE_BYTES));
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
    let (mut buffers, mut mirror) = rebuilt(&mesh, false);
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
    let (mut buffers, mut mirror) = rebuilt(&Mesh::new(), true);
    buffers.update(&Mesh::new(), &Touched::default(), &mut mirror);
    assert_eq!((buffers.triangles(), mirror.written), (0, 0));
}

#[derive(Clone, Debug)]
enum Edit {
    Split(u32, Connect),
    Triangulate(u32),
    Move(u32, [f32; 3]),
    Paint(u32, [u8; 3]),
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
        2 => Just(Edit::Undo),
        1 => Just(Edit::Redo),
    ];
    prop::collection::vec(edit, 1..30)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// After any sequence of edits, undos and redos the streams are the same as after a rebuild.
    #[test]
    fn streams_follow_edits(edits in edits(), which in 0..3, smooth in any::<bool>()) {
        let mut mesh = match which { 0 => cube(), 1 => grid(4, 3, false), _ => sphere(8, 6) };
        let (mut buffers, mut mirror) = rebuilt(&mesh, smooth);
        let (mut undo, mut redo) = (Vec::new(), Vec::new());
        for edit in edits {
            let touched = match edit {
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
                        Edit::Undo | Edit::Redo => {}
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
