//! The description of an operation: what menus, panels, the palette and documentation show.

/// An operation's name, texts and fields.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// The name in JSON.
    pub name: &'static str,
    /// What menus and the history call it, in sentence case.
    pub label: &'static str,
    /// One sentence on what it does.
    pub description: &'static str,
    /// The key that does it with default fields, as in `Ctrl+Z`.
    pub key: Option<&'static str>,
    /// What it works on.
    pub kind: OperationKind,
    /// Its fields, without `op` and `object`.
    pub fields: &'static [Field],
}

/// What an operation works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OperationKind {
    /// A few elements of a mesh: quick, keeps ids, can be dragged.
    Local,
    /// Whole meshes: may run as a job, gives elements new ids.
    WholeMesh,
    /// The control points of a Bezier object: quick, can be dragged.
    Bezier,
    /// The document: which objects there are, and what they are called.
    Document,
}

/// One field of an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The name in JSON.
    pub name: &'static str,
    /// What it takes.
    pub kind: FieldKind,
    /// What it is when left out, as JSON where it is a value (`0.5`, `"triangles"`) and in words
    /// otherwise (`the selection`); none for a field that must be given.
    pub default: Option<&'static str>,
    /// What it means, in a few words.
    pub description: &'static str,
}

/// What a field takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldKind {
    /// A vertex id.
    Vertex,
    /// An edge id or the pair of its ends.
    Edge,
    /// A half-edge id or the pair of where it leaves and where it points.
    Halfedge,
    /// A face id.
    Face,
    /// A list of vertex ids.
    Vertices,
    /// A list of edges.
    Edges,
    /// A list of half-edges.
    Halfedges,
    /// A list of face ids.
    Faces,
    /// A number from `min` to `max`.
    Number {
        /// The least it may be.
        min: f32,
        /// The most it may be.
        max: f32,
    },
    /// A whole number from `min` to `max`.
    Integer {
        /// The least it may be.
        min: u32,
        /// The most it may be.
        max: u32,
    },
    /// Three numbers: a position, an offset or a direction.
    Vector,
    /// Two positions.
    VectorPair,
    /// Three factors, or one for all three axes.
    Factors,
    /// An axis and degrees: `{"axis": [0, 0, 1], "degrees": 90}`.
    Rotation,
    /// A colour as `#rrggbb`.
    Color,
    /// One of these words.
    Choice(&'static [&'static str]),
    /// True or false.
    Flag,
    /// Text.
    Text,
    /// A list of places in the document's list of objects.
    Objects,
}

impl Spec {
    /// The field of this name.
    pub fn field(&self, name: &str) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.name == name)
    }
}

impl Field {
    pub(crate) const fn new(name: &'static str, kind: FieldKind, description: &'static str) -> Self {
        Self { name, kind, default: None, description }
    }

    pub(crate) const fn or(self, default: &'static str) -> Self {
        Self { default: Some(default), ..self }
    }
}
