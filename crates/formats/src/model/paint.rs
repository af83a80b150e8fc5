//! The materials and colours of faces as files have them.
//!
//! A mesh has a material and a colour for each face; files have colours in their materials only. So a face
//! that was painted in another colour than its material's is written with a material of its own, whose
//! name tells both ([`painted`]), and readers take them apart again ([`unpainted`]).

use crate::model::Model;
use halfedge::{Color, Element, FaceId, Mesh, NONE, keys};
use std::collections::{HashMap, HashSet};

/// What stands in front of the colour in the name of a material made for a painted face.
const PAINT: &str = "color-";

/// The name of the material for faces that have `material` (or none, if empty) and this colour.
pub(crate) fn painted(material: &str, color: Color) -> String {
    let hex = color.to_hex();
    let hex = hex.trim_start_matches('#');
    if material.is_empty() { format!("{PAINT}{hex}") } else { format!("{material}.{PAINT}{hex}") }
}

/// The material and the colour that a name made by [`painted`] stands for.
pub(crate) fn unpainted(name: &str) -> Option<(&str, Color)> {
    let (material, hex) = match name.strip_prefix(PAINT) {
        Some(hex) => ("", hex),
        None => {
            let (material, paint) = name.rsplit_once('.')?;
            (material, paint.strip_prefix(PAINT)?)
        }
    };
    Some((material, Color::from_hex(&format!("#{hex}"))?))
}

/// The colours of faces that go under their materials' own names, by what `name` makes of those: the one
/// that the library gave the material, where a face still has it, or else the one that most faces have.
/// Faces of other colours get a material of a [`painted`] name. Costs O(faces).
pub(crate) fn own_colors(model: &Model, name: impl Fn(&str) -> String) -> HashMap<String, Color> {
    // For each name its colours in order of first use, with how many faces have them.
    let mut found: HashMap<String, Vec<(Color, usize)>> = HashMap::new();
    for mesh in model.objects.iter().map(|object| &object.mesh) {
        let labels = mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |c| &c.labels);
        let of =
            |f: FaceId| (mesh.get(keys::FACE_MATERIAL, f.index()), mesh.get(keys::FACE_COLOR, f.index()));
        let mut counts: HashMap<(u32, Color), usize> = HashMap::new();
        let mut order = Vec::new();
        for key in mesh.faces().map(of).filter(|&(label, _)| label != NONE) {
            *counts.entry(key).or_insert_with(|| {
                order.push(key);
                0
            }) += 1;
        }
        for key in order {
            let Some(label) = labels.get(key.0 as usize) else { continue };
            let colors = found.entry(name(label)).or_default();
            let count = counts.get(&key).copied().unwrap_or_default();
            match colors.iter_mut().find(|(color, _)| *color == key.1) {
                Some((_, sum)) => *sum += count,
                None => colors.push((key.1, count)),
            }
        }
    }
    let mut own: HashMap<String, Color> = HashMap::with_capacity(found.len());
    for material in &model.materials.list {
        let name = name(&material.name);
        let color = material.color().unwrap_or(Color::UNPAINTED);
        if found.get(&name).is_some_and(|colors| colors.iter().any(|&(has, _)| has == color)) {
            own.entry(name).or_insert(color);
        }
    }
    for (name, colors) in found {
        // Of as many faces, the first: `max_by_key` takes the last.
        if let Some(&(color, _)) = colors.iter().rev().max_by_key(|(_, count)| *count) {
            own.entry(name).or_insert(color);
        }
    }
    own
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
    fn painted_names_carry_their_colour() {
        let red = Color([255, 0, 1]);
        assert_eq!(painted("", red), "color-ff0001");
        assert_eq!(unpainted("color-ff0001"), Some(("", red)));
        assert_eq!(unpainted(&painted("a.b", red)), Some(("a.b", red)));
        for name in ["red", "color-", "color-ff00", "x.color-zzzzzz", ".", ""] {
            assert_eq!(unpainted(name), None, "{name}");
        }
    }
}
