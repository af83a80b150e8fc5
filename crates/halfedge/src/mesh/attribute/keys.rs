//! The columns that Meshwright's own code uses.

use super::{Color, Key};
use crate::Element;
use glam::{Vec2, Vec3};

/// The painted colour of a face.
pub const FACE_COLOR: Key<Color> = Key::new(Element::Face, "color", Color::UNPAINTED);
/// The material of a face: an index into the column's labels.
pub const FACE_MATERIAL: Key<u32> = Key::new(Element::Face, "material", crate::NONE);
/// The group (`g` or `o` in an OBJ) of a face: an index into the column's labels.
pub const FACE_GROUP: Key<u32> = Key::new(Element::Face, "group", crate::NONE);
/// The smoothing group (`s` in an OBJ) of a face; 0 is "off".
pub const FACE_SMOOTHING: Key<u32> = Key::new(Element::Face, "smoothing", 0);
/// The texture coordinate of a corner; NaN where it is missing.
pub const CORNER_UV: Key<Vec2> = Key::new(Element::Halfedge, "uv", Vec2::NAN);
/// The normal of a corner from the file; NaN where it is missing.
pub const CORNER_NORMAL: Key<Vec3> = Key::new(Element::Halfedge, "normal", Vec3::NAN);
/// The colour of a vertex from the file; NaN where it is missing.
pub const VERTEX_COLOR: Key<Vec3> = Key::new(Element::Vertex, "color", Vec3::NAN);
/// The sharpness of an edge for semi-sharp creases: 0 is smooth, 10 and more infinitely sharp.
pub const EDGE_CREASE: Key<f32> = Key::new(Element::Edge, "crease", 0.0);
/// The sharpness of a vertex for semi-sharp corners, likewise.
pub const VERTEX_CREASE: Key<f32> = Key::new(Element::Vertex, "crease", 0.0);
