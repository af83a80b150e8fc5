//! The header of a PLY: which elements with which properties come, and how they are written.

use crate::error::not_a;
use crate::report::Places;
use crate::text::scan::{Scan, is_text};

/// How much of a file's start its first line is looked for in, in bytes.
const HEAD_BYTES: usize = 64 * 1024;

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Scalar {
    fn parse(word: &[u8]) -> Option<Self> {
        Some(match word {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"int64" => Self::I64,
            b"uint64" => Self::U64,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }

    /// What a channel of a colour is divided by to run from 0 to 1.
    pub(super) fn full(self) -> f64 {
        match self {
            Self::I8 => f64::from(i8::MAX),
            Self::U8 => f64::from(u8::MAX),
            Self::I16 => f64::from(i16::MAX),
            Self::U16 => f64::from(u16::MAX),
            Self::I32 => f64::from(i32::MAX),
            Self::U32 => f64::from(u32::MAX),
            Self::I64 => i64::MAX as f64,
            Self::U64 => u64::MAX as f64,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

/// How the numbers after the header are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A property of every row of an element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Property {
    pub name: String,
    pub scalar: Scalar,
    /// For a list: how its length is stored.
    pub count: Option<Scalar>,
}

/// A table: so many rows with these properties.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Table {
    pub name: String,
    pub rows: u64,
    pub properties: Vec<Property>,
}

/// What the header says, and where what it describes begins.
#[derive(Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub tables: Vec<Table>,
    /// The images that a `comment TextureFile` names, as MeshLab writes it.
    pub texture_files: Vec<String>,
    /// The texts of `obj_info` lines.
    pub infos: Vec<String>,
    /// Lines that don't belong in a header.
    pub stray: Places,
    /// Lines of properties of a type that is none of the format's, which text can have.
    pub unknown_types: Places,
    /// Whether the header states no format.
    pub is_guessed: bool,
    /// Where the rows start.
    pub end: usize,
}

/// Whether the first line is that of a PLY.
pub(super) fn is_ply(bytes: &[u8]) -> bool {
    let mut scan = Scan::new(bytes.get(..HEAD_BYTES).unwrap_or(bytes), None);
    scan.word() == Some(b"ply") && !scan.more_on_line()
}

/// The least number of corners that the faces of a file have, if all of its header is there.
pub(super) fn corners(head: &[u8]) -> Option<u64> {
    if !is_ply(head) {
        return None;
    }
    let header = Header::read(head).ok()?;
    let faces = header.tables.iter().find(|table| table.name == "face")?;
    Some(3 * faces.rows)
}

/// Whether a file is a PLY in text, as far as its header says.
pub(super) fn is_text_ply(bytes: &[u8]) -> bool {
    Header::read(bytes).is_ok_and(|header| header.encoding == Encoding::Text)
}

impl Header {
    /// Reads the header.
    ///
    /// # Errors
    /// What is wrong with it, with the line.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, String> {
        let mut scan = Scan::new(bytes, None);
        if scan.word() != Some(b"ply") {
            return Err(not_a("a PLY", "its first line is not \"ply\""));
        }
        let mut encoding = None;
        let mut header = Self {
            encoding: Encoding::Text,
            tables: Vec::new(),
            texture_files: Vec::new(),
            infos: Vec::new(),
            stray: Places::default(),
            unknown_types: Places::default(),
            is_guessed: false,
            end: 0,
        };
        let mut line_number = 1;
        loop {
            let start = scan.at;
            scan.skip_blanks();
            line_number += scan.taken_since(start).iter().filter(|&&byte| byte == b'\n').count();
            let line = scan.line();
            if line.is_empty() {
                return Err("the header of the PLY doesn't end: there is no line \"end_header\"".to_owned());
            }
            let wrong = |what: &str| Err(format!("line {line_number} of the header: {what}"));
            let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            match words.next().unwrap_or_default() {
                b"format" => {
                    encoding = Some(match words.next() {
                        Some(b"ascii") => Encoding::Text,
                        Some(b"binary_little_endian") => Encoding::LittleEndian,
                        Some(b"binary_big_endian") => Encoding::BigEndian,
                        _ => {
                            return wrong(
                                "the format is none of ascii, binary_little_endian, binary_big_endian",
                            );
                        }
                    });
                }
                b"element" => {
                    let name = words.next().map(|name| String::from_utf8_lossy(name).into_owned());
                    let rows = words.next().and_then(|rows| std::str::from_utf8(rows).ok()?.parse().ok());
                    let (Some(name), Some(rows)) = (name, rows) else {
                        return wrong("an element is a name and a count");
                    };
                    header.tables.push(Table { name, rows, properties: Vec::new() });
                }
                b"property" => {
                    let Some(table) = header.tables.last_mut() else {
                        header.stray.add(line_number);
                        continue;
                    };
                    let Some((property, is_known)) = property(words) else {
                        return wrong("a property is a type and a name, or \"list\", two types and a name");
                    };
                    table.properties.push(property);
                    if !is_known {
                        header.unknown_types.add(line_number);
                    }
                }
                b"comment" => header.texture_files.extend(texture_file(line)),
                b"obj_info" => {
                    let text = line.strip_prefix(b"obj_info").unwrap_or_default().trim_ascii();
                    header.infos.push(String::from_utf8_lossy(text).into_owned());
                }
                b"end_header" => break,
                _ => header.stray.add(line_number),
            }
        }
        // What follows begins right after the line end, which is one or two bytes.
        header.end = match bytes.get(scan.at..) {
            Some([b'\r', b'\n', ..]) => scan.at + 2,
            Some([_, ..]) => scan.at + 1,
            _ => scan.at,
        };
        header.is_guessed = encoding.is_none();
        if encoding.is_none() && !is_text(bytes.get(header.end..).unwrap_or_default()) {
            return Err(
                "the header of the PLY doesn't say its format, and what follows is not text".to_owned()
            );
        }
        header.encoding = encoding.unwrap_or(Encoding::Text);
        if header.encoding != Encoding::Text && !header.unknown_types.is_empty() {
            let what = "of a type that is none of the format's, so that what follows can't be read";
            return Err(header.unknown_types.sentence("property is", "properties are", what, "line"));
        }
        Ok(header)
    }
}

/// The property of a line, after its first word, and whether its types are known. Some programs leave the
/// name out.
fn property<'a>(mut words: impl Iterator<Item = &'a [u8]>) -> Option<(Property, bool)> {
    let mut word = words.next()?;
    let mut is_known = true;
    let mut scalar = |word: &[u8]| {
        Scalar::parse(word).unwrap_or_else(|| {
            is_known = false;
            Scalar::F64
        })
    };
    let mut count = None;
    if word == b"list" {
        count = Some(scalar(words.next()?));
        word = words.next()?;
    }
    let scalar = scalar(word);
    let name = String::from_utf8_lossy(words.next().unwrap_or_default()).into_owned();
    Some((Property { name, scalar, count }, is_known))
}

/// The image that a comment names.
fn texture_file(line: &[u8]) -> Option<String> {
    let line = String::from_utf8_lossy(line);
    let (keyword, name) = line.strip_prefix("comment")?.trim_start().split_once(char::is_whitespace)?;
    let name = name.trim();
    (keyword.eq_ignore_ascii_case("TextureFile") && !name.is_empty()).then(|| name.to_owned())
}
