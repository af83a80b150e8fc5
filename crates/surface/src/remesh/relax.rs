//! Moving vertices along the surface to the middle of their triangles, and along their curves to the
//! middle between their neighbours.

use super::curves::Role;
use super::work::Work;
use crate::SurfaceError;
use crate::pace::Pace;
use glam::DVec3;
use halfedge::NONE;

/// How often the vertices of a curve are put in the middle between their neighbours in one round.
const SWEEPS: u32 = 8;
/// How much of the way to a neighbour a vertex may go in one round: less than half, so that they stay in
/// order even where one of them may not move.
const REACH: f64 = 0.45;

/// A vertex on a curve.
struct Sliding {
    v: u32,
    /// One of its two edges there.
    edge: u32,
    /// How far its neighbours are along the curve, and who they are.
    gaps: [f64; 2],
    ends: [u32; 2],
}

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
    /// The vertices on curves.
    sliding: Vec<Sliding>,
    /// Per vertex: how far it goes along its curve.
    shift: Vec<f64>,
    back: Vec<u32>,
}

impl Relaxer {
    /// One round. Vertices whose move would turn a triangle over stay this time.
    pub fn run(&mut self, work: &mut Work, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        self.add_up(work);
        self.moved.clear();
        self.moved.extend_from_slice(&work.tri.position);
        self.slide(work);
        pace.chunks(work.tri.out.len(), |range| {
            for v in range {
                match work.roles[v] {
                    Role::Free => self.moved[v] = self.middle(work, v),
                    // Where these go is known already.
                    Role::Curve | Role::Fixed => {}
                }
            }
        })?;
        self.take_back(work);
        for &Sliding { v, .. } in &self.sliding {
            if self.moved[v as usize] != work.tri.at(v) {
                work.slide(v, self.shift[v as usize]);
            }
        }
        std::mem::swap(&mut self.moved, &mut work.tri.position);
        Ok(())
    }

    /// Evens out the places of vertices on curves.
    fn slide(&mut self, work: &Work) {
        self.shift.clear();
        self.shift.resize(work.tri.out.len(), 0.0);
        self.sliding.clear();
        for v in 0..work.tri.out.len() as u32 {
            if work.roles[v as usize] != Role::Curve || work.tri.out[v as usize] == NONE {
                continue;
            }
            let [a, b] = work.kept_at(v);
            if a == NONE || b == NONE {
                continue;
            }
            let gaps = [a, b].map(|h| {
                let [here, there] = work.places_from(v, h);
                there - here
            });
            let ends = [a, b].map(|h| if work.tri.from(h) == v { work.tri.to(h) } else { work.tri.from(h) });
            self.sliding.push(Sliding { v, edge: a, gaps, ends });
        }
        for _ in 0..SWEEPS {
            for &Sliding { v, gaps, ends, .. } in &self.sliding {
                // One gap is positive and one negative: towards the start of the curve.
                let [p, q] = ends.map(|w| self.shift[w as usize]);
                self.shift[v as usize] = 0.5 * ((gaps[0] + p) + (gaps[1] + q));
            }
        }
        for &Sliding { v, edge, gaps, .. } in &self.sliding {
            let shift = &mut self.shift[v as usize];
            let (low, high) = (REACH * gaps[0].min(gaps[1]).min(0.0), REACH * gaps[0].max(gaps[1]).max(0.0));
            *shift = shift.clamp(low, high);
            let [here, _] = work.places_from(v, edge);
            self.moved[v as usize] = work.curve_point(edge, here + *shift);
        }
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
        let (at, near) = work.put_on(v as u32, to);
        work.near[v] = near;
        at
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
