//! Numbers in the text of elements.
//!
//! Blanks lie between numbers. Programs in some languages write decimal commas, and some programs write
//! commas between numbers. Text with commas is read in the one way that gives the number of values that it
//! should have.

use crate::notes::Notes;
use crate::text::scan::Scan;
use halfedge::NONE;

/// A number type that lists are read as.
pub(super) trait Number: Copy + Default {
    /// What stands for a number that can't be read.
    const UNREADABLE: Self;

    fn scan(scan: &mut Scan) -> Option<Self>;

    fn parse(word: &str) -> Option<Self>;
}

impl Number for f32 {
    const UNREADABLE: Self = Self::NAN;

    fn scan(scan: &mut Scan) -> Option<Self> {
        scan.float()
    }

    fn parse(word: &str) -> Option<Self> {
        word.parse().ok()
    }
}

impl Number for f64 {
    const UNREADABLE: Self = Self::NAN;

    fn scan(scan: &mut Scan) -> Option<Self> {
        scan.double()
    }

    fn parse(word: &str) -> Option<Self> {
        word.parse().ok()
    }
}

/// An index or a count. Negative ones stand for "none" in some files and are unreadable here.
impl Number for u32 {
    const UNREADABLE: Self = NONE;

    fn scan(scan: &mut Scan) -> Option<Self> {
        u32::try_from(scan.integer()?).ok()
    }

    fn parse(word: &str) -> Option<Self> {
        word.parse().ok().or_else(|| {
            // "3.0" is a whole number, too.
            let value = word.parse::<f64>().ok()?;
            (value.fract() == 0.0 && (0.0..f64::from(NONE)).contains(&value)).then_some(value as u32)
        })
    }
}

/// The numbers of a text.
#[derive(Debug, PartialEq)]
pub(super) struct Numbers<T> {
    pub values: Vec<T>,
    /// How many of them can't be read.
    pub unreadable: usize,
    pub commas: Commas,
}

/// What commas in a text are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Commas {
    /// There are none.
    None,
    Decimal,
    Separators,
    /// Neither reading gives the right number of values.
    Ambiguous,
}

impl<T> Numbers<T> {
    /// Notes how commas were read.
    ///
    /// # Errors
    /// Where commas are ambiguous; the clause follows "has".
    pub(super) fn note_commas(&self, notes: &mut Notes) -> Result<(), &'static str> {
        match self.commas {
            Commas::None => {}
            Commas::Decimal => notes.info("Commas in its numbers were read as decimal commas"),
            Commas::Separators => notes.info("Commas between its numbers were read as separators"),
            Commas::Ambiguous => {
                return Err("commas that may be decimal commas or separators (decimal points are needed)");
            }
        }
        Ok(())
    }
}

/// The numbers of a text that should have `expected` of them, if that is known. There are no values where
/// commas are ambiguous. Costs O(text).
pub(super) fn numbers<T: Number>(text: &[u8], expected: Option<usize>) -> Numbers<T> {
    if text.contains(&b',') {
        return with_commas(text, expected);
    }
    let mut scan = Scan::new(text, None);
    let mut values = Vec::with_capacity(text.len() / 8);
    let mut unreadable = 0;
    while !scan.at_end() {
        let start = scan.at;
        let value = T::scan(&mut scan).or_else(|| {
            let word = text.get(start..scan.at).and_then(|word| std::str::from_utf8(word).ok())?;
            T::parse(word.trim())
        });
        unreadable += usize::from(value.is_none());
        values.push(value.unwrap_or(T::UNREADABLE));
    }
    Numbers { values, unreadable, commas: Commas::None }
}

#[cold]
fn with_commas<T: Number>(text: &[u8], expected: Option<usize>) -> Numbers<T> {
    let text = String::from_utf8_lossy(text);
    let decimals = |words: &mut dyn Iterator<Item = &str>| -> Vec<Option<T>> {
        words.map(|word| T::parse(&word.replacen(',', ".", 1))).collect()
    };
    let words = decimals(&mut text.split_whitespace());
    let separator = |c: char| c.is_whitespace() || c == ',';
    let parts: Vec<Option<T>> = text.split(separator).filter(|part| !part.is_empty()).map(T::parse).collect();
    // A word like "1,2,3" or "1," is not one number.
    let can_be_decimal =
        words.iter().all(Option::is_some) && !text.split_whitespace().any(|word| word.ends_with(','));
    let can_be_separators = parts.iter().all(Option::is_some);
    let fits = |count: usize| expected.is_none_or(|expected| expected == count);
    let is_decimal = can_be_decimal && fits(words.len());
    let is_separators = can_be_separators && fits(parts.len());
    let (values, commas) = match (is_decimal, is_separators) {
        (true, false) => (words, Commas::Decimal),
        (false, true) => (parts, Commas::Separators),
        _ => (Vec::new(), Commas::Ambiguous),
    };
    let unreadable = values.iter().filter(|value| value.is_none()).count();
    Numbers {
        values: values.into_iter().map(|value| value.unwrap_or(T::UNREADABLE)).collect(),
        unreadable,
        commas,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, expected: Option<usize>) -> (Vec<f32>, Commas) {
        let numbers = numbers(text.as_bytes(), expected);
        assert_eq!(numbers.unreadable, 0, "{text}");
        (numbers.values, numbers.commas)
    }

    #[test]
    fn commas_are_read_in_the_one_way_that_fits() {
        assert_eq!(read(" 1 2.5\n-3e1 ", None), (vec![1.0, 2.5, -30.0], Commas::None));
        assert_eq!(read("-7,5 -14,25 0,0", Some(3)), (vec![-7.5, -14.25, 0.0], Commas::Decimal));
        assert_eq!(read("1,5 2 3", Some(3)), (vec![1.5, 2.0, 3.0], Commas::Decimal));
        assert_eq!(read("1,2,3 4,5,6", Some(6)), (vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0], Commas::Separators));
        assert_eq!(read("1, 2, 3", None), (vec![1.0, 2.0, 3.0], Commas::Separators));
        assert_eq!(read("0.5,1", None), (vec![0.5, 1.0], Commas::Separators));
        for ambiguous in ["1,5 2,5", "1,5 x"] {
            assert_eq!(read(ambiguous, Some(3)), (vec![], Commas::Ambiguous), "{ambiguous}");
        }
        assert_eq!(read("1,5 2,5", None), (vec![], Commas::Ambiguous));
    }

    #[test]
    fn unreadable_numbers_keep_their_places() {
        let found: Numbers<f32> = numbers(b"1 x 3", None);
        assert!(found.unreadable == 1 && found.values[1].is_nan() && found.values[2] == 3.0);
        let found: Numbers<u32> = numbers(b"1 -1 3.0 2.5 99999999999", None);
        assert_eq!((found.unreadable, found.values), (3, vec![1, NONE, 3, NONE, NONE]));
        let found: Numbers<u32> = numbers(b"0,1,2", None);
        assert_eq!((found.commas, found.values), (Commas::Separators, vec![0, 1, 2]));
    }
}
