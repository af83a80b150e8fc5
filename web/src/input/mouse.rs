//! What clicks and drags in the viewport do in each preset, in one table.

use editor::SelectMode::{self, Extend, Remove, Replace, Toggle};
use egui::{Modifiers, PointerButton};
use halfedge::Element;
use std::sync::LazyLock;
use surface::selecting::Line;

use super::camera_style::CameraStyle;
use super::key_preset::KeyPreset;

/// What a gesture does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MouseAction {
    /// Turns the view.
    Orbit,
    /// Moves the view.
    Pan,
    /// Comes closer or goes away.
    Zoom,
    /// Selects in a box.
    Box,
    /// Selects what a line goes around.
    Lasso(SelectMode),
    /// Selects the element under the pointer.
    Select(SelectMode),
    /// Selects the line of elements under the pointer.
    Line(Line, SelectMode),
    /// Adds to the selection what the circle is drawn over.
    Paint,
    /// Slides the selected edges or vertices.
    Slide,
    /// Adds the shortest path to the element under the pointer.
    Path,
    /// Selects everything connected to the element under the pointer.
    Linked,
    /// Puts the 3D cursor where the pointer is.
    PlaceCursor,
    /// With the modifier held, a box or a lasso changes the selection in this way.
    Within(SelectMode),
}

use MouseAction as M;

/// An action, its name, and its gestures in each column, with commas between several.
type Row<const COLUMNS: usize> = (MouseAction, &'static str, [&'static str; COLUMNS]);

/// The gestures that move the camera, in each style. They come before those of the preset of keys.
#[rustfmt::skip]
static CAMERA_ROWS: &[Row<{ CameraStyle::COUNT }>] = &[
    // Action  Name               Course                                        Blender                              Maya               CAD                                             Trackpad
    (M::Orbit, "Orbit the view", ["drag, Alt+drag, middle-drag",               "middle-drag, Alt+drag",             "Alt+drag",        "right-drag, Shift+middle-drag, Alt+drag",      "scroll, middle-drag, Alt+drag"]),
    (M::Pan,   "Pan the view",   ["right-drag, Shift+drag, Shift+middle-drag", "Shift+middle-drag, Alt+Shift+drag", "Alt+middle-drag", "middle-drag, Alt+Shift+drag",                  "Shift+scroll, Shift+middle-drag, Alt+Shift+drag"]),
    (M::Zoom,  "Zoom",           ["Ctrl+middle-drag",                          "Ctrl+middle-drag, Ctrl+Alt+drag",   "Alt+right-drag",  "Ctrl+middle-drag, Ctrl+Alt+drag",              "Ctrl+scroll, Ctrl+middle-drag, Ctrl+Alt+drag"]),
];

#[rustfmt::skip]
static ROWS: &[Row<{ KeyPreset::COUNT }>] = &[
    // Action              Name                          Course                                     Blender                                  Maya
    (M::Select(Replace),   "Select",                    ["click",                                  "click",                                 "click"]),
    (M::Select(Extend),    "Add to the selection",      ["Shift+click",                            "",                                      "Ctrl+Shift+click"]),
    (M::Select(Toggle),    "Add or remove",             ["Ctrl+click",                             "Shift+click",                           "Shift+click"]),
    (M::Select(Remove),    "Remove from the selection", ["",                                       "",                                      "Ctrl+click"]),
    (M::Line(Line::Loop, Replace), "Select a loop",     ["Alt+click, double-click",                "Alt+click, double-click",               "double-click"]),
    (M::Line(Line::Loop, Extend),  "Add a loop",        ["Alt+Shift+click, Shift+double-click",    "Alt+Shift+click, Shift+double-click",   ""]),
    (M::Line(Line::Ring, Replace), "Select a ring",     ["Ctrl+Alt+click",                         "Ctrl+Alt+click",                        ""]),
    (M::Line(Line::Ring, Extend),  "Add a ring",        ["Ctrl+Alt+Shift+click",                   "Ctrl+Alt+Shift+click",                  ""]),
    (M::Path,              "Add the shortest path",     ["Ctrl+Shift+click",                       "Ctrl+click",                            "Shift+double-click"]),
    (M::Linked,            "Select linked",             ["",                                       "",                                      "double-click on a face"]),
    (M::PlaceCursor,       "Place the 3D cursor",       ["Shift+right-click",                      "Shift+right-click",                     "Shift+right-click"]),
    (M::Slide,             "Slide the selection",       ["",                                       "",                                      "Ctrl+Shift+middle-drag"]),
    (M::Box,               "Select in a box",           ["Ctrl+drag, Ctrl+Shift+drag",             "drag, Shift+drag, Ctrl+drag",           "drag, Shift+drag, Ctrl+drag, Ctrl+Shift+drag"]),
    (M::Paint,             "Paint a selection",         ["",                                       "",                                      "Tab+drag"]),
    (M::Lasso(Replace),    "Select with a lasso",       ["Ctrl+right-drag",                        "Ctrl+right-drag",                       ""]),
    (M::Lasso(Extend),     "Add with a lasso",          ["Ctrl+Shift+right-drag",                  "",                                      ""]),
    (M::Lasso(Toggle),     "Add or remove with a lasso", ["Ctrl+Alt+right-drag",                   "",                                      ""]),
    (M::Lasso(Remove),     "Remove with a lasso",       ["",                                       "Ctrl+Shift+right-drag",                 ""]),
    (M::Within(Extend),    "Add, in a box or a lasso",  ["Shift",                                  "Shift",                                 "Ctrl+Shift"]),
    (M::Within(Toggle),    "Add or remove, in a box or a lasso", ["Ctrl, Ctrl+Shift",              "",                                      "Shift"]),
    (M::Within(Remove),    "Remove, in a box or a lasso", ["",                                     "Ctrl",                                  "Ctrl"]),
];

/// Gestures that are the same in all presets.
pub static SHARED_GESTURES: &[(&str, &str)] = &[
    ("Zoom", "wheel, pinch, or Ctrl+wheel"),
    ("Orbit the view", "arrow keys, or one finger"),
    ("Pan the view", "Shift and the arrow keys, or two fingers"),
    ("Move the selection", "drag a selected element, or a handle of the gizmo"),
    ("Change the radius of soft selection", "drag to the left or right with the key of soft selection held"),
    ("Open a menu", "right-click"),
    (
        "Select with a circle",
        "the circle tool: drag; with Ctrl or the middle button, remove; wheel for the size",
    ),
    ("Select with a box or a lasso", "the tool: drag"),
    ("Move a control point", "drag it, on a Bezier curve or surface"),
    ("Add a control point", "double-click, on a Bezier curve"),
];

/// A gesture without the modifiers that are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Gesture {
    Click,
    /// The second click of two.
    DoubleClick {
        on_face: bool,
    },
    Drag(PointerButton),
    RightClick,
    /// Two fingers on a trackpad.
    Scroll,
    /// A drag with the first button while Tab is held.
    TabDrag,
    /// Nothing but the modifiers.
    Held,
}

/// A gesture with the modifiers that are held: Ctrl, Alt and Shift.
type Held = ([bool; 3], Gesture);

/// What clicks and drags do in a preset of keys and a style of the camera.
#[derive(Debug)]
pub struct Mouse {
    /// The style's column of the table, then the preset's.
    rows: Vec<(Held, MouseAction)>,
}

static MICE: LazyLock<[[Mouse; CameraStyle::COUNT]; KeyPreset::COUNT]> = LazyLock::new(|| {
    KeyPreset::ALL.map(|preset| {
        CameraStyle::ALL.map(|style| {
            let of_style =
                CAMERA_ROWS.iter().map(|(action, _, columns)| (*action, style.of_columns(*columns)));
            let of_preset = ROWS.iter().map(|(action, _, columns)| (*action, preset.of(*columns)));
            let gestures = of_style.chain(of_preset).flat_map(|(action, text)| {
                let texts = text.split(", ").filter(|text| !text.is_empty());
                texts.filter_map(move |text| Some((parse(text)?, action)))
            });
            Mouse { rows: gestures.collect() }
        })
    })
});

/// Reads a gesture such as `Ctrl+middle-drag`.
fn parse(text: &str) -> Option<Held> {
    let mut held = [false; 3];
    let mut gesture = Gesture::Held;
    for part in text.split('+') {
        match part {
            "Ctrl" => held[0] = true,
            "Alt" => held[1] = true,
            "Shift" => held[2] = true,
            "click" => gesture = Gesture::Click,
            "right-click" => gesture = Gesture::RightClick,
            "double-click" => gesture = Gesture::DoubleClick { on_face: false },
            "double-click on a face" => gesture = Gesture::DoubleClick { on_face: true },
            "Tab" => gesture = Gesture::TabDrag,
            "drag" if gesture == Gesture::TabDrag => {}
            "drag" => gesture = Gesture::Drag(PointerButton::Primary),
            "middle-drag" => gesture = Gesture::Drag(PointerButton::Middle),
            "scroll" => gesture = Gesture::Scroll,
            "right-drag" => gesture = Gesture::Drag(PointerButton::Secondary),
            _ => return None,
        }
    }
    Some((held, gesture))
}

impl Mouse {
    /// The gestures of a preset and a style of the camera.
    pub fn of(preset: KeyPreset, style: CameraStyle) -> &'static Self {
        let [course, blender, maya] = &*MICE;
        style.of_columns(preset.of([course, blender, maya]).each_ref())
    }

    fn find(&self, modifiers: Modifiers, gesture: Gesture) -> Option<MouseAction> {
        let held = [modifiers.command || modifiers.ctrl, modifiers.alt, modifiers.shift];
        let row = self.rows.iter().find(|(of_row, _)| *of_row == (held, gesture));
        row.map(|(_, action)| *action)
    }

    /// What a click does.
    pub fn click(&self, modifiers: Modifiers) -> Option<MouseAction> {
        self.find(modifiers, Gesture::Click)
    }

    /// What a right-click does; none where it opens a menu.
    pub fn right_click(&self, modifiers: Modifiers) -> Option<MouseAction> {
        self.find(modifiers, Gesture::RightClick)
    }

    /// What the second click of two does where elements of this kind are selected.
    pub fn double_click(&self, modifiers: Modifiers, kind: Element) -> Option<MouseAction> {
        let of_faces = || self.find(modifiers, Gesture::DoubleClick { on_face: true });
        let special = (kind == Element::Face).then(of_faces).flatten();
        special.or_else(|| self.find(modifiers, Gesture::DoubleClick { on_face: false }))
    }

    /// What a drag with a button does, where it begins on nothing that can be dragged. Where the camera leaves the first
    /// button free, it selects in a box.
    pub fn drag(&self, button: PointerButton, modifiers: Modifiers) -> Option<MouseAction> {
        let is_free = button == PointerButton::Primary && !modifiers.alt;
        self.find(modifiers, Gesture::Drag(button)).or(is_free.then_some(MouseAction::Box))
    }

    /// Whether a drag paints a selection while Tab is held.
    pub fn paints_with_tab(&self) -> bool {
        self.find(Modifiers::NONE, Gesture::TabDrag) == Some(MouseAction::Paint)
    }

    /// What two fingers on a trackpad do; none where they do what the wheel does.
    pub fn scroll(&self, modifiers: Modifiers) -> Option<MouseAction> {
        self.find(modifiers, Gesture::Scroll)
    }

    /// How a box or a lasso with these modifiers changes the selection.
    pub fn mode_within(&self, modifiers: Modifiers) -> SelectMode {
        match self.find(modifiers, Gesture::Held) {
            Some(MouseAction::Within(mode)) => mode,
            _ => Replace,
        }
    }
}

/// The names of what gestures do, with the gestures of each preset; empty where it has none.
pub fn described() -> impl Iterator<Item = (&'static str, [&'static str; KeyPreset::COUNT])> {
    ROWS.iter().map(|(_, name, columns)| (*name, *columns))
}

/// The movements of the camera, with the gestures of each style.
pub fn camera_described() -> impl Iterator<Item = (&'static str, [&'static str; CameraStyle::COUNT])> {
    CAMERA_ROWS.iter().map(|(_, name, columns)| (*name, *columns))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every preset with every style.
    fn all() -> impl Iterator<Item = (KeyPreset, CameraStyle, &'static Mouse)> {
        let styles = |preset| CameraStyle::ALL.map(|style| (preset, style, Mouse::of(preset, style)));
        KeyPreset::ALL.into_iter().flat_map(styles)
    }

    #[test]
    fn every_gesture_can_be_read_and_means_one_thing() {
        for (preset, style, mouse) in all() {
            let of_style =
                CAMERA_ROWS.iter().flat_map(|(_, _, columns)| style.of_columns(*columns).split(", "));
            let of_preset = ROWS.iter().flat_map(|(_, _, columns)| preset.of(*columns).split(", "));
            let count = of_style.chain(of_preset).filter(|text| !text.is_empty()).count();
            let rows = &mouse.rows;
            assert_eq!(rows.len(), count, "{preset:?}, {style:?}: a gesture can't be read");
            for (at, (gesture, action)) in rows.iter().enumerate() {
                let Some((_, again)) = rows.iter().skip(at + 1).find(|(other, _)| other == gesture) else {
                    continue;
                };
                // Another program's camera may take a drag that draws a box.
                let is_taken = style != CameraStyle::of(preset) && *again == M::Box;
                assert!(is_taken, "{preset:?}, {style:?}: {gesture:?} does {action:?} and {again:?}");
            }
        }
    }

    #[test]
    fn every_preset_has_the_gestures_that_one_cannot_do_without() {
        for (preset, style, mouse) in all() {
            for action in [M::Orbit, M::Pan, M::Zoom, M::Box, M::Select(Replace), M::Select(Toggle), M::Path]
            {
                let has = mouse.rows.iter().any(|(_, bound)| *bound == action);
                assert!(has, "{preset:?} with {style:?} has no {action:?}");
            }
        }
    }

    #[test]
    fn a_free_first_button_selects_in_a_box() {
        let course =
            |style| Mouse::of(KeyPreset::Course, style).drag(PointerButton::Primary, Modifiers::NONE);
        assert_eq!(course(CameraStyle::Course), Some(M::Orbit));
        assert_eq!(course(CameraStyle::Cad), Some(M::Box));
        let cad = Mouse::of(KeyPreset::Course, CameraStyle::Cad);
        assert_eq!(cad.drag(PointerButton::Secondary, Modifiers::NONE), Some(M::Orbit));
        assert_eq!(cad.drag(PointerButton::Primary, Modifiers::ALT), Some(M::Orbit));
        assert_eq!(cad.scroll(Modifiers::NONE), None);
        let trackpad = Mouse::of(KeyPreset::Blender, CameraStyle::Trackpad);
        assert_eq!(trackpad.scroll(Modifiers::SHIFT), Some(M::Pan));
    }

    #[test]
    fn gestures_on_faces_come_first() {
        let maya = Mouse::of(KeyPreset::Maya, CameraStyle::Maya);
        assert_eq!(maya.double_click(Modifiers::NONE, Element::Face), Some(M::Linked));
        assert_eq!(maya.double_click(Modifiers::NONE, Element::Edge), Some(M::Line(Line::Loop, Replace)));
        assert_eq!(maya.double_click(Modifiers::SHIFT, Element::Face), Some(M::Path));
        assert_eq!(maya.mode_within(Modifiers::SHIFT), Toggle);
        assert_eq!(maya.mode_within(Modifiers::NONE), Replace);
    }
}
