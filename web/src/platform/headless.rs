//! A platform without a browser, for tests on the host: jobs run at once, and files are only recorded.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::time::Instant;

use editor::{CommandError, JobRequest, JobResult, Wire};

use crate::platform::store::{Answer, Documents, Id, MemoryDisk, Request, Tab, now_or_never};
use crate::platform::{DeviceInfo, Download, Event, NamedBytes, Platform, Source};

/// The test's side of a headless platform; clones share their state.
#[derive(Clone, Default)]
pub struct Outside {
    inner: Rc<RefCell<Inner>>,
}

#[derive(Default)]
struct Inner {
    events: Vec<Event>,
    downloads: Vec<NamedBytes>,
    dialogs: usize,
    settings: HashMap<String, String>,
    parameters: HashMap<String, String>,
    /// Jobs held back so that a test can examine their progress.
    held: Option<Vec<(u64, Vec<u8>)>>,
    cancelled: Vec<u64>,
    wanted: Vec<String>,
    fragment: String,
    reduces_motion: bool,
    fetches: Vec<(u64, Vec<String>)>,
    disk: MemoryDisk,
    /// The settings of each tab.
    tabs: HashMap<u64, HashMap<String, String>>,
    /// The tab that a page opens in.
    tab: u64,
    ids: u64,
    persists: usize,
    /// Whether the store takes requests and does nothing.
    store_hangs: bool,
    /// How often the store is still to end when it is asked for something.
    store_crashes: usize,
    date_ms: f64,
    /// The names of the files of each source.
    sources: Vec<Vec<String>>,
    written: Vec<NamedBytes>,
    /// Why files can't be written.
    refuses_writes: Option<String>,
    updates: usize,
    title: String,
    guides: usize,
    has_no_guide: bool,
    /// Whether the user is asked where files go.
    asks_where: bool,
}

impl Outside {
    /// Opens files that can be written again.
    pub fn open_writable(&self, files: Vec<NamedBytes>) {
        let source = {
            let mut inner = self.inner.borrow_mut();
            inner.sources.push(files.iter().map(|file| file.name.clone()).collect());
            inner.sources.len() as Source - 1
        };
        self.push(Event::FilesOf(source, files));
    }

    /// The files written where they were opened so far.
    pub fn written(&self) -> Vec<NamedBytes> {
        self.inner.borrow().written.clone()
    }

    /// Refuses to write files from now on.
    pub fn refuse_writes(&self, reason: &str) {
        self.inner.borrow_mut().refuses_writes = Some(reason.to_owned());
    }

    /// Asks the user where files go from now on. The test pushes [`Event::Placed`].
    pub fn ask_where(&self) {
        self.inner.borrow_mut().asks_where = true;
    }

    /// How often the page was reloaded with a newer version.
    pub fn updates(&self) -> usize {
        self.inner.borrow().updates
    }

    /// How often the guide was opened.
    pub fn guides(&self) -> usize {
        self.inner.borrow().guides
    }

    /// Leaves the guide no place to open in.
    pub fn take_guide_away(&self) {
        self.inner.borrow_mut().has_no_guide = true;
    }

    /// The disk with the documents that the browser keeps.
    pub fn disk(&self) -> MemoryDisk {
        self.inner.borrow().disk.clone()
    }

    /// Makes the next page open in another tab.
    pub fn open_in_new_tab(&self) {
        self.inner.borrow_mut().tab += 1;
    }

    /// How often the page asked that what is kept not be removed.
    pub fn persists(&self) -> usize {
        self.inner.borrow().persists
    }

    /// Lets the store take requests and do nothing.
    pub fn hang_store(&self) {
        self.inner.borrow_mut().store_hangs = true;
    }

    /// The title of the page.
    pub fn title(&self) -> String {
        self.inner.borrow().title.clone()
    }

    /// Lets the store end the next times that it is asked for something.
    pub fn crash_store(&self, times: usize) {
        self.inner.borrow_mut().store_crashes = times;
    }

    /// Lets time go by.
    pub fn advance(&self, milliseconds: f64) {
        self.inner.borrow_mut().date_ms += milliseconds;
    }

    /// Queues an event for the next frame.
    pub fn push(&self, event: Event) {
        self.inner.borrow_mut().events.push(event);
    }

    /// The files downloaded so far.
    pub fn downloads(&self) -> Vec<NamedBytes> {
        self.inner.borrow().downloads.clone()
    }

    /// The number of times the file dialog was opened.
    pub fn dialogs(&self) -> usize {
        self.inner.borrow().dialogs
    }

    /// A stored setting.
    pub fn setting(&self, key: &str) -> Option<String> {
        self.inner.borrow().settings.get(key).cloned()
    }

    /// Stores a setting, like an earlier visit.
    pub fn set_setting(&self, key: &str, value: &str) {
        self.inner.borrow_mut().settings.insert(key.to_owned(), value.to_owned());
    }

    /// Gives the page's address a parameter.
    pub fn set_parameter(&self, name: &str, value: &str) {
        self.inner.borrow_mut().parameters.insert(name.to_owned(), value.to_owned());
    }

    /// Gives the page's address a fragment, before the page opens.
    pub fn set_fragment(&self, fragment: &str) {
        self.inner.borrow_mut().fragment = fragment.to_owned();
    }

    /// The fragment of the page's address.
    pub fn fragment(&self) -> String {
        self.inner.borrow().fragment.clone()
    }

    /// Asks for less motion, or no longer.
    pub fn reduce_motion(&self, reduces: bool) {
        self.inner.borrow_mut().reduces_motion = reduces;
    }

    /// Holds back jobs from now on.
    pub fn hold_jobs(&self) {
        self.inner.borrow_mut().held = Some(Vec::new());
    }

    /// Makes the page open with a file from this address.
    pub fn want(&self, address: &str) {
        self.inner.borrow_mut().wanted.push(address.to_owned());
    }

    /// The requested fetches: job and addresses.
    pub fn fetches(&self) -> Vec<(u64, Vec<String>)> {
        self.inner.borrow().fetches.clone()
    }

    /// The jobs that were cancelled.
    pub fn cancelled(&self) -> Vec<u64> {
        self.inner.borrow().cancelled.clone()
    }

    /// Runs the jobs that were held back, and runs later ones at once again.
    pub fn release_jobs(&self) {
        let held = self.inner.borrow_mut().held.take().unwrap_or_default();
        for (job, request) in held {
            self.push(run(job, &request));
        }
    }
}

fn run(job: u64, request: &[u8]) -> Event {
    let result = JobRequest::from_bytes(request)
        .map_err(|error| CommandError::refused("job", error.to_string()))
        .and_then(|request| request.run(&mut |_| ControlFlow::Continue(())))
        .and_then(|result| {
            JobResult::from_bytes(&result.to_bytes())
                .map_err(|error| CommandError::refused("job", error.to_string()))
        });
    Event::JobDone { job, result }
}

/// The platform itself.
pub struct Headless {
    outside: Outside,
    started: Instant,
    tab: u64,
    documents: Documents<Tab>,
}

impl Headless {
    /// A platform whose state `outside` shares.
    pub fn new(outside: Outside) -> Self {
        let (tab, disk) = (outside.inner.borrow().tab, outside.disk());
        Self { outside, started: Instant::now(), tab, documents: Documents::new(disk.tab()) }
    }
}

impl Platform for Headless {
    fn poll(&mut self, _ctx: &egui::Context) -> Vec<Event> {
        std::mem::take(&mut self.outside.inner.borrow_mut().events)
    }

    fn start_job(&mut self, job: u64, request: &JobRequest) {
        // Through bytes, as on the way to a worker.
        let request = request.to_bytes();
        if let Some(held) = &mut self.outside.inner.borrow_mut().held {
            held.push((job, request));
            return;
        }
        self.outside.push(run(job, &request));
    }

    fn wanted(&self) -> Vec<String> {
        self.outside.inner.borrow().wanted.clone()
    }

    fn parameter(&self, name: &str) -> Option<String> {
        self.outside.inner.borrow().parameters.get(name).cloned()
    }

    fn address(&self) -> Option<String> {
        Some("https://example.org/meshwright/".to_owned())
    }

    fn fragment(&self) -> String {
        self.outside.fragment()
    }

    fn clear_fragment(&mut self) {
        self.outside.set_fragment("");
    }

    fn fetch(&mut self, job: u64, addresses: Vec<String>) {
        self.outside.inner.borrow_mut().fetches.push((job, addresses));
    }

    fn cancel_job(&mut self, job: u64) {
        let mut inner = self.outside.inner.borrow_mut();
        inner.cancelled.push(job);
        if let Some(held) = &mut inner.held {
            held.retain(|(id, _)| *id != job);
        }
    }

    fn open_file_dialog(&mut self) {
        self.outside.inner.borrow_mut().dialogs += 1;
    }

    fn download(&mut self, files: Vec<NamedBytes>) -> Download {
        let mut inner = self.outside.inner.borrow_mut();
        inner.downloads.extend(files);
        if inner.asks_where { Download::Asking } else { Download::Done }
    }

    fn can_write(&self, source: Source, name: &str) -> bool {
        let inner = self.outside.inner.borrow();
        inner.sources.get(source as usize).is_some_and(|names| names.iter().any(|own| own == name))
    }

    fn ask_to_write(&mut self, _source: Source) {}

    fn write_back(&mut self, _source: Source, files: Vec<NamedBytes>) {
        let names = files.iter().map(|file| file.name.clone()).collect();
        let mut inner = self.outside.inner.borrow_mut();
        let result = match inner.refuses_writes.clone() {
            Some(reason) => Err(reason),
            None => {
                inner.written.extend(files);
                Ok(())
            }
        };
        inner.events.push(Event::Written { files: names, result });
    }

    fn update(&mut self) {
        self.outside.inner.borrow_mut().updates += 1;
    }

    fn open_guide(&mut self) -> bool {
        let mut inner = self.outside.inner.borrow_mut();
        let opens = !inner.has_no_guide;
        inner.guides += usize::from(opens);
        opens
    }

    fn load_setting(&self, key: &str) -> Option<String> {
        self.outside.setting(key)
    }

    fn store_setting(&mut self, key: &str, value: &str) {
        self.outside.inner.borrow_mut().settings.insert(key.to_owned(), value.to_owned());
    }

    fn load_tab_setting(&self, key: &str) -> Option<String> {
        self.outside.inner.borrow().tabs.get(&self.tab)?.get(key).cloned()
    }

    fn store_tab_setting(&mut self, key: &str, value: &str) {
        let mut inner = self.outside.inner.borrow_mut();
        inner.tabs.entry(self.tab).or_default().insert(key.to_owned(), value.to_owned());
    }

    fn set_title(&mut self, title: &str) {
        title.clone_into(&mut self.outside.inner.borrow_mut().title);
    }

    fn ask_store(&mut self, request: &Request, bytes: &[u8]) {
        let outside = self.outside.clone();
        if outside.inner.borrow().store_hangs {
            return;
        }
        if outside.inner.borrow().store_crashes > 0 {
            outside.inner.borrow_mut().store_crashes -= 1;
            // Its locks end with it.
            self.documents = Documents::new(outside.disk().tab());
            outside.push(Event::Store(Answer::Crashed("it has crashed".to_owned()), Vec::new()));
            return;
        }
        let mut tell = |answer, bytes| outside.push(Event::Store(answer, bytes));
        let handled = now_or_never(self.documents.handle(request.clone(), bytes, &mut tell));
        // A disk in memory never waits.
        debug_assert!(handled.is_some());
    }

    fn new_id(&mut self) -> Id {
        let mut inner = self.outside.inner.borrow_mut();
        inner.ids += 1;
        format!("document{}", inner.ids)
    }

    fn persist(&mut self) {
        self.outside.inner.borrow_mut().persists += 1;
    }

    fn date_ms(&self) -> f64 {
        self.outside.inner.borrow().date_ms
    }

    fn reduces_motion(&self) -> bool {
        self.outside.inner.borrow().reduces_motion
    }

    fn draw_on(&mut self, _ctx: &egui::Context, _device: DeviceInfo) {}

    fn device(&self) -> DeviceInfo {
        DeviceInfo { renderer: "host".to_owned(), adapter: String::new() }
    }

    fn now(&self) -> f64 {
        self.started.elapsed().as_secs_f64() + self.outside.inner.borrow().date_ms / 1000.0
    }
}
