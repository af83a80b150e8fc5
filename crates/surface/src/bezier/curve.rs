//! Bezier curves of any degree.

use glam::{DVec3, Vec3};

/// A Bezier curve with one or more control points; a plane curve has z = 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// The control points; the degree is one less than their number.
    pub points: Vec<Vec3>,
}

/// One de Casteljau step: the points at `t` between consecutive points.
fn step(points: &[Vec3], t: f32) -> Vec<Vec3> {
    points.windows(2).map(|pair| mix(pair[0], pair[1], t)).collect()
}

/// Interpolates from `a` at 0 to `b` at 1, both to the bit.
pub(super) fn mix(a: Vec3, b: Vec3, t: f32) -> Vec3 {
    a * (1.0 - t) + b * t
}

/// Points of curves with more control points are weighted sums: de Casteljau's construction takes time that grows
/// with the square of their number.
const MAX_DE_CASTELJAU_POINTS: usize = 33;

/// The point at `t` of the curve with these control points; the origin if there are none.
fn point_of(points: &[Vec3], t: f32) -> Vec3 {
    if points.len() > MAX_DE_CASTELJAU_POINTS {
        return weighted(points, t);
    }
    let mut points = points.to_vec();
    while points.len() > 1 {
        points = step(&points, t);
    }
    points.first().copied().unwrap_or_default()
}

/// The sum of the control points times the Bernstein polynomials at `t`, in double precision.
///
/// Only the few polynomials near t count. Starting from the largest, each follows from its neighbour, until they
/// are too small to matter even for points 10^20 times as far away. Costs O(sqrt(n)) for n points.
fn weighted(points: &[Vec3], t: f32) -> Vec3 {
    const MIN_WEIGHT: f64 = 1e-30;
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return Vec3::ZERO };
    if t <= 0.0 || t >= 1.0 {
        return if t <= 0.0 { first } else { last };
    }
    let degree = points.len() - 1;
    let (n, t) = (degree as f64, f64::from(t));
    let odds = t / (1.0 - t);
    let largest = (((n + 1.0) * t) as usize).min(degree);
    let (mut sum, mut total) = (DVec3::ZERO, 0.0);
    let mut weight = 1.0;
    for (i, point) in points.iter().enumerate().skip(largest) {
        sum += point.as_dvec3() * weight;
        total += weight;
        weight *= (n - i as f64) / (i as f64 + 1.0) * odds;
        if weight < MIN_WEIGHT {
            break;
        }
    }
    weight = 1.0;
    for (i, point) in points.iter().enumerate().take(largest).rev() {
        weight *= (i as f64 + 1.0) / (n - i as f64) / odds;
        if weight < MIN_WEIGHT {
            break;
        }
        sum += point.as_dvec3() * weight;
        total += weight;
    }
    (sum / total).as_vec3()
}

impl Curve {
    /// The levels of de Casteljau's construction at `t`: the control points, then one point fewer in each level,
    /// down to the point on the curve. Costs O(n^2) for n points.
    pub fn construction(&self, t: f32) -> Vec<Vec<Vec3>> {
        self.levels(t).collect()
    }

    /// The levels of [`Curve::construction`], made one by one.
    pub fn levels(&self, t: f32) -> impl Iterator<Item = Vec<Vec3>> {
        let first = Some(self.points.clone());
        std::iter::successors(first, move |level| (level.len() > 1).then(|| step(level, t)))
    }

    /// Every `stride`th point of a level of the construction at `t`: level 0 is the control points, the last
    /// level the point on the curve; empty beyond. Costs O(sqrt(level)) for each.
    pub fn level(&self, level: usize, t: f32, stride: usize) -> Vec<Vec3> {
        self.points.windows(level + 1).step_by(stride.max(1)).map(|points| point_of(points, t)).collect()
    }

    /// The point at `t` from 0 to 1; the origin for a curve without points. Costs O(sqrt(n)).
    pub fn point(&self, t: f32) -> Vec3 {
        point_of(&self.points, t)
    }

    /// The derivative at `t`.
    pub fn derivative(&self, t: f32) -> Vec3 {
        let degree = self.points.len().saturating_sub(1) as f32;
        let hodograph =
            Self { points: self.points.windows(2).map(|pair| (pair[1] - pair[0]) * degree).collect() };
        hodograph.point(t)
    }

    /// The curve from 0 to `end` as a polyline, evenly spaced in t and fine enough to look smooth: the bends of a
    /// curve with n control points are as short as 1 / sqrt(n) of it.
    pub fn polyline(&self, end: f32) -> Vec<Vec3> {
        let segments = (4 * self.points.len().isqrt()).clamp(256, 512);
        (0..=segments).map(|i| self.point(end * i as f32 / segments as f32)).collect()
    }

    /// Splits the curve at `t` into two of the same degree: the first and the last points of the construction's
    /// levels. Costs O(n^2) time and O(n) memory.
    pub fn split(&self, t: f32) -> (Self, Self) {
        let mut points = self.points.clone();
        let mut first = Vec::with_capacity(points.len());
        // Each level is one shorter; the last points that it leaves behind are the second curve.
        for level in (0..points.len()).rev() {
            first.push(points[0]);
            for i in 0..level {
                points[i] = mix(points[i], points[i + 1], t);
            }
        }
        (Self { points: first }, Self { points })
    }

    /// The same curve with one more control point (Farin 5.1).
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

    /// Control points that go up and down at random.
    fn wavy(count: usize) -> Curve {
        let height = |i: usize| ((i * 7919 + i * i * 31) % 97) as f32 / 9.7 - 5.0;
        let point = |i: usize| Vec3::new(i as f32 / count as f32 * 10.0, height(i), height(i + 40));
        Curve { points: (0..count).map(point).collect() }
    }

    /// De Casteljau's construction in double precision.
    fn steps(points: &[Vec3], t: f32) -> Vec3 {
        let t = f64::from(t);
        let mut points: Vec<DVec3> = points.iter().map(|p| p.as_dvec3()).collect();
        while points.len() > 1 {
            points = points.windows(2).map(|pair| pair[0] * (1.0 - t) + pair[1] * t).collect();
        }
        points[0].as_vec3()
    }

    #[test]
    fn curves_of_many_points_are_those_of_the_construction() {
        for count in [34, 35, 100, 1001, 3000] {
            let curve = wavy(count);
            for t in [0.0, 1e-7, 0.001, 0.25, 0.5, 0.7, 0.999, 1.0] {
                let (is, should) = (curve.point(t), steps(&curve.points, t));
                assert!(is.distance(should) < 1e-5, "{count} points at {t}: {is}, not {should}");
            }
            assert_eq!((curve.point(0.0), curve.point(1.0)), (curve.points[0], curve.points[count - 1]));
        }
        // A point as far away as there are numbers pulls as hard as its weight says.
        let mut far = wavy(2000);
        far.points[900].y = 1e38;
        let (is, should) = (far.point(0.3).y, steps(&far.points, 0.3).y);
        assert!((is - should).abs() <= 1e-5 * should.abs().max(1.0), "{is}, not {should}");
    }

    #[test]
    fn levels_and_halves_of_many_points_are_those_of_the_construction() {
        let curve = wavy(300);
        let levels = curve.construction(0.3);
        for (level, points) in levels.iter().enumerate() {
            for stride in [1, 7] {
                let some = curve.level(level, 0.3, stride);
                assert_eq!(some.len(), points.len().div_ceil(stride));
                for (is, should) in some.iter().zip(points.iter().step_by(stride)) {
                    assert!(is.distance(*should) < 1e-4, "level {level}: {is}, not {should}");
                }
            }
        }
        assert_eq!(curve.level(300, 0.3, 1), []);
        let (first, rest) = curve.split(0.3);
        let ends = |pick: fn(&Vec<Vec3>) -> Vec3| levels.iter().map(pick).collect::<Vec<_>>();
        assert_eq!(first.points, ends(|level| level[0]));
        assert_eq!(
            rest.points.iter().rev().copied().collect::<Vec<_>>(),
            ends(|level| *level.last().unwrap())
        );
    }

    #[test]
    fn a_line_of_a_million_points_takes_few_steps() {
        let line = wavy(1_000_000).polyline(0.5);
        assert_eq!(line.len(), 513);
        assert_eq!(line[0], Vec3::new(0.0, -5.0, line[0].z));
        assert!((line[512].x - 5.0).abs() < 1e-3, "{}", line[512]);
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
        assert_eq!(none.level(0, 0.5, 1), []);
        assert_eq!(none.split(0.5), (none.clone(), none.clone()));
    }
}
