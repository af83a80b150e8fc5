//! Closest points by walking over triangles.

use super::TriMesh;
use crate::face_tree::closest_in_triangle;
use glam::DVec3;
use halfedge::NONE;

/// The most triangles that a walk may cross: far more than a vertex moves over.
const MAX_WALK_STEPS: usize = 1024;

/// Twice the area vector of a triangle.
#[inline]
pub(crate) fn area_vector([a, b, c]: &[DVec3; 3]) -> DVec3 {
    (*b - *a).cross(*c - *a)
}

impl TriMesh {
    /// The positions of a triangle's corners.
    #[inline]
    pub fn places(&self, face: u32) -> [DVec3; 3] {
        [0, 1, 2].map(|k| self.at(self.from(3 * face + k)))
    }

    /// The point closest to `p` that a walk from a triangle to ever closer neighbours reaches. Unlike a search
    /// through space, it never jumps to the other side of a thin wall.
    pub fn closest(&self, start: u32, p: DVec3) -> Foot {
        let mut best = self.on(start, p);
        for _ in 0..MAX_WALK_STEPS {
            let first = 3 * best.face;
            let zero = best.weights.to_array().map(|w| w == 0.0);
            let mut closer = best;
            match zero {
                [false, false, false] => return best,
                [true, false, false] => self.try_across(first + 1, p, &mut closer),
                [false, true, false] => self.try_across(first + 2, p, &mut closer),
                [false, false, true] => self.try_across(first, p, &mut closer),
                _ => {
                    let corner = if !zero[0] {
                        0
                    } else if !zero[1] {
                        1
                    } else {
                        2
                    };
                    self.try_around(self.from(first + corner), p, &mut closer);
                }
            }
            if closer.face == best.face {
                return best;
            }
            best = closer;
        }
        best
    }

    /// The point of a triangle closest to `p`.
    #[inline]
    fn on(&self, face: u32, p: DVec3) -> Foot {
        let [a, b, c] = self.places(face);
        let weights = closest_in_triangle([a, b, c], p);
        let at = a * weights.x + b * weights.y + c * weights.z;
        Foot { face, at, squared: at.distance_squared(p), weights }
    }

    /// Tries the triangle across a side.
    fn try_across(&self, h: u32, p: DVec3, best: &mut Foot) {
        let across = self.opp(h);
        if across != NONE {
            let foot = self.on(across / 3, p);
            if foot.squared < best.squared {
                *best = foot;
            }
        }
    }

    /// Tries the triangles around a vertex.
    fn try_around(&self, v: u32, p: DVec3, best: &mut Foot) {
        let first = self.out[v as usize];
        let mut h = first;
        while h != NONE {
            let foot = self.on(h / 3, p);
            if foot.squared < best.squared {
                *best = foot;
            }
            h = self.turn(h);
            if h == first {
                break;
            }
        }
    }
}

/// A point on a surface.
#[derive(Clone, Copy)]
pub(crate) struct Foot {
    pub face: u32,
    pub at: DVec3,
    /// The squared distance from the query point.
    pub squared: f64,
    weights: DVec3,
}
