//! What other versions wrote: earlier ones are read, later ones stay as they are.

use crate::visitor::{Visitor, answers, describe, info, keep, names, record};
use editor::recovery::{Snapshot, new_log, read_log};
use editor::{Editor, Wire};
use meshwright_worker::store::*;
use std::fs;

/// Changes a file of document "a" on a disk that nobody uses.
fn with(edit: impl Fn(&mut std::collections::BTreeMap<String, Vec<u8>>)) -> MemoryDisk {
    let disk = MemoryDisk::default();
    keep(&mut Visitor::new(&disk), "a", b"the checkpoint");
    let mut contents = disk.contents();
    edit(contents.get_mut("a").expect("the folder"));
    disk.set_contents(contents);
    disk
}

/// A record of an event that only a later version knows, with the right checksum.
fn later_record() -> Vec<u8> {
    let known = record("one");
    let entry = String::from_utf8(known[8..].to_vec()).expect("it is text but for its head");
    let entry = entry.replace("\"name\"", "\"nome\"").into_bytes();
    let len = (entry.len() as u32).to_le_bytes();
    let checksum = crc32fast::hash(&[&len[..], &entry].concat()).to_le_bytes();
    [&len[..], &checksum, &entry].concat()
}

#[test]
fn what_a_later_version_wrote_is_not_opened_and_stays_as_it_is() {
    let header = with(|files| files.get_mut("log-1").expect("the log")[7] = 2);
    let event = with(|files| files.get_mut("log-1").expect("the log").extend(later_record()));
    let seal = with(|files| {
        let checkpoint = files.get_mut("checkpoint-1").expect("the checkpoint");
        let version = checkpoint.len() - 13;
        assert_eq!(checkpoint[version], 1);
        checkpoint[version] = 2;
    });
    let snapshot = MemoryDisk::default();
    keep(&mut Visitor::new(&snapshot), "a", b"MWsnap\0\x02 as later versions write it");
    let newer = with(|files| {
        // A later version had begun a checkpoint of its own, and not yet removed the older one.
        let mut later = files["checkpoint-1"].clone();
        let version = later.len() - 13;
        later[version] = 2;
        files.insert("checkpoint-2".into(), later);
    });
    for (name, disk) in
        [("header", header), ("event", event), ("seal", seal), ("snapshot", snapshot), ("newer", newer)]
    {
        let before = disk.contents();
        let mut visitor = Visitor::new(&disk);
        assert_eq!(visitor.open("a").map(drop), Err(WhyNot::Later), "{name}");
        let duplicate = Request::Duplicate { id: "a".into(), copy: "c".into(), name: "Copy".into() };
        let told = answers(visitor.ask(duplicate, &[]));
        assert_eq!(told[0], Answer::Refused(Refusal::NotCopied(WhyNot::Later)), "{name}");
        assert_eq!(visitor.list().len(), 1, "{name}: it is listed");
        assert_eq!(disk.contents(), before, "{name}");
        let holder = &mut disk.tab();
        assert_eq!(now_or_never(holder.lock("a")), Some(true), "{name}: a later version can open it");
        assert_eq!(visitor.open("a").map(drop), Err(WhyNot::Later), "{name}: a copy is none either");
        assert_eq!(disk.contents(), before, "{name}");
    }
}

#[test]
fn a_log_is_told_from_one_of_a_later_version() {
    let later = [new_log(), record("one"), later_record(), record("two")].concat();
    let records = read_log(&later);
    assert_eq!((records.entries.len(), records.is_later), (1, true));
    let damaged = [new_log(), record("one"), record("two")[..20].to_vec()].concat();
    assert!(!read_log(&damaged).is_later);
}

#[test]
fn only_complete_checkpoints_are_listed_and_opened() {
    let torn = |bytes: &[u8]| bytes[..bytes.len() - 1].to_vec();
    let only = with(|files| {
        let checkpoint = torn(&files["checkpoint-1"]);
        files.insert("checkpoint-1".into(), checkpoint);
    });
    let mut visitor = Visitor::new(&only);
    assert_eq!(visitor.list(), []);
    assert_eq!(visitor.open("a").map(drop), Err(WhyNot::Damaged));

    let newer = with(|files| {
        let checkpoint = torn(&files["checkpoint-1"]);
        files.insert("checkpoint-2".into(), checkpoint);
    });
    let mut visitor = Visitor::new(&newer);
    assert_eq!(visitor.list().len(), 1);
    let (checkpoint, log, _) = visitor.open("a").expect("the older one");
    assert_eq!((checkpoint.as_slice(), names(&log)), (&b"the checkpoint"[..], vec!["one".to_owned()]));
    visitor.ask(describe("a", info("a")), &[]);
    assert_eq!(answers(visitor.checkpoint("a", b"third")), [Answer::Checked("a".into())]);
}

/// The document of this folder in `crates/fixtures/files/kept`.
fn kept(version: &str) -> MemoryDisk {
    let files = fs::read_dir(fixtures::fixture(&format!("kept/{version}"))).expect("a folder");
    let files = files.map(|entry| {
        let entry = entry.expect("a file");
        (entry.file_name().into_string().expect("letters"), fs::read(entry.path()).expect("a file"))
    });
    let disk = MemoryDisk::default();
    disk.set_contents([("a".to_owned(), files.collect())].into());
    disk
}

fn recover(disk: &MemoryDisk) -> (Editor, Opened) {
    let (checkpoint, log, opened) = Visitor::new(disk).open("a").expect("whole");
    let mut editor = Snapshot::from_bytes(&checkpoint).expect("a snapshot").into_editor();
    let records = read_log(&log);
    assert!(!records.is_cut_off && !records.entries.is_empty());
    records.entries.into_iter().for_each(|entry| editor.replay(entry).expect("done"));
    editor.end_replay();
    (editor, opened)
}

#[test]
fn documents_that_version_1_kept_are_read() {
    let disk = kept("version-1");
    let picture = match Visitor::new(&disk).ask(Request::List, &[]).pop() {
        Some((Answer::Listed { documents, .. }, pictures)) => {
            assert_eq!(documents[0].info.shown_name(), "Kept");
            pictures
        }
        answer => panic!("{answer:?}"),
    };
    assert_eq!(picture, b"a picture");
    let (editor, opened) = recover(&disk);
    assert_eq!((opened.info.name.as_str(), opened.info.sizes), ("Cube", [1, 12, 10]));
    assert_eq!(opened.info.renamed.as_deref(), Some("Kept"));
    assert!(opened.info.is_touched && !opened.is_cut_off);
    assert_eq!(editor.mesh().map(|mesh| mesh.face_count()), Some(13));
    assert_eq!(editor.undo_labels().collect::<Vec<_>>(), ["Poke faces"]);
}
