//! Names and diffuse colours of materials.

use super::xml::{Document, Node};
use crate::material::Rgb;
use crate::obj::names::unpainted;
use crate::scan::Scan;
use halfedge::Color;

/// What the faces of one material have.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Material {
    /// Its name; empty for one that only stands for a colour.
    pub name: String,
    /// The diffuse colour, if there is one.
    pub color: Option<Color>,
}

impl Material {
    /// The material that a symbol stands for: the one bound to it, or the one of that id.
    pub(crate) fn find(document: &Document, bound: Option<&str>, symbol: &str) -> Self {
        let Some(material) = document.target(bound.unwrap_or(symbol)).filter(|node| node.name == "material")
        else {
            return Self { name: symbol.to_owned(), color: None };
        };
        let color = diffuse(document, material);
        let name = material.label();
        match unpainted(name) {
            Some((plain, paint)) if color == Some(paint) => Self { name: plain.to_owned(), color },
            _ => Self { name: name.to_owned(), color },
        }
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
