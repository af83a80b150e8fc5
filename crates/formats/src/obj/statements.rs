//! The statements of an OBJ file, line by line: what the file says, before it is made a mesh.
//!
//! One pass over the bytes with no allocation per line. A line that can't be read is noted by its
//! number and the rest goes on; a vertex that can't be read still counts, because faces refer to
//! vertices by how many came before.

use super::cursor::Cursor;
use super::names::{group_label, spaced};
use super::runs::Runs;
use super::troubles::Troubles;
use crate::model::labels::Names;
use crate::soup::origin::Origin;
use glam::{DVec3, Vec2, Vec3};
use halfedge::{NONE, PolygonSoup, Progress};

/// What a file says.
#[derive(Default)]
pub(crate) struct Statements {
    /// Positions and faces.
    pub soup: PolygonSoup,
    /// Where positions are counted from, if not from zero.
    pub origin: Option<Origin>,
    /// Per vertex, as far as colours were given: NaN where none was.
    pub colors: Vec<Vec3>,
    /// The texture coordinates that faces refer to.
    pub uvs: Vec<Vec2>,
    /// The normals that faces refer to.
    pub normals: Vec<Vec3>,
    /// Per corner, as far as any was given: its texture coordinate's number.
    pub corner_uvs: Vec<u32>,
    /// Per corner, as far as any was given: its normal's number.
    pub corner_normals: Vec<u32>,
    pub groups: Runs,
    pub group_names: Names,
    pub materials: Runs,
    pub material_names: Names,
    pub smoothing: Runs,
    /// The material libraries named, as written.
    pub libraries: Vec<String>,
    /// How many lines were statements of the format, read or not.
    pub known: usize,
    /// How many lines there are.
    pub lines: usize,
    pub troubles: Troubles,
    /// Faces of the soup that refer to vertices which never came, in order.
    pub faces_without_vertices: Vec<u32>,
    object: String,
    group: String,
    /// Faces that refer to vertices further on, which may not come, with their lines.
    ahead: Vec<(u32, u32)>,
    /// Colours in comments, as ZBrush writes them.
    comment_colors: Vec<Vec3>,
    /// Texture coordinates and normals (true) further on that corners refer to, with their lines.
    attributes_ahead: Vec<(u32, u32, bool)>,
}

/// Why a face was not taken.
enum BadFace {
    Unreadable,
    MissingVertex,
}

/// A number of a vertex, texture coordinate or normal as written, made to count from 0: `None`
/// where it is 0 or counts back past the first.
#[inline(always)]
fn resolve(number: i64, count: usize) -> Option<u32> {
    let index = if number > 0 { number - 1 } else { number.checked_add(count as i64)? };
    if number == 0 { None } else { u32::try_from(index).ok().filter(|&index| index != NONE) }
}

impl Statements {
    /// Reads all of a file. `None` if `progress` says to stop; it is told 0 to 1.
    pub(crate) fn read(bytes: &[u8], origin: Option<Origin>, progress: &mut Progress) -> Option<Self> {
        const REPORT_EVERY: usize = 1 << 20;
        let mut this = Self { origin, ..Self::default() };
        // For the common `v` and `f` lines of large files; always less than the file itself.
        this.soup.positions.reserve(bytes.len() / 72);
        this.soup.corners.reserve(bytes.len() / 12);
        this.soup.face_starts.reserve(bytes.len() / 36);
        let mut cursor = Cursor::new(bytes);
        let mut next_report = REPORT_EVERY;
        while !cursor.at_end() {
            cursor.blanks();
            match (cursor.peek(), cursor.peek_second()) {
                (b'v', b' ' | b'\t') => {
                    cursor.at += 1;
                    this.vertex(&mut cursor);
                }
                (b'f', b' ' | b'\t') => {
                    cursor.at += 1;
                    this.face(&mut cursor);
                }
                (b'#', b'M') => this.comment_colors(&mut cursor),
                (b'#' | b'\n' | b'\r', _) => {}
                _ => this.other(&mut cursor),
            }
            cursor.next_line();
            if cursor.at >= next_report {
                next_report = cursor.at + REPORT_EVERY;
                if progress(cursor.at as f32 / bytes.len() as f32).is_break() {
                    return None;
                }
            }
        }
        this.lines = cursor.line - 1;
        if this.colors.is_empty() && !this.comment_colors.is_empty() {
            this.colors = std::mem::take(&mut this.comment_colors);
            this.colors.resize(this.soup.positions.len(), Vec3::NAN);
        }
        this.find_faces_without_vertices();
        this.note_missing_attributes();
        Some(this)
    }

    /// Whether there are vertices and none can be read.
    pub(crate) fn is_unreadable(&self) -> bool {
        let count = self.soup.positions.len();
        count > 0 && self.troubles.bad_vertices.count() == count
    }

    /// Numbers up to the end of the line: how many, or `None` if something else is among them or
    /// they are more than `N`.
    #[inline(always)]
    fn numbers<const N: usize>(cursor: &mut Cursor, values: &mut [f32; N]) -> Option<usize> {
        for (count, value) in values.iter_mut().enumerate() {
            cursor.blanks();
            if cursor.line_is_over() {
                return Some(count);
            }
            *value = cursor.float()?;
        }
        cursor.blanks();
        cursor.line_is_over().then_some(N)
    }

    /// `v x y z`, also with `w`, with `r g b`, or with both.
    #[inline(always)]
    fn vertex(&mut self, cursor: &mut Cursor) {
        self.known += 1;
        let line = cursor.line;
        if self.origin.is_some() {
            return self.far_vertex(cursor);
        }
        let mut values = [0.0; 7];
        let count = Self::numbers(cursor, &mut values);
        let [x, y, z, a, b, c, d] = values;
        self.soup.positions.push(Vec3::new(x, y, z));
        if count != Some(3) {
            self.unusual_vertex(line, count, [a, b, c, d]);
        }
    }

    /// A vertex that is counted from an origin.
    #[cold]
    fn far_vertex(&mut self, cursor: &mut Cursor) {
        let line = cursor.line;
        let mut values = [0.0; 7];
        let mut count = Some(0);
        for value in &mut values {
            cursor.blanks();
            if cursor.line_is_over() {
                break;
            }
            count = cursor.double().and_then(|number| {
                *value = number;
                Some(count? + 1)
            });
            if count.is_none() {
                break;
            }
        }
        cursor.blanks();
        let count = count.filter(|_| cursor.line_is_over());
        let [x, y, z, colors @ ..] = values;
        let position = DVec3::new(x, y, z);
        let place = |origin: &mut Origin| origin.place(position);
        self.soup.positions.push(self.origin.as_mut().map_or(position.as_vec3(), place));
        if count != Some(3) {
            self.unusual_vertex(line, count, colors.map(|c| c as f32));
        }
    }

    #[cold]
    fn unusual_vertex(&mut self, line: usize, count: Option<usize>, [a, b, c, d]: [f32; 4]) {
        let last = self.soup.positions.len().saturating_sub(1);
        let color = match count {
            Some(4) => None,
            Some(6) => Some(Vec3::new(a, b, c)),
            Some(7) => Some(Vec3::new(b, c, d)),
            _ => {
                self.troubles.bad_vertices.add(line);
                if let Some(position) = self.soup.positions.last_mut() {
                    *position = Vec3::ZERO;
                }
                return;
            }
        };
        // A fourth coordinate of 1 says nothing.
        if matches!(count, Some(4 | 7)) && a != 1.0 {
            self.troubles.fourth_coordinate.add(line);
        }
        if let Some(color) = color {
            self.colors.resize(last, Vec3::NAN);
            self.colors.push(color);
        }
    }

    /// `f` with corners `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    #[inline(always)]
    fn face(&mut self, cursor: &mut Cursor) {
        self.known += 1;
        let line = cursor.line;
        let start = self.soup.corners.len();
        let mut ahead = false;
        let result = loop {
            cursor.blanks();
            if cursor.line_is_over() {
                break Ok(());
            }
            let Some(number) = cursor.integer() else { break Err(BadFace::Unreadable) };
            let Some(vertex) = resolve(number, self.soup.positions.len()) else {
                break Err(BadFace::MissingVertex);
            };
            ahead |= vertex as usize >= self.soup.positions.len();
            self.soup.corners.push(vertex);
            if cursor.peek() == b'/' && self.corner_attributes(cursor, line).is_none() {
                break Err(BadFace::Unreadable);
            }
            if !cursor.token_is_over() {
                break Err(BadFace::Unreadable);
            }
        };
        let corners = self.soup.corners.len() - start;
        if result.is_ok() && corners >= 3 {
            if ahead {
                self.ahead.push((self.soup.face_count() as u32, line as u32));
            }
            self.soup.face_starts.push(self.soup.corners.len() as u32);
        } else {
            self.leave_out(start, line, result);
        }
    }

    /// `/vt`, `//vn` or `/vt/vn` behind the corner pushed last. `None` if it can't be read.
    #[inline(always)]
    fn corner_attributes(&mut self, cursor: &mut Cursor, line: usize) -> Option<()> {
        let corner = self.soup.corners.len() - 1;
        cursor.at += 1;
        // `1/` and `1//` are met in files; they give nothing.
        if cursor.peek() != b'/' && !cursor.token_is_over() {
            let uv = resolve(cursor.integer()?, self.uvs.len());
            if uv.is_none_or(|uv| uv as usize >= self.uvs.len()) {
                self.attributes_ahead.push((uv.unwrap_or(NONE), line as u32, false));
            }
            self.corner_uvs.resize(corner, NONE);
            self.corner_uvs.push(uv.unwrap_or(NONE));
        }
        if cursor.peek() == b'/' {
            cursor.at += 1;
            if !cursor.token_is_over() {
                let normal = resolve(cursor.integer()?, self.normals.len());
                if normal.is_none_or(|normal| normal as usize >= self.normals.len()) {
                    self.attributes_ahead.push((normal.unwrap_or(NONE), line as u32, true));
                }
                self.corner_normals.resize(corner, NONE);
                self.corner_normals.push(normal.unwrap_or(NONE));
            }
        }
        Some(())
    }

    /// Takes back the corners of a face that can't be used, and notes why.
    #[cold]
    fn leave_out(&mut self, start: usize, line: usize, result: Result<(), BadFace>) {
        self.soup.corners.truncate(start);
        self.corner_uvs.truncate(start);
        self.corner_normals.truncate(start);
        while self.attributes_ahead.last().is_some_and(|&(_, at, _)| at as usize == line) {
            self.attributes_ahead.pop();
        }
        match result {
            Ok(()) => self.troubles.small_faces.add(line),
            Err(BadFace::Unreadable) => self.troubles.bad_faces.add(line),
            Err(BadFace::MissingVertex) => self.troubles.missing_vertex.add(line),
        }
    }

    /// Every statement but the common two.
    fn other(&mut self, cursor: &mut Cursor) {
        let line = cursor.line;
        let word = cursor.word();
        if !cursor.token_is_over() {
            self.troubles.unknown.add(line);
            return;
        }
        self.known += 1;
        match word {
            b"vt" => {
                let mut values = [0.0; 3];
                let count = Self::numbers(cursor, &mut values);
                let [u, v, w] = values;
                let read = matches!(count, Some(1..=3));
                if count == Some(3) && w != 0.0 {
                    self.troubles.third_texture_coordinate.add(line);
                }
                self.uvs.push(if read { Vec2::new(u, v) } else { Vec2::NAN });
                if !read {
                    self.troubles.bad_uvs.add(line);
                }
            }
            b"vn" => {
                let mut values = [0.0; 3];
                let read = Self::numbers(cursor, &mut values) == Some(3);
                self.normals.push(if read { Vec3::from_array(values) } else { Vec3::NAN });
                if !read {
                    self.troubles.bad_normals.add(line);
                }
            }
            b"v" => self.vertex(cursor),
            // "fo" is what older files have for a face.
            b"f" | b"fo" => self.face(cursor),
            b"o" => {
                self.object = cursor.text();
                self.group.clear();
                self.start_group();
            }
            b"g" => {
                self.group = spaced(&cursor.text());
                self.start_group();
            }
            b"usemtl" => {
                let name = cursor.text();
                let number = if name.is_empty() { NONE } else { self.material_names.number(&name) };
                self.materials.start(self.soup.face_count(), number);
            }
            b"mtllib" => {
                let name = cursor.text();
                if !name.is_empty() && !self.libraries.contains(&name) {
                    self.libraries.push(name);
                }
            }
            b"s" => {
                let text = cursor.text();
                let group = match text.as_str() {
                    "off" => Some(0),
                    "on" => Some(1),
                    number => number.parse().ok(),
                };
                match group {
                    Some(group) => self.smoothing.start(self.soup.face_count(), group),
                    None => self.troubles.bad_smoothing.add(line),
                }
            }
            b"l" | b"p" => self.troubles.lines_and_points.add(line),
            word => match unused(word) {
                Some(word) => self.troubles.add_unused(word, line),
                None => {
                    self.known -= 1;
                    self.troubles.unknown.add(line);
                }
            },
        }
        // Whatever wasn't taken is skipped with the rest of the line.
    }

    /// `#MRGB` and eight hexadecimal digits for each vertex: a mask and a colour.
    #[cold]
    fn comment_colors(&mut self, cursor: &mut Cursor) {
        cursor.at += 1;
        if cursor.word() != b"MRGB" {
            return;
        }
        for digits in cursor.text().as_bytes().as_chunks::<8>().0 {
            let color =
                std::str::from_utf8(digits).ok().and_then(|digits| u32::from_str_radix(digits, 16).ok());
            let Some(color) = color else { return };
            let [_, r, g, b] = color.to_be_bytes();
            self.comment_colors.push(Vec3::new(r.into(), g.into(), b.into()) / 255.0);
        }
    }

    fn start_group(&mut self) {
        let number = match group_label(&self.object, &self.group) {
            Some(label) => self.group_names.number(&label),
            None => NONE,
        };
        self.groups.start(self.soup.face_count(), number);
    }

    /// Faces may refer to vertices that come after them; those that refer to none at all must go.
    fn find_faces_without_vertices(&mut self) {
        let count = self.soup.positions.len();
        for &(face, line) in &self.ahead {
            if self.soup.face(face as usize).iter().any(|&v| v as usize >= count) {
                self.faces_without_vertices.push(face);
                self.troubles.missing_vertex.add(line as usize);
            }
        }
    }

    fn note_missing_attributes(&mut self) {
        for &(number, line, is_normal) in &self.attributes_ahead {
            let count = if is_normal { self.normals.len() } else { self.uvs.len() };
            if number as usize >= count {
                self.troubles.missing_attribute.add(line as usize);
            }
        }
    }
}

/// The statements of the format that have no meaning here: of free-form curves and surfaces and of display.
const UNUSED: [&str; 28] = [
    "vp",
    "cstype",
    "deg",
    "bmat",
    "step",
    "curv",
    "curv2",
    "surf",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "mg",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "maplib",
    "usemap",
    "call",
    "csh",
];

/// A word if it begins such a statement.
fn unused(word: &[u8]) -> Option<&'static str> {
    UNUSED.into_iter().find(|unused| unused.as_bytes() == word)
}
