//! From a mesh to the vertex streams of its faces, whole or only what an edit changed.
//!
//! This module knows no GPU: it writes to a [`Sink`], which uploads in the page and is a plain array in
//! tests. Triangles are not indexed: each has three corners of its own, so that a face has its own colour
//! and normal, and the wireframe shader finds a corner's place in its triangle from the vertex index
//! alone. A corner takes 24 bytes: position 12, normal 8, colour and edge flags 4.

use crate::coloring::{Coloring, Columns};
use crate::corner_normals::{LocalNormals, Shading, WholeNormals, pack};
use crate::slots::{Range, Slots};
use glam::Vec3;
use halfedge::geometry::{BitSet, PolygonTriangulator};
use halfedge::{Budget, FaceId, HalfedgeId, Mesh, Touched, VertexId};
use std::collections::BTreeSet;
use std::sync::Arc;
use surface::normals;

/// Bytes of a triangle in all streams together.
pub const TRIANGLE_BYTES: usize = 3 * (12 + 8 + 4);
/// Triangles written to the sink at once.
const TRIANGLES_PER_WRITE: usize = 1 << 14;
/// With more separate ranges than this to write, a rebuild is faster than an update.
const MAX_UPDATED_RANGES: usize = 4096;

/// Vertex streams of some triangles, with three entries per triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Corners {
    /// Positions relative to the object's origin.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals as signed normalised integers; the last component is unused.
    pub normals: Vec<[i16; 4]>,
    /// The corner's sRGB colour; the last byte says which sides are edges of the mesh, the same for all three
    /// corners: bit i stands for the side from corner i to the next.
    pub colors: Vec<[u8; 4]>,
}

impl Corners {
    /// The number of triangles.
    pub fn triangles(&self) -> usize {
        self.positions.len() / 3
    }

    fn clear(&mut self) {
        self.positions.clear();
        self.normals.clear();
        self.colors.clear();
    }

    /// Adds triangles without area.
    fn blank(&mut self, triangles: u32) {
        let corners = self.positions.len() + triangles as usize * 3;
        self.positions.resize(corners, [0.0; 3]);
        self.normals.resize(corners, [0; 4]);
        self.colors.resize(corners, [0; 4]);
    }
}

/// Receives the vertex streams.
pub trait Sink {
    /// Discards everything that was written; this many triangles will follow.
    fn reset(&mut self, triangles: u32);
    /// Writes triangles at an index, which may be past the current end.
    fn write(&mut self, first_triangle: u32, corners: &Corners);
}

/// The state of a rebuild that writes some faces at a time.
#[derive(Clone, Debug)]
pub struct Rebuild {
    next: usize,
    normals: WholeNormals,
}

/// The layout of an object's buffers: which triangles each face has, and the origin of positions.
#[derive(Clone, Debug, Default)]
pub struct Buffers {
    slots: Slots,
    origin: Vec3,
    shading: Shading,
    coloring: Coloring,
    /// Faces that have no triangles.
    hidden: Arc<BitSet>,
}

impl Buffers {
    /// Sets the faces that have no triangles, for the next rebuild; pass those that changed to [`Buffers::update`].
    pub fn set_hidden(&mut self, faces: &Arc<BitSet>) {
        self.hidden.clone_from(faces);
    }

    /// The faces that have no triangles.
    pub fn hidden(&self) -> &Arc<BitSet> {
        &self.hidden
    }

    /// Whether a face exists and isn't hidden.
    fn shows(&self, mesh: &Mesh, face: FaceId) -> bool {
        mesh.has_face(face) && !self.hidden.contains(face.index())
    }

    /// The world position that the positions in the streams are relative to: the middle of the mesh at the
    /// last rebuild.
    pub fn origin(&self) -> Vec3 {
        self.origin
    }

    /// Which normals the streams have.
    pub fn shading(&self) -> Shading {
        self.shading
    }

    /// What gives the streams their colours.
    pub fn coloring(&self) -> &Coloring {
        &self.coloring
    }

    /// The number of triangles to draw; unused ones among them have no area.
    pub fn triangles(&self) -> u32 {
        self.slots.end()
    }

    /// The triangles of a face.
    pub fn range(&self, face: FaceId) -> Range {
        self.slots.of(face.index())
    }

    /// Heap bytes in use: 8 for each face id.
    pub fn bytes(&self) -> usize {
        self.slots.bytes()
    }

    /// Writes the whole mesh relative to this origin. Costs O(mesh).
    pub fn rebuild(
        &mut self,
        mesh: &Mesh,
        origin: Vec3,
        shading: Shading,
        coloring: Coloring,
        sink: &mut dyn Sink,
    ) {
        let mut rebuilding = self.begin_rebuild(mesh, origin, shading, coloring, sink);
        self.rebuild_faces(mesh, &mut rebuilding, &mut Budget::unlimited(), sink);
    }

    /// Begins a rebuild that [`Buffers::rebuild_faces`] carries out. Costs O(mesh), little for each face.
    pub fn begin_rebuild(
        &mut self,
        mesh: &Mesh,
        origin: Vec3,
        shading: Shading,
        coloring: Coloring,
        sink: &mut dyn Sink,
    ) -> Rebuild {
        self.origin = origin;
        self.shading = shading;
        self.coloring = coloring;
        self.coloring.restart();
        self.slots.clear(mesh.face_capacity());
        let shown = mesh.faces().filter(|f| self.shows(mesh, *f));
        let total: usize = shown.map(|f| mesh.face_degree(f).saturating_sub(2)).sum();
        sink.reset(u32::try_from(total).unwrap_or(u32::MAX));
        Rebuild { next: 0, normals: WholeNormals::new(mesh, shading) }
    }

    /// Writes more faces, as many as the budget has ids for; returns whether there are any left. Once all are
    /// written, pass edits made since [`Buffers::begin_rebuild`] to [`Buffers::update`].
    pub fn rebuild_faces(
        &mut self,
        mesh: &Mesh,
        rebuilding: &mut Rebuild,
        budget: &mut Budget,
        sink: &mut dyn Sink,
    ) -> bool {
        if self.coloring.measure(mesh, budget) {
            return true;
        }
        let Rebuild { next, normals } = rebuilding;
        let end = *next + budget.take(mesh.face_capacity().saturating_sub(*next));
        let mut writer = Writer::new(mesh, self.origin);
        for face in (*next..end).map(FaceId::new) {
            if !self.shows(mesh, face) {
                continue;
            }
            writer.load(face);
            let range = self.slots.acquire(face.index(), writer.triangles());
            writer.emit(range, sink, &self.coloring, |corner| normals.at(mesh, corner));
        }
        writer.flush(sink);
        *next = end;
        end < mesh.face_capacity()
    }

    /// Writes the faces that an edit relinked, recoloured or moved a corner of, and for smooth shading the
    /// faces around their corners. Costs O(valence) for a local edit. An edit of much of the mesh, or one
    /// that leaves more gaps than triangles, causes a rebuild.
    pub fn update(&mut self, mesh: &Mesh, touched: &Touched, sink: &mut dyn Sink) {
        let faces = if touched.everything { None } else { self.affected(mesh, touched) };
        let Some(faces) = faces else {
            return self.rebuild_alike(mesh, sink);
        };
        let (hidden, slots) = (&self.hidden, &mut self.slots);
        let shows = |face: FaceId| mesh.has_face(face) && !hidden.contains(face.index());
        let wanted = |face: FaceId| {
            if shows(face) { mesh.face_degree(face).saturating_sub(2) as u32 } else { 0 }
        };
        for &face in &faces {
            slots.release(face.index(), wanted(face));
        }
        let mut placed: Vec<(Range, FaceId)> = Vec::with_capacity(faces.len());
        for &face in faces.iter().filter(|f| shows(**f)) {
            placed.push((slots.acquire(face.index(), wanted(face)), face));
        }
        placed.sort_unstable();
        let abandoned = self.slots.take_abandoned();
        let ranges = placed.iter().map(|(range, _)| *range).chain(abandoned.iter().copied());
        let gaps = self.slots.end() - self.slots.live();
        if count_runs(ranges) > MAX_UPDATED_RANGES || gaps > self.slots.live().max(TRIANGLES_PER_WRITE as u32)
        {
            return self.rebuild_alike(mesh, sink);
        }

        self.coloring.follow(mesh, &faces);
        let mut normals = LocalNormals::new(self.shading);
        let mut writer = Writer::new(mesh, self.origin);
        for (range, face) in placed {
            writer.load(face);
            writer.emit(range, sink, &self.coloring, |corner| normals.at(mesh, corner));
        }
        for range in abandoned {
            writer.blank(range, sink);
        }
        writer.flush(sink);
    }

    /// Writes the whole mesh again as before.
    fn rebuild_alike(&mut self, mesh: &Mesh, sink: &mut dyn Sink) {
        let coloring = std::mem::take(&mut self.coloring);
        self.rebuild(mesh, self.origin, self.shading, coloring, sink);
    }

    /// The faces whose triangles an edit changed, and the ids of removed faces; none if there are so many
    /// that a rebuild is faster.
    fn affected(&self, mesh: &Mesh, touched: &Touched) -> Option<BTreeSet<FaceId>> {
        let limit = mesh.face_count() / 2 + 64;
        if touched.vertices.len() + touched.halfedges.len() / 2 + touched.faces.len() > limit * 4 {
            return None;
        }
        let mut faces: BTreeSet<FaceId> = touched.faces.iter().copied().collect();
        let vertices = touched.vertices.iter().copied().filter(|&v| mesh.has_vertex(v));
        let halfedges = touched.halfedges.iter().copied().filter(|&h| mesh.has_halfedge(h));
        for v in vertices.clone() {
            faces.extend(mesh.vertex_faces(v));
        }
        faces.extend(halfedges.clone().filter_map(|h| mesh.face_of(h)));
        if faces.len() > limit {
            return None;
        }
        if self.shading != Shading::Flat || self.coloring.depends_on_neighbours() {
            // A corner changes with any face around its vertex.
            let mut rim: BTreeSet<VertexId> = vertices.collect();
            rim.extend(halfedges.flat_map(|h| [mesh.from(h), mesh.to(h)]));
            for &face in faces.iter().filter(|f| mesh.has_face(**f)) {
                rim.extend(mesh.face_vertices(face));
            }
            for v in rim {
                faces.extend(mesh.vertex_faces(v));
                if faces.len() > limit {
                    return None;
                }
            }
        }
        Some(faces)
    }
}

/// The number of separate ranges after joining adjacent ones; the ranges are sorted or nearly so.
fn count_runs(ranges: impl Iterator<Item = Range>) -> usize {
    let mut end = None;
    ranges
        .filter(|range| {
            let starts = end != Some(range.first);
            end = Some(range.first + range.count);
            starts
        })
        .count()
}

/// Turns faces into triangles and combines adjacent ones into one write.
struct Writer<'m> {
    mesh: &'m Mesh,
    columns: Columns<'m>,
    origin: Vec3,
    face: Option<FaceId>,
    /// The half-edges that start at the face's corners.
    corners: Vec<HalfedgeId>,
    points: Vec<Vec3>,
    triangulator: PolygonTriangulator,
    staged: Corners,
    staged_first: u32,
}

impl<'m> Writer<'m> {
    fn new(mesh: &'m Mesh, origin: Vec3) -> Self {
        Self {
            mesh,
            columns: Columns::new(mesh),
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
    fn load(&mut self, face: FaceId) {
        self.face = Some(face);
        self.corners.clear();
        self.corners.extend(self.mesh.face_halfedges(face));
        self.points.clear();
        self.points.extend(self.corners.iter().map(|&h| self.mesh.position(self.mesh.from(h))));
    }

    /// The number of the face's triangles.
    fn triangles(&self) -> u32 {
        self.points.len().saturating_sub(2) as u32
    }

    /// Writes the face with the packed normals that `corner_normal` returns for the half-edges at its corners, or
    /// the face's own normal where that is zero.
    fn emit(
        &mut self,
        range: Range,
        sink: &mut dyn Sink,
        coloring: &Coloring,
        mut corner_normal: impl FnMut(HalfedgeId) -> [i16; 4],
    ) {
        self.seek(range.first, sink);
        let (mesh, face) = (self.mesh, self.face);
        let mut flat = None;
        let mut face_normal =
            || *flat.get_or_insert_with(|| face.map_or([0; 4], |f| pack(normals::face_normal(mesh, f))));
        let colors = face.map(|f| coloring.face(mesh, &self.columns, f));
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
            for ((normal, color), &corner) in normals.iter_mut().zip(&mut shown).zip(triangle) {
                let Some(&h) = self.corners.get(corner as usize) else { continue };
                let own = corner_normal(h);
                *normal = if own == [0; 4] { face_normal() } else { own };
                let [r, g, b] = colors.as_ref().map_or([0; 3], |colors| colors.at(mesh.from(h)));
                *color = [r, g, b, flags];
            }
            self.staged.positions.extend_from_slice(&at.map(|p| (p - self.origin).to_array()));
            self.staged.normals.extend_from_slice(&normals);
            self.staged.colors.extend_from_slice(&shown);
            written += 1;
        }
        self.staged.blank(range.count.saturating_sub(written));
    }

    /// Writes triangles without area.
    fn blank(&mut self, range: Range, sink: &mut dyn Sink) {
        self.seek(range.first, sink);
        self.staged.blank(range.count);
    }

    /// Continues at a triangle; flushes first unless that triangle is the next one.
    fn seek(&mut self, triangle: u32, sink: &mut dyn Sink) {
        let end = self.staged_first as usize + self.staged.triangles();
        if triangle as usize != end || self.staged.triangles() >= TRIANGLES_PER_WRITE {
            self.flush(sink);
            self.staged_first = triangle;
        }
    }

    fn flush(&mut self, sink: &mut dyn Sink) {
        if self.staged.triangles() > 0 {
            sink.write(self.staged_first, &self.staged);
            self.staged_first += self.staged.triangles() as u32;
            self.staged.clear();
        }
    }
}
