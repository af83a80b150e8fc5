//! Locks on documents, which all tabs of the browser share (Web Locks).

use crate::alive::lock_manager;
use js_sys::{Function, Object, Promise, Reflect};
use std::collections::HashMap;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;

/// The locks that this tab holds. They end with the worker.
#[derive(Debug, Default)]
pub(super) struct Locks {
    /// What unlocks each.
    held: HashMap<String, Function>,
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
        let granted = Promise::new(&mut |resolve, _| {
            let until_released = until_released.clone();
            let callback = Closure::once_into_js(move |lock: JsValue| -> JsValue {
                let is_granted = !lock.is_null();
                let _ = resolve.call1(&JsValue::NULL, &is_granted.into());
                if is_granted { until_released.into() } else { JsValue::UNDEFINED }
            });
            // A lock that can't be asked for is one that nobody holds.
            let _ = manager.request(&format!("meshwright-{name}"), &options, &callback);
        });
        let is_granted = JsFuture::from(granted).await.is_ok_and(|granted| granted.is_truthy());
        if let Some(release) = release.filter(|_| is_granted) {
            self.held.insert(name.to_owned(), release);
        }
        is_granted
    }

    pub fn release(&mut self, name: &str) {
        if let Some(release) = self.held.remove(name) {
            let _ = release.call0(&JsValue::NULL);
        }
    }
}
