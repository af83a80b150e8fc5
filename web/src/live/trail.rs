//! Where the pointer has been since an edit began, which the amount is measured by.
//!
//! The bar of an edit lies over the viewport. On the way to its buttons the pointer crosses the picture, which must not change
//! the amount that someone goes there to apply. So the pointer doesn't count over the bar: there the edit shows the amount
//! that it had where the pointer last rested. Once the pointer leaves the bar, the amount follows it as if there were no bar.

use egui::{Modifiers, Pos2};
use glam::Vec3;

use super::edit::Live;
use crate::transforming::Settings;
use crate::view::View;

/// With Shift held, the pointer counts as moving at this part of its speed.
const FINE_SPEED: f32 = 0.1;
/// A pointer that moves no sooner than this after it last did has rested.
const REST_SECONDS: f64 = 0.3;

/// Where the pointer has been.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Trail {
    /// The place that the amount is measured from; none until the pointer is over the viewport.
    pub from: Option<Pos2>,
    /// Where the pointer would be had it always moved at full speed.
    pub at: Pos2,
    /// The degrees that the pointer has turned about the middle.
    pub turned: f32,
    /// The last place of the pointer. The preview changes only when the pointer moves, even if the panels beside the viewport
    /// change its size.
    seen: Option<Pos2>,
    /// When the pointer last moved, in seconds.
    moved_at: f64,
    /// The amount, and the direction of a slide, where the pointer last rested after it had moved.
    rest: Option<(Vec3, Vec3)>,
    on_bar: bool,
}

impl Trail {
    /// A trail that begins where the pointer is, or where it is seen first.
    pub fn new(from: Option<Pos2>) -> Self {
        Self { from, at: from.unwrap_or_default(), seen: from, ..Self::default() }
    }

    /// Goes on from another place with the same amount.
    fn take_up(&mut self, to: Pos2) {
        let by = to - self.at;
        self.from = Some(self.from.map_or(to, |from| from + by));
        (self.at, self.seen) = (to, Some(to));
    }

    /// Forgets where the pointer rested: the amount means something else now.
    pub fn forget_rest(&mut self) {
        self.rest = None;
    }
}

impl Live {
    /// Moves the pointer over the viewport, `now` in seconds; returns whether that counts. Rotations add up.
    pub(crate) fn follow_pointer(
        &mut self,
        to: Pos2,
        view: &View,
        settings: &Settings,
        modifiers: Modifiers,
        now: f64,
    ) -> bool {
        let was_on_bar = std::mem::take(&mut self.trail.on_bar);
        let Some(seen) = self.trail.seen.replace(to).filter(|_| self.trail.from.is_some()) else {
            (self.trail.from, self.trail.at) = (Some(to), to);
            return false;
        };
        if !self.follows {
            return false;
        }
        if seen == to {
            return was_on_bar;
        }
        if now - self.trail.moved_at >= REST_SECONDS && !was_on_bar {
            self.trail.rest = self.does_something().then_some((self.value, self.way));
        }
        self.trail.moved_at = now;
        let speed = if modifiers.shift { FINE_SPEED } else { 1.0 };
        let before = self.trail.at;
        self.trail.at += (to - seen) * speed;
        // Turns add up, so that there can be more than one. Fine ones are taken around the middle too.
        let [from, to] = [seen, to].map(|place| view.local(place));
        self.trail.turned += self.turn(settings, view, from, to) * speed;
        was_on_bar || before != self.trail.at
    }

    /// Moves the pointer onto the bar of the edit; returns whether the amount is another.
    pub(crate) fn go_to_bar(&mut self, now: f64) -> bool {
        if !self.follows || std::mem::replace(&mut self.trail.on_bar, true) {
            return false;
        }
        let has_rested = now - self.trail.moved_at >= REST_SECONDS;
        match self.trail.rest.filter(|_| !has_rested) {
            Some((value, way)) => {
                (self.value, self.way) = (value, way);
                true
            }
            None => false,
        }
    }

    /// Goes on from another place with the same amount, as when a finger touches again.
    pub fn take_up(&mut self, to: Pos2) {
        self.trail.take_up(to);
    }
}
