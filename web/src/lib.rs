//! The part of the Meshwright page that needs no browser: the panels and the viewport on top of the
//! `editor` and `viewport` crates. `main.rs` runs it on a canvas.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

pub mod access;
pub mod app;
mod bezier;
mod embedding;
pub mod fonts;
pub mod input;
mod keeping;
pub mod lists;
mod live;
#[cfg(target_arch = "wasm32")]
pub mod page;
mod page_view;
mod panels;
pub mod platform;
mod request;
pub mod script;
mod session;
mod shown;
pub mod theme;
mod transforming;
mod units;
mod view;
mod widgets;
