//! The notices of web/site/start.js for when there is no editor to show a message.

use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// The editor runs: removes the notice and resolves `meshwright.ready` with this JSON.
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    pub fn started(info: &str);
    /// There is neither WebGPU nor WebGL2.
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = noGraphics)]
    pub fn no_graphics(reason: &str);
    /// The page can't go on: a title, and paragraphs separated by line breaks.
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    pub fn stopped(title: &str, text: &str, details: &str);
    /// The program has panicked and runs no more.
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    pub fn crashed(message: &str);
}
