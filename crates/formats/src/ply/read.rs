//! Reading a PLY, table by table.

use super::faces::{Faces, read_strips};
use super::header::{Encoding, Header};
use super::rows::Rows;
use super::textures::materials;
use super::vertices::Vertices;
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Contents, Reading, Source, build};
use crate::report::{ImportReport, first_few};
use crate::soup::of_vertices;
use crate::text::commas::{AMBIGUOUS, Commas, read_commas};
use glam::Vec2;
use halfedge::attribute::Column;
use halfedge::words::counted;
use halfedge::{Color, PolygonSoup, Progress, keys};

/// How many texts of `obj_info` lines a note lists.
const INFOS_LISTED: usize = 4;

/// Reads one PLY as one object.
///
/// # Errors
/// Where it is no PLY, or none of its vertices can be read.
pub(super) fn read(
    source: &Source,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let file = source.file;
    let fail = |message: &str| Err(ReadError::file(&file.name, message));
    let header = Header::read(&file.bytes).map_err(|message| ReadError::file(&file.name, message))?;
    if !header.tables.iter().any(|table| table.name == "vertex") {
        return fail("the PLY has no element \"vertex\"");
    }
    let mut report = ImportReport::default();
    note_header(&header, &mut report);
    let mut tables = Tables::default();
    tables.read(&header, &file.bytes, reading, progress)?;
    if header.encoding == Encoding::Text && !tables.vertices.unreadable.is_empty() {
        let (head, body) = file.bytes.split_at_checked(header.end).unwrap_or_default();
        match read_commas(body, |line| 0..line.len()) {
            Commas::None => {}
            Commas::Ambiguous if tables.vertices.is_unreadable() => return fail(AMBIGUOUS),
            Commas::Ambiguous => {}
            Commas::Readable(body, note) => {
                report.info(note);
                tables = Tables::default();
                tables.read(&header, &[head, &body].concat(), reading, progress)?;
            }
        }
    }
    if tables.vertices.is_unreadable() {
        return fail(
            "none of the PLY's vertices has a position that can be read: numbers x, y and z are needed",
        );
    }
    tables.finish(source, &header, report, reading, progress)
}

/// The names of the images that a file refers to.
pub(super) fn companions(file: &NamedBytes) -> Vec<String> {
    Header::read(&file.bytes).map_or(Vec::new(), |header| header.texture_files)
}

/// Notes what is odd about a header, or not kept.
fn note_header(header: &Header, report: &mut ImportReport) {
    if !header.stray.is_empty() {
        report.info(header.stray.sentence(
            "line",
            "lines",
            "of the header has no meaning and was left out",
            "line",
        ));
    }
    if !header.unknown_types.is_empty() {
        let what = "of a type that is none of the format's, read as numbers";
        report.info(header.unknown_types.sentence("property", "properties", what, "line"));
    }
    if header.is_guessed {
        report.info("The header doesn't say the format of what follows, which was read as text");
    }
    if !header.infos.is_empty() {
        report.info(format!("Remarks (obj_info) left out: {}", first_few(&header.infos, INFOS_LISTED)));
    }
}

/// What the tables hold.
#[derive(Default)]
struct Tables {
    vertices: Vertices,
    faces: Faces,
    /// The faces; the positions are with the vertices.
    soup: PolygonSoup,
    /// Properties and elements that are not kept.
    left_out: Vec<String>,
    /// Where the file ends early.
    early_end: Option<String>,
}

impl Tables {
    fn read(
        &mut self,
        header: &Header,
        bytes: &[u8],
        reading: &mut Reading,
        progress: &mut Progress,
    ) -> Result<(), ReadError> {
        let mut rows = Rows::new(bytes, header, reading.origin.is_some());
        for table in &header.tables {
            let Self { vertices, faces, soup, left_out, .. } = self;
            let read = match table.name.as_str() {
                "vertex" => vertices.read(table, &mut rows, &mut reading.origin, left_out, progress)?,
                "face" => {
                    let has_images = !header.texture_files.is_empty();
                    faces.read(table, &mut rows, soup, has_images, left_out, progress)?
                }
                "tristrips" => read_strips(table, &mut rows, soup, progress)?,
                name => {
                    if table.rows > 0 {
                        left_out.push(format!("all of \"{name}\""));
                    }
                    rows.for_each(table, [None; 2], progress, |_, _, _| {})?
                }
            };
            if read < table.rows {
                self.early_end = Some(format!(
                    "The file ends early: {read} of {} (element \"{}\") are there",
                    counted(usize::try_from(table.rows).unwrap_or(usize::MAX), "row", "rows"),
                    table.name
                ));
                break;
            }
        }
        Ok(())
    }

    /// The mesh, with all attributes and notes.
    fn finish(
        self,
        source: &Source,
        header: &Header,
        mut report: ImportReport,
        reading: &mut Reading,
        progress: &mut Progress,
    ) -> Result<Contents, ReadError> {
        self.note(&mut report);
        let Self { mut vertices, mut faces, mut soup, .. } = self;
        vertices.scale_colors();
        soup.positions = std::mem::take(&mut vertices.positions);
        if vertices.colors.iter().any(|color| !color.is_nan()) {
            soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, vertices.colors));
        }
        soup.vertex_columns.extend(vertices.columns.finish(&mut report));
        if faces.colors.iter().any(|&color| color != Color::UNPAINTED) {
            faces.colors.resize(soup.face_count(), Color::UNPAINTED);
            soup.face_columns.push(Column::with_values(keys::FACE_COLOR, faces.colors));
        }
        let numbers = faces.textures.as_deref();
        let (materials, column) =
            materials(&header.texture_files, numbers, soup.face_count(), source.files, &mut report);
        soup.face_columns.extend(column);
        soup.face_columns.extend(faces.columns.finish(&mut report));
        if vertices.normals.iter().any(|normal| !normal.is_nan()) {
            soup.corner_columns.push(of_vertices(&soup, keys::CORNER_NORMAL, &vertices.normals));
        }
        if !faces.corner_uvs.is_empty() {
            faces.corner_uvs.resize(soup.corners.len(), Vec2::NAN);
            soup.corner_columns.push(Column::with_values(keys::CORNER_UV, faces.corner_uvs));
        } else if vertices.uvs.iter().any(|uv| !uv.is_nan()) {
            soup.corner_columns.push(of_vertices(&soup, keys::CORNER_UV, &vertices.uvs));
        }
        let file = source.file;
        let part = &mut |part| progress(0.5 + part * 0.5);
        let object = build(file.stem(), soup, &file.name, reading, &mut report, part)?;
        Ok(Contents { objects: vec![object], materials, report })
    }

    fn note(&self, report: &mut ImportReport) {
        if let Some(early_end) = &self.early_end {
            report.warn(early_end);
        }
        if !self.left_out.is_empty() {
            report.info(format!("Properties and elements left out: {}", self.left_out.join(", ")));
        }
        let Self { vertices, faces, .. } = self;
        if !vertices.absent.is_empty() && !vertices.positions.is_empty() {
            report.info(format!("Vertices have no {}, which is 0", vertices.absent.join(" and no ")));
        }
        if !vertices.unreadable.is_empty() {
            let what = "with a coordinate that is no number";
            report.warn(vertices.unreadable.sentence("vertex", "vertices", what, "number"));
        }
        if !faces.bad_uvs.is_empty() {
            let what = "without its own texture coordinates: they are not two numbers for each corner";
            report.warn(faces.bad_uvs.sentence("face", "faces", what, "number"));
        }
    }
}
