//! The fonts of the interface.
//!
//! They are parts of Ubuntu Light and, for columns of numbers, of Hack, which `build.rs` cuts out: whole, they would be a tenth
//! of the page's program. Characters that they lack are drawn by the browser on the page, and by the whole fonts on the desktop.

use egui::{Context, FontData, FontDefinitions, FontFamily};

const TEXT: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/text.ttf"));
const COLUMNS: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/columns.ttf"));

/// Makes an egui use the fonts.
pub fn install(ctx: &Context) {
    ctx.set_fonts(definitions());
}

fn definitions() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in [("text", TEXT), ("columns", COLUMNS)] {
        fonts.font_data.insert(name.to_owned(), FontData::from_static(bytes).into());
    }
    let mut family = |family, names: &[&str]| {
        fonts.families.insert(family, names.iter().map(|name| (*name).to_owned()).collect());
    };
    family(FontFamily::Proportional, &["text"]);
    family(FontFamily::Monospace, &["columns", "text"]);
    fonts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::shortcut::Shortcut;
    use egui::epaint::text::{Fonts, TextOptions};
    use egui::{FontId, Key};
    use std::path::Path;

    fn fonts() -> Fonts {
        Fonts::new(TextOptions::default(), definitions())
    }

    /// The lines of a folder's code without comments and tests, with their files.
    fn code(folder: &Path, lines: &mut Vec<(String, String)>) {
        for entry in std::fs::read_dir(folder).expect("a folder of the repository") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                code(&path, lines);
            } else {
                let text = std::fs::read_to_string(&path).expect("text");
                let product = text.split("#[cfg(test)]").next().unwrap_or_default();
                let product = product.lines().filter(|line| !line.trim_start().starts_with("//"));
                lines.extend(product.map(|line| (path.display().to_string(), line.to_owned())));
            }
        }
    }

    #[test]
    fn they_have_every_character_that_the_program_says() {
        let mut lines = Vec::new();
        let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        for folder in ["web/src", "crates/editor/src", "crates/surface/src", "crates/halfedge/src"] {
            code(&repository.join(folder), &mut lines);
        }
        let (mut fonts, font) = (fonts(), FontId::proportional(13.0));
        let mut seen = 0;
        for (path, line) in &lines {
            for character in line.chars().filter(|character| !character.is_ascii()) {
                seen += 1;
                assert!(fonts.has_glyph(&font, character), "{character:?} in {path}: add it to web/build.rs");
            }
        }
        assert!(seen > 50, "{seen}");
    }

    #[test]
    fn they_have_what_is_typed_and_the_names_of_keys() {
        let mut fonts = fonts();
        for font in [FontId::proportional(13.0), FontId::monospace(12.0)] {
            let typed: String = (' '..='~').chain('\u{a0}'..='ſ').collect();
            assert!(fonts.has_glyphs(&font, &typed), "{font:?}");
            for key in Key::ALL {
                let shortcut = Shortcut { ctrl: false, alt: false, shift: false, pad: false, key: *key };
                assert!(fonts.has_glyphs(&font, &shortcut.text()), "{key:?}");
            }
        }
    }

    #[test]
    fn digits_line_up_in_columns() {
        let mut fonts = fonts();
        let mut view = fonts.with_pixels_per_point(1.0);
        let mut width = |character| view.glyph_width(&FontId::monospace(12.0), character);
        let zero = width('0');
        assert!(zero > 0.0);
        assert!("123456789-.−".chars().all(|character| width(character) == zero));
    }
}
