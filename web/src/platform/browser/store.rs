//! The page's side of the worker that keeps documents.

use std::cell::RefCell;
use std::rc::{Rc, Weak};

use meshwright_worker::store::{Answer, Request, WORKER_NAME, from_js, to_js};
use wasm_bindgen::prelude::*;

use super::fetch;
use super::inbox::{Inbox, describe};
use super::worker::Link;
use crate::platform::Event;

/// The parameter of the page's address that chooses where documents are kept: `?store=indexeddb`, for tests.
const STORE_PARAMETER: &str = "store";

/// Sends requests to the worker that keeps documents.
pub(super) struct Store {
    state: Rc<RefCell<State>>,
}

struct State {
    inbox: Inbox,
    worker: Option<Link>,
    is_ready: bool,
    /// What was asked for before the worker was ready.
    waiting: Vec<(JsValue, JsValue)>,
}

impl Store {
    pub fn new(inbox: Inbox) -> Self {
        let state = State { inbox, worker: None, is_ready: false, waiting: Vec::new() };
        let store = Self { state: Rc::new(RefCell::new(state)) };
        store.start();
        store
    }

    fn start(&self) {
        let chosen = fetch::parameters().and_then(|parameters| parameters.get(STORE_PARAMETER));
        let name = format!("{WORKER_NAME} {}", chosen.unwrap_or_default());
        let this = Rc::downgrade(&self.state);
        let link = Link::new(
            &name,
            {
                let this = this.clone();
                move |message| on_message(&this, &message)
            },
            move |said| {
                if let Some(state) = this.upgrade() {
                    state.borrow_mut().lose(said.unwrap_or_else(|| "the worker did not load".to_owned()));
                }
            },
        );
        let mut state = self.state.borrow_mut();
        match link {
            Ok(link) => state.worker = Some(link),
            Err(error) => state.lose(describe(&error)),
        }
    }

    /// Asks for something.
    pub fn ask(&self, request: &Request, bytes: &[u8]) {
        let mut state = self.state.borrow_mut();
        if state.worker.is_none() {
            state.lose("the worker has ended".to_owned());
            return;
        }
        let message = to_js(request, bytes);
        if state.is_ready { state.post(&message) } else { state.waiting.push(message) }
    }
}

fn on_message(state: &Weak<RefCell<State>>, message: &JsValue) {
    let (Some(state), Some((answer, bytes))) = (state.upgrade(), from_js(message)) else { return };
    let mut state = state.borrow_mut();
    match answer {
        Answer::Ready => {
            state.is_ready = true;
            for message in std::mem::take(&mut state.waiting) {
                state.post(&message);
            }
        }
        Answer::Crashed(reason) => state.lose(reason),
        answer => state.inbox.push(Event::Store(answer, bytes)),
    }
}

impl State {
    fn post(&mut self, (value, transfer): &(JsValue, JsValue)) {
        let posted = self.worker.as_ref().map(|link| link.worker.post_message_with_transfer(value, transfer));
        if let Some(Err(error)) = posted {
            self.lose(describe(&error));
        }
    }

    /// Ends the worker. Nothing is kept without it.
    fn lose(&mut self, reason: String) {
        self.worker = None;
        self.waiting.clear();
        self.inbox.push(Event::Store(Answer::Crashed(reason), Vec::new()));
    }
}

/// Asks the browser not to remove what is kept when it needs room. It may ask the user, or decide by itself.
pub(super) fn persist() {
    let Some(window) = web_sys::window() else { return };
    // Missing where the page was not fetched by https.
    let storage = js_sys::Reflect::get(&window.navigator(), &"storage".into());
    if let Ok(storage) = storage.and_then(|storage| storage.dyn_into::<web_sys::StorageManager>()) {
        let _ = storage.persist();
    }
}
