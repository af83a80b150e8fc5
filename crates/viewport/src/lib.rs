//! The 3D viewport: a camera, GPU buffers that follow a mesh's edits, and picking.
//!
//! Knows wgpu but no window and no user interface: the page gives it a device, tells it what
//! changed, and lends it a command encoder and a render pass each frame. Needs no more of the
//! device than WebGL2 offers.

mod bounds;
pub mod buffers;
mod camera;
mod gpu;
mod normals;
mod slots;
mod style;
mod triangulate;

pub use bounds::Bounds;
pub use camera::{Camera, Ray};
pub use gpu::{Frame, Highlight, Layer, ObjectChange, ObjectDraw, Renderer};
pub use slots::Range;
pub use style::{Style, Theme};
