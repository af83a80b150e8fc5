//! Everything that touches wgpu.

mod highlight;
mod isolated;
mod object;
mod pipelines;
mod renderer;
mod stream;
mod targets;
mod uniforms;

pub use highlight::{Highlight, Layer};
pub use renderer::{Frame, ObjectChange, ObjectDraw, Renderer};
