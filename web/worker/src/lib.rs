//! The web worker's side of a job, and the words in which it and the page talk.
//!
//! The page sends a job's number and an [`editor::JobRequest`] as bytes; the worker answers with a
//! [`Message`] each time there is something to say. Bytes change hands without being copied.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

#[cfg(target_arch = "wasm32")]
mod message;
#[cfg(target_arch = "wasm32")]
mod serve;
mod throttle;

#[cfg(target_arch = "wasm32")]
pub use message::{Message, request, transferable};
#[cfg(target_arch = "wasm32")]
pub use serve::serve;
pub use throttle::Throttle;
