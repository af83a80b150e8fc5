//! A view of the viewport, and how the viewport is split into such.

use egui::{Pos2, Rect, Vec2};
use serde::{Deserialize, Serialize};
use viewport::{Camera, Side};

/// The room between views, in points.
pub(crate) const GAP_POINTS: f32 = 2.0;
/// Where views meet at first, as parts of the viewport's width and height.
pub(crate) const MIDDLE: Vec2 = Vec2::splat(0.5);

/// How the viewport is split.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Split {
    /// It is not.
    #[default]
    One,
    /// Into two views side by side: in perspective, and from the front.
    Two,
    /// Into four: from above and in perspective, below from the front and from the right.
    Four,
}

/// A view, named after where it looks from at first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Pane {
    Top,
    /// In perspective.
    #[default]
    Free,
    Front,
    Right,
}

impl Pane {
    /// Row by row.
    pub const ALL: [Self; 4] = [Self::Top, Self::Free, Self::Front, Self::Right];

    /// The side from which it looks at first, without perspective.
    fn side(self) -> Option<Side> {
        match self {
            Self::Top => Some(Side::Top),
            Self::Front => Some(Side::Front),
            Self::Right => Some(Side::Right),
            Self::Free => None,
        }
    }

    /// Its part of the viewport, of which the views meet at `middle`.
    pub fn rect(self, split: Split, area: Rect, middle: Pos2) -> Rect {
        let (left, right) = area.split_left_right_at_x(middle.x);
        let half = match (self, split) {
            (_, Split::One) => return area,
            (Self::Free | Self::Right, Split::Four) | (Self::Front, Split::Two) => {
                right.with_min_x(right.left() + GAP_POINTS / 2.0)
            }
            _ => left.with_max_x(left.right() - GAP_POINTS / 2.0),
        };
        let (above, below) = half.split_top_bottom_at_y(middle.y);
        match (self, split) {
            (_, Split::One | Split::Two) => half,
            (Self::Top | Self::Free, _) => above.with_max_y(above.bottom() - GAP_POINTS / 2.0),
            (Self::Front | Self::Right, _) => below.with_min_y(below.top() + GAP_POINTS / 2.0),
        }
    }

    /// The camera that it begins with, before it frames anything.
    pub fn start(self, like: &Camera) -> Camera {
        let start = Camera::default();
        let mut camera =
            Camera { yaw: start.yaw, pitch: start.pitch, roll: 0.0, orthographic: false, ..*like };
        if let Some(side) = self.side() {
            camera.look_from(side);
            camera.orthographic = true;
        }
        camera
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{pos2, vec2};

    #[test]
    fn views_fill_the_viewport_without_overlap() {
        let area = Rect::from_min_size(pos2(301.0, 40.0), vec2(641.0, 533.0));
        for (split, panes) in [
            (Split::One, &[Pane::Right][..]),
            (Split::Two, &[Pane::Free, Pane::Front]),
            (Split::Four, &Pane::ALL),
        ] {
            let middle = pos2(497.0, 150.0);
            let rects: Vec<Rect> = panes.iter().map(|pane| pane.rect(split, area, middle)).collect();
            let all = rects.iter().fold(Rect::NOTHING, |all, rect| all.union(*rect));
            assert_eq!(all, area, "{split:?}");
            let covered: f32 = rects.iter().map(|rect| rect.area()).sum();
            assert!(covered <= area.area() && covered > 0.99 * area.area(), "{split:?}");
            for (at, rect) in rects.iter().enumerate() {
                assert!(rects.iter().skip(at + 1).all(|other| !other.intersects(*rect)), "{split:?}");
            }
        }
    }
}
