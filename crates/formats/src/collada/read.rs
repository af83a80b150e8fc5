//! Reading a COLLADA document: the scene's instances, each as an object.

use super::controller::{Morph, Shape};
use super::geometry::{self, Shown};
use super::material::Library;
use super::scene::{self, Instance, Scene, has_faces};
use super::skin::{self, Joints};
use super::xml::Document;
use super::{image, left_out, transform};
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Contents, Reading, Source, build};
use crate::model::NamedMesh;
use crate::notes::{Fault, Notes};
use crate::report::ImportReport;
use crate::soup::origin::Origin;
use crate::soup::placement::Placement;
use crate::text::encoding::{Encoding, decode};
use halfedge::words::counted;
use halfedge::{PolygonSoup, Progress};
use std::collections::HashSet;

/// The size of the head of a file that tells whether it is a COLLADA document.
const HEAD_BYTES: usize = 4096;

/// How many elements instances may have in all, however small the file.
const MIN_ELEMENT_BUDGET: usize = 4_000_000;

/// How many elements instances may have in all for each byte of the file.
const ELEMENTS_PER_BYTE: usize = 8;

/// What an object costs besides its elements, counted in elements.
const ELEMENTS_PER_OBJECT: usize = 200;

/// The names of the files that a document refers to: the images of its textures.
pub(crate) fn companions(file: &NamedBytes) -> Vec<String> {
    let (text, _) = decode(&file.bytes);
    Document::read(&text, &file.name).map_or(Vec::new(), |document| image::names(&document))
}

/// Whether the file starts like a COLLADA document.
pub(crate) fn looks_like(bytes: &[u8]) -> bool {
    let (head, _) = decode(bytes.get(..HEAD_BYTES).unwrap_or(bytes));
    head.trim_start().starts_with('<') && head.contains("<COLLADA")
}

/// Reads one document: an object for each instance, or for each geometry where no node shows one.
///
/// # Errors
/// When nothing in the document can be shown; the message names the first thing that is in the way.
pub(crate) fn read(
    source: &Source,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let file = source.file;
    let fail = |message: String| ReadError::file(&file.name, message);
    let (text, encoding) = decode(&file.bytes);
    let document = Document::read(&text, &file.name).map_err(|why| match looks_like(&file.bytes) {
        true => fail(why),
        false => ReadError::not_a(file, "a COLLADA", &why),
    })?;
    if progress(0.3).is_break() {
        return Err(ReadError::Cancelled);
    }
    let mut notes = Notes::default();
    note_encoding(&text, encoding, &mut notes);
    for fault in &document.faults {
        notes.fault(Fault::Scene, fault);
    }
    let axes = transform::of_document(&document, &mut notes);
    let scene = Scene::read(&document, axes, &mut notes);
    let joints = Joints::of(&scene);
    let mut reader = Reader {
        document: &document,
        joints: &joints,
        library: Library::new(&document, source.files),
        used: HashSet::new(),
        elements: 0,
        max_elements: file.bytes.len().saturating_mul(ELEMENTS_PER_BYTE).max(MIN_ELEMENT_BUDGET),
        notes,
    };
    let mut report = ImportReport::default();
    let mut objects = reader.objects(&scene.instances, file, reading, &mut report, progress)?;
    let geometries;
    if objects.is_empty() && scene.instances.iter().any(|instance| instance.binding.is_some()) {
        geometries = scene::geometries(&document, axes);
        objects = reader.objects(&geometries, file, reading, &mut report, progress)?;
    }
    if objects.is_empty() {
        return Err(nothing(file, &document, &reader.notes));
    }
    reader.note_unused();
    left_out::note(&document, &mut reader.notes);
    let Reader { library, mut notes, .. } = reader;
    let materials = library.finish(&mut notes);
    notes.report(&mut report);
    Ok(Contents { objects, materials, report })
}

/// Why a document gives no object.
fn nothing(file: &NamedBytes, document: &Document, notes: &Notes) -> ReadError {
    let version = document.root().attribute("version").unwrap_or_default();
    if ["1.0", "1.1", "1.2", "1.3"].iter().any(|old| version.starts_with(old)) {
        let message =
            format!("it is COLLADA {version}. Versions 1.4 and 1.5 can be read: export it as one of those");
        return ReadError::file(&file.name, message);
    }
    match notes.first_fault() {
        Some(fault) => ReadError::nothing(file, fault),
        None => ReadError::file(&file.name, "it holds no mesh"),
    }
}

/// Notes an encoding that some letters may be wrong in.
fn note_encoding(text: &str, encoding: Encoding, notes: &mut Notes) {
    if encoding != Encoding::Latin1 {
        return;
    }
    let declaration = text.trim_start().strip_prefix("<?xml").and_then(|rest| rest.split_once("?>"));
    let declared = declaration.and_then(|(inside, _)| {
        let (_, value) = inside.split_once("encoding")?;
        value.split(['"', '\'']).nth(1)
    });
    let is_own = |name: &str| {
        let name = name.to_ascii_lowercase();
        ["iso-8859-1", "iso8859-1", "latin1", "latin-1", "windows-1252", "cp1252", "us-ascii"]
            .contains(&name.as_str())
    };
    match declared {
        Some(name) if is_own(name) => {}
        Some(name) => notes.info(format!(
            "Its text is not {name} as it says, or that encoding can't be read: it was read as Latin-1, so letters of names may be wrong"
        )),
        None => notes.info("Its text is not UTF-8: it was read as Latin-1, so letters of names may be wrong"),
    }
}

/// Reads instances one after the other.
struct Reader<'r, 'd, 'a> {
    document: &'d Document<'a>,
    joints: &'r Joints<'r, 'd, 'a>,
    library: Library<'d, 'a>,
    /// The geometries that were shown or blended to.
    used: HashSet<u32>,
    /// How many corners and vertices instances have so far, and may have: they may repeat a geometry, and
    /// a small file must not fill the memory that way.
    elements: usize,
    max_elements: usize,
    notes: Notes,
}

impl<'r, 'd, 'a> Reader<'r, 'd, 'a> {
    /// The objects of instances, as many as there is room for.
    fn objects(
        &mut self,
        instances: &[Instance<'d, 'a>],
        file: &NamedBytes,
        reading: &mut Reading,
        report: &mut ImportReport,
        progress: &mut Progress,
    ) -> Result<Vec<NamedMesh>, ReadError> {
        let mut objects = Vec::new();
        let total = instances.len();
        for (i, instance) in instances.iter().enumerate() {
            let Some(soup) = self.soup(instance, &mut reading.origin) else { continue };
            self.elements += soup.corners.len() + soup.positions.len() + ELEMENTS_PER_OBJECT;
            if self.elements > self.max_elements {
                let rest = counted(total - i, "mesh", "meshes");
                self.notes
                    .fault(Fault::Scene, format!("{rest}: the scene repeats its geometries too many times"));
                break;
            }
            let part = |fraction: f32| 0.3 + 0.7 * (i as f32 + fraction) / total as f32;
            let mut own = ImportReport::default();
            let mut progress = |fraction| progress(part(fraction));
            let object = build(&instance.name, soup, &file.name, reading, &mut own, &mut progress)?;
            report.append(if total > 1 { own.prefixed(&instance.name) } else { own });
            objects.push(object);
        }
        Ok(objects)
    }

    /// The soup of an instance. None where it can't be read, which is noted.
    fn soup(&mut self, instance: &Instance<'d, 'a>, origin: &mut Option<Origin>) -> Option<PolygonSoup> {
        let Self { document, joints, library, used, notes, .. } = self;
        let shape = match Shape::find(document, instance.content, notes) {
            Ok(shape) => shape,
            Err(why) => {
                notes.fault(Fault::Scene, format!("what node \"{}\" shows: {why}", instance.name));
                return None;
            }
        };
        let geometry = shape.geometry;
        used.insert(geometry.index);
        let placement = match shape.skin {
            Some(skin) => skin::place(document, skin, instance, joints, notes),
            None => Placement::Rigid(instance.transform),
        };
        let morph = shape.morph.and_then(|morph| Morph::read(document, morph, geometry, used, notes));
        let shown = Shown { geometry, instance, placement, morph };
        match geometry::read(document, &shown, origin, library, notes) {
            Ok(soup) => Some(soup),
            Err(why) => {
                notes.fault(Fault::Scene, format!("geometry \"{}\": {why}", geometry.label()));
                None
            }
        }
    }

    /// Notes geometries that nothing shows.
    fn note_unused(&mut self) {
        for geometry in self.document.all("geometry") {
            if !self.used.contains(&geometry.index) && has_faces(self.document, geometry) {
                self.notes
                    .fault(Fault::Scene, format!("geometry \"{}\", which no node shows", geometry.label()));
            }
        }
    }
}
