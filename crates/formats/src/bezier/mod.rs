//! Bezier curves (`.bzc`) and surfaces (`.bez`) as the CS184 course has them: text, a count, then
//! the control points.
//!
//! A curve is its number of control points, then `x y` for each; `x y z` is understood too, since
//! the count tells the two apart. A surface is its number of patches, then 16 points `x y z` for
//! each, row by row. These files hold control points and no mesh: the editor makes one.

mod read;
mod write;

use crate::format::{Certainty, FormatInfo, Holds};
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
    read: Some(|source, _, progress| read::read(source.file, Kind::Curve, progress).map(Into::into)),
    write: Some(|model| Ok(write::write_curves(model))),
    ..FormatInfo::DEFAULT
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
    read: Some(|source, _, progress| read::read(source.file, Kind::Surface, progress).map(Into::into)),
    write: Some(|model| Ok(write::write_surface(model))),
    ..FormatInfo::DEFAULT
};
