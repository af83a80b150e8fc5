//! Bezier curves of any degree.

use glam::Vec3;

/// A Bezier curve: one control point or more; a plane curve has z = 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The control points in order; the degree is one less than their number.
    pub points: Vec<Vec3>,
}

/// One de Casteljau step: the points at `t` between each two that follow each other.
fn step(points: &[Vec3], t: f32) -> Vec<Vec3> {
    points.windows(2).map(|pair| mix(pair[0], pair[1], t)).collect()
}

/// `a` at 0 and `b` at 1, both to the bit.
pub(super) fn mix(a: Vec3, b: Vec3, t: f32) -> Vec3 {
    a * (1.0 - t) + b * t
}

impl Curve {
    /// The levels of de Casteljau's construction at `t`: the control points first, then one point
    /// fewer each time, down to the one on the curve. Costs O(n^2) for n points.
    pub fn construction(&self, t: f32) -> Vec<Vec<Vec3>> {
        let mut levels = vec![self.points.clone()];
        while let Some(last) = levels.last().filter(|level| level.len() > 1) {
            levels.push(step(last, t));
        }
        levels
    }

    /// The point at `t` in 0..=1; the origin for a curve without points.
    pub fn point(&self, t: f32) -> Vec3 {
        let mut points = self.points.clone();
        while points.len() > 1 {
            points = step(&points, t);
        }
        points.first().copied().unwrap_or_default()
    }

    /// The derivative at `t`, of length n times the last difference for degree n.
    pub fn derivative(&self, t: f32) -> Vec3 {
        let degree = self.points.len().saturating_sub(1) as f32;
        let hodograph =
            Self { points: self.points.windows(2).map(|pair| (pair[1] - pair[0]) * degree).collect() };
        hodograph.point(t)
    }

    /// `segments` + 1 points along the curve, evenly spaced in t.
    pub fn polyline(&self, segments: usize) -> Vec<Vec3> {
        (0..=segments).map(|i| self.point(i as f32 / segments.max(1) as f32)).collect()
    }

    /// The two curves of the same degree that the part up to `t` and the rest are: the first and
    /// the last points of the construction's levels.
    pub fn split(&self, t: f32) -> (Self, Self) {
        let levels = self.construction(t);
        let first = levels.iter().filter_map(|level| level.first().copied()).collect();
        let rest = levels.iter().rev().filter_map(|level| level.last().copied()).collect();
        (Self { points: first }, Self { points: rest })
    }

    /// The same curve with one control point more (Farin 5.1).
    #[must_use]
    pub fn elevated(&self) -> Self {
        let n = self.points.len();
        let (Some(&first), Some(&last)) = (self.points.first(), self.points.last()) else {
            return self.clone();
        };
        let mut points = Vec::with_capacity(n + 1);
        points.push(first);
        for (i, pair) in self.points.windows(2).enumerate() {
            points.push(mix(pair[1], pair[0], (i + 1) as f32 / n as f32));
        }
        points.push(last);
        Self { points }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The closed form: the sum of points times Bernstein polynomials, in double precision.
    fn bernstein(points: &[Vec3], t: f32) -> Vec3 {
        let n = points.len() - 1;
        let t = f64::from(t);
        let mut sum = glam::DVec3::ZERO;
        let mut binomial = 1.0;
        for (i, p) in points.iter().enumerate() {
            let weight = binomial * t.powi(i as i32) * (1.0 - t).powi((n - i) as i32);
            sum += p.as_dvec3() * weight;
            binomial = binomial * (n - i) as f64 / (i + 1) as f64;
        }
        sum.as_vec3()
    }

    fn curve() -> impl Strategy<Value = Curve> {
        proptest::collection::vec((-9.0f32..9.0, -9.0f32..9.0, -9.0f32..9.0), 1..9)
            .prop_map(|points| Curve { points: points.into_iter().map(Vec3::from).collect() })
    }

    proptest! {
        #[test]
        fn points_are_those_of_the_closed_form(curve in curve(), t in 0.0f32..=1.0) {
            prop_assert!(curve.point(t).distance(bernstein(&curve.points, t)) < 1e-4);
            let levels = curve.construction(t);
            prop_assert_eq!(levels.len(), curve.points.len());
            prop_assert_eq!(levels.last().and_then(|l| l.first()).copied(), Some(curve.point(t)));
            for (i, level) in levels.iter().enumerate() {
                prop_assert_eq!(level.len(), curve.points.len() - i);
            }
        }

        #[test]
        fn ends_are_exact_and_halves_and_elevation_are_the_same_curve(
            curve in curve(), at in 0.0f32..=1.0, t in 0.0f32..=1.0
        ) {
            prop_assert_eq!(curve.point(0.0), curve.points[0]);
            prop_assert_eq!(curve.point(1.0), *curve.points.last().unwrap());
            prop_assert_eq!(curve.elevated().points.len(), curve.points.len() + 1);
            prop_assert!(curve.elevated().point(t).distance(curve.point(t)) < 1e-4);
            let (a, b) = curve.split(at);
            prop_assert_eq!(a.points.last(), b.points.first());
            prop_assert!(a.point(t).distance(curve.point(at * t)) < 1e-4);
            prop_assert!(b.point(t).distance(curve.point(at + (1.0 - at) * t)) < 1e-4);
        }

        #[test]
        fn the_derivative_is_the_slope(curve in curve(), t in 0.1f32..0.9) {
            let h = 1e-3f32;
            let slope = (bernstein(&curve.points, t + h) - bernstein(&curve.points, t - h)) / (2.0 * h);
            prop_assert!(curve.derivative(t).distance(slope) < 0.2, "{} {}", curve.derivative(t), slope);
        }
    }

    #[test]
    fn a_curve_without_points_has_nothing_to_show() {
        let none = Curve::default();
        assert_eq!(none.point(0.5), Vec3::ZERO);
        assert_eq!(none.elevated(), none);
        assert_eq!(none.construction(0.5), [vec![]]);
    }
}
