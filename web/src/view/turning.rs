//! How the view is turned, and about what.

use glam::DVec3;
use viewport::Rotation;

use crate::input::camera_style::OrbitAbout;
use crate::input::scroll::Scrolling;

/// The settings, and the orbit in progress.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Turning {
    pub rotation: Rotation,
    pub about: OrbitAbout,
    /// The point that the orbit in progress turns about; none for the middle of the view.
    pub center: Option<DVec3>,
    /// What scrolls.
    pub scrolling: Scrolling,
}
