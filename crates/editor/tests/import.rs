//! Repairing an import again with other choices, and the offset of models far from the origin.

mod support;

use editor::formats::{Format, NamedBytes, NonManifold, Repairs};
use editor::{Begun, Editor, Finished, JobRequest, JobResult, Outcome, Wire};
use glam::DVec3;
use serde_json::json;
use std::ops::ControlFlow;
use support::*;

/// Three triangles at one edge, two of which face the same way round it.
const FIN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
const FAR: &str =
    "v 4458321.123 5412000.004 12.5\nv 4458323.125 5412000.011 12.25\nv 4458322.12 5412001.006 13\nf 1 2 3\n";

/// Opens one file through a worker's bytes.
fn open(editor: &mut Editor, text: &str, repairs: Repairs) {
    let request = editor.begin_import_with(vec![NamedBytes::new("a.obj", text)], repairs);
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = there.run(&mut |_| ControlFlow::Continue(())).expect("readable");
    let back = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
    assert!(matches!(editor.finish(request.id(), Ok(back)), Ok(Finished::Done(_))));
    validate(editor);
}

fn on_fin() -> Editor {
    let mut editor = Editor::new();
    open(&mut editor, FIN, Repairs::default());
    editor
}

fn components(editor: &Editor) -> usize {
    editor.mesh().expect("a mesh").components().1
}

#[test]
fn an_import_can_be_repaired_again_and_undone() {
    let mut editor = on_fin();
    assert!(editor.document().objects()[0].is_repairable());
    let report = |outcome: &Outcome| {
        serde_json::to_value(outcome).expect("plain")["report"]
            .as_array()
            .map(|notes| notes.iter().map(|note| note["severity"].to_string()).collect::<Vec<_>>())
    };
    let request = editor.begin_import(vec![NamedBytes::new("a.obj", FIN)]);
    let result = request.run(&mut |_| ControlFlow::Continue(()));
    let Ok(Finished::Done(opened)) = editor.finish(request.id(), result) else { panic!("opens") };
    let severities = report(&opened).expect("the whole report, not only its warnings");
    assert!(severities.contains(&"\"info\"".into()) && severities.contains(&"\"warning\"".into()));
    assert_eq!(editor.state()["document"]["objects"][0]["repairable"], true);
    assert_eq!((sizes(&editor)[2], components(&editor)), (3, 3));
    let before = editor.document().clone();
    let outcome = run(&mut editor, json!({"op": "repair-import", "non_manifold": "drop"}));
    assert_eq!(report(&outcome), None, "only opening has a report");
    assert_eq!(outcome.warnings, ["1 face left out: two earlier faces meet at one of its edges (face 2)"]);
    assert_eq!((sizes(&editor)[2], components(&editor)), (2, 2));
    let dropped = editor.document().clone();
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
    editor.redo().expect("free");
    assert_eq!(editor.document(), &dropped);
    // Again, otherwise: it starts from the file each time, whatever was done since.
    run(&mut editor, json!({"op": "subdivide-linear"}));
    run(&mut editor, json!({"op": "repair-import"}));
    assert_eq!(editor.mesh(), before.objects()[0].mesh().into());
    run(&mut editor, json!({"op": "repair-import", "merge_by_distance": 5}));
    assert_eq!(sizes(&editor)[2], 0);
}

#[test]
fn choices_before_opening_give_the_same_result() {
    let mut later = on_fin();
    run(&mut later, json!({"op": "repair-import", "non_manifold": "drop", "orient": false}));
    let mut before = Editor::new();
    open(&mut before, FIN, Repairs { non_manifold: NonManifold::Drop, orient: false, ..Repairs::default() });
    assert_eq!(before.mesh(), later.mesh());
    assert!(before.document().objects()[0].is_repairable());
}

#[test]
fn repairing_runs_in_a_worker() {
    let mut editor = on_fin();
    let mut direct = on_fin();
    let value = json!({"op": "repair-import", "non_manifold": "drop"});
    let expected = direct.run(command(value.clone())).expect("goes through");
    let Begun::Job(request) = editor.begin_from(command(value), 0).expect("goes through") else {
        panic!("a job")
    };
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = there.run(&mut |_| ControlFlow::Continue(())).expect("goes through");
    let back = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
    let Ok(Finished::Done(outcome)) = editor.finish(request.id(), Ok(back)) else { panic!("a command") };
    assert_eq!(outcome, expected);
    assert_eq!(editor.document(), direct.document());
    // Other operations don't send the file's faces along.
    let sent = |value| {
        let mut editor = on_fin();
        match editor.begin_from(command(value), 0).expect("goes through") {
            Begun::Job(request) => request.to_bytes().len(),
            Begun::Done(_) | Begun::Selecting => panic!("a job"),
        }
    };
    let [smooth, repair] = [json!({"op": "smooth"}), json!({"op": "repair-import"})].map(sent);
    assert!(smooth < repair, "{smooth} {repair}");
}

#[test]
fn a_mesh_without_repairs_is_not_repairable() {
    let text = refusal(&mut on_cube(), json!({"op": "repair-import"}));
    assert!(text.contains("nothing was repaired when Cube was read"), "{text}");
    let mut editor = on_fin();
    for (value, part) in [
        (json!({"op": "repair-import", "merge_by_distance": -1}), "`merge_by_distance`: -1 is out of range"),
        (json!({"op": "repair-import", "non_manifold": "keep"}), "`non_manifold`: `keep` is not a choice"),
        (json!({"op": "repair-import", "orient": 1}), "`orient`"),
    ] {
        let text = refusal(&mut editor, value.clone());
        assert!(text.contains(part), "{value}: {text}");
    }
    // Parts of it are no longer what the file held.
    let before = editor.document().clone();
    run(&mut editor, json!({"op": "separate", "by": "components"}));
    assert!(editor.document().objects().iter().all(|object| !object.is_repairable()));
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
}

#[test]
fn the_offset_belongs_to_the_document() {
    let mut editor = Editor::new();
    open(&mut editor, FAR, Repairs::default());
    let offset = editor.document().offset();
    assert!(offset.x > 4e6 && offset.y > 5e6, "{offset}");
    assert_eq!(editor.state()["document"]["offset"], json!(offset.to_array()));
    let request = editor.begin_export(Format::default());
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = there.run(&mut |_| ControlFlow::Continue(())).expect("writes");
    let Ok(Finished::Exported(files)) = editor.finish(request.id(), Ok(result)) else { panic!("files") };
    let written = String::from_utf8(files[0].bytes.clone()).expect("text");
    let x: f64 =
        written.lines().nth(1).and_then(|line| line.split(' ').nth(1)?.parse().ok()).expect("a vertex");
    assert!((x - 4_458_321.123).abs() < 2e-7, "{written}");
    run(&mut editor, json!({"op": "new", "shape": "cube"}));
    assert_eq!(editor.document().offset(), DVec3::ZERO);
    editor.undo().expect("free");
    assert_eq!(editor.document().offset(), offset);
}

#[test]
fn objects_of_a_file_are_separated_by_name() {
    let mut editor = Editor::new();
    let text =
        "o box\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no car\ng wheel\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n";
    open(&mut editor, text, Repairs::default());
    assert_eq!(editor.document().objects().len(), 1);
    run(&mut editor, json!({"op": "separate", "by": "groups"}));
    let names: Vec<&str> = editor.document().objects().iter().map(|object| object.name()).collect();
    assert_eq!(names, ["box", "o car; g wheel"]);
}
