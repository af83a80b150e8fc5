//! The Meshwright page, as far as it needs no browser: the editor's panels and viewport over the
//! `editor` and `viewport` crates. `main.rs` puts it on a canvas.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]

pub mod actions;
pub mod api;
pub mod app;
mod availability;
mod bezier;
mod commands;
mod frame_times;
#[cfg(not(target_arch = "wasm32"))]
pub mod headless;
mod icons;
mod jobs;
pub mod keys;
pub mod lists;
mod live;
mod measures;
#[cfg(target_arch = "wasm32")]
pub mod page;
mod panels;
pub mod platform;
pub mod scripting;
mod survey;
pub mod theme;
mod toasts;
mod viewport_widget;
