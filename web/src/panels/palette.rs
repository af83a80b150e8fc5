//! The command palette: every action by name, found by typing.

use egui::{
    Align2, AtomExt as _, Button, Context, Id, Key, Modal, Modifiers, RichText, Role, ScrollArea, vec2,
};

use crate::input::actions::{self, Action, Entry};
use crate::input::keys;
use crate::page_view::Page;
use crate::panels::menu_bar::explain;
use crate::request::{Request, Requests};
use crate::widgets::controls::text_field;

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
    let width = 480.0_f32.min(screen.width() - 32.0).max(0.0);
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
        let field = text_field(&mut own.text).hint_text("Find a command").desired_width(width);
        let field = ui.add(field).accessible_name("Find a command");
        if std::mem::take(&mut own.fresh) || !field.has_focus() {
            field.request_focus();
        }
        if field.changed() {
            own.at = 0;
        }
        let found = find(&own.text, &own.recent, |action| page.why_not(action));
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
            ui.ctx().accesskit_node_builder(ui.unique_id(), |node| {
                node.set_role(Role::ListBox);
                node.set_label("Commands");
            });
            let on_selection = ui.visuals().selection.stroke.color;
            for (row, Found { entry, why_not }) in found.iter().enumerate() {
                let on = row == own.at;
                // Beside a greyed command stands what it needs.
                let beside = match why_not {
                    Some(reason) => RichText::new(reason).small().color(ui.visuals().warn_fg_color),
                    None if on => RichText::new(keys::text(ui.ctx(), entry.action)).color(on_selection),
                    None => RichText::new(keys::text(ui.ctx(), entry.action)),
                };
                let button = Button::selectable(on, entry.label)
                    .shortcut_text(beside.atom_shrink(true))
                    .truncate()
                    .min_size(vec2(ui.available_width(), 26.0));
                let response = ui.add_enabled(why_not.is_none(), button).accessible_name(entry.label);
                ui.ctx().accesskit_node_builder(response.id, |node| node.set_role(Role::ListBoxOption));
                if on {
                    // The keyboard stays in the field, but means this row.
                    let row = response.id.accesskit_id();
                    ui.ctx().accesskit_node_builder(field.id, |node| node.set_active_descendant(row));
                }
                if on && moved {
                    response.scroll_to_me(None);
                }
                let clicked = explain(response, ui, entry, why_not.as_deref()).clicked();
                match why_not {
                    None if clicked || (on && enter) => chosen = Some(entry.action),
                    Some(reason) if on && enter => out.push(Request::Warn(reason.clone())),
                    _ => {}
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

/// An action that was found.
#[derive(Debug)]
struct Found {
    entry: Entry,
    /// Why it can't be done now.
    why_not: Option<String>,
}

/// The actions whose names, or names in other programs, contain all typed words: first the one of exactly that
/// name, then those that begin with the typed text, if they can be done, then those called so elsewhere; among equals those that can be done now, then those that were
/// chosen lately.
fn find(typed: &str, recent: &[Action], why_not: impl Fn(Action) -> Option<String>) -> Vec<Found> {
    let typed = typed.trim().to_lowercase();
    let mut found: Vec<((usize, bool, usize, usize), Found)> = actions::all()
        .filter_map(|entry| {
            let rank = if typed.is_empty() { 0 } else { rank(&entry, &typed)? };
            let why_not = why_not(entry.action);
            // Part of a name counts less than another program's name for what can be done.
            let rank = if why_not.is_some() && rank > 0 { rank.max(SYNONYM_RANK) } else { rank };
            let age = recent.iter().position(|action| *action == entry.action).unwrap_or(usize::MAX);
            // What was typed is more of a shorter label.
            let words = if typed.is_empty() { 0 } else { entry.label.split(' ').count() };
            Some(((rank, why_not.is_some(), age, words), Found { entry, why_not }))
        })
        .collect();
    found.sort_by_key(|(order, _)| *order);
    found.into_iter().map(|(_, found)| found).collect()
}

/// The rank of an action that another program calls so.
const SYNONYM_RANK: usize = 3;

/// How well an action fits the typed text, in lower case, from 0; none if it doesn't.
pub(crate) fn rank(entry: &Entry, typed: &str) -> Option<usize> {
    let label = entry.label.to_lowercase();
    let name = match entry.action {
        Action::Operation(id) => id.spec().name,
        _ => "",
    };
    let has_all = |text: &str| typed.split_whitespace().all(|word| text.contains(word));
    Some(match () {
        () if label.trim_end_matches('…') == typed || name == typed => 0,
        () if label.starts_with(typed) => 1,
        () if label.split(' ').any(|word| word.starts_with(typed)) => 2,
        () if entry.synonyms.contains(&typed) => SYNONYM_RANK,
        () if has_all(&format!("{label} {name}")) => 4,
        () if entry.synonyms.iter().any(|synonym| has_all(synonym)) => 5,
        () => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use editor::OpId;

    /// The actions that are found where everything can be done.
    fn named(typed: &str, recent: &[Action]) -> Vec<Action> {
        find(typed, recent, |_| None).iter().map(|found| found.entry.action).collect()
    }

    #[test]
    fn what_can_be_done_comes_first_and_the_rest_says_why_not() {
        let can = [Action::Undo, Action::Grid];
        let why_not = |action| (!can.contains(&action)).then(|| "Not now.".to_owned());
        let found = find("", &[Action::Save, Action::Grid], why_not);
        let actions: Vec<Action> = found.iter().map(|found| found.entry.action).collect();
        assert_eq!(actions[..3], [Action::Grid, Action::Undo, Action::Save]);
        assert!(found[2].why_not.is_some());
        // What was typed counts more: Enter must not do something else.
        let found = find("redo", &[], why_not);
        assert_eq!(found.first().map(|found| found.entry.action), Some(Action::Redo));
    }

    #[test]
    fn finds_by_label_word_and_op_name() {
        assert_eq!(named("und", &[]).first().copied(), Some(Action::Undo));
        assert_eq!(named("grid", &[]).first().copied(), Some(Action::Grid));
        assert_eq!(named("split-edge", &[]).first().copied(), Some(Action::Operation(OpId::SplitEdge)));
        let smooth = named("smooth", &[]).first().copied();
        assert_eq!(smooth, Some(Action::Operation(OpId::Smooth)), "before smooth shading");
        assert_eq!(named("all select", &[]).first().copied(), Some(Action::SelectAll));
        assert!(named("no such thing", &[]).is_empty());
        assert_eq!(named("", &[]).len(), actions::all().count());
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
            let found = named(typed, &[]);
            assert!(found.iter().take(3).any(|found| Some(*found) == action), "{typed}: {found:?}");
        }
    }

    #[test]
    fn lists_what_was_chosen_lately_first() {
        let recent = [Action::Grid, Action::Operation(OpId::Simplify)];
        let actions: Vec<Action> = named("", &recent);
        assert_eq!(actions[..2], recent);
        assert_eq!(actions.len(), actions::all().count());
        // What was typed counts more.
        assert_eq!(named("undo", &recent).first().copied(), Some(Action::Undo));
    }
}
