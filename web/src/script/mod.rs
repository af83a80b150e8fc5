//! `window.meshwright`: the editor for scripts on the page, for pages that embed it, and for the browser
//! tests. `app/script.rs` implements the calls; this module exposes them to JavaScript.

#[cfg(target_arch = "wasm32")]
mod events;
#[cfg(target_arch = "wasm32")]
mod js;
#[cfg(target_arch = "wasm32")]
mod parent;
pub mod ui_tree;
#[cfg(target_arch = "wasm32")]
mod window;

#[cfg(target_arch = "wasm32")]
pub(crate) use events::tell;
#[cfg(target_arch = "wasm32")]
pub(crate) use parent::serve as serve_parent;
#[cfg(target_arch = "wasm32")]
pub(crate) use window::install;
