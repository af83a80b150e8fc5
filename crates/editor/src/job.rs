//! Jobs: work that takes long, as plain data that can be sent to a worker and back.

pub(crate) mod columns;
mod derive;
pub(crate) mod messages;
pub(crate) mod packed;
pub(crate) mod wire;

pub use wire::{BadBytes, Part, Reading, Wire};

use crate::Task;
use crate::bezier::fill_previews;
use crate::error::{CommandError, Problem, not_opened};
use crate::ops::{Action, Op, Symmetry, edit_local};
use crate::outcome::{Before, ElementIds};
use crate::project::{Link, Project, ReadProject};
use formats::{
    Format, Import, Materials, Model, NamedBytes, NamedMesh, Picture, PictureError, PictureSource, ReadError,
    Repairs,
};
use glam::DVec3;
use halfedge::{FaceId, Journal, Mesh, Progress};
use surface::MirrorImages;

/// The number of a job of an editor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct JobId(pub u64);

/// The work of a job and everything it needs: it can run on any thread, or be sent to a worker.
#[derive(Clone, Debug)]
pub struct JobRequest {
    pub(crate) id: JobId,
    pub(crate) work: Work,
}

#[derive(Clone, Debug)]
pub(crate) enum Work {
    /// Reads files, and repairs faces that are not a mesh as they stand.
    Import(Vec<NamedBytes>, Repairs),
    /// Runs operations on meshes; several, and with symmetry, only where they are local edits.
    Run(Vec<Op>, Symmetry, Vec<NamedMesh>),
    /// Writes a document as files.
    Export(ExportHead, Vec<NamedMesh>),
    /// Writes a project file.
    Save(Box<Project>),
    /// Makes a link to a document.
    Share(Box<Project>),
    /// Decodes images, with at most this many pixels on a side.
    Decode(PictureSource, u32),
}

/// The parts of a document that are written besides its objects.
#[derive(Clone, Debug)]
pub(crate) struct ExportHead {
    pub format: Format,
    /// The document's name, which the files are named after.
    pub name: String,
    pub offset: DVec3,
    pub materials: Materials,
}

/// The result of a job.
#[derive(Debug)]
pub struct JobResult {
    pub(crate) made: Made,
    /// Whether every mesh was found valid: see [`JobResult::validate`].
    pub(crate) validated: bool,
}

#[derive(Debug)]
pub(crate) enum Made {
    Import(Import),
    Project(Box<ReadProject>),
    /// The meshes; for local edits the elements they created and removed; warnings.
    Meshes(Vec<NamedMesh>, Option<(ElementIds, ElementIds)>, Vec<String>),
    Files(Vec<NamedBytes>),
    Link(Link),
    Picture(Picture),
}

impl Made {
    /// Validates every mesh.
    ///
    /// # Errors
    /// What is wrong with the first invalid one.
    pub fn validate(&self) -> Result<(), String> {
        let check = |name: &str, mesh: &Mesh| {
            mesh.validate().map_err(|defect| match name {
                "" => defect.to_string(),
                name => format!("{name}: {defect}"),
            })
        };
        match self {
            Self::Import(import) => import.model.objects.iter().try_for_each(|o| check(&o.name, &o.mesh)),
            Self::Meshes(outputs, ..) => outputs.iter().try_for_each(|o| check(&o.name, &o.mesh)),
            Self::Project(read) => read.project.objects().try_for_each(|o| check(o.name(), o.mesh())),
            Self::Files(_) | Self::Link(_) | Self::Picture(_) => Ok(()),
        }
    }
}

impl JobRequest {
    /// The job of reading files without an editor; [`JobResult::into_import`] gives what was read.
    pub fn import(files: Vec<NamedBytes>) -> Self {
        Self { id: JobId(0), work: Work::Import(files, Repairs::default()) }
    }

    /// The job of reading the files of an import that [`crate::Editor::expect_import`] announced.
    pub fn import_expected(id: JobId, files: Vec<NamedBytes>) -> Self {
        Self { id, work: Work::Import(files, Repairs::default()) }
    }

    /// Which job this is.
    pub fn id(&self) -> JobId {
        self.id
    }

    /// What it does; none for a job without operations, which does nothing.
    pub fn task(&self) -> Option<Task> {
        match &self.work {
            Work::Import(..) => Some(Task::Open),
            Work::Run(ops, ..) => ops.first().map(|op| Task::Op(op.id())),
            Work::Export(..) | Work::Save(_) => Some(Task::Export),
            Work::Share(_) => Some(Task::Share),
            Work::Decode(..) => Some(Task::Decode),
        }
    }

    /// Does the work and reports to `progress`, which may stop it.
    ///
    /// # Errors
    /// Why the command is refused, or that it was cancelled.
    pub fn run(&self, progress: &mut Progress<'_>) -> Result<JobResult, CommandError> {
        let name = self.task().map_or("job", Task::name);
        self.work.run(progress).map_err(|problem| CommandError::of(name, problem))
    }
}

impl JobResult {
    /// Validates the meshes where the job ran, which takes longer than a frame of the page, so that
    /// [`crate::Editor::finish`] need not. A result with an invalid mesh stays unvalidated, and
    /// `finish` refuses it, saying why.
    pub fn validate(&mut self) {
        self.validated = self.validated || self.made.validate().is_ok();
    }

    /// What was read, if this is the result of an import.
    pub fn into_import(self) -> Option<Import> {
        match self.made {
            Made::Import(import) => Some(import),
            _ => None,
        }
    }
}

impl Work {
    fn run(&self, progress: &mut Progress<'_>) -> Result<JobResult, Problem> {
        let made = match self {
            Self::Import(files, repairs) => {
                if let Some(read) = read_project(files)? {
                    return Ok(JobResult { made: Made::Project(Box::new(read)), validated: false });
                }
                let mut import =
                    formats::read_with(files, repairs, progress).map_err(|error| match error {
                        ReadError::Cancelled => Problem::cancelled(),
                        other => Problem::new(other.to_string()),
                    })?;
                fill_previews(&mut import)?;
                // A file with nothing usable in it must not replace the open document.
                if import
                    .model
                    .objects
                    .iter()
                    .all(|object| object.mesh.vertex_count() == 0 && object.bezier.is_none())
                    && let Some(first) = import.report.warnings().next()
                {
                    let why = format!("nothing in it could be used. {first}");
                    return Err(Problem::new(not_opened(&import.model.name, &why)));
                }
                Made::Import(import)
            }
            Self::Run(ops, symmetry, inputs) => run(ops, *symmetry, inputs, progress)?,
            Self::Export(head, inputs) => {
                let model = Model {
                    name: head.name.clone(),
                    objects: inputs.clone(),
                    offset: head.offset,
                    materials: head.materials.clone(),
                };
                let files = formats::write(head.format, &model);
                Made::Files(files.map_err(|error| Problem::new(error.to_string()))?)
            }
            Self::Save(project) => Made::Files(vec![project.file()]),
            Self::Share(project) => Made::Link(Link::to(project)),
            Self::Decode(source, largest) => {
                Made::Picture(Picture::decode(source, *largest, progress).map_err(|error| match error {
                    PictureError::Cancelled => Problem::cancelled(),
                    PictureError::Unreadable(why) => Problem::new(why),
                })?)
            }
        };
        Ok(JobResult { made, validated: false })
    }
}

/// The project, if a file is one or the text of a link.
fn read_project(files: &[NamedBytes]) -> Result<Option<ReadProject>, Problem> {
    if let [file] = files
        && let Some(link) = std::str::from_utf8(&file.bytes).ok().and_then(Link::find)
    {
        return Link::read(link).map(Some).map_err(Problem::new);
    }
    let Some(file) = files.iter().find(|file| Project::is_file(file)) else { return Ok(None) };
    let mut read = Project::open_file(file).map_err(Problem::new)?;
    for other in files.iter().filter(|other| other.name != file.name) {
        read.report.warn(format!("{} was left out: a project is opened by itself", other.name));
    }
    Ok(Some(read))
}

/// Runs operations on meshes: a whole-mesh one on all inputs, local ones on the first.
pub(crate) fn run(
    ops: &[Op],
    symmetry: Symmetry,
    inputs: &[NamedMesh],
    progress: &mut Progress<'_>,
) -> Result<Made, Problem> {
    if let [op] = ops
        && let Action::WholeMesh(whole) = op.action()
    {
        whole.check()?;
        let mut notes = Vec::new();
        return Ok(Made::Meshes(whole.compute(inputs, &mut notes, progress)?, None, notes));
    }
    let input = inputs.first().ok_or_else(|| Problem::new("there is no mesh to edit"))?;
    let mut mesh = Mesh::clone(&input.mesh);
    let before = Before::of(&mesh);
    mesh.start_recording();
    let mut notes = Vec::new();
    let mut images = symmetry.axis().map(|axis| MirrorImages::new(&mesh, axis));
    edit_local(ops, images.as_mut(), &mut mesh, &mut notes, progress)?;
    let mut journal = mesh.finish_recording();
    let (created, removed) = before.compare(&mesh, &journal.touched());
    let ids = (created.with_sources(&face_sources(ops, &mut journal)), removed);
    Ok(Made::Meshes(vec![NamedMesh::new("", mesh)], Some(ids), notes))
}

/// The new faces with those that they were cut from, where the operations cut faces.
pub(crate) fn face_sources(ops: &[Op], journal: &mut Journal) -> Vec<(FaceId, FaceId)> {
    let sources = journal.take_face_sources();
    let cuts = |op: &Op| matches!(op.action(), Action::Local(edit) if edit.cuts_faces());
    if ops.iter().any(cuts) { sources } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfedge::PolygonSoup;

    #[test]
    fn an_invalid_mesh_stays_unvalidated() {
        let soup = PolygonSoup::new(vec![glam::Vec3::ZERO; 3], &[[0, 1, 2]]);
        let mut raw = Mesh::build(soup).expect("small").mesh.into_raw();
        raw.next.swap(0, 1);
        let output = NamedMesh::new("", Mesh::from_raw(raw));
        let made = Made::Meshes(vec![output], None, Vec::new());
        let mut result = JobResult { made, validated: false };
        result.validate();
        let read = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
        assert!(!read.validated);
        assert!(read.made.validate().is_err());
    }
}
