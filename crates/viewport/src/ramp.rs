//! Colours for numbers and for labels. The ramps differ in lightness too, for eyes that see few colours.

use halfedge::Color;

/// Of so many curvatures the range of colours is found; of more, evenly spread ones are taken.
const SAMPLED_VALUES: usize = 100_000;
/// The share of the curvatures whose colours differ: a few extreme ones would leave no difference between the others.
const SHARE_IN_RANGE: f64 = 0.95;

/// From low over the middle to high.
const DIVERGING: [Color; 5] = [
    Color([0x1f, 0x5f, 0xc4]),
    Color([0x8f, 0xb8, 0xe8]),
    Color([0xec, 0xec, 0xec]),
    Color([0xf0, 0xa5, 0x7c]),
    Color([0xc4, 0x3a, 0x22]),
];
/// From low to high.
const SEQUENTIAL: [Color; 5] = [
    Color([0x44, 0x01, 0x54]),
    Color([0x3b, 0x52, 0x8b]),
    Color([0x21, 0x91, 0x8c]),
    Color([0x5e, 0xc9, 0x62]),
    Color([0xfd, 0xe7, 0x25]),
];
/// The colours of Okabe and Ito, which differ for all eyes.
const LABELS: [Color; 7] = [
    Color([0xe6, 0x9f, 0x00]),
    Color([0x56, 0xb4, 0xe9]),
    Color([0x00, 0x9e, 0x73]),
    Color([0xf0, 0xe4, 0x42]),
    Color([0x2f, 0x7f, 0xc2]),
    Color([0xd5, 0x5e, 0x00]),
    Color([0xcc, 0x79, 0xa7]),
];

/// The colours of a range of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// The number that the lowest colour stands for.
    pub low: f32,
    /// The number that the highest colour stands for.
    pub high: f32,
    /// The colours, evenly spaced.
    pub colors: [Color; 5],
}

impl Ramp {
    /// Blue below the middle, red above.
    pub const fn diverging(low: f32, high: f32) -> Self {
        Self { low, high, colors: DIVERGING }
    }

    /// Dark to light.
    pub const fn sequential(low: f32, high: f32) -> Self {
        Self { low, high, colors: SEQUENTIAL }
    }

    /// The colour of a number; numbers beyond the ends have the ends' colours, and what is not a number is unpainted.
    pub fn color(&self, value: f32) -> Color {
        if value.is_nan() {
            return Color::UNPAINTED;
        }
        let span = self.high - self.low;
        let at = if span > 0.0 { ((value - self.low) / span).clamp(0.0, 1.0) } else { 0.5 };
        let at = at * (self.colors.len() - 1) as f32;
        let below = (at as usize).min(self.colors.len() - 2);
        let [a, b] = [below, below + 1].map(|i| self.colors.get(i).copied().unwrap_or(Color::UNPAINTED).0);
        let t = at - below as f32;
        let mix = |a: u8, b: u8| (f32::from(a) + (f32::from(b) - f32::from(a)) * t).round() as u8;
        Color([mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2])])
    }
}

/// The colour of a label by its number. After seven they come again, darker, then lighter.
pub fn label_color(label: usize) -> Color {
    let color = LABELS.get(label % LABELS.len()).copied().unwrap_or(Color::UNPAINTED);
    match label / LABELS.len() % 3 {
        0 => color,
        1 => Color(color.0.map(|c| (u32::from(c) * 11 / 20) as u8)),
        _ => Color(color.0.map(|c| 255 - ((255 - u32::from(c)) / 2) as u8)),
    }
}

/// The magnitude that most values are below; 0 if there are none.
pub fn end_of_range(values: &[f32]) -> f32 {
    let step = values.len().div_ceil(SAMPLED_VALUES).max(1);
    let mut sample: Vec<f32> =
        values.iter().step_by(step).map(|value| value.abs()).filter(|value| value.is_finite()).collect();
    let last = (sample.len().saturating_sub(1) as f64 * SHARE_IN_RANGE).round() as usize;
    if sample.is_empty() {
        return 0.0;
    }
    *sample.select_nth_unstable_by(last, f32::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ramps_interpolate_between_their_ends() {
        let ramp = Ramp::diverging(-2.0, 2.0);
        assert_eq!(ramp.color(-9.0), DIVERGING[0]);
        assert_eq!(ramp.color(f32::NEG_INFINITY), DIVERGING[0]);
        assert_eq!(ramp.color(0.0), DIVERGING[2]);
        assert_eq!(ramp.color(1.0), DIVERGING[3]);
        assert_eq!(ramp.color(2.0), DIVERGING[4]);
        assert_eq!(ramp.color(f32::NAN), Color::UNPAINTED);
        assert_eq!(Ramp::diverging(0.0, 0.0).color(0.0), DIVERGING[2], "a plane has no curvature");
        let [r, g, b] = ramp.color(-1.5).0;
        assert_eq!([r, g, b], [0x57, 0x8c, 0xd6]);
    }

    #[test]
    fn many_labels_have_different_colours() {
        let colors: std::collections::HashSet<Color> = (0..21).map(label_color).collect();
        assert_eq!(colors.len(), 21);
    }
}
