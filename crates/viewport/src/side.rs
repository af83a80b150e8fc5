//! The sides from which the camera looks at a scene, and the axis that points upwards.

use crate::camera::MAX_PITCH_RADIANS;
use glam::{DVec3, dvec3};

/// The axis that points upwards. It changes the view only; coordinates stay.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    /// As in the OBJ files of most programs: the front faces +z.
    #[default]
    Y,
    /// As in Blender and CAD programs: the front faces -y.
    Z,
}

impl UpAxis {
    /// A vector of the scene, from one whose second component points upwards and whose third points to the front.
    pub fn to_scene(self, v: DVec3) -> DVec3 {
        match self {
            Self::Y => v,
            Self::Z => dvec3(v.x, -v.z, v.y),
        }
    }

    /// The inverse of [`UpAxis::to_scene`].
    pub fn to_upright(self, v: DVec3) -> DVec3 {
        match self {
            Self::Y => v,
            Self::Z => dvec3(v.x, v.z, -v.y),
        }
    }
}

/// A side of the scene. With y upwards the front faces +z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From +z.
    Front,
    /// From -z.
    Back,
    /// From +x.
    Right,
    /// From -x.
    Left,
    /// From +y.
    Top,
    /// From -y.
    Bottom,
}

impl Side {
    /// Every side.
    pub const ALL: [Self; 6] = [Self::Front, Self::Back, Self::Right, Self::Left, Self::Top, Self::Bottom];

    /// The side across.
    pub fn opposite(self) -> Self {
        match self {
            Self::Front => Self::Back,
            Self::Back => Self::Front,
            Self::Right => Self::Left,
            Self::Left => Self::Right,
            Self::Top => Self::Bottom,
            Self::Bottom => Self::Top,
        }
    }

    /// The yaw and pitch of a camera that looks from this side.
    pub(crate) fn angles(self) -> (f64, f64) {
        use std::f64::consts::{FRAC_PI_2, PI};
        match self {
            Self::Front => (0.0, 0.0),
            Self::Right => (FRAC_PI_2, 0.0),
            Self::Back => (PI, 0.0),
            Self::Left => (PI + FRAC_PI_2, 0.0),
            Self::Top => (0.0, MAX_PITCH_RADIANS),
            Self::Bottom => (0.0, -MAX_PITCH_RADIANS),
        }
    }
}
