//! The part of the viewport that uses wgpu.

mod casts;
mod frame;
mod highlight;
mod isolated;
mod marks;
mod object;
mod pipelines;
mod renderer;
mod screen;
mod shadow;
mod stream;
mod surface;
mod targets;
mod textures;
mod uniforms;

pub use frame::{Frame, ObjectDraw};
pub use highlight::{Highlight, Layer};
pub use renderer::{ObjectChange, Renderer};
pub use textures::Picture;
