//! Simplification by edge collapses in order of their quadric error.
//!
//! Garland and Heckbert: Surface simplification using quadric error metrics (1997). Weights lie between areas,
//! which keep the mean distance small, and equal ones, which keep small spikes. Further planes keep boundaries
//! and attribute seams, and a faint pull towards the old vertices decides where the planes leave a direction
//! open. Each collapse is checked: the link condition (the result stays a manifold of the same topology), and
//! that no triangle turns over or becomes a sliver.

mod collapse_order;
mod deviation;
mod limit;
mod measurement;
mod quadric;
mod queue;
mod work;

use crate::error::{SurfaceError, require};
use crate::pace::Pace;
use crate::trimesh::TriMesh;
use halfedge::words::{counted, thousands};
use halfedge::{Element, Mesh, NumberRange, Progress};
use work::Work;

/// How far to simplify.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SimplifyTarget {
    /// To this number of triangles.
    Faces(usize),
    /// To this share of the triangles, above 0 and up to 1.
    Ratio(f64),
    /// As long as the surface stays within this distance of the input, in mesh units.
    ///
    /// Each collapse is checked in one of two ways. Bounds on the distances that collapses move the surface by, in
    /// both directions, are added up; while the sum is within the limit, that is a proof for every point. The sum
    /// exceeds the limit long before the surface does. From then on distances are measured and must be within
    /// 85 % of the limit. New triangles are quartered until a bound for all points of each part is within it: from
    /// the corners' distances to a single triangle of the input, from the part's size, or, for parts smaller than
    /// the input's triangles, from the angle between the triangles closest to its corners. The input's triangles
    /// are measured at their corners, their centroids and the middles of their sides; if there are few, at up to
    /// seven times as many points, so that points on large ones are closer together. What remains unproven is an
    /// input that bends more than once within a part of a new triangle that is smaller than its own triangles or
    /// than a 128th of the new triangle, and not at any of those points.
    MaxError(f64),
}

/// The shares of the triangles that can be kept.
pub const SIMPLIFY_RATIO_RANGE: NumberRange = NumberRange::above(0.0, 1.0);

/// Options of simplification.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simplify {
    /// How far to simplify.
    pub target: SimplifyTarget,
    /// Whether boundary vertices stay on the boundary curve, which is simplified separately; otherwise the boundary
    /// counts only as much as the surface does.
    pub preserve_boundary: bool,
    /// Whether vertices on seams of corner attributes, such as texture coordinates, stay on the seams; otherwise
    /// values on the two sides of a seam may no longer match.
    pub preserve_seams: bool,
}

/// A simplified mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Simplified {
    /// The triangles.
    pub mesh: Mesh,
    /// The number of triangles that was asked for, if one was.
    pub wanted: Option<usize>,
    /// Whether simplification stopped early and preserved seams of corner attributes.
    pub has_seams: bool,
}

impl Simplified {
    /// Says why the number of triangles differs from what was asked for, if it does.
    pub fn shortfall(&self) -> Option<String> {
        let (wanted, faces) = (self.wanted?, self.mesh.face_count());
        if faces == wanted {
            return None;
        }
        let closed = self.mesh.boundary_loops().is_empty();
        let made = counted(faces, "triangle", "triangles");
        let is_odd = wanted % 2 == 1;
        let is_one_more = faces.checked_sub(1) == Some(wanted);
        let is_less = faces < wanted;
        let wanted = thousands(wanted);
        Some(if is_one_more && closed && is_odd {
            format!("{made}, not {wanted}: a closed mesh has an even number of them")
        } else if is_less {
            format!("the mesh has only {made}")
        } else {
            let seam =
                if self.has_seams { "break a seam of the texture coordinates or normals, " } else { "" };
            format!(
                "stopped at {made}, not {wanted}: any further collapse would {seam}turn over or \
                 flatten a triangle, close a hole or glue faces together"
            )
        })
    }
}

/// Simplifies a mesh. Polygons are cut into triangles first; isolated vertices are dropped. Remaining triangles
/// keep their face attributes; corner and vertex attributes are interpolated where vertices merge. Costs at most
/// O(n log n).
///
/// # Errors
/// [`SurfaceError::BadField`] for a target out of range; [`SurfaceError::Cancelled`].
pub fn simplify(
    mesh: &Mesh,
    options: &Simplify,
    progress: &mut Progress<'_>,
) -> Result<Simplified, SurfaceError> {
    let mut pace = Pace::new(progress);
    match options.target {
        SimplifyTarget::Ratio(ratio) => require("ratio", ratio, SIMPLIFY_RATIO_RANGE)?,
        SimplifyTarget::MaxError(error) => require("max_error", error, NumberRange::NOT_NEGATIVE)?,
        SimplifyTarget::Faces(_) => {}
    }
    pace.at(0.0)?;
    let mut tri = TriMesh::new(mesh);
    if mesh.columns().of(Element::Face).is_empty() {
        tri.face_source = Vec::new();
    }
    let before = tri.faces;
    let wanted = match options.target {
        SimplifyTarget::Faces(faces) => Some(faces),
        SimplifyTarget::Ratio(ratio) => Some((before as f64 * ratio).round() as usize),
        SimplifyTarget::MaxError(_) => None,
    };
    let mut work = Work::new(mesh, tri, options);
    pace.at(0.05)?;
    collapse_order::collapse_to_face_count(&mut work, wanted.unwrap_or(0), &mut pace.part(0.1, 0.95))?;
    let tri = work.finish();
    let has_seams = options.preserve_seams
        && wanted.is_some_and(|wanted| tri.faces > wanted)
        && (0..tri.v.len() as u32).any(|h| tri.is_alive(h) && tri.is_seam(h));
    let mesh = tri.into_mesh(mesh);
    pace.at(1.0)?;
    Ok(Simplified { mesh, wanted, has_seams })
}
