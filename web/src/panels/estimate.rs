//! How large an operation's result will be, said before it runs.

use crate::app::App;
use crate::lists::columns::{counted, thousands};
use crate::panels::fields::{Filled, Hints};
use crate::panels::new_shape;
use halfedge::Element;
use serde_json::Value;

/// A count that was made for a form, and for which state of the document and which field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Merged {
    revision: u64,
    distance: f64,
    vertices: usize,
}

/// Up to this many faces, merging is tried out to count what would be left: a few milliseconds.
const TRIED: usize = 20_000;

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
            "remesh" => {
                if let Some((_, faces)) = shown {
                    return Some(format!("Result: {} triangles", thousands(faces)));
                }
                let measures = hints.measures?;
                let length = number("edge_length").unwrap_or(measures.mean_edge);
                // As many equilateral triangles as have the same area.
                let count = measures.area / (length * length * 3_f64.sqrt() / 4.0);
                count
                    .is_finite()
                    .then(|| format!("Result: about {} triangles", thousands(count.round() as usize)))
            }
            "smooth" => Some(format!("{} move; counts stay", counted(Element::Vertex, hints.vertices))),
            "merge-by-distance" => match shown {
                Some((vertices, _)) => Some(of_vertices(vertices, hints.vertices)),
                None => self.estimate_merge(number("distance")?),
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
    fn estimate_merge(&mut self, distance: f64) -> Option<String> {
        let mesh = self.editor.mesh()?;
        if mesh.face_count() > TRIED || self.editor.is_dragging() {
            return Some(format!("Of {}", counted(Element::Vertex, mesh.vertex_count())));
        }
        let revision = self.editor.revision();
        let known =
            self.forms.merged.filter(|merged| merged.revision == revision && merged.distance == distance);
        let merged = match known {
            Some(merged) => merged,
            None => {
                let go_on = &mut |_| std::ops::ControlFlow::Continue(());
                let vertices = surface::merge_by_distance(mesh, distance, go_on).ok()?.mesh.vertex_count();
                Merged { revision, distance, vertices }
            }
        };
        let all = mesh.vertex_count();
        self.forms.merged = Some(merged);
        Some(of_vertices(merged.vertices, all))
    }
}

fn of_vertices(left: usize, all: usize) -> String {
    format!("Result: {} of {} vertices", thousands(left), thousands(all))
}
