//! Random commands with reloads, crashes and power failures in between: the document is the same to the bit as that of an
//! editor which does the same commands without a page, as the command line does. `MESHWRIGHT_SOAK` sets the number of
//! commands, and `MESHWRIGHT_SEED` other ones.

use std::cell::RefCell;
use std::rc::Rc;

use editor::{Command, Editor, SelectMode, element_name};
use halfedge::Element;
use meshwright_web::platform::store::Failure;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use serde_json::{Value, json};

use crate::page::Page;

#[path = "../../../crates/editor/tests/support/contents.rs"]
mod contents;
#[path = "../../../crates/editor/tests/support/random.rs"]
mod random;

use contents::Contents;

const COMMANDS: usize = 160;

/// With more faces the document is replaced by a small one.
const MOST_FACES: usize = 300;

/// Something that is done in the page.
#[derive(Clone, Debug)]
enum Deed {
    Run(Value),
    Select(Element, Vec<u32>),
    Undo,
    Redo,
}

/// How the page ends after it.
#[derive(Clone, Copy, Debug)]
enum End {
    /// It goes on.
    None,
    /// The tab is closed or killed in the frame of the deed.
    Kill,
    /// It is reloaded after a while.
    Reload,
    /// Power fails after so many bytes.
    PowerFails(u64),
    /// The store's worker crashes, and the page goes on.
    StoreCrashes,
}

fn any_deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        12 => random::any_command().prop_map(Deed::Run),
        2 => (random::any_element(), prop::collection::vec(0u32..12, 0..5)).prop_map(|(k, i)| Deed::Select(k, i)),
        2 => Just(Deed::Undo),
        1 => Just(Deed::Redo),
    ]
}

fn any_end() -> impl Strategy<Value = End> {
    prop_oneof![
        18 => Just(End::None),
        2 => Just(End::Kill),
        1 => Just(End::Reload),
        2 => (0u64..3000).prop_map(End::PowerFails),
        1 => Just(End::StoreCrashes),
    ]
}

fn contents(editor: &Editor) -> Contents {
    Contents::named(editor, editor.document().name())
}

/// Does something in the page, and returns whether it was done.
fn act(page: &mut Page, deed: &Deed) -> bool {
    let done = Rc::new(RefCell::new(None));
    let tell = done.clone();
    let mut app = page.app().script();
    match deed.clone() {
        Deed::Run(command) => {
            app.run(command, Box::new(move |answer| *tell.borrow_mut() = Some(answer.is_ok())))
        }
        Deed::Select(kind, ids) => *tell.borrow_mut() = Some(app.select(element_name(kind), &ids).is_ok()),
        Deed::Undo => *tell.borrow_mut() = Some(app.undo().is_ok()),
        Deed::Redo => *tell.borrow_mut() = Some(app.redo().is_ok()),
    }
    drop(app);
    page.harness.step();
    let done = *done.borrow();
    done.expect("no job, so it is answered at once")
}

/// Does the same in an editor without a page.
fn repeat(editor: &mut Editor, deed: &Deed) -> bool {
    match deed.clone() {
        Deed::Run(command) => Command::from_value(command).is_ok_and(|command| editor.run(command).is_ok()),
        Deed::Select(kind, ids) => editor.select(kind, ids, SelectMode::Replace).is_ok(),
        Deed::Undo => editor.undo().is_ok(),
        Deed::Redo => editor.redo().is_ok(),
    }
}

fn number(variable: &str, default: usize) -> usize {
    std::env::var(variable).ok().map_or(default, |value| value.parse().expect("a number"))
}

#[test]
fn random_commands_with_kills_in_between_give_the_same_bits_as_without_a_page() {
    let mut seed = [7; 32];
    seed[..8].copy_from_slice(&number("MESHWRIGHT_SEED", 1).to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let (mut page, mut twin) = (Page::new(), Editor::new());
    let first = json!({"op": "new", "shape": "cube"});
    twin.start_with(Command::from_value(first).expect("a command")).expect("a cube");
    assert!(contents(page.app().editor()) == contents(&twin));
    let small = || Deed::Run(json!({"op": "new", "shape": "torus", "segments": 5, "tube_segments": 4}));
    assert!(act(&mut page, &small()) && repeat(&mut twin, &small()));
    let mut ended = [0; 4];
    for at in 0..number("MESHWRIGHT_SOAK", COMMANDS) {
        let objects = twin.document().objects().iter();
        let faces: usize = objects.map(|object| object.mesh().face_count()).sum();
        let deed = match any_deed().new_tree(&mut runner).expect("a deed").current() {
            _ if faces > MOST_FACES || faces == 0 => small(),
            deed => deed,
        };
        let editor = page.app().editor();
        let has_step = match deed {
            // A reload keeps the history back to the last checkpoint.
            Deed::Undo => editor.undo_labels().next().is_some(),
            Deed::Redo => editor.redo_labels().next().is_some(),
            _ => true,
        };
        if !has_step {
            continue;
        }
        let end = any_end().new_tree(&mut runner).expect("an end").current();
        let (outside, disk) = (page.outside.clone(), page.outside.disk());
        match end {
            End::PowerFails(bytes) => disk.fail_after(bytes, Failure::Other("no power".into())),
            End::StoreCrashes => outside.crash_store(1),
            End::None | End::Kill | End::Reload => {}
        }
        let was_done = act(&mut page, &deed);
        println!("{at}: {deed:?}, {end:?}, {was_done}");
        match end {
            End::None => {}
            End::Kill => page = page.reload(),
            End::Reload => {
                page.run();
                outside.advance(6000.0);
                page.run();
                page = page.reload();
            }
            End::PowerFails(_) => {
                drop(page);
                disk.mend();
                page = Page::visit(&outside);
                let before = contents(&twin);
                if contents(page.app().editor()) == before {
                    // It is missing, or changed nothing.
                    continue;
                }
            }
            End::StoreCrashes => {
                page.run();
                // One that was asked for nothing has not crashed.
                outside.crash_store(0);
            }
        }
        ended[match end {
            End::None => 0,
            End::Kill | End::Reload => 1,
            End::PowerFails(_) => 2,
            End::StoreCrashes => 3,
        }] += 1;
        assert_eq!(repeat(&mut twin, &deed), was_done, "{at}: {deed:?}");
        let (kept, wanted) = (contents(page.app().editor()), contents(&twin));
        assert!(kept == wanted, "{at}: after {deed:?} and {end:?}\n{kept:#?}\n{wanted:#?}");
        page.mesh().validate().expect("valid");
    }
    assert!(ended.iter().all(|count| *count > 0), "{ended:?}");
}
