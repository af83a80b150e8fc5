//! Reading a PLY, table by table.

use super::header::{Header, Property, Table};
use super::source::Source;
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Reading, build};
use crate::model::NamedMesh;
use crate::report::{ImportReport, Places, counted};
use crate::soup::of_vertices;
use crate::text::scan::Ticker;
use glam::{DVec3, Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Color, NONE, PolygonSoup, Progress, keys};

/// Reads one PLY as one object.
pub(crate) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let header = Header::read(&file.bytes).map_err(|message| ReadError::file(&file.name, message))?;
    if !header.tables.iter().any(|table| table.name == "vertex") {
        return Err(ReadError::file(&file.name, "the PLY has no element \"vertex\""));
    }
    let mut reader = Reader {
        source: Source::new(&file.bytes, header.end, header.encoding, reading.origin.is_some()),
        reading: *reading,
        size: file.bytes.len(),
        ticker: Ticker::new(file.bytes.len()),
        soup: PolygonSoup::default(),
        vertex_colors: Vec::new(),
        normals: Vec::new(),
        uvs: Vec::new(),
        corner_uvs: Vec::new(),
        face_colors: Vec::new(),
        unread: Places::default(),
        left_out: Vec::new(),
    };
    let mut report = ImportReport::default();
    for table in &header.tables {
        let rows = match table.name.as_str() {
            "vertex" => reader.vertices(table, progress)?,
            "face" => reader.faces(table, progress)?,
            "tristrips" => reader.strips(table, progress)?,
            _ => reader.skip(table, progress)?,
        };
        if rows < table.rows {
            report.warn(format!(
                "The file ends early: {rows} of {} (element \"{}\") are there",
                counted(usize::try_from(table.rows).unwrap_or(usize::MAX), "row", "rows"),
                table.name
            ));
            break;
        }
    }
    reading.origin = reader.reading.origin;
    reader.finish(file, report, progress)
}

struct Reader<'a> {
    source: Source<'a>,
    reading: Reading,
    size: usize,
    ticker: Ticker,
    soup: PolygonSoup,
    vertex_colors: Vec<Vec3>,
    /// What vertices have, for all of their corners.
    normals: Vec<Vec3>,
    uvs: Vec<Vec2>,
    /// What faces say of their own corners, which counts for more.
    corner_uvs: Vec<Vec2>,
    face_colors: Vec<Color>,
    /// Vertices with a coordinate that is no number.
    unread: Places,
    /// Properties and elements that are not used.
    left_out: Vec<String>,
}

/// The names that the parts of a colour, a normal and a texture coordinate go by.
const COLOR: [[&str; 3]; 2] = [["red", "green", "blue"], ["diffuse_red", "diffuse_green", "diffuse_blue"]];
const NORMAL: [[&str; 3]; 1] = [["nx", "ny", "nz"]];
const UV: [[&str; 2]; 4] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["s0", "t0"]];

/// Where in a row the numbers are that go by these names, or by those after them.
fn places<const N: usize>(table: &Table, names: &[[&str; N]]) -> Option<[usize; N]> {
    names.iter().find_map(|names| {
        let mut found = [0; N];
        for (place, name) in found.iter_mut().zip(names) {
            *place = table.properties.iter().position(|p| p.count.is_none() && p.name == *name)?;
        }
        Some(found)
    })
}

/// What the channels of a colour are divided by.
fn full(table: &Table, places: [usize; 3]) -> [f64; 3] {
    places.map(|i| table.properties.get(i).map_or(1.0, |p| p.scalar.full()))
}

impl Reader<'_> {
    /// Reads the numbers of one row: of a list the length, the values of those at `wanted` into
    /// `lists`. False where the
    /// file ends before the row does.
    fn row(
        &mut self,
        properties: &[Property],
        row: &mut Vec<f64>,
        lists: &mut [Vec<f64>; 2],
        wanted: [Option<usize>; 2],
    ) -> bool {
        row.clear();
        lists.iter_mut().for_each(Vec::clear);
        for (place, property) in properties.iter().enumerate() {
            let Some(value) = self.source.next(property.count.unwrap_or(property.scalar)) else {
                return false;
            };
            row.push(value);
            if property.count.is_some() {
                // A negative or unreadable length is none.
                for _ in 0..value as u64 {
                    let Some(item) = self.source.next(property.scalar) else { return false };
                    for (list, wanted) in lists.iter_mut().zip(wanted) {
                        if wanted == Some(place) {
                            list.push(item);
                        }
                    }
                }
            }
        }
        true
    }

    /// Calls `take` with each row of a table and the values of its lists at `wanted`. Gives how
    /// many rows there were.
    fn rows(
        &mut self,
        table: &Table,
        wanted: [Option<usize>; 2],
        progress: &mut Progress,
        mut take: impl FnMut(&mut Self, u64, &[f64], &[Vec<f64>; 2]),
    ) -> Result<u64, ReadError> {
        // Rows of nothing could be any number.
        if table.properties.is_empty() {
            return Ok(table.rows);
        }
        let (mut row, mut lists) = (Vec::new(), [Vec::new(), Vec::new()]);
        for number in 0..table.rows {
            if !self.row(&table.properties, &mut row, &mut lists, wanted) {
                return Ok(number);
            }
            take(self, number, &row, &lists);
            self.ticker.tick(self.source.at(), progress)?;
        }
        Ok(table.rows)
    }

    /// How many rows to make room for: no more than the file can hold.
    fn expected(&self, table: &Table) -> usize {
        let most = self.size.saturating_sub(self.source.at()) / table.properties.len().max(1);
        usize::try_from(table.rows).unwrap_or(most).min(most)
    }

    fn vertices(&mut self, table: &Table, progress: &mut Progress) -> Result<u64, ReadError> {
        let place = |name: &str| table.properties.iter().position(|p| p.count.is_none() && p.name == name);
        let position = [place("x"), place("y"), place("z")];
        let color = places(table, &COLOR);
        let full = color.map(|places| full(table, places));
        let (normal, uv) = (places(table, &NORMAL), places(table, &UV));
        let in_use: Vec<usize> = position
            .into_iter()
            .flatten()
            .chain([color, normal].into_iter().flatten().flatten())
            .chain(uv.into_iter().flatten())
            .collect();
        self.leave_out(table, &in_use);
        let expected = self.expected(table);
        self.soup.positions.reserve(expected);
        self.rows(table, [None; 2], progress, |this, number, row, _| {
            let value = |place: usize| row.get(place).copied().unwrap_or(0.0);
            let at = DVec3::from_array(position.map(|place| place.map_or(0.0, value)));
            if at.is_nan() {
                this.unread.add(number as usize);
            }
            let origin = this.reading.origin.as_mut();
            this.soup.positions.push(origin.map_or(at.as_vec3(), |origin| origin.place(at)));
            if let Some((places, full)) = color.zip(full) {
                let [r, g, b] = [0, 1, 2].map(|i: usize| {
                    let place = places.get(i).copied().unwrap_or_default();
                    (value(place) / full.get(i).copied().unwrap_or(1.0)) as f32
                });
                this.vertex_colors.push(Vec3::new(r, g, b));
            }
            if let Some(places) = normal {
                let normal = Vec3::from_array(places.map(|place| value(place) as f32));
                // A normal of no length is none.
                this.normals.push(if normal == Vec3::ZERO { Vec3::NAN } else { normal });
            }
            if let Some(places) = uv {
                this.uvs.push(Vec2::from_array(places.map(|place| value(place) as f32)));
            }
        })
    }

    fn faces(&mut self, table: &Table, progress: &mut Progress) -> Result<u64, ReadError> {
        let list = self.index_list(table);
        let uvs = table.properties.iter().position(|p| p.count.is_some() && p.name == "texcoord");
        let color = places(table, &COLOR);
        let full = color.map(|places| full(table, places));
        let in_use: Vec<usize> = list.into_iter().chain(uvs).chain(color.into_iter().flatten()).collect();
        self.leave_out(table, &in_use);
        let expected = self.expected(table);
        self.soup.face_starts.reserve(expected);
        self.soup.corners.reserve(expected * 3);
        self.rows(table, [list, uvs], progress, |this, _, row, [list, uvs]| {
            let (pairs, rest) = uvs.as_chunks::<2>();
            if !pairs.is_empty() && pairs.len() == list.len() && rest.is_empty() {
                this.corner_uvs.resize(this.soup.corners.len(), Vec2::NAN);
                this.corner_uvs.extend(pairs.iter().map(|uv| Vec2::from_array(uv.map(|c| c as f32))));
            }
            // What is no vertex number becomes one that no vertex has: the build drops the face.
            this.soup.push_face(list.iter().map(|&v| index(v)));
            if let Some((places, full)) = color.zip(full) {
                let channels = [0, 1, 2].map(|i: usize| {
                    let value = places.get(i).and_then(|&place| row.get(place)).copied().unwrap_or(0.0);
                    (value / full.get(i).copied().unwrap_or(1.0) * 255.0).round().clamp(0.0, 255.0) as u8
                });
                this.face_colors.push(Color(channels));
            }
        })
    }

    /// Strips of triangles, -1 between them, every second triangle the other way round.
    fn strips(&mut self, table: &Table, progress: &mut Progress) -> Result<u64, ReadError> {
        let list = self.index_list(table);
        self.rows(table, [list, None], progress, |this, _, _, [list, _]| {
            for strip in list.split(|&v| v < 0.0) {
                for (i, corners) in strip.windows(3).enumerate() {
                    let &[a, b, c] = corners else { continue };
                    let (a, b, c) = (index(a), index(b), index(c));
                    // A repeat only joins two strips.
                    if a != b && b != c && c != a {
                        this.soup.push_face(if i % 2 == 0 { [a, b, c] } else { [b, a, c] });
                    }
                }
            }
        })
    }

    fn skip(&mut self, table: &Table, progress: &mut Progress) -> Result<u64, ReadError> {
        if table.rows > 0 {
            self.left_out.push(format!("all of \"{}\"", table.name));
        }
        self.rows(table, [None; 2], progress, |_, _, _, _| {})
    }

    /// Notes the properties of a table that are not used.
    fn leave_out(&mut self, table: &Table, in_use: &[usize]) {
        let unused = table.properties.iter().enumerate().filter(|(place, _)| !in_use.contains(place));
        self.left_out.extend(unused.map(|(_, property)| property.name.clone()));
    }

    /// Where a table has its list of vertex numbers.
    fn index_list(&self, table: &Table) -> Option<usize> {
        let is_list = |p: &Property| p.count.is_some();
        table
            .properties
            .iter()
            .position(|p| is_list(p) && matches!(p.name.as_str(), "vertex_indices" | "vertex_index"))
            .or_else(|| table.properties.iter().position(is_list))
    }

    fn finish(
        mut self,
        file: &NamedBytes,
        mut report: ImportReport,
        progress: &mut Progress,
    ) -> Result<(NamedMesh, ImportReport), ReadError> {
        if !self.left_out.is_empty() {
            report.info(format!("Properties that are not used were left out: {}", self.left_out.join(", ")));
        }
        if !self.unread.is_empty() {
            report.warn(self.unread.sentence(
                "vertex",
                "vertices",
                "with a coordinate that is no number",
                "number",
            ));
        }
        if self.vertex_colors.iter().any(|color| !color.is_nan()) {
            let colors = std::mem::take(&mut self.vertex_colors);
            self.soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
        }
        if self.face_colors.iter().any(|&color| color != Color::UNPAINTED) {
            let mut colors = std::mem::take(&mut self.face_colors);
            colors.resize(self.soup.face_count(), Color::UNPAINTED);
            self.soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors));
        }
        if self.normals.iter().any(|normal| !normal.is_nan()) {
            self.soup.corner_columns.push(of_vertices(&self.soup, keys::CORNER_NORMAL, &self.normals));
        }
        if !self.corner_uvs.is_empty() {
            self.corner_uvs.resize(self.soup.corners.len(), Vec2::NAN);
            let uvs = std::mem::take(&mut self.corner_uvs);
            self.soup.corner_columns.push(Column::with_values(keys::CORNER_UV, uvs));
        } else if self.uvs.iter().any(|uv| !uv.is_nan()) {
            self.soup.corner_columns.push(of_vertices(&self.soup, keys::CORNER_UV, &self.uvs));
        }
        let part = &mut |part| progress(0.5 + part * 0.5);
        let object = build(file.stem(), self.soup, &file.name, &self.reading, &mut report, part)?;
        Ok((object, report))
    }
}

/// A number read as a vertex number.
fn index(value: f64) -> u32 {
    if (0.0..f64::from(NONE)).contains(&value) { value as u32 } else { NONE }
}
