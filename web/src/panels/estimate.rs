//! How large an operation's result will be, said before it runs.

use crate::app::App;
use crate::lists::columns::{counted, thousands};
use crate::panels::fields::{Filled, Hints};
use crate::panels::new_shape;
use editor::Command;
use halfedge::{Element, Mesh, Progress};
use serde_json::Value;
use std::ops::ControlFlow;

/// A count that was made by trying an operation out, and for which state of the document and which
/// fields.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tried {
    revision: u64,
    op: &'static str,
    filled: Filled,
    /// The vertices or faces it makes; none where it is refused.
    count: Option<usize>,
}

/// Up to this many faces, merging is tried out to count what would be left: a few milliseconds.
const TRIED: usize = 20_000;

/// Up to so many times the mean length of its edges, a mesh's area says how many triangles it becomes.
const COARSER: f64 = 1.5;

impl App {
    /// How large the result of an operation with these fields is, as a sentence; none where that
    /// can't be said beforehand.
    pub(crate) fn estimate(&mut self, name: &str, filled: &Filled, hints: &Hints) -> Option<String> {
        if name == "new" {
            return new_shape::estimate(filled);
        }
        // What is shown has no need of reckoning.
        let shown = self.previewed(name, filled).map(|mesh| (mesh.vertex_count(), mesh.face_count()));
        let number = |field: &str| filled.get(field).and_then(Value::as_f64);
        let result = |count: usize| format!("Result: {}", counted(Element::Face, count));
        let levels = || u32::try_from(filled.get("levels")?.as_u64()?).ok().filter(|&levels| levels > 0);
        match name {
            // One quad for each corner, then four for each quad.
            "subdivide-catmull-clark" | "subdivide-linear" => {
                Some(result(hints.corners?.checked_mul(4_usize.checked_pow(levels()? - 1)?)?))
            }
            "subdivide-loop" => Some(result(hints.faces.checked_mul(4_usize.checked_pow(levels()?)?)?)),
            "simplify" => {
                let all = hints.triangles()?;
                let wanted = match (shown, number("ratio"), number("faces")) {
                    (Some((_, faces)), ..) => faces,
                    (None, Some(ratio), _) => (all as f64 * ratio).round() as usize,
                    (None, None, Some(faces)) => (faces as usize).min(all),
                    (None, None, None) => return Some(format!("Of {} triangles", thousands(all))),
                };
                Some(format!("Result: {} of {} triangles", thousands(wanted), thousands(all)))
            }
            "remesh" => match shown {
                Some((_, faces)) => Some(format!("Result: {} triangles", thousands(faces))),
                None => self.estimate_remesh(filled, hints),
            },
            "smooth" => Some(format!("{} move; counts stay", counted(Element::Vertex, hints.vertices))),
            "merge-by-distance" => match shown {
                Some((vertices, _)) => Some(of_vertices(vertices, hints.vertices)),
                None => self.estimate_merge(filled),
            },
            "bezier-tessellate" => {
                let patches = self.editor.document().active()?.bezier()?.patches().len();
                let side = usize::try_from(filled.get("resolution")?.as_u64()?).ok()?;
                Some(result(side.checked_mul(side)?.checked_mul(patches)?))
            }
            _ => None,
        }
    }

    /// Tries a merge out on a small mesh and counts what is left.
    fn estimate_merge(&mut self, filled: &Filled) -> Option<String> {
        let distance = filled.get("distance")?.as_f64()?;
        let mesh = self.editor.mesh()?;
        let all = mesh.vertex_count();
        if mesh.face_count() > TRIED || self.editor.is_editing() {
            return Some(format!("Of {}", counted(Element::Vertex, all)));
        }
        let left = self.tried("merge-by-distance", filled, |mesh, go_on| {
            Some(surface::merge_by_distance(mesh, distance, go_on).ok()?.mesh.vertex_count())
        })?;
        Some(of_vertices(left, all))
    }

    /// Tries remeshing out where that is quick. Else reckons with the area, as long as edges don't get
    /// much longer: how much coarser a mesh can become depends on what all has to be kept.
    fn estimate_remesh(&mut self, filled: &Filled, hints: &Hints) -> Option<String> {
        let mut value = filled.clone();
        value.insert("op".into(), "remesh".into());
        let command = Command::from_value(Value::Object(value)).ok()?;
        if !self.editor.is_editing() && self.editor.is_quick(command) {
            let defaults = surface::Remesh::default();
            let number = |field: &str| filled.get(field).and_then(Value::as_f64);
            let whole = |field: &str| filled.get(field).and_then(Value::as_u64);
            let options = surface::Remesh {
                edge_length: number("edge_length"),
                iterations: whole("iterations").map_or(defaults.iterations, |n| n as u32),
                feature_angle: number("feature_angle").unwrap_or(defaults.feature_angle),
                project: filled.get("project").and_then(Value::as_bool).unwrap_or(defaults.project),
            };
            let made = self.tried("remesh", filled, |mesh, go_on| {
                Some(surface::remesh(mesh, &options, go_on).ok()?.face_count())
            })?;
            return Some(format!("Result: {} triangles", thousands(made)));
        }
        let measures = hints.measures?;
        let length = filled.get("edge_length").and_then(Value::as_f64).unwrap_or(measures.mean_edge);
        if length > COARSER * measures.mean_edge {
            return None;
        }
        let count = surface::Remesh::expected(measures.area, length);
        count.is_finite().then(|| format!("Result: about {} triangles", thousands(count.round() as usize)))
    }

    /// What `count` finds for the active mesh, once for a state of the document and fields.
    fn tried(
        &mut self,
        op: &'static str,
        filled: &Filled,
        count: impl FnOnce(&Mesh, &mut Progress<'_>) -> Option<usize>,
    ) -> Option<usize> {
        let revision = self.editor.revision();
        let known = |tried: &Tried| tried.revision == revision && tried.op == op && tried.filled == *filled;
        if let Some(tried) = self.forms.tried.as_ref().filter(|tried| known(tried)) {
            return tried.count;
        }
        let count = count(self.editor.mesh()?, &mut |_| ControlFlow::Continue(()));
        self.forms.tried = Some(Tried { revision, op, filled: filled.clone(), count });
        count
    }
}

fn of_vertices(left: usize, all: usize) -> String {
    format!("Result: {} of {} vertices", thousands(left), thousands(all))
}
