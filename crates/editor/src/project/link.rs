//! Links that hold a document: a few characters of text after `#d=`.
//!
//! A link holds the commands that lead from a new shape to the document, or the document itself, whichever is shorter.
//! `docs/project-file.md` describes the characters.

use super::container::{deflate, inflate};
use super::file::{Project, ReadProject, is_same};
use super::open::Work;
use crate::document::{Object, ObjectId, Origin};
use crate::editor::Editor;
use crate::ops::Command;
use crate::recovery::{Entry, Event, Numbers, Snapshot, read_log};
use crate::selection::Selection;
use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use formats::ImportReport;
use halfedge::Element;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::sync::Arc;

/// What links begin with, in the fragment of an address.
pub const LINK_MARK: &str = "#d=";

/// The version of links, one character.
const VERSION: char = '1';

/// The most characters of a link that is read, and the most bytes that it may expand to.
const MAX_CHARACTERS: usize = 100_000;
const MAX_EXPANDED_BYTES: u64 = 4 << 20;

/// Larger documents are too long as meshes, whatever they look like: they are not tried.
const MAX_TRIED_FACES: usize = 50_000;

/// The work of repeating the commands of larger documents is too much.
const MAX_FACES: usize = 200_000;

/// The first byte tells what follows, compressed.
const MESHES: u8 = 0;
const COMMANDS: u8 = 1;

/// What a link holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LinkKind {
    /// The document's meshes.
    Meshes,
    /// The commands that lead from a new shape to the document.
    Commands,
}

/// A link to a document.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Link {
    /// The fragment of the address, from `#` on; empty if the document is too large for any link.
    pub fragment: String,
    /// What it holds.
    pub kind: LinkKind,
}

/// The JSON of a link of commands.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Commands {
    name: String,
    commands: Vec<Value>,
}

impl Link {
    /// The shortest link to a project's document, without its selection, view and history. Costs O(document) and the
    /// work of its history, which is limited.
    pub fn to(project: &Project) -> Self {
        let shared = bare(&project.now);
        let faces: usize = shared.document.objects.iter().map(|object| object.mesh().face_count()).sum();
        let meshes = (faces <= MAX_TRIED_FACES)
            .then(|| Self { fragment: encode(MESHES, &shared.to_packed()), kind: LinkKind::Meshes });
        let commands = commands_of(project).and_then(|commands| {
            let commands = Commands { name: shared.document.name.clone(), commands };
            let json = serde_json::to_vec(&commands).ok()?;
            let repeated = repeat(&json).ok()?;
            is_same(&bare(&Snapshot::of(&repeated)), &shared)
                .then(|| Self { fragment: encode(COMMANDS, &json), kind: LinkKind::Commands })
        });
        let links = [meshes, commands].into_iter().flatten();
        let readable = links.filter(|link| link.fragment.len() <= MAX_CHARACTERS);
        readable
            .min_by_key(|link| link.fragment.len())
            .unwrap_or(Self { fragment: String::new(), kind: LinkKind::Meshes })
    }

    /// Whether a document may have a link at all: larger ones are not tried.
    pub(crate) fn may_hold(editor: &Editor) -> bool {
        let objects = editor.document().objects().iter();
        objects.map(|object| object.mesh().face_count()).sum::<usize>() <= MAX_FACES
    }

    /// The part of a text that is a link: the text from [`LINK_MARK`] on, if it is a fragment or an address.
    pub fn find(text: &str) -> Option<&str> {
        let text = text.trim();
        if text.contains(char::is_whitespace) {
            return None;
        }
        let is_address = text.starts_with("https://") || text.starts_with("http://");
        match text.find(LINK_MARK) {
            Some(0) => Some(text),
            Some(at) if is_address => text.get(at..),
            _ => None,
        }
    }

    /// Reads a link. Nothing of it is trusted.
    ///
    /// # Errors
    /// It is damaged, or of a later version: sentences.
    pub fn read(fragment: &str) -> Result<ReadProject, String> {
        let incomplete = || "The link is damaged or incomplete: copy it again, to its end.".to_owned();
        let text = fragment.strip_prefix(LINK_MARK).ok_or_else(incomplete)?;
        if text.len() > MAX_CHARACTERS {
            return Err("The link is too long to be one of Meshwright.".to_owned());
        }
        let mut characters = text.chars();
        match characters.next() {
            Some(VERSION) => {}
            Some(later) if later.is_ascii_digit() => {
                return Err(
                    "The link was made by a later version of Meshwright. Reload the page to get the latest version."
                        .to_owned(),
                );
            }
            _ => return Err(incomplete()),
        }
        let bytes = URL_SAFE_NO_PAD.decode(characters.as_str()).map_err(|_| incomplete())?;
        let (kind, packed) = bytes.split_first().ok_or_else(incomplete)?;
        let (checksum, packed) = packed.split_first_chunk::<4>().ok_or_else(incomplete)?;
        if checksum_of(*kind, packed) != *checksum {
            return Err(incomplete());
        }
        let bytes = inflate(packed, MAX_EXPANDED_BYTES).map_err(|_| incomplete())?;
        let project = match *kind {
            MESHES => {
                let now = Snapshot::from_packed(&bytes)
                    .map_err(|error| format!("The link holds no valid document: {}.", error.reason()))?;
                Project { now, view: None, history: None }
            }
            COMMANDS => Project::of(&repeat(&bytes)?),
            _ => return Err(incomplete()),
        };
        Ok(ReadProject { project, report: ImportReport::default(), is_link: true })
    }
}

/// The document alone, with numbers as in a new editor.
fn bare(snapshot: &Snapshot) -> Snapshot {
    let mut snapshot = snapshot.clone();
    let objects = std::mem::take(&mut snapshot.document.objects);
    let alone = |(id, object): (u64, Object)| object.without_soup().with_id(ObjectId(id));
    snapshot.document.objects = (1..).zip(objects).map(alone).collect();
    let next_object = snapshot.document.objects.len() as u64 + 1;
    snapshot.numbers = Numbers { next_object, revision: 0, last_revision: 0, saved: 0 };
    snapshot.document.origin = Origin::default();
    snapshot.selection = Arc::default();
    snapshot
}

fn encode(kind: u8, bytes: &[u8]) -> String {
    let packed = deflate(bytes, Compression::best());
    let checksum = checksum_of(kind, &packed);
    let payload = [&[kind], &checksum[..], &packed].concat();
    format!("{LINK_MARK}{VERSION}{}", URL_SAFE_NO_PAD.encode(payload))
}

fn checksum_of(kind: u8, packed: &[u8]) -> [u8; 4] {
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(&[kind]);
    checksum.update(packed);
    checksum.finalize().to_le_bytes()
}

/// Runs the commands of a link on a document without objects.
fn repeat(json: &[u8]) -> Result<Editor, String> {
    let no_commands = "The link holds no commands that Meshwright understands";
    let Commands { name, commands } =
        serde_json::from_slice(json).map_err(|error| format!("{no_commands}: {error}."))?;
    let mut editor = Editor::new();
    let mut work = Work::default();
    for (at, value) in commands.into_iter().enumerate() {
        let command = Command::from_value(value).map_err(|error| format!("{no_commands}: {error}."))?;
        if !work.allows(&editor, Some(&command)) {
            return Err("The link asks for more work than opening a link may take.".to_owned());
        }
        let run = if at == 0 { editor.start_with(command) } else { editor.run(command) };
        run.map_err(|error| format!("A command in the link can't be carried out: {error}."))?;
    }
    editor.rename_document(&name);
    Ok(editor)
}

/// What was done since the document began as a new shape, as commands, without what was undone; none if it did not begin so.
fn commands_of(project: &Project) -> Option<Vec<Value>> {
    let past = project.history.as_ref().filter(|past| past.start.document.objects.is_empty())?;
    let (mut done, mut undone): (Vec<Deed>, Vec<Deed>) = (Vec::new(), Vec::new());
    for Entry { event, .. } in read_log(&past.log).entries {
        match event {
            Event::Start(command) | Event::Run(command) | Event::Edit(command) => {
                done.push(Deed::Do(command))
            }
            Event::Job { command, .. } => done.push(Deed::Do(command)),
            Event::Select { selection, continues } => {
                if continues {
                    done.pop_if(|deed| matches!(deed, Deed::Select(_)));
                }
                done.push(Deed::Select((*selection).clone()));
                continue;
            }
            Event::Undo => {
                while done.pop_if(|deed| matches!(deed, Deed::Select(_))).is_some() {}
                undone.push(done.pop()?);
                continue;
            }
            Event::UndoStep => {
                undone.push(done.pop()?);
                continue;
            }
            Event::Redo => {
                while undone.pop_if(|deed| matches!(deed, Deed::Select(_))).is_some() {}
                done.push(undone.pop()?);
                continue;
            }
            Event::RedoStep => {
                done.push(undone.pop()?);
                continue;
            }
            _ => continue,
        }
        undone.clear();
    }
    // Only the last selection before a command counts, and none after the last one.
    let mut commands = Vec::new();
    let mut selected = None;
    for deed in done {
        match deed {
            Deed::Select(selection) => selected = Some(selection),
            Deed::Do(command) => {
                commands.extend(selected.take().map(|selection| select(&selection)));
                commands.push(command.to_value());
            }
        }
    }
    Some(commands)
}

/// Something that was done.
enum Deed {
    Do(Command),
    Select(Selection),
}

/// The command that selects the same.
fn select(selection: &Selection) -> Value {
    let field = match selection.kind() {
        Element::Vertex => "vertices",
        Element::Edge => "edges",
        Element::Halfedge => "halfedges",
        Element::Face => "faces",
    };
    json!({"op": "select-elements", field: selection.ids().collect::<Vec<u32>>()})
}
