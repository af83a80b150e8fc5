//! Tests that run in a browser: what only a browser can answer.
#![cfg(target_arch = "wasm32")]

use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// Ids and counts are `u32` and sizes in bytes fit a page: the memory model that the mesh counts on.
#[wasm_bindgen_test]
fn the_page_has_32_bit_memory() {
    assert_eq!(size_of::<usize>(), 4);
}
