//! Smoothing the positions of vertices.

use crate::error::{SurfaceError, require};
use crate::pace::Pace;
use glam::DVec3;
use halfedge::{Element, Mesh, NumberRange, Progress, VertexId, keys};

/// The numbers of iterations of [`smooth`].
pub const SMOOTH_ITERATIONS_RANGE: NumberRange = NumberRange::counts(1, 10_000);

/// The strengths of [`smooth`].
pub const SMOOTH_STRENGTH_RANGE: NumberRange = NumberRange::new(0.0, 1.0);

/// How to smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smooth {
    /// The number of iterations, in [`SMOOTH_ITERATIONS_RANGE`].
    pub iterations: u32,
    /// How far a vertex moves towards the mean of its neighbours in an iteration: from 0, which moves nothing, to 1.
    pub strength: f64,
    /// The method of an iteration.
    pub method: SmoothMethod,
}

/// Smoothing methods.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SmoothMethod {
    /// Move vertices towards the mean of their neighbours. The mesh shrinks.
    #[default]
    Laplacian,
    /// Likewise, followed by a slightly longer step back (Taubin 1995, pass band 0.1), which nearly keeps the
    /// volume.
    Taubin,
}

/// The frequency below which Taubin's steps keep a shape.
const TAUBIN_PASS_BAND: f64 = 0.1;

/// Smooths a mesh. Boundary vertices move towards their two neighbours on the boundary, so that boundaries are
/// smoothed as curves; isolated vertices stay. Ids (after closing gaps) and attributes are kept, except for
/// corner normals, which no longer fit. Costs O(iterations x mesh).
///
/// # Errors
/// [`SurfaceError::BadField`]; [`SurfaceError::Cancelled`].
pub fn smooth(mesh: &Mesh, options: &Smooth, progress: &mut Progress<'_>) -> Result<Mesh, SurfaceError> {
    require("strength", options.strength, SMOOTH_STRENGTH_RANGE)?;
    require("iterations", options.iterations.into(), SMOOTH_ITERATIONS_RANGE)?;
    if options.strength == 0.0 {
        return Ok(mesh.clone());
    }
    let mut pace = Pace::new(progress);
    pace.at(0.0)?;
    let compact = mesh.to_compact().into_owned();
    let mut now: Vec<DVec3> = compact.positions().iter().map(|p| p.as_dvec3()).collect();
    let mut later = now.clone();
    let back = 1.0 / (TAUBIN_PASS_BAND - 1.0 / options.strength);
    let steps: &[f64] = match options.method {
        SmoothMethod::Laplacian => &[options.strength],
        SmoothMethod::Taubin => &[options.strength, back],
    };
    for iteration in 0..options.iterations {
        let mut part = pace.part(
            iteration as f32 / options.iterations as f32,
            (iteration + 1) as f32 / options.iterations as f32,
        );
        for &step in steps {
            part.chunks(now.len(), |range| {
                for v in range {
                    later[v] = now[v] + (mean_of_neighbors(&compact, &now, v) - now[v]) * step;
                }
            })?;
            std::mem::swap(&mut now, &mut later);
        }
    }
    let mut raw = compact.into_raw();
    // Where nothing moved, positions stay as they were to the bit.
    for (position, moved) in raw.positions.iter_mut().zip(now) {
        *position = moved.as_vec3();
    }
    raw.columns.of_mut(Element::Halfedge).retain(|column| column.name != keys::CORNER_NORMAL.name);
    pace.at(1.0)?;
    Ok(Mesh::from_raw(raw))
}

fn mean_of_neighbors(mesh: &Mesh, positions: &[DVec3], v: usize) -> DVec3 {
    let at = |v: VertexId| positions[v.index()];
    let Some(first) = mesh.halfedge_from(VertexId::new(v)) else { return positions[v] };
    if mesh.is_boundary_halfedge(first) {
        return (at(mesh.to(first)) + at(mesh.from(mesh.prev(first)))) * 0.5;
    }
    let (sum, count) =
        mesh.neighbors(VertexId::new(v)).fold((DVec3::ZERO, 0u32), |(sum, n), w| (sum + at(w), n + 1));
    sum / f64::from(count.max(1))
}
