//! The editor's state as JSON, as scripts on the page see it.

use crate::bezier::Bezier;
use crate::document::{Counts, NamedSelection, Object};
use crate::editor::Editor;
use crate::error::{CommandError, Problem};
use crate::script::json::{number, vector};
use glam::DVec3;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId, keys};
use serde_json::{Value, json};

/// Adds a field to a JSON object if there is a value for it.
fn with(mut object: Value, field: &str, value: Option<Value>) -> Value {
    if let (Value::Object(fields), Some(value)) = (&mut object, value) {
        fields.insert(field.to_owned(), value);
    }
    object
}

impl Editor {
    /// The document, selection, history and messages, as `window.meshwright.state()` returns them. The page
    /// adds `view` and the progress of `jobs`.
    ///
    /// Counts cover all objects together.
    pub fn state(&self) -> Value {
        let document = self.document();
        let total: Counts = document.objects().iter().filter_map(|object| self.counts(object.id())).sum();
        let objects: Vec<Value> = document
            .objects()
            .iter()
            .map(|object| {
                let value = json!({
                    "name": object.name(),
                    "visible": object.visible(),
                    "faces": object.mesh().face_count(),
                });
                let value = with(value, "bezier", object.bezier().map(bezier_state));
                let value = with(value, "repairable", object.is_repairable().then_some(Value::Bool(true)));
                let hidden = object.hidden().len();
                let value = with(value, "hidden", (hidden > 0).then(|| hidden.into()));
                let named = object.named_selections();
                with(
                    value,
                    "selections",
                    (!named.is_empty()).then(|| named.iter().map(named_state).collect()),
                )
            })
            .collect();
        let selection = self.selection();
        let offset = document.offset();
        let offset = (offset != DVec3::ZERO).then(|| offset.to_array().to_vec().into());
        let document = json!({
            "name": document.name(),
            "objects": objects,
            "active": document.active_index(),
            "vertices": total.vertices,
            "edges": total.edges,
            "halfedges": total.halfedges,
            "faces": total.faces,
            "boundary_loops": total.boundary_loops,
            "components": total.components,
            "euler": total.euler,
            "dirty": self.is_dirty(),
        });
        json!({
            "document": with(document, "offset", offset),
            "selection": {
                "kind": element_name(selection.kind()),
                "ids": selection.ids().collect::<Vec<_>>(),
            },
            "history": {
                "undo": self.undo_labels().collect::<Vec<_>>(),
                "redo": self.redo_labels().collect::<Vec<_>>(),
                "bytes": self.history_bytes(),
            },
            "jobs": self.jobs().map(|job| json!({"op": job.task})).collect::<Vec<_>>(),
            "messages": self.messages().collect::<Vec<_>>(),
        })
    }

    /// One element of the active object, as `window.meshwright.element(kind, id)` returns it.
    ///
    /// # Errors
    /// There is no such element.
    pub fn element(&self, kind: Element, id: u32) -> Result<Value, CommandError> {
        let mesh = self.document().active().map(Object::mesh).filter(|mesh| mesh.exists(kind, id));
        let Some(mesh) = mesh else {
            return Err(CommandError::of(
                "element",
                Problem::field("id", format!("there is no {kind} {id}")),
            ));
        };
        let at = id as usize;
        Ok(match kind {
            Element::Vertex => vertex(mesh, VertexId::new(at)),
            Element::Halfedge => halfedge(mesh, HalfedgeId::new(at)),
            Element::Edge => edge(mesh, EdgeId::new(at)),
            Element::Face => face(mesh, FaceId::new(at)),
        })
    }
}

/// The name, kind and number of elements of a named selection.
fn named_state(named: &NamedSelection) -> Value {
    let selection = &named.selection;
    json!({"name": named.name, "kind": element_name(selection.kind()), "count": selection.len()})
}

/// The kind of a Bezier object, with a curve's control points or the number of a surface's patches.
fn bezier_state(bezier: &Bezier) -> Value {
    match bezier {
        Bezier::Curve(curve) => json!({
            "kind": "curve",
            "points": curve.points.iter().map(|point| vector(point.to_array())).collect::<Vec<_>>(),
        }),
        Bezier::Surface(patches) => json!({"kind": "surface", "patches": patches.len()}),
    }
}

/// The name of a kind of element in JSON: `vertex`, `edge`, `halfedge` or `face`.
pub fn element_name(kind: Element) -> &'static str {
    match kind {
        Element::Vertex => "vertex",
        Element::Edge => "edge",
        Element::Halfedge => "halfedge",
        Element::Face => "face",
    }
}

/// The kind of element with this name in JSON; also accepts `half-edge`.
pub fn element_kind(name: &str) -> Option<Element> {
    match name {
        "vertex" => Some(Element::Vertex),
        "edge" => Some(Element::Edge),
        "halfedge" | "half-edge" => Some(Element::Halfedge),
        "face" => Some(Element::Face),
        _ => None,
    }
}

fn vertex(mesh: &Mesh, v: VertexId) -> Value {
    json!({
        "id": v.raw(),
        "position": vector(mesh.position(v).to_array()),
        "halfedge": mesh.halfedge_from(v).map(HalfedgeId::raw),
        "valence": mesh.valence(v),
        "boundary": mesh.is_boundary_vertex(v),
    })
}

fn halfedge(mesh: &Mesh, h: HalfedgeId) -> Value {
    json!({
        "id": h.raw(),
        "next": mesh.next(h).raw(),
        "prev": mesh.prev(h).raw(),
        "twin": h.twin().raw(),
        "vertex": mesh.to(h).raw(),
        "edge": h.edge().raw(),
        "face": mesh.face_of(h).map(FaceId::raw),
        "boundary": mesh.is_boundary_halfedge(h),
    })
}

fn edge(mesh: &Mesh, e: EdgeId) -> Value {
    let [a, b] = mesh.ends(e);
    json!({
        "id": e.raw(),
        "halfedge": e.halfedge().raw(),
        "vertices": [a.raw(), b.raw()],
        "faces": e.halfedges().map(|h| mesh.face_of(h).map(FaceId::raw)),
        "length": number(mesh.position(a).distance(mesh.position(b))),
        "crease": number(mesh.get(keys::EDGE_CREASE, e.index())),
        "boundary": mesh.is_boundary_edge(e),
    })
}

fn face(mesh: &Mesh, f: FaceId) -> Value {
    json!({
        "id": f.raw(),
        "halfedge": mesh.halfedge_of(f).raw(),
        "corners": mesh.face_vertices(f).map(VertexId::raw).collect::<Vec<_>>(),
        "color": mesh.get(keys::FACE_COLOR, f.index()).to_hex(),
        "area": number(surface::measure::face_area(mesh, f) as f32),
        "boundary": mesh.is_boundary_face(f),
    })
}
