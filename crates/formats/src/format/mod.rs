//! The description of a file format: everything that the rest of the program knows of it.

pub(crate) mod loss;
pub(crate) mod reading;

use crate::error::{ReadError, WriteError};
use crate::file::NamedBytes;
use crate::format::loss::Part;
use crate::format::reading::{Contents, Reading, Source};
use crate::model::Model;
use crate::model::material::Property;
use crate::model::texture::Texture;
use halfedge::Progress;

/// A file format. A format that is written in two ways has two descriptions, one of which reads both.
///
/// What reads and writes its files is its [`Codec`], apart from this: the page only describes formats, and its program
/// must not hold their readers and writers.
pub(crate) struct FormatInfo {
    /// What scripts, settings and jobs call the format: it never changes.
    pub code: &'static str,
    /// What users call it.
    pub name: &'static str,
    /// The menu entry that saves in it.
    pub save_label: &'static str,
    /// What it is good for, in one sentence.
    pub description: &'static str,
    /// The extensions of its files, in lower case without a dot, the usual one first.
    pub extensions: &'static [&'static str],
    /// What its files hold.
    pub holds: Holds,
    /// How its files are told by their content; `None` where only their name tells.
    pub detect: Option<Detection>,
    /// Whether a file is text, which its reader is given in UTF-8 whatever encoding it has.
    pub is_text: fn(&[u8]) -> bool,
    /// How many corners of faces a file of so many bytes has at least, if its beginning tells.
    pub corners: fn(&[u8], u64) -> Option<u64>,
    /// Whether its [`Codec`] reads files.
    pub is_read: bool,
    /// Whether its [`Codec`] writes models.
    pub is_written: bool,
    /// The extensions of companion files that are not models, each with what to say of such a file
    /// without its model.
    pub companion_extensions: &'static [(&'static str, &'static str)],
    /// The names of the companion files that a file of the format, or one of its companions, refers to.
    pub companions: fn(&NamedBytes) -> Vec<String>,
    /// Makes one file that opens by itself of those written; `None` where there are none.
    pub single_file: fn(Vec<NamedBytes>) -> Option<NamedBytes>,
    /// Whether it has a place for the name of an object that is alone in its file. In other formats the file's name
    /// stands for it.
    pub keeps_name: bool,
    /// The parts of a document that it has no place for.
    pub lacks: &'static [Part],
    /// Whether it has a place for a property of a material.
    pub keeps_property: fn(Property) -> bool,
    /// Whether it has a place for how a texture lies on the surface: its set of texture coordinates, what
    /// lies beyond its edges, its scale and its transform. Only asked where it keeps the texture.
    pub keeps_placement: fn(&Texture) -> bool,
    /// What else is lost of a model without curves, one sentence each.
    pub losses: fn(&Model) -> Vec<String>,
}

/// How sure a format is of content that the function says is its own.
pub(crate) type Detection = (Certainty, fn(&[u8]) -> bool);

/// Reads one file of a format.
pub(crate) type Reader = fn(&Source, &mut Reading, &mut Progress) -> Result<Contents, ReadError>;

/// Writes a model without curves, or one with, where the format [holds](Holds) control points.
pub(crate) type Writer = fn(&Model) -> Result<Vec<NamedBytes>, WriteError>;

/// What reads and writes the files of a format.
#[derive(Clone, Copy)]
pub(crate) struct Codec {
    /// Reads a file; `None` for a format, or a way of writing one, that isn't read as such.
    pub read: Option<Reader>,
    /// Writes a model: the model file first, then its companion files. `None` if it can't be written.
    pub write: Option<Writer>,
}

impl Codec {
    /// That of a format which others read and write.
    pub(crate) const NONE: Self = Self { read: None, write: None };
}

impl FormatInfo {
    /// What most formats have in common; the rest is to be filled in.
    pub(crate) const DEFAULT: Self = Self {
        code: "",
        name: "",
        save_label: "",
        description: "",
        extensions: &[],
        holds: Holds::Meshes,
        detect: None,
        is_text: |_| false,
        corners: |_, _| None,
        is_read: false,
        is_written: false,
        companion_extensions: &[],
        companions: |_| Vec::new(),
        single_file: |files| files.into_iter().next(),
        keeps_name: false,
        lacks: &[],
        keeps_property: |property| property == Property::BaseColor,
        keeps_placement: |_| true,
        losses: |_| Vec::new(),
    };
}

/// What files of a format hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Holds {
    Meshes,
    /// The control points of Bezier curves.
    Curves,
    /// The control points of Bezier surfaces.
    Surfaces,
    /// Whole documents, which the editor reads and writes.
    Documents,
}

impl Holds {
    /// What messages call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Meshes => "meshes",
            Self::Curves => "Bezier curves",
            Self::Surfaces => "Bezier surfaces",
            Self::Documents => "documents",
        }
    }
}

/// How sure a format is that content is its own. Of two formats that recognise a file, the surer one
/// counts, then the one that comes first in the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Certainty {
    /// The file starts with words or bytes that only the format has.
    Signature,
    /// Sizes or words agree with each other.
    Layout,
    /// A line reads like one of the format.
    Statement,
    /// Nothing but as many numbers as there should be.
    Numbers,
}

impl Certainty {
    /// All of them, the surest first.
    pub(crate) const ALL: [Self; 4] = [Self::Signature, Self::Layout, Self::Statement, Self::Numbers];
}
