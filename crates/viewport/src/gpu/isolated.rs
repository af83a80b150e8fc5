//! Isolated vertices: always drawn as dots, as nothing else would show them.

use super::object::{HIDDEN_POSITION, point};
use super::stream::Stream;
use glam::Vec3;
use halfedge::{Mesh, VertexId};
use std::collections::HashMap;

/// Bytes of a position.
const POSITION_BYTES: u64 = 12;

/// A position for each isolated vertex. An edit writes only those that it touched, whatever the size of the
/// mesh.
pub struct IsolatedVertices {
    /// Each vertex's entry.
    places: HashMap<VertexId, u32>,
    /// Unused entries, whose position is hidden.
    free: Vec<u32>,
    pub points: Stream,
}

fn is_isolated(mesh: &Mesh, v: VertexId) -> bool {
    mesh.has_vertex(v) && mesh.halfedge_from(v).is_none()
}

impl IsolatedVertices {
    pub fn new() -> Self {
        Self { places: HashMap::new(), free: Vec::new(), points: Stream::new("vertices without a face") }
    }

    /// The number of entries.
    pub fn count(&self) -> u64 {
        self.points.len() / POSITION_BYTES
    }

    /// Uploads those of a whole mesh; returns the number of bytes. Costs O(vertices).
    pub fn set(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, mesh: &Mesh, origin: Vec3) -> u64 {
        self.free.clear();
        let vertices: Vec<VertexId> = mesh.vertices().filter(|&v| is_isolated(mesh, v)).collect();
        self.places = vertices.iter().copied().zip(0..).collect();
        let positions: Vec<[f32; 3]> = vertices.iter().map(|v| point(mesh, v.raw(), origin)).collect();
        self.points.set(device, queue, &positions);
        self.points.len()
    }

    /// Uploads those of the vertices that an edit touched; returns the number of bytes.
    pub fn follow(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        mesh: &Mesh,
        origin: Vec3,
        touched: &[VertexId],
    ) -> u64 {
        let mut bytes = 0;
        for &v in touched {
            let (place, position) = if is_isolated(mesh, v) {
                let entries = self.count() as u32;
                let place = match self.places.get(&v) {
                    Some(&place) => place,
                    None => self.free.pop().unwrap_or(entries),
                };
                self.places.insert(v, place);
                (place, point(mesh, v.raw(), origin))
            } else if let Some(place) = self.places.remove(&v) {
                self.free.push(place);
                (place, HIDDEN_POSITION)
            } else {
                continue;
            };
            let offset = u64::from(place) * POSITION_BYTES;
            self.points.write(device, queue, offset, bytemuck::bytes_of(&position), u64::MAX);
            bytes += POSITION_BYTES;
        }
        bytes
    }
}
