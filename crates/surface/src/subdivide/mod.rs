//! Catmull-Clark, Loop and linear subdivision, each giving a new mesh.
//!
//! The size of a level is known beforehand, and each child's id follows from its parent's by a formula (see
//! [`quads`] and [`triangles`]). A level therefore takes a few passes that fill flat arrays, without an edge
//! map or an allocation per element.

mod carry;
mod catmull_clark;
mod descendants;
mod halves;
mod linear;
mod loops;
mod quads;
mod sharpness;
mod triangles;

pub use carry::Split;
pub use catmull_clark::{CatmullClark, VertexRule, subdivide_catmull_clark};
pub use descendants::{compact_ids, descendants};
pub use linear::{Linear, subdivide_linear};
pub use loops::{Loop, LoopWeights, subdivide_loop};

use crate::SurfaceError;
use crate::pace::Pace;
use glam::Vec3;
use halfedge::attribute::Columns;
use halfedge::{Connectivity, Mesh, NONE, NumberRange, Progress, RawMesh};
use sharpness::Sharpness;

/// The most faces that a subdivision may make. A mesh of that many quads takes 1.4 GB, which together with its
/// input fits in a browser tab.
pub const MAX_SUBDIVIDED_FACES: u64 = 16_000_000;

/// The numbers of levels that change a mesh and fit: beyond the last, a single triangle makes too many faces.
pub const SUBDIVISION_LEVELS_RANGE: NumberRange = NumberRange::counts(1, 12);

/// The subdivision rule at the boundary of an open mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum BoundaryRule {
    /// The boundary becomes a smooth cubic curve, even where a vertex has only one face.
    #[default]
    EdgeOnly,
    /// Like `EdgeOnly`, but a boundary vertex with only one face stays where it is.
    EdgeAndCorner,
}

/// The input of a level.
#[derive(Clone, Copy)]
pub(crate) struct Level<'a> {
    pub links: Connectivity<'a>,
    pub positions: &'a [Vec3],
    pub columns: &'a Columns,
}

impl<'a> Level<'a> {
    fn of_raw(raw: &'a RawMesh) -> Self {
        Self { links: raw.connectivity(), positions: &raw.positions, columns: &raw.columns }
    }

    pub fn vertices(&self) -> usize {
        self.positions.len()
    }

    pub fn edges(&self) -> usize {
        self.links.to.len() / 2
    }

    pub fn faces(&self) -> usize {
        self.links.face_halfedge.len()
    }

    /// The number of the faces' corners: half-edges that aren't on the boundary.
    pub fn corners(&self) -> usize {
        self.links.face.len() - self.links.face.iter().filter(|&&f| f == NONE).count()
    }
}

/// Refuses levels that would make more than [`MAX_SUBDIVIDED_FACES`] faces; `first` is the number that the first level makes.
fn check_size(first: u64, levels: u32) -> Result<(), SurfaceError> {
    let faces = match levels {
        0 => return Ok(()),
        levels => first.saturating_mul(4u64.saturating_pow(levels - 1)),
    };
    if faces > MAX_SUBDIVIDED_FACES {
        return Err(SurfaceError::TooManyFaces { faces, limit: MAX_SUBDIVIDED_FACES });
    }
    Ok(())
}

/// The number of faces after `levels` of [`subdivide_catmull_clark`] or [`subdivide_linear`]; saturates.
pub fn quad_split_faces(mesh: &Mesh, levels: u32) -> u64 {
    if levels == 0 {
        return mesh.face_count() as u64;
    }
    let boundary = mesh
        .connectivity()
        .face
        .iter()
        .enumerate()
        .filter(|&(h, &f)| f == NONE && mesh.halfedge(h as u32).is_some());
    let corners = (mesh.halfedge_count() - boundary.count()) as u64;
    corners.saturating_mul(4u64.saturating_pow(levels - 1))
}

/// Runs `step` for each level on the compacted input. Creases are passed separately from the other columns.
fn refine(
    mesh: &Mesh,
    levels: u32,
    progress: &mut Progress<'_>,
    mut step: impl FnMut(&Level<'_>, &Sharpness, &mut Pace<'_, '_>) -> Result<RawMesh, SurfaceError>,
    child_sharpness: impl Fn(&Level<'_>, &Sharpness, &RawMesh) -> Sharpness,
) -> Result<Mesh, SurfaceError> {
    let mut pace = Pace::new(progress);
    pace.at(0.0)?;
    let mesh = mesh.to_compact();
    if levels == 0 {
        return Ok(mesh.into_owned());
    }
    let mut sharpness = Sharpness::of(&mesh);
    // Each level costs four times as much as the one before.
    let share = |level: u32| (4f32.powi(level as i32) - 1.0) / (4f32.powi(levels as i32) - 1.0);
    let mut made: Option<RawMesh> = None;
    for level in 0..levels {
        let mut part = pace.part(share(level), share(level + 1));
        let input = match &made {
            None => {
                Level { links: mesh.connectivity(), positions: mesh.positions(), columns: mesh.columns() }
            }
            Some(raw) => Level::of_raw(raw),
        };
        let child = step(&input, &sharpness, &mut part)?;
        sharpness = child_sharpness(&input, &sharpness, &child);
        made = Some(child);
    }
    let mut raw = made.unwrap_or_default();
    sharpness.into_columns(&mut raw);
    pace.at(1.0)?;
    Ok(Mesh::from_raw(raw))
}
