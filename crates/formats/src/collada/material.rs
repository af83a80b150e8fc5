//! Materials: what faces of a primitive have.

use super::xml::{Document, Node};
use crate::material::Rgb;
use crate::obj::names::unpainted;
use crate::obj::runs::Names;
use crate::scan::Scan;
use halfedge::attribute::Column;
use halfedge::{Color, NONE, keys};
use std::collections::HashMap;

/// What the faces of one material have.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
struct Paint {
    /// The material's name; empty for one that only stands for a colour.
    name: String,
    /// The diffuse colour, if there is one.
    color: Option<Color>,
}

/// The materials of one instance, by the symbols that primitives have for them.
pub(super) struct Palette<'d, 'a> {
    document: &'d Document<'a>,
    bound: HashMap<&'d str, &'d str>,
    list: Vec<Paint>,
    numbers: HashMap<Paint, u32>,
}

impl<'d, 'a> Palette<'d, 'a> {
    /// The materials that primitives of an instance may name.
    pub(super) fn of(document: &'d Document<'a>, binding: Option<&Node<'a>>) -> Self {
        let binds = binding.and_then(|node| document.path(node, &["bind_material", "technique_common"]));
        let bound = binds
            .into_iter()
            .flat_map(|binds| document.children_named(binds, "instance_material"))
            .filter_map(|bind| Some((bind.attribute("symbol")?, bind.attribute("target")?)))
            .collect();
        Self { document, bound, list: Vec::new(), numbers: HashMap::new() }
    }

    /// The number of the material that a symbol stands for.
    pub(super) fn number(&mut self, symbol: &str) -> u32 {
        let paint = find(self.document, self.bound.get(symbol).copied(), symbol);
        let next = self.list.len() as u32;
        let number = *self.numbers.entry(paint.clone()).or_insert(next);
        if number == next {
            self.list.push(paint);
        }
        number
    }

    /// Columns of faces with these materials.
    pub(super) fn columns(&self, numbers: &[u32]) -> Vec<Column> {
        let mut columns = Vec::new();
        let paint = |number: &u32| self.list.get(*number as usize);
        // Several materials here may be one by name: different colours of it.
        let mut names = Names::default();
        let of_paint: Vec<u32> = self
            .list
            .iter()
            .map(|paint| if paint.name.is_empty() { NONE } else { names.number(&paint.name) })
            .collect();
        let named: Vec<u32> =
            numbers.iter().map(|&n| of_paint.get(n as usize).copied().unwrap_or(NONE)).collect();
        if named.iter().any(|&name| name != NONE) {
            columns.push(names.column(keys::FACE_MATERIAL, named));
        }
        if numbers.iter().any(|n| paint(n).is_some_and(|paint| paint.color.is_some())) {
            let color = |n: &u32| paint(n).and_then(|paint| paint.color).unwrap_or(Color::UNPAINTED);
            columns.push(Column::with_values(keys::FACE_COLOR, numbers.iter().map(color).collect()));
        }
        columns
    }
}

/// The material that a symbol stands for: the one bound to it, or the one of that id.
fn find(document: &Document, bound: Option<&str>, symbol: &str) -> Paint {
    let Some(material) = document.target(bound.unwrap_or(symbol)).filter(|node| node.name == "material")
    else {
        return Paint { name: symbol.to_owned(), color: None };
    };
    let color = diffuse(document, material);
    let name = material.label();
    match unpainted(name) {
        Some((plain, paint)) if color == Some(paint) => Paint { name: plain.to_owned(), color },
        _ => Paint { name: name.to_owned(), color },
    }
}

fn diffuse(document: &Document, material: &Node) -> Option<Color> {
    let effect = document.target(document.child(material, "instance_effect")?.attribute("url")?)?;
    let technique = document.path(effect, &["profile_COMMON", "technique"])?;
    let shader =
        document.children(technique).find_map(|shader| document.path(shader, &["diffuse", "color"]))?;
    let mut scan = Scan::new(shader.text(), None);
    Some(Rgb::from_srgb([scan.float()?, scan.float()?, scan.float()?]).to_color())
}
