//! Dissolve around vertices: the faces that become one when many vertices are dissolved, merged at once.
//!
//! Dissolving vertices one by one makes a polygon that grows with each, and each costs as much as the polygon is long. This
//! finds out first which faces come together, and merges them in one step. What is left of the vertices lies on outlines:
//! [`dissolve_vertex`](super::dissolve_vertex) removes those.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::outline;
use crate::edit::{Made, Refusal};
use crate::geometry::UnionFind;
use crate::mesh::Mesh;
use crate::{FaceId, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// Whether [`dissolve_around`] would succeed.
pub fn can_dissolve_around(mesh: &Mesh, vertices: &[VertexId]) -> Result<(), Refusal> {
    plan_dissolve(mesh, vertices).map(drop)
}

/// The sets of faces that become one, several faces each, when these vertices are dissolved in this order.
fn find_regions(mesh: &Mesh, vertices: &[VertexId]) -> Vec<FxHashSet<FaceId>> {
    let mut numbers: FxHashMap<FaceId, u32> = FxHashMap::default();
    let mut faces: Vec<FaceId> = Vec::new();
    for face in vertices.iter().flat_map(|&v| mesh.vertex_faces(v)) {
        numbers.entry(face).or_insert_with(|| {
            faces.push(face);
            faces.len() as u32 - 1
        });
    }
    let mut sets = UnionFind::new(faces.len());
    for &v in vertices {
        let mut round: Vec<u32> =
            mesh.vertex_faces(v).filter_map(|face| numbers.get(&face)).map(|&n| sets.find(n)).collect();
        round.sort_unstable();
        round.dedup();
        // A vertex between two faces inside the mesh is removed from both, which stay apart.
        if round.len() > 2 || mesh.is_boundary_vertex(v) {
            round.windows(2).for_each(|pair| {
                sets.union(pair[0], pair[1]);
            });
        }
    }
    let mut regions: FxHashMap<u32, usize> = FxHashMap::default();
    let mut list: Vec<FxHashSet<FaceId>> = Vec::new();
    for (number, &face) in (0u32..).zip(&faces) {
        let at = *regions.entry(sets.find(number)).or_insert_with(|| {
            list.push(FxHashSet::default());
            list.len() - 1
        });
        list[at].insert(face);
    }
    list.retain(|faces| faces.len() > 1);
    list
}

fn plan_dissolve(mesh: &Mesh, vertices: &[VertexId]) -> Result<Plan, Refusal> {
    vertices.iter().try_for_each(|&v| mesh.require_vertex(v).map(drop))?;
    let mut patch = Patch::new(mesh);
    for faces in find_regions(mesh, vertices) {
        let corners = outline(mesh, &faces)?.into_iter().map(|h| Corner::keep(mesh, h)).collect();
        let Some(&keep) = faces.iter().min() else { continue };
        patch.remove.extend(faces.iter().copied().filter(|&face| face != keep));
        patch.replace_face(keep, corners);
    }
    patch.plan(mesh)
}

/// Merges the faces that become one when these vertices are dissolved in this order; each keeps the smallest id. Vertices
/// whose edges all lie inside such a polygon are removed; those on its outline stay.
///
/// Costs O(degrees of the faces + valences of their corners), however many vertices there are. Attributes: as for
/// [`dissolve_vertex`](super::dissolve_vertex).
///
/// # Errors
/// Faces that come together are no disc, or an element doesn't exist.
pub fn dissolve_around(mesh: &mut Mesh, vertices: &[VertexId]) -> Result<Made, Refusal> {
    Ok(plan_dissolve(mesh, vertices)?.apply(mesh))
}
