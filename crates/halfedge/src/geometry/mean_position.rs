//! The mean of vertices' positions.

use crate::{Mesh, VertexId};
use glam::DVec3;

/// The mean of some vertices' positions, in 64 bits so that many positions can be summed; zero for none. Costs
/// O(vertices).
pub fn mean_position(mesh: &Mesh, vertices: impl IntoIterator<Item = VertexId>) -> DVec3 {
    let (mut sum, mut count) = (DVec3::ZERO, 0.0);
    for v in vertices {
        sum += mesh.position(v).as_dvec3();
        count += 1.0;
    }
    if count == 0.0 { DVec3::ZERO } else { sum / count }
}
