//! Which gestures move the camera, and what it turns about.

use super::key_preset::KeyPreset;

/// The gestures that move the camera, as in a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CameraStyle {
    /// A drag beside the mesh turns the view.
    Course,
    /// As in Blender with a mouse.
    Blender,
    /// As in Maya: with Alt held, each button has its movement.
    Maya,
    /// As in Onshape and Fusion: the right button turns about the point under the pointer, the middle one pans.
    Cad,
    /// Two fingers on a trackpad, as in Blender on a Mac.
    Trackpad,
}

impl CameraStyle {
    /// The number of styles.
    pub(super) const COUNT: usize = 5;

    /// The styles, in the order of the columns of the table.
    pub const ALL: [Self; Self::COUNT] = [Self::Course, Self::Blender, Self::Maya, Self::Cad, Self::Trackpad];

    /// The style that belongs to a preset of keys.
    pub fn of(preset: KeyPreset) -> Self {
        preset.of([Self::Course, Self::Blender, Self::Maya])
    }

    /// The name in settings.
    pub fn name(self) -> &'static str {
        match self {
            Self::Course => "course",
            Self::Blender => "blender",
            Self::Maya => "maya",
            Self::Cad => "cad",
            Self::Trackpad => "trackpad",
        }
    }

    /// The name that users see.
    pub fn label(self) -> &'static str {
        match self {
            Self::Course => "Course",
            Self::Blender => "Blender",
            Self::Maya => "Maya",
            Self::Cad => "CAD",
            Self::Trackpad => "Trackpad",
        }
    }

    /// The style of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|style| style.name() == name)
    }

    /// Its column of a table.
    pub(crate) fn of_columns<T: Copy>(self, [course, blender, maya, cad, trackpad]: [T; Self::COUNT]) -> T {
        match self {
            Self::Course => course,
            Self::Blender => blender,
            Self::Maya => maya,
            Self::Cad => cad,
            Self::Trackpad => trackpad,
        }
    }

    /// What the camera turns about in such programs.
    pub(crate) fn orbit_about(self) -> OrbitAbout {
        if self == Self::Cad { OrbitAbout::Pointer } else { OrbitAbout::View }
    }
}

/// What the camera turns about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OrbitAbout {
    /// The middle of the view.
    #[default]
    View,
    /// The middle of the selection.
    Selection,
    /// The point of the surface under the pointer.
    Pointer,
}

impl OrbitAbout {
    const ALL: [Self; 3] = [Self::View, Self::Selection, Self::Pointer];

    /// The name in settings.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::Selection => "selection",
            Self::Pointer => "pointer",
        }
    }

    /// The choice of a name.
    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|about| about.name() == name)
    }
}
