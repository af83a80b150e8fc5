//! Facts about the active mesh: what forms suggest for their fields and estimate results with.

use editor::{Changes, Editor, Facts};

use crate::session::survey::Survey;

/// The lengths and areas of the active mesh, measured when they are first asked for after a change.
#[derive(Debug, Default)]
pub struct Measured {
    known: Option<Facts>,
    stale: bool,
}

/// While a larger mesh is being edited, its measures may lag behind: taking them at every movement
/// would be felt.
const MAX_FACES_MEASURED_LIVE: usize = 20_000;

impl Measured {
    /// Forgets what the active object measured, where it changed or is another.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        let active = editor.document().active().map(editor::Object::id);
        if changes.document || active.is_some_and(|id| changes.of(id).is_some()) {
            self.stale = true;
        }
    }

    /// The facts about the active mesh, with measures where they are asked for. Costs O(mesh) then, after
    /// a change.
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
        let may_lag = editor.is_editing() && mesh.face_count() > MAX_FACES_MEASURED_LIVE;
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
