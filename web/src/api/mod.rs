//! `window.meshwright`: the editor for scripts on the page, for pages that embed it, and for the
//! browser tests. What its calls do is in [`crate::scripting`]; here they become JavaScript.

#[cfg(target_arch = "wasm32")]
mod js;
#[cfg(target_arch = "wasm32")]
mod script;
pub mod ui_tree;

#[cfg(target_arch = "wasm32")]
pub(crate) use script::install;
