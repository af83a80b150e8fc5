//! The head of a PLY: which elements with which properties come, and how they are written.

use crate::error::not_a;
use crate::text::scan::Scan;

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
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
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub(crate) fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }

    /// What a channel of a colour is divided by to run from 0 to 1.
    pub(crate) fn full(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32_767.0,
            Self::U16 => 65_535.0,
            Self::I32 => 2_147_483_647.0,
            Self::U32 => 4_294_967_295.0,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

/// How the numbers after the head are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// A property of every row of an element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Property {
    pub name: String,
    pub scalar: Scalar,
    /// For a list: how its length is stored.
    pub count: Option<Scalar>,
}

/// A table: so many rows with these properties.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Table {
    pub name: String,
    pub rows: u64,
    pub properties: Vec<Property>,
}

/// What the head says, and where what it describes begins.
#[derive(Debug)]
pub(crate) struct Header {
    pub encoding: Encoding,
    pub tables: Vec<Table>,
    pub end: usize,
}

impl Header {
    /// Reads the head.
    ///
    /// # Errors
    /// What is wrong with it, with the line.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, String> {
        let mut scan = Scan::new(bytes, None);
        let mut encoding = None;
        let mut tables: Vec<Table> = Vec::new();
        if scan.word() != Some(b"ply") {
            return Err(not_a("a PLY", "its first line is not \"ply\""));
        }
        loop {
            let Some(word) = scan.word() else {
                return Err("the head of the PLY doesn't end: there is no line \"end_header\"".to_owned());
            };
            let wrong =
                |scan: &Scan, what: &str| Err(format!("line {} of the head: {what}", scan.line_number()));
            match word {
                b"format" => {
                    encoding = match scan.word() {
                        Some(b"ascii") => Some(Encoding::Text),
                        Some(b"binary_little_endian") => Some(Encoding::LittleEndian),
                        Some(b"binary_big_endian") => Some(Encoding::BigEndian),
                        _ => {
                            return wrong(
                                &scan,
                                "the format is none of ascii, binary_little_endian, binary_big_endian",
                            );
                        }
                    };
                    scan.skip_line();
                }
                b"element" => {
                    let name = scan.word().map(|name| String::from_utf8_lossy(name).into_owned());
                    let rows = scan.integer().and_then(|rows| u64::try_from(rows).ok());
                    let (Some(name), Some(rows)) = (name, rows) else {
                        return wrong(&scan, "an element is a name and a count");
                    };
                    tables.push(Table { name, rows, properties: Vec::new() });
                }
                b"property" => {
                    let Some(property) = Self::property(&mut scan) else {
                        return wrong(
                            &scan,
                            "a property is a type and a name, or \"list\", two types and a name",
                        );
                    };
                    let Some(table) = tables.last_mut() else {
                        return wrong(&scan, "a property comes before any element");
                    };
                    table.properties.push(property);
                }
                b"comment" | b"obj_info" => scan.skip_line(),
                b"end_header" => break,
                _ => return wrong(&scan, "it starts with a word that doesn't belong in a head"),
            }
        }
        let Some(encoding) = encoding else {
            return Err("the head of the PLY doesn't say its format".to_owned());
        };
        // What follows begins right after the line end, which is one or two bytes.
        let end = match bytes.get(scan.at..) {
            Some([b'\r', b'\n', ..]) => scan.at + 2,
            Some([_, ..]) => scan.at + 1,
            _ => scan.at,
        };
        Ok(Self { encoding, tables, end })
    }

    fn property(scan: &mut Scan) -> Option<Property> {
        let mut word = scan.word()?;
        let mut count = None;
        if word == b"list" {
            count = Some(Scalar::parse(scan.word()?)?);
            word = scan.word()?;
        }
        let scalar = Scalar::parse(word)?;
        Some(Property { name: String::from_utf8_lossy(scan.word()?).into_owned(), scalar, count })
    }
}
/// Whether the first line is that of a PLY.
pub(crate) fn is_ply(bytes: &[u8]) -> bool {
    let mut scan = Scan::new(bytes.get(..64 * 1024).unwrap_or(bytes), None);
    scan.word() == Some(b"ply") && !scan.more_on_line()
}
