//! From a mesh to the vertex streams of its faces, whole or only what an edit changed.
//!
//! This module knows no GPU: it writes to a [`Sink`], which uploads in the page and is a plain array in
//! tests. Triangles are not indexed: each has three corners of its own, so that a face has its own colour
//! and normal, and the wireframe shader finds a corner's place in its triangle from the vertex index
//! alone. A corner takes 24 bytes: position 12, normal and texture 8, colour and edge flags 4; with texture coordinates
//! 8 more.

use crate::coloring::Coloring;
use crate::corner_normals::{LocalNormals, Shading, WholeNormals};
use crate::face_writer::{FaceWriter, TRIANGLES_PER_WRITE};
use crate::id_set::IdSet;
use crate::slots::{Range, Slots};
use glam::Vec3;
use halfedge::geometry::BitSet;
use halfedge::{Budget, FaceId, Mesh, Touched, VertexId};
use std::sync::Arc;

/// Bytes of a triangle without texture coordinates in all streams together.
pub const TRIANGLE_BYTES: usize = 3 * (12 + 8 + 4);
/// With more separate ranges than this to write, a rebuild is faster than an update.
const MAX_UPDATED_RANGES: usize = 4096;

/// Vertex streams of some triangles, with three entries per triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Corners {
    /// Positions relative to the object's origin.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals as signed normalised integers. The last component says which texture the face shows.
    pub normals: Vec<[i16; 4]>,
    /// The corner's sRGB colour; the last byte says which sides are edges of the mesh, the same for all three
    /// corners: bit i stands for the side from corner i to the next.
    pub colors: Vec<[u8; 4]>,
    /// Texture coordinates, v from the top; empty unless they are wanted.
    pub uvs: Vec<[f32; 2]>,
}

impl Corners {
    /// The number of triangles.
    pub fn triangles(&self) -> usize {
        self.positions.len() / 3
    }

    pub(crate) fn clear(&mut self) {
        self.positions.clear();
        self.normals.clear();
        self.colors.clear();
        self.uvs.clear();
    }

    /// Adds triangles without area.
    pub(crate) fn blank(&mut self, triangles: u32, with_uvs: bool) {
        let corners = self.positions.len() + triangles as usize * 3;
        self.positions.resize(corners, [0.0; 3]);
        self.normals.resize(corners, [0; 4]);
        self.colors.resize(corners, [0; 4]);
        if with_uvs {
            self.uvs.resize(corners, [0.0; 2]);
        }
    }
}

/// Receives the vertex streams.
pub trait Sink {
    /// Discards everything that was written; this many triangles will follow.
    fn reset(&mut self, triangles: u32, with_uvs: bool);
    /// Writes triangles at an index, which may be past the current end.
    fn write(&mut self, first_triangle: u32, corners: &Corners);
}

/// The triangles of so many faces are counted in about the time in which one is written.
const COUNTED_PER_ELEMENT: usize = 8;

/// The state of a rebuild that reads or writes some faces at a time.
#[derive(Clone, Debug)]
pub struct Rebuild {
    stage: Stage,
    next: usize,
    normals: WholeNormals,
}

#[derive(Clone, Debug)]
enum Stage {
    /// Counting the triangles; so many are counted.
    Counting(usize),
    /// Preparing the normals.
    Normals,
    Writing,
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
        let mut rebuilding = self.begin_rebuild(mesh, origin, shading, coloring);
        self.rebuild_faces(mesh, &mut rebuilding, &mut Budget::unlimited(), sink);
    }

    /// Begins a rebuild that [`Buffers::rebuild_faces`] carries out.
    pub fn begin_rebuild(
        &mut self,
        mesh: &Mesh,
        origin: Vec3,
        shading: Shading,
        coloring: Coloring,
    ) -> Rebuild {
        self.origin = origin;
        self.shading = shading;
        self.coloring = coloring;
        self.coloring.restart(mesh);
        self.slots.clear(mesh.face_capacity());
        Rebuild { stage: Stage::Counting(0), next: 0, normals: WholeNormals::new(shading) }
    }

    /// Counts the triangles of more faces; returns their number once it is known.
    fn count_triangles(&self, mesh: &Mesh, rebuilding: &mut Rebuild, budget: &mut Budget) -> Option<u32> {
        let Stage::Counting(counted) = &mut rebuilding.stage else { return None };
        let left = mesh.face_capacity().saturating_sub(rebuilding.next);
        let end = rebuilding.next + budget.take_light(left, COUNTED_PER_ELEMENT);
        let shown = (rebuilding.next..end).map(FaceId::new).filter(|f| self.shows(mesh, *f));
        *counted += shown.map(|f| mesh.face_degree(f).saturating_sub(2)).sum::<usize>();
        rebuilding.next = end;
        (end >= mesh.face_capacity()).then(|| u32::try_from(*counted).unwrap_or(u32::MAX))
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
        if let Stage::Counting(_) = rebuilding.stage {
            let Some(triangles) = self.count_triangles(mesh, rebuilding, budget) else { return true };
            sink.reset(triangles, self.coloring.has_uvs());
            (rebuilding.stage, rebuilding.next) = (Stage::Normals, 0);
        }
        if let Stage::Normals = rebuilding.stage {
            if rebuilding.normals.prepare(mesh, budget) {
                return true;
            }
            rebuilding.stage = Stage::Writing;
        }
        let Rebuild { next, normals, .. } = rebuilding;
        let end = *next + budget.take(mesh.face_capacity().saturating_sub(*next));
        let mut writer = FaceWriter::new(mesh, self.origin, &self.coloring);
        for face in (*next..end).map(FaceId::new) {
            if !self.shows(mesh, face) {
                continue;
            }
            writer.load(face);
            let range = self.slots.acquire(face.index(), writer.triangles());
            writer.emit(range, sink, |corner| normals.at(mesh, corner));
        }
        writer.flush(sink);
        *next = end;
        end < mesh.face_capacity()
    }

    /// Writes the faces that an edit relinked, recoloured or moved a corner of, and for smooth shading the
    /// faces around their corners. Costs O(valence) for a local edit. An edit of much of the mesh, or one
    /// that leaves more gaps than triangles, causes a rebuild.
    pub fn update(&mut self, mesh: &Mesh, touched: &Touched, sink: &mut dyn Sink) {
        let is_whole = touched.everything || self.coloring.misses_uvs(mesh);
        let faces = if is_whole { None } else { self.affected(mesh, touched) };
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
        let mut normals = LocalNormals::new(self.shading, mesh, faces.len());
        let mut writer = FaceWriter::new(mesh, self.origin, &self.coloring);
        for (range, face) in placed {
            writer.load(face);
            writer.emit(range, sink, |corner| normals.at(mesh, corner));
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
    fn affected(&self, mesh: &Mesh, touched: &Touched) -> Option<Vec<FaceId>> {
        let limit = mesh.face_count() / 4 * 3 + 64;
        if touched.vertices.len() + touched.halfedges.len() / 2 + touched.faces.len() > limit * 4 {
            return None;
        }
        let mut faces = IdSet::default();
        touched.for_each_face(mesh, |f| faces.insert(f.index()));
        if faces.len() > limit {
            return None;
        }
        if self.shading != Shading::Flat || self.coloring.depends_on_neighbours() {
            // A corner changes with any face around its vertex.
            let mut rim = IdSet::default();
            let vertices = touched.vertices.iter().filter(|v| mesh.has_vertex(**v));
            let halfedges = touched.halfedges.iter().copied().filter(|&h| mesh.has_halfedge(h));
            vertices.for_each(|v| rim.insert(v.index()));
            halfedges.flat_map(|h| [mesh.from(h), mesh.to(h)]).for_each(|v| rim.insert(v.index()));
            for face in faces.iter().map(FaceId::new).filter(|f| mesh.has_face(*f)) {
                mesh.face_vertices(face).for_each(|v| rim.insert(v.index()));
            }
            for v in rim.iter().map(VertexId::new) {
                mesh.vertex_faces(v).for_each(|f| faces.insert(f.index()));
            }
            if faces.len() > limit {
                return None;
            }
        }
        Some(faces.iter().map(FaceId::new).collect())
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
