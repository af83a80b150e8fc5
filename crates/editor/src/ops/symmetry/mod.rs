//! Symmetry: an edit with a mirror acts on what lies at the mirror images of its elements too.
//!
//! One place does this for every operation on elements. A list of elements gets the images added, so that both sides are one
//! edit; an operation on one or two elements gets a second one for the images. Operations that only move vertices move
//! the images as in a mirror. Afterwards, positions that differ from mirror images by rounding alone are made exact, so that
//! what was symmetric to the bit stays so. Where a symmetric mesh would not stay symmetric, the edit is refused.

mod images;
mod moves;
mod outcome;

pub(crate) use images::Reflection;

use super::choice::choice;
use super::{Action, Field, Op};
use crate::error::Problem;
use halfedge::words::counted;
use halfedge::{Mesh, Progress};
use images::{Images, mirror};
use surface::MirrorImages;

choice! {
    /// Whether an edit is mirrored across the plane through the origin that an axis is normal to.
    pub enum Symmetry {
        /// It is not.
        None = "none" "None",
        /// Across the plane x = 0.
        X = "x" "Along x",
        /// Across the plane y = 0.
        Y = "y" "Along y",
        /// Across the plane z = 0.
        Z = "z" "Along z",
    }
}

/// The name of the field in JSON. It belongs to the command, not to the operation.
pub(crate) const FIELD_NAME: &str = "symmetry";

/// The names of axes in messages.
const AXIS_NAMES: [&str; 3] = ["x", "y", "z"];

/// The field of operations that can be mirrored.
pub(crate) const SYMMETRY: Field = Symmetry::field(
    FIELD_NAME,
    "Mirror the edit across the plane through the origin that this axis is normal to",
);

impl Field {
    /// Whether it is the symmetry, which belongs to the command and which the page has a setting for.
    pub fn is_symmetry(&self) -> bool {
        self.name == FIELD_NAME
    }
}

impl Symmetry {
    /// The number of the axis; none without symmetry.
    pub fn axis(self) -> Option<usize> {
        match self {
            Self::None => None,
            Self::X => Some(0),
            Self::Y => Some(1),
            Self::Z => Some(2),
        }
    }
}

/// How an operation with lists of elements is mirrored.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Mirroring {
    /// Both sides are one edit: lists get the images added.
    Together,
    /// The images are an edit of their own, unless they overlap.
    Apart,
    /// It only moves vertices: their images move as in a mirror.
    Moves,
}

/// Makes local edits with their mirror images. `images` are those of this mesh and may already know some.
pub(crate) fn edit_symmetric(
    ops: &[Op],
    images: &mut MirrorImages,
    mesh: &mut Mesh,
    notes: &mut Vec<String>,
    progress: &mut Progress<'_>,
) -> Result<(), Problem> {
    let Images { own, others, alone } = mirror(ops.to_vec(), mesh, images);
    let made_from = mesh.vertex_capacity();
    let mut left_out = None;
    if ops.first().is_some_and(|op| op.mirroring() == Mirroring::Moves) {
        let ops: Vec<Op> = own.into_iter().map(|(op, _)| op).collect();
        moves::edit(&ops, &others, images, mesh, notes, progress)?;
    } else {
        let count = own.len() + others.len();
        for (at, (op, count_own)) in own.iter().enumerate() {
            if progress(at as f32 / count as f32).is_break() {
                return Err(Problem::cancelled());
            }
            let Action::Local(edit) = op.action() else { continue };
            if at == 0 || !edit.is_moot(mesh) {
                edit.edit_mirrored(mesh, &Mirror { images, own: *count_own }, notes)?;
            }
        }
        for (at, op) in others.iter().enumerate() {
            if progress((own.len() + at) as f32 / count as f32).is_break() {
                return Err(Problem::cancelled());
            }
            let Action::Local(edit) = op.action() else { continue };
            if edit.is_moot(mesh) {
                continue;
            }
            match edit.can(mesh) {
                Ok(()) => edit.edit(mesh, notes)?,
                Err(problem) => drop(left_out.get_or_insert(problem)),
            }
        }
        outcome::settle(images, mesh, made_from, alone, left_out.as_ref())?;
    }
    if alone > 0 {
        let elements = counted(alone, "element has", "elements have");
        let axis = AXIS_NAMES.get(images.axis()).copied().unwrap_or_default();
        notes.push(format!("{elements} no mirror image along {axis} and changed alone"));
    }
    if let Some(problem) = left_out {
        notes.push(format!("The mirror image of an edit was left out: {}", problem.text));
    }
    Ok(())
}

/// What an edit of elements on both sides knows of the mirror.
pub(crate) struct Mirror<'a> {
    /// The images of the elements' vertices.
    pub images: &'a MirrorImages,
    /// How many elements at the start of the list were given; the others are their images.
    pub own: usize,
}
