//! What the user points with. eframe reports a pen as a mouse, and some browsers report its touches as those of a finger.

use std::cell::Cell;
use std::rc::Rc;

use wasm_bindgen::prelude::*;
use web_sys::PointerEvent;

/// Whether the pointer that was last seen is a pen; the browser keeps it up to date.
pub(super) fn listen_for_pen() -> Rc<Cell<bool>> {
    let is_pen = Rc::new(Cell::new(false));
    let Some(window) = web_sys::window() else { return is_pen };
    let seen = is_pen.clone();
    let on_pointer = Closure::<dyn FnMut(PointerEvent)>::new(move |event: PointerEvent| {
        seen.set(event.pointer_type() == "pen");
    });
    for event in ["pointerdown", "pointermove"] {
        // Before eframe's own listeners, which may run a frame. Without it, a pen is taken for a mouse.
        let _ = window.add_event_listener_with_callback_and_bool(
            event,
            on_pointer.as_ref().unchecked_ref(),
            true,
        );
    }
    // The listener lives as long as the page.
    on_pointer.forget();
    is_pen
}
