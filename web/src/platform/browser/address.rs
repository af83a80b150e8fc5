//! The page's own address.

use wasm_bindgen::prelude::*;
use web_sys::Window;

use super::inbox::Inbox;
use crate::platform::Event;

/// Tells the page when the user changes the fragment of its address, as by pasting a link in its place.
pub fn listen(inbox: Inbox) {
    let Some(window) = web_sys::window() else { return };
    let on_change = Closure::<dyn FnMut()>::new(move || inbox.push(Event::Fragment(fragment())));
    // The page works without; a link then opens in another tab only.
    let _ = window.add_event_listener_with_callback("hashchange", on_change.as_ref().unchecked_ref());
    // The listener lives as long as the page.
    on_change.forget();
}

/// Where the page is, without parameters and fragment.
pub fn address() -> String {
    let place = |window: Window| Some(window.location().origin().ok()? + &window.location().pathname().ok()?);
    web_sys::window().and_then(place).unwrap_or_default()
}

/// The fragment, from `#` on.
pub fn fragment() -> String {
    web_sys::window().and_then(|window| window.location().hash().ok()).unwrap_or_default()
}

/// Opens a page of the site in a new tab.
pub fn open_in_new_tab(page: &str) {
    let Some(window) = web_sys::window() else { return };
    // A browser that forbids it says so itself.
    let _ = window.open_with_url_and_target_and_features(page, "_blank", "noopener");
}

/// Removes the fragment. The parameters stay, and the browser's history gets no entry.
pub fn clear_fragment() {
    let Some(window) = web_sys::window() else { return };
    let address = address() + &window.location().search().unwrap_or_default();
    if let Ok(history) = window.history() {
        // A page that may not do this shows an address that is out of date.
        let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
    }
}
