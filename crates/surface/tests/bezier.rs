//! Tessellated Bezier surfaces: welded, closed where patches meet, with exact normals.

use glam::Vec3;
use halfedge::{Mesh, keys};
use surface::bezier::{Patch, teapot_patches, tessellate};

fixtures::shared_tests!(
    the_control_points_are_those_of_the_course_file,
    the_course_file_tessellates_to_the_same_components,
);

fn shared_teapot() -> Vec<Patch> {
    let text = std::fs::read_to_string(fixtures::shared("models/cs184/teapot.bez")).unwrap();
    let numbers: Vec<f32> = text.split_whitespace().skip(1).map(|w| w.parse().unwrap()).collect();
    let point = |i: usize| Vec3::new(numbers[i * 3], numbers[i * 3 + 1], numbers[i * 3 + 2]);
    (0..numbers.len() / 48)
        .map(|p| Patch { rows: [0, 1, 2, 3].map(|j| [0, 1, 2, 3].map(|i| point(p * 16 + j * 4 + i))) })
        .collect()
}

/// Each corner normal is on the same side as the face's normal.
fn check_normals(mesh: &Mesh, at_least: f32) {
    let normals = mesh.attribute(keys::CORNER_NORMAL).unwrap();
    for f in mesh.faces() {
        let corners: Vec<Vec3> = mesh.face_vertices(f).map(|v| mesh.position(v)).collect();
        let across = (corners[2] - corners[0]).cross(corners[corners.len() - 1] - corners[1]);
        let flat = if corners.len() == 3 {
            (corners[1] - corners[0]).cross(corners[2] - corners[0])
        } else {
            across
        };
        for h in mesh.face_halfedges(f) {
            let normal = normals[h.index()];
            assert!((normal.length() - 1.0).abs() < 1e-4, "{h}: {normal}");
            assert!(normal.dot(flat.normalize()) > at_least, "{f} {h}: {normal} against {flat}");
        }
    }
}

#[test]
fn the_teapot_is_welded_and_faces_outward() {
    let patches = teapot_patches();
    assert_eq!(patches.len(), 32);
    for resolution in [2, 4, 10] {
        let made = tessellate(&patches, resolution).unwrap();
        let mesh = &made.mesh;
        mesh.validate().unwrap();
        let n = resolution as usize;
        // At the lid's knob and in the middle of the bottom, quads become triangles. (At resolution 1 the two
        // halves of the handle and of the spout would be the same faces.)
        assert_eq!(mesh.face_count(), 32 * n * n);
        let poles =
            mesh.vertices().filter(|&v| mesh.valence(v) == 4 * n && mesh.position(v).x == 0.0).count();
        assert_eq!(poles, 2);
        // Body with bottom, lid, handle and spout: open at the inside of the rim, at the edge of the lid, and at
        // both ends of the handle and of the spout.
        assert_eq!(mesh.components().1, 4);
        assert_eq!(mesh.boundary_loops().len(), 6);
    }
    // Fine enough for the lip of the spout, which turns over within a few hundredths.
    let made = tessellate(&patches, 48).unwrap();
    check_normals(&made.mesh, 0.3);
    // Outside is away from the middle of the body.
    let body = made.mesh.faces().find(|&f| {
        let p = made.mesh.position(made.mesh.face_vertices(f).next().unwrap());
        p.x > 1.9 && p.z > 0.5 && p.z < 1.2 && p.y.abs() < 0.5
    });
    let h = made.mesh.halfedge_of(body.unwrap());
    assert!(made.mesh.get(keys::CORNER_NORMAL, h.index()).x > 0.8);
}

fn the_control_points_are_those_of_the_course_file() {
    let theirs = shared_teapot();
    assert_eq!(theirs.len(), 32);
    // The file has three decimals and another order; each point is in both.
    for p in theirs.iter().flat_map(|patch| patch.rows.as_flattened()) {
        let near = teapot_patches()
            .iter()
            .flat_map(|t| t.rows.as_flattened().to_vec())
            .any(|q| q.distance(*p) < 2e-3);
        assert!(near, "{p} is not among ours");
    }
}

fn the_course_file_tessellates_to_the_same_components() {
    let theirs = shared_teapot();
    let made = tessellate(&theirs, 6).unwrap();
    made.mesh.validate().unwrap();
    let ours = tessellate(&teapot_patches(), 6).unwrap();
    assert_eq!(made.mesh.face_count(), ours.mesh.face_count());
    assert_eq!(made.mesh.vertex_count(), ours.mesh.vertex_count());
    assert_eq!(made.mesh.boundary_loops().len(), ours.mesh.boundary_loops().len());
    check_normals(&made.mesh, -1.1);
}

#[test]
fn a_bilinear_patch_is_its_plane() {
    let rows = [0.0, 1.0, 2.0, 3.0].map(|y| [0.0, 1.0, 2.0, 3.0].map(|x| Vec3::new(x, y, 5.0)));
    let made = tessellate(&[Patch { rows }], 3).unwrap();
    assert!(made.notes.is_empty());
    assert_eq!((made.mesh.vertex_count(), made.mesh.face_count()), (16, 9));
    for &p in made.mesh.positions() {
        assert!((p - p.round()).length() < 1e-6 && p.z == 5.0);
    }
    check_normals(&made.mesh, 0.999);
}

#[test]
fn no_patches_make_an_empty_mesh() {
    assert_eq!(tessellate(&[], 5).unwrap().mesh.face_count(), 0);
}

#[test]
fn patches_at_a_single_point_stay_there() {
    for point in [Vec3::ZERO, Vec3::new(1.0, -2.0, 3.0), Vec3::new(0.0, 1e-30, 0.0)] {
        let made = tessellate(&[Patch { rows: [[point; 4]; 4] }; 2], 3).unwrap();
        made.mesh.validate().unwrap();
        assert!(made.mesh.positions().iter().all(|p| p.is_finite() && (p - point).length() < 1e-6));
    }
}

/// A patch with a pole, whose derivatives and normals are not those of a plane.
fn bent_patch(factor: f32) -> Patch {
    let at = |i: usize, j: usize| {
        let along = if j == 0 { 0.0 } else { i as f32 - 1.5 };
        Vec3::new(along, j as f32 - 1.5, ((i * j) % 3) as f32) * factor
    };
    Patch { rows: std::array::from_fn(|j| std::array::from_fn(|i| at(i, j))) }
}

/// Squares of very large and very small lengths are out of the range of single precision.
#[test]
fn surfaces_of_any_size_have_the_same_shape() {
    let normals = |mesh: &Mesh| -> Vec<Vec3> {
        mesh.halfedges()
            .filter(|&h| !mesh.is_boundary_halfedge(h))
            .map(|h| mesh.get(keys::CORNER_NORMAL, h.index()))
            .collect()
    };
    let near = tessellate(&[bent_patch(1.0)], 4).expect("small").mesh;
    assert!(normals(&near).iter().all(|normal| normal.is_normalized()));
    for exponent in [70_i8, 126, -70, -110] {
        let factor = f32::from(exponent).exp2();
        let far = tessellate(&[bent_patch(factor)], 4).expect("small").mesh;
        assert_eq!(far.face_count(), near.face_count());
        assert_eq!(normals(&far), normals(&near), "2^{exponent}");
        for (a, b) in far.positions().iter().zip(near.positions()) {
            assert_eq!(*a / factor, *b, "2^{exponent}");
        }
    }
    let tiny = tessellate(&[bent_patch(1e-40)], 4).expect("small").mesh;
    assert_eq!(tiny.face_count(), near.face_count());
}
