//! Models far from the origin: positions are kept relative to a point near them.
//!
//! A position is three `f32`. Far from the origin, as map coordinates are, those are too coarse: at
//! five million they are half a unit apart. So a file whose model lies far away for its size is
//! read a second time with coordinates in `f64`, from which an offset is subtracted before they are
//! rounded. Writers add it again. Files whose numbers fit `f32` get an offset too: the results of edits
//! don't fit.

use crate::model::NamedMesh;
use glam::{DVec3, Vec3};
use halfedge::{Mesh, VertexId};

/// What positions are relative to, and how much they are rounded with and without it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Origin {
    /// What is subtracted from every position.
    pub offset: DVec3,
    /// The largest rounding of a coordinate without the offset.
    lost: f64,
    /// The largest rounding of a coordinate with the offset.
    rounded: f64,
}

impl Origin {
    pub(crate) fn new(offset: DVec3) -> Self {
        Self { offset, lost: 0.0, rounded: 0.0 }
    }

    /// A position relative to the offset.
    pub(crate) fn place(&mut self, position: DVec3) -> Vec3 {
        let placed = (position - self.offset).as_vec3();
        let lost = (position - position.as_vec3().as_dvec3()).abs().max_element();
        let rounded = (position - self.offset - placed.as_dvec3()).abs().max_element();
        if lost.is_finite() && rounded.is_finite() {
            self.lost = self.lost.max(lost);
            self.rounded = self.rounded.max(rounded);
        }
        placed
    }

    /// Whether no digits of the file are lost by the offset. Vertices in no face may lie far from it.
    pub(crate) fn is_sound(&self) -> bool {
        self.rounded <= self.lost
    }
}

/// Where the faces and control points of a document lie.
pub(crate) struct Bounds {
    low: DVec3,
    high: DVec3,
}

impl Bounds {
    /// A model is far away if it lies this many times its size from the origin: then at least 8 of the
    /// 24 bits of a coordinate say nothing about its shape.
    const FAR_SIZES: f64 = 256.0;

    /// Coordinates this large are on a map, not in a model's own space: `f32` are 1/64 or more apart there.
    const MIN_MAP_COORDINATE: f64 = 131_072.0;

    /// A map is far away if it lies this many times its size from the origin. An edit of a tenth of a unit, five
    /// million away, is kept in a map of 600 thousand units.
    const FAR_SIZES_ON_MAP: f64 = 8.0;

    /// The bounds of all vertices of faces and all control points; of all vertices where there are none:
    /// faces far from the origin may have been lost to rounding.
    pub(crate) fn of(objects: &[NamedMesh]) -> Self {
        let mut bounds = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
        let add_vertices = |bounds: &mut Self, is_added: fn(&Mesh, VertexId) -> bool| {
            for mesh in objects.iter().map(|object| &object.mesh) {
                mesh.vertices().filter(|&v| is_added(mesh, v)).for_each(|v| bounds.add(mesh.position(v)));
            }
        };
        add_vertices(&mut bounds, |mesh, v| mesh.halfedge_from(v).is_some());
        for bezier in objects.iter().filter_map(|object| object.bezier.as_ref()) {
            bezier.points().into_iter().for_each(|point| bounds.add(point));
        }
        if bounds.size() < 0.0 {
            add_vertices(&mut bounds, |_, _| true);
        }
        bounds
    }

    fn add(&mut self, position: Vec3) {
        self.low = self.low.min(position.as_dvec3());
        self.high = self.high.max(position.as_dvec3());
    }

    fn size(&self) -> f64 {
        (self.high - self.low).max_element()
    }

    /// The best offset for a model far away: its middle along the axes on which it is far away, in whole
    /// numbers if the model is larger than 1. A model that rounding made a point is far away, too.
    pub(crate) fn offset(&self) -> Option<DVec3> {
        let size = self.size();
        if !(size.is_finite() && size >= 0.0) {
            return None;
        }
        let along = |low: f64, high: f64| {
            let middle = low + (high - low) / 2.0;
            let far = if middle.abs() >= Self::MIN_MAP_COORDINATE {
                Self::FAR_SIZES_ON_MAP
            } else {
                Self::FAR_SIZES
            };
            if middle.abs() <= size * far {
                return 0.0;
            }
            // A power of two, so that multiples of it are exact; not finer than the coordinates, so that
            // the differences from the offset are exact too.
            let spacing = middle.abs().log2().floor() - f64::from(f32::MANTISSA_DIGITS - 1);
            let step = if size > 0.0 { size.log2().floor().min(spacing.max(0.0)).exp2() } else { 1.0 };
            (middle / step).round() * step
        };
        let offset = DVec3::from_array([0, 1, 2].map(|i| along(self.low[i], self.high[i])));
        (offset != DVec3::ZERO && offset.is_finite()).then_some(offset)
    }

    /// Whether a model with these bounds, which was read with the offset, keeps it.
    pub(crate) fn is_worth(&self, origin: &Origin) -> bool {
        self.size() > 0.0 && origin.is_sound()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn offset(low: [f64; 3], high: [f64; 3]) -> Option<DVec3> {
        Bounds { low: low.into(), high: high.into() }.offset()
    }

    #[test]
    fn only_what_is_far_away_for_its_size_gets_an_offset() {
        assert_eq!(offset([0.0; 3], [1.0; 3]), None);
        assert_eq!(offset([100.0; 3], [101.0; 3]), None);
        assert_eq!(offset([5e5, -3.0, 9.0], [5e5 + 10.0, 4.0, 11.0]), Some(DVec3::new(500_005.0, 0.0, 0.0)));
        assert_eq!(offset([1e3; 3], [1e3 + 0.01; 3]), Some(DVec3::splat(1e3 + 0.0078125)));
        assert_eq!(offset([7.0; 3], [7.0; 3]), Some(DVec3::splat(7.0)), "a point");
        assert_eq!(offset([5e6; 3], [5.1e6; 3]), Some(DVec3::splat(5_050_000.0)), "a large part of a map");
        assert_eq!(offset([4e6; 3], [5e6; 3]), None, "most of a map");
        assert_eq!(offset([0.0; 3], [0.0; 3]), None);
        assert_eq!(offset([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]), None);
        assert_eq!(offset([-3e38; 3], [3e38; 3]), None);
    }

    #[test]
    fn what_would_be_lost_is_measured() {
        let mut origin = Origin::new(DVec3::splat(5_000_000.0));
        assert_eq!(origin.place(DVec3::splat(5_000_001.0)), Vec3::ONE);
        assert_eq!((origin.lost, origin.rounded), (0.0, 0.0));
        assert!(origin.is_sound(), "numbers that fit, but edits wouldn't");
        assert_eq!(origin.place(DVec3::new(5_000_000.125, 5e6, 5e6)), Vec3::new(0.125, 0.0, 0.0));
        assert_eq!((origin.lost, origin.rounded), (0.125, 0.0));
        let mut origin = Origin::new(DVec3::splat(5_000_000.0));
        origin.place(DVec3::new(f64::from(0.4_f32), 5e6, 5e6));
        assert!(!origin.is_sound(), "{origin:?}");
    }
}
