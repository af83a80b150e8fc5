//! What keys mean now, and the settings behind them: the preset and the changed keys.

use super::Panels;
use crate::bezier;
use crate::input::actions::Action;
use crate::input::key_map::When;
use crate::input::key_preset::KeyPreset;
use crate::input::keys::{self, KeyReader};
use crate::page_view::Page;
use crate::request::KeyChange;
use crate::session::Session;
use crate::shown::Arrangement;
use crate::view::Tool;

/// The key of the setting that names the preset, and of the parameter in the page's address.
const PRESET: &str = "keys";
/// The key of the setting with the changed keys of all presets.
const CHANGES: &str = "changed-keys";

/// Whether the key of an action counts while an edit follows the pointer: views, and edits that take its place.
pub(super) fn works_during_live_edit(action: Action) -> bool {
    matches!(
        action,
        Action::Move
            | Action::Rotate
            | Action::Scale
            | Action::Soft
            | Action::Snap
            | Action::Undo
            | Action::Frame
            | Action::FrameAll
            | Action::ResetView
            | Action::ZoomIn
            | Action::ZoomOut
            | Action::LookFrom(_)
            | Action::Orthographic
            | Action::AlignView
    )
}

/// Puts the keys of the page's address or of an earlier visit into effect.
pub(super) fn load(session: &mut Session) {
    let mut map = (*keys::map(&session.ctx)).clone();
    if let Some(stored) = session.platform.load_setting(CHANGES)
        && let Err(error) = map.take_changes(&stored)
    {
        session.warn(
            "The changed keys of earlier visits can't be read, so all keys are those of the preset."
                .to_owned(),
            vec![error.to_string()],
        );
    }
    let stored = session.platform.load_setting(PRESET);
    let mut preset = stored.as_deref().and_then(KeyPreset::named).unwrap_or_default();
    if let Some(wanted) = session.platform.parameter(PRESET) {
        match KeyPreset::named(&wanted) {
            Some(named) => preset = named,
            None => {
                let names = KeyPreset::ALL.map(KeyPreset::name).join(", ");
                session.warn(
                    format!("The address asks for keys that don't exist ({wanted:?}): use one of {names}."),
                    Vec::new(),
                );
            }
        }
    }
    map.set_preset(preset);
    keys::set_map(&session.ctx, map);
}

/// Takes a preset, and keeps it for later visits.
pub(super) fn choose(session: &mut Session, preset: KeyPreset) {
    let mut map = (*keys::map(&session.ctx)).clone();
    map.set_preset(preset);
    keys::set_map(&session.ctx, map);
    session.platform.store_setting(PRESET, preset.name());
}

/// Changes keys of the preset in effect, and keeps them for later visits.
pub(super) fn change(session: &mut Session, changes: Vec<KeyChange>) {
    let mut map = (*keys::map(&session.ctx)).clone();
    for change in changes {
        match change {
            KeyChange::Set(action, keys) => map.set_keys(action, &keys),
            KeyChange::Reset(action) => map.reset(action),
            KeyChange::ResetAll => map.reset_all(),
        }
    }
    session.platform.store_setting(CHANGES, &map.changes_to_json());
    keys::set_map(&session.ctx, map);
}

/// What keys mean now; none while a dialog takes them.
pub(super) fn reader(page: &Page<'_>, panels: &Panels) -> Option<KeyReader> {
    if panels.palette.open || panels.saving.is_open() {
        return None;
    }
    let mut cases = vec![When::Always];
    if bezier::active(&page.editor).is_some() {
        cases.insert(0, When::Bezier);
    }
    if page.view.tool == Tool::Circle {
        cases.insert(0, When::Circle);
    }
    let is_study = page.shown.arrangement == Arrangement::Study;
    if is_study && page.session.selected_halfedge().is_some() {
        cases.insert(0, When::Halfedge);
    }
    // egui itself closes an open menu on Escape.
    Some(KeyReader::new(&page.ctx, egui::Popup::is_any_open(&page.ctx), cases))
}
