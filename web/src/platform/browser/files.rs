//! Files from the user: dropped on the page, or picked in the browser's dialog.

use egui::DroppedFileHandle;
use formats::{HEAD_BYTES, Room, refusal};
use js_sys::Uint8Array;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{File, HtmlInputElement};

use super::handles;
use super::inbox::{Inbox, describe};
use crate::platform::{Event, NamedBytes, Source};

/// Reads files that were dropped together.
pub fn read_dropped(dropped: Vec<DroppedFileHandle>, inbox: Inbox) {
    spawn_local(async move {
        let source = handles::dropped().await;
        let files: Vec<File> = dropped.iter().filter_map(|file| file.web_file().cloned()).collect();
        read_all(&files, source, &inbox).await;
    });
}

/// Reads files and delivers them together, so that an OBJ finds its MTL.
pub(super) async fn read_all(files: &[File], source: Option<Source>, inbox: &Inbox) {
    let mut read_files = Vec::with_capacity(files.len());
    for file in files {
        let name = file.name();
        match read(file).await {
            Ok(bytes) => read_files.push(NamedBytes { name, bytes }),
            Err(failure) => return inbox.push(failure.event(&name)),
        }
    }
    inbox.push(match source {
        Some(source) => Event::FilesOf(source, read_files),
        None => Event::Files(read_files),
    });
}

/// The browser's file dialog.
pub struct FilePicker {
    /// Not part of the page; `None` if there is no document to create it in.
    input: Option<HtmlInputElement>,
    inbox: Inbox,
    _on_change: Closure<dyn FnMut()>,
}

impl FilePicker {
    pub fn new(inbox: Inbox) -> Self {
        let input = make_input();
        let on_change = Closure::new({
            let input = input.clone();
            let inbox = inbox.clone();
            move || {
                if let Some(input) = &input {
                    read_picked(input, &inbox);
                }
            }
        });
        if let Some(input) = &input {
            input.set_onchange(Some(on_change.as_ref().unchecked_ref()));
        }
        Self { input, inbox, _on_change: on_change }
    }

    /// Shows the dialog. Browsers allow this only shortly after a click or a key.
    pub fn show(&self) {
        match &self.input {
            Some(input) => input.click(),
            None => self.inbox.push(Event::Failed("This browser offers no file dialog.".to_owned())),
        }
    }
}

/// Offers all types of file: some systems know none of these extensions and would grey out every file.
fn make_input() -> Option<HtmlInputElement> {
    let document = web_sys::window()?.document()?;
    let input: HtmlInputElement = document.create_element("input").ok()?.dyn_into().ok()?;
    input.set_type("file");
    input.set_multiple(true);
    Some(input)
}

fn read_picked(input: &HtmlInputElement, inbox: &Inbox) {
    let list = input.files();
    let picked: Vec<File> =
        list.iter().flat_map(|list| (0..list.length()).filter_map(|i| list.get(i))).collect();
    // Without this, picking the same file again would be no change.
    input.set_value("");
    if picked.is_empty() {
        return;
    }
    let inbox = inbox.clone();
    spawn_local(async move { read_all(&picked, None, &inbox).await });
}

/// Why a file was not read.
enum Failure {
    TooLarge(String),
    Unreadable(JsValue),
}

impl Failure {
    fn event(&self, name: &str) -> Event {
        Event::Failed(match self {
            Self::TooLarge(why) => format!("{name} was not opened: {why}."),
            Self::Unreadable(error) => format!(
                "{name} could not be read: {}. It may have been moved or changed; try again.",
                describe(error)
            ),
        })
    }
}

impl From<JsValue> for Failure {
    fn from(error: JsValue) -> Self {
        Self::Unreadable(error)
    }
}

/// Reads a file, unless its beginning and its size tell that it doesn't fit into memory.
async fn read(file: &File) -> Result<Vec<u8>, Failure> {
    let head = file.slice_with_f64_and_f64(0.0, HEAD_BYTES as f64)?;
    let head = Uint8Array::new(&JsFuture::from(head.array_buffer()).await?).to_vec();
    if let Some(why) = refusal(&Room::default(), &head, file.size() as u64) {
        return Err(Failure::TooLarge(why));
    }
    let buffer = JsFuture::from(file.array_buffer()).await?;
    Ok(Uint8Array::new(&buffer).to_vec())
}
