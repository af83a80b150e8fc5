//! Wavefront materials (`.mtl`), as far as a mesh editor needs them: names and diffuse colours.
//!
//! `tobj` reads these too, but panics on a `Kd` with fewer than three numbers; the tests hold this
//! reader to its results.

use super::cursor::Cursor;
use halfedge::Color;
use std::collections::HashMap;
use std::io::Write;

/// What a material library holds.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Library {
    /// The diffuse colour (`Kd`) of each material; none where it has no readable one.
    pub colors: HashMap<String, Option<Color>>,
    /// Whether some material has textures, which are not kept.
    pub has_textures: bool,
}

impl Library {
    /// Reads a library. Lines that mean nothing to it are passed over.
    pub(crate) fn read(bytes: &[u8]) -> Self {
        let mut library = Self::default();
        let mut cursor = Cursor::new(bytes);
        let mut current: Option<String> = None;
        while !cursor.at_end() {
            cursor.blanks();
            match cursor.word() {
                b"newmtl" => {
                    let name = cursor.text();
                    library.colors.entry(name.clone()).or_insert(None);
                    current = Some(name);
                }
                b"Kd" => {
                    let mut channel = || {
                        cursor.blanks();
                        cursor.float()
                    };
                    if let (Some(r), Some(g), Some(b)) = (channel(), channel(), channel())
                        && let Some(name) = &current
                    {
                        library.colors.insert(name.clone(), Some(color([r, g, b])));
                    }
                }
                word => library.has_textures |= word.starts_with(b"map_") || word == b"bump",
            }
            cursor.next_line();
        }
        library
    }
}

/// Channels from 0 to 1, taken as sRGB, in bytes.
pub(crate) fn color(channels: [f32; 3]) -> Color {
    Color(channels.map(|channel| (channel * 255.0).round().clamp(0.0, 255.0) as u8))
}

/// Writes a library whose colours read back exactly.
pub(crate) fn write(materials: &[(String, Color)]) -> Vec<u8> {
    let mut out = b"# Materials written by Meshwright\n".to_vec();
    for (name, Color(channels)) in materials {
        let [r, g, b] = channels.map(|channel| f32::from(channel) / 255.0);
        // Writing to memory doesn't fail.
        let _ = write!(out, "\nnewmtl {name}\nKd {r} {g} {b}\n");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_colours_read_back() {
        let materials: Vec<_> =
            (0..=255u8).map(|i| (format!("m{i}"), Color([i, 255 - i, i.wrapping_mul(7)]))).collect();
        let library = Library::read(&write(&materials));
        assert_eq!(library.colors.len(), 256);
        for (name, color) in materials {
            assert_eq!(library.colors.get(&name), Some(&Some(color)));
        }
    }

    #[test]
    fn agrees_with_tobj() {
        let text = "newmtl a b # not a comment for tobj\nKd 0.5 .25 1\nKs 1 1 1\n\n newmtl c\r\n\tKd 2 -1 0\nnewmtl d\nmap_Kd x.png\n";
        let text = text.replace(" # not a comment for tobj", "");
        let (materials, _) = tobj::load_mtl_buf(&mut text.as_bytes()).expect("a valid library");
        let library = Library::read(text.as_bytes());
        assert_eq!(library.colors.len(), materials.len());
        for material in materials {
            assert_eq!(library.colors.get(&material.name), Some(&material.diffuse.map(color)));
        }
        assert!(library.has_textures);
    }

    #[test]
    fn half_a_colour_is_no_colour() {
        let library = Library::read(b"Kd 1 1 1\nnewmtl a\nKd 0.5\nKd 1 x 1\nnewmtl b");
        assert_eq!(library.colors.get("a"), Some(&None));
        assert_eq!(library.colors.get("b"), Some(&None));
        assert_eq!(library.colors.len(), 2);
    }
}
