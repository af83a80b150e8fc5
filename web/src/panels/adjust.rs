//! "Adjust last operation": the fields of what was done last. Changing one does it again in place of
//! itself, as one undo step.

use editor::{Begun, Command, JobId, OperationKind};
use egui::{CollapsingHeader, Grid, Ui, vec2};
use serde_json::Value;

use crate::app::App;
use crate::panels::fields;

/// Fields that were changed and are not done yet, and the job that does them.
#[derive(Default)]
pub(crate) struct Adjusting {
    /// The command as it will be when the pointer lets go.
    pending: Option<Value>,
    /// The job of an adjustment: if it fails, the step it replaces comes back.
    job: Option<JobId>,
}

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
        for (name, value) in fields::initial(spec) {
            // A default that stands for elements would take the place of those of the command.
            if spec.field(&name).is_some_and(|field| !fields::is_elements(field.kind)) {
                filled.entry(name).or_insert(value);
            }
        }
        let start = filled.clone();
        let title = format!("Adjust last operation: {}", spec.label);
        CollapsingHeader::new(title).id_salt("adjust").default_open(true).show(ui, |ui| {
            Grid::new(("adjust", spec.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
                for field in shown() {
                    fields::show(ui, spec, field, &mut filled);
                }
            });
        });
        ui.separator();
        if filled != start {
            self.adjusting.pending = Some(filled.into());
        }
        // A local edit follows every step of a spin; a whole mesh waits for its end.
        let waits = spec.kind == OperationKind::WholeMesh && ui.input(|input| input.pointer.any_down());
        if let Some(value) = self.adjusting.pending.take_if(|_| !waits) {
            self.adjust(value);
        }
    }

    fn adjust(&mut self, value: Value) {
        let begun = Command::from_value(value).and_then(|command| {
            let label = command.op.spec().label;
            self.editor.adjust(command).map(|begun| (begun, label))
        });
        match begun {
            Ok((Begun::Done(_), _)) => {}
            Ok((Begun::Job(request), label)) => {
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
