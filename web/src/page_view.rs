//! The state that panels read but don't change: the session and the other parts of the page.

use std::ops::Deref;

use editor::OpId;
use egui::ThemePreference;
use halfedge::Element;

use crate::bezier::Player;
use crate::input::actions::{Action, Entry};
use crate::input::availability;
use crate::input::key_preset::KeyPreset;
use crate::input::keys;
use crate::session::Session;
use crate::shown::Shown;
use crate::transforming::{CursorAction, Gizmo};
use crate::view::pane::Split;
use crate::view::{Tool, View};
use crate::widgets::number_box::length_unit;
use viewport::{Rotation, Shading};

/// Everything that a panel may read.
#[derive(Clone, Copy)]
pub(crate) struct Page<'a> {
    pub session: &'a Session,
    pub shown: &'a Shown,
    pub view: &'a View,
    pub player: &'a Player,
}

impl Deref for Page<'_> {
    type Target = Session;

    fn deref(&self) -> &Session {
        self.session
    }
}

impl Page<'_> {
    /// Why an action can't be done now, as a sentence that says what to do first; none if it can.
    pub fn why_not(&self, action: Action) -> Option<String> {
        if matches!(action, Action::Views(split) if split != Split::One) && self.shown.narrow {
            return Some("There is room for one view only. Make the window wider.".into());
        }
        if action == Action::Fly && self.shown.touch {
            return Some("Flying needs a keyboard and a mouse.".into());
        }
        availability::why_not(action, self.session, self.shown.kind, self.player)
    }

    /// What an action is called now: undo and redo name their step.
    pub fn label_of(&self, entry: &Entry) -> String {
        let step = match entry.action {
            // An ongoing edit is cancelled instead.
            Action::Undo if self.editor.is_editing() => None,
            Action::Undo => self.editor.next_undo(),
            Action::Redo => self.editor.next_redo(),
            _ => None,
        };
        step.map_or_else(|| entry.label.to_owned(), |step| format!("{} {step}", entry.label))
    }

    /// The kind of element that is selected, or that a click would select.
    pub fn selecting_kind(&self) -> Element {
        let selection = self.editor.selection();
        if selection.is_empty() { self.shown.kind } else { selection.kind() }
    }

    /// Whether the edit that follows the pointer is this action's.
    pub fn is_live(&self, action: Action) -> bool {
        let id = match action {
            Action::Operation(id) => id,
            Action::SlideSplit => OpId::SplitEdge,
            _ => return false,
        };
        self.live.as_ref().is_some_and(|live| live.id == id)
    }

    /// The preset of keys in effect; `Action::UseKeys` takes another.
    pub fn key_preset(&self) -> KeyPreset {
        keys::map(&self.ctx).preset()
    }

    /// Whether a toggle is on; none for actions that are not toggles.
    pub fn is_on(&self, action: Action) -> Option<bool> {
        let style = &self.view.style;
        let theme = self.ctx.options(|options| options.theme_preference);
        Some(match action {
            Action::Show(kind) => self.shown.kind == kind,
            Action::OnlySelected => self.shown.only_selected,
            Action::SelectTool => {
                self.view.tool == Tool::Orbit && self.live_settings.gizmo == Gizmo::Off && self.live.is_none()
            }
            Action::BoxSelect => self.view.tool == Tool::Box,
            Action::LassoSelect => self.view.tool == Tool::Lasso,
            Action::CircleSelect => self.view.tool == Tool::Circle,
            Action::LoopCutTool => {
                self.view.tool == Tool::LoopCut || self.is_live(Action::Operation(OpId::LoopCut))
            }
            Action::UpAxis(up) => self.view.camera.up == up,
            Action::Orthographic => self.view.camera.orthographic,
            Action::Views(split) => self.view.panes.split == split,
            Action::Camera(style) => keys::map(&self.ctx).own_camera() == Some(style),
            Action::CameraOfKeys => keys::map(&self.ctx).own_camera().is_none(),
            Action::FreeRotation => self.view.turning.rotation == Rotation::Trackball,
            Action::OrbitAbout(about) => self.view.turning.about == about,
            Action::Wireframe => style.wireframe,
            Action::XRay => style.x_ray,
            Action::Smooth => style.shading == Shading::Smooth,
            Action::AutoSmooth(degrees) => style.shading == Shading::Auto(degrees.into()),
            Action::ColorBy(by) => style.color_by == by,
            Action::Look(look) => style.look == look,
            Action::HideBacks => style.cull,
            Action::Mark(mark) => style.marks.has(mark),
            Action::Shadow => style.shadow,
            Action::Dots => style.vertices,
            Action::Grid => style.grid,
            Action::Gizmo(gizmo) => self.live_settings.gizmo == gizmo,
            Action::Snap => self.live_settings.snaps,
            Action::SnapTo(to) => self.live_settings.snap_to == to,
            Action::Soft => self.live_settings.soft,
            Action::PivotAt(pivot) => self.live_settings.pivot == pivot,
            Action::Cursor(CursorAction::Show) => self.view.cursor.is_shown,
            Action::Mirror(symmetry) => self.live_settings.symmetry == symmetry,
            Action::Orient(orientation) => self.live_settings.orientation == orientation,
            Action::Welcome => self.shown.welcome,
            Action::History => self.shown.shows_history(),
            Action::Overlay => self.shown.overlay,
            Action::Numbers => self.shown.numbers,
            Action::AddToSelection => self.shown.adds,
            Action::Arrange(arrangement) => self.shown.is_arranged && self.shown.arrangement == arrangement,
            Action::LengthUnit(unit) => length_unit(&self.ctx) == unit,
            Action::InterfaceScale(percent) => self.shown.scale_percent == percent,
            Action::LeftPanel => self.shown.left,
            Action::RightPanel => self.shown.right,
            Action::WholeCurve => self.player.controls.whole,
            Action::ControlNets => self.player.controls.nets,
            Action::Play => self.player.controls.playing,
            Action::UseKeys(preset) => self.key_preset() == preset,
            Action::SystemTheme => theme == ThemePreference::System,
            Action::LightTheme => theme == ThemePreference::Light,
            Action::DarkTheme => theme == ThemePreference::Dark,
            _ => return None,
        })
    }
}
