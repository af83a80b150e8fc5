//! The command palette: every action by name, found by typing.

use egui::{Align2, Button, Context, Id, Key, Modal, Modifiers, RichText, ScrollArea, TextEdit, vec2};

use crate::input::actions::{self, Action, Entry};
use crate::input::keys;
use crate::page_view::Page;
use crate::panels::menu_bar::explain;
use crate::request::Requests;

/// The state of the palette while it is open.
#[derive(Default)]
pub(crate) struct PaletteState {
    pub open: bool,
    text: String,
    at: usize,
    fresh: bool,
    /// The actions that were chosen here, the latest first.
    recent: Vec<Action>,
}

impl PaletteState {
    /// Opens the palette with an empty field.
    pub fn show(&mut self) {
        *self = Self { open: true, fresh: true, recent: std::mem::take(&mut self.recent), ..Self::default() };
    }
}

pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut PaletteState, out: &mut Requests) {
    if !own.open {
        return;
    }
    let screen = ctx.content_rect();
    let width = 480.0_f32.min(screen.width() - 32.0);
    let id = Id::unique("palette");
    let area = Modal::default_area(id).anchor(Align2::CENTER_TOP, vec2(0.0, screen.height() * 0.12));
    let mut chosen = None;
    let shown = Modal::new(id).area(area).show(ctx, |ui| {
        ui.set_width(width);
        // The list takes the arrow keys before the text field sees them.
        let (up, down, enter) = ui.input_mut(|input| {
            (
                input.consume_key(Modifiers::NONE, Key::ArrowUp),
                input.consume_key(Modifiers::NONE, Key::ArrowDown),
                input.key_pressed(Key::Enter),
            )
        });
        let field = TextEdit::singleline(&mut own.text).hint_text("Find a command").desired_width(width);
        let field = ui.add(field).accessible_name("Find a command");
        if std::mem::take(&mut own.fresh) || !field.has_focus() {
            field.request_focus();
        }
        if field.changed() {
            own.at = 0;
        }
        let found = find(&own.text, &own.recent);
        let last = found.len().saturating_sub(1);
        let moved = up || down;
        if down {
            own.at = (own.at + 1).min(last);
        }
        if up {
            own.at = own.at.saturating_sub(1);
        }
        if found.is_empty() {
            ui.label(RichText::new("No command matches.").weak());
        }
        ScrollArea::vertical().max_height(screen.height() * 0.5).auto_shrink([false, true]).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            for (row, entry) in found.iter().enumerate() {
                let why_not = page.why_not(entry.action);
                let on = row == own.at;
                let button = Button::selectable(on, entry.label)
                    .shortcut_text(keys::text(ui.ctx(), entry.action))
                    .min_size(vec2(ui.available_width(), 26.0));
                let response = ui.add_enabled(why_not.is_none(), button);
                if on && moved {
                    response.scroll_to_me(None);
                }
                let clicked = explain(response, ui, entry, why_not.as_deref()).clicked();
                if clicked || (on && enter && why_not.is_none()) {
                    chosen = Some(entry.action);
                }
            }
        });
    });
    if let Some(action) = chosen {
        own.open = false;
        own.recent.retain(|recent| *recent != action);
        own.recent.insert(0, action);
        out.act(action);
    } else if shown.should_close() {
        own.open = false;
    }
}

/// The actions whose names, or names in other programs, contain all typed words: first the one of exactly that
/// name, then those that begin with the typed text; among equals those that were chosen lately.
fn find(typed: &str, recent: &[Action]) -> Vec<Entry> {
    let typed = typed.trim().to_lowercase();
    let mut found: Vec<((usize, usize), Entry)> = actions::all()
        .filter_map(|entry| {
            let label = entry.label.to_lowercase();
            let name = match entry.action {
                Action::Operation(id) => id.spec().name,
                _ => "",
            };
            let has_all = |text: &str| typed.split_whitespace().all(|word| text.contains(word));
            let rank = match () {
                () if label.trim_end_matches('…') == typed || name == typed => 0,
                () if label.starts_with(&typed) => 1,
                () if label.split(' ').any(|word| word.starts_with(&typed)) => 2,
                () if entry.synonyms.contains(&typed.as_str()) => 3,
                () if has_all(&format!("{label} {name}")) => 4,
                () if entry.synonyms.iter().any(|synonym| has_all(synonym)) => 5,
                () => return None,
            };
            let age = recent.iter().position(|action| *action == entry.action).unwrap_or(usize::MAX);
            Some(((rank, age), entry))
        })
        .collect();
    if typed.is_empty() {
        found.sort_by_key(|((_, age), _)| *age);
    } else {
        found.sort_by_key(|(rank, _)| *rank);
    }
    found.into_iter().map(|(_, entry)| entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use editor::OpId;

    #[test]
    fn finds_by_label_word_and_op_name() {
        assert_eq!(find("und", &[]).first().map(|entry| entry.action), Some(Action::Undo));
        assert_eq!(find("grid", &[]).first().map(|entry| entry.action), Some(Action::Grid));
        assert_eq!(
            find("split-edge", &[]).first().map(|entry| entry.action),
            Some(Action::Operation(OpId::SplitEdge))
        );
        let smooth = find("smooth", &[]).first().map(|entry| entry.action);
        assert_eq!(smooth, Some(Action::Operation(OpId::Smooth)), "before smooth shading");
        assert_eq!(find("all select", &[]).first().map(|entry| entry.action), Some(Action::SelectAll));
        assert!(find("no such thing", &[]).is_empty());
        assert_eq!(find("", &[]).len(), actions::all().count());
    }

    #[test]
    fn finds_by_the_names_of_other_programs() {
        let operation = |id| Some(Action::Operation(id));
        let cases = [
            ("decimate", operation(OpId::Simplify)),
            ("weld", operation(OpId::MergeByDistance)),
            ("triangulate", operation(OpId::TriangulateFaces)),
            ("flip normals", operation(OpId::FlipOrientation)),
            ("chamfer", operation(OpId::BevelEdges)),
            ("insert edge loop", operation(OpId::LoopCut)),
            ("remove doubles", operation(OpId::MergeByDistance)),
            ("export", Some(Action::Save)),
            ("import", Some(Action::Open)),
            ("deselect", Some(Action::SelectNone)),
        ];
        for (typed, action) in cases {
            let found = find(typed, &[]);
            assert!(found.iter().take(3).any(|entry| Some(entry.action) == action), "{typed}: {found:?}");
        }
    }

    #[test]
    fn lists_what_was_chosen_lately_first() {
        let recent = [Action::Grid, Action::Operation(OpId::Simplify)];
        let actions: Vec<Action> = find("", &recent).iter().map(|entry| entry.action).collect();
        assert_eq!(actions[..2], recent);
        assert_eq!(actions.len(), actions::all().count());
        // What was typed counts more.
        assert_eq!(find("undo", &recent).first().map(|entry| entry.action), Some(Action::Undo));
    }
}
