//! The editor's [`Platform`] in a browser: jobs run in a worker, files come through the page, settings are
//! in local storage.

mod address;
mod download;
mod fetch;
mod files;
mod handles;
mod inbox;
mod jobs;
mod offline;
mod pointer;
mod store;
mod wait;
mod worker;

use std::cell::Cell;
use std::rc::Rc;

use super::store::{Id, Request};
use super::{DeviceInfo, Download, Event, NamedBytes, PlacedFile, Platform, Source};
use editor::JobRequest;
use fetch::Fetches;
use files::FilePicker;
use inbox::Inbox;
pub(crate) use inbox::describe;
use jobs::Jobs;
use store::Store;
pub(crate) use wait::{sleep, within};

/// The contents of the guide, from the page on (`xtask/src/site/help.rs`).
const GUIDE: &str = "help/guide.html";

/// The browser as a platform.
pub struct Browser {
    inbox: Inbox,
    jobs: Jobs,
    store: Store,
    fetches: Fetches,
    picker: FilePicker,
    device: DeviceInfo,
    /// The user's wish for less motion, which the browser keeps up to date.
    less_motion: Option<web_sys::MediaQueryList>,
    /// Whether the user points with a pen, which the browser keeps up to date too.
    has_pen: Rc<Cell<bool>>,
}

impl Browser {
    /// Starts the worker at once, so that the first job need not wait for it.
    pub fn new(ctx: &egui::Context, device: DeviceInfo) -> Self {
        let inbox = Inbox::new(ctx);
        address::listen(inbox.clone());
        handles::listen(&inbox);
        offline::listen(inbox.clone());
        let window = web_sys::window();
        let less_motion =
            window.and_then(|window| window.match_media("(prefers-reduced-motion: reduce)").ok().flatten());
        Self {
            jobs: Jobs::new(inbox.clone()),
            store: Store::new(inbox.clone()),
            fetches: Fetches::new(inbox.clone()),
            picker: FilePicker::new(inbox.clone()),
            inbox,
            device,
            less_motion,
            has_pen: pointer::listen_for_pen(),
        }
    }
}

impl Platform for Browser {
    fn poll(&mut self, ctx: &egui::Context) -> Vec<Event> {
        let dropped = ctx.input(|input| input.raw.dropped_files.clone());
        if !dropped.is_empty() {
            files::read_dropped(dropped, self.inbox.clone());
        }
        self.jobs.step();
        self.inbox.take()
    }

    fn start_job(&mut self, job: u64, request: &JobRequest) {
        self.jobs.start(job, request);
    }

    fn wanted(&self) -> Vec<String> {
        fetch::wanted().unwrap_or_default()
    }

    fn parameter(&self, name: &str) -> Option<String> {
        address_parameter(name)
    }

    fn address(&self) -> Option<String> {
        Some(address::address())
    }

    fn fragment(&self) -> String {
        address::fragment()
    }

    fn clear_fragment(&mut self) {
        address::clear_fragment();
    }

    fn fetch(&mut self, job: u64, addresses: Vec<String>) {
        self.fetches.start(job, addresses);
    }

    fn cancel_job(&mut self, job: u64) {
        self.fetches.cancel(job);
        self.jobs.cancel(job);
    }

    fn open_file_dialog(&mut self) {
        if !handles::pick(&self.inbox) {
            self.picker.show();
        }
    }

    fn download(&mut self, files: Vec<NamedBytes>) -> Download {
        for file in files {
            if let Err(error) = download::download(&file) {
                let reason = describe(&error);
                self.inbox.push(Event::Failed(format!("{} could not be saved: {reason}.", file.name)));
            }
        }
        Download::Done
    }

    fn can_write(&self, source: Source, name: &str) -> bool {
        handles::can_write(source, name)
    }

    fn ask_to_write(&mut self, source: Source) {
        handles::ask(source);
    }

    fn write_back(&mut self, source: Source, files: Vec<NamedBytes>) {
        handles::write_back(source, files, self.inbox.clone());
    }

    fn remember_file(&mut self, document: &Id, file: Option<&PlacedFile>) {
        handles::remember(document, file);
    }

    fn recall_file(&mut self, document: &Id) {
        handles::recall(document.clone(), self.inbox.clone());
    }

    fn update(&mut self) {
        offline::update();
    }

    fn open_guide(&mut self) -> bool {
        address::open_in_new_tab(GUIDE);
        true
    }

    fn load_setting(&self, key: &str) -> Option<String> {
        storage()?.get_item(&setting_key(key)).ok()?
    }

    fn store_setting(&mut self, key: &str, value: &str) {
        // If storage is full or forbidden, the setting lasts as long as the page.
        if let Some(storage) = storage() {
            let _ = storage.set_item(&setting_key(key), value);
        }
    }

    fn load_tab_setting(&self, key: &str) -> Option<String> {
        load_tab_setting(key)
    }

    fn store_tab_setting(&mut self, key: &str, value: &str) {
        store_tab_setting(key, value);
    }

    fn set_title(&mut self, title: &str) {
        if let Some(document) = web_sys::window().and_then(|window| window.document()) {
            document.set_title(title);
        }
    }

    fn ask_store(&mut self, request: &Request, bytes: &[u8]) {
        self.store.ask(request, bytes);
    }

    fn new_id(&mut self) -> Id {
        let random = || (js_sys::Math::random() * f64::from(u32::MAX)) as u32;
        format!("{:08x}{:08x}", random(), random())
    }

    fn persist(&mut self) {
        store::persist();
    }

    fn date_ms(&self) -> f64 {
        js_sys::Date::now()
    }

    fn reduces_motion(&self) -> bool {
        self.less_motion.as_ref().is_some_and(web_sys::MediaQueryList::matches)
    }

    fn has_pen(&self) -> bool {
        self.has_pen.get()
    }

    fn draw_on(&mut self, ctx: &egui::Context, device: DeviceInfo) {
        self.inbox.set_ctx(ctx);
        self.device = device;
    }

    fn device(&self) -> DeviceInfo {
        self.device.clone()
    }

    fn now(&self) -> f64 {
        web_sys::window().and_then(|window| window.performance()).map_or(0.0, |clock| clock.now() / 1000.0)
    }
}

/// `None` if the browser allows the page no storage.
fn storage() -> Option<web_sys::Storage> {
    web_sys::window()?.local_storage().ok()?
}

/// What lasts as long as the tab.
fn tab_storage() -> Option<web_sys::Storage> {
    web_sys::window()?.session_storage().ok()?
}

/// A setting that this tab stored before it was reloaded.
pub(crate) fn load_tab_setting(key: &str) -> Option<String> {
    tab_storage()?.get_item(&setting_key(key)).ok()?
}

/// Stores a setting of this tab.
pub(crate) fn store_tab_setting(key: &str, value: &str) {
    // Without it, a reload opens the document that was changed last in any tab, and tries WebGPU again.
    if let Some(storage) = tab_storage() {
        let _ = storage.set_item(&setting_key(key), value);
    }
}

/// A parameter of the page's address.
pub(crate) fn address_parameter(name: &str) -> Option<String> {
    fetch::parameters()?.get(name)
}

fn setting_key(key: &str) -> String {
    format!("meshwright.{key}")
}
