//! Regression tests: edits that once gave wrong results, on the files concerned.

mod support;

use editor::formats::{NamedBytes, Repairs};
use editor::halfedge::geometry::face_area_vector;
use editor::halfedge::{EdgeId, Element, Mesh, keys};
use editor::{Editor, Finished, SelectMode};
use glam::Vec3;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use support::*;

fn open(name: &str) -> Editor {
    let path = fixtures::fixture(&format!("cases/{name}"));
    let bytes = std::fs::read(&path).expect("readable");
    let mut editor = Editor::new();
    let request = editor.begin_import_with(vec![NamedBytes::new(name, bytes)], Repairs::default());
    let id = request.id();
    let result = request.run(&mut |_| ControlFlow::Continue(()));
    assert!(matches!(editor.finish(id, result), Ok(Finished::Done(_))));
    validate(&editor);
    editor
}

fn mesh(editor: &Editor) -> &Mesh {
    editor.mesh().expect("a mesh")
}

#[test]
fn texture_coordinates_follow_edits_in_the_plane() {
    let edits: [Value; 20] = [
        json!({"op": "inset-faces", "faces": [4], "amount": 0.2}),
        json!({"op": "inset-faces", "faces": [3, 4, 7], "amount": 0.1, "mode": "individual"}),
        json!({"op": "bevel-edges", "edges": [[5, 6]], "width": 0.2}),
        json!({"op": "bevel-edges", "edges": [[5, 6], [6, 10], [1, 5]], "width": 0.1, "segments": 3}),
        json!({"op": "bevel-vertices", "vertices": [5], "width": 0.2}),
        json!({"op": "collapse-face", "face": 4}),
        json!({"op": "collapse-edge", "edge": [5, 6], "t": 0.3}),
        json!({"op": "merge-vertices", "vertices": [5, 6, 10]}),
        json!({"op": "merge-vertices", "vertices": [5, 6], "position": [1.2, 1.4, 0.0]}),
        json!({"op": "split-vertex", "vertex": 5, "edges": [[5, 1], [5, 9]]}),
        json!({"op": "extrude-faces", "faces": [4, 5], "distance": 0.5}),
        json!({"op": "extrude-edges", "edges": [[0, 1], [1, 2]], "offset": [0.2, -0.7, 0.0]}),
        json!({"op": "loop-cut", "edge": [5, 6], "cuts": 3, "t": 0.3}),
        json!({"op": "slide-edges", "edges": [[5, 6], [6, 10]], "amount": 0.3}),
        json!({"op": "slide-vertices", "vertices": [5, 6], "direction": [1, 2, 0], "amount": 0.3}),
        json!({"op": "split-edge", "edge": [5, 6], "t": 0.3, "connect": "all"}),
        json!({"op": "poke-faces", "faces": [0, 4]}),
        json!({"op": "dissolve-edge", "edge": [5, 6]}),
        json!({"op": "dissolve-vertex", "vertex": 5}),
        json!({"op": "flip-edge", "edge": [5, 6]}),
    ];
    for edit in edits {
        let mut editor = open("obj-uv-grid.obj");
        run(&mut editor, edit.clone());
        let mesh = mesh(&editor);
        let mut corners = 0;
        for h in mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)) {
            let (uv, at) = (mesh.get(keys::CORNER_UV, h.index()), mesh.position(mesh.from(h)));
            assert!(uv.distance(at.truncate() / 3.0) < 1e-6, "{edit}: {uv} at {at}");
            assert_eq!(mesh.get(keys::CORNER_NORMAL, h.index()), Vec3::Z, "{edit}");
            corners += 1;
        }
        assert!(corners > 20, "{edit}");
    }
}

#[test]
fn a_bevel_ends_at_a_flat_vertex_with_a_third_point() {
    let mut editor = open("obj-flat-grid.obj");
    run(&mut editor, json!({"op": "bevel-edges", "edges": [[5, 6]], "width": 0.2}));
    let mesh = mesh(&editor);
    for third in [Vec3::new(0.8, 1.0, 0.0), Vec3::new(2.2, 1.0, 0.0)] {
        assert!(mesh.vertices().any(|v| mesh.position(v).distance(third) < 1e-6), "{third}");
    }
    let smallest = mesh.faces().map(|f| face_area_vector(mesh, f).length()).fold(f64::MAX, f64::min);
    assert!((smallest - 0.04).abs() < 1e-6, "{smallest}");
}

#[test]
fn dissolving_a_loop_cut_gives_the_mesh_back() {
    let cut = || {
        let mut editor = open("obj-loop-prism.obj");
        run(&mut editor, json!({"op": "loop-cut", "edge": [0, 8]}));
        assert_eq!(sizes(&editor), [24, 40, 18]);
        let is_new = |e: &EdgeId| mesh(&editor).ends(*e).iter().all(|v| v.index() >= 16);
        let ring: Vec<u32> = mesh(&editor).edges().filter(is_new).map(|e| e.raw()).collect();
        assert_eq!(ring.len(), 8);
        (editor, ring)
    };
    // The selected edges, all at once, in one step.
    let (mut editor, ring) = cut();
    editor.select(Element::Edge, ring, SelectMode::Replace).expect("there");
    let steps = editor.undo_labels().count();
    run(&mut editor, json!({"op": "dissolve-edge"}));
    assert_eq!(sizes(&editor), [16, 24, 10]);
    assert_eq!(editor.undo_labels().count(), steps + 1);
    let (mut editor, ring) = cut();
    run(&mut editor, json!({"op": "dissolve-edge", "edges": ring.clone()}));
    assert_eq!(sizes(&editor), [16, 24, 10]);
    // Edge by edge.
    let (mut editor, ring) = cut();
    for edge in &ring {
        run(&mut editor, json!({"op": "dissolve-edge", "edge": edge}));
    }
    assert_eq!(sizes(&editor), [16, 24, 10]);
    let (mut editor, ring) = cut();
    run(&mut editor, json!({"op": "dissolve-edge", "edges": ring, "keep_vertices": true}));
    assert_eq!(sizes(&editor), [24, 32, 10]);
    assert!(refusal(&mut editor, json!({"op": "dissolve-edge"})).contains("edge"));
    assert!(refusal(&mut editor, json!({"op": "dissolve-edge", "edges": []})).contains("edge"));
}

#[test]
fn a_concave_face_is_triangulated_inside_by_default() {
    for edit in [json!({"op": "triangulate-faces"}), json!({"op": "triangulate-faces", "method": "auto"})] {
        let mut editor = open("obj-concave.obj");
        run(&mut editor, edit);
        let mesh = mesh(&editor);
        assert_eq!(mesh.face_count(), 9);
        let area: f64 = mesh.faces().map(|f| face_area_vector(mesh, f).length()).sum();
        assert!((area - 84.0).abs() < 1e-4, "{area}");
    }
    let mut editor = open("obj-concave.obj");
    run(&mut editor, json!({"op": "triangulate-faces", "method": "fan"}));
    let mesh = mesh(&editor);
    let area: f64 = mesh.faces().map(|f| face_area_vector(mesh, f).length()).sum();
    assert!((area - 180.0).abs() < 1e-4, "{area}: a fan is a fan where it is asked for");
}
