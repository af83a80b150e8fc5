//! Project files: what is saved comes back, with its history; and no file, however damaged, does harm.

mod support;

use editor::formats::{Format, NamedBytes};
use editor::halfedge::Element;
use editor::project::{Link, Project, ReadProject};
use editor::{Editor, Finished, JobRequest, JobResult, SelectMode, Wire};
use proptest::prelude::*;
use serde_json::json;
use support::contents::Contents;
use support::deeds::*;
use support::*;

/// What a project keeps of a document. Its name is that of the file.
fn state(editor: &Editor) -> Contents {
    Contents::named(editor, "same")
}

fn read(bytes: &[u8]) -> ReadProject {
    Project::read(bytes).unwrap_or_else(|why| panic!("{why}"))
}

/// Opens a file in an editor with another document; returns the warnings.
fn open(bytes: &[u8]) -> (Editor, Vec<String>) {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    let outcome = editor.open_project(read(bytes));
    validate(&editor);
    assert!(!editor.is_dirty());
    (editor, outcome.warnings)
}

fn labels(editor: &Editor) -> Vec<String> {
    editor.undo_labels().map(str::to_owned).collect()
}

/// The labels of the steps that came with a project.
fn labels_of_project(editor: &Editor) -> Vec<String> {
    let mut all = labels(editor);
    let at = all.iter().position(|label| label.starts_with("Open ")).expect("the project's step");
    all.split_off(at + 1)
}

/// Sends a job to a worker and back.
fn do_job(editor: &mut Editor, request: &JobRequest) -> Result<Finished, editor::CommandError> {
    let request = JobRequest::from_bytes(&request.to_bytes()).expect("its own");
    let result = run_job(&request).map(|result| JobResult::from_bytes(&result.to_bytes()).expect("its own"));
    editor.finish(request.id(), result)
}

fn save(editor: &mut Editor, name: &str) -> NamedBytes {
    let request = editor.begin_export_as(Format::project(), name.to_owned());
    let Ok(Finished::Exported(mut files)) = do_job(editor, &request) else { panic!("written") };
    assert_eq!(files.len(), 1);
    files.remove(0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn whatever_was_done_comes_back_with_its_history(deeds in prop::collection::vec(any_deed(), 1..40)) {
        let mut editor = on_two();
        let mut jobs = Vec::new();
        for deed in &deeds {
            act(&mut editor, &mut jobs, deed);
        }
        let file = save(&mut editor, "Saved");
        let is_editing = editor.is_editing();
        let (mut opened, warnings) = open(&file.bytes);
        prop_assert!(state(&opened) == state(&editor));
        prop_assert_eq!(warnings, [""; 0]);
        if is_editing {
            return Ok(());
        }
        // The steps since the document was opened or made, above the step that opened the project.
        let steps = labels_of_project(&opened);
        prop_assert!(labels(&editor).ends_with(&steps));
        if jobs.is_empty() {
            // A job that adjusts a step keeps it until the end.
            let redo: Vec<&str> = editor.redo_labels().collect();
            prop_assert!(redo.ends_with(&opened.redo_labels().collect::<Vec<_>>()));
        }
        // What comes back can be undone, down to the document before.
        for _ in 0..=steps.len() {
            opened.undo().expect("free");
            validate(&opened);
        }
        prop_assert_eq!(opened.document().objects().len(), 2);
        prop_assert_eq!(opened.undo_labels().last(), Some("Poke faces"));
        for _ in 0..=steps.len() {
            opened.redo().expect("free");
        }
        validate(&opened);
        prop_assert!(state(&opened).model == state(&editor).model);
    }
}

/// A small document with everything that a project holds.
fn rich() -> Editor {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "set-face-color", "faces": [0, 1], "color": "#ff8000"}));
    run(&mut editor, json!({"op": "set-crease", "edges": [3], "sharpness": 2}));
    run(&mut editor, json!({"op": "new", "shape": "tetrahedron", "add": true}));
    run(&mut editor, json!({"op": "set-object-visible", "object": 0, "visible": false}));
    editor.select(Element::Face, [1], SelectMode::Replace).expect("a face");
    run(&mut editor, json!({"op": "name-selection", "name": "Side"}));
    run(&mut editor, json!({"op": "hide"}));
    editor.select(Element::Vertex, [2, 3], SelectMode::Replace).expect("vertices");
    editor.log_view(r#"{"yaw":0.5}"#);
    editor.undo().expect("free");
    editor.redo().expect("free");
    editor
}

#[test]
fn a_project_is_saved_and_opened_by_jobs_under_its_own_name() {
    let mut editor = rich();
    let file = save(&mut editor, "Chair");
    assert_eq!(file.name, "Chair.meshwright");
    let mut other = Editor::new();
    let request = other.begin_import(vec![NamedBytes::new("Stool.meshwright", file.bytes.clone())]);
    let Ok(Finished::Done(outcome)) = do_job(&mut other, &request) else { panic!("opened") };
    assert_eq!(outcome.message, "Opened Stool: 12 vertices, 18 edges and 10 faces");
    assert_eq!((outcome.op.name(), other.document().name()), ("open", "Stool"), "the file was renamed");
    assert_eq!(outcome.warnings, [""; 0]);
    assert_eq!(state(&other), state(&editor));
    assert_eq!(other.view(), Some(r#"{"yaw":0.5}"#));
    assert_eq!(labels_of_project(&other), labels(&editor));
    // Saved again, nothing is lost.
    let again = save(&mut other, "Chair");
    let (third, warnings) = open(&again.bytes);
    assert_eq!((state(&third), warnings), (state(&editor), Vec::new()));
    assert_eq!(third.view(), editor.view());
}

#[test]
fn a_new_shape_begins_the_history() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "new", "shape": "torus"}));
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    let (opened, warnings) = open(&Project::of(&editor).write());
    assert_eq!(warnings, [""; 0]);
    assert_eq!(labels_of_project(&opened), ["Poke faces"]);
    // What was before the shape is another document.
    editor.undo().expect("free");
    editor.undo().expect("free");
    assert_eq!(editor.document().objects().len(), 2);
    let (opened, warnings) = open(&Project::of(&editor).write());
    assert_eq!((state(&opened), warnings), (state(&editor), Vec::new()));
}

#[test]
fn a_long_history_begins_later() {
    let mut editor = on_cube();
    for step in 0..4500 {
        let to = [f64::from(step) / 1000.0, 0.0, 0.0];
        run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": to}));
    }
    let project = Project::of(&editor);
    assert!((1000..=2000).contains(&project.logged()), "{}", project.logged());
    let (opened, warnings) = open(&project.write());
    assert_eq!((state(&opened), warnings), (state(&editor), Vec::new()));
    assert_eq!(labels_of_project(&opened).len(), project.logged());
}

#[test]
fn a_history_that_takes_too_long_is_left_out_and_said() {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 100, "rows": 100}));
    for _ in 0..60 {
        run(&mut editor, json!({"op": "smooth", "iterations": 3}));
    }
    let (opened, warnings) = open(&Project::of(&editor).write());
    assert_eq!(state(&opened), state(&editor));
    assert!(warnings[0].contains("too long"), "{warnings:?}");
    assert_eq!(labels_of_project(&opened), [""; 0]);
}

#[test]
fn large_documents_have_no_start_to_copy() {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 500, "rows": 500}));
    // The trail begins with the shape; a break in it has to copy the mesh.
    assert_eq!(Project::of(&editor).logged(), 1);
    let (mut opened, _) = open(&Project::of(&editor).write());
    assert_eq!(Project::of(&opened).logged(), 1, "opened with its history");
    opened.undo().expect("free");
    opened.redo().expect("free");
    run(&mut opened, json!({"op": "poke-faces", "faces": [0]}));
    assert_eq!(Project::of(&opened).logged(), 0);
}

#[test]
fn a_forged_history_is_left_out() {
    let mut editor = rich();
    let honest = Project::of(&editor).write();
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    let other = Project::of(&editor).write();
    // The log of one with the document of the other.
    let forged = swap_section(&other, &honest, "document");
    let (opened, warnings) = open(&forged);
    assert!(warnings[0].contains("history of the project was left out"), "{warnings:?}");
    assert_eq!(sizes(&opened), sizes(&open(&honest).0));
}

/// A file's sections: name and all bytes.
fn sections(file: &[u8]) -> Vec<(String, &[u8])> {
    let mut rest = &file[12..];
    let mut all = Vec::new();
    while !rest.is_empty() {
        let name = String::from_utf8_lossy(&rest[..8]).trim_end_matches('\0').to_owned();
        let stored = u64::from_le_bytes(rest[12..20].try_into().expect("eight bytes")) as usize;
        let (section, after) = rest.split_at(32 + stored);
        all.push((name, section));
        rest = after;
    }
    all
}

fn swap_section(file: &[u8], from: &[u8], name: &str) -> Vec<u8> {
    let theirs = sections(from).into_iter().find(|(own, _)| own == name).expect("there").1;
    let parts = sections(file).into_iter().map(|(own, bytes)| if own == name { theirs } else { bytes });
    let parts: Vec<&[u8]> = parts.collect();
    [&file[..12], &parts.concat()].concat()
}

#[test]
fn sections_of_later_versions_are_skipped_and_missing_ones_named() {
    let file = Project::of(&rich()).write();
    let mut all = sections(&file);
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["about", "document", "view", "start", "log", "end"]);
    // A section that this version doesn't know, with a valid checksum.
    let mut later = all[2].1.to_vec();
    later[..8].copy_from_slice(b"future\0\0");
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(&later[..28]);
    checksum.update(&later[32..]);
    later[28..32].copy_from_slice(&checksum.finalize().to_le_bytes());
    all.insert(2, ("future".to_owned(), &later));
    let join = |all: &[(String, &[u8])]| {
        let bytes: Vec<&[u8]> = all.iter().map(|(_, bytes)| *bytes).collect();
        [&file[..12], &bytes.concat()].concat()
    };
    let (opened, warnings) = open(&join(&all));
    assert_eq!(state(&opened), state(&rich()));
    assert_eq!(warnings, ["The section “future” was left out: this version of Meshwright doesn't know it"]);
    all.retain(|(name, _)| name != "document");
    let error = Project::read(&join(&all)).expect_err("no document");
    assert_eq!(error, "the section “document” is missing");
}

#[test]
fn every_truncated_and_every_damaged_file_is_refused() {
    let file = Project::of(&rich()).write();
    for at in 0..file.len() {
        Project::read(&file[..at]).expect_err("cut off");
        let mut damaged = file.clone();
        damaged[at] ^= 0x10;
        Project::read(&damaged).expect_err("a checksum");
    }
    let mut editor = on_cube();
    let request = editor.begin_import(vec![NamedBytes::new("a.meshwright", &file[..300])]);
    let error = do_job(&mut editor, &request).expect_err("cut off");
    assert_eq!(
        error.to_string(),
        "Could not open a.meshwright. It is incomplete: its end is missing. Download or copy the file again."
    );
    assert_eq!(editor.document(), on_cube().document());
}

#[test]
fn other_files_beside_a_project_are_named() {
    let file = NamedBytes::new("a.meshwright", Project::of(&rich()).write());
    let mut editor = Editor::new();
    let request = editor.begin_import(vec![NamedBytes::new("b.obj", "v 0 0 0"), file]);
    let Ok(Finished::Done(outcome)) = do_job(&mut editor, &request) else { panic!("opened") };
    assert_eq!(outcome.warnings, ["b.obj was left out: a project is opened by itself"]);
}

/// Writes what fuzzing begins with: the files in `fuzz/seeds` that no editor for text makes.
#[test]
#[ignore = "writes into the repository; the seeds stay useful whatever changes"]
fn write_seeds() {
    let editor = &rich();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds");
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.join(name), bytes).expect("writable");
    let project = Project::of(editor);
    write("project/rich.meshwright", &project.write());
    write("link/rich.txt", Link::to(&project).fragment.as_bytes());
    let file = NamedBytes::new(
        "edges.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n",
    );
    let mut repaired = Editor::new();
    let request = repaired.begin_import(vec![file]);
    do_job(&mut repaired, &request).expect("read");
    run(&mut repaired, json!({"op": "delete-faces", "faces": [0]}));
    assert!(repaired.document().objects()[0].is_repairable());
    for (name, editor) in [("rich", editor), ("repaired", &repaired)] {
        let file = Project::of(editor).write();
        let (_, stored) = sections(&file).into_iter().find(|(name, _)| name == "document").expect("there");
        let mut bytes = Vec::new();
        let mut inflater = flate2::read::DeflateDecoder::new(&stored[32..]);
        std::io::Read::read_to_end(&mut inflater, &mut bytes).expect("its own");
        write(&format!("document/{name}.bin"), &bytes);
    }
    let mut shaped = Editor::new();
    shaped.start_with(command(json!({"op": "new", "shape": "octahedron"}))).expect("a shape");
    write("link/octahedron.txt", Link::to(&Project::of(&shaped)).fragment.as_bytes());
}

#[test]
fn files_of_version_1_stay_readable() {
    let path = fixtures::fixture("projects/version-1.meshwright");
    let file = std::fs::read(&path).expect("readable");
    let (opened, warnings) = open(&file);
    assert_eq!(warnings, [""; 0], "its history too: commands must go on giving the same bits");
    let expected = rich();
    assert_eq!(state(&opened), state(&expected));
    assert_eq!(opened.view(), expected.view());
    assert_eq!(labels_of_project(&opened), labels(&expected));
}
