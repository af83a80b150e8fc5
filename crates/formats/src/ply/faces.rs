//! The faces of a PLY.

use super::columns::Columns;
use super::header::{Property, Table};
use super::rows::Rows;
use super::vertices::{COLOR, full, places};
use crate::error::ReadError;
use crate::report::Places;
use glam::Vec2;
use halfedge::{Color, Element, NONE, PolygonSoup, Progress};

/// The property that says which image a face shows, as MeshLab writes it.
const TEXTURE_NUMBER: &str = "texnumber";

/// What the rows of faces hold.
#[derive(Default)]
pub(super) struct Faces {
    /// Per corner, as far as any is given: what a face says of its own corners.
    pub corner_uvs: Vec<Vec2>,
    pub colors: Vec<Color>,
    /// Per face the number of its image; none without the property.
    pub textures: Option<Vec<i64>>,
    pub columns: Columns,
    /// Faces with texture coordinates that are not two for each corner.
    pub bad_uvs: Places,
}

impl Faces {
    /// Reads the rows of a table into a soup; returns how many there were. Names of properties that are not
    /// kept are added to `left_out`. Without images in the file, their numbers mean nothing.
    pub(super) fn read(
        &mut self,
        table: &Table,
        rows: &mut Rows,
        soup: &mut PolygonSoup,
        has_images: bool,
        left_out: &mut Vec<String>,
        progress: &mut Progress,
    ) -> Result<u64, ReadError> {
        let list = index_list(table);
        let uvs = table.properties.iter().position(|p| p.count.is_some() && p.name == "texcoord");
        let color = places(table, &COLOR);
        let full = color.map(|places| full(table, places));
        let texture = table.properties.iter().position(|p| p.count.is_none() && p.name == TEXTURE_NUMBER);
        let texture = texture.filter(|_| has_images);
        let in_use: Vec<usize> =
            list.into_iter().chain(uvs).chain(texture).chain(color.into_iter().flatten()).collect();
        self.columns = Columns::new(table, Element::Face, &in_use, left_out);
        self.textures = texture.map(|_| Vec::new());
        let expected = rows.expected(table);
        soup.face_starts.reserve(expected);
        soup.corners.reserve(expected * 3);
        rows.for_each(table, [list, uvs], progress, |number, row, [list, uvs]| {
            let (pairs, rest) = uvs.as_chunks::<2>();
            if !pairs.is_empty() && pairs.len() == list.len() && rest.is_empty() {
                self.corner_uvs.resize(soup.corners.len(), Vec2::NAN);
                self.corner_uvs.extend(pairs.iter().map(|uv| Vec2::from_array(uv.map(|c| c as f32))));
            } else if !uvs.is_empty() {
                self.bad_uvs.add(number as usize);
            }
            // What is no vertex number is one that no vertex has: the build drops the face.
            soup.push_face(list.iter().map(|&v| index(v)));
            if let Some((places, full)) = color.zip(full) {
                let channels = [0, 1, 2].map(|i: usize| {
                    let value = places.get(i).and_then(|&place| row.get(place)).copied().unwrap_or(0.0);
                    (value / full.get(i).copied().unwrap_or(1.0) * 255.0).round().clamp(0.0, 255.0) as u8
                });
                self.colors.push(Color(channels));
            }
            if let Some((textures, place)) = self.textures.as_mut().zip(texture) {
                textures.push(row.get(place).map_or(-1, |&value| value as i64));
            }
            self.columns.push(row);
        })
    }
}

/// Reads strips of triangles into a soup: -1 between them, every second triangle the other way round.
pub(super) fn read_strips(
    table: &Table,
    rows: &mut Rows,
    soup: &mut PolygonSoup,
    progress: &mut Progress,
) -> Result<u64, ReadError> {
    rows.for_each(table, [index_list(table), None], progress, |_, _, [list, _]| {
        for strip in list.split(|&v| v < 0.0) {
            for (i, corners) in strip.windows(3).enumerate() {
                let &[a, b, c] = corners else { continue };
                let (a, b, c) = (index(a), index(b), index(c));
                // A repeat only joins two strips.
                if a != b && b != c && c != a {
                    soup.push_face(if i % 2 == 0 { [a, b, c] } else { [b, a, c] });
                }
            }
        }
    })
}

/// Where a table has its list of vertex numbers.
fn index_list(table: &Table) -> Option<usize> {
    let is_list = |p: &Property| p.count.is_some();
    let position = |is: &dyn Fn(&Property) -> bool| table.properties.iter().position(is);
    position(&|p| is_list(p) && matches!(p.name.as_str(), "vertex_indices" | "vertex_index"))
        .or_else(|| position(&|p| is_list(p) && !p.scalar.is_float()))
}

/// A number read as a vertex number.
fn index(value: f64) -> u32 {
    if (0.0..f64::from(NONE)).contains(&value) { value as u32 } else { NONE }
}
