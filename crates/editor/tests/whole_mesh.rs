//! Whole-mesh operations as commands: their fields, results and messages.

mod support;

use editor::formats::NamedBytes;
use editor::halfedge::Mesh;
use editor::{Begun, Editor, Finished, JobRequest, JobResult, Wire};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use support::*;

fn on_sphere() -> Editor {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "ico-sphere", "subdivisions": 3}));
    assert_eq!(sizes(&editor)[2], 1280);
    editor
}

fn after(value: Value) -> Editor {
    let mut editor = on_sphere();
    let before = editor.document().clone();
    run(&mut editor, value);
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
    editor.redo().expect("free");
    editor
}

fn volume(mesh: &Mesh) -> f64 {
    surface::measure::volume(mesh)
}

#[test]
fn simplify_reaches_its_targets() {
    assert_eq!(sizes(&after(json!({"op": "simplify", "faces": 500})))[2], 500);
    assert_eq!(sizes(&after(json!({"op": "simplify", "ratio": 0.1})))[2], 128);
    let by_error = sizes(&after(json!({"op": "simplify", "max_error": 0.05})))[2];
    assert!((8..1280).contains(&by_error), "{by_error}");
    let outcome = run(&mut on_sphere(), json!({"op": "simplify", "faces": 501, "preserve_boundary": false}));
    assert_eq!(outcome.removed.faces, 1280 - 502);
    assert_eq!(outcome.warnings.len(), 1);
    assert!(
        outcome.warnings[0].contains("502") && outcome.warnings[0].contains("501"),
        "{:?}",
        outcome.warnings
    );
}

#[test]
fn smooth_moves_vertices_and_keeps_ids() {
    let (round, shrunk, kept) = (
        on_sphere(),
        after(json!({"op": "smooth", "iterations": 10})),
        after(json!({"op": "smooth", "iterations": 10, "method": "taubin", "strength": 0.6})),
    );
    let [a, b, c] = [&round, &shrunk, &kept].map(|editor| volume(editor.mesh().expect("a mesh")));
    assert_eq!(sizes(&shrunk), sizes(&round));
    assert!(b < a * 0.99, "{b} of {a}");
    assert!((c - a).abs() < (a - b) / 4.0, "{c} of {a}");
}

#[test]
fn merge_by_distance_glues_pieces() {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 2, "rows": 2}));
    run(&mut editor, json!({"op": "separate", "faces": [0, 1]}));
    run(&mut editor, json!({"op": "join-objects"}));
    assert_eq!(sizes(&editor)[0], 12);
    let outcome = run(&mut editor, json!({"op": "merge-by-distance", "distance": 0}));
    assert_eq!(sizes(&editor), [9, 12, 4]);
    assert_eq!((outcome.removed.vertices, outcome.removed.edges), (3, 2));
}

#[test]
fn remesh_takes_a_length_and_evens_edges_out() {
    let mut editor = on_sphere();
    let mean = surface::measure::mean_edge_length(editor.mesh().expect("a mesh"));
    run(&mut editor, json!({"op": "remesh", "edge_length": mean / 2.0, "iterations": 6}));
    validate(&editor);
    let mesh = editor.mesh().expect("a mesh");
    assert!(mesh.face_count() > 3 * 1280, "{}", mesh.face_count());
    assert_eq!(mesh.euler_characteristic(), 2);
    let even = mesh.edges().filter(|&e| {
        let [a, b] = mesh.ends(e).map(|v| mesh.position(v));
        let length = f64::from(a.distance(b)) / (mean / 2.0);
        (0.8..=4.0 / 3.0).contains(&length)
    });
    assert!(even.count() * 10 > mesh.edge_count() * 9);
    editor.undo().expect("one step");
    assert_eq!(sizes(&editor)[2], 1280);
}

#[test]
fn refusals_name_the_field() {
    let cases: &[(Value, &[&str])] = &[
        (json!({"op": "simplify"}), &["`ratio`", "one of"]),
        (json!({"op": "simplify", "faces": 3, "ratio": 0.5}), &["`faces`", "one of"]),
        (json!({"op": "simplify", "max_error": 3, "ratio": 0.5}), &["`ratio`", "one of"]),
        (json!({"op": "simplify", "ratio": 0}), &["`ratio`", "above 0"]),
        (json!({"op": "simplify", "ratio": 2}), &["`ratio`", "at most 1"]),
        (json!({"op": "simplify", "max_error": -1}), &["`max_error`"]),
        (json!({"op": "simplify", "faces": -1}), &["`faces`", "-1"]),
        (json!({"op": "simplify", "faces": 3, "preserve_boundary": 1}), &["`preserve_boundary`"]),
        (json!({"op": "smooth", "iterations": 0}), &["`iterations`", "1 to 10000"]),
        (json!({"op": "smooth", "strength": -0.5}), &["`strength`"]),
        (json!({"op": "smooth", "strength": 1.5}), &["`strength`"]),
        (json!({"op": "smooth", "method": "hard"}), &["`method`", "hard", "taubin"]),
        (json!({"op": "remesh", "edge_length": 0}), &["`edge_length`"]),
        (json!({"op": "remesh", "edge_length": 1e-6}), &["`edge_length`", "memory"]),
        (json!({"op": "remesh", "iterations": 0}), &["`iterations`", "1 to 1000"]),
        (json!({"op": "remesh", "iterations": 1001}), &["`iterations`", "1 to 1000"]),
        (json!({"op": "smooth", "iterations": 10_001}), &["`iterations`", "1 to 10000"]),
        (json!({"op": "remesh", "feature_angle": 200}), &["`feature_angle`"]),
        (json!({"op": "remesh", "project": "no"}), &["`project`"]),
        (json!({"op": "merge-by-distance"}), &["`distance`", "missing"]),
        (json!({"op": "merge-by-distance", "distance": -1}), &["`distance`"]),
    ];
    for (value, parts) in cases {
        let text = refusal(&mut on_sphere(), value.clone());
        let op = value["op"].as_str().expect("text");
        assert!(text.starts_with(&format!("{op}: ")), "{text}");
        for part in *parts {
            assert!(text.contains(part), "{value}: {text}");
        }
    }
}

#[test]
fn notes_come_back_from_a_worker() {
    let mut editor = on_sphere();
    let value = json!({"op": "simplify", "faces": 501});
    let expected = on_sphere().run(command(value.clone())).expect("goes through");
    let Begun::Job(request) = editor.begin_from(command(value), 0).expect("goes through") else {
        panic!("a job")
    };
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = there.run(&mut |_| ControlFlow::Continue(())).expect("goes through");
    let back = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
    let Ok(Finished::Done(outcome)) = editor.finish(request.id(), Ok(back)) else { panic!("a command") };
    assert_eq!(outcome, expected);
    validate(&editor);
}

#[test]
fn seams_that_stop_simplifying_can_be_given_up() {
    // Nine squares, each with a piece of the texture of its own.
    let mut text = String::new();
    for i in 0..16 {
        text += &format!("v {} 0 {}\n", i % 4, i / 4);
    }
    for corner in 0..36 {
        text += &format!("vt {} {}\n", corner as f32 / 40.0, (corner % 5) as f32 / 5.0);
    }
    for (face, a) in [1, 2, 3, 5, 6, 7, 9, 10, 11].into_iter().enumerate() {
        let corners = [a, a + 4, a + 5, a + 1];
        let written = corners.iter().enumerate().map(|(i, v)| format!(" {v}/{}", face * 4 + i + 1));
        text += &format!("f{}\n", written.collect::<String>());
    }
    let charted = || {
        let mut editor = Editor::new();
        let files = [NamedBytes::new("charts.obj", text.clone().into_bytes())];
        let imported = editor::formats::read(&files, &mut |_| ControlFlow::Continue(())).expect("readable");
        editor.open(imported).expect("valid");
        editor
    };
    let mut editor = charted();
    let kept = run(&mut editor, json!({"op": "simplify", "faces": 2}));
    assert!(sizes(&editor)[2] > 2);
    assert!(kept.warnings.iter().any(|text| text.contains("“Preserve seams”")), "{:?}", kept.warnings);
    let mut editor = charted();
    let free = run(&mut editor, json!({"op": "simplify", "faces": 2, "preserve_seams": false}));
    assert_eq!((sizes(&editor)[2], free.warnings.len()), (2, 0), "{:?}", free.warnings);
}
