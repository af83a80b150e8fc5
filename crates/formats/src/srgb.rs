//! Channels of colours between sRGB, as colours are kept here, and linear light, as glTF has them
//! (IEC 61966-2-1). Worked out in double precision; 0, 1 and all of k / 255 come back to the bit.

/// An sRGB channel, linear.
pub(crate) fn to_linear(srgb: f32) -> f32 {
    let srgb = f64::from(srgb);
    (if srgb <= 0.040_45 { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) }) as f32
}

/// A linear channel in sRGB. Several may give one linear value: of those it is one of eight bits.
pub(crate) fn to_srgb(linear: f32) -> f32 {
    let wide = f64::from(linear);
    let srgb = if wide <= 0.003_130_8 { wide * 12.92 } else { 1.055 * wide.powf(1.0 / 2.4) - 0.055 };
    let eight_bits = (srgb * 255.0).round() as f32 / 255.0;
    if to_linear(eight_bits) == linear { eight_bits } else { srgb as f32 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_bit_values_come_back_to_the_bit() {
        for k in 0..=255u8 {
            let value = f32::from(k) / 255.0;
            assert_eq!(to_srgb(to_linear(value)).to_bits(), value.to_bits(), "{k} / 255");
        }
        assert_eq!([0.0, 1.0].map(to_linear), [0.0, 1.0]);
        assert_eq!([0.0, 1.0].map(to_srgb), [0.0, 1.0]);
        // Half of the light is brighter than half of the channel.
        assert!((to_srgb(0.5) - 0.735_36).abs() < 1e-5);
    }
}
