//! Spin boxes that take arithmetic and units, and act when editing ends, never on half a number.

use egui::emath::Numeric;
use egui::{Context, DragValue, Id, Ui};

use crate::units::{LengthUnit, Measure, Wrong, evaluate};

/// A spin box. What is typed may be an expression such as `1/3` or `2*pi`, with units of what it measures; it counts when the
/// box loses the focus or Enter is pressed.
pub fn number_box<'a, N: Numeric>(ui: &Ui, value: &'a mut N, measure: Measure) -> DragValue<'a> {
    let ctx = ui.ctx().clone();
    let parse = move |text: &str| match evaluate(text, measure, length_unit(&ctx)) {
        Ok(value) => Some(value),
        Err(Wrong::Unfinished) => None,
        Err(Wrong::Unit(reason)) => {
            ctx.data_mut(|data| data.insert_temp(refusal_place(), reason));
            None
        }
    };
    DragValue::new(value).update_while_editing(false).custom_parser(parse)
}

/// Why the number that was last typed can't be, once.
pub(crate) fn take_refusal(ctx: &Context) -> Option<String> {
    ctx.data_mut(|data| data.remove_temp(refusal_place()))
}

/// What one unit of the mesh is. It belongs to egui's context, as the keys do, so that every spin box knows it.
pub(crate) fn length_unit(ctx: &Context) -> LengthUnit {
    ctx.data(|data| data.get_temp(unit_place())).unwrap_or_default()
}

/// Sets what one unit of the mesh is.
pub(crate) fn set_length_unit(ctx: &Context, unit: LengthUnit) {
    ctx.data_mut(|data| data.insert_temp(unit_place(), unit));
}

fn refusal_place() -> Id {
    Id::unique("refused number")
}

fn unit_place() -> Id {
    Id::unique("length unit")
}
