//! Sets of elements as blocks.

use crate::job::wire::{BadBytes, Reader, Writer};
use crate::selection::Selection;
use halfedge::Element;
use halfedge::geometry::BitSet;
use serde::{Deserialize, Serialize};
use std::io;

/// How the ids of a set follow.
#[derive(Serialize, Deserialize)]
enum Form {
    /// As numbers.
    Ids,
    /// As bits.
    Words,
}

/// The largest id that is read, to bound the memory that a few bytes can ask for.
const MAX_ID: u32 = 1 << 29;

#[derive(Serialize, Deserialize)]
struct SelectionHead {
    kind: u8,
    latest: Option<u32>,
}

/// Writes a set as ids or as bits, whichever is shorter.
pub(super) fn write_set(out: &mut Writer<'_>, set: &BitSet) -> io::Result<()> {
    let words = set.largest().map_or(0, |largest| largest / 64 + 1);
    if set.len() * size_of::<u32>() < words * size_of::<u64>() {
        let ids: Vec<u32> = set.iter().map(|id| id as u32).collect();
        out.value(&Form::Ids)?;
        out.links(&ids)
    } else {
        out.value(&Form::Words)?;
        out.column(set.words().get(..words).unwrap_or_default())
    }
}

pub(super) async fn read_set(from: &mut Reader<'_>) -> Result<BitSet, BadBytes> {
    match from.value().await? {
        Form::Words => Ok(BitSet::from_words(from.column().await?)),
        Form::Ids => {
            let ids = from.links().await?;
            if ids.iter().any(|&id| id > MAX_ID) {
                return Err(BadBytes::new("the id of an element is too large"));
            }
            Ok(ids.into_iter().map(|id| id as usize).collect())
        }
    }
}

pub(super) fn write_selection(out: &mut Writer<'_>, selection: &Selection) -> io::Result<()> {
    let kind = Element::ALL.iter().position(|kind| *kind == selection.kind()).unwrap_or_default() as u8;
    out.value(&SelectionHead { kind, latest: selection.latest() })?;
    write_set(out, selection.set())
}

pub(super) async fn read_selection(from: &mut Reader<'_>) -> Result<Selection, BadBytes> {
    let SelectionHead { kind, latest } = from.value().await?;
    let kind = Element::ALL.get(usize::from(kind)).ok_or_else(|| BadBytes::new("no such kind of element"))?;
    Ok(Selection::of_set(*kind, read_set(from).await?, latest))
}
