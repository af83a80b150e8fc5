//! The 3D viewport: a camera, GPU buffers that follow a mesh's edits, and picking.
//!
//! It uses wgpu, but no window and no user interface: the page gives it a device, tells it what
//! changed, and lends it a command encoder and a render pass each frame. It asks no more of the
//! device than WebGL2 offers.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod between;
pub mod buffers;
mod camera;
mod coloring;
mod corner_normals;
mod face_writer;
mod gpu;
mod id_set;
mod marks;
mod matcap;
mod materials;
mod nearby;
mod occlusion;
mod orbit;
mod pick;
mod projector;
mod ramp;
mod region;
mod region_select;
mod side;
mod sight;
mod slots;
mod snap;
mod style;

pub use camera::Camera;
pub use coloring::{ColorBy, Coloring, Legend};
pub use corner_normals::Shading;
pub use gpu::{Frame, Highlight, Layer, ObjectChange, ObjectDraw, Picture, Renderer};
pub use marks::{Mark, Marks};
pub use matcap::Matcap;
pub use materials::{MaterialLook, Materials, Texture, Wrap};
pub use nearby::{Around, Nearby, elements_near};
pub use orbit::Rotation;
pub use pick::{Aim, Picked, pick, pick_nearest};
pub use ramp::Ramp;
pub use region::{Region, ScreenRect};
pub use region_select::RegionSelection;
pub use side::{Side, UpAxis};
pub use slots::Range;
pub use snap::snap;
pub use style::{Look, Style, Theme};
pub use surface::measure::Bounds;
