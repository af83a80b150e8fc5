//! Projects, and the sections of their files.

use super::container::{Contents, Sections};
use crate::document::{Document, Object};
use crate::editor::Editor;
use crate::error::not_opened;
use crate::job::wire::{BadBytes, Reader, Writer};
use crate::recovery::{Snapshot, read_log};
use formats::{Format, ImportReport, NamedBytes};
use serde::{Deserialize, Serialize};
use std::io;

/// A document with its selection, its view and its history. Clones share the meshes.
#[derive(Clone, Debug)]
pub struct Project {
    pub(super) now: Snapshot,
    pub(crate) view: Option<String>,
    pub(super) history: Option<Past>,
}

/// An earlier document, and the log of what was done since.
#[derive(Clone, Debug)]
pub(super) struct Past {
    pub start: Snapshot,
    pub log: Vec<u8>,
}

/// A project that was read, and what to tell about it.
#[derive(Clone, Debug)]
pub struct ReadProject {
    /// The project.
    pub project: Project,
    /// What was left out.
    pub report: ImportReport,
    /// Whether it came by a link, so that there is no file.
    pub is_link: bool,
}

/// The JSON of the section `about`.
#[derive(Serialize, Deserialize)]
#[serde(default)]
struct About {
    /// The program and its version.
    written_by: String,
    /// Whether the earlier document has the images of the present one, which are then written once.
    shares_images: bool,
}

impl Default for About {
    fn default() -> Self {
        Self {
            written_by: concat!("Meshwright ", env!("CARGO_PKG_VERSION")).to_owned(),
            shares_images: false,
        }
    }
}

/// The names of the sections.
const ABOUT: &str = "about";
const DOCUMENT: &str = "document";
const VIEW: &str = "view";
const START: &str = "start";
const LOG: &str = "log";

/// The longest state of a viewport that is read, in bytes.
const MAX_VIEW_BYTES: usize = 64 << 10;

impl Project {
    /// What an editor holds. An ongoing edit is in the document as it is shown, and then there is no history. Costs
    /// O(objects and the log of the history).
    pub fn of(editor: &Editor) -> Self {
        let past = editor.trail.contents().filter(|_| !editor.is_editing());
        Self {
            now: Snapshot::of(editor),
            view: editor.view.clone(),
            history: past.map(|(start, log)| Past { start: Snapshot::clone(start), log: log.to_vec() }),
        }
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.now.document
    }

    /// Whether it has a state of the viewport.
    pub fn has_view(&self) -> bool {
        self.view.is_some()
    }

    /// The number of entries of the history's log.
    pub fn logged(&self) -> usize {
        self.history.as_ref().map_or(0, |past| read_log(&past.log).entries.len())
    }

    /// Whether a file is a project, by its content.
    pub fn is_file(file: &NamedBytes) -> bool {
        Format::detect(file).is_some_and(Format::is_project)
    }

    /// Reads a file as a project that is named after it.
    ///
    /// # Errors
    /// As [`Project::read`], in sentences that name the file.
    pub fn open_file(file: &NamedBytes) -> Result<ReadProject, String> {
        let read = Self::read(&file.bytes).map_err(|why| not_opened(&file.name, &why))?;
        let name = file.name.rsplit_once('.').map_or(file.name.as_str(), |(stem, _)| stem);
        Ok(ReadProject { project: read.project.named(name), ..read })
    }

    /// The project as a file that is named after the document.
    pub fn file(&self) -> NamedBytes {
        let extension = Format::project().extension();
        NamedBytes::new(format!("{}.{extension}", self.now.document.name()), self.write())
    }

    /// The project under another name.
    pub fn named(mut self, name: &str) -> Self {
        name.clone_into(&mut self.now.document.name);
        self
    }

    /// The bytes of a project file. Costs O(document), about a second for a million triangles.
    pub fn write(&self) -> Vec<u8> {
        let mut file = Sections::new();
        let past = self.history.as_ref();
        let images = &self.now.document.materials.images;
        let shares_images = past.is_some_and(|past| past.start.document.materials.images == *images);
        let about = About { shares_images, ..About::default() };
        // Numbers and strings are always JSON.
        file.add(ABOUT, &serde_json::to_vec(&about).unwrap_or_default());
        file.add(DOCUMENT, &self.now.to_packed());
        if let Some(view) = &self.view {
            file.add(VIEW, view.as_bytes());
        }
        if let Some(Past { start, log }) = past {
            let mut start = start.clone();
            if shares_images {
                start.document.materials.images.clear();
            }
            file.add(START, &start.to_packed());
            file.add(LOG, log);
        }
        file.finish()
    }

    /// Reads a project file. Nothing of it is trusted: meshes are validated, and what it takes in memory is limited.
    ///
    /// # Errors
    /// It is no project file, one of a later version, or damaged: a sentence, without the file's name.
    pub fn read(file: &[u8]) -> Result<ReadProject, String> {
        let mut report = ImportReport::default();
        let mut sections = Contents::of(file)?;
        let about: About = match sections.take(ABOUT)? {
            Some(json) => serde_json::from_slice(&json).map_err(|_| damaged(ABOUT, "it is no JSON"))?,
            None => return Err(format!("the section “{ABOUT}” is missing")),
        };
        let document =
            sections.take(DOCUMENT)?.ok_or_else(|| format!("the section “{DOCUMENT}” is missing"))?;
        let now = snapshot(DOCUMENT, &document)?;
        let view = match sections.take(VIEW)? {
            Some(view) if view.len() <= MAX_VIEW_BYTES => {
                Some(String::from_utf8(view).map_err(|_| damaged(VIEW, "it is no text"))?)
            }
            Some(_) => return Err(damaged(VIEW, "it is too long")),
            None => None,
        };
        let history = match (sections.take(START)?, sections.take(LOG)?) {
            (Some(start), Some(log)) => {
                let mut start = snapshot(START, &start)?;
                if about.shares_images {
                    start.document.materials.images.clone_from(&now.document.materials.images);
                }
                Some(Past { start, log })
            }
            _ => None,
        };
        report.info(format!("Read a project saved by {}", shown(&about.written_by)));
        for name in sections.others() {
            report.warn(format!(
                "The section “{}” was left out: this version of Meshwright doesn't know it",
                shown(&name)
            ));
        }
        Ok(ReadProject { project: Self { now, view, history }, report, is_link: false })
    }

    /// Writes the project into the blocks of a message between threads.
    pub(crate) fn send(&self, out: &mut Writer<'_>) -> io::Result<()> {
        out.value(&(&self.view, self.history.is_some()))?;
        self.now.send(out)?;
        if let Some(Past { start, log }) = &self.history {
            start.send(out)?;
            out.column(log)?;
        }
        Ok(())
    }

    /// Reads what [`Project::send`] wrote. Meshes are not validated.
    pub(crate) async fn receive(from: &mut Reader<'_>) -> Result<Self, BadBytes> {
        let (view, has_history) = from.value().await?;
        let now = Snapshot::receive(from).await?;
        let history = if has_history {
            Some(Past { start: Snapshot::receive(from).await?, log: from.column().await? })
        } else {
            None
        };
        Ok(Self { now, view, history })
    }

    /// The objects of the document as it is now and as it was at the start of the history.
    pub(crate) fn objects(&self) -> impl Iterator<Item = &Object> {
        let start = self.history.iter().flat_map(|past| &past.start.document.objects);
        self.now.document.objects.iter().chain(start)
    }
}

/// Whether two documents are the same but for the identities of their objects and the document's name.
pub(super) fn is_same(one: &Snapshot, other: &Snapshot) -> bool {
    let (a, b) = (&one.document, &other.document);
    let is_same_object = |(a, b): (&Object, &Object)| a.clone().with_id(b.id()) == *b;
    a.objects.len() == b.objects.len()
        && a.objects.iter().zip(&b.objects).all(is_same_object)
        && (a.active, a.offset, &a.materials) == (b.active, b.offset, &b.materials)
        && one.selection == other.selection
}

fn snapshot(section: &str, bytes: &[u8]) -> Result<Snapshot, String> {
    Snapshot::from_packed(bytes).map_err(|error| damaged(section, error.reason()))
}

fn damaged(section: &str, why: &str) -> String {
    format!("the section “{section}” can't be used: {why}")
}

/// Text from a file that is fit to be shown in a line.
fn shown(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(60).collect()
}
