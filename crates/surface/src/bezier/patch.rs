//! Bicubic Bezier patches.

use super::curve::mix;
use glam::Vec3;

/// A bicubic patch: rows of control points; u runs along a row and v from row to row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patch {
    /// `rows[j][i]`: row j, point i.
    pub rows: [[Vec3; 4]; 4],
}

/// A point of a patch with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchPoint {
    /// The position.
    pub position: Vec3,
    /// The derivative along u.
    pub du: Vec3,
    /// The derivative along v.
    pub dv: Vec3,
    /// The unit normal: along `du` x `dv` where those span a plane, else its limit where a side of the patch is a
    /// single point; zero where that is undefined too.
    pub normal: Vec3,
}

/// The construction of a point: de Casteljau along each row, then along the column of results.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchConstruction {
    /// Per row, the levels at u, from four points to one.
    pub rows: [Vec<Vec<Vec3>>; 4],
    /// The levels at v over the rows' results, from four points to the point of the patch.
    pub column: Vec<Vec<Vec3>>,
}

/// A point of a cubic and its derivative.
pub(super) fn cubic(p: [Vec3; 4], t: f32) -> (Vec3, Vec3) {
    let a = [mix(p[0], p[1], t), mix(p[1], p[2], t), mix(p[2], p[3], t)];
    let b = [mix(a[0], a[1], t), mix(a[1], a[2], t)];
    (mix(b[0], b[1], t), (b[1] - b[0]) * 3.0)
}

impl Patch {
    /// The point at (u, v), each from 0 to 1, by de Casteljau's construction.
    pub fn point(&self, u: f32, v: f32) -> PatchPoint {
        // Derivatives are multiplied and squared, so lengths are brought near 1, by a power of two to keep every bit.
        let size = self.size();
        let scale = (size.log2().floor() as f32).clamp(-126.0, 126.0).exp2();
        let near = self.rows.map(|row| row.map(|point| point / scale));
        let rows = near.map(|row| cubic(row, u));
        let (position, dv) = cubic(self.rows.map(|row| cubic(row, u).0), v);
        let dv_near = cubic(rows.map(|row| row.0), v).1;
        // The derivative along u is a cubic in v of the rows' derivatives; its derivative is the mixed one.
        let (du_near, mixed) = cubic(rows.map(|row| row.1), v);
        let du = du_near * scale;
        let size = (size / f64::from(scale)) as f32;
        let unit = |n: Vec3| (n.length() > 1e-6 * size * size).then(|| n.normalize());
        // Where a derivative vanishes (a side is a single point), its direction nearby is that of the mixed
        // derivative, inward.
        let inward = |t: f32| if t > 0.5 { -1.0 } else { 1.0 };
        let normal = unit(du_near.cross(dv_near))
            .or_else(|| unit((mixed * inward(v)).cross(dv_near)))
            .or_else(|| unit(du_near.cross(mixed * inward(u))))
            .unwrap_or_default();
        PatchPoint { position, du, dv, normal }
    }

    /// The construction of the point at (u, v).
    pub fn construction(&self, u: f32, v: f32) -> PatchConstruction {
        let curve = |points: &[Vec3]| super::Curve { points: points.to_vec() };
        let rows = self.rows.map(|row| curve(&row).construction(u));
        let results: Vec<Vec3> =
            rows.iter().filter_map(|levels| levels.last().and_then(|level| level.first()).copied()).collect();
        let column = curve(&results).construction(v);
        PatchConstruction { rows, column }
    }

    /// The longest side of the control points' bounding box.
    pub(super) fn size(&self) -> f64 {
        let points = self.rows.as_flattened();
        let low = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        (high.as_dvec3() - low.as_dvec3()).max_element()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn patch() -> impl Strategy<Value = Patch> {
        proptest::array::uniform4(proptest::array::uniform4((-5.0f32..5.0, -5.0f32..5.0, -5.0f32..5.0)))
            .prop_map(|rows| Patch { rows: rows.map(|row| row.map(Vec3::from)) })
    }

    fn bernstein(t: f64) -> [f64; 4] {
        let s = 1.0 - t;
        [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
    }

    fn closed_form(patch: &Patch, u: f32, v: f32) -> Vec3 {
        let (bu, bv) = (bernstein(u.into()), bernstein(v.into()));
        let mut sum = glam::DVec3::ZERO;
        for (row, wv) in patch.rows.iter().zip(bv) {
            for (p, wu) in row.iter().zip(bu) {
                sum += p.as_dvec3() * wu * wv;
            }
        }
        sum.as_vec3()
    }

    proptest! {
        #[test]
        fn points_are_those_of_the_closed_form(patch in patch(), u in 0.0f32..=1.0, v in 0.0f32..=1.0) {
            let point = patch.point(u, v);
            prop_assert!(point.position.distance(closed_form(&patch, u, v)) < 1e-4);
            let construction = patch.construction(u, v);
            let last = construction.column.last().and_then(|l| l.first()).copied().unwrap();
            prop_assert!(last.distance(point.position) < 1e-5);
            prop_assert_eq!(construction.rows.each_ref().map(|levels| levels.len()), [4; 4]);
        }

        #[test]
        fn derivatives_are_slopes(patch in patch(), u in 0.1f32..0.9, v in 0.1f32..0.9) {
            let h = 1e-3;
            let point = patch.point(u, v);
            let du = (closed_form(&patch, u + h, v) - closed_form(&patch, u - h, v)) / (2.0 * h);
            let dv = (closed_form(&patch, u, v + h) - closed_form(&patch, u, v - h)) / (2.0 * h);
            prop_assert!(point.du.distance(du) < 0.05 && point.dv.distance(dv) < 0.05);
        }
    }

    #[test]
    fn the_normal_at_a_pole_is_the_limit() {
        // A side drawn together to the top of a dome.
        let top = Vec3::Z;
        let row = |r: f32, z: f32| {
            [Vec3::new(r, 0.0, z), Vec3::new(r, r * 0.55, z), Vec3::new(r * 0.55, r, z), Vec3::new(0.0, r, z)]
        };
        let patch = Patch { rows: [[top; 4], row(0.5, 1.0), row(1.0, 0.5), row(1.0, 0.0)] };
        for u in [0.0, 0.3, 1.0] {
            let at_pole = patch.point(u, 0.0).normal;
            assert!(at_pole.distance(patch.point(u, 1e-3).normal) < 1e-2, "{at_pole}");
            assert!(at_pole.z.abs() > 0.999);
        }
        let flipped = Patch { rows: [row(1.0, 0.0), row(1.0, 0.5), row(0.5, 1.0), [top; 4]] };
        for u in [0.0, 0.3, 1.0] {
            let at_pole = flipped.point(u, 1.0).normal;
            assert!(at_pole.distance(flipped.point(u, 1.0 - 1e-3).normal) < 1e-2, "{at_pole}");
        }
    }

    #[test]
    fn a_patch_that_is_one_point_has_no_normal() {
        let patch = Patch { rows: [[Vec3::ONE; 4]; 4] };
        assert_eq!(patch.point(0.2, 0.7).normal, Vec3::ZERO);
        assert_eq!(patch.point(0.2, 0.7).position, Vec3::ONE);
    }
}
