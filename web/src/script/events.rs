//! Events that scripts subscribe to: `meshwright.on(name, callback)` returns a function that ends the subscription.

use std::cell::{Cell, RefCell};

use js_sys::{Function, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::spawn_local;

use super::js::{Answer, error, to_js};
use crate::app::App;
use crate::app::notices::Notice;

struct Listener {
    id: u32,
    notice: Notice,
    callback: Function,
}

thread_local! {
    static LISTENERS: RefCell<Vec<Listener>> = const { RefCell::new(Vec::new()) };
    static NEXT_ID: Cell<u32> = const { Cell::new(0) };
}

/// Subscribes to an event.
pub(super) fn on(name: &JsValue, callback: JsValue) -> Answer {
    let names = || Notice::ALL.map(Notice::name).join(", ");
    let notice = name.as_string().as_deref().and_then(Notice::named);
    let notice = notice.ok_or_else(|| error(&format!("on: expected the name of an event: {}", names())))?;
    let callback: Function =
        callback.dyn_into().map_err(|_| error("on: expected a function to call with the event"))?;
    let id = NEXT_ID.replace(NEXT_ID.get().wrapping_add(1));
    LISTENERS.with_borrow_mut(|listeners| listeners.push(Listener { id, notice, callback }));
    let end = Closure::<dyn FnMut()>::new(move || {
        LISTENERS.with_borrow_mut(|listeners| listeners.retain(|listener| listener.id != id));
    });
    Ok(end.into_js_value())
}

/// Tells subscribers what happened since the last call, once the frame is over: they may call the editor.
pub(crate) fn tell(app: &mut App) {
    let notices = app.script().take_notices();
    if notices.is_empty() || LISTENERS.with_borrow(Vec::is_empty) {
        return;
    }
    spawn_local(async move {
        for (notice, detail) in notices {
            let Ok(detail) = to_js(&detail) else { continue };
            let called: Vec<Function> = LISTENERS.with_borrow(|listeners| {
                let of_this = listeners.iter().filter(|listener| listener.notice == notice);
                of_this.map(|listener| listener.callback.clone()).collect()
            });
            for callback in called {
                if let Err(thrown) = callback.call1(&JsValue::UNDEFINED, &detail) {
                    report(&thrown);
                }
            }
        }
    });
}

/// Reports what a callback threw as browsers report what event listeners throw.
fn report(thrown: &JsValue) {
    let reports = Reflect::get(&js_sys::global(), &"reportError".into());
    if let Some(reports) = reports.ok().and_then(|reports| reports.dyn_into::<Function>().ok()) {
        // It throws nothing itself.
        let _ = reports.call1(&JsValue::UNDEFINED, thrown);
    }
}
