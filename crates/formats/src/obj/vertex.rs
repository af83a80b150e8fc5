//! Statements of vertices, their texture coordinates and normals.

use super::cursor::Cursor;
use super::statements::Statements;
use crate::soup::origin::Origin;
use glam::{DVec3, Vec2, Vec3};

/// The most numbers that a vertex has: x y z w r g b.
const MAX_NUMBERS: usize = 7;

impl Statements {
    /// Reads `v x y z`, which may have `w`, `r g b`, or both behind it.
    #[inline(always)]
    pub(super) fn vertex(&mut self, cursor: &mut Cursor) {
        self.known += 1;
        let line = cursor.line;
        if self.origin.is_some() {
            return self.far_vertex(cursor);
        }
        let mut values = [0.0; MAX_NUMBERS];
        let count = Self::numbers(cursor, &mut values);
        let [x, y, z, a, b, c, d] = values;
        self.soup.positions.push(Vec3::new(x, y, z));
        if count != Some(3) {
            self.unusual_vertex(line, count, [a, b, c, d]);
        }
    }

    /// Reads a vertex in double precision, relative to the origin.
    #[cold]
    fn far_vertex(&mut self, cursor: &mut Cursor) {
        let line = cursor.line;
        let mut values = [0.0; MAX_NUMBERS];
        let mut count = Some(0);
        for value in &mut values {
            cursor.skip_blanks();
            if cursor.is_line_over() {
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
        cursor.skip_blanks();
        let count = count.filter(|_| cursor.is_line_over());
        let [x, y, z, colors @ ..] = values;
        let position = DVec3::new(x, y, z);
        let place = |origin: &mut Origin| origin.place(position);
        self.soup.positions.push(self.origin.as_mut().map_or(position.as_vec3(), place));
        if count != Some(3) {
            self.unusual_vertex(line, count, colors.map(|c| c as f32));
        }
    }

    /// Completes the vertex added last, which has other than three numbers.
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
        // A fourth coordinate of 1 is the default.
        if matches!(count, Some(4 | 7)) && a != 1.0 {
            self.troubles.fourth_coordinate.add(line);
        }
        if let Some(color) = color {
            self.colors.resize(last, Vec3::NAN);
            self.colors.push(color);
        }
    }

    /// Reads the rest of `vt u v w`, in which v and w may be missing.
    pub(super) fn texture_coordinate(&mut self, cursor: &mut Cursor) {
        let line = cursor.line;
        let mut values = [0.0; 3];
        let count = Self::numbers(cursor, &mut values);
        let [u, v, w] = values;
        let is_readable = matches!(count, Some(1..=3));
        self.uvs.push(if is_readable { Vec2::new(u, v) } else { Vec2::NAN });
        if !is_readable {
            self.troubles.bad_uvs.add(line);
        } else if w != 0.0 {
            self.troubles.third_texture_coordinate.add(line);
        }
    }

    /// Reads the rest of `vn x y z`.
    pub(super) fn normal(&mut self, cursor: &mut Cursor) {
        let line = cursor.line;
        let mut values = [0.0; 3];
        let is_readable = Self::numbers(cursor, &mut values) == Some(3);
        self.normals.push(if is_readable { Vec3::from_array(values) } else { Vec3::NAN });
        if !is_readable {
            self.troubles.bad_normals.add(line);
        }
    }

    /// Reads `#MRGB` and, for each vertex, eight hexadecimal digits of a mask and a colour.
    #[cold]
    pub(super) fn comment_colors(&mut self, cursor: &mut Cursor) {
        cursor.at += 1;
        if cursor.word() != b"MRGB" {
            return;
        }
        for digits in cursor.text().as_bytes().as_chunks::<8>().0 {
            let color = std::str::from_utf8(digits).ok().and_then(|text| u32::from_str_radix(text, 16).ok());
            let Some(color) = color else { return };
            let [_, r, g, b] = color.to_be_bytes();
            self.comment_colors.push(Vec3::new(r.into(), g.into(), b.into()) / 255.0);
        }
    }

    /// Gives vertices the colours in comments, if they have no others.
    pub(super) fn use_comment_colors(&mut self) {
        if self.colors.is_empty() && !self.comment_colors.is_empty() {
            self.colors = std::mem::take(&mut self.comment_colors);
            self.colors.resize(self.soup.positions.len(), Vec3::NAN);
        }
    }
}
