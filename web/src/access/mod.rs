//! The page for people who don't use eyes or a mouse: the accessibility tree, and its mirror in the document.

pub mod aria;
pub mod mirror;
pub mod tree;
