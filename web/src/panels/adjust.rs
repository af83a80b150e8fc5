//! "Adjust last operation": the fields of the last operation. A change runs the operation again with the
//! new fields, still as one undo step.

use editor::ops::Field;
use editor::{Command, Facts, MAX_ELEMENTS_AT_ONCE, Scope};
use egui::{CollapsingHeader, FocusDirection, Grid, RichText, Ui, vec2};

use crate::page_view::Page;
use crate::panels::fields;
use crate::request::{Request, Requests};
use crate::session::form;

/// A change of fields that has not been applied yet.
#[derive(Default)]
pub(crate) struct Adjusting {
    /// The command to run when the pointer's button is released.
    pending: Option<Command>,
    /// Where the keyboard focus goes next.
    focus: Option<Focus>,
}

/// A step on the way of the keyboard focus to the first field.
#[derive(Clone, Copy)]
enum Focus {
    Header,
    Field,
}

impl Adjusting {
    /// Moves the keyboard focus to the first field.
    pub fn take_focus(&mut self) {
        self.focus = Some(Focus::Header);
    }
}

/// Shows the panel, unless the last operation has no fields to change.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut Adjusting, out: &mut Requests) {
    let Some(command) = form::adjustable(&page.editor) else {
        (own.pending, own.focus) = (None, None);
        return;
    };
    let spec = command.op.spec();
    let is_shown = |field: &Field| form::is_adjustable(command, field);
    let before = own.pending.clone().unwrap_or_else(|| command.clone());
    let (id, object) = (before.op.id(), before.object);
    let mut filled = before.fields();
    // The mesh is already the result; the number of triangles before is not known.
    let facts = match spec.scope {
        Scope::Meshes => Facts { corners: None, ..page.facts(id) },
        _ => page.facts(id),
    };
    let start = filled.clone();
    if matches!(own.focus, Some(Focus::Field)) {
        // From the header, which has it, to the first field.
        ui.memory_mut(|memory| memory.move_focus(FocusDirection::Next));
    }
    // A header doesn't wrap: with the operation's name in it, it would widen the panel.
    let header = CollapsingHeader::new("Adjust last operation").id_salt("adjust").default_open(true);
    let header = header.open(own.focus.map(|_| true)).show(ui, |ui| {
        ui.label(RichText::new(before.op.label()).strong());
        Grid::new(("adjust", spec.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
            fields::rows(ui, spec, &mut filled, &facts, is_shown);
        });
    });
    own.focus = match own.focus {
        Some(Focus::Header) => {
            header.header_response.request_focus();
            header.header_response.scroll_to_me(None);
            ui.ctx().request_repaint();
            Some(Focus::Field)
        }
        Some(Focus::Field) | None => None,
    };
    ui.separator();
    if filled != start {
        match form::command(id, &filled) {
            Ok(command) => own.pending = Some(Command { object, ..command }),
            Err(error) => out.push(Request::Refuse(error)),
        }
    }
    // A quick operation follows every step of a spin box; a slow one waits for the release.
    let quick = spec.scope != Scope::Meshes
        || (!page.adjusting_is_slow
            && page.editor.mesh().is_some_and(|mesh| mesh.face_count() < MAX_ELEMENTS_AT_ONCE));
    let waits = !quick && ui.input(|input| input.pointer.any_down());
    if let Some(command) = own.pending.take_if(|_| !waits) {
        out.push(Request::Adjust(command));
    }
}
