//! How edits that follow the pointer behave: what they turn about, along which axes, and what they snap to.

pub use editor::ops::Symmetry;

/// What rotations and scales leave in place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pivot {
    /// The mean of the selected vertices.
    #[default]
    Middle,
    /// The middle of the selection's bounding box.
    Bounds,
    /// The element selected last.
    Active,
    /// The middle of each connected part, for that part.
    Individual,
    /// The origin.
    Origin,
    /// The 3D cursor.
    Cursor,
}

/// What is done with the 3D cursor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CursorAction {
    /// Shows or hides it.
    Show,
    /// Puts it at the selection's pivot.
    ToSelection,
    /// Puts it at the origin.
    ToOrigin,
    /// Moves the selection to it.
    TakesSelection,
    /// Merges the selected vertices there.
    Merge,
}

/// The directions of x, y and z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Orientation {
    /// The mesh's axes.
    #[default]
    Global,
    /// z along the selection's normal.
    Normal,
    /// x to the right, y up, z towards the viewer.
    View,
}

impl Orientation {
    /// The orientation that a second press of an axis key switches to.
    pub(crate) fn other(self) -> Self {
        if self == Self::Global { Self::Normal } else { Self::Global }
    }
}

/// What moved elements snap to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SnapTo {
    /// Round steps: of length, of 5 degrees, of a tenth.
    #[default]
    Steps,
    /// The points of the grid: moves end at round coordinates.
    Grid,
    /// The vertex under the pointer.
    Vertex,
    /// The edge under the pointer.
    Edge,
    /// The face under the pointer.
    Face,
}

impl SnapTo {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Steps, Self::Grid, Self::Edge, Self::Vertex, Self::Face];

    /// What hints call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Steps => "steps",
            Self::Grid => "the grid",
            Self::Vertex => "vertices",
            Self::Edge => "edges",
            Self::Face => "faces",
        }
    }
}

/// What the handles at the selection do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gizmo {
    /// There are none.
    #[default]
    Off,
    Move,
    Rotate,
    Scale,
}

/// The settings, which last from one edit to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Settings {
    pub gizmo: Gizmo,
    pub pivot: Pivot,
    pub orientation: Orientation,
    /// Whether edits snap; holding Ctrl does the opposite.
    pub snaps: bool,
    pub snap_to: SnapTo,
    /// Whether vertices near the selection move too.
    pub soft: bool,
    /// Whether what lies at the mirror image moves too.
    pub symmetry: Symmetry,
    /// How far along the surface they do, in mesh units; none until an edit needs it.
    pub soft_radius: Option<f32>,
}
