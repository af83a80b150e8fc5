//! What an OFF holds, before it is made a mesh.

use crate::report::{ImportReport, Places};
use crate::soup::of_vertices;
use glam::{Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Color, PolygonSoup, keys};

/// What a vertex has besides its position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct VertexExtras {
    pub normal: Option<Vec3>,
    /// Red, green and blue as the file has them, out of 1 or out of 255.
    pub color: Option<Vec3>,
    pub uv: Option<Vec2>,
}

/// The colour of a face as the file has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FaceColor {
    pub channels: Vec3,
    /// Whether its numbers have decimal points: whole numbers are out of 255.
    pub has_points: bool,
}

/// Positions, faces and their attributes.
#[derive(Default)]
pub(super) struct Contents {
    pub soup: PolygonSoup,
    /// Per vertex, as far as any was given: NaN where none was. Likewise `colors` and `uvs`.
    normals: Vec<Vec3>,
    colors: Vec<Vec3>,
    uvs: Vec<Vec2>,
    /// Per face.
    face_colors: Vec<Option<FaceColor>>,
    pub troubles: Troubles,
}

/// What could not be read or is not kept, by the number of the vertex or face.
#[derive(Default)]
pub(super) struct Troubles {
    pub bad_vertices: Places,
    pub incomplete_vertices: Places,
    pub long_vertices: Places,
    pub divided_vertices: Places,
    pub more_dimensions: Places,
    pub bad_faces: Places,
    pub long_faces: Places,
    /// Colours that are places in a table.
    pub palette: Places,
    /// Opacities below full.
    pub opacities: Places,
}

impl Contents {
    /// Adds a vertex; one that can't be read lies at the origin.
    pub(super) fn push_vertex(&mut self, position: Option<Vec3>, extras: VertexExtras) {
        let number = self.soup.positions.len();
        if position.is_none() {
            self.troubles.bad_vertices.add(number);
        }
        self.soup.positions.push(position.unwrap_or_default());
        push_at(&mut self.normals, number, extras.normal, Vec3::NAN);
        push_at(&mut self.colors, number, extras.color, Vec3::NAN);
        push_at(&mut self.uvs, number, extras.uv, Vec2::NAN);
    }

    /// Adds a face whose corners are in the soup already.
    pub(super) fn end_face(&mut self, color: Option<FaceColor>) {
        self.soup.face_starts.push(self.soup.corners.len() as u32);
        self.face_colors.push(color);
    }

    /// Whether there are vertices and none can be read.
    pub(super) fn is_unreadable(&self) -> bool {
        let count = self.soup.positions.len();
        count > 0 && self.troubles.bad_vertices.count() == count
    }

    /// The soup with all attributes, and what there is to say.
    pub(super) fn finish(mut self, report: &mut ImportReport) -> PolygonSoup {
        self.troubles.report(report);
        // A normal of no length is none.
        self.normals
            .iter_mut()
            .filter(|normal| **normal == Vec3::ZERO)
            .for_each(|normal| *normal = Vec3::NAN);
        if self.normals.iter().any(|normal| !normal.is_nan()) {
            self.soup.corner_columns.push(of_vertices(&self.soup, keys::CORNER_NORMAL, &self.normals));
        }
        if self.uvs.iter().any(|uv| !uv.is_nan()) {
            self.soup.corner_columns.push(of_vertices(&self.soup, keys::CORNER_UV, &self.uvs));
        }
        if self.colors.iter().any(|color| !color.is_nan()) {
            // Channels above 1 are out of 255, and so are all others of the file.
            let is_bytes = self.colors.iter().any(|color| color.max_element() > 1.0);
            let full = if is_bytes { 255.0 } else { 1.0 };
            let mut colors: Vec<Vec3> = self.colors.iter().map(|&color| color / full).collect();
            colors.resize(self.soup.positions.len(), Vec3::NAN);
            self.soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
        }
        let has_fractions = self.face_colors.iter().flatten().any(|color| color.has_points);
        let color = |color: &Option<FaceColor>| {
            let Some(FaceColor { channels, has_points }) = *color else { return Color::UNPAINTED };
            let is_fraction = has_points || has_fractions;
            let full = if is_fraction && channels.max_element() <= 1.0 { 255.0 } else { 1.0 };
            Color((channels * full).to_array().map(|c| c.round().clamp(0.0, 255.0) as u8))
        };
        let face_colors: Vec<Color> = self.face_colors.iter().map(color).collect();
        if face_colors.iter().any(|&color| color != Color::UNPAINTED) {
            self.soup.face_columns.push(Column::with_values(keys::FACE_COLOR, face_colors));
        }
        self.soup
    }
}

/// Puts a value at a place past the end, with `missing` in between; no value changes nothing.
fn push_at<T: Copy>(values: &mut Vec<T>, place: usize, value: Option<T>, missing: T) {
    if let Some(value) = value {
        values.resize(place, missing);
        values.push(value);
    }
}

impl Troubles {
    fn report(&self, report: &mut ImportReport) {
        let notes = [
            (&self.bad_vertices, "vertex", "vertices", "put at the origin: not three numbers"),
            (
                &self.incomplete_vertices,
                "vertex",
                "vertices",
                "without normal, colour or texture coordinates, although the first line of the file says that it has \
                 them",
            ),
            (
                &self.long_vertices,
                "vertex",
                "vertices",
                "with numbers that have no meaning, which are left out",
            ),
            (
                &self.more_dimensions,
                "vertex",
                "vertices",
                "with more than three coordinates: only three are kept",
            ),
            (&self.bad_faces, "face", "faces", "left out: not a count and as many vertex numbers"),
            (&self.long_faces, "face", "faces", "with numbers that are no colour, which are left out"),
        ];
        for (places, one, many, what) in notes {
            if !places.is_empty() {
                report.warn(places.sentence(one, many, what, "number"));
            }
        }
        let notes = [
            (
                &self.palette,
                "colour",
                "colours",
                "left out: a place in a table of colours that is not in the file",
            ),
            (&self.opacities, "opacity", "opacities", "left out: colours are opaque here"),
            (
                &self.divided_vertices,
                "vertex",
                "vertices",
                "with a fourth coordinate (w), by which the others were divided",
            ),
        ];
        for (places, one, many, what) in notes {
            if !places.is_empty() {
                report.info(places.sentence(one, many, what, "number"));
            }
        }
    }
}
