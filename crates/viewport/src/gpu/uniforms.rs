//! The uniforms of the shaders: one per frame, and one per draw.

use crate::{Camera, Look, Style, UpAxis};
use glam::{DVec3, Vec2, Vec3};
use halfedge::Color;

/// The uniform of a frame, with the layout of `Frame` in `common.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct FrameUniform {
    /// From positions relative to the eye, in units of its distance to the target, to clip space.
    matrix: [[f32; 4]; 4],
    /// The direction to the light and 1 for a parallel projection; the last component is 0 in perspective,
    /// where the light is at the eye.
    light: [f32; 4],
    /// The camera's direction to the right, and the number of the look.
    right: [f32; 4],
    /// The camera's direction upwards, and 1 where z is the scene's up axis.
    up: [f32; 4],
    /// Width and height in pixels, pixels per point, and the depth of the near plane.
    viewport: [f32; 4],
    background_top: [f32; 4],
    background_bottom: [f32; 4],
    /// The wireframe's colour.
    edge: [f32; 4],
    back_face: [f32; 4],
    /// The colour of grid lines.
    grid_color: [f32; 4],
    /// The middle of the grid relative to the eye in units of distance, and its spacing.
    grid: [f32; 4],
    /// How far the grid extends, how far its fine lines have faded (0 to 1), and the target relative to the
    /// grid's middle.
    grid_fade: [f32; 4],
}

/// The uniform of a draw, with the layout of `Draw` in `common.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct DrawUniform {
    /// The object's origin relative to the eye in mesh units, and 1 / the distance to the target.
    pub offset: [f32; 4],
    pub color: [f32; 4],
    /// Sizes in pixels, by shader.
    pub params: [f32; 4],
}

/// The number of a look in `mesh.wgsl`.
fn number(look: Look) -> f32 {
    match look {
        Look::Course => 0.0,
        Look::Studio => 1.0,
        Look::Matcap(_) => 2.0,
        Look::Zebra => 3.0,
        Look::Flat => 4.0,
        Look::HiddenLine => 5.0,
        Look::Normals => 6.0,
        Look::Orientation => 7.0,
        Look::Texture => 8.0,
        Look::Checker => 9.0,
    }
}

/// The number of an up axis in the shaders.
pub fn number_of_axis(up: UpAxis) -> f32 {
    match up {
        UpAxis::Y => 0.0,
        UpAxis::Z => 1.0,
    }
}

/// sRGB bytes as fractions.
pub fn rgba(color: Color, alpha: f32) -> [f32; 4] {
    let [r, g, b] = color.0.map(|c| f32::from(c) / 255.0);
    [r, g, b, alpha]
}

impl FrameUniform {
    pub fn new(camera: &Camera, size: [u32; 2], pixels_per_point: f32, style: &Style) -> Self {
        let [right, up, forward] = camera.axes();
        let edge = if style.look == Look::HiddenLine { style.theme.isolated } else { style.theme.edge };
        let size = Vec2::new(size[0] as f32, size[1] as f32);
        let (grid, grid_fade) = grid(camera);
        let to_light = (-forward).as_vec3().extend(if camera.orthographic { 1.0 } else { 0.0 });
        Self {
            matrix: camera.relative_view_proj(f64::from(size.x / size.y)).to_cols_array_2d(),
            light: to_light.to_array(),
            right: right.as_vec3().extend(number(style.look)).to_array(),
            up: up.as_vec3().extend(number_of_axis(camera.up)).to_array(),
            viewport: [size.x, size.y, pixels_per_point, (camera.near() / camera.distance) as f32],
            background_top: rgba(style.theme.background_top, 1.0),
            background_bottom: rgba(style.theme.background_bottom, 1.0),
            edge: rgba(edge, 0.85),
            back_face: rgba(style.theme.back_face, 1.0),
            grid_color: rgba(style.theme.grid, 0.5),
            grid,
            grid_fade,
        }
    }
}

/// The ground grid around the target: lines at powers of ten that suit the distance. The scene stands on the ground, so
/// that the ground never cuts through it.
fn grid(camera: &Camera) -> ([f32; 4], [f32; 4]) {
    let level = (camera.apparent_distance() * 0.2).log10();
    let spacing = 10_f64.powf(level.floor());
    // The middle is where coarse lines cross, so that lines stay put while the target moves.
    let coarse = spacing * 100.0;
    let target = camera.up.to_upright(camera.target);
    let middle = DVec3::new(
        (target.x / coarse).round() * coarse,
        camera.scene().map_or(0.0, |scene| camera.up.to_upright(scene.min.as_dvec3()).y),
        (target.z / coarse).round() * coarse,
    );
    let scale = 1.0 / camera.distance;
    let relative = ((camera.up.to_scene(middle) - camera.eye()) * scale).as_vec3();
    let to_target = ((target - middle) * scale).as_vec3();
    (
        relative.extend((spacing * scale) as f32).to_array(),
        [12.0, (level - level.floor()) as f32, to_target.x, to_target.z],
    )
}

impl DrawUniform {
    pub fn new(camera: &Camera, origin: Vec3, color: [f32; 4], params: [f32; 4]) -> Self {
        let offset = (origin.as_dvec3() - camera.eye()).as_vec3();
        Self { offset: offset.extend((1.0 / camera.distance) as f32).to_array(), color, params }
    }
}
