//! `bridge` on what is selected.

mod support;

use editor::halfedge::{Element, Mesh};
use editor::{Editor, SelectMode};
use glam::Vec3;
use serde_json::json;
use support::*;

/// Grids of 4 by 4 quads over each other, the ones at odd places face down.
fn grids(heights: &[f32]) -> Mesh {
    let mut positions = Vec::new();
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for (at, &height) in heights.iter().enumerate() {
        let first = positions.len() as u32;
        positions.extend((0..25).map(|i| Vec3::new((i % 5) as f32 - 2.0, (i / 5) as f32 - 2.0, height)));
        for i in 0..16 {
            let corner = first + i / 4 * 5 + i % 4;
            let mut face = vec![corner, corner + 1, corner + 6, corner + 5];
            if at % 2 == 1 {
                face.reverse();
            }
            faces.push(face);
        }
    }
    build(positions, &faces)
}

fn select(editor: &mut Editor, kind: Element, ids: impl IntoIterator<Item = u32>) {
    editor.select(kind, ids, SelectMode::Replace).expect("there");
}

/// The faces in the middle of the grid at a place.
fn inner(at: u32) -> Vec<u32> {
    [5, 6, 9, 10].iter().map(|f| f + 16 * at).collect()
}

#[test]
fn selected_regions_of_faces_are_joined_in_pairs() {
    let mut editor = Editor::with_mesh("Grids", grids(&[0.0, 1.0, 5.0, 6.0]));
    select(&mut editor, Element::Face, (0..4).flat_map(inner));
    let before = sizes(&editor);
    let made = run(&mut editor, json!({"op": "bridge", "cuts": 2}));
    assert_eq!(editor.selection().len(), 2 * 8 * 3, "the bands");
    assert_eq!(made.removed.ids.expect("a local edit").vertices.len(), 4, "the middles");
    assert_eq!(sizes(&editor)[2], before[2] - 16 + 48);
    let mesh = editor.mesh().expect("it");
    assert_eq!(mesh.components().1, 2, "the closest ones were joined");

    // Adjusted, it is one step still.
    let steps = editor.undo_labels().count();
    editor.adjust(command(json!({"op": "bridge", "cuts": 0, "twist": -2}))).expect("quick");
    assert_eq!(editor.undo_labels().count(), steps);
    assert_eq!(editor.selection().len(), 2 * 8);
    validate(&editor);
}

#[test]
fn selected_edges_stand_for_their_boundary_loops() {
    let rims = |mesh: &Mesh| -> Vec<u32> {
        mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).map(|e| e.raw()).collect()
    };
    let mut editor = Editor::with_mesh("Grids", grids(&[0.0, 1.0]));
    let edges = rims(editor.mesh().expect("it"));
    assert_eq!(edges.len(), 32);
    select(&mut editor, Element::Edge, edges);
    run(&mut editor, json!({"op": "bridge", "cuts": 1}));
    let mesh = editor.mesh().expect("it");
    assert!(mesh.boundary_loops().is_empty());
    assert_eq!(mesh.euler_characteristic(), 2);

    // One edge of each loop is enough, and edges inside the surface do no harm.
    let mut editor = Editor::with_mesh("Grids", grids(&[0.0, 1.0]));
    let mesh = editor.mesh().expect("it");
    let edges = rims(mesh);
    let inside = mesh.edges().find(|&e| !mesh.is_boundary_edge(e)).expect("some").raw();
    select(&mut editor, Element::Edge, [edges[0], edges[31], inside]);
    run(&mut editor, json!({"op": "bridge"}));
    assert!(editor.mesh().expect("it").boundary_loops().is_empty());

    let mut editor = Editor::with_mesh("Grids", grids(&[0.0, 1.0, 5.0]));
    select(&mut editor, Element::Edge, [inside]);
    assert!(refusal(&mut editor, json!({"op": "bridge"})).contains("no selected edge is on a boundary"));
    let edges = rims(editor.mesh().expect("it"));
    select(&mut editor, Element::Edge, edges);
    assert!(refusal(&mut editor, json!({"op": "bridge"})).contains("there are 3"));
    select(&mut editor, Element::Face, inner(0));
    assert!(refusal(&mut editor, json!({"op": "bridge"})).contains("don't touch"));
    let both = json!({"op": "bridge", "faces": [0, 16], "halfedges": [0, 1]});
    assert!(refusal(&mut editor, both).contains("not both"));
    for (field, value) in [("twist", 1001), ("twist", -1001), ("cuts", 1001), ("cuts", -1)] {
        let text = refusal(&mut editor, json!({"op": "bridge", "faces": [5, 21], field: value}));
        assert!(text.contains(field), "{text}");
    }
}

#[test]
fn a_mirrored_bridge_joins_both_sides() {
    // The faces at x > 0 of both grids, and with symmetry those at x < 0 too.
    let mut editor = Editor::with_mesh("Grids", grids(&[0.0, 1.0]));
    let before = sizes(&editor);
    run(&mut editor, json!({"op": "bridge", "faces": [3, 19], "cuts": 1, "symmetry": "x"}));
    assert_eq!(sizes(&editor)[2], before[2] - 4 + 2 * 8);
    let mesh = editor.mesh().expect("it");
    // Each place has as many vertices as its mirror image.
    let places = |sign: f32| {
        let mut all: Vec<[i32; 3]> = mesh
            .vertices()
            .map(|v| (mesh.position(v) * Vec3::new(sign, 1.0, 1.0) * 16.0).round().as_ivec3().to_array())
            .collect();
        all.sort_unstable();
        all
    };
    assert_eq!(places(1.0), places(-1.0));
}

#[test]
fn a_smooth_bridge_bulges_and_is_straight_by_default() {
    let outermost = |smoothness: Option<f64>| {
        let mut editor = Editor::with_mesh("Grids", grids(&[0.0, 2.0]));
        select(&mut editor, Element::Face, (0..2).flat_map(inner));
        let mut bridge = json!({"op": "bridge", "cuts": 3});
        if let Some(smoothness) = smoothness {
            bridge["smoothness"] = smoothness.into();
        }
        let made = run(&mut editor, bridge);
        validate(&editor);
        let mesh = editor.mesh().expect("it");
        let vertices = made.created.ids.expect("a local edit").vertices;
        let at = vertices.iter().map(|v| mesh.position(mesh.vertex(*v).expect("made")));
        at.map(|at| at.x.abs()).fold(0.0, f32::max)
    };
    // The hole in the grids is two wide, and its sides go on inwards.
    assert_eq!(outermost(None), 1.0);
    assert_eq!(outermost(Some(0.0)), 1.0);
    assert!(outermost(Some(1.0)) < 0.9, "{}", outermost(Some(1.0)));
}
