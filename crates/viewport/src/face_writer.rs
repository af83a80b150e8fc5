//! From faces to their triangles' vertex streams.

use crate::buffers::{Corners, Sink};
use crate::coloring::{Coloring, Columns};
use crate::corner_normals::pack;
use crate::materials::{MISSING_UV, from_top};
use crate::slots::Range;
use glam::Vec3;
use halfedge::geometry::PolygonTriangulator;
use halfedge::{FaceId, HalfedgeId, Mesh};
use surface::normals;

/// Triangles written to the sink at once.
pub(crate) const TRIANGLES_PER_WRITE: usize = 1 << 14;

/// Turns faces into triangles and combines adjacent ones into one write.
pub(crate) struct FaceWriter<'m> {
    mesh: &'m Mesh,
    columns: Columns<'m>,
    coloring: &'m Coloring,
    origin: Vec3,
    face: Option<FaceId>,
    /// The half-edges that start at the face's corners.
    corners: Vec<HalfedgeId>,
    points: Vec<Vec3>,
    triangulator: PolygonTriangulator,
    staged: Corners,
    staged_first: u32,
}

impl<'m> FaceWriter<'m> {
    pub fn new(mesh: &'m Mesh, origin: Vec3, coloring: &'m Coloring) -> Self {
        Self {
            mesh,
            columns: Columns::new(mesh),
            coloring,
            origin,
            face: None,
            corners: Vec::new(),
            points: Vec::new(),
            triangulator: PolygonTriangulator::new(),
            staged: Corners::default(),
            staged_first: 0,
        }
    }

    /// Takes the next face.
    pub fn load(&mut self, face: FaceId) {
        self.face = Some(face);
        self.corners.clear();
        self.corners.extend(self.mesh.face_halfedges(face));
        self.points.clear();
        self.points.extend(self.corners.iter().map(|&h| self.mesh.position(self.mesh.from(h))));
    }

    /// The number of the face's triangles.
    pub fn triangles(&self) -> u32 {
        self.points.len().saturating_sub(2) as u32
    }

    /// Writes the face with the packed normals that `corner_normal` returns for the half-edges at its corners, or
    /// the face's own normal where that is zero.
    pub fn emit(
        &mut self,
        range: Range,
        sink: &mut dyn Sink,
        mut corner_normal: impl FnMut(HalfedgeId) -> [i16; 4],
    ) {
        self.seek(range.first, sink);
        let (mesh, face, coloring) = (self.mesh, self.face, self.coloring);
        let mut flat = None;
        let mut face_normal =
            || *flat.get_or_insert_with(|| face.map_or([0; 4], |f| pack(normals::face_normal(mesh, f))));
        let colors = face.map(|f| coloring.face(mesh, &self.columns, f));
        let texture = face.map(|f| coloring.texture(mesh, f, self.columns.uvs, &self.corners));
        let corners = self.points.len() as u32;
        let triangles: &[[u32; 3]] =
            if corners == 3 { &[[0, 1, 2]] } else { self.triangulator.triangulate(&self.points) };
        let mut written = 0;
        for triangle in triangles {
            let [i, j, k] = *triangle;
            let flag = |a: u32, b: u32, bit: u8| if (a + 1) % corners == b { bit } else { 0 };
            let flags = flag(i, j, 1) | flag(j, k, 2) | flag(k, i, 4);
            let at = triangle.map(|i| self.points.get(i as usize).copied().unwrap_or(self.origin));
            let mut normals = [[0; 4]; 3];
            let mut shown = [[0; 4]; 3];
            let mut uvs = [[0.0; 2]; 3];
            for (((normal, color), uv), &corner) in
                normals.iter_mut().zip(&mut shown).zip(&mut uvs).zip(triangle)
            {
                let Some(&h) = self.corners.get(corner as usize) else { continue };
                let own = corner_normal(h);
                *normal = if own == [0; 4] { face_normal() } else { own };
                let mut rgb = colors.as_ref().map_or([0; 3], |colors| colors.at(mesh.from(h)));
                if let Some(texture) = &texture {
                    normal[3] = texture.mark;
                    rgb = texture.tint(rgb);
                    *uv = self.columns.uvs.get(h.index()).copied().map_or(MISSING_UV, from_top);
                }
                let [r, g, b] = rgb;
                *color = [r, g, b, flags];
            }
            if coloring.has_uvs() {
                self.staged.uvs.extend_from_slice(&uvs);
            }
            self.staged.positions.extend_from_slice(&at.map(|p| (p - self.origin).to_array()));
            self.staged.normals.extend_from_slice(&normals);
            self.staged.colors.extend_from_slice(&shown);
            written += 1;
        }
        self.staged.blank(range.count.saturating_sub(written), coloring.has_uvs());
    }

    /// Writes triangles without area.
    pub fn blank(&mut self, range: Range, sink: &mut dyn Sink) {
        self.seek(range.first, sink);
        self.staged.blank(range.count, self.coloring.has_uvs());
    }

    /// Continues at a triangle; flushes first unless that triangle is the next one.
    fn seek(&mut self, triangle: u32, sink: &mut dyn Sink) {
        let end = self.staged_first as usize + self.staged.triangles();
        if triangle as usize != end || self.staged.triangles() >= TRIANGLES_PER_WRITE {
            self.flush(sink);
            self.staged_first = triangle;
        }
    }

    pub fn flush(&mut self, sink: &mut dyn Sink) {
        if self.staged.triangles() > 0 {
            sink.write(self.staged_first, &self.staged);
            self.staged_first += self.staged.triangles() as u32;
            self.staged.clear();
        }
    }
}
