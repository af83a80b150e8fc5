//! Pictures: image files decoded for showing them.

use crate::model::images::media_type;
use crate::model::srgb::{linear_from_srgb, srgb_from_linear};
use crate::model::texture::Image;
use halfedge::Progress;
use halfedge::words::thousands;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader, Limits};
use std::fmt;
use std::io::Cursor;

/// A file that says it has more pixels is refused: decoded, it might not fit into a browser's memory.
const MAX_PIXELS: u64 = 1 << 27;
/// The most memory that decoding may take: eight bytes for each pixel.
const MAX_DECODING_BYTES: u64 = MAX_PIXELS * 8;
/// How much of the work decoding is, as seen in the progress; the rest are the smaller versions.
const DECODING_SHARE: f32 = 0.7;

/// Why an image was not decoded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PictureError {
    /// The progress callback asked to stop.
    Cancelled,
    /// In words: the bytes are missing or damaged, the picture is too large, or of another kind.
    Unreadable(String),
}

impl fmt::Display for PictureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("Decoding the image was cancelled."),
            Self::Unreadable(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for PictureError {}

impl From<String> for PictureError {
    fn from(why: String) -> Self {
        Self::Unreadable(why)
    }
}

/// The images that a picture is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PictureSource {
    /// What gives the colours; white without it.
    pub color: Option<Image>,
    /// What gives the opacity in place of the colours' alpha: its alpha if it has any, else its brightness.
    pub alpha: Option<Image>,
}

impl PictureSource {
    /// An image by itself.
    pub fn of(image: Image) -> Self {
        Self { color: Some(image), alpha: None }
    }

    /// The images, that of the colours first.
    pub fn images(&self) -> impl Iterator<Item = &Image> {
        self.color.iter().chain(&self.alpha)
    }
}

/// A decoded picture, and smaller versions of it for showing it small.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// 8-bit RGBA in sRGB, rows from the top; then the picture at half the size, rounded down but at least 1, and so on
    /// down to one pixel.
    pub pixels: Vec<u8>,
    /// The size of the picture in the file.
    pub original: [u32; 2],
}

impl Picture {
    /// Decodes image files: PNG, JPEG, WebP, BMP or TGA. A picture that is larger than `largest` on a side is halved
    /// until it isn't. It has the size of the image of its colours.
    ///
    /// # Errors
    /// [`PictureError`].
    ///
    /// # Cost
    /// Time and memory are linear in the pixels of the files, of which there are at most 2²⁷ in each.
    pub fn decode(
        source: &PictureSource,
        largest: u32,
        progress: &mut Progress,
    ) -> Result<Self, PictureError> {
        let mut decoded =
            |image: &Option<Image>| image.as_ref().map(|image| Pixels::decode(image, progress)).transpose();
        let (color, alpha) = (decoded(&source.color)?, decoded(&source.alpha)?);
        let white =
            |size: [u32; 2]| Pixels { size, rgba: vec![u8::MAX; size[0] as usize * size[1] as usize * 4] };
        let color = color.or_else(|| alpha.as_ref().map(|alpha| white(alpha.size)));
        let mut pixels = color.ok_or_else(|| "no image was given".to_owned())?;
        if let Some(alpha) = alpha {
            pixels.take_alpha(&alpha);
        }
        Self::with_levels(pixels.size, pixels.rgba, largest, progress).ok_or(PictureError::Cancelled)
    }

    /// A picture of these pixels: 8-bit RGBA in sRGB, rows from the top. Missing ones are black.
    pub fn new(size: [u32; 2], pixels: Vec<u8>) -> Self {
        let whole = Self::with_levels(size, pixels, u32::MAX, &mut |_| std::ops::ControlFlow::Continue(()));
        whole.unwrap_or(Self { size: [0; 2], pixels: Vec::new(), original: [0; 2] })
    }

    /// Adds the smaller versions, and leaves out those that are too large; none if it was cancelled.
    fn with_levels(
        original: [u32; 2],
        mut level: Vec<u8>,
        largest: u32,
        progress: &mut Progress,
    ) -> Option<Self> {
        let tables = Tables::new();
        let mut size = original.map(|side| side.max(1));
        level.resize(size.iter().map(|side| *side as usize).product::<usize>() * 4, 0);
        let (mut shown, mut pixels) = (size, Vec::new());
        loop {
            if size.iter().all(|side| *side <= largest.max(1)) {
                if pixels.is_empty() {
                    shown = size;
                    pixels.reserve_exact(level.len() / 3 * 4 + 64);
                }
                pixels.extend_from_slice(&level);
            }
            if size == [1, 1] {
                return Some(Self { size: shown, pixels, original });
            }
            let done = 1.0 - size[0].max(size[1]) as f32 / original[0].max(original[1]) as f32;
            if progress(DECODING_SHARE + (1.0 - DECODING_SHARE) * done).is_break() {
                return None;
            }
            let half = size.map(|side| (side / 2).max(1));
            level = tables.shrink(size, &level, half);
            size = half;
        }
    }
}

/// The pixels of an image file: 8-bit RGBA, rows from the top.
struct Pixels {
    size: [u32; 2],
    rgba: Vec<u8>,
}

impl Pixels {
    fn decode(image: &Image, progress: &mut Progress) -> Result<Self, PictureError> {
        let bytes = image.bytes.as_deref().ok_or_else(|| "its file was not given".to_owned())?;
        let format = format_of(image, bytes)?;
        let mut limits = Limits::default();
        limits.max_alloc = Some(MAX_DECODING_BYTES);
        let mut reader = ImageReader::with_format(Cursor::new(bytes), format);
        reader.limits(limits);
        let decoder = reader.into_decoder().map_err(|error| in_words(&error))?;
        let (width, height) = decoder.dimensions();
        let pixels = u64::from(width) * u64::from(height);
        if pixels > MAX_PIXELS || pixels == 0 {
            let why = format!(
                "it says that it is {width} × {height} pixels large; at most {} pixels can be shown",
                thousands(MAX_PIXELS as usize)
            );
            return Err(why.into());
        }
        if progress(0.0).is_break() {
            return Err(PictureError::Cancelled);
        }
        let decoded = DynamicImage::from_decoder(decoder).map_err(|error| in_words(&error))?;
        Ok(Self { size: [width, height], rgba: decoded.into_rgba8().into_raw() })
    }

    /// Takes the opacity from another image, stretched to the size of this one.
    fn take_alpha(&mut self, other: &Self) {
        let [width, height] = self.size.map(|side| side.max(1) as usize);
        let [other_width, other_height] = other.size.map(|side| side as usize);
        let texels = other.rgba.as_chunks::<4>().0;
        let has_alpha = texels.iter().any(|[.., a]| *a < u8::MAX);
        let opacity = |[r, g, b, a]: [u8; 4]| match has_alpha {
            true => a,
            // Rec. 709's weights in 256ths.
            false => ((u32::from(r) * 54 + u32::from(g) * 183 + u32::from(b) * 19) >> 8) as u8,
        };
        for (at, pixel) in self.rgba.as_chunks_mut::<4>().0.iter_mut().enumerate() {
            let (x, y) = (at % width * other_width / width, at / width * other_height / height);
            if let Some(texel) = texels.get(y * other_width + x) {
                pixel[3] = opacity(*texel);
            }
        }
    }
}

/// The kind of an image: by its content, or else by what the model or its name say.
fn format_of(image: &Image, bytes: &[u8]) -> Result<ImageFormat, String> {
    let named = media_type(&image.name, bytes).or_else(|| image.media_type.clone());
    let kind = named.as_deref().and_then(|kind| kind.strip_prefix("image/"));
    match kind {
        Some("png") => Ok(ImageFormat::Png),
        Some("jpeg") => Ok(ImageFormat::Jpeg),
        Some("webp") => Ok(ImageFormat::WebP),
        Some("bmp") => Ok(ImageFormat::Bmp),
        Some("x-tga") => Ok(ImageFormat::Tga),
        Some(other) => Err(format!(
            "it is of the kind {}, and PNG, JPEG, WebP, BMP and TGA can be shown",
            other.trim_start_matches("vnd-ms.").to_uppercase()
        )),
        None => Err("it is no image of a known kind".to_owned()),
    }
}

/// What is wrong with a file, for people who don't know its format.
fn in_words(error: &ImageError) -> String {
    match error {
        ImageError::Limits(_) => "decoding it would take too much memory".to_owned(),
        ImageError::Unsupported(_) => format!("it uses what can't be decoded here: {error}"),
        _ => format!("it is damaged: {error}"),
    }
}

/// Conversions between 8-bit sRGB and 16-bit linear light: averages of light are right, of sRGB too dark.
struct Tables {
    linear: [u32; 256],
    srgb: Vec<u8>,
}

/// Bits of the linear values that the table of sRGB values distinguishes.
const LINEAR_BITS: u32 = 12;

impl Tables {
    fn new() -> Self {
        let linear =
            std::array::from_fn(|srgb| (linear_from_srgb(srgb as f64 / 255.0) * 65535.0).round() as u32);
        let step = f64::from(1 << LINEAR_BITS);
        let srgb = (0..1 << LINEAR_BITS).map(|at| srgb_from_linear((f64::from(at) + 0.5) / step));
        Self { linear, srgb: srgb.map(|srgb| (srgb * 255.0).round() as u8).collect() }
    }

    /// The picture at another size, at most as large: each pixel is the mean of those in its place.
    fn shrink(&self, [width, height]: [u32; 2], pixels: &[u8], [to_width, to_height]: [u32; 2]) -> Vec<u8> {
        let range = |at: u32, to: u32, from: u32| {
            let bound = |at: u32| (u64::from(at) * u64::from(from) / u64::from(to)) as usize;
            bound(at)..bound(at + 1)
        };
        let mut out = Vec::with_capacity(to_width as usize * to_height as usize * 4);
        for y in 0..to_height {
            let rows = range(y, to_height, height);
            for x in 0..to_width {
                let columns = range(x, to_width, width);
                let count = (rows.len() * columns.len()).max(1) as u32;
                let mut sums = [0_u32; 4];
                for row in rows.clone() {
                    let first = row * width as usize;
                    let row = pixels.get((first + columns.start) * 4..(first + columns.end) * 4);
                    for &[r, g, b, a] in row.unwrap_or_default().as_chunks().0 {
                        let light = [r, g, b].map(|c| self.linear.get(usize::from(c)).copied().unwrap_or(0));
                        for (sum, value) in sums.iter_mut().zip(light.into_iter().chain([u32::from(a)])) {
                            *sum += value;
                        }
                    }
                }
                let [r, g, b, a] = sums.map(|sum| sum / count);
                let channel = |light: u32| {
                    self.srgb.get((light >> (16 - LINEAR_BITS)) as usize).copied().unwrap_or(u8::MAX)
                };
                out.extend([channel(r), channel(g), channel(b), a.min(255) as u8]);
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smaller_versions_have_the_mean_light() {
        for value in 0..=255 {
            let picture = Picture::new([5, 3], [value, value, value, 255].repeat(15));
            assert!(picture.pixels.chunks(4).all(|pixel| *pixel == [value, value, value, 255]), "{value}");
            assert_eq!(picture.pixels.len(), (5 * 3 + 2 + 1) * 4);
        }
        let chequered: Vec<u8> = (0..64).flat_map(|i| [((i + i / 8) % 2) as u8 * 255; 4]).collect();
        let picture = Picture::new([8, 8], chequered);
        let [r, .., a] = picture.pixels[64 * 4..64 * 4 + 4] else { panic!("a pixel") };
        assert!(r.abs_diff(188) <= 1 && a == 127, "half the light is 188 in sRGB: {r} {a}");
    }

    #[test]
    fn pictures_larger_than_wanted_are_halved() {
        let whole = Picture::new([40, 10], vec![9; 1600]);
        let go_on = &mut |_: f32| std::ops::ControlFlow::Continue(());
        let small = Picture::with_levels([40, 10], vec![9; 1600], 12, go_on).expect("not cancelled");
        assert_eq!((small.size, small.original), ([10, 2], [40, 10]));
        assert!(whole.pixels.ends_with(&small.pixels) && small.pixels.len() == (20 + 5 + 2 + 1) * 4);
    }
}
