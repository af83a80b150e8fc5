//! Bezier curves (`.bzc`) and surfaces (`.bez`) in the formats of the CS184 course: text, a count, then the
//! control points.
//!
//! A curve is the number of its control points, then `x y` for each, or `x y z`: the count tells which. A
//! surface is the number of its patches, then 16 points `x y z` for each, row by row. These files hold
//! control points and no mesh: the editor makes one.

mod read;
mod write;

use crate::format::{Certainty, Codec, FormatInfo, Holds};
use read::Kind;

/// Bezier curves.
pub(crate) static CURVES: FormatInfo = FormatInfo {
    code: "bzc",
    name: "BZC",
    save_label: "Save as BZC…",
    description: "The control points of a Bezier curve.",
    extensions: &["bzc"],
    holds: Holds::Curves,
    detect: Some((Certainty::Numbers, |bytes| read::kind(bytes) == Some(Kind::Curve))),
    is_text: |_| true,
    is_read: true,
    is_written: true,
    ..FormatInfo::DEFAULT
};

pub(crate) const CURVES_CODEC: Codec = Codec {
    read: Some(|source, reading, progress| {
        read::read(source.file, Kind::Curve, reading, progress).map(Into::into)
    }),
    write: Some(|model| Ok(write::write_curves(model))),
};

/// Bezier surfaces.
pub(crate) static SURFACES: FormatInfo = FormatInfo {
    code: "bez",
    name: "BEZ",
    save_label: "Save as BEZ…",
    description: "The control points of a Bezier surface's patches.",
    extensions: &["bez"],
    holds: Holds::Surfaces,
    detect: Some((Certainty::Numbers, |bytes| read::kind(bytes) == Some(Kind::Surface))),
    is_text: |_| true,
    is_read: true,
    is_written: true,
    ..FormatInfo::DEFAULT
};

pub(crate) const SURFACES_CODEC: Codec = Codec {
    read: Some(|source, reading, progress| {
        read::read(source.file, Kind::Surface, reading, progress).map(Into::into)
    }),
    write: Some(|model| Ok(write::write_surface(model))),
};
