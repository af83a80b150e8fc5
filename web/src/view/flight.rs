//! Flying through the scene: keys move the eye, the pointer turns it.

use egui::{Context, Event, InputState, Key, Pos2};
use glam::DVec3;
use viewport::Camera;

/// The part of the distance to the target that the eye flies in a second at first.
const START_SPEED: f64 = 0.5;
/// How much faster it is with Shift held.
const FAST: f64 = 4.0;
/// How much a notch of the wheel changes the speed, and the limits of all changes together.
const SPEED_STEP: f64 = 1.25;
const MAX_SPEED_CHANGE: f64 = 1e3;
/// A slow frame counts as no more than this many seconds: nobody can steer through it.
const MAX_FRAME_SECONDS: f32 = 0.1;

/// The keys, and where each moves the eye: to the right, up, forward. The arrows do what the letters at their places do.
const KEYS: [(Key, DVec3); 10] = [
    (Key::W, DVec3::Z),
    (Key::S, DVec3::NEG_Z),
    (Key::A, DVec3::NEG_X),
    (Key::D, DVec3::X),
    (Key::E, DVec3::Y),
    (Key::Q, DVec3::NEG_Y),
    (Key::ArrowUp, DVec3::Z),
    (Key::ArrowDown, DVec3::NEG_Z),
    (Key::ArrowLeft, DVec3::NEG_X),
    (Key::ArrowRight, DVec3::X),
];

/// How a flight ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Landing {
    /// Where the eye is.
    Here,
    /// Where the flight began.
    Back,
}

/// A flight in progress.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flight {
    /// The camera to go back to.
    pub before: Camera,
    /// In mesh units per second.
    speed: f64,
    start_speed: f64,
    /// Where the pointer was last, in the viewport.
    pub seen: Option<Pos2>,
    /// How a key has ended it.
    pub ends: Option<Landing>,
}

impl Flight {
    /// A flight that begins with a camera.
    pub fn from(before: Camera) -> Self {
        let speed = START_SPEED * before.distance;
        Self { before, speed, start_speed: speed, seen: None, ends: None }
    }

    /// The speed in percent of the one at first.
    pub fn speed_percent(&self) -> f64 {
        100.0 * self.speed / self.start_speed
    }

    /// Takes the keys out of the frame's input, up to one that ends the flight: they fly, or would start something by
    /// mistake.
    pub fn take_keys(&mut self, ctx: &Context) {
        let takes = |event: &Event| match event {
            Event::Key { key, pressed: true, modifiers, .. } => {
                !modifiers.command && !modifiers.alt && !is_function_key(*key)
            }
            Event::Text(_) => true,
            _ => false,
        };
        ctx.input_mut(|input| {
            input.events.retain(|event| {
                if self.ends.is_some() || !takes(event) {
                    return true;
                }
                if let Event::Key { key, .. } = event {
                    self.ends = match key {
                        Key::Escape => Some(Landing::Back),
                        Key::Enter | Key::Space => Some(Landing::Here),
                        _ => None,
                    };
                }
                false
            });
        });
    }

    /// Changes the speed by notches of the wheel.
    pub fn turn_wheel(&mut self, notches: i32) {
        let (least, most) = (self.start_speed / MAX_SPEED_CHANGE, self.start_speed * MAX_SPEED_CHANGE);
        self.speed = (self.speed * SPEED_STEP.powi(notches)).clamp(least, most);
    }

    /// How far the held keys move the eye in this frame; none if no such key is held.
    pub fn step(&self, input: &InputState) -> Option<DVec3> {
        let held = KEYS.iter().filter(|(key, _)| input.key_down(*key));
        let way = held.fold(DVec3::ZERO, |sum, (_, way)| sum + *way).try_normalize()?;
        let speed = if input.modifiers.shift { FAST * self.speed } else { self.speed };
        Some(way * speed * f64::from(input.stable_dt.min(MAX_FRAME_SECONDS)))
    }
}

fn is_function_key(key: Key) -> bool {
    key.name().strip_prefix('F').is_some_and(|number| number.parse::<u8>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    #[test]
    fn opposite_keys_cancel_out_and_slanted_ways_are_no_faster() {
        let flight = Flight { speed: 2.0, ..Flight::from(Camera::default()) };
        let mut input = InputState::default();
        input.stable_dt = 0.05;
        assert_eq!(flight.step(&input), None);
        input.keys_down.extend([Key::W, Key::E]);
        let step = flight.step(&input).expect("a step");
        assert!((step.length() - 0.1).abs() < 1e-6 && step.y == step.z, "{step}");
        input.modifiers.shift = true;
        assert!((flight.step(&input).expect("a step").length() - 0.4).abs() < 1e-6);
        input.keys_down.extend([Key::ArrowDown, Key::Q]);
        assert_eq!(flight.step(&input), None);
        input.keys_down.insert(Key::A);
        input.stable_dt = 3.0;
        let step = flight.step(&input).expect("a step");
        assert!(step.distance(dvec3(-0.8, 0.0, 0.0)) < 1e-6, "slow frames count as short: {step}");
    }
}
