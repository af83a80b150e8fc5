//! Opening projects, with the steps that led to their documents.

use super::Editor;
use super::jobs::WaitingFor;
use crate::document::Origin;
use crate::history::{Change, Step};
use crate::outcome::{self, Outcome};
use crate::project::{ReadProject, Unused};
use crate::recovery::Event;
use halfedge::Mesh;

impl Editor {
    /// Replaces the document by a project, as one step: undo goes back through the steps of the project, then to the
    /// previous document. If the project's steps can't be repeated, its document is opened without them, and the report says
    /// why.
    ///
    /// Costs O(document) and the work of the steps, which is limited to less than a second.
    pub fn open_project(&mut self, read: ReadProject) -> Outcome {
        self.end_edit();
        // Jobs on objects that are removed have nowhere to put their results. Later imports replace the document in turn.
        self.jobs.retain(|job| matches!(job.kind, WaitingFor::Open));
        let ReadProject { project, mut report, is_link } = read;
        self.view = project.view.clone();
        let step = self.number_step();
        let unused =
            Unused { object: self.next_object, revision: self.last_revision + 1, step: self.next_step };
        let limit = self.history_limit();
        let (opened, objects_at_start) = project.repeat(unused, limit).unwrap_or_else(|reason| {
            report.warn(format!("The history of the project was left out: {reason}"));
            (project.without_history(unused, limit), project.document().objects().len())
        });
        let name = opened.document.name.clone();
        let origin = Origin { revision: unused.revision, is_file: !is_link };
        self.adopt(opened, origin, objects_at_start, step);
        let meshes = self.document.objects.iter().map(|object| object.mesh());
        let size = outcome::sizes(meshes.collect::<Vec<&Mesh>>());
        self.say_opened(&name, size, &report)
    }

    /// Lets the steps of a new editor have numbers from this one on.
    pub(crate) fn begin_steps_at(&mut self, number: u64, history_limit: usize) {
        self.next_step = number;
        self.set_history_limit(history_limit);
        self.restart_trail();
    }

    /// Takes over the document and the history of another editor, whose first step came when there were so many objects.
    fn adopt(&mut self, other: Self, origin: Origin, objects_at_start: usize, number: u64) {
        let Self {
            mut document,
            selection,
            history,
            next_object,
            revision,
            last_revision,
            next_step,
            trail,
            ..
        } = other;
        document.origin = origin;
        self.changes.replaced(&self.document.objects, &document.objects);
        let label = format!("Open {}", document.name);
        let old = std::mem::replace(&mut self.document, document);
        let mut back: Vec<Change> = (0..objects_at_start).rev().map(Change::Remove).collect();
        let inserted = old.objects.into_iter().enumerate();
        back.extend(inserted.map(|(at, object)| Change::Insert(at, Box::new(object))));
        back.extend([
            Change::Origin(old.origin),
            Change::DocumentName(old.name),
            Change::Offset(old.offset),
            Change::Materials(old.materials),
            Change::Active(old.active),
        ]);
        let before = std::mem::replace(&mut self.selection, selection);
        let step = Step { label, changes: back, selection: before, revision: self.revision, number };
        self.history.push(step);
        self.history.append(history);
        (self.next_object, self.next_step) = (next_object, next_step);
        (self.revision, self.last_revision, self.saved) = (revision, last_revision, revision);
        (self.last, self.stroke, self.images) = (None, None, Default::default());
        self.counts.get_mut().unwrap_or_else(std::sync::PoisonError::into_inner).clear();
        // The log breaks off here, but the trail is that of the project.
        self.log(Event::Break);
        self.trail = trail;
    }
}
