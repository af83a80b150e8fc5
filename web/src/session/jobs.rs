//! The jobs that run in the worker, as the status bar shows them.

use editor::{JobId, Outcome};
use formats::NamedBytes;

/// What a call that takes a while came to.
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "there is one at a time, and it is moved once")]
pub enum Answer {
    /// A command was carried out, or a file was opened.
    Outcome(Outcome),
    /// Files were written, the one that was asked for first.
    Files(Vec<NamedBytes>),
}

/// Called once with a call's result, or with a sentence that says why it failed.
pub type Reply = Box<dyn FnOnce(Result<Answer, String>)>;

/// A job that was started.
pub struct Running {
    /// Which one.
    pub id: JobId,
    /// What the status bar calls it.
    pub label: String,
    /// How much of it is done; 0 until it says so.
    pub fraction: f32,
    /// When it was first seen waiting, in the seconds that egui counts.
    pub seen: Option<f64>,
    /// Who waits for it besides the person.
    pub reply: Option<Reply>,
    /// The state of the document that is safe once the job is done, where it saves all of it.
    pub saves: Option<u64>,
    /// What is to be told with its result.
    pub notes: Vec<String>,
}

/// The jobs that were started and are waited for, the oldest first.
#[derive(Default)]
pub struct Jobs {
    running: Vec<Running>,
}

impl Jobs {
    /// Adds a job that was just started.
    pub fn add(&mut self, id: JobId, label: String, reply: Option<Reply>) {
        self.running.push(Running {
            id,
            label,
            fraction: 0.0,
            seen: None,
            reply,
            saves: None,
            notes: Vec::new(),
        });
    }

    /// Notes that a job saves the whole document as it is in this state.
    pub fn saves(&mut self, id: JobId, revision: u64) {
        if let Some(running) = self.running.iter_mut().find(|running| running.id == id) {
            running.saves = Some(revision);
        }
    }

    /// Keeps what is to be told with a job's result.
    pub fn note(&mut self, id: JobId, notes: Vec<String>) {
        if let Some(running) = self.running.iter_mut().find(|running| running.id == id) {
            running.notes.extend(notes);
        }
    }

    /// Takes in that a job got further.
    pub fn progress(&mut self, job: u64, fraction: f32) {
        if let Some(running) = self.running.iter_mut().find(|running| running.id.0 == job) {
            // Never back: stages of one operation may each start at 0.
            running.fraction = running.fraction.max(fraction.clamp(0.0, 1.0));
        }
    }

    /// How much of a job is done; 0 of one that isn't there.
    pub fn fraction(&self, id: JobId) -> f32 {
        self.running.iter().find(|running| running.id == id).map_or(0.0, |running| running.fraction)
    }

    /// Takes a job out; none where it was cancelled before.
    pub fn take(&mut self, job: u64) -> Option<Running> {
        let at = self.running.iter().position(|running| running.id.0 == job)?;
        Some(self.running.remove(at))
    }

    /// The jobs, the one that runs first.
    pub fn iter(&self) -> impl Iterator<Item = &Running> {
        self.running.iter()
    }

    /// Notes that a frame was drawn while a job waits: from the first one on its time counts.
    pub fn note_frame(&mut self, now: f64) {
        if let Some(first) = self.running.first_mut() {
            first.seen.get_or_insert(now);
        }
    }

    /// For how many seconds the job that runs has been waited for.
    pub fn waited(&self, now: f64) -> Option<f64> {
        self.running.first().map(|first| now - first.seen.unwrap_or(now))
    }

    /// The latest job: the one that Escape cancels.
    pub fn latest(&self) -> Option<JobId> {
        self.running.last().map(|running| running.id)
    }
}
