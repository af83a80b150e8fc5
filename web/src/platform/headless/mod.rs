//! A platform without a browser, for tests on the host: jobs run at once, and files are only recorded.

mod outside;

use std::ops::ControlFlow;
use std::time::Instant;

use editor::{CommandError, JobRequest, JobResult, Wire};

pub use outside::Outside;

use crate::platform::store::{Answer, Documents, Id, Request, Tab, now_or_never};
use crate::platform::{DeviceInfo, Download, Event, NamedBytes, PlacedFile, Platform, Source};

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
    /// The requests that the store has not carried out yet.
    requests: Vec<(Request, Vec<u8>)>,
}

impl Headless {
    /// A platform whose state `outside` shares.
    pub fn new(outside: Outside) -> Self {
        let (tab, disk) = (outside.inner.borrow().tab, outside.disk());
        let (documents, requests) = (Documents::new(disk.tab()), Vec::new());
        Self { outside, started: Instant::now(), tab, documents, requests }
    }
}

impl Drop for Headless {
    /// What happens for a page that has ended, nobody hears.
    fn drop(&mut self) {
        self.outside.inner.borrow_mut().events.clear();
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
        let event = Event::Written { files: names, result };
        match &mut inner.held_writes {
            Some(held) => held.push_back(event),
            None => inner.events.push(event),
        }
    }

    fn remember_file(&mut self, document: &Id, file: Option<&PlacedFile>) {
        let files = &mut self.outside.inner.borrow_mut().files;
        match file {
            Some(file) => drop(files.insert(document.clone(), file.clone())),
            None => drop(files.remove(document)),
        }
    }

    fn recall_file(&mut self, document: &Id) {
        let file = self.outside.inner.borrow().files.get(document).cloned();
        if let Some(file) = file {
            self.outside.push(Event::Recalled { document: document.clone(), file });
        }
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
        self.requests.push((request.clone(), bytes.to_vec()));
        if outside.inner.borrow().store_hangs {
            return;
        }
        if outside.inner.borrow().store_crashes > 0 {
            outside.inner.borrow_mut().store_crashes -= 1;
            self.requests.clear();
            // Its locks end with it.
            self.documents = Documents::new(outside.disk().tab());
            outside.push(Event::Store(Answer::Crashed("it has crashed".to_owned()), Vec::new()));
            return;
        }
        let mut tell = |answer, bytes| outside.push(Event::Store(answer, bytes));
        for (request, bytes) in std::mem::take(&mut self.requests) {
            let handled = now_or_never(self.documents.handle(request, &bytes, &mut tell));
            debug_assert!(handled.is_some(), "a disk in memory never waits");
        }
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

    fn has_pen(&self) -> bool {
        self.outside.inner.borrow().has_pen
    }

    fn draw_on(&mut self, _ctx: &egui::Context, _device: DeviceInfo) {}

    fn device(&self) -> DeviceInfo {
        DeviceInfo { renderer: "host".to_owned(), adapter: String::new() }
    }

    fn now(&self) -> f64 {
        let inner = self.outside.inner.borrow();
        // Otherwise how much is done in a frame would depend on the load of the machine.
        let elapsed = if inner.is_timed { self.started.elapsed().as_secs_f64() } else { 0.0 };
        elapsed + inner.date_ms / 1000.0
    }
}
