//! Several tabs, and what the list asks for: what one does is no failure of another, and nothing refused stops keeping.

use crate::visitor::{Visitor, answers, describe, info, keep, names, record};
use meshwright_worker::store::*;

#[test]
fn a_duplicate_can_be_opened_and_written_by_another_tab() {
    let disk = MemoryDisk::default();
    let mut first = Visitor::new(&disk);
    keep(&mut first, "a", b"the checkpoint");
    first.ask(Request::Duplicate { id: "a".into(), copy: "c".into(), name: "Copy".into() }, &[]);
    let mut second = Visitor::new(&disk);
    let (checkpoint, log, opened) = second.open("c").expect("whole");
    assert_eq!((checkpoint.as_slice(), names(&log)), (&b"the checkpoint"[..], vec!["one".to_owned()]));
    assert_eq!((opened.is_copy, opened.info.shown_name()), (false, "Copy"));
    second.ask(Request::Append("c".into()), &record("two"));
    for _ in 0..3 {
        assert_eq!(answers(second.checkpoint("c", b"later")), [Answer::Checked("c".into())]);
        assert_eq!(second.ask(describe("c", info("Copy")), &[]), []);
        assert_eq!(disk.contents()["c"].len(), 3, "a checkpoint, a log and an info");
    }
}

#[test]
fn a_file_that_cannot_be_removed_is_no_failure_of_the_checkpoint() {
    let disk = MemoryDisk::default();
    keep(&mut Visitor::new(&disk), "a", b"the checkpoint");
    let mut visitor = Visitor::new(&disk);
    visitor.open("a").expect("whole");
    let mut other = disk.tab();
    for file in ["checkpoint-1", "info-1"] {
        now_or_never(other.append("a", file, b"")).expect("no waiting").expect("nobody writes it");
    }
    assert_eq!(answers(visitor.checkpoint("a", b"second")), [Answer::Checked("a".into())]);
    assert_eq!(visitor.ask(describe("a", info("Second")), &[]), []);
    assert!(disk.contents()["a"].contains_key("checkpoint-1"), "the other tab holds it");
    drop(other);
    assert_eq!(answers(visitor.checkpoint("a", b"third")), [Answer::Checked("a".into())]);
    assert_eq!(visitor.ask(describe("a", info("Third")), &[]), []);
    let names: Vec<String> = disk.contents()["a"].keys().cloned().collect();
    assert_eq!(names, ["checkpoint-3", "info-3", "log-3"]);
}

#[test]
fn a_checkpoint_in_the_other_tab_while_a_copy_is_made_only_delays_the_copy() {
    let disk = MemoryDisk::default();
    let mut first = Visitor::new(&disk);
    keep(&mut first, "a", b"the first");
    let before = disk.contents();
    first.checkpoint("a", b"the second");
    first.ask(describe("a", info("Second")), &[]);
    let after = disk.contents();
    disk.set_contents(before);
    disk.replace_before_next_read(after);
    let (checkpoint, _, opened) = Visitor::new(&disk).open("a").expect("a copy");
    assert_eq!((checkpoint.as_slice(), opened.is_copy), (&b"the second"[..], true));
    assert_eq!(opened.info.shown_name(), "Second");
}

#[test]
fn a_record_that_another_tab_is_writing_is_left_out_of_a_copy() {
    let disk = MemoryDisk::default();
    let mut first = Visitor::new(&disk);
    keep(&mut first, "a", b"the checkpoint");
    disk.fail_after(5, Failure::Other("not yet".into()));
    first.ask(Request::Append("a".into()), &record("half"));
    disk.mend();
    let (_, log, opened) = Visitor::new(&disk).open("a").expect("a copy");
    assert_eq!((names(&log), opened.is_cut_off), (vec!["one".to_owned()], false));
}

#[test]
fn the_list_bears_what_other_tabs_do_meanwhile() {
    let disk = MemoryDisk::default();
    let mut first = Visitor::new(&disk);
    keep(&mut first, "a", b"a");
    let before = disk.contents();
    first.ask(describe("a", info("Renamed")), &[]);
    let after = disk.contents();
    let mut second = Visitor::new(&disk);
    disk.set_contents(before.clone());
    disk.replace_before_next_read(after);
    let shown: Vec<Kept> = second.list();
    assert_eq!(shown.iter().map(|kept| kept.info.shown_name()).collect::<Vec<_>>(), ["Renamed"]);

    disk.set_contents(before);
    disk.replace_before_next_read(Contents::default());
    assert_eq!(second.list(), []);
}

#[test]
fn what_the_list_cannot_do_is_refused_and_keeping_goes_on() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    keep(&mut visitor, "a", &[1; 400]);
    let duplicate = |id: &str| Request::Duplicate { id: id.into(), copy: "c".into(), name: "Copy".into() };
    let refused = |visitor: &mut Visitor, request: Request| match &answers(visitor.ask(request, &[]))[..] {
        [Answer::Refused(refusal), Answer::Listed { documents, .. }] => {
            assert_eq!(documents.iter().map(|kept| kept.id.as_str()).collect::<Vec<_>>(), ["a"]);
            refusal.clone()
        }
        told => panic!("{told:?}"),
    };
    let missing = Refusal::NotCopied(WhyNot::Missing);
    assert_eq!(refused(&mut visitor, duplicate("nowhere")), missing);
    let rename = Request::Rename { id: "nowhere".into(), name: "Name".into() };
    assert_eq!(refused(&mut visitor, rename), Refusal::NotChanged(Failure::Missing));
    let used = disk.used();
    disk.set_quota(Some(used + 300));
    let full = Refusal::NotCopied(WhyNot::Failed(Failure::Full));
    assert_eq!(refused(&mut visitor, duplicate("a")), full);
    assert_eq!(disk.used(), used, "no half of a copy stays");
    visitor.ask(Request::Append("a".into()), &record("two"));
    drop(visitor);
    assert_eq!(Visitor::new(&disk).open("a").map(|(_, log, _)| names(&log).len()), Ok(2));
}

#[test]
fn what_is_meant_for_another_document_does_nothing() {
    let disk = MemoryDisk::default();
    let mut visitor = Visitor::new(&disk);
    keep(&mut visitor, "a", b"a");
    keep(&mut visitor, "b", b"b");
    let before = disk.contents();
    visitor.ask(describe("a", info("Wrong")), &[]);
    visitor.ask(Request::Append("a".into()), &record("wrong"));
    visitor.ask(Request::Picture("a".into()), b"wrong");
    assert_eq!(visitor.checkpoint("a", b"wrong"), []);
    assert_eq!(disk.contents(), before);
}

#[test]
fn where_documents_may_be_in_a_place_that_cannot_be_read_none_is_said_to_be_gone() {
    let failure = Failure::Other("it is busy".into());
    let mut documents = Documents::new(MemoryDisk::default().tab()).beside_unreadable(Some(failure.clone()));
    let mut told = Vec::new();
    let open = Request::Open { id: "a".into(), copy: "copy".into() };
    now_or_never(documents.handle(open, &[], &mut |answer, _| told.push(answer))).expect("no waiting");
    assert_eq!(told, [Answer::NotOpened { opening: "copy".into(), why: WhyNot::Failed(failure) }]);
}
