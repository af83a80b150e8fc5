//! Rows of numbers in the buffers.

use super::document::{Accessor, Document};
use std::borrow::Cow;

/// The rows of an accessor, as many numbers each as its kind has.
pub(crate) struct Rows<'a> {
    bytes: &'a [u8],
    stride: usize,
    component: u32,
    normalized: bool,
    /// How many numbers a row has.
    pub width: usize,
    pub count: usize,
}

/// The bytes of one number of a type; none for types there are not.
fn size(component: u32) -> Option<usize> {
    match component {
        5120 | 5121 => Some(1),
        5122 | 5123 => Some(2),
        5125 | 5126 => Some(4),
        _ => None,
    }
}

impl<'a> Rows<'a> {
    /// Finds the rows of an accessor; all of them are there.
    pub(crate) fn find(
        document: &Document,
        buffers: &'a [Cow<'a, [u8]>],
        index: usize,
    ) -> Result<Self, String> {
        let fail = |what: &str| format!("accessor {index}: {what}");
        let accessor: &Accessor = document.accessors.get(index).ok_or_else(|| fail("it doesn't exist"))?;
        if accessor.sparse.is_some() {
            return Err(fail("it is sparse, which can't be read; export it in full"));
        }
        let width = match accessor.kind.as_str() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => return Err(fail("its kind is none of SCALAR, VEC2, VEC3, VEC4")),
        };
        let row = size(accessor.component_type).ok_or_else(|| fail("its component type is unknown"))? * width;
        let view = accessor.buffer_view.ok_or_else(|| fail("it has no data"))?;
        let view = document.buffer_views.get(view).ok_or_else(|| fail("its buffer view doesn't exist"))?;
        let stride = view.byte_stride.filter(|&stride| stride > 0).unwrap_or(row);
        if stride < row {
            return Err(fail("its rows overlap"));
        }
        let bytes = buffers
            .get(view.buffer)
            .and_then(|buffer| buffer.get(view.byte_offset..view.byte_offset.checked_add(view.byte_length)?))
            .and_then(|view| view.get(accessor.byte_offset..))
            .ok_or_else(|| fail("its data lies outside its buffer"))?;
        let last = accessor.count.saturating_sub(1).checked_mul(stride).and_then(|at| at.checked_add(row));
        if accessor.count > 0 && last.is_none_or(|end| end > bytes.len()) {
            return Err(fail("its data lies outside its buffer"));
        }
        let (component, normalized, count) = (accessor.component_type, accessor.normalized, accessor.count);
        Ok(Self { bytes, stride, component, normalized, width, count })
    }

    /// One number; 0 where there is none.
    fn number(&self, row: usize, place: usize) -> f64 {
        fn take<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
            bytes.get(at..).and_then(|bytes| bytes.first_chunk::<N>()).copied().unwrap_or([0; N])
        }
        if row >= self.count || place >= self.width {
            return 0.0;
        }
        let at = row * self.stride + place * size(self.component).unwrap_or(1);
        let (value, full) = match self.component {
            5120 => (f64::from(i8::from_le_bytes(take(self.bytes, at))), 127.0),
            5121 => (f64::from(u8::from_le_bytes(take(self.bytes, at))), 255.0),
            5122 => (f64::from(i16::from_le_bytes(take(self.bytes, at))), 32_767.0),
            5123 => (f64::from(u16::from_le_bytes(take(self.bytes, at))), 65_535.0),
            5125 => (f64::from(u32::from_le_bytes(take(self.bytes, at))), 4_294_967_295.0),
            _ => (f64::from(f32::from_le_bytes(take(self.bytes, at))), 1.0),
        };
        if self.normalized { (value / full).max(-1.0) } else { value }
    }

    /// A row's first numbers, zeros where it has fewer.
    pub(crate) fn floats<const N: usize>(&self, row: usize) -> [f32; N] {
        let mut values = [0.0; N];
        for (place, value) in values.iter_mut().enumerate() {
            *value = self.number(row, place) as f32;
        }
        values
    }

    /// A row as a number of a vertex.
    pub(crate) fn index(&self, row: usize) -> u32 {
        self.number(row, 0) as u32
    }
}
