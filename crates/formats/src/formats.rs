//! The tables of formats. A format is a folder beside this file and a line in each: detection, dispatch,
//! losses, companion files, names and the menus of the program come from them.

use crate::file::NamedBytes;
use crate::format::{Certainty, Codec, FormatInfo, Holds};
use crate::text::encoding::decode_utf16;
use crate::{bezier, collada, gltf, json, obj, off, ply, project, stl};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;
use std::hash::{Hash, Hasher};

/// The formats, in the order of menus. Of two that are equally sure of a file's content, the first one
/// reads it.
static FORMATS: &[&FormatInfo] = &[
    &project::FORMAT,
    &obj::FORMAT,
    &ply::BINARY,
    &ply::TEXT,
    &stl::BINARY,
    &stl::TEXT,
    &off::FORMAT,
    &collada::FORMAT,
    &gltf::BINARY,
    &gltf::TEXT,
    &bezier::CURVES,
    &bezier::SURFACES,
    &json::FORMAT,
];

/// What reads and writes them, in a table of its own: only programs that read or write files hold it.
static CODECS: &[(&FormatInfo, Codec)] = &[
    (&project::FORMAT, Codec::NONE),
    (&obj::FORMAT, obj::CODEC),
    (&ply::BINARY, ply::BINARY_CODEC),
    (&ply::TEXT, ply::TEXT_CODEC),
    (&stl::BINARY, stl::BINARY_CODEC),
    (&stl::TEXT, stl::TEXT_CODEC),
    (&off::FORMAT, off::CODEC),
    (&collada::FORMAT, collada::CODEC),
    (&gltf::BINARY, gltf::BINARY_CODEC),
    (&gltf::TEXT, gltf::TEXT_CODEC),
    (&bezier::CURVES, bezier::CURVES_CODEC),
    (&bezier::SURFACES, bezier::SURFACES_CODEC),
    (&json::FORMAT, json::CODEC),
];

/// A file format. Where a format is written in two ways, these are two formats, and files of both are
/// read as the first.
#[derive(Clone, Copy)]
pub struct Format(&'static FormatInfo);

impl Default for Format {
    /// OBJ, which every program for meshes reads.
    fn default() -> Self {
        Self(&obj::FORMAT)
    }
}

impl Format {
    /// All formats, in the order in which menus show them.
    pub fn all() -> impl Iterator<Item = Self> {
        FORMATS.iter().map(|info| Self(info))
    }

    /// The format of this code, or else the one with this extension, in upper or lower case.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::all()
            .find(|format| format.code().eq_ignore_ascii_case(code))
            .or_else(|| Self::from_extension(code))
    }

    /// The format that files of this extension have, in upper or lower case.
    pub fn from_extension(extension: &str) -> Option<Self> {
        let extension = extension.to_ascii_lowercase();
        Self::all().find(|format| format.extensions().contains(&extension.as_str()))
    }

    /// The format of a file by its name alone.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::from_extension(name.rsplit_once('.')?.1)
    }

    /// The format of content that is plainly of one. Looks at the start, but passes over a whole file of
    /// numbers.
    fn of_content(bytes: &[u8]) -> Option<Self> {
        Certainty::ALL.into_iter().find_map(|certainty| {
            Self::all()
                .find(|format| format.0.detect.is_some_and(|(own, is_own)| own == certainty && is_own(bytes)))
        })
    }

    /// How many corners of faces a file of so many bytes has at least, if its beginning tells.
    pub(crate) fn corners_told_by(head: &[u8], bytes: u64) -> Option<u64> {
        Self::all().find_map(|format| (format.0.corners)(head, bytes))
    }

    /// The format of a file: by content where that is plain, else by extension.
    pub fn detect(file: &NamedBytes) -> Option<Self> {
        Self::of_content(&file.bytes)
            .or_else(|| Self::of_content(decode_utf16(&file.bytes)?.as_bytes()))
            .or_else(|| Self::from_name(&file.name))
    }

    /// The format for a document of nothing but Bezier curves, or of nothing but surfaces.
    pub fn for_bezier(curves: bool) -> Option<Self> {
        let holds = if curves { Holds::Curves } else { Holds::Surfaces };
        Self::all().find(|format| format.0.holds == holds)
    }

    /// The format of whole documents.
    pub fn project() -> Self {
        Self(&project::FORMAT)
    }

    /// Whether it holds whole documents. The editor reads and writes them, this crate only knows their names.
    pub fn is_project(self) -> bool {
        self.0.holds == Holds::Documents
    }

    /// Whether the editor opens its files.
    pub fn can_open(self) -> bool {
        self.can_read() || self.is_project()
    }

    /// Whether the editor saves in it.
    pub fn can_save(self) -> bool {
        self.can_write() || self.is_project()
    }

    /// What scripts, settings and jobs call it: it never changes.
    pub fn code(self) -> &'static str {
        self.0.code
    }

    /// What users call it.
    pub fn name(self) -> &'static str {
        self.0.name
    }

    /// The menu entry that saves in it.
    pub fn save_label(self) -> &'static str {
        self.0.save_label
    }

    /// What it is good for, in one sentence.
    pub fn description(self) -> &'static str {
        self.0.description
    }

    /// The extensions of its files, in lower case without a dot, the usual one first.
    pub fn extensions(self) -> &'static [&'static str] {
        self.0.extensions
    }

    /// The usual extension, without a dot.
    pub fn extension(self) -> &'static str {
        self.extensions().first().copied().unwrap_or_default()
    }

    /// Whether [`crate::read`] gives it as a file's format.
    pub fn can_read(self) -> bool {
        self.0.is_read
    }

    /// Whether [`crate::write`] writes it.
    pub fn can_write(self) -> bool {
        self.0.is_written
    }

    /// Whether it holds control points of Bezier curves or surfaces and no meshes.
    pub fn is_bezier(self) -> bool {
        matches!(self.0.holds, Holds::Curves | Holds::Surfaces)
    }

    pub(crate) fn info(self) -> &'static FormatInfo {
        self.0
    }

    /// What reads and writes its files.
    pub(crate) fn codec(self) -> Codec {
        CODECS.iter().find(|(info, _)| info.code == self.0.code).map_or(Codec::NONE, |(_, codec)| *codec)
    }
}

impl PartialEq for Format {
    fn eq(&self, other: &Self) -> bool {
        self.code() == other.code()
    }
}

impl Eq for Format {}

impl Hash for Format {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.code().hash(state);
    }
}

impl fmt::Debug for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Format({})", self.code())
    }
}

impl Serialize for Format {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.code())
    }
}

impl<'de> Deserialize<'de> for Format {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let code = String::deserialize(deserializer)?;
        Self::from_code(&code).ok_or_else(|| de::Error::custom(format!("unknown format `{code}`")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn descriptions_are_complete_and_codes_differ() {
        let mut codes = HashSet::new();
        for format in Format::all() {
            assert!(codes.insert(format.code()), "{format:?}");
            let texts =
                [format.code(), format.name(), format.save_label(), format.description(), format.extension()];
            assert!(texts.iter().all(|text| !text.is_empty()), "{format:?}");
            assert!(format.can_open() || format.can_save(), "{format:?}");
        }
    }

    #[test]
    fn formats_have_the_codecs_that_they_promise() {
        let described: Vec<&str> = Format::all().map(Format::code).collect();
        assert_eq!(CODECS.iter().map(|(info, _)| info.code).collect::<Vec<_>>(), described);
        for format in Format::all() {
            let Codec { read, write } = format.codec();
            assert_eq!(
                (read.is_some(), write.is_some()),
                (format.can_read(), format.can_write()),
                "{format:?}"
            );
        }
    }

    #[test]
    fn codes_lead_to_their_format_and_never_change() {
        let codes: Vec<&str> = Format::all().map(Format::code).collect();
        let known = [
            "meshwright",
            "obj",
            "ply",
            "ply-text",
            "stl",
            "stl-text",
            "off",
            "dae",
            "glb",
            "gltf",
            "bzc",
            "bez",
            "json",
        ];
        assert_eq!(codes, known);
        for format in Format::all() {
            assert_eq!(Format::from_code(format.code()), Some(format));
            assert_eq!(Format::from_code(&format.code().to_uppercase()), Some(format));
            let json = serde_json::to_string(&format).expect("text");
            assert_eq!(json, format!("{:?}", format.code()));
            assert_eq!(serde_json::from_str::<Format>(&json).expect("its own"), format);
        }
        assert_eq!(Format::from_code("COFF"), Format::from_code("off"), "other extensions work too");
        assert_eq!(Format::from_code("doc"), None);
    }

    #[test]
    fn extensions_lead_to_what_can_be_read() {
        for format in Format::all() {
            let found = Format::from_extension(format.extension());
            assert_eq!(found.map(Format::extension), Some(format.extension()));
            let can_be_read =
                Format::all().any(|other| other.extension() == format.extension() && other.can_open());
            assert_eq!(found.is_some_and(Format::can_open), can_be_read, "{format:?}");
        }
    }

    #[test]
    fn control_points_have_formats_of_their_own() {
        assert_eq!(Format::for_bezier(true).map(Format::code), Some("bzc"));
        assert_eq!(Format::for_bezier(false).map(Format::code), Some("bez"));
    }
}
