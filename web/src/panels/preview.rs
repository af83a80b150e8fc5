//! Live preview: if the form's operation is quick, the document shows its result while the fields are
//! filled in. Applying makes the preview one undo step; anything else removes it.

use editor::OpId;
use egui::{Checkbox, Label, RichText, Ui};

use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::session::form::Filled;
use crate::session::preview::WhyNot;

/// The state of the forms' previews.
pub(crate) struct Previews {
    /// Whether the user wants previews.
    on: bool,
    /// Whether the form was opened or a field changed, and the result is yet to be shown.
    due: bool,
    /// Whether the form was on the screen in this frame.
    seen: bool,
}

impl Default for Previews {
    fn default() -> Self {
        Self { on: true, due: false, seen: false }
    }
}

impl Previews {
    /// Requests a preview as soon as one is possible.
    pub fn ask(&mut self) {
        self.due = true;
    }

    /// Shows no preview until a field changes.
    pub fn end(&mut self) {
        self.due = false;
    }

    /// Whether the form was on the screen since the last call.
    pub fn take_seen(&mut self) -> bool {
        std::mem::take(&mut self.seen)
    }
}

/// Why the check box is greyed where a preview would make the page wait.
const TOO_LARGE: &str = "With these fields the operation takes too long to show before it is applied.";

/// The preview's check box below a form, and why there is no preview; requests the preview when it is due. Returns
/// whether one is coming, which then tells the size of the result too.
pub(crate) fn row(
    ui: &mut Ui,
    page: &Page<'_>,
    own: &mut Previews,
    id: OpId,
    filled: &Filled,
    changed: bool,
    out: &mut Requests,
) -> bool {
    if !id.spec().previewed || page.editor.mesh().is_none() {
        return false;
    }
    own.seen = true;
    own.due |= changed;
    // The facts about the mesh without the preview that is ending are known in the next frame.
    let mut is_ending = page.preview().is_some_and(|preview| preview.id != id);
    if is_ending {
        out.push(Request::EndPreview);
        own.due = true;
    }
    let hint = "Show what the operation makes while its fields change; only Apply does it (Escape \
                    cancels it)";
    // A ticked box over a note that there is no preview would contradict itself.
    let too_large = matches!(page.why_no_preview(), Some(WhyNot::TooLarge)) && page.preview().is_none();
    let mut on = own.on && !too_large;
    if too_large && page.shown.narrow {
        // The fields need the room of a box that can't be ticked.
        ui.add(Label::new(RichText::new(TOO_LARGE).small().weak()).wrap());
        return false;
    }
    let response = ui.add_enabled(!too_large, Checkbox::new(&mut on, "Live preview"));
    if response.on_hover_text(hint).on_disabled_hover_text(TOO_LARGE).changed() {
        own.on = on;
        out.push(Request::EndPreview);
        is_ending = true;
        own.due = own.on;
    }
    if !own.on {
        own.due = false;
        return false;
    }
    let is_coming = own.due || is_ending;
    let waits = page.previewing.is_slow && ui.input(|input| input.pointer.any_down());
    // The size of the mesh without the preview can't be counted while there is a preview.
    let counted = page.facts(id).corners.is_some();
    if counted && own.due && !waits && !is_ending {
        own.due = false;
        out.push(Request::Preview(id, filled.clone()));
    }
    let words = match (page.why_no_preview(), page.preview()) {
        (_, Some(_)) if page.shown.touch => "This is a preview: apply it, or cancel it.",
        (_, Some(_)) => "This is a preview: apply it, or cancel it with Escape.",
        (Some(WhyNot::TooLarge), _) => TOO_LARGE,
        (Some(WhyNot::Refused(reason)), _) => {
            ui.add(Label::new(RichText::new(reason).small().color(ui.visuals().warn_fg_color)).wrap());
            return is_coming;
        }
        (None, None) => "Change a field to preview it.",
    };
    ui.add(Label::new(RichText::new(words).small().weak()).wrap());
    is_coming
}
