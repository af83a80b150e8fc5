//! Every operation on whole meshes, on tiny meshes of any shape: doubled faces, faces without area, vertices at one
//! place or far away.

mod common;

use common::*;
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};
use proptest::prelude::*;
use surface::*;

fn place() -> impl Strategy<Value = Vec3> {
    let number = prop_oneof![
        4 => (-2i8..3).prop_map(f32::from),
        4 => -2f32..2.0,
        1 => Just(1e-6f32),
        1 => Just(40f32),
    ];
    [number.clone(), number.clone(), number].prop_map(Vec3::from_array)
}

/// One to six faces of three to five corners among three to six vertices, each with another on its back if `doubled`.
fn tiny() -> impl Strategy<Value = Mesh> {
    (prop::collection::vec(place(), 3..7), any::<bool>(), any::<bool>())
        .prop_flat_map(|(places, doubled, only_triangles)| {
            let all: Vec<u32> = (0..places.len() as u32).collect();
            let most = if only_triangles { 3 } else { places.len().min(5) };
            let face = prop::sample::subsequence(all, 3..=most).prop_shuffle();
            (Just(places), prop::collection::vec(face, 1..7), Just(doubled))
        })
        .prop_map(|(places, mut faces, doubled)| {
            if doubled {
                let backs: Vec<Vec<u32>> =
                    faces.iter().map(|face| face.iter().rev().copied().collect()).collect();
                faces.extend(backs);
            }
            let mesh = Mesh::build(PolygonSoup::new(places, &faces)).expect("small").mesh;
            mesh.validate().expect("valid");
            mesh
        })
}

/// Two triangles on the same three vertices, back to back.
fn pillow(places: [[f32; 3]; 3]) -> Mesh {
    mesh(&places, &[&[0, 1, 2], &[0, 2, 1]])
}

fn is_valid(result: Result<Mesh, SurfaceError>) -> Result<Mesh, TestCaseError> {
    let mesh = result.map_err(|error| TestCaseError::fail(error.to_string()))?;
    mesh.validate().map_err(|defect| TestCaseError::fail(defect.to_string()))?;
    Ok(mesh)
}

#[test]
fn doubled_triangles_are_remeshed_into_a_closed_surface() {
    for places in [
        [[0., 0., 0.], [0., 2., 0.], [0.01, 3., 0.]],
        [[0., 0., 0.], [2., 0., 0.], [0., 2., 0.]],
        [
            [0.361_232_6, -38.712_105, -1.701_835_6],
            [0.737_061_4, -12.612_834, -1.767_110_8],
            [0.758_158_5, 0.166_848, 1.962_506],
        ],
    ] {
        for edge_length in [None, Some(0.3), Some(5.0), Some(50.0)] {
            let result = is_valid(remesh(
                &pillow(places),
                &Remesh { edge_length, ..Remesh::default() },
                &mut never_cancel,
            ));
            let result = result.unwrap_or_else(|error| panic!("{places:?}, {edge_length:?}: {error}"));
            assert_eq!(result.euler_characteristic(), 2, "{places:?}, {edge_length:?}");
        }
    }
    let fine = Remesh { edge_length: Some(0.3), ..Remesh::default() };
    let result =
        remesh(&pillow([[0., 0., 0.], [2., 0., 0.], [0., 2., 0.]]), &fine, &mut never_cancel).unwrap();
    assert!(result.face_count() > 60, "{} faces", result.face_count());
}

#[test]
fn one_far_vertex_does_not_explode() {
    for far in [1e3, 1e5, 1e6, 1e9, 1e30] {
        let mut spiked = cube();
        let v = spiked.vertices().next().unwrap();
        spiked.set_position(v, Vec3::new(0.0, far, 0.0));
        let most = Remesh::most_triangles(&spiked, Remesh::default_length(&spiked));
        assert!(most < 100_000.0, "{far}: {most}");
        let result =
            remesh(&spiked, &Remesh { iterations: 1, ..Remesh::default() }, &mut never_cancel).unwrap();
        result.validate().expect("valid");
        assert!(result.face_count() as f64 <= most, "{far}: {}, more than {most}", result.face_count());
        // A length that cuts the spike into too many pieces is refused before it is cut.
        if far >= 1e6 {
            let short = Remesh { edge_length: Some(0.5), ..Remesh::default() };
            let error = remesh(&spiked, &short, &mut never_cancel).expect_err("too many");
            assert!(matches!(error, SurfaceError::TooManyFaces { .. }), "{far}: {error}");
        }
    }
}

proptest! {
    #[test]
    fn any_tiny_mesh_is_remeshed(
        mesh in tiny(),
        length in prop_oneof![Just(None), (0.2f64..5.0).prop_map(Some)],
        iterations in 1u32..4,
        feature_angle in prop_oneof![Just(45.0), 1f64..180.0, Just(180.0)],
        project: bool,
    ) {
        let options = Remesh { edge_length: length, iterations, feature_angle, project };
        let result = remesh(&mesh, &options, &mut never_cancel);
        if let Err(SurfaceError::BadField { .. }) = result {
            prop_assert!(Remesh::default_length(&mesh) == 0.0);
            return Ok(());
        }
        let result = is_valid(result)?;
        let most = Remesh::most_triangles(&mesh, length.unwrap_or_else(|| Remesh::default_length(&mesh)));
        let before: usize = mesh.faces().map(|f| mesh.face_degree(f)).sum();
        prop_assert!(result.face_count() as f64 <= 4.0 * (most + before as f64), "{} of {most}", result.face_count());
    }

    #[test]
    fn any_tiny_mesh_is_simplified(
        mesh in tiny(),
        target in prop_oneof![
            (0usize..8).prop_map(SimplifyTarget::Faces),
            (0.01f64..1.0).prop_map(SimplifyTarget::Ratio),
            (0f64..3.0).prop_map(SimplifyTarget::MaxError),
        ],
        preserve_boundary: bool,
        preserve_seams: bool,
    ) {
        let options = Simplify { target, preserve_boundary, preserve_seams };
        is_valid(simplify(&mesh, &options, &mut never_cancel).map(|simplified| simplified.mesh))?;
    }

    #[test]
    fn any_tiny_mesh_is_subdivided_smoothed_and_merged(
        mesh in tiny(),
        levels in 1u32..3,
        strength in 0f64..1.0,
        distance in 0f64..2.0,
        keeps_corners: bool,
    ) {
        let boundary = if keeps_corners { BoundaryRule::EdgeAndCorner } else { BoundaryRule::EdgeOnly };
        for vertex_rule in [VertexRule::Standard, VertexRule::SmoothedMidpoints] {
            let options = CatmullClark { levels, boundary, vertex_rule };
            is_valid(subdivide_catmull_clark(&mesh, &options, &mut never_cancel))?;
        }
        is_valid(subdivide_linear(&mesh, &Linear { levels }, &mut never_cancel))?;
        for weights in [LoopWeights::Loop, LoopWeights::Warren] {
            match subdivide_loop(&mesh, &Loop { levels, boundary, weights }, &mut never_cancel) {
                Err(SurfaceError::NotTriangles { .. } | SurfaceError::MeetTwice { .. }) => {}
                other => drop(is_valid(other)?),
            }
        }
        for method in [SmoothMethod::Taubin, SmoothMethod::Laplacian] {
            is_valid(smooth(&mesh, &Smooth { iterations: 3, strength, method }, &mut never_cancel))?;
        }
        is_valid(merge_by_distance(&mesh, distance, &mut never_cancel).map(|merged| merged.mesh))?;
    }
}
