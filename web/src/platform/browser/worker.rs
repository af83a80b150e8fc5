//! Starting the page's workers.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use meshwright_worker::alive::when_ended;
use wasm_bindgen::prelude::*;
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

/// Where index.html names the worker's script: the name on a built site contains a hash of the script.
const SCRIPT_NAMED_BY: &str = "meta[name=meshwright-worker]";

/// The script that the build puts beside the page. The address is relative to the page, so that the site can
/// be in any folder.
pub(super) fn script() -> String {
    let named = web_sys::window()
        .and_then(|window| window.document())
        .and_then(|document| document.query_selector(SCRIPT_NAMED_BY).ok()?)
        .and_then(|meta| meta.get_attribute("content"));
    named.unwrap_or_else(|| "./meshwright-worker_loader.js".to_owned())
}

/// A worker and its listeners. It is terminated with this.
pub(super) struct Link {
    pub worker: Worker,
    /// Whether its end is of interest.
    is_watched: Rc<Cell<bool>>,
    _on_message: Closure<dyn FnMut(MessageEvent)>,
    _on_error: Closure<dyn FnMut(web_sys::Event)>,
}

impl Drop for Link {
    fn drop(&mut self) {
        self.is_watched.set(false);
        // Pending messages must not reach handlers that are about to be freed.
        self.worker.set_onmessage(None);
        self.worker.set_onerror(None);
        self.worker.terminate();
    }
}

impl Link {
    /// Starts a worker. Its name begins with what it does. Messages that are sent before its first one are lost.
    /// `on_end` is called with what the browser says, if anything, when the worker didn't load or has ended.
    ///
    /// # Errors
    /// The browser refuses to start one.
    pub fn new(
        name: &str,
        mut on_message: impl FnMut(JsValue) + 'static,
        on_end: impl FnMut(Option<String>) + 'static,
    ) -> Result<Self, JsValue> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        // The lock that tells of a worker's end has its name, so no two have the same one.
        let name = format!("{name} {:x}", (js_sys::Math::random() * f64::from(u32::MAX)) as u32);
        options.set_name(&name);
        let worker = Worker::new_with_options(&script(), &options)?;
        let is_watched = Rc::new(Cell::new(true));
        let on_end = Rc::new(RefCell::new(on_end));
        let (watched, ended, mut is_first) = (is_watched.clone(), on_end.clone(), true);
        let on_message = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
            if std::mem::take(&mut is_first) {
                let (watched, ended) = (watched.clone(), ended.clone());
                when_ended(&name, move || {
                    if watched.get()
                        && let Ok(mut ended) = ended.try_borrow_mut()
                    {
                        ended(None);
                    }
                });
            }
            on_message(event.data());
        });
        let watched = is_watched.clone();
        let on_error = Closure::<dyn FnMut(web_sys::Event)>::new(move |event: web_sys::Event| {
            // The error is handled here; the page's own handler treats errors as a failed start.
            event.prevent_default();
            if watched.get()
                && let Ok(mut ended) = on_end.try_borrow_mut()
            {
                ended(event.dyn_ref::<web_sys::ErrorEvent>().map(web_sys::ErrorEvent::message));
            }
        });
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        Ok(Self { worker, is_watched, _on_message: on_message, _on_error: on_error })
    }
}
