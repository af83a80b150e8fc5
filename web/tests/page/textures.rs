//! Images of materials on the page: opened with their model or after it, shown, and said to be missing.

use crate::looks::picture;
use crate::page::{DESKTOP, PHONE, Page};
use egui::{Key, Modifiers, Theme};
use egui_kittest::kittest::{NodeT, Queryable};
use meshwright_web::platform::{Event, NamedBytes};
use serde_json::{Value, json};

/// A square in the xy plane that the image covers, with a second one beside it that has no material.
const SQUARE: &str = "mtllib square.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 2 -1 0\nv 2 1 0\n\
                      vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl wood\nf 1/1 2/2 3/3 4/4\nusemtl\nf 2 5 6 3\n";
const LIBRARY: &str = "newmtl wood\nmap_Kd textures\\wood.png\n";

/// Red and green above, blue and white below.
fn image() -> NamedBytes {
    let quarters = [[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [255, 255, 255]]];
    let picture =
        image::RgbImage::from_fn(64, 64, |x, y| image::Rgb(quarters[y as usize / 32][x as usize / 32]));
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).expect("a PNG");
    NamedBytes::new("wood.png", bytes.into_inner())
}

fn open(page: &mut Page, files: &[NamedBytes]) {
    page.outside.push(Event::Files(files.to_vec()));
    page.run();
}

fn model() -> [NamedBytes; 2] {
    [NamedBytes::new("square.obj", SQUARE), NamedBytes::new("square.mtl", LIBRARY)]
}

fn with_image() -> Vec<NamedBytes> {
    model().into_iter().chain([image()]).collect()
}

fn view(page: &mut Page) -> Value {
    page.app().script().state()["view"].clone()
}

fn look(page: &mut Page) -> String {
    view(page)["look"].as_str().expect("a look").to_owned()
}

/// The colours near the corners of the square: top left, top right, bottom left, bottom right.
fn corners(page: &mut Page, name: &str) -> [[u8; 3]; 4] {
    page.press_with(Modifiers::ALT, Key::Num1);
    let shown = picture(page, name);
    [[-0.8, 0.7], [0.7, 0.8], [-0.7, -0.8], [0.8, -0.7]].map(|[x, y]| {
        let at = page.at([x, y, 0.0]);
        let [r, g, b, _] = shown.get_pixel(at.x as u32, at.y as u32).0;
        [r, g, b]
    })
}

fn shows_image([a, b, c, d]: [[u8; 3]; 4]) -> bool {
    let is = |[r, g, b]: [u8; 3], wanted: [bool; 3]| {
        [r, g, b].into_iter().zip(wanted).all(|(channel, wanted)| (channel > 150) == wanted)
    };
    is(a, [true, false, false])
        && is(b, [false, true, false])
        && is(c, [false, false, true])
        && is(d, [true; 3])
}

#[test]
fn a_model_dropped_with_its_image_shows_it() {
    for (theme, name) in [(Theme::Dark, "textures dark"), (Theme::Light, "textures light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        open(&mut page, &with_image());
        assert_eq!(look(&mut page), "texture", "chosen by itself");
        let shown = corners(&mut page, name);
        assert!(shows_image(shown), "{shown:?}");
        let told = &view(&mut page)["textures"];
        assert_eq!(*told, json!([{ "image": "textures/wood.png", "state": "shown", "size": [64, 64] }]));
        assert!(page.has("wood.png: 64 × 64"), "in the document's panel");
        // The corners of the texture follow edits, and undo brings them back.
        page.command(json!({ "op": "subdivide-linear" }));
        let shown = corners(&mut page, &format!("{name} subdivided"));
        assert!(shows_image(shown), "{shown:?}");
        page.press_with(Modifiers::COMMAND, Key::Z);
        page.press_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(look(&mut page), "studio", "the cube has no image");
        page.press_with(Modifiers::COMMAND, Key::Y);
        let shown = corners(&mut page, name);
        assert!(shows_image(shown), "opened again: {shown:?}");
        open(&mut page, &[NamedBytes::new("plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")]);
        assert_eq!(look(&mut page), "studio", "without textures the look is as before");
    }
}

#[test]
fn a_missing_image_is_named_and_can_be_dropped_later() {
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    open(&mut page, &model());
    assert_eq!(look(&mut page), "studio");
    assert!(page.has_part("Images are missing: drop textures/wood.png on the page."));
    assert!(page.has("wood.png: missing"));
    assert_eq!(view(&mut page)["textures"][0]["state"], "missing");
    picture(&mut page, "textures missing");
    assert!(!shows_image(corners(&mut page, "textures missing front")));

    open(&mut page, &[NamedBytes::new("stone.png", image().bytes)]);
    assert!(page.has_part("No material names stone.png"));
    open(&mut page, &[image()]);
    assert_eq!(look(&mut page), "texture");
    let shown = corners(&mut page, "textures dropped later");
    assert!(shows_image(shown), "{shown:?}");
    assert_eq!(page.undo_labels().last().map(String::as_str), Some("Add wood.png"));
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert!(page.has("wood.png: missing"));
    assert!(!shows_image(corners(&mut page, "textures undone")));
}

#[test]
fn a_damaged_image_is_said_in_words_and_the_model_shown_without() {
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    let whole = image();
    let damaged = NamedBytes::new("wood.png", &whole.bytes[..60]);
    let [obj, mtl] = model();
    open(&mut page, &[obj, mtl, damaged]);
    assert!(page.has_part("wood.png can't be shown: it is damaged"));
    assert!(page.has("wood.png: not shown"));
    let [a, b, c, d] = corners(&mut page, "textures damaged");
    assert!(
        [b, c, d].into_iter().all(|other| (0..3).all(|i| other[i].abs_diff(a[i]) < 12)),
        "plain: {a:?} {d:?}"
    );
    assert_eq!(view(&mut page)["textures"][0]["state"], "failed");
    // The whole image in its place.
    open(&mut page, &[whole]);
    let shown = corners(&mut page, "textures repaired");
    assert!(shows_image(shown), "{shown:?}");
}

#[test]
fn the_looks_say_what_they_need() {
    let mut page = Page::drawn(DESKTOP, Theme::Light);
    let reason = |page: &mut Page, entry: &str| {
        page.click("View");
        page.find("Look").hover();
        page.run();
        page.find("Look").click();
        page.run();
        let disabled = page.find(entry).accesskit_node().is_disabled();
        page.press(Key::Escape);
        page.press(Key::Escape);
        disabled
    };
    assert!(reason(&mut page, "Textures") && reason(&mut page, "UV checker"), "the cube has neither");
    open(&mut page, &with_image());
    assert!(!reason(&mut page, "Textures") && !reason(&mut page, "UV checker"));
    page.press_with(Modifiers::COMMAND, Key::K);
    page.find("Find a command").type_text("UV checker");
    page.run();
    page.press(Key::Enter);
    assert_eq!(look(&mut page), "uv-checker");
    let shown = corners(&mut page, "uv checker");
    assert!(!shows_image(shown), "{shown:?}");
    // A colour that stands for something takes the place of pictures; the look brings them back.
    for (command, looks_like) in [("Textures", true), ("Valence", false), ("Textures", true)] {
        page.press_with(Modifiers::COMMAND, Key::K);
        page.find("Find a command").type_text(command);
        page.run();
        page.press(Key::Enter);
        let shown = corners(&mut page, &format!("look {command}"));
        assert_eq!(shows_image(shown), looks_like, "{command}: {shown:?}");
    }
}

#[test]
fn on_a_telephone() {
    let mut page = Page::drawn(PHONE, Theme::Light);
    open(&mut page, &with_image());
    let shown = corners(&mut page, "textures phone");
    assert!(shows_image(shown), "{shown:?}");
    assert!(page.harness.query_by_label_contains("Viewport").is_some());
}
