//! What comes of commands and jobs.

use crate::Task;
use crate::job::{JobId, JobRequest};
use crate::outcome::Outcome;
use crate::project::Link;
use formats::{NamedBytes, Picture};

/// The result of beginning a command.
#[derive(Debug)]
pub enum Begun {
    /// The command is done.
    Done(Outcome),
    /// The command looks for elements in a large mesh: [`crate::Editor::select_some`] continues.
    Selecting,
    /// The command takes long: run this job anywhere and pass its result to [`crate::Editor::finish`].
    Job(JobRequest),
}

/// The result of finishing a job.
#[derive(Debug)]
#[allow(
    clippy::large_enum_variant,
    reason = "there is one at a time, and it is taken apart at once; small on wasm32"
)]
pub enum Finished {
    /// A command was carried out, or a file opened.
    Done(Outcome),
    /// Files were written and are ready to be saved.
    Exported(Vec<NamedBytes>),
    /// A link was made.
    Shared(Link),
    /// An image was decoded.
    Decoded(Picture),
}

/// A job that has begun and has not finished.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunningJob {
    /// The job's id.
    pub id: JobId,
    /// What it does.
    pub task: Task,
}
