//! Reading an OFF.

use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Reading, build};
use crate::model::NamedMesh;
use crate::report::{ImportReport, Places};
use crate::soup::of_vertices;
use crate::soup::origin::Origin;
use crate::text::scan::{Scan, Ticker};
use glam::{Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Color, NONE, PolygonSoup, Progress, keys};

/// What the first word says comes with each vertex.
struct Kind {
    texture: bool,
    color: bool,
    normal: bool,
    /// How many coordinates, and whether a count of them comes first.
    fourth: bool,
    any_dimension: bool,
    /// How much of the word is the keyword: some files have the counts right behind it.
    length: usize,
}

fn kind(word: &[u8]) -> Option<Kind> {
    let at = word.windows(3).position(|part| part == b"OFF")?;
    let (mut prefix, length) = (word.get(..at)?, at + 3);
    let mut has = |part: &[u8]| match prefix.strip_prefix(part) {
        Some(rest) => {
            prefix = rest;
            true
        }
        None => false,
    };
    let kind = Kind {
        texture: has(b"ST"),
        color: has(b"C"),
        normal: has(b"N"),
        fourth: has(b"4"),
        any_dimension: has(b"n"),
        length,
    };
    let rest = word.get(length..)?;
    (prefix.is_empty() && rest.iter().all(u8::is_ascii_digit)).then_some(kind)
}

/// Whether the first word is that of an OFF.
pub(crate) fn is_off(bytes: &[u8]) -> bool {
    let head = bytes.get(..4096).unwrap_or(bytes);
    Scan::new(head, Some(b'#')).word().and_then(kind).is_some()
}

/// Reads one OFF as one object.
pub(crate) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let fail = |message: &str| ReadError::file(&file.name, message);
    let mut scan = Scan::new(&file.bytes, Some(b'#'));
    let mut probe = Scan::new(&file.bytes, Some(b'#'));
    let word = probe.word().ok_or_else(|| ReadError::not_a(file, "an OFF", "it is empty"))?;
    // The keyword may be left out: then the counts come first.
    let kind = kind(word);
    if let Some(kind) = &kind {
        scan.at = probe.at - word.len() + kind.length;
        if kind.any_dimension {
            return Err(fail("an OFF of any number of dimensions (nOFF) can't be opened, only one in space"));
        }
    }
    let kind = kind.unwrap_or(Kind {
        texture: false,
        color: false,
        normal: false,
        fourth: false,
        any_dimension: false,
        length: 0,
    });
    if scan.more_on_line() {
        let mut rest = Scan::new(&file.bytes, Some(b'#'));
        rest.at = scan.at;
        if rest.word() == Some(b"BINARY") {
            return Err(fail("this is a binary OFF; save it as text and open it again"));
        }
    }
    let mut count = || scan.integer().and_then(|count| u64::try_from(count).ok());
    let (Some(vertices), Some(faces), Some(_)) = (count(), count(), count()) else {
        let why = "the numbers of its vertices, faces and edges don't come first";
        return Err(ReadError::not_a(file, "an OFF", why));
    };
    let mut reader = Reader {
        scan,
        origin: &mut reading.origin,
        ticker: Ticker::new(file.bytes.len()),
        soup: PolygonSoup::default(),
        vertex_colors: Vec::new(),
        normals: Vec::new(),
        uvs: Vec::new(),
        face_colors: Vec::new(),
        bad_vertices: Places::default(),
        bad_faces: Places::default(),
    };
    // No more room than the file can fill: two bytes a number at least.
    let most = file.bytes.len() / 2;
    reader.soup.positions.reserve(usize::try_from(vertices).unwrap_or(most).min(most / 3));
    reader.soup.face_starts.reserve(usize::try_from(faces).unwrap_or(most).min(most / 4));
    let vertices_there = reader.vertices(vertices, &kind, progress)?;
    let faces_there = reader.faces(faces, progress)?;
    let mut report = ImportReport::default();
    if vertices_there < vertices || faces_there < faces {
        report.warn(format!(
            "The file ends early: {vertices_there} of {vertices} vertices and {faces_there} of {faces} faces are there"
        ));
    }
    for (places, one, many, what) in [
        (&reader.bad_vertices, "vertex", "vertices", "put at the origin: not three numbers"),
        (&reader.bad_faces, "face", "faces", "left out: not a count and as many vertex numbers"),
    ] {
        if !places.is_empty() {
            report.warn(places.sentence(one, many, what, "number"));
        }
    }
    let mut soup = reader.soup;
    // A normal of no length is none.
    reader.normals.iter_mut().filter(|normal| **normal == Vec3::ZERO).for_each(|normal| *normal = Vec3::NAN);
    if reader.normals.iter().any(|normal| !normal.is_nan()) {
        soup.corner_columns.push(of_vertices(&soup, keys::CORNER_NORMAL, &reader.normals));
    }
    if reader.uvs.iter().any(|uv| !uv.is_nan()) {
        soup.corner_columns.push(of_vertices(&soup, keys::CORNER_UV, &reader.uvs));
    }
    if kind.color && !reader.vertex_colors.is_empty() {
        soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, reader.vertex_colors));
    }
    if reader.face_colors.iter().any(|&color| color != Color::UNPAINTED) {
        soup.face_columns.push(Column::with_values(keys::FACE_COLOR, reader.face_colors));
    }
    let part = &mut |part| progress(0.5 + part * 0.5);
    let object = build(file.stem(), soup, &file.name, reading, &mut report, part)?;
    Ok((object, report))
}

struct Reader<'a> {
    scan: Scan<'a>,
    origin: &'a mut Option<Origin>,
    ticker: Ticker,
    soup: PolygonSoup,
    vertex_colors: Vec<Vec3>,
    normals: Vec<Vec3>,
    uvs: Vec<Vec2>,
    face_colors: Vec<Color>,
    bad_vertices: Places,
    bad_faces: Places,
}

impl Reader<'_> {
    fn vertices(&mut self, count: u64, kind: &Kind, progress: &mut Progress) -> Result<u64, ReadError> {
        for number in 0..count {
            if self.scan.at_end() {
                return Ok(number);
            }
            let position = self.scan.position(self.origin);
            let mut next = || self.scan.float();
            if kind.fourth {
                next();
            }
            if kind.normal {
                let normal = [next(), next(), next()].map(|c| c.unwrap_or(f32::NAN));
                self.normals.push(Vec3::from_array(normal));
            }
            if kind.color {
                let channels = [next(), next(), next()].map(|c| c.unwrap_or(f32::NAN));
                // Whole numbers above 1 are out of 255; an opacity may follow.
                let full = if channels.iter().any(|&c| c > 1.0) { 255.0 } else { 1.0 };
                self.vertex_colors.push(Vec3::from_array(channels) / full);
                if self.scan.more_on_line() && !kind.texture {
                    self.scan.float();
                }
            }
            if kind.texture {
                // The last two numbers of the line: a colour before them may have an opacity.
                let mut uv = [f32::NAN; 2];
                while self.scan.more_on_line() {
                    uv = [uv[1], self.scan.float().unwrap_or(f32::NAN)];
                }
                self.uvs.push(Vec2::from_array(uv));
            }
            match position {
                Some(position) => self.soup.positions.push(position),
                None => {
                    self.bad_vertices.add(number as usize);
                    self.soup.positions.push(Vec3::ZERO);
                }
            }
            self.ticker.tick(self.scan.at, progress)?;
        }
        Ok(count)
    }

    fn faces(&mut self, count: u64, progress: &mut Progress) -> Result<u64, ReadError> {
        for number in 0..count {
            if self.scan.at_end() {
                return Ok(number);
            }
            let start = self.soup.corners.len();
            let mut readable = false;
            if let Some(corners) = self.scan.integer() {
                readable = corners >= 0;
                for _ in 0..corners {
                    if !self.scan.more_on_line() && self.scan.at_end() {
                        readable = false;
                        break;
                    }
                    // What is no vertex number is one that no vertex has: the build drops the face.
                    let vertex = self.scan.integer().and_then(|v| u32::try_from(v).ok()).unwrap_or(NONE);
                    self.soup.corners.push(vertex);
                }
            }
            let color = self.color();
            if readable {
                self.soup.face_starts.push(self.soup.corners.len() as u32);
                self.face_colors.push(color.unwrap_or(Color::UNPAINTED));
            } else {
                self.soup.corners.truncate(start);
                self.bad_faces.add(number as usize);
            }
            self.ticker.tick(self.scan.at, progress)?;
        }
        Ok(count)
    }

    /// The colour in the rest of a face's line: three or four numbers, out of 255 if whole. One
    /// number alone is a place in a table that isn't in the file.
    fn color(&mut self) -> Option<Color> {
        let mut channels = [0.0f32; 3];
        let mut count = 0;
        let mut fraction = false;
        while self.scan.more_on_line() {
            let start = self.scan.at;
            let value = self.scan.float();
            if let (Some(value), Some(channel)) = (value, channels.get_mut(count)) {
                *channel = value;
            }
            fraction |= value.is_some() && self.scan.has_point_since(start);
            count += 1;
        }
        let full = if fraction { 255.0 } else { 1.0 };
        (count >= 3).then(|| Color(channels.map(|c| (c * full).round().clamp(0.0, 255.0) as u8)))
    }
}
