//! A key with modifiers, as tables, settings and texts write it: `Ctrl+Shift+Z`, `Numpad5`, `?`.

use egui::{Context, Event, Key, Modifiers};

/// The physical key of events of the number pad: egui has no keys for it. The page marks such events.
pub const NUMBER_PAD: Key = Key::NumLock;

/// A key with the modifiers that are held with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shortcut {
    /// Ctrl, or Command on a Mac.
    pub ctrl: bool,
    /// Alt, or Option on a Mac.
    pub alt: bool,
    /// Shift. Never set for characters that take Shift on some keyboards.
    pub shift: bool,
    /// Whether the key is on the number pad.
    pub pad: bool,
    /// The key.
    pub key: Key,
}

impl Shortcut {
    /// Reads a shortcut such as `Ctrl+Shift+Z`.
    pub fn parse(text: &str) -> Option<Self> {
        let mut shortcut = Self { ctrl: false, alt: false, shift: false, pad: false, key: Key::Escape };
        let mut rest = text.trim();
        loop {
            if let Some(after) = rest.strip_prefix("Ctrl+") {
                (shortcut.ctrl, rest) = (true, after);
            } else if let Some(after) = rest.strip_prefix("Alt+") {
                (shortcut.alt, rest) = (true, after);
            } else if let Some(after) = rest.strip_prefix("Shift+") {
                (shortcut.shift, rest) = (true, after);
            } else {
                break;
            }
        }
        if let Some(after) = rest.strip_prefix("Numpad") {
            (shortcut.pad, rest) = (true, after.trim_start());
        }
        shortcut.key = Key::from_name(rest)?;
        Some(shortcut)
    }

    /// Reads shortcuts with spaces between them.
    pub fn parse_all(text: &str) -> Vec<Self> {
        text.split_whitespace().filter_map(Self::parse).collect()
    }

    /// The shortcut of an event, if a key was pressed that can be one.
    pub fn of_event(event: &Event) -> Option<Self> {
        let &Event::Key { key, physical_key, pressed: true, modifiers, .. } = event else { return None };
        (!is_modifier(key)).then(|| Self::pressed(key, physical_key == Some(NUMBER_PAD), modifiers))
    }

    /// The shortcut of a key that was pressed with modifiers.
    pub fn pressed(key: Key, pad: bool, modifiers: Modifiers) -> Self {
        let Modifiers { alt, ctrl, shift, command, .. } = modifiers;
        Self { ctrl: ctrl || command, alt, shift: shift && (pad || !takes_shift(key)), pad, key }
    }

    /// The same key of the main block, for keys of the number pad that mean the same there. Its digits are keys of their
    /// own.
    pub fn off_the_pad(self) -> Option<Self> {
        (self.pad && !is_digit(self.key)).then_some(Self { pad: false, ..self })
    }

    /// The shortcut as settings and documentation write it.
    pub fn text(self) -> String {
        self.with_names("Ctrl+", "Alt+", "Numpad")
    }

    /// The shortcut as the platform writes it.
    pub fn written(self, ctx: &Context) -> String {
        if ctx.os().is_mac() {
            self.with_names("Cmd+", "Option+", "Numpad ")
        } else {
            self.with_names("Ctrl+", "Alt+", "Numpad ")
        }
    }

    fn with_names(self, ctrl: &str, alt: &str, pad: &str) -> String {
        let part = |is_held: bool, name| if is_held { name } else { "" };
        let key = match self.key {
            Key::Minus => "-",
            Key::ArrowDown | Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp => self.key.name(),
            key => key.symbol_or_name(),
        };
        [part(self.ctrl, ctrl), part(self.alt, alt), part(self.shift, "Shift+"), part(self.pad, pad), key]
            .concat()
    }
}

/// Whether a key types a digit.
pub fn is_digit(key: Key) -> bool {
    key.name().bytes().all(|byte| byte.is_ascii_digit())
}

/// Whether a key is only held with others.
fn is_modifier(key: Key) -> bool {
    matches!(
        key,
        Key::ShiftLeft
            | Key::ShiftRight
            | Key::ControlLeft
            | Key::ControlRight
            | Key::AltLeft
            | Key::AltRight
            | Key::SuperLeft
            | Key::SuperRight
            | Key::CapsLock
            | Key::NumLock
            | Key::ScrollLock
            | Key::Fn
    )
}

/// Whether the character of a key takes Shift on some keyboards and not on others.
fn takes_shift(key: Key) -> bool {
    matches!(
        key,
        Key::Questionmark
            | Key::Exclamationmark
            | Key::Colon
            | Key::Plus
            | Key::Pipe
            | Key::OpenCurlyBracket
            | Key::CloseCurlyBracket
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shortcuts_are_read_as_they_are_written() {
        for text in [
            "Z",
            "Ctrl+Alt+Shift+Z",
            "Ctrl+-",
            "Ctrl++",
            "Numpad5",
            "Ctrl+Numpad+",
            "?",
            ".",
            "F12",
            "Home",
            "Left",
        ] {
            assert_eq!(Shortcut::parse(text).map(Shortcut::text).as_deref(), Some(text));
        }
        assert_eq!(Shortcut::parse("Shift+Ctrl+Z"), Shortcut::parse("Ctrl+Shift+Z"));
        for text in ["", "Ctrl+", "Ctrl+Nothing", "Numpad"] {
            assert_eq!(Shortcut::parse(text), None, "{text:?}");
        }
        let ctx = Context::default();
        assert_eq!(
            Shortcut::parse("Ctrl+Numpad1").map(|key| key.written(&ctx)).as_deref(),
            Some("Ctrl+Numpad 1")
        );
    }

    #[test]
    fn characters_that_take_shift_match_without_it() {
        let pressed = |key, modifiers| Some(Shortcut::pressed(key, false, modifiers));
        assert_eq!(pressed(Key::Questionmark, Modifiers::SHIFT), Shortcut::parse("?"));
        assert_eq!(pressed(Key::Plus, Modifiers::COMMAND.plus(Modifiers::SHIFT)), Shortcut::parse("Ctrl++"));
        assert_eq!(pressed(Key::Period, Modifiers::SHIFT), Shortcut::parse("Shift+."));
        assert_ne!(pressed(Key::A, Modifiers::CTRL), Shortcut::parse("A"));
    }

    #[test]
    fn digits_of_the_number_pad_are_keys_of_their_own() {
        let on_pad = |key| Shortcut::pressed(key, true, Modifiers::NONE).off_the_pad();
        assert_eq!(on_pad(Key::Num1), None);
        assert_eq!(on_pad(Key::Slash), Shortcut::parse("/"));
        assert_eq!(Shortcut::parse("A").and_then(Shortcut::off_the_pad), None);
    }
}
