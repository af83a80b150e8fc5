//! The teapot that M. Newell modelled at the University of Utah in 1975, as bicubic patches.
//!
//! The body, rim, lid and bottom are given for a quarter turn, the handle and spout for one half; the rest are
//! rotated and mirrored. The control points are those of F. Crow, "The Origins of the Teapot", IEEE CG&A 7(1),
//! 1987, with the bottom that was added later.

use super::patch::Patch;
use glam::Vec3;

/// A row along a quarter turn: radius, the offset of the middle points that Newell used, and height.
struct Ring(f32, f32, f32);

impl Ring {
    fn row(&self) -> [Vec3; 4] {
        let &Self(r, off, z) = self;
        [Vec3::new(r, 0.0, z), Vec3::new(r, -off, z), Vec3::new(off, -r, z), Vec3::new(0.0, -r, z)]
    }
}

/// Quarters of the surfaces of revolution: from the inside of the rim to the bottom, with the lid from its knob
/// to its edge.
const QUARTER_TURNS: [[Ring; 4]; 6] = [
    // Rim.
    [Ring(1.4, 0.784, 2.4), Ring(1.3375, 0.749, 2.53125), Ring(1.4375, 0.805, 2.53125), Ring(1.5, 0.84, 2.4)],
    // Body.
    [Ring(1.5, 0.84, 2.4), Ring(1.75, 0.98, 1.875), Ring(2.0, 1.12, 1.35), Ring(2.0, 1.12, 0.9)],
    [Ring(2.0, 1.12, 0.9), Ring(2.0, 1.12, 0.45), Ring(1.5, 0.84, 0.225), Ring(1.5, 0.84, 0.15)],
    // Lid.
    [Ring(0.0, 0.0, 3.15), Ring(0.8, 0.45, 3.15), Ring(0.0, 0.0, 2.85), Ring(0.2, 0.112, 2.7)],
    [Ring(0.2, 0.112, 2.7), Ring(0.4, 0.224, 2.55), Ring(1.3, 0.728, 2.55), Ring(1.3, 0.728, 2.4)],
    // Bottom.
    [Ring(1.5, 0.84, 0.15), Ring(1.5, 0.84, 0.075), Ring(1.425, 0.798, 0.0), Ring(0.0, 0.0, 0.0)],
];

/// The near halves of the handle and the spout: rows of (x, y, z).
const HALVES: [[[[f32; 3]; 4]; 4]; 4] = [
    [
        [[-1.6, 0.0, 2.025], [-1.6, -0.3, 2.025], [-1.5, -0.3, 2.25], [-1.5, 0.0, 2.25]],
        [[-2.3, 0.0, 2.025], [-2.3, -0.3, 2.025], [-2.5, -0.3, 2.25], [-2.5, 0.0, 2.25]],
        [[-2.7, 0.0, 2.025], [-2.7, -0.3, 2.025], [-3.0, -0.3, 2.25], [-3.0, 0.0, 2.25]],
        [[-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8]],
    ],
    [
        [[-2.7, 0.0, 1.8], [-2.7, -0.3, 1.8], [-3.0, -0.3, 1.8], [-3.0, 0.0, 1.8]],
        [[-2.7, 0.0, 1.575], [-2.7, -0.3, 1.575], [-3.0, -0.3, 1.35], [-3.0, 0.0, 1.35]],
        [[-2.5, 0.0, 1.125], [-2.5, -0.3, 1.125], [-2.65, -0.3, 0.9375], [-2.65, 0.0, 0.9375]],
        [[-2.0, 0.0, 0.9], [-2.0, -0.3, 0.9], [-1.9, -0.3, 0.6], [-1.9, 0.0, 0.6]],
    ],
    [
        [[1.7, 0.0, 1.425], [1.7, -0.66, 1.425], [1.7, -0.66, 0.6], [1.7, 0.0, 0.6]],
        [[2.6, 0.0, 1.425], [2.6, -0.66, 1.425], [3.1, -0.66, 0.825], [3.1, 0.0, 0.825]],
        [[2.3, 0.0, 2.1], [2.3, -0.25, 2.1], [2.4, -0.25, 2.025], [2.4, 0.0, 2.025]],
        [[2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4]],
    ],
    [
        [[2.7, 0.0, 2.4], [2.7, -0.25, 2.4], [3.3, -0.25, 2.4], [3.3, 0.0, 2.4]],
        [[2.8, 0.0, 2.475], [2.8, -0.25, 2.475], [3.525, -0.25, 2.49375], [3.525, 0.0, 2.49375]],
        [[2.9, 0.0, 2.475], [2.9, -0.15, 2.475], [3.45, -0.15, 2.5125], [3.45, 0.0, 2.5125]],
        [[2.8, 0.0, 2.4], [2.8, -0.15, 2.4], [3.2, -0.15, 2.4], [3.2, 0.0, 2.4]],
    ],
];

impl Patch {
    fn mapped(&self, f: impl Fn(Vec3) -> Vec3) -> Self {
        // `+ 0.0` turns -0.0 into 0.0.
        Self { rows: self.rows.map(|row| row.map(|p| f(p) + 0.0)) }
    }

    /// The mirror image in the plane y = 0, with the same side outward.
    fn mirrored(&self) -> Self {
        let image = self.mapped(|p| Vec3::new(p.x, -p.y, p.z));
        Self { rows: image.rows.map(|[a, b, c, d]| [d, c, b, a]) }
    }
}

/// The 32 patches: z up, about 6.4 wide and 3.15 high; u x v points outward.
pub fn teapot_patches() -> Vec<Patch> {
    let mut patches = Vec::with_capacity(32);
    for rings in &QUARTER_TURNS {
        let quarter = Patch { rows: [0, 1, 2, 3].map(|j| rings[j].row()) };
        patches.push(quarter);
        patches.push(quarter.mapped(|p| Vec3::new(p.y, -p.x, p.z)));
        patches.push(quarter.mapped(|p| Vec3::new(-p.x, -p.y, p.z)));
        patches.push(quarter.mapped(|p| Vec3::new(-p.y, p.x, p.z)));
    }
    for rows in HALVES {
        let half = Patch { rows: rows.map(|row| row.map(Vec3::from)) };
        patches.push(half);
        patches.push(half.mirrored());
    }
    patches
}
