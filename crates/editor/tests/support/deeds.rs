//! Random things that a user or a script does.

use super::command;
use super::random::{any_command, any_element};
use editor::formats::NamedBytes;
use editor::halfedge::Element;
use editor::{Begun, Editor, JobRequest, JobResult, SelectBy, SelectMode};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::ops::ControlFlow;

/// Something that a user or a script does.
#[derive(Clone, Debug)]
pub enum Deed {
    Run(Value),
    Adjust(Value),
    Drag(Value),
    Commit,
    Cancel,
    Select(Element, Vec<u32>, SelectMode),
    Stroke(u32, u64),
    Related(SelectBy),
    SwitchKind(Element, bool),
    All(Element),
    Undo,
    UndoStep,
    Redo,
    RedoStep,
    Jump(usize),
    Begin(Value),
    AdjustAsJob(Value),
    Finish,
    Fail,
    Save,
    Name,
    Open,
    Draft,
    Snapshot(usize),
}

fn any_selecting() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(json!({"op": "select-boundary", "kind": "edge"})),
        Just(json!({"op": "select-all", "kind": "face"})),
        Just(json!({"op": "hide"})),
        Just(json!({"op": "reveal"})),
        Just(json!({"op": "name-selection", "name": "Rim"})),
        Just(json!({"op": "extrude-faces", "distance": 0.5})),
        Just(json!({"op": "transform", "translate": [0.5, 0, 0.25], "falloff": 1.5})),
        Just(json!({"op": "delete-faces"})),
    ]
}

fn any_run() -> impl Strategy<Value = Value> {
    prop_oneof![3 => any_command(), 1 => any_selecting()]
}

pub fn any_deed() -> impl Strategy<Value = Deed> {
    let modes = vec![SelectMode::Replace, SelectMode::Extend, SelectMode::Toggle, SelectMode::Remove];
    let ids = prop::collection::vec(0u32..12, 0..5);
    let related = vec![SelectBy::Grow, SelectBy::Shrink, SelectBy::Linked, SelectBy::Kind(Element::Face)];
    prop_oneof![
        6 => any_run().prop_map(Deed::Run),
        2 => any_run().prop_map(Deed::Adjust),
        4 => any_run().prop_map(Deed::Drag),
        1 => Just(Deed::Commit),
        1 => Just(Deed::Cancel),
        4 => (any_element(), ids, prop::sample::select(modes)).prop_map(|(k, i, m)| Deed::Select(k, i, m)),
        2 => (0u32..12, 0u64..3).prop_map(|(id, stroke)| Deed::Stroke(id, stroke)),
        1 => prop::sample::select(related).prop_map(Deed::Related),
        1 => (any_element(), any::<bool>()).prop_map(|(kind, touches)| Deed::SwitchKind(kind, touches)),
        1 => any_element().prop_map(Deed::All),
        2 => Just(Deed::Undo),
        2 => Just(Deed::UndoStep),
        1 => Just(Deed::Redo),
        2 => Just(Deed::RedoStep),
        1 => (0usize..6).prop_map(Deed::Jump),
        3 => any_run().prop_map(Deed::Begin),
        1 => any_run().prop_map(Deed::AdjustAsJob),
        3 => Just(Deed::Finish),
        1 => Just(Deed::Fail),
        1 => Just(Deed::Save),
        1 => Just(Deed::Name),
        1 => Just(Deed::Open),
        1 => Just(Deed::Draft),
        1 => (1usize..5000).prop_map(Deed::Snapshot),
    ]
}

pub fn run_job(request: &JobRequest) -> Result<JobResult, editor::CommandError> {
    request.run(&mut |_| ControlFlow::Continue(()))
}

/// A job that was begun, as a command's or an adjustment's.
fn keep(jobs: &mut Vec<JobRequest>, begun: Result<Begun, editor::CommandError>) {
    if let Ok(Begun::Job(request)) = begun {
        jobs.push(request);
    }
}

/// Does something; jobs that it begins wait in `jobs`.
pub fn act(editor: &mut Editor, jobs: &mut Vec<JobRequest>, deed: &Deed) {
    let faces =
        |editor: &Editor| editor.document().objects().iter().map(|o| o.mesh().face_count()).sum::<usize>();
    let is_large = faces(editor) > 800;
    match deed.clone() {
        Deed::Run(_) | Deed::Adjust(_) | Deed::Drag(_) | Deed::Begin(_) | Deed::AdjustAsJob(_)
            if is_large => {}
        Deed::Run(value) => drop(editor.run(command(value))),
        Deed::Adjust(value) => keep(jobs, editor.adjust(command(value))),
        Deed::Drag(value) => drop(editor.update_edit(command(value))),
        Deed::Commit => drop(editor.commit_edit()),
        Deed::Cancel => drop(editor.cancel_edit()),
        Deed::Select(kind, ids, mode) => drop(editor.select(kind, ids, mode)),
        Deed::Stroke(id, stroke) => {
            drop(editor.select_in_stroke(Element::Vertex, [id], SelectMode::Extend, stroke));
        }
        Deed::Related(by) => drop(editor.select_by(by)),
        Deed::SwitchKind(kind, touches) => editor.switch_kind(kind, touches),
        Deed::All(kind) => editor.select_all(kind),
        Deed::Undo => drop(editor.undo()),
        Deed::UndoStep => drop(editor.undo_step()),
        Deed::Redo => drop(editor.redo()),
        Deed::RedoStep => drop(editor.redo_step()),
        Deed::Jump(to) => drop(editor.jump_to(to)),
        Deed::Begin(value) => keep(jobs, editor.begin_from(command(value), 1)),
        Deed::AdjustAsJob(value) => keep(jobs, editor.adjust_from(command(value), 1)),
        Deed::Finish if !jobs.is_empty() => {
            let request = jobs.remove(0);
            let _ = editor.finish(request.id(), run_job(&request));
        }
        Deed::Fail if !jobs.is_empty() => {
            editor.cancel_job(jobs.remove(0).id());
        }
        Deed::Finish | Deed::Fail => {}
        Deed::Save => editor.mark_saved(editor.revision()),
        Deed::Name => editor.rename_document("Saved"),
        Deed::Open => {
            let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec();
            let files = vec![NamedBytes { name: "Tri.obj".into(), bytes: text }];
            let import = run_job(&JobRequest::import(files)).expect("a triangle").into_import();
            editor.open(import.expect("an import")).expect("valid");
        }
        Deed::Draft => editor.log_draft(),
        // Only who keeps the document knows where.
        Deed::Snapshot(_) => {}
    }
}
