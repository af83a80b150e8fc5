//! A document as bytes.

use super::sets::{read_selection, read_set, write_selection, write_set};
use crate::document::{Document, NamedSelection, Object, ObjectId, Origin};
use crate::editor::Editor;
use crate::job::columns::{read_named, write_named};
use crate::job::messages::{read_materials, write_materials};
use crate::job::wire::{BadBytes, Part, Reader, Wire, Writer, at_once};
use crate::selection::Selection;
use halfedge::Element;
use serde::{Deserialize, Serialize};
use std::io::{self, Read, Write};
use std::sync::Arc;

/// A document with its selection and all that an editor numbers, without its history.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(crate) document: Document,
    pub(crate) selection: Arc<Selection>,
    pub(crate) numbers: Numbers,
}

/// Where an editor goes on counting.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Numbers {
    pub next_object: u64,
    pub revision: u64,
    pub last_revision: u64,
    pub saved: u64,
}

#[derive(Serialize, Deserialize)]
struct Head {
    name: String,
    // Project files of version 1 may lack it.
    #[serde(default)]
    origin: Origin,
    offset: [f64; 3],
    active: usize,
    numbers: Numbers,
    objects: Vec<ObjectHead>,
}

#[derive(Serialize, Deserialize)]
struct ObjectHead {
    id: u64,
    visible: bool,
    named_selections: Vec<String>,
}

pub(super) const SNAPSHOT_MARK: [u8; 8] = *b"MWsnap\0\x01";
const PACKED_MARK: [u8; 8] = *b"MWpack\0\x01";

/// The largest number that is read: JSON holds it exactly, and an editor can go on counting from there.
const MAX_NUMBER: u64 = 1 << 52;

impl Wire for Snapshot {
    fn write_to(&self, out: &mut dyn Write) -> io::Result<()> {
        write(&self.document, &self.selection, self.numbers, &mut Writer::start(out, SNAPSHOT_MARK)?)
    }

    async fn read(from: &mut dyn Read, len: usize, part: Part) -> Result<Self, BadBytes> {
        let mut from = Reader::start(from, len, SNAPSHOT_MARK, part)?;
        let snapshot = read(&mut from, true).await?;
        from.end()?;
        Ok(snapshot)
    }
}

/// Reads a snapshot. Meshes are validated unless they are known to be valid.
async fn read(from: &mut Reader<'_>, validates: bool) -> Result<Snapshot, BadBytes> {
    let Head { name, origin, offset, active, numbers, objects } = from.value().await?;
    let materials = read_materials(from).await?;
    let mut read = Vec::new();
    for head in objects {
        read.push(read_object(from, head, validates).await?);
    }
    let selection = Arc::new(read_selection(from).await?);
    let document = Document { name, objects: read, active, offset: offset.into(), materials, origin };
    check(&document, &selection, numbers)?;
    Ok(Snapshot { document, selection, numbers })
}

fn write(
    document: &Document,
    selection: &Selection,
    numbers: Numbers,
    out: &mut Writer<'_>,
) -> io::Result<()> {
    let objects = document.objects.iter().map(|object| ObjectHead {
        id: object.id().0,
        visible: object.visible,
        named_selections: object.named_selections().iter().map(|named| named.name.clone()).collect(),
    });
    out.value(&Head {
        name: document.name.clone(),
        origin: document.origin,
        offset: document.offset.to_array(),
        active: document.active,
        numbers,
        objects: objects.collect(),
    })?;
    write_materials(out, &document.materials)?;
    for object in &document.objects {
        write_named(out, &object.named, true)?;
        write_set(out, &object.hidden)?;
        object.named_selections().iter().try_for_each(|named| write_selection(out, &named.selection))?;
    }
    write_selection(out, selection)
}

/// Checks what else an editor relies on.
fn check(document: &Document, selection: &Selection, numbers: Numbers) -> Result<(), BadBytes> {
    let mut ids: Vec<u64> = document.objects.iter().map(|object| object.id().0).collect();
    ids.sort_unstable();
    ids.dedup();
    let is_wrong = ids.len() < document.objects.len()
        || ids.last().is_some_and(|&id| id >= numbers.next_object)
        || document.active >= document.objects.len().max(1)
        || numbers.revision.max(numbers.saved).max(document.origin.revision) > numbers.last_revision
        || numbers.next_object.max(numbers.last_revision) > MAX_NUMBER
        || !document.offset.is_finite()
        || document.active().map_or(!selection.is_empty(), |object| selection.has_gone(object.mesh()));
    if is_wrong { Err(BadBytes::new("the document does not fit together")) } else { Ok(()) }
}

async fn read_object(from: &mut Reader<'_>, head: ObjectHead, validates: bool) -> Result<Object, BadBytes> {
    let named = read_named(from).await?;
    let valid = if validates { named.mesh.validate() } else { Ok(()) };
    valid.map_err(|defect| BadBytes::new(format!("{}: {defect}", named.name)))?;
    let mut object = Object::new(ObjectId(head.id), named);
    object.visible = head.visible;
    object.hidden = Arc::new(read_set(from).await?);
    let mut named = Vec::new();
    for name in head.named_selections {
        named.push(NamedSelection { name, selection: read_selection(from).await? });
    }
    object.named_selections = Arc::new(named);
    let mesh = object.mesh();
    let has_gone = object.hidden.iter().any(|face| !mesh.exists(Element::Face, face as u32))
        || object.named_selections().iter().any(|named| named.selection.has_gone(mesh));
    if has_gone { Err(BadBytes::new("a set holds elements that do not exist")) } else { Ok(object) }
}

/// A snapshot being copied in parts, so that no frame of the page takes long: a million triangles take about 100 MB. Editing
/// goes on meanwhile; the log of the editor then continues both the last snapshot and this one.
#[derive(Debug)]
pub struct SnapshotCopy {
    snapshot: Snapshot,
    done_bytes: usize,
    total_bytes: usize,
}

impl SnapshotCopy {
    /// Begins to copy the document as it is now; none while an edit is ongoing, whose preview is no part of the document.
    /// The meshes are shared until they are edited. Costs O(objects and materials).
    pub fn begin(editor: &mut Editor) -> Option<Self> {
        if editor.is_editing() || editor.is_selecting() {
            return None;
        }
        editor.begin_log_of_copy();
        let snapshot = Snapshot::of(editor);
        Some(Self { total_bytes: snapshot.byte_len(), snapshot, done_bytes: 0 })
    }

    /// The length of the whole snapshot.
    pub fn total_bytes(&self) -> usize {
        self.total_bytes
    }

    /// Whether the snapshot is complete.
    pub fn is_done(&self) -> bool {
        self.done_bytes == self.total_bytes
    }

    /// Gives the next bytes, at most this many, to `out`, in pieces; they follow those of the previous call. Costs
    /// O(bytes + objects).
    pub fn step(&mut self, bytes: usize, out: &mut dyn FnMut(&[u8])) {
        let mut window = Window { skip: self.done_bytes, room: bytes, out };
        // Writing to a window can't fail.
        let _ = self.snapshot.write_to(&mut window);
        self.done_bytes = self.total_bytes.min(self.done_bytes.saturating_add(bytes));
    }

    /// Makes the log of the editor the one that continues this snapshot: [`Editor::take_log`] gives what was done since it
    /// was begun. Log the view then, which no snapshot holds.
    pub fn finish(self, editor: &mut Editor) {
        editor.end_log_of_copy();
    }
}

/// Passes on some of the bytes that are written to it.
struct Window<'a> {
    /// The bytes to leave out at the beginning.
    skip: usize,
    /// The bytes to pass on after those.
    room: usize,
    out: &'a mut dyn FnMut(&[u8]),
}

impl Write for Window<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let left_out = self.skip.min(bytes.len());
        self.skip -= left_out;
        let rest = bytes.get(left_out..).unwrap_or_default();
        let wanted = rest.get(..self.room.min(rest.len())).unwrap_or_default();
        if !wanted.is_empty() {
            self.room -= wanted.len();
            (self.out)(wanted);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Snapshot {
    /// The document of an editor as it is now. Shares the meshes.
    pub(crate) fn of(editor: &Editor) -> Self {
        Self {
            document: editor.document().clone(),
            selection: editor.shared_selection().clone(),
            numbers: editor.numbers(),
        }
    }

    /// A document without objects, before its first step.
    pub(crate) fn empty() -> Self {
        let numbers = Numbers { next_object: 1, revision: 0, last_revision: 0, saved: 0 };
        Self { document: Document::untitled(), selection: Arc::default(), numbers }
    }

    /// The snapshot in packed blocks, which compress well.
    pub(crate) fn to_packed(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        // Writing to a vector can't fail.
        let _ = Writer::start_packed(&mut bytes, PACKED_MARK)
            .and_then(|mut out| write(&self.document, &self.selection, self.numbers, &mut out));
        bytes
    }

    /// Reads what [`Snapshot::to_packed`] wrote, and validates it.
    ///
    /// # Errors
    /// The bytes are no packed snapshot.
    pub(crate) fn from_packed(mut bytes: &[u8]) -> Result<Self, BadBytes> {
        at_once(async {
            let len = bytes.len();
            let mut from = Reader::start_packed(&mut bytes, len, PACKED_MARK)?;
            let snapshot = read(&mut from, true).await?;
            from.end()?;
            Ok(snapshot)
        })
    }

    /// Writes the snapshot into the blocks of a message between threads.
    pub(crate) fn send(&self, out: &mut Writer<'_>) -> io::Result<()> {
        write(&self.document, &self.selection, self.numbers, out)
    }

    /// Reads what [`Snapshot::send`] wrote. Meshes are not validated.
    pub(crate) async fn receive(from: &mut Reader<'_>) -> Result<Self, BadBytes> {
        read(from, false).await
    }

    /// An editor on the snapshot's document, without a history, ready for [`Editor::replay`].
    pub fn into_editor(self) -> Editor {
        let Self { document, selection, numbers } = self;
        Editor::restored(document, selection, numbers)
    }
}
