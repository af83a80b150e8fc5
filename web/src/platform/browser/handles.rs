//! The page's side of `web/site/files.js`: files that are saved where they were opened, files that the system opens with the
//! page, and files that other programs share with it.

use js_sys::{Array, Promise, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};

use super::inbox::{Inbox, describe};
use crate::platform::{Event, NamedBytes, Source};

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = pickFiles)]
    fn pick_files() -> Option<Promise>;
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = sourceOfDropped)]
    fn source_of_dropped() -> Promise;
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = onLaunched)]
    fn on_launched(deliver: &JsValue);
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = takeShared)]
    fn take_shared() -> Promise;
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = hasFile)]
    fn has_file(source: Source, name: &str) -> bool;
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = askToWrite)]
    fn ask_to_write(source: Source);
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    fn write(source: Source, names: Array, contents: Array) -> Promise;
}

/// Delivers the files that the system opens with the page, or that another program shared with it.
pub fn listen(inbox: &Inbox) {
    deliver(take_shared(), inbox.clone());
    let inbox = inbox.clone();
    let on_launched_files = Closure::<dyn FnMut(Promise)>::new(move |files| deliver(files, inbox.clone()));
    // It lives as long as the page.
    on_launched(&on_launched_files.into_js_value());
}

/// Shows the browser's dialog that gives out handles; false if it has none.
pub fn pick(inbox: &Inbox) -> bool {
    let files = pick_files();
    let has_dialog = files.is_some();
    if let Some(files) = files {
        deliver(files, inbox.clone());
    }
    has_dialog
}

/// The source of the files that were dropped last, if the browser tells.
pub async fn dropped() -> Option<Source> {
    as_source(&JsFuture::from(source_of_dropped()).await.ok()?)
}

pub fn can_write(source: Source, name: &str) -> bool {
    has_file(source, name)
}

pub fn ask(source: Source) {
    ask_to_write(source);
}

/// Writes files to where they were opened.
pub fn write_back(source: Source, files: Vec<NamedBytes>, inbox: Inbox) {
    let names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
    let written = write(
        source,
        names.iter().map(JsValue::from).collect(),
        files.iter().map(|file| Uint8Array::new_from_slice(&file.bytes)).collect(),
    );
    spawn_local(async move {
        let result = JsFuture::from(written).await.map(drop).map_err(|error| describe(&error));
        inbox.push(Event::Written { files: names, result });
    });
}

/// Delivers files once they are read: a source, and an array with the name and the bytes of each.
fn deliver(files: Promise, inbox: Inbox) {
    spawn_local(async move {
        match JsFuture::from(files).await {
            Ok(nothing) if nothing.is_undefined() => {}
            Ok(opened) => {
                let opened = Array::from(&opened);
                let files: Vec<NamedBytes> = Array::from(&opened.get(1)).iter().filter_map(file).collect();
                inbox.push(match as_source(&opened.get(0)) {
                    Some(source) => Event::FilesOf(source, files),
                    None if files.is_empty() => Event::Failed(
                        "No files came from the program that shared them. Try again.".to_owned(),
                    ),
                    None => Event::Files(files),
                });
            }
            Err(error) => {
                let reason = describe(&error);
                inbox.push(Event::Failed(format!("The files could not be read: {reason}. Try again.")));
            }
        }
    });
}

fn file(entry: JsValue) -> Option<NamedBytes> {
    let entry = Array::from(&entry);
    let bytes: Uint8Array = entry.get(1).dyn_into().ok()?;
    Some(NamedBytes { name: entry.get(0).as_string()?, bytes: bytes.to_vec() })
}

fn as_source(value: &JsValue) -> Option<Source> {
    value.as_f64().map(|number| number as Source)
}
