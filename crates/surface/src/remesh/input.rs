//! The surface that is remeshed, to put vertices back on.

use crate::face_tree::closest_in_triangle;
use crate::trimesh::{Frame, TriMesh, prev};
use glam::{DVec3, Vec3};
use halfedge::NONE;

/// How many triangles one walk may cross: far more than any vertex moves over.
const STEPS: usize = 1024;

/// The input's triangles.
pub(super) struct Input {
    v: Vec<u32>,
    opp: Vec<u32>,
    out: Vec<u32>,
    /// As in the mesh: they are exact there.
    position: Vec<Vec3>,
    frame: Frame,
}

/// A point on the input.
#[derive(Clone, Copy)]
pub(super) struct Foot {
    pub face: u32,
    pub at: DVec3,
    squared: f64,
    weights: DVec3,
}

impl Input {
    /// A copy of triangles.
    pub fn of(tri: &TriMesh) -> Self {
        Self {
            v: tri.v.clone(),
            opp: tri.opp.clone(),
            out: tri.out.clone(),
            position: tri.position.iter().map(|&p| tri.frame.outward(p)).collect(),
            frame: tri.frame,
        }
    }

    /// The point closest to `p`, walking down from a triangle to neighbours that are closer. What lies
    /// on the other side of a thin wall is never taken for the surface, as a search through space would.
    pub fn closest(&self, start: u32, p: DVec3) -> Foot {
        let mut best = self.on(start, p);
        for _ in 0..STEPS {
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
                    self.try_around(self.v[(first + corner) as usize], p, &mut closer);
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
        let first = 3 * face as usize;
        let corner = |k: usize| self.frame.inward(self.position[self.v[first + k] as usize]);
        let (a, b, c) = (corner(0), corner(1), corner(2));
        let weights = closest_in_triangle([a, b, c], p);
        let at = a * weights.x + b * weights.y + c * weights.z;
        Foot { face, at, squared: at.distance_squared(p), weights }
    }

    fn try_across(&self, h: u32, p: DVec3, best: &mut Foot) {
        let across = self.opp[h as usize];
        if across != NONE {
            let foot = self.on(across / 3, p);
            if foot.squared < best.squared {
                *best = foot;
            }
        }
    }

    fn try_around(&self, v: u32, p: DVec3, best: &mut Foot) {
        let first = self.out[v as usize];
        let mut h = first;
        while h != NONE {
            let foot = self.on(h / 3, p);
            if foot.squared < best.squared {
                *best = foot;
            }
            h = self.opp[prev(h) as usize];
            if h == first {
                break;
            }
        }
    }
}
