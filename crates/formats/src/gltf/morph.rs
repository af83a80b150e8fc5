//! Morph targets, which are added to the attributes of a primitive by weights.

use super::json::Object;
use super::primitive::Primitive;
use super::rows::Rows;
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use halfedge::words::counted;

/// The part of a target that changes one attribute.
struct Step<'b> {
    weight: f64,
    rows: Rows<'b>,
}

/// The parts of all targets that change one attribute.
#[derive(Default)]
pub(super) struct Steps<'b>(Vec<Step<'b>>);

impl<'b> Steps<'b> {
    /// Reads the parts for one attribute. Notes those that can't be read.
    pub(super) fn read(
        primitive: &Primitive<'b, '_>,
        weights: &[f64],
        attribute: &str,
        label: &str,
        notes: &mut Notes,
    ) -> Self {
        let mut steps = Vec::new();
        for (i, (target, &weight)) in primitive.object.objects("targets").zip(weights).enumerate() {
            if weight == 0.0 {
                continue;
            }
            let rows = target.index(attribute).and_then(|index| index.map(|i| primitive.rows(i)).transpose());
            match rows {
                Ok(Some(rows)) => steps.push(Step { weight, rows }),
                Ok(None) => {}
                Err(why) => {
                    notes.fault(Fault::Attribute, format!("{label}: morph target {i} doesn't count ({why})"));
                }
            }
        }
        Self(steps)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The values of a row with all weighted parts added.
    pub(super) fn added<const N: usize>(&self, row: usize, mut values: [f64; N]) -> [f64; N] {
        for step in self.0.iter().filter(|step| row < step.rows.count) {
            for (value, added) in values.iter_mut().zip(step.rows.row::<N>(row)) {
                *value += added * step.weight;
            }
        }
        values
    }
}

/// The weights of a mesh's targets: those of the node, else those of the mesh, else 0. Notes that the targets
/// are not kept.
pub(super) fn weights(mesh: Object, node: Option<Object>, label: &str, notes: &mut Notes) -> Vec<f64> {
    let targets = mesh.objects("primitives").map(|primitive| primitive.list("targets").len()).max();
    let count = targets.unwrap_or(0);
    if count == 0 {
        return Vec::new();
    }
    let stated = node.filter(|node| node.get("weights").is_some()).unwrap_or(mesh).list("weights");
    let weight = |i: usize| stated.get(i)?.as_f64().filter(|weight| weight.is_finite());
    let names = mesh.object("extras").map_or(&[][..], |extras| extras.list("targetNames"));
    let names: Vec<&str> = names.iter().filter_map(|name| name.as_str()).collect();
    let names = if names.is_empty() { String::new() } else { format!(": {}", first_few(&names, 6)) };
    let targets = counted(count, "morph target is", "morph targets are");
    let label = label.strip_prefix("mesh ").unwrap_or(label);
    notes.info(format!("Mesh {label} is blended by its morph weights; its {targets} not kept{names}"));
    (0..count).map(|i| weight(i).unwrap_or(0.0)).collect()
}
