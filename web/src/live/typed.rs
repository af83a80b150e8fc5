//! Numbers typed during an edit, one per axis that may change.

use crate::widgets::number_box::evaluate;

/// The typed numbers. Each may be an expression such as `1/3`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Typed {
    texts: Vec<String>,
    at: usize,
}

impl Typed {
    /// Whether nothing is typed.
    pub fn is_empty(&self) -> bool {
        self.texts.iter().all(String::is_empty)
    }

    /// Appends the characters that numbers and expressions consist of, with the letters of `pi`; returns whether there were any.
    pub fn push(&mut self, text: &str) -> bool {
        let before = self.texts.get(self.at).map_or(0, String::len);
        if self.texts.len() <= self.at {
            self.texts.resize(self.at + 1, String::new());
        }
        if let Some(typed) = self.texts.get_mut(self.at) {
            for c in text.chars() {
                // A letter alone is a key.
                let is_of_pi = match c {
                    'p' | 'P' => typed.ends_with(['+', '-', '*', '/', '^', '(']),
                    'i' | 'I' => typed.ends_with(['p', 'P']),
                    _ => false,
                };
                if is_of_pi || c.is_ascii_digit() || "+-*/^().π".contains(c) {
                    typed.push(c);
                }
            }
            return typed.len() > before;
        }
        false
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
        let text = self.texts.get(at)?;
        // A sign or an operator at the end waits for its number.
        let finished = text.trim_end_matches(['+', '-', '*', '/', '^', '(', '.', 'p', 'P']);
        evaluate(text)
            .or_else(|| evaluate(finished))
            .map(|value| value as f32)
            .filter(|value| value.is_finite())
    }

    /// The text of a number, as typed.
    pub fn text(&self, at: usize) -> Option<&str> {
        self.texts.get(at).map(String::as_str).filter(|text| !text.is_empty())
    }
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
    fn pi_is_typed_after_an_operator() {
        let mut typed = Typed::default();
        assert!(!typed.push("p"), "a key, not a number");
        for text in ["2", "*", "p"] {
            assert!(typed.push(text));
            assert_eq!(typed.value(0), Some(2.0), "after {text}");
        }
        assert!(typed.push("i") && !typed.push("i"));
        assert_eq!(typed.value(0), Some(std::f32::consts::TAU));
    }
}
