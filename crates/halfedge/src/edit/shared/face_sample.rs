//! Interpolating values at a place in the plane of a face.

use crate::attribute::Value;
use crate::geometry::{mean_value_weights, polygon_area_vector};
use crate::mesh::Mesh;
use crate::{Element, HalfedgeId};
use glam::{DVec2, DVec3, Vec3};

/// The most corners of a face that values are interpolated from.
const MAX_SAMPLED_CORNERS: usize = 32;

/// The corners of a face that values are interpolated from, in the face's plane.
///
/// These are all corners. Of a face with more than 32 they are one corner, its neighbours and some others, evenly spread:
/// following every corner of a large face would cost the square of their number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FaceSample {
    corners: Vec<HalfedgeId>,
    vertices: Vec<u32>,
    flat: Vec<DVec2>,
    origin: DVec3,
    /// None for a face without area.
    axes: Option<(DVec3, DVec3)>,
}

impl FaceSample {
    /// Whether one sample serves all corners of a face.
    pub(crate) fn is_shared(sides: &[HalfedgeId]) -> bool {
        sides.len() <= MAX_SAMPLED_CORNERS
    }

    /// A sample of the face with these half-edges, for the corner with the number `own`.
    pub(crate) fn new(mesh: &Mesh, sides: &[HalfedgeId], own: usize) -> Self {
        let count = sides.len();
        let corners: Vec<HalfedgeId> = if Self::is_shared(sides) {
            sides.to_vec()
        } else {
            let spread = MAX_SAMPLED_CORNERS - 3;
            // Steps from the corner: 0, 1, evenly spaced ones, and all round but one.
            let steps = [0, 1].into_iter().chain((1..=spread).map(|i| 1 + i * (count - 2) / (spread + 1)));
            let steps = steps.chain([count - 1]);
            steps.map(|step| sides[(own + step) % count]).collect()
        };
        let vertices: Vec<u32> = corners.iter().map(|&h| mesh.from(h).raw()).collect();
        let positions: Vec<Vec3> = corners.iter().map(|&h| mesh.position(mesh.from(h))).collect();
        let origin = positions.first().copied().unwrap_or_default().as_dvec3();
        let normal = polygon_area_vector(positions.iter().copied()).try_normalize();
        let axes = normal.map(|normal| normal.any_orthonormal_pair());
        let mut sample = Self { corners, vertices, flat: Vec::new(), origin, axes };
        sample.flat = positions.iter().filter_map(|&p| sample.project(p)).collect();
        sample
    }

    fn project(&self, position: Vec3) -> Option<DVec2> {
        let (x, y) = self.axes?;
        // Relative to a corner, so that faces far from the origin keep their precision.
        let from_origin = position.as_dvec3() - self.origin;
        Some(DVec2::new(from_origin.dot(x), from_origin.dot(y)))
    }

    /// The weights of the sample's corners at a position, seen along the face's normal. None for a face without area.
    pub(crate) fn weights(&self, position: Vec3) -> Option<Vec<f64>> {
        mean_value_weights(&self.flat, self.project(position)?)
    }

    /// The values of a column of half-edges or vertices at the sample's corners; none if some are missing.
    pub(crate) fn values(&self, mesh: &Mesh, element: Element, column: usize) -> Option<Vec<Numbers>> {
        let values = &mesh.columns.of(element).get(column)?.values;
        let value = |i: usize| {
            let id = if element == Element::Vertex { self.vertices[i] } else { self.corners[i].raw() };
            numbers(values.get(id as usize)?)
        };
        (0..self.corners.len()).map(value).collect()
    }
}

/// The components of a value; unused ones are zero.
pub(crate) type Numbers = [f32; 3];

/// The components of a value that can be interpolated. None for whole numbers and missing values.
pub(crate) fn numbers(value: Value) -> Option<Numbers> {
    let numbers = match value {
        Value::F32(x) => [x, 0.0, 0.0],
        Value::Vec2(v) => [v.x, v.y, 0.0],
        Value::Vec3(v) => v.to_array(),
        Value::Color(color) => color.0.map(f32::from),
        Value::U32(_) => return None,
    };
    numbers.iter().all(|x| x.is_finite()).then_some(numbers)
}
