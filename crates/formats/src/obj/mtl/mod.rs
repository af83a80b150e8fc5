//! Wavefront material libraries (`.mtl`).
//!
//! `tobj` reads the values. It stops at, or panics on, statements with missing or unreadable values, so
//! those are taken out before and named in the report. Every statement is also kept as it stands, to be
//! written again. Statements beyond `tobj`'s follow "Extending the MTL format for PBR" (Exocortex).

mod read;
mod statement;
mod texture;
mod write;

pub(super) use read::{image_names, read};
pub(crate) use statement::other_statements;
pub(super) use statement::statement_counts;
pub(super) use texture::keeps_placement;
pub(super) use write::{Entry, write};

use crate::model::material::Property;
use texture::TEXTURES;

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
    use crate::file::NamedBytes;
    use crate::model::material::{Material, Materials, Rgb};
    use crate::model::texture::{Texture, TextureRole};
    use crate::report::ImportReport;
    use halfedge::Color;

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
