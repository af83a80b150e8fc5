//! The objects that cast the shadow, and drawing its map.

use super::frame::Frame;
use super::object::Object;
use super::renderer::Renderer;
use super::screen::DRAW_UNIFORM_STRIDE;
use super::uniforms::DrawUniform;

impl Renderer {
    /// The objects that cast a shadow.
    pub(super) fn list_casts(&self, frame: &Frame<'_>) -> Vec<(&Object, DrawUniform)> {
        let Some(ground) = self.ground(frame) else { return Vec::new() };
        let visible = frame.objects.iter().filter(|object| object.visible);
        let objects = visible.filter_map(|object| self.objects.get(&object.id));
        objects.map(|object| (object, ground.cast(object.buffers.origin()))).collect()
    }

    /// Draws the map of the shadow; `first` is the number of the first cast's uniform.
    pub(super) fn encode_casts(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        uniforms: &wgpu::BindGroup,
        casts: &[(&Object, DrawUniform)],
        first: usize,
    ) {
        self.shadow.encode(encoder, uniforms, |pass| {
            for (at, (object, _)) in casts.iter().enumerate() {
                pass.set_bind_group(0, uniforms, &[((first + at) * DRAW_UNIFORM_STRIDE) as u32]);
                for page in &object.pages {
                    if let Some(positions) = page.positions.slice() {
                        pass.set_vertex_buffer(0, positions);
                        pass.draw(0..page.vertices(), 0..1);
                    }
                }
            }
        });
    }
}
