//! Collects primitives into polygon soup with corner attributes.

use super::material::FaceMaterial;
use super::morph::Steps;
use super::primitive::Mode;
use super::rows::Rows;
use crate::model::collector::{Paint, face_columns};
use crate::model::srgb::to_srgb;
use crate::notes::Notes;
use crate::soup::corner_colors::CornerColors;
use crate::soup::hash::Unique;
use crate::soup::origin::Origin;
use crate::soup::placement::Placement;
use glam::{DVec3, Vec2, Vec3};
use halfedge::attribute::{AttributeType, Column, Key};
use halfedge::{NONE, PolygonSoup, keys};
use std::rc::Rc;

/// The vertex data of a primitive.
pub(super) struct Vertices<'b> {
    pub positions: Rows<'b>,
    pub position_steps: Steps<'b>,
    pub colors: Option<Rows<'b>>,
    /// The numbers that our files give vertices where several share a position.
    pub ids: Option<Rows<'b>>,
    pub placement: Placement,
}

/// The corner data of a primitive.
pub(super) struct Corners<'b> {
    pub indices: Option<Rows<'b>>,
    pub uvs: Option<Rows<'b>>,
    pub uv_steps: Steps<'b>,
    pub normals: Option<Rows<'b>>,
    pub normal_steps: Steps<'b>,
    pub colors: Option<Rows<'b>>,
    pub color_steps: Steps<'b>,
}

/// The faces of a mesh while it is read.
pub(super) struct Faces {
    soup: PolygonSoup,
    pub origin: Option<Origin>,
    /// Vertices by position and number.
    unique: Unique<4>,
    /// One colour for each vertex; counts for vertices in no face.
    vertex_colors: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    colors: Vec<[f32; 4]>,
    /// For each face the index of its material in `palette`.
    materials: Vec<u32>,
    palette: Vec<Rc<FaceMaterial>>,
}

impl Faces {
    pub(super) fn new(origin: Option<Origin>) -> Self {
        Self {
            soup: PolygonSoup::default(),
            origin,
            unique: Unique::new(),
            vertex_colors: Vec::new(),
            uvs: Vec::new(),
            normals: Vec::new(),
            colors: Vec::new(),
            materials: Vec::new(),
            palette: Vec::new(),
        }
    }

    /// Adds the vertices of a primitive and returns the number of each row's vertex. Rows at the same
    /// position become one vertex, as files split vertices where corners differ.
    pub(super) fn add_vertices(&mut self, vertices: &Vertices) -> Vec<u32> {
        (0..vertices.positions.count).map(|row| self.vertex(vertices, row)).collect()
    }

    fn vertex(&mut self, vertices: &Vertices, row: usize) -> u32 {
        let own = DVec3::from(vertices.position_steps.added(row, vertices.positions.row(row)));
        let placement = &vertices.placement;
        // Multiplying by the identity would turn -0 into 0.
        let place = match placement.is_identity() {
            true => own,
            false => placement.of(row).transform_point3(own),
        };
        let told_by = if matches!(placement, Placement::Rigid(_)) { own } else { place };
        let id = vertices.ids.as_ref().map_or(0, |ids| u32::from_le_bytes(ids.row(row).map(|b| b as u8)));
        // Adding zero turns -0 into 0.
        let [x, y, z] = (told_by.as_vec3() + Vec3::ZERO).to_array();
        let (number, is_new) = self.unique.number([x, y, z, f32::from_bits(id)]);
        if is_new {
            self.soup.positions.push(match &mut self.origin {
                Some(origin) => origin.place(place),
                None => place.as_vec3(),
            });
            let color = vertices.colors.as_ref().filter(|colors| row < colors.count);
            let color = color.map_or(Vec3::NAN, |colors| Vec3::from_array(colors.floats(row).map(to_srgb)));
            self.vertex_colors.push(color);
        }
        number
    }

    /// Adds the triangles of a primitive. `numbers` are those that `add_vertices` returned. Returns how many
    /// triangles were left out because a corner refers to no vertex.
    pub(super) fn add_triangles(
        &mut self,
        mode: Mode,
        corners: &Corners,
        numbers: &[u32],
        placement: &Placement,
        material: Option<Rc<FaceMaterial>>,
    ) -> usize {
        let count = corners.indices.as_ref().map_or(numbers.len(), |indices| indices.count);
        let index = |i: usize| corners.indices.as_ref().map_or(i as u32, |indices| indices.index(i)) as usize;
        let material = material.map_or(NONE, |material| {
            self.palette.push(material);
            self.palette.len() as u32 - 1
        });
        // Mirroring turns triangles over, so their order is reversed to keep the front at the front.
        let is_mirrored = placement.is_mirrored();
        let mut left_out = 0;
        for [a, b, c] in mode.triangles(count) {
            let rows = if is_mirrored { [a, c, b] } else { [a, b, c] }.map(index);
            let vertices = rows.map(|row| numbers.get(row).copied().unwrap_or(NONE));
            if vertices.contains(&NONE) {
                left_out += 1;
                continue;
            }
            for (row, vertex) in rows.into_iter().zip(vertices) {
                self.corner(corners, placement, row, vertex);
            }
            self.soup.face_starts.push(self.soup.corners.len() as u32);
            self.materials.push(material);
        }
        left_out
    }

    fn corner(&mut self, corners: &Corners, placement: &Placement, row: usize, vertex: u32) {
        let at = self.soup.corners.len();
        self.soup.corners.push(vertex);
        let has = |rows: &&Rows| row < rows.count;
        if let Some(uvs) = corners.uvs.as_ref().filter(has) {
            let [u, v] = corners.uv_steps.added(row, uvs.row(row)).map(|value| value as f32);
            self.uvs.resize(at, Vec2::NAN);
            // In files v counts from the top of the image.
            self.uvs.push(Vec2::new(u, 1.0 - v));
        }
        if let Some(normals) = corners.normals.as_ref().filter(has) {
            let normal = normals.row(row);
            let normal = match corners.normal_steps.is_empty() {
                true => DVec3::from(normal),
                false => DVec3::from(corners.normal_steps.added(row, normal)).normalize_or_zero(),
            };
            self.normals.resize(at, Vec3::NAN);
            self.normals.push(placement.direction(row, normal.as_vec3()));
        }
        if let Some(colors) = corners.colors.as_ref().filter(has) {
            let color = corners.color_steps.added(row, colors.row(row)).map(|value| value as f32);
            let [r, g, b, a] = color;
            let [r, g, b] = [r, g, b].map(to_srgb);
            self.colors.resize(at, [f32::NAN; 4]);
            self.colors.push([r, g, b, if colors.width < 4 { 1.0 } else { a }]);
        }
    }

    /// The soup with columns for the attributes. `label` names the mesh in notes.
    pub(super) fn finish(mut self, label: &str, notes: &mut Notes) -> PolygonSoup {
        let corners = self.soup.corners.len();
        let uvs = column(keys::CORNER_UV, self.uvs, corners);
        let normals = column(keys::CORNER_NORMAL, self.normals, corners);
        self.soup.corner_columns.extend([uvs, normals].into_iter().flatten());
        let paints: Vec<&Paint> = self.palette.iter().map(|material| &material.paint).collect();
        self.soup.face_columns = face_columns(&paints, &self.materials);
        let has_color = |color: &Vec3| !color.is_nan();
        if self.vertex_colors.iter().any(has_color) {
            self.colors.resize(corners, [f32::NAN; 4]);
            let of_vertex = |v: usize| self.vertex_colors.get(v).copied();
            let can_color_faces = paints.iter().all(|paint| paint.color.is_none());
            let colors = CornerColors { corners: &self.colors, vertices: &of_vertex, can_color_faces };
            colors.add_to(&mut self.soup, label, notes);
        }
        self.soup
    }
}

/// A column of corners, if there is anything for it. Corners at the end may have no values.
fn column<T: AttributeType>(key: Key<T>, mut values: Vec<T>, corners: usize) -> Option<Column> {
    if values.is_empty() {
        return None;
    }
    values.resize(corners, key.default);
    Some(Column::with_values(key, values))
}
