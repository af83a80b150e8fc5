//! The log of changes and snapshots: whatever is done, and wherever the bytes end, what is recovered is a state that the
//! document was in.

mod support;

use editor::formats::{Model, NamedBytes};
use editor::halfedge::Element;
use editor::halfedge::geometry::BitSet;
use editor::recovery::{Entry, Event, Snapshot, SnapshotCopy, append_record, new_log, read_log};
use editor::{Begun, Editor, JobRequest, JobResult, NamedSelection, SelectBy, SelectMode, Selection, Wire};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::sync::Arc;
use support::random::*;
use support::*;

/// What is kept outside the program.
#[derive(Clone)]
struct Disk {
    snapshot: Vec<u8>,
    log: Vec<u8>,
}

impl Disk {
    /// Keeps an editor's document, and what is done in it from here on.
    fn of(editor: &mut Editor) -> Self {
        editor.start_log();
        let mut disk = Self { snapshot: Vec::new(), log: new_log() };
        assert!(disk.take_snapshot(editor, 997), "nothing is ongoing");
        disk
    }

    /// Whether a snapshot could be taken.
    fn take_snapshot(&mut self, editor: &mut Editor, part_bytes: usize) -> bool {
        let Some(mut copy) = SnapshotCopy::begin(editor) else { return false };
        let mut bytes = Vec::new();
        while !copy.is_done() {
            let mut part = 0;
            let goes_on = copy.step(editor, part_bytes, &mut |piece| {
                part += piece.len();
                bytes.extend_from_slice(piece);
            });
            assert!(goes_on && part <= part_bytes);
        }
        assert_eq!(bytes.len(), copy.total_bytes());
        *self = Self { snapshot: bytes, log: new_log() };
        true
    }

    fn append(&mut self, entries: &[Entry]) {
        entries.iter().for_each(|entry| append_record(&mut self.log, entry));
    }

    fn entries(&self) -> Vec<Entry> {
        read_log(&self.log).entries
    }

    fn recover(&self) -> Editor {
        let records = read_log(&self.log);
        let mut editor = Snapshot::from_bytes(&self.snapshot).expect("whole").into_editor();
        for entry in records.entries {
            if entry.event == Event::Break {
                break;
            }
            editor.replay(entry.clone()).unwrap_or_else(|error| panic!("{entry:?}: {error}"));
        }
        editor.end_replay();
        validate(&editor);
        editor
    }
}

/// Everything that has to be recovered. Previews take identities of objects, so those may differ.
#[derive(Clone, Debug, PartialEq)]
struct State {
    model: Model,
    objects: Vec<(bool, Arc<BitSet>, Vec<NamedSelection>)>,
    active: usize,
    selection: Selection,
    is_dirty: bool,
    revision: u64,
}

fn state(editor: &Editor) -> State {
    let document = editor.document();
    let objects = document.objects().iter();
    State {
        model: document.to_model(document.name()),
        objects: objects.map(|o| (o.visible(), o.hidden().clone(), o.named_selections().to_vec())).collect(),
        active: document.active_index(),
        selection: editor.selection().clone(),
        is_dirty: editor.is_dirty(),
        revision: editor.revision(),
    }
}

/// Something that a user or a script does.
#[derive(Clone, Debug)]
enum Deed {
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

fn any_deed() -> impl Strategy<Value = Deed> {
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

fn run_job(request: &JobRequest) -> Result<JobResult, editor::CommandError> {
    request.run(&mut |_| ControlFlow::Continue(()))
}

/// A job that was begun, as a command's or an adjustment's.
fn keep(jobs: &mut Vec<JobRequest>, begun: Result<Begun, editor::CommandError>) {
    if let Ok(Begun::Job(request)) = begun {
        jobs.push(request);
    }
}

fn act(editor: &mut Editor, jobs: &mut Vec<JobRequest>, disk: &mut Disk, deed: &Deed) {
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
        Deed::Snapshot(bytes) => {
            let entries = editor.take_log();
            disk.append(&entries);
            disk.take_snapshot(editor, bytes);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]

    #[test]
    fn whatever_is_done_is_recovered(deeds in prop::collection::vec(any_deed(), 1..40)) {
        let mut editor = on_two();
        let mut disk = Disk::of(&mut editor);
        let mut jobs = Vec::new();
        for deed in &deeds {
            act(&mut editor, &mut jobs, &mut disk, deed);
            disk.append(&editor.take_log());
            if editor.is_editing() || editor.is_selecting() {
                // Only drafts keep what is shown, and only the result of selecting is kept.
                continue;
            }
            if editor.needs_snapshot() {
                prop_assert!(disk.take_snapshot(&mut editor, 1 << 20));
            }
            let waits = !jobs.is_empty();
            let recovered = disk.recover();
            prop_assert!(state(&recovered) == state(&editor), "after {:?}: {:#?}", deed, disk.entries());
            if !waits {
                // As many steps can be undone as were made since the snapshot.
                prop_assert!(recovered.undo_labels().count() <= editor.undo_labels().count());
            }
        }
    }

    #[test]
    fn a_log_that_ends_anywhere_gives_an_earlier_state(
        deeds in prop::collection::vec(any_deed(), 1..12),
        damage in any::<prop::sample::Index>(),
        flip in 1u8..=255,
    ) {
        let mut editor = on_two();
        let mut disk = Disk::of(&mut editor);
        let mut jobs = Vec::new();
        for deed in deeds.iter().filter(|deed| !matches!(deed, Deed::Open | Deed::Snapshot(_))) {
            act(&mut editor, &mut jobs, &mut disk, deed);
            disk.append(&editor.take_log());
        }
        let whole = read_log(&disk.log);
        prop_assert_eq!((whole.valid_bytes, whole.is_cut_off), (disk.log.len(), false));
        let (mut torn, mut damaged) = (disk.clone(), disk.clone());
        let at = damage.index(disk.log.len());
        torn.log.truncate(at);
        damaged.log[at] ^= flip;
        for broken in [torn, damaged] {
            let read = read_log(&broken.log);
            prop_assert!(read.valid_bytes <= at);
            prop_assert_eq!(&read.entries[..], &whole.entries[..read.entries.len()]);
            broken.recover();
        }
    }
}

/// A log of a few entries, and the editor that it is of.
fn small_log() -> (Editor, Disk) {
    let mut editor = on_cube();
    let mut disk = Disk::of(&mut editor);
    editor.select(Element::Face, [1], SelectMode::Replace).expect("a face");
    run(&mut editor, json!({"op": "extrude-faces", "distance": 0.5}));
    editor.undo().expect("free");
    editor.redo().expect("free");
    editor.update_edit(command(json!({"op": "inset-faces", "faces": [0], "amount": 0.25}))).expect("a face");
    editor.log_draft();
    disk.append(&editor.take_log());
    (editor, disk)
}

#[test]
fn every_byte_of_a_log_may_be_the_last_or_damaged() {
    let (_, disk) = small_log();
    let whole = read_log(&disk.log).entries;
    assert_eq!(whole.len(), 5);
    for at in 0..disk.log.len() {
        let mut torn = disk.clone();
        torn.log.truncate(at);
        let mut damaged = disk.clone();
        damaged.log[at] ^= 0x55;
        for broken in [torn, damaged] {
            let read = read_log(&broken.log);
            assert!(read.valid_bytes <= at, "byte {at}");
            assert_eq!(read.entries, whole[..read.entries.len()]);
            broken.recover();
        }
    }
}

#[test]
fn every_byte_of_a_snapshot_may_be_missing() {
    let (_, disk) = small_log();
    for at in 0..disk.snapshot.len() {
        assert!(Snapshot::from_bytes(&disk.snapshot[..at]).is_err(), "byte {at}");
    }
}

#[test]
fn an_edit_that_had_not_ended_is_committed() {
    let (mut editor, disk) = small_log();
    let mut recovered = disk.recover();
    assert!(!recovered.is_editing());
    editor.commit_edit();
    assert_eq!(recovered.document(), editor.document());
    assert_eq!(recovered.undo_labels().last(), Some("Inset faces"));
    // The history goes back to the snapshot.
    recovered.jump_to(0).expect("free");
    assert_eq!(recovered.document(), on_cube().document());
}

#[test]
fn a_cancelled_drag_leaves_no_trace() {
    let (mut editor, mut disk) = small_log();
    editor.cancel_edit();
    editor.select(Element::Face, [2], SelectMode::Replace).expect("a face");
    disk.append(&editor.take_log());
    assert_eq!(state(&disk.recover()), state(&editor));
}

#[test]
fn an_entry_of_an_edit_is_small_on_a_large_mesh() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 200}));
    let mut disk = Disk::of(&mut editor);
    editor.select_all(Element::Vertex);
    run(&mut editor, json!({"op": "transform", "translate": [0, 1, 0]}));
    editor.select(Element::Vertex, [40_000], SelectMode::Replace).expect("a vertex");
    run(&mut editor, json!({"op": "transform", "translate": [0, 0, 1]}));
    let entries = editor.take_log();
    let sizes: Vec<usize> = entries.iter().map(Wire::byte_len).collect();
    assert!(sizes[0] < 40_401 / 8 + 200, "a bit for each vertex: {sizes:?}");
    assert!(sizes[1..].iter().all(|size| *size < 250), "{sizes:?}");
    disk.append(&entries);
    assert_eq!(state(&disk.recover()), state(&editor));
}

#[test]
fn a_snapshot_is_worthless_once_the_document_changed() {
    let mut editor = on_cube();
    editor.start_log();
    let mut copy = SnapshotCopy::begin(&editor).expect("nothing is ongoing");
    assert!(copy.step(&mut editor, 100, &mut |_| {}));
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    assert!(!copy.step(&mut editor, 100, &mut |_| {}));
    let mut copy = SnapshotCopy::begin(&editor).expect("nothing is ongoing");
    editor.rename_document("A longer name");
    assert!(!copy.step(&mut editor, 100, &mut |_| {}), "a name is no step");
    editor.undo().expect("free");
    let mut copy = SnapshotCopy::begin(&editor).expect("nothing is ongoing");
    assert!(copy.step(&mut editor, 100, &mut |_| {}));
    editor.update_edit(command(json!({"op": "inset-faces", "faces": [0], "amount": 0.25}))).expect("a face");
    assert!(!copy.step(&mut editor, 100, &mut |_| {}));
    assert!(SnapshotCopy::begin(&editor).is_none(), "a preview is no part of the document");
}

#[test]
fn undoing_past_the_snapshot_needs_another() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    let mut disk = Disk::of(&mut editor);
    run(&mut editor, json!({"op": "poke-faces", "faces": [1]}));
    editor.undo().expect("free");
    assert!(!editor.needs_snapshot());
    editor.undo().expect("free");
    assert!(editor.needs_snapshot());
    disk.append(&editor.take_log());
    assert_eq!(sizes(&disk.recover()), [9, 16, 9], "the last state that could be replayed");
    assert!(disk.take_snapshot(&mut editor, 1 << 20));
    assert_eq!(state(&disk.recover()), state(&editor));
}
