//! Reading a binary STL.

use super::color::{self, Attributes};
use super::triangles::Triangles;
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::report::ImportReport;
use crate::soup::origin::Origin;
use crate::text::scan::{Ticker, is_text};
use glam::Vec3;
use halfedge::Progress;
use halfedge::words::{counted, thousands};

/// The size of the text at the start.
pub(super) const HEADER_BYTES: usize = 80;

/// The size of what comes before the triangles: the text and the number of triangles.
const HEAD_BYTES: usize = HEADER_BYTES + 4;

/// The size of a triangle: a normal, three corners and two bytes for the writer's use.
const FACET_BYTES: usize = 50;

/// The text in the headers of our own files.
pub(super) const TITLE: &str = "Written by Meshwright";

/// Whether the bytes are a binary STL: 80 bytes of anything, a count, and so many triangles, or some of
/// them and what can't be anything else, where the file was cut short or has more bytes behind.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    said(bytes).is_some_and(|count| is_whole(bytes, count) || has_triangles(bytes, facets(bytes, count)))
}

/// The corners of a file of so many bytes, if its beginning is that of a whole one.
pub(super) fn corners(head: &[u8], bytes: u64) -> Option<u64> {
    said(head).filter(|count| bytes == HEAD_BYTES as u64 + count * FACET_BYTES as u64).map(|count| 3 * count)
}

fn is_whole(bytes: &[u8], count: u64) -> bool {
    bytes.len() as u64 == HEAD_BYTES as u64 + count * FACET_BYTES as u64
}

/// Whether most of what should be triangles is: looked at in up to a thousand of them.
fn has_triangles(bytes: &[u8], count: u64) -> bool {
    let (there, _) = bytes.get(HEAD_BYTES..).unwrap_or_default().as_chunks::<FACET_BYTES>();
    let counted = there.len().min(usize::try_from(count).unwrap_or(usize::MAX));
    // A count is less than 2^24 where a file isn't enormous, so that one of its bytes is zero.
    if counted == 0 || count / 1000 > there.len() as u64 || is_text(bytes) {
        return false;
    }
    let step = counted.div_ceil(1000);
    let looked_at = there.iter().take(counted).step_by(step);
    let total = looked_at.len();
    looked_at.filter(|facet| is_triangle(facet)).count() * 4 >= total * 3
}

/// Whether the numbers are those of a triangle: a normal of length 1 or none, corners that differ, none
/// of them beyond what anybody measures.
fn is_triangle(facet: &[u8; FACET_BYTES]) -> bool {
    let (words, _) = facet.as_chunks::<4>();
    let mut numbers = words.iter().map(|word| f32::from_le_bytes(*word));
    let mut point = || Vec3::from_array([(); 3].map(|()| numbers.next().unwrap_or(f32::NAN)));
    let [normal, a, b, c] = [(); 4].map(|()| point());
    let is_measure = |c: f32| c == 0.0 || (1e-30..1e30).contains(&c.abs());
    (normal == Vec3::ZERO || (normal.length() - 1.0).abs() < 0.1)
        && [a, b, c].iter().all(|corner| corner.to_array().into_iter().all(is_measure))
        && (a != b || b != c)
}

/// The number of triangles that the head states.
fn said(bytes: &[u8]) -> Option<u64> {
    bytes.get(HEADER_BYTES..)?.first_chunk::<4>().map(|count| u64::from(u32::from_le_bytes(*count)))
}

/// The number of triangles to read: what the head states, or all, where the program that wrote the file could
/// not go back to put the count in.
fn facets(bytes: &[u8], said: u64) -> u64 {
    let body = bytes.len().saturating_sub(HEAD_BYTES);
    let is_left = said == 0 || said == u64::from(u32::MAX);
    if is_left && body > 0 && body.is_multiple_of(FACET_BYTES) { (body / FACET_BYTES) as u64 } else { said }
}

/// Reads the triangles of a file.
///
/// # Errors
/// Where it is no STL.
pub(super) fn read(
    file: &NamedBytes,
    origin: &mut Option<Origin>,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<Triangles, ReadError> {
    let Some(said) = said(&file.bytes) else {
        return Err(ReadError::not_a(file, "an STL", "it is shorter than the head of one"));
    };
    let count = facets(&file.bytes, said);
    let body = file.bytes.get(HEAD_BYTES..).unwrap_or_default();
    let there = (body.len() / FACET_BYTES) as u64;
    if there == 0 && count > 0 {
        return Err(ReadError::not_a(
            file,
            "an STL",
            &format!("none of its {} triangles is there", thousands(count)),
        ));
    }
    if !is_binary(&file.bytes) {
        let why = "it has neither the words of one, \"solid\" and \"facet\", nor the numbers of triangles";
        return Err(ReadError::not_a(file, "an STL", why));
    }
    if count != said {
        report.warn(format!(
            "The file does not say how many triangles it has; all {} there are were read",
            thousands(count)
        ));
    }
    if there < count {
        report.warn(format!(
            "The file ends early: {} of {} triangles are there",
            thousands(there),
            thousands(count)
        ));
    }
    let more = (body.len() as u64).saturating_sub(count * FACET_BYTES as u64);
    if more > 0 {
        let bytes = counted(more as usize, "byte", "bytes");
        report.warn(format!("{bytes} after the last of its {} triangles left out", thousands(count)));
    }
    let mut triangles = Triangles::new();
    let mut ticker = Ticker::new(file.bytes.len());
    let (facets, _) = body.as_chunks::<FACET_BYTES>();
    let facets = facets.get(..usize::try_from(count).unwrap_or(usize::MAX)).unwrap_or(facets);
    for (i, facet) in facets.iter().enumerate() {
        let (words, _) = facet.as_chunks::<4>();
        // The normal, which is left out, follows from the corners.
        let mut numbers = words.iter().skip(3).map(|word| f32::from_le_bytes(*word));
        let mut corner = || {
            let position = Vec3::from_array([(); 3].map(|()| numbers.next().unwrap_or(0.0)));
            origin.as_mut().map_or(position, |origin| origin.place(position.as_dvec3()))
        };
        triangles.push(&[corner(), corner(), corner()]);
        ticker.tick(HEAD_BYTES + i * FACET_BYTES, progress)?;
    }
    attributes(&file.bytes, facets, &mut triangles, report);
    Ok(triangles)
}

/// Colours the triangles, and notes what else the header and the bytes behind triangles say.
fn attributes(
    bytes: &[u8],
    facets: &[[u8; FACET_BYTES]],
    triangles: &mut Triangles,
    report: &mut ImportReport,
) {
    let header = bytes.get(..HEADER_BYTES).unwrap_or_default();
    let last =
        |facet: &[u8; FACET_BYTES]| facet.last_chunk().map_or(0, |attribute| u16::from_le_bytes(*attribute));
    match color::read(header, &facets.iter().map(last).collect::<Vec<u16>>()) {
        Attributes::None => {}
        Attributes::Colors(colors, has_opacity) => {
            triangles.colors = colors;
            if has_opacity {
                report.info("The opacity in its header is left out: colours are opaque here");
            }
        }
        Attributes::Unknown(count) => report.info(format!(
            "The attribute bytes of {} are left out: they are no colours in a known convention",
            counted(count, "triangle", "triangles")
        )),
    }
    if header.windows(9).any(|part| part == b"MATERIAL=") {
        report.info("The material in its header (MATERIAL=) is left out");
    }
    let text = color::text(header);
    if !text.is_empty() && text != TITLE {
        report.info(format!("The text in its header is left out: {text}"));
    }
}
