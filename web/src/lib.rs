//! The Meshwright page, as far as it needs no browser: the editor's panels and viewport over the
//! `editor` and `viewport` crates. `main.rs` puts it on a canvas.

pub mod platform;
