//! Mean value coordinates: weights by which a value is interpolated between the corners of a polygon.
//!
//! M. S. Floater, "Mean value coordinates", 2003; K. Hormann and M. S. Floater, "Mean value coordinates for
//! arbitrary planar polygons", 2006. The weights add up to one and reproduce every linear function, inside
//! the polygon and outside. At a corner they are that corner's alone, on a side those of its two ends. They
//! exist for every polygon that doesn't cross itself, convex or not.

use glam::DVec2;

/// The sines of angles below this count as zero: the point lies on the line through the side.
const MIN_SINE: f64 = 1e-12;
/// Sums of weights smaller than this fraction of the sum of their absolute values are lost to rounding.
const MIN_SUM: f64 = 1e-6;

/// The weight of each corner at a point. None if there are no such weights: the polygon has no area or
/// crosses itself, and the point is on none of its sides.
pub(crate) fn mean_value_weights(polygon: &[DVec2], at: DVec2) -> Option<Vec<f64>> {
    let count = polygon.len();
    let mut weights = vec![0.0; count];
    let to: Vec<DVec2> = polygon.iter().map(|&corner| corner - at).collect();
    let distances: Vec<f64> = to.iter().map(|to| to.length()).collect();
    if let Some(corner) = distances.iter().position(|&distance| distance == 0.0) {
        weights[corner] = 1.0;
        return Some(weights);
    }
    for i in 0..count {
        let j = (i + 1) % count;
        let (sine, cosine) = (to[i].perp_dot(to[j]), to[i].dot(to[j]));
        let scale = distances[i] * distances[j];
        if sine.abs() <= MIN_SINE * scale {
            if cosine < 0.0 {
                let length = distances[i] + distances[j];
                weights.fill(0.0);
                weights[i] = distances[j] / length;
                weights[j] = distances[i] / length;
                return Some(weights);
            }
            continue;
        }
        // The tangent of half the angle between the two corners, in the form that doesn't cancel.
        let tangent = if cosine > 0.0 { sine / (scale + cosine) } else { (scale - cosine) / sine };
        weights[i] += tangent / distances[i];
        weights[j] += tangent / distances[j];
    }
    let sum: f64 = weights.iter().sum();
    let amount: f64 = weights.iter().map(|weight| weight.abs()).sum();
    if !sum.is_finite() || sum.abs() <= MIN_SUM * amount {
        return None;
    }
    weights.iter_mut().for_each(|weight| *weight /= sum);
    Some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An L, counter-clockwise, with a corner at a straight angle.
    fn polygon() -> Vec<DVec2> {
        [(0., 0.), (2., 0.), (4., 0.), (4., 2.), (2., 2.), (2., 4.), (0., 4.)].map(DVec2::from).to_vec()
    }

    #[test]
    fn linear_functions_are_reproduced_inside_and_outside() {
        for (x, y) in [(1.0, 1.0), (3.0, 1.5), (3.5, 3.0), (-1.0, 2.0), (9.0, -7.0), (2.0, 3.0), (4.0, 1.0)] {
            for turned in [false, true] {
                let mut corners = polygon();
                if turned {
                    corners.reverse();
                }
                let weights = mean_value_weights(&corners, DVec2::new(x, y)).unwrap();
                let at: DVec2 = corners.iter().zip(&weights).map(|(corner, weight)| *corner * *weight).sum();
                assert!(at.distance(DVec2::new(x, y)) < 1e-9, "{at} for {x} {y}");
                assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn sides_and_corners_have_the_weights_of_their_ends_alone() {
        let corners = polygon();
        let on_side = mean_value_weights(&corners, DVec2::new(4.0, 0.5)).unwrap();
        assert_eq!(on_side, [0.0, 0.0, 0.75, 0.25, 0.0, 0.0, 0.0]);
        let at_corner = mean_value_weights(&corners, DVec2::new(2.0, 2.0)).unwrap();
        assert_eq!(at_corner, [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }

    #[test]
    fn a_polygon_without_area_has_weights_on_its_sides() {
        let corners = [(0., 0.), (1., 0.), (3., 0.)].map(DVec2::from);
        assert_eq!(mean_value_weights(&corners, DVec2::new(2.0, 0.0)), Some(vec![0.0, 0.5, 0.5]));
        assert_eq!(mean_value_weights(&corners, DVec2::new(5.0, 0.0)), None);
        assert_eq!(mean_value_weights(&[DVec2::ZERO; 3], DVec2::ONE), None);
    }
}
