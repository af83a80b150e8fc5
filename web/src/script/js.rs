//! Functions and promises for scripts, made from Rust closures.

use std::cell::RefCell;
use std::rc::Rc;

use js_sys::{Array, ArrayBuffer, Function, JSON, Promise, Reflect};
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// The result of a script's call: a value, or the `Error` to throw.
pub type Answer = Result<JsValue, JsValue>;

/// An `Error` with a message, to throw or to reject with.
pub fn error(message: &str) -> JsValue {
    js_sys::Error::new(message).into()
}

/// Adds a method of up to two arguments to an object; omitted arguments are `undefined`. The method lives
/// as long as the page.
pub fn method(
    object: &JsValue,
    name: &str,
    body: impl FnMut(JsValue, JsValue) -> Answer + 'static,
) -> Result<(), JsValue> {
    let closure: Closure<dyn FnMut(JsValue, JsValue) -> Answer> = Closure::new(body);
    Reflect::set(object, &name.into(), &closure.into_js_value())?;
    Ok(())
}

/// Serialises into plain JavaScript data, as `JSON.parse` returns it.
pub fn to_js(value: &impl Serialize) -> Answer {
    let text = serde_json::to_string(value).map_err(|failure| error(&failure.to_string()))?;
    JSON::parse(&text)
}

/// A script's argument as JSON; typed arrays become lists. `undefined`, which JSON lacks, is refused with
/// the `message`.
pub fn to_json(value: &JsValue, message: &str) -> Result<serde_json::Value, JsValue> {
    let refused = || error(message);
    // JSON would turn NaN and infinities into null and drop functions and symbols, as if nothing had been
    // given. Their names are passed instead, so that the editor refuses them with a clear message.
    let by_name = Closure::<dyn Fn(JsValue, JsValue) -> JsValue>::new(|_, value: JsValue| {
        if value.is_function() {
            return "a function".into();
        }
        if value.is_symbol() {
            return "a symbol".into();
        }
        if ArrayBuffer::is_view(&value) {
            return Array::from(&value).into();
        }
        match value.as_f64() {
            Some(number) if number.is_nan() => "NaN".into(),
            Some(f64::INFINITY) => "Infinity".into(),
            Some(f64::NEG_INFINITY) => "-Infinity".into(),
            _ => value,
        }
    });
    let text = JSON::stringify_with_replacer(value, by_name.as_ref()).map_err(|_| refused())?;
    let text = text.as_string().ok_or_else(refused)?;
    serde_json::from_str(&text).map_err(|_| refused())
}

/// A promise to be settled once, now or later.
#[derive(Clone)]
pub struct Settle {
    functions: Rc<RefCell<Option<(Function, Function)>>>,
}

impl Settle {
    /// Resolves with the answer's value, or rejects with its error.
    pub fn with(&self, answer: Answer) {
        let Some((resolve, reject)) = self.functions.borrow_mut().take() else {
            return;
        };
        let (settle, value) = match answer {
            Ok(value) => (resolve, value),
            Err(error) => (reject, error),
        };
        // A promise's own functions don't throw.
        let _ = settle.call1(&JsValue::UNDEFINED, &value);
    }
}

/// A promise that `start` settles, or passes on to be settled later. An error of `start` itself rejects it.
pub fn promise(start: impl FnOnce(&Settle) -> Result<(), JsValue>) -> JsValue {
    let functions = Rc::new(RefCell::new(None));
    let promise = Promise::new(&mut |resolve, reject| *functions.borrow_mut() = Some((resolve, reject)));
    let settle = Settle { functions };
    if let Err(error) = start(&settle) {
        settle.with(Err(error));
    }
    promise.into()
}
