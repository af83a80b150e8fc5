//! How long the page's frames take with a million triangles: the longest frame of each action, and all of them together.
//!
//! `cargo xtask bench -p meshwright-web --bench frames` prints the figures of `BENCHMARKS.md`; words after `--` choose groups
//! of actions by a part of their names. Times are processor time of the page's thread without the graphics device, which draws in
//! software here; jobs, which run in the worker on the page, are left out.

#[cfg(not(target_arch = "wasm32"))]
mod native;

fn main() {
    #[cfg(not(target_arch = "wasm32"))]
    native::run();
}
