//! The store's worker: carries out the page's requests one after the other.

use super::disk::{Disk, Failure, FileLength};
use super::documents::Documents;
use super::indexed_db::IndexedDb;
use super::message::{Answer, Bytes, Request, from_js, to_js};
use super::opfs::Opfs;
use crate::alive::hold_while_alive;
use js_sys::{Array, Uint8Array};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;
use std::task::{Poll, Waker};
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// The part of the worker's name that asks for IndexedDB, for tests in browsers that have both.
const ASKS_FOR_INDEXED_DB: &str = "indexeddb";

/// The requests that were not carried out yet.
#[derive(Default)]
struct Waiting {
    requests: VecDeque<(Request, Bytes)>,
    waker: Option<Waker>,
}

/// Answers the page's requests for as long as the worker lives. Does nothing outside a worker.
pub fn serve() {
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else {
        return;
    };
    std::panic::set_hook(Box::new(|info| {
        if let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() {
            post(&scope, &Answer::Crashed(info.to_string()), &[]);
        }
    }));
    let waiting = Rc::new(RefCell::new(Waiting::default()));
    let on_message = Closure::<dyn FnMut(MessageEvent)>::new({
        let waiting = waiting.clone();
        move |event: MessageEvent| {
            if let Some(request) = from_js(&event.data()) {
                let mut waiting = waiting.borrow_mut();
                waiting.requests.push_back(request);
                if let Some(waker) = waiting.waker.take() {
                    waker.wake();
                }
            }
        }
    });
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    // The listener lives as long as the worker, until the page ends.
    on_message.forget();
    hold_while_alive(&scope.name(), {
        let scope = scope.clone();
        move || post(&scope, &Answer::Ready, &[])
    });
    wasm_bindgen_futures::spawn_local(async move {
        match Place::find(&scope).await {
            Place::Private(disk) => carry_out(Documents::new(disk), &scope, &waiting).await,
            Place::Indexed(disk, unreadable) => {
                let documents = Documents::new(disk).beside_unreadable(unreadable);
                carry_out(documents, &scope, &waiting).await;
            }
            Place::None(failure) => carry_out(Documents::new(NoDisk(failure)), &scope, &waiting).await,
        }
    });
}

/// Where documents are kept.
enum Place {
    Private(Opfs),
    /// And why documents may be in private files that can't be read now.
    Indexed(IndexedDb, Option<Failure>),
    None(Failure),
}

impl Place {
    /// The origin private file system where the browser has it, unless the documents are in IndexedDB: an earlier version
    /// of the browser may have had only that.
    async fn find(scope: &DedicatedWorkerGlobalScope) -> Self {
        let private = match scope.name().contains(ASKS_FOR_INDEXED_DB) {
            true => Err(Failure::Denied),
            false => Opfs::new().await,
        };
        let unreadable = match private {
            Ok(mut disk) => {
                if disk.folders().await == Ok(Vec::new())
                    && let Ok(mut indexed) = IndexedDb::new().await
                    && indexed.folders().await.is_ok_and(|folders| !folders.is_empty())
                {
                    return Self::Indexed(indexed, None);
                }
                return Self::Private(disk);
            }
            // The browser has no such files, or allows none.
            Err(Failure::Denied) => None,
            Err(failure) => Some(failure),
        };
        match IndexedDb::new().await {
            Ok(disk) => Self::Indexed(disk, unreadable),
            Err(failure) => Self::None(failure),
        }
    }
}

/// Makes files of kept documents for a page whose program has crashed. It sends `[id, repeatsLog]` and gets
/// `["file", name, bytes]` or `["failed", why]`. Does nothing outside a worker.
pub fn serve_rescue() {
    let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() else {
        return;
    };
    let answers = scope.clone();
    let on_message = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let Ok(asked) = event.data().dyn_into::<Array>() else { return };
        let (Some(id), repeats_log) = (asked.get(0).as_string(), asked.get(1).is_truthy()) else { return };
        let scope = answers.clone();
        wasm_bindgen_futures::spawn_local(async move {
            let rescued = match Place::find(&scope).await {
                Place::Private(disk) => Documents::new(disk).rescue(&id, repeats_log).await,
                Place::Indexed(disk, _) => Documents::new(disk).rescue(&id, repeats_log).await,
                Place::None(failure) => Err(super::rescue::unreadable(&failure)),
            };
            let answer = match rescued {
                Ok(file) => {
                    Array::of3(&"file".into(), &file.name.into(), &Uint8Array::from(file.bytes.as_slice()))
                }
                Err(why) => Array::of2(&"failed".into(), &why.into()),
            };
            // Fails only if the page is gone.
            let _ = scope.post_message(&answer);
        });
    });
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    // The listener lives as long as the worker.
    on_message.forget();
    let _ = scope.post_message(&Array::of1(&"ready".into()));
}

async fn carry_out(
    mut documents: Documents<impl Disk>,
    scope: &DedicatedWorkerGlobalScope,
    waiting: &RefCell<Waiting>,
) {
    loop {
        let (request, bytes) = std::future::poll_fn(|context| {
            let mut waiting = waiting.borrow_mut();
            match waiting.requests.pop_front() {
                Some(request) => Poll::Ready(request),
                None => {
                    waiting.waker = Some(context.waker().clone());
                    Poll::Pending
                }
            }
        })
        .await;
        documents.handle(request, &bytes, &mut |answer, bytes| post(scope, &answer, &bytes)).await;
    }
}

fn post(scope: &DedicatedWorkerGlobalScope, answer: &Answer, bytes: &[u8]) {
    let (value, transfer) = to_js(answer, bytes);
    // Fails only if the page is gone, and then there is no receiver.
    let _ = scope.post_message_with_transfer(&value, &transfer);
}

/// What there is where the browser keeps nothing for the page.
#[derive(Debug)]
struct NoDisk(Failure);

impl NoDisk {
    fn fails<T>(&self) -> Result<T, Failure> {
        Err(self.0.clone())
    }
}

impl Disk for NoDisk {
    async fn folders(&mut self) -> Result<Vec<String>, Failure> {
        self.fails()
    }

    async fn files(&mut self, _folder: &str) -> Result<Vec<FileLength>, Failure> {
        self.fails()
    }

    async fn append(&mut self, _folder: &str, _file: &str, _bytes: &[u8]) -> Result<(), Failure> {
        self.fails()
    }

    async fn read(&mut self, _folder: &str, _file: &str, _at: u64, _len: usize) -> Result<Vec<u8>, Failure> {
        self.fails()
    }

    async fn truncate(&mut self, _folder: &str, _file: &str, _bytes: u64) -> Result<(), Failure> {
        self.fails()
    }

    async fn remove(&mut self, _folder: &str, _file: &str) -> Result<(), Failure> {
        self.fails()
    }

    async fn remove_folder(&mut self, _folder: &str) -> Result<(), Failure> {
        self.fails()
    }

    async fn lock(&mut self, _folder: &str) -> bool {
        true
    }

    async fn unlock(&mut self, _folder: &str) {}
}
