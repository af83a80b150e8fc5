//! Conversion of colour channels between sRGB and linear light (IEC 61966-2-1).
//!
//! The editor's colours are sRGB; glTF's are linear. Conversions are computed in double precision: 0, 1
//! and every k / 255 come back to the bit.

/// The end of the linear segment of the sRGB curve, in sRGB.
const SRGB_LINEAR_END: f64 = 0.040_45;

/// An sRGB channel in linear light.
pub(crate) fn linear_from_srgb(srgb: f64) -> f64 {
    if srgb <= SRGB_LINEAR_END { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) }
}

/// A linear channel in sRGB: the inverse of [`linear_from_srgb`].
pub(crate) fn srgb_from_linear(linear: f64) -> f64 {
    let end = SRGB_LINEAR_END / 12.92;
    if linear <= end { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// [`linear_from_srgb`] in single precision.
pub(crate) fn to_linear(srgb: f32) -> f32 {
    linear_from_srgb(f64::from(srgb)) as f32
}

/// [`srgb_from_linear`] in single precision. Several sRGB values may share one linear value: of those
/// this prefers k / 255.
pub(crate) fn to_srgb(linear: f32) -> f32 {
    let srgb = srgb_from_linear(f64::from(linear));
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
