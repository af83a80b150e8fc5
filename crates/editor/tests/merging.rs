//! Merging by distance gives the same whether a file is opened with it or the operation does it later.

use formats::{Repairs, rebuild};
use glam::{Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Mesh, PolygonSoup, keys};
use proptest::prelude::*;
use std::ops::ControlFlow;
use surface::merge_by_distance;

/// Quads of a grid, each with corners of its own that are nearly where its neighbours' are, and some
/// vertices close together anywhere.
fn soup() -> impl Strategy<Value = PolygonSoup> {
    let offset = (-9i8..10, -9i8..10, -9i8..10);
    let offset = offset.prop_map(|(x, y, z)| Vec3::new(x.into(), y.into(), z.into()) * 0.01);
    (prop::collection::vec((0u8..16, prop::array::uniform4(offset.clone())), 1..14), 0.0f32..500.0).prop_map(
        |(quads, far)| {
            let mut soup = PolygonSoup::default();
            for (cell, offsets) in quads {
                let first = soup.positions.len() as u32;
                let (x, y) = (f32::from(cell % 4), f32::from(cell / 4));
                let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
                for ((u, v), offset) in corners.into_iter().zip(offsets) {
                    soup.positions.push(Vec3::new(far + x + u, y + v, -far) + offset);
                }
                soup.push_face(first..first + 4);
            }
            let uvs = (0..soup.corners.len()).map(|i| Vec2::splat(i as f32)).collect();
            soup.corner_columns.push(Column::with_values(keys::CORNER_UV, uvs));
            let colors = (0..soup.positions.len()).map(|i| Vec3::splat(i as f32)).collect();
            soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
            soup
        },
    )
}

/// A corner's vertex, that one's colour and its own texture coordinate.
type Corner = (u32, Vec3, Vec2);

/// The vertices in order, and the faces' corners.
fn content(mesh: &Mesh) -> (Vec<Vec3>, Vec<Vec<Corner>>) {
    let faces = mesh.faces().map(|f| {
        let corner = |h| {
            let v: halfedge::VertexId = mesh.from(h);
            (v.raw(), mesh.get(keys::VERTEX_COLOR, v.index()), mesh.get(keys::CORNER_UV, h.index()))
        };
        mesh.face_halfedges(f).map(corner).collect()
    });
    (mesh.positions().to_vec(), faces.collect())
}

proptest! {
    #[test]
    fn opening_and_the_operation_merge_the_same(
        soup in soup(),
        distance in prop::sample::select(vec![0.0f32, 0.01, 0.05, 0.1, 0.3, 0.9, 1.5]),
    ) {
        let repairs = Repairs { merge_by_distance: Some(distance), ..Repairs::default() };
        let (opened, _) = rebuild(&soup, &repairs).expect("small");
        let plain = Mesh::build(soup).expect("small");
        prop_assert!(plain.notes.is_empty(), "every face has vertices of its own");
        let merged = merge_by_distance(&plain.mesh, formats::shortest(distance), &mut |_| ControlFlow::Continue(()));
        let merged = merged.expect("not cancelled").mesh;
        prop_assert_eq!(opened.validate(), Ok(()));
        prop_assert_eq!(content(&opened), content(&merged));
    }
}
