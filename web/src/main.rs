//! The Meshwright page: starts the editor on the page's canvas.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

#[cfg(target_arch = "wasm32")]
fn main() {
    meshwright_web::page::start();
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program runs in a browser: `cargo xtask serve` builds and serves the page.");
    std::process::exit(2);
}
