//! The images that a PLY names: `comment TextureFile` and a number for each face, as MeshLab writes them.

use crate::file::{NamedBytes, base_name};
use crate::model::Model;
use crate::model::images::{image, image_files, written_names};
use crate::model::labels::labelled;
use crate::model::material::{Material, Materials};
use crate::model::texture::{Texture, TextureRole};
use crate::report::{ImportReport, first_few};
use crate::soup::pieces::Pieces;
use halfedge::attribute::Column;
use halfedge::words::counted;
use halfedge::{Element, NONE, keys};
use std::collections::{HashMap, HashSet};

/// The materials that show these images, and which of them each of `faces` faces has; nothing where there are
/// no images or no faces. `numbers` are those of the faces' images; without, all have the first.
pub(super) fn materials(
    names: &[String],
    numbers: Option<&[i64]>,
    faces: usize,
    files: &[NamedBytes],
    report: &mut ImportReport,
) -> (Materials, Option<Column>) {
    let mut materials = Materials::default();
    let labels = labels(names);
    let number = |face: usize| match numbers {
        Some(numbers) => {
            let number = numbers.get(face).and_then(|&number| u32::try_from(number).ok());
            number.filter(|&number| (number as usize) < names.len()).unwrap_or(NONE)
        }
        None if names.is_empty() => NONE,
        None => 0,
    };
    let values: Vec<u32> = (0..faces).map(number).collect();
    let used: HashSet<u32> = values.iter().copied().collect();
    for ((place, name), label) in (0..).zip(names).zip(&labels) {
        if used.contains(&place) {
            let image = materials.add_image(image(name, files));
            let texture = Texture::new(TextureRole::BaseColor, image);
            let material = Material { name: label.clone(), textures: vec![texture], ..Material::default() };
            materials.list.push(material);
        }
    }
    let unused: Vec<&str> =
        (0..).zip(names).filter(|(place, _)| !used.contains(place)).map(|(_, name)| name.as_str()).collect();
    if !unused.is_empty() {
        let images = counted(unused.len(), "image", "images");
        report.info(format!("{images} that no face shows left out: {}", first_few(&unused, 6)));
    }
    let column = (!materials.is_empty()).then(|| labelled(keys::FACE_MATERIAL, values, &labels));
    (materials, column)
}

/// Names for the materials of images: the images' own without folders and extension, where these differ.
fn labels(names: &[String]) -> Vec<String> {
    let short = |name: &String| {
        let base = base_name(name);
        base.rsplit_once('.').map_or(base, |(stem, _)| stem).to_owned()
    };
    let labels: Vec<String> = names.iter().map(short).collect();
    let distinct: HashSet<&String> = labels.iter().collect();
    if distinct.len() == labels.len() && !distinct.contains(&String::new()) { labels } else { names.to_vec() }
}

/// The images that the faces of a model show.
#[derive(Default)]
pub(super) struct Textures {
    /// Their names in the file.
    pub names: Vec<String>,
    /// Those whose contents are known.
    pub files: Vec<NamedBytes>,
    /// Per face the number of its image, or -1; nothing where all have the only one.
    pub numbers: Option<Vec<i32>>,
}

impl Textures {
    /// The images that materials of faces have for their base colour.
    pub(super) fn of(model: &Model, pieces: &Pieces) -> Self {
        let all = &model.materials;
        let image_of: HashMap<&str, u32> = all
            .list
            .iter()
            .filter_map(|material| {
                let texture = material.texture(TextureRole::BaseColor)?;
                let is_named = all.image(texture).is_some_and(|image| !image.name.trim().is_empty());
                is_named.then_some((material.name.as_str(), texture.image))
            })
            .collect();
        if image_of.is_empty() {
            return Self::default();
        }
        let mut images: Vec<u32> = Vec::new();
        let mut numbers: Vec<i32> = Vec::new();
        for (mesh, _) in &pieces.meshes {
            let labels = mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |c| &c.labels);
            let mut number_of_label: Vec<Option<i32>> = vec![None; labels.len()];
            for f in mesh.faces() {
                let label = mesh.get(keys::FACE_MATERIAL, f.index()) as usize;
                let image = labels.get(label).and_then(|label| image_of.get(label.as_str()));
                let number = image.zip(number_of_label.get_mut(label)).map(|(image, number)| {
                    *number.get_or_insert_with(|| {
                        let known = images.iter().position(|known| known == image);
                        known.unwrap_or_else(|| {
                            images.push(*image);
                            images.len() - 1
                        }) as i32
                    })
                });
                numbers.push(number.unwrap_or(-1));
            }
        }
        let names = written_names(&all.images, [format!("{}.ply", model.name).as_str()]);
        let is_one = images.len() == 1 && numbers.iter().all(|&number| number == 0);
        Self {
            files: image_files(&all.images, &names, &images.iter().copied().collect()),
            names: images.iter().filter_map(|&image| names.get(image as usize).cloned()).collect(),
            numbers: (!images.is_empty() && !is_one).then_some(numbers),
        }
    }

    /// The number of a face's image.
    pub(super) fn number(&self, face: usize) -> Option<i32> {
        self.numbers.as_ref()?.get(face).copied()
    }
}
