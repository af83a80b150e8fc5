//! The ring of quads that a loop cut at the pointer would cut.

use glam::Vec3;
use halfedge::Mesh;
use halfedge::edit::edge_ring;

/// More lines than this are not drawn: they would lie closer than a pixel.
const MAX_LINES: usize = 20_000;

/// A loop cut through the ring of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RingCut {
    /// The id of the edge.
    pub edge: u32,
    /// The number of cuts.
    pub cuts: u32,
}

/// The state of the tool that cuts the ring of quads under the pointer.
#[derive(Clone, Debug)]
pub(crate) struct RingTool {
    /// The number of cuts that a click makes.
    pub cuts: u32,
    /// The number of cuts as typed so far; 0 if nothing is typed.
    pub typed: u32,
    /// Where the cuts would be.
    pub shown: ShownRing,
}

impl Default for RingTool {
    fn default() -> Self {
        Self { cuts: 1, typed: 0, shown: ShownRing::default() }
    }
}

/// The cuts that a click would make.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ShownRing {
    pub cut: Option<RingCut>,
    pub lines: Vec<[Vec3; 2]>,
}

/// The lines of a cut, quad by quad.
pub(crate) fn lines(mesh: &Mesh, cut: RingCut) -> Option<Vec<[Vec3; 2]>> {
    let (ring, closed) = edge_ring(mesh, mesh.edge(cut.edge)?);
    let ends = ring.iter().map(|h| [mesh.from(*h), mesh.to(*h)].map(|v| mesh.position(v)));
    let ends: Vec<[Vec3; 2]> = ends.collect();
    let next = ends.iter().cycle().skip(1);
    let quads = ends.iter().zip(next).take(if closed { ends.len() } else { ends.len().saturating_sub(1) });
    let fractions = (1..=cut.cuts).map(move |at| at as f32 / (cut.cuts + 1) as f32);
    let lines = quads.flat_map(move |(here, there)| {
        fractions.clone().map(move |t| [here, there].map(|[from, to]| from.lerp(*to, t)))
    });
    Some(lines.take(MAX_LINES).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfedge::EdgeId;

    #[test]
    fn a_ring_around_a_cube_is_closed_and_cut_at_even_distances() {
        let mesh = surface::Shape::named("cube").expect("a shape").build().expect("a cube");
        let edge: EdgeId = mesh.edges().next().expect("an edge");
        let lines = lines(&mesh, RingCut { edge: edge.raw(), cuts: 3 }).expect("lines");
        assert_eq!(lines.len(), 4 * 3);
        let length = mesh.ends(edge).map(|v| mesh.position(v));
        let length = length[0].distance(length[1]);
        assert!((lines[0][0].distance(lines[1][0]) - length / 4.0).abs() < 1e-6);
    }
}
