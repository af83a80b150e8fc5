//! Files from other addresses: `?model=<url>`.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use formats::{Room, refusal};
use js_sys::{Reflect, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{
    AbortController, ReadableStreamDefaultReader, RequestInit, Response, Url, UrlSearchParams, Window,
};

use super::inbox::{Inbox, describe};
use crate::platform::{Event, Fetched, NamedBytes};

/// The share of the job's progress that fetching takes; opening takes the rest.
const FETCH_SHARE: f64 = 0.5;

/// The parameters of the page's address.
pub fn parameters() -> Option<UrlSearchParams> {
    let search = web_sys::window()?.location().search().ok()?;
    UrlSearchParams::new_with_str(&search).ok()
}

/// The values of `model` in the page's address.
pub fn wanted() -> Option<Vec<String>> {
    let all = parameters()?.get_all("model");
    // An empty `?model=` asks for nothing; it must not fetch the page itself.
    Some(all.iter().filter_map(|value| value.as_string()).filter(|value| !value.trim().is_empty()).collect())
}

/// The fetches in progress.
pub struct Fetches {
    inbox: Inbox,
    running: Rc<RefCell<HashMap<u64, AbortController>>>,
}

impl Fetches {
    pub fn new(inbox: Inbox) -> Self {
        Self { inbox, running: Rc::default() }
    }

    /// Fetches the files one after the other, then their companion files from the same places, and delivers
    /// all together.
    pub fn start(&self, job: u64, addresses: Vec<String>) {
        let (Some(window), Ok(abort)) = (web_sys::window(), AbortController::new()) else { return };
        self.running.borrow_mut().insert(job, abort.clone());
        let (inbox, running) = (self.inbox.clone(), self.running.clone());
        spawn_local(async move {
            let progress = |fraction: f64| {
                inbox.push(Event::JobProgress { job, fraction: (FETCH_SHARE * fraction) as f32 });
            };
            let files = fetch_all(&window, &addresses, &abort, progress).await;
            // A cancelled job is no longer in the list, and nothing waits for its files.
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
) -> Result<Fetched, String> {
    let page = window.location().href().unwrap_or_default();
    let mut fetched = Fetched::default();
    let mut models = Vec::new();
    for (at, address) in addresses.iter().enumerate() {
        let url = Url::new_with_base(address, &page)
            .map_err(|_| format!("{address:?} after `?model=` is not the address of a file."))?;
        if !matches!(url.protocol().as_str(), "http:" | "https:" | "blob:" | "data:") {
            return Err(format!(
                "{address:?} after `?model=` can't be fetched: a page reads addresses that begin with http or \
                 https. Drop a file from this computer on the page instead."
            ));
        }
        let part = |part: f64| progress((at as f64 + part) / addresses.len() as f64);
        let (bytes, url) = fetch(window, &url, abort, part)
            .await
            .map_err(|Failure { why, advice }| format!("{} {why}. {advice}", url.href()))?;
        models.push(url.clone());
        fetched.files.push(NamedBytes { name: name_of(&url), bytes });
    }
    let asked: Vec<String> = models.iter().map(Url::href).collect();
    // The companions of models, then the companions of those: images that material libraries name.
    let mut owners: Vec<(usize, Url)> = models.into_iter().enumerate().collect();
    for depth in 0..2 {
        let mut found = Vec::new();
        for (at, owner) in owners {
            let Some(file) = fetched.files.get(at) else { continue };
            let (name, companions) = (file.name.clone(), formats::companions(file));
            let mut failures: HashMap<&str, String> = HashMap::new();
            for companion in &companions {
                // Once a name with blanks was found as a whole, its parts are not looked for.
                let is_part = |other: &&String| other.split_whitespace().any(|part| part == companion);
                let mut wholes = companions.iter().filter(|other| *other != companion).filter(is_part);
                let is_fetched = |name: &String| fetched.files.iter().any(|file| file.name == *name);
                if wholes.any(is_fetched) || (depth > 0 && is_fetched(companion)) {
                    continue;
                }
                match fetch_companion(window, &owner, companion, &asked, abort).await {
                    Ok(Some((bytes, url))) => {
                        found.push((fetched.files.len(), url));
                        fetched.files.push(NamedBytes { name: companion.clone(), bytes });
                    }
                    Ok(None) => {}
                    Err(why) => {
                        failures.insert(companion, why);
                    }
                }
            }
            for missing in formats::missing(&companions, |name| !failures.contains_key(name)) {
                let why = failures.get(missing).map_or("could not be fetched", String::as_str);
                fetched.notes.push(format!("{missing}, which belongs to {name}, {why}."));
            }
        }
        owners = found;
    }
    Ok(fetched)
}

/// Fetches a companion file from its owner's folder; returns none if the user asked for it directly.
async fn fetch_companion(
    window: &Window,
    owner: &Url,
    name: &str,
    asked: &[String],
    abort: &AbortController,
) -> Result<Option<(Vec<u8>, Url)>, String> {
    let path: Vec<String> =
        name.split('/').map(|part| String::from(js_sys::encode_uri_component(part))).collect();
    let elsewhere = "does not lie beside it, and is not looked for elsewhere";
    let url = Url::new_with_base(&path.join("/"), &owner.href()).map_err(|_| elsewhere.to_owned())?;
    // A model must not make the page contact other sites.
    if url.origin() != owner.origin() {
        return Err(elsewhere.to_owned());
    }
    if asked.contains(&url.href()) {
        return Ok(None);
    }
    match fetch(window, &url, abort, |_| {}).await {
        Ok(fetched) => Ok(Some(fetched)),
        Err(Failure { why, .. }) => Err(format!("{why} ({})", url.href())),
    }
}

/// Why a file could not be fetched.
struct Failure {
    /// The text after the file's name: "could not be fetched: …".
    why: String,
    /// A sentence on what to do, for files that the user asked for directly.
    advice: &'static str,
}

/// Fetches one file; returns its bytes and final address.
async fn fetch(
    window: &Window,
    url: &Url,
    abort: &AbortController,
    progress: impl Fn(f64),
) -> Result<(Vec<u8>, Url), Failure> {
    let options = RequestInit::new();
    options.set_signal(Some(&abort.signal()));
    let response = JsFuture::from(window.fetch_with_str_and_init(&url.href(), &options))
        .await
        .map_err(|error| unreachable(window, url, &describe(&error)))?;
    let broken = |error: JsValue| Failure {
        why: format!("could not be fetched whole: {}", describe(&error)),
        advice: "Reload the page to try again.",
    };
    let response: Response = response.dyn_into().map_err(broken)?;
    if !response.ok() {
        let status = format!("{} {}", response.status(), response.status_text());
        return Err(Failure {
            why: format!("could not be fetched: the server answered {}", status.trim_end()),
            advice: "Check the address after `?model=`.",
        });
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
            let all = (bytes.len() as u64 + u64::from(chunk.length())).max(length.unwrap_or_default() as u64);
            if let Some(why) = refusal(&Room::default(), &bytes, all) {
                return Err(Failure { why: format!("was not opened: {why}"), advice: "" });
            }
            let start = bytes.len();
            bytes.resize(start + chunk.length() as usize, 0);
            if let Some(end) = bytes.get_mut(start..) {
                chunk.copy_to(end);
            }
            // For compressed files, the stated length is too small.
            progress(length.map_or(0.0, |length| (bytes.len() as f64 / length).min(1.0)));
        }
    }
    let came_from = Url::new(&response.url()).unwrap_or_else(|_| url.clone());
    Ok((bytes, came_from))
}

/// Browsers don't tell the page why a fetch failed; these are the possible reasons.
fn unreachable(window: &Window, url: &Url, said: &str) -> Failure {
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
    Failure {
        why: format!("could not be fetched ({said}): {why}"),
        advice: "Download the file and drop it here, or put it on a server that allows it.",
    }
}

/// The last part of an address's path.
fn name_of(url: &Url) -> String {
    let path = url.pathname();
    let last = path.rsplit('/').find(|part| !part.is_empty()).unwrap_or("model");
    js_sys::decode_uri_component(last).map_or_else(|_| last.to_owned(), String::from)
}
