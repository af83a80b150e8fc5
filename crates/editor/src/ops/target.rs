//! Resolving an operation: the selection fills in the elements that it leaves out.

use super::field::{Arity, Field, FieldKind, Fill, Selected};
use super::refs::AnyRef;
use super::{EdgeRef, FaceRef, HalfedgeRef, Kind, Operation, VertexRef};
use crate::document::Object;
use crate::error::Problem;
use crate::selection::Selection;
use halfedge::{EdgeId, Element, HalfedgeId, Mesh, VertexId};

/// The mesh and the selection that an operation is resolved against.
pub(crate) struct Target<'a> {
    pub mesh: &'a Mesh,
    /// The selection; an empty one where the operation is for an object that isn't active.
    pub selection: &'a Selection,
    /// The mesh's object, if there is one.
    pub object: Option<&'a Object>,
}

/// An element field of an operation, to be filled in.
pub(crate) enum Slot<'a> {
    Vertex(&'a mut Option<VertexRef>),
    Edge(&'a mut Option<EdgeRef>),
    Halfedge(&'a mut Option<HalfedgeRef>),
    Face(&'a mut Option<FaceRef>),
    Vertices(&'a mut Option<Vec<VertexRef>>),
    Edges(&'a mut Option<Vec<EdgeRef>>),
    Halfedges(&'a mut Option<Vec<HalfedgeRef>>),
    Faces(&'a mut Option<Vec<FaceRef>>),
    TwoVertices(&'a mut Option<[VertexRef; 2]>),
    TwoEdges(&'a mut Option<[EdgeRef; 2]>),
}

impl Slot<'_> {
    pub fn is_given(&self) -> bool {
        match self {
            Self::Vertex(slot) => slot.is_some(),
            Self::Edge(slot) => slot.is_some(),
            Self::Halfedge(slot) => slot.is_some(),
            Self::Face(slot) => slot.is_some(),
            Self::Vertices(slot) => slot.is_some(),
            Self::Edges(slot) => slot.is_some(),
            Self::Halfedges(slot) => slot.is_some(),
            Self::Faces(slot) => slot.is_some(),
            Self::TwoVertices(slot) => slot.is_some(),
            Self::TwoEdges(slot) => slot.is_some(),
        }
    }

    /// Whether it takes any number of elements.
    pub fn is_list(&self) -> bool {
        matches!(self, Self::Vertices(_) | Self::Edges(_) | Self::Halfedges(_) | Self::Faces(_))
    }

    /// The elements that are given.
    pub fn refs(&self) -> Vec<AnyRef> {
        fn all<R: Copy>(list: Option<&[R]>, any: fn(R) -> AnyRef) -> Vec<AnyRef> {
            list.unwrap_or_default().iter().copied().map(any).collect()
        }
        match self {
            Self::Vertex(slot) => all(slot.as_ref().map(std::slice::from_ref), AnyRef::Vertex),
            Self::Edge(slot) => all(slot.as_ref().map(std::slice::from_ref), AnyRef::Edge),
            Self::Halfedge(slot) => all(slot.as_ref().map(std::slice::from_ref), AnyRef::Halfedge),
            Self::Face(slot) => all(slot.as_ref().map(std::slice::from_ref), AnyRef::Face),
            Self::Vertices(slot) => all(slot.as_deref(), AnyRef::Vertex),
            Self::Edges(slot) => all(slot.as_deref(), AnyRef::Edge),
            Self::Halfedges(slot) => all(slot.as_deref(), AnyRef::Halfedge),
            Self::Faces(slot) => all(slot.as_deref(), AnyRef::Face),
            Self::TwoVertices(slot) => all(slot.as_ref().map(<[_; 2]>::as_slice), AnyRef::Vertex),
            Self::TwoEdges(slot) => all(slot.as_ref().map(<[_; 2]>::as_slice), AnyRef::Edge),
        }
    }

    /// Sets the slot to these ids; a slot for one element takes the first.
    pub fn fill(self, ids: &[u32]) {
        let two = || <[u32; 2]>::try_from(ids).ok();
        match self {
            Self::Vertex(slot) => *slot = ids.first().map(|&id| VertexRef(id)),
            Self::Edge(slot) => *slot = ids.first().map(|&id| EdgeRef::Id(id)),
            Self::Halfedge(slot) => *slot = ids.first().map(|&id| HalfedgeRef::Id(id)),
            Self::Face(slot) => *slot = ids.first().map(|&id| FaceRef(id)),
            Self::Vertices(slot) => *slot = Some(ids.iter().map(|&id| VertexRef(id)).collect()),
            Self::Edges(slot) => *slot = Some(ids.iter().map(|&id| EdgeRef::Id(id)).collect()),
            Self::Halfedges(slot) => *slot = Some(ids.iter().map(|&id| HalfedgeRef::Id(id)).collect()),
            Self::Faces(slot) => *slot = Some(ids.iter().map(|&id| FaceRef(id)).collect()),
            Self::TwoVertices(slot) => *slot = two().map(|ids| ids.map(VertexRef)),
            Self::TwoEdges(slot) => *slot = two().map(|ids| ids.map(EdgeRef::Id)),
        }
    }
}

/// The element fields of an operation that the selection can fill in, with their indices among its slots.
fn selectable<O: Operation>() -> impl Iterator<Item = (usize, &'static Field, Element, Selected)> {
    let elements =
        O::SPEC.fields.iter().filter(|field| matches!(field.kind, FieldKind::Elements { .. })).enumerate();
    elements.filter_map(|(at, field)| match (field.kind, field.fill) {
        (FieldKind::Elements { element, .. }, Fill::Selection(selected)) => {
            Some((at, field, element, selected))
        }
        _ => None,
    })
}

/// Whether an operation acts on the selection: it can, and names no elements itself.
pub(crate) fn is_open<O: Operation>(op: &O) -> bool {
    let mut op = op.clone();
    op.takes_selection() && selectable::<O>().next().is_some() && !op.elements().iter().any(Slot::is_given)
}

/// Checks that the selection can fill in the elements of an operation, without listing them. Costs O(1).
pub(crate) fn check_selection<O: Operation>(target: &Target<'_>) -> Result<(), Problem> {
    let Some((_, field, element, selected)) = chosen::<O>(target) else { return Ok(()) };
    let (kind, count) = (target.selection.kind(), target.selection.len());
    let fits = field.takes_selected(kind) && count > 0;
    match selected {
        Selected::AllOrEvery => Ok(()),
        _ if !fits => Err(nothing_selected(field, element, selected)),
        Selected::Only if count != 1 => Err(wrong_number(field, element, count, "one")),
        Selected::Two if count != 2 => Err(wrong_number(field, element, count, "two")),
        _ => Ok(()),
    }
}

/// The field that the selection fills in: the first one that takes the selected kind, or else the
/// first one.
fn chosen<O: Operation>(target: &Target<'_>) -> Option<(usize, &'static Field, Element, Selected)> {
    let kind = target.selection.kind();
    selectable::<O>().find(|(_, field, ..)| field.takes_selected(kind)).or_else(|| selectable::<O>().next())
}

/// Fills in the elements that an operation leaves out with the selected ones. An operation on one element
/// becomes one operation per selected element; together they are one undo step.
pub(crate) fn resolve<O: Operation>(mut op: O, target: &Target<'_>) -> Result<Vec<O>, Problem> {
    let mut ops = Vec::new();
    match chosen::<O>(target).filter(|_| is_open(&op)) {
        None => ops.push(op),
        Some((at, field, element, selected)) => {
            check_selection::<O>(target)?;
            let ids = target.ids(element, selected);
            let mut fill = |mut op: O, ids: &[u32]| {
                if let Some(slot) = op.elements().into_iter().nth(at) {
                    slot.fill(ids);
                }
                ops.push(op);
            };
            match (selected, field.kind) {
                (Selected::AllOrEvery, _) if ids.is_empty() => ops.push(op),
                (_, FieldKind::Elements { arity: Arity::One, .. }) => match ids.split_last() {
                    None => return Err(nothing_selected(field, element, selected)),
                    Some((last, rest)) => {
                        for id in rest {
                            fill(op.clone(), &[*id]);
                        }
                        fill(op, &[*last]);
                    }
                },
                (Selected::Two, _) if ids.len() != 2 => {
                    return Err(wrong_number(field, element, ids.len(), "two"));
                }
                _ => {
                    if let Some(slot) = op.elements().into_iter().nth(at) {
                        slot.fill(&ids);
                    }
                    ops.push(op);
                }
            }
            ops = O::from_selection(ops, target.mesh)?;
        }
    }
    for op in &mut ops {
        op.complete(target)?;
    }
    Ok(ops)
}

impl Target<'_> {
    /// The kind of elements to select: the given one, or that of the selection.
    pub fn kind(&self, given: Option<Kind>) -> Element {
        given.map_or(self.selection.kind(), Kind::element)
    }

    /// The element of a kind that was selected last.
    pub fn latest(&self, kind: Element) -> Result<u32, Problem> {
        let latest = self.selection.latest().filter(|_| self.selection.kind() == kind);
        latest.ok_or_else(|| {
            let one = if kind == Element::Edge { "an edge".to_owned() } else { format!("a {kind}") };
            Problem::new(format!("no {kind} is selected")).advise(format!("Select {one} first."))
        })
    }

    /// The ids of the selected elements, converted to this kind.
    fn ids(&self, element: Element, selected: Selected) -> Vec<u32> {
        let mut ids: Vec<u32> = match (element, selected) {
            (_, Selected::Vertices) => self.vertices().into_iter().map(VertexId::raw).collect(),
            (Element::Edge, _) => self.edges().into_iter().map(EdgeId::raw).collect(),
            (Element::Halfedge, _) => self.boundary_sides().into_iter().map(HalfedgeId::raw).collect(),
            _ if self.selection.kind() == element => self.selection.ids().collect(),
            _ => Vec::new(),
        };
        if selected == Selected::Two
            && let [a, b] = ids.as_mut_slice()
            && let Some(latest) = self.selection.latest()
        {
            // The element selected last may be of another kind than the field's.
            let alone = Selection::of(self.selection.kind(), [latest]);
            let latest = Target { selection: &alone, ..*self }.ids(element, Selected::Only);
            if latest == [*a] {
                std::mem::swap(a, b);
            }
        }
        ids
    }

    /// The selected vertices, or the vertices of the selected edges, half-edges or faces.
    fn vertices(&self) -> Vec<VertexId> {
        let mesh = self.mesh;
        let ids = self.selection.ids();
        let mut vertices: Vec<VertexId> = match self.selection.kind() {
            Element::Vertex => ids.filter_map(|id| mesh.vertex(id)).collect(),
            Element::Edge => ids.filter_map(|id| mesh.edge(id)).flat_map(|e| mesh.ends(e)).collect(),
            Element::Halfedge => {
                ids.filter_map(|id| mesh.halfedge(id)).flat_map(|h| mesh.ends(h.edge())).collect()
            }
            Element::Face => ids
                .filter_map(|id| mesh.face(id))
                .flat_map(|f| mesh.face_vertices(f).collect::<Vec<_>>())
                .collect(),
        };
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// The selected edges, or those of the selected half-edges.
    fn edges(&self) -> Vec<EdgeId> {
        let ids = self.selection.ids();
        let mut edges: Vec<EdgeId> = match self.selection.kind() {
            Element::Edge => ids.filter_map(|id| self.mesh.edge(id)).collect(),
            Element::Halfedge => ids.filter_map(|id| self.mesh.halfedge(id)).map(|h| h.edge()).collect(),
            Element::Vertex | Element::Face => Vec::new(),
        };
        edges.dedup();
        edges
    }

    /// The boundary sides of the selected edges or half-edges; for those that are not on the boundary, a half-edge.
    fn boundary_sides(&self) -> Vec<HalfedgeId> {
        let mut sides: Vec<HalfedgeId> = match self.selection.kind() {
            Element::Halfedge => self.selection.ids().filter_map(|id| self.mesh.halfedge(id)).collect(),
            _ => self.edges().into_iter().map(EdgeId::halfedge).collect(),
        };
        for side in &mut sides {
            if self.mesh.is_boundary_halfedge(side.twin()) {
                *side = side.twin();
            }
        }
        sides.dedup();
        sides
    }
}

fn nothing_selected(field: &Field, element: Element, selected: Selected) -> Problem {
    let (what, advice) = match selected {
        Selected::Vertices => ("nothing".to_owned(), "Select something first.".to_owned()),
        Selected::Two => (format!("no {element}"), format!("Select two {} first.", element.plural())),
        _ => {
            let advice = match element {
                Element::Edge => "Select an edge first.".to_owned(),
                // Edges can stand in for their boundary sides.
                Element::Halfedge => "Select an edge or a half-edge first.".to_owned(),
                Element::Vertex | Element::Face => format!("Select a {element} first."),
            };
            (format!("no {element}"), advice)
        }
    };
    Problem::of_field(field.name, format!("is missing, and {what} is selected")).advise(advice)
}

fn wrong_number(field: &Field, element: Element, selected: usize, needed: &str) -> Problem {
    let are = if selected == 1 { "1 is".to_owned() } else { format!("{selected} are") };
    let elements = if needed == "one" { element.to_string() } else { element.plural().to_owned() };
    Problem::of_field(
        field.name,
        format!("is missing, and {are} selected where it takes {needed} {elements}"),
    )
    .advise(format!("Select {needed} {elements} first."))
}
