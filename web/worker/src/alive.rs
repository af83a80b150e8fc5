//! Learning that a worker has ended. The browser may end one without an event, such as for lack of memory; but then it
//! releases its locks (Web Locks). Where the browser has no locks, a worker ends unnoticed.

use js_sys::{Object, Promise, Reflect};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};

// web-sys counts these as unstable, which they no longer are.
#[wasm_bindgen]
extern "C" {
    /// The locks that all pages and workers of this origin share.
    pub type LockManager;

    /// Asks for a lock, which is held until the promise is fulfilled that the callback returns.
    #[wasm_bindgen(method, catch)]
    pub fn request(
        this: &LockManager,
        name: &str,
        options: &Object,
        callback: &JsValue,
    ) -> Result<Promise, JsValue>;
}

/// The locks; none where the browser has none.
pub fn lock_manager() -> Option<LockManager> {
    let navigator = Reflect::get(&js_sys::global(), &"navigator".into()).ok()?;
    let locks = Reflect::get(&navigator, &"locks".into()).ok()?;
    (!locks.is_undefined()).then(|| locks.unchecked_into())
}

/// What is called once.
type Then = Box<dyn FnOnce()>;

/// Holds a lock for as long as the worker of this name lives, and then calls `then`.
pub fn hold_while_alive(worker: &str, then: impl FnOnce() + 'static) {
    let Some(manager) = lock_manager() else { return then() };
    let then: Rc<Cell<Option<Then>>> = Rc::new(Cell::new(Some(Box::new(then))));
    let call = |then: &Cell<Option<Then>>| then.take().into_iter().for_each(|then| then());
    let callback = Closure::once_into_js({
        let then = then.clone();
        move || -> JsValue {
            call(&then);
            Promise::new(&mut |_, _| {}).into()
        }
    });
    let requested = manager.request(&lock_name(worker), &Object::new(), &callback);
    spawn_local(async move {
        if ended(requested).await.is_err() {
            // The worker ends unnoticed then, as without locks.
            call(&then);
        }
    });
}

/// Waits until a lock that was asked for has ended.
///
/// # Errors
/// The browser gives no lock.
pub async fn ended(requested: Result<Promise, JsValue>) -> Result<JsValue, JsValue> {
    JsFuture::from(requested?).await
}

/// Calls `then` when the worker of this name ends, if it holds its lock now.
pub fn when_ended(worker: &str, then: impl FnOnce() + 'static) {
    let Some(manager) = lock_manager() else { return };
    let if_available = Object::new();
    let _ = Reflect::set(&if_available, &"ifAvailable".into(), &true.into());
    let name = lock_name(worker);
    let callback = Closure::once_into_js({
        let name = name.clone();
        move |lock: JsValue| {
            if lock.is_null()
                && let Some(manager) = lock_manager()
            {
                let _ = manager.request(&name, &Object::new(), &Closure::once_into_js(then));
            }
        }
    });
    let _ = manager.request(&name, &if_available, &callback);
}

fn lock_name(worker: &str) -> String {
    format!("meshwright-alive {worker}")
}
