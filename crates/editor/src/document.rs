//! What is being edited: named objects, each with a mesh.

use crate::bezier::Bezier;
use crate::selection::Selection;
use formats::{Materials, Model, NamedMesh};
use glam::DVec3;
use halfedge::Mesh;
use halfedge::geometry::BitSet;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;

/// An object's identity: it stays the same while the object's place in the list changes, and is
/// never given twice in a session.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct ObjectId(pub u64);

impl fmt::Display for ObjectId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "object #{}", self.0)
    }
}

/// A named mesh of a document, or a Bezier curve or surface with the mesh that shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    id: ObjectId,
    /// Whether the viewport draws it.
    pub(crate) visible: bool,
    /// Its mesh and name. Only jobs that read the mesh share it, so that edits don't copy it.
    pub(crate) named: NamedMesh,
    /// The faces that are hidden, which all exist.
    pub(crate) hidden: Arc<BitSet>,
    pub(crate) named_selections: Arc<Vec<NamedSelection>>,
}

/// A selection that is kept under a name. It loses the elements that edits remove.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSelection {
    /// The name, which no other one of the object has.
    pub name: String,
    /// The elements.
    pub selection: Selection,
}

impl Object {
    pub(crate) fn new(id: ObjectId, named: NamedMesh) -> Self {
        Self { id, visible: true, named, hidden: Arc::default(), named_selections: Arc::default() }
    }

    pub(crate) fn with_id(self, id: ObjectId) -> Self {
        Self { id, ..self }
    }

    /// The object without the faces of the file that it was read from.
    pub(crate) fn without_soup(mut self) -> Self {
        self.named.soup = None;
        self
    }

    /// The object's identity.
    pub fn id(&self) -> ObjectId {
        self.id
    }

    /// The name lists show.
    pub fn name(&self) -> &str {
        &self.named.name
    }

    /// Whether the viewport draws it.
    pub fn visible(&self) -> bool {
        self.visible
    }

    /// The object's mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.named.mesh
    }

    /// The faces that are hidden. Edges and vertices are hidden if all their faces are, see
    /// [`surface::selecting::is_hidden`].
    pub fn hidden(&self) -> &Arc<BitSet> {
        &self.hidden
    }

    /// The selections that are kept under names, in the order in which they were named.
    pub fn named_selections(&self) -> &[NamedSelection] {
        &self.named_selections
    }

    /// The control points that the mesh is made from, where it is a Bezier curve or surface.
    pub fn bezier(&self) -> Option<&Bezier> {
        self.named.bezier.as_deref()
    }

    /// Whether something was changed when the object was read, so that `repair-import` can do it
    /// another way.
    pub fn is_repairable(&self) -> bool {
        self.named.soup.is_some()
    }
}

/// A document: one or more objects, one of them active. Lists, selection and commands are about
/// the active one. Only a document whose file held nothing has no object.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    pub(crate) name: String,
    pub(crate) objects: Vec<Object>,
    pub(crate) active: usize,
    pub(crate) offset: DVec3,
    pub(crate) materials: Materials,
    pub(crate) origin: Origin,
}

/// What tells a document from those before it: it changes when another one is opened or begun, and undo brings the old one
/// back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Origin {
    /// The revision that the document was opened or begun in.
    pub revision: u64,
    /// Whether it was read from a file.
    pub is_file: bool,
}

impl Document {
    /// A document without objects, before it has a name.
    pub(crate) fn untitled() -> Self {
        Self { name: "Untitled".into(), ..Self::default() }
    }

    /// The document's name, without a file extension.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What is added to every position when the document is saved: positions of models far from the
    /// origin are kept relative to a point near them, so that 32 bits are enough. Zero for others.
    pub fn offset(&self) -> DVec3 {
        self.offset
    }

    /// The materials that faces have or had, with their images: formats that hold them write them.
    pub fn materials(&self) -> &Materials {
        &self.materials
    }

    /// Where the document comes from.
    pub fn origin(&self) -> Origin {
        self.origin
    }

    /// The document as files of this name hold it. Shares the meshes.
    pub fn to_model(&self, name: &str) -> Model {
        Model {
            name: name.to_owned(),
            objects: self.objects.iter().map(|object| object.named.clone()).collect(),
            offset: self.offset,
            materials: self.materials.clone(),
        }
    }

    /// The objects in the order lists show them.
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }

    /// The place of the active object in [`Document::objects`].
    pub fn active_index(&self) -> usize {
        self.active
    }

    /// The active object; none in a document with no object.
    pub fn active(&self) -> Option<&Object> {
        self.objects.get(self.active)
    }

    /// The object with this identity.
    pub fn object(&self, id: ObjectId) -> Option<&Object> {
        self.objects.iter().find(|object| object.id == id)
    }

    /// The place of the object with this identity.
    pub fn index_of(&self, id: ObjectId) -> Option<usize> {
        self.objects.iter().position(|object| object.id == id)
    }
}

/// The numbers of a mesh, or of several meshes together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Vertices.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Half-edges: both sides of every edge, boundary ones included.
    pub halfedges: usize,
    /// Faces.
    pub faces: usize,
    /// Closed loops of boundary half-edges.
    pub boundary_loops: usize,
    /// Connected pieces; a vertex in no face is one.
    pub components: usize,
    /// Vertices - edges + faces.
    pub euler: i64,
}

impl Counts {
    /// Counts a mesh. Costs O(mesh): one pass over its half-edges, in the order they are stored.
    pub fn of(mesh: &Mesh) -> Self {
        let topology = mesh.topology();
        Self { boundary_loops: topology.boundary_loops, components: topology.components, ..Self::quick(mesh) }
    }

    /// What a mesh knows without being walked over: all but the loops and the components, which
    /// are 0 here.
    pub fn quick(mesh: &Mesh) -> Self {
        Self {
            vertices: mesh.vertex_count(),
            edges: mesh.edge_count(),
            halfedges: mesh.halfedge_count(),
            faces: mesh.face_count(),
            boundary_loops: 0,
            components: 0,
            euler: mesh.euler_characteristic(),
        }
    }
}

impl std::ops::Add for Counts {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            vertices: self.vertices + other.vertices,
            edges: self.edges + other.edges,
            halfedges: self.halfedges + other.halfedges,
            faces: self.faces + other.faces,
            boundary_loops: self.boundary_loops + other.boundary_loops,
            components: self.components + other.components,
            euler: self.euler + other.euler,
        }
    }
}

impl std::iter::Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::default(), |a, b| a + b)
    }
}
