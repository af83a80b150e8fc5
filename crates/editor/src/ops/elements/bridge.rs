//! `bridge`: join boundary loops, or regions of faces, with bands of faces.

use crate::error::Problem;
use crate::ops::refs::all;
use crate::ops::symmetry::Mirroring;
use crate::ops::{
    Action, DefaultValue, FaceRef, Field, FieldKind, HalfedgeRef, LocalEdit, Operation, Reflection, SYMMETRY,
    Scope, Selected, Slot, Spec, Unit,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::edit::Bands;
use halfedge::{Element, Mesh, NumberRange, edit};
use serde::{Deserialize, Serialize};

/// The twists either way.
const TWIST_RANGE: NumberRange = NumberRange::new(-1000.0, 1000.0);

/// Join boundary loops, or regions of faces, with bands of faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Bridge {
    /// Boundary half-edges of the loops, two loops or more; the selected ones when left out.
    pub halfedges: Option<Vec<HalfedgeRef>>,
    /// Faces, in two regions or more, which the bands replace; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
    /// How many loops of edges there are between the two that are joined.
    pub cuts: u32,
    /// By how many vertices the pairing is shifted from the one with the shortest edges.
    pub twist: i32,
    /// How far the bands go on in the directions of the surfaces.
    #[serde(with = "crate::script::json::finite")]
    pub smoothness: f32,
}

impl Operation for Bridge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "bridge",
        "Bridge",
        "Join two boundary loops, or two faces or regions that it replaces, with a band of faces; of more than two, those \
         that are closest to each other.",
    )
    .synonyms(&["bridge edge loops", "bridge faces", "handle", "loft"])
    .fields(&[
        Field::many(
            "halfedges",
            Element::Halfedge,
            Selected::All,
            "Boundary half-edges, one or more of each loop",
        ),
        Field::many("faces", Element::Face, Selected::All, "Faces to replace, in two regions or more"),
        Field::count("cuts", edit::BRIDGE_CUTS_RANGE, "How many loops of edges to add between the two")
            .or(DefaultValue::Integer(0)),
        Field::required(
            "twist",
            FieldKind::Integer { unit: Unit::Count, range: TWIST_RANGE },
            "By how many vertices to turn one loop against the other",
        )
        .or(DefaultValue::Integer(0)),
        Field::number(
            "smoothness",
            Unit::Fraction,
            edit::BRIDGE_SMOOTHNESS_RANGE,
            "How far the band goes on in the directions of the surfaces: 0 is straight, 1 leaves both smoothly, and more makes \
             it rounder; it takes cuts",
        )
        .or(DefaultValue::Number(0.0)),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Halfedges(&mut self.halfedges), Slot::Faces(&mut self.faces)]
    }

    fn from_selection(mut ops: Vec<Self>, mesh: &Mesh) -> Result<Vec<Self>, Problem> {
        for op in &mut ops {
            let given = all(&op.halfedges, "halfedges", mesh)?;
            if given.is_empty() {
                continue;
            }
            // Of a selection that reaches into the surface, the loops beside it are joined.
            let on_boundary: Vec<HalfedgeRef> =
                given.iter().filter(|&&h| mesh.is_boundary_halfedge(h)).map(|&h| h.into()).collect();
            if on_boundary.is_empty() {
                return Err(Problem::new("no selected edge is on a boundary")
                    .advise("Select edges of two boundary loops, or the faces to replace."));
            }
            op.halfedges = Some(on_boundary);
        }
        Ok(ops)
    }

    const MIRRORING: Mirroring = Mirroring::Apart;

    fn reflect(&mut self, reflection: Reflection) {
        // Loops of a mirror image run the other way round; what is its own image has no twist.
        self.twist = if reflection.is_own { 0 } else { -self.twist };
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl Bridge {
    /// Whether it acts on faces; a refusal if it names both faces and half-edges.
    fn is_of_faces(&self) -> Result<bool, Problem> {
        match (&self.halfedges, &self.faces) {
            (Some(_), Some(_)) => Err(Problem::new("give either half-edges or faces, not both")),
            (_, faces) => Ok(faces.is_some()),
        }
    }

    fn bands(&self) -> Bands {
        Bands { twist: self.twist, cuts: self.cuts, smoothness: self.smoothness }
    }
}

impl LocalEdit for Bridge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let bands = self.bands();
        if self.is_of_faces()? {
            edit::can_bridge_faces(mesh, &all(&self.faces, "faces", mesh)?, bands)?;
        } else {
            edit::can_bridge(mesh, &all(&self.halfedges, "halfedges", mesh)?, bands)?;
        }
        Ok(())
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let bands = self.bands();
        if self.is_of_faces()? {
            edit::bridge_faces(mesh, &all(&self.faces, "faces", mesh)?, bands)?;
        } else {
            edit::bridge(mesh, &all(&self.halfedges, "halfedges", mesh)?, bands)?;
        }
        Ok(())
    }

    fn selects(&self, _mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        Some(Selection::of(Element::Face, created.faces.iter().copied()))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // Each half-edge of a loop gets at most one face and one for each cut. The half-edges of one loop are often all given.
        let mut seen = std::collections::HashSet::new();
        let mut count = 0_usize;
        for h in all(&self.halfedges, "halfedges", mesh).unwrap_or_default() {
            if !seen.contains(&h) {
                let before = seen.len();
                seen.extend(mesh.loop_of(h));
                count += seen.len() - before;
            }
        }
        let faces = all(&self.faces, "faces", mesh).unwrap_or_default();
        count += faces.into_iter().map(|face| mesh.face_degree(face)).sum::<usize>();
        count.saturating_mul(self.cuts as usize + 1)
    }
}
