//! What threads tell the editor.

use std::sync::{Arc, Mutex, PoisonError};

use meshwright_web::platform::Event;

/// Events for the next frame. Clones share them.
#[derive(Clone)]
pub struct Inbox {
    events: Arc<Mutex<Vec<Event>>>,
    ctx: egui::Context,
}

impl Inbox {
    pub fn new(ctx: &egui::Context) -> Self {
        Self { events: Arc::default(), ctx: ctx.clone() }
    }

    /// Queues an event and asks for a frame.
    pub fn push(&self, event: Event) {
        self.events.lock().unwrap_or_else(PoisonError::into_inner).push(event);
        self.ctx.request_repaint();
    }

    /// The events since the last call.
    pub fn take(&self) -> Vec<Event> {
        std::mem::take(&mut self.events.lock().unwrap_or_else(PoisonError::into_inner))
    }
}
