//! Reading a binary OFF.
//!
//! Geomview writes numbers with their highest byte first, and behind the corners of each face the number of its
//! colour's channels and those; pmp-library writes as its machine does, and no colours. Nothing in the file says
//! which: the layout is the one that the file's size and its vertex numbers fit.

use super::contents::{Contents, FaceColor, VertexExtras};
use super::keyword::Keyword;
use crate::error::ReadError;
use crate::soup::origin::Origin;
use crate::text::scan::Ticker;
use glam::{DVec3, Vec2, Vec3};
use halfedge::{NONE, Progress};

/// How the numbers are arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Layout {
    big_endian: bool,
    /// Whether the number of channels of its colour follows each face's corners.
    face_colors: bool,
    /// How many channels the colour of a vertex has.
    channels: usize,
}

/// Words of four bytes one after the other.
#[derive(Clone)]
struct Words<'a> {
    words: &'a [[u8; 4]],
    at: usize,
    big_endian: bool,
}

impl Words<'_> {
    fn bytes(&mut self) -> Option<[u8; 4]> {
        let mut word = *self.words.get(self.at)?;
        self.at += 1;
        if self.big_endian {
            word.reverse();
        }
        Some(word)
    }

    fn integer(&mut self) -> Option<u32> {
        self.bytes().map(u32::from_le_bytes)
    }

    fn float(&mut self) -> Option<f32> {
        self.bytes().map(f32::from_le_bytes)
    }

    fn vector(&mut self) -> Option<Vec3> {
        Some(Vec3::new(self.float()?, self.float()?, self.float()?))
    }

    fn skip(&mut self, count: usize) -> Option<()> {
        self.at = self.at.checked_add(count).filter(|&at| at <= self.words.len())?;
        Some(())
    }

    fn left(&self) -> usize {
        self.words.len() - self.at
    }
}

/// What was read of a file: how many vertices and faces it says it has, and how many are there.
pub(super) struct Counts {
    pub said: [u64; 2],
    pub there: [u64; 2],
}

/// Reads what follows the first line. `None` where the bytes fit no layout.
pub(super) fn read(
    body: &[u8],
    keyword: Keyword,
    contents: &mut Contents,
    origin: &mut Option<Origin>,
    progress: &mut Progress,
) -> Result<Option<Counts>, ReadError> {
    let Some(layout) = layout(body, keyword) else { return Ok(None) };
    let mut words = Words { words: body.as_chunks().0, at: 0, big_endian: layout.big_endian };
    let mut ticker = Ticker::new(body.len());
    let Some([vertices, faces]) = counts(&mut words, keyword) else { return Ok(None) };
    let mut there = [0, 0];
    while there[0] < vertices.into() && vertex(&mut words, keyword, layout, contents, origin).is_some() {
        there[0] += 1;
        ticker.tick(words.at * 4, progress)?;
    }
    while there[1] < faces.into() && face(&mut words, layout, contents).is_some() {
        there[1] += 1;
        ticker.tick(words.at * 4, progress)?;
    }
    Ok(Some(Counts { said: [vertices.into(), faces.into()], there }))
}

/// The numbers of vertices and faces.
fn counts(words: &mut Words, keyword: Keyword) -> Option<[u32; 2]> {
    if keyword.any_dimension {
        words.integer().filter(|&dimensions| dimensions == 3)?;
    }
    let counts = [words.integer()?, words.integer()?];
    words.integer()?;
    Some(counts)
}

/// The layout that reads most: all of the file, or as many faces as possible.
fn layout(body: &[u8], keyword: Keyword) -> Option<Layout> {
    let channels: &[usize] = if keyword.color { &[4, 3] } else { &[0] };
    let mut best: Option<((bool, u32), Layout)> = None;
    for big_endian in [true, false] {
        for face_colors in [true, false] {
            for &channels in channels {
                let layout = Layout { big_endian, face_colors, channels };
                let Some(fit) = fit(body, keyword, layout) else { continue };
                if best.is_none_or(|(most, _)| fit > most) {
                    best = Some((fit, layout));
                }
            }
        }
    }
    best.map(|(_, layout)| layout)
}

/// Whether a layout ends with the file, and how many faces have corners that there are; none where the
/// vertices alone are more than the file holds.
fn fit(body: &[u8], keyword: Keyword, layout: Layout) -> Option<(bool, u32)> {
    let mut words = Words { words: body.as_chunks().0, at: 0, big_endian: layout.big_endian };
    let [vertices, faces] = counts(&mut words, keyword)?;
    let per_vertex = 3
        + usize::from(keyword.homogeneous)
        + 3 * usize::from(keyword.normal)
        + layout.channels
        + 2 * usize::from(keyword.texture);
    words.skip(per_vertex.checked_mul(usize::try_from(vertices).ok()?)?)?;
    let mut good = 0;
    while good < faces && face_fits(&mut words, layout, vertices).is_some() {
        good += 1;
    }
    Some((good == faces && words.left() == 0 && body.len().is_multiple_of(4), good))
}

fn face_fits(words: &mut Words, layout: Layout, vertices: u32) -> Option<()> {
    let corners = usize::try_from(words.integer()?).ok()?;
    for _ in 0..corners {
        words.integer().filter(|&vertex| vertex < vertices)?;
    }
    if layout.face_colors {
        let channels = words.integer().filter(|&channels| channels <= 4)?;
        words.skip(channels as usize)?;
    }
    Some(())
}

fn vertex(
    words: &mut Words,
    keyword: Keyword,
    layout: Layout,
    contents: &mut Contents,
    origin: &mut Option<Origin>,
) -> Option<()> {
    let number = contents.soup.positions.len();
    let mut position: DVec3 = words.vector()?.as_dvec3();
    if keyword.homogeneous {
        let w = f64::from(words.float()?);
        if w != 1.0 {
            contents.troubles.divided_vertices.add(number);
        }
        position /= if w == 0.0 { 1.0 } else { w };
    }
    let mut extras = VertexExtras::default();
    if keyword.normal {
        extras.normal = Some(words.vector()?);
    }
    if layout.channels > 0 {
        extras.color = Some(words.vector()?);
    }
    if layout.channels > 3 && words.float()? != 1.0 {
        contents.troubles.opacities.add(number);
    }
    if keyword.texture {
        extras.uv = Some(Vec2::new(words.float()?, words.float()?));
    }
    let position = origin.as_mut().map_or(position.as_vec3(), |origin| origin.place(position));
    contents.push_vertex(Some(position), extras);
    Some(())
}

/// Adds a face; none where the file ends before it does.
fn face(words: &mut Words, layout: Layout, contents: &mut Contents) -> Option<()> {
    let number = contents.soup.face_count();
    let corners = words.integer()? as usize;
    if corners > words.left() {
        return None;
    }
    for _ in 0..corners {
        // What is no vertex number is one that no vertex has: the build drops the face.
        contents.soup.corners.push(words.integer().unwrap_or(NONE));
    }
    let mut color = None;
    if layout.face_colors {
        let channels = words.integer()?;
        match channels {
            3 | 4 => color = Some(FaceColor { channels: words.vector()?, has_points: true }),
            1 | 2 => contents.troubles.palette.add(number),
            _ => {}
        }
        if channels == 4 && words.float()? != 1.0 {
            contents.troubles.opacities.add(number);
        }
        if channels < 3 {
            words.skip(channels as usize)?;
        }
    }
    contents.end_face(color);
    Some(())
}
