//! Facts about the active mesh, from which forms suggest values and estimate results.

use editor::{Changes, Editor, Facts, MAX_ELEMENTS_AT_ONCE};

use crate::session::survey::Survey;

/// The lengths and areas of the active mesh, measured on the first request after a change.
#[derive(Debug, Default)]
pub struct Measured {
    known: Option<Facts>,
    stale: bool,
}

impl Measured {
    /// Forgets the measures if the active object changed or another one is active.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        let active = editor.document().active().map(editor::Object::id);
        if changes.document || active.is_some_and(|id| changes.of(id).is_some()) {
            self.stale = true;
        }
    }

    /// The facts about the active mesh, with measures if requested. Measuring costs O(mesh), once after a
    /// change.
    pub fn facts(&mut self, editor: &Editor, survey: &Survey, measures: bool) -> Facts {
        let Some(mesh) = editor.mesh() else { return Facts::default() };
        let boundary = survey.found().map(|found| found.boundary_halfedges);
        let bezier = editor.document().active().and_then(editor::Object::bezier);
        let counts = Facts {
            corners: boundary.map(|boundary| mesh.halfedge_count().saturating_sub(boundary)),
            patches: bezier.map_or(0, |bezier| bezier.patches().len()),
            ..Facts::counts(mesh)
        };
        if !measures {
            return counts;
        }
        // Measuring a large mesh at every movement would be noticeable.
        let may_lag = editor.is_editing() && mesh.face_count() > MAX_ELEMENTS_AT_ONCE;
        let known = self.known.filter(|_| !self.stale || may_lag);
        let Facts { mean_edge, area, diagonal, .. } = known.unwrap_or_else(|| counts.with_measures(mesh));
        let facts = Facts { mean_edge, area, diagonal, ..counts };
        if known.is_none() {
            self.stale = false;
        }
        self.known = Some(facts);
        facts
    }
}
