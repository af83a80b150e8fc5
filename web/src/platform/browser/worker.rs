//! Starting the page's workers.

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
    _on_message: Closure<dyn FnMut(MessageEvent)>,
    _on_error: Closure<dyn FnMut(web_sys::Event)>,
}

impl Drop for Link {
    fn drop(&mut self) {
        // Pending messages must not reach handlers that are about to be freed.
        self.worker.set_onmessage(None);
        self.worker.set_onerror(None);
        self.worker.terminate();
    }
}

impl Link {
    /// Starts a worker. Its name tells it what to do. Messages that are sent before its first one are lost.
    ///
    /// # Errors
    /// The browser refuses to start one.
    pub fn new(
        name: &str,
        mut on_message: impl FnMut(JsValue) + 'static,
        mut on_error: impl FnMut(Option<String>) + 'static,
    ) -> Result<Self, JsValue> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        options.set_name(name);
        let worker = Worker::new_with_options(&script(), &options)?;
        let on_message =
            Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| on_message(event.data()));
        let on_error = Closure::<dyn FnMut(web_sys::Event)>::new(move |event: web_sys::Event| {
            // The error is handled here; the page's own handler treats errors as a failed start.
            event.prevent_default();
            on_error(event.dyn_ref::<web_sys::ErrorEvent>().map(web_sys::ErrorEvent::message));
        });
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        Ok(Self { worker, _on_message: on_message, _on_error: on_error })
    }
}
