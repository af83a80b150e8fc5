//! `new`: start with a shape, or add one.

use crate::document::ObjectId;
use crate::error::Problem;
use crate::ops::json::Fields;
use crate::ops::{
    Action, Commit, DefaultValue, Estimate, Facts, Field, FieldKind, NamedMesh, Operation, Place, Scope,
    Spec, WholeMesh, sentence_case,
};
use halfedge::Progress;
use halfedge::words::thousands;
use serde_json::{Map, Value};
use std::sync::Arc;
use surface::{Shape, SurfaceError};

/// Start a new document with a shape, or add the shape to the document.
#[derive(Clone, Debug, PartialEq)]
pub struct New {
    /// The shape with its sizes.
    pub shape: Shape,
    /// Whether the shape becomes another object of the document instead of replacing it.
    pub add: bool,
}

impl Operation for New {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "new",
        "New shape",
        "Start a new document with a shape, or add the shape to this one.",
    )
    .synonyms(&[
        "add primitive",
        "cube",
        "sphere",
        "torus",
        "cylinder",
        "cone",
        "plane",
        "grid",
        "teapot",
        "bezier curve",
        "bezier patch",
    ])
    .fields(&[
        Field::required("shape", FieldKind::Shape, "Which shape"),
        Field::required("add", FieldKind::Flag, "Add it to this document instead of starting a new one")
            .labelled("Add to this document")
            .or(DefaultValue::Flag(false)),
        size("size", "The length of its sides"),
        size("radius", "The radius, from the centre or axis"),
        size("tube_radius", "The radius of a torus's tube"),
        size("height", "The height of the shape"),
        size("segments", "The number of faces around the axis"),
        size("tube_segments", "The number of faces around the tube"),
        size("rings", "The number of rows of faces"),
        size("subdivisions", "How many times to subdivide an icosahedron"),
        size("columns", "The number of faces in a row"),
        size("rows", "The number of rows of faces"),
        size("degree", "The degree of a Bezier curve, which has one control point more"),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

const fn size(name: &'static str, description: &'static str) -> Field {
    Field::required(name, FieldKind::ShapeSize, description).optional("by shape")
}

impl Fields for New {
    fn parse(mut fields: Map<String, Value>) -> Result<Self, Problem> {
        let names = || Shape::names().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let mut shape = match fields.remove("shape") {
            None => return Err(Problem::of_field("shape", format!("is missing; it is one of {}", names()))),
            Some(Value::String(name)) => Shape::named(&name).ok_or_else(|| {
                Problem::field("shape", format!("`{name}` is not a shape; it is one of {}", names()))
            })?,
            Some(other) => {
                return Err(Problem::field(
                    "shape",
                    format!("{other} is not the name of a shape, in quotes"),
                ));
            }
        };
        let add = match fields.remove("add") {
            None => false,
            Some(Value::Bool(add)) => add,
            Some(other) => return Err(Problem::field("add", format!("{other} is not true or false"))),
        };
        for (field, value) in fields {
            if shape.get(&field).is_none() {
                let known: Vec<String> = shape.fields().iter().map(|f| format!("`{}`", f.name)).collect();
                let known = known.join(", ");
                let text =
                    format!("is not a field of the shape `{}`; it has `shape`, `add`, {known}", shape.name());
                return Err(Problem::of_field(field, text));
            }
            let number =
                value.as_f64().ok_or_else(|| Problem::field(&*field, format!("{value} is not a number")))?;
            shape.set(&field, number)?;
        }
        Ok(Self { shape, add })
    }

    fn to_fields(&self) -> Value {
        let mut fields = Map::new();
        fields.insert("shape".into(), self.shape.name().into());
        if self.add {
            fields.insert("add".into(), true.into());
        }
        for field in self.shape.fields() {
            let value = self.shape.get(field.name).unwrap_or(field.default);
            let value = if field.whole { Value::from(value as u64) } else { Value::from(value) };
            fields.insert(field.name.into(), value);
        }
        Value::Object(fields)
    }
}

impl WholeMesh for New {
    fn compute(
        &self,
        _inputs: &[NamedMesh],
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem> {
        if progress(0.0).is_break() {
            return Err(Problem::cancelled());
        }
        let mesh = self.shape.build().map_err(|error| match error {
            SurfaceError::TooManyFaces { faces, limit } => Problem::new(format!(
                "the shape would have {} faces, more than the {} that fit; give smaller counts",
                thousands(faces),
                thousands(limit)
            )),
            other => other.into(),
        })?;
        let bezier = self.shape.control_points().map(Arc::new);
        Ok(vec![NamedMesh { bezier, ..NamedMesh::new(sentence_case(self.shape.name()), mesh) }])
    }

    fn result(&self, _facts: &Facts) -> Option<Estimate> {
        usize::try_from(self.shape.face_count()).ok().map(Estimate::faces)
    }

    fn cost(&self, _inputs: &[NamedMesh]) -> usize {
        usize::try_from(self.shape.face_count()).unwrap_or(usize::MAX)
    }

    fn is_for_each_object(&self) -> bool {
        false
    }

    fn objects(&self, place: &Place<'_>) -> Result<Vec<ObjectId>, Problem> {
        match place.object {
            Some(_) => Err(Problem::of_field("object", "does not go with this op, which makes an object")),
            None => Ok(Vec::new()),
        }
    }

    fn commit(&self) -> Commit {
        if self.add { Commit::NewObject } else { Commit::NewDocument }
    }
}
