//! The transforms of nodes and of the whole document.

use super::numbers::numbers;
use super::xml::{Document, Node};
use crate::notes::Notes;
use glam::{DMat4, DVec3, DVec4};

/// The numbers in the text of an element, of which there should be `N`.
fn values<const N: usize>(node: &Node, notes: &mut Notes) -> Result<[f64; N], String> {
    let read = numbers::<f64>(node.text(), Some(N));
    read.note_commas(notes).map_err(|why| format!("its <{}> has {why}", node.name))?;
    // More numbers than needed do no harm.
    let found = read.values.len();
    let values = read
        .values
        .first_chunk::<N>()
        .copied()
        .ok_or_else(|| format!("its <{}> has {found} numbers instead of {N}", node.name))?;
    match values.iter().all(|value| value.is_finite()) {
        true => Ok(values),
        false => Err(format!("its <{}> has a number that can't be read", node.name)),
    }
}

/// A matrix of 16 numbers, row by row.
pub(super) fn matrix(node: &Node, notes: &mut Notes) -> Result<DMat4, String> {
    Ok(DMat4::from_cols_array(&values::<16>(node, notes)?).transpose())
}

/// The product of all transforms of a node.
///
/// # Errors
/// In words, where one of them can't be read.
pub(super) fn of_node(document: &Document, node: &Node, notes: &mut Notes) -> Result<DMat4, String> {
    let mut whole = DMat4::IDENTITY;
    for child in document.children(node) {
        whole *= match child.name {
            "matrix" => matrix(child, notes)?,
            "translate" => DMat4::from_translation(values::<3>(child, notes)?.into()),
            "scale" => DMat4::from_scale(values::<3>(child, notes)?.into()),
            "rotate" => rotation(values(child, notes)?),
            "lookat" => look_at(values(child, notes)?),
            "skew" => skew(values(child, notes)?).ok_or("its <skew> has an axis without direction")?,
            _ => continue,
        };
    }
    match whole.is_finite() {
        true => Ok(whole),
        false => Err("its transforms give no finite numbers".to_owned()),
    }
}

fn rotation([x, y, z, degrees]: [f64; 4]) -> DMat4 {
    let axis = DVec3::new(x, y, z).try_normalize();
    axis.map_or(DMat4::IDENTITY, |axis| DMat4::from_axis_angle(axis, degrees.to_radians()))
}

/// At the eye, looking along -Z, as cameras do: eye, point of interest, up.
fn look_at([a, b, c, d, e, f, g, h, i]: [f64; 9]) -> DMat4 {
    let (eye, at, up) = (DVec3::new(a, b, c), DVec3::new(d, e, f), DVec3::new(g, h, i));
    let back = (eye - at).normalize_or(DVec3::Z);
    let right = up.cross(back).normalize_or(DVec3::X);
    DMat4::from_cols(right.extend(0.0), back.cross(right).extend(0.0), back.extend(0.0), eye.extend(1.0))
}

/// A shear: points move along the second axis by the tangent of the angle for each unit along the first.
/// That is RenderMan's `RiSkew`, which COLLADA refers to, where the axes are at right angles; elsewhere it is
/// what OpenCOLLADA and FCollada do. None where an axis has no direction.
fn skew([degrees, a, b, c, d, e, f]: [f64; 7]) -> Option<DMat4> {
    let measured = DVec3::new(a, b, c).try_normalize()?;
    let shear = DVec3::new(d, e, f).try_normalize()? * degrees.to_radians().tan();
    let column = |axis: DVec3| (axis + shear * measured.dot(axis)).extend(0.0);
    Some(DMat4::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z), DVec4::W))
}

/// From the document's axes and unit to metres with Y up.
pub(super) fn of_document(document: &Document, notes: &mut Notes) -> DMat4 {
    let asset = document.child(document.root(), "asset");
    let up = asset.and_then(|asset| document.child(asset, "up_axis")).map(Node::word);
    let (turn, axis) = match up.as_deref() {
        Some("Z_UP") => {
            (DMat4::from_cols_array(&[1., 0., 0., 0., 0., 0., -1., 0., 0., 1., 0., 0., 0., 0., 0., 1.]), "Z")
        }
        Some("X_UP") => {
            (DMat4::from_cols_array(&[0., 1., 0., 0., -1., 0., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.]), "X")
        }
        Some("Y_UP") | None => (DMat4::IDENTITY, "Y"),
        Some(other) => {
            notes.info(format!("Its up axis \"{other}\" is unknown: Y was taken"));
            (DMat4::IDENTITY, "Y")
        }
    };
    let unit = asset.and_then(|asset| document.child(asset, "unit")).and_then(|unit| unit.attribute("meter"));
    let meter = unit.map_or(1.0, |text| {
        let read = numbers::<f64>(text.as_bytes(), Some(1));
        // Of one number, a comma is the decimal one.
        let _ = read.note_commas(notes);
        match read.values.as_slice() {
            &[meter] if meter.is_finite() && meter > 0.0 => meter,
            _ => {
                notes.info(format!("Its unit of \"{text}\" metres can't be read: metres were taken"));
                1.0
            }
        }
    });
    let is_own = |other: &Node| asset.is_some_and(|asset| asset.index == other.index);
    let has_units =
        |other: &Node| ["unit", "up_axis"].iter().any(|name| document.child(other, name).is_some());
    let others = document.all("asset").filter(|other| !is_own(other) && has_units(other)).count();
    if others > 0 {
        notes.info(format!("Units and up axes of single elements are not applied: {others}"));
    }
    let mut changes = Vec::new();
    if axis != "Y" {
        changes.push(format!("turned so that Y is up instead of {axis}"));
    }
    if meter != 1.0 {
        changes.push(format!("scaled by {meter} to metres"));
    }
    if !changes.is_empty() {
        notes.info(format!("The model was {}", changes.join(" and ")));
    }
    DMat4::from_scale(DVec3::splat(meter)) * turn
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_skew_moves_points_along_one_axis_by_where_they_are_on_another() {
        let slanted = skew([45.0, 0.0, 2.0, 0.0, 3.0, 0.0, 0.0]).expect("two directions");
        let point = |x, y, z| slanted.transform_point3(DVec3::new(x, y, z));
        assert!(point(0.0, 2.0, 5.0).distance(DVec3::new(2.0, 2.0, 5.0)) < 1e-12);
        assert_eq!(point(3.0, 0.0, 1.0), DVec3::new(3.0, 0.0, 1.0));
        // Of the conformance suite.
        assert!(skew([45.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.0]).is_some_and(|slanted| slanted.is_finite()));
        assert_eq!(skew([45.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]), None);
    }

    #[test]
    fn look_at_is_a_camera_without_roll() {
        let placed = look_at([1.0, 2.0, 3.0, 1.0, 2.0, -4.0, 0.0, 1.0, 0.0]);
        assert_eq!(placed, DMat4::from_translation(DVec3::new(1.0, 2.0, 3.0)));
        // Along x: what lies ahead, at -Z, comes to lie there.
        let placed = look_at([0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        assert!(placed.transform_point3(DVec3::NEG_Z).distance(DVec3::X) < 1e-12);
    }
}
