//! The view as it is kept with a document.

use glam::DVec3;
use serde::{Deserialize, Serialize};
use viewport::Camera;

use crate::view::View;

/// The camera of the current view, and the 3D cursor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct SavedView {
    target: [f64; 3],
    yaw: f64,
    pitch: f64,
    roll: f64,
    distance: f64,
    fov_y: f64,
    orthographic: bool,
    #[serde(default)]
    cursor: [f64; 3],
    #[serde(default)]
    shows_cursor: bool,
}

impl SavedView {
    pub fn of(view: &View) -> Self {
        let Camera { target, yaw, pitch, roll, distance, fov_y, orthographic, .. } = view.camera;
        let (cursor, shows_cursor) = (view.cursor.at.to_array(), view.cursor.is_shown);
        let target = target.to_array();
        Self { target, yaw, pitch, roll, distance, fov_y, orthographic, cursor, shows_cursor }
    }

    /// Reads what was kept; none if it makes no sense.
    pub fn read(json: &str) -> Option<Self> {
        let view: Self = serde_json::from_str(json).ok()?;
        let numbers = [view.yaw, view.pitch, view.roll, view.distance, view.fov_y];
        let is_fine = numbers.iter().chain(&view.target).chain(&view.cursor).all(|number| number.is_finite())
            && view.distance > 0.0
            && view.pitch.abs() <= std::f64::consts::FRAC_PI_2
            && (0.01..3.0).contains(&view.fov_y);
        is_fine.then_some(view)
    }

    pub fn to_json(self) -> String {
        // Numbers can't fail to be written.
        serde_json::to_string(&self).unwrap_or_default()
    }

    /// Shows it, with the axis upwards that the user chose.
    pub fn show(self, view: &mut View) {
        let Self { target, yaw, pitch, roll, distance, fov_y, orthographic, cursor, shows_cursor } = self;
        (view.cursor.at, view.cursor.is_shown) = (cursor.into(), shows_cursor);
        view.camera = Camera {
            target: DVec3::from_array(target),
            yaw,
            pitch,
            roll,
            distance,
            fov_y,
            orthographic,
            ..view.camera
        };
        view.frame_due = 0;
    }
}
