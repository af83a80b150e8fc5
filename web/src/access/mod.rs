//! The page for screen readers and other assistive technology: the accessibility tree, and its mirror in the document.

pub mod aria;
pub mod mirror;
pub mod tree;
