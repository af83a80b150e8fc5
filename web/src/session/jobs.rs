//! The jobs in the worker, as the status bar shows them.

use editor::{JobId, Outcome};
use formats::NamedBytes;

/// The result of a call that may take a while.
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "there is one at a time, and it is moved once")]
pub enum Answer {
    /// A command was carried out, or a file was opened.
    Outcome(Outcome),
    /// Files were written; the model's own file comes first.
    Files(Vec<NamedBytes>),
}

/// Called once with a call's result, or with a sentence that says why it failed.
pub type Reply = Box<dyn FnOnce(Result<Answer, String>)>;

/// A job that has started.
pub struct Running {
    /// The job's id.
    pub id: JobId,
    /// The label in the status bar.
    pub label: String,
    /// When it was started, on the platform's clock in seconds.
    pub started: f64,
    /// The completed fraction; 0 until the job reports progress.
    pub fraction: f32,
    /// The time at which the job was first seen waiting, on egui's clock in seconds.
    pub seen: Option<f64>,
    /// The caller that waits for the result besides the user.
    pub reply: Option<Reply>,
    /// The revision of the document that is saved once the job is done, if opening the files brings back all of it.
    pub saves: Option<u64>,
    /// Notes to show with the result.
    pub notes: Vec<String>,
}

/// The jobs that have not finished, the oldest first.
#[derive(Default)]
pub struct Jobs {
    running: Vec<Running>,
}

impl Jobs {
    /// Adds a job that has just started.
    pub fn add(&mut self, id: JobId, label: String, reply: Option<Reply>, started: f64) {
        self.running.push(Running {
            id,
            label,
            started,
            fraction: 0.0,
            seen: None,
            reply,
            saves: None,
            notes: Vec::new(),
        });
    }

    /// Records that a job saves the whole document at this revision.
    pub fn set_saved_revision(&mut self, id: JobId, revision: u64) {
        if let Some(running) = self.running.iter_mut().find(|running| running.id == id) {
            running.saves = Some(revision);
        }
    }

    /// Keeps notes to show with a job's result.
    pub fn note(&mut self, id: JobId, notes: Vec<String>) {
        if let Some(running) = self.running.iter_mut().find(|running| running.id == id) {
            running.notes.extend(notes);
        }
    }

    /// Records a job's progress.
    pub fn progress(&mut self, job: u64, fraction: f32) {
        if let Some(running) = self.running.iter_mut().find(|running| running.id.0 == job) {
            // The fraction never decreases: stages of one operation may each start at 0.
            running.fraction = running.fraction.max(fraction.clamp(0.0, 1.0));
        }
    }

    /// The completed fraction of a job; 0 if there is no such job.
    pub fn fraction(&self, id: JobId) -> f32 {
        self.running.iter().find(|running| running.id == id).map_or(0.0, |running| running.fraction)
    }

    /// Removes and returns a job; none if it was cancelled.
    pub fn take(&mut self, job: u64) -> Option<Running> {
        let at = self.running.iter().position(|running| running.id.0 == job)?;
        Some(self.running.remove(at))
    }

    /// The jobs, starting with the running one.
    pub fn iter(&self) -> impl Iterator<Item = &Running> {
        self.running.iter()
    }

    /// Records that a frame was drawn while a job waits; waiting time counts from the first such frame.
    pub fn note_frame(&mut self, now: f64) {
        if let Some(first) = self.running.first_mut() {
            first.seen.get_or_insert(now);
        }
    }

    /// For how many seconds the user has waited for the running job.
    pub fn waited(&self, now: f64) -> Option<f64> {
        self.running.first().map(|first| now - first.seen.unwrap_or(now))
    }

    /// The latest job, which Escape cancels.
    pub fn latest(&self) -> Option<JobId> {
        self.running.last().map(|running| running.id)
    }
}
