//! `transform`: move, rotate and scale elements; what the gizmo sends.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, Arity, DefaultValue, Drag, EdgeRef, FaceRef, Field, FieldKind, LocalEdit, Mirroring, Operation,
    SYMMETRY, Scope, Selected, Slot, Spec, Unit, VertexRef,
};
use crate::script::json::{finite, finite_option, finite3, finite3_option, shortest};
use glam::{Affine3A, Mat3A, Quat, Vec3};
use halfedge::edit::Refusal;
use halfedge::geometry::{UnionFind, mean_position};
use halfedge::{Element, Mesh, NumberRange, VertexId};
use serde::de::{Deserializer, Error};
use serde::{Deserialize, Serialize, Serializer};
use std::collections::BTreeMap;

/// Scale and rotate elements about a pivot, then move them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Default)]
pub struct Transform {
    /// Vertices to move. When no elements are given at all, the selected ones are moved.
    pub vertices: Option<Vec<VertexRef>>,
    /// Edges whose ends to move.
    pub edges: Option<Vec<EdgeRef>>,
    /// Faces whose corners to move.
    pub faces: Option<Vec<FaceRef>>,
    /// How far to move, in mesh units.
    #[serde(with = "finite3")]
    pub translate: [f32; 3],
    /// How to rotate about the pivot.
    pub rotate: Option<Rotate>,
    /// By how much to scale about the pivot.
    pub scale: Scale,
    /// How the axes of the scale are turned; they are the mesh's when left out.
    pub orientation: Option<Rotate>,
    /// Rotate and scale each connected part of the elements about its own middle, not all about the pivot.
    #[serde(default)]
    pub individual: bool,
    /// What stays in place when scaling and rotating; the mean of the moved vertices when left out.
    #[serde(default, with = "finite3_option")]
    pub pivot: Option<[f32; 3]>,
    /// Soft selection: vertices within this distance along the surface move too, less the farther
    /// they are.
    #[serde(default, with = "finite_option")]
    pub falloff: Option<f32>,
}

/// A rotation about an axis, counter-clockwise as seen from its tip.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rotate {
    /// The axis; its length doesn't matter.
    #[serde(with = "finite3")]
    pub axis: [f32; 3],
    /// The angle.
    #[serde(with = "finite")]
    pub degrees: f32,
}

/// A factor per axis; in JSON one number stands for three equal ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale(pub [f32; 3]);

impl Default for Scale {
    fn default() -> Self {
        Self([1.0; 3])
    }
}

impl Serialize for Scale {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            [x, y, z] if x == y && y == z => finite::serialize(&x, serializer),
            factors => finite3::serialize(&factors, serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Scale {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = serde_json::Value::deserialize(deserializer)?;
        let factors = match value {
            serde_json::Value::Array(_) => finite3::deserialize(value),
            value => finite::deserialize(value).map(|factor| [factor; 3]),
        };
        factors.map(Self).map_err(D::Error::custom)
    }
}

const EDGES: FieldKind = FieldKind::Elements { element: Element::Edge, arity: Arity::Many };
const FACES: FieldKind = FieldKind::Elements { element: Element::Face, arity: Arity::Many };

/// Moving a vertex is this much less work than linking a face.
const VERTICES_MOVED_PER_FACE_LINKED: usize = 16;

impl Operation for Transform {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "transform", "Transform", "Move, rotate and scale elements.")
            .synonyms(&["move", "rotate", "scale", "grab", "translate"])
            .fields(&[
                Field::many("vertices", Element::Vertex, Selected::Vertices, "Vertices to move"),
                Field::required("edges", EDGES, "Edges whose ends to move").optional("none"),
                Field::required("faces", FACES, "Faces whose corners to move").optional("none"),
                Field::required("translate", FieldKind::Vector, "How far to move, in mesh units")
                    .or(DefaultValue::Vector([0.0; 3]))
                    .drag(Drag::Offset),
                Field::required("rotate", FieldKind::Rotation, "How to rotate about the pivot")
                    .unset("no rotation")
                    .drag(Drag::Rotation),
                Field::required("scale", FieldKind::Factors, "The factor by which to scale about the pivot")
                    .or(DefaultValue::Factor(1.0))
                    .drag(Drag::Factors),
                Field::required("orientation", FieldKind::Rotation, "How the axes of the scale are turned")
                    .unset("the axes of the mesh"),
                Field::required(
                    "individual",
                    FieldKind::Flag,
                    "Rotate and scale each connected part about its own middle, not about the pivot",
                )
                .or(DefaultValue::Flag(false)),
                Field::required("pivot", FieldKind::Vector, "The point that stays in place")
                    .unset("the centre of the vertices"),
                Field::number(
                    "falloff",
                    Unit::Length,
                    NumberRange::NOT_NEGATIVE,
                    "Soft selection: how far along the surface other vertices move too",
                )
                .unset("none"),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertices(&mut self.vertices), Slot::Edges(&mut self.edges), Slot::Faces(&mut self.faces)]
    }

    const MIRRORING: Mirroring = Mirroring::Moves;

    fn pair(&mut self, _image: Self, _mesh: &Mesh) -> Option<Self> {
        None
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl Transform {
    /// What it does, if that is one thing.
    pub(crate) fn label(&self) -> &'static str {
        let moves = self.translate != [0.0; 3];
        let rotates = self.rotate.is_some_and(|rotate| rotate.degrees != 0.0);
        let scales = self.scale != Scale::default();
        match (moves, rotates, scales) {
            (true, false, false) => "Move",
            (false, true, false) => "Rotate",
            (false, false, true) => "Scale",
            _ => Self::SPEC.label,
        }
    }
}

impl LocalEdit for Transform {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        self.check()?;
        let vertices = self.moved(mesh)?;
        self.map(self.pivot(mesh, &vertices)).map(drop)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        self.check()?;
        let vertices = self.moved(mesh)?;
        let parts = if self.individual { self.connected_parts(mesh, &vertices)? } else { vec![vertices] };
        let mut moves = Vec::new();
        for part in parts {
            let map = self.map(self.pivot(mesh, &part))?;
            let weights = match self.falloff {
                Some(radius) if radius > 0.0 => surface::soft_selection(mesh, &part, radius),
                _ => part.into_iter().map(|v| (v, 1.0)).collect(),
            };
            moves.extend(weights.into_iter().map(|(v, weight)| {
                let old = mesh.position(v);
                let by = if self.is_translation() {
                    Vec3::from(self.translate)
                } else {
                    map.transform_point3(old) - old
                };
                (v, by * weight)
            }));
        }
        let mut rounding = Rounding::default();
        // Within the radius of several parts, a vertex follows each of them.
        for (v, by) in moves {
            let new = mesh.position(v) + by;
            if !new.is_finite() {
                return Err(Problem::new(format!("{v} would get a position that is not finite")));
            }
            rounding.add(mesh.position(v), by, new);
            mesh.set_position(v, new);
        }
        notes.extend(rounding.note());
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        let given = count(&self.vertices, 0) + count(&self.edges, 0) + count(&self.faces, 0);
        given / VERTICES_MOVED_PER_FACE_LINKED
    }
}

/// How far single precision rounds the moves of vertices.
#[derive(Default)]
struct Rounding {
    /// The coarsest spacing of coordinates where a move was rounded.
    spacing: f32,
}

impl Rounding {
    /// The part of a move by which rounding may change it unnoticed.
    const TOLERANCE: f32 = 0.01;

    fn add(&mut self, old: Vec3, by: Vec3, new: Vec3) {
        let error = (new.as_dvec3() - old.as_dvec3() - by.as_dvec3()).abs().max_element();
        if error > f64::from(by.abs().max_element() * Self::TOLERANCE) {
            let far = old.abs().max_element().max(new.abs().max_element());
            self.spacing = self.spacing.max(far.next_up() - far);
        }
    }

    fn note(&self) -> Option<String> {
        (self.spacing > 0.0).then(|| {
            format!(
                "Some vertices moved by more or less than asked, because so far from the origin positions are {} apart. Move \
                 the model closer to the origin to edit it finely",
                shortest(self.spacing)
            )
        })
    }
}

impl Transform {
    /// Refuses fields that can't be carried out, or not together.
    fn check(&self) -> Result<(), Problem> {
        match self.pivot {
            Some(_) if self.individual => Err(Problem::of_field(
                "pivot",
                "does not go with `individual`, which turns each part about its own middle: leave one of them out",
            )
            .advise("Pivot does not go with individual parts, which turn about their own middles. Leave one of them out.")),
            _ => Ok(()),
        }
    }

    /// The vertices of the given elements, each once, in order of id.
    fn moved(&self, mesh: &Mesh) -> Result<Vec<VertexId>, Problem> {
        let mut vertices = all(&self.vertices, "vertices", mesh)?;
        for e in all(&self.edges, "edges", mesh)? {
            vertices.extend(mesh.ends(e));
        }
        for f in all(&self.faces, "faces", mesh)? {
            vertices.extend(mesh.face_vertices(f));
        }
        vertices.sort_unstable();
        vertices.dedup();
        if vertices.is_empty() { Err(Refusal::NothingGiven(Element::Vertex).into()) } else { Ok(vertices) }
    }

    fn pivot(&self, mesh: &Mesh, vertices: &[VertexId]) -> Vec3 {
        self.pivot.map_or_else(|| mean_position(mesh, vertices.iter().copied()).as_vec3(), Vec3::from)
    }

    /// The moved vertices in parts, each in order of id: a given edge or face connects its vertices, and given
    /// vertices are connected by the edges between them.
    fn connected_parts(&self, mesh: &Mesh, vertices: &[VertexId]) -> Result<Vec<Vec<VertexId>>, Problem> {
        let mut sets = UnionFind::new(vertices.len());
        let mut connect = |a: VertexId, b: VertexId| {
            if let (Ok(a), Ok(b)) = (vertices.binary_search(&a), vertices.binary_search(&b)) {
                sets.union(a as u32, b as u32);
            }
        };
        let mut given = all(&self.vertices, "vertices", mesh)?;
        given.sort_unstable();
        for &v in &given {
            mesh.neighbors(v).filter(|to| given.binary_search(to).is_ok()).for_each(|to| connect(v, to));
        }
        for e in all(&self.edges, "edges", mesh)? {
            let [a, b] = mesh.ends(e);
            connect(a, b);
        }
        for f in all(&self.faces, "faces", mesh)? {
            mesh.face_halfedges(f).for_each(|h| connect(mesh.from(h), mesh.to(h)));
        }
        let mut parts: BTreeMap<u32, Vec<VertexId>> = BTreeMap::new();
        for (at, &v) in vertices.iter().enumerate() {
            parts.entry(sets.find(at as u32)).or_default().push(v);
        }
        Ok(parts.into_values().collect())
    }

    fn is_translation(&self) -> bool {
        self.rotate.is_none() && self.scale == Scale::default()
    }

    /// Scale, then rotate, about the pivot; then move.
    fn map(&self, pivot: Vec3) -> Result<Affine3A, Problem> {
        let translate = Vec3::from(self.translate);
        if self.is_translation() {
            // Exactly what was asked for, whatever the pivot.
            return Ok(Affine3A::from_translation(translate));
        }
        let rotation = Mat3A::from_quat(quaternion(self.rotate, "rotate.axis")?);
        let mut scale = Mat3A::from_diagonal(self.scale.0.into());
        if self.orientation.is_some() {
            let axes = Mat3A::from_quat(quaternion(self.orientation, "orientation.axis")?);
            scale = axes * scale * axes.transpose();
        }
        let matrix = rotation * scale;
        Ok(Affine3A::from_mat3_translation(matrix.into(), translate + pivot - matrix * pivot))
    }
}

/// The rotation as a quaternion; `field` is what an error names.
fn quaternion(rotate: Option<Rotate>, field: &str) -> Result<Quat, Problem> {
    let Some(Rotate { axis, degrees }) = rotate else { return Ok(Quat::IDENTITY) };
    // The square of a large axis overflows in single precision.
    let long = || Some(Vec3::from(axis).as_dvec3().try_normalize()?.as_vec3());
    let axis = Vec3::from(axis)
        .try_normalize()
        .or_else(long)
        .ok_or_else(|| Problem::of_field(field, "is too short to give a direction"))?;
    Ok(Quat::from_axis_angle(axis, degrees.to_radians()))
}
