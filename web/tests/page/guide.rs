//! The guide: it opens from the menu, and what it names exists. In its texts, bold is for places in the menus and `<kbd>` for
//! keys; a key in brackets after a place in a menu starts what is there, in the keys of the Course preset.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::page::{DESKTOP, Page};
use editor::OpId;
use egui::Key;
use halfedge::Element;
use meshwright_web::access::tree::UiTree;
use meshwright_web::input::actions::{self, Action};
use meshwright_web::input::key_map::KeyMap;
use meshwright_web::input::key_preset::KeyPreset;
use meshwright_web::input::menus::{MENUS, submenu};
use meshwright_web::input::shortcut::Shortcut;

/// Keys that mean something while others are held, in edits, in flight or in any page.
const OTHER_KEYS: [&str; 15] = [
    "Enter",
    "Tab",
    "Shift",
    "Ctrl",
    "Alt",
    "Ctrl+Alt",
    "Ctrl+Shift",
    "W",
    "A",
    "S",
    "D",
    "X",
    "Y",
    "Z",
    "Shift+X",
];

/// A text of the guide, without blocks of code and with each paragraph on one line.
struct Text {
    file: PathBuf,
    prose: String,
}

fn texts() -> Vec<Text> {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let guide =
        fs::read_dir(docs.join("guide")).expect("the guide").map(|entry| entry.expect("an entry").path());
    let mut files: Vec<PathBuf> =
        guide.filter(|path| path.extension().is_some_and(|end| end == "md")).collect();
    files.sort();
    files.push(docs.join("scripting.md"));
    let prose = |file: &PathBuf| {
        let text = fs::read_to_string(file).expect("text");
        let outside = text.split("```").step_by(2).collect::<String>();
        outside.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    files.into_iter().map(|file| Text { prose: prose(&file), file }).collect()
}

/// The places in menus, each with the keys in the brackets after it.
fn places(prose: &str) -> Vec<(&str, Vec<&str>)> {
    let pieces: Vec<&str> = prose.split("**").collect();
    assert!(pieces.len() % 2 == 1, "bold that doesn't end: {prose}");
    let follows = |at: usize| pieces.get(at + 1).copied().unwrap_or_default();
    let keys = |at: usize| {
        let brackets = follows(at).strip_prefix(" (").and_then(|rest| rest.split(')').next());
        brackets.map(kbds).unwrap_or_default()
    };
    (1..pieces.len()).step_by(2).map(|at| (pieces[at], keys(at))).collect()
}

fn kbds(text: &str) -> Vec<&str> {
    text.split("<kbd>").skip(1).map(|rest| rest.split("</kbd>").next().unwrap_or_default()).collect()
}

/// The names of everything on the page, with their numbers.
fn names(page: &Page) -> BTreeMap<String, usize> {
    let tree = page.harness.ctx.plugin::<UiTree>();
    let mut names = BTreeMap::new();
    for widget in tree.lock().read() {
        *names.entry(widget.name.to_string()).or_default() += 1;
    }
    names
}

/// Whether a widget's name is that of an entry, perhaps with an ellipsis and a key.
fn is_named(name: &str, entry: &str) -> bool {
    let Some(rest) = name.strip_prefix(entry) else { return false };
    let rest = rest.strip_prefix('…').unwrap_or(rest);
    rest.is_empty() || rest.strip_prefix(' ').is_some_and(|key| Shortcut::parse(key).is_some())
}

#[test]
fn places_in_menus_exist() {
    // High enough for the longest menu.
    let mut page = Page::sized(egui::vec2(DESKTOP.x, 2000.0));
    let mut wanted: BTreeMap<Vec<String>, BTreeSet<String>> = BTreeMap::new();
    for text in texts() {
        for (place, _) in places(&text.prose) {
            let mut way: Vec<String> = place.split(" > ").map(str::to_owned).collect();
            let entry = way.pop().expect("a name");
            assert!(!way.is_empty(), "{place} in {} is no place in a menu", text.file.display());
            wanted.entry(way).or_default().insert(entry);
        }
    }
    assert!(wanted.len() > 20, "places are found");
    for (way, entries) in wanted {
        let mut before = BTreeMap::new();
        for step in &way {
            before = names(&page);
            page.click(step);
        }
        let after = names(&page);
        for entry in entries {
            let is_new = |name: &str, count: usize| before.get(name).is_none_or(|old| *old < count);
            let found = after.iter().any(|(name, count)| is_new(name, *count) && is_named(name, &entry));
            assert!(found, "the guide names {} > {entry}; there is {after:?}", way.join(" > "));
        }
        for _ in &way {
            page.press(Key::Escape);
        }
        assert_eq!(names(&page).get("Open…"), Some(&1), "menus are closed");
    }
}

/// The action at a place in a menu.
fn action_at(place: &str) -> Option<Action> {
    let mut way = place.split(" > ");
    let title = way.next()?;
    let menu = MENUS.iter().find(|menu| menu.id.title() == title)?;
    let rest: Vec<&str> = way.collect();
    let (label, folders) = rest.split_last()?;
    let is_it = |name: &str| name.trim_end_matches('…') == *label;
    let mut own = menu.entries.iter().flatten();
    let own = own.find(|entry| is_it(entry.label) && submenu(entry.action).as_slice() == folders);
    own.map(|entry| entry.action).or_else(|| {
        OpId::ALL.iter().find(|id| is_it(id.spec().label)).map(|id| actions::of_operation(*id).action)
    })
}

#[test]
fn keys_start_what_the_guide_says() {
    let map = KeyMap::new(KeyPreset::Course);
    let shortcut = |key: &str| Shortcut::parse(key).unwrap_or_else(|| panic!("{key} is no key"));
    let all: Vec<Shortcut> = map.bindings().iter().flat_map(|binding| binding.keys.clone()).collect();
    let mut checked = 0;
    for text in texts() {
        let file = text.file.display();
        for (place, keys) in places(&text.prose).into_iter().filter(|(_, keys)| !keys.is_empty()) {
            let action = action_at(place).unwrap_or_else(|| panic!("{file}: {place} starts nothing"));
            let starts =
                [Element::Vertex, Element::Edge, Element::Face].map(|kind| action.for_selection(kind));
            assert!(starts.contains(&action), "{place}");
            for key in keys {
                assert!(map.keys_of(action).contains(&shortcut(key)), "{file}: {key} doesn't start {place}");
                checked += 1;
            }
        }
        for key in kbds(&text.prose).into_iter().filter(|key| !OTHER_KEYS.contains(key)) {
            assert!(all.contains(&shortcut(key)), "{file}: {key} starts nothing");
        }
    }
    assert!(checked > 40, "{checked} keys after places in menus");
}

#[test]
fn operations_that_the_guide_names_exist() {
    let known: BTreeSet<&str> = OpId::ALL.iter().map(|id| id.spec().name).collect();
    let mut named = 0;
    for text in texts() {
        let whole = fs::read_to_string(&text.file).expect("text");
        let in_commands = whole.replace("\"op\": \"", "op: \"").replace("\"op\":\"", "op: \"");
        let in_commands = in_commands.split("op: \"").skip(1).filter_map(|rest| rest.split('"').next());
        let in_prose = text.prose.split('`').skip(1).step_by(2);
        let in_prose = in_prose.filter(|code| {
            code.contains('-')
                && code.split('-').all(|word| word.bytes().all(|byte| byte.is_ascii_lowercase()))
        });
        let in_prose = in_prose.filter(|code| !code.starts_with("--"));
        for name in in_commands.chain(in_prose) {
            assert!(known.contains(name), "{}: there is no operation {name}", text.file.display());
            named += 1;
        }
    }
    assert!(named > 5, "operations are found");
}

#[test]
fn the_help_menu_opens_the_guide_or_says_where_it_is() {
    let mut page = Page::new();
    let open = |page: &mut Page| {
        page.click("Help");
        page.click("Guide");
    };
    open(&mut page);
    assert_eq!(page.outside.guides(), 1);
    assert!(!page.has_part("docs/guide"));
    page.outside.take_guide_away();
    open(&mut page);
    assert_eq!(page.outside.guides(), 1);
    assert!(page.has_part("It is in the folder docs/guide"));
}
