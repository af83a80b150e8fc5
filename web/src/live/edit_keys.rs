//! The keys and the wheel of an edit that follows the pointer.

use editor::OpId;
use editor::ops::Drag;
use egui::{Context, Event, Key};

use super::edit::Live;
use crate::input::key_map::When;
use crate::input::keys;
use crate::input::shortcut::{Shortcut, is_digit};
use crate::transforming::Settings;

/// How keys end an edit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ending {
    Apply,
    Cancel,
}

impl Live {
    /// Takes the keys that mean something to the edit out of the frame's input, up to one that ends it. Returns whether
    /// they changed the amount, and how they end the edit.
    pub(crate) fn take_keys(&mut self, ctx: &Context, settings: &Settings) -> (bool, Option<Ending>) {
        let typing = ctx.text_edit_focused();
        let map = keys::map(ctx);
        // A key that snaps while it is held locks no axis.
        let snaps = |key: Key| {
            let pressed = Shortcut { ctrl: false, alt: false, shift: false, pad: false, key };
            map.actions_of(pressed, When::Always).any(keys::acts_while_held)
        };
        let (mut changed, mut ending) = (false, None);
        ctx.input_mut(|input| {
            input.events.retain(|event| {
                if ending.is_some() {
                    return true;
                }
                let taken = match event {
                    Event::Key { key, pressed: true, modifiers, .. } => match key {
                        Key::Escape => {
                            ending = Some(Ending::Cancel);
                            true
                        }
                        _ if typing || modifiers.command || modifiers.alt => false,
                        Key::Enter => {
                            // The bar says why a number can't be what is typed: it can be typed again.
                            ending = self.typed.refusal().is_none().then_some(Ending::Apply);
                            true
                        }
                        Key::Backspace => {
                            changed |= self.typed.pop();
                            true
                        }
                        Key::Tab => {
                            self.typed.next(self.number_count());
                            true
                        }
                        // What they type is text: they must not move the view too.
                        _ if types_number(*key) || self.types_letter(*key) => true,
                        _ => match axis_of(*key).filter(|_| self.takes_lock() && !snaps(*key)) {
                            Some(axis) => {
                                self.press_axis(axis, modifiers.shift, settings);
                                changed = true;
                                true
                            }
                            None => false,
                        },
                    },
                    Event::Text(text) if !typing => {
                        changed |= self.typed.push(text);
                        true
                    }
                    _ => false,
                };
                !taken
            });
        });
        (changed, ending)
    }

    /// Whether axis keys limit the edit.
    pub(crate) fn takes_lock(&self) -> bool {
        matches!(self.drag, Drag::Offset | Drag::Rotation | Drag::Factors)
    }

    /// Whether the wheel changes the edit instead of the view.
    pub(crate) fn takes_wheel(&self, settings: &Settings) -> bool {
        self.wheel_words(settings).is_some()
    }

    /// What the wheel changes; none where it zooms.
    pub(crate) fn wheel_words(&self, settings: &Settings) -> Option<String> {
        let count = self.count.map(|(field, _)| field.label());
        count.or_else(|| (self.id == OpId::Transform && settings.soft).then(|| "Radius".to_owned()))
    }

    /// Whether a key types a letter of the number that is being typed: of `pi` or a unit.
    fn types_letter(&self, key: Key) -> bool {
        let mut name = key.name().chars();
        let letter = name.next().filter(|letter| letter.is_ascii_alphabetic() && name.next().is_none());
        letter.is_some_and(|letter| self.typed.takes(letter))
    }

    /// How many numbers can be typed.
    pub(crate) fn number_count(&self) -> usize {
        if self.drag == Drag::Offset { self.lock.free_axes().len() } else { 1 }
    }
}

/// Whether a key types a part of a number.
fn types_number(key: Key) -> bool {
    is_digit(key) || matches!(key, Key::Period | Key::Plus | Key::Minus | Key::Slash)
}

fn axis_of(key: Key) -> Option<usize> {
    match key {
        Key::X => Some(0),
        Key::Y => Some(1),
        Key::Z => Some(2),
        _ => None,
    }
}

/// The direction of a turn of the wheel: 1 away from the user, -1 towards.
pub(crate) fn notches_of(event: &Event) -> i32 {
    match event {
        Event::MouseWheel { delta, .. } if delta.y > 0.0 => 1,
        Event::MouseWheel { delta, .. } if delta.y < 0.0 => -1,
        _ => 0,
    }
}
