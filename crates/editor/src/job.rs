//! Jobs: what takes long, as plain data that can be sent to a worker and back.

mod bytes;

pub use bytes::BadBytes;

use crate::bezier::fill_previews;
use crate::error::{CommandError, Problem};
use crate::ops::{Action, Input, Op, Output, edit_all};
use crate::outcome::{Before, ElementIds};
use formats::{Format, Import, Materials, Model, NamedBytes, NamedMesh, ReadError, Repairs};
use glam::DVec3;
use halfedge::{Mesh, Progress};
use std::sync::Arc;

/// Which job of an editor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct JobId(pub u64);

/// What a job has to do, with all it needs: it can be run on any thread or sent to a worker.
#[derive(Clone, Debug)]
pub struct JobRequest {
    pub(crate) id: JobId,
    pub(crate) work: Work,
}

#[derive(Clone, Debug)]
pub(crate) enum Work {
    /// Reads files, making meshes of what is not one by these choices.
    Import(Vec<NamedBytes>, Repairs),
    /// Runs operations on meshes; several only where they are local edits.
    Run(Vec<Op>, Vec<Input>),
    /// Writes a document as files.
    Export(ExportHead, Vec<Input>),
}

/// What there is to a document that is written besides its objects.
#[derive(Clone, Debug)]
pub(crate) struct ExportHead {
    pub format: Format,
    /// The document's name, which files are called after.
    pub name: String,
    pub offset: DVec3,
    pub materials: Materials,
}

/// What a job made.
#[derive(Debug)]
pub struct JobResult {
    pub(crate) made: Made,
    /// Whether the meshes have been validated: reading a result from bytes does that.
    pub(crate) validated: bool,
}

#[derive(Debug)]
pub(crate) enum Made {
    Import(Import),
    /// The meshes; for local edits what they created and removed; what to tell the user besides.
    Meshes(Vec<Output>, Option<(ElementIds, ElementIds)>, Vec<String>),
    Files(Vec<NamedBytes>),
}

impl Made {
    /// Validates every mesh; gives what is wrong with the first that is not valid.
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
            Self::Files(_) => Ok(()),
        }
    }
}

impl JobRequest {
    /// Reading files, for whoever has no editor yet; its result goes to [`JobResult::into_import`].
    pub fn import(files: Vec<NamedBytes>) -> Self {
        Self { id: JobId(0), work: Work::Import(files, Repairs::default()) }
    }

    /// Reading the files of an import that was announced with [`crate::Editor::expect_import`].
    pub fn import_expected(id: JobId, files: Vec<NamedBytes>) -> Self {
        Self { id, work: Work::Import(files, Repairs::default()) }
    }

    /// Which job this is.
    pub fn id(&self) -> JobId {
        self.id
    }

    /// The op, or `open` and `export`.
    pub fn op(&self) -> &'static str {
        match &self.work {
            Work::Import(..) => "open",
            Work::Run(ops, _) => ops.first().map_or("nothing", |op| op.spec().name),
            Work::Export(..) => "export",
        }
    }

    /// Does the work, telling `progress`, which may stop it.
    ///
    /// # Errors
    /// What the command would be refused for, or that it was cancelled.
    pub fn run(&self, progress: &mut Progress<'_>) -> Result<JobResult, CommandError> {
        self.work.run(progress).map_err(|problem| CommandError::of(self.op(), problem))
    }
}

impl JobResult {
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
                let mut import =
                    formats::read_with(files, repairs, progress).map_err(|error| match error {
                        ReadError::Cancelled => Problem::cancelled(),
                        other => Problem::new(other.to_string()),
                    })?;
                fill_previews(&mut import)?;
                // Nothing but trouble is no reason to take the open document away.
                if import
                    .model
                    .objects
                    .iter()
                    .all(|object| object.mesh.vertex_count() == 0 && object.bezier.is_none())
                    && let Some(first) = import.report.warnings().next()
                {
                    return Err(Problem::new(format!(
                        "nothing in {} could be used. {first}",
                        import.model.name
                    )));
                }
                Made::Import(import)
            }
            Self::Run(ops, inputs) => run(ops, inputs, progress)?,
            Self::Export(head, inputs) => {
                let object = |input: &Input| NamedMesh {
                    bezier: input.bezier.clone(),
                    ..NamedMesh::new(&input.name, Arc::clone(&input.mesh))
                };
                let model = Model {
                    name: head.name.clone(),
                    objects: inputs.iter().map(object).collect(),
                    offset: head.offset,
                    materials: head.materials.clone(),
                };
                let files = formats::write(head.format, &model);
                Made::Files(files.map_err(|error| Problem::new(error.to_string()))?)
            }
        };
        Ok(JobResult { made, validated: false })
    }
}

/// Runs operations on meshes: a whole-mesh one on all inputs, local ones on the first.
pub(crate) fn run(ops: &[Op], inputs: &[Input], progress: &mut Progress<'_>) -> Result<Made, Problem> {
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
    edit_all(ops, &mut mesh, &mut notes, progress)?;
    let touched = mesh.finish_recording().touched();
    let ids = before.compare(&mesh, &touched);
    Ok(Made::Meshes(vec![Output::new("", mesh)], Some(ids), notes))
}
