//! The material statements of an OBJ.

use crate::model::paint::painted;
use crate::obj::names::clean;
use halfedge::{Color, Element, Mesh, NONE, keys};
use std::collections::HashMap;

/// A material of the file: its name there, the colour of its faces, and its label in the mesh, which is empty if
/// it only stands for a colour.
pub(super) struct Named {
    pub name: String,
    pub color: Color,
    pub label: String,
}

/// All materials of the file. A material whose faces have different colours becomes several.
#[derive(Default)]
pub(super) struct Materials {
    has_colors: bool,
    pub list: Vec<Named>,
    numbers: HashMap<(String, Option<Color>), usize>,
    /// The colours that are written under materials' own names.
    own: HashMap<String, Color>,
}

impl Materials {
    pub(super) fn new(has_colors: bool, own: HashMap<String, Color>) -> Self {
        Self { has_colors, own, ..Self::default() }
    }

    /// The number of the file's material for faces with this material (none if empty) and colour.
    pub(super) fn number(&mut self, material: &str, color: Color) -> usize {
        let color_key = self.has_colors.then_some(color);
        if let Some(&number) = self.numbers.get(&(material.to_owned(), color_key)) {
            return number;
        }
        let name = if material.is_empty() {
            painted("", color)
        } else if !self.has_colors || self.own.get(material) == Some(&color) {
            material.to_owned()
        } else {
            painted(material, color)
        };
        let number = self.list.len();
        self.list.push(Named { name, color, label: material.to_owned() });
        self.numbers.insert((material.to_owned(), color_key), number);
        number
    }
}

/// The `usemtl` statements of one mesh.
pub(super) struct FaceMaterials<'a> {
    values: Option<&'a [u32]>,
    colors: Option<&'a [Color]>,
    labels: Vec<String>,
    current: Option<(u32, Color)>,
    written: Option<usize>,
}

impl<'a> FaceMaterials<'a> {
    pub(super) fn new(mesh: &'a Mesh) -> Self {
        let labels =
            mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |column| &column.labels);
        Self {
            values: mesh.attribute(keys::FACE_MATERIAL),
            colors: mesh.attribute(keys::FACE_COLOR),
            labels: labels.iter().map(|label| clean(label)).collect(),
            current: None,
            written: None,
        }
    }

    fn value(&self, face: usize) -> (u32, Color) {
        let value = self.values.and_then(|values| values.get(face)).copied().unwrap_or(NONE);
        let color = self.colors.and_then(|colors| colors.get(face)).copied().unwrap_or(Color::UNPAINTED);
        (value, color)
    }

    /// Whether this face has another material or colour than the one before: most have not.
    #[inline]
    pub(super) fn differs(&self, face: usize) -> bool {
        self.current != Some(self.value(face))
    }

    /// The name to write before this face, unless it applies already.
    pub(super) fn enter<'m>(&mut self, face: usize, materials: &'m mut Materials) -> Option<&'m str> {
        let (value, color) = self.value(face);
        self.current = Some((value, color));
        let label = self.labels.get(value as usize).map_or("", String::as_str);
        let plain = label.is_empty() && color == Color::UNPAINTED;
        // No statement ends a material, so a face without one after others gets that of the plain colour.
        if plain && self.written.is_none() && materials.list.is_empty() {
            return None;
        }
        let number = materials.number(label, color);
        if self.written == Some(number) {
            return None;
        }
        self.written = Some(number);
        materials.list.get(number).map(|named| named.name.as_str())
    }
}
