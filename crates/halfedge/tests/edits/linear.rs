//! Corner values follow every edit: on flat meshes whose texture coordinates are a linear function of position, they still
//! are that function afterwards.
//!
//! Each face has the function of its island (its group), so edges between islands are seams. The corners of a face that an
//! edit makes or moves must have values of the face's island.
//!
//! Where this can't hold, and why:
//!
//! - Moving vertices (`transform`, `set-vertex-position`, the height of an extrusion) keeps corner values by design: the
//!   texture moves with the surface. Extruded walls stand upright on the plane here, so their corners still have the
//!   values of the places below them.
//! - Dissolving merges faces. Across a seam the polygon has corners of two islands.
//! - Filling a hole and bridging make faces that border several others. Their corners have the values of the faces beside
//!   them, so that no seam appears. If those are of different islands no function fits all.

use crate::any_edit::{Kind, edit_any};
use crate::random::Random;
use crate::zoo;
use glam::{Mat3, Quat, Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Element, Mesh, keys};
use std::collections::BTreeMap;

/// Edits that make faces of several islands.
const MERGE_ISLANDS: [Kind; 5] =
    [Kind::DissolveVertex, Kind::DissolveEdges, Kind::FillHole, Kind::Bridge, Kind::SmoothBridge];

/// Edits that make one vertex of several, which may have had different values.
const MERGE_VERTICES: [Kind; 2] = [Kind::MergeVertices, Kind::WeldEdges];

/// A plane in space, and a linear function on it for each island.
struct Plane {
    origin: Vec3,
    /// The axes of the plane and its normal as columns.
    axes: Mat3,
    /// Per island: the derivatives along the axes, and the value at the origin.
    functions: Vec<[Vec2; 3]>,
}

impl Plane {
    fn random(random: &mut Random, islands: usize) -> Self {
        let mut pair = || Vec2::new(random.unit() - 0.5, random.unit() - 0.5);
        let functions = (0..islands).map(|_| [pair(), pair(), pair() * 4.0]).collect();
        let turn = Quat::from_euler(
            glam::EulerRot::XYZ,
            random.unit() * 6.0,
            random.unit() * 6.0,
            random.unit() * 6.0,
        );
        let origin = Vec3::new(random.unit(), random.unit(), random.unit()) * 3.0;
        Self { origin, axes: Mat3::from_quat(turn), functions }
    }

    fn value(&self, island: u32, position: Vec3) -> Vec2 {
        let flat = self.axes.transpose() * (position - self.origin);
        let [dx, dy, base] = self.functions[island as usize];
        dx * flat.x + dy * flat.y + base
    }

    /// Puts a mesh of the xy plane on this one, its faces on random islands.
    fn place(&self, mesh: &mut Mesh, random: &mut Random) {
        for v in mesh.vertices().collect::<Vec<_>>() {
            let p = mesh.position(v);
            mesh.set_position(v, self.origin + self.axes * Vec3::new(p.x, p.y, 0.0));
        }
        let groups = (0..mesh.face_capacity()).map(|_| random.below(self.functions.len()) as u32).collect();
        mesh.insert_column(Element::Face, Column::with_values(keys::FACE_GROUP, groups));
        for f in mesh.faces().collect::<Vec<_>>() {
            for h in mesh.face_halfedges(f).collect::<Vec<_>>() {
                let value = self.value(mesh.get(keys::FACE_GROUP, f.index()), mesh.position(mesh.from(h)));
                mesh.set(keys::CORNER_UV, h.index(), value);
            }
        }
    }

    fn check(&self, mesh: &Mesh) -> Result<(), String> {
        for f in mesh.faces() {
            let island = mesh.get(keys::FACE_GROUP, f.index());
            for h in mesh.face_halfedges(f) {
                let position = mesh.position(mesh.from(h));
                let (value, expected) = (mesh.get(keys::CORNER_UV, h.index()), self.value(island, position));
                // False for a missing value too.
                let is_right = value.distance(expected) < 1e-4;
                if !is_right {
                    let v = mesh.from(h);
                    return Err(format!("corner {v} of {f} has {value}, expected {expected}"));
                }
            }
        }
        Ok(())
    }
}

/// Flat meshes in the xy plane: quads, triangles, polygons, concave ones, straight corners, holes, several
/// pieces, large faces.
fn flat_meshes() -> Vec<(&'static str, Mesh)> {
    let mut pieces: Vec<(Vec<Vec3>, Vec<Vec<u32>>)> = Vec::new();
    for (i, part) in [zoo::grid(2, 2), zoo::patchwork(), zoo::triangle_grid(2, 1)].into_iter().enumerate() {
        let positions = part.positions().iter().map(|p| *p + Vec3::X * 7.0 * i as f32).collect();
        let faces = part.faces().map(|f| part.face_vertices(f).map(|v| v.raw()).collect()).collect();
        pieces.push((positions, faces));
    }
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for (points, polygons) in pieces {
        let base = positions.len() as u32;
        positions.extend(points);
        faces.extend(
            polygons.into_iter().map(|polygon| polygon.iter().map(|v| v + base).collect::<Vec<u32>>()),
        );
    }
    let several = zoo::mesh(positions, &faces);

    // A quad grid with an L of three of its faces and with corners at straight angles.
    let mut corners = zoo::grid(4, 3);
    for (a, b) in [(6, 11), (6, 7), (12, 13)] {
        let edge = zoo::he(&corners, a, b).edge();
        halfedge::edit::dissolve_edges(&mut corners, &[edge], true).unwrap();
    }
    // A round table: its top has 60 corners and half of them spokes to the rim.
    let n = 60;
    let ring = |radius: f32| {
        (0..n).map(move |i| Vec3::from((Vec2::from_angle(i as f32 / n as f32 * 6.2831855) * radius, 0.0)))
    };
    let mut faces: Vec<Vec<u32>> = vec![(0..n).collect()];
    faces.extend((0..n).step_by(2).map(|i| {
        let (b, c) = ((i + 1) % n, (i + 2) % n);
        vec![i, n + i, n + b, n + c, c, b]
    }));
    let table = zoo::mesh(ring(2.0).chain(ring(3.0)).collect(), &faces);
    vec![
        ("grid", zoo::grid(3, 3)),
        ("triangle grid", zoo::triangle_grid(4, 3)),
        ("patchwork", zoo::patchwork()),
        ("frame", zoo::frame()),
        ("several", several),
        ("corners", corners),
        ("table", table),
    ]
}

#[test]
fn linear_corner_values_stay_linear() {
    let meshes = flat_meshes();
    let mut done = [[0; Kind::ALL.len()]; 2];
    let mut failed = BTreeMap::new();
    for seed in 1..=6000_u64 {
        let mut random = Random::new(seed * 0x9E37_79B9);
        let (name, flat) = &meshes[seed as usize % meshes.len()];
        let islands = [1, 3][random.below(2)];
        let plane = Plane::random(&mut random, islands);
        let mut mesh = flat.clone();
        plane.place(&mut mesh, &mut random);
        plane.check(&mesh).unwrap();
        let kind = Kind::ALL[random.below(Kind::ALL.len())];
        // Its vertices lie beside the straight lines that their values are interpolated along.
        let is_curved = kind == Kind::SmoothBridge;
        if is_curved || islands > 1 && MERGE_ISLANDS.contains(&kind) {
            continue;
        }
        if edit_any(&mut mesh, &mut random, kind).is_ok() {
            mesh.validate().unwrap();
            if let Err(why) = plane.check(&mesh) {
                failed
                    .entry(kind)
                    .or_insert_with(|| format!("{name}, {islands} islands, seed {seed}: {why}"));
            }
            done[usize::from(islands > 1)][kind as usize] += 1;
        }
    }
    println!("edits done: {done:?}");
    assert!(failed.is_empty(), "by kind of edit, the first failure: {failed:#?}");
    for kind in Kind::ALL {
        let [one, several] = [0, 1].map(|i| done[i][kind as usize]);
        assert!(one > 0 || kind == Kind::SmoothBridge, "{kind:?} was never made");
        assert!(several > 0 || MERGE_ISLANDS.contains(&kind), "{kind:?} was never made on islands");
    }
}

/// Corners of one vertex that have one value, whatever function of the vertices the values are, have one
/// value after every edit: to the bit, since programs tell seams by comparing.
#[test]
fn edits_make_no_seams() {
    let mut meshes = flat_meshes();
    meshes.extend(zoo::all());
    let mut done = [0; Kind::ALL.len()];
    let mut failed = BTreeMap::new();
    for seed in 1..=6000_u64 {
        let mut random = Random::new(seed * 0x517C_C1B7);
        let (name, start) = &meshes[seed as usize % meshes.len()];
        let mut mesh = start.clone();
        for v in start.vertices() {
            let value = Vec2::new(random.unit(), random.unit());
            for h in start.outgoing(v).filter(|&h| !start.is_boundary_halfedge(h)) {
                mesh.set(keys::CORNER_UV, h.index(), value);
            }
        }
        let kind = Kind::ALL[random.below(Kind::ALL.len())];
        if MERGE_VERTICES.contains(&kind) || edit_any(&mut mesh, &mut random, kind).is_err() {
            continue;
        }
        done[kind as usize] += 1;
        for v in mesh.vertices() {
            let corners = mesh.outgoing(v).filter(|&h| !mesh.is_boundary_halfedge(h));
            let values: Vec<Vec2> = corners.map(|h| mesh.get(keys::CORNER_UV, h.index())).collect();
            if values.iter().any(|value| *value != values[0]) {
                let why = format!("{name}, seed {seed}: {v} has {values:?}");
                failed.entry(kind).or_insert(why);
            }
        }
    }
    assert!(failed.is_empty(), "by kind of edit, the first failure: {failed:#?}");
    let is_missing = |kind: &Kind| done[*kind as usize] == 0 && !MERGE_VERTICES.contains(kind);
    let never = Kind::ALL.into_iter().find(is_missing);
    assert_eq!(never, None, "an edit was never made: {done:?}");
}
