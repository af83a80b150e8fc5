//! Soft selection: the vertices around selected ones, with weights that fall off with the distance.

use halfedge::{Mesh, VertexId};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// From so many vertices of a mesh on, one of this many, a distance is kept for every vertex: looking it up by number takes
/// longer.
const VERTICES_PER_LOOKED_UP: usize = 16;

/// The distances of vertices that were reached.
enum Distances {
    Few(FxHashMap<VertexId, f32>),
    /// By id; infinite where none was reached.
    Many(Vec<f32>),
}

impl Distances {
    fn new(mesh: &Mesh, selected: usize) -> Self {
        if selected > mesh.vertex_count() / VERTICES_PER_LOOKED_UP {
            Self::Many(vec![f32::INFINITY; mesh.vertex_capacity()])
        } else {
            Self::Few(FxHashMap::default())
        }
    }

    fn get(&self, v: VertexId) -> f32 {
        match self {
            Self::Few(known) => known.get(&v).copied(),
            Self::Many(known) => known.get(v.index()).copied(),
        }
        .unwrap_or(f32::INFINITY)
    }

    fn set(&mut self, v: VertexId, distance: f32) {
        match self {
            Self::Few(known) => {
                known.insert(v, distance);
            }
            Self::Many(known) => known.get_mut(v.index()).into_iter().for_each(|known| *known = distance),
        }
    }

    /// The vertices that were reached, in order of id.
    fn into_sorted(self) -> Vec<(VertexId, f32)> {
        match self {
            Self::Few(known) => {
                let mut all: Vec<(VertexId, f32)> = known.into_iter().collect();
                all.sort_unstable_by_key(|&(v, _)| v);
                all
            }
            Self::Many(known) => {
                let all = known.into_iter().enumerate().filter(|(_, distance)| distance.is_finite());
                all.map(|(v, distance)| (VertexId::new(v), distance)).collect()
            }
        }
    }
}

/// The vertices of a soft selection with their weights, in order of id: 1 for the selected ones, falling smoothly
/// to 0 at the radius (mesh units, above 0).
///
/// A front spreads along edges. Each vertex remembers the selected vertex that the front came from, and its
/// distance is the straight one to that vertex. Parts of the surface that are near only through space are
/// therefore not included. Costs O(k log k) for k vertices within the radius.
pub fn soft_selection(mesh: &Mesh, selected: &[VertexId], radius: f32) -> Vec<(VertexId, f32)> {
    let mut distances = Distances::new(mesh, selected.len());
    selected.iter().for_each(|v| distances.set(*v, 0.0));
    // From within the selection the front reaches nothing.
    let is_rim = |v: &&VertexId| mesh.neighbors(**v).any(|w| distances.get(w) > 0.0);
    // Nearest first: the bits of non-negative floats sort like their values.
    let mut front: BinaryHeap<_> =
        selected.iter().filter(is_rim).map(|&v| Reverse((0.0f32.to_bits(), v, v))).collect();
    while let Some(Reverse((distance, vertex, source))) = front.pop() {
        if distances.get(vertex).to_bits() < distance {
            continue;
        }
        for w in mesh.neighbors(vertex) {
            let distance = mesh.position(w).as_dvec3().distance(mesh.position(source).as_dvec3()) as f32;
            if distance < radius && distance < distances.get(w) {
                distances.set(w, distance);
                front.push(Reverse((distance.to_bits(), w, source)));
            }
        }
    }
    let weight = |distance: f32| {
        let x = 1.0 - distance / radius;
        x * x * (3.0 - 2.0 * x)
    };
    distances.into_sorted().into_iter().map(|(v, distance)| (v, weight(distance))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use halfedge::PolygonSoup;

    #[test]
    fn weights_fall_off_over_the_surface_only() {
        // A strip of five quads with a side of 1, and a triangle half a unit above its start.
        let mut soup = PolygonSoup::default();
        soup.positions.extend((0..12u8).map(|i| Vec3::new(f32::from(i / 2), f32::from(i % 2), 0.0)));
        soup.positions.extend([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| Vec3::new(x, y, 0.5)));
        (0..5).for_each(|i| soup.push_face([2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]));
        soup.push_face([12, 13, 14]);
        let mesh = Mesh::build(soup).expect("small").mesh;
        let [a, b] = [0, 1].map(VertexId::new);
        let weights = soft_selection(&mesh, &[b, a], 2.0);
        // Half-way the weight is a half; at the radius there is none.
        let expected = [(0, 1.0), (1, 1.0), (2, 0.5), (3, 0.5)].map(|(v, weight)| (VertexId::new(v), weight));
        assert_eq!(weights, expected);
        // Nearest to the one selected vertex, in a straight line.
        let weights = soft_selection(&mesh, &[a], 2.0);
        let x = 1.0 - 2f32.sqrt() / 2.0;
        assert_eq!(weights[3], (VertexId::new(3), x * x * (3.0 - 2.0 * x)));
        assert_eq!(weights.len(), 4);
        assert_eq!(soft_selection(&mesh, &[], 2.0), []);
    }
}
