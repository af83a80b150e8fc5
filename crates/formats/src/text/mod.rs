//! Text of files: its encoding, its words and numbers, and numbers as text.

pub(crate) mod commas;
pub(crate) mod encoding;
pub(crate) mod json_fault;
pub(crate) mod number;
pub(crate) mod print;
pub(crate) mod scan;
