//! Faces gathered into polygon soup, with the attributes of their corners.

use super::source::Source;
use crate::notes::{Fault, Notes};
use crate::soup::corner_colors::CornerColors;
use crate::soup::holes;
use crate::soup::placement::Placement;
use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Column, Key};
use halfedge::words::counted;
use halfedge::{NONE, PolygonSoup, keys};
use std::rc::Rc;

/// An attribute of corners: where its index is in a corner's group of numbers, and its values.
pub(super) type Input = (usize, Rc<Source>);

/// What the numbers of a corner refer to.
pub(super) struct Inputs {
    /// How many numbers a corner has.
    pub stride: usize,
    /// Which of them is the vertex.
    pub vertex: usize,
    pub uv: Option<Input>,
    pub normal: Option<Input>,
    pub color: Option<Input>,
}

/// The faces of a geometry so far.
pub(super) struct Faces<'p> {
    pub soup: PolygonSoup,
    placement: &'p Placement,
    /// Whether faces run the other way round.
    is_mirrored: bool,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    /// Red, green, blue and alpha.
    colors: Vec<[f32; 4]>,
    /// Faces left out because a corner has no vertex.
    without_vertex: usize,
    /// Corners that refer to an attribute that doesn't exist.
    bad_uvs: usize,
    bad_normals: usize,
    bad_colors: usize,
    /// Polygons that had holes: how many were cut into triangles round them, and of how many the holes
    /// were filled.
    cut: usize,
    filled: usize,
}

impl<'p> Faces<'p> {
    pub(super) fn new(positions: Vec<Vec3>, placement: &'p Placement) -> Self {
        Self {
            soup: PolygonSoup { positions, ..PolygonSoup::default() },
            placement,
            is_mirrored: placement.is_mirrored(),
            uvs: Vec::new(),
            normals: Vec::new(),
            colors: Vec::new(),
            without_vertex: 0,
            bad_uvs: 0,
            bad_normals: 0,
            bad_colors: 0,
            cut: 0,
            filled: 0,
        }
    }

    /// Adds a face by the numbers of its corners, unless one of them has no vertex.
    pub(super) fn add(&mut self, indices: &[u32], inputs: &Inputs) {
        let groups = indices.chunks_exact(inputs.stride);
        let vertices = self.soup.positions.len();
        let has_vertex = |group: &[u32]| group.get(inputs.vertex).is_some_and(|&v| (v as usize) < vertices);
        if !groups.clone().all(has_vertex) {
            self.without_vertex += 1;
            return;
        }
        let count = groups.len();
        for i in 0..count {
            // Backwards from the same first corner where the placement mirrors.
            let place = if self.is_mirrored && i > 0 { count - i } else { i };
            let Some(group) = groups.clone().nth(place) else { continue };
            self.corner(group, inputs);
        }
        if count > 0 {
            self.soup.face_starts.push(self.soup.corners.len() as u32);
        }
    }

    fn corner(&mut self, group: &[u32], inputs: &Inputs) {
        let number = |place: usize| group.get(place).copied().unwrap_or(NONE) as usize;
        let corner = self.soup.corners.len();
        let vertex = number(inputs.vertex);
        self.soup.corners.push(vertex as u32);
        if let Some((place, source)) = &inputs.uv {
            let uv = source.get::<2>(number(*place));
            self.bad_uvs += usize::from(uv.is_none());
            self.uvs.resize(corner, Vec2::NAN);
            self.uvs.push(uv.map_or(Vec2::NAN, Vec2::from_array));
        }
        if let Some((place, source)) = &inputs.normal {
            let normal = source.get::<3>(number(*place));
            self.bad_normals += usize::from(normal.is_none());
            let normal = normal.map_or(Vec3::NAN, |normal| self.placement.direction(vertex, normal.into()));
            self.normals.resize(corner, Vec3::NAN);
            self.normals.push(normal);
        }
        if let Some((place, source)) = &inputs.color {
            let color = source.get::<4>(number(*place));
            self.bad_colors += usize::from(color.is_none());
            let [r, g, b, a] = color.unwrap_or([f32::NAN; 4]);
            self.colors.resize(corner, [f32::NAN; 4]);
            self.colors.push([r, g, b, if source.width() < 4 { 1.0 } else { a }]);
        }
    }

    /// Adds a polygon with holes as triangles, or its outline alone where it can't be cut.
    pub(super) fn add_with_holes(&mut self, outline: &[u32], holes: &[Vec<u32>], inputs: &Inputs) {
        let stride = inputs.stride;
        let position = |group: &[u32]| {
            let vertex = group.get(inputs.vertex).copied().unwrap_or(NONE);
            self.soup.positions.get(vertex as usize).copied().unwrap_or(Vec3::NAN)
        };
        let ring = |indices: &[u32]| -> Vec<Vec3> { indices.chunks_exact(stride).map(position).collect() };
        let rings: Vec<Vec<Vec3>> = holes.iter().map(|hole| ring(hole)).collect();
        let Some(triangles) = holes::cut(&ring(outline), &rings) else {
            self.filled += 1;
            return self.add(outline, inputs);
        };
        self.cut += 1;
        let holes = holes.iter().flat_map(|hole| hole.chunks_exact(stride));
        let groups: Vec<&[u32]> = outline.chunks_exact(stride).chain(holes).collect();
        let mut corners: Vec<u32> = Vec::with_capacity(3 * stride);
        for triangle in triangles {
            corners.clear();
            corners.extend(triangle.iter().filter_map(|&i| groups.get(i as usize)).copied().flatten());
            self.add(&corners, inputs);
        }
    }

    /// Whether faces were left out because of their vertices.
    pub(super) fn has_faults(&self) -> bool {
        self.without_vertex > 0
    }

    /// The soup with columns for the attributes that corners have. `vertex_colors` are those of vertices,
    /// for vertices in no face; `can_color_faces` says that nothing else gives faces their colours. `label`
    /// names the geometry in notes.
    pub(super) fn finish(
        mut self,
        label: &str,
        vertex_colors: Option<&Source>,
        can_color_faces: bool,
        notes: &mut Notes,
    ) -> PolygonSoup {
        self.note_faults(label, notes);
        let corners = self.soup.corners.len();
        let mut add = |column: Option<Column>| self.soup.corner_columns.extend(column);
        add(column(keys::CORNER_UV, self.uvs, corners, |uv| uv.is_nan()));
        add(column(keys::CORNER_NORMAL, self.normals, corners, |normal| normal.is_nan()));
        if !self.colors.is_empty() || vertex_colors.is_some() {
            self.colors.resize(corners, [f32::NAN; 4]);
            let of_vertex = |v: usize| vertex_colors?.get::<3>(v).map(Vec3::from_array);
            let colors = CornerColors { corners: &self.colors, vertices: &of_vertex, can_color_faces };
            colors.add_to(&mut self.soup, &format!("geometry \"{label}\""), notes);
        }
        self.soup
    }

    fn note_faults(&self, label: &str, notes: &mut Notes) {
        if self.without_vertex > 0 {
            let faces = counted(self.without_vertex, "face", "faces");
            let vertices = self.soup.positions.len();
            notes.fault(
                Fault::Faces,
                format!("geometry \"{label}\": {faces} with a vertex that doesn't exist (of {vertices})"),
            );
        }
        for (count, what) in [
            (self.bad_uvs, "texture coordinates"),
            (self.bad_normals, "normals"),
            (self.bad_colors, "colours"),
        ] {
            if count > 0 {
                let corners = counted(count, "corner", "corners");
                notes.fault(
                    Fault::Attribute,
                    format!(
                        "geometry \"{label}\": {corners} without {what} (their indices are out of range)"
                    ),
                );
            }
        }
        let polygons = |count: usize| counted(count, "polygon", "polygons");
        if self.cut > 0 {
            let cut = polygons(self.cut);
            notes.info(format!(
                "Geometry \"{label}\": {cut} with holes cut into triangles: faces have one outline here"
            ));
        }
        if self.filled > 0 {
            let filled = polygons(self.filled);
            notes.fault(
                Fault::Attribute,
                format!(
                    "geometry \"{label}\": the holes of {filled} were filled (they cross an outline, or there are \
                     too many corners)"
                ),
            );
        }
    }
}

/// A column of corners, filled up at the end; none where no corner has a value.
fn column<T: AttributeType>(
    key: Key<T>,
    mut values: Vec<T>,
    corners: usize,
    is_missing: impl Fn(&T) -> bool,
) -> Option<Column> {
    if values.iter().all(is_missing) {
        return None;
    }
    values.resize(corners, key.default);
    Some(Column::with_values(key, values))
}
