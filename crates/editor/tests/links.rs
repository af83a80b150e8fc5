//! Links that hold documents.

mod support;

use editor::formats::NamedBytes;
use editor::halfedge::Element;
use editor::project::{Link, LinkKind, Project};
use editor::{Editor, Finished, JobRequest, JobResult, SelectMode, Wire};
use proptest::prelude::*;
use serde_json::json;
use support::deeds::*;
use support::*;

fn link(editor: &Editor) -> Link {
    Link::to(&Project::of(editor))
}

fn open(fragment: &str) -> Result<Editor, String> {
    let mut editor = Editor::new();
    editor.open_project(Link::read(fragment)?);
    validate(&editor);
    Ok(editor)
}

/// What a link keeps of a document.
fn shared(editor: &Editor) -> impl PartialEq + std::fmt::Debug + use<> {
    let document = editor.document();
    let mut model = document.to_model(document.name());
    model.objects.iter_mut().for_each(|object| object.soup = None);
    let objects = document.objects().iter();
    let rest: Vec<_> =
        objects.map(|o| (o.visible(), o.hidden().clone(), o.named_selections().to_vec())).collect();
    (model, rest, document.active_index())
}

/// A document that began as a shape.
fn shaped() -> Editor {
    let mut editor = Editor::new();
    editor.start_with(command(json!({"op": "new", "shape": "cube"}))).expect("a cube");
    editor
}

#[test]
fn commands_that_lead_from_a_shape_are_shorter() {
    let mut editor = shaped();
    assert!(link(&editor).fragment.len() < 110, "{}", link(&editor).fragment);
    editor.select(Element::Face, [2], SelectMode::Replace).expect("a face");
    editor.select(Element::Face, [1], SelectMode::Replace).expect("a face");
    run(&mut editor, json!({"op": "extrude-faces", "distance": 0.5}));
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    editor.undo().expect("free");
    run(&mut editor, json!({"op": "subdivide-catmull-clark", "levels": 2}));
    editor.select(Element::Vertex, [1, 2, 3], SelectMode::Replace).expect("vertices");
    editor.rename_document("Lamp");
    let made = link(&editor);
    assert_eq!(made.kind, LinkKind::Commands);
    assert!(made.fragment.starts_with("#d=1") && made.fragment.len() < 300, "{}", made.fragment);
    let opened = open(&made.fragment).expect("its own");
    assert_eq!(shared(&opened), shared(&editor));
    assert_eq!(opened.document().name(), "Lamp");
    assert!(!opened.is_dirty());
    let labels: Vec<&str> = opened.undo_labels().collect();
    assert_eq!(labels[1..].iter().filter(|label| label.contains("Extrude")).count(), 1, "{labels:?}");
}

#[test]
fn other_documents_are_sent_as_meshes() {
    let editor = on_two();
    let made = link(&editor);
    assert_eq!(made.kind, LinkKind::Meshes);
    assert!(made.fragment.len() < 900, "{}", made.fragment.len());
    assert_eq!(shared(&open(&made.fragment).expect("its own")), shared(&editor));
    // An edit that can't be repeated exactly where it was made.
    let mut editor = shaped();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 3, "rows": 3, "add": true}));
    run(&mut editor, json!({"op": "set-face-color", "faces": [0], "color": "#ff0000"}));
    assert_eq!(shared(&open(&link(&editor).fragment).expect("its own")), shared(&editor));
}

#[test]
fn documents_that_are_too_large_have_no_link() {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 500, "rows": 500}));
    assert!(editor.begin_share().is_none());
    let mut editor = on_cube();
    // Without order, so that nothing compresses.
    run(&mut editor, json!({"op": "subdivide-catmull-clark", "levels": 6}));
    assert_eq!(link(&editor).fragment, "");
}

#[test]
fn jobs_make_and_open_links() {
    let mut editor = shaped();
    let request = editor.begin_share().expect("small");
    let request = JobRequest::from_bytes(&request.to_bytes()).expect("its own");
    let result = JobResult::from_bytes(&run_job(&request).expect("made").to_bytes()).expect("its own");
    let Ok(Finished::Shared(made)) = editor.finish(request.id(), Ok(result)) else { panic!("a link") };
    assert_eq!(made, link(&editor));
    for text in [made.fragment.clone(), format!(" https://example.org/editor/?a=b{}\n", made.fragment)] {
        let mut other = Editor::new();
        let request = other.begin_import(vec![NamedBytes::new("Pasted.obj", text)]);
        let Ok(Finished::Done(outcome)) = other.finish(request.id(), run_job(&request)) else {
            panic!("opened")
        };
        assert_eq!(outcome.message, "Opened Cube: 8 vertices, 12 edges and 6 faces");
    }
    for text in ["# d=1x\nv 0 0 0", "see https://example.org/#d=1x", "#d=1 x", "v 1 2 3 #d=1x"] {
        assert_eq!(Link::find(text), None, "{text}");
    }
}

#[test]
fn every_truncated_and_every_damaged_link_is_refused_in_words() {
    for fragment in [link(&shaped()).fragment, link(&on_two()).fragment] {
        open(&fragment).expect("its own");
        for at in 0..fragment.len() {
            let error = open(&fragment[..at]).expect_err("cut off");
            assert_eq!(error, "The link is damaged or incomplete: copy it again, to its end.", "{at}");
            for other in ["A", "_", "7", "=", "é"] {
                if fragment.is_char_boundary(at) && &fragment[at..=at] != other {
                    let damaged = format!("{}{other}{}", &fragment[..at], &fragment[at + 1..]);
                    open(&damaged).expect_err("damaged");
                }
            }
        }
    }
    assert!(open("#d=2abc").expect_err("later").contains("later version"));
    assert!(open(&format!("#d=1{}", "A".repeat(200_000))).expect_err("long").contains("too long"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn whatever_was_done_is_in_the_link(deeds in prop::collection::vec(any_deed(), 1..30)) {
        let mut editor = shaped();
        let mut jobs = Vec::new();
        for deed in &deeds {
            act(&mut editor, &mut jobs, deed);
        }
        editor.commit_edit();
        let made = link(&editor);
        prop_assert!(!made.fragment.is_empty());
        let opened = open(&made.fragment).expect("its own");
        prop_assert_eq!(shared(&opened), shared(&editor));
    }
}
