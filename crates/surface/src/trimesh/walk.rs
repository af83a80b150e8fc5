//! The point of a surface closest to a point, by walking over its triangles.

use super::{Frame, TriMesh, prev};
use crate::face_tree::closest_in_triangle;
use glam::{DVec3, Vec3};
use halfedge::NONE;

/// How many triangles one walk may cross: far more than any vertex moves over.
const STEPS: usize = 1024;

/// Triangles with what is across their sides, numbered as in [`TriMesh`].
pub(crate) trait Surface {
    /// The vertex that a half-edge leaves.
    fn vertex(&self, h: u32) -> u32;
    /// The half-edge across, or [`NONE`].
    fn across(&self, h: u32) -> u32;
    /// A half-edge leaving a vertex, the boundary one if there is one.
    fn leaving(&self, v: u32) -> u32;
    /// Where a vertex is, in the frame.
    fn place(&self, v: u32) -> DVec3;

    /// Where a triangle's corners are.
    #[inline]
    fn places(&self, face: u32) -> [DVec3; 3] {
        [0, 1, 2].map(|k| self.place(self.vertex(3 * face + k)))
    }

    /// The point closest to `p`, walking down from a triangle to neighbours that are closer. What lies
    /// on the other side of a thin wall is never taken for the surface, as a search through space would.
    fn closest(&self, start: u32, p: DVec3) -> Foot {
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
                    self.try_around(self.vertex(first + corner), p, &mut closer);
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
        let across = self.across(h);
        if across != NONE {
            let foot = self.on(across / 3, p);
            if foot.squared < best.squared {
                *best = foot;
            }
        }
    }

    /// Tries the triangles around a vertex.
    fn try_around(&self, v: u32, p: DVec3, best: &mut Foot) {
        let first = self.leaving(v);
        let mut h = first;
        while h != NONE {
            let foot = self.on(h / 3, p);
            if foot.squared < best.squared {
                *best = foot;
            }
            h = self.across(prev(h));
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
    /// How far it is from the point asked for, squared.
    pub squared: f64,
    weights: DVec3,
}

impl Surface for TriMesh {
    #[inline]
    fn vertex(&self, h: u32) -> u32 {
        self.from(h)
    }

    #[inline]
    fn across(&self, h: u32) -> u32 {
        self.opp(h)
    }

    #[inline]
    fn leaving(&self, v: u32) -> u32 {
        self.out[v as usize]
    }

    #[inline]
    fn place(&self, v: u32) -> DVec3 {
        self.at(v)
    }
}

/// The triangles of the input, to measure from and to put vertices back on while those made of it change.
pub(crate) struct Input {
    v: Vec<u32>,
    opp: Vec<u32>,
    out: Vec<u32>,
    /// As in the mesh: they are exact there.
    position: Vec<Vec3>,
    frame: Frame,
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

    /// Triangles that nothing else needs any more.
    pub fn from(tri: TriMesh) -> Self {
        let position = tri.position.iter().map(|&p| tri.frame.outward(p)).collect();
        Self { v: tri.v, opp: tri.opp, out: tri.out, position, frame: tri.frame }
    }

    /// How many triangles there are.
    pub fn triangles(&self) -> usize {
        self.v.len() / 3
    }

    /// How many vertices there are.
    pub fn vertices(&self) -> usize {
        self.out.len()
    }
}

impl Surface for Input {
    #[inline]
    fn vertex(&self, h: u32) -> u32 {
        self.v[h as usize]
    }

    #[inline]
    fn across(&self, h: u32) -> u32 {
        self.opp[h as usize]
    }

    #[inline]
    fn leaving(&self, v: u32) -> u32 {
        self.out[v as usize]
    }

    #[inline]
    fn place(&self, v: u32) -> DVec3 {
        self.frame.inward(self.position[v as usize])
    }
}
