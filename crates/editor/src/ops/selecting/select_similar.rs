//! `select-similar`: select elements like the one selected last.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Action, DefaultValue, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Target, Unit};
use halfedge::geometry::face_area_vector;
use halfedge::{Element, FaceId, NumberRange, VertexId, keys};
use serde::{Deserialize, Serialize};
use surface::selecting::{Comparison, Criterion, Finding, size};

/// Select elements that share a property with the one selected last.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectSimilar {
    /// The property.
    pub by: Similarity,
    /// How much it may differ, as a fraction: of the size, of a colour's range, or of a half turn.
    #[serde(with = "crate::script::json::finite")]
    pub tolerance: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

choice! {
    /// What similar elements share.
    pub enum Similarity {
        /// The number of a face's corners or of a vertex's edges.
        Count = "count" "Corners or valence",
        /// The area of a face or the length of an edge.
        Size = "size" "Area or length",
        /// A face's normal.
        Normal = "normal" "Normal",
        /// A face's colour.
        Color = "color" "Colour",
    }
}

const TOLERANCE: f32 = 0.01;

impl SelectSimilar {
    /// Elements that share a property with the one selected last, as menus select them.
    pub fn by(by: Similarity) -> Self {
        Self { by, tolerance: TOLERANCE, mode: SelectMode::Replace }
    }
}

impl Operation for SelectSimilar {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-similar",
        "Select similar",
        "Select elements that share a property with the one selected last.",
    )
    .synonyms(&["same area", "same length", "same colour", "same material"])
    .fields(&[
        Similarity::field("by", "The property"),
        Field::number(
            "tolerance",
            Unit::Fraction,
            NumberRange::new(0.0, 1.0),
            "How much it may differ, as a fraction",
        )
        .or(DefaultValue::Number(TOLERANCE as f64)),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectSimilar {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        let (mesh, kind, tolerance) = (target.mesh, target.kind(None), f64::from(self.tolerance));
        let criterion = match (self.by, kind) {
            (Similarity::Count, Element::Vertex) => {
                let than = mesh.valence(VertexId::new(target.latest(kind)? as usize));
                Criterion::Count { is: Comparison::Equal, than }
            }
            (Similarity::Count, Element::Edge | Element::Halfedge) => {
                return Err(Problem::field("by", "edges have no corners")
                    .advise("Select a face or a vertex first: edges have no corners."));
            }
            (Similarity::Count, Element::Face) => {
                let than = mesh.face_degree(FaceId::new(target.latest(kind)? as usize));
                Criterion::Count { is: Comparison::Equal, than }
            }
            (Similarity::Size, kind) => {
                let latest = target.latest(kind)?;
                let Some(size) = size(mesh, kind, latest as usize) else {
                    return Err(Problem::field("by", "vertices have no size")
                        .advise("Select a face or an edge first: vertices have no size."));
                };
                Criterion::Near { size, tolerance }
            }
            (Similarity::Normal, _) => {
                let direction = face_area_vector(mesh, FaceId::new(target.latest(Element::Face)? as usize));
                Criterion::Facing { direction, degrees: tolerance * 180.0 }
            }
            (Similarity::Color, _) => {
                let color = mesh.get(keys::FACE_COLOR, target.latest(Element::Face)? as usize);
                Criterion::Colored { color, tolerance }
            }
        };
        let kind = if criterion.kinds().contains(&kind) { kind } else { Element::Face };
        Ok(Finding::by(kind, criterion))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
