//! Colours of corners, made those of vertices or faces: meshes have no others.

use crate::model::material::Rgb;
use crate::notes::{Fault, Notes};
use glam::Vec3;
use halfedge::attribute::Column;
use halfedge::{Color, PolygonSoup, keys};

/// The colours of a soup's corners, red, green, blue and alpha in sRGB; `NaN` where a corner has none.
pub(crate) struct CornerColors<'a> {
    pub corners: &'a [[f32; 4]],
    /// Those of vertices, for vertices in no face.
    pub vertices: &'a dyn Fn(usize) -> Option<Vec3>,
    /// Whether nothing else gives faces their colours.
    pub can_color_faces: bool,
}

impl CornerColors<'_> {
    /// Adds them to the soup: as the colours of vertices where the corners of each vertex agree, else as
    /// those of faces where the corners of each face do, else as means at vertices. `label` names the mesh
    /// in notes.
    pub(crate) fn add_to(&self, soup: &mut PolygonSoup, label: &str, notes: &mut Notes) {
        if self.corners.iter().any(|[.., alpha]| *alpha < 1.0) {
            notes.fault(Fault::Attribute, format!("{label}: the alpha of colours is left out"));
        }
        let rgb = |[r, g, b, _]: [f32; 4]| Vec3::new(r, g, b);
        let mut colors = vec![Vec3::NAN; soup.positions.len()];
        let mut sums = vec![(Vec3::ZERO, 0.0f32); soup.positions.len()];
        let mut differing = 0;
        for (&vertex, &color) in soup.corners.iter().zip(self.corners) {
            let color = rgb(color);
            let Some((known, sum)) = colors.get_mut(vertex as usize).zip(sums.get_mut(vertex as usize))
            else {
                continue;
            };
            if color.is_nan() {
                continue;
            }
            if known.is_nan() {
                *known = color;
            }
            differing += usize::from(*known != color);
            *sum = (sum.0 + color, sum.1 + 1.0);
        }
        for (v, color) in colors.iter_mut().enumerate().filter(|(_, color)| color.is_nan()) {
            *color = (self.vertices)(v).unwrap_or(Vec3::NAN);
        }
        if differing == 0 {
            soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
            return;
        }
        if self.can_color_faces
            && let Some(colors) = self.of_faces(soup)
        {
            soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors));
            notes.info(format!("Corners of a face have one colour, which became the face's: {label}"));
            return;
        }
        for (color, (sum, count)) in colors.iter_mut().zip(sums).filter(|(_, (_, count))| *count > 0.0) {
            *color = sum / count;
        }
        soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
        notes.fault(
            Fault::Attribute,
            format!("{label}: vertices whose corners have different colours have the mean"),
        );
    }

    /// The colour of each face. None where corners of a face differ.
    fn of_faces(&self, soup: &PolygonSoup) -> Option<Vec<Color>> {
        let faces = soup.face_starts.windows(2).filter_map(|ends| match ends {
            &[start, end] => self.corners.get(start as usize..end as usize),
            _ => None,
        });
        let color = |corners: &[[f32; 4]]| {
            let [r, g, b, _] = corners.first().copied().unwrap_or([f32::NAN; 4]);
            let bits = |color: &[f32; 4]| color.map(f32::to_bits);
            let is_uniform = corners.iter().all(|color| Some(bits(color)) == corners.first().map(bits));
            let color = if r.is_nan() { Color::UNPAINTED } else { Rgb::from_srgb([r, g, b]).to_color() };
            is_uniform.then_some(color)
        };
        faces.map(color).collect()
    }
}
