//! Cuts the fonts of the interface down to the characters that it and most names use: whole, they would be a tenth of the
//! page's program.

use std::ops::RangeInclusive;
use std::path::Path;

use epaint_default_fonts::{HACK_REGULAR, UBUNTU_LIGHT};

/// Latin letters with the punctuation and the signs of European languages, and the signs of the interface.
const TEXT: [RangeInclusive<char>; 10] = [
    ' '..='~',
    '\u{a0}'..='ſ',
    'ƒ'..='ƒ',
    'ˆ'..='˝',
    'π'..='π',
    '\u{2010}'..='⁄',
    '€'..='€',
    '™'..='™',
    '←'..='↙',
    '−'..='−',
];

/// What is written in columns: numbers, ids, colours, keys and links.
const COLUMNS: [RangeInclusive<char>; 6] =
    [' '..='~', '\u{a0}'..='\u{a0}', '°'..='°', '×'..='×', '…'..='…', '−'..='−'];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    cut("text.ttf", UBUNTU_LIGHT, &TEXT);
    cut("columns.ttf", HACK_REGULAR, &COLUMNS);
}

/// Writes the part of a font that draws these characters, with its kerning and hinting.
fn cut(name: &str, font: &[u8], ranges: &[RangeInclusive<char>]) {
    let characters: Vec<u32> = ranges.iter().cloned().flatten().map(u32::from).collect();
    let part = fontcull::subset_font_data_unicode(font, &characters, &[]).expect("a font that can be cut");
    let folder = std::env::var_os("OUT_DIR").expect("Cargo says where to write");
    std::fs::write(Path::new(&folder).join(name), part).expect("a folder to write to");
}
