//! `bridge`: join two boundary loops, or two faces, with a band of faces.

use crate::error::Problem;
use crate::ops::refs::two;
use crate::ops::{Action, FaceRef, Field, HalfedgeRef, LocalEdit, Operation, SYMMETRY, Scope, Slot, Spec};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Join two boundary loops, or two faces, with a band of faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bridge {
    /// A boundary half-edge of each loop; the two selected ones when left out.
    pub halfedges: Option<[HalfedgeRef; 2]>,
    /// Two faces, which the band replaces; the two selected ones when left out.
    pub faces: Option<[FaceRef; 2]>,
}

impl Operation for Bridge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "bridge",
        "Bridge",
        "Join two boundary loops, or two faces that it replaces, with a band of faces.",
    )
    .synonyms(&["bridge edge loops", "bridge faces", "handle"])
    .fields(&[
        Field::two("halfedges", Element::Halfedge, "A boundary half-edge of each loop"),
        Field::two("faces", Element::Face, "Two faces to replace"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::TwoHalfedges(&mut self.halfedges), Slot::TwoFaces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl Bridge {
    /// Whether it acts on faces; a refusal if it names both faces and half-edges.
    fn is_of_faces(&self) -> Result<bool, Problem> {
        match (&self.halfedges, &self.faces) {
            (Some(_), Some(_)) => Err(Problem::new("give either two half-edges or two faces, not both")),
            (_, faces) => Ok(faces.is_some()),
        }
    }
}

impl LocalEdit for Bridge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        if self.is_of_faces()? {
            edit::can_bridge_faces(mesh, two(self.faces, "faces", mesh)?)?;
        } else {
            edit::can_bridge(mesh, two(self.halfedges, "halfedges", mesh)?)?;
        }
        Ok(())
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        if self.is_of_faces()? {
            edit::bridge_faces(mesh, two(self.faces, "faces", mesh)?)?;
        } else {
            edit::bridge(mesh, two(self.halfedges, "halfedges", mesh)?)?;
        }
        Ok(())
    }

    fn selects(&self, _mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        Some(Selection::of(Element::Face, created.faces.iter().copied()))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // Each half-edge of either loop gets at most one face.
        let loops = match two(self.faces, "faces", mesh) {
            Ok(faces) => Ok(faces.map(|face| mesh.halfedge_of(face))),
            Err(_) => two(self.halfedges, "halfedges", mesh),
        };
        loops.map_or(0, |loops| loops.into_iter().map(|h| mesh.loop_of(h).count()).sum())
    }
}
