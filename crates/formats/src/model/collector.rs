//! Collects the materials that faces of a file use, while it is read.

use crate::model::labels::Names;
use crate::model::material::{Material, Materials};
use crate::model::paint::unpainted;
use crate::model::texture::Image;
use halfedge::attribute::Column;
use halfedge::{Color, NONE, keys};
use std::collections::HashMap;

/// The attributes of faces with one material.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Paint {
    /// The material's name; empty for a mere colour.
    pub name: String,
    /// The base colour, if the material states one.
    pub color: Option<Color>,
}

/// Collects materials and images. Gives different materials different names.
#[derive(Default)]
pub(crate) struct MaterialCollector {
    materials: Materials,
    /// The index of each material in the list, by name.
    numbers: HashMap<String, usize>,
    /// The last number appended to each name.
    copies: HashMap<String, usize>,
    /// Materials of painted variants, by their plain names: used if nothing else has the name.
    plain: Vec<(String, Material)>,
}

impl MaterialCollector {
    /// Adds an image unless it is known, and returns its index.
    pub(crate) fn add_image(&mut self, image: Image) -> u32 {
        self.materials.add_image(image)
    }

    /// Adds a material that has this name in the file, and returns the attributes of its faces.
    pub(crate) fn add(&mut self, label: &str, material: Material) -> Paint {
        let color = material.color();
        let name = match unpainted(label) {
            // A variant for painted faces stands for the material that it was made from.
            Some((plain, paint)) if color == Some(paint) => {
                if !plain.is_empty() {
                    self.plain.push((plain.to_owned(), material));
                }
                plain.to_owned()
            }
            _ => self.add_named(label, material),
        };
        Paint { name, color }
    }

    /// Adds a material and returns its name: a new one if a different material has this name. Mere colours
    /// share a name.
    fn add_named(&mut self, label: &str, mut material: Material) -> String {
        material.name = label.to_owned();
        if let Some(known) = self.numbers.get(label).and_then(|&number| self.materials.list.get(number)) {
            if *known == material || (is_color(known) && is_color(&material)) {
                return material.name;
            }
            let mut number = self.copies.get(label).copied().unwrap_or(1);
            while self.numbers.contains_key(&material.name) {
                number += 1;
                material.name = format!("{label}.{number}");
            }
            self.copies.insert(label.to_owned(), number);
        }
        let name = material.name.clone();
        self.numbers.insert(name.clone(), self.materials.list.len());
        self.materials.list.push(material);
        name
    }

    /// The collected materials.
    pub(crate) fn finish(mut self) -> Materials {
        for (name, material) in std::mem::take(&mut self.plain) {
            if !self.numbers.contains_key(&name) {
                self.add_named(&name, material);
            }
        }
        self.materials
    }
}

/// Whether a material states nothing but a base colour.
pub(crate) fn is_color(material: &Material) -> bool {
    let name = material.name.clone();
    *material == Material { name, base_color: material.base_color, ..Material::default() }
}

/// The columns of faces with these paints, by the number of each face's paint. A number out of range stands
/// for no material.
pub(crate) fn face_columns(paints: &[&Paint], faces: &[u32]) -> Vec<Column> {
    let mut columns = Vec::new();
    // Paints of different colours may share a material.
    let mut names = Names::default();
    let name = |paint: &&Paint| match paint.name.as_str() {
        "" => NONE,
        name => names.number(name),
    };
    let of_paint: Vec<u32> = paints.iter().map(name).collect();
    let named: Vec<u32> = faces.iter().map(|&n| of_paint.get(n as usize).copied().unwrap_or(NONE)).collect();
    if named.iter().any(|&name| name != NONE) {
        columns.push(names.column(keys::FACE_MATERIAL, named));
    }
    let color = |n: &u32| paints.get(*n as usize).and_then(|paint| paint.color);
    if faces.iter().any(|n| color(n).is_some()) {
        let colors = faces.iter().map(|n| color(n).unwrap_or(Color::UNPAINTED)).collect();
        columns.push(Column::with_values(keys::FACE_COLOR, colors));
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::material::Rgb;
    use crate::model::paint::painted;

    fn colored(color: Color) -> Material {
        Material { base_color: Some(Rgb::from_color(color)), ..Material::default() }
    }

    #[test]
    fn painted_materials_are_the_one_that_they_were_made_from() {
        let (red, blue) = (Color([255, 0, 0]), Color([0, 0, 255]));
        let rich = |color| Material { alpha: Some(0.5), ..colored(color) };
        let mut collector = MaterialCollector::default();
        let first = collector.add(&painted("wood", blue), rich(blue));
        assert_eq!(first, Paint { name: "wood".to_owned(), color: Some(blue) });
        assert_eq!(collector.add("wood", rich(red)).name, "wood");
        assert_eq!(collector.add(&painted("", red), colored(red)).name, "");
        assert_eq!(collector.add(&painted("tin", red), rich(red)).name, "tin");
        let names = collector.finish().list;
        let names: Vec<_> = names.iter().map(|material| (material.name.as_str(), material.color())).collect();
        assert_eq!(names, [("wood", Some(red)), ("tin", Some(red))]);
    }

    #[test]
    fn different_materials_of_one_name_get_two() {
        let mut collector = MaterialCollector::default();
        let alpha = |alpha| Material { alpha: Some(alpha), ..Material::default() };
        let names = [0.5, 0.25, 0.5, 0.75].map(|value| collector.add("glass", alpha(value)).name);
        assert_eq!(names, ["glass", "glass.2", "glass", "glass.3"]);
        // Mere colours share a name.
        let colors = [[1, 2, 3], [4, 5, 6]].map(|color| collector.add("red", colored(Color(color))).name);
        assert_eq!(colors, ["red", "red"]);
    }
}
