//! Events from outside frames, kept until the page polls them.

use std::cell::RefCell;
use std::rc::Rc;

use wasm_bindgen::JsValue;

use crate::platform::Event;

/// Events that have not been polled yet. Adding one wakes the page.
#[derive(Clone)]
pub(crate) struct Inbox {
    events: Rc<RefCell<Vec<Event>>>,
    ctx: Rc<RefCell<egui::Context>>,
}

impl Inbox {
    pub(super) fn new(ctx: &egui::Context) -> Self {
        Self { events: Rc::default(), ctx: Rc::new(RefCell::new(ctx.clone())) }
    }

    pub(crate) fn push(&self, event: Event) {
        self.events.borrow_mut().push(event);
        self.wake();
    }

    /// Wakes the page for another frame.
    pub(super) fn wake(&self) {
        self.ctx.borrow().request_repaint();
    }

    /// Wakes this egui from here on.
    pub(super) fn set_ctx(&self, ctx: &egui::Context) {
        self.ctx.replace(ctx.clone());
    }

    pub(super) fn take(&self) -> Vec<Event> {
        std::mem::take(&mut *self.events.borrow_mut())
    }
}

/// An exception's message, or the thrown value if it is not an exception.
pub(crate) fn describe(error: &JsValue) -> String {
    use wasm_bindgen::JsCast;
    if let Some(error) = error.dyn_ref::<js_sys::Error>() {
        return error.message().into();
    }
    error.as_string().unwrap_or_else(|| format!("{error:?}"))
}
