//! Live preview: what the form's operation makes is shown in the document while its fields are filled
//! in, where that is cheap. Applying keeps it as one undo step; anything else takes it back.

use egui::{Checkbox, Label, RichText, Ui};
use halfedge::{Element, Mesh};

use crate::app::App;
use crate::panels::QUICK;
use crate::panels::fields::{self, Filled};
use editor::{Facts, MessageKind, OpId, Outcome};

/// The previews of forms.
pub(crate) struct Previews {
    /// Whether the person wants any.
    on: bool,
    /// The form was opened or a field was changed, and what that makes is yet to be shown.
    due: bool,
    shown: Option<Trial>,
    /// Why nothing is shown.
    why_not: Option<WhyNot>,
    /// The last one took too long to be made at every step of a spin.
    slow: bool,
    /// The form was on the screen in this frame.
    seen: bool,
}

impl Default for Previews {
    fn default() -> Self {
        Self { on: true, due: false, shown: None, why_not: None, slow: false, seen: false }
    }
}

/// An operation that the document shows, and that is no step yet.
struct Trial {
    op: OpId,
    filled: Filled,
    outcome: Outcome,
    /// What the mesh is without it.
    before: Facts,
    /// The ids of elements mean the same with it and without.
    keeps_ids: bool,
}

enum WhyNot {
    TooLarge,
    Refused(String),
}

impl Previews {
    /// Shows a preview as soon as there can be one.
    pub fn ask(&mut self) {
        self.due = true;
    }
}

fn sizes(mesh: &Mesh) -> [usize; 4] {
    Element::ALL.map(|kind| mesh.capacity(kind))
}

impl App {
    fn trial(&self) -> Option<&Trial> {
        // Whatever else was done has taken it back.
        self.forms.previews.shown.as_ref().filter(|_| self.editor.is_previewing_mesh())
    }

    /// What the mesh is without what is only previewed.
    pub(crate) fn facts_before_preview(&self) -> Option<Facts> {
        self.trial().map(|trial| trial.before)
    }

    /// The mesh that an operation with these fields makes, where it is previewed.
    pub(crate) fn previewed(&self, op: OpId, filled: &Filled) -> Option<&Mesh> {
        self.trial().filter(|trial| trial.op == op && trial.filled == *filled)?;
        self.editor.mesh()
    }

    /// Takes the preview back, if there is one; gives whether ids of elements mean what they meant.
    pub(crate) fn end_preview(&mut self) -> Option<bool> {
        self.forms.previews.due = false;
        let keeps_ids = self.trial()?.keeps_ids;
        self.forms.previews.shown = None;
        self.editor.cancel_edit();
        self.follow();
        Some(keeps_ids)
    }

    /// Takes the preview back where its form is no longer on the screen.
    pub(crate) fn end_unseen_preview(&mut self) {
        let due = self.forms.previews.due;
        if !std::mem::take(&mut self.forms.previews.seen) {
            self.end_preview();
            // A form that was just opened is on the screen in the next frame.
            self.forms.previews.due = due;
        }
    }

    /// Makes the preview one undo step, if it shows just this.
    pub(crate) fn apply_preview(&mut self, op: OpId, filled: &Filled) -> bool {
        if self.previewed(op, filled).is_none() {
            return false;
        }
        self.commit_preview();
        if let Some(Trial { outcome, .. }) = self.forms.previews.shown.take()
            && !outcome.warnings.is_empty()
        {
            self.toast(MessageKind::Warning, outcome.message, outcome.warnings);
        }
        true
    }

    /// The switch of the preview below a form, and why there is none; makes it where it is due.
    pub(crate) fn preview_row(&mut self, ui: &mut Ui, id: OpId, filled: &Filled, changed: bool) {
        if !id.spec().previewed || self.editor.mesh().is_none() {
            return;
        }
        self.forms.previews.seen = true;
        self.forms.previews.due |= changed;
        if self.trial().is_some_and(|trial| trial.op != id) {
            self.end_preview();
            self.forms.previews.due = true;
        }
        let hint = "Shows what the operation makes while its fields are changed; only Apply does it (Escape \
                    takes it back)";
        let on = Checkbox::new(&mut self.forms.previews.on, "Live preview");
        if ui.add(on).on_hover_text(hint).changed() {
            self.end_preview();
            self.forms.previews.due = self.forms.previews.on;
        }
        if !self.forms.previews.on {
            self.forms.previews.due = false;
            self.forms.previews.why_not = None;
            return;
        }
        let waits = self.forms.previews.slow && ui.input(|input| input.pointer.any_down());
        // How large the mesh is without the preview can't be counted once there is one.
        let counted = self.facts(id).corners.is_some();
        if counted && self.forms.previews.due && !waits {
            self.show_preview(id, filled);
        }
        let words = match (&self.forms.previews.why_not, self.trial()) {
            (_, Some(_)) => "Previewed, not done yet: apply it, or take it back with Escape.",
            (Some(WhyNot::TooLarge), _) => {
                "No preview: with these fields this mesh takes too long to be shown at every change."
            }
            (Some(WhyNot::Refused(reason)), _) => {
                ui.add(Label::new(RichText::new(reason).small().color(ui.visuals().warn_fg_color)).wrap());
                return;
            }
            (None, None) => "Change a field to preview it.",
        };
        ui.add(Label::new(RichText::new(words).small().weak()).wrap());
    }

    fn show_preview(&mut self, id: OpId, filled: &Filled) {
        let started = self.platform.now();
        let before = self.measured_facts();
        self.end_preview();
        self.end_live(true);
        self.forms.previews.why_not = self.try_out(id, filled, before).err();
        self.forms.previews.slow = self.platform.now() - started > QUICK;
        self.follow();
    }

    fn try_out(&mut self, id: OpId, filled: &Filled, before: Facts) -> Result<(), WhyNot> {
        let refused = |error: editor::CommandError| WhyNot::Refused(error.reason());
        let command = fields::command(id, filled).map_err(refused)?;
        self.editor.can(&command).map_err(refused)?;
        if !self.editor.is_quick(&command) {
            return Err(WhyNot::TooLarge);
        }
        let sizes_before = self.editor.mesh().map(sizes);
        let outcome = self.editor.update_edit(command).map_err(refused)?;
        let keeps_ids = self.editor.mesh().map(sizes) == sizes_before;
        self.forms.previews.shown =
            Some(Trial { op: id, filled: filled.clone(), outcome, before, keeps_ids });
        Ok(())
    }
}
