//! Primitives: attributes and indices from accessors or compressed data.

use super::accessor;
use super::buffers::Buffers;
use super::draco::{self, DracoMesh};
use super::json::{ACCESSORS, Document, Object};
use super::rows::Rows;
use crate::notes::{Fault, Notes};

/// The topology of a primitive.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Mode {
    Points,
    Lines,
    Triangles,
    Strip,
    Fan,
}

impl Mode {
    fn of(code: usize) -> Option<Self> {
        Some(match code {
            0 => Self::Points,
            1..=3 => Self::Lines,
            4 => Self::Triangles,
            5 => Self::Strip,
            6 => Self::Fan,
            _ => return None,
        })
    }

    /// For each triangle the positions of its corners in a list of `count` indices.
    pub(super) fn triangles(self, count: usize) -> Box<dyn Iterator<Item = [usize; 3]>> {
        let faces = count.saturating_sub(2);
        match self {
            Self::Points | Self::Lines => Box::new(std::iter::empty()),
            Self::Triangles => Box::new((0..count / 3).map(|i| [i * 3, i * 3 + 1, i * 3 + 2])),
            Self::Strip => {
                Box::new((0..faces).map(|i| if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] }))
            }
            Self::Fan => Box::new((0..faces).map(|i| [i + 1, i + 2, 0])),
        }
    }
}

/// A primitive of a mesh.
pub(super) struct Primitive<'b, 'a> {
    pub object: Object<'a>,
    pub mode: Mode,
    document: &'a Document,
    buffers: &'b Buffers<'a>,
    /// The decoded mesh, with the extension's ids of its attributes.
    draco: Option<(&'b DracoMesh, Object<'a>)>,
}

impl<'b, 'a> Primitive<'b, 'a> {
    /// `label` names the primitive in notes.
    ///
    /// # Errors
    /// When nothing of it can be read.
    pub(super) fn open(
        document: &'a Document,
        buffers: &'b Buffers<'a>,
        object: Object<'a>,
        label: &str,
        notes: &mut Notes,
    ) -> Result<Self, String> {
        let code = object.index_or("mode", 4)?;
        let mode = Mode::of(code).ok_or_else(|| format!("its mode {code} is unknown"))?;
        let mut this = Self { object, mode, document, buffers, draco: None };
        let Some(extension) = object.extension(draco::EXTENSION) else { return Ok(this) };
        let decoded = extension.required_index("bufferView").and_then(|view| buffers.draco_mesh(view));
        match (decoded, extension.object("attributes")) {
            (Ok(mesh), Some(attributes)) => {
                this.draco = Some((mesh, attributes));
                this.mode = Mode::Triangles;
            }
            (Err(why), _) if this.has_uncompressed_copy() => {
                notes.fault(Fault::Attribute, format!("{label}: an uncompressed copy was read ({why})"));
            }
            (Err(why), _) => return Err(why),
            (Ok(_), None) => return Err("it doesn't say which attributes its Draco data has".to_owned()),
        }
        Ok(this)
    }

    /// Whether a compressed primitive has uncompressed positions too.
    fn has_uncompressed_copy(&self) -> bool {
        let accessor = self.accessor("POSITION").ok().flatten();
        let accessor = accessor.and_then(|index| self.document.item(ACCESSORS, index).ok());
        accessor.is_some_and(|accessor| accessor.get("bufferView").is_some())
    }

    /// The index of an attribute's accessor.
    pub(super) fn accessor(&self, name: &str) -> Result<Option<usize>, String> {
        self.object.object("attributes").map_or(Ok(None), |attributes| attributes.index(name))
    }

    /// The names of its attributes.
    pub(super) fn attributes(&self) -> impl Iterator<Item = &'a str> {
        self.object.object("attributes").into_iter().flat_map(Object::fields).map(|(name, _)| name)
    }

    /// The rows of an attribute; `None` if the primitive doesn't have it.
    ///
    /// # Errors
    /// When it can't be read.
    pub(super) fn attribute(&self, name: &str) -> Result<Option<Rows<'b>>, String> {
        let accessor = self.accessor(name)?;
        if let Some((mesh, attributes)) = self.draco
            && let Some(number) = attributes.index(name)?
        {
            let accessor = accessor.and_then(|index| self.document.item(ACCESSORS, index).ok());
            let is_normalized = accessor.and_then(|accessor| accessor.flag("normalized")).unwrap_or(false);
            return mesh.attribute(number, is_normalized).map(Some);
        }
        accessor.map(|index| self.rows(index)).transpose()
    }

    /// The indices; `None` for a primitive that uses its vertices in order.
    ///
    /// # Errors
    /// When they can't be read.
    pub(super) fn indices(&self) -> Result<Option<Rows<'b>>, String> {
        match self.draco {
            Some((mesh, _)) => Ok(Some(mesh.indices())),
            None => self.object.index("indices")?.map(|index| self.rows(index)).transpose(),
        }
    }

    /// The rows of an accessor.
    pub(super) fn rows(&self, index: usize) -> Result<Rows<'b>, String> {
        accessor::rows(self.document, self.buffers, index)
    }
}
