//! "Adjust last operation": the fields of the last operation. A change runs the operation again with the
//! new fields, still as one undo step.

use editor::ops::{Field, FieldKind, Fill, Symmetry};
use editor::{Command, Facts, MAX_ELEMENTS_AT_ONCE, OpId, Scope};
use egui::{CollapsingHeader, Grid, RichText, Ui, vec2};

use crate::page_view::Page;
use crate::panels::fields;
use crate::request::{Request, Requests};
use crate::session::form;

/// A change of fields that has not been applied yet.
#[derive(Default)]
pub(crate) struct Adjusting {
    /// The command to run when the pointer's button is released.
    pending: Option<Command>,
}

/// Shows the panel, unless the last operation has no fields to change.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut Adjusting, out: &mut Requests) {
    let Some(command) = page.editor.last_command() else {
        own.pending = None;
        return;
    };
    let spec = command.op.spec();
    // Which document a new shape is in was decided when it was made.
    let is_place = |field: &Field| command.op.id() == OpId::New && field.name == "add";
    let is_mirrored = command.symmetry != Symmetry::None;
    let is_shown = |field: &Field| {
        !field.is_target()
            && !matches!(field.fill, Fill::Optional(_))
            && !is_place(field)
            && (is_mirrored || !field.is_symmetry())
    };
    // The inspector has these fields, and must not move away while they change.
    let in_inspector = matches!(command.op.id(), OpId::SetFaceColor | OpId::SetVertexPosition);
    let has_text = spec.fields.iter().any(|field| field.kind == FieldKind::Text);
    // The cube that the page opens with is no step.
    let is_start = command.op.id() == OpId::New && page.editor.undo_labels().next().is_none();
    if is_start
        || has_text
        || spec.scope == Scope::Document
        || in_inspector
        || !spec.fields.iter().any(is_shown)
    {
        return;
    }
    let before = own.pending.clone().unwrap_or_else(|| command.clone());
    let (id, object) = (before.op.id(), before.object);
    let mut filled = before.fields();
    // The mesh is already the result; the number of triangles before is not known.
    let facts = match spec.scope {
        Scope::Meshes => Facts { corners: None, ..page.facts(id) },
        _ => page.facts(id),
    };
    let start = filled.clone();
    // A header doesn't wrap: with the operation's name in it, it would widen the panel.
    CollapsingHeader::new("Adjust last operation").id_salt("adjust").default_open(true).show(ui, |ui| {
        ui.label(RichText::new(before.op.label()).strong());
        Grid::new(("adjust", spec.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
            fields::rows(ui, spec, &mut filled, &facts, is_shown);
        });
    });
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
