//! Writing a material library.

use super::statement::first_word;
use super::texture;
use crate::model::material::{Material, Rgb};
use halfedge::Color;
use std::io::Write;

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
