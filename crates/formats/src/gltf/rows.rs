//! Rows of numbers: the values of an accessor or of decoded data.

use std::borrow::Cow;

/// The types of numbers. Some files use 32-bit signed integers and 64-bit floats, which the format doesn't allow.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Component {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Component {
    pub(super) fn of(code: usize) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5124 => Self::I32,
            5125 => Self::U32,
            5126 => Self::F32,
            5130 => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The number at the start of the bytes; 0 if there are too few. `is_normalized` divides integers by the
    /// largest of their type.
    fn read(self, bytes: &[u8], is_normalized: bool) -> f64 {
        fn first<const N: usize>(bytes: &[u8]) -> [u8; N] {
            bytes.first_chunk::<N>().copied().unwrap_or([0; N])
        }
        let (value, full) = match self {
            Self::I8 => (f64::from(i8::from_le_bytes(first(bytes))), f64::from(i8::MAX)),
            Self::U8 => (f64::from(u8::from_le_bytes(first(bytes))), f64::from(u8::MAX)),
            Self::I16 => (f64::from(i16::from_le_bytes(first(bytes))), f64::from(i16::MAX)),
            Self::U16 => (f64::from(u16::from_le_bytes(first(bytes))), f64::from(u16::MAX)),
            Self::I32 => (f64::from(i32::from_le_bytes(first(bytes))), f64::from(i32::MAX)),
            Self::U32 => (f64::from(u32::from_le_bytes(first(bytes))), f64::from(u32::MAX)),
            Self::F32 => return f64::from(f32::from_le_bytes(first(bytes))),
            Self::F64 => return f64::from_le_bytes(first(bytes)),
        };
        if is_normalized { (value / full).max(-1.0) } else { value }
    }
}

/// Rows of numbers in memory, at equal distances.
pub(super) struct Table<'b> {
    pub bytes: Cow<'b, [u8]>,
    pub stride: usize,
    pub component: Component,
}

impl Table<'_> {
    /// The number at this place of a row; 0 if there is none.
    pub(super) fn number(&self, row: usize, place: usize, is_normalized: bool) -> f64 {
        let at = row.saturating_mul(self.stride).saturating_add(place * self.component.size());
        self.component.read(self.bytes.get(at..).unwrap_or_default(), is_normalized)
    }

    /// How many rows of this size, in bytes, there are.
    pub(super) fn rows(&self, row_size: usize) -> usize {
        match self.bytes.len().checked_sub(row_size) {
            Some(rest) if self.stride > 0 => rest / self.stride + 1,
            _ => 0,
        }
    }
}

/// Rows that replace others.
pub(super) struct Sparse<'b> {
    /// The replaced rows in ascending order, each with the row of `values` that replaces it.
    pub replaced: Vec<(u32, u32)>,
    pub values: Table<'b>,
}

/// The rows of an accessor.
pub(super) struct Rows<'b> {
    /// `None` for an accessor whose values are 0, apart from sparse ones.
    pub table: Option<Table<'b>>,
    pub sparse: Option<Sparse<'b>>,
    /// Whether integers are mapped to fractions.
    pub is_normalized: bool,
    /// How many numbers a row has.
    pub width: usize,
    pub count: usize,
    /// How many rows of the accessor lie beyond the end of its buffer.
    pub missing: usize,
}

impl Rows<'_> {
    /// Rows of one integer each.
    pub(super) fn of_indices(indices: impl Iterator<Item = u32>) -> Self {
        Self::of_bytes(indices.flat_map(u32::to_le_bytes).collect(), Component::U32, 1)
    }

    /// Rows of `width` floats each.
    pub(super) fn of_floats(values: Vec<f32>, width: usize) -> Self {
        Self::of_bytes(values.into_iter().flat_map(f32::to_le_bytes).collect(), Component::F32, width)
    }

    fn of_bytes(bytes: Vec<u8>, component: Component, width: usize) -> Self {
        let stride = component.size() * width;
        let count = bytes.len().checked_div(stride).unwrap_or(0);
        let table = Some(Table { bytes: Cow::Owned(bytes), stride, component });
        Self { table, sparse: None, is_normalized: false, width, count, missing: 0 }
    }

    /// The first `N` numbers of a row, padded with zeros.
    pub(super) fn row<const N: usize>(&self, row: usize) -> [f64; N] {
        let replaced = self.sparse.as_ref().and_then(|sparse| sparse.find(row));
        let (table, row) = match replaced {
            Some((values, row)) => (Some(values), row),
            None => (self.table.as_ref(), row),
        };
        let mut values = [0.0; N];
        if let Some(table) = table {
            for (place, value) in values.iter_mut().enumerate().take(self.width) {
                *value = table.number(row, place, self.is_normalized);
            }
        }
        values
    }

    /// [`row`](Self::row) in single precision.
    pub(super) fn floats<const N: usize>(&self, row: usize) -> [f32; N] {
        self.row::<N>(row).map(|value| value as f32)
    }

    /// The first number of a row as an index.
    pub(super) fn index(&self, row: usize) -> u32 {
        let [number] = self.row(row);
        number as u32
    }
}

impl<'b> Sparse<'b> {
    /// The table and its row that replace a row.
    fn find(&self, row: usize) -> Option<(&Table<'b>, usize)> {
        let place = self.replaced.binary_search_by_key(&row, |&(replaced, _)| replaced as usize).ok()?;
        Some((&self.values, self.replaced.get(place)?.1 as usize))
    }
}
