//! The page's workers. One runs long jobs on its own copy of the mesh, so that the page never freezes; the other, told by
//! its name, keeps documents.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

#[cfg(target_arch = "wasm32")]
fn main() {
    meshwright_worker::serve();
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program runs in a browser, as the page's worker.");
    std::process::exit(2);
}
