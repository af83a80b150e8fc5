//! Wavefront material libraries (`.mtl`).
//!
//! `tobj` reads the values. It stops at, or panics on, statements with missing or unreadable values, so
//! those are taken out before and named in the report. Every statement is also kept as it stands, to be
//! written again. Statements beyond `tobj`'s follow "Extending the MTL format for PBR" (Exocortex).

use super::cursor::Cursor;
use super::texture::{self, TEXTURES};
use crate::file::NamedBytes;
use crate::model::images::image;
use crate::model::material::{Material, Materials, MtlStatements, Property, Rgb};
use crate::model::texture::Texture;
use crate::report::{ImportReport, Places, counted_words};
use crate::text::encoding::{Encoding, decode};
use halfedge::Color;
use std::collections::HashMap;
use std::io::Write;

/// A material's statements while its library is read.
#[derive(Default)]
struct Statements {
    name: String,
    kept: MtlStatements,
    /// Those that `tobj` takes.
    readable: String,
}

/// The word that a statement begins with, and the rest.
fn first_word(line: &str) -> (&str, &str) {
    line.split_once(char::is_whitespace).map_or((line, ""), |(word, rest)| (word, rest.trim()))
}

/// Whether `tobj` takes a statement, and its values are finite.
fn is_readable(word: &str, rest: &str) -> bool {
    let has_numbers = |count: usize| {
        let is_number = |word: &&str| word.parse::<f32>().is_ok_and(f32::is_finite);
        rest.split_whitespace().take(count).filter(is_number).count() == count
    };
    match word {
        "Ka" | "Kd" | "Ks" | "Ke" => has_numbers(3),
        "Ns" | "Ni" | "d" | "Tr" | "Pr" | "Pm" => has_numbers(1),
        "illum" => rest.split_whitespace().next().is_some_and(|word| word.parse::<u8>().is_ok()),
        word if TEXTURES.iter().any(|(texture, _)| *texture == word) => !rest.is_empty(),
        _ => true,
    }
}

/// Reads a library: its materials in order, each name once. Comments are left out. `files` are those
/// that came with it, for the images of textures.
pub(crate) fn read(library: &NamedBytes, files: &[NamedBytes], report: &mut ImportReport) -> Materials {
    let mut all: Vec<Statements> = Vec::new();
    let mut numbers: HashMap<String, usize> = HashMap::new();
    let mut current = None;
    let mut unreadable = Places::default();
    let (text, encoding) = decode(&library.bytes);
    if encoding == Encoding::Latin1 {
        report.info(format!(
            "The text of {} is neither UTF-8 nor UTF-16, so it was read as Latin-1 (Windows-1252)",
            library.name
        ));
    }
    let mut cursor = Cursor::new(text.as_bytes());
    while !cursor.at_end() {
        let line = cursor.text();
        let number = cursor.line;
        cursor.next_line();
        // A backslash at the end of the file would join the next line when the statement is written.
        let line = line.trim_end_matches(|c: char| c == '\\' || c.is_whitespace());
        let (word, rest) = first_word(line);
        if word == "newmtl" {
            let number = *numbers.entry(rest.to_owned()).or_insert(all.len());
            if number == all.len() {
                all.push(Statements { name: rest.to_owned(), ..Statements::default() });
            }
            current = Some(number);
        } else if let Some(material) = current.and_then(|number| all.get_mut(number))
            && !word.is_empty()
            && !word.starts_with('#')
        {
            let readable = is_readable(word, rest);
            if readable {
                material.readable += &format!("{line}\n");
            } else {
                unreadable.add(number);
            }
            if word == "Kd" && readable {
                material.kept.diffuse = Some(rest.to_owned());
            } else {
                material.kept.others += &format!("{line}\n");
            }
        }
    }
    if !unreadable.is_empty() {
        let what = format!(
            "of {} not used, but kept for saving as OBJ: a value is missing or can't be read",
            library.name
        );
        report.info(unreadable.sentence("material statement", "material statements", &what, "line"));
    }
    let mut materials = Materials::default();
    let values = values(&all);
    for (statements, values) in all.into_iter().zip(values) {
        let material = material(statements, &values, files, &mut materials);
        materials.list.push(material);
    }
    materials
}

/// The values of each material.
fn values(all: &[Statements]) -> Vec<tobj::Material> {
    // Numbers in place of names: tobj takes no empty name, and one of two of the same name.
    let text: String =
        (0..).zip(all).map(|(number, material)| format!("newmtl {number}\n{}", material.readable)).collect();
    let mut values = tobj::load_mtl_buf(&mut text.as_bytes()).map(|(values, _)| values).unwrap_or_default();
    values.resize_with(all.len(), tobj::Material::default);
    values
}

/// The material of these values and statements; its images go to `materials`.
fn material(
    statements: Statements,
    values: &tobj::Material,
    files: &[NamedBytes],
    materials: &mut Materials,
) -> Material {
    let other = |word: &str| values.unknown_param.get(word).map(String::as_str);
    let number = |word: &str| other(word)?.split_whitespace().next()?.parse::<f32>().ok();
    let color = |color: Option<[f32; 3]>| color.map(Rgb::from_srgb);
    let mut material = Material {
        name: statements.name,
        base_color: color(values.diffuse),
        alpha: values.dissolve.or_else(|| number("Tr").map(|transparency| 1.0 - transparency)),
        emissive: color(values.emissive),
        metallic: number("Pm"),
        roughness: number("Pr"),
        specular: color(values.specular),
        ambient: color(values.ambient),
        shininess: values.shininess,
        index_of_refraction: values.optical_density,
        mtl: Some(statements.kept),
        ..Material::default()
    };
    for (word, role) in TEXTURES {
        let text = match word {
            "map_Ka" => values.ambient_texture.as_deref(),
            "map_Kd" => values.diffuse_texture.as_deref(),
            "map_Ks" => values.specular_texture.as_deref(),
            "map_Ns" => values.shininess_texture.as_deref(),
            "map_d" => values.dissolve_texture.as_deref(),
            // tobj takes "map_bump" and "bump" for the same.
            "map_Bump" => values.normal_texture.as_deref(),
            word => other(word),
        };
        let Some(text) = text else { continue };
        let (name, texture) = texture::parse(role, text);
        if !name.is_empty() && material.texture(role).is_none() {
            let image = materials.add_image(image(name, files));
            material.textures.push(Texture { image, ..texture });
        }
    }
    material
}

/// The names of the images that a library's textures show.
pub(crate) fn image_names(library: &NamedBytes) -> Vec<String> {
    let materials = read(library, &[], &mut ImportReport::default());
    materials.images.into_iter().map(|image| image.name).collect()
}

/// A material to write.
pub(crate) struct Entry<'a> {
    pub name: String,
    /// The colour of its faces; none where no face of the document has one.
    pub color: Option<Color>,
    /// What is known of it.
    pub known: Option<&'a Material>,
}

/// Writes a library whose colours read back exactly. A colour that the material still has is written as
/// it was. `image_names` are the names of the document's images in the file.
pub(crate) fn write(materials: &[Entry], image_names: &[String]) -> Vec<u8> {
    let mut out = b"# Materials written by Meshwright\n".to_vec();
    for Entry { name, color, known } in materials {
        let own = known.and_then(Material::color);
        // Writing to memory doesn't fail.
        let _ = writeln!(out, "\nnewmtl {name}");
        let is_own = match color {
            None => true,
            Some(color) => own.map_or(known.is_some() && *color == Color::UNPAINTED, |own| own == *color),
        };
        let mtl = known.and_then(|known| known.mtl.as_ref());
        if !is_own && let Some(Color(channels)) = color {
            let [r, g, b] = channels.map(|channel| f32::from(channel) / 255.0);
            let _ = writeln!(out, "Kd {r} {g} {b}");
        } else if let Some(mtl) = mtl {
            if let Some(diffuse) = &mtl.diffuse {
                let _ = writeln!(out, "Kd {diffuse}");
            }
        } else if let Some(color) = known.and_then(|known| known.base_color) {
            let _ = writeln!(out, "{}", color_statement("Kd", color));
        }
        match (mtl, known) {
            (Some(mtl), _) => {
                for line in mtl.others.lines() {
                    // A "Kd" that can't be read would override the new colour.
                    if is_own || first_word(line).0 != "Kd" {
                        let _ = writeln!(out, "{line}");
                    }
                }
            }
            (None, Some(known)) => {
                for line in statements(known, image_names) {
                    let _ = writeln!(out, "{line}");
                }
            }
            (None, None) => {}
        }
    }
    out
}

fn color_statement(word: &str, color: Rgb) -> String {
    let [r, g, b] = color.to_srgb();
    format!("{word} {r} {g} {b}")
}

/// The statements of a material that no library has, without its base colour.
fn statements(material: &Material, image_names: &[String]) -> Vec<String> {
    let color = |word: &str, color: Option<Rgb>| color.map(|color| color_statement(word, color));
    let number = |word: &str, value: Option<f32>| value.map(|value| format!("{word} {value}"));
    let values = [
        color("Ka", material.ambient),
        color("Ks", material.specular),
        color("Ke", material.emissive),
        number("Ns", material.shininess),
        number("Ni", material.index_of_refraction),
        number("d", material.alpha),
        number("Pm", material.metallic),
        number("Pr", material.roughness),
    ];
    let textures = material
        .textures
        .iter()
        .filter_map(|texture| texture::statement(texture, image_names.get(texture.image as usize)?));
    values.into_iter().flatten().chain(textures).collect()
}

/// The words of statements that fill no field of a material.
pub(crate) fn other_statements(mtl: &MtlStatements) -> impl Iterator<Item = &str> {
    const FIELDS: [&str; 10] = ["Ka", "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "Pm", "Pr"];
    let is_field =
        |word: &str| FIELDS.contains(&word) || TEXTURES.iter().any(|(texture, _)| *texture == word);
    mtl.others
        .lines()
        .map(first_word)
        .filter(move |(word, rest)| !is_field(word) || !is_readable(word, rest))
        .map(|(word, _)| word)
}

/// The words that statements of materials begin with besides `Kd`, each with how many of them there are:
/// "Ks (3), map_Kd (1)"; none where there are no statements.
pub(crate) fn statement_counts<'a>(materials: impl Iterator<Item = &'a Material>) -> Option<String> {
    let statements = materials.filter_map(|material| material.mtl.as_ref());
    let words = statements.flat_map(|mtl| mtl.others.lines()).map(|line| first_word(line).0);
    counted_words(words)
}

/// Whether a library written by [`write`] holds a property of a material.
pub(crate) fn keeps(property: Property) -> bool {
    match property {
        Property::AlphaMode | Property::DoubleSided => false,
        Property::Texture(role) => TEXTURES.iter().any(|(_, known)| *known == role),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::texture::TextureRole;

    fn read(text: &str) -> (Materials, ImportReport) {
        let mut report = ImportReport::default();
        let materials = super::read(&NamedBytes::new("sub/a.mtl", text), &[], &mut report);
        (materials, report)
    }

    fn written(entries: &[Entry]) -> String {
        String::from_utf8(write(entries, &[])).expect("UTF-8")
    }

    #[test]
    fn all_colours_read_back() {
        let color = |i: u8| Color([i, 255 - i, i.wrapping_mul(7)]);
        let entry = |i: u8| Entry { name: format!("m{i}"), color: Some(color(i)), known: None };
        let (materials, _) = read(&written(&(0..=255).map(entry).collect::<Vec<_>>()));
        assert_eq!(materials.list.len(), 256);
        for (i, material) in (0..=255).zip(materials.list) {
            assert_eq!(
                (material.name.as_str(), material.color()),
                (format!("m{i}").as_str(), Some(color(i)))
            );
        }
    }

    #[test]
    fn values_and_textures_are_read() {
        let (materials, report) = read(
            "newmtl a b\nKd 0.5 .25 1\nKs 1 1 1\nKa 0 0 0\nKe 2 0 0\nNs 9\nNi 1.5\nd 0.5\nPm 1\nPr 0.25\n\
             map_Kd -s 2 2 1 a b.png\nmap_bump -bm 2 bumps.png\nnorm n.png\nillum 2\n newmtl c\r\n\tKd 2 -1 0\n\
             Tr 0.25\nnewmtl d\nmap_Kd x.png\nmap_Kd y.png\n",
        );
        assert!(report.is_clean() && report.notes().is_empty(), "{report}");
        let [a, c, d] = materials.list.as_slice() else { panic!("{materials:?}") };
        assert_eq!(a.base_color, Some(Rgb::from_srgb([0.5, 0.25, 1.0])));
        assert_eq!(a.color(), Some(Color([128, 64, 255])));
        assert_eq!([a.specular, a.ambient].map(|c| c.map(Rgb::to_srgb)), [Some([1.0; 3]), Some([0.0; 3])]);
        assert_eq!(a.emissive.map(Rgb::to_srgb), Some([2.0, 0.0, 0.0]));
        assert_eq!([a.shininess, a.index_of_refraction, a.alpha], [Some(9.0), Some(1.5), Some(0.5)]);
        assert_eq!([a.metallic, a.roughness], [Some(1.0), Some(0.25)]);
        let shown = |material: &Material, role| {
            let texture = material.texture(role)?;
            Some((materials.image(texture)?.name.clone(), texture.scale))
        };
        assert_eq!(shown(a, TextureRole::BaseColor), Some(("a b.png".to_owned(), 1.0)));
        assert_eq!(shown(a, TextureRole::Bump), Some(("bumps.png".to_owned(), 2.0)));
        assert_eq!(shown(a, TextureRole::Normal), Some(("n.png".to_owned(), 1.0)));
        assert_eq!((c.color(), c.alpha), (Some(Color([255, 0, 0])), Some(0.75)));
        assert_eq!(shown(d, TextureRole::BaseColor), Some(("y.png".to_owned(), 1.0)), "the last counts");
    }

    #[test]
    fn unreadable_statements_are_kept_and_named() {
        let (materials, report) = read(
            "Kd 1 1 1\nnewmtl a\nKd 0.5\nKd 1 x 1\nKs\nNs nan\nd -halo 1\nmap_Kd\nillum x\nKd inf 0 0\nnewmtl b\nKd spectral x.rfl",
        );
        assert_eq!(materials.list.iter().map(Material::color).collect::<Vec<_>>(), [None, None]);
        let others = |at: usize| materials.list[at].mtl.as_ref().map(|mtl| mtl.others.as_str());
        assert_eq!(others(0), Some("Kd 0.5\nKd 1 x 1\nKs\nNs nan\nd -halo 1\nmap_Kd\nillum x\nKd inf 0 0\n"));
        assert_eq!(others(1), Some("Kd spectral x.rfl\n"));
        let note = &report.notes()[0].text;
        assert!(
            note.starts_with("9 material statements of sub/a.mtl") && note.contains("lines 3, 4, 5"),
            "{note}"
        );
    }

    #[test]
    fn a_library_is_written_as_it_was_but_for_colours_that_changed() {
        let text = "# Materials written by Meshwright\n\nnewmtl a\nKd 0.5 0.2 0.20\nNs 9\nmap_Kd -s 1 1 1 a b#2.png\n\nnewmtl b\nKd spectral x.rfl\nillum 2\n";
        let (known, _) = read(&text.replace("Ns 9", "  Ns 9 # shiny\n#c"));
        let known = known.list;
        let entries = |colors: [Option<Color>; 2]| -> Vec<Entry> {
            let entry =
                |(known, color)| Entry { name: Material::clone(known).name, color, known: Some(known) };
            known.iter().zip(colors).map(entry).collect()
        };
        let written = |colors| written(&entries(colors));
        assert_eq!(written([known[0].color(), Some(Color::UNPAINTED)]), text);
        assert_eq!(written([None, None]), text);
        let painted = written([Some(Color([255, 0, 0])), Some(Color([0, 255, 0]))]);
        assert_eq!(painted, text.replace("0.5 0.2 0.20", "1 0 0").replace("spectral x.rfl", "0 1 0"));
    }

    #[test]
    fn a_material_of_another_format_reads_back() {
        let mut material = Material {
            name: "a".to_owned(),
            base_color: Some(Rgb::from_linear([0.8, 0.3, 0.1])),
            alpha: Some(0.5),
            emissive: Some(Rgb::from_srgb([0.5, 2.0, 0.0])),
            metallic: Some(0.25),
            roughness: Some(0.75),
            specular: Some(Rgb::from_srgb([0.1, 0.2, 0.3])),
            ambient: Some(Rgb::BLACK),
            shininess: Some(9.5),
            index_of_refraction: Some(1.5),
            textures: vec![Texture::new(TextureRole::BaseColor, 0), Texture::new(TextureRole::Bump, 1)],
            ..Material::default()
        };
        let entry = Entry { name: "a".to_owned(), color: None, known: Some(&material) };
        let text = String::from_utf8(write(&[entry], &["x.png".to_owned(), "y z.png".to_owned()]));
        let (back, _) = read(&text.expect("UTF-8"));
        let mut back = back.list[0].clone();
        // Only as exact as sRGB in single precision is.
        let colors = [&mut material, &mut back].map(|m| m.base_color.take().map(Rgb::to_srgb));
        assert_eq!(colors[0], colors[1]);
        back.mtl = None;
        assert_eq!(back, material);
    }
}
