//! Dissolve edges: the faces beside them become one.
//!
//! Faces joined by the given edges form regions, and each region becomes one polygon: its outline. The outline is one loop
//! with different corners exactly if the region is a disc. Other edges inside a region are removed too, and so are vertices
//! that only have edges inside: two faces that share several edges in a row lose the whole row. Faces that meet along
//! edges apart would become a ring that touches itself; they are refused, as are faces with nothing round them.
//!
//! The ends of a dissolved edge lose an edge. An end that is left with two edges only bends an outline, so it is dissolved
//! too, unless the caller keeps vertices or a face would be left with two corners. Edges are counted when all given ones
//! are gone. Counted earlier, a given edge could become one with another that isn't given, and survive.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::outline;
use crate::edit::{Made, Refusal, can_dissolve_vertex, dissolve_vertex};
use crate::geometry::UnionFind;
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// Whether [`dissolve_edges`] would succeed; keeping vertices makes no difference.
pub fn can_dissolve_edges(mesh: &Mesh, edges: &[EdgeId]) -> Result<(), Refusal> {
    plan_dissolve(mesh, edges).map(drop)
}

/// Faces that become one.
struct Region {
    faces: FxHashSet<FaceId>,
    /// The one whose id the polygon keeps.
    kept: FaceId,
}

/// The regions of faces joined by edges. Each edge decides which face is kept: the one kept so far on the side of its
/// even half-edge.
fn find_regions(mesh: &Mesh, edges: &[EdgeId]) -> Result<Vec<Region>, Refusal> {
    let mut numbers: FxHashMap<FaceId, u32> = FxHashMap::default();
    let mut faces: Vec<FaceId> = Vec::new();
    let mut pairs = Vec::with_capacity(edges.len());
    for &edge in edges {
        let [Some(left), Some(right)] = edge.halfedges().map(|h| mesh.face_of(h)) else {
            return Err(Refusal::BoundaryEdge(edge));
        };
        pairs.push([left, right].map(|face| {
            *numbers.entry(face).or_insert_with(|| {
                faces.push(face);
                faces.len() as u32 - 1
            })
        }));
    }
    let mut sets = UnionFind::new(faces.len());
    // By the number of the set.
    let mut kept = faces.clone();
    for [left, right] in pairs {
        let face = kept[sets.find(left) as usize];
        sets.union(left, right);
        kept[sets.find(left) as usize] = face;
    }
    let mut regions: FxHashMap<u32, Region> = FxHashMap::default();
    let mut order = Vec::new();
    for (i, &face) in faces.iter().enumerate() {
        let set = sets.find(i as u32);
        let region = regions.entry(set).or_insert_with(|| {
            order.push(set);
            Region { faces: FxHashSet::default(), kept: kept[set as usize] }
        });
        region.faces.insert(face);
    }
    Ok(order.into_iter().filter_map(|set| regions.remove(&set)).collect())
}

fn plan_dissolve(mesh: &Mesh, edges: &[EdgeId]) -> Result<Plan, Refusal> {
    mesh.require_edges(edges)?;
    let mut patch = Patch::new(mesh);
    for region in find_regions(mesh, edges)? {
        let corners = outline(mesh, &region.faces)?.into_iter().map(|h| Corner::keep(mesh, h)).collect();
        patch.remove.extend(region.faces.iter().filter(|&&face| face != region.kept));
        patch.replace_face(region.kept, corners);
    }
    patch.plan(mesh)
}

/// Makes the faces joined by edges one polygon each, and unless `keep_vertices` removes the vertices that are left with two
/// edges, which become one edge; see the module's text.
///
/// Costs O(degrees of the faces + valences of their corners). Attributes: the polygon keeps those of the face whose id it
/// keeps, the face of the even half-edge; corners keep theirs, so that across a seam the polygon has values of both sides.
/// Of edges that become one the sharper crease stays.
pub fn dissolve_edges(mesh: &mut Mesh, edges: &[EdgeId], keep_vertices: bool) -> Result<Made, Refusal> {
    let plan = plan_dissolve(mesh, edges)?;
    let mut ends: Vec<VertexId> = plan.made.removed_edges.iter().flat_map(|&edge| mesh.ends(edge)).collect();
    ends.sort_unstable();
    ends.dedup();
    let mut made = plan.apply(mesh);
    for v in ends {
        if !keep_vertices
            && mesh.has_vertex(v)
            && mesh.outgoing(v).take(3).count() == 2
            && can_dissolve_vertex(mesh, v).is_ok()
        {
            made.add(dissolve_vertex(mesh, v)?);
        }
    }
    Ok(made)
}
