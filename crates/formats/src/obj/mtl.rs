//! Wavefront materials (`.mtl`): names and diffuse colours, which a mesh editor shows, and every other
//! line as it is, to be written again.
//!
//! `tobj` reads these too, but panics on a `Kd` with fewer than three numbers; the tests hold this
//! reader to its results.

use super::cursor::Cursor;
use crate::report::first_few;
use halfedge::{Color, Element, Mesh, keys};
use serde::{Deserialize, Serialize};
use std::collections::{HashMap, HashSet};
use std::io::Write;

/// A material of a library.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Material {
    /// Its name, which the labels of faces' materials refer to.
    pub name: String,
    /// The diffuse colour (`Kd`) as the file has it: three numbers; none where there is no readable one.
    pub diffuse: Option<String>,
    /// All other lines as the file has them, each with a line end behind it.
    pub lines: String,
}

impl Material {
    /// The diffuse colour in bytes.
    pub fn color(&self) -> Option<Color> {
        diffuse(self.diffuse.as_deref()?)
    }

    /// About the memory that it takes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>() + self.name.len() + self.diffuse.as_ref().map_or(0, String::len) + self.lines.len()
    }
}

/// The colour of three channels in words; none where one can't be read.
fn diffuse(text: &str) -> Option<Color> {
    let mut cursor = Cursor::new(text.as_bytes());
    let mut channel = || {
        cursor.blanks();
        cursor.float()
    };
    Some(color([channel()?, channel()?, channel()?]))
}

/// Channels from 0 to 1, taken as sRGB, in bytes.
pub(crate) fn color(channels: [f32; 3]) -> Color {
    Color(channels.map(|channel| (channel * 255.0).round().clamp(0.0, 255.0) as u8))
}

/// The word that a line begins with, and the rest.
fn first_word(line: &str) -> (&str, &str) {
    line.split_once(char::is_whitespace).map_or((line, ""), |(word, rest)| (word, rest.trim()))
}

/// Reads a library: its materials in order, each name once. Comments are left out.
pub(crate) fn read(bytes: &[u8]) -> Vec<Material> {
    let mut materials: Vec<Material> = Vec::new();
    let mut numbers: HashMap<String, usize> = HashMap::new();
    let mut current = None;
    let mut cursor = Cursor::new(bytes);
    while !cursor.at_end() {
        let line = cursor.text();
        cursor.next_line();
        // A backslash at the end of the file would, when written, take the next line to this one.
        let line = line.trim_end_matches(|c: char| c == '\\' || c.is_whitespace());
        let (word, rest) = first_word(line);
        if word == "newmtl" {
            let number = *numbers.entry(rest.to_owned()).or_insert(materials.len());
            if number == materials.len() {
                materials.push(Material { name: rest.to_owned(), ..Material::default() });
            }
            current = Some(number);
        } else if let Some(material) = current.and_then(|number| materials.get_mut(number))
            && !word.is_empty()
            && !word.starts_with('#')
        {
            if word == "Kd" && diffuse(rest).is_some() {
                material.diffuse = Some(rest.to_owned());
            } else {
                material.lines.push_str(line);
                material.lines.push('\n');
            }
        }
    }
    materials
}

/// A material to write.
pub(crate) struct Entry<'a> {
    pub name: String,
    /// The colour of its faces; none where no face has any.
    pub color: Option<Color>,
    /// What a library said of it.
    pub known: Option<&'a Material>,
}

/// Writes a library whose colours read back exactly. A colour that is still the library's is written
/// as it was there.
pub(crate) fn write(materials: &[Entry]) -> Vec<u8> {
    let mut out = b"# Materials written by Meshwright\n".to_vec();
    for Entry { name, color, known } in materials {
        let own = known.and_then(Material::color);
        // Writing to memory doesn't fail.
        let _ = writeln!(out, "\nnewmtl {name}");
        let is_own = match color {
            None => true,
            Some(color) => own.map_or(known.is_some() && *color == Color::UNPAINTED, |own| own == *color),
        };
        if is_own {
            if let Some(diffuse) = known.and_then(|known| known.diffuse.as_deref()) {
                let _ = writeln!(out, "Kd {diffuse}");
            }
        } else if let Some(Color(channels)) = color {
            let [r, g, b] = channels.map(|channel| f32::from(channel) / 255.0);
            let _ = writeln!(out, "Kd {r} {g} {b}");
        }
        for line in known.map_or("", |known| &known.lines).lines() {
            // A colour in words that mean nothing here would count for more than the new one.
            if is_own || first_word(line).0 != "Kd" {
                let _ = writeln!(out, "{line}");
            }
        }
    }
    out
}

/// The words that lines of materials begin with besides `Kd`, each with how many of them there are:
/// "Ks (3), map_Kd (1)"; nothing where there are none.
pub(crate) fn parameters<'a>(materials: impl Iterator<Item = &'a Material>) -> Option<String> {
    const SHOWN: usize = 8;
    let mut order = Vec::new();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for word in materials.flat_map(|material| material.lines.lines()).map(|line| first_word(line).0) {
        let count = counts.entry(word).or_default();
        if *count == 0 {
            order.push(word);
        }
        *count += 1;
    }
    let count = |word: &&str| format!("{word} ({})", counts.get(word).copied().unwrap_or_default());
    let words: Vec<String> = order.iter().map(count).collect();
    (!words.is_empty()).then(|| first_few(&words, SHOWN))
}

/// The names of the materials that faces of a mesh have.
pub(crate) fn names_in_use(mesh: &Mesh) -> HashSet<&str> {
    let labels = mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |c| &c.labels);
    let mut used = vec![false; labels.len()];
    for f in mesh.faces() {
        if let Some(used) = used.get_mut(mesh.get(keys::FACE_MATERIAL, f.index()) as usize) {
            *used = true;
        }
    }
    labels.iter().zip(used).filter(|(_, used)| *used).map(|(label, _)| label.as_str()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_colours_read_back() {
        let color = |i: u8| Color([i, 255 - i, i.wrapping_mul(7)]);
        let entry = |i: u8| Entry { name: format!("m{i}"), color: Some(color(i)), known: None };
        let materials = read(&write(&(0..=255).map(entry).collect::<Vec<_>>()));
        assert_eq!(materials.len(), 256);
        for (i, material) in (0..=255).zip(materials) {
            assert_eq!(
                (material.name.as_str(), material.color()),
                (format!("m{i}").as_str(), Some(color(i)))
            );
        }
    }

    #[test]
    fn agrees_with_tobj() {
        let text = "newmtl a b # not a comment for tobj\nKd 0.5 .25 1\nKs 1 1 1\n\n newmtl c\r\n\tKd 2 -1 0\nnewmtl d\nmap_Kd x.png\n";
        let text = text.replace(" # not a comment for tobj", "");
        let (materials, _) = tobj::load_mtl_buf(&mut text.as_bytes()).expect("a valid library");
        let own = read(text.as_bytes());
        assert_eq!(own.len(), materials.len());
        for (own, material) in own.iter().zip(materials) {
            assert_eq!((&own.name, own.color()), (&material.name, material.diffuse.map(color)));
        }
        assert_eq!(parameters(own.iter()).as_deref(), Some("Ks (1), map_Kd (1)"));
    }

    #[test]
    fn half_a_colour_is_no_colour() {
        let materials = read(b"Kd 1 1 1\nnewmtl a\nKd 0.5\nKd 1 x 1\nnewmtl b");
        assert_eq!(materials.iter().map(Material::color).collect::<Vec<_>>(), [None, None]);
        assert_eq!(materials[0].lines, "Kd 0.5\nKd 1 x 1\n");
    }

    #[test]
    fn a_library_is_written_as_it_was_but_for_colours_that_changed() {
        let text = "# Materials written by Meshwright\n\nnewmtl a\nKd 0.5 0.2 0.20\nNs 9\nmap_Kd -s 1 1 1 a b#2.png\n\nnewmtl b\nKd spectral x.rfl\nillum 2\n";
        let known = read(text.replace("Ns 9", "  Ns 9 # shiny\n#c").as_bytes());
        let entries = |colors: [Option<Color>; 2]| -> Vec<Entry> {
            let entry =
                |(known, color)| Entry { name: Material::clone(known).name, color, known: Some(known) };
            known.iter().zip(colors).map(entry).collect()
        };
        let written = |colors| String::from_utf8(write(&entries(colors))).expect("UTF-8");
        assert_eq!(written([known[0].color(), Some(Color::UNPAINTED)]), text);
        assert_eq!(written([None, None]), text);
        let painted = written([Some(Color([255, 0, 0])), Some(Color([0, 255, 0]))]);
        assert_eq!(painted, text.replace("0.5 0.2 0.20", "1 0 0").replace("spectral x.rfl", "0 1 0"));
    }
}
