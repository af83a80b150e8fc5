//! The marks of an object on the GPU.

use super::stream::Stream;
use crate::marks::{Mark, MarkSearch, Marks};
use glam::Vec3;
use halfedge::geometry::BitSet;
use halfedge::{Budget, InParts, Mesh};
use std::sync::Arc;

/// Bytes of a line.
pub const LINE_BYTES: u64 = 24;

/// The marks that were found last, drawn until another search has ended: each change of the mesh begins one.
pub struct MarkBuffers {
    /// The kinds that the buffers have.
    has: Marks,
    /// What positions are relative to.
    pub origin: Vec3,
    pub lines: [Stream; Mark::ALL.len()],
    pub points: Stream,
    hidden: Arc<BitSet>,
    /// Whether the mesh has changed since the buffers, or the search, began.
    is_stale: bool,
    search: Option<(MarkSearch, Vec3)>,
}

impl MarkBuffers {
    pub fn new() -> Self {
        Self {
            has: Marks::default(),
            origin: Vec3::ZERO,
            lines: Mark::ALL.map(|_| Stream::new("marked edges")),
            points: Stream::new("marked vertices"),
            hidden: Arc::default(),
            is_stale: false,
            search: None,
        }
    }

    /// Sets the hidden faces, whose marks aren't drawn.
    pub fn set_hidden(&mut self, faces: &Arc<BitSet>) {
        self.hidden.clone_from(faces);
    }

    /// Notes that the mesh changed.
    pub fn mesh_changed(&mut self) {
        self.is_stale = true;
    }

    /// Brings the buffers closer to what is wanted, as far as the budget allows; returns whether they changed, and
    /// whether there is more to do.
    pub fn step(
        &mut self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        mesh: &Mesh,
        origin: Vec3,
        wanted: Marks,
        budget: &mut Budget,
    ) -> (bool, bool) {
        let aims_at = self.search.as_ref().map_or(self.has, |(search, _)| search.marks());
        if self.is_stale || aims_at != wanted {
            self.is_stale = false;
            self.search = Some((MarkSearch::new(mesh, wanted, origin).without(&self.hidden), origin));
        }
        let Some((search, origin)) = &mut self.search else { return (false, false) };
        let Some(found) = search.step(mesh, budget) else { return (false, true) };
        for (stream, lines) in self.lines.iter_mut().zip(&found.lines) {
            stream.set(device, queue, lines);
        }
        self.points.set(device, queue, &found.points);
        self.has = wanted;
        self.origin = *origin;
        self.search = None;
        (true, false)
    }

    /// The number of marks of a kind.
    pub fn count(&self, mark: Mark) -> u64 {
        let lines = self.lines.get(mark as usize).map_or(0, |lines| lines.len() / LINE_BYTES);
        lines + if mark == Mark::NonManifold { self.points.len() / 12 } else { 0 }
    }

    /// Bytes of GPU memory.
    pub fn gpu_bytes(&self) -> u64 {
        self.lines.iter().map(Stream::capacity).sum::<u64>() + self.points.capacity()
    }
}
