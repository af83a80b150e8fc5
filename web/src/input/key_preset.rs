//! The presets of keys and gestures.

/// A set of keys and of gestures of the mouse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KeyPreset {
    /// Single letters for the operations of geometry courses.
    #[default]
    Course,
    /// As in Blender.
    Blender,
    /// As in Maya.
    Maya,
}

impl KeyPreset {
    /// The number of presets.
    pub(super) const COUNT: usize = 3;

    /// The presets, in the order of the columns of the tables.
    pub const ALL: [Self; Self::COUNT] = [Self::Course, Self::Blender, Self::Maya];

    /// The name in addresses, settings and the state.
    pub fn name(self) -> &'static str {
        match self {
            Self::Course => "course",
            Self::Blender => "blender",
            Self::Maya => "maya",
        }
    }

    /// The name that users see.
    pub fn label(self) -> &'static str {
        match self {
            Self::Course => "Course",
            Self::Blender => "Blender",
            Self::Maya => "Maya",
        }
    }

    /// The preset of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|preset| preset.name().eq_ignore_ascii_case(name))
    }

    /// Its column of a table.
    pub(crate) fn of<T: Copy>(self, [course, blender, maya]: [T; Self::COUNT]) -> T {
        match self {
            Self::Course => course,
            Self::Blender => blender,
            Self::Maya => maya,
        }
    }
}
