//! Notes of what building a mesh changed.

use std::fmt;

/// A kind of change to the input, with the elements that were changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The kind of change.
    pub kind: NoteKind,
    /// The number of changed elements.
    pub count: usize,
    /// The first few elements, numbered from 0 in the input's order: faces, vertices, or for edges pairs of their
    /// end vertices.
    pub first: Vec<u32>,
}

/// The kinds of change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NoteKind {
    /// Faces that refer to vertices that don't exist were dropped.
    MissingVertex,
    /// Faces with fewer than three different corners, or that pass a vertex twice, were dropped.
    DegenerateFace,
    /// Corners equal to the one before were merged with it.
    RepeatedCorner,
    /// Faces equal to an earlier one were dropped.
    DuplicateFace,
    /// Edges with more than two faces were separated.
    NonManifoldEdge,
    /// Faces were flipped.
    FaceTurned,
    /// Edges were separated because their faces can't be oriented consistently.
    NotOrientable,
    /// Vertices where faces meet without sharing edges were separated.
    VertexSeparated,
    /// Positions that weren't finite were replaced by the origin.
    PositionNotFinite,
}

impl Note {
    const MAX_LISTED: usize = 6;

    pub(crate) fn new(kind: NoteKind, elements: Vec<u32>) -> Self {
        let per_item = if kind.is_about_edges() { 2 } else { 1 };
        let count = elements.len() / per_item;
        let mut first = elements;
        first.truncate(Self::MAX_LISTED * per_item);
        Self { kind, count, first }
    }
}

impl NoteKind {
    fn is_about_edges(self) -> bool {
        matches!(self, Self::NonManifoldEdge | Self::NotOrientable)
    }
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (thing, things, done) = match self.kind {
            NoteKind::MissingVertex => {
                ("face", "faces", "left out: a corner refers to a vertex that doesn't exist")
            }
            NoteKind::DegenerateFace => {
                ("face", "faces", "left out: fewer than three different corners, or the same corner twice")
            }
            NoteKind::RepeatedCorner => ("face", "faces", "simplified: the same corner came twice in a row"),
            NoteKind::DuplicateFace => ("face", "faces", "left out: the same corners as an earlier face"),
            NoteKind::NonManifoldEdge => ("edge", "edges", "separated: more than two faces met there"),
            NoteKind::FaceTurned => ("face", "faces", "flipped so that neighbouring faces face the same way"),
            NoteKind::NotOrientable => {
                ("edge", "edges", "separated: its two faces can't be made to face the same way")
            }
            NoteKind::VertexSeparated => {
                ("vertex", "vertices", "separated: groups of faces touched there without sharing an edge")
            }
            NoteKind::PositionNotFinite => {
                ("vertex", "vertices", "moved to the origin: the position is not a finite number")
            }
        };
        write!(f, "{} {} {done} (", self.count, if self.count == 1 { thing } else { things })?;
        if self.kind.is_about_edges() {
            f.write_str("between vertices ")?;
            for (i, ends) in self.first.chunks_exact(2).enumerate() {
                write!(f, "{}{} and {}", if i > 0 { ", " } else { "" }, ends[0], ends[1])?;
            }
        } else {
            write!(f, "{} ", if self.first.len() == 1 { thing } else { things })?;
            for (i, id) in self.first.iter().enumerate() {
                write!(f, "{}{id}", if i > 0 { ", " } else { "" })?;
            }
        }
        let shown = self.first.len() / if self.kind.is_about_edges() { 2 } else { 1 };
        f.write_str(if shown < self.count { ", …)" } else { ")" })
    }
}
