//! Locks on documents, which all tabs of the browser share (Web Locks).

use crate::alive::{ended, lock_manager};
use js_sys::{Function, Object, Promise, Reflect};
use std::collections::HashMap;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};

/// The locks that this tab holds. They end with the worker.
#[derive(Debug, Default)]
pub(super) struct Locks {
    /// What unlocks each.
    held: HashMap<String, Function>,
    /// Whether the browser has refused to give any.
    are_refused: bool,
}

impl Locks {
    /// Takes a lock; returns whether no other tab holds it. Where the browser has no locks, none does.
    pub async fn take(&mut self, name: &str) -> bool {
        if self.held.contains_key(name) {
            return true;
        }
        let Some(manager) = lock_manager() else { return true };
        let options = Object::new();
        let _ = Reflect::set(&options, &"ifAvailable".into(), &true.into());
        let mut release = None;
        let until_released = Promise::new(&mut |resolve, _| release = Some(resolve));
        let granted = Promise::new(&mut |resolve, reject| {
            let until_released = until_released.clone();
            let callback = Closure::once_into_js(move |lock: JsValue| -> JsValue {
                let is_granted = !lock.is_null();
                let _ = resolve.call1(&JsValue::NULL, &is_granted.into());
                if is_granted { until_released.into() } else { JsValue::UNDEFINED }
            });
            let requested = manager.request(&format!("meshwright-{name}"), &options, &callback);
            spawn_local(async move {
                // Ends when the lock is released, or at once if the browser refuses.
                if let Err(error) = ended(requested).await {
                    let _ = reject.call1(&JsValue::NULL, &error);
                }
            });
        });
        let Ok(granted) = JsFuture::from(granted).await else {
            // A lock that can't be asked for is one that nobody holds.
            self.are_refused = true;
            return true;
        };
        let is_granted = granted.is_truthy();
        if let Some(release) = release.filter(|_| is_granted) {
            self.held.insert(name.to_owned(), release);
        }
        is_granted
    }

    /// Whether there are locks, so that one that is granted means something.
    pub fn work(&self) -> bool {
        !self.are_refused && lock_manager().is_some()
    }

    pub fn release(&mut self, name: &str) {
        if let Some(release) = self.held.remove(name) {
            let _ = release.call0(&JsValue::NULL);
        }
    }
}
