//! Controllers: which geometry they deform, and how morphs blend it with others.

use super::numbers::numbers;
use super::scene::mesh;
use super::source::Source;
use super::xml::{Document, Node};
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use glam::DVec3;
use std::collections::HashSet;

/// What an instance shows: a geometry, and what deforms it.
pub(super) struct Shape<'d, 'a> {
    pub geometry: &'d Node<'a>,
    pub morph: Option<&'d Node<'a>>,
    pub skin: Option<&'d Node<'a>>,
}

impl<'d, 'a> Shape<'d, 'a> {
    /// Follows controllers to the geometry that they start from.
    ///
    /// # Errors
    /// In words, where there is none.
    pub(super) fn find(
        document: &'d Document<'a>,
        content: &'d Node<'a>,
        notes: &mut Notes,
    ) -> Result<Self, String> {
        let (mut morph, mut skin) = (None, None);
        let mut met = HashSet::new();
        let mut at = content;
        while at.name == "controller" {
            if !met.insert(at.index) {
                return Err("its controllers refer to each other in a circle".to_owned());
            }
            let deformer = document
                .children(at)
                .find(|child| matches!(child.name, "skin" | "morph"))
                .ok_or_else(|| format!("controller \"{}\" has neither skin nor morph", at.label()))?;
            let slot = if deformer.name == "skin" { &mut skin } else { &mut morph };
            if slot.replace(deformer).is_some() {
                notes.fault(
                    Fault::Attribute,
                    format!(
                        "controller \"{}\": of several <{}> one is applied",
                        content.label(),
                        deformer.name
                    ),
                );
            }
            let reference = deformer.attribute("source").unwrap_or_default();
            let missing = || format!("its geometry {}", document.why_missing(reference));
            at = document.target(reference).ok_or_else(missing)?;
        }
        match at.name {
            "geometry" => Ok(Self { geometry: at, morph, skin }),
            name => Err(format!("it shows a <{name}>")),
        }
    }
}

/// Morph targets, which are blended into a geometry by weights.
pub(super) struct Morph {
    targets: Vec<(Source<f64>, f64)>,
    /// Whether targets are added to the geometry's own positions, rather than mixed with them.
    is_relative: bool,
}

impl Morph {
    /// Reads the targets of a `<morph>` with their weights. None where no weight moves anything. Adds the
    /// geometries of all targets to `used`.
    pub(super) fn read(
        document: &Document,
        morph: &Node,
        geometry: &Node,
        used: &mut HashSet<u32>,
        notes: &mut Notes,
    ) -> Option<Self> {
        let label = geometry.label();
        let input = |semantic: &str| {
            let targets = document.child(morph, "targets")?;
            let mut inputs = document.children_named(targets, "input");
            inputs.find(|input| input.attribute("semantic") == Some(semantic))?.attribute("source")
        };
        let array = input("MORPH_TARGET").and_then(|source| {
            let source = document.target(source)?;
            document.children(source).find(|child| matches!(child.name, "IDREF_array" | "Name_array"))
        });
        let ids = array.map(Node::word).unwrap_or_default();
        let ids: Vec<&str> = ids.split_whitespace().collect();
        let weights = input("MORPH_WEIGHT").and_then(|source| document.target(source));
        let weights = weights.and_then(|source| document.child(source, "float_array"));
        let weights =
            weights.map_or(Vec::new(), |array| numbers::<f64>(array.text(), Some(ids.len())).values);
        let mut targets = Vec::new();
        let mut names = Vec::new();
        for (i, id) in ids.iter().enumerate() {
            let weight = weights.get(i).copied().filter(|weight| weight.is_finite()).unwrap_or(0.0);
            let Some(target) = document.target(id).filter(|node| node.name == "geometry") else {
                notes.fault(
                    Fault::Attribute,
                    format!("geometry \"{label}\": morph target \"{id}\" doesn't exist"),
                );
                continue;
            };
            used.insert(target.index);
            names.push(target.label());
            if weight == 0.0 {
                continue;
            }
            match positions(document, target, notes) {
                Ok(source) => targets.push((source, weight)),
                Err(why) => notes.fault(
                    Fault::Attribute,
                    format!("geometry \"{label}\": morph target \"{}\" ({why})", target.label()),
                ),
            }
        }
        if !names.is_empty() {
            let names = first_few(&names, 6);
            notes.info(format!(
                "Geometry \"{label}\" is blended by its morph weights; its morph targets are not kept: {names}"
            ));
        }
        let is_relative = morph.attribute("method") == Some("RELATIVE");
        (!targets.is_empty()).then_some(Self { targets, is_relative })
    }

    /// The blended position of a vertex. A target without that vertex doesn't move it.
    pub(super) fn blend(&self, vertex: usize, position: DVec3) -> DVec3 {
        let mut blended = position;
        for (source, weight) in &self.targets {
            let Some(target) = source.get(vertex).map(DVec3::from_array) else { continue };
            let step = if self.is_relative { target } else { target - position };
            blended += step * *weight;
        }
        blended
    }
}

/// The positions of a geometry.
fn positions(document: &Document, geometry: &Node, notes: &mut Notes) -> Result<Source<f64>, String> {
    let mesh = mesh(document, geometry).ok_or("it has no <mesh>")?;
    let input = position_input(document, mesh)?;
    Source::read(document, input, 3, geometry.label(), notes)
}

/// The source of the positions of a mesh.
///
/// # Errors
/// In words, where it names none.
pub(super) fn position_input<'d>(document: &'d Document, mesh: &Node) -> Result<&'d str, String> {
    let vertices = document.child(mesh, "vertices").ok_or("it has no <vertices>")?;
    let mut inputs = document.children_named(vertices, "input");
    let position = inputs.find(|input| input.attribute("semantic") == Some("POSITION"));
    Ok(position.and_then(|input| input.attribute("source")).ok_or("its vertices have no positions")?)
}
