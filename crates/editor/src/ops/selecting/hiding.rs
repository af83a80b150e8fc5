//! The faces that hiding and isolating mean.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{EdgeRef, FaceRef, Field, Place, Selected, VertexRef};
use halfedge::edit::Refusal;
use halfedge::geometry::BitSet;
use halfedge::{Element, InParts};
use surface::selecting::Finding;

/// The fields of an operation on faces that are named by themselves or by their edges or vertices.
pub(super) const fn fields(faces: &'static str) -> [Field; 3] {
    [
        Field::many("faces", Element::Face, Selected::All, faces),
        Field::many("edges", Element::Edge, Selected::All, "Edges: the faces beside them"),
        Field::many("vertices", Element::Vertex, Selected::All, "Vertices: the faces around them"),
    ]
}

/// The faces that are given, or that have one of the given edges or vertices; where nothing is given, those that are
/// selected or touch the selection.
pub(super) fn faces_of(
    place: &Place<'_>,
    faces: &Option<Vec<FaceRef>>,
    edges: &Option<Vec<EdgeRef>>,
    vertices: &Option<Vec<VertexRef>>,
) -> Result<BitSet, Problem> {
    let object = place.object()?;
    crate::ops::refuse_bezier(object.name(), object.bezier())?;
    let mesh = object.mesh();
    let touching = |kind, ids: BitSet| Finding::expand(kind, Element::Face, ids).finish(mesh);
    if faces.is_none() && edges.is_none() && vertices.is_none() {
        let selection = place.selection().filter(|selection| !selection.is_empty());
        let selection = selection.ok_or_else(|| {
            Problem::new("nothing is given and nothing is selected").advise("Select something first.")
        })?;
        return Ok(touching(selection.kind(), selection.set().clone()));
    }
    if count(faces, 0) + count(edges, 0) + count(vertices, 0) == 0 {
        return Err(Refusal::NothingGiven(Element::Face).into());
    }
    let mut found: BitSet = all(faces, "faces", mesh)?.iter().map(|f| f.index()).collect();
    let edges: BitSet = all(edges, "edges", mesh)?.iter().map(|e| e.index()).collect();
    let vertices: BitSet = all(vertices, "vertices", mesh)?.iter().map(|v| v.index()).collect();
    found.union_with(&touching(Element::Edge, edges));
    found.union_with(&touching(Element::Vertex, vertices));
    Ok(found)
}
