//! Keys that the browser would act on too, and keys of the number pad, which eframe doesn't tell apart from others.

use std::cell::RefCell;
use std::collections::VecDeque;

use egui::{Event, Key, Modifiers, RawInput};
use wasm_bindgen::prelude::*;
use web_sys::KeyboardEvent;

use super::handle::Handle;
use crate::input::shortcut::{NUMBER_PAD, Shortcut};

/// The keys that were pressed since the last frame, and whether they are on the number pad.
#[derive(Default)]
pub struct Pressed {
    keys: RefCell<VecDeque<(Key, bool)>>,
}

impl Pressed {
    /// Marks the events of the number pad among a frame's.
    pub fn mark(&self, raw: &mut RawInput) {
        let mut keys = std::mem::take(&mut *self.keys.borrow_mut());
        for event in &mut raw.events {
            if let Event::Key { key, physical_key, pressed: true, .. } = event {
                // The page may have got keys that eframe didn't take.
                while let Some((seen, on_pad)) = keys.pop_front() {
                    if seen == *key {
                        if on_pad {
                            *physical_key = Some(NUMBER_PAD);
                        }
                        break;
                    }
                }
            }
        }
    }
}

/// Notes the page's keys, and keeps the browser from acting on those that the editor acts on.
pub fn listen(handle: Handle) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let on_key = Closure::<dyn FnMut(KeyboardEvent)>::new(move |event: KeyboardEvent| {
        let Some(key) = Key::from_name(&event.key()).or_else(|| Key::from_name(&event.code())) else {
            return;
        };
        let on_pad = event.location() == KeyboardEvent::DOM_KEY_LOCATION_NUMPAD;
        handle.pressed().keys.borrow_mut().push_back((key, on_pad));
        let ctrl = event.ctrl_key() || event.meta_key();
        let (alt, shift) = (event.alt_key(), event.shift_key());
        let modifiers = Modifiers { alt, ctrl, shift, mac_cmd: event.meta_key(), command: ctrl };
        let shortcut = Shortcut::pressed(key, on_pad, modifiers);
        if handle.app().is_some_and(|app| app.takes_key(shortcut)) {
            event.prevent_default();
        }
    });
    // Before eframe's own listener, which is on the canvas.
    window.add_event_listener_with_callback_and_bool("keydown", on_key.as_ref().unchecked_ref(), true)?;
    // The listener lives as long as the page.
    on_key.forget();
    Ok(())
}
