//! "Adjust last operation": the fields of what was done last. Changing one does it again in place of
//! itself, as one undo step.

use editor::{Begun, Command, JobId, MessageKind, OperationKind};
use egui::{CollapsingHeader, Grid, RichText, Ui, vec2};
use serde_json::Value;

use crate::app::App;
use crate::panels::{QUICK, fields};

/// Fields that were changed and are not done yet, and the job that does them.
#[derive(Default)]
pub(crate) struct Adjusting {
    /// The command as it will be when the pointer lets go.
    pending: Option<Value>,
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
        let shown = || spec.fields.iter().filter(|field| !fields::is_elements(field.kind));
        if spec.kind == OperationKind::Document || shown().next().is_none() || spec.name == "new" {
            return;
        }
        let before = self.adjusting.pending.clone().unwrap_or_else(|| command.to_value());
        let Some(mut filled) = before.as_object().cloned() else { return };
        // A default that stands for elements would take the place of those of the command.
        for field in shown() {
            if let Some(value) = fields::default_value(field) {
                filled.entry(field.name).or_insert(value);
            }
        }
        let hints = self.hints(spec.name);
        let start = filled.clone();
        // A header doesn't wrap: with the operation's name in it, it would widen the panel.
        CollapsingHeader::new("Adjust last operation").id_salt("adjust").default_open(true).show(ui, |ui| {
            ui.label(RichText::new(spec.label).strong());
            Grid::new(("adjust", spec.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
                fields::rows(ui, spec, &mut filled, &hints, |field| !fields::is_elements(field.kind));
            });
        });
        ui.separator();
        if filled != start {
            self.adjusting.pending = Some(filled.into());
        }
        // What is quick follows every step of a spin; what takes a while waits for its end.
        let quick = spec.kind != OperationKind::WholeMesh
            || (!self.adjusting.slow && self.editor.mesh().is_some_and(|mesh| mesh.face_count() < SMALL));
        let waits = !quick && ui.input(|input| input.pointer.any_down());
        if let Some(value) = self.adjusting.pending.take_if(|_| !waits) {
            self.adjust(value);
        }
    }

    fn adjust(&mut self, value: Value) {
        let started = self.platform.now();
        let begun = Command::from_value(value).and_then(|command| {
            let label = command.op.spec().label;
            self.editor.adjust(command).map(|begun| (begun, label))
        });
        match begun {
            Ok((Begun::Done(outcome), _)) => {
                self.adjusting.slow = self.platform.now() - started > QUICK;
                if !outcome.warnings.is_empty() {
                    self.toast(MessageKind::Warning, outcome.message, outcome.warnings);
                }
            }
            Ok((Begun::Job(request), label)) => {
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
