//! Creases of any sharpness against a second implementation of the published rules, which only uses lists of
//! corners: no half-edges, no formulas for child ids, no shared code.

mod common;

use common::*;
use glam::DVec3;
use halfedge::Mesh;
use halfedge::attribute::keys;
use proptest::prelude::*;
use std::collections::BTreeMap;
use surface::*;

/// Edges by their ends, smaller first.
type Edges<T> = BTreeMap<(usize, usize), T>;

/// Polygons with a sharpness per edge and per vertex; boundaries have an infinite one.
struct Cage {
    points: Vec<DVec3>,
    polygons: Vec<Vec<usize>>,
    /// The polygons at each edge.
    sides: Edges<Vec<usize>>,
    edge_sharpness: Edges<f64>,
    vertex_sharpness: Vec<f64>,
}

fn mean(points: impl Iterator<Item = DVec3>) -> DVec3 {
    let (sum, count) = points.fold((DVec3::ZERO, 0.0), |(sum, count), p| (sum + p, count + 1.0));
    sum / count
}

impl Cage {
    fn of(mesh: &Mesh) -> Self {
        let polygons: Vec<Vec<usize>> =
            mesh.faces().map(|f| mesh.face_vertices(f).map(|v| v.index()).collect()).collect();
        let mut sides = Edges::<Vec<usize>>::new();
        for (i, polygon) in polygons.iter().enumerate() {
            for k in 0..polygon.len() {
                let (a, b) = (polygon[k], polygon[(k + 1) % polygon.len()]);
                sides.entry((a.min(b), a.max(b))).or_default().push(i);
            }
        }
        let mut edge_sharpness = Edges::new();
        for e in mesh.edges() {
            let [a, b] = mesh.ends(e).map(|v| v.index());
            edge_sharpness.insert((a.min(b), a.max(b)), f64::from(mesh.get(keys::EDGE_CREASE, e.index())));
        }
        for (edge, polygons) in &sides {
            if polygons.len() == 1 {
                edge_sharpness.insert(*edge, f64::INFINITY);
            }
        }
        Self {
            points: points(mesh),
            polygons,
            sides,
            edge_sharpness,
            vertex_sharpness: (0..mesh.vertex_count())
                .map(|v| f64::from(mesh.get(keys::VERTEX_CREASE, v)))
                .collect(),
        }
    }

    fn face_point(&self, polygon: usize) -> DVec3 {
        mean(self.polygons[polygon].iter().map(|&v| self.points[v]))
    }

    fn edge_point(&self, edge: (usize, usize)) -> DVec3 {
        let (a, b) = (self.points[edge.0], self.points[edge.1]);
        let middle = (a + b) / 2.0;
        let sharp = self.edge_sharpness[&edge].min(1.0);
        if sharp == 1.0 {
            return middle;
        }
        let sides = &self.sides[&edge];
        let smooth = (a + b + self.face_point(sides[0]) + self.face_point(sides[1])) / 4.0;
        smooth.lerp(middle, sharp)
    }

    /// The position of a vertex if the edges to these ends are sharp; none for the smooth rule.
    fn sharp_point(&self, v: usize, is_corner: bool, ends: &[usize]) -> Option<DVec3> {
        match ends {
            _ if is_corner => Some(self.points[v]),
            [] | [_] => None,
            [a, b] => Some((6.0 * self.points[v] + self.points[*a] + self.points[*b]) / 8.0),
            _ => Some(self.points[v]),
        }
    }

    fn vertex_point(&self, v: usize) -> DVec3 {
        let edges: Vec<(usize, f64)> = self
            .edge_sharpness
            .iter()
            .filter(|((a, b), _)| *a == v || *b == v)
            .map(|((a, b), &s)| (a + b - v, s))
            .collect();
        if edges.is_empty() {
            return self.points[v];
        }
        let own = self.vertex_sharpness[v];
        let above = |limit: f64| -> Vec<usize> {
            edges.iter().filter(|(_, s)| *s > limit).map(|(w, _)| *w).collect()
        };
        let smooth = || {
            let around: Vec<usize> =
                (0..self.polygons.len()).filter(|&f| self.polygons[f].contains(&v)).collect();
            let n = around.len() as f64;
            let faces = mean(around.iter().map(|&f| self.face_point(f)));
            let middles = mean(edges.iter().map(|(w, _)| (self.points[*w] + self.points[v]) / 2.0));
            (faces + 2.0 * middles + (n - 3.0) * self.points[v]) / n
        };
        let Some(now) = self.sharp_point(v, own > 0.0, &above(0.0)) else { return smooth() };
        let later = self.sharp_point(v, own > 1.0, &above(1.0)).unwrap_or_else(smooth);
        // The mean of the sharpnesses that end in this level is the share of the current rule.
        let ending: Vec<f64> =
            edges.iter().map(|(_, s)| *s).chain([own]).filter(|s| *s > 0.0 && *s <= 1.0).collect();
        if ending.is_empty() {
            return now;
        }
        later.lerp(now, ending.iter().sum::<f64>() / ending.len() as f64)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn fractional_creases_and_corners_follow_the_rules(
        mesh in random_mesh(false),
        edges in prop::collection::vec(prop_oneof![Just(0.0f32), 0.0f32..1.0, 0.0f32..3.5, Just(1.0), Just(10.0)], 1..40),
        vertices in prop::collection::vec(prop_oneof![3 => Just(0.0f32), 1 => 0.0f32..1.0, 1 => 0.0f32..2.5], 1..20),
        levels in 1u32..3,
    ) {
        let mut mesh = mesh;
        for e in 0..mesh.edge_count() {
            mesh.set(keys::EDGE_CREASE, e, edges[e % edges.len()]);
        }
        for v in 0..mesh.vertex_count() {
            mesh.set(keys::VERTEX_CREASE, v, vertices[v % vertices.len()]);
        }
        let options = CatmullClark { levels: 1, ..CatmullClark::default() };
        for _ in 0..levels {
            let result = subdivide_catmull_clark(&mesh, &options, &mut never_cancel).expect("fits");
            result.validate().expect("valid");
            let cage = Cage::of(&mesh);
            let vertices = (0..cage.points.len()).map(|v| cage.vertex_point(v));
            let edges = cage.sides.keys().map(|&edge| cage.edge_point(edge));
            let faces = (0..cage.polygons.len()).map(|f| cage.face_point(f));
            let expected: Vec<DVec3> = vertices.chain(edges).chain(faces).collect();
            let ours = points(&result);
            prop_assert_eq!(ours.len(), expected.len());
            let error = farthest(&ours, &expected).max(farthest(&expected, &ours)) / diagonal(&expected);
            prop_assert!(error < 1e-6, "{:e}", error);
            // The next level starts from this one's result, which tests its sharpness too.
            mesh = result;
        }
    }
}
