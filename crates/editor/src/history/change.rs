//! The reversible changes that steps consist of.

use crate::bezier::Bezier;
use crate::changes::Changes;
use crate::document::{Document, NamedSelection, Object, ObjectId, Origin};
use formats::Materials;
use glam::DVec3;
use halfedge::geometry::BitSet;
use halfedge::{Journal, Mesh, PolygonSoup, Touched};
use std::sync::Arc;

/// One reversible change to a document.
#[derive(Debug)]
pub(crate) enum Change {
    /// Plays a journal back on the object's mesh.
    Journal(ObjectId, Journal),
    /// Replaces the object's mesh.
    Mesh(ObjectId, Arc<Mesh>),
    /// Replaces the object's control points, or removes them.
    Bezier(ObjectId, Option<Arc<Bezier>>),
    /// Replaces the faces from which the object can be repaired, or removes them.
    Soup(ObjectId, Option<Arc<PolygonSoup>>),
    /// Sets the offset that is added to every position on saving.
    Offset(DVec3),
    /// Sets the document's materials.
    Materials(Materials),
    /// Renames the object.
    Name(ObjectId, String),
    /// Shows or hides the object.
    Visible(ObjectId, bool),
    /// Hides these faces of the object and no others.
    Hidden(ObjectId, Arc<BitSet>),
    /// Replaces the object's named selections.
    NamedSelections(ObjectId, Arc<Vec<NamedSelection>>),
    /// Activates the object at this place in the list.
    Active(usize),
    /// Inserts an object at this place in the list.
    Insert(usize, Box<Object>),
    /// Removes the object at this place from the list.
    Remove(usize),
    /// Renames the document.
    DocumentName(String),
    /// Makes the document another one.
    Origin(Origin),
}

impl Change {
    /// Applies the change and returns its inverse; none if the change doesn't fit the document, which then
    /// stays as it was. Calls `reshaped` with an object whose element counts may have changed.
    pub fn make(
        self,
        document: &mut Document,
        changes: &mut Changes,
        mut reshaped: impl FnMut(ObjectId),
    ) -> Option<Self> {
        let find = |document: &Document, id| document.index_of(id);
        Some(match self {
            Self::Journal(id, journal) => {
                let at = find(document, id)?;
                let mesh = Arc::make_mut(&mut document.objects.get_mut(at)?.named.mesh);
                let vertices = mesh.vertex_count();
                let back = mesh.undo(journal);
                let touched = back.touched();
                if is_reshaping(&touched) || mesh.vertex_count() != vertices {
                    reshaped(id);
                }
                changes.touched(id, mesh, touched);
                Self::Journal(id, back)
            }
            Self::Mesh(id, mesh) => {
                let at = find(document, id)?;
                let old = std::mem::replace(&mut document.objects.get_mut(at)?.named.mesh, mesh);
                changes.everything(id);
                reshaped(id);
                Self::Mesh(id, old)
            }
            Self::Bezier(id, bezier) => {
                let at = find(document, id)?;
                let old = std::mem::replace(&mut document.objects.get_mut(at)?.named.bezier, bezier);
                changes.controls(id);
                Self::Bezier(id, old)
            }
            Self::Soup(id, soup) => {
                let at = find(document, id)?;
                changes.document = true;
                Self::Soup(id, std::mem::replace(&mut document.objects.get_mut(at)?.named.soup, soup))
            }
            Self::Offset(offset) => {
                changes.document = true;
                Self::Offset(std::mem::replace(&mut document.offset, offset))
            }
            Self::Materials(materials) => {
                (changes.document, changes.materials) = (true, true);
                Self::Materials(std::mem::replace(&mut document.materials, materials))
            }
            Self::Name(id, name) => {
                let at = find(document, id)?;
                changes.document = true;
                Self::Name(id, std::mem::replace(&mut document.objects.get_mut(at)?.named.name, name))
            }
            Self::Visible(id, visible) => {
                let at = find(document, id)?;
                changes.document = true;
                Self::Visible(id, std::mem::replace(&mut document.objects.get_mut(at)?.visible, visible))
            }
            Self::Hidden(id, hidden) => {
                let at = find(document, id)?;
                let old = std::mem::replace(&mut document.objects.get_mut(at)?.hidden, hidden.clone());
                let mut changed = (*old).clone();
                changed.toggle_with(&hidden);
                changes.hid(id, changed);
                Self::Hidden(id, old)
            }
            Self::NamedSelections(id, named) => {
                let at = find(document, id)?;
                changes.document = true;
                let object = document.objects.get_mut(at)?;
                Self::NamedSelections(id, std::mem::replace(&mut object.named_selections, named))
            }
            Self::Active(at) => {
                changes.document = true;
                Self::Active(std::mem::replace(&mut document.active, at))
            }
            Self::Insert(at, object) => {
                if at > document.objects.len() {
                    return None;
                }
                changes.added(&object);
                document.objects.insert(at, *object);
                Self::Remove(at)
            }
            Self::Remove(at) => {
                if at >= document.objects.len() {
                    return None;
                }
                let object = document.objects.remove(at);
                changes.gone(&object);
                reshaped(object.id());
                Self::Insert(at, Box::new(object))
            }
            Self::DocumentName(name) => {
                changes.document = true;
                Self::DocumentName(std::mem::replace(&mut document.name, name))
            }
            Self::Origin(origin) => Self::Origin(std::mem::replace(&mut document.origin, origin)),
        })
    }

    /// The only object that the change affects, if it is identified by id: such a change still fits after changes to
    /// other objects.
    pub fn object(&self) -> Option<ObjectId> {
        match self {
            Self::Journal(id, _)
            | Self::Mesh(id, _)
            | Self::Bezier(id, _)
            | Self::Soup(id, _)
            | Self::Name(id, _)
            | Self::Visible(id, _)
            | Self::Hidden(id, _)
            | Self::NamedSelections(id, _) => Some(*id),
            _ => None,
        }
    }

    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>()
            + match self {
                Self::Journal(_, journal) => journal.bytes(),
                Self::Mesh(_, mesh) => mesh.bytes(),
                Self::Bezier(_, bezier) => bezier.as_ref().map_or(0, |bezier| bezier.bytes()),
                Self::Soup(_, soup) => soup.as_ref().map_or(0, |soup| soup_bytes(soup)),
                Self::Materials(materials) => materials.bytes(),
                Self::Hidden(_, hidden) => hidden.bytes(),
                Self::NamedSelections(_, named) => named_bytes(named),
                Self::Insert(_, object) => {
                    object.mesh().bytes()
                        + object.bezier().map_or(0, |bezier| bezier.bytes())
                        + object.named.soup.as_ref().map_or(0, |soup| soup_bytes(soup))
                        + object.hidden.bytes()
                        + named_bytes(&object.named_selections)
                }
                _ => 0,
            }
    }
}

fn named_bytes(named: &[NamedSelection]) -> usize {
    named.iter().map(|named| size_of::<NamedSelection>() + named.name.len() + named.selection.bytes()).sum()
}

/// The approximate memory of a soup in bytes, without its attributes.
fn soup_bytes(soup: &PolygonSoup) -> usize {
    soup.positions.len() * 12 + (soup.corners.len() + soup.face_starts.len()) * 4
}

/// Whether an edit that touched these elements may have changed connectivity, not only positions and
/// attributes.
pub(crate) fn is_reshaping(touched: &Touched) -> bool {
    touched.everything || !touched.halfedges.is_empty()
}
