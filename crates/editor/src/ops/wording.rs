//! Names and numbers as forms show them.

use halfedge::words::capitalized;

/// A name in JSON as people read it: `tube_radius` is "Tube radius", `uv-sphere` "UV sphere".
pub fn sentence_case(name: &str) -> String {
    capitalized(&name.replace(['_', '-'], " ").replace("uv ", "UV "))
}

/// A length to suggest, rounded to four significant digits: 0 for one that is not above 0.
pub fn four_digits(length: f64) -> f64 {
    if !length.is_finite() || length <= 0.0 {
        return 0.0;
    }
    let unit = 10_f64.powi(length.log10().floor() as i32 - 3);
    let steps = (length / unit).round();
    // Dividing by a whole power of ten gives the number that is written with these digits.
    if unit < 1.0 { steps / (1.0 / unit).round() } else { steps * unit }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suggested_lengths_have_four_digits() {
        let cases = [(0.123456, 0.1235), (2.0, 2.0), (98765.4, 98770.0), (1.23456e-5, 1.235e-5), (0.0, 0.0)];
        for (length, wanted) in cases {
            assert_eq!(four_digits(length), wanted);
        }
        assert_eq!(four_digits(f64::NAN), 0.0);
        assert_eq!(four_digits(-1.0), 0.0);
    }

    #[test]
    fn names_are_read_as_words() {
        assert_eq!(sentence_case("feature_angle"), "Feature angle");
        assert_eq!(sentence_case("uv-sphere"), "UV sphere");
        assert_eq!(sentence_case(""), "");
    }
}
