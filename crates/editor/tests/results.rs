//! What is selected after an edit, and how the selection stands in for elements.

mod support;

use editor::halfedge::{EdgeId, Element, HalfedgeId, Mesh, VertexId};
use editor::{Begun, Editor, SelectMode};
use serde_json::{Value, json};
use support::*;

fn select(editor: &mut Editor, kind: Element, ids: impl IntoIterator<Item = u32>) {
    editor.select(kind, ids, SelectMode::Replace).expect("there");
}

fn selected(editor: &Editor) -> (Element, Vec<u32>) {
    (editor.selection().kind(), editor.selection().ids().collect())
}

fn positions(editor: &Editor, edges: &[u32]) -> Vec<[f32; 3]> {
    let mesh = editor.mesh().expect("a mesh");
    let ends = edges.iter().flat_map(|&id| mesh.ends(EdgeId::new(id as usize)));
    ends.map(|v| mesh.position(v).to_array()).collect()
}

/// A tube of quads round z, open at both ends: `segments` round and `rings` along.
fn tube(segments: usize, rings: usize) -> Mesh {
    let at = |i: usize| std::f32::consts::TAU * i as f32 / segments as f32;
    let positions = (0..=rings)
        .flat_map(|ring| (0..segments).map(move |i| glam::Vec3::new(at(i).cos(), at(i).sin(), ring as f32)));
    let faces: Vec<[u32; 4]> = (0..rings)
        .flat_map(|ring| {
            (0..segments).map(move |i| {
                let id = |ring: usize, i: usize| (ring * segments + i % segments) as u32;
                [id(ring, i), id(ring, i + 1), id(ring + 1, i + 1), id(ring + 1, i)]
            })
        })
        .collect();
    build(positions.collect(), &faces)
}

/// The edges along z between two rings of a tube.
fn upright(mesh: &Mesh, segments: usize, ring: usize) -> Vec<u32> {
    let edge = |i: usize| {
        let at = |ring: usize| VertexId::new(ring * segments + i);
        mesh.find_halfedge(at(ring), at(ring + 1)).expect("an edge").edge().raw()
    };
    (0..segments).map(edge).collect()
}

/// The edges at one end of a tube.
fn rim(mesh: &Mesh) -> Vec<u32> {
    mesh.loop_of(mesh.boundary_loops()[0]).map(|h| h.edge().raw()).collect()
}

#[test]
fn edits_select_what_they_made() {
    let mut editor = on_cube();
    let all_faces: Vec<u32> = (0..6).collect();
    select(&mut editor, Element::Edge, [0]);
    let made = run(&mut editor, json!({"op": "bevel-edges", "width": 0.1, "segments": 2}));
    let strip = made.created.ids.expect("a local edit").faces;
    assert!(strip.len() == 2 && strip.iter().all(|id| !all_faces.contains(id)), "the strip: {strip:?}");
    // Who works on edges goes on with edges: those of the strip.
    let mesh = editor.mesh().expect("a mesh");
    let sides = strip.iter().flat_map(|id| mesh.face_halfedges(mesh.face(*id).expect("a face")));
    let mut edges: Vec<u32> = sides.map(|h| h.edge().raw()).collect();
    edges.sort_unstable();
    edges.dedup();
    assert_eq!(selected(&editor), (Element::Edge, edges.clone()));
    assert_eq!(edges.len(), 7);
    editor.undo().expect("free");
    assert_eq!(selected(&editor), (Element::Edge, vec![0]), "as before");
    editor.redo().expect("free");
    assert_eq!(selected(&editor), (Element::Edge, edges));

    let mut editor = on_cube();
    select(&mut editor, Element::Vertex, [0, 7]);
    run(&mut editor, json!({"op": "bevel-vertices", "width": 0.1}));
    let mesh = editor.mesh().expect("a mesh");
    let corners = [6, 7].map(|id| mesh.face_vertices(mesh.face(id).expect("a corner cut off")));
    let mut vertices: Vec<u32> = corners.into_iter().flatten().map(|v| v.raw()).collect();
    vertices.sort_unstable();
    assert_eq!(selected(&editor), (Element::Vertex, vertices));

    // A cut leaves its edges selected, or its vertices for who works on those, as in Blender; faces give way to edges.
    for (kind, made) in [
        (Element::Vertex, (Element::Vertex, 4)),
        (Element::Edge, (Element::Edge, 4)),
        (Element::Face, (Element::Edge, 4)),
    ] {
        let mut editor = on_cube();
        select(&mut editor, kind, [0]);
        editor.update_edit(command(json!({"op": "loop-cut", "edge": 0}))).expect("a ring");
        editor.commit_edit();
        assert_eq!((editor.selection().kind(), editor.selection().len()), made, "{kind}");
    }

    for op in [json!({"op": "extrude-faces", "distance": 0.5}), json!({"op": "inset-faces", "amount": 0.1})] {
        let mut editor = on_cube();
        select(&mut editor, Element::Face, [1, 3]);
        run(&mut editor, op.clone());
        assert_eq!(selected(&editor), (Element::Face, vec![1, 3]), "the moved faces: {op}");
    }

    let mut editor = Editor::with_mesh("Tube", tube(6, 1));
    let rim = rim(editor.mesh().expect("it"));
    select(&mut editor, Element::Edge, rim);
    run(&mut editor, json!({"op": "extrude-edges", "offset": [0, 0, -3]}));
    let (kind, edges) = selected(&editor);
    assert_eq!((kind, edges.len()), (Element::Edge, 6));
    assert!(positions(&editor, &edges).iter().all(|p| p[2] == -3.0), "the far ends, to be extruded again");
}

#[test]
fn a_loop_cut_selects_the_cuts_only() {
    for (rings, cuts) in [(1, 1), (1, 3), (3, 2)] {
        let mut editor = Editor::with_mesh("Tube", tube(8, rings));
        let ring = upright(editor.mesh().expect("it"), 8, 0);
        select(&mut editor, Element::Edge, [ring[0]]);
        run(&mut editor, json!({"op": "loop-cut", "cuts": cuts}));
        let (kind, edges) = selected(&editor);
        assert_eq!((kind, edges.len()), (Element::Edge, 8 * cuts), "{rings} rings, {cuts} cuts");
        let places = positions(&editor, &edges);
        assert!(places.chunks(2).all(|ends| ends[0][2] == ends[1][2] && ends[0][2].fract() != 0.0));
    }
    // Along the tube the ring is open, and its ends are on the boundary.
    let mut editor = Editor::with_mesh("Tube", tube(8, 3));
    let rim = rim(editor.mesh().expect("it"));
    select(&mut editor, Element::Edge, [rim[0]]);
    run(&mut editor, json!({"op": "loop-cut", "cuts": 2}));
    assert_eq!(editor.selection().len(), 3 * 2);
}

#[test]
fn a_selected_ring_is_cut_once() {
    let mut editor = Editor::with_mesh("Tube", tube(8, 3));
    let mesh = editor.mesh().expect("it").clone();
    let ring = upright(&mesh, 8, 1);
    select(&mut editor, Element::Edge, ring);
    assert_eq!(editor.can(&command(json!({"op": "loop-cut"}))), Ok(()));
    run(&mut editor, json!({"op": "loop-cut"}));
    assert_eq!(sizes(&editor)[2], 8 * 4, "one more row of quads");
    assert_eq!(editor.undo_labels().count(), 1);

    let mut editor = Editor::with_mesh("Tube", mesh.clone());
    select(&mut editor, Element::Edge, upright(&mesh, 8, 0).into_iter().chain(upright(&mesh, 8, 2)));
    run(&mut editor, json!({"op": "loop-cut"}));
    assert_eq!(sizes(&editor)[2], 8 * 5, "two rings");
    // Across each other: every quad of the crossing rows becomes a grid.
    let mut editor = Editor::with_mesh("Tube", mesh.clone());
    select(&mut editor, Element::Edge, [upright(&mesh, 8, 1)[0], rim(&mesh)[0]]);
    run(&mut editor, json!({"op": "loop-cut"}));
    assert_eq!(sizes(&editor)[2], 4 * 9);
    assert_eq!(editor.selection().len(), 9 + 4, "both cuts");
}

#[test]
fn a_script_that_names_its_elements_keeps_the_selection() {
    let mut editor = on_cube();
    select(&mut editor, Element::Vertex, [3]);
    run(&mut editor, json!({"op": "bevel-edges", "edges": [[4, 5]], "width": 0.1}));
    assert_eq!(selected(&editor), (Element::Vertex, vec![3]));
}

#[test]
fn a_job_and_a_preview_select_the_same() {
    let mut editor = on_cube();
    select(&mut editor, Element::Edge, [0]);
    let bevel = |width: f64| command(json!({"op": "bevel-edges", "width": width}));
    for width in [0.1, 0.2] {
        editor.update_edit(bevel(width)).expect("possible");
        assert_eq!(selected(&editor), (Element::Edge, vec![12, 13, 14, 15]));
    }
    let refused = command(json!({"op": "bevel-edges", "edges": [99], "width": 0.1}));
    editor.update_edit(refused).expect_err("no such edge");
    assert_eq!(selected(&editor), (Element::Edge, vec![12, 13, 14, 15]), "of the preview that stays");
    editor.cancel_edit();
    assert_eq!(selected(&editor), (Element::Edge, vec![0]));

    let Ok(Begun::Job(request)) = editor.begin_from(bevel(0.1), 0) else { panic!("a job") };
    let result = request.run(&mut |_| std::ops::ControlFlow::Continue(()));
    editor.finish(request.id(), result).expect("done");
    assert_eq!(selected(&editor), (Element::Edge, vec![12, 13, 14, 15]));
}

#[test]
fn inner_edges_of_a_selection_are_not_extruded() {
    let mut editor = Editor::with_mesh("Tube", tube(6, 1));
    let mesh = editor.mesh().expect("it").clone();
    let (rim, inner) = (rim(&mesh), upright(&mesh, 6, 0));
    select(&mut editor, Element::Edge, rim.iter().copied().chain([inner[0]]));
    let extrude = || json!({"op": "extrude-edges", "offset": [0, 0, -1]});
    assert_eq!(editor.can(&command(extrude())), Ok(()));
    run(&mut editor, extrude());
    assert_eq!(sizes(&editor)[2], 12);

    let mut editor = Editor::with_mesh("Tube", mesh);
    select(&mut editor, Element::Edge, inner);
    let reason = editor.can(&command(extrude())).expect_err("no boundary").reason();
    assert!(reason.ends_with("has a face on both sides; choose an edge on the boundary."), "{reason}");
}

#[test]
fn a_hole_is_filled_from_either_side_of_its_edges() {
    let fill = || json!({"op": "fill-hole"});
    let mesh = tube(6, 1);
    let open = HalfedgeId::new(mesh.boundary_loops()[0].index());
    let inner = upright(&mesh, 6, 0);
    for (kind, ids) in [
        (Element::Halfedge, vec![open.raw()]),
        (Element::Halfedge, vec![open.twin().raw()]),
        (Element::Halfedge, vec![open.raw(), open.twin().raw()]),
        (Element::Edge, vec![open.edge().raw()]),
        (Element::Edge, vec![inner[0], open.edge().raw(), inner[1]]),
        (Element::Edge, rim(&mesh)),
    ] {
        let mut editor = Editor::with_mesh("Tube", mesh.clone());
        select(&mut editor, kind, ids.iter().copied());
        assert_eq!(editor.can(&command(fill())), Ok(()), "{kind} {ids:?}");
        run(&mut editor, fill());
        assert_eq!(
            (sizes(&editor)[2], editor.mesh().expect("it").boundary_loops().len()),
            (7, 1),
            "{kind} {ids:?}"
        );
    }
    let mut editor = Editor::with_mesh("Tube", mesh);
    select(&mut editor, Element::Edge, [inner[0]]);
    let reason = editor.can(&command(fill())).expect_err("no hole").reason();
    assert!(reason.ends_with("has a face on both sides; choose an edge on the boundary."), "{reason}");
    editor.deselect();
    let reason = editor.can(&command(fill())).expect_err("nothing selected").reason();
    assert_eq!(reason, "Select an edge or a half-edge first.");
}

#[test]
fn what_can_not_be_separated_is_greyed_with_the_reason() {
    let can = |editor: &Editor, op: Value| editor.can(&command(op)).map_err(|error| error.reason());
    let by = |by: &str| json!({"op": "separate", "by": by});
    let one_piece = Err("The mesh is one connected piece. Select the faces to separate first.".to_owned());
    let mut editor = on_cube();
    assert_eq!(can(&editor, json!({"op": "separate"})), one_piece);
    assert_eq!(can(&editor, by("components")), one_piece);
    assert_eq!(can(&editor, by("groups")), Err("No face is in a group.".to_owned()));
    assert_eq!(can(&editor, by("faces")), Err("Select a face first.".to_owned()));
    select(&mut editor, Element::Edge, [0]);
    assert_eq!(can(&editor, by("faces")), Err("Select a face first.".to_owned()));
    // Selected faces are separated without a word more.
    select(&mut editor, Element::Face, [0, 1]);
    assert_eq!(can(&editor, json!({"op": "separate"})), Ok(()));
    run(&mut editor, json!({"op": "separate"}));
    let faces: Vec<usize> = editor.document().objects().iter().map(|o| o.mesh().face_count()).collect();
    assert_eq!(faces, [4, 2]);
    let editor = Editor::with_mesh("Patches", patches());
    assert_eq!(can(&editor, json!({"op": "separate"})), Ok(()), "two pieces");
}

#[test]
fn the_clicked_element_of_a_line_is_the_latest() {
    use editor::surface::selecting::Line;
    let mesh = tube(8, 3);
    let ring = upright(&mesh, 8, 1);
    for &edge in &ring {
        let mut editor = Editor::with_mesh("Tube", mesh.clone());
        editor.select_line(Element::Edge, 2 * edge, Line::Ring, SelectMode::Replace).expect("there");
        assert_eq!((editor.selection().len(), editor.selection().latest()), (8, Some(edge)));
        editor.select_line(Element::Halfedge, 2 * edge + 1, Line::Ring, SelectMode::Replace).expect("there");
        assert_eq!(editor.selection().latest(), Some(2 * edge + 1));
    }
}

#[test]
fn a_new_document_counts_only_what_is_in_it() {
    let mut editor = on_cube();
    let outcome = run(&mut editor, json!({"op": "new", "shape": "tetrahedron"}));
    assert_eq!(outcome.message, "New shape: 4 vertices, 6 edges and 4 faces created");
    assert_eq!(outcome.removed.vertices, 8, "what was removed is still counted");
}
