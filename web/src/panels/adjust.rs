//! "Adjust last operation": the fields of what was done last. Changing one does it again in place of
//! itself, as one undo step.

use editor::ops::{Field, Fill};
use editor::{Begun, Command, JobId, MessageKind, OpId, Scope};
use egui::{CollapsingHeader, Grid, RichText, Ui, vec2};

use crate::app::App;
use crate::panels::{QUICK, fields};

/// Fields that were changed and are not done yet, and the job that does them.
#[derive(Default)]
pub(crate) struct Adjusting {
    /// The command as it will be when the pointer lets go.
    pending: Option<Command>,
    /// The job of an adjustment: if it fails, the step it replaces comes back.
    job: Option<JobId>,
    /// The last adjustment took too long to be made at every step of a spin.
    slow: bool,
}

/// An operation that left this many faces or more is not tried at every step of a spin.
const SMALL: usize = 20_000;

impl App {
    /// The panel; nothing where the last thing done has no fields to change.
    pub(crate) fn adjust_panel(&mut self, ui: &mut Ui) {
        let Some(command) = self.editor.last_command() else {
            self.adjusting.pending = None;
            return;
        };
        let spec = command.op.spec();
        // An operation that made the document has nothing before it to be done again on.
        let is_shown = |field: &Field| !field.is_elements() && !matches!(field.fill, Fill::Optional(_));
        let makes_document = command.op.id() == OpId::New;
        if spec.scope == Scope::Document || makes_document || !spec.fields.iter().any(is_shown) {
            return;
        }
        let before = self.adjusting.pending.clone().unwrap_or_else(|| command.clone());
        let (id, object) = (before.op.id(), before.object);
        let mut filled = before.fields();
        let facts = self.facts(id);
        let start = filled.clone();
        // A header doesn't wrap: with the operation's name in it, it would widen the panel.
        CollapsingHeader::new("Adjust last operation").id_salt("adjust").default_open(true).show(ui, |ui| {
            ui.label(RichText::new(spec.label).strong());
            Grid::new(("adjust", spec.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
                fields::rows(ui, spec, &mut filled, &facts, is_shown);
            });
        });
        ui.separator();
        if filled != start {
            match fields::command(id, &filled) {
                Ok(command) => self.adjusting.pending = Some(Command { object, ..command }),
                Err(error) => self.refused(&error, None),
            }
        }
        // What is quick follows every step of a spin; what takes a while waits for its end.
        let quick = spec.scope != Scope::Meshes
            || (!self.adjusting.slow && self.editor.mesh().is_some_and(|mesh| mesh.face_count() < SMALL));
        let waits = !quick && ui.input(|input| input.pointer.any_down());
        if let Some(command) = self.adjusting.pending.take_if(|_| !waits) {
            self.adjust(command);
        }
    }

    fn adjust(&mut self, command: Command) {
        let started = self.platform.now();
        let label = command.op.spec().label;
        match self.editor.adjust(command) {
            Ok(Begun::Done(outcome)) => {
                self.adjusting.slow = self.platform.now() - started > QUICK;
                if !outcome.warnings.is_empty() {
                    self.toast(MessageKind::Warning, outcome.message, outcome.warnings);
                }
            }
            Ok(Begun::Job(request)) => {
                self.adjusting.slow = true;
                self.adjusting.job = Some(request.id());
                self.start(&request, label.to_owned(), None);
            }
            Err(error) => self.refused(&error, None),
        }
        self.follow();
    }

    /// Brings the step back that an adjustment was to replace, where the adjustment came to nothing.
    pub(crate) fn adjustment_ended(&mut self, job: JobId, done: bool) {
        if self.adjusting.job.take_if(|adjusting| *adjusting == job).is_some()
            && !done
            && let Err(error) = self.editor.redo()
        {
            self.refused(&error, None);
        }
    }
}
