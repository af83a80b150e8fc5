//! The transforms of nodes.

use super::xml::{Document, Node};
use crate::scan::Scan;
use glam::{DMat4, DVec3};

/// Numbers in the text of an element.
fn numbers<const N: usize>(node: &Node) -> Option<[f64; N]> {
    let mut scan = Scan::new(node.text(), None);
    let mut values = [0.0; N];
    for value in &mut values {
        *value = f64::from(scan.float()?);
    }
    Some(values)
}

/// All transforms of a node, one after the other. Errors name an element that can't be read.
pub(crate) fn of_node(document: &Document, node: &Node) -> Result<DMat4, String> {
    let mut whole = DMat4::IDENTITY;
    for child in document.children(node) {
        let part = match child.name {
            "matrix" => numbers::<16>(child).map(|m| DMat4::from_cols_array(&m).transpose()),
            "translate" => numbers::<3>(child).map(|t| DMat4::from_translation(t.into())),
            "scale" => numbers::<3>(child).map(|s| DMat4::from_scale(s.into())),
            "rotate" => numbers::<4>(child).map(|[x, y, z, degrees]| {
                let axis = DVec3::new(x, y, z).try_normalize();
                axis.map_or(DMat4::IDENTITY, |axis| DMat4::from_axis_angle(axis, degrees.to_radians()))
            }),
            "lookat" => numbers::<9>(child).map(|[a, b, c, d, e, f, g, h, i]| {
                // At the eye, looking along -Z, as cameras do.
                let (eye, at, up) = (DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i));
                let back = (eye - at).normalize_or(DVec3::Z);
                let right = up.cross(back).normalize_or(DVec3::X);
                DMat4::from_cols(
                    right.extend(0.0),
                    back.cross(right).extend(0.0),
                    back.extend(0.0),
                    eye.extend(1.0),
                )
            }),
            "skew" => return Err(format!("node \"{}\" is skewed, which can't be read", node.label())),
            _ => continue,
        };
        whole *=
            part.ok_or_else(|| format!("the <{}> of node \"{}\" can't be read", child.name, node.label()))?;
    }
    Ok(whole)
}

/// From the file's axes and unit to metres with Y up, and what to tell about it.
pub(crate) fn of_document(document: &Document) -> (DMat4, Option<String>) {
    let asset = document.child(document.root(), "asset");
    let up = asset.and_then(|asset| document.child(asset, "up_axis")).map(|up| up.text().trim_ascii());
    let meter = asset
        .and_then(|asset| document.child(asset, "unit"))
        .and_then(|unit| unit.attribute("meter")?.parse::<f64>().ok())
        .filter(|meter| meter.is_finite() && *meter > 0.0)
        .unwrap_or(1.0);
    let (turn, axis) = match up {
        Some(b"Z_UP") => {
            (DMat4::from_cols_array(&[1., 0., 0., 0., 0., 0., -1., 0., 0., 1., 0., 0., 0., 0., 0., 1.]), "Z")
        }
        Some(b"X_UP") => {
            (DMat4::from_cols_array(&[0., 1., 0., 0., -1., 0., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.]), "X")
        }
        _ => (DMat4::IDENTITY, "Y"),
    };
    let mut changes = Vec::new();
    if axis != "Y" {
        changes.push(format!("turned so that Y is up instead of {axis}"));
    }
    if meter != 1.0 {
        changes.push(format!("scaled by {meter} to metres"));
    }
    let note = (!changes.is_empty()).then(|| format!("The model was {}", changes.join(" and ")));
    (DMat4::from_scale(DVec3::splat(meter)) * turn, note)
}
