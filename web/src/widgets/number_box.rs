//! Spin boxes that take arithmetic, and act when editing ends, never on half a number.

use std::iter::Peekable;
use std::str::Chars;

use egui::DragValue;
use egui::emath::Numeric;

/// A spin box. What is typed may be an expression such as `1/3` or `2*pi`; it counts when the box loses the
/// focus or Enter is pressed.
pub fn number_box<N: Numeric>(value: &mut N) -> DragValue<'_> {
    DragValue::new(value).update_while_editing(false).custom_parser(evaluate)
}

/// The value of an expression of numbers, `pi`, `+`, `-`, `*`, `/`, `^` and parentheses; none if it isn't one or
/// its value isn't finite. Written here because the crates for it bring a regex engine into the page.
pub(crate) fn evaluate(text: &str) -> Option<f64> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let mut parser = Parser { rest: text.chars().peekable(), depth: 0 };
    let value = parser.sum()?;
    (parser.rest.next().is_none() && value.is_finite()).then_some(value)
}

/// The deepest nesting of parentheses and signs.
const MAX_NESTING: u32 = 100;

struct Parser<'a> {
    rest: Peekable<Chars<'a>>,
    depth: u32,
}

impl Parser<'_> {
    fn takes(&mut self, wanted: &[char]) -> Option<char> {
        self.rest.next_if(|c| wanted.contains(c))
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        while let Some(sign) = self.takes(&['+', '-', '−']) {
            let next = self.product()?;
            value += if sign == '+' { next } else { -next };
        }
        Some(value)
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.signed()?;
        while let Some(sign) = self.takes(&['*', '×', '/', '÷']) {
            let next = self.signed()?;
            value = if matches!(sign, '*' | '×') { value * next } else { value / next };
        }
        Some(value)
    }

    fn signed(&mut self) -> Option<f64> {
        self.depth += 1;
        if self.depth > MAX_NESTING {
            return None;
        }
        let value = match self.takes(&['+', '-', '−']) {
            Some('+') => self.signed(),
            Some(_) => self.signed().map(|value| -value),
            None => {
                let base = self.atom()?;
                // As in mathematics, -2^2 is -4, and 2^3^2 is 2^9.
                match self.takes(&['^']) {
                    Some(_) => Some(base.powf(self.signed()?)),
                    None => Some(base),
                }
            }
        };
        self.depth -= 1;
        value
    }

    fn atom(&mut self) -> Option<f64> {
        if self.takes(&['(']).is_some() {
            let value = self.sum()?;
            return self.takes(&[')']).map(|_| value);
        }
        if self.takes(&['π']).is_some() {
            return Some(std::f64::consts::PI);
        }
        if self.takes(&['p', 'P']).is_some() {
            return self.takes(&['i', 'I']).map(|_| std::f64::consts::PI);
        }
        self.number()
    }

    fn number(&mut self) -> Option<f64> {
        let mut digits = String::new();
        while let Some(c) = self.rest.next_if(|c| c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E')) {
            digits.push(c);
            if matches!(c, 'e' | 'E') {
                digits.extend(self.takes(&['+', '-', '−']).map(|sign| if sign == '+' { '+' } else { '-' }));
            }
        }
        digits.parse().ok()
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn expressions_have_their_values() {
        let pi = std::f64::consts::PI;
        let cases = [
            ("12", 12.0),
            ("-0.25", -0.25),
            ("−3", -3.0),
            (" 1 / 3 ", 1.0 / 3.0),
            ("2*pi", 2.0 * pi),
            ("-π/2", -pi / 2.0),
            ("1e-3", 0.001),
            ("2.5E2+1", 251.0),
            ("1 - 2 - 3", -4.0),
            ("2 + 3 * 4", 14.0),
            ("(2 + 3) * -4", -20.0),
            ("-2^2", -4.0),
            ("2^3^2", 512.0),
            ("8/2/2", 2.0),
            (".5", 0.5),
        ];
        for (text, value) in cases {
            assert_eq!(evaluate(text), Some(value), "{text}");
        }
        let wrong =
            ["", "-", "1+", "(1", "1)", "1/0", "0/0", "p", "two", "1..2", "1 2 x", "1e", "e", "nan", "inf"];
        for text in wrong {
            assert_eq!(evaluate(text), None, "{text}");
        }
        assert_eq!(evaluate(&"(".repeat(100_000)), None, "no stack overflow");
        assert_eq!(evaluate(&"-".repeat(100_000)), None);
    }

    proptest! {
        #[test]
        fn anything_may_be_typed(text in "[-+*/^().0-9eπpi ]{0,40}") {
            prop_assert!(evaluate(&text).is_none_or(f64::is_finite));
        }

        #[test]
        fn numbers_mean_themselves(value in -1e9f64..1e9) {
            prop_assert_eq!(evaluate(&value.to_string()), Some(value));
            prop_assert_eq!(evaluate(&format!("{value:e}")), Some(value));
        }
    }
}
