//! The description of an operation, from which everything about it is made: menus, the palette,
//! forms, previews, the operations reference and `meshwright --help`.

use super::OpId;
use super::field::{Field, FieldKind, Fill};
use halfedge::Element;

/// An operation's name, texts and fields.
#[derive(Clone, Copy, Debug)]
pub struct Spec {
    /// The name in JSON.
    pub name: &'static str,
    /// What menus and the history call it, in sentence case.
    pub label: &'static str,
    /// One sentence that says what it does.
    pub description: &'static str,
    /// Other programs' names for it, by which the palette finds it too.
    pub synonyms: &'static [&'static str],
    /// What it works on.
    pub scope: Scope,
    /// The operations that do the same to other kinds of elements.
    pub family: Option<Family>,
    /// Another family that it stands in for, without being of it.
    pub also: Option<Family>,
    /// Whether its form shows the result while its fields are filled in.
    pub previewed: bool,
    /// Its fields, without `op` and `object`.
    pub fields: &'static [Field],
}

/// What an operation works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// A few elements of a mesh: quick, keeps ids, can follow the pointer.
    Elements,
    /// Whole meshes: may run as a job, gives elements new ids.
    Meshes,
    /// The control points of a Bezier object: quick, can follow the pointer.
    Bezier,
    /// What is selected and what is hidden: quick, doesn't change meshes.
    Selection,
    /// The document: which objects there are, and what they are called.
    Document,
}

/// Operations that do the same to different kinds of elements: a key of one starts the one that suits the selection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Extrude faces or edges.
    Extrude,
    /// Bevel edges or vertices.
    Bevel,
    /// Delete faces or vertices, dissolve edges.
    Delete,
    /// Dissolve vertices or edges.
    Dissolve,
    /// Slide edges or vertices.
    Slide,
}

impl Spec {
    /// An operation without fields.
    pub(crate) const fn new(
        scope: Scope,
        name: &'static str,
        label: &'static str,
        description: &'static str,
    ) -> Self {
        Self {
            name,
            label,
            description,
            synonyms: &[],
            scope,
            family: None,
            also: None,
            previewed: false,
            fields: &[],
        }
    }

    pub(crate) const fn synonyms(self, synonyms: &'static [&'static str]) -> Self {
        Self { synonyms, ..self }
    }

    pub(crate) const fn family(self, family: Family) -> Self {
        Self { family: Some(family), ..self }
    }

    pub(crate) const fn also(self, family: Family) -> Self {
        Self { also: Some(family), ..self }
    }

    /// Whether it is of a family, or stands in for it.
    pub fn is_of(&self, family: Family) -> bool {
        self.family == Some(family) || self.also == Some(family)
    }

    pub(crate) const fn previewed(self) -> Self {
        Self { previewed: true, ..self }
    }

    pub(crate) const fn fields(self, fields: &'static [Field]) -> Self {
        Self { fields, ..self }
    }

    /// The field of this name.
    pub fn field(&self, name: &str) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// The first field that follows the pointer.
    pub fn dragged_field(&self) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.drag.is_some())
    }

    /// Whether a selection of this kind can stand in for the elements that are left out.
    pub fn applies_to(&self, kind: Element) -> bool {
        self.fields.iter().any(|field| field.takes_selected(kind))
    }

    /// The kind of element whose menu lists the operation: that of its first element field, with
    /// half-edges among the edges; none where it takes no elements.
    pub fn element(&self) -> Option<Element> {
        self.fields.iter().find_map(|field| match field.kind {
            FieldKind::Elements { element: Element::Halfedge, .. } => Some(Element::Edge),
            FieldKind::Elements { element, .. } => Some(element),
            _ => None,
        })
    }

    /// Whether the operation makes sense with no field filled in by hand: the selection gives its
    /// elements, and every other field has a value as its default. The others open a form.
    pub fn runs_without_form(&self) -> bool {
        self.fields.iter().all(|field| match field.fill {
            Fill::Required | Fill::Unset(_) => false,
            Fill::Value(_) | Fill::Selection(_) | Fill::Optional(_) => true,
        })
    }
}

impl OpId {
    /// The operation of the same family that works on a kind of element; this one where it has no
    /// family, or where no member works on that kind.
    pub fn for_selection(self, kind: Element) -> Self {
        let spec = self.spec();
        let Some(family) = spec.family.filter(|_| !spec.applies_to(kind)) else { return self };
        let mut members = Self::ALL.iter().filter(|id| id.spec().is_of(family));
        members.find(|id| id.spec().applies_to(kind)).copied().unwrap_or(self)
    }
}
