//! `select-all`: select every element of a kind.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Action, Field, FieldKind, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use halfedge::Element;
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select every element of a kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectAll {
    /// The kind of elements; that of the selection when left out.
    pub kind: Option<Kind>,
    /// How what is found changes the selection; `toggle` inverts it.
    pub mode: SelectMode,
}

choice! {
    /// A kind of element.
    pub enum Kind {
        /// Vertices.
        Vertex = "vertex" "Vertices",
        /// Edges.
        Edge = "edge" "Edges",
        /// Half-edges.
        Halfedge = "halfedge" "Half-edges",
        /// Faces.
        Face = "face" "Faces",
    }
}

impl Kind {
    /// A field that takes a kind.
    pub(crate) const FIELD: Field =
        Field::required("kind", FieldKind::Choice(Self::CHOICES), "The kind of elements to select")
            .optional("the kind of the selection");

    /// The kind of element.
    pub fn element(self) -> Element {
        match self {
            Self::Vertex => Element::Vertex,
            Self::Edge => Element::Edge,
            Self::Halfedge => Element::Halfedge,
            Self::Face => Element::Face,
        }
    }
}

impl From<Element> for Kind {
    fn from(element: Element) -> Self {
        match element {
            Element::Vertex => Self::Vertex,
            Element::Edge => Self::Edge,
            Element::Halfedge => Self::Halfedge,
            Element::Face => Self::Face,
        }
    }
}

impl Operation for SelectAll {
    const SPEC: Spec =
        Spec::new(Scope::Selection, "select-all", "Select all elements", "Select every element of a kind.")
            .fields(&[Kind::FIELD, MODE]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectAll {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        Ok(Finding::by(target.kind(self.kind), Criterion::Any))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
