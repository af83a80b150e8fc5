//! The vertices of a PLY.

use super::columns::Columns;
use super::header::Table;
use super::rows::Rows;
use crate::error::ReadError;
use crate::report::Places;
use crate::soup::origin::Origin;
use glam::{DVec3, Vec2, Vec3};
use halfedge::{Element, Progress};

/// The names of the parts of a colour, a normal and a texture coordinate.
pub(super) const COLOR: [[&str; 3]; 2] =
    [["red", "green", "blue"], ["diffuse_red", "diffuse_green", "diffuse_blue"]];
const NORMAL: [[&str; 3]; 1] = [["nx", "ny", "nz"]];
const UV: [[&str; 2]; 4] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["s0", "t0"]];

/// What the rows of vertices hold.
#[derive(Default)]
pub(super) struct Vertices {
    pub positions: Vec<Vec3>,
    /// Red, green and blue from 0 to 1.
    pub colors: Vec<Vec3>,
    /// For all corners of a vertex.
    pub normals: Vec<Vec3>,
    pub uvs: Vec<Vec2>,
    pub columns: Columns,
    /// Vertices with a coordinate that is no number.
    pub unreadable: Places,
    /// The coordinates that the file doesn't have.
    pub absent: Vec<&'static str>,
}

/// Where in a row the numbers with these names are, or with those after them.
pub(super) fn places<const N: usize>(table: &Table, names: &[[&str; N]]) -> Option<[usize; N]> {
    names.iter().find_map(|names| {
        let mut found = [0; N];
        for (place, name) in found.iter_mut().zip(names) {
            *place = table.properties.iter().position(|p| p.count.is_none() && p.name == *name)?;
        }
        Some(found)
    })
}

/// What the channels of a colour are divided by.
pub(super) fn full(table: &Table, places: [usize; 3]) -> [f64; 3] {
    places.map(|i| table.properties.get(i).map_or(1.0, |p| p.scalar.full()))
}

impl Vertices {
    /// Reads the rows of a table; returns how many there were. Names of properties that are not kept are added
    /// to `left_out`.
    pub(super) fn read(
        &mut self,
        table: &Table,
        rows: &mut Rows,
        origin: &mut Option<Origin>,
        left_out: &mut Vec<String>,
        progress: &mut Progress,
    ) -> Result<u64, ReadError> {
        let place = |name: &str| table.properties.iter().position(|p| p.count.is_none() && p.name == name);
        let position = ["x", "y", "z"].map(place);
        self.absent = ["x", "y", "z"].into_iter().filter(|name| place(name).is_none()).collect();
        let color = places(table, &COLOR);
        let full = color.map(|places| full(table, places));
        let (normal, uv) = (places(table, &NORMAL), places(table, &UV));
        let in_use: Vec<usize> = position
            .into_iter()
            .flatten()
            .chain([color, normal].into_iter().flatten().flatten())
            .chain(uv.into_iter().flatten())
            .collect();
        self.columns = Columns::new(table, Element::Vertex, &in_use, left_out);
        self.positions.reserve(rows.expected(table));
        rows.for_each(table, [None; 2], progress, |number, row, _| {
            let value = |place: usize| row.get(place).copied().unwrap_or(0.0);
            let at = DVec3::from_array(position.map(|place| place.map_or(0.0, value)));
            if at.is_nan() {
                self.unreadable.add(number as usize);
            }
            self.positions.push(origin.as_mut().map_or(at.as_vec3(), |origin| origin.place(at)));
            if let Some((places, full)) = color.zip(full) {
                let [r, g, b] = [0, 1, 2].map(|i: usize| {
                    let place = places.get(i).copied().unwrap_or_default();
                    (value(place) / full.get(i).copied().unwrap_or(1.0)) as f32
                });
                self.colors.push(Vec3::new(r, g, b));
            }
            if let Some(places) = normal {
                let normal = Vec3::from_array(places.map(|place| value(place) as f32));
                // A normal of no length is none.
                self.normals.push(if normal == Vec3::ZERO { Vec3::NAN } else { normal });
            }
            if let Some(places) = uv {
                self.uvs.push(Vec2::from_array(places.map(|place| value(place) as f32)));
            }
            self.columns.push(row);
        })
    }

    /// Whether there are vertices and none of them has a position.
    pub(super) fn is_unreadable(&self) -> bool {
        let count = self.positions.len();
        count > 0 && (self.absent.len() == 3 || self.unreadable.count() == count)
    }

    /// Divides colours in floats by 255 where some are above 1.
    pub(super) fn scale_colors(&mut self) {
        if self.colors.iter().any(|color| color.max_element() > 1.0) {
            self.colors.iter_mut().for_each(|color| *color /= 255.0);
        }
    }
}
