//! The page's side of the worker that keeps documents.

use std::cell::RefCell;
use std::rc::{Rc, Weak};

use meshwright_worker::store::{Answer, Request, WORKER_NAME, from_js, to_js};
use wasm_bindgen::prelude::*;

use super::fetch;
use super::inbox::{Inbox, describe};
use super::wait::sleep;
use super::worker::Link;
use crate::platform::Event;

/// The parameter of the page's address that chooses where documents are kept: `?store=indexeddb`, for tests.
const STORE_PARAMETER: &str = "store";

/// How long another worker waits after one has ended, until the browser has released its files and locks.
const RESTART_PAUSE_MS: i32 = 300;

/// Sends requests to the worker that keeps documents. If it ends, the next request starts another.
pub(super) struct Store {
    state: Rc<RefCell<State>>,
}

struct State {
    inbox: Inbox,
    worker: Option<Link>,
    is_ready: bool,
    /// Whether a worker has just ended, so that another one has to wait.
    is_pausing: bool,
    /// What was asked for before the worker was ready.
    waiting: Vec<(JsValue, JsValue)>,
    /// For the message handlers of later workers.
    this: Weak<RefCell<State>>,
}

impl Store {
    pub fn new(inbox: Inbox) -> Self {
        let state = Rc::new_cyclic(|this| {
            RefCell::new(State {
                inbox,
                worker: None,
                is_ready: false,
                is_pausing: false,
                waiting: Vec::new(),
                this: this.clone(),
            })
        });
        state.borrow_mut().start();
        Self { state }
    }

    /// Asks for something.
    pub fn ask(&self, request: &Request, bytes: &[u8]) {
        let mut state = self.state.borrow_mut();
        let message = to_js(request, bytes);
        if state.is_ready {
            state.post(&message);
            return;
        }
        state.waiting.push(message);
        if state.worker.is_none() && !state.is_pausing {
            state.start();
        }
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
    fn start(&mut self) {
        let chosen = fetch::parameters().and_then(|parameters| parameters.get(STORE_PARAMETER));
        let name = format!("{WORKER_NAME} {}", chosen.unwrap_or_default());
        let (messages, ends) = (self.this.clone(), self.this.clone());
        let link = Link::new(
            &name,
            move |message| on_message(&messages, &message),
            move |said| {
                if let Some(state) = ends.upgrade() {
                    state.borrow_mut().lose(said.unwrap_or_else(|| "its worker has ended".to_owned()));
                }
            },
        );
        match link {
            Ok(link) => self.worker = Some(link),
            Err(error) => self.lose(describe(&error)),
        }
    }

    fn post(&mut self, (value, transfer): &(JsValue, JsValue)) {
        let posted = self.worker.as_ref().map(|link| link.worker.post_message_with_transfer(value, transfer));
        if let Some(Err(error)) = posted {
            self.lose(describe(&error));
        }
    }

    /// Ends the worker. What it was asked for is forgotten: the next one has no document open.
    fn lose(&mut self, reason: String) {
        (self.worker, self.is_ready, self.is_pausing) = (None, false, true);
        self.waiting.clear();
        self.inbox.push(Event::Store(Answer::Crashed(reason), Vec::new()));
        let this = self.this.clone();
        wasm_bindgen_futures::spawn_local(async move {
            sleep(RESTART_PAUSE_MS).await;
            if let Some(state) = this.upgrade() {
                let mut state = state.borrow_mut();
                state.is_pausing = false;
                if !state.waiting.is_empty() {
                    state.start();
                }
            }
        });
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
