//! The current drag in the viewport.

use editor::SelectMode;
use egui::Pos2;
use glam::Vec3;

use crate::bezier::ControlPoint;

/// What a drag with the primary button beside the mesh does, in place of what it does in the preset of keys.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tool {
    /// What the preset says.
    #[default]
    Orbit,
    /// Draws a box that selects.
    Box,
    /// Draws a line around what it selects.
    Lasso,
    /// Paints over what it selects with a circle.
    Circle,
    /// Cuts the ring of quads under the pointer.
    LoopCut,
}

impl Tool {
    /// Whether a right-click puts the tool away, in place of opening a menu.
    pub fn ends_on_right_click(self) -> bool {
        matches!(self, Self::Circle | Self::LoopCut)
    }
}

/// A drag in progress.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Gesture {
    None,
    Orbit,
    Pan,
    Zoom,
    Box {
        from: Pos2,
    },
    /// A line around elements; with the right button its keys mean something else.
    Lasso {
        points: Vec<Pos2>,
        secondary: bool,
    },
    /// A stroke of the circle: where it is, and what it does with the elements under it.
    Paint {
        at: Pos2,
        mode: SelectMode,
        stroke: u64,
    },
    /// The edit that follows the pointer; the release applies it, unless a finger may touch again.
    Live {
        applies: bool,
    },
    /// A slide that began with the drag. Its modifiers mean nothing else.
    Slide,
    /// Changes the radius of the soft selection.
    SoftRadius,
    Control {
        point: ControlPoint,
        from: Pos2,
        anchor: Vec3,
    },
    /// Cancelled with Escape, but the button is still down.
    Ended,
}
