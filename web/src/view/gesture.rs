//! The current drag in the viewport.

use egui::{Pos2, Rect};
use glam::{Vec3, vec2};

use super::View;
use crate::bezier::ControlPoint;

/// What a drag with the primary button beside the mesh does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tool {
    /// Turns the view.
    #[default]
    Orbit,
    /// Draws a box that selects.
    Box,
}

/// A drag in progress.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Gesture {
    None,
    Orbit,
    Pan,
    Box {
        from: Pos2,
    },
    Move {
        from: Pos2,
        anchor: Vec3,
    },
    Control {
        point: ControlPoint,
        from: Pos2,
        anchor: Vec3,
    },
    /// Cancelled with Escape, but the button is still down.
    Ended,
}

impl View {
    /// Cancels the drag in progress; returns whether there was one.
    pub fn cancel_gesture(&mut self) -> bool {
        let going =
            matches!(self.gesture, Gesture::Box { .. } | Gesture::Move { .. } | Gesture::Control { .. });
        if going {
            self.gesture = Gesture::Ended;
        }
        self.boxed.take().is_some() || going
    }

    /// The selection box being drawn.
    pub fn selection_box(&self, to: Option<Pos2>) -> Option<Rect> {
        match (&self.gesture, to) {
            (Gesture::Box { from }, Some(to)) => Some(Rect::from_two_pos(*from, to).intersect(self.rect)),
            _ => None,
        }
    }

    pub fn local(&self, at: Pos2) -> glam::Vec2 {
        vec2(at.x - self.rect.min.x, at.y - self.rect.min.y)
    }
}
