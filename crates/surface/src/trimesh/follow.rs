//! Values that follow a vertex as it moves over the surface.

use super::{TriMesh, next, prev};
use crate::face_tree::along_segment;
use glam::{DVec3, Vec3};
use halfedge::attribute::{Column, Value};
use halfedge::{Color, keys};

/// A place in the plane of a triangle: a side that leaves the vertex, and the weights of its corner and the two
/// after it.
type Place = (u32, [f32; 3]);

impl TriMesh {
    /// Moves a vertex over the surface. The values at its corners and its own become those that its triangles have
    /// at the new place; each corner takes the triangle with its value that is closest to the place.
    pub fn slide(&mut self, v: u32, to: DVec3) {
        if !self.wedge.is_empty() || !self.vertex_columns.is_empty() {
            let places = self.places_around(v, to);
            if let Some((h, weights)) = best(&places, |_| true) {
                let corners = [h, next(h), prev(h)].map(|h| self.v[h as usize] as usize);
                weigh_all(&mut self.vertex_columns, corners, weights);
            }
            self.slide_corners(&places);
        }
        self.put(v, to);
    }

    /// Merges the end of an edge into its start, which moves to `at`. Attributes are interpolated along the edge
    /// up to the point closest to `at`, and follow the vertex from there.
    pub fn collapse_to(&mut self, h: u32, at: DVec3) {
        let (v, from, to) = (self.from(h), self.at(self.from(h)), self.at(self.to(h)));
        let t = along_segment(from, to, at);
        self.collapse(h, t);
        let on_edge = if t == 1.0 { to } else { from + (to - from) * t };
        if on_edge == at {
            self.put(v, at);
        } else {
            self.put(v, on_edge);
            self.slide(v, at);
        }
    }

    fn slide_corners(&mut self, places: &[Place]) {
        if self.wedge.is_empty() {
            return;
        }
        for (i, &(h, _)) in places.iter().enumerate() {
            let wedge = self.wedge[h as usize];
            let has_wedge = |h: u32| self.wedge[h as usize] == wedge;
            if places[..i].iter().any(|&(h, _)| has_wedge(h)) {
                continue;
            }
            if let Some((h, weights)) = best(places, has_wedge) {
                let corners = [h, next(h), prev(h)].map(|h| self.wedge[h as usize] as usize);
                weigh_all(&mut self.corner_columns, corners, weights);
            }
        }
    }

    /// The place in each triangle of a vertex that has area.
    fn places_around(&self, v: u32, to: DVec3) -> Vec<Place> {
        let mut places = Vec::new();
        let here = self.at(v);
        self.around(v, |h| {
            let (x, y) = (self.at(self.to(h)) - here, self.at(self.apex(h)) - here);
            let normal = x.cross(y);
            let squared = normal.length_squared();
            if squared > 0.0 {
                let by = to - here;
                let (along_x, along_y) =
                    (by.cross(y).dot(normal) / squared, x.cross(by).dot(normal) / squared);
                places.push((h, [1.0 - along_x - along_y, along_x, along_y].map(|weight| weight as f32)));
            }
        });
        places
    }
}

/// The place that is deepest inside its triangle, or the least outside, among those of some half-edges.
fn best(places: &[Place], among: impl Fn(u32) -> bool) -> Option<Place> {
    let depth = |(_, weights): &Place| weights.iter().copied().fold(f32::MAX, f32::min);
    places.iter().filter(|&&(h, _)| among(h)).copied().max_by(|a, b| depth(a).total_cmp(&depth(b)))
}

/// Puts the weighted sum of three values in place of the first. Whole numbers and creases stay, and so do values
/// where one of the three is missing.
fn weigh_all(columns: &mut [Column], corners: [usize; 3], [s, t, u]: [f32; 3]) {
    let at = corners[0];
    for column in columns.iter_mut().filter(|column| column.name != keys::VERTEX_CREASE.name) {
        let sum = match corners.map(|corner| column.values.get(corner)) {
            [Some(Value::F32(a)), Some(Value::F32(b)), Some(Value::F32(c))] => {
                Some(Value::F32(a * s + b * t + c * u)).filter(|_| (a + b + c).is_finite())
            }
            [Some(Value::Vec2(a)), Some(Value::Vec2(b)), Some(Value::Vec2(c))] => {
                Some(Value::Vec2(a * s + b * t + c * u)).filter(|_| (a + b + c).is_finite())
            }
            [Some(Value::Vec3(a)), Some(Value::Vec3(b)), Some(Value::Vec3(c))] => {
                Some(Value::Vec3(a * s + b * t + c * u)).filter(|_| (a + b + c).is_finite())
            }
            [Some(Value::Color(a)), Some(Value::Color(b)), Some(Value::Color(c))] => {
                let [a, b, c] = [a, b, c].map(|color| Vec3::from(color.0.map(f32::from)));
                // `as` keeps channels in range.
                let channels = (a * s + b * t + c * u).to_array().map(|channel| channel.round() as u8);
                Some(Value::Color(Color(channels)))
            }
            _ => None,
        };
        if let Some(sum) = sum {
            column.values.set(at, sum);
        }
    }
}
