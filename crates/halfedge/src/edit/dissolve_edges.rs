//! Dissolve edges: the faces beside them become one.
//!
//! Faces that the edges join form regions, and each becomes one polygon: its outline. The outline is one
//! loop, and its corners differ, exactly where the region is a disc. Edges inside a region go too, given or
//! not, as do the vertices that only such edges have: two faces that share several edges in a row lose the
//! whole row. Faces that meet along edges apart would become a ring that touches itself and are refused, as
//! are faces with nothing round them.
//!
//! A dissolved edge leaves its ends with an edge less. Those that are left with two edges only bend an
//! outline: they are dissolved too, unless they are to be kept or a face would be left with two corners.
//! How many edges a vertex is left with counts when all the given ones have gone; if it counted after each,
//! one edge could become one with another that isn't given, and stay.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::outline;
use crate::edit::{Made, Refusal, can_dissolve_vertex, dissolve_vertex};
use crate::geometry::UnionFind;
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// Whether [`dissolve_edges`] would succeed; it does or doesn't whether vertices are kept or not.
pub fn can_dissolve_edges(mesh: &Mesh, edges: &[EdgeId]) -> Result<(), Refusal> {
    plan_dissolve(mesh, edges).map(drop)
}

/// Faces that become one, and the one whose id stays.
struct Region {
    faces: FxHashSet<FaceId>,
    stays: FaceId,
}

/// The regions of faces that edges join. The face that stays is found edge by edge: of the two that an edge
/// has made one so far, the one of its even half-edge.
fn regions(mesh: &Mesh, edges: &[EdgeId]) -> Result<Vec<Region>, Refusal> {
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
    // By the number of each set.
    let mut stays = faces.clone();
    for [left, right] in pairs {
        let face = stays[sets.find(left) as usize];
        sets.union(left, right);
        stays[sets.find(left) as usize] = face;
    }
    let mut regions: FxHashMap<u32, Region> = FxHashMap::default();
    let mut order = Vec::new();
    for (i, &face) in faces.iter().enumerate() {
        let set = sets.find(i as u32);
        let region = regions.entry(set).or_insert_with(|| {
            order.push(set);
            Region { faces: FxHashSet::default(), stays: stays[set as usize] }
        });
        region.faces.insert(face);
    }
    Ok(order.into_iter().filter_map(|set| regions.remove(&set)).collect())
}

fn plan_dissolve(mesh: &Mesh, edges: &[EdgeId]) -> Result<Plan, Refusal> {
    mesh.require_edges(edges)?;
    let mut patch = Patch::new(mesh);
    for region in regions(mesh, edges)? {
        let corners = outline(mesh, &region.faces)?.into_iter().map(|h| Corner::keep(mesh, h)).collect();
        patch.remove.extend(region.faces.iter().filter(|&&face| face != region.stays));
        patch.replace_face(region.stays, corners);
    }
    patch.plan(mesh)
}

/// Makes the faces that edges join one polygon each, and removes the vertices that are left with two edges
/// unless `keep_vertices`; see the module's text for which. Edges on either side of such a vertex become
/// one.
///
/// Costs O(degrees of the faces + valences of their corners). Attributes: the polygon keeps those of the
/// face whose id it keeps, that of the even half-edge; corners keep theirs. Across a seam the polygon has
/// values of both sides. Of edges that become one the sharper crease stays.
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
