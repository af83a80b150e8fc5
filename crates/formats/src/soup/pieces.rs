//! Several objects as one mesh, for formats that hold one.

use crate::model::Model;
use glam::{DVec3, Vec2, Vec3};
use halfedge::attribute::{AttributeType, Key};
use halfedge::{Color, FaceId, Mesh, keys};
use std::borrow::Cow;

/// Compact meshes whose vertex numbers continue from one to the next.
pub(crate) struct Pieces<'a> {
    /// The meshes, each with the number of its first vertex in the file.
    pub meshes: Vec<(Cow<'a, Mesh>, u64)>,
    /// The offset of all positions.
    offset: DVec3,
    /// The number of vertices of all meshes.
    pub vertices: u64,
    /// The number of faces of all meshes.
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

    /// All positions in order, each with the offset to add.
    pub(crate) fn positions(&self) -> impl Iterator<Item = (Vec3, DVec3)> + '_ {
        let positions = self.meshes.iter().flat_map(|(mesh, _)| mesh.positions());
        positions.map(|&position| (position, self.offset))
    }

    /// Whether there is an offset, which needs numbers in double precision.
    pub(crate) fn is_far(&self) -> bool {
        self.offset != DVec3::ZERO && !self.meshes.is_empty()
    }

    /// All faces in order, each with its mesh and the number of that mesh's first vertex.
    pub(crate) fn faces(&self) -> impl Iterator<Item = (&Mesh, u64, FaceId)> + '_ {
        self.meshes.iter().flat_map(|(mesh, first)| mesh.faces().map(move |f| (mesh.as_ref(), *first, f)))
    }

    /// The colours of all vertices, white for those without; `None` if no vertex has one.
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

    /// The normals of all vertices, zero for isolated ones; `None` if a corner has none or corners of a vertex
    /// differ.
    pub(crate) fn vertex_normals(&self) -> Option<Vec<Vec3>> {
        self.uniform(keys::CORNER_NORMAL, |normal| normal.is_nan(), Vec3::ZERO)
    }

    /// The texture coordinates of all vertices, zero for isolated ones; `None` if a corner has none or corners of
    /// a vertex differ.
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

    /// Whether any corner has a texture coordinate.
    pub(crate) fn has_uvs(&self) -> bool {
        let has = |mesh: &Mesh| {
            mesh.attribute(keys::CORNER_UV).is_some_and(|uvs| uvs.iter().any(|uv| !uv.is_nan()))
        };
        self.meshes.iter().any(|(mesh, _)| has(mesh))
    }

    /// The colours of all faces; `None` if no face is painted.
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
