//! Shapes of revolution about the y axis.

use super::build_mesh;
use crate::SurfaceError;
use crate::trig::sin_cos_turns;
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};

/// Point `i` of `n` on a circle of this radius at this height. Points run counter-clockwise as seen from +y.
fn on_circle(radius: f64, y: f64, i: u32, n: u32) -> Vec3 {
    let (sin, cos) = sin_cos_turns(f64::from(i) / f64::from(n));
    Vec3::new((radius * cos) as f32, y as f32, (-radius * sin) as f32)
}

/// A surface of revolution, made ring by ring from the bottom up.
struct Revolution {
    soup: PolygonSoup,
    segments: u32,
    /// The first vertex of the last ring.
    latest: Option<u32>,
}

impl Revolution {
    fn new(segments: u32) -> Self {
        Self { soup: PolygonSoup::default(), segments, latest: None }
    }

    /// Adds a ring above the last one, joined to it by quads.
    fn ring(&mut self, radius: f64, y: f64) {
        let (n, first) = (self.segments, self.soup.positions.len() as u32);
        self.soup.positions.extend((0..n).map(|i| on_circle(radius, y, i, n)));
        if let Some(below) = self.latest {
            for i in 0..n {
                let j = (i + 1) % n;
                self.soup.push_face([below + i, below + j, first + j, first + i]);
            }
        }
        self.latest = Some(first);
    }

    /// Adds a point above the last ring, joined to it by triangles.
    fn top(&mut self, y: f64) {
        let tip = self.soup.positions.len() as u32;
        self.soup.positions.push(Vec3::new(0.0, y as f32, 0.0));
        if let Some(below) = self.latest {
            for i in 0..self.segments {
                self.soup.push_face([below + i, below + (i + 1) % self.segments, tip]);
            }
        }
    }

    /// Closes the last ring with a polygon that faces up or down.
    fn cap(&mut self, facing_up: bool) {
        if let Some(first) = self.latest {
            let ring = first..first + self.segments;
            if facing_up {
                self.soup.push_face(ring);
            } else {
                self.soup.push_face(ring.rev());
            }
        }
    }
}

pub(super) fn uv_sphere(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let (radius, segments, rings) = (values[0], values[1] as u32, values[2] as u32);
    let mut turned = Revolution::new(segments);
    let y = |ring: u32| sin_cos_turns(f64::from(ring) / f64::from(2 * rings));
    for ring in 1..rings {
        let (sin, cos) = y(ring);
        turned.ring(radius * sin, -radius * cos);
    }
    turned.top(radius);
    // The triangles at the lower pole run around the first ring the other way.
    let pole = turned.soup.positions.len() as u32;
    turned.soup.positions.push(Vec3::new(0.0, -radius as f32, 0.0));
    for i in 0..segments {
        turned.soup.push_face([(i + 1) % segments, i, pole]);
    }
    build_mesh(turned.soup)
}

pub(super) fn cylinder(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let (radius, height, segments, rings) = (values[0], values[1], values[2] as u32, values[3] as u32);
    let mut turned = Revolution::new(segments);
    for ring in 0..=rings {
        turned.ring(radius, height * (f64::from(ring) / f64::from(rings) - 0.5));
        if ring == 0 {
            turned.cap(false);
        }
    }
    turned.cap(true);
    build_mesh(turned.soup)
}

pub(super) fn cone(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let (radius, height) = (values[0], values[1]);
    let mut turned = Revolution::new(values[2] as u32);
    turned.ring(radius, -height / 2.0);
    turned.cap(false);
    turned.top(height / 2.0);
    build_mesh(turned.soup)
}

pub(super) fn torus(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let (radius, tube, segments, around) = (values[0], values[1], values[2] as u32, values[3] as u32);
    if tube >= radius {
        return Err(SurfaceError::field("tube_radius", "smaller than radius"));
    }
    let mut turned = Revolution::new(segments);
    // From the inside over the bottom, so that quads joined upwards along the profile face outward.
    for k in 0..around {
        let (sin, cos) = sin_cos_turns(f64::from(k) / f64::from(around));
        turned.ring(radius + tube * cos, tube * sin);
    }
    let last = (around - 1) * segments;
    for i in 0..segments {
        let j = (i + 1) % segments;
        turned.soup.push_face([last + i, last + j, j, i]);
    }
    build_mesh(turned.soup)
}
