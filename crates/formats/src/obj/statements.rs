//! The statements of an OBJ, read line by line.
//!
//! One pass over the bytes, without an allocation per line. An unreadable line is noted by its number. An
//! unreadable vertex still counts, because faces refer to vertices by number.

use super::cursor::Cursor;
use super::names::{group_label, spaced};
use super::runs::Runs;
use super::troubles::Troubles;
use crate::model::labels::Names;
use crate::soup::origin::Origin;
use glam::{Vec2, Vec3};
use halfedge::{NONE, PolygonSoup, Progress};

/// How many bytes are read between two reports of progress.
const PROGRESS_INTERVAL_BYTES: usize = 1 << 20;

/// Bytes of a file per vertex, per corner and per face, for reserving memory: more than common `v` and `f`
/// lines have, so that less than the file's size is reserved.
const BYTES_PER_VERTEX: usize = 72;
const BYTES_PER_CORNER: usize = 12;
const BYTES_PER_FACE: usize = 36;

/// The contents of an OBJ.
#[derive(Default)]
pub(super) struct Statements {
    /// Positions and faces.
    pub soup: PolygonSoup,
    /// The point that positions are relative to, if not zero.
    pub origin: Option<Origin>,
    /// Colours of vertices, up to the last one given; NaN where there is none.
    pub colors: Vec<Vec3>,
    /// The texture coordinates that corners refer to.
    pub uvs: Vec<Vec2>,
    /// The normals that corners refer to.
    pub normals: Vec<Vec3>,
    /// Per corner, up to the last one given, the number of its texture coordinate.
    pub corner_uvs: Vec<u32>,
    /// Per corner, up to the last one given, the number of its normal.
    pub corner_normals: Vec<u32>,
    pub groups: Runs,
    pub group_names: Names,
    pub materials: Runs,
    pub material_names: Names,
    pub smoothing: Runs,
    /// The text of `mtllib` statements.
    pub libraries: Vec<String>,
    /// The number of lines that are statements of the format, readable or not.
    pub known: usize,
    /// The number of lines.
    pub lines: usize,
    pub troubles: Troubles,
    /// Faces that refer to vertices that don't exist, in order.
    pub faces_without_vertices: Vec<u32>,
    object: String,
    group: String,
    /// Faces that refer to vertices further on, with their lines.
    pub(super) forward_faces: Vec<(u32, u32)>,
    /// Texture coordinates and normals (true) further on that corners refer to, with their lines.
    pub(super) forward_attributes: Vec<(u32, u32, bool)>,
    /// Colours in comments, as ZBrush writes them.
    pub(super) comment_colors: Vec<Vec3>,
}

impl Statements {
    /// Reads a file. `progress` receives fractions from 0 to 1; `None` if it stops the work.
    pub(super) fn read(bytes: &[u8], origin: Option<Origin>, progress: &mut Progress) -> Option<Self> {
        let mut this = Self { origin, ..Self::default() };
        this.soup.positions.reserve(bytes.len() / BYTES_PER_VERTEX);
        this.soup.corners.reserve(bytes.len() / BYTES_PER_CORNER);
        this.soup.face_starts.reserve(bytes.len() / BYTES_PER_FACE);
        let mut cursor = Cursor::new(bytes);
        let mut next_report = PROGRESS_INTERVAL_BYTES;
        while !cursor.at_end() {
            cursor.skip_blanks();
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
                next_report = cursor.at + PROGRESS_INTERVAL_BYTES;
                if progress(cursor.at as f32 / bytes.len() as f32).is_break() {
                    return None;
                }
            }
        }
        this.lines = cursor.line - 1;
        this.use_comment_colors();
        this.find_faces_without_vertices();
        this.note_missing_attributes();
        Some(this)
    }

    /// Whether there are vertices and none can be read.
    pub(super) fn is_unreadable(&self) -> bool {
        let count = self.soup.positions.len();
        count > 0 && self.troubles.bad_vertices.count() == count
    }

    /// Reads numbers up to the end of the line: returns how many there are, or `None` if there is something
    /// else among them or they are more than `N`.
    #[inline(always)]
    pub(super) fn numbers<const N: usize>(cursor: &mut Cursor, values: &mut [f32; N]) -> Option<usize> {
        for (count, value) in values.iter_mut().enumerate() {
            cursor.skip_blanks();
            if cursor.is_line_over() {
                return Some(count);
            }
            *value = cursor.float()?;
        }
        cursor.skip_blanks();
        cursor.is_line_over().then_some(N)
    }

    /// Reads any statement but the two common ones. What it doesn't take is skipped with the line.
    fn other(&mut self, cursor: &mut Cursor) {
        let line = cursor.line;
        let word = cursor.word();
        if !cursor.is_token_over() {
            self.troubles.unknown.add(line);
            return;
        }
        self.known += 1;
        match word {
            b"vt" => self.texture_coordinate(cursor),
            b"vn" => self.normal(cursor),
            b"v" => self.vertex(cursor),
            // "fo" stands for a face in older files.
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
            word => match unused_word(word) {
                Some(word) => self.troubles.add_unused(word, line),
                None => {
                    self.known -= 1;
                    self.troubles.unknown.add(line);
                }
            },
        }
    }

    fn start_group(&mut self) {
        let number = match group_label(&self.object, &self.group) {
            Some(label) => self.group_names.number(&label),
            None => NONE,
        };
        self.groups.start(self.soup.face_count(), number);
    }
}

/// The statements of the format that have no meaning here: those of free-form curves and surfaces and of
/// display.
const UNUSED_WORDS: [&str; 28] = [
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

/// The word, if a statement that has no meaning here begins with it.
fn unused_word(word: &[u8]) -> Option<&'static str> {
    UNUSED_WORDS.into_iter().find(|unused| unused.as_bytes() == word)
}
