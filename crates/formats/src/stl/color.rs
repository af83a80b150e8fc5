//! Colours of faces in the two bytes that a binary STL has behind each triangle: 15 bits in one of two
//! conventions.
//!
//! VisCAM and SolidView set the highest bit where a triangle has a colour, blue is lowest. Materialise Magics
//! has a colour for all triangles behind `COLOR=` in the header and sets the bit where a triangle has that one,
//! red is lowest.

use halfedge::Color;

/// The highest value of a channel.
const FULL: u16 = 31;

/// What stands before the colour of all triangles in the header.
const DEFAULT_COLOR: &[u8] = b"COLOR=";

/// What the bytes behind triangles say.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Attributes {
    /// Nothing.
    None,
    /// The colour of each triangle, and whether the header has an opacity below full.
    Colors(Vec<Color>, bool),
    /// Of so many triangles something else than a colour.
    Unknown(usize),
}

/// The colours that the header and the bytes behind each triangle give.
pub(super) fn read(header: &[u8], attributes: &[u16]) -> Attributes {
    let has_flag = |attribute: &u16| attribute & 0x8000 != 0;
    let used = attributes.iter().filter(|&&attribute| attribute != 0).count();
    if let Some([r, g, b, opacity]) = default_color(header) {
        let default = Color([r, g, b]);
        // Nothing behind any triangle doesn't mean that all are black.
        let own = |attribute: &u16| {
            if used == 0 || has_flag(attribute) { default } else { color(*attribute, [0, 5, 10]) }
        };
        return Attributes::Colors(attributes.iter().map(own).collect(), opacity < 255);
    }
    if used == 0 {
        return Attributes::None;
    }
    if !attributes.iter().any(has_flag) {
        return Attributes::Unknown(used);
    }
    let own = |attribute: &u16| {
        if has_flag(attribute) { color(*attribute, [10, 5, 0]) } else { Color::UNPAINTED }
    };
    Attributes::Colors(attributes.iter().map(own).collect(), false)
}

/// The bytes behind a triangle of this colour, in VisCAM's convention; zero for one without.
pub(super) fn attribute(color: Color) -> u16 {
    if color == Color::UNPAINTED {
        return 0;
    }
    let [r, g, b] = color.0.map(|channel| (u16::from(channel) * FULL + 127) / 255);
    0x8000 | r << 10 | g << 5 | b
}

/// Whether a colour comes back as it is.
pub(super) fn is_exact(painted: Color) -> bool {
    painted == Color::UNPAINTED || color(attribute(painted), [10, 5, 0]) == painted
}

fn color(attribute: u16, shifts: [u16; 3]) -> Color {
    Color(shifts.map(|shift| (((attribute >> shift & FULL) * 255 + FULL / 2) / FULL) as u8))
}

/// Red, green, blue and opacity of all triangles, by the header.
fn default_color(header: &[u8]) -> Option<[u8; 4]> {
    let at = header.windows(DEFAULT_COLOR.len()).position(|part| part == DEFAULT_COLOR)?;
    header.get(at + DEFAULT_COLOR.len()..)?.first_chunk().copied()
}

/// What else a header says, for the import report: its text, up to a colour.
pub(super) fn text(header: &[u8]) -> String {
    let end =
        header.windows(DEFAULT_COLOR.len()).position(|part| part == DEFAULT_COLOR).unwrap_or(header.len());
    let text = header.get(..end).unwrap_or_default().split(|&byte| byte == 0).next().unwrap_or_default();
    let text: String = String::from_utf8_lossy(text).chars().filter(|c| !c.is_control()).collect();
    // What is no text says nothing.
    if text.contains(char::REPLACEMENT_CHARACTER) { String::new() } else { text.trim().to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_of_both_conventions_are_read() {
        let viscam = read(b"x", &[0xfc00, 0x83e0, 0x801f, 0x7c00]);
        let (red, green, blue) = (Color([255, 0, 0]), Color([0, 255, 0]), Color([0, 0, 255]));
        assert_eq!(viscam, Attributes::Colors(vec![red, green, blue, Color::UNPAINTED], false));
        let header = b"COLOR=\x01\x02\x03\xff,MATERIAL=";
        let magics = read(header, &[0x001f, 0x03e0, 0x7c00, 0x801f]);
        assert_eq!(magics, Attributes::Colors(vec![red, green, blue, Color([1, 2, 3])], false));
        assert_eq!(read(header, &[0, 0]), Attributes::Colors(vec![Color([1, 2, 3]); 2], false));
        assert_eq!(read(b"COLOR=\x01\x02\x03\x7f", &[]), Attributes::Colors(vec![], true));
        assert_eq!(read(b"COLOR=\x01\x02", &[0, 0]), Attributes::None);
        assert_eq!(read(b"", &[0, 7, 9]), Attributes::Unknown(2));
    }

    #[test]
    fn colours_of_five_bits_come_back() {
        for bits in 0..0x8000u16 {
            let read = color(bits, [10, 5, 0]);
            if read != Color::UNPAINTED {
                assert_eq!(attribute(read), 0x8000 | bits);
                assert!(is_exact(read));
            }
        }
        assert!(!is_exact(Color([1, 0, 0])) && is_exact(Color::UNPAINTED));
    }

    #[test]
    fn headers_are_named_up_to_their_colour() {
        assert_eq!(text(b"made by x\0\0rest"), "made by x");
        assert_eq!(text(b" a\x01 COLOR=\xff\xff\xff\xff"), "a");
        assert_eq!(text(&[0; 80]), "");
    }
}
