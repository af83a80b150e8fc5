//! What the editor needs from where it runs: jobs, files, settings. The page implements it with a
//! browser, the tests with [`headless::Headless`].
//!
//! Requests go down through [`Platform`]'s methods; everything that happens meanwhile comes back as
//! [`Event`]s, polled once a frame. Whoever queues an event outside a frame (a worker's message, a
//! file that finished loading) asks for a repaint itself.

#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(not(target_arch = "wasm32"))]
pub mod headless;

use editor::{CommandError, JobRequest, JobResult};
pub use formats::NamedBytes;

/// The graphics device, as the status bar and the "About this device" window show it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceInfo {
    /// `"webgpu"` or `"webgl2"` on the page: what `meshwright.ready` reports.
    pub renderer: String,
    /// The adapter's name and driver, as far as the browser tells.
    pub adapter: String,
}

/// Files that were fetched.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Fetched {
    /// The models that were asked for, and the files beside them that belong to them.
    pub files: Vec<NamedBytes>,
    /// Why files that belong to them are not here: sentences for the report of the import.
    pub notes: Vec<String>,
}

/// What happened since the last poll.
#[derive(Debug)]
pub enum Event {
    /// A job got further: 0 to 1.
    JobProgress {
        /// The number given to [`Platform::start_job`].
        job: u64,
        /// How much is done.
        fraction: f32,
    },
    /// A job ended by itself. A job that was cancelled sends nothing more.
    JobDone {
        /// The number given to [`Platform::start_job`].
        job: u64,
        /// The result; or why there is none: the operation's refusal, or that the worker itself failed
        /// (it could not start, ran out of memory, crashed).
        result: Result<JobResult, CommandError>,
    },
    /// What [`Platform::fetch`] was to fetch is here, or can't be had: a sentence. Fetching that was
    /// cancelled sends nothing more.
    Fetched {
        /// The number given to [`Platform::fetch`].
        job: u64,
        /// The files, or why one that was asked for is missing.
        files: Result<Fetched, String>,
    },
    /// Files arrived whole: picked or dropped.
    Files(Vec<NamedBytes>),
    /// Something the person asked for could not be done, such as reading a dropped file: a sentence.
    Failed(String),
}

/// Where the editor runs.
pub trait Platform {
    /// What happened since the last poll. Called once a frame, before any drawing; files dropped on
    /// the page are in `ctx`'s raw input, reading them is up to the platform.
    fn poll(&mut self, ctx: &egui::Context) -> Vec<Event>;

    /// Runs a job away from this thread. Several may be waiting; they run in order.
    fn start_job(&mut self, job: u64, request: &JobRequest);

    /// The addresses of the files that the page was asked to open with, as they were written: each
    /// `model` of the page's own address.
    fn wanted(&self) -> Vec<String>;

    /// Fetches files from the addresses, as the first part of a job.
    fn fetch(&mut self, job: u64, addresses: Vec<String>);

    /// Stops a job, whether it is fetched for, runs or waits. Nothing more comes from it.
    fn cancel_job(&mut self, job: u64);

    /// Lets the person pick files; they come as [`Event::Files`], or never.
    fn open_file_dialog(&mut self);

    /// Saves files where the person's downloads go.
    fn download(&mut self, files: Vec<NamedBytes>);

    /// A setting kept from an earlier visit.
    fn load_setting(&self, key: &str) -> Option<String>;

    /// Keeps a small setting for later visits.
    fn store_setting(&mut self, key: &str, value: &str);

    /// The graphics device.
    fn device(&self) -> DeviceInfo;

    /// Seconds on a clock that never goes back, to fractions of a millisecond: for frame times.
    fn now(&self) -> f64;
}
