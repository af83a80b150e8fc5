//! The selection, and what is hidden and named, stay on the same places when operations renumber or cut elements.

mod support;

use editor::halfedge::geometry::face_area_vector;
use editor::halfedge::{Element, Mesh};
use editor::{Begun, Editor, SelectMode};
use glam::Vec3;
use proptest::prelude::*;
use serde_json::json;
use support::*;

fn select(editor: &mut Editor, kind: Element, ids: &[u32]) {
    editor.select(kind, ids.iter().copied(), SelectMode::Replace).expect("there");
}

fn selected(editor: &Editor) -> (Element, Vec<u32>) {
    (editor.selection().kind(), editor.selection().ids().collect())
}

fn area(mesh: &Mesh, faces: &[u32]) -> f32 {
    faces.iter().map(|&f| face_area_vector(mesh, mesh.face(f).expect("a face")).length() as f32).sum()
}

fn length(mesh: &Mesh, edges: &[u32]) -> f32 {
    let ends = edges.iter().map(|&e| mesh.ends(mesh.edge(e).expect("an edge")).map(|v| mesh.position(v)));
    ends.map(|[a, b]| a.distance(b)).sum()
}

/// Places that tell a selection from any other: of faces and edges also how much of them there is.
fn extent(editor: &Editor) -> (Vec3, f32) {
    let mesh = editor.mesh().expect("a mesh");
    let (kind, ids) = selected(editor);
    let mut sum = Vec3::ZERO;
    let (points, size): (Vec<(Vec3, f32)>, f32) = match kind {
        Element::Vertex => (
            ids.iter().map(|&v| (mesh.position(mesh.vertex(v).expect("it")), 1.0)).collect(),
            ids.len() as f32,
        ),
        Element::Edge | Element::Halfedge => {
            let edges: Vec<u32> =
                ids.iter().map(|&id| if kind == Element::Edge { id } else { id / 2 }).collect();
            let middle = |e: &u32| {
                let [a, b] = mesh.ends(mesh.edge(*e).expect("it")).map(|v| mesh.position(v));
                ((a + b) * 0.5, a.distance(b))
            };
            (edges.iter().map(middle).collect(), length(mesh, &edges))
        }
        Element::Face => {
            let middle = |f: &u32| {
                let corners: Vec<Vec3> =
                    mesh.face_vertices(mesh.face(*f).expect("it")).map(|v| mesh.position(v)).collect();
                (corners.iter().sum::<Vec3>() / corners.len() as f32, area(mesh, &[*f]))
            };
            (ids.iter().map(middle).collect(), area(mesh, &ids))
        }
    };
    for (at, weight) in points {
        sum += at * weight;
    }
    (sum, size)
}

fn kinds() -> impl Strategy<Value = Element> {
    prop::sample::select(Element::ALL.to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    /// Cutting without moving covers the same places, on meshes with gaps in their ids too.
    #[test]
    fn a_selection_covers_the_same_places_when_the_mesh_is_cut(
        kind in kinds(),
        levels in 1_u32..4,
        picks in prop::collection::btree_set(0_u32..24, 1..8),
        removed in prop::collection::vec(0_u32..6, 0..3),
        as_job in any::<bool>(),
    ) {
        let mut editor = on_cube();
        run(&mut editor, json!({"op": "inset-faces", "faces": [1], "amount": 0.25}));
        let _ = editor.run(command(json!({"op": "delete-faces", "faces": removed})));
        let mesh = editor.mesh().expect("it");
        let ids: Vec<u32> = picks.into_iter().filter(|&id| mesh.exists(kind, id)).collect();
        prop_assume!(!ids.is_empty() && mesh.face_count() > 0);
        select(&mut editor, kind, &ids);
        let before = (selected(&editor), extent(&editor));
        let subdivide = command(json!({"op": "subdivide-linear", "levels": levels}));
        if as_job {
            let Begun::Job(job) = editor.begin_from(subdivide, 0).expect("allowed") else { panic!("no job") };
            let result = job.run(&mut |_| std::ops::ControlFlow::Continue(()));
            editor.finish(job.id(), result).expect("done");
        } else {
            editor.run(subdivide).expect("allowed");
        }
        let (place, size) = extent(&editor);
        prop_assert!((size - before.1.1).abs() < 1e-3, "{} became {size}", before.1.1);
        // Quads of a pentagon have another middle than it; everything else is cut in parts that average to it.
        if kind != Element::Face {
            prop_assert!((place - before.1.0).length() < 1e-3, "{} became {place}", before.1.0);
        }
        let after = selected(&editor);
        editor.undo().expect("it");
        prop_assert_eq!(selected(&editor), before.0);
        editor.redo().expect("it");
        prop_assert_eq!(selected(&editor), after);
    }
}

fn hidden(editor: &Editor) -> Vec<u32> {
    editor.document().active().expect("it").hidden().iter().map(|f| f as u32).collect()
}

/// A command that cuts faces at elements that exist, without moving anything.
fn cut(editor: &Editor, kind: usize, picks: &[u32], place: f32) -> serde_json::Value {
    let mesh = editor.mesh().expect("a mesh");
    let faces: Vec<u32> = mesh.faces().map(|f| f.raw()).collect();
    let edges: Vec<u32> = mesh.edges().map(|e| e.raw()).collect();
    let pick = |from: &[u32], at: usize| from[picks[at % picks.len()] as usize % from.len()];
    let mut some: Vec<u32> = (0..picks.len()).map(|at| pick(&faces, at)).collect();
    some.sort_unstable();
    some.dedup();
    match kind {
        0 => json!({"op": "triangulate-faces", "faces": some}),
        1 => json!({"op": "poke-faces", "faces": some}),
        2 => json!({"op": "split-edge", "edge": pick(&edges, 0), "t": place, "connect": "all"}),
        3 => {
            let face = mesh.face(some[0]).expect("it");
            let corners: Vec<u32> = mesh.face_vertices(face).map(|v| v.raw()).collect();
            let first = picks[0] as usize % corners.len();
            json!({"op": "connect-vertices", "vertices": [corners[first], corners[(first + 2) % corners.len()]]})
        }
        4 => json!({"op": "loop-cut", "edge": pick(&edges, 0), "cuts": 1 + picks[0] % 4, "t": place}),
        5 => json!({"op": "inset-faces", "faces": some, "amount": place * 0.05, "mode": "individual"}),
        _ => json!({"op": "subdivide-linear", "levels": 1}),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    /// Every operation that cuts faces leaves the same places hidden, also with mirror images and as a job.
    #[test]
    fn all_pieces_of_a_hidden_face_are_hidden(
        hides in prop::collection::btree_set(0_u32..24, 1..12),
        cuts in prop::collection::vec(
            (0_usize..7, prop::collection::vec(0_u32..10_000, 1..4), 0.1_f32..0.9, any::<bool>(), any::<bool>()),
            1..4,
        ),
    ) {
        let mut editor = on_cube();
        run(&mut editor, json!({"op": "subdivide-linear", "levels": 1}));
        let hides: Vec<u32> = hides.into_iter().collect();
        select(&mut editor, Element::Face, &hides);
        run(&mut editor, json!({"op": "hide"}));
        let covered = area(editor.mesh().expect("a mesh"), &hides);
        for (kind, picks, place, symmetric, as_job) in cuts {
            let mut value = cut(&editor, kind, &picks, place);
            if symmetric && kind < 6 {
                value["symmetry"] = "x".into();
            }
            let (before, mesh) = (hidden(&editor), editor.mesh().expect("a mesh").clone());
            if as_job {
                let Ok(Begun::Job(job)) = editor.begin_from(command(value.clone()), 0) else { continue };
                let result = job.run(&mut |_| std::ops::ControlFlow::Continue(()));
                if editor.finish(job.id(), result).is_err() {
                    continue;
                }
            } else if editor.run(command(value.clone())).is_err() {
                continue;
            }
            validate(&editor);
            let after = hidden(&editor);
            let now = area(editor.mesh().expect("a mesh"), &after);
            prop_assert!((now - covered).abs() < 1e-3, "{value}: {covered} of {before:?} became {now} of {after:?}");
            if editor.mesh().expect("a mesh") == &mesh {
                // Triangles are triangulated already: that is no step.
                continue;
            }
            editor.undo().expect("a step");
            prop_assert_eq!(hidden(&editor), before, "{}", &value);
            editor.redo().expect("a step");
            prop_assert_eq!(hidden(&editor), after, "{}", value);
        }
    }
}

#[test]
fn all_triangles_of_a_poked_hidden_face_are_hidden() {
    let mut editor = on_cube();
    select(&mut editor, Element::Face, &[2]);
    run(&mut editor, json!({"op": "hide"}));
    run(&mut editor, json!({"op": "poke-faces", "faces": [2, 3]}));
    assert_eq!(hidden(&editor), [2, 6, 7, 8]);
    // Cut again, piece by piece.
    run(&mut editor, json!({"op": "poke-faces", "faces": [7]}));
    assert_eq!(hidden(&editor).len(), 6);
    run(&mut editor, json!({"op": "reveal"}));
    assert!(hidden(&editor).is_empty());
    run(&mut editor, json!({"op": "poke-faces", "faces": [0]}));
    assert!(hidden(&editor).is_empty());
}

#[test]
fn every_subdivision_keeps_the_selection_on_its_faces() {
    let mut quads = Vec::new();
    for op in ["subdivide-linear", "subdivide-catmull-clark"] {
        let mut editor = on_cube();
        select(&mut editor, Element::Face, &[2, 5]);
        run(&mut editor, json!({"op": op, "levels": 2}));
        quads.push(selected(&editor));
        assert_eq!(editor.selection().len(), 32, "{op}");
    }
    assert_eq!(quads[0], quads[1]);
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "icosahedron"}));
    select(&mut editor, Element::Face, &[7]);
    let normal = |editor: &Editor| {
        let mesh = editor.mesh().expect("it");
        let faces = selected(editor).1.into_iter().filter_map(|f| mesh.face(f));
        faces.map(|f| face_area_vector(mesh, f).as_vec3()).sum::<Vec3>().normalize()
    };
    let before = normal(&editor);
    run(&mut editor, json!({"op": "subdivide-loop", "levels": 3}));
    assert_eq!(editor.selection().len(), 64);
    assert!(normal(&editor).dot(before) > 0.999, "the same side of the ball");
    // A preview shows it too, and leaves the selection as it was.
    let kept = selected(&editor);
    editor.update_edit(command(json!({"op": "subdivide-loop"}))).expect("quick");
    assert_eq!(editor.selection().len(), 256);
    editor.cancel_edit();
    assert_eq!(selected(&editor), kept);
}

#[test]
fn smoothing_keeps_the_selection_and_making_anew_drops_it() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "delete-faces", "faces": [0]}));
    select(&mut editor, Element::Face, &[2, 5]);
    let place = extent(&editor).0;
    run(&mut editor, json!({"op": "smooth", "iterations": 1, "strength": 0.1}));
    assert_eq!(selected(&editor), (Element::Face, vec![1, 4]), "without the gap");
    assert!(extent(&editor).0.normalize().dot(place.normalize()) > 0.99);
    run(&mut editor, json!({"op": "remesh", "edge_length": 0.5}));
    assert!(editor.selection().is_empty());
}

#[test]
fn hidden_faces_and_named_selections_follow() {
    let mut editor = on_cube();
    select(&mut editor, Element::Edge, &[3]);
    run(&mut editor, json!({"op": "name-selection", "name": "Rim"}));
    select(&mut editor, Element::Face, &[1]);
    run(&mut editor, json!({"op": "hide"}));
    let outcome = run(&mut editor, json!({"op": "subdivide-catmull-clark", "levels": 1}));
    assert_eq!(outcome.warnings, Vec::<String>::new());
    let object = editor.document().active().expect("it");
    assert_eq!(object.hidden().iter().collect::<Vec<_>>(), [4, 5, 6, 7]);
    run(&mut editor, json!({"op": "select-named", "name": "Rim"}));
    assert_eq!(selected(&editor), (Element::Edge, vec![6, 7]));
    editor.undo().expect("it");
    let object = editor.document().active().expect("it");
    assert_eq!(object.hidden().iter().collect::<Vec<_>>(), [1]);
}

#[test]
fn what_is_cut_stays_selected_as_a_whole() {
    for op in ["triangulate-faces", "poke-faces"] {
        let mut editor = on_cube();
        select(&mut editor, Element::Face, &[0, 1]);
        let covered = area(editor.mesh().expect("it"), &[0, 1]);
        run(&mut editor, json!({"op": op}));
        let (kind, faces) = selected(&editor);
        let mesh = editor.mesh().expect("it");
        assert_eq!(kind, Element::Face);
        assert!((area(mesh, &faces) - covered).abs() < 1e-4, "{op}: {faces:?}");
        assert!(faces.iter().all(|&f| mesh.face_degree(mesh.face(f).expect("it")) == 3), "{op}");
    }
    // All faces at once, with none selected.
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "triangulate-faces"}));
    assert!(editor.selection().is_empty());

    // Edges that are split, of which some share a face.
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "triangulate-faces"}));
    let edges = [0, 1, 2, 5];
    select(&mut editor, Element::Edge, &edges);
    let before = length(editor.mesh().expect("it"), &edges);
    run(&mut editor, json!({"op": "split-edge", "t": 0.3, "connect": "all"}));
    let (kind, halves) = selected(&editor);
    assert_eq!((kind, halves.len()), (Element::Edge, 8));
    assert!((length(editor.mesh().expect("it"), &halves) - before).abs() < 1e-4);
}

#[test]
fn uneven_cuts_that_cross_stay_inside_a_hidden_face() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "subdivide-linear", "levels": 1}));
    select(&mut editor, Element::Face, &[0]);
    run(&mut editor, json!({"op": "hide"}));
    run(&mut editor, json!({"op": "triangulate-faces", "faces": [4, 6]}));
    run(&mut editor, json!({"op": "subdivide-linear", "levels": 1}));
    // The ring passes all quads of the hidden face twice.
    run(&mut editor, json!({"op": "loop-cut", "edge": 142, "cuts": 3, "t": 0.1}));
    let (mesh, hides) = (editor.mesh().expect("a mesh"), hidden(&editor));
    assert_eq!(hides.len(), 4 * 16);
    assert!((area(mesh, &hides) - 0.25).abs() < 1e-5);
}
