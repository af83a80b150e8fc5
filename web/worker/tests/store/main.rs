//! The store of documents: wherever writing ends, what is opened afterwards is a state that was complete.

mod room;
mod tabs;
mod versions;
mod visitor;

use editor::recovery::{SnapshotCopy, append_record, read_log};
use editor::{Command, Editor};
use meshwright_worker::store::*;
use visitor::{Visitor, describe, info, names, record};

/// Everything that is written in the life of a document, and the states that it goes through: a checkpoint and the
/// records after it.
fn write_all(visitor: &mut Visitor) {
    visitor.ask(Request::Begin("a".into()), &[]);
    visitor.ask(describe("a", info("First")), &[]);
    visitor.checkpoint("a", b"the first checkpoint");
    visitor.ask(Request::Append("a".into()), &record("one"));
    visitor.ask(Request::Append("a".into()), &record("two"));
    visitor.checkpoint("a", b"the second checkpoint, a longer one");
    visitor.ask(describe("a", info("Second")), &[]);
    visitor.ask(Request::Append("a".into()), &record("three"));
    visitor.ask(Request::Picture("a".into()), b"a picture");
    visitor.ask(Request::Append("a".into()), &record("four"));
}

const STATES: [(&str, &[&str]); 6] = [
    ("the first checkpoint", &[]),
    ("the first checkpoint", &["one"]),
    ("the first checkpoint", &["one", "two"]),
    ("the second checkpoint, a longer one", &[]),
    ("the second checkpoint, a longer one", &["three"]),
    ("the second checkpoint, a longer one", &["three", "four"]),
];

fn state_of(checkpoint: &[u8], log: &[u8]) -> usize {
    let names = names(log);
    let is = |(state, records): &(&str, &[&str])| state.as_bytes() == checkpoint && names == *records;
    STATES.iter().position(is).unwrap_or_else(|| panic!("{checkpoint:?} {names:?} was never complete"))
}

#[test]
fn wherever_power_fails_the_document_is_in_one_of_its_states_and_goes_on_from_there() {
    let mut last = 0;
    let mut seen = [false; STATES.len()];
    for limit in 0..100_000 {
        let disk = MemoryDisk::default();
        // After the limit nothing is written or removed: the power has failed.
        disk.fail_after(limit, Failure::Other("no power".into()));
        write_all(&mut Visitor::new(&disk));
        disk.mend();
        let mut visitor = Visitor::new(&disk);
        match visitor.open("a") {
            Ok((checkpoint, log, _)) => {
                let state = state_of(&checkpoint, &log);
                assert!(state >= last, "after {limit} bytes, less is there than after fewer");
                (last, seen[state]) = (state, true);
                visitor.ask(Request::Append("a".into()), &record("more"));
                let (_, log, opened) = Visitor::new(&disk_without_locks(&disk)).open("a").expect("whole");
                assert_eq!(names(&log).last().map(String::as_str), Some("more"), "after {limit} bytes");
                assert_eq!(names(&log).len(), STATES[state].1.len() + 1);
                assert!(!opened.is_cut_off);
                assert!(!visitor.checkpoint("a", b"later").is_empty());
                let (checkpoint, log, _) = Visitor::new(&disk_without_locks(&disk)).open("a").expect("whole");
                assert_eq!((checkpoint.as_slice(), names(&log).len()), (&b"later"[..], 0));
            }
            Err(why) => {
                assert!(last == 0 && !seen[0], "after {limit} bytes: {why:?}");
                visitor.ask(Request::Begin("a".into()), &[]);
                visitor.checkpoint("a", b"later");
                let (checkpoint, ..) = Visitor::new(&disk_without_locks(&disk)).open("a").expect("whole");
                assert_eq!(checkpoint, b"later");
            }
        }
        if last == STATES.len() - 1 {
            assert_eq!(seen, [true; STATES.len()]);
            return;
        }
    }
    panic!("the limit was never enough");
}

/// The same contents on a disk that no tab has locked.
fn disk_without_locks(disk: &MemoryDisk) -> MemoryDisk {
    let copy = MemoryDisk::default();
    copy.set_contents(disk.contents());
    copy
}

#[test]
fn a_damaged_byte_or_a_file_that_ends_early_is_never_taken_for_the_document() {
    let disk = MemoryDisk::default();
    write_all(&mut Visitor::new(&disk));
    let whole = disk.contents();
    let files: Vec<(String, usize)> =
        whole["a"].iter().map(|(name, bytes)| (name.clone(), bytes.len())).collect();
    assert_eq!(files.len(), 4, "old files are removed: {files:?}");
    let check = |contents: Contents, what: &str| {
        let disk = MemoryDisk::default();
        disk.set_contents(contents);
        match Visitor::new(&disk).open("a") {
            Ok((checkpoint, log, _)) => {
                assert_eq!(checkpoint, STATES[5].0.as_bytes(), "{what}");
                assert!(
                    STATES[5].1.starts_with(&names(&log).iter().map(String::as_str).collect::<Vec<_>>()),
                    "{what}"
                );
            }
            // The versions of the log and of the seal have no checksum.
            Err(WhyNot::Later) => {
                assert!(["log-2, byte 7", "checkpoint-2, byte 42"].contains(&what), "{what}")
            }
            Err(why) => assert_eq!(why, WhyNot::Damaged, "{what}"),
        }
    };
    for (name, len) in files {
        for at in 0..len {
            let mut damaged = whole.clone();
            let file = damaged.get_mut("a").and_then(|folder| folder.get_mut(&name)).expect("the file");
            file[at] ^= 0x10;
            check(damaged.clone(), &format!("{name}, byte {at}"));
            let file = damaged.get_mut("a").and_then(|folder| folder.get_mut(&name)).expect("the file");
            file[at] ^= 0x10;
            file.truncate(at);
            check(damaged, &format!("{name}, {at} bytes long"));
        }
    }
}

#[test]
fn a_checkpoint_and_a_log_are_a_document() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    let mut editor = Editor::new();
    editor.start_log();
    let run = |editor: &mut Editor, json: serde_json::Value| {
        let command: Command = Command::from_json(&json.to_string()).expect("a command");
        editor.run(command).expect("done");
    };
    run(&mut editor, serde_json::json!({"op": "new", "shape": "cube"}));
    let mut bytes = Vec::new();
    let mut copy = SnapshotCopy::begin(&mut editor).expect("nothing is ongoing");
    copy.step(usize::MAX, &mut |part| bytes.extend_from_slice(part));
    copy.finish(&mut editor);
    visitor.ask(Request::Begin("a".into()), &[]);
    assert_eq!(visitor.checkpoint("a", &bytes), [(Answer::Checked("a".into()), Bytes::new())]);
    run(&mut editor, serde_json::json!({"op": "triangulate-faces", "faces": [0]}));
    for entry in editor.take_log() {
        let mut bytes = Vec::new();
        append_record(&mut bytes, &entry);
        assert_eq!(visitor.ask(Request::Append("a".into()), &bytes), []);
    }
    drop(visitor);
    let (checkpoint, log, _) = Visitor::new(&disk).open("a").expect("whole");
    let snapshot = <editor::recovery::Snapshot as editor::Wire>::from_bytes(&checkpoint).expect("a snapshot");
    let mut again = snapshot.into_editor();
    read_log(&log).entries.into_iter().for_each(|entry| again.replay(entry).expect("done"));
    assert_eq!(again.mesh(), editor.mesh());
}

#[test]
fn documents_are_listed_renamed_copied_deleted_and_restored() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    write_all(&mut visitor);
    visitor.ask(Request::Begin("b".into()), &[]);
    visitor.ask(describe("b", Info { changed_ms: 9.0, ..info("Other") }), &[]);
    visitor.checkpoint("b", b"other");
    visitor.ask(Request::Begin("untouched".into()), &[]);
    visitor.ask(describe("untouched", Info { is_touched: false, ..info("Untouched") }), &[]);
    visitor.checkpoint("untouched", b"untouched");
    let shown = |visitor: &mut Visitor| -> Vec<(String, String)> {
        visitor.list().into_iter().map(|kept| (kept.id.clone(), kept.info.shown_name().to_owned())).collect()
    };
    let pair = |id: &str, name: &str| (id.to_owned(), name.to_owned());
    assert_eq!(shown(&mut visitor), [pair("b", "Other"), pair("a", "Second")]);
    match visitor.ask(Request::List, &[]).pop() {
        Some((Answer::Listed { documents, picture_bytes }, pictures)) => {
            assert_eq!((picture_bytes.as_slice(), pictures.as_slice()), (&[0, 9][..], &b"a picture"[..]));
            let sizes: usize = disk.contents()["a"].values().map(Vec::len).sum();
            assert_eq!(documents[1].bytes, sizes as u64);
        }
        answer => panic!("{answer:?}"),
    }

    visitor.ask(Request::Rename { id: "b".into(), name: "Renamed".into() }, &[]);
    assert_eq!(shown(&mut visitor), [pair("b", "Renamed"), pair("a", "Second")]);
    visitor.ask(Request::Duplicate { id: "a".into(), copy: "c".into(), name: "Second copy".into() }, &[]);
    assert!(shown(&mut visitor).contains(&pair("c", "Second copy")));
    assert_eq!(
        Visitor::new(&disk).open("c").map(|(_, log, _)| names(&log)),
        Ok(vec!["three".into(), "four".into()])
    );

    visitor.ask(Request::Delete { id: "a".into(), now_ms: 1000.0 }, &[]);
    assert!(!shown(&mut visitor).contains(&pair("a", "Second")));
    visitor.ask(Request::Sweep { now_ms: 2000.0 }, &[]);
    visitor.ask(Request::Restore("a".into()), &[]);
    assert!(shown(&mut visitor).contains(&pair("a", "Second")));
    visitor.ask(Request::Delete { id: "a".into(), now_ms: 1000.0 }, &[]);
    visitor.ask(Request::Sweep { now_ms: 1000.0 + 25.0 * 3600.0 * 1000.0 }, &[]);
    visitor.ask(Request::Restore("a".into()), &[]);
    assert!(
        !disk
            .contents()
            .get("a")
            .is_some_and(|folder| folder.keys().any(|name| name.starts_with("checkpoint")))
    );
    assert!(!shown(&mut visitor).iter().any(|(id, _)| id == "a"));
    assert!(disk.contents().contains_key("untouched"), "this tab shows it");
    drop(visitor);
    Visitor::new(&disk).ask(Request::Sweep { now_ms: 0.0 }, &[]);
    assert!(!disk.contents().contains_key("untouched"));
}

#[test]
fn a_document_that_another_tab_shows_is_neither_written_nor_deleted() {
    let disk = MemoryDisk::default();
    let mut first = Visitor::new(&disk);
    write_all(&mut first);
    let mut second = Visitor::new(&disk);
    assert_eq!(second.ask(Request::Begin("a".into()), &[]), [(Answer::Busy("a".into()), Bytes::new())]);
    assert_eq!(second.ask(Request::Append("a".into()), &record("lost")), []);
    let refused = (Answer::Refused(Refusal::IsOpen), Bytes::new());
    assert_eq!(second.ask(Request::Delete { id: "a".into(), now_ms: 0.0 }, &[]), [refused]);
    assert!(second.list()[0].is_open);
    let (_, log, opened) = second.open("a").expect("a copy");
    assert_eq!((opened.id.as_str(), opened.is_copy, opened.info.is_touched), ("copy", true, false));
    assert_eq!(names(&log), ["three", "four"]);
    second.ask(Request::Append("copy".into()), &record("mine"));
    first.ask(Request::Append("a".into()), &record("yours"));
    drop((first, second));
    let mut third = Visitor::new(&disk);
    assert_eq!(third.open("a").map(|(_, log, _)| names(&log)[2..].to_vec()), Ok(vec!["yours".to_owned()]));
    assert_eq!(third.open("copy").map(|(_, log, _)| names(&log)[2..].to_vec()), Ok(vec!["mine".to_owned()]));
    assert_eq!(third.open("nowhere").map(drop), Err(WhyNot::Missing));
}

#[test]
fn after_a_failure_nothing_is_written_until_the_next_checkpoint() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    write_all(&mut visitor);
    disk.fail_after(3, Failure::Full);
    assert_eq!(
        visitor.ask(Request::Append("a".into()), &record("torn")),
        [(Answer::Failed(Failure::Full), Bytes::new())]
    );
    disk.mend();
    assert_eq!(visitor.ask(Request::Append("a".into()), &record("after it")), []);
    let (_, log, opened) = Visitor::new(&disk_without_locks(&disk)).open("a").expect("whole");
    assert!(opened.is_cut_off);
    assert_eq!(names(&log), ["three", "four"]);
    assert_eq!(visitor.checkpoint("a", b"whole again"), [(Answer::Checked("a".into()), Bytes::new())]);
    visitor.ask(Request::Append("a".into()), &record("five"));
    let (checkpoint, log, _) = Visitor::new(&disk_without_locks(&disk)).open("a").expect("whole");
    assert_eq!((checkpoint.as_slice(), names(&log)), (&b"whole again"[..], vec!["five".to_owned()]));
}
