//! The faces that hiding and isolating mean.

use crate::error::Problem;
use crate::ops::refs::all;
use crate::ops::{EdgeRef, FaceRef, Place, VertexRef};
use halfedge::geometry::BitSet;
use halfedge::{Element, InParts};
use surface::selecting::Finding;

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
    let mut found: BitSet = all(faces, "faces", mesh)?.iter().map(|f| f.index()).collect();
    let edges: BitSet = all(edges, "edges", mesh)?.iter().map(|e| e.index()).collect();
    let vertices: BitSet = all(vertices, "vertices", mesh)?.iter().map(|v| v.index()).collect();
    found.union_with(&touching(Element::Edge, edges));
    found.union_with(&touching(Element::Vertex, vertices));
    Ok(found)
}
