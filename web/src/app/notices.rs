//! What scripts are told about, if they subscribe to it.

use editor::Changes;
use serde_json::{Value, json};

use crate::session::Session;

/// Something that scripts can subscribe to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notice {
    /// The document changed.
    Change,
    /// Something else is selected.
    Selection,
    /// A job began, went on or ended.
    Job,
}

impl Notice {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Change, Self::Selection, Self::Job];

    /// What scripts call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Change => "change",
            Self::Selection => "selection",
            Self::Job => "job",
        }
    }

    /// The notice of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|notice| notice.name() == name)
    }
}

/// What happened since scripts were told.
#[derive(Default)]
pub(super) struct Notices {
    change: bool,
    selection: bool,
    job: bool,
}

impl Notices {
    /// Forgets what happened, and gives it with a few words on how things are now. Costs O(jobs).
    pub fn take(&mut self, session: &Session) -> Vec<(Notice, Value)> {
        let Self { change, selection, job } = std::mem::take(self);
        let happened = [(change, Notice::Change), (selection, Notice::Selection), (job, Notice::Job)];
        let notices = happened.into_iter().filter(|(happened, _)| *happened);
        notices.map(|(_, notice)| (notice, describe(notice, session))).collect()
    }

    /// Notes what changed in the editor.
    pub fn note(&mut self, changes: &Changes) {
        self.change |= changes.document || changes.materials || !changes.objects.is_empty();
        self.selection |= changes.selection;
        self.job |= changes.jobs;
    }

    /// Notes that a job went on.
    pub fn note_progress(&mut self) {
        self.job = true;
    }
}

fn describe(notice: Notice, session: &Session) -> Value {
    let editor = &session.editor;
    match notice {
        Notice::Change => json!({
            "name": editor.document().name(),
            "dirty": editor.is_dirty(),
            "last": editor.undo_labels().last(),
        }),
        Notice::Selection => {
            let selection = editor.selection();
            json!({ "kind": editor::element_name(selection.kind()), "count": selection.len() })
        }
        Notice::Job => {
            let jobs = editor.jobs();
            let jobs =
                jobs.map(|job| json!({ "progress": session.jobs.fraction(job.id), "op": job.task.name() }));
            json!({ "jobs": jobs.collect::<Vec<_>>() })
        }
    }
}
