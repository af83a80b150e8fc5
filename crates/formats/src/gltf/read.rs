//! Reading a document.

use super::buffers::Buffers;
use super::container::Container;
use super::left_out;
use super::material::Library;
use super::mesh::MeshReader;
use super::scene::{self, Instance, Scene};
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Contents, Reading, Source, build};
use crate::model::NamedMesh;
use crate::notes::{Fault, Notes};
use crate::report::ImportReport;
use halfedge::Progress;

/// Total number of corners and vertices that instances in any file may have.
const MIN_ELEMENT_BUDGET: usize = 4_000_000;

/// Total number of corners and vertices that instances may have for each byte of the buffers.
const ELEMENTS_PER_BYTE: usize = 8;

/// Reads a document: an object for each node that shows a mesh, or for each mesh if no node shows one.
///
/// # Errors
/// When the file has nothing that can be shown; the message names the first fault.
pub(super) fn read(
    source: &Source,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let file = source.file;
    let fail = |message: String| ReadError::file(&file.name, message);
    let container = Container::open(&file.bytes).map_err(fail)?;
    let document = &container.document;
    let mut notes = Notes::default();
    container.faults.iter().for_each(|fault| notes.fault(Fault::Scene, fault.as_str()));
    let buffers = Buffers::open(&container, source.files);
    let scene = Scene::read(document, &mut notes);
    let budget = buffers.size().saturating_mul(ELEMENTS_PER_BYTE).max(MIN_ELEMENT_BUDGET);
    let library = Library::new(document, &buffers, source.files);
    let mut reader = MeshReader { document, buffers: &buffers, scene: &scene, library, notes, budget };
    let mut report = ImportReport::default();
    let instances = &scene.instances;
    let mut objects = objects(&mut reader, instances, file, reading, &mut report, progress)?;
    if objects.is_empty() && instances.iter().any(|instance| instance.node.is_some()) {
        let meshes = scene::meshes(document);
        objects = self::objects(&mut reader, &meshes, file, reading, &mut report, progress)?;
    }
    let MeshReader { library, mut notes, .. } = reader;
    if objects.is_empty() {
        return Err(match (buffers.missing(), notes.first_fault()) {
            ([], Some(fault)) => ReadError::nothing(file, fault),
            ([], None) => fail("it holds no mesh".to_owned()),
            (missing, _) => fail(format!(
                "open it together with {}, which holds its data and was not given",
                missing.join(" and ")
            )),
        });
    }
    let materials = library.finish(&mut notes);
    left_out::note(document, &mut notes);
    notes.report(&mut report);
    Ok(Contents { objects, materials, report })
}

/// Reads the instances that can be read.
fn objects<'a>(
    reader: &mut MeshReader<'_, 'a>,
    instances: &[Instance<'a>],
    file: &NamedBytes,
    reading: &mut Reading,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<Vec<NamedMesh>, ReadError> {
    let mut objects = Vec::new();
    let total = instances.len();
    for (i, instance) in instances.iter().enumerate() {
        let part = |fraction: f32| (i as f32 + fraction) / total as f32;
        if progress(part(0.0)).is_break() {
            return Err(ReadError::Cancelled);
        }
        let Some(soup) = reader.soup(instance, &mut reading.origin) else { continue };
        let mut own = ImportReport::default();
        let mut progress = |fraction: f32| progress(part(0.5 + 0.5 * fraction));
        let object = build(&instance.name, soup, &file.name, reading, &mut own, &mut progress)?;
        report.append(if total > 1 { own.prefixed(&instance.name) } else { own });
        objects.push(object);
    }
    Ok(objects)
}
