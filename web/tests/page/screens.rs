//! The main screens in both themes and three sizes, compared with references: PNG files in `web/tests/screens`, each
//! pixel of which is the mean of a square of the screen. `MESHWRIGHT_UPDATE=1 cargo test -p meshwright-web --test page
//! screens` rewrites them; look at the screens themselves, in `looks` of the target folder, before you commit.

use crate::looks::picture;
use crate::page::{DESKTOP, PHONE, Page};
use egui::{Key, Modifiers, Theme, Vec2, vec2};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{Rgb, RgbImage, RgbaImage};
use serde_json::json;
use std::path::Path;

const LARGE: Vec2 = vec2(1920.0, 1080.0);
/// The side of the square of the screen that a pixel of a reference stands for.
const CELL_PIXELS: u32 = 16;
/// How far a channel of a cell may be from the reference, of 255. Other antialiasing changes it by less; a thin icon,
/// a row of text, or the edge of a panel that moved by two pixels changes it by more.
const MAX_DIFFERENCE: u8 = 8;
/// How many cells may differ by more.
const MAX_CELLS: usize = 2;

/// Each pixel is the mean of a cell of the screen.
fn reduced(screen: &RgbaImage) -> RgbImage {
    let (width, height) = screen.dimensions();
    RgbImage::from_fn(width.div_ceil(CELL_PIXELS), height.div_ceil(CELL_PIXELS), |x, y| {
        let (mut sum, mut count) = ([0; 3], 0);
        for at_y in y * CELL_PIXELS..height.min((y + 1) * CELL_PIXELS) {
            for at_x in x * CELL_PIXELS..width.min((x + 1) * CELL_PIXELS) {
                let [r, g, b, _] = screen.get_pixel(at_x, at_y).0;
                sum = [sum[0] + u32::from(r), sum[1] + u32::from(g), sum[2] + u32::from(b)];
                count += 1;
            }
        }
        Rgb(sum.map(|sum| (sum / count) as u8))
    })
}

/// The middles of the cells in which two references differ too much.
fn differences(a: &RgbImage, b: &RgbImage) -> Vec<(u32, u32)> {
    let differs = |(x, y, pixel): (u32, u32, &Rgb<u8>)| {
        let other = b.get_pixel(x, y);
        let far = pixel.0.iter().zip(other.0).any(|(a, b)| a.abs_diff(b) > MAX_DIFFERENCE);
        far.then_some((x * CELL_PIXELS + CELL_PIXELS / 2, y * CELL_PIXELS + CELL_PIXELS / 2))
    };
    a.enumerate_pixels().filter_map(differs).collect()
}

/// Compares a screen with its reference, or writes the reference. Returns what is wrong.
fn check(page: &mut Page, name: &str) -> Result<(), String> {
    let now = reduced(&picture(page, &format!("screen {name}")));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/screens").join(format!("{name}.png"));
    if std::env::var_os("MESHWRIGHT_UPDATE").is_some() {
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder for references");
        let file = std::fs::File::create(&path).expect("a file");
        let encoder = PngEncoder::new_with_quality(file, CompressionType::Best, FilterType::Adaptive);
        now.write_with_encoder(encoder).expect("a reference on disk");
        return Ok(());
    }
    let before = image::open(&path).map_err(|error| format!("{name}: {error}"))?.to_rgb8();
    if before.dimensions() != now.dimensions() {
        return Err(format!("{name}: the reference is of another size"));
    }
    let cells = differences(&now, &before);
    match cells.first() {
        Some((x, y)) if cells.len() > MAX_CELLS => {
            Err(format!("{name}: {} cells differ, the first one around {x}, {y}", cells.len()))
        }
        _ => Ok(()),
    }
}

/// Starts a command by the palette, which is the same at every size.
fn start(page: &mut Page, command: &str) {
    page.press_with(Modifiers::COMMAND, Key::K);
    page.find("Find a command").type_text(command);
    page.run();
    page.press(Key::Enter);
}

fn with_mode(page: &mut Page, key: Key, kind: &str, ids: &[u32]) {
    page.press(key);
    page.select(kind, ids);
}

const FIRST_VISIT: &str = "welcome";

/// The screens, and how to get to them from the cube.
type Screen = (&'static str, fn(&mut Page));

const SCREENS: [Screen; 15] = [
    (FIRST_VISIT, |_| {}),
    ("vertices", |page| with_mode(page, Key::Num1, "vertex", &[3, 7])),
    ("edges", |page| with_mode(page, Key::Num2, "edge", &[2, 5, 8])),
    ("half-edges", |page| with_mode(page, Key::Num3, "half-edge", &[6])),
    ("faces", |page| {
        with_mode(page, Key::Num4, "face", &[1, 3]);
        start(page, "Move gizmo");
    }),
    ("form", |page| {
        page.command(json!({ "op": "new", "shape": "torus" }));
        if page.harness.ctx.content_rect().width() < 600.0 {
            page.click("Operations");
        }
        page.choose("Remesh");
    }),
    ("live edit", |page| {
        with_mode(page, Key::Num4, "face", &[3]);
        page.press(Key::G);
        page.hover_off_middle(Vec2::ZERO);
        page.press(Key::X);
        page.hover_off_middle(vec2(60.0, -20.0));
    }),
    ("loop cut", |page| {
        let on_edge = page.at([1.0, 0.0, 1.0]);
        page.harness.hover_at(on_edge);
        page.run();
        page.press(Key::L);
        page.harness.event(egui::Event::Text("3".to_owned()));
        page.run();
        page.harness.hover_at(on_edge + vec2(1.0, 0.0));
        page.run();
    }),
    ("palette", |page| {
        with_mode(page, Key::Num4, "face", &[0]);
        page.press_with(Modifiers::COMMAND, Key::K);
        page.find("Find a command").type_text("edge");
        page.run();
    }),
    ("save", |page| {
        page.press_with(Modifiers::COMMAND, Key::S);
    }),
    ("keys", |page| page.press(Key::Questionmark)),
    ("bezier", |page| {
        let patch = |x: usize| -> String {
            (0..16).map(|i| format!("{} {} {}\n", 3 * x + i % 4, (i % 4 * (i / 4)) % 3, i / 4)).collect()
        };
        page.open("two.bez", &format!("2\n{}{}", patch(0), patch(1)));
    }),
    ("large", |page| {
        page.command(json!({ "op": "new", "shape": "torus", "segments": 400, "tube_segments": 200 }));
        page.wait();
        page.select("face", &(0..20_000).collect::<Vec<_>>());
        page.wait();
    }),
    ("messages", |page| {
        page.open("broken.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 9\nv 1 x 2\n");
        page.open("nothing.obj", "# no vertices\n");
        start(page, "Messages");
    }),
    ("empty", |page| page.command(json!({ "op": "delete-faces", "faces": [0, 1, 2, 3, 4, 5] }))),
];

/// Compares all screens of a size.
fn compare(size: Vec2, size_name: &str) {
    let mut wrong = Vec::new();
    for (theme, shade) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        for (name, go_to) in SCREENS {
            let mut page = match name {
                FIRST_VISIT => Page::welcoming_drawn(size, theme),
                _ => Page::drawn(size, theme),
            };
            go_to(&mut page);
            wrong.extend(check(&mut page, &format!("{name} {size_name} {shade}")).err());
        }
    }
    assert!(
        wrong.is_empty(),
        "These screens look different (see `screen *.png` in looks of the target folder). If that is intended, run \
         `MESHWRIGHT_UPDATE=1 cargo test -p meshwright-web --test page screens`:\n{}",
        wrong.join("\n")
    );
}

#[test]
fn screens_of_a_desktop() {
    compare(DESKTOP, "desktop");
}

#[test]
fn screens_of_a_large_window() {
    compare(LARGE, "large");
}

#[test]
fn screens_of_a_phone() {
    compare(PHONE, "phone");
}

#[test]
fn a_missing_icon_a_moved_panel_and_another_colour_are_found_but_not_antialiasing() {
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    page.select("face", &[1]);
    let screen = picture(&mut page, "screen compared");
    let reference = reduced(&screen);
    let found = |screen: &RgbaImage| differences(&reduced(screen), &reference).len();
    let fill = |screen: &mut RgbaImage, rect: egui::Rect, color: image::Rgba<u8>| {
        for y in rect.top() as u32..rect.bottom() as u32 {
            (rect.left() as u32..rect.right() as u32).for_each(|x| screen.put_pixel(x, y, color));
        }
    };

    let icon = page.find("Wireframe").rect();
    let behind = *screen.get_pixel(icon.left() as u32 - 2, icon.center().y as u32);
    let mut without_icon = screen.clone();
    fill(&mut without_icon, icon, behind);
    assert!(found(&without_icon) > MAX_CELLS, "{} cells", found(&without_icon));

    let viewport = page.find("Viewport").rect();
    let mut moved = screen.clone();
    for y in 0..screen.height() {
        let at = |x: u32| *screen.get_pixel(x, y);
        (viewport.right() as u32..screen.width() - 2).for_each(|x| moved.put_pixel(x, y, at(x + 2)));
    }
    assert!(found(&moved) > MAX_CELLS, "{} cells", found(&moved));

    let mut recolored = screen.clone();
    for pixel in recolored.pixels_mut().filter(|pixel| pixel.0[0] > 200 && pixel.0[2] < 90) {
        pixel.0.swap(0, 2);
    }
    assert!(found(&recolored) > MAX_CELLS, "the selection is blue: {} cells", found(&recolored));

    // Every other pixel is a little lighter or darker.
    let mut noisy = screen.clone();
    for (x, y, pixel) in noisy.enumerate_pixels_mut() {
        let by = if (x + y) % 2 == 0 { 12 } else { -12 };
        pixel.0 = pixel.0.map(|channel| channel.saturating_add_signed(by));
    }
    assert_eq!(found(&noisy), 0);
}
