//! Fields that name elements: an id, or for edges and half-edges a pair of vertices.

use crate::error::Problem;
use halfedge::edit::Refusal;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};
use serde::{Deserialize, Serialize};
use surface::MirrorImages;

/// A vertex, by its id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct VertexRef(pub u32);

/// A face, by its id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct FaceRef(pub u32);

/// An edge, by its id or by the vertices at its ends, in either order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(untagged)]
pub enum EdgeRef {
    /// The edge's id.
    Id(u32),
    /// The ids of the vertices at its ends.
    Ends([u32; 2]),
}

/// A half-edge, by its id or by the vertices it leaves and points to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(untagged)]
pub enum HalfedgeRef {
    /// The half-edge's id.
    Id(u32),
    /// The ids of the vertices it leaves and points to.
    FromTo([u32; 2]),
}

/// What names an element in a command.
pub(crate) trait ElementRef: Copy {
    /// The element's id in the mesh.
    type Id;

    /// The element of the mesh, or a refusal that names the field.
    fn find(self, mesh: &Mesh, field: &str) -> Result<Self::Id, Problem>;
}

fn none_such(element: Element, id: u32, mesh: &Mesh, field: &str) -> Problem {
    let range = match mesh.capacity(element) {
        0 => "the mesh has none".to_owned(),
        n if mesh.count(element) == n => format!("ids go from 0 to {}", n - 1),
        _ => "it may have been removed".to_owned(),
    };
    Problem::field(field, format!("there is no {element} {id}; {range}"))
}

impl ElementRef for VertexRef {
    type Id = VertexId;

    fn find(self, mesh: &Mesh, field: &str) -> Result<VertexId, Problem> {
        mesh.vertex(self.0).ok_or_else(|| none_such(Element::Vertex, self.0, mesh, field))
    }
}

impl ElementRef for FaceRef {
    type Id = FaceId;

    fn find(self, mesh: &Mesh, field: &str) -> Result<FaceId, Problem> {
        mesh.face(self.0).ok_or_else(|| none_such(Element::Face, self.0, mesh, field))
    }
}

impl ElementRef for EdgeRef {
    type Id = EdgeId;

    fn find(self, mesh: &Mesh, field: &str) -> Result<EdgeId, Problem> {
        match self {
            Self::Id(id) => mesh.edge(id).ok_or_else(|| none_such(Element::Edge, id, mesh, field)),
            Self::Ends(ends) => Ok(between(ends, mesh, field)?.edge()),
        }
    }
}

impl ElementRef for HalfedgeRef {
    type Id = HalfedgeId;

    fn find(self, mesh: &Mesh, field: &str) -> Result<HalfedgeId, Problem> {
        match self {
            Self::Id(id) => mesh.halfedge(id).ok_or_else(|| none_such(Element::Halfedge, id, mesh, field)),
            Self::FromTo(ends) => between(ends, mesh, field),
        }
    }
}

/// An element of any kind, as a field names it.
#[derive(Clone, Copy, Debug)]
pub(crate) enum AnyRef {
    Vertex(VertexRef),
    Edge(EdgeRef),
    Halfedge(HalfedgeRef),
    Face(FaceRef),
}

impl AnyRef {
    /// The id of the element; none if there is no such element.
    pub fn id(self, mesh: &Mesh) -> Option<u32> {
        match self {
            Self::Vertex(v) => v.find(mesh, "").ok().map(VertexId::raw),
            Self::Edge(e) => e.find(mesh, "").ok().map(EdgeId::raw),
            Self::Halfedge(h) => h.find(mesh, "").ok().map(HalfedgeId::raw),
            Self::Face(f) => f.find(mesh, "").ok().map(FaceId::raw),
        }
    }

    /// The vertices of the element.
    pub fn vertices(self, mesh: &Mesh) -> Vec<VertexId> {
        let of_edge = |e: EdgeId| mesh.ends(e).to_vec();
        match self {
            Self::Vertex(v) => v.find(mesh, "").into_iter().collect(),
            Self::Edge(e) => e.find(mesh, "").map(of_edge).unwrap_or_default(),
            Self::Halfedge(h) => h.find(mesh, "").map(|h| of_edge(h.edge())).unwrap_or_default(),
            Self::Face(f) => f.find(mesh, "").map(|f| mesh.face_vertices(f).collect()).unwrap_or_default(),
        }
    }

    /// The id of the element's mirror image; of an edge also whether the image's even half-edge runs the other way than the
    /// edge as it is named.
    pub fn image(self, mesh: &Mesh, images: &MirrorImages) -> Option<(u32, Option<bool>)> {
        match self {
            Self::Vertex(v) => Some((images.vertex(v.find(mesh, "").ok()?)?.raw(), None)),
            Self::Face(f) => Some((images.face(mesh, f.find(mesh, "").ok()?)?.raw(), None)),
            Self::Halfedge(h) => Some((images.halfedge(mesh, h.find(mesh, "").ok()?)?.raw(), None)),
            Self::Edge(e) => {
                let edge = e.find(mesh, "").ok()?;
                let first = match e {
                    EdgeRef::Ends([first, _]) => mesh.vertex(first)?,
                    EdgeRef::Id(_) => mesh.from(edge.halfedge()),
                };
                let image = images.edge(mesh, edge)?;
                let reversed = mesh.from(image.halfedge()) != images.vertex(first)?;
                Some((image.raw(), Some(reversed)))
            }
        }
    }
}

impl EdgeRef {
    /// The edge, and a place along it given from the first of its two vertices: the one named first,
    /// or the one that the edge's first half-edge leaves.
    pub(crate) fn find_along(self, t: f32, mesh: &Mesh, field: &str) -> Result<(EdgeId, f32), Problem> {
        let edge = self.find(mesh, field)?;
        let reversed = matches!(self, Self::Ends([first, _]) if mesh.from(edge.halfedge()).raw() != first);
        Ok((edge, if reversed { 1.0 - t } else { t }))
    }
}

fn between([from, to]: [u32; 2], mesh: &Mesh, field: &str) -> Result<HalfedgeId, Problem> {
    let a = VertexRef(from).find(mesh, field)?;
    let b = VertexRef(to).find(mesh, field)?;
    mesh.find_halfedge(a, b)
        .ok_or_else(|| Problem::field(field, format!("no edge joins vertex {from} and vertex {to}")))
}

/// A field that resolving fills in.
pub(crate) fn given<R>(value: Option<R>, field: &str) -> Result<R, Problem> {
    value.ok_or_else(|| Problem::of_field(field, "is missing"))
}

/// The element of a field that resolving fills in.
pub(crate) fn one<R: ElementRef>(value: Option<R>, field: &str, mesh: &Mesh) -> Result<R::Id, Problem> {
    given(value, field)?.find(mesh, field)
}

/// The two elements of a field that resolving fills in.
pub(crate) fn two<R: ElementRef>(
    value: Option<[R; 2]>,
    field: &str,
    mesh: &Mesh,
) -> Result<[R::Id; 2], Problem> {
    let [a, b] = given(value, field)?;
    Ok([find_at(a, 0, field, mesh)?, find_at(b, 1, field, mesh)?])
}

/// The elements of a list; none for one that is left out.
pub(crate) fn all<R: ElementRef>(
    list: &Option<Vec<R>>,
    field: &str,
    mesh: &Mesh,
) -> Result<Vec<R::Id>, Problem> {
    let list = list.as_deref().unwrap_or_default();
    list.iter().enumerate().map(|(at, &item)| find_at(item, at, field, mesh)).collect()
}

/// The faces of a `faces` field that stands for all when left out.
pub(crate) fn faces_or_every(list: &Option<Vec<FaceRef>>, mesh: &Mesh) -> Result<Vec<FaceId>, Problem> {
    match list.as_deref() {
        Some([]) => Err(Refusal::NothingGiven(Element::Face).into()),
        Some(_) => all(list, "faces", mesh),
        None => Ok(mesh.faces().collect()),
    }
}

/// An element of a list; the field in messages has the place in the list.
fn find_at<R: ElementRef>(item: R, at: usize, field: &str, mesh: &Mesh) -> Result<R::Id, Problem> {
    item.find(mesh, field).map_err(|problem| Problem { field: Some(format!("{field}[{at}]")), ..problem })
}

/// The number of elements in a list; `otherwise` where it is left out.
pub(crate) fn count<R>(list: &Option<Vec<R>>, otherwise: usize) -> usize {
    list.as_ref().map_or(otherwise, Vec::len)
}

/// The number of corners of the faces in a list, or of all faces where it is left out: an upper bound
/// of the edges and faces that edits of faces make. Costs O(corners of the list).
pub(crate) fn corner_count(list: &Option<Vec<FaceRef>>, mesh: &Mesh) -> usize {
    let Some(list) = list else { return super::facts::corners_at_most(mesh) };
    list.iter().filter_map(|face| mesh.face(face.0)).map(|f| mesh.face_degree(f)).sum()
}

macro_rules! id_conversions {
    ($($from:ty => $to:ident $(:: $variant:ident)?),* $(,)?) => {
        $(impl From<$from> for $to {
            fn from(id: $from) -> Self {
                Self $(:: $variant)? (id.raw())
            }
        })*
    };
}
id_conversions!(VertexId => VertexRef, FaceId => FaceRef, EdgeId => EdgeRef::Id, HalfedgeId => HalfedgeRef::Id);
