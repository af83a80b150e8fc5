//! The keys in effect, as menus, tooltips and the handling of input read them. They belong to egui's context, as its
//! style does.

use std::sync::Arc;

use egui::{Context, Event, FocusDirection, Id, InputState, Key, Modifiers};

use crate::input::actions::{self, Action};
use crate::input::availability::follows_pointer;
use crate::input::held_keys::is_typed;
use crate::input::key_map::{KeyMap, When};
use crate::input::shortcut::Shortcut;
use crate::lists::row_list;
use crate::theme;
use crate::transforming::SnapTo;
use crate::view;

use Action as A;

/// Where the context holds the keys.
fn place() -> Id {
    Id::unique("key map")
}

/// The keys in effect.
pub fn map(ctx: &Context) -> Arc<KeyMap> {
    ctx.data_mut(|data| {
        data.get_temp_mut_or_insert_with(place(), || Arc::new(KeyMap::new(Default::default()))).clone()
    })
}

/// Puts other keys into effect.
pub fn set_map(ctx: &Context, map: KeyMap) {
    ctx.data_mut(|data| data.insert_temp(place(), Arc::new(map)));
    ctx.request_repaint();
}

/// The first key of an action as the platform writes it; empty if there is none, and on a touch screen.
pub fn text(ctx: &Context, action: Action) -> String {
    if theme::is_for_touch(ctx) {
        return String::new();
    }
    map(ctx).keys_of(action).first().map(|shortcut| shortcut.written(ctx)).unwrap_or_default()
}

/// A sentence followed by its key: "Undo the last change. (Ctrl+Z)".
pub fn tooltip(ctx: &Context, description: &str, action: Action) -> String {
    let key = text(ctx, action);
    if key.is_empty() { description.to_owned() } else { format!("{description} ({key})") }
}

/// How to start an action, within a sentence: "press Ctrl+O", or without a key "choose Open…".
pub fn how_to(ctx: &Context, action: Action) -> String {
    let key = text(ctx, action);
    if key.is_empty() {
        format!("choose {}", actions::describe(action).label)
    } else {
        format!("press {key}")
    }
}

/// Whether a key of an action is held.
pub fn is_held(ctx: &Context, action: Action) -> bool {
    !ctx.text_edit_focused() && is_down(ctx, map(ctx).own_keys(action))
}

/// What moved elements snap to while its key is held.
pub fn held_snap(ctx: &Context) -> Option<SnapTo> {
    let map = map(ctx);
    let is_held = |to: &SnapTo| is_down(ctx, map.own_keys(A::SnapTo(*to)));
    if ctx.text_edit_focused() { None } else { SnapTo::ALL.into_iter().find(is_held) }
}

fn is_down(ctx: &Context, keys: &[Shortcut]) -> bool {
    // Shift may be held too: it slows the pointer.
    let is_down = |input: &InputState, key: &Shortcut| {
        let Modifiers { ctrl, command, alt, .. } = input.modifiers;
        input.key_down(key.key) && key.ctrl == (ctrl || command) && key.alt == alt
    };
    !keys.is_empty() && ctx.input(|input| keys.iter().any(|key| is_down(input, key)))
}

/// The keys that snap while they are held, as the platform writes them, and what they snap to: "X, C, V" and "the grid, edges,
/// vertices"; empty if there are none.
pub fn snap_keys(ctx: &Context) -> [String; 2] {
    let map = map(ctx);
    let first = |to: SnapTo| Some((map.own_keys(A::SnapTo(to)).first()?.written(ctx), to.name()));
    let (keys, names): (Vec<_>, Vec<_>) = SnapTo::ALL.into_iter().filter_map(first).unzip();
    [keys.join(", "), names.join(", ")]
}

/// Whether the key of an action means something only as long as it is held.
pub fn acts_while_held(action: Action) -> bool {
    matches!(action, A::SnapTo(_))
}

/// What keys mean now.
pub struct KeyReader {
    map: Arc<KeyMap>,
    /// When keys mean something, the first first.
    cases: Vec<When>,
    /// Whether a text field has the focus.
    typing: bool,
    /// Whether a menu is open.
    menu: bool,
    /// Whether a control has the focus, and not the viewport.
    on_control: bool,
    /// Whether a list has it.
    on_list: bool,
}

impl KeyReader {
    /// What keys mean in `cases`. While the user types, only keys with Ctrl or Command that a text field doesn't use
    /// count, and Escape goes to the field. While a menu is open, Escape goes to the menu.
    pub fn new(ctx: &Context, menu: bool, cases: Vec<When>) -> Self {
        let focused = ctx.memory(|memory| memory.focused()).filter(|id| *id != view::widget_id());
        let on_list = focused.is_some() && focused == row_list::focused(ctx);
        Self {
            map: map(ctx),
            cases,
            typing: ctx.text_edit_focused(),
            menu,
            on_control: focused.is_some(),
            on_list,
        }
    }

    /// The action that a key starts.
    pub fn action_of(&self, shortcut: Shortcut) -> Option<Action> {
        // A focused button uses Space, a focused list Home and the paging keys, and Shift+Tab goes to the control before.
        let is_theirs = match shortcut.key {
            Key::Space => self.on_control && !self.on_list,
            Key::Home | Key::PageUp | Key::PageDown | Key::Tab => self.on_control,
            Key::Escape => self.menu,
            _ => false,
        };
        if is_theirs || (is_of_browser(shortcut) && (self.on_control || self.menu)) {
            return None;
        }
        let action = self.map.action_of(shortcut, &self.cases)?;
        (!self.typing || (works_while_typing(action) && types_no_text(shortcut))).then_some(action)
    }

    /// The actions that count whose keys were pressed this frame, in order and as often as they were pressed; consumes the
    /// keys. The events after a key that opens a text field or starts an edit that takes keys belong to that: they are
    /// removed and returned, for the next frame.
    pub fn take(&self, ctx: &Context, counts: impl Fn(Action) -> bool) -> (Vec<Action>, Vec<Event>) {
        let (mut actions, mut later) = (Vec::new(), Vec::new());
        let mut takes_tab = false;
        ctx.input_mut(|input| {
            input.events.retain(|event| {
                if actions.last().copied().is_some_and(takes_keys) {
                    later.extend(is_typed(event).then(|| event.clone()));
                    return !is_typed(event);
                }
                let shortcut = Shortcut::of_event(event);
                let action = shortcut.and_then(|shortcut| self.action_of(shortcut));
                takes_tab |= action.is_some() && shortcut.is_some_and(|shortcut| shortcut.key == Key::Tab);
                // A switch whose key is held goes on and off once.
                let is_repeated = matches!(event, Event::Key { repeat: true, .. }) && action == Some(A::Soft);
                let counts = |action: &Action| !is_repeated && !acts_while_held(*action) && counts(*action);
                actions.extend(action.filter(counts));
                action.is_none()
            });
        });
        if takes_tab {
            // egui has read the event too, before the page.
            ctx.memory_mut(|memory| memory.move_focus(FocusDirection::None));
        }
        (actions, later)
    }
}

/// Whether the browser uses a key for something that users expect everywhere but in the viewport: reload, bookmarks, history,
/// search.
fn is_of_browser(shortcut: Shortcut) -> bool {
    let keys = [Key::R, Key::B, Key::D, Key::H, Key::E, Key::F];
    shortcut.ctrl && !shortcut.alt && !shortcut.shift && keys.contains(&shortcut.key)
}

/// Whether a key types no text.
fn types_no_text(shortcut: Shortcut) -> bool {
    shortcut.ctrl || shortcut.alt || matches!(shortcut.key, Key::F3)
}

/// Whether the keys after an action's mean something else than before: it opens a text field, or starts a live edit or a flight.
fn takes_keys(action: Action) -> bool {
    match action {
        A::Palette | A::GoToId | A::Save | A::SaveAs(_) => true,
        A::Move | A::Rotate | A::Scale | A::SlideSplit | A::Fly => true,
        A::Operation(id) => follows_pointer(id),
        _ => false,
    }
}

fn works_while_typing(action: Action) -> bool {
    matches!(action, A::Open | A::Save | A::Palette)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::key_preset::KeyPreset;
    use editor::SelectBy;

    #[test]
    fn keys_are_written_with_their_modifiers() {
        let ctx = Context::default();
        assert_eq!(text(&ctx, A::SelectBy(SelectBy::Grow)), "Ctrl+=");
        assert_eq!(text(&ctx, A::SelectBy(SelectBy::Shrink)), "Ctrl+-");
        assert_eq!(text(&ctx, A::LongerEdges), "=");
        assert_eq!(text(&ctx, A::Expand(halfedge::Element::Face)), "");
        assert_eq!(tooltip(&ctx, "Undo.", A::Undo), "Undo. (Ctrl+Z)");
        assert_eq!(how_to(&ctx, A::Open), "press Ctrl+O");
        assert_eq!(how_to(&ctx, A::About), "choose About Meshwright");
        set_map(&ctx, KeyMap::new(KeyPreset::Blender));
        assert_eq!(text(&ctx, A::SelectBy(SelectBy::Grow)), "Ctrl+Numpad +");
        for preset in KeyPreset::ALL {
            let mut seen = std::collections::HashMap::new();
            for binding in KeyMap::new(preset).bindings() {
                for key in &binding.keys {
                    let case = (When::of(binding.action) as u8, key.written(&ctx));
                    if let Some(other) = seen.insert(case, binding.action) {
                        panic!("{:?} and {other:?} are both written {}", binding.action, key.text());
                    }
                }
            }
        }
    }

    #[test]
    fn keys_of_the_browser_count_while_nothing_else_has_the_focus() {
        let ctx = Context::default();
        set_map(&ctx, KeyMap::new(KeyPreset::Blender));
        let reader = |on_control, typing| KeyReader {
            on_control,
            typing,
            ..KeyReader::new(&ctx, false, vec![When::Always])
        };
        let key = |text| Shortcut::parse(text).expect("a key");
        let cut = Some(A::LoopCutTool);
        assert_eq!(reader(false, false).action_of(key("Ctrl+R")), cut);
        assert_eq!(reader(true, false).action_of(key("Ctrl+R")), None);
        assert_eq!(reader(true, false).action_of(key("Ctrl+Z")), Some(A::Undo));
        assert_eq!(reader(true, true).action_of(key("Ctrl+Z")), None, "the text field's own");
        assert_eq!(reader(true, true).action_of(key("Ctrl+S")), Some(A::Save));
        assert_eq!(reader(true, true).action_of(key("Space")), None, "a space is text");
    }
}
