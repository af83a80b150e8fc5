//! Soft selection: the vertices around selected ones, with weights that fall off with the distance.

use halfedge::{Mesh, VertexId};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// The vertices of a soft selection with their weights, in order of id: 1 for the selected ones, falling smoothly
/// to 0 at the radius (mesh units, above 0).
///
/// A front spreads along edges. Each vertex remembers the selected vertex that the front came from, and its
/// distance is the straight one to that vertex. Parts of the surface that are near only through space are
/// therefore not included. Costs O(k log k) for k vertices within the radius.
pub fn soft_selection(mesh: &Mesh, selected: &[VertexId], radius: f32) -> Vec<(VertexId, f32)> {
    let mut distances: HashMap<VertexId, f32> = selected.iter().map(|&v| (v, 0.0)).collect();
    // Nearest first: the bits of non-negative floats sort like their values.
    let mut front: BinaryHeap<_> = selected.iter().map(|&v| Reverse((0.0f32.to_bits(), v, v))).collect();
    while let Some(Reverse((distance, vertex, source))) = front.pop() {
        if distances.get(&vertex).is_some_and(|known| known.to_bits() < distance) {
            continue;
        }
        for w in mesh.neighbors(vertex) {
            let distance = mesh.position(w).as_dvec3().distance(mesh.position(source).as_dvec3()) as f32;
            if distance < radius && distances.get(&w).is_none_or(|&known| distance < known) {
                distances.insert(w, distance);
                front.push(Reverse((distance.to_bits(), w, source)));
            }
        }
    }
    let weight = |distance: f32| {
        let x = 1.0 - distance / radius;
        x * x * (3.0 - 2.0 * x)
    };
    let mut weights: Vec<(VertexId, f32)> = distances.into_iter().map(|(v, d)| (v, weight(d))).collect();
    weights.sort_unstable_by_key(|&(v, _)| v);
    weights
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
