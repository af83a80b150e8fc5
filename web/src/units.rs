//! Typed numbers: arithmetic, and the units of lengths, angles and factors.

use std::iter::Peekable;
use std::str::Chars;

use Measure::{Angle, Factor, Length};

/// What one unit of the mesh is, so that typed lengths may have units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LengthUnit {
    /// Nothing in particular.
    #[default]
    None,
    Millimetre,
    Centimetre,
    Metre,
    Inch,
    Foot,
}

impl LengthUnit {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::None, Self::Millimetre, Self::Centimetre, Self::Metre, Self::Inch, Self::Foot];

    /// The name in settings; that of a unit is what is typed.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Millimetre => "mm",
            Self::Centimetre => "cm",
            Self::Metre => "m",
            Self::Inch => "in",
            Self::Foot => "ft",
        }
    }

    /// The unit of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// The length in tenths of a millimetre, which are whole for all units, so that conversions are exact.
    fn tenths_of_mm(self) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Millimetre => Some(10.0),
            Self::Centimetre => Some(100.0),
            Self::Metre => Some(10_000.0),
            Self::Inch => Some(254.0),
            Self::Foot => Some(3_048.0),
        }
    }
}

/// What a number measures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Measure {
    /// Nothing that has a unit.
    #[default]
    Number,
    /// A length, in the unit of the mesh.
    Length,
    /// An angle, in degrees.
    Angle,
    /// A factor or a part of a whole.
    Factor,
}

impl Measure {
    /// What it is called, and what may follow its numbers.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Number => ["a number without a unit", "no unit"],
            Self::Length => ["a length", "mm, cm, m, in, ft or no unit"],
            Self::Angle => ["an angle", "deg, °, rad or no unit"],
            Self::Factor => ["a factor", "% or no unit"],
        }
    }
}

/// Why a text isn't the number that was wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// It isn't a number at all, or not yet.
    Unfinished,
    /// It has a unit that can't be there, for this reason.
    Unit(String),
}

/// What follows a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Suffix {
    Length(LengthUnit),
    Degrees,
    DegreeSign,
    Radians,
    Percent,
}

/// The suffixes as they are typed; `mm` comes before `m`.
const SUFFIXES: [(&str, Suffix); 9] = [
    ("mm", Suffix::Length(LengthUnit::Millimetre)),
    ("cm", Suffix::Length(LengthUnit::Centimetre)),
    ("m", Suffix::Length(LengthUnit::Metre)),
    ("in", Suffix::Length(LengthUnit::Inch)),
    ("ft", Suffix::Length(LengthUnit::Foot)),
    ("deg", Suffix::Degrees),
    ("rad", Suffix::Radians),
    ("°", Suffix::DegreeSign),
    ("%", Suffix::Percent),
];

impl Suffix {
    fn measure(self) -> Measure {
        match self {
            Self::Length(_) => Length,
            Self::Degrees | Self::DegreeSign | Self::Radians => Angle,
            Self::Percent => Factor,
        }
    }

    fn text(self) -> &'static str {
        SUFFIXES.iter().find(|(_, suffix)| *suffix == self).map_or("", |(text, _)| text)
    }
}

/// Whether a letter can follow a number with these letters after it, as a part of a suffix.
pub fn continues_suffix(letters: &str, letter: char) -> bool {
    let with = letters.chars().chain([letter]).flat_map(char::to_lowercase).collect::<String>();
    SUFFIXES.iter().any(|(text, _)| text.starts_with(&with))
}

/// The value of an expression of numbers, `pi`, `+`, `-`, `*`, `/`, `^`, parentheses and units, in degrees for angles and in
/// the unit of the mesh for lengths. Its value is finite. Written here because the crates for it bring a regex engine into
/// the page.
pub fn evaluate(text: &str, measure: Measure, unit: LengthUnit) -> Result<f64, Wrong> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let mut parser = Parser { rest: text.chars().peekable(), depth: 0, unit, refused: None };
    let found = parser.sum().filter(|_| parser.rest.next().is_none());
    if let Some(reason) = parser.refused {
        return Err(Wrong::Unit(reason));
    }
    let value = found.filter(|found| found.value.is_finite()).ok_or(Wrong::Unfinished)?;
    match value.suffix {
        Some(suffix) if suffix.measure() != measure => {
            let [is, may_be] = measure.words();
            let [belongs_to, _] = suffix.measure().words();
            let text = suffix.text();
            Err(Wrong::Unit(format!("\"{text}\" belongs to {belongs_to}, and this is {is}: use {may_be}.")))
        }
        _ => Ok(value.value),
    }
}

/// A value, and the unit that it was given in: without one, it is what the field measures.
#[derive(Clone, Copy)]
struct Value {
    value: f64,
    suffix: Option<Suffix>,
}

impl Value {
    fn plain(value: f64) -> Self {
        Self { value, suffix: None }
    }
}

/// The deepest nesting of parentheses and signs.
const MAX_NESTING: u32 = 100;

struct Parser<'a> {
    rest: Peekable<Chars<'a>>,
    depth: u32,
    unit: LengthUnit,
    /// Why a unit can't be where it is.
    refused: Option<String>,
}

impl Parser<'_> {
    fn takes(&mut self, wanted: &[char]) -> Option<char> {
        self.rest.next_if(|c| wanted.contains(c))
    }

    fn sum(&mut self) -> Option<Value> {
        let mut sum = self.product()?;
        while let Some(sign) = self.takes(&['+', '-', '−']) {
            let next = self.product()?;
            if let (Some(a), Some(b)) = (sum.suffix, next.suffix)
                && a.measure() != b.measure()
            {
                let [a, b] = [a.text(), b.text()];
                return self
                    .refuse(format!("\"{a}\" and \"{b}\" can't be added: they measure different things."));
            }
            sum.value += if sign == '+' { next.value } else { -next.value };
            sum.suffix = sum.suffix.or(next.suffix);
        }
        Some(sum)
    }

    /// A product with its unit, which belongs to all before it: `1/3 in` is a third of an inch.
    fn product(&mut self) -> Option<Value> {
        let mut product = self.signed()?;
        loop {
            if let Some(suffix) = self.suffix() {
                if product.suffix.is_some() {
                    return self.refuse_square(suffix);
                }
                let value = product.value * self.factor(suffix)?;
                product = Value { value, suffix: Some(suffix) };
            } else if let Some(sign) = self.takes(&['*', '×', '/', '÷']) {
                let next = self.signed()?;
                let is_product = matches!(sign, '*' | '×');
                match (product.suffix, next.suffix) {
                    (Some(_), Some(suffix)) => return self.refuse_square(suffix),
                    (None, Some(suffix)) if !is_product => return self.refuse_square(suffix),
                    _ => {}
                }
                product.value =
                    if is_product { product.value * next.value } else { product.value / next.value };
                product.suffix = product.suffix.or(next.suffix);
            } else {
                return Some(product);
            }
        }
    }

    fn refuse<T>(&mut self, reason: String) -> Option<T> {
        self.refused.get_or_insert(reason);
        None
    }

    fn refuse_square<T>(&mut self, suffix: Suffix) -> Option<T> {
        self.refuse(format!(
            "\"{}\" can't be there: only numbers without a unit multiply and divide.",
            suffix.text()
        ))
    }

    fn suffix(&mut self) -> Option<Suffix> {
        let rest = self.rest.clone().take(4).flat_map(char::to_lowercase).collect::<String>();
        let (text, suffix) = SUFFIXES.iter().find(|(text, _)| rest.starts_with(text))?;
        for _ in text.chars() {
            self.rest.next();
        }
        Some(*suffix)
    }

    /// What a number with this suffix is multiplied by.
    fn factor(&mut self, suffix: Suffix) -> Option<f64> {
        match suffix {
            Suffix::Degrees | Suffix::DegreeSign => Some(1.0),
            Suffix::Radians => Some(180.0 / std::f64::consts::PI),
            Suffix::Percent => Some(0.01),
            Suffix::Length(unit) => match self.unit.tenths_of_mm() {
                Some(own) => Some(unit.tenths_of_mm()? / own),
                None => self.refuse(format!(
                    "\"{}\" means nothing yet: choose what one unit of the mesh is in Edit > Unit of length.",
                    unit.name()
                )),
            },
        }
    }

    fn signed(&mut self) -> Option<Value> {
        self.depth += 1;
        if self.depth > MAX_NESTING {
            return None;
        }
        let signed = match self.takes(&['+', '-', '−']) {
            Some('+') => self.signed(),
            Some(_) => self.signed().map(|value| Value { value: -value.value, ..value }),
            None => {
                let base = self.atom()?;
                // As in mathematics, -2^2 is -4, and 2^3^2 is 2^9.
                match self.takes(&['^']) {
                    Some(_) => {
                        let exponent = self.signed()?;
                        if let Some(suffix) = base.suffix.or(exponent.suffix) {
                            return self.refuse_square(suffix);
                        }
                        Some(Value::plain(base.value.powf(exponent.value)))
                    }
                    None => Some(base),
                }
            }
        };
        self.depth -= 1;
        signed
    }

    fn atom(&mut self) -> Option<Value> {
        if self.takes(&['(']).is_some() {
            let sum = self.sum()?;
            return self.takes(&[')']).map(|_| sum);
        }
        if self.takes(&['π']).is_some() {
            return Some(Value::plain(std::f64::consts::PI));
        }
        if self.takes(&['p', 'P']).is_some() {
            return self.takes(&['i', 'I']).map(|_| Value::plain(std::f64::consts::PI));
        }
        self.number().map(Value::plain)
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

    fn number(text: &str) -> Option<f64> {
        evaluate(text, Measure::Number, LengthUnit::None).ok()
    }

    fn refusal(text: &str, measure: Measure, unit: LengthUnit) -> String {
        match evaluate(text, measure, unit) {
            Err(Wrong::Unit(reason)) => reason,
            other => panic!("{text}: {other:?}"),
        }
    }

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
            assert_eq!(number(text), Some(value), "{text}");
        }
        let wrong =
            ["", "-", "1+", "(1", "1)", "1/0", "0/0", "p", "two", "1..2", "1 2 x", "1e", "e", "nan", "inf"];
        for text in wrong {
            assert_eq!(number(text), None, "{text}");
        }
        assert_eq!(number(&"(".repeat(100_000)), None, "no stack overflow");
        assert_eq!(number(&"-".repeat(100_000)), None);
    }

    #[test]
    fn lengths_are_converted_to_the_unit_of_the_mesh() {
        let units = [LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch];
        for (text, millimetres) in
            [("1mm", 1.0), ("1 cm", 10.0), ("1M", 1000.0), ("1in", 25.4), ("1 ft", 304.8)]
        {
            for (unit, per_unit) in units.into_iter().zip([1.0, 10.0, 1000.0, 25.4]) {
                let value = evaluate(text, Length, unit).expect("a length");
                assert!((value - millimetres / per_unit).abs() < 1e-12, "{text} in {}: {value}", unit.name());
            }
        }
        assert_eq!(evaluate("1ft", Length, LengthUnit::Inch), Ok(12.0), "exactly");
        assert_eq!(evaluate("7", Length, LengthUnit::Inch), Ok(7.0), "a number is in the unit of the mesh");
        assert_eq!(evaluate("7", Length, LengthUnit::None), Ok(7.0));
    }

    #[test]
    fn units_mix_with_arithmetic() {
        let mm = |text: &str| evaluate(text, Length, LengthUnit::Millimetre);
        let cases = [
            ("1cm+2mm", 12.0),
            ("1cm + 2", 12.0),
            ("-1cm", -10.0),
            ("2*3cm", 60.0),
            ("3cm*2", 60.0),
            ("(1+1)cm", 20.0),
            ("(1cm+5mm)/3", 5.0),
            ("1/4 cm", 2.5),
            ("1ft - 1in", 279.4),
            ("1e1mm", 10.0),
        ];
        for (text, value) in cases {
            let found = mm(text).unwrap_or_else(|wrong| panic!("{text}: {wrong:?}"));
            assert!((found - value).abs() < 1e-9, "{text}: {found}");
        }
        for text in ["1 cm cm", "1cm*2cm", "1/(2cm)", "(1cm)^2", "2^(1cm)", "6cm/2cm"] {
            let reason = refusal(text, Length, LengthUnit::Millimetre);
            assert!(reason.contains("only numbers without a unit multiply and divide"), "{text}: {reason}");
        }
        assert_eq!(
            refusal("1cm+3deg", Length, LengthUnit::Millimetre),
            "\"cm\" and \"deg\" can't be added: they measure different things."
        );
        for text in ["cm", "1km", "1c", "1cm2", "cm1"] {
            assert_eq!(mm(text), Err(Wrong::Unfinished), "{text}");
        }
    }

    #[test]
    fn angles_are_in_degrees_and_factors_are_parts() {
        let angle = |text: &str| evaluate(text, Angle, LengthUnit::None).expect("an angle");
        assert_eq!((angle("90deg"), angle("45 °"), angle("30")), (90.0, 45.0, 30.0));
        assert!((angle("pi rad") - 180.0).abs() < 1e-12 && (angle("1/2*pi rad") - 90.0).abs() < 1e-12);
        let factor = |text: &str| evaluate(text, Factor, LengthUnit::None).expect("a factor");
        assert_eq!((factor("50%"), factor("100% + 0.5"), factor("2")), (0.5, 1.5, 2.0));
    }

    #[test]
    fn units_of_something_else_are_refused_in_words() {
        assert_eq!(
            refusal("3deg", Length, LengthUnit::Metre),
            "\"deg\" belongs to an angle, and this is a length: use mm, cm, m, in, ft or no unit."
        );
        assert_eq!(
            refusal("3cm", Angle, LengthUnit::Metre),
            "\"cm\" belongs to a length, and this is an angle: use deg, °, rad or no unit."
        );
        assert_eq!(
            refusal("1rad", Factor, LengthUnit::Metre),
            "\"rad\" belongs to an angle, and this is a factor: use % or no unit."
        );
        assert_eq!(
            refusal("5%", Measure::Number, LengthUnit::Metre),
            "\"%\" belongs to a factor, and this is a number without a unit: use no unit."
        );
        assert_eq!(
            refusal("1 cm", Length, LengthUnit::None),
            "\"cm\" means nothing yet: choose what one unit of the mesh is in Edit > Unit of length."
        );
    }

    #[test]
    fn suffixes_are_typed_letter_by_letter() {
        for (letters, letter) in
            [("", 'm'), ("m", 'm'), ("", 'C'), ("c", 'm'), ("d", 'e'), ("de", 'g'), ("ra", 'd')]
        {
            assert!(continues_suffix(letters, letter), "{letters}{letter}");
        }
        for (letters, letter) in [("", 'x'), ("", 'g'), ("mm", 'm'), ("in", 'n'), ("c", 'i')] {
            assert!(!continues_suffix(letters, letter), "{letters}{letter}");
        }
        for unit in LengthUnit::ALL {
            assert_eq!(LengthUnit::named(unit.name()), Some(unit));
        }
    }

    proptest! {
        #[test]
        fn anything_may_be_typed(text in "[-+*/^().0-9eπpicmdgraft%° ]{0,40}") {
            for measure in [Measure::Number, Length, Angle, Factor] {
                let value = evaluate(&text, measure, LengthUnit::Metre);
                prop_assert!(value.is_ok_and(f64::is_finite) || evaluate(&text, measure, LengthUnit::Metre).is_err());
            }
        }

        #[test]
        fn numbers_mean_themselves(value in -1e9f64..1e9) {
            prop_assert_eq!(number(&value.to_string()), Some(value));
            prop_assert_eq!(number(&format!("{value:e}")), Some(value));
        }
    }
}
