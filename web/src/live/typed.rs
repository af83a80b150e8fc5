//! Numbers typed during an edit, one per axis that may change.

use crate::units::{LengthUnit, Measure, Wrong, continues_suffix, evaluate};

/// The typed numbers. Each may be an expression such as `1/3`, with units.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Typed {
    texts: Vec<String>,
    at: usize,
    measure: Measure,
    unit: LengthUnit,
}

impl Typed {
    /// Nothing yet, of what the numbers measure, where one unit of the mesh is `unit`.
    pub fn new(measure: Measure, unit: LengthUnit) -> Self {
        Self { measure, unit, ..Self::default() }
    }

    /// Forgets what was typed.
    pub fn clear(&mut self) {
        *self = Self::new(self.measure, self.unit);
    }

    /// Whether nothing is typed.
    pub fn is_empty(&self) -> bool {
        self.texts.iter().all(String::is_empty)
    }

    /// Appends the characters that numbers and expressions consist of, with the letters of `pi` and of units; returns whether
    /// there were any.
    pub fn push(&mut self, text: &str) -> bool {
        let before = self.texts.get(self.at).map_or(0, String::len);
        if self.texts.len() <= self.at {
            self.texts.resize(self.at + 1, String::new());
        }
        if let Some(typed) = self.texts.get_mut(self.at) {
            for c in text.chars() {
                if fits(typed, c) {
                    typed.push(c);
                }
            }
            return typed.len() > before;
        }
        false
    }

    /// Whether a character is a part of the number that is being typed, and so no key.
    pub fn takes(&self, c: char) -> bool {
        fits(self.texts.get(self.at).map_or("", String::as_str), c)
    }

    /// Deletes the last character; returns whether there was one.
    pub fn pop(&mut self) -> bool {
        let removed = self.texts.get_mut(self.at).is_some_and(|text| text.pop().is_some());
        if !removed && self.at > 0 {
            self.at -= 1;
            return true;
        }
        removed
    }

    /// Goes on to the next of so many numbers.
    pub fn next(&mut self, count: usize) {
        self.at = (self.at + 1) % count.max(1);
    }

    /// Starts with the first number again when fewer can be typed.
    pub fn limit(&mut self, count: usize) {
        self.texts.truncate(count);
        self.at = self.at.min(count.saturating_sub(1));
    }

    /// The value of a number; none while it is empty or unfinished.
    pub fn value(&self, at: usize) -> Option<f32> {
        self.result(self.texts.get(at)?).ok().map(|value| value as f32).filter(|value| value.is_finite())
    }

    fn result(&self, text: &str) -> Result<f64, Wrong> {
        let evaluate = |text| evaluate(text, self.measure, self.unit);
        // A sign, an operator or the first letter of a unit at the end waits for the rest.
        let whole = text.trim_end_matches(|c: char| c.is_alphabetic() && c != 'π');
        let finished = whole.trim_end_matches(['+', '-', '*', '/', '^', '(', '.']);
        match evaluate(text) {
            Err(Wrong::Unfinished) => match evaluate(whole) {
                Err(Wrong::Unfinished) => evaluate(finished),
                result => result,
            },
            result => result,
        }
    }

    /// Why a number can't be what is typed; none if it can, or may once it is finished.
    pub fn refusal(&self) -> Option<String> {
        self.texts.iter().find_map(|text| match self.result(text) {
            Err(Wrong::Unit(reason)) => Some(reason),
            _ => None,
        })
    }

    /// The text of a number, as typed.
    pub fn text(&self, at: usize) -> Option<&str> {
        self.texts.get(at).map(String::as_str).filter(|text| !text.is_empty())
    }
}

/// Whether a character can follow what is typed. A letter that follows no number is a key.
fn fits(typed: &str, c: char) -> bool {
    if c.is_ascii_digit() || "+-*/^().π".contains(c) {
        return true;
    }
    let number = typed.trim_end_matches(|c: char| c.is_alphabetic() && c != 'π');
    let letters = typed.get(number.len()..).unwrap_or_default().to_lowercase();
    let (is_of_pi, letters) = match (letters.strip_prefix("pi"), c) {
        (Some(rest), _) => (false, rest),
        (None, 'p' | 'P') => (letters.is_empty() && number.ends_with(['+', '-', '*', '/', '^', '(']), ""),
        (None, 'i' | 'I') if letters == "p" => (true, ""),
        (None, _) => (false, letters.as_str()),
    };
    let is_after_number = number.ends_with(|c: char| c.is_ascii_digit() || ".)π".contains(c))
        || letters.len() < typed.len() - number.len();
    is_of_pi || (is_after_number && continues_suffix(letters, c))
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_typed_one_after_the_other() {
        let mut typed = Typed::default();
        assert!(typed.is_empty() && !typed.push("q"));
        assert!(typed.push("-") && typed.value(0).is_none());
        for (text, value) in [("1", -1.0), ("/", -1.0), ("4", -0.25)] {
            assert!(typed.push(text));
            assert_eq!(typed.value(0), Some(value), "after {text}");
        }
        typed.next(3);
        assert!(typed.push("2"));
        assert_eq!((typed.value(0), typed.value(1), typed.value(2)), (Some(-0.25), Some(2.0), None));
        assert!(typed.pop() && typed.pop(), "back to the first number");
        assert!(typed.pop());
        assert_eq!(typed.text(0), Some("-1/"));
        typed.next(3);
        typed.next(3);
        typed.limit(1);
        assert!(typed.push("2"));
        assert_eq!(typed.value(0), Some(-0.5));
    }

    #[test]
    fn units_are_typed_after_numbers() {
        let mut typed = Typed::new(Measure::Length, LengthUnit::Millimetre);
        assert!(!typed.push("m") && !typed.takes('c'), "a key, not a unit");
        for (text, value) in
            [("1", 1.0), ("c", 1.0), ("m", 10.0), ("+", 10.0), ("2", 12.0), ("m", 2010.0), ("m", 12.0)]
        {
            assert!(typed.push(text));
            assert_eq!(typed.value(0), Some(value), "after {text}");
        }
        assert!(!typed.push("m") && !typed.push("x"));
        assert_eq!(typed.refusal(), None);
        typed.clear();
        assert!("3deg".chars().all(|c| typed.push(&c.to_string())));
        assert_eq!(typed.value(0), None);
        assert!(typed.refusal().is_some_and(|reason| reason.contains("this is a length")));
        assert!(typed.pop());
        assert_eq!((typed.value(0), typed.refusal()), (Some(3.0), None), "unfinished");

        let mut typed = Typed::new(Measure::Angle, LengthUnit::None);
        assert!("2*pirad".chars().all(|c| typed.push(&c.to_string())));
        assert_eq!(typed.value(0), Some(360.0));
        let mut typed = Typed::new(Measure::Factor, LengthUnit::None);
        assert!(typed.push("5") && typed.push("0") && typed.push("%"));
        assert_eq!(typed.value(0), Some(0.5));
    }

    #[test]
    fn pi_is_typed_after_an_operator() {
        let mut typed = Typed::default();
        assert!(!typed.push("p"), "a key, not a number");
        for text in ["2", "*", "p"] {
            assert!(typed.push(text));
            assert_eq!(typed.value(0), Some(2.0), "after {text}");
        }
        assert!(typed.push("i"));
        assert_eq!(typed.value(0), Some(std::f32::consts::TAU));
    }
}
