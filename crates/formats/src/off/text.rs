//! Reading the vertices and faces of an OFF in text.

use super::contents::{Contents, FaceColor, VertexExtras};
use super::keyword::Keyword;
use crate::error::ReadError;
use crate::soup::origin::Origin;
use crate::text::scan::{Scan, Ticker};
use glam::{DVec3, Vec2, Vec3};
use halfedge::{NONE, Progress};

/// How many lines of vertices are looked at for the order of normals and colours.
const SAMPLE_LINES: u64 = 64;

/// How far the length of a normal may be from 1.
const NORMAL_TOLERANCE: f32 = 0.01;

/// Reads what comes after the counts.
pub(super) struct TextReader<'a> {
    scan: Scan<'a>,
    keyword: Keyword,
    /// How many coordinates a position has.
    dimensions: usize,
    color_first: bool,
    ticker: Ticker,
    /// The numbers of a vertex's line.
    row: Vec<f32>,
    pub contents: Contents,
}

impl<'a> TextReader<'a> {
    /// A reader of what `scan` is before.
    pub(super) fn new(scan: Scan<'a>, size: usize, keyword: Keyword, dimensions: usize) -> Self {
        let ticker = Ticker::new(size);
        let contents = Contents::default();
        Self {
            scan,
            keyword,
            dimensions,
            color_first: keyword.color_first,
            ticker,
            row: Vec::new(),
            contents,
        }
    }

    /// Reads as many vertices as there are of `count`; gives how many.
    pub(super) fn vertices(
        &mut self,
        count: u64,
        faces: u64,
        origin: &mut Option<Origin>,
        progress: &mut Progress,
    ) -> Result<u64, ReadError> {
        let is_one_per_line = self.is_one_per_line(count, faces);
        if is_one_per_line && self.keyword.normal && self.keyword.color {
            self.color_first = self.puts_colors_first(count);
        }
        for number in 0..count {
            if self.scan.at_end() {
                return Ok(number);
            }
            if is_one_per_line {
                self.vertex_line(origin);
            } else {
                self.vertex_words(origin);
            }
            self.ticker.tick(self.scan.at, progress)?;
        }
        Ok(count)
    }

    /// How many numbers a vertex has at least.
    fn least_numbers(&self) -> usize {
        let Keyword { texture, color, normal, .. } = self.keyword;
        self.dimensions + 3 * usize::from(normal) + 3 * usize::from(color) + 2 * usize::from(texture)
    }

    /// Whether each vertex has a line of its own, as in most files, so that what is more on a line, or less,
    /// is about that vertex.
    fn is_one_per_line(&self, vertices: u64, faces: u64) -> bool {
        let mut scan = self.scan.clone();
        scan.skip_blanks();
        let mut first = 0;
        while scan.more_on_line() {
            scan.word();
            first += 1;
        }
        let least = self.least_numbers();
        if first == least || (self.keyword.color && first == least + 1) {
            return true;
        }
        let mut lines = 1u64;
        while !scan.at_end() {
            lines += 1;
            scan.skip_line();
        }
        if first < least {
            // Less on a line than a vertex has: is the rest on the next one?
            return first >= self.dimensions && lines < vertices.saturating_mul(2).saturating_add(faces);
        }
        lines >= vertices.saturating_add(faces) || !first.is_multiple_of(least)
    }

    /// Whether colours come before normals: where only one of both orders gives normals of length 1, that one.
    fn puts_colors_first(&self, vertices: u64) -> bool {
        let mut scan = self.scan.clone();
        let fixed = self.dimensions + 3 + 2 * usize::from(self.keyword.texture);
        let (mut normals_fit, mut colors_fit) = (true, true);
        for _ in 0..vertices.min(SAMPLE_LINES) {
            scan.skip_blanks();
            let mut row = Vec::new();
            while scan.more_on_line() {
                row.push(scan.float().unwrap_or(f32::NAN));
            }
            let is_normal = |at: usize| {
                let Some(&[x, y, z]) = row.get(at..).and_then(|rest| rest.first_chunk()) else { return true };
                let length = Vec3::new(x, y, z).length();
                length == 0.0 || (length - 1.0).abs() < NORMAL_TOLERANCE
            };
            let channels = row.len().saturating_sub(fixed);
            normals_fit &= is_normal(self.dimensions);
            colors_fit &= is_normal(self.dimensions + channels);
        }
        if normals_fit == colors_fit { self.keyword.color_first } else { colors_fit }
    }

    /// A position of which the numbers come next.
    fn position(&mut self, origin: &mut Option<Origin>) -> Option<Vec3> {
        if self.dimensions == 3 && !self.keyword.homogeneous {
            return self.scan.position(origin);
        }
        let mut coordinates = [Some(0.0), Some(0.0), Some(0.0)];
        let mut last = None;
        let own = self.dimensions - usize::from(self.keyword.homogeneous);
        for i in 0..self.dimensions {
            last = self.scan.double();
            if let Some(coordinate) = coordinates.get_mut(i).filter(|_| i < own) {
                *coordinate = last;
            }
        }
        let number = self.contents.soup.positions.len();
        if own > 3 {
            self.contents.troubles.more_dimensions.add(number);
        }
        let [x, y, z] = coordinates;
        let mut position = DVec3::new(x?, y?, z?);
        if self.keyword.homogeneous {
            let w = last?;
            if w != 1.0 {
                self.contents.troubles.divided_vertices.add(number);
            }
            // A point at infinity stays where the other coordinates say.
            position /= if w == 0.0 { 1.0 } else { w };
        }
        Some(origin.as_mut().map_or(position.as_vec3(), |origin| origin.place(position)))
    }

    /// A vertex that is the next line.
    fn vertex_line(&mut self, origin: &mut Option<Origin>) {
        self.scan.skip_blanks();
        let start = self.scan.at;
        self.row.clear();
        while self.scan.more_on_line() {
            self.row.push(self.scan.float().unwrap_or(f32::NAN));
        }
        let end = self.scan.at;
        let is_simple = origin.is_none() && self.dimensions == 3 && !self.keyword.homogeneous;
        let position = match self.row.as_slice() {
            &[x, y, z, ..] if is_simple => Some(Vec3::new(x, y, z)).filter(|position| !position.is_nan()),
            row if row.len() < self.dimensions => None,
            _ => {
                self.scan.at = start;
                self.position(origin)
            }
        };
        self.scan.at = end;
        let extras = self.extras();
        self.contents.push_vertex(position, extras);
    }

    /// What comes after the position on a vertex's line.
    fn extras(&mut self) -> VertexExtras {
        let row = self.row.get(self.dimensions..).unwrap_or_default();
        let Keyword { texture, color, normal, .. } = self.keyword;
        let fixed = 3 * usize::from(normal) + 2 * usize::from(texture);
        if row.is_empty() && fixed == 0 && !color {
            return VertexExtras::default();
        }
        let number = self.contents.soup.positions.len();
        let troubles = &mut self.contents.troubles;
        let Some(channels) = row.len().checked_sub(fixed) else {
            troubles.incomplete_vertices.add(number);
            return VertexExtras::default();
        };
        match channels {
            0 if color => troubles.incomplete_vertices.add(number),
            1 if color => troubles.palette.add(number),
            0 | 3 => {}
            4 => {
                let opacity = row.get(if self.color_first || !normal { 3 } else { 6 });
                if opacity.is_some_and(|opacity| *opacity != 1.0 && *opacity != 255.0) {
                    troubles.opacities.add(number);
                }
            }
            _ => troubles.long_vertices.add(number),
        }
        let has_color = matches!(channels, 3 | 4);
        let vector = |at: usize| row.get(at..)?.first_chunk().map(|chunk| Vec3::from_array(*chunk));
        let (normal_at, color_at) = if self.color_first { (channels, 0) } else { (0, fixed.min(3)) };
        let color_at = if normal { color_at } else { 0 };
        let uv_at = row.len() - 2 * usize::from(texture);
        VertexExtras {
            normal: vector(normal_at).filter(|_| normal),
            color: vector(color_at).filter(|_| has_color),
            uv: row
                .get(uv_at..)
                .and_then(<[f32]>::first_chunk)
                .map(|uv| Vec2::from_array(*uv))
                .filter(|_| texture),
        }
    }

    /// A vertex whose numbers come next, wherever lines end.
    fn vertex_words(&mut self, origin: &mut Option<Origin>) {
        let position = self.position(origin);
        let Keyword { texture, color, normal, .. } = self.keyword;
        let mut next = || self.scan.float().unwrap_or(f32::NAN);
        let normal = normal.then(|| Vec3::new(next(), next(), next()));
        let color = color.then(|| Vec3::new(next(), next(), next()));
        let uv = texture.then(|| Vec2::new(next(), next()));
        // An opacity.
        if color.is_some() && uv.is_none() && self.scan.more_on_line() {
            self.scan.float();
        }
        self.contents.push_vertex(position, VertexExtras { normal, color, uv });
    }

    /// Reads as many faces as there are of `count`; gives how many.
    pub(super) fn faces(&mut self, count: u64, progress: &mut Progress) -> Result<u64, ReadError> {
        for number in 0..count {
            if self.scan.at_end() {
                return Ok(number);
            }
            let corners = &mut self.contents.soup.corners;
            let start = corners.len();
            let mut readable = false;
            if let Some(corner_count) = self.scan.integer() {
                readable = corner_count >= 0;
                for _ in 0..corner_count {
                    if !self.scan.more_on_line() && self.scan.at_end() {
                        readable = false;
                        break;
                    }
                    // What is no vertex number is one that no vertex has: the build drops the face.
                    let vertex = self.scan.integer().and_then(|v| u32::try_from(v).ok()).unwrap_or(NONE);
                    corners.push(vertex);
                }
            }
            let color = self.face_color(number as usize);
            if readable {
                self.contents.end_face(color);
            } else {
                self.contents.soup.corners.truncate(start);
                self.contents.troubles.bad_faces.add(number as usize);
            }
            self.ticker.tick(self.scan.at, progress)?;
        }
        Ok(count)
    }

    /// The colour in the rest of a face's line: three or four numbers.
    fn face_color(&mut self, face: usize) -> Option<FaceColor> {
        let start = self.scan.at;
        self.row.clear();
        while self.scan.more_on_line() {
            self.row.push(self.scan.float().unwrap_or(f32::NAN));
        }
        let troubles = &mut self.contents.troubles;
        let &[r, g, b, ref more @ ..] = self.row.as_slice() else {
            match self.row.len() {
                0 => {}
                1 => troubles.palette.add(face),
                _ => troubles.long_faces.add(face),
            }
            return None;
        };
        match more {
            [] => {}
            [opacity] if *opacity == 1.0 || *opacity == 255.0 => {}
            [_] => troubles.opacities.add(face),
            _ => troubles.long_faces.add(face),
        }
        Some(FaceColor { channels: Vec3::new(r, g, b), has_points: self.scan.has_point_since(start) })
    }
}
