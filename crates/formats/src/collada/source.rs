//! Sources of numbers, and lists of them in the text of an element.

use super::xml::{Document, Node};
use crate::origin::Origin;
use crate::scan::Scan;
use glam::{DMat4, DVec3, Vec3};

/// A source of numbers, so many for each index.
pub(super) struct Source<T = f32> {
    pub values: Vec<T>,
    pub stride: usize,
}

impl<T: Copy + Default> Source<T> {
    pub(super) fn get<const N: usize>(&self, index: usize) -> Option<[T; N]> {
        let start = index.checked_mul(self.stride)?;
        self.values.get(start..start.checked_add(N.min(self.stride))?).map(|found| {
            let mut values = [T::default(); N];
            values.iter_mut().zip(found).for_each(|(value, found)| *value = *found);
            values
        })
    }
}

/// All positions of a source, transformed.
pub(super) fn positions(
    document: &Document,
    input: &Node,
    transform: DMat4,
    origin: &mut Option<Origin>,
) -> Result<Vec<Vec3>, String> {
    let Some(origin) = origin else {
        let source = source(document, input, |scan| scan.float())?;
        let count = source.values.len() / source.stride;
        let position = |i| Vec3::from_array(source.get(i).unwrap_or_default());
        return Ok((0..count).map(|i| place(position(i), transform)).collect());
    };
    let source = source(document, input, |scan| scan.double())?;
    let count = source.values.len() / source.stride;
    let position = |i| DVec3::from_array(source.get(i).unwrap_or_default());
    Ok((0..count).map(|i| origin.place(transform.transform_point3(position(i)))).collect())
}

/// A transformed position; untouched, to the bit, where there is nothing to do.
fn place(position: Vec3, transform: DMat4) -> Vec3 {
    if transform == DMat4::IDENTITY {
        position
    } else {
        transform.transform_point3(position.as_dvec3()).as_vec3()
    }
}

/// The source that an input names.
pub(super) fn source<T>(
    document: &Document,
    input: &Node,
    number: impl Fn(&mut Scan) -> Option<T>,
) -> Result<Source<T>, String> {
    let name = input.attribute("source").unwrap_or_default();
    let missing = || format!("there is no source \"{name}\"");
    let source = document.target(name).ok_or_else(missing)?;
    let array = document.child(source, "float_array").ok_or_else(missing)?;
    let stride = document
        .path(source, &["technique_common", "accessor"])
        .and_then(|accessor| accessor.attribute("stride")?.parse().ok())
        .unwrap_or(1usize)
        .max(1);
    let mut scan = Scan::new(array.text(), None);
    let mut values = Vec::with_capacity(array.text().len() / 8);
    while !scan.at_end() {
        values.push(
            number(&mut scan)
                .ok_or_else(|| format!("source \"{name}\" holds something else than numbers"))?,
        );
    }
    Ok(Source { values, stride })
}

/// All whole numbers in the text of an element; none where something else is among them.
pub(super) fn integers(node: &Node) -> Option<Vec<u32>> {
    let mut scan = Scan::new(node.text(), None);
    let mut values = Vec::with_capacity(node.text().len() / 6);
    while !scan.at_end() {
        values.push(u32::try_from(scan.integer()?).ok()?);
    }
    Some(values)
}
