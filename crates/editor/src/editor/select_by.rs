//! Selections that follow from the current one, or from the element under the pointer.

use super::Editor;
use crate::error::{CommandError, Problem};
use crate::ops::{Relation, SelectMode};
use crate::selection::Selection;
use halfedge::geometry::BitSet;
use halfedge::{Element, FaceId, HalfedgeId, Mesh};
use surface::selecting::{self, Finding, Line};

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

impl From<Relation> for SelectBy {
    fn from(relation: Relation) -> Self {
        match relation {
            Relation::Grow => Self::Grow,
            Relation::Shrink => Self::Shrink,
            Relation::Linked => Self::Linked,
            Relation::Loops => Self::Loops,
            Relation::Rings => Self::Rings,
            Relation::Path => Self::Path,
            Relation::Outline => Self::Outline,
            Relation::Vertices => Self::Kind(Element::Vertex),
            Relation::Edges => Self::Kind(Element::Edge),
            Relation::Halfedges => Self::Kind(Element::Halfedge),
            Relation::Faces => Self::Kind(Element::Face),
            Relation::TouchingEdges => Self::Touching(Element::Edge),
            Relation::TouchingHalfedges => Self::Touching(Element::Halfedge),
            Relation::TouchingFaces => Self::Touching(Element::Face),
        }
    }
}

impl Editor {
    /// Whether [`Editor::select_by`] would succeed.
    ///
    /// # Errors
    /// Why not, and what to select first. Finding that out costs O(selection x valence) at most.
    pub fn can_select_by(&self, by: SelectBy) -> Result<(), CommandError> {
        let mesh = self.mesh().filter(|_| !self.selection.is_empty());
        let problem = match mesh {
            None => Some(refused("Select something first.")),
            Some(_) => check(&self.selection, by).err(),
        };
        problem.map_or(Ok(()), |problem| Err(CommandError::of("select", problem)))
    }

    /// Changes the selection by what is selected, at once. Costs O(elements of the result x valence).
    ///
    /// # Errors
    /// The selection isn't suited: the error says what to select first. It is unchanged then.
    pub fn select_by(&mut self, by: SelectBy) -> Result<(), CommandError> {
        self.begin_select_by(by)?;
        self.finish_selecting();
        Ok(())
    }

    /// Changes the selection by what is selected: at once, or if that may take long with [`Editor::select_some`].
    ///
    /// # Errors
    /// As [`Editor::select_by`].
    pub fn begin_select_by(&mut self, by: SelectBy) -> Result<(), CommandError> {
        self.end_edit();
        let refused = |problem| CommandError::of("select", problem);
        let Some(object) = self.document.active() else {
            return self.can_select_by(by);
        };
        let find = find_related(object.mesh(), &self.selection, by).map_err(refused)?;
        self.start_or_finish(find.shown(object.hidden()));
        Ok(())
    }

    /// Converts the selection to another kind: to what it contains, or to all that `touches` it. An empty selection stays
    /// empty, which is no step.
    pub fn switch_kind(&mut self, kind: Element, touches: bool) {
        self.end_edit();
        if self.selection.is_empty() {
            self.replace_selection(Selection::new(kind));
            self.log_selection(true);
        } else {
            // Refused only where the selection is of this kind already.
            let _ =
                self.begin_select_by(if touches { SelectBy::Touching(kind) } else { SelectBy::Kind(kind) });
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
        let mut ids = path(mesh, kind, from, to).map_err(|problem| CommandError::of("select", problem))?;
        // The element last in the list counts as selected last.
        ids.retain(|&id| id != to);
        ids.push(to);
        self.select(kind, ids, SelectMode::Extend)
    }
}

/// How to find what follows from a selection.
pub(crate) fn find_related(mesh: &Mesh, selection: &Selection, by: SelectBy) -> Result<Finding, Problem> {
    check(selection, by)?;
    let (kind, chosen) = (selection.kind(), selection.set().clone());
    Ok(match by {
        SelectBy::Grow => Finding::grow(kind, chosen),
        SelectBy::Shrink => Finding::shrink(kind, chosen),
        SelectBy::Linked => Finding::linked(kind, chosen),
        SelectBy::Loops => Finding::known(kind, lines(mesh, kind, &chosen, Line::Loop)?),
        SelectBy::Rings => Finding::known(kind, lines(mesh, kind, &chosen, Line::Ring)?),
        SelectBy::Kind(to) => Finding::convert(kind, to, chosen),
        SelectBy::Touching(to) => Finding::expand(kind, to, chosen),
        SelectBy::Outline => Finding::outline(chosen),
        SelectBy::Path => {
            let ends: Vec<u32> = selection.ids().collect();
            let [from, to] = *ends.as_slice() else {
                return Err(refused("Select the two ends of the path first."));
            };
            Finding::known(kind, path(mesh, kind, from, to)?.into_iter().map(|id| id as usize).collect())
        }
    })
}

/// What is known of a selection that isn't suited without looking at the mesh.
fn check(selection: &Selection, by: SelectBy) -> Result<(), Problem> {
    let (kind, count) = (selection.kind(), selection.len());
    match by {
        _ if count == 0 => Err(refused("Select something first.")),
        SelectBy::Kind(to) | SelectBy::Touching(to) if kind == to => {
            Err(refused(format!("The selection consists of {} already.", kind.plural())))
        }
        SelectBy::Outline if kind != Element::Face => Err(refused("Select faces first.")),
        SelectBy::Path if count != 2 => Err(refused("Select the two ends of the path first.")),
        SelectBy::Loops | SelectBy::Rings
            if count == 1 && matches!(kind, Element::Vertex | Element::Face) =>
        {
            Err(refused(format!("Select two neighbouring {} first: they give the direction.", kind.plural())))
        }
        _ => Ok(()),
    }
}

fn refused(text: impl Into<String>) -> Problem {
    Problem::new(text)
}

fn lines(mesh: &Mesh, kind: Element, chosen: &BitSet, line: Line) -> Result<BitSet, Problem> {
    let through = selecting::directions(mesh, kind, chosen);
    if through.is_empty() {
        let text =
            format!("No two of the selected {} are neighbours, which gives the direction.", kind.plural());
        return Err(refused(text));
    }
    let mut found = selecting::lines(mesh, kind, &through, line);
    chosen.iter().for_each(|id| {
        found.insert(id);
    });
    Ok(found)
}

fn path(mesh: &Mesh, kind: Element, from: u32, to: u32) -> Result<Vec<u32>, Problem> {
    selecting::shortest_path(mesh, kind, from, to).ok_or_else(|| {
        let text = format!("No path leads from {kind} {from} to {kind} {to}: they are in different pieces.");
        refused(text)
    })
}
