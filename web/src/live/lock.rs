//! What an edit is limited to: an axis, or the plane across one.

use glam::{Mat3, Vec3};
use viewport::Camera;

use crate::transforming::Orientation;

/// The names of the axes.
pub(crate) const AXIS_NAMES: [&str; 3] = ["x", "y", "z"];

/// The axes that an edit may change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Lock {
    /// All of them.
    #[default]
    Free,
    /// One axis.
    Along(usize, Orientation),
    /// The plane across one axis.
    Across(usize, Orientation),
}

impl Lock {
    /// The lock after an axis key: first in the usual orientation, then in another one, then off.
    pub fn after_key(self, axis: usize, plane: bool, usual: Orientation) -> Self {
        let lock = if plane { Self::Across } else { Self::Along };
        match self {
            _ if self == lock(axis, usual) => lock(axis, usual.other()),
            _ if self == lock(axis, usual.other()) => Self::Free,
            _ => lock(axis, usual),
        }
    }

    /// The orientation that the lock is in.
    pub fn orientation(self, usual: Orientation) -> Orientation {
        match self {
            Self::Free => usual,
            Self::Along(_, orientation) | Self::Across(_, orientation) => orientation,
        }
    }

    /// The axes that may change: 0, 1 and 2 are x, y and z.
    pub fn free_axes(self) -> &'static [usize] {
        match self {
            Self::Free => &[0, 1, 2],
            Self::Along(0, _) => &[0],
            Self::Along(1, _) => &[1],
            Self::Along(..) => &[2],
            Self::Across(0, _) => &[1, 2],
            Self::Across(1, _) => &[0, 2],
            Self::Across(..) => &[0, 1],
        }
    }

    /// The numbers at rest, with those of the axes that may change replaced. `number` is given an axis and how many of
    /// these come before it.
    pub fn fill(self, rest: Vec3, mut number: impl FnMut(usize, usize) -> f32) -> Vec3 {
        let mut numbers = rest.to_array();
        for (at, &axis) in self.free_axes().iter().enumerate() {
            numbers.get_mut(axis).into_iter().for_each(|to| *to = number(axis, at));
        }
        numbers.into()
    }

    /// An offset along the axes, without what the lock keeps out.
    pub fn limited(self, offset: Vec3) -> Vec3 {
        let offset = offset.to_array();
        self.fill(Vec3::ZERO, |axis, _| offset.get(axis).copied().unwrap_or_default())
    }

    /// What the bar says: "along x", "in the y-z plane of the normal".
    pub fn words(self) -> Option<String> {
        let (words, orientation) = match self {
            Self::Free => return None,
            Self::Along(axis, orientation) => (format!("along {}", AXIS_NAMES.get(axis)?), orientation),
            Self::Across(_, orientation) => {
                let names: Vec<&str> =
                    self.free_axes().iter().filter_map(|a| AXIS_NAMES.get(*a).copied()).collect();
                (format!("in the {} plane", names.join("-")), orientation)
            }
        };
        Some(match orientation {
            Orientation::Global => words,
            Orientation::Normal => format!("{words} (normal)"),
            Orientation::View => format!("{words} (view)"),
        })
    }
}

/// The directions of x, y and z in an orientation.
pub(crate) fn axes_of(orientation: Orientation, normal: Vec3, camera: &Camera) -> Mat3 {
    match orientation {
        Orientation::Global => Mat3::IDENTITY,
        Orientation::Normal => axes_of_normal(normal),
        Orientation::View => {
            let [right, up, forward] = camera.axes().map(|axis| axis.as_vec3());
            Mat3::from_cols(right, up, -forward)
        }
    }
}

/// The axes with z along a normal; x is horizontal where that is possible.
fn axes_of_normal(normal: Vec3) -> Mat3 {
    let Some(z) = normal.try_normalize() else { return Mat3::IDENTITY };
    let x = Vec3::Y.cross(z).try_normalize().filter(|_| z.y.abs() < 0.999).unwrap_or(Vec3::X);
    let x = (x - z * x.dot(z)).normalize_or(z.any_orthonormal_vector());
    Mat3::from_cols(x, z.cross(x), z)
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn an_axis_key_goes_through_two_orientations() {
        let first = Lock::Free.after_key(0, false, Orientation::Global);
        assert_eq!(first, Lock::Along(0, Orientation::Global));
        let second = first.after_key(0, false, Orientation::Global);
        assert_eq!(second, Lock::Along(0, Orientation::Normal));
        assert_eq!(second.after_key(0, false, Orientation::Global), Lock::Free);
        assert_eq!(second.after_key(1, true, Orientation::Global), Lock::Across(1, Orientation::Global));
        assert_eq!(Lock::Across(1, Orientation::Global).free_axes(), [0, 2]);
        assert_eq!(
            Lock::Across(1, Orientation::Normal).words().as_deref(),
            Some("in the x-z plane (normal)")
        );
    }

    proptest! {
        #[test]
        fn axes_are_perpendicular(x in -1f32..1.0, y in -1f32..1.0, z in -1f32..1.0) {
            let axes = axes_of_normal(Vec3::new(x, y, z));
            prop_assert!((axes.transpose() * axes).abs_diff_eq(Mat3::IDENTITY, 1e-4));
            prop_assert!((axes.determinant() - 1.0).abs() < 1e-4, "right-handed");
        }
    }
}
