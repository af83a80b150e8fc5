//! Documents are kept in the browser: whenever the page ends, the next visit goes on where it was.

use crate::page::Page;
use editor::{CommandError, ErrorKind};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use halfedge::{Element, Mesh};
use meshwright_web::platform::headless::Outside;
use meshwright_web::platform::store::{Contents, Failure};
use meshwright_web::platform::{Event, NamedBytes};
use serde_json::{Value, json};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn extrude(page: &mut Page) {
    page.select("face", &[1]);
    page.command(json!({"op": "extrude-faces", "distance": 0.5}));
}

/// Everything that has to come back.
fn state(page: &mut Page) -> (Mesh, (Element, Vec<u32>), Vec<Value>, bool) {
    let view = page.app().script().state()["view"].clone();
    let camera = ["target", "yaw", "pitch", "distance", "orthographic"].map(|name| view[name].clone());
    (page.mesh().clone(), page.selected(), camera.to_vec(), page.app().editor().is_dirty())
}

fn faces(page: &mut Page) -> usize {
    page.mesh().face_count()
}

fn name(page: &mut Page) -> String {
    page.app().editor().document().name().to_owned()
}

/// Lets so much time go by that everything is written.
fn settle(page: &mut Page) {
    page.run();
    page.outside.advance(6000.0);
    page.run();
}

#[test]
fn a_reload_brings_back_the_document_its_history_its_selection_and_its_view() {
    let mut page = Page::new();
    extrude(&mut page);
    page.command(json!({"op": "poke-faces"}));
    page.select("edge", &[2, 3]);
    let camera = state(&mut page).2;
    page.press(Key::ArrowLeft);
    assert_ne!(state(&mut page).2, camera, "the key turns the view");
    settle(&mut page);
    let before = state(&mut page);
    let labels = page.undo_labels();
    let mut page = page.reload();
    assert_eq!(state(&mut page), before);
    assert_eq!(page.undo_labels(), labels);

    // What is done after a recovery is kept too.
    page.command(json!({"op": "triangulate-faces", "faces": [2]}));
    let before = state(&mut page);
    let mut page = page.reload();
    assert_eq!(state(&mut page), before);
    for _ in 0..3 {
        page.app().script().undo().expect("a step");
        page.run();
    }
    assert_eq!(faces(&mut page), 6, "undo goes back to the cube");
    let mut page = page.reload();
    assert_eq!(faces(&mut page), 6);
    page.app().script().redo().expect("a step");
    page.run();
    assert_eq!(faces(&mut page), 10);
}

#[test]
fn an_edit_is_kept_in_the_frame_in_which_it_is_made() {
    let mut page = Page::new();
    page.select("face", &[1]);
    page.app().script().run(json!({"op": "extrude-faces", "distance": 0.5}), Box::new(|_| {}));
    page.harness.step();
    let mut page = page.reload();
    assert_eq!(faces(&mut page), 10);
}

#[test]
fn a_drag_that_had_not_ended_is_kept_but_for_the_last_two_seconds() {
    let mut page = Page::new();
    page.select("vertex", &[0]);
    let before = page.mesh().clone();
    page.press(Key::G);
    page.hover_off_middle(egui::vec2(40.0, 10.0));
    page.outside.advance(2500.0);
    page.hover_off_middle(egui::vec2(80.0, 20.0));
    page.harness.step();
    let dragged = page.mesh().clone();
    assert_ne!(dragged, before);
    let mut page = page.reload();
    assert_eq!(*page.mesh(), dragged);
    assert_eq!(page.undo_labels().len(), 1);
}

#[test]
fn a_file_that_was_opened_is_there_again_without_an_edit() {
    let mut page = Page::new();
    page.open("tri.obj", TRIANGLE);
    settle(&mut page);
    let mut page = page.reload();
    assert_eq!((faces(&mut page), name(&mut page)), (1, "tri".to_owned()));
    assert!(!page.app().editor().is_dirty());
}

#[test]
fn a_first_visit_keeps_nothing_and_another_one_begins_afresh() {
    let page = Page::new();
    let outside = page.outside.clone();
    drop(page);
    assert_eq!(outside.setting("document"), None);
    outside.open_in_new_tab();
    let page = Page::visit(&outside);
    drop(page);
    assert!(outside.disk().contents().len() <= 2, "documents that nothing was done in are removed");
}

#[test]
fn the_next_visit_opens_the_last_document_and_two_tabs_do_not_overwrite_each_other() {
    let mut first = Page::new();
    extrude(&mut first);
    settle(&mut first);
    let outside = first.outside.clone();
    outside.open_in_new_tab();
    let mut second = Page::visit(&outside);
    assert_eq!(faces(&mut second), 10);
    assert!(second.has_part("This document is open in another tab or window"));
    second.command(json!({"op": "triangulate-faces", "faces": [2]}));
    first.command(json!({"op": "poke-faces"}));
    let (of_first, of_second) = (first.mesh().clone(), second.mesh().clone());
    drop(first);
    let mut second = second.reload();
    assert_eq!(*second.mesh(), of_second);
    drop(second);
    let mut third = visit_first_document(&outside);
    assert_eq!(*third.mesh(), of_first);
    assert!(!third.has_part("open in another tab"));
}

#[test]
fn new_documents_leave_the_old_one_as_it_was_and_undo_goes_back_to_it() {
    let mut page = Page::new();
    extrude(&mut page);
    page.command(json!({"op": "new", "shape": "torus"}));
    let torus = page.mesh().clone();
    let mut page = page.reload();
    assert_eq!(*page.mesh(), torus);
    let old = page.outside.clone();
    drop(page);
    let mut page = visit_first_document(&old);
    assert_eq!(faces(&mut page), 10, "the old document is kept");

    page.command(json!({"op": "new", "shape": "torus"}));
    page.app().script().undo().expect("a step");
    page.run();
    page.command(json!({"op": "poke-faces"}));
    let before = page.mesh().clone();
    let mut page = page.reload();
    assert_eq!(*page.mesh(), before, "what undo brought back is kept as the same document");
    assert_eq!(page.outside.setting("document").as_deref(), Some("document1"));
}

#[test]
fn a_document_that_is_changed_in_the_frame_in_which_it_begins_is_listed() {
    let mut page = Page::new();
    for command in [json!({"op": "new", "shape": "torus"}), json!({"op": "subdivide-linear"})] {
        page.app().script().run(command, Box::new(|answer| assert!(answer.is_ok(), "{answer:?}")));
    }
    settle(&mut page);
    open_list(&mut page);
    listed(&mut page, &["Torus"]);
}

#[test]
fn without_room_it_says_so_editing_goes_on_and_later_everything_is_kept_again() {
    let mut page = Page::new();
    let disk = page.outside.disk();
    disk.fail_after(10, Failure::Full);
    extrude(&mut page);
    settle(&mut page);
    assert!(page.has_part("Changes are not kept: the storage has no more room"));
    page.command(json!({"op": "poke-faces"}));
    let poked = page.mesh().clone();
    disk.mend();
    page.outside.advance(31_000.0);
    settle(&mut page);
    assert!(page.has_part("Changes are kept again."));
    let mut page = page.reload();
    assert_eq!(*page.mesh(), poked);
}

#[test]
fn a_browser_that_keeps_nothing_says_so_with_the_first_change() {
    let outside = Outside::default();
    outside.disk().fail_after(0, Failure::Denied);
    let mut page = Page::visit(&outside);
    settle(&mut page);
    assert!(!page.has_part("Changes are not kept"));
    extrude(&mut page);
    settle(&mut page);
    assert!(page.has_part("the storage may not be written"));
    assert!(page.app().would_lose_changes());
}

/// A visit in another tab, to the first document with damage done to one of its files.
fn visit_damaged(
    outside: &Outside,
    mut contents: Contents,
    file: &str,
    damage: impl Fn(&mut Vec<u8>),
) -> Page {
    let folder = contents.get_mut("document1").expect("the document");
    damage(folder.iter_mut().find(|(name, _)| name.starts_with(file)).expect("one").1);
    outside.disk().set_contents(contents);
    visit_first_document(outside)
}

/// What a visit leaves behind in which the cube was extruded.
fn after_a_visit() -> Outside {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    page.outside.clone()
}

/// A visit in another tab that goes on with the first document.
fn visit_first_document(outside: &Outside) -> Page {
    outside.set_setting("document", "document1");
    outside.open_in_new_tab();
    Page::visit(outside)
}

#[test]
fn a_document_that_is_gone_or_damaged_is_named_and_the_page_begins_afresh() {
    let outside = after_a_visit();
    let whole = outside.disk().contents();

    outside.disk().set_contents(Default::default());
    let mut page = Page::visit(&outside);
    assert!(page.has_part("has been removed from the storage"));
    assert_eq!(faces(&mut page), 6);
    drop(page);

    let mut page = visit_damaged(&outside, whole.clone(), "checkpoint", |bytes| bytes[40] ^= 1);
    assert!(page.has_part("is damaged or incomplete"));
    assert_eq!(faces(&mut page), 6);
    drop(page);

    let mut page = visit_damaged(&outside, whole, "log", |bytes| bytes.truncate(bytes.len() - 1));
    assert!(page.has_part("The last change was not completely written"));
    extrude(&mut page);
    let before = page.mesh().clone();
    let mut page = page.reload();
    assert_eq!(*page.mesh(), before, "the log goes on after the cut");
}

#[test]
fn a_tab_whose_document_was_swept_begins_afresh_without_a_word() {
    let mut page = Page::new();
    settle(&mut page);
    page.outside.disk().set_contents(Default::default());
    let mut page = page.reload();
    assert!(!page.has_part("The last document is gone"));
    extrude(&mut page);
    settle(&mut page);
    page.outside.disk().set_contents(Default::default());
    let page = page.reload();
    assert!(page.has_part("The last document is gone"));
}

#[test]
fn a_store_that_does_not_answer_does_not_keep_the_page_waiting() {
    let outside = after_a_visit();
    outside.hang_store(true);
    let mut page = Page::begin_visit(&outside);
    assert!(page.app().is_opening());
    page.outside.advance(9000.0);
    settle(&mut page);
    assert!(!page.app().is_opening());
    assert!(page.has_part("The last document can't be opened"));
    assert_eq!(faces(&mut page), 6);
}

#[test]
fn leaving_asks_nothing_once_everything_is_kept_and_the_browser_is_asked_to_keep_it() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    assert!(page.app().editor().is_dirty());
    assert!(!page.app().would_lose_changes());
    assert_eq!(page.outside.persists(), 0);
    for _ in 0..6 {
        page.command(json!({"op": "triangulate-faces", "faces": [2]}));
        page.press_with(Modifiers::CTRL, Key::Z);
        extrude(&mut page);
    }
    settle(&mut page);
    assert_eq!(page.outside.persists(), 1);
}

/// The names in the window with the list.
fn listed(page: &mut Page, names: &[&str]) {
    for name in names {
        assert!(page.has(&format!("Name of {name}")), "{name} is listed");
    }
    assert!(page.has_part(&format!("{} document", names.len())), "no others are");
}

fn open_list(page: &mut Page) {
    page.click("File");
    page.click("Recent documents…");
}

fn rename(page: &mut Page, from: &str, to: &str) {
    page.find(&format!("Name of {from}")).focus();
    page.run();
    page.press_with(Modifiers::COMMAND, Key::A);
    page.type_text(to);
    page.run();
    page.press(Key::Enter);
}

#[test]
fn when_power_fails_in_the_first_checkpoint_the_document_before_is_opened() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    let (outside, before) = (page.outside.clone(), page.mesh().clone());
    outside.disk().fail_after(100, Failure::Other("no power".into()));
    page.command(json!({ "op": "new", "shape": "torus" }));
    drop(page);
    outside.disk().mend();
    let mut page = Page::visit(&outside);
    assert_eq!((name(&mut page), page.mesh().clone()), ("Cube".to_owned(), before));
}

#[test]
fn when_power_fails_after_an_undo_to_before_the_checkpoint_the_document_goes_on() {
    for bytes in (0..3000).step_by(250) {
        let mut page = Page::new();
        extrude(&mut page);
        settle(&mut page);
        // The store that takes its place gets a checkpoint, which holds no history.
        let outside = page.outside.clone();
        outside.crash_store(1);
        extrude(&mut page);
        settle(&mut page);
        let before = page.mesh().clone();
        outside.disk().fail_after(bytes, Failure::Other("no power".into()));
        page.press_with(Modifiers::COMMAND, Key::Z);
        drop(page);
        outside.disk().mend();
        let mut page = Page::visit(&outside);
        assert_eq!(name(&mut page), "Cube", "{bytes}");
        if *page.mesh() == before {
            extrude(&mut page);
        }
        let last = page.mesh().clone();
        let mut page = page.reload();
        assert_eq!((name(&mut page), page.mesh().clone()), ("Cube".to_owned(), last), "{bytes}");
    }
}

#[test]
fn documents_are_listed_opened_renamed_copied_deleted_and_brought_back() {
    let mut page = Page::new();
    open_list(&mut page);
    assert!(page.has_part("No documents are kept yet"));
    page.press(Key::Escape);
    extrude(&mut page);
    page.open("tri.obj", TRIANGLE);
    settle(&mut page);
    open_list(&mut page);
    listed(&mut page, &["tri", "Cube"]);
    assert!(page.has_part("1 face · "));

    page.find("Open document Cube").click();
    page.run();
    settle(&mut page);
    assert_eq!((faces(&mut page), name(&mut page)), (10, "Cube".to_owned()));
    assert_eq!(page.undo_labels(), ["Extrude faces"], "with its history");
    assert!(!page.has("Name of tri"), "the window closes");
    page.command(json!({"op": "poke-faces"}));
    let poked = page.mesh().clone();
    let mut page = page.reload();
    assert_eq!(*page.mesh(), poked, "and goes on as itself");

    open_list(&mut page);
    page.click("Duplicate Cube");
    listed(&mut page, &["tri", "Cube", "Cube copy"]);
    page.click("Delete tri");
    listed(&mut page, &["Cube", "Cube copy"]);
    assert!(page.has_part("Deleted tri."));
    page.harness.get_by_role_and_label(egui::Role::Link, "Undo").click();
    page.run();
    listed(&mut page, &["tri", "Cube", "Cube copy"]);
    rename(&mut page, "Cube copy", "Spare");
    listed(&mut page, &["tri", "Cube", "Spare"]);
    rename(&mut page, "Cube", "Original");
    listed(&mut page, &["tri", "Original", "Spare"]);
    assert_eq!(name(&mut page), "Original");
    page.find("Open document Spare").click();
    page.run();
    settle(&mut page);
    assert_eq!((name(&mut page), page.mesh().clone()), ("Spare".to_owned(), poked));
}

#[test]
fn visits_leave_nothing_behind() {
    let mut page = Page::new();
    page.open("tri.obj", TRIANGLE);
    settle(&mut page);
    let outside = page.outside.clone();
    for _ in 0..3 {
        outside.open_in_new_tab();
        let mut other = Page::visit(&outside);
        settle(&mut other);
    }
    settle(&mut page);
    let folders = outside.disk().contents().len();
    assert_eq!(folders, 2, "the document and the copy of the last visit");
}

#[test]
fn what_a_later_version_keeps_is_left_as_it_is() {
    let outside = after_a_visit();
    let whole = outside.disk().contents();
    let mut page = visit_damaged(&outside, whole, "log", |bytes| bytes[7] += 1);
    assert!(page.has_part("a later version of Meshwright wrote it. It is unchanged. Reload the page"));
    assert_eq!(faces(&mut page), 6);
}

#[test]
fn a_late_answer_is_not_taken_for_the_next_document() {
    let mut page = Page::new();
    extrude(&mut page);
    page.open("tri.obj", TRIANGLE);
    settle(&mut page);
    open_list(&mut page);
    page.outside.hang_store(true);
    page.find("Open document Cube").click();
    page.run();
    page.outside.advance(9000.0);
    page.run();
    assert!(page.has_part("does not answer"));
    page.outside.hang_store(false);
    page.find("Open document Cube").click();
    page.run();
    settle(&mut page);
    assert_eq!((faces(&mut page), name(&mut page)), (10, "Cube".to_owned()));
    page.command(json!({"op": "poke-faces"}));
    let poked = page.mesh().clone();
    let mut page = page.reload();
    assert_eq!(*page.mesh(), poked);
}

#[test]
fn the_welcome_view_offers_the_last_documents() {
    let mut page = Page::new();
    page.open("other.obj", TRIANGLE);
    settle(&mut page);
    page.open("tri.obj", TRIANGLE);
    settle(&mut page);
    let outside = page.outside.clone();
    drop(page);
    outside.set_setting("welcome", "on");
    outside.set_setting("document", "");
    outside.open_in_new_tab();
    let mut page = Page::first_visit_of(&outside);
    let gap = page.find("Open other").rect().left() - page.find("Open tri").rect().right();
    assert!((gap - 8.0).abs() < 0.5, "{gap} points between tiles, as between those of shapes");
    page.find("Open tri").click();
    page.run();
    settle(&mut page);
    assert_eq!(faces(&mut page), 1);
    assert!(!page.has("Close welcome"));
}

#[test]
fn the_store_is_started_again_when_it_crashes_and_nothing_is_lost() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    page.outside.crash_store(1);
    page.command(json!({"op": "poke-faces", "faces": [0]}));
    assert!(!page.has_part("not kept"));
    let mut page = page.reload();
    assert_eq!(faces(&mut page), 13);
}

#[test]
fn a_store_that_crashes_again_is_tried_later_and_the_user_is_told() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    page.outside.crash_store(2);
    page.command(json!({"op": "poke-faces", "faces": [0]}));
    page.run();
    assert!(
        page.has_part(
            "Changes are not kept: the storage reports “it has crashed”. Save the document to a file"
        )
    );
    page.command(json!({"op": "poke-faces", "faces": [1]}));
    page.outside.advance(31_000.0);
    settle(&mut page);
    assert!(page.has_part("Changes are kept again"));
    let mut page = page.reload();
    assert_eq!(faces(&mut page), 16);
}

#[test]
fn a_document_is_opened_although_the_store_crashes_meanwhile() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    let before = state(&mut page);
    page.outside.crash_store(1);
    let mut page = page.reload();
    assert_eq!(state(&mut page), before);
    page.command(json!({"op": "poke-faces", "faces": [0]}));
    let mut page = page.reload();
    assert_eq!(faces(&mut page), 13);
}

#[test]
fn the_title_shows_what_is_in_no_file_yet() {
    let mut page = Page::new();
    assert_eq!(page.outside.title(), "Cube – Meshwright");
    extrude(&mut page);
    assert_eq!(page.outside.title(), "• Cube – Meshwright");
    settle(&mut page);
    let mut page = page.reload();
    assert_eq!(page.outside.title(), "• Cube – Meshwright", "kept by the browser, but in no file");
    page.app().script().undo().expect("a step");
    page.run();
    assert_eq!(page.outside.title(), "Cube – Meshwright");
    page.open("Tri.obj", TRIANGLE);
    assert_eq!(page.outside.title(), "Tri – Meshwright");
}

#[test]
fn a_long_job_of_the_log_is_repeated_by_the_worker() {
    let mut page = Page::new();
    page.command(json!({"op": "new", "shape": "grid", "columns": 150, "rows": 150}));
    settle(&mut page);
    page.command(json!({"op": "triangulate-faces"}));
    page.command(json!({"op": "set-vertex-position", "vertex": 7, "position": [0, 0, 1]}));
    let (before, outside) = (state(&mut page), page.outside.clone());
    drop(page);
    outside.hold_jobs();
    let mut page = Page::begin_visit(&outside);
    assert!(page.app().is_opening(), "the worker has not repeated it yet");
    outside.release_jobs();
    page.run();
    assert!(!page.app().is_opening());
    assert_eq!(state(&mut page), before);
    assert_eq!(page.undo_labels(), ["Triangulate", "Move vertex"]);
}

/// Opens a file whose checkpoint takes several frames, up to the first of them.
fn begin_large(page: &mut Page, called: &str) {
    const SIDE: usize = 250;
    let mut text = String::new();
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        text += &format!("v {x} {y} 0\n");
    }
    for (x, y) in (1..SIDE).flat_map(|y| (1..SIDE).map(move |x| (x, y))) {
        let corner = (y - 1) * SIDE + x;
        text += &format!("f {corner} {} {} {}\n", corner + 1, corner + SIDE + 1, corner + SIDE);
    }
    page.outside.push(Event::Files(vec![NamedBytes::new(format!("{called}.obj"), text.as_bytes())]));
    while name(page) != called {
        page.harness.step();
    }
}

#[test]
fn what_is_done_while_a_large_document_is_written_is_kept() {
    let mut page = Page::new();
    begin_large(&mut page, "first");
    // Each frame changes something.
    page.app().script().run(json!({"op": "poke-faces", "faces": [7]}), Box::new(|_| {}));
    page.harness.step();
    assert!(page.app().would_lose_changes(), "the checkpoint takes more frames");
    let mut ids = (0..24).cycle();
    for _ in 0..20 {
        page.app().script().select("face", &[ids.next().expect("an id")]).expect("a face");
        page.harness.step();
    }
    assert!(!page.app().would_lose_changes());
    page.app().script().run(json!({"op": "poke-faces", "faces": [3]}), Box::new(|_| {}));
    page.harness.step();
    let before = state(&mut page);
    let mut page = page.reload();
    assert_eq!(state(&mut page).0, before.0);
}

#[test]
fn a_large_document_that_another_one_replaces_at_once_is_kept() {
    let mut page = Page::new();
    begin_large(&mut page, "first");
    let large = page.mesh().clone();
    page.command(json!({"op": "new", "shape": "tetrahedron"}));
    page.command(json!({"op": "poke-faces", "faces": [0]}));
    settle(&mut page);
    open_list(&mut page);
    page.find("Open document first").click();
    page.run();
    settle(&mut page);
    assert!(*page.mesh() == large);

    // The same with one that is opened from the list.
    begin_large(&mut page, "second");
    page.app().script().run(json!({"op": "poke-faces", "faces": [0]}), Box::new(|_| {}));
    let poked = page.mesh().clone();
    open_list(&mut page);
    page.find("Open document Tetrahedron").click();
    page.run();
    settle(&mut page);
    assert_eq!(faces(&mut page), 6);
    open_list(&mut page);
    page.find("Open document second").click();
    page.run();
    settle(&mut page);
    assert!(*page.mesh() == poked);
}

#[test]
fn the_last_change_before_another_document_is_kept() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    for command in [json!({"op": "poke-faces", "faces": [0]}), json!({"op": "new", "shape": "torus"})] {
        page.app().script().run(command, Box::new(|answer| assert!(answer.is_ok(), "{answer:?}")));
    }
    settle(&mut page);
    let outside = page.outside.clone();
    drop(page);
    assert_eq!(faces(&mut visit_first_document(&outside)), 13);
}

#[test]
fn a_worker_that_fails_to_repeat_a_change_costs_nothing() {
    let mut page = Page::new();
    page.command(json!({"op": "new", "shape": "grid", "columns": 150, "rows": 150}));
    settle(&mut page);
    page.command(json!({"op": "triangulate-faces"}));
    page.command(json!({"op": "set-vertex-position", "vertex": 7, "position": [0, 0, 1]}));
    let (before, outside) = (page.mesh().clone(), page.outside.clone());
    drop(page);
    let failed = || {
        let refused = CommandError::refused("job", "the worker ran out of memory");
        Event::JobDone { job: 1 << 48, result: Err(CommandError { kind: ErrorKind::Internal, ..refused }) }
    };

    // Once: another worker repeats it.
    outside.hold_jobs();
    let mut page = Page::begin_visit(&outside);
    outside.push(failed());
    page.wait();
    assert!(page.app().is_opening());
    outside.release_jobs();
    page.run();
    assert_eq!(*page.mesh(), before);
    drop(page);

    // Again and again: the document opens without it, as a copy.
    outside.hold_jobs();
    let mut page = Page::begin_visit(&outside);
    for _ in 0..2 {
        outside.push(failed());
        page.wait();
    }
    settle(&mut page);
    assert!(page.has_part("The last 2 changes could not be repeated: "));
    assert!(page.has_part("This is a copy without them. The original stays in File > Recent documents."));
    assert_eq!((faces(&mut page), name(&mut page)), (150 * 150, "Grid (recovered)".to_owned()));
    extrude(&mut page);
    settle(&mut page);
    outside.release_jobs();
    page.run();
    open_list(&mut page);
    page.find("Open document Grid").click();
    page.run();
    settle(&mut page);
    assert_eq!(*page.mesh(), before, "the original has everything");
}

#[test]
fn a_damaged_link_does_not_hide_the_document_at_the_next_visit() {
    let mut page = Page::new();
    extrude(&mut page);
    settle(&mut page);
    page.outside.set_fragment("#d=1AAAAAAAA");
    page.outside.push(Event::Fragment("#d=1AAAAAAAA".to_owned()));
    page.run();
    assert!(page.has_part("The link is damaged"));
    assert_eq!(page.outside.fragment(), "");
    assert_eq!(faces(&mut page.reload()), 10);
}
