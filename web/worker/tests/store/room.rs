//! Room: nothing that is no longer needed takes any, and a full disk does no harm.

use crate::visitor::{NOW_MS, Visitor, answers, describe, info, keep, names, record};
use meshwright_worker::store::*;

const DAY_MS: f64 = 24.0 * 3600.0 * 1000.0;

fn sweep(visitor: &mut Visitor, now_ms: f64) {
    assert_eq!(visitor.ask(Request::Sweep { now_ms }, &[]), []);
}

fn folders(disk: &MemoryDisk) -> Vec<String> {
    disk.contents().into_keys().collect()
}

#[test]
fn what_visits_leave_behind_is_swept_but_nothing_that_a_tab_shows() {
    let disk = MemoryDisk::default();
    let mut first = Visitor::new(&disk);
    keep(&mut first, "shown", b"shown");
    let mut untouched = Visitor::new(&disk);
    keep(&mut untouched, "untouched", b"untouched");
    untouched.ask(describe("untouched", Info { is_touched: false, ..info("untouched") }), &[]);
    // A page that ended while it wrote its first checkpoint.
    untouched.ask(Request::Begin("incomplete".into()), &[]);
    untouched.ask(describe("incomplete", info("incomplete")), &[]);
    untouched.begin_checkpoint("incomplete", b"half", NOW_MS);
    let with_incomplete = disk.contents();
    drop(untouched);
    disk.set_contents(with_incomplete);
    let mut second = Visitor::new(&disk);
    assert!(second.open("shown").expect("a copy").2.is_copy);

    let mut third = Visitor::new(&disk);
    sweep(&mut third, NOW_MS);
    assert_eq!(folders(&disk), ["copy", "incomplete", "shown"], "another tab shows the copy");
    sweep(&mut third, NOW_MS + 2.0 * DAY_MS);
    assert_eq!(folders(&disk), ["copy", "shown"]);
    drop((first, second));
    sweep(&mut third, NOW_MS + 3.0 * DAY_MS);
    assert_eq!(folders(&disk), ["shown"]);
}

#[test]
fn without_locks_another_tab_may_show_what_looks_left_behind() {
    let disk = MemoryDisk::default();
    disk.take_locks_away();
    let mut first = Visitor::new(&disk);
    first.ask(Request::Begin("a".into()), &[]);
    first.ask(describe("a", Info { is_touched: false, ..info("a") }), &[]);
    first.checkpoint("a", b"untouched so far");
    sweep(&mut Visitor::new(&disk), NOW_MS + 2.0 * DAY_MS);
    assert_eq!(folders(&disk), ["a"]);
}

#[test]
fn deleted_documents_make_room_once_nobody_can_ask_for_them_any_more() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    keep(&mut visitor, "large", &[7; 1000]);
    keep(&mut visitor, "a", b"small");
    visitor.ask(Request::Delete { id: "large".into(), now_ms: NOW_MS }, &[]);
    disk.set_quota(Some(disk.used() + 100));
    let full = [Answer::Failed(Failure::Full)];
    assert_eq!(answers(visitor.checkpoint_at("a", &[8; 500], NOW_MS + 6000.0)), full);
    visitor.ask(Request::Restore("large".into()), &[]);
    assert_eq!(visitor.list().len(), 2, "undo brings it back");

    visitor.ask(Request::Delete { id: "large".into(), now_ms: NOW_MS }, &[]);
    let later_ms = NOW_MS + MIN_RESTORABLE_MS + 1.0;
    assert_eq!(answers(visitor.checkpoint_at("a", &[8; 500], later_ms)), [Answer::Checked("a".into())]);
    assert_eq!(folders(&disk), ["a"]);
    drop(visitor);
    assert_eq!(Visitor::new(&disk).open("a").expect("whole").0, [8; 500]);
}

#[test]
fn a_document_can_be_deleted_where_there_is_no_room_at_all() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    keep(&mut visitor, "large", b"large");
    visitor.ask(Request::Picture("large".into()), &[5; 400]);
    keep(&mut visitor, "a", b"a");
    disk.set_quota(Some(disk.used()));
    let told = answers(visitor.ask(Request::Delete { id: "large".into(), now_ms: NOW_MS }, &[]));
    assert!(matches!(&told[..], [Answer::Listed { documents, .. }] if documents.len() == 1), "{told:?}");
}

#[test]
fn a_document_that_is_being_restored_or_copied_makes_no_room() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    keep(&mut visitor, "large", &[7; 1000]);
    keep(&mut visitor, "a", b"small");
    visitor.ask(Request::Delete { id: "large".into(), now_ms: NOW_MS }, &[]);
    sweep(&mut visitor, NOW_MS + DAY_MS / 2.0);
    disk.set_quota(Some(disk.used()));
    let refused = Answer::Refused(Refusal::NotChanged(Failure::Full));
    assert_eq!(answers(visitor.ask(Request::Restore("large".into()), &[]))[0], refused);
    assert!(folders(&disk).contains(&"large".to_owned()));
}

#[test]
fn checkpoints_that_fail_leave_nothing_behind() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    keep(&mut visitor, "a", b"the checkpoint");
    let used = disk.used();
    disk.set_quota(Some(used + 300));
    for _ in 0..4 {
        // The first half fits.
        assert_eq!(answers(visitor.checkpoint("a", &[1; 500])), [Answer::Failed(Failure::Full)]);
        assert_eq!(disk.used(), used);
    }
    // The page may begin again, or end, in the middle of one.
    for _ in 0..3 {
        assert_eq!(visitor.begin_checkpoint("a", &[2; 200], NOW_MS), []);
        assert_eq!(disk.used(), used + 200);
    }
    drop(visitor);
    let mut visitor = Visitor::new(&disk);
    let (checkpoint, log, opened) = visitor.open("a").expect("whole");
    assert_eq!((checkpoint.as_slice(), names(&log)), (&b"the checkpoint"[..], vec!["one".to_owned()]));
    assert!(!opened.is_cut_off);
    assert_eq!(disk.used(), used);
    assert_eq!(answers(visitor.checkpoint("a", &[3; 200])), [Answer::Checked("a".into())]);
}

#[test]
fn a_document_is_opened_although_there_is_no_room_to_begin_its_log() {
    let disk = MemoryDisk::default();
    keep(&mut Visitor::new(&disk), "a", b"the checkpoint");
    let mut contents = disk.contents();
    contents.get_mut("a").expect("the folder").remove("log-1").expect("the log");
    disk.set_contents(contents);
    disk.set_quota(Some(disk.used()));
    let mut visitor = Visitor::new(&disk);
    let told = answers(visitor.ask(Request::Open { id: "a".into(), copy: "copy".into() }, &[]));
    assert!(matches!(&told[..], [Answer::Part { .. }, Answer::Opened(_), Answer::Failed(Failure::Full)]));
    disk.set_quota(None);
    assert_eq!(answers(visitor.checkpoint("a", b"later")), [Answer::Checked("a".into())]);
    visitor.ask(Request::Append("a".into()), &record("two"));
    drop(visitor);
    let (checkpoint, log, _) = Visitor::new(&disk).open("a").expect("whole");
    assert_eq!((checkpoint.as_slice(), names(&log)), (&b"later"[..], vec!["two".to_owned()]));
}
