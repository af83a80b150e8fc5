//! Error quadrics: sums of squared distances to planes, as functions of a point.

use glam::DVec3;

/// x'Ax + 2 b'x + c, with A symmetric (Garland and Heckbert 1997).
#[derive(Clone, Copy, Default)]
pub(super) struct Quadric {
    /// xx, xy, xz, yy, yz, zz.
    a: [f64; 6],
    b: DVec3,
    c: f64,
}

impl Quadric {
    /// `weight` times the squared distance to the plane through `point` with unit `normal`.
    pub fn plane(normal: DVec3, point: DVec3, weight: f64) -> Self {
        let n = normal;
        let d = -n.dot(point);
        let w = n * weight;
        Self {
            a: [w.x * n.x, w.x * n.y, w.x * n.z, w.y * n.y, w.y * n.z, w.z * n.z],
            b: w * d,
            c: weight * d * d,
        }
    }

    /// `weight` times the squared distance to a point.
    pub fn point(point: DVec3, weight: f64) -> Self {
        Self {
            a: [weight, 0.0, 0.0, weight, 0.0, weight],
            b: point * -weight,
            c: weight * point.length_squared(),
        }
    }

    #[inline]
    pub fn add(&mut self, other: &Self) {
        for (x, y) in self.a.iter_mut().zip(&other.a) {
            *x += y;
        }
        self.b += other.b;
        self.c += other.c;
    }

    #[inline]
    pub fn sum(mut self, other: &Self) -> Self {
        self.add(other);
        self
    }

    /// The error at a point, never negative.
    #[inline]
    pub fn at(&self, p: DVec3) -> f64 {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        let ap = DVec3::new(
            xx * p.x + xy * p.y + xz * p.z,
            xy * p.x + yy * p.y + yz * p.z,
            xz * p.x + yz * p.y + zz * p.z,
        );
        (p.dot(ap + 2.0 * self.b) + self.c).max(0.0)
    }

    /// The point of least error, by LDL' factorisation; none if a pivot shows that the planes leave a direction
    /// open.
    #[inline]
    pub fn minimum(&self) -> Option<DVec3> {
        let [xx, xy, xz, yy, yz, zz] = self.a;
        let tiny = 1e-10 * (xx + yy + zz);
        if xx <= tiny {
            return None;
        }
        let (l1, l2) = (xy / xx, xz / xx);
        let d1 = yy - l1 * xy;
        if d1 <= tiny {
            return None;
        }
        let m = yz - l1 * xz;
        let l3 = m / d1;
        let d2 = zz - l2 * xz - l3 * m;
        if d2 <= tiny {
            return None;
        }
        let y0 = -self.b.x;
        let y1 = -self.b.y - l1 * y0;
        let y2 = -self.b.z - l2 * y0 - l3 * y1;
        let z = y2 / d2;
        let y = y1 / d1 - l3 * z;
        let x = y0 / xx - l1 * y - l2 * z;
        Some(DVec3::new(x, y, z))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_planes_meet_in_a_point() {
        let p = DVec3::new(0.3, -0.2, 0.7);
        let mut q = Quadric::default();
        for (n, w) in
            [(DVec3::new(1.0, 2.0, 2.0) / 3.0, 1.0), (DVec3::Y, 2.0), (DVec3::new(0.6, 0.0, -0.8), 0.5)]
        {
            q.add(&Quadric::plane(n, p, w));
        }
        assert!(q.minimum().expect("a point").distance(p) < 1e-12);
        assert!(q.at(p) < 1e-15);
        // Two units along y: 4 in the first plane at 2/3 each, 4 times 2 in the second.
        assert!((q.at(p + 2.0 * DVec3::Y) - (16.0 / 9.0 + 8.0)).abs() < 1e-12);
    }

    #[test]
    fn one_plane_leaves_it_open() {
        assert!(Quadric::plane(DVec3::Z, DVec3::ONE, 1.0).minimum().is_none());
        let q = Quadric::point(DVec3::ONE, 3.0);
        assert_eq!(q.minimum(), Some(DVec3::ONE));
        assert_eq!(q.at(DVec3::ZERO), 9.0);
    }
}
