//! Moving vertices along the surface to the middle of their triangles, and along their curves to the
//! middle between their neighbours.

use super::curves::Role;
use super::work::Work;
use crate::SurfaceError;
use crate::pace::Pace;
use glam::DVec3;
use halfedge::NONE;

/// What a vertex's triangles add up to.
#[derive(Clone, Copy, Default)]
struct Sum {
    /// Twice their area vectors.
    normal: DVec3,
    /// Their middles, times three, by area.
    middles: DVec3,
    weight: f64,
}

/// Scratch space, kept from one round to the next.
#[derive(Default)]
pub(super) struct Relaxer {
    sums: Vec<Sum>,
    moved: Vec<DVec3>,
    back: Vec<u32>,
}

impl Relaxer {
    /// One round. Vertices whose move would turn a triangle over stay this time.
    pub fn run(&mut self, work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        self.add_up(work);
        self.moved.clear();
        self.moved.extend_from_slice(&work.tri.position);
        pace.chunks(work.tri.out.len(), |range| {
            for v in range {
                match work.roles[v] {
                    Role::Free => self.moved[v] = self.middle(work, v),
                    Role::Curve => self.moved[v] = slide(work, v as u32),
                    Role::Fixed => {}
                }
            }
        })?;
        self.take_back(work);
        std::mem::swap(&mut self.moved, &mut work.tri.position);
        Ok(())
    }

    fn add_up(&mut self, work: &Work) {
        self.sums.clear();
        self.sums.resize(work.tri.out.len(), Sum::default());
        for corners in work.tri.v.chunks_exact(3) {
            if corners[0] == NONE {
                continue;
            }
            let (a, b, c) = (work.tri.at(corners[0]), work.tri.at(corners[1]), work.tri.at(corners[2]));
            let normal = (b - a).cross(c - a);
            let weight = normal.length();
            let middles = (a + b + c) * weight;
            for &v in corners {
                let sum = &mut self.sums[v as usize];
                sum.normal += normal;
                sum.middles += middles;
                sum.weight += weight;
            }
        }
    }

    /// The middle of a free vertex's triangles, on its tangent plane and then on the input.
    fn middle(&self, work: &mut Work, v: usize) -> DVec3 {
        let here = work.tri.position[v];
        let sum = &self.sums[v];
        let squared = sum.normal.length_squared();
        if work.tri.out[v] == NONE || squared.is_nan() || squared <= 0.0 {
            return here;
        }
        let by = sum.middles / (3.0 * sum.weight) - here;
        let to = here + by - sum.normal * (by.dot(sum.normal) / squared);
        let Some(input) = &work.input else { return to };
        let foot = input.closest(work.near[v], to);
        work.near[v] = foot.face;
        foot.at
    }

    /// Has vertices stay where a triangle would turn over, until none does.
    fn take_back(&mut self, work: &Work) {
        let tri = &work.tri;
        let turns = |moved: &[DVec3], corners: [u32; 3]| {
            let area = |p: &[DVec3]| {
                let (a, b, c) = (p[corners[0] as usize], p[corners[1] as usize], p[corners[2] as usize]);
                (b - a).cross(c - a)
            };
            let (old, new) = (area(&tri.position), area(moved));
            new.dot(old) <= 0.0 && old != DVec3::ZERO
        };
        self.back.clear();
        for f in 0..tri.v.len() / 3 {
            let corners = [tri.v[3 * f], tri.v[3 * f + 1], tri.v[3 * f + 2]];
            if corners[0] != NONE && turns(&self.moved, corners) {
                self.back.extend(corners);
            }
        }
        while let Some(v) = self.back.pop() {
            let here = tri.at(v);
            if self.moved[v as usize] == here {
                continue;
            }
            self.moved[v as usize] = here;
            let (moved, back) = (&self.moved, &mut self.back);
            tri.around(v, |out| {
                let corners = [v, tri.to(out), tri.apex(out)];
                if turns(moved, corners) {
                    back.extend(corners);
                }
            });
        }
    }
}

/// Moves a vertex along its curve to the middle between its neighbours there.
fn slide(work: &mut Work, v: u32) -> DVec3 {
    let [a, b] = work.kept_at(v);
    if a == NONE || b == NONE {
        return work.tri.at(v);
    }
    let ([from, before], [to, after]) = (work.places_from(v, a), work.places_from(v, b));
    // The signs say which way the curve runs; both go away from the vertex.
    let by = 0.5 * ((before - from) + (after - to));
    work.set_place(v, a, from + by);
    work.set_place(v, b, to + by);
    work.curves.at(work.arcs[work.arc[a as usize] as usize / 2].curve, from + by)
}
