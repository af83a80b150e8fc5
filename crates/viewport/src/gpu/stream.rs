//! A vertex buffer that doubles when it is full; the GPU copies its contents.

/// A growable vertex buffer with entries of one type.
pub struct Stream {
    label: &'static str,
    buffer: Option<wgpu::Buffer>,
    len: u64,
}

impl Stream {
    pub fn new(label: &'static str) -> Self {
        Self { label, buffer: None, len: 0 }
    }

    /// Bytes in use.
    pub fn len(&self) -> u64 {
        self.len
    }

    /// Bytes of GPU memory.
    pub fn capacity(&self) -> u64 {
        self.buffer.as_ref().map_or(0, wgpu::Buffer::size)
    }

    pub fn slice(&self) -> Option<wgpu::BufferSlice<'_>> {
        self.buffer.as_ref().filter(|_| self.len > 0).map(|buffer| buffer.slice(..self.len))
    }

    /// Empties the buffer and makes room for `bytes`; frees memory that is far too much.
    pub fn reset(&mut self, device: &wgpu::Device, bytes: u64) {
        self.len = 0;
        if self.capacity() < bytes || self.capacity() / 4 > bytes.max(1024) {
            self.buffer = (bytes > 0).then(|| create(device, self.label, bytes));
        }
    }

    /// Writes at `offset`, growing the buffer as needed, beyond `limit` bytes only if the write itself needs
    /// it. The offset and the length of `data` are multiples of four.
    pub fn write(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        offset: u64,
        data: &[u8],
        limit: u64,
    ) {
        let end = offset + data.len() as u64;
        if self.capacity() < end {
            let room = (self.capacity() * 2).min(limit).max(end).max(1024);
            let larger = create(device, self.label, room);
            if let Some(old) = self.buffer.take()
                && self.len > 0
            {
                let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
                encoder.copy_buffer_to_buffer(&old, 0, &larger, 0, self.len);
                queue.submit([encoder.finish()]);
            }
            self.buffer = Some(larger);
        }
        if let Some(buffer) = &self.buffer {
            queue.write_buffer(buffer, offset, data);
        }
        self.len = self.len.max(end);
    }

    /// Adds entries of type `T` at the end, as many as fit into the largest buffer of the device.
    pub fn append<T: bytemuck::Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, entries: &[T]) {
        let most = device.limits().max_buffer_size;
        let room = most.saturating_sub(self.len) / size_of::<T>().max(1) as u64;
        let kept = entries.len().min(usize::try_from(room).unwrap_or(usize::MAX));
        let data: &[u8] = bytemuck::cast_slice(entries.get(..kept).unwrap_or_default());
        if !data.is_empty() {
            self.write(device, queue, self.len, data, most);
        }
    }

    /// Replaces the contents by entries of type `T`, as many as fit into the largest buffer of the device.
    pub fn set<T: bytemuck::Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, entries: &[T]) {
        self.reset(device, (size_of_val(entries) as u64).min(device.limits().max_buffer_size));
        self.append(device, queue, entries);
    }
}

fn create(device: &wgpu::Device, label: &str, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size.next_multiple_of(4),
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    })
}
