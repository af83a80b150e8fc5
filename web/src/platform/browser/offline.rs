//! The page's side of `web/site/offline.js`: newer versions of the page.

use wasm_bindgen::prelude::*;

use super::inbox::Inbox;
use crate::platform::Event;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = onUpdate)]
    fn on_update(callback: &JsValue);
    /// Reloads the page with the newer version.
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    pub fn update();
}

/// Tells the page once a newer version is there.
pub fn listen(inbox: Inbox) {
    let announce = Closure::<dyn FnMut()>::new(move || inbox.push(Event::UpdateReady));
    // It lives as long as the page.
    on_update(&announce.into_js_value());
}
