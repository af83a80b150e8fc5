//! The log of changes and snapshots: whatever is done, and wherever the bytes end, what is recovered is a state that the
//! document was in.

mod support;

use editor::halfedge::Element;
use editor::project::Project;
use editor::recovery::{Entry, Event, Snapshot, SnapshotCopy, append_record, new_log, read_log};
use editor::{Begun, Editor, JobRequest, SelectMode, Wire};
use proptest::prelude::*;
use serde_json::json;
use support::contents::Contents;
use support::deeds::*;
use support::*;

/// What is kept outside the program.
#[derive(Clone)]
struct Disk {
    snapshot: Vec<u8>,
    log: Vec<u8>,
    /// The first bytes of a snapshot that is being copied.
    begun: Vec<u8>,
}

impl Disk {
    /// Keeps an editor's document, and what is done in it from here on.
    fn of(editor: &mut Editor) -> Self {
        editor.start_log();
        let mut disk = Self { snapshot: Vec::new(), log: new_log(), begun: Vec::new() };
        assert!(disk.take_snapshot(editor, 997), "nothing is ongoing");
        disk
    }

    /// Whether a snapshot could be taken.
    fn take_snapshot(&mut self, editor: &mut Editor, part_bytes: usize) -> bool {
        let Some(copy) = SnapshotCopy::begin(editor) else { return false };
        self.finish_snapshot(editor, copy, part_bytes);
        true
    }

    /// Takes the place of what was kept by a snapshot and what was done since it was begun.
    fn finish_snapshot(&mut self, editor: &mut Editor, mut copy: SnapshotCopy, part_bytes: usize) {
        let mut bytes = std::mem::take(&mut self.begun);
        while !copy.is_done() {
            let mut part = 0;
            copy.step(part_bytes, &mut |piece| {
                part += piece.len();
                bytes.extend_from_slice(piece);
            });
            assert!(part <= part_bytes);
        }
        assert_eq!(bytes.len(), copy.total_bytes());
        *self = Self { snapshot: bytes, log: new_log(), begun: Vec::new() };
        copy.finish(editor);
        self.append(&editor.take_log());
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

/// Everything that has to be recovered: the contents, whether they are saved, and the revision.
fn state(editor: &Editor) -> (Contents, bool, u64) {
    let contents = Contents::named(editor, editor.document().name());
    (contents, editor.is_dirty(), editor.revision())
}

/// Does something, or begins a snapshot or ends the one that was begun.
fn act_or_keep(
    editor: &mut Editor,
    jobs: &mut Vec<JobRequest>,
    disk: &mut Disk,
    copying: &mut Option<SnapshotCopy>,
    deed: &Deed,
) {
    let Deed::Snapshot(bytes) = deed else { return act(editor, jobs, deed) };
    match copying.take() {
        None => *copying = SnapshotCopy::begin(editor),
        Some(_) if editor.has_outdated_copy() => {}
        Some(copy) => disk.finish_snapshot(editor, copy, *bytes),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(192))]

    #[test]
    fn whatever_is_done_is_recovered(deeds in prop::collection::vec(any_deed(), 1..40)) {
        let mut editor = on_two();
        let mut disk = Disk::of(&mut editor);
        let (mut jobs, mut copying) = (Vec::new(), None);
        for deed in &deeds {
            act_or_keep(&mut editor, &mut jobs, &mut disk, &mut copying, deed);
            disk.append(&editor.take_log());
            if editor.is_editing() || editor.is_selecting() {
                // Only drafts keep what is shown, and only the result of selecting is kept.
                continue;
            }
            if editor.needs_snapshot() {
                copying = None;
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
            act(&mut editor, &mut jobs, deed);
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
fn editing_goes_on_while_a_snapshot_is_copied() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    let mut disk = Disk::of(&mut editor);
    let mut copy = SnapshotCopy::begin(&mut editor).expect("nothing is ongoing");
    copy.step(100, &mut |part| disk.begun.extend_from_slice(part));
    let before = state(&editor);
    run(&mut editor, json!({"op": "poke-faces", "faces": [1]}));
    editor.rename_document("A longer name");
    editor.update_edit(command(json!({"op": "inset-faces", "faces": [0], "amount": 0.25}))).expect("a face");
    editor.commit_edit();
    assert!(!editor.has_outdated_copy());
    // The page ends before the copy does: the last snapshot has everything.
    disk.append(&editor.take_log());
    assert_eq!(state(&disk.recover()), state(&editor));
    // It ends after that: the new one has everything, too.
    disk.finish_snapshot(&mut editor, copy, 64);
    assert_eq!(state(&disk.recover()), state(&editor));
    let bare = Disk { log: new_log(), ..disk.clone() };
    assert_eq!(state(&bare.recover()), before, "the snapshot is of the moment at which it was begun");

    editor.update_edit(command(json!({"op": "inset-faces", "faces": [0], "amount": 0.25}))).expect("a face");
    assert!(SnapshotCopy::begin(&mut editor).is_none(), "a preview is no part of the document");
    editor.cancel_edit();
    // Undoing more than was done since makes a copy worthless, but not the last snapshot.
    let _copy = SnapshotCopy::begin(&mut editor).expect("nothing is ongoing");
    editor.undo().expect("free");
    assert!(editor.has_outdated_copy() && !editor.needs_snapshot());
    disk.append(&editor.take_log());
    assert_eq!(state(&disk.recover()), state(&editor));
}

#[test]
fn the_log_of_a_document_ends_where_another_takes_its_place() {
    let mut editor = on_cube();
    let mut disk = Disk::of(&mut editor);
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    let (origin, before) = (editor.document().origin(), state(&editor));
    run(&mut editor, json!({"op": "new", "shape": "tetrahedron"}));
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    disk.append(&editor.take_log_of(origin));
    assert_eq!(state(&disk.recover()), before);
    assert!(editor.take_log().is_empty());
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

#[test]
fn an_edit_that_changed_nothing_leaves_the_selection_that_was() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "new", "shape": "tetrahedron"}));
    let mut disk = Disk::of(&mut editor);
    let before = state(&editor);
    // A triangle stays as it is; what it would leave selected is nothing that undo could bring back.
    editor.update_edit(command(json!({"op": "triangulate-faces", "faces": [0]}))).expect("previewed");
    editor.commit_edit();
    assert_eq!(state(&editor), before);
    disk.append(&editor.take_log());
    assert_eq!(state(&disk.recover()), before);
}

#[test]
fn faces_that_were_hidden_while_a_job_kept_their_deletion_are_no_longer_hidden() {
    let mut editor = on_two();
    let mut disk = Disk::of(&mut editor);
    run(&mut editor, json!({"op": "select-all", "kind": "face"}));
    run(&mut editor, json!({"op": "delete-faces"}));
    let Ok(Begun::Job(request)) =
        editor.adjust_from(command(json!({"op": "separate", "by": "components"})), 1)
    else {
        panic!("a job")
    };
    run(&mut editor, json!({"op": "hide"}));
    assert_eq!(editor.document().active().expect("the cube").hidden().len(), 6);
    editor.cancel_job(request.id());
    let cube = editor.document().active().expect("the cube");
    assert_eq!((cube.mesh().face_count(), cube.hidden().len()), (0, 0));
    assert!(disk.take_snapshot(&mut editor, 1 << 20));
    assert_eq!(state(&disk.recover()), state(&editor));
    while editor.next_undo().is_some() {
        editor.undo().expect("undone");
        validate(&editor);
    }
    assert_eq!(editor.mesh().expect("the cube").face_count(), 6);
}

#[test]
fn pieces_are_named_after_what_the_object_was_called_when_their_job_began() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "join-objects", "objects": [0, 1]}));
    let mut disk = Disk::of(&mut editor);
    let Ok(Begun::Job(request)) =
        editor.begin_from(command(json!({"op": "separate", "by": "components"})), 1)
    else {
        panic!("a job")
    };
    run(&mut editor, json!({"op": "rename-object", "object": 0, "name": "Dice"}));
    editor.finish(request.id(), run_job(&request)).expect("two pieces");
    let names: Vec<&str> = editor.document().objects().iter().map(|object| object.name()).collect();
    assert_eq!(names, ["Dice", "Cube 2"]);
    disk.append(&editor.take_log());
    let mut recovered = disk.recover();
    assert_eq!(state(&recovered), state(&editor));
    // What is repeated is kept, and repeated once more.
    let trail = Project::of(&recovered).write();
    let opened = Project::read(&trail).expect("its own");
    let mut other = on_two();
    assert_eq!(other.open_project(opened).warnings, [""; 0]);
    recovered.undo().expect("free");
    assert_eq!(recovered.document().objects().len(), 1);
}
