//! Geometry that several parts share: each piece is written once.

mod ears;

pub(crate) use ears::{Ear, ears};
