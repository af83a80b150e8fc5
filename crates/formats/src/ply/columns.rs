//! Properties of vertices and faces that mean nothing here: they are kept as columns of the mesh.

use super::header::{Property, Scalar, Table};
use crate::model::attributes::has_meaning;
use crate::report::{ImportReport, first_few};
use halfedge::Element;
use halfedge::attribute::{Column, Value, Values};

/// How many names a note lists.
const NAMES_LISTED: usize = 8;

/// The largest whole number up to which all are exact in `f64`.
const MAX_EXACT_F64: f64 = 9_007_199_254_740_992.0;

/// The columns of one table.
#[derive(Default)]
pub(super) struct Columns {
    columns: Vec<PropertyColumn>,
}

/// A column while it is read.
struct PropertyColumn {
    place: usize,
    name: String,
    values: Numbers,
    /// Whether the file has whole numbers of 64 bits.
    is_long: bool,
    /// Whether values had to be rounded, and whether some are no numbers.
    is_rounded: bool,
    is_damaged: bool,
}

/// Values as they are stored in the file, as far as 32 bits hold them.
enum Numbers {
    Unsigned(Vec<u32>),
    Signed(Vec<i32>),
    Float(Vec<f32>),
}

impl Numbers {
    /// Whether they have negative whole numbers, which are kept as `f32`, and some that this can't hold.
    fn is_beyond_f32(&self) -> bool {
        const LARGEST_EXACT: u32 = 1 << 24;
        match self {
            Self::Signed(values) => {
                values.iter().any(|value| *value < 0)
                    && values.iter().any(|value| value.unsigned_abs() > LARGEST_EXACT)
            }
            _ => false,
        }
    }
}

impl Columns {
    /// Columns for the properties of a table that are not in use otherwise. Lists, and names that have a
    /// meaning as columns, are added to `left_out`.
    pub(super) fn new(table: &Table, element: Element, in_use: &[usize], left_out: &mut Vec<String>) -> Self {
        let mut columns: Vec<PropertyColumn> = Vec::new();
        for (place, property) in
            table.properties.iter().enumerate().filter(|(place, _)| !in_use.contains(place))
        {
            let Property { name, scalar, count } = property;
            let is_known = columns.iter().any(|column| column.name == *name);
            if count.is_some() || name.is_empty() || is_known || has_meaning(element, name) {
                left_out.push(if name.is_empty() { "one without a name".to_owned() } else { name.clone() });
                continue;
            }
            let values = match scalar {
                Scalar::U8 | Scalar::U16 | Scalar::U32 => Numbers::Unsigned(Vec::new()),
                Scalar::I8 | Scalar::I16 | Scalar::I32 => Numbers::Signed(Vec::new()),
                Scalar::I64 | Scalar::U64 | Scalar::F32 | Scalar::F64 => Numbers::Float(Vec::new()),
            };
            columns.push(PropertyColumn {
                place,
                name: name.clone(),
                values,
                is_long: matches!(scalar, Scalar::I64 | Scalar::U64),
                is_rounded: false,
                is_damaged: false,
            });
        }
        Self { columns }
    }

    /// Adds the values of a row.
    pub(super) fn push(&mut self, row: &[f64]) {
        for column in &mut self.columns {
            let value = row.get(column.place).copied().unwrap_or_default();
            let kept = match &mut column.values {
                Numbers::Unsigned(values) => {
                    values.push(value as u32);
                    f64::from(value as u32)
                }
                Numbers::Signed(values) => {
                    values.push(value as i32);
                    f64::from(value as i32)
                }
                Numbers::Float(values) => {
                    values.push(value as f32);
                    f64::from(value as f32)
                }
            };
            column.is_damaged |= value.is_nan() && !kept.is_nan();
            column.is_rounded |= kept != value && !value.is_nan();
            // They are rounded already.
            column.is_rounded |= column.is_long && value.abs() > MAX_EXACT_F64;
        }
    }

    /// The columns, with notes of what they don't hold.
    pub(super) fn finish(self, report: &mut ImportReport) -> impl Iterator<Item = Column> {
        let names = |is: fn(&PropertyColumn) -> bool| -> Option<String> {
            let names: Vec<&str> =
                self.columns.iter().filter(|c| is(c)).map(|column| column.name.as_str()).collect();
            (!names.is_empty()).then(|| first_few(&names, NAMES_LISTED))
        };
        if let Some(names) = names(|_| true) {
            report.info(format!("Properties without a meaning here were kept, in 32 bits: {names}"));
        }
        if let Some(names) = names(|column| column.is_rounded || column.values.is_beyond_f32()) {
            report.warn(format!("Values of properties were rounded to what 32 bits hold: {names}"));
        }
        if let Some(names) = names(|column| column.is_damaged) {
            report.warn(format!("Values of properties that are no numbers were read as 0: {names}"));
        }
        self.columns.into_iter().map(|column| {
            let (values, default) = match column.values {
                Numbers::Unsigned(values) => (Values::U32(values), Value::U32(0)),
                // Without negative numbers they can stay whole.
                Numbers::Signed(values) if values.iter().all(|&value| value >= 0) => {
                    (Values::U32(values.into_iter().map(i32::unsigned_abs).collect()), Value::U32(0))
                }
                Numbers::Signed(values) => {
                    (Values::F32(values.into_iter().map(|value| value as f32).collect()), Value::F32(0.0))
                }
                Numbers::Float(values) => (Values::F32(values), Value::F32(0.0)),
            };
            Column { name: column.name, values, default, labels: Vec::new() }
        })
    }
}
