//! Selections that follow from the current one, or from the element under the pointer.

use super::{Editor, SelectMode};
use crate::error::{CommandError, Problem};
use crate::selection::Selection;
use halfedge::geometry::BitSet;
use halfedge::{Element, FaceId, HalfedgeId, Mesh};
use surface::selecting::{self, Line};

/// A way to get a selection from the current one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SelectBy {
    /// Adds the neighbours.
    Grow,
    /// Removes the elements beside unselected ones.
    Shrink,
    /// Adds everything in the same connected pieces.
    Linked,
    /// Adds the loops that the selected elements lie on.
    Loops,
    /// Adds the rings that the selected elements lie on.
    Rings,
    /// Adds the shortest path between the two selected elements.
    Path,
    /// Selects the edges around the selected faces.
    Outline,
    /// Selects the elements of this kind that belong to the selection instead: those that it contains.
    Kind(Element),
    /// Selects the elements of this kind that have any of the selected ones instead.
    Touching(Element),
}

impl Editor {
    /// Whether [`Editor::select_by`] would succeed.
    ///
    /// # Errors
    /// Why not, and what to select first. Finding that out costs O(selection x valence) at most.
    pub fn can_select_by(&self, by: SelectBy) -> Result<(), CommandError> {
        let refuse = |text: &str| Err(CommandError::refused("select", text));
        let selection = &self.selection;
        let (kind, count) = (selection.kind(), selection.len());
        if self.mesh().is_none() || selection.is_empty() {
            return refuse("Select something first.");
        }
        match by {
            SelectBy::Kind(to) | SelectBy::Touching(to) if kind == to => Err(CommandError::refused(
                "select",
                format!("The selection consists of {} already.", kind.plural()),
            )),
            SelectBy::Outline if kind != Element::Face => refuse("Select faces first."),
            SelectBy::Path if count != 2 => refuse("Select the two ends of the path first."),
            SelectBy::Loops | SelectBy::Rings
                if count == 1 && matches!(kind, Element::Vertex | Element::Face) =>
            {
                let text =
                    format!("Select two neighbouring {} first: they give the direction.", kind.plural());
                Err(CommandError::refused("select", text))
            }
            _ => Ok(()),
        }
    }

    /// Changes the selection by what is selected. Costs O(elements of the result x valence); linked elements cost
    /// O(mesh).
    ///
    /// # Errors
    /// The selection isn't suited: the error says what to select first. It is unchanged then.
    pub fn select_by(&mut self, by: SelectBy) -> Result<(), CommandError> {
        self.can_select_by(by)?;
        self.end_edit();
        let Some(mesh) = self.mesh() else { return Ok(()) };
        let kind = self.selection.kind();
        let chosen: BitSet = self.selection.ids().map(|id| id as usize).collect();
        let (kind, found) = match by {
            SelectBy::Grow => (kind, selecting::grow(mesh, kind, &chosen)),
            SelectBy::Shrink => (kind, selecting::shrink(mesh, kind, &chosen)),
            SelectBy::Linked => (kind, selecting::linked(mesh, kind, &chosen)),
            SelectBy::Loops => (kind, lines(mesh, kind, &chosen, Line::Loop)?),
            SelectBy::Rings => (kind, lines(mesh, kind, &chosen, Line::Ring)?),
            SelectBy::Kind(to) => (to, selecting::convert(mesh, kind, to, &chosen)),
            SelectBy::Touching(to) => (to, selecting::expand(mesh, kind, to, &chosen)),
            SelectBy::Outline => (Element::Edge, selecting::outline(mesh, &chosen)),
            SelectBy::Path => {
                let mut ends = self.selection.ids();
                let (Some(from), Some(to)) = (ends.next(), ends.next()) else { return Ok(()) };
                (kind, path(mesh, kind, from, to)?.into_iter().map(|id| id as usize).collect())
            }
        };
        self.set_selection(Selection::of_set(kind, found, self.selection.latest()));
        Ok(())
    }

    /// Converts the selection to another kind: to what it contains, or to all that `touches` it. An empty selection stays
    /// empty, which is no step.
    pub fn switch_kind(&mut self, kind: Element, touches: bool) {
        if self.selection.is_empty() {
            self.replace_selection(Selection::new(kind));
        } else {
            // Refused only where the selection is of this kind already.
            let _ = self.select_by(if touches { SelectBy::Touching(kind) } else { SelectBy::Kind(kind) });
        }
    }

    /// Selects the line of elements of a kind through a half-edge.
    ///
    /// # Errors
    /// The half-edge doesn't exist.
    pub fn select_line(
        &mut self,
        kind: Element,
        through: u32,
        line: Line,
        mode: SelectMode,
    ) -> Result<(), CommandError> {
        let Some(mesh) = self.mesh().filter(|mesh| mesh.exists(Element::Halfedge, through)) else {
            return Err(CommandError::of(
                "select",
                Problem::field("ids", format!("there is no half-edge {through}")),
            ));
        };
        let through = HalfedgeId::new(through as usize);
        let found = selecting::lines(mesh, kind, &[through], line);
        let mut ids: Vec<u32> = found.iter().map(|id| id as u32).collect();
        // The element last in the list counts as selected last: the one that was clicked.
        let clicked = match kind {
            Element::Vertex => Some(mesh.from(through).raw()),
            Element::Edge => Some(through.edge().raw()),
            Element::Halfedge => Some(through.raw()),
            Element::Face => mesh.face_of(through).map(FaceId::raw),
        };
        if let Some(at) = ids.iter().position(|id| Some(*id) == clicked) {
            let id = ids.remove(at);
            ids.push(id);
        }
        self.select(kind, ids, mode)
    }

    /// Extends the selection by the shortest path from the element selected last to this one; selects it alone if no
    /// element of the kind is selected.
    ///
    /// # Errors
    /// It doesn't exist, or no path leads there.
    pub fn select_path_to(&mut self, kind: Element, to: u32) -> Result<(), CommandError> {
        let from = if self.selection.kind() == kind { self.selection.latest() } else { None };
        let (Some(mesh), Some(from)) = (self.mesh(), from) else {
            return self.select(kind, [to], SelectMode::Replace);
        };
        let mut ids = path(mesh, kind, from, to)?;
        // The element last in the list counts as selected last.
        ids.retain(|&id| id != to);
        ids.push(to);
        self.select(kind, ids, SelectMode::Extend)
    }
}

fn lines(mesh: &Mesh, kind: Element, chosen: &BitSet, line: Line) -> Result<BitSet, CommandError> {
    let through = selecting::directions(mesh, kind, chosen);
    if through.is_empty() {
        let text =
            format!("No two of the selected {} are neighbours, which gives the direction.", kind.plural());
        return Err(CommandError::refused("select", text));
    }
    let mut found = selecting::lines(mesh, kind, &through, line);
    chosen.iter().for_each(|id| {
        found.insert(id);
    });
    Ok(found)
}

fn path(mesh: &Mesh, kind: Element, from: u32, to: u32) -> Result<Vec<u32>, CommandError> {
    selecting::shortest_path(mesh, kind, from, to).ok_or_else(|| {
        let text = format!("No path leads from {kind} {from} to {kind} {to}: they are in different pieces.");
        CommandError::refused("select", text)
    })
}
