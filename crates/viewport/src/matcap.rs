//! Matcaps: pictures of a lit sphere of some material, which shade a surface by its normal alone.
//!
//! They are computed rather than painted: a few lights and a reflected room, in linear light.

use glam::{Vec3, vec3};

/// Pixels on each side of a matcap's picture.
pub(crate) const MATCAP_SIZE: u32 = 256;

/// A material that a matcap imitates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matcap {
    /// Matt terracotta.
    Clay,
    /// White with a soft gloss and a play of colours at the rim.
    Pearl,
    /// Brushed steel in a bright room.
    Metal,
    /// Glossy and slightly translucent.
    RedWax,
}

impl Matcap {
    /// The sRGB colour of a surface whose unit normal points this far to the right, up and towards the viewer.
    /// Normals that point away are shaded like the rim.
    pub fn color(self, normal: Vec3) -> [u8; 3] {
        let n = Vec3::new(normal.x, normal.y, normal.z.max(0.0)).normalize_or(Vec3::Z);
        let light = match self {
            Self::Clay => clay(n),
            Self::Pearl => pearl(n),
            Self::Metal => metal(n),
            Self::RedWax => red_wax(n),
        };
        light.to_array().map(|c| (encode(c) * 255.0).round() as u8)
    }

    /// The picture, RGBA, from the top left: the unit disc fills it.
    pub(crate) fn picture(self) -> Vec<[u8; 4]> {
        let place = |at: u32| (at as f32 + 0.5) / MATCAP_SIZE as f32 * 2.0 - 1.0;
        let pixels = (0..MATCAP_SIZE).flat_map(|y| (0..MATCAP_SIZE).map(move |x| (place(x), -place(y))));
        pixels
            .map(|(x, y)| {
                let out = x * x + y * y;
                // Beside the disc the rim goes on, so that filtering at the rim stays in the material.
                let [r, g, b] = self.color(vec3(x, y, (1.0 - out).max(0.0).sqrt()));
                [r, g, b, 255]
            })
            .collect()
    }
}

/// The directions to the key light, above left of the viewer, and to the fill light on the right.
const KEY: Vec3 = Vec3::new(-0.456, 0.636, 0.622);
const FILL: Vec3 = Vec3::new(0.868, -0.099, 0.486);

/// Diffuse light that reaches around the terminator by `wrap`.
fn wrapped(n: Vec3, light: Vec3, wrap: f32) -> f32 {
    ((n.dot(light) + wrap) / (1.0 + wrap)).max(0.0)
}

/// A highlight of Blinn and Phong.
fn gloss(n: Vec3, light: Vec3, exponent: f32) -> f32 {
    n.dot((light + Vec3::Z).normalize()).max(0.0).powf(exponent)
}

/// How close a normal is to the rim, from 0 to 1, more sharply with a greater power.
fn rim(n: Vec3, power: f32) -> f32 {
    (1.0 - n.z).clamp(0.0, 1.0).powf(power)
}

/// Light from the sky above, less from the ground.
fn sky(n: Vec3, above: Vec3, below: Vec3) -> Vec3 {
    below.lerp(above, n.y * 0.5 + 0.5)
}

fn clay(n: Vec3) -> Vec3 {
    let light = Vec3::new(1.0, 0.94, 0.86) * 0.78 * wrapped(n, KEY, 0.1)
        + Vec3::new(0.55, 0.68, 0.85) * 0.13 * wrapped(n, FILL, 0.2)
        + sky(n, Vec3::new(0.10, 0.11, 0.13), Vec3::new(0.06, 0.04, 0.035));
    Vec3::new(0.56, 0.29, 0.19) * light * (1.0 - 0.35 * rim(n, 3.0)) + Vec3::splat(0.03 * gloss(n, KEY, 9.0))
}

fn pearl(n: Vec3) -> Vec3 {
    let light = Vec3::splat(0.52 * wrapped(n, KEY, 0.4) + 0.12 * wrapped(n, FILL, 0.4))
        + sky(n, Vec3::new(0.18, 0.20, 0.25), Vec3::new(0.13, 0.10, 0.11));
    // Thin layers reflect other colours at other angles.
    let phase = (1.0 - n.z) * 7.0 + n.y * 1.5;
    let play = vec3(phase.cos(), (phase + 2.1).cos(), (phase + 4.2).cos());
    let base = Vec3::new(0.86, 0.83, 0.82) + play * (0.035 + 0.09 * rim(n, 1.0));
    base * light + Vec3::splat(0.28 * gloss(n, KEY, 28.0) + 0.10 * rim(n, 3.0))
}

fn metal(n: Vec3) -> Vec3 {
    // A room as the surface mirrors it: a bright ceiling, a dark horizon, a lit floor, two soft boxes.
    let mirrored = n * (2.0 * n.z) - Vec3::Z;
    let step = |from: f32, to: f32, at: f32| {
        let t = ((at - from) / (to - from)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    };
    let ceiling = 0.10 + 0.52 * step(-0.05, 0.9, mirrored.y);
    let floor = 0.05 + 0.20 * step(0.1, 0.9, -mirrored.y);
    let room = floor + (ceiling - floor) * step(-0.12, 0.12, mirrored.y);
    let boxed = step(0.80, 0.95, mirrored.dot(KEY)) * 0.75
        + step(0.72, 0.95, mirrored.dot(vec3(0.80, 0.32, 0.51).normalize())) * 0.30;
    let diffuse = 0.16 * wrapped(n, KEY, 0.4);
    Vec3::new(0.88, 0.91, 0.96) * (room * 0.8 + boxed + diffuse + 0.30 * rim(n, 4.0))
}

fn red_wax(n: Vec3) -> Vec3 {
    let light = 0.80 * wrapped(n, KEY, 0.15) + 0.14 * wrapped(n, FILL, 0.3);
    let under = Vec3::new(0.16, 0.012, 0.008) * (0.5 + wrapped(n, KEY, 0.9));
    Vec3::new(0.50, 0.045, 0.035) * (light + 0.06)
        + under * 0.6
        + Vec3::new(1.0, 0.92, 0.88) * (0.34 * gloss(n, KEY, 48.0) + 0.05 * gloss(n, KEY, 6.0))
        + Vec3::new(0.30, 0.06, 0.05) * 0.5 * rim(n, 3.0)
}

/// Linear light as sRGB encodes it.
fn encode(linear: f32) -> f32 {
    let linear = linear.clamp(0.0, 1.0);
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}
