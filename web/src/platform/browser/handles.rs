//! The page's side of `web/site/files.js`: files that are saved where they were opened, files that the system opens with the
//! page, and files that other programs share with it.

use js_sys::{Array, Promise, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::File;

use super::files::read_all;
use super::inbox::{Inbox, describe};
use crate::platform::{Event, NamedBytes, PlacedFile, Source};
use formats::Format;

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
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = rememberFile)]
    fn remember_file(document: &str, source: Source, name: &str, format: &str);
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = forgetFile)]
    fn forget_file(document: &str);
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = recallFile)]
    fn recall_file(document: &str) -> Promise;
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

/// Remembers for later visits which file a document is saved to.
pub fn remember(document: &str, file: Option<&PlacedFile>) {
    match file {
        Some(file) => remember_file(document, file.source, &file.name, file.format.code()),
        None => forget_file(document),
    }
}

/// Delivers the file that a document is saved to since an earlier visit.
pub fn recall(document: String, inbox: Inbox) {
    let recalled = recall_file(&document);
    spawn_local(async move {
        // A browser that remembers nothing says so here; saving then asks where.
        let Ok(file) = JsFuture::from(recalled).await else { return };
        if let Some(file) = as_file(&file) {
            inbox.push(Event::Recalled { document, file });
        }
    });
}

/// A file as an array of its source, its name and its format's code; none of `undefined`.
fn as_file(value: &JsValue) -> Option<PlacedFile> {
    let fields = value.dyn_ref::<Array>()?;
    let format = Format::from_code(&fields.get(2).as_string()?);
    PlacedFile::new(as_source(&fields.get(0))?, &fields.get(1).as_string()?, format)
}

/// Reads files and delivers them: those of a promise of a source and an array.
fn deliver(files: Promise, inbox: Inbox) {
    spawn_local(async move {
        let opened = match JsFuture::from(files).await {
            Ok(nothing) if nothing.is_undefined() => return,
            Ok(opened) => Array::from(&opened),
            Err(error) => {
                let reason = describe(&error);
                return inbox
                    .push(Event::Failed(format!("The files could not be read: {reason}. Try again.")));
            }
        };
        let files: Vec<File> =
            Array::from(&opened.get(1)).iter().filter_map(|file| file.dyn_into().ok()).collect();
        if files.is_empty() {
            return inbox.push(Event::Failed("The other program shared no files. Try again.".to_owned()));
        }
        read_all(&files, as_source(&opened.get(0)), &inbox).await;
    });
}

fn as_source(value: &JsValue) -> Option<Source> {
    value.as_f64().map(|number| number as Source)
}
