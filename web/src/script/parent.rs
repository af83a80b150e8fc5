//! `window.meshwright` for a page that embeds this one, by messages.
//!
//! The address names the origins that may send: `?embed&origins=https://a.example`. Messages from others, and from windows
//! other than the parent, are ignored; answers go to the sender's origin only. `web/embed/meshwright-embed.js` is the other
//! end.
//!
//! A call is `{meshwright: 1, id, call, args}`; its answer `{meshwright: 1, id, result}` or `{meshwright: 1, id, error}`.
//! An event is `{meshwright: 1, event, detail}`; `ready` comes without being asked for.

use js_sys::{Array, Function, Object, Promise, Reflect};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{MessageEvent, Url, UrlSearchParams, Window};

use super::js::error;
use crate::platform::browser::describe;

/// The version of the messages.
const VERSION: u32 = 1;

/// The calls that a parent may make.
const CALLS: [&str; 13] = [
    "open",
    "openFiles",
    "run",
    "export",
    "exportFiles",
    "state",
    "element",
    "select",
    "undo",
    "redo",
    "cancel",
    "project",
    "on",
];

/// Answers the calls of the page that embeds this one, if the address allows any.
pub(crate) fn serve() -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let origins = allowed(&window)?;
    let Some(parent) = window.parent()?.filter(|parent| *parent != window) else { return Ok(()) };
    if origins.is_empty() {
        return Ok(());
    }
    let (own, embedder, allowed) = (window.clone(), parent.clone(), origins.clone());
    let source: JsValue = parent.clone().into();
    let on_message = Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
        let is_parent = event.source().is_some_and(|sender| JsValue::from(sender) == source);
        if is_parent && allowed.contains(&event.origin()) {
            answer(&own, &embedder, &event);
        }
    });
    window.add_event_listener_with_callback("message", on_message.as_ref().unchecked_ref())?;
    // The listener lives as long as the page.
    on_message.forget();
    spawn_local(async move {
        let ready = api(&window).and_then(|api| Reflect::get(&api, &"ready".into()));
        // If the editor can't start, the page says so itself.
        let Ok(ready) = ready.map(|ready| Promise::resolve(&ready)) else { return };
        let Ok(info) = JsFuture::from(ready).await else { return };
        for origin in origins {
            post(&parent, &origin, &[("event", "ready".into()), ("detail", info.clone())]);
        }
    });
    Ok(())
}

/// The origins that the address names. None counts that isn't one of the web, such as `null`.
fn allowed(window: &Window) -> Result<Vec<String>, JsValue> {
    let parameters = UrlSearchParams::new_with_str(&window.location().search()?)?;
    if !parameters.has("embed") {
        return Ok(Vec::new());
    }
    let named = parameters.get_all("origins");
    let named = named.iter().filter_map(|value| value.as_string());
    let origins =
        named.flat_map(|list| list.split(',').map(str::trim).map(str::to_owned).collect::<Vec<_>>());
    let origins = origins.filter_map(|origin| Url::new(&origin).ok().map(|url| url.origin()));
    Ok(origins.filter(|origin| origin.starts_with("https://") || origin.starts_with("http://")).collect())
}

fn api(window: &Window) -> Result<JsValue, JsValue> {
    Reflect::get(window, &"meshwright".into())
}

/// Carries out a call and posts the answer.
fn answer(window: &Window, parent: &Window, event: &MessageEvent) {
    let data = event.data();
    let field = |name: &str| Reflect::get(&data, &name.into()).unwrap_or(JsValue::UNDEFINED);
    if !data.is_object() || field("meshwright").as_f64() != Some(f64::from(VERSION)) {
        return;
    }
    let (id, call, args) = (field("id"), field("call"), field("args"));
    let (parent, origin) = (parent.clone(), event.origin());
    let result = call_api(window, &call, &args, &parent, &origin);
    spawn_local(async move {
        let result = match result {
            Ok(result) => JsFuture::from(Promise::resolve(&result)).await,
            Err(error) => Err(error),
        };
        match result {
            Ok(result) => post(&parent, &origin, &[("id", id), ("result", result)]),
            Err(error) => post(&parent, &origin, &[("id", id), ("error", describe(&error).into())]),
        }
    });
}

fn call_api(
    window: &Window,
    call: &JsValue,
    args: &JsValue,
    parent: &Window,
    origin: &str,
) -> Result<JsValue, JsValue> {
    let name = call.as_string().filter(|name| CALLS.contains(&name.as_str()));
    let name =
        name.ok_or_else(|| error(&format!("there is no such call; use one of {}", CALLS.join(", "))))?;
    let args: Array = if Array::is_array(args) { args.clone().unchecked_into() } else { Array::new() };
    if name == "on" {
        let (parent, origin, event) = (parent.clone(), origin.to_owned(), args.get(0));
        let named = event.clone();
        let forward = Closure::<dyn FnMut(JsValue)>::new(move |detail: JsValue| {
            post(&parent, &origin, &[("event", named.clone()), ("detail", detail)]);
        });
        super::events::on(&event, forward.into_js_value())?;
        return Ok(JsValue::UNDEFINED);
    }
    let api = api(window)?;
    let method: Function = Reflect::get(&api, &name.into())?.dyn_into()?;
    method.apply(&api, &args)
}

fn post(parent: &Window, origin: &str, fields: &[(&str, JsValue)]) {
    let message = Object::new();
    let version = ("meshwright", JsValue::from(VERSION));
    for (name, value) in std::iter::once(&version).chain(fields) {
        // Setting a field of a plain object can't fail.
        let _ = Reflect::set(&message, &(*name).into(), value);
    }
    // The browser drops a message to a parent of another origin.
    let _ = parent.post_message(&message, origin);
}
