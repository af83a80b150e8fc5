//! Small pictures of meshes for the tiles of the welcome view, drawn on the processor: they need no viewport and
//! no downloads, and look the same everywhere.

use glam::{Vec2, Vec3, vec2, vec3};
use halfedge::geometry::polygon_area_vector;

/// Polygons to draw, each with its colour from 0 to 1.
#[derive(Clone, Debug, Default)]
pub(crate) struct Figure {
    pub positions: Vec<Vec3>,
    pub polygons: Vec<(Vec<u32>, Vec3)>,
}

/// Each pixel is the mean of this many samples along each side.
const SAMPLES: usize = 3;
/// The direction to the eye.
const TO_EYE: Vec3 = vec3(0.52, 0.42, 0.743);
/// The directions to the lights, and their strengths: key, fill and rim.
const LIGHTS: [(Vec3, f32); 3] =
    [(vec3(-0.35, 0.8, 0.6), 0.84), (vec3(0.9, 0.25, 0.35), 0.34), (vec3(-0.3, 0.35, -0.9), 0.2)];
const AMBIENT: f32 = 0.34;
/// The darkness of the shadow under the figure.
const SHADOW: f32 = 0.3;
/// How far the shadow reaches, as a multiple of the figure's extent on the ground.
const SHADOW_REACH: f32 = 1.15;
/// Neighbouring faces with an angle below this (its cosine) are shaded as one smooth surface.
const MIN_COSINE_SMOOTH: f32 = 0.72;

/// Draws a figure into a picture of `width` by `height` pixels: rows of red, green, blue and opacity, premultiplied.
pub(crate) fn draw(figure: &Figure, width: usize, height: usize) -> Vec<u8> {
    let mut canvas = Canvas::new(width * SAMPLES, height * SAMPLES);
    let normals = corner_normals(figure);
    let eye = TO_EYE.normalize();
    let right = Vec3::Y.cross(eye).normalize();
    let up = eye.cross(right);
    let flat = |p: Vec3| vec2(p.dot(right), -p.dot(up));
    let seen = || figure.positions.iter().copied().chain(ground(figure, SHADOW_REACH)).map(flat);
    let low = seen().reduce(Vec2::min).unwrap_or_default();
    let high = seen().reduce(Vec2::max).unwrap_or_default();
    let size = (high - low).max(Vec2::splat(1e-6));
    let room = vec2(canvas.width as f32, canvas.height as f32);
    let scale = (room * 0.92 / size).min_element();
    let middle = (low + high) * 0.5;
    let place = |p: Vec3| (flat(p) - middle) * scale + room * 0.5;

    canvas.shadow(figure, place);
    for ((corners, color), normals) in figure.polygons.iter().zip(&normals) {
        let corner = |at: usize| -> Option<Corner> {
            let position = *figure.positions.get(*corners.get(at)? as usize)?;
            let light = shade(*normals.get(at)?, eye);
            Some(Corner { at: place(position), depth: position.dot(eye), color: *color * light })
        };
        for at in 1..corners.len().saturating_sub(1) {
            if let (Some(a), Some(b), Some(c)) = (corner(0), corner(at), corner(at + 1)) {
                canvas.triangle([a, b, c]);
            }
        }
    }
    canvas.averaged()
}

/// The ends of the figure's extent along x and z on the ground, moved out from its middle by a factor.
fn ground(figure: &Figure, factor: f32) -> [Vec3; 4] {
    let low = figure.positions.iter().copied().reduce(Vec3::min).unwrap_or_default();
    let high = figure.positions.iter().copied().reduce(Vec3::max).unwrap_or_default();
    let (middle, half) = (((low + high) * 0.5).with_y(low.y), (high - low) * 0.5 * factor);
    let (x, z) = (Vec3::X * half.x, Vec3::Z * half.z);
    [middle + x, middle - x, middle + z, middle - z]
}

/// The light that a surface sends to the eye.
fn shade(normal: Vec3, eye: Vec3) -> f32 {
    let lit: f32 = LIGHTS.iter().map(|(to, power)| normal.dot(to.normalize()).max(0.0) * power).sum();
    let sky = 0.5 + 0.5 * normal.y;
    let edge = 1.0 - 0.18 * (1.0 - normal.dot(eye).abs());
    (AMBIENT * sky + lit) * edge + 0.08
}

/// The normals at the corners of each polygon: the mean of the adjacent polygons that are nearly parallel.
fn corner_normals(figure: &Figure) -> Vec<Vec<Vec3>> {
    let point = |id: &u32| figure.positions.get(*id as usize).copied().unwrap_or_default();
    let areas: Vec<Vec3> = figure
        .polygons
        .iter()
        .map(|(corners, _)| polygon_area_vector(corners.iter().map(point)).as_vec3())
        .collect();
    let mut adjacent = vec![Vec::new(); figure.positions.len()];
    for ((corners, _), area) in figure.polygons.iter().zip(&areas) {
        for id in corners {
            if let Some(list) = adjacent.get_mut(*id as usize) {
                list.push(*area);
            }
        }
    }
    let smooth = |id: &u32, own: Vec3| -> Vec3 {
        let near = |area: &&Vec3| area.normalize_or_zero().dot(own) > MIN_COSINE_SMOOTH;
        let sum: Vec3 = adjacent.get(*id as usize).into_iter().flatten().filter(near).sum();
        sum.normalize_or_zero()
    };
    let normals = figure.polygons.iter().zip(&areas);
    normals
        .map(|((corners, _), area)| {
            let own = area.normalize_or_zero();
            corners.iter().map(|id| smooth(id, own)).collect()
        })
        .collect()
}

#[derive(Clone, Copy)]
struct Corner {
    at: Vec2,
    depth: f32,
    color: Vec3,
}

/// Samples with their depth; colours premultiplied by the opacity.
struct Canvas {
    width: usize,
    height: usize,
    colors: Vec<(Vec3, f32)>,
    depths: Vec<f32>,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        Self { width, height, colors: vec![(Vec3::ZERO, 0.0); count], depths: vec![f32::NEG_INFINITY; count] }
    }

    /// A soft shadow on the ground, darkest below the figure's middle.
    fn shadow(&mut self, figure: &Figure, place: impl Fn(Vec3) -> Vec2) {
        let [right, left, front, back] = ground(figure, SHADOW_REACH).map(place);
        let center = (right + left) * 0.5;
        // The axes of the footprint as they are seen.
        let (x, z) = ((right - left) * 0.5, (front - back) * 0.5);
        let area = x.perp_dot(z);
        if area.abs() < 1e-3 {
            return;
        }
        for (at, (color, opacity)) in self.colors.iter_mut().enumerate() {
            let from = vec2((at % self.width) as f32, (at / self.width) as f32) - center;
            let (u, v) = (from.perp_dot(z) / area, x.perp_dot(from) / area);
            let away = vec2(u, v).length();
            if away < 1.0 {
                let soft = 1.0 - away * away;
                (*color, *opacity) = (Vec3::ZERO, SHADOW * soft * soft);
            }
        }
    }

    fn triangle(&mut self, corners: [Corner; 3]) {
        let [a, b, c] = corners;
        let area = (b.at - a.at).perp_dot(c.at - a.at);
        // The front is counter-clockwise where y points up, clockwise on the canvas.
        if area >= -1e-6 {
            return;
        }
        let low = a.at.min(b.at).min(c.at).max(Vec2::ZERO);
        let high = a.at.max(b.at).max(c.at).min(vec2(self.width as f32, self.height as f32));
        for row in low.y as usize..high.y.ceil() as usize {
            for column in low.x as usize..high.x.ceil() as usize {
                let p = vec2(column as f32 + 0.5, row as f32 + 0.5);
                let wa = (c.at - b.at).perp_dot(p - b.at) / area;
                let wb = (a.at - c.at).perp_dot(p - c.at) / area;
                let wc = 1.0 - wa - wb;
                let at = row * self.width + column;
                let depth = wa * a.depth + wb * b.depth + wc * c.depth;
                if wa < 0.0
                    || wb < 0.0
                    || wc < 0.0
                    || self.depths.get(at).is_none_or(|&nearest| depth <= nearest)
                {
                    continue;
                }
                if let (Some(nearest), Some(color)) = (self.depths.get_mut(at), self.colors.get_mut(at)) {
                    *nearest = depth;
                    *color = (a.color * wa + b.color * wb + c.color * wc, 1.0);
                }
            }
        }
    }

    /// The picture with one pixel for each square of samples.
    fn averaged(&self) -> Vec<u8> {
        let (width, height) = (self.width / SAMPLES, self.height / SAMPLES);
        let mut bytes = Vec::with_capacity(width * height * 4);
        let share = 1.0 / (SAMPLES * SAMPLES) as f32;
        for at in 0..width * height {
            let (mut color, mut opacity) = (Vec3::ZERO, 0.0);
            for sample in 0..SAMPLES * SAMPLES {
                let row = at / width * SAMPLES + sample / SAMPLES;
                let column = at % width * SAMPLES + sample % SAMPLES;
                let (sampled, covers) =
                    self.colors.get(row * self.width + column).copied().unwrap_or_default();
                color += sampled.min(Vec3::ONE) * share;
                opacity += covers * share;
            }
            bytes.extend((color * 255.0).to_array().map(|channel| channel.round() as u8));
            bytes.push((opacity * 255.0).round() as u8);
        }
        bytes
    }
}
