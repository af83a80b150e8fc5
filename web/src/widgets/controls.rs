//! egui's controls as this page shows them: of one width in forms, with their contents in the middle.

use egui::{Align2, Atom, Button, Checkbox, DragValue, Response, RichText, TextEdit, Ui, vec2};

use crate::theme;

/// The width of a form's numbers, choices and texts, in points.
pub const FIELD_WIDTH: f32 = 140.0;

/// A text field of one line, with the text in the middle of its height.
pub fn text_field(text: &mut String) -> TextEdit<'_> {
    TextEdit::singleline(text).align(Align2::LEFT_CENTER)
}

/// A check box without text, flush with the other controls of a form.
pub fn check_box(on: &mut bool) -> Checkbox<'_> {
    // egui centres the box in the width of a button.
    Checkbox::new(on, Atom::grow())
}

/// A spin box as wide as a form's other fields.
pub fn form_number(ui: &mut Ui, number: DragValue<'_>) -> Response {
    ui.add_sized(vec2(FIELD_WIDTH, ui.spacing().interact_size.y), number)
}

/// The button of what a form or dialog is for.
pub fn primary_button(ui: &Ui, text: &str) -> Button<'static> {
    let palette = theme::palette(ui.visuals());
    Button::new(RichText::new(text).color(palette.on_primary)).fill(palette.primary)
}
