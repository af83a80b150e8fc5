//! Moves of the camera that take a moment, so that one sees where the view went. The view's camera is at the end of a move
//! as soon as it starts, for everything that reads it; only what is painted gets there step by step.

use egui::{Context, Event};
use viewport::Camera;

use super::pane::Pane;

/// How long a move takes.
const GLIDE_SECONDS: f64 = 0.2;

/// A move of one view's camera.
#[derive(Clone, Copy, Debug)]
struct Glide {
    pane: Pane,
    from: Camera,
    to: Camera,
    /// When it started, in seconds.
    since: f64,
}

impl Glide {
    /// The camera to paint with.
    fn shown(&self, now: f64) -> Camera {
        let left = 1.0 - ((now - self.since) / GLIDE_SECONDS).clamp(0.0, 1.0);
        // Fast at first, so that the view answers at once.
        self.from.between(&self.to, 1.0 - left.powi(3))
    }
}

/// The moves in progress.
#[derive(Clone, Debug, Default)]
pub(crate) struct Glides {
    going: Vec<Glide>,
    /// What the views showed whose moves were ended by the input of this frame: another move starts from there.
    ended: Vec<(Pane, Camera)>,
    /// Whether views jump, for users who want less motion.
    pub are_off: bool,
}

impl Glides {
    /// Ends the moves if there is input in this frame: what is pressed means the view at their end.
    pub fn follow_input(&mut self, ctx: &Context) {
        self.ended.clear();
        let (acts, now) = ctx
            .input(|input| (input.pointer.any_down() || input.events.iter().any(is_deliberate), input.time));
        if acts {
            self.ended.extend(self.going.drain(..).map(|glide| (glide.pane, glide.shown(now))));
        }
    }

    /// Shows the moves from these cameras to those that the views have now.
    pub fn start(&mut self, from: Vec<(Pane, Camera)>, to: &[(Pane, Camera)], now: f64) {
        if self.are_off {
            return;
        }
        for (pane, before) in from {
            let Some((_, to)) = to.iter().find(|(other, _)| *other == pane) else { continue };
            if before.shows_the_same(to) || before.up != to.up {
                continue;
            }
            let ended = self.ended.iter().find(|(other, _)| *other == pane);
            let from = ended.map_or(before, |(_, shown)| *shown);
            self.going.retain(|glide| glide.pane != pane);
            self.going.push(Glide { pane, from, to: *to, since: now });
        }
    }

    /// The cameras to paint with of the views that are on their way, of those that have these cameras.
    pub fn shown(&mut self, cameras: &[(Pane, Camera)], now: f64) -> Vec<(Pane, Camera)> {
        let mut shown = Vec::new();
        self.going.retain(|glide| {
            // A camera that has moved since is where the user wants it.
            let own = cameras.iter().find(|(pane, own)| *pane == glide.pane && own.shows_the_same(&glide.to));
            let own = own.filter(|_| now - glide.since < GLIDE_SECONDS);
            shown.extend(own.map(|(pane, own)| (*pane, Glide { to: *own, ..*glide }.shown(now))));
            own.is_some()
        });
        shown
    }
}

/// Whether an event is the user's doing, other than moving the pointer.
fn is_deliberate(event: &Event) -> bool {
    matches!(
        event,
        Event::Key { pressed: true, .. }
            | Event::PointerButton { pressed: true, .. }
            | Event::MouseWheel { .. }
            | Event::Zoom(_)
            | Event::Touch { .. }
            | Event::AccessKitActionRequest(_)
    )
}
