//! The values in an operation's form, and the command made from them.

use editor::ops::{Facts, Field, FieldKind, Fill, Symmetry};
use editor::{Command, CommandError, Editor, OpId, Scope, Spec};
use serde_json::{Map, Value};

/// The values that the user filled in, by the fields' names. The command omits fields that are not in it.
pub type Filled = Map<String, Value>;

/// The initial values of a form. Fields that the selection fills and fields that are not set are omitted;
/// of alternatives, the first is included. The symmetry is a setting of the page.
pub fn initial(spec: &Spec, facts: &Facts) -> Filled {
    let mut filled = Filled::new();
    for field in spec.fields {
        let is_shown = matches!(field.fill, Fill::Required | Fill::Value(_)) && !field.is_symmetry();
        if is_shown && field.alternative.is_none_or(|title| chosen(spec, title, &filled).is_none()) {
            filled.insert(field.name.to_owned(), field.initial_value(facts));
        }
    }
    filled
}

/// The command that a form describes.
pub fn command(id: OpId, filled: &Filled) -> Result<Command, CommandError> {
    Command::from_fields(id, filled.clone())
}

/// The command that makes the document of a new page.
pub fn first_shape() -> Result<Command, CommandError> {
    command(OpId::New, &initial(OpId::New.spec(), &Facts::default()))
}

/// The command that makes a document with the shape of this name.
pub fn shape(name: &str) -> Result<Command, CommandError> {
    let mut filled = initial(OpId::New.spec(), &Facts::default());
    filled.insert("shape".to_owned(), name.into());
    command(OpId::New, &filled)
}

/// Whether any field of a form depends on the size of the mesh, which must then be measured.
pub fn needs_measures(spec: &Spec) -> bool {
    use editor::ops::Suggestion::{MeanEdge, OfDiagonal, RemeshedEdge};
    spec.fields.iter().any(|field| matches!(field.suggestion, MeanEdge | RemeshedEdge | OfDiagonal(_)))
}

/// The last command, if it has fields that can be changed afterwards.
pub fn adjustable(editor: &Editor) -> Option<&Command> {
    let command = editor.last_command()?;
    let (id, spec) = (command.op.id(), command.op.spec());
    // The inspector has these fields, and must not move away while they change.
    let in_inspector = matches!(id, OpId::SetFaceColor | OpId::SetVertexPosition);
    let has_text = spec.fields.iter().any(|field| field.kind == FieldKind::Text);
    // The cube that the page opens with is no step.
    let is_start = id == OpId::New && editor.undo_labels().next().is_none();
    let is_left_out = is_start || has_text || spec.scope == Scope::Document || in_inspector;
    (!is_left_out && spec.fields.iter().any(|field| is_adjustable(command, field))).then_some(command)
}

/// Whether a field of a command can be changed afterwards.
pub fn is_adjustable(command: &Command, field: &Field) -> bool {
    // Which document a new shape is in was decided when it was made.
    let is_place = command.op.id() == OpId::New && field.name == "add";
    !field.is_target()
        && !matches!(field.fill, Fill::Optional(_))
        && !is_place
        && (command.symmetry != Symmetry::None || !field.is_symmetry())
}

/// The alternative that is filled in, of those with this title.
pub fn chosen(spec: &Spec, title: &str, filled: &Filled) -> Option<&'static Field> {
    alternatives(spec, title).find(|field| filled.contains_key(field.name))
}

pub fn alternatives<'a>(spec: &Spec, title: &'a str) -> impl Iterator<Item = &'static Field> + use<'a> {
    spec.fields.iter().filter(move |field| field.alternative == Some(title))
}
