//! The fields of operations: what each takes, what it is when left out, and what forms suggest.

use super::choice::Choice;
use super::facts::Facts;
use super::wording::{four_digits, sentence_case};
use halfedge::{Element, NumberRange};
use serde_json::{Value, json};

/// One field of an operation.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    /// The name in JSON.
    pub name: &'static str,
    /// What forms call it where the name read as words says too little.
    label: &'static str,
    /// What it means, in a few words.
    pub description: &'static str,
    /// What it takes.
    pub kind: FieldKind,
    /// What it is when left out.
    pub fill: Fill,
    /// What a form starts with where the field has no default value.
    pub suggestion: Suggestion,
    /// How it follows the pointer.
    pub drag: Option<Drag>,
    /// The title of its group of alternatives. Exactly one of a group is given; they are listed
    /// together.
    pub alternative: Option<&'static str>,
}

/// What a field takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FieldKind {
    /// Elements by id; edges and half-edges also by the pair of their vertices.
    Elements {
        /// The kind of element.
        element: Element,
        /// How many it takes.
        arity: Arity,
    },
    /// A number.
    Number {
        /// What it measures.
        unit: Unit,
        /// The numbers that commands and forms take.
        range: NumberRange,
    },
    /// A whole number.
    Integer {
        /// What it counts.
        unit: Unit,
        /// The numbers that commands and forms take.
        range: NumberRange,
    },
    /// Three numbers: a position, an offset or a direction.
    Vector,
    /// Two positions.
    VectorPair,
    /// Three factors, or one for all three axes.
    Factors,
    /// An axis and degrees: `{"axis": [0, 0, 1], "degrees": 90}`.
    Rotation,
    /// A colour as `#rrggbb`.
    Color,
    /// One of these words.
    Choice(&'static [Choice]),
    /// True or false.
    Flag,
    /// Text.
    Text,
    /// A list of places in the document's list of objects.
    Objects,
    /// The name of a shape. Its form also has the sizes that this shape has.
    Shape,
    /// A size that some shapes have: the form of the shape shows it.
    ShapeSize,
}

/// How many elements a field takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arity {
    /// One.
    One,
    /// Two, as a list.
    Two,
    /// A list.
    Many,
}

/// What a number measures or counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A length in mesh units.
    Length,
    /// An area in square mesh units.
    Area,
    /// An angle in degrees.
    Degrees,
    /// A part of a whole: from 0 to 1, or from -1 to 1 where there are two ways.
    Fraction,
    /// A count.
    Count,
    /// A count of triangles of the mesh.
    Triangles,
    /// A part of the triangles of the mesh.
    ShareOfTriangles,
}

/// What a field is when it is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fill {
    /// It must be given.
    Required,
    /// This value.
    Value(DefaultValue),
    /// What the selection gives.
    Selection(Selected),
    /// No value; these words say what happens then. Forms offer to set it.
    Unset(&'static str),
    /// No value; these words say what happens then. Forms leave it out: something else fills it in.
    Optional(&'static str),
}

/// A value as a default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DefaultValue {
    /// A number.
    Number(f64),
    /// A whole number.
    Integer(u32),
    /// True or false.
    Flag(bool),
    /// A word of a choice.
    Choice(&'static str),
    /// Three numbers.
    Vector([f64; 3]),
    /// Three equal factors.
    Factor(f64),
}

/// Which selected elements a field takes when it is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selected {
    /// The selected elements, one operation for each in one undo step.
    Each,
    /// The one selected element.
    Only,
    /// The two selected elements, the latest one second.
    Two,
    /// All selected elements.
    All,
    /// All selected elements, or every element of the mesh where none is selected.
    AllOrEvery,
    /// The vertices of whatever is selected.
    Vertices,
}

/// What a form starts with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Suggestion {
    /// Nothing special: 1, or the nearest value the field takes.
    None,
    /// This number.
    Number(f64),
    /// The mean length of the mesh's edges.
    MeanEdge,
    /// The length of edges that remeshing takes for the mesh.
    RemeshedEdge,
    /// This part of the diagonal of the mesh's bounding box.
    OfDiagonal(f64),
    /// This part of the mesh's triangles.
    OfTriangles(f64),
}

/// How a field follows the pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drag {
    /// A length along the normal of the selection.
    Distance,
    /// A length of 0 or more: the farther from where the pointer began, the more.
    Width,
    /// A fraction of an edge, from its middle.
    Fraction,
    /// A fraction from -1 to 1 of the way to the neighbours on one side or the other, which begins at 0.
    Slide,
    /// A vector in the plane of the view, or along an axis.
    Offset,
    /// A rotation about the direction of view, or about an axis.
    Rotation,
    /// A factor for all axes, or one for each.
    Factors,
}

/// Angles between two directions, in degrees.
pub(crate) const ANGLE_RANGE: NumberRange = NumberRange::new(0.0, 180.0);

/// Places in a list, from 0. The operation knows the list, and says how long it is.
pub(crate) const INDEX_RANGE: NumberRange = NumberRange::counts(0, u32::MAX);

impl Field {
    const fn new(name: &'static str, kind: FieldKind, fill: Fill, description: &'static str) -> Self {
        let (suggestion, drag, alternative) = (Suggestion::None, None, None);
        Self { name, label: "", description, kind, fill, suggestion, drag, alternative }
    }

    /// A field that must be given.
    pub(crate) const fn required(name: &'static str, kind: FieldKind, description: &'static str) -> Self {
        Self::new(name, kind, Fill::Required, description)
    }

    /// One element, which the selection stands in for.
    pub(crate) const fn one(
        name: &'static str,
        element: Element,
        selected: Selected,
        description: &'static str,
    ) -> Self {
        let kind = FieldKind::Elements { element, arity: Arity::One };
        Self::new(name, kind, Fill::Selection(selected), description)
    }

    /// Two elements, which two selected ones stand in for.
    pub(crate) const fn two(name: &'static str, element: Element, description: &'static str) -> Self {
        let kind = FieldKind::Elements { element, arity: Arity::Two };
        Self::new(name, kind, Fill::Selection(Selected::Two), description)
    }

    /// A list of elements, which the selection stands in for.
    pub(crate) const fn many(
        name: &'static str,
        element: Element,
        selected: Selected,
        description: &'static str,
    ) -> Self {
        let kind = FieldKind::Elements { element, arity: Arity::Many };
        Self::new(name, kind, Fill::Selection(selected), description)
    }

    /// A number, which must be given unless a default follows.
    pub(crate) const fn number(
        name: &'static str,
        unit: Unit,
        range: NumberRange,
        description: &'static str,
    ) -> Self {
        Self::required(name, FieldKind::Number { unit, range }, description)
    }

    /// A whole number, which must be given unless a default follows.
    pub(crate) const fn count(name: &'static str, range: NumberRange, description: &'static str) -> Self {
        Self::required(name, FieldKind::Integer { unit: Unit::Count, range }, description)
    }

    pub(crate) const fn or(self, default: DefaultValue) -> Self {
        Self { fill: Fill::Value(default), ..self }
    }

    pub(crate) const fn unset(self, words: &'static str) -> Self {
        Self { fill: Fill::Unset(words), ..self }
    }

    pub(crate) const fn optional(self, words: &'static str) -> Self {
        Self { fill: Fill::Optional(words), ..self }
    }

    pub(crate) const fn labelled(self, label: &'static str) -> Self {
        Self { label, ..self }
    }

    pub(crate) const fn suggest(self, suggestion: Suggestion) -> Self {
        Self { suggestion, ..self }
    }

    pub(crate) const fn drag(self, drag: Drag) -> Self {
        Self { drag: Some(drag), ..self }
    }

    pub(crate) const fn alternative(self, title: &'static str) -> Self {
        Self { alternative: Some(title), ..self }
    }

    /// What forms call it: "Feature angle".
    pub fn label(&self) -> String {
        if self.label.is_empty() { sentence_case(self.name) } else { self.label.to_owned() }
    }

    /// The range of a number.
    pub fn range(&self) -> Option<NumberRange> {
        match self.kind {
            FieldKind::Number { range, .. } | FieldKind::Integer { range, .. } => Some(range),
            _ => None,
        }
    }

    /// Whether it takes elements or objects, which no form has values for.
    pub fn is_target(&self) -> bool {
        matches!(self.kind, FieldKind::Elements { .. } | FieldKind::Objects)
    }

    /// Whether selected elements of this kind can stand in for it.
    pub fn takes_selected(&self, kind: Element) -> bool {
        let (FieldKind::Elements { element, .. }, Fill::Selection(selected)) = (self.kind, self.fill) else {
            return false;
        };
        match (element, kind) {
            _ if selected == Selected::Vertices => true,
            // The edges of half-edges stand in for them, and boundary sides of edges for half-edges.
            (Element::Edge | Element::Halfedge, Element::Edge | Element::Halfedge) => true,
            (element, kind) => element == kind,
        }
    }

    /// The default, where it is a value.
    pub fn default_value(&self) -> Option<Value> {
        let Fill::Value(default) = self.fill else { return None };
        Some(match default {
            DefaultValue::Number(number) | DefaultValue::Factor(number) => json!(number),
            DefaultValue::Integer(number) => json!(number),
            DefaultValue::Flag(on) => json!(on),
            DefaultValue::Choice(name) => json!(name),
            DefaultValue::Vector(vector) => json!(vector),
        })
    }

    /// What it is when left out, in words: "0.5", "the selected edges"; none for a field that must be
    /// given.
    pub fn default_words(&self) -> Option<String> {
        match self.fill {
            Fill::Required => None,
            Fill::Value(_) => self.default_value().map(|value| match value {
                Value::String(word) => word,
                value => value.to_string(),
            }),
            Fill::Selection(selected) => Some(self.selection_words(selected)),
            Fill::Unset(words) | Fill::Optional(words) => Some(words.to_owned()),
        }
    }

    fn selection_words(&self, selected: Selected) -> String {
        let FieldKind::Elements { element, .. } = self.kind else { return "the selection".to_owned() };
        let (one, many) = (element.to_string(), element.plural());
        match selected {
            Selected::Each | Selected::All => format!("the selected {many}"),
            Selected::Only => format!("the selected {one}"),
            Selected::Two => format!("the two selected {many}"),
            Selected::AllOrEvery => format!("the selected {many}, or all"),
            Selected::Vertices => "the vertices of the selection".to_owned(),
        }
    }

    /// What a form starts with: the default, or a value that suits the mesh.
    pub fn initial_value(&self, facts: &Facts) -> Value {
        if let Some(value) = self.default_value() {
            return value;
        }
        let suggested = match self.suggestion {
            Suggestion::None => None,
            Suggestion::Number(number) => Some(number),
            Suggestion::MeanEdge => facts.mean_edge,
            Suggestion::RemeshedEdge => facts.remeshed_edge(),
            Suggestion::OfDiagonal(part) => facts.diagonal.map(|diagonal| diagonal * part),
            Suggestion::OfTriangles(part) => facts.triangles().map(|count| (count as f64 * part).round()),
        };
        let suggested = suggested.map(four_digits).filter(|number| *number > 0.0);
        match self.kind {
            FieldKind::Number { range, .. } => json!(range.nearest(suggested.unwrap_or(1.0))),
            FieldKind::Integer { range, .. } => {
                json!(range.nearest(suggested.unwrap_or(1.0)) as i64)
            }
            FieldKind::Vector => json!([0.0, 0.0, 0.0]),
            FieldKind::VectorPair => json!([[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]),
            FieldKind::Factors => json!([1.0, 1.0, 1.0]),
            FieldKind::Rotation => json!({ "axis": [0.0, 1.0, 0.0], "degrees": 0.0 }),
            FieldKind::Color => json!(halfedge::Color::UNPAINTED.to_hex()),
            FieldKind::Choice(choices) => json!(choices.first().map_or("", |choice| choice.name)),
            FieldKind::Flag => json!(false),
            FieldKind::Text => json!(""),
            FieldKind::Shape => json!(surface::Shape::names().next()),
            FieldKind::Elements { arity: Arity::One, .. } | FieldKind::ShapeSize => json!(0),
            FieldKind::Elements { .. } | FieldKind::Objects => json!([]),
        }
    }
}
