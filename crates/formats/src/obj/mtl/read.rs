//! Reading a material library.

use super::statement::{first_word, is_readable};
use super::texture::{self, TEXTURES};
use crate::file::NamedBytes;
use crate::model::images::image;
use crate::model::material::{Material, Materials, MtlStatements, Rgb};
use crate::model::texture::Texture;
use crate::obj::cursor::Cursor;
use crate::report::{ImportReport, Places};
use crate::text::encoding::{Encoding, decode};
use std::collections::HashMap;

/// A material's statements while its library is read.
#[derive(Default)]
struct Statements {
    name: String,
    kept: MtlStatements,
    /// Those that `tobj` takes.
    readable: String,
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
