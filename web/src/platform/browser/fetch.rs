//! Files from other addresses: `?model=<url>`.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use js_sys::{Reflect, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{
    AbortController, ReadableStreamDefaultReader, RequestInit, Response, Url, UrlSearchParams, Window,
};

use super::{Inbox, describe};
use crate::platform::{Event, NamedBytes};

/// The program's memory ends at 4 GiB, and a larger copy would be a crash.
const LARGEST: usize = 2 << 30;

/// How much of the job fetching is; opening is the rest.
const SHARE: f64 = 0.5;

/// Each `model` of the page's address.
pub fn wanted() -> Option<Vec<String>> {
    let search = web_sys::window()?.location().search().ok()?;
    let all = UrlSearchParams::new_with_str(&search).ok()?.get_all("model");
    Some(all.iter().filter_map(|value| value.as_string()).collect())
}

/// What is being fetched.
pub struct Fetches {
    inbox: Inbox,
    running: Rc<RefCell<HashMap<u64, AbortController>>>,
}

impl Fetches {
    pub fn new(inbox: Inbox) -> Self {
        Self { inbox, running: Rc::default() }
    }

    /// Fetches the files one after the other and delivers them together.
    pub fn start(&self, job: u64, addresses: Vec<String>) {
        let (Some(window), Ok(abort)) = (web_sys::window(), AbortController::new()) else { return };
        self.running.borrow_mut().insert(job, abort.clone());
        let (inbox, running) = (self.inbox.clone(), self.running.clone());
        spawn_local(async move {
            let progress = |fraction: f64| {
                inbox.push(Event::JobProgress { job, fraction: (SHARE * fraction) as f32 });
            };
            let files = fetch_all(&window, &addresses, &abort, progress).await;
            // Whoever cancelled it has taken it out, and waits for nothing.
            if running.borrow_mut().remove(&job).is_some() {
                inbox.push(Event::Fetched { job, files });
            }
        });
    }

    pub fn cancel(&self, job: u64) {
        if let Some(abort) = self.running.borrow_mut().remove(&job) {
            abort.abort();
        }
    }
}

async fn fetch_all(
    window: &Window,
    addresses: &[String],
    abort: &AbortController,
    progress: impl Fn(f64),
) -> Result<Vec<NamedBytes>, String> {
    let mut files = Vec::with_capacity(addresses.len());
    for address in addresses {
        let before = files.len() as f64;
        let part = |part: f64| progress((before + part) / addresses.len() as f64);
        files.push(fetch(window, address, abort, part).await?);
    }
    Ok(files)
}

/// One file; a sentence where it can't be had.
async fn fetch(
    window: &Window,
    address: &str,
    abort: &AbortController,
    progress: impl Fn(f64),
) -> Result<NamedBytes, String> {
    let page = window.location().href().unwrap_or_default();
    let url = Url::new_with_base(address, &page)
        .map_err(|_| format!("{address:?} after `?model=` is no address of a file."))?;
    let options = RequestInit::new();
    options.set_signal(Some(&abort.signal()));
    let response = JsFuture::from(window.fetch_with_str_and_init(&url.href(), &options))
        .await
        .map_err(|error| unreachable(window, &url, &describe(&error)))?;
    let broken = |error: JsValue| {
        format!(
            "{} broke off while it was fetched: {}. Reload the page to try again.",
            url.href(),
            describe(&error)
        )
    };
    let response: Response = response.dyn_into().map_err(broken)?;
    if !response.ok() {
        let status = format!("{} {}", response.status(), response.status_text());
        return Err(format!(
            "{} could not be fetched: the server answered {}. Check the address after `?model=`.",
            url.href(),
            status.trim_end()
        ));
    }
    let length = response.headers().get("content-length").ok().flatten();
    let length = length.and_then(|text| text.parse::<f64>().ok()).filter(|&length| length > 0.0);
    let mut bytes = Vec::new();
    if let Some(body) = response.body() {
        let reader: ReadableStreamDefaultReader =
            body.get_reader().dyn_into().map_err(|other| broken(other.into()))?;
        loop {
            let part = JsFuture::from(reader.read()).await.map_err(broken)?;
            let field = |name: &str| Reflect::get(&part, &name.into());
            if field("done").is_ok_and(|done| done.is_truthy()) {
                break;
            }
            let chunk: Uint8Array = field("value").and_then(JsCast::dyn_into).map_err(broken)?;
            if bytes.len() + chunk.length() as usize > LARGEST {
                return Err(format!("{} is larger than 2 GB: too large for a browser.", url.href()));
            }
            let start = bytes.len();
            bytes.resize(start + chunk.length() as usize, 0);
            if let Some(end) = bytes.get_mut(start..) {
                chunk.copy_to(end);
            }
            // A length that was given of compressed bytes is too small.
            progress(length.map_or(0.0, |length| (bytes.len() as f64 / length).min(1.0)));
        }
    }
    Ok(NamedBytes { name: name_of(&url), bytes })
}

/// Browsers keep from the page why a fetch failed; these are the reasons there are.
fn unreachable(window: &Window, url: &Url, said: &str) -> String {
    let insecure = window.location().protocol().is_ok_and(|own| own == "https:") && url.protocol() == "http:";
    let why = if insecure {
        "a page from https can't read files from http".to_owned()
    } else {
        format!(
            "either {} can't be reached, or it doesn't allow pages of other sites to read its files (CORS: the \
             header Access-Control-Allow-Origin is missing)",
            url.host()
        )
    };
    format!(
        "{} could not be fetched ({said}): {why}. Download the file and drop it here, or put it on a server that allows it.",
        url.href()
    )
}

/// The last part of an address's path.
fn name_of(url: &Url) -> String {
    let path = url.pathname();
    let last = path.rsplit('/').find(|part| !part.is_empty()).unwrap_or("model");
    js_sys::decode_uri_component(last).map_or_else(|_| last.to_owned(), String::from)
}
