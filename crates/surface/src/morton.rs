//! Sorting points along a space-filling curve, so that neighbours in the order are close in space.

use crate::measure::Bounds;
use glam::Vec3;

/// The points' numbers in order of their Morton codes (10 bits per axis), stably. Costs O(points): three passes
/// of a radix sort.
pub(crate) fn order(points: impl Iterator<Item = (u32, Vec3)> + Clone) -> Vec<u32> {
    let all = points.clone().map(|(_, point)| point).fold(Bounds::EMPTY, Bounds::with);
    let size = (all.max.as_dvec3() - all.min.as_dvec3()).max_element();
    let scale = if size > 0.0 && size.is_finite() { (1023.0 / size) as f32 } else { 0.0 };
    let mut codes: Vec<(u32, u32)> = points
        .map(|(i, point)| {
            let cell = ((point - all.min) * scale).clamp(Vec3::ZERO, Vec3::splat(1023.0));
            (spread(cell.x as u32) | spread(cell.y as u32) << 1 | spread(cell.z as u32) << 2, i)
        })
        .collect();
    let mut sorted = vec![(0, 0); codes.len()];
    for shift in [0, 10, 20] {
        let mut starts = [0u32; 1025];
        for (code, _) in &codes {
            starts[(code >> shift & 1023) as usize + 1] += 1;
        }
        for digit in 0..1024 {
            starts[digit + 1] += starts[digit];
        }
        for &entry in &codes {
            let start = &mut starts[(entry.0 >> shift & 1023) as usize];
            sorted[*start as usize] = entry;
            *start += 1;
        }
        std::mem::swap(&mut codes, &mut sorted);
    }
    codes.into_iter().map(|(_, i)| i).collect()
}

/// The ten lowest bits with two zeros between each.
fn spread(bits: u32) -> u32 {
    let mut x = bits & 0x3ff;
    x = (x | x << 16) & 0x0300_00ff;
    x = (x | x << 8) & 0x0300_f00f;
    x = (x | x << 4) & 0x030c_30c3;
    (x | x << 2) & 0x0924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreading_interleaves() {
        for bits in 0..1024u32 {
            let expected = (0..10).map(|i| (bits >> i & 1) << (3 * i)).sum::<u32>();
            assert_eq!(spread(bits), expected);
        }
    }

    #[test]
    fn points_on_a_line_sort_along_it_and_ties_keep_their_order() {
        let points = [9.0, 1.0, 5.0, 1.0, 0.0].map(Vec3::splat);
        assert_eq!(order((0..).zip(points)), [4, 1, 3, 2, 0]);
        assert!(order([].into_iter()).is_empty());
    }
}
