//! How the page is arranged and scaled, kept for later visits.

use egui::{Context, Event as Input};
use serde::{Deserialize, Serialize};
use viewport::{Look, UpAxis};

use super::App;
use crate::embedding::{NAMES, Parts};
use crate::platform::Platform;
use crate::session::Session;
use crate::shown::{Arrangement, Sheet, Shown};
use crate::theme;
use crate::view::View;
use crate::view::pane::{self, Split};

/// The key of the setting with the arrangement.
const LAYOUT_SETTING: &str = "layout";
/// The key of the setting with the interface's scale in percent.
const SCALE_SETTING: &str = "scale";

/// The key of the setting with the axis that points upwards.
const UP_AXIS_SETTING: &str = "up-axis";

/// The scales in percent that a setting may hold.
const SCALES_PERCENT: std::ops::RangeInclusive<u16> = 50..=300;

/// What is open in an arrangement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Open {
    left: bool,
    right: bool,
    overlay: bool,
    numbers: bool,
    course_light: bool,
    #[serde(default = "yes")]
    history: bool,
    #[serde(default)]
    history_in_low: bool,
}

fn yes() -> bool {
    true
}

/// The arrangements and the sizes of panels, as they are kept.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Layout {
    arrangement: Arrangement,
    /// Whether the user chose the arrangement: the first visit is not quite like any of them.
    #[serde(default = "yes")]
    chosen: bool,
    model: Open,
    study: Open,
    sheet: Sheet,
    #[serde(default)]
    split: Split,
    /// Where the views meet, as parts of the viewport's width and height.
    #[serde(default = "middle")]
    divide: [f32; 2],
    /// The widths of the panels on the left and on the right, in points.
    pub widths: [f32; 2],
    /// The height of the list of steps, in points.
    #[serde(default = "initial_history_height")]
    pub history_height: f32,
}

fn middle() -> [f32; 2] {
    pane::MIDDLE.into()
}

fn initial_history_height() -> f32 {
    176.0
}

impl Default for Layout {
    /// That of the first visit: the study layout's panels, in the studio's light.
    fn default() -> Self {
        Self {
            arrangement: Arrangement::default(),
            chosen: false,
            model: initial(Arrangement::Model),
            study: Open {
                overlay: false,
                numbers: false,
                course_light: false,
                ..initial(Arrangement::Study)
            },
            sheet: Sheet::default(),
            split: Split::default(),
            divide: middle(),
            widths: [332.0, 300.0],
            history_height: initial_history_height(),
        }
    }
}

fn initial(arrangement: Arrangement) -> Open {
    let study = arrangement == Arrangement::Study;
    Open {
        left: study,
        right: true,
        overlay: study,
        numbers: study,
        course_light: study,
        history: true,
        history_in_low: false,
    }
}

/// Leaves the parts of the page out that its address doesn't ask for.
pub(super) fn load_parts(session: &mut Session, shown: &mut Shown) {
    let (parts, unknown) = Parts::of(&*session.platform);
    shown.parts = parts;
    if !unknown.is_empty() {
        let text = format!(
            "The address asks for panels that don't exist: {}. They are {}.",
            unknown.join(", "),
            NAMES.join(", ")
        );
        session.warn(text, Vec::new());
    }
}

impl Layout {
    /// The layout of the last visit.
    pub fn load(platform: &dyn Platform) -> Self {
        let kept = platform.load_setting(LAYOUT_SETTING);
        let kept: Option<Self> = kept.and_then(|kept| serde_json::from_str(&kept).ok());
        let are_sizes = |kept: &Self| kept.sizes().iter().all(|size| (1.0..=4096.0).contains(size));
        let are_parts = |kept: &Self| kept.divide.iter().all(|part| (0.0..=1.0).contains(part));
        kept.filter(are_sizes).filter(are_parts).unwrap_or_default()
    }

    /// The sizes of all panels.
    fn sizes(&self) -> [f32; 3] {
        let [left, right] = self.widths;
        [left, right, self.history_height]
    }

    fn open(&mut self, arrangement: Arrangement) -> &mut Open {
        match arrangement {
            Arrangement::Model => &mut self.model,
            Arrangement::Study => &mut self.study,
        }
    }
}

fn store(layout: &Layout, platform: &mut dyn Platform) {
    if let Ok(text) = serde_json::to_string(layout) {
        platform.store_setting(LAYOUT_SETTING, &text);
    }
}

/// Takes the scale and the up axis of the last visit.
pub(super) fn load_scale_and_axis(app: &mut App) {
    let platform = &*app.session.platform;
    app.shown.scale_percent = load_scale(platform);
    app.view.camera.up = load_up_axis(platform);
}

/// The scale of the last visit, in percent.
fn load_scale(platform: &dyn Platform) -> u16 {
    let kept = platform.load_setting(SCALE_SETTING).and_then(|kept| kept.parse().ok());
    kept.filter(|percent| SCALES_PERCENT.contains(percent)).unwrap_or(100)
}

/// The up axis of the last visit.
fn load_up_axis(platform: &dyn Platform) -> UpAxis {
    match platform.load_setting(UP_AXIS_SETTING).as_deref() {
        Some("z") => UpAxis::Z,
        _ => UpAxis::Y,
    }
}

/// Shows the scene with this axis upwards, and keeps it for later visits.
pub(super) fn set_up_axis(session: &mut Session, view: &mut View, up: UpAxis) {
    view.change_cameras(|camera| camera.up = up);
    let name = match up {
        UpAxis::Y => "y",
        UpAxis::Z => "z",
    };
    session.platform.store_setting(UP_AXIS_SETTING, name);
}

/// The zoom for a scale, in a window of a width in CSS pixels. A page scaled up so far that it fits no longer
/// would be of no use.
fn zoom(scale_percent: u16, window_width: f32) -> f32 {
    let most = (window_width / theme::MIN_PAGE_WIDTH).max(1.0);
    (f32::from(scale_percent) / 100.0).min(most)
}

impl App {
    /// Arranges the page; where it is arranged like this already, as at first.
    pub(super) fn arrange(&mut self, arrangement: Arrangement) {
        if self.shown.arrangement == arrangement {
            *self.layout.open(arrangement) = initial(arrangement);
        }
        (self.layout.arrangement, self.layout.chosen) = (arrangement, true);
        self.apply_layout();
        store(&self.layout, &mut *self.session.platform);
    }

    /// Opens and closes panels as the layout says.
    pub(super) fn apply_layout(&mut self) {
        let arrangement = self.layout.arrangement;
        let open = *self.layout.open(arrangement);
        let shown = &mut self.shown;
        (shown.arrangement, shown.sheet, shown.split) = (arrangement, self.layout.sheet, self.layout.split);
        shown.is_arranged = self.layout.chosen;
        self.view.panes.divide = self.layout.divide.into();
        (shown.left, shown.right, shown.history) = (open.left, open.right, open.history);
        shown.history_in_low = open.history_in_low;
        (shown.overlay, shown.numbers) = (open.overlay, open.numbers);
        let look = &mut self.view.style.look;
        if open.course_light {
            *look = Look::Course;
        } else if *look == Look::Course {
            *look = Look::Studio;
        }
    }

    /// Keeps what is open for later visits, if it has changed.
    pub(super) fn keep_layout(&mut self, widths: [f32; 2]) {
        let Shown {
            arrangement, left, right, overlay, numbers, history, history_in_low, sheet, split, ..
        } = self.shown;
        let history_height = self.panels.history.height.unwrap_or(self.layout.history_height);
        let divide = self.view.panes.divide.into();
        let mut layout = Layout { arrangement, sheet, split, divide, widths, history_height, ..self.layout };
        let course_light = self.view.textures.chosen_look(&self.view.style) == Look::Course;
        *layout.open(arrangement) =
            Open { left, right, overlay, numbers, course_light, history, history_in_low };
        // While a panel is being dragged, its width changes in every frame.
        let dragging = self.session.ctx.input(|input| input.pointer.any_down());
        if layout == self.layout || dragging {
            return;
        }
        self.layout = layout;
        store(&layout, &mut *self.session.platform);
    }

    /// Scales texts and controls, and keeps the scale for later visits.
    pub(super) fn set_scale(&mut self, percent: u16) {
        self.shown.scale_percent = percent;
        self.session.platform.store_setting(SCALE_SETTING, &percent.to_string());
    }

    /// Fits the sizes of controls to the window, and to the mouse or the fingers that were used last.
    pub(super) fn fit(&mut self, ctx: &Context) {
        let width = ctx.content_rect().width();
        let zoom = zoom(self.shown.scale_percent, width * ctx.zoom_factor());
        if (zoom - ctx.zoom_factor()).abs() > 1e-3 {
            ctx.set_zoom_factor(zoom);
            ctx.request_repaint();
        }
        let (by_finger, by_mouse, is_down) = ctx.input(|input| {
            let any = |wanted: fn(&Input) -> bool| input.events.iter().any(wanted);
            let moves = any(|event| matches!(event, Input::PointerMoved(_) | Input::MouseMoved(_)));
            let touches = any(|event| matches!(event, Input::Touch { .. }));
            (touches, moves, input.pointer.any_down() || input.any_touches())
        });
        if by_finger || by_mouse {
            self.fingers = by_finger;
        }
        self.shown.narrow = width < theme::NARROW_WIDTH_POINTS;
        self.shown.low = ctx.content_rect().height() < theme::LOW_HEIGHT_POINTS;
        let touch = self.fingers || self.shown.narrow;
        if touch != self.shown.touch {
            // Nothing moves under a finger that is about to tap it. Lifting it makes a frame, and the one after that can
            // fit.
            if by_finger && !is_down {
                ctx.request_repaint();
            } else if !is_down {
                self.shown.touch = touch;
            }
        }
        theme::set_touch(ctx, self.shown.touch);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_scaled_up_no_further_than_fits() {
        assert_eq!(zoom(150, 1280.0), 1.5);
        assert_eq!(zoom(80, 390.0), 0.8);
        assert_eq!(zoom(150, 380.0), 1.0);
        assert_eq!(zoom(150, 320.0), 1.0);
        assert_eq!(zoom(150, 475.0), 1.25);
    }
}
