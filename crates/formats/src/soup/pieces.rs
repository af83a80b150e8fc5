//! Several objects written as one mesh, for formats that hold one.

use crate::model::Model;
use glam::{DVec3, Vec2, Vec3};
use halfedge::attribute::{AttributeType, Key};
use halfedge::{Color, FaceId, Mesh, keys};
use std::borrow::Cow;

/// Compact meshes that are numbered on from each other.
pub(crate) struct Pieces<'a> {
    /// The meshes, each with the number of its first vertex.
    pub meshes: Vec<(Cow<'a, Mesh>, u64)>,
    /// What to add to positions.
    offset: DVec3,
    /// How many vertices all have.
    pub vertices: u64,
    /// How many faces all have.
    pub faces: u64,
}

impl<'a> Pieces<'a> {
    pub(crate) fn new(model: &'a Model) -> Self {
        let mut pieces = Self {
            meshes: Vec::with_capacity(model.objects.len()),
            offset: model.offset,
            vertices: 0,
            faces: 0,
        };
        for object in &model.objects {
            let mesh = object.mesh.to_compact();
            let first = pieces.vertices;
            pieces.vertices += mesh.vertex_count() as u64;
            pieces.faces += mesh.face_count() as u64;
            pieces.meshes.push((mesh, first));
        }
        pieces
    }

    /// All positions in order, each with what is to be added to it.
    pub(crate) fn positions(&self) -> impl Iterator<Item = (Vec3, DVec3)> + '_ {
        let positions = self.meshes.iter().flat_map(|(mesh, _)| mesh.positions());
        positions.map(|&position| (position, self.offset))
    }

    /// Whether something is to be added to positions, which takes numbers in double precision.
    pub(crate) fn is_far(&self) -> bool {
        self.offset != DVec3::ZERO && !self.meshes.is_empty()
    }

    /// All faces in order, each with its mesh and the number of that mesh's first vertex.
    pub(crate) fn faces(&self) -> impl Iterator<Item = (&Mesh, u64, FaceId)> + '_ {
        self.meshes.iter().flat_map(|(mesh, first)| mesh.faces().map(move |f| (mesh.as_ref(), *first, f)))
    }

    /// The colours of all vertices, white where one has none; nothing where none has any.
    pub(crate) fn vertex_colors(&self) -> Option<Vec<Vec3>> {
        let has =
            |mesh: &Mesh| mesh.attribute(keys::VERTEX_COLOR).is_some_and(|c| c.iter().any(|c| !c.is_nan()));
        if !self.meshes.iter().any(|(mesh, _)| has(mesh)) {
            return None;
        }
        let of = |mesh: &Mesh, v: usize| {
            let color = mesh.get(keys::VERTEX_COLOR, v);
            if color.is_nan() { Vec3::ONE } else { color }
        };
        Some(self.meshes.iter().flat_map(|(mesh, _)| (0..mesh.vertex_count()).map(|v| of(mesh, v))).collect())
    }

    /// The normals of all vertices, zero for those in no face; nothing where there are none or
    /// corners of a vertex differ.
    pub(crate) fn vertex_normals(&self) -> Option<Vec<Vec3>> {
        self.uniform(keys::CORNER_NORMAL, |normal| normal.is_nan(), Vec3::ZERO)
    }

    /// The texture coordinates of all vertices, zero for those in no face; nothing where there are
    /// none or corners of a vertex differ.
    pub(crate) fn vertex_uvs(&self) -> Option<Vec<Vec2>> {
        self.uniform(keys::CORNER_UV, |uv| uv.is_nan(), Vec2::ZERO)
    }

    fn uniform<T: AttributeType + PartialEq>(
        &self,
        key: Key<T>,
        is_missing: fn(T) -> bool,
        loose: T,
    ) -> Option<Vec<T>> {
        let mut all = Vec::new();
        for (mesh, _) in &self.meshes {
            all.extend(uniform(mesh, key, is_missing, loose)?);
        }
        (self.faces > 0).then_some(all)
    }

    /// Whether some corner has a texture coordinate.
    pub(crate) fn has_uvs(&self) -> bool {
        let has = |mesh: &Mesh| {
            mesh.attribute(keys::CORNER_UV).is_some_and(|uvs| uvs.iter().any(|uv| !uv.is_nan()))
        };
        self.meshes.iter().any(|(mesh, _)| has(mesh))
    }

    /// The colours of all faces; nothing where none is painted.
    pub(crate) fn face_colors(&self) -> Option<Vec<Color>> {
        let colors: Vec<Color> =
            self.faces().map(|(mesh, _, f)| mesh.get(keys::FACE_COLOR, f.index())).collect();
        colors.iter().any(|&color| color != Color::UNPAINTED).then_some(colors)
    }
}

/// The value that all corners of each vertex have, `loose` for vertices in no face; nothing where
/// corners of a vertex differ, or one has none. By vertex id.
pub(crate) fn uniform<T: AttributeType + PartialEq>(
    mesh: &Mesh,
    key: Key<T>,
    is_missing: impl Fn(T) -> bool,
    loose: T,
) -> Option<Vec<T>> {
    let mut values = vec![loose; mesh.vertex_capacity()];
    let mut met = vec![false; mesh.vertex_capacity()];
    for h in mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)) {
        let value = mesh.get(key, h.index());
        let v = mesh.from(h).index();
        let (slot, met) = values.get_mut(v).zip(met.get_mut(v))?;
        if is_missing(value) || (*met && *slot != value) {
            return None;
        }
        (*slot, *met) = (value, true);
    }
    Some(values)
}
