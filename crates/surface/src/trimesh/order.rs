//! Ordering elements so that neighbours in space are close in memory.

use super::TriMesh;
use crate::morton;
use halfedge::NONE;

/// The renumbering by [`TriMesh::put_in_order`].
pub(crate) struct Order {
    pub vertices: Renumbering,
    pub triangles: Renumbering,
}

/// The old numbers of the elements that are kept, in their new order.
pub(crate) struct Renumbering(pub Vec<u32>);

impl Renumbering {
    /// The number of elements that are kept.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Per old number, of which there are `count`, the new one, or [`NONE`] if it is dropped.
    pub fn new_numbers(&self, count: usize) -> Vec<u32> {
        let mut new = vec![NONE; count];
        for (at, &old) in (0u32..).zip(&self.0) {
            new[old as usize] = at;
        }
        new
    }

    /// Permutes a list in place, since large meshes have no memory for a second list. An empty list stays empty.
    /// Costs O(list).
    pub fn apply<T: Copy>(&self, values: &mut Vec<T>) {
        if !values.is_empty() {
            self.permute(values);
            values.truncate(self.len());
            values.shrink_to_fit();
        }
    }

    /// Like [`Self::apply`], for a list with three values per number.
    fn apply_to_corners(&self, values: &mut Vec<u32>) {
        if !values.is_empty() {
            self.permute(values.as_chunks_mut::<3>().0);
            values.truncate(3 * self.len());
            values.shrink_to_fit();
        }
    }

    fn permute<T: Copy>(&self, values: &mut [T]) {
        let Self(old) = self;
        let mut wanted = vec![false; old.len()];
        for &from in old {
            if let Some(wanted) = wanted.get_mut(from as usize) {
                *wanted = true;
            }
        }
        let mut done = vec![false; old.len()];
        // An entry whose value is dropped takes another's value; that entry is free then and takes the next, until
        // a value comes from past the end.
        for start in (0..old.len()).filter(|&at| !wanted[at]) {
            let mut at = start;
            while let Some(&from) = old.get(at) {
                values[at] = values[from as usize];
                done[at] = true;
                at = from as usize;
            }
        }
        // The rest are cycles.
        for start in 0..old.len() {
            let first = values[start];
            let mut at = start;
            while !done[at] {
                done[at] = true;
                let from = old[at] as usize;
                values[at] = if from == start { first } else { values[from] };
                at = from;
            }
        }
    }
}

impl TriMesh {
    /// Sorts vertices along a space-filling curve and triangles by their first vertex, and drops removed ones, so
    /// that neighbours are close in memory. Returns the renumbering. Costs O(mesh).
    pub fn put_in_order(&mut self) -> Order {
        let live = (0u32..).zip(&self.out).filter(|(_, out)| **out != NONE);
        let vertices = Renumbering(morton::order(live.map(|(v, _)| (v, self.at(v).as_vec3()))));
        let vertex = vertices.new_numbers(self.out.len());
        let triangles = Renumbering(counting_sort(vertices.len(), || {
            let live = (0u32..).zip(self.v.chunks_exact(3)).filter(|(_, corners)| corners[0] != NONE);
            let first = |corners: &[u32]| corners.iter().map(|&v| vertex[v as usize]).min().unwrap_or(0);
            live.map(move |(f, corners)| (f, first(corners)))
        }));
        triangles.apply_to_corners(&mut self.v);
        self.v.iter_mut().for_each(|v| *v = vertex[*v as usize]);
        drop(vertex);
        let triangle = triangles.new_numbers(self.opp.len() / 3);
        let half = |h: u32| if h == NONE { NONE } else { 3 * triangle[h as usize / 3] + h % 3 };
        triangles.apply_to_corners(&mut self.opp);
        self.opp.iter_mut().for_each(|h| *h = half(*h));
        vertices.apply(&mut self.out);
        self.out.iter_mut().for_each(|h| *h = half(*h));
        drop(triangle);
        vertices.apply(&mut self.position);
        triangles.apply(&mut self.face_source);
        triangles.apply_to_corners(&mut self.wedge);
        triangles.apply_to_corners(&mut self.edge_source);
        for column in &mut self.vertex_columns {
            *column = column.gather(vertices.0.iter().copied());
        }
        Order { vertices, triangles }
    }
}

/// Sorts numbers stably by their keys, which are below `most`, by counting. Costs O(numbers + most).
pub(super) fn counting_sort<I: Iterator<Item = (u32, u32)>>(
    most: usize,
    numbers: impl Fn() -> I,
) -> Vec<u32> {
    let mut starts = vec![0u32; most + 1];
    for (_, at) in numbers() {
        starts[at as usize + 1] += 1;
    }
    for at in 0..most {
        starts[at + 1] += starts[at];
    }
    let mut ordered = vec![NONE; starts[most] as usize];
    for (number, at) in numbers() {
        let place = &mut starts[at as usize];
        ordered[*place as usize] = number;
        *place += 1;
    }
    ordered
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn renumbering_in_place_is_gathering(
            old in (0u32..60).prop_flat_map(|count| {
                let all: Vec<u32> = (0..count).collect();
                prop::sample::subsequence(all, 0..=count as usize).prop_shuffle()
            }),
            beyond in 0u32..5,
        ) {
            let count = old.iter().max().map_or(0, |most| most + 1) + beyond;
            let mut values: Vec<u32> = (0..count).map(|v| 7 * v).collect();
            let mut corners: Vec<u32> = (0..3 * count).collect();
            let renumbering = Renumbering(old.clone());
            let new = renumbering.new_numbers(count as usize);
            prop_assert!((0u32..).zip(&old).all(|(at, &v)| new[v as usize] == at));
            prop_assert_eq!(new.iter().filter(|&&at| at != NONE).count(), old.len());
            renumbering.apply(&mut values);
            prop_assert_eq!(values, old.iter().map(|v| 7 * v).collect::<Vec<_>>());
            renumbering.apply_to_corners(&mut corners);
            prop_assert_eq!(corners, old.iter().flat_map(|v| [0, 1, 2].map(|k| 3 * v + k)).collect::<Vec<_>>());
        }
    }
}
