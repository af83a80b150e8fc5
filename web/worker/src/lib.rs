//! The web worker's side of a job, and the messages between it and the page.
//!
//! The page posts a job's number and an [`editor::JobRequest`] (`Request`). The worker answers with
//! `Posted` messages: progress, then a result or a refusal.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

#[cfg(target_arch = "wasm32")]
pub mod alive;
#[cfg(target_arch = "wasm32")]
mod message;
#[cfg(target_arch = "wasm32")]
mod serve;
pub mod store;
mod throttle;

#[cfg(target_arch = "wasm32")]
pub use message::{Posted, Received, Request};
#[cfg(target_arch = "wasm32")]
pub use serve::serve;
pub use throttle::Throttle;
