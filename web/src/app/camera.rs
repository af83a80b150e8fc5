//! How the camera is moved, kept for later visits.

use viewport::{Rotation, Side, UpAxis};

use crate::input::camera_style::{CameraStyle, OrbitAbout};
use crate::input::keys;
use crate::keeping::SavedView;
use crate::session::{Session, ViewTarget};
use crate::view::flight::Landing;
use crate::view::pane::Split;
use crate::view::{View, flying};

/// The key of the setting with the style of the gestures; without it, that of the preset of keys counts.
const STYLE_SETTING: &str = "camera";
/// The style's name that stands for that of the preset.
const OF_KEYS: &str = "keys";
/// The key of the setting with what the camera turns about.
const ABOUT_SETTING: &str = "orbit-about";
/// The key of the setting that says how drags turn the camera.
const ROTATION_SETTING: &str = "rotation";
const TRACKBALL: &str = "trackball";
const TURNTABLE: &str = "turntable";

/// Puts the settings of an earlier visit into effect.
pub(super) fn load(session: &mut Session, view: &mut View) {
    let setting = |key| session.platform.load_setting(key);
    view.turning.about = setting(ABOUT_SETTING).as_deref().and_then(OrbitAbout::named).unwrap_or_default();
    if setting(ROTATION_SETTING).as_deref() == Some(TRACKBALL) {
        view.turning.rotation = Rotation::Trackball;
    }
    let style = setting(STYLE_SETTING).as_deref().and_then(CameraStyle::named);
    take(session, style);
}

fn take(session: &mut Session, style: Option<CameraStyle>) {
    let mut map = (*keys::map(&session.ctx)).clone();
    map.set_camera(style);
    keys::set_map(&session.ctx, map);
}

/// Sets the view for a document that was opened or created.
pub(super) fn show_target(view: &mut View, session: &Session, target: ViewTarget) {
    // The side from which the plane of flat curves is seen from straight above.
    let above = match view.camera.up {
        UpAxis::Y => Side::Front,
        UpAxis::Z => Side::Top,
    };
    let was_from_above = view.camera.is_from(above);
    if view.panes.split != Split::One {
        // One of several views shows either as it should be seen.
    } else if target == ViewTarget::FlatCurves {
        view.camera.look_from(above);
    } else if was_from_above {
        // From straight above, an object that isn't flat hides its depth.
        view.reset();
    }
    view.cursor = Default::default();
    flying::end(view, Landing::Here, 0.0);
    view.frame_when_seen();
    if target == ViewTarget::Kept
        && let Some(saved) = session.editor.view().and_then(SavedView::read)
    {
        saved.show(view);
    }
}

/// Moves the camera with the gestures of a style, about what is usual with it; without one, as the preset of keys does.
pub(super) fn choose(session: &mut Session, view: &mut View, style: Option<CameraStyle>) {
    take(session, style);
    session.platform.store_setting(STYLE_SETTING, style.map_or(OF_KEYS, CameraStyle::name));
    orbit_about(session, view, keys::map(&session.ctx).camera().orbit_about());
}

/// Chooses what the camera turns about.
pub(super) fn orbit_about(session: &mut Session, view: &mut View, about: OrbitAbout) {
    view.turning.about = about;
    session.platform.store_setting(ABOUT_SETTING, about.name());
}

/// Switches between turning on a turntable and freely.
pub(super) fn toggle_rotation(session: &mut Session, view: &mut View) {
    let (rotation, name) = match view.turning.rotation {
        Rotation::Turntable => (Rotation::Trackball, TRACKBALL),
        Rotation::Trackball => (Rotation::Turntable, TURNTABLE),
    };
    view.turning.rotation = rotation;
    if rotation == Rotation::Turntable {
        view.change_cameras(|camera| camera.roll = 0.0);
    }
    session.platform.store_setting(ROTATION_SETTING, name);
}
