//! The program of the worker for jobs: waits for them and runs them one after the other.

use std::ops::ControlFlow;

use editor::{BadBytes, JobRequest};
use js_sys::Date;
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

use crate::alive::hold_while_alive;
use crate::message::{Posted, Request};
use crate::store;
use crate::throttle::Throttle;

/// Answers the page's requests for as long as the worker lives. Does nothing outside a worker.
pub fn serve() {
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else {
        return;
    };
    if scope.name().starts_with(store::WORKER_NAME) {
        return store::serve();
    }
    if scope.name().starts_with(store::RESCUE_NAME) {
        return store::serve_rescue();
    }
    std::panic::set_hook(Box::new(|info| {
        if let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() {
            post(&scope, &Posted::Crashed { reason: info.to_string() });
        }
    }));
    let on_message = Closure::<dyn FnMut(MessageEvent)>::new({
        let scope = scope.clone();
        move |event: MessageEvent| {
            if let Some((job, request)) = Request::read(&event.data()) {
                let answer = run(job, request, |message| post(&scope, message));
                post(&scope, &answer);
            }
        }
    });
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    // The listener lives as long as the worker, until the page terminates it.
    on_message.forget();
    hold_while_alive(&scope.name(), move || post(&scope, &Posted::Ready));
}

/// Runs a job, reports its progress and returns the answer.
fn run(job: u64, request: Result<JobRequest, BadBytes>, mut tell: impl FnMut(&Posted)) -> Posted {
    let request = match request {
        Ok(request) => request,
        Err(reason) => return Posted::Misunderstood { job, reason: reason.to_string() },
    };
    let mut throttle = Throttle::new(Date::now());
    // The page cancels a job by terminating the worker.
    let result = request.run(&mut |fraction| {
        if throttle.allows(Date::now()) {
            tell(&Posted::Progress { job, fraction });
        }
        ControlFlow::Continue(())
    });
    match result {
        Ok(mut result) => {
            // Validates here, because validating in the page would block it.
            result.validate();
            Posted::Done { job, result, memory: memory() }
        }
        Err(refusal) => Posted::Refused { job, refusal },
    }
}

fn post(scope: &DedicatedWorkerGlobalScope, message: &Posted) {
    let (value, transfer) = message.to_js();
    // Fails only if the page is gone, and then there is no receiver.
    let _ = scope.post_message_with_transfer(&value, &transfer);
}

/// The size of the program's memory in bytes; it never shrinks.
fn memory() -> f64 {
    let memory: js_sys::WebAssembly::Memory = wasm_bindgen::memory().unchecked_into();
    let buffer: js_sys::ArrayBuffer = memory.buffer().unchecked_into();
    f64::from(buffer.byte_length())
}
