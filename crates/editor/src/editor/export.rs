//! Jobs that write files.

use super::Editor;
use super::jobs::WaitingFor;
use crate::document::ObjectId;
use crate::job::{ExportHead, JobRequest, Work};
use crate::project::{Link, Project};
use formats::Format;

impl Editor {
    /// A job that writes the document's objects to files of a format, named after the document; a project holds the rest of the
    /// document too. An ongoing
    /// edit of elements is written as shown and continues; the preview of an operation is cancelled.
    pub fn begin_export(&mut self, format: Format) -> JobRequest {
        self.begin_export_as(format, self.document.name.clone())
    }

    /// A job that makes a link to the document; none if it is too large for any. An ongoing edit is in it as shown; the
    /// preview of an operation is cancelled.
    pub fn begin_share(&mut self) -> Option<JobRequest> {
        self.finish_parts();
        if self.is_previewing_mesh() {
            self.cancel_edit();
        }
        if !Link::may_hold(self) {
            return None;
        }
        let id = self.wait_for(WaitingFor::Share);
        Some(JobRequest { id, work: Work::Share(Box::new(Project::of(self))) })
    }

    /// [`Editor::begin_export`] under another file name, given without an extension.
    pub fn begin_export_as(&mut self, format: Format, name: String) -> JobRequest {
        self.finish_parts();
        if self.is_previewing_mesh() {
            self.cancel_edit();
        }
        if format.is_project() {
            let id = self.wait_for(WaitingFor::Export);
            return JobRequest { id, work: Work::Save(Box::new(Project::of(self).named(&name))) };
        }
        let objects: Vec<ObjectId> = self.document.objects().iter().map(|object| object.id()).collect();
        let id = self.wait_for(WaitingFor::Export);
        let head = ExportHead {
            format,
            name,
            offset: self.document.offset,
            materials: self.document.materials.clone(),
        };
        JobRequest { id, work: Work::Export(head, self.inputs(&objects)) }
    }
}
