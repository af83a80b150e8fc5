//! Reading an STL.

use crate::import::{ImportedObject, NamedBytes, ReadError, Reading, build};
use crate::origin::Origin;
use crate::report::{ImportReport, Places, counted};
use crate::scan::{Scan, Ticker};
use crate::weld::Weld;
use glam::Vec3;
use halfedge::{PolygonSoup, Progress};

const HEAD: usize = 84;
const FACET: usize = 50;

/// Whether the bytes are a binary STL: 80 bytes of anything, a count, and so many triangles.
pub(crate) fn is_binary(bytes: &[u8]) -> bool {
    facets(bytes).is_some_and(|count| (bytes.len() - HEAD) as u64 == count * FACET as u64)
}

/// Whether the bytes are a text STL. Some programs write its words in capitals.
pub(crate) fn is_text(bytes: &[u8]) -> bool {
    let head = bytes.get(..1024).unwrap_or(bytes);
    let mut scan = Scan::new(head, None);
    let is = |word: Option<&[u8]>, what: &[u8]| word.is_some_and(|word| word.eq_ignore_ascii_case(what));
    is(scan.word(), b"solid") && {
        scan.skip_line();
        let next = scan.word();
        next.is_none() || is(next, b"facet") || is(next, b"endsolid")
    }
}

fn facets(bytes: &[u8]) -> Option<u64> {
    bytes.get(80..)?.first_chunk::<4>().map(|count| u64::from(u32::from_le_bytes(*count)))
}

/// Reads one STL as one object.
pub(crate) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(ImportedObject, ImportReport), ReadError> {
    let mut report = ImportReport::default();
    let mut triangles = Triangles { weld: Weld::new(), soup: PolygonSoup::default() };
    if is_text(&file.bytes) && !is_binary(&file.bytes) {
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
    let Some(count) = facets(&file.bytes) else {
        return Err(ReadError::file(&file.name, "this is not an STL: it is shorter than the head of one"));
    };
    let body = file.bytes.get(HEAD..).unwrap_or_default();
    let there = (body.len() / FACET) as u64;
    if there == 0 && count > 0 {
        return Err(ReadError::file(
            &file.name,
            format!("this is not an STL: none of its {count} triangles is there"),
        ));
    }
    if there < count {
        report.warn(format!("The file ends early: {there} of {count} triangles are there"));
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
