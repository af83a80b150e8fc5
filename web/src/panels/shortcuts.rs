//! The window with all keys and gestures: it finds them by name and by key, and changes them.

use egui::{Align, Button, Context, Event, Key, Layout, RichText, ScrollArea, Ui, vec2};

use crate::input::actions::{self, Action};
use crate::input::key_map::{KeyMap, When};
use crate::input::key_preset::KeyPreset;
use crate::input::shortcut::Shortcut;
use crate::input::{key_reference, keys, mouse};
use crate::page_view::Page;
use crate::request::{KeyChange, Request, Requests};
use crate::widgets::controls::text_field;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use crate::widgets::window::fixed;

/// The most that the window is wide, in points.
const MAX_WIDTH_POINTS: f32 = 640.0;
/// The most that the list takes of the screen's height.
const MAX_SHARE_OF_HEIGHT: f32 = 0.6;

/// What the window waits for, and what it looks for.
#[derive(Default)]
pub(crate) struct KeyEditor {
    text: String,
    /// Only actions with this key are listed.
    key: Option<Shortcut>,
    only_changed: bool,
    listening: Option<Listening>,
}

/// What the next key is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Listening {
    /// To list the actions that it starts.
    Find,
    /// To start an action, in place of another key or beside the others.
    Bind { action: Action, replaces: Option<Shortcut>, pressed: Option<Shortcut> },
}

impl KeyEditor {
    /// Whether the next key is the window's. `is_open` says whether the window is.
    pub fn is_listening(&self, is_open: bool) -> bool {
        is_open && matches!(self.listening, Some(Listening::Find | Listening::Bind { pressed: None, .. }))
    }

    /// Takes the next key out of the frame's input if the window waits for it. Escape ends the waiting.
    pub fn take_key(&mut self, ctx: &Context, is_open: bool) {
        if !is_open {
            self.listening = None;
            return;
        }
        if self.listening.is_some()
            && ctx.input_mut(|input| input.consume_key(Default::default(), Key::Escape))
        {
            self.listening = None;
            return;
        }
        if !self.is_listening(is_open) {
            return;
        }
        let pressed = ctx.input_mut(|input| {
            let pressed = input.events.iter().find_map(Shortcut::of_event);
            // A key also types text, cuts or copies.
            input.events.retain(|event| {
                !matches!(
                    event,
                    Event::Key { .. } | Event::Text(_) | Event::Cut | Event::Copy | Event::Paste(_)
                )
            });
            pressed
        });
        match (&mut self.listening, pressed) {
            (_, None) | (None, _) => {}
            (Some(Listening::Find), found) => {
                self.key = found;
                self.listening = None;
            }
            (Some(Listening::Bind { pressed, .. }), key) => *pressed = key,
        }
    }
}

pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut KeyEditor, out: &mut Requests) {
    if !page.shown.shortcuts {
        return;
    }
    bind_pressed(&keys::map(ctx), own, out);
    let mut open = true;
    let screen = ctx.content_rect();
    fixed(ctx, "Keyboard shortcuts").open(&mut open).show(ctx, |ui| {
        ui.set_width(MAX_WIDTH_POINTS.min(screen.width() - 48.0).max(0.0));
        let map = keys::map(ctx);
        head(ui, &map, own, out);
        ui.separator();
        let most = screen.height() * MAX_SHARE_OF_HEIGHT;
        let area = ScrollArea::vertical().max_height(most).min_scrolled_height(most);
        area.auto_shrink([false, false]).show(ui, |ui| {
            let any = list(ui, &map, own, out);
            let any = mouse_list(ui, &map, own) || any;
            if !any {
                ui.label(RichText::new("Nothing matches.").weak());
            }
        });
    });
    if !open {
        out.push(Request::Close(crate::shown::Window::Shortcuts));
    }
}

/// Binds the key that was pressed, if it means nothing else yet.
fn bind_pressed(map: &KeyMap, own: &mut KeyEditor, out: &mut Requests) {
    let Some(Listening::Bind { action, replaces, pressed: Some(pressed) }) = own.listening else { return };
    if holders(map, action, pressed).is_empty() {
        out.push(Request::ChangeKeys(vec![KeyChange::Set(action, with_key(map, action, replaces, pressed))]));
        own.listening = None;
    }
}

/// The other actions that a key starts in the same case.
fn holders(map: &KeyMap, action: Action, key: Shortcut) -> Vec<Action> {
    map.actions_of(key, When::of(action)).filter(|other| *other != action).collect()
}

/// The keys of an action with one more, or with one in place of another.
fn with_key(map: &KeyMap, action: Action, replaces: Option<Shortcut>, key: Shortcut) -> Vec<Shortcut> {
    let kept = map
        .own_keys(action)
        .iter()
        .filter(|old| Some(**old) == replaces || replaces.is_none() || **old != key);
    let mut all: Vec<Shortcut> = kept.map(|old| if Some(*old) == replaces { key } else { *old }).collect();
    if !all.contains(&key) {
        all.push(key);
    }
    all
}

/// A choice of the preset of keys.
pub(crate) fn key_presets(ui: &mut Ui, chosen: KeyPreset, out: &mut Requests) {
    for preset in KeyPreset::ALL {
        let entry = actions::describe(Action::UseKeys(preset));
        let button = ui.selectable_label(chosen == preset, preset.label()).accessible_name(entry.label);
        if button.on_hover_text(entry.description).clicked() {
            out.act(entry.action);
        }
    }
}

/// The presets, and what is listed.
fn head(ui: &mut Ui, map: &KeyMap, own: &mut KeyEditor, out: &mut Requests) {
    ui.horizontal_wrapped(|ui| {
        key_presets(ui, map.preset(), out);
        ui.separator();
        let reset = ui.add_enabled(map.has_changes(), Button::new("Reset all"));
        let reset = reset
            .on_hover_text(format!("Restore all keys of the {} preset", map.preset().label()))
            .on_disabled_hover_text("No key of this preset has been changed.");
        if reset.clicked() {
            own.listening = None;
            out.push(Request::ChangeKeys(vec![KeyChange::ResetAll]));
        }
    });
    ui.horizontal_wrapped(|ui| {
        let width = 240.0_f32.min(ui.available_width());
        let field = text_field(&mut own.text).hint_text("Find by name").desired_width(width);
        ui.add(field).accessible_name("Find by name");
        let finds = own.listening == Some(Listening::Find);
        let text = match own.key {
            _ if finds => "Press a key…".to_owned(),
            Some(key) => format!("Key: {}", key.written(ui.ctx())),
            None => "Find by key".to_owned(),
        };
        let find =
            ui.add(Button::new(text).selected(finds || own.key.is_some())).accessible_name("Find by key");
        if find.on_hover_text("Press a key and see what it does; click again to list all").clicked() {
            own.listening = (!finds && own.key.is_none()).then_some(Listening::Find);
            own.key = None;
        }
        ui.checkbox(&mut own.only_changed, "Changed only")
            .on_hover_text("List only actions whose keys were changed");
    });
}

/// Lists the actions in groups, those without a key in the preset last; returns whether there are any.
fn list(ui: &mut Ui, map: &KeyMap, own: &mut KeyEditor, out: &mut Requests) -> bool {
    let typed = own.text.trim().to_lowercase();
    let mut groups = key_reference::groups();
    let mut keyless = Vec::new();
    for (_, group) in &mut groups {
        group.retain(|action| is_listed(ui, map, own, *action, &typed));
        keyless.extend(group.extract_if(.., |action| map.default_keys(*action).is_empty()));
    }
    groups.push(("Without a key in this preset", keyless));
    groups.retain(|(_, group)| !group.is_empty());
    for (title, group) in &groups {
        ui.add_space(6.0);
        ui.label(RichText::new(*title).strong());
        for action in group {
            row(ui, map, *action, own, out);
        }
    }
    !groups.is_empty()
}

/// Whether an action is among those that the user looks for; `typed` is in lower case.
fn is_listed(ui: &Ui, map: &KeyMap, own: &KeyEditor, action: Action, typed: &str) -> bool {
    let keys = map.own_keys(action);
    let has_key =
        |key: Shortcut| keys.contains(&key) || key.off_the_pad().is_some_and(|key| keys.contains(&key));
    let is_named = || {
        let entry = actions::describe(action);
        let names = std::iter::once(entry.label).chain(entry.synonyms.iter().copied()).map(str::to_lowercase);
        let keys = keys.iter().map(|key| key.written(ui.ctx()).to_lowercase());
        keys.chain(names).any(|text| text.contains(typed))
    };
    own.key.is_none_or(has_key)
        && (!own.only_changed || map.is_changed(action))
        && (typed.is_empty() || is_named())
}

/// An action with its keys.
fn row(ui: &mut Ui, map: &KeyMap, action: Action, own: &mut KeyEditor, out: &mut Requests) {
    let entry = actions::describe(action);
    let is_changed = map.is_changed(action);
    let waits = matches!(own.listening, Some(Listening::Bind { action: of, .. }) if of == action);
    ui.horizontal(|ui| {
        let text = RichText::new(entry.label);
        let text = if is_changed { text.color(ui.visuals().hyperlink_color) } else { text };
        let label = ui.label(text).on_hover_text(entry.description);
        if is_changed {
            label.on_hover_text("Its keys were changed");
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            if is_changed {
                let name = format!("Reset the keys of {}", entry.label);
                if icon_button(ui, Icon::Undo, &name, false).on_hover_text(&name).clicked() {
                    own.listening = None;
                    out.push(Request::ChangeKeys(vec![KeyChange::Reset(action)]));
                }
            }
            if waits {
                waiting(ui, map, action, own, out);
                return;
            }
            let name = format!("Add a key to {}", entry.label);
            if ui
                .add(Button::new("+").min_size(vec2(22.0, 0.0)))
                .on_hover_text(&name)
                .accessible_name(&name)
                .clicked()
            {
                own.listening = Some(Listening::Bind { action, replaces: None, pressed: None });
            }
            for key in map.own_keys(action).iter().rev() {
                let text = key.written(ui.ctx());
                let button = ui.add(Button::new(RichText::new(&text).monospace()));
                let button = button.accessible_name(format!("{}: {text}", entry.label));
                if button.on_hover_text("Change or remove this key").clicked() {
                    own.listening = Some(Listening::Bind { action, replaces: Some(*key), pressed: None });
                }
            }
        });
    });
    if waits {
        conflict(ui, map, action, own, out);
    }
    for key in map.own_keys(action) {
        for other in holders(map, action, *key) {
            let text = format!("{} also starts {}.", key.written(ui.ctx()), actions::describe(other).label);
            ui.colored_label(ui.visuals().warn_fg_color, text);
        }
    }
}

/// What can be done while an action waits for its key, from right to left.
fn waiting(ui: &mut Ui, map: &KeyMap, action: Action, own: &mut KeyEditor, out: &mut Requests) {
    let Some(Listening::Bind { replaces, pressed, .. }) = own.listening else { return };
    if ui.button("Cancel").on_hover_text("Keep the keys as they are (Escape)").clicked() {
        own.listening = None;
    }
    if pressed.is_none()
        && let Some(old) = replaces
    {
        let text = old.written(ui.ctx());
        if ui.button("Remove").on_hover_text(format!("Remove {text} from this action")).clicked() {
            let mut keys = map.own_keys(action).to_vec();
            keys.retain(|key| *key != old);
            own.listening = None;
            out.push(Request::ChangeKeys(vec![KeyChange::Set(action, keys)]));
        }
    }
    let text = pressed.map_or_else(|| "Press a key…".to_owned(), |key| key.written(ui.ctx()));
    ui.label(RichText::new(text).strong());
}

/// Names what else the pressed key starts, and offers to take it over.
fn conflict(ui: &mut Ui, map: &KeyMap, action: Action, own: &mut KeyEditor, out: &mut Requests) {
    let Some(Listening::Bind { replaces, pressed: Some(pressed), .. }) = own.listening else { return };
    let others = holders(map, action, pressed);
    let names: Vec<&str> = others.iter().map(|other| actions::describe(*other).label).collect();
    let key = pressed.written(ui.ctx());
    ui.horizontal_wrapped(|ui| {
        ui.colored_label(ui.visuals().warn_fg_color, format!("{key} starts {}.", names.join(" and ")));
        let take = ui.button("Take it over").on_hover_text(format!("Use {key} for this action instead"));
        if take.clicked() {
            let mut changes: Vec<KeyChange> = Vec::new();
            for other in others {
                let mut keys = map.own_keys(other).to_vec();
                keys.retain(|key| *key != pressed);
                changes.push(KeyChange::Set(other, keys));
            }
            changes.push(KeyChange::Set(action, with_key(map, action, replaces, pressed)));
            out.push(Request::ChangeKeys(changes));
            own.listening = None;
        }
        let again = ui.button("Press another").on_hover_text("Choose another key");
        if again.clicked() {
            own.listening = Some(Listening::Bind { action, replaces, pressed: None });
        }
    });
}

/// Lists the gestures; returns whether there are any.
fn mouse_list(ui: &mut Ui, map: &KeyMap, own: &KeyEditor) -> bool {
    if own.only_changed || own.key.is_some() {
        return false;
    }
    let typed = own.text.trim().to_lowercase();
    let own_gestures = mouse::described().map(|(name, columns)| (name, map.preset().of(columns)));
    let of_camera = mouse::camera_described().map(|(name, columns)| (name, map.camera().of_columns(columns)));
    let all = of_camera.chain(own_gestures).chain(mouse::SHARED_GESTURES.iter().copied());
    let is_listed = |(name, how): &(&str, &str)| {
        !how.is_empty() && (name.to_lowercase().contains(&typed) || how.to_lowercase().contains(&typed))
    };
    let listed: Vec<_> = all.filter(is_listed).collect();
    if listed.is_empty() {
        return false;
    }
    ui.add_space(6.0);
    ui.label(RichText::new("In the viewport").strong());
    for (name, how) in &listed {
        ui.horizontal_wrapped(|ui| {
            ui.label(*name);
            ui.label(RichText::new(*how).small().weak());
        });
    }
    true
}
