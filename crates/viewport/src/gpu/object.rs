//! An object's buffers on the GPU.

use super::isolated::IsolatedVertices;
use super::marks::MarkBuffers;
use super::stream::Stream;
use crate::buffers::{Buffers, Corners, Rebuild, Sink};
use crate::{Coloring, Materials, Style};
use glam::Vec3;
use halfedge::geometry::BitSet;
use halfedge::{Budget, Element, InParts, Mesh, Touched};
use std::sync::Arc;
use surface::selecting::is_hidden;

/// Triangles per page. An object's triangles are spread over pages, so that growing copies at most one
/// page and no buffer exceeds what every device allows (128 MiB).
pub const TRIANGLES_PER_PAGE: u32 = 1 << 20;
/// The position of an id without a vertex; shaders skip it.
pub const HIDDEN_POSITION: [f32; 3] = [3.0e38; 3];

/// Vertex streams of up to [`TRIANGLES_PER_PAGE`].
pub struct Page {
    pub positions: Stream,
    pub normals: Stream,
    pub colors: Stream,
    /// Texture coordinates; empty unless the look shows what lies at them.
    pub uvs: Stream,
}

impl Page {
    fn new() -> Self {
        Self {
            positions: Stream::new("triangle positions"),
            normals: Stream::new("triangle normals"),
            colors: Stream::new("triangle colours"),
            uvs: Stream::new("triangle texture coordinates"),
        }
    }

    /// The number of vertices to draw.
    pub fn vertices(&self) -> u32 {
        (self.positions.len() / 12) as u32
    }

    /// Draws the triangles, with their texture coordinates if `with_uvs`.
    pub fn draw(&self, pass: &mut wgpu::RenderPass<'_>, with_uvs: bool) {
        let streams = [&self.positions, &self.normals, &self.colors, &self.uvs];
        let count = if with_uvs { 4 } else { 3 };
        for (slot, stream) in (0..count).zip(streams) {
            let Some(slice) = stream.slice() else { return };
            pass.set_vertex_buffer(slot, slice);
        }
        pass.draw(0..self.vertices(), 0..1);
    }
}

/// Buffers of one object.
pub struct Object {
    pub buffers: Buffers,
    pub pages: Vec<Page>,
    /// A position per vertex id for the dots; empty unless dots are shown.
    pub points: Stream,
    pub has_points: bool,
    /// The dots of isolated vertices, which are always drawn.
    pub isolated: IsolatedVertices,
    pub marks: MarkBuffers,
    /// Faces that aren't drawn.
    hidden: Arc<BitSet>,
    /// Buffers that replace these once they are complete.
    next: Option<Next>,
}

/// Buffers that are filled some faces at a time while the old ones are drawn.
struct Next {
    buffers: Buffers,
    pages: Vec<Page>,
    rebuilding: Rebuild,
    points: bool,
    /// Edits made since they were begun: they may have touched faces that are written already.
    touched: Vec<Touched>,
}

fn origin_of(mesh: &Mesh) -> Vec3 {
    surface::measure::bounding_box(mesh).map_or(Vec3::ZERO, |b| b.center())
}

impl InParts for Next {
    type Input<'a> = (&'a wgpu::Device, &'a wgpu::Queue, &'a Mesh);
    type Output = ();

    fn step(&mut self, (device, queue, mesh): Self::Input<'_>, budget: &mut Budget) -> Option<()> {
        let mut upload = Upload { device, queue, pages: &mut self.pages, bytes: 0 };
        let is_left = self.buffers.rebuild_faces(mesh, &mut self.rebuilding, budget, &mut upload);
        (!is_left).then_some(())
    }
}

impl Object {
    pub fn new() -> Self {
        Self {
            buffers: Buffers::default(),
            pages: Vec::new(),
            points: Stream::new("vertices"),
            has_points: false,
            isolated: IsolatedVertices::new(),
            marks: MarkBuffers::new(),
            hidden: Arc::default(),
            next: None,
        }
    }

    /// Sets the faces that aren't drawn, for the next upload or update.
    pub fn set_hidden(&mut self, faces: &Arc<BitSet>) {
        self.hidden.clone_from(faces);
        self.buffers.set_hidden(faces);
        self.marks.set_hidden(faces);
        if let Some(next) = &mut self.next {
            next.buffers.set_hidden(faces);
        }
    }

    /// Uploads a whole mesh; returns the number of bytes.
    pub fn rebuild(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        mesh: &Mesh,
        style: &Style,
        materials: &Arc<Materials>,
    ) -> u64 {
        self.next = None;
        self.marks.mesh_changed();
        let mut upload = Upload { device, queue, pages: &mut self.pages, bytes: 0 };
        let coloring = Coloring::new(mesh, style.color_by, style.wants_uvs(), materials);
        self.buffers.rebuild(mesh, origin_of(mesh), style.shading, coloring, &mut upload);
        upload.bytes + self.set_points(device, queue, mesh, style.vertices)
    }

    /// Uploads the dots of isolated vertices, and those of all vertices if `points` says so.
    fn set_points(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, mesh: &Mesh, points: bool) -> u64 {
        self.has_points = points;
        let origin = self.buffers.origin();
        let isolated = self.isolated.set(device, queue, mesh, origin);
        if !points {
            self.points.reset(device, 0);
            return isolated;
        }
        let positions: Vec<[f32; 3]> =
            (0..mesh.vertex_capacity() as u32).map(|v| self.dot(mesh, v, origin)).collect();
        self.points.set(device, queue, &positions);
        isolated + self.points.len()
    }

    /// Where the dot of a vertex is drawn.
    fn dot(&self, mesh: &Mesh, raw: u32, origin: Vec3) -> [f32; 3] {
        if is_hidden(mesh, Element::Vertex, raw as usize, &self.hidden) {
            HIDDEN_POSITION
        } else {
            point(mesh, raw, origin)
        }
    }

    /// Begins an upload of a whole mesh that [`Object::upload_faces`] carries out.
    pub fn begin_upload(&mut self, mesh: &Mesh, style: &Style, materials: &Arc<Materials>) {
        let mut buffers = Buffers::default();
        buffers.set_hidden(&self.hidden);
        let coloring = Coloring::new(mesh, style.color_by, style.wants_uvs(), materials);
        let rebuilding = buffers.begin_rebuild(mesh, origin_of(mesh), style.shading, coloring);
        let points = style.vertices;
        self.next = Some(Next { buffers, pages: Vec::new(), rebuilding, points, touched: Vec::new() });
    }

    /// Uploads more faces of an upload that has begun, as many as the budget has; returns whether that was the
    /// last of it. If so, the new buffers are drawn from now on.
    pub fn upload_faces(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        mesh: &Mesh,
        budget: &mut Budget,
    ) -> bool {
        let Some(mut next) = self.next.take() else { return false };
        if next.step((device, queue, mesh), budget).is_none() {
            self.next = Some(next);
            return false;
        }
        (self.buffers, self.pages) = (next.buffers, next.pages);
        self.marks.mesh_changed();
        self.set_points(device, queue, mesh, next.points);
        for touched in next.touched {
            self.update(device, queue, mesh, &touched);
        }
        true
    }

    /// Whether an upload has begun and isn't complete.
    pub fn is_uploading(&self) -> bool {
        self.next.is_some()
    }

    /// Whether the buffers, or those being filled, are as the style wants them.
    pub fn fits(&self, style: &Style, materials: &Arc<Materials>) -> bool {
        let (buffers, has_points) = match &self.next {
            Some(next) => (&next.buffers, next.points),
            None => (&self.buffers, self.has_points),
        };
        let is_colored = buffers.coloring().fits(style.color_by, style.wants_uvs(), materials);
        is_colored && buffers.shading() == style.shading && (has_points || !style.vertices)
    }

    /// Uploads what an edit touched; returns the number of bytes.
    pub fn update(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        mesh: &Mesh,
        touched: &Touched,
    ) -> u64 {
        self.marks.mesh_changed();
        if let Some(next) = &mut self.next {
            next.touched.push(touched.clone());
            return 0;
        }
        let mut upload = Upload { device, queue, pages: &mut self.pages, bytes: 0 };
        self.buffers.update(mesh, touched, &mut upload);
        let (mut bytes, origin) = (upload.bytes, self.buffers.origin());
        bytes += self.isolated.follow(device, queue, mesh, origin, &touched.vertices);
        if self.has_points {
            for v in &touched.vertices {
                let position = self.dot(mesh, v.raw(), origin);
                self.points.write(
                    device,
                    queue,
                    v.index() as u64 * 12,
                    bytemuck::bytes_of(&position),
                    u64::MAX,
                );
                bytes += 12;
            }
        }
        bytes
    }

    /// Bytes of GPU memory.
    pub fn gpu_bytes(&self) -> u64 {
        let next = self.next.iter().flat_map(|next| &next.pages);
        let pages = self.pages.iter().chain(next).flat_map(|p| [&p.positions, &p.normals, &p.colors, &p.uvs]);
        let dots = self.points.capacity() + self.isolated.points.capacity();
        pages.map(Stream::capacity).sum::<u64>() + dots + self.marks.gpu_bytes()
    }
}

/// A vertex's position relative to the object's origin.
pub fn point(mesh: &Mesh, raw: u32, origin: Vec3) -> [f32; 3] {
    mesh.vertex(raw).map_or(HIDDEN_POSITION, |v| (mesh.position(v) - origin).to_array())
}

/// Writes vertex streams to pages.
struct Upload<'a> {
    device: &'a wgpu::Device,
    queue: &'a wgpu::Queue,
    pages: &'a mut Vec<Page>,
    bytes: u64,
}

impl Sink for Upload<'_> {
    fn reset(&mut self, triangles: u32, with_uvs: bool) {
        self.pages.truncate(triangles.div_ceil(TRIANGLES_PER_PAGE) as usize);
        for at in 0..triangles.div_ceil(TRIANGLES_PER_PAGE) {
            let here = u64::from((triangles - at * TRIANGLES_PER_PAGE).min(TRIANGLES_PER_PAGE));
            if self.pages.len() <= at as usize {
                self.pages.push(Page::new());
            }
            if let Some(page) = self.pages.get_mut(at as usize) {
                page.positions.reset(self.device, here * 36);
                page.normals.reset(self.device, here * 24);
                page.colors.reset(self.device, here * 12);
                page.uvs.reset(self.device, if with_uvs { here * 24 } else { 0 });
            }
        }
    }

    fn write(&mut self, first_triangle: u32, corners: &Corners) {
        let data: [&[u8]; 4] = [
            bytemuck::cast_slice(&corners.positions),
            bytemuck::cast_slice(&corners.normals),
            bytemuck::cast_slice(&corners.colors),
            bytemuck::cast_slice(&corners.uvs),
        ];
        let (mut done, total) = (0, corners.triangles() as u32);
        while done < total {
            let at = first_triangle + done;
            let (page, in_page) = ((at / TRIANGLES_PER_PAGE) as usize, at % TRIANGLES_PER_PAGE);
            let count = (total - done).min(TRIANGLES_PER_PAGE - in_page);
            while self.pages.len() <= page {
                self.pages.push(Page::new());
            }
            let Some(page) = self.pages.get_mut(page) else { return };
            let streams = [
                (&mut page.positions, 36_usize),
                (&mut page.normals, 24),
                (&mut page.colors, 12),
                (&mut page.uvs, 24),
            ];
            for ((stream, size), data) in streams.into_iter().zip(data).filter(|(_, data)| !data.is_empty()) {
                let data = data.get(done as usize * size..(done + count) as usize * size).unwrap_or_default();
                let limit = u64::from(TRIANGLES_PER_PAGE) * size as u64;
                stream.write(self.device, self.queue, u64::from(in_page) * size as u64, data, limit);
                self.bytes += data.len() as u64;
            }
            done += count;
        }
    }
}
