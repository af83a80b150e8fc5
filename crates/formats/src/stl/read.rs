//! Reading an STL.

use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Reading, build};
use crate::model::NamedMesh;
use crate::report::{ImportReport, Places, counted};
use crate::soup::origin::Origin;
use crate::soup::weld::Weld;
use crate::text::scan::{Scan, Ticker, is_text};
use glam::Vec3;
use halfedge::{PolygonSoup, Progress};

const HEAD: usize = 84;
const FACET: usize = 50;

/// Whether the bytes are a binary STL: 80 bytes of anything, a count, and so many triangles, or some of
/// them and what can't be anything else, where the file was cut short or has more bytes behind.
pub(crate) fn is_binary(bytes: &[u8]) -> bool {
    said(bytes).is_some_and(|count| is_whole(bytes, count) || has_triangles(bytes, facets(bytes, count)))
}

fn is_whole(bytes: &[u8], count: u64) -> bool {
    bytes.len() as u64 == HEAD as u64 + count * FACET as u64
}

/// Whether most of what should be triangles is: looked at in up to a thousand of them.
fn has_triangles(bytes: &[u8], count: u64) -> bool {
    let (there, _) = bytes.get(HEAD..).unwrap_or_default().as_chunks::<FACET>();
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
fn is_triangle(facet: &[u8; FACET]) -> bool {
    let (words, _) = facet.as_chunks::<4>();
    let mut numbers = words.iter().map(|word| f32::from_le_bytes(*word));
    let mut point = || Vec3::from_array([(); 3].map(|()| numbers.next().unwrap_or(f32::NAN)));
    let [normal, a, b, c] = [(); 4].map(|()| point());
    let is_measure = |c: f32| c == 0.0 || (1e-30..1e30).contains(&c.abs());
    (normal == Vec3::ZERO || (normal.length() - 1.0).abs() < 0.1)
        && [a, b, c].iter().all(|corner| corner.to_array().into_iter().all(is_measure))
        && (a != b || b != c)
}

/// Whether the bytes are a text STL. Some programs write its words in capitals.
pub(crate) fn is_text_stl(bytes: &[u8]) -> bool {
    let head = bytes.get(..4096).unwrap_or(bytes);
    let mut scan = Scan::new(head, None);
    let is = |word: &[u8], what: &[u8]| word.eq_ignore_ascii_case(what);
    if !is_text(head) || !scan.word().is_some_and(|word| is(word, b"solid")) {
        return false;
    }
    scan.skip_line();
    let mut rest = std::iter::from_fn(|| scan.word()).peekable();
    rest.peek().is_none() || rest.any(|word| is(word, b"facet") || is(word, b"endsolid"))
}

/// How many triangles the head says there are.
fn said(bytes: &[u8]) -> Option<u64> {
    bytes.get(80..)?.first_chunk::<4>().map(|count| u64::from(u32::from_le_bytes(*count)))
}

/// How many there are to be: what the head says, or all, where the program that wrote it left the place for
/// the count as it was because it could not go back.
fn facets(bytes: &[u8], said: u64) -> u64 {
    let body = bytes.len().saturating_sub(HEAD);
    let is_left = said == 0 || said == u64::from(u32::MAX);
    if is_left && body > 0 && body.is_multiple_of(FACET) { (body / FACET) as u64 } else { said }
}

/// Reads one STL as one object.
pub(crate) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let mut report = ImportReport::default();
    let mut triangles = Triangles { weld: Weld::new(), soup: PolygonSoup::default() };
    if is_text_stl(&file.bytes) {
        text(file, &mut triangles, &mut reading.origin, &mut report, progress)?;
    } else {
        binary(file, &mut triangles, &mut reading.origin, &mut report, progress)?;
    }
    let corners = triangles.soup.corners.len();
    triangles.soup.positions = triangles.weld.positions;
    if corners > 0 {
        report.info(format!(
            "{} at the same positions merged into {}",
            counted(corners, "corner", "corners"),
            counted(triangles.soup.positions.len(), "vertex", "vertices")
        ));
    }
    let part = &mut |part| progress(0.5 + part * 0.5);
    let object = build(file.stem(), triangles.soup, &file.name, reading, &mut report, part)?;
    Ok((object, report))
}

struct Triangles {
    weld: Weld,
    soup: PolygonSoup,
}

impl Triangles {
    fn push(&mut self, corners: [Vec3; 3]) {
        let corners = corners.map(|corner| self.weld.vertex(corner));
        self.soup.push_face(corners);
    }
}

fn binary(
    file: &NamedBytes,
    triangles: &mut Triangles,
    origin: &mut Option<Origin>,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<(), ReadError> {
    let Some(said) = said(&file.bytes) else {
        return Err(ReadError::not_a(file, "an STL", "it is shorter than the head of one"));
    };
    let count = facets(&file.bytes, said);
    let body = file.bytes.get(HEAD..).unwrap_or_default();
    let there = (body.len() / FACET) as u64;
    if there == 0 && count > 0 {
        return Err(ReadError::not_a(file, "an STL", &format!("none of its {count} triangles is there")));
    }
    if !is_binary(&file.bytes) {
        let why = "it has neither the words of one, \"solid\" and \"facet\", nor the numbers of triangles";
        return Err(ReadError::not_a(file, "an STL", why));
    }
    if count != said {
        report.warn(format!(
            "The file does not say how many triangles it has; all {count} there are were read"
        ));
    }
    if there < count {
        report.warn(format!("The file ends early: {there} of {count} triangles are there"));
    }
    let more = (body.len() as u64).saturating_sub(count * FACET as u64);
    if more > 0 {
        let bytes = counted(more as usize, "byte", "bytes");
        report.warn(format!("{bytes} after the last of its {count} triangles left out"));
    }
    let mut ticker = Ticker::new(file.bytes.len());
    let (facets, _) = body.as_chunks::<FACET>();
    for (i, facet) in facets.iter().take(usize::try_from(count).unwrap_or(usize::MAX)).enumerate() {
        let (words, _) = facet.as_chunks::<4>();
        // A normal, three corners, and two bytes that mean nothing certain.
        let mut numbers = words.iter().skip(3).map(|word| f32::from_le_bytes(*word));
        let mut corner = || {
            let position = Vec3::from_array([(); 3].map(|()| numbers.next().unwrap_or(0.0)));
            origin.as_mut().map_or(position, |origin| origin.place(position.as_dvec3()))
        };
        triangles.push([corner(), corner(), corner()]);
        ticker.tick(HEAD + i * FACET, progress)?;
    }
    Ok(())
}

fn text(
    file: &NamedBytes,
    triangles: &mut Triangles,
    origin: &mut Option<Origin>,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<(), ReadError> {
    let mut scan = Scan::new(&file.bytes, None);
    let mut ticker = Ticker::new(file.bytes.len());
    let mut corners: Vec<Vec3> = Vec::with_capacity(3);
    let mut facet = 0;
    let mut bad = Places::default();
    let mut readable = true;
    while let Some(word) = scan.word() {
        let is = |what: &[u8]| word.eq_ignore_ascii_case(what);
        if is(b"vertex") {
            match scan.position(origin) {
                Some(position) => corners.push(position),
                None => readable = false,
            }
        } else if is(b"endfacet") {
            facet += 1;
            match corners.as_slice() {
                &[a, b, c] if readable => triangles.push([a, b, c]),
                _ => bad.add(facet),
            }
            corners.clear();
            readable = true;
            ticker.tick(scan.at, progress)?;
        } else if is(b"solid") || is(b"endsolid") {
            scan.skip_line();
        }
        // The words between mean nothing more, nor does the normal, which follows from the corners.
    }
    if !bad.is_empty() {
        report.warn(bad.sentence(
            "triangle",
            "triangles",
            "left out: not three corners of three numbers",
            "number",
        ));
    }
    if !corners.is_empty() || !readable {
        report.warn("The file ends in the middle of a triangle, which was left out");
    }
    Ok(())
}
