//! The preview of an operation while its form is filled in; it is not an undo step yet.

use editor::{CommandError, Facts, OpId, Outcome};
use halfedge::{Element, Mesh};

use super::form::{self, Filled};
use crate::session::Session;

/// The longest time in seconds that a preview may take to be updated at every step of a spin box.
pub(crate) const MAX_SECONDS_PER_STEP: f64 = 0.03;

/// The result of the last request for a preview.
#[derive(Default)]
pub(crate) struct Previewing {
    shown: Option<Preview>,
    /// Why there is no preview.
    why_not: Option<WhyNot>,
    /// Whether the last preview took too long to be updated at every step of a spin box.
    pub is_slow: bool,
}

/// A previewed operation.
pub(crate) struct Preview {
    pub id: OpId,
    filled: Filled,
    outcome: Outcome,
    /// The facts about the mesh without the preview.
    pub before: Facts,
    /// Whether ids refer to the same elements with the preview and without.
    keeps_ids: bool,
}

/// Why there is no preview.
#[derive(Clone)]
pub(crate) enum WhyNot {
    TooLarge,
    Refused(String),
}

impl Session {
    /// The preview that the document shows.
    pub fn preview(&self) -> Option<&Preview> {
        // Any other change has removed the preview.
        self.previewing.shown.as_ref().filter(|_| self.editor.is_previewing_mesh())
    }

    /// Why there is no preview.
    pub fn why_no_preview(&self) -> Option<&WhyNot> {
        self.previewing.why_not.as_ref()
    }

    /// Forgets why there is no preview.
    pub fn forget_refused_preview(&mut self) {
        self.previewing.why_not = None;
    }

    /// The result of an operation with these fields, if it is previewed.
    pub fn previewed(&self, id: OpId, filled: &Filled) -> Option<&Mesh> {
        self.preview().filter(|preview| preview.id == id && preview.filled == *filled)?;
        self.editor.mesh()
    }

    /// Removes the preview. If there was one, returns whether ids refer to the same elements as before.
    pub fn end_preview(&mut self) -> Option<bool> {
        let keeps_ids = self.preview()?.keeps_ids;
        self.previewing.shown = None;
        self.editor.cancel_edit();
        Some(keeps_ids)
    }

    /// Makes the preview one undo step, if it is of this operation with these fields.
    pub fn apply_preview(&mut self, id: OpId, filled: &Filled) -> bool {
        if self.previewed(id, filled).is_none() {
            return false;
        }
        self.editor.commit_edit();
        if let Some(Preview { outcome, .. }) = self.previewing.shown.take()
            && !outcome.warnings.is_empty()
        {
            self.warn(outcome.message, outcome.warnings);
        }
        true
    }

    /// Previews an operation in place of the last preview.
    pub fn show_preview(&mut self, id: OpId, filled: Filled) {
        let started = self.platform.now();
        let before = self.measured_facts();
        self.end_preview();
        self.end_live(true);
        self.previewing.why_not = self.try_preview(id, filled, before).err();
        self.previewing.is_slow = self.platform.now() - started > MAX_SECONDS_PER_STEP;
    }

    fn try_preview(&mut self, id: OpId, filled: Filled, before: Facts) -> Result<(), WhyNot> {
        let refused = |error: CommandError| WhyNot::Refused(error.reason());
        let command = form::command(id, &filled).map_err(refused)?.mirrored(self.live_settings.symmetry);
        self.editor.can(&command).map_err(refused)?;
        if !self.editor.is_quick(&command) {
            return Err(WhyNot::TooLarge);
        }
        let sizes_before = self.editor.mesh().map(sizes);
        let started = self.platform.now();
        let outcome = self.editor.update_edit(command).map_err(refused)?;
        self.edit_seconds = self.platform.now() - started;
        let keeps_ids = self.editor.mesh().map(sizes) == sizes_before;
        self.previewing.shown = Some(Preview { id, filled, outcome, before, keeps_ids });
        Ok(())
    }
}

fn sizes(mesh: &Mesh) -> [usize; 4] {
    Element::ALL.map(|kind| mesh.capacity(kind))
}
