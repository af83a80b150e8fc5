//! The keys in effect: a preset, and what the user changed of it.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::actions::{self, Action};
use super::camera_style::CameraStyle;
use super::key_preset::KeyPreset;
use super::key_table;
use super::mouse::Mouse;
use super::shortcut::Shortcut;

/// When a key means something. Keys of the special cases come before those that always count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Always.
    Always,
    /// While a Bezier curve or surface is active.
    Bezier,
    /// While elements are selected with the circle.
    Circle,
    /// While a half-edge is selected in the Study layout.
    Halfedge,
}

impl When {
    /// When the keys of an action count.
    pub fn of(action: Action) -> Self {
        match action {
            Action::NextLevel
            | Action::WholeCurve
            | Action::ControlNets
            | Action::Play
            | Action::AddPoint
            | Action::DeletePoint
            | Action::ElevateDegree
            | Action::SplitCurve => Self::Bezier,
            Action::LargerCircle | Action::SmallerCircle => Self::Circle,
            Action::VertexOf | Action::EdgeOf | Action::FaceOf => Self::Halfedge,
            _ => Self::Always,
        }
    }
}

/// An action with the keys that start it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The action.
    pub action: Action,
    /// Its keys; menus show the first.
    pub keys: Vec<Shortcut>,
    /// Whether they differ from the preset's.
    pub is_changed: bool,
}

/// The user's changes: for the name of each preset the names of actions with their keys. Kept as text, so that what this
/// version doesn't know stays for the one that does.
type Changes = BTreeMap<String, BTreeMap<String, Vec<String>>>;

/// A column of the table.
type Column = Vec<(Action, Vec<Shortcut>)>;

/// The keys of each preset, without changes.
static DEFAULTS: LazyLock<[Column; KeyPreset::COUNT]> = LazyLock::new(|| {
    KeyPreset::ALL.map(|preset| {
        let keys = |row: &key_table::Row| (row.0, Shortcut::parse_all(preset.of(row.1)));
        key_table::ROWS.iter().map(keys).collect()
    })
});

/// The keys in effect.
#[derive(Clone, Debug, Default)]
pub struct KeyMap {
    preset: KeyPreset,
    /// The style of the camera, where it isn't that of the preset.
    camera: Option<CameraStyle>,
    changes: Changes,
    /// The actions that have keys, or had some before a change; the changed ones first.
    bindings: Vec<Binding>,
}

impl KeyMap {
    /// The keys of a preset, without changes.
    pub fn new(preset: KeyPreset) -> Self {
        let mut map = Self { preset, ..Self::default() };
        map.rebuild();
        map
    }

    /// The preset.
    pub fn preset(&self) -> KeyPreset {
        self.preset
    }

    /// Takes another preset, with the changes that were made to it.
    pub fn set_preset(&mut self, preset: KeyPreset) {
        self.preset = preset;
        self.rebuild();
    }

    /// Moves the camera in a style of its own, or in that of the preset.
    pub fn set_camera(&mut self, style: Option<CameraStyle>) {
        self.camera = style;
    }

    /// The style that was chosen for the camera; none if it is that of the preset.
    pub fn own_camera(&self) -> Option<CameraStyle> {
        self.camera
    }

    /// The style in which the camera is moved.
    pub fn camera(&self) -> CameraStyle {
        self.camera.unwrap_or(CameraStyle::of(self.preset))
    }

    /// What clicks and drags do.
    pub fn mouse(&self) -> &'static Mouse {
        Mouse::of(self.preset, self.camera())
    }

    /// The actions that have keys, or had some before a change.
    pub fn bindings(&self) -> &[Binding] {
        &self.bindings
    }

    /// The keys of an action in the preset.
    pub fn default_keys(&self, action: Action) -> &'static [Shortcut] {
        let [course, blender, maya] = &*DEFAULTS;
        let table = self.preset.of([course, blender, maya]);
        table.iter().find(|(bound, _)| *bound == action).map_or(&[], |(_, keys)| keys)
    }

    /// The keys of an action, without those of its family.
    pub fn own_keys(&self, action: Action) -> &[Shortcut] {
        self.binding(action).map_or(&[], |binding| &binding.keys)
    }

    /// The keys that start an action: its own, or those of an operation of the same family.
    pub fn keys_of(&self, action: Action) -> &[Shortcut] {
        let own = self.own_keys(action);
        let family = match action {
            Action::Operation(id) if own.is_empty() => id.spec().family,
            _ => None,
        };
        let Some(family) = family else { return own };
        let shares = |binding: &&Binding| match binding.action {
            Action::Operation(id) => id.spec().family == Some(family) && !binding.keys.is_empty(),
            _ => false,
        };
        self.bindings.iter().find(shares).map_or(own, |binding| &binding.keys)
    }

    /// Whether the user changed the keys of an action.
    pub fn is_changed(&self, action: Action) -> bool {
        self.binding(action).is_some_and(|binding| binding.is_changed)
    }

    /// Whether the user changed any key of the preset.
    pub fn has_changes(&self) -> bool {
        self.bindings.iter().any(|binding| binding.is_changed)
    }

    fn binding(&self, action: Action) -> Option<&Binding> {
        self.bindings.iter().find(|binding| binding.action == action)
    }

    /// The action of a key: that of the first of the cases in which it means something.
    pub fn action_of(&self, pressed: Shortcut, cases: &[When]) -> Option<Action> {
        let find = |shortcut: Shortcut| cases.iter().find_map(|&when| self.actions_of(shortcut, when).next());
        find(pressed).or_else(|| find(pressed.off_the_pad()?))
    }

    /// The actions that a key starts in a case: more than one only where changes disagree with a new version's preset.
    pub fn actions_of(&self, shortcut: Shortcut, when: When) -> impl Iterator<Item = Action> {
        let bound = self
            .bindings
            .iter()
            .filter(move |binding| binding.keys.contains(&shortcut) && When::of(binding.action) == when);
        bound.map(|binding| binding.action)
    }

    /// Gives an action other keys.
    pub fn set_keys(&mut self, action: Action, keys: &[Shortcut]) {
        if keys == self.default_keys(action) {
            return self.reset(action);
        }
        let keys = keys.iter().map(|key| key.text()).collect();
        self.changes.entry(self.preset.name().to_owned()).or_default().insert(action.name(), keys);
        self.rebuild();
    }

    /// Gives an action the preset's keys again.
    pub fn reset(&mut self, action: Action) {
        if let Some(changes) = self.changes.get_mut(self.preset.name()) {
            changes.remove(&action.name());
        }
        self.rebuild();
    }

    /// Gives every action the preset's keys again.
    pub fn reset_all(&mut self) {
        self.changes.remove(self.preset.name());
        self.rebuild();
    }

    /// Works out the keys in effect.
    fn rebuild(&mut self) {
        let changes = self.changes.get(self.preset.name());
        let mut bindings: Vec<Binding> = Vec::new();
        for action in actions::all().map(|entry| entry.action) {
            let changed = changes.and_then(|changes| changes.get(&action.name()));
            let keys: Vec<Shortcut> = match changed {
                Some(texts) => texts.iter().filter_map(|text| Shortcut::parse(text)).collect(),
                None => self.default_keys(action).to_vec(),
            };
            if !keys.is_empty() || changed.is_some() {
                bindings.push(Binding { action, keys, is_changed: changed.is_some() });
            }
        }
        bindings.sort_by_key(|binding| !binding.is_changed);
        self.bindings = bindings;
    }

    /// The changes to all presets as JSON, for the settings.
    pub fn changes_to_json(&self) -> String {
        serde_json::json!(self.changes).to_string()
    }

    /// Takes changes from the settings.
    ///
    /// # Errors
    /// They are not what [`KeyMap::changes_to_json`] writes; the keys stay as they are.
    pub fn take_changes(&mut self, json: &str) -> Result<(), serde_json::Error> {
        self.changes = serde_json::from_str(json)?;
        self.rebuild();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use editor::OpId;
    use std::collections::HashMap;

    fn key(text: &str) -> Shortcut {
        Shortcut::parse(text).expect("a key")
    }

    #[test]
    fn no_key_means_two_things() {
        for preset in KeyPreset::ALL {
            let mut seen = HashMap::new();
            for binding in KeyMap::new(preset).bindings() {
                for shortcut in &binding.keys {
                    let case = (format!("{:?}", When::of(binding.action)), *shortcut);
                    if let Some(other) = seen.insert(case, binding.action) {
                        panic!("{preset:?}: {} starts {:?} and {other:?}", shortcut.text(), binding.action);
                    }
                }
            }
        }
    }

    #[test]
    fn every_row_is_of_an_action_in_a_menu_and_every_key_can_be_read() {
        for (at, (action, columns)) in key_table::ROWS.iter().enumerate() {
            assert!(actions::all().any(|entry| entry.action == *action), "{action:?}");
            assert!(
                key_table::ROWS.iter().skip(at + 1).all(|row| row.0 != *action),
                "{action:?} is there twice"
            );
            assert!(columns.iter().any(|column| !column.is_empty()), "{action:?} has no key");
            for text in columns.iter().flat_map(|column| column.split(' ')).filter(|text| !text.is_empty()) {
                assert_eq!(Shortcut::parse(text).map(Shortcut::text).as_deref(), Some(text), "{action:?}");
            }
        }
    }

    #[test]
    fn all_presets_share_the_keys_of_every_program() {
        let shared = [
            ("Ctrl+Z", Action::Undo),
            ("Ctrl+Shift+Z", Action::Redo),
            ("Ctrl+Y", Action::Redo),
            ("Ctrl+O", Action::Open),
            ("Ctrl+S", Action::Save),
            ("Ctrl+K", Action::Palette),
            ("F3", Action::Palette),
            ("F1", Action::Shortcuts),
            ("?", Action::Shortcuts),
            ("Escape", Action::Cancel),
            ("Delete", Action::Operation(OpId::DeleteFaces)),
        ];
        for preset in KeyPreset::ALL {
            for (text, action) in shared {
                assert_eq!(KeyMap::new(preset).action_of(key(text), &[When::Always]), Some(action), "{text}");
            }
        }
    }

    #[test]
    fn operations_of_a_family_share_keys_that_they_have_none_of_their_own_for() {
        let map = KeyMap::new(KeyPreset::Course);
        assert_eq!(map.keys_of(Action::Operation(OpId::ExtrudeEdges)), [key("E")]);
        assert_eq!(map.keys_of(Action::Operation(OpId::BevelVertices)), [key("Ctrl+Shift+B")]);
        assert_eq!(map.keys_of(Action::Operation(OpId::DissolveEdge)), [key("Delete"), key("X")]);
        assert!(map.own_keys(Action::Operation(OpId::ExtrudeEdges)).is_empty());
    }

    #[test]
    fn special_cases_come_first_and_pad_keys_stand_for_others() {
        let map = KeyMap::new(KeyPreset::Course);
        assert_eq!(map.action_of(key("["), &[When::Always]), Some(Action::LeftPanel));
        assert_eq!(map.action_of(key("["), &[When::Circle, When::Always]), Some(Action::SmallerCircle));
        assert_eq!(map.action_of(key("Numpad."), &[When::Always]), Some(Action::Frame));
        assert_eq!(map.action_of(key("Numpad2"), &[When::Always]), None);
    }

    #[test]
    fn changes_belong_to_a_preset_and_survive_being_stored() {
        let mut map = KeyMap::new(KeyPreset::Course);
        map.set_keys(Action::Upsample, &[key("Ctrl+U")]);
        map.set_keys(Action::Downsample, &[]);
        assert_eq!(map.action_of(key("Ctrl+U"), &[When::Always]), Some(Action::Upsample));
        assert_eq!(map.action_of(key("U"), &[When::Always]), None);
        assert!(map.is_changed(Action::Downsample) && map.own_keys(Action::Downsample).is_empty());

        let mut again = KeyMap::new(KeyPreset::Blender);
        again.take_changes(&map.changes_to_json()).expect("what was written");
        assert!(!again.has_changes());
        again.set_keys(Action::Upsample, &[key("U")]);
        again.set_preset(KeyPreset::Course);
        assert_eq!(again.bindings(), map.bindings());
        again.reset(Action::Downsample);
        assert_eq!(again.own_keys(Action::Downsample), [key("D")]);
        again.reset_all();
        assert_eq!(again.bindings(), KeyMap::new(KeyPreset::Course).bindings());
        again.set_preset(KeyPreset::Blender);
        assert_eq!(again.own_keys(Action::Upsample), [key("U")]);
        // The preset's own keys are no change.
        again.set_keys(Action::Upsample, &[]);
        assert!(!again.has_changes());
    }

    #[test]
    fn what_another_version_stored_is_kept() {
        let mut map = KeyMap::new(KeyPreset::Course);
        let stored =
            r#"{"course":{"knife-of-the-future":["K"],"undo":["Ctrl+Unknown","Ctrl+U"]},"other":{}}"#;
        map.take_changes(stored).expect("known form");
        assert_eq!(map.own_keys(Action::Undo), [key("Ctrl+U")]);
        map.reset(Action::Undo);
        assert!(map.changes_to_json().contains("knife-of-the-future"));
        assert!(map.take_changes("[1]").is_err());
    }
}
