//! The rows of a PLY's tables.

use super::header::{Header, Property, Table};
use super::source::Source;
use crate::error::ReadError;
use crate::text::scan::Ticker;
use halfedge::Progress;

/// How many lists of a row are read; others are passed over.
const LISTS_PER_ROW: usize = 2;

/// Reads rows one after the other.
pub(super) struct Rows<'a> {
    source: Source<'a>,
    size: usize,
    ticker: Ticker,
}

impl<'a> Rows<'a> {
    /// The rows behind a header. `precise` reads text in double precision.
    pub(super) fn new(bytes: &'a [u8], header: &Header, precise: bool) -> Self {
        Self {
            source: Source::new(bytes, header.end, header.encoding, precise),
            size: bytes.len(),
            ticker: Ticker::new(bytes.len()),
        }
    }

    /// The number of rows to make room for: no more than the file can hold.
    pub(super) fn expected(&self, table: &Table) -> usize {
        let most = self.size.saturating_sub(self.source.at()) / table.properties.len().max(1);
        usize::try_from(table.rows).unwrap_or(most).min(most)
    }

    /// Calls `take` with the number of each row of a table, its values, and the values of its lists at
    /// `wanted`. Returns how many rows there were.
    pub(super) fn for_each(
        &mut self,
        table: &Table,
        wanted: [Option<usize>; LISTS_PER_ROW],
        progress: &mut Progress,
        mut take: impl FnMut(u64, &[f64], &[Vec<f64>; LISTS_PER_ROW]),
    ) -> Result<u64, ReadError> {
        // Rows of nothing could be any number.
        if table.properties.is_empty() {
            return Ok(table.rows);
        }
        let (mut row, mut lists) = (Vec::new(), [Vec::new(), Vec::new()]);
        for number in 0..table.rows {
            if !self.row(&table.properties, &mut row, &mut lists, wanted) {
                return Ok(number);
            }
            take(number, &row, &lists);
            self.ticker.tick(self.source.at(), progress)?;
        }
        Ok(table.rows)
    }

    /// Reads the numbers of one row into `row`, of a list its length, and the values of the lists at `wanted`
    /// into `lists`. False where the file ends before the row does.
    fn row(
        &mut self,
        properties: &[Property],
        row: &mut Vec<f64>,
        lists: &mut [Vec<f64>; LISTS_PER_ROW],
        wanted: [Option<usize>; LISTS_PER_ROW],
    ) -> bool {
        row.clear();
        lists.iter_mut().for_each(Vec::clear);
        for (place, property) in properties.iter().enumerate() {
            let Some(value) = self.source.next(property.count.unwrap_or(property.scalar)) else {
                return false;
            };
            row.push(value);
            if property.count.is_some() {
                // A negative or unreadable length is none.
                for _ in 0..value as u64 {
                    let Some(item) = self.source.next(property.scalar) else { return false };
                    for (list, wanted) in lists.iter_mut().zip(wanted) {
                        if wanted == Some(place) {
                            list.push(item);
                        }
                    }
                }
            }
        }
        true
    }
}
