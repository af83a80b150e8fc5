//! The services that the editor needs from its surroundings: jobs, files, settings. The page implements
//! them with a browser, the tests with [`headless::Headless`].
//!
//! Requests are methods of [`Platform`]; results and everything else that happens come back as [`Event`]s,
//! which are polled once per frame. Code that queues an event outside a frame (a worker's message, a file
//! that finished loading) also requests a repaint.

#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod headless;

use editor::{CommandError, JobRequest, JobResult};
use formats::Format;
pub use formats::NamedBytes;
pub use meshwright_worker::store;

/// The graphics device, as the status bar and the "About Meshwright" window show it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceInfo {
    /// `"webgpu"` or `"webgl2"` on the page: what `meshwright.ready` reports.
    pub renderer: String,
    /// The adapter's name and driver, if the browser tells.
    pub adapter: String,
}

/// Files that were fetched.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Fetched {
    /// The requested models and their companion files.
    pub files: Vec<NamedBytes>,
    /// By what number they can be written again.
    pub source: Option<Source>,
    /// Why companion files are missing: sentences for the import report.
    pub notes: Vec<String>,
}

/// Files that came together and can be written again, by their number.
pub type Source = u32;

/// A file on the user's disk that a document is saved to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlacedFile {
    /// The number of the files that it came with.
    pub source: Source,
    /// Its name.
    pub name: String,
    /// The format that it is written in.
    pub format: Format,
}

impl PlacedFile {
    /// A file of a source; none if a document can't be saved in its format.
    pub fn new(source: Source, name: &str, format: Option<Format>) -> Option<Self> {
        let format = format.filter(|format| format.can_open() && format.can_save())?;
        Some(Self { source, name: name.to_owned(), format })
    }
}

/// What becomes of files that were given to the user.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Download {
    /// They are on their way to the downloads.
    Done,
    /// The user is asked where they go; [`Event::Placed`] follows.
    Asking,
}

/// Files that the user has given a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Their number, by which they can be written again.
    pub source: Source,
    /// Their names.
    pub names: Vec<String>,
    /// What was left out, in sentences.
    pub notes: Vec<String>,
}

/// What happened since the last poll.
#[derive(Debug)]
pub enum Event {
    /// A job's progress changed.
    JobProgress {
        /// The number given to [`Platform::start_job`].
        job: u64,
        /// The completed fraction, 0 to 1.
        fraction: f32,
    },
    /// A job ended. A cancelled job sends no further events.
    JobDone {
        /// The number given to [`Platform::start_job`].
        job: u64,
        /// The result, or why there is none: the operation refused, or the worker failed (it could not
        /// start, ran out of memory, or crashed).
        result: Result<JobResult, CommandError>,
    },
    /// The files of [`Platform::fetch`] have arrived or failed. A cancelled fetch sends no further events.
    Fetched {
        /// The number given to [`Platform::fetch`].
        job: u64,
        /// The files, or a sentence on why a requested one is missing.
        files: Result<Fetched, String>,
    },
    /// Files that the user picked or dropped, completely read.
    Files(Vec<NamedBytes>),
    /// Files that can be saved where they were opened.
    FilesOf(Source, Vec<NamedBytes>),
    /// The files of [`Platform::write_back`] were written, or not, and why.
    Written {
        /// Their names.
        files: Vec<String>,
        /// Why they were not written: the text after "could not be written".
        result: Result<(), String>,
    },
    /// What came of asking where files go, or why they were not written, in a sentence; none if the user changed their mind.
    Placed(Option<Result<Placed, String>>),
    /// The file that was remembered with a kept document.
    Recalled {
        /// The document.
        document: store::Id,
        /// The file, with a number of this visit.
        file: PlacedFile,
    },
    /// A newer version of the page is there.
    UpdateReady,
    /// A sentence on why something the user asked for failed, such as reading a dropped file.
    Failed(String),
    /// The store of documents answered, with these bytes.
    Store(store::Answer, store::Bytes),
    /// The user gave the page's address this fragment, which begins with `#`.
    Fragment(String),
}

/// The editor's surroundings.
pub trait Platform {
    /// The events since the last poll. Called once per frame, before drawing. Files dropped on the page are
    /// in `ctx`'s raw input; the platform reads them.
    fn poll(&mut self, ctx: &egui::Context) -> Vec<Event>;

    /// Runs a job on another thread. Several may be waiting; they run in order.
    fn start_job(&mut self, job: u64, request: &JobRequest);

    /// The addresses of the files to open at the start, as written: the values of `model` in the page's own
    /// address.
    fn wanted(&self) -> Vec<String>;

    /// A parameter of the page's own address: of `?keys=maya`, `keys` is `maya`.
    fn parameter(&self, name: &str) -> Option<String>;

    /// The page's own address without parameters and fragment, which links begin with; none where there is no page.
    fn address(&self) -> Option<String>;

    /// The fragment of the page's own address, from `#` on; empty if there is none.
    fn fragment(&self) -> String;

    /// Removes the fragment from the page's own address.
    fn clear_fragment(&mut self);

    /// Fetches files from the addresses, as the first part of a job.
    fn fetch(&mut self, job: u64, addresses: Vec<String>);

    /// Stops a job, whether it is fetching, running or waiting. It sends no further events.
    fn cancel_job(&mut self, job: u64);

    /// Opens the file dialog; picked files come as [`Event::Files`], or never.
    fn open_file_dialog(&mut self);

    /// Gives files to the user: to their downloads, or where they say.
    fn download(&mut self, files: Vec<NamedBytes>) -> Download;

    /// Whether a source has a file of this name.
    fn can_write(&self, source: Source, name: &str) -> bool;

    /// Asks the user whether the files of a source may be written. Browsers allow it only shortly after a click or a key.
    fn ask_to_write(&mut self, source: Source);

    /// Writes files of a source, once the user allows it. Their fate comes as [`Event::Written`].
    fn write_back(&mut self, source: Source, files: Vec<NamedBytes>);

    /// Remembers for later visits which file a kept document is saved to, or that there is none.
    fn remember_file(&mut self, document: &store::Id, file: Option<&PlacedFile>);

    /// Asks for the file that was remembered with a kept document. If there is one, [`Event::Recalled`] follows.
    fn recall_file(&mut self, document: &store::Id);

    /// Reloads the page with the newer version.
    fn update(&mut self);

    /// Shows the guide outside the editor; false if there is no place for it.
    fn open_guide(&mut self) -> bool {
        false
    }

    /// A setting stored by an earlier visit.
    fn load_setting(&self, key: &str) -> Option<String>;

    /// Stores a small setting for later visits.
    fn store_setting(&mut self, key: &str, value: &str);

    /// A setting stored by this tab before it was reloaded.
    fn load_tab_setting(&self, key: &str) -> Option<String>;

    /// Stores a small setting for this tab, which a reload keeps.
    fn store_tab_setting(&mut self, key: &str, value: &str);

    /// Sets the title of the page.
    fn set_title(&mut self, title: &str);

    /// Asks the store of documents to do something. Requests are carried out in order; answers come as [`Event::Store`].
    fn ask_store(&mut self, request: &store::Request, bytes: &[u8]);

    /// A new identity for a kept document.
    fn new_id(&mut self) -> store::Id;

    /// Asks the browser not to remove what is kept when it needs room.
    fn persist(&mut self);

    /// The time in milliseconds since 1970.
    fn date_ms(&self) -> f64;

    /// Whether the user has asked the system for less motion; may change at any time.
    fn reduces_motion(&self) -> bool;

    /// Whether the user points with a pen; may change at any time.
    fn has_pen(&self) -> bool {
        false
    }

    /// Draws on another device from here on, with another egui.
    fn draw_on(&mut self, ctx: &egui::Context, device: DeviceInfo);

    /// The graphics device.
    fn device(&self) -> DeviceInfo;

    /// Seconds on a monotonic clock, to fractions of a millisecond, for frame times.
    fn now(&self) -> f64;
}
