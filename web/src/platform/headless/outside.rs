//! What a test does to a headless platform, and sees of it.

use std::cell::RefCell;
use std::collections::{HashMap, VecDeque};
use std::rc::Rc;

use super::run;
use crate::platform::store::{Id, MemoryDisk};
use crate::platform::{Event, NamedBytes, PlacedFile, Source};

/// The test's side of a headless platform; clones share their state.
#[derive(Clone, Default)]
pub struct Outside {
    pub(super) inner: Rc<RefCell<Inner>>,
}

#[derive(Default)]
pub(super) struct Inner {
    pub(super) events: Vec<Event>,
    pub(super) downloads: Vec<NamedBytes>,
    pub(super) dialogs: usize,
    pub(super) settings: HashMap<String, String>,
    pub(super) parameters: HashMap<String, String>,
    /// Jobs held back so that a test can examine their progress.
    pub(super) held: Option<Vec<(u64, Vec<u8>)>>,
    pub(super) cancelled: Vec<u64>,
    pub(super) wanted: Vec<String>,
    pub(super) fragment: String,
    pub(super) reduces_motion: bool,
    pub(super) has_pen: bool,
    pub(super) fetches: Vec<(u64, Vec<String>)>,
    pub(super) disk: MemoryDisk,
    /// The settings of each tab.
    pub(super) tabs: HashMap<u64, HashMap<String, String>>,
    /// The tab that a page opens in.
    pub(super) tab: u64,
    pub(super) ids: u64,
    pub(super) persists: usize,
    /// Whether the store takes requests and does nothing.
    pub(super) store_hangs: bool,
    /// How often the store is still to end when it is asked for something.
    pub(super) store_crashes: usize,
    pub(super) date_ms: f64,
    /// Whether the clock of frames goes on by itself.
    pub(super) is_timed: bool,
    /// The names of the files of each source.
    pub(super) sources: Vec<Vec<String>>,
    /// The files that kept documents are saved to.
    pub(super) files: HashMap<Id, PlacedFile>,
    pub(super) written: Vec<NamedBytes>,
    /// Why files can't be written.
    pub(super) refuses_writes: Option<String>,
    pub(super) held_writes: Option<VecDeque<Event>>,
    pub(super) updates: usize,
    pub(super) title: String,
    pub(super) guides: usize,
    pub(super) has_no_guide: bool,
    /// Whether the user is asked where files go.
    pub(super) asks_where: bool,
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

    /// Makes the pointer a pen, or no pen.
    pub fn point_with_pen(&self, has_pen: bool) {
        self.inner.borrow_mut().has_pen = has_pen;
    }

    /// The files written where they were opened so far.
    pub fn written(&self) -> Vec<NamedBytes> {
        self.inner.borrow().written.clone()
    }

    /// Holds back word of written files from now on.
    pub fn hold_writes(&self) {
        self.inner.borrow_mut().held_writes = Some(VecDeque::new());
    }

    /// Lets the page know of the next file that was written.
    pub fn release_write(&self) {
        let mut inner = self.inner.borrow_mut();
        let event = inner.held_writes.as_mut().and_then(VecDeque::pop_front);
        inner.events.extend(event);
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

    /// Lets the store take requests and do nothing, or lets it carry them out with the next one.
    pub fn hang_store(&self, hangs: bool) {
        self.inner.borrow_mut().store_hangs = hangs;
    }

    /// The title of the page.
    pub fn title(&self) -> String {
        self.inner.borrow().title.clone()
    }

    /// Lets the store end the next times that it is asked for something.
    pub fn crash_store(&self, times: usize) {
        self.inner.borrow_mut().store_crashes = times;
    }

    /// Lets the clock of frames go on by itself.
    pub fn start_clock(&self) {
        self.inner.borrow_mut().is_timed = true;
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
