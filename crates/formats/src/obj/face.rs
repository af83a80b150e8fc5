//! Statements of faces.

use super::cursor::Cursor;
use super::statements::Statements;
use halfedge::NONE;

/// Why a face is left out.
enum BadFace {
    Unreadable,
    MissingVertex,
}

/// The index, from 0, of a vertex, texture coordinate or normal that a face names by `number`: counted from 1,
/// or back from the last of `count` if negative. `None` for 0 and before the first one.
#[inline(always)]
fn resolve(number: i64, count: usize) -> Option<u32> {
    let index = if number > 0 { number - 1 } else { number.checked_add(count as i64)? };
    if number == 0 { None } else { u32::try_from(index).ok().filter(|&index| index != NONE) }
}

impl Statements {
    /// Reads `f` with corners `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    #[inline(always)]
    pub(super) fn face(&mut self, cursor: &mut Cursor) {
        self.known += 1;
        let line = cursor.line;
        let start = self.soup.corners.len();
        let mut is_forward = false;
        let result = loop {
            cursor.skip_blanks();
            if cursor.is_line_over() {
                break Ok(());
            }
            let Some(number) = cursor.integer() else { break Err(BadFace::Unreadable) };
            let Some(vertex) = resolve(number, self.soup.positions.len()) else {
                break Err(BadFace::MissingVertex);
            };
            is_forward |= vertex as usize >= self.soup.positions.len();
            self.soup.corners.push(vertex);
            if cursor.peek() == b'/' && self.corner_attributes(cursor, line).is_none() {
                break Err(BadFace::Unreadable);
            }
            if !cursor.is_token_over() {
                break Err(BadFace::Unreadable);
            }
        };
        let corners = self.soup.corners.len() - start;
        if result.is_ok() && corners >= 3 {
            if is_forward {
                self.forward_faces.push((self.soup.face_count() as u32, line as u32));
            }
            self.soup.face_starts.push(self.soup.corners.len() as u32);
        } else {
            self.leave_out(start, line, result);
        }
    }

    /// Reads `/vt`, `//vn` or `/vt/vn` behind the corner added last. `None` if it can't be read.
    #[inline(always)]
    fn corner_attributes(&mut self, cursor: &mut Cursor, line: usize) -> Option<()> {
        let corner = self.soup.corners.len() - 1;
        cursor.at += 1;
        // Some files have `1/` and `1//`, which name nothing.
        if cursor.peek() != b'/' && !cursor.is_token_over() {
            let uv = resolve(cursor.integer()?, self.uvs.len());
            if uv.is_none_or(|uv| uv as usize >= self.uvs.len()) {
                self.forward_attributes.push((uv.unwrap_or(NONE), line as u32, false));
            }
            self.corner_uvs.resize(corner, NONE);
            self.corner_uvs.push(uv.unwrap_or(NONE));
        }
        if cursor.peek() == b'/' {
            cursor.at += 1;
            if !cursor.is_token_over() {
                let normal = resolve(cursor.integer()?, self.normals.len());
                if normal.is_none_or(|normal| normal as usize >= self.normals.len()) {
                    self.forward_attributes.push((normal.unwrap_or(NONE), line as u32, true));
                }
                self.corner_normals.resize(corner, NONE);
                self.corner_normals.push(normal.unwrap_or(NONE));
            }
        }
        Some(())
    }

    /// Removes the corners of a face that can't be used, and notes why.
    #[cold]
    fn leave_out(&mut self, start: usize, line: usize, result: Result<(), BadFace>) {
        self.soup.corners.truncate(start);
        self.corner_uvs.truncate(start);
        self.corner_normals.truncate(start);
        while self.forward_attributes.last().is_some_and(|&(_, at, _)| at as usize == line) {
            self.forward_attributes.pop();
        }
        match result {
            Ok(()) => self.troubles.small_faces.add(line),
            Err(BadFace::Unreadable) => self.troubles.bad_faces.add(line),
            Err(BadFace::MissingVertex) => self.troubles.missing_vertex.add(line),
        }
    }

    /// Finds the faces that refer to vertices that never came.
    pub(super) fn find_faces_without_vertices(&mut self) {
        let count = self.soup.positions.len();
        for &(face, line) in &self.forward_faces {
            if self.soup.face(face as usize).iter().any(|&v| v as usize >= count) {
                self.faces_without_vertices.push(face);
                self.troubles.missing_vertex.add(line as usize);
            }
        }
    }

    /// Notes the corners that refer to texture coordinates or normals that never came.
    pub(super) fn note_missing_attributes(&mut self) {
        for &(number, line, is_normal) in &self.forward_attributes {
            let count = if is_normal { self.normals.len() } else { self.uvs.len() };
            if number as usize >= count {
                self.troubles.missing_attribute.add(line as usize);
            }
        }
    }
}
