//! Requests and results as blocks.

use super::columns::{read_named, write_named};
use super::wire::{BadBytes, Part, Reader, Wire, Writer};
use super::{ExportHead, JobId, JobRequest, JobResult, Made, Work};
use crate::ops::{Action, Command, Op, Symmetry};
use crate::outcome::ElementIds;
use crate::project::{Link, Project, ReadProject};
use formats::{
    Format, Image, Import, ImportReport, Materials, Model, NamedBytes, NamedMesh, Picture, PictureSource,
    Repairs,
};
use serde::{Deserialize, Serialize};
use std::io::{self, Read, Write};

const REQUEST_MARK: [u8; 8] = *b"MWjobRq2";
const RESULT_MARK: [u8; 8] = *b"MWjobRs2";

#[derive(Serialize, Deserialize)]
struct RequestHead {
    id: u64,
    work: WorkHead,
}

#[derive(Serialize, Deserialize)]
enum WorkHead {
    /// The files follow.
    Import { repairs: Repairs },
    /// The meshes follow.
    Run { ops: Vec<Command> },
    /// The materials and the meshes follow.
    Export { format: Format, name: String, offset: [f64; 3] },
    /// The project follows.
    Save,
    /// The project follows.
    Share,
    /// The contents of the images follow, if they have any.
    Decode { images: [Option<Image>; 2], has_bytes: [bool; 2], largest: u32 },
}

#[derive(Serialize, Deserialize)]
struct ResultHead {
    /// Whether the writing end found every mesh valid.
    validated: bool,
    made: MadeHead,
}

#[derive(Serialize, Deserialize)]
enum MadeHead {
    /// The materials and the objects follow.
    Import {
        name: String,
        report: ImportReport,
        offset: [f64; 3],
    },
    /// The project follows.
    Project {
        report: ImportReport,
        is_link: bool,
    },
    /// The meshes follow, and what was created and removed if `has_ids`.
    Meshes {
        notes: Vec<String>,
        has_ids: bool,
    },
    /// The files follow.
    Files,
    Link(Link),
    /// The pixels follow.
    Picture {
        size: [u32; 2],
        original: [u32; 2],
    },
}

impl Wire for JobRequest {
    fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut out = Writer::start(out, REQUEST_MARK)?;
        let head = |work| RequestHead { id: self.id.0, work };
        match &self.work {
            Work::Import(files, repairs) => {
                out.value(&head(WorkHead::Import { repairs: *repairs }))?;
                write_files(&mut out, files)
            }
            Work::Run(ops, symmetry, inputs) => {
                let command = |op: &Op| Command { object: None, symmetry: *symmetry, op: op.clone() };
                out.value(&head(WorkHead::Run { ops: ops.iter().map(command).collect() }))?;
                write_meshes(&mut out, inputs, reads_soup(ops))
            }
            Work::Export(export, inputs) => {
                out.value(&head(WorkHead::Export {
                    format: export.format,
                    name: export.name.clone(),
                    offset: export.offset.to_array(),
                }))?;
                write_materials(&mut out, &export.materials)?;
                write_meshes(&mut out, inputs, false)
            }
            Work::Save(project) => {
                out.value(&head(WorkHead::Save))?;
                project.send(&mut out)
            }
            Work::Share(project) => {
                out.value(&head(WorkHead::Share))?;
                project.send(&mut out)
            }
            Work::Decode(PictureSource { color, alpha }, largest) => {
                let (both, largest) = ([color, alpha], *largest);
                let images = both.map(|image| image.as_ref().map(without_bytes));
                let bytes = both.map(|image| image.as_ref().and_then(|image| image.bytes.as_ref()));
                let has_bytes = bytes.map(|bytes| bytes.is_some());
                out.value(&head(WorkHead::Decode { images, has_bytes, largest }))?;
                bytes.into_iter().flatten().try_for_each(|bytes| out.column(bytes))
            }
        }
    }

    async fn read(from: &mut dyn Read, len: usize, part: Part) -> Result<Self, BadBytes> {
        let mut from = Reader::start(from, len, REQUEST_MARK, part)?;
        let RequestHead { id, work } = from.value().await?;
        let work = match work {
            WorkHead::Import { repairs } => Work::Import(read_files(&mut from).await?, repairs),
            WorkHead::Run { ops: commands } => {
                let symmetry = commands.first().map_or(Symmetry::None, |command| command.symmetry);
                let ops = commands.into_iter().map(|command| command.op).collect();
                Work::Run(ops, symmetry, read_meshes(&mut from).await?)
            }
            WorkHead::Export { format, name, offset } => {
                let materials = read_materials(&mut from).await?;
                let head = ExportHead { format, name, offset: offset.into(), materials };
                Work::Export(head, read_meshes(&mut from).await?)
            }
            WorkHead::Save => Work::Save(Box::new(Project::receive(&mut from).await?)),
            WorkHead::Share => Work::Share(Box::new(Project::receive(&mut from).await?)),
            WorkHead::Decode { mut images, has_bytes, largest } => {
                for (image, _) in images.iter_mut().zip(has_bytes).filter(|(_, has_bytes)| *has_bytes) {
                    let bytes = Some(from.column().await?.into());
                    image.iter_mut().for_each(|image| image.bytes.clone_from(&bytes));
                }
                let [color, alpha] = images;
                Work::Decode(PictureSource { color, alpha }, largest)
            }
        };
        from.end()?;
        Ok(Self { id: JobId(id), work })
    }
}

impl Wire for JobResult {
    fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut out = Writer::start(out, RESULT_MARK)?;
        let head = |made| ResultHead { validated: self.validated, made };
        match &self.made {
            Made::Import(import) => {
                let Import { model, report } = import;
                let (name, offset) = (model.name.clone(), model.offset.to_array());
                out.value(&head(MadeHead::Import { name, report: report.clone(), offset }))?;
                write_materials(&mut out, &model.materials)?;
                write_meshes(&mut out, &model.objects, true)
            }
            Made::Project(read) => {
                out.value(&head(MadeHead::Project { report: read.report.clone(), is_link: read.is_link }))?;
                read.project.send(&mut out)
            }
            Made::Meshes(outputs, ids, notes) => {
                out.value(&head(MadeHead::Meshes { notes: notes.clone(), has_ids: ids.is_some() }))?;
                write_meshes(&mut out, outputs, true)?;
                for ids in ids.iter().flat_map(|(created, removed)| [created, removed]) {
                    [&ids.vertices, &ids.edges, &ids.faces, &ids.cut_from]
                        .into_iter()
                        .try_for_each(|list| out.column(list))?;
                }
                Ok(())
            }
            Made::Files(files) => {
                out.value(&head(MadeHead::Files))?;
                write_files(&mut out, files)
            }
            Made::Link(link) => out.value(&head(MadeHead::Link(link.clone()))),
            Made::Picture(Picture { size, pixels, original }) => {
                out.value(&head(MadeHead::Picture { size: *size, original: *original }))?;
                out.column(pixels)
            }
        }
    }

    async fn read(from: &mut dyn Read, len: usize, part: Part) -> Result<Self, BadBytes> {
        let mut from = Reader::start(from, len, RESULT_MARK, part)?;
        let ResultHead { validated, made } = from.value().await?;
        let made = match made {
            MadeHead::Import { name, report, offset } => {
                let materials = read_materials(&mut from).await?;
                let objects = read_meshes(&mut from).await?;
                let model = Model { name, objects, offset: offset.into(), materials };
                Made::Import(Import { model, report })
            }
            MadeHead::Project { report, is_link } => {
                let project = Project::receive(&mut from).await?;
                Made::Project(Box::new(ReadProject { project, report, is_link }))
            }
            MadeHead::Meshes { notes, has_ids } => {
                let outputs = read_meshes(&mut from).await?;
                let ids = if has_ids {
                    Some((read_ids(&mut from).await?, read_ids(&mut from).await?))
                } else {
                    None
                };
                Made::Meshes(outputs, ids, notes)
            }
            MadeHead::Files => Made::Files(read_files(&mut from).await?),
            MadeHead::Link(link) => Made::Link(link),
            MadeHead::Picture { size, original } => {
                Made::Picture(Picture { size, pixels: from.column().await?, original })
            }
        };
        from.end()?;
        Ok(Self { made, validated })
    }
}

/// Whether an operation reads the faces as they were in the file: no other job needs them sent.
fn reads_soup(ops: &[Op]) -> bool {
    ops.iter().any(|op| matches!(op.action(), Action::WholeMesh(whole) if whole.reads_soup()))
}

fn write_meshes(out: &mut Writer<'_>, meshes: &[NamedMesh], with_soup: bool) -> io::Result<()> {
    out.value(&meshes.len())?;
    meshes.iter().try_for_each(|mesh| write_named(out, mesh, with_soup))
}

async fn read_meshes(from: &mut Reader<'_>) -> Result<Vec<NamedMesh>, BadBytes> {
    // Each takes bytes, so a false count ends with an error.
    let count: usize = from.value().await?;
    let mut meshes = Vec::new();
    for _ in 0..count {
        meshes.push(read_named(from).await?);
    }
    Ok(meshes)
}

fn write_files(out: &mut Writer<'_>, files: &[NamedBytes]) -> io::Result<()> {
    out.value(&files.iter().map(|file| &file.name).collect::<Vec<_>>())?;
    files.iter().try_for_each(|file| out.column(&file.bytes))
}

async fn read_files(from: &mut Reader<'_>) -> Result<Vec<NamedBytes>, BadBytes> {
    let names: Vec<String> = from.value().await?;
    let mut files = Vec::new();
    for name in names {
        files.push(NamedBytes { name, bytes: from.column().await? });
    }
    Ok(files)
}

fn without_bytes(image: &Image) -> Image {
    Image { name: image.name.clone(), media_type: image.media_type.clone(), bytes: None }
}

pub(crate) fn write_materials(out: &mut Writer<'_>, materials: &Materials) -> io::Result<()> {
    let images = materials.images.iter().map(without_bytes);
    let has_bytes: Vec<bool> = materials.images.iter().map(|image| image.bytes.is_some()).collect();
    out.value(&(&materials.list, images.collect::<Vec<_>>(), has_bytes))?;
    materials.images.iter().filter_map(|image| image.bytes.as_ref()).try_for_each(|bytes| out.column(bytes))
}

pub(crate) async fn read_materials(from: &mut Reader<'_>) -> Result<Materials, BadBytes> {
    let (list, mut images, has_bytes): (_, Vec<Image>, Vec<bool>) = from.value().await?;
    for (image, has_bytes) in images.iter_mut().zip(has_bytes) {
        if has_bytes {
            image.bytes = Some(from.column().await?.into());
        }
    }
    Ok(Materials { list, images })
}

async fn read_ids(from: &mut Reader<'_>) -> Result<ElementIds, BadBytes> {
    let [vertices, edges, faces] = [from.column().await?, from.column().await?, from.column().await?];
    Ok(ElementIds { vertices, edges, faces, cut_from: from.column().await? })
}
