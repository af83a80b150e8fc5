//! The page's end of the worker that runs jobs.

use wasm_bindgen::prelude::*;
use web_sys::{MessageEvent, Worker, WorkerOptions, WorkerType};

/// Starts the worker and logs its first message.
pub fn spawn() {
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    match Worker::new_with_options("./meshwright-worker_loader.js", &options) {
        Ok(worker) => {
            let on_message = Closure::<dyn FnMut(MessageEvent)>::new(|event: MessageEvent| {
                web_sys::console::log_1(&event.data());
            });
            worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
            // The worker lives as long as the page does, and so does its listener.
            on_message.forget();
        }
        Err(error) => web_sys::console::warn_2(&"The worker could not be started.".into(), &error),
    }
}
