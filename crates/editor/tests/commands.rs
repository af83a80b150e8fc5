//! Every operation through its JSON: its effect, its outcome and its refusals.

mod support;

use editor::halfedge::{Color, Element, Mesh, VertexId, keys};
use editor::{Command, Editor, OpId, SelectMode};
use glam::Vec3;
use serde_json::{Value, json};
use support::*;

#[test]
fn set_vertex_position_moves_one_vertex() {
    let mut editor = on_cube();
    let outcome =
        run(&mut editor, json!({"op": "set-vertex-position", "vertex": 3, "position": [0.1, -2, 3e5]}));
    assert_eq!(editor.mesh().expect("a cube").position(VertexId::new(3)).to_array(), [0.1, -2.0, 3e5]);
    assert_eq!(outcome.op.name(), "set-vertex-position");
    assert!(outcome.created.is_empty() && outcome.removed.is_empty());
}

#[test]
fn set_face_color_paints() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "set-face-color", "faces": [1, 4], "color": "#102030"}));
    let mesh = editor.mesh().expect("a cube");
    let colors: Vec<Color> = (0..6).map(|f| mesh.get(keys::FACE_COLOR, f)).collect();
    let (new, old) = (Color([0x10, 0x20, 0x30]), Color::UNPAINTED);
    assert_eq!(colors, [old, new, old, old, new, old]);
}

#[test]
fn split_edge_reports_what_it_made() {
    let mut editor = on_cube();
    let outcome = run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    let json = serde_json::to_value(&outcome).expect("plain data");
    assert_eq!(
        json["created"],
        json!({"vertices": 1, "edges": 1, "faces": 0, "ids": {"vertices": [8], "edges": [12], "faces": []}})
    );
    assert_eq!(outcome.message, "Split edge: 1 vertex and 1 edge created");
    let outcome = run(&mut on_cube(), json!({"op": "split-edge", "edge": 0, "connect": "all", "t": 0.25}));
    assert_eq!((outcome.created.vertices, outcome.created.edges, outcome.created.faces), (1, 3, 2));
    let outcome = run(&mut on_cube(), json!({"op": "split-edge", "edge": 0, "connect": "none"}));
    assert_eq!((outcome.created.vertices, outcome.created.edges, outcome.created.faces), (1, 1, 0));
    // By its ends, either way round.
    for ends in [[2, 3], [3, 2]] {
        let mut editor = on_cube();
        run(&mut editor, json!({"op": "split-edge", "edge": ends, "connect": "none"}));
        assert_eq!(editor.mesh().expect("a cube").position(VertexId::new(8)).to_array(), [0.5, 1.0, 0.0]);
    }
}

#[test]
fn split_edge_cuts_triangles_of_any_mesh() {
    let mut editor = Editor::with_mesh("Patches", patches());
    let edges = editor.mesh().expect("patches").edge_count();
    for e in 0..edges {
        run(&mut editor, json!({"op": "split-edge", "edge": e, "connect": "triangles"}));
    }
    assert_eq!(editor.undo_labels().count(), edges);
}

#[test]
fn triangulate_faces_cuts_all_or_some() {
    let mut editor = on_cube();
    let outcome = run(&mut editor, json!({"op": "triangulate-faces"}));
    assert_eq!(sizes(&editor), [8, 18, 12]);
    assert_eq!((outcome.created.vertices, outcome.created.edges, outcome.created.faces), (0, 6, 6));
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "triangulate-faces", "faces": [2], "method": "fan"}));
    assert_eq!(sizes(&editor), [8, 13, 7]);
}

#[test]
fn subdivisions_multiply_faces() {
    let mut editor = on_cube();
    let outcome = run(&mut editor, json!({"op": "subdivide-catmull-clark"}));
    assert_eq!(sizes(&editor), [26, 48, 24]);
    assert_eq!((outcome.created.vertices, outcome.created.edges, outcome.created.faces), (18, 36, 18));
    assert_eq!(outcome.created.ids, None);
    run(&mut editor, json!({"op": "subdivide-linear", "levels": 2}));
    assert_eq!(sizes(&editor)[2], 24 * 16);
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "triangulate-faces"}));
    run(
        &mut editor,
        json!({"op": "subdivide-loop", "levels": 2, "weights": "warren", "boundary": "edge-and-corner"}),
    );
    assert_eq!(sizes(&editor)[2], 12 * 16);
    let mut editor = on_cube();
    let rule = json!({"op": "subdivide-catmull-clark", "boundary": "edge-and-corner", "vertex_rule": "smoothed-midpoints"});
    run(&mut editor, rule);
    assert_eq!(sizes(&editor), [26, 48, 24]);
}

#[test]
fn loop_subdivision_refuses_polygons_in_words() {
    let text = refusal(&mut on_cube(), json!({"op": "subdivide-loop"}));
    assert!(text.starts_with("subdivide-loop: ") && text.contains("triangles"), "{text}");
}

#[test]
fn new_makes_every_shape() {
    let spec = OpId::New.spec();
    for name in surface::Shape::names() {
        let mut editor = on_two();
        run(&mut editor, json!({"op": "new", "shape": name}));
        assert_eq!(editor.document().objects().len(), 1);
        let object = editor.document().active().expect("it");
        let is_curve = object.bezier().is_some_and(|bezier| bezier.curve().is_some());
        assert_eq!(object.mesh().face_count() > 0, !is_curve, "{name}");
        assert_eq!(object.bezier().is_some(), name.starts_with("bezier-"), "{name}");
        for field in surface::Shape::named(name).expect("listed").fields() {
            assert!(spec.field(field.name).is_some(), "{name}: {}", field.name);
            run(&mut editor, json!({"op": "new", "shape": name, field.name: field.default}));
        }
    }
    let mut editor = on_cube();
    let added = run(&mut editor, json!({"op": "new", "shape": "ico-sphere", "subdivisions": 1, "add": true}));
    assert_eq!((added.created.faces, added.removed.faces), (80, 0));
    assert_eq!(editor.document().objects().len(), 2);
    assert_eq!(editor.document().active_index(), 1);
    assert_eq!(editor.document().active().expect("it").name(), "Ico sphere");
    assert_eq!(sizes(&editor)[2], 80);
    editor.undo().expect("free");
    assert_eq!(editor.document().objects().len(), 1);
    assert_eq!(sizes(&editor)[2], 6);
}

#[test]
fn new_starts_over_and_undo_brings_the_document_back() {
    let mut editor = on_two();
    let before = editor.document().clone();
    let gone: usize = before.objects().iter().map(|object| object.mesh().face_count()).sum();
    let outcome = run(&mut editor, json!({"op": "new", "shape": "tetrahedron"}));
    assert_eq!(outcome.created.faces, 4, "all of it is new");
    assert_eq!(outcome.removed.faces, gone, "nothing stays of two cubes");
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
}

#[test]
fn objects_are_activated_renamed_hidden_and_deleted() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "activate-object", "object": 1}));
    assert_eq!(editor.document().active_index(), 1);
    run(&mut editor, json!({"op": "rename-object", "name": " Floor "}));
    run(&mut editor, json!({"op": "rename-object", "object": 0, "name": "Box"}));
    let names: Vec<&str> = editor.document().objects().iter().map(|o| o.name()).collect();
    assert_eq!(names, ["Box", "Floor"]);
    run(&mut editor, json!({"op": "set-object-visible", "object": 0, "visible": false}));
    assert!(!editor.document().objects()[0].visible() && editor.document().objects()[1].visible());
    run(&mut editor, json!({"op": "delete-object", "object": 0}));
    assert_eq!(editor.document().active_index(), 0);
    assert_eq!(editor.document().active().expect("it").name(), "Floor");
    let text = refusal(&mut editor, json!({"op": "delete-object"}));
    assert!(text.contains("`object`") && text.contains("at least one"), "{text}");
    for _ in 0..5 {
        editor.undo().expect("free");
    }
    assert_eq!(editor.document(), on_two().document());
}

#[test]
fn the_same_name_again_is_no_step() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    let name = editor.document().objects()[0].name().to_owned();
    run(&mut editor, json!({"op": "rename-object", "object": 0, "name": name}));
    assert_eq!(editor.last_command().map(|last| last.name()), Some("split-edge"));
    editor.undo().expect("free");
    assert_eq!(editor.document(), on_two().document());
}

#[test]
fn joining_with_a_visible_object_keeps_the_result_visible() {
    for (hidden, visible) in [(vec![0], true), (vec![1], true), (vec![0, 1], false)] {
        let mut editor = on_two();
        for object in &hidden {
            run(&mut editor, json!({"op": "set-object-visible", "object": object, "visible": false}));
        }
        let before = editor.document().clone();
        run(&mut editor, json!({"op": "join-objects", "objects": [0, 1]}));
        assert_eq!(editor.document().objects()[0].visible(), visible, "{hidden:?}");
        editor.undo().expect("free");
        assert_eq!(*editor.document(), before);
    }
}

#[test]
fn commands_act_on_the_object_they_name() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "subdivide-linear", "object": 1}));
    run(&mut editor, json!({"op": "split-edge", "object": 1, "edge": 0}));
    assert_eq!(sizes(&editor), [8, 12, 6]);
    assert_eq!(editor.document().objects()[1].mesh().vertex_count(), 26);
    for op in
        [json!({"op": "split-edge", "edge": 0, "object": 2}), json!({"op": "subdivide-linear", "object": 2})]
    {
        let text = refusal(&mut editor, op);
        assert!(text.contains("`object`: there is no object 2"), "{text}");
    }
}

#[test]
fn join_and_separate_reverse_each_other() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "set-face-color", "faces": [0], "color": "#ff0000"}));
    let parts: Vec<_> = editor.document().objects().iter().map(|o| o.mesh().clone()).collect();
    run(&mut editor, json!({"op": "join-objects", "objects": [0, 1]}));
    assert_eq!(editor.document().objects().len(), 1);
    assert_eq!(sizes(&editor), [17, 24, 10]);
    run(&mut editor, json!({"op": "separate", "by": "components"}));
    assert_eq!(editor.document().objects().len(), 2);
    assert_eq!(editor.document().objects()[0].mesh(), &parts[0]);
    assert_eq!(editor.document().objects()[1].mesh().face_count(), parts[1].face_count());
    assert_eq!(editor.document().objects()[1].name(), "Cube 2");
    assert_eq!(editor.document().active_index(), 0);
    // Joined the other way round, the second object's place is kept.
    run(&mut editor, json!({"op": "join-objects", "objects": [1, 0]}));
    assert_eq!(editor.document().active().expect("it").name(), "Cube 2");
}

#[test]
fn separate_by_faces_and_groups() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "separate", "faces": [0, 5]}));
    let faces: Vec<usize> = editor.document().objects().iter().map(|o| o.mesh().face_count()).collect();
    assert_eq!(faces, [4, 2]);
    let mut editor = on_cube();
    editor.select(Element::Face, [1], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "separate", "by": "faces"}));
    assert_eq!(editor.document().objects()[1].mesh().face_count(), 1);
    let text = refusal(&mut on_cube(), json!({"op": "separate", "by": "groups"}));
    assert!(text.contains("`by`: no face is in a group"), "{text}");

    let mut mesh = cube();
    let mut column =
        editor::halfedge::attribute::Column::with_values(keys::FACE_GROUP, vec![1, 1, 0, 0, 7, u32::MAX]);
    column.labels = vec!["lid".into(), "side".into()];
    mesh.insert_column(Element::Face, column);
    let mut editor = Editor::with_mesh("Box", mesh);
    run(&mut editor, json!({"op": "separate", "by": "groups"}));
    let names: Vec<&str> = editor.document().objects().iter().map(|o| o.name()).collect();
    assert_eq!(names, ["side", "lid", "Group 7", "No group"]);
}

#[test]
fn transform_scales_rotates_and_moves() {
    let at = |editor: &Editor, v: usize| editor.mesh().expect("it").position(VertexId::new(v)).to_array();
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "transform", "vertices": [7], "translate": [0.5, 0, -0.25]}));
    assert_eq!(at(&editor, 7), [1.5, 1.0, 0.75]);
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "transform", "faces": [0], "scale": 3}));
    assert_eq!((at(&editor, 0), at(&editor, 3)), ([-1.0, -1.0, 0.0], [2.0, 2.0, 0.0]));
    let mut editor = on_cube();
    let turn = json!({"axis": [0, 0, 2], "degrees": 90});
    run(
        &mut editor,
        json!({"op": "transform", "edges": [[0, 1]], "rotate": turn, "pivot": [0, 0, 0], "scale": [2, 1, 1]}),
    );
    let [x, y, z] = at(&editor, 1);
    assert!(x.abs() < 1e-6 && (y - 2.0).abs() < 1e-6 && z == 0.0, "{:?}", at(&editor, 1));
    assert_eq!(at(&editor, 2), [0.0, 1.0, 0.0]);
}

#[test]
fn levels_have_a_limit_on_meshes_without_faces_too() {
    for op in ["subdivide-linear", "subdivide-catmull-clark", "subdivide-loop"] {
        let error = Command::from_value(json!({"op": op, "levels": 13})).expect_err("too many levels");
        assert_eq!(error.to_string(), format!("{op}: `levels`: 13 is out of range; it must be from 1 to 12"));
        run(&mut Editor::with_mesh("Points", Mesh::new()), json!({"op": op, "levels": 12}));
    }
}

#[test]
fn a_long_axis_is_a_direction_too() {
    let mut editor = on_cube();
    let before = editor.mesh().expect("a cube").positions().to_vec();
    let turn = json!({"axis": [0, 0, 1e38], "degrees": 90});
    run(&mut editor, json!({"op": "transform", "vertices": [1], "rotate": turn, "pivot": [0, 0, 0]}));
    let [old, new] = [before[1], editor.mesh().expect("a cube").position(VertexId::new(1))];
    assert!(new.distance(Vec3::new(-old.y, old.x, old.z)) < 1e-5, "{old} became {new}");
}

#[test]
fn transform_scales_along_turned_axes() {
    let mut editor = on_cube();
    let before = editor.mesh().expect("a cube").positions().to_vec();
    let turned = json!({"axis": [0, 0, 1], "degrees": 90});
    run(
        &mut editor,
        json!({"op": "transform", "vertices": [0, 1, 2, 3, 4, 5, 6, 7], "scale": [3, 1, 1],
        "orientation": turned, "pivot": [0, 0, 0]}),
    );
    for (old, new) in before.iter().zip(editor.mesh().expect("a cube").positions()) {
        // The x axis of the scale is the mesh's y axis.
        let wanted = *old * Vec3::new(1.0, 3.0, 1.0);
        assert!(new.distance(wanted) < 1e-5, "{old} became {new}");
    }
    let short = json!({"op": "transform", "vertices": [0], "scale": 2, "orientation": {"axis": [0, 0, 0], "degrees": 5}});
    let error = editor.run(Command::from_value(short).expect("a command")).expect_err("no axis");
    assert!(error.to_string().contains("orientation.axis"), "{error}");
}

#[test]
fn symmetric_transforms_move_mirror_images_too() {
    let mut editor = Editor::default();
    run(&mut editor, json!({"op": "new", "shape": "cube"}));
    let before = editor.mesh().expect("a cube").positions().to_vec();
    let at = |x: f32, y: f32, z: f32| {
        before.iter().position(|p| *p == Vec3::new(x, y, z)).expect("a corner of the cube")
    };
    let (right, left) = (at(1.0, 1.0, 1.0), at(-1.0, 1.0, 1.0));
    let by = Vec3::new(0.25, 0.5, -0.125);
    let translate = by.to_array();
    run(
        &mut editor,
        json!({"op": "transform", "vertices": [right], "translate": translate, "symmetry": "x"}),
    );
    for (v, old) in before.iter().enumerate() {
        let wanted = match v {
            _ if v == right => *old + by,
            _ if v == left => *old + by * Vec3::new(-1.0, 1.0, 1.0),
            _ => *old,
        };
        assert_eq!(editor.mesh().expect("a cube").positions()[v], wanted, "vertex {v}");
    }
    editor.undo().expect("a step");
    assert_eq!(editor.mesh().expect("a cube").positions(), before);

    // The one that moves farther leads; here both move equally, and the one on the positive side does.
    run(
        &mut editor,
        json!({"op": "transform", "vertices": [left, right], "translate": translate, "symmetry": "x"}),
    );
    let after = editor.mesh().expect("a cube").positions().to_vec();
    assert_eq!(after[right], before[right] + by);
    assert_eq!(after[left], before[left] + by * Vec3::new(-1.0, 1.0, 1.0));
    editor.undo().expect("a step");

    // A vertex in the plane stays in it.
    run(&mut editor, json!({"op": "split-edge", "edge": [left, right], "connect": "none"}));
    let middle = before.len();
    assert_eq!(editor.mesh().expect("a mesh").positions()[middle].x, 0.0);
    run(
        &mut editor,
        json!({"op": "transform", "vertices": [middle], "translate": translate, "symmetry": "x"}),
    );
    let moved = editor.mesh().expect("a mesh").positions()[middle];
    assert_eq!(moved, Vec3::new(0.0, 1.5, 0.875));
}

#[test]
fn parts_are_scaled_about_their_own_middles() {
    let mut editor = on_cube();
    let before = editor.mesh().expect("a cube").positions().to_vec();
    let middle = |positions: &[Vec3], mesh: &Mesh, f: u32| {
        let corners: Vec<Vec3> =
            mesh.face_vertices(mesh.face(f).expect("a face")).map(|v| positions[v.index()]).collect();
        corners.iter().sum::<Vec3>() / corners.len() as f32
    };
    // Opposite faces share no vertex.
    let mesh = editor.mesh().expect("a cube").clone();
    let corners = |f| mesh.face_vertices(mesh.face(f).expect("a face")).collect::<Vec<_>>();
    let other = (1..6).find(|f| corners(*f).iter().all(|v| !corners(0).contains(v))).expect("a face across");
    run(&mut editor, json!({"op": "transform", "faces": [0, other], "scale": 0.5, "individual": true}));
    let after = editor.mesh().expect("a cube").positions().to_vec();
    for f in [0, other] {
        let (old, new) = (middle(&before, &mesh, f), middle(&after, &mesh, f));
        assert!(old.distance(new) < 1e-6, "the middle of a part stays");
        for v in corners(f) {
            let wanted = old + (before[v.index()] - old) * 0.5;
            assert!(after[v.index()].distance(wanted) < 1e-6);
        }
    }
}

#[test]
fn transform_falls_off_along_the_surface() {
    let mut editor = Editor::with_mesh("Patches", patches());
    run(&mut editor, json!({"op": "transform", "vertices": [0], "translate": [0, 0, 1], "falloff": 2.0}));
    let z: Vec<f32> = editor.mesh().expect("it").positions().iter().map(|p| p.z - 0.25).collect();
    assert_eq!(z[0], 1.0);
    assert!((z[1] - 0.5).abs() < 1e-6 && (z[3] - 0.5).abs() < 1e-6, "{z:?}");
    assert!(z[4] > 0.0 && z[4] < z[1], "{z:?}");
    assert_eq!(z[2], 0.0, "a vertex at the radius stays");
    assert!(z[9..].iter().all(|&z| z == -0.25), "another piece stays");
}

#[test]
fn a_command_without_elements_acts_on_the_selection() {
    let mut editor = on_cube();
    editor.select(Element::Edge, [0, 5], SelectMode::Replace).expect("there");
    let outcome = run(&mut editor, json!({"op": "split-edge", "connect": "none"}));
    assert_eq!(outcome.created.vertices, 2);
    assert_eq!(editor.undo_labels().count(), 1);
    editor.select(Element::Halfedge, [0], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "split-edge"}));
    editor.select(Element::Vertex, [2], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "set-vertex-position", "position": [9, 9, 9]}));
    assert_eq!(editor.mesh().expect("it").position(VertexId::new(2)).x, 9.0);
    editor.select(Element::Face, [1, 2], SelectMode::Replace).expect("there");
    run(&mut editor, json!({"op": "set-face-color", "color": "#000000"}));
    run(&mut editor, json!({"op": "triangulate-faces"}));
    let mesh = editor.mesh().expect("it");
    assert!(mesh.face_degree(mesh.face(0).expect("there")) > 3, "a face that was not selected is whole");
    run(&mut editor, json!({"op": "transform", "translate": [1, 0, 0]}));
}

#[test]
fn refusals_name_the_op_and_the_field() {
    let cases: &[(Value, &[&str])] = &[
        (json!([1]), &["command"]),
        (json!({}), &["command", "`op`", "missing"]),
        (json!({"op": 3}), &["command", "`op`"]),
        (json!({"op": "explode"}), &["explode", "no such op"]),
        (json!({"op": "split_edge"}), &["split_edge", "did you mean `split-edge`"]),
        (json!({"op": "split-edge"}), &["split-edge", "`edge`", "missing"]),
        (json!({"op": "split-edge", "edge": 99}), &["split-edge", "`edge`", "no edge 99", "0 to 11"]),
        (json!({"op": "split-edge", "edge": -1}), &["split-edge", "`edge`", "-1", "an edge id"]),
        (json!({"op": "split-edge", "edge": 1.5}), &["split-edge", "`edge`", "1.5"]),
        (json!({"op": "split-edge", "edge": "first"}), &["split-edge", "`edge`", "first", "an edge id"]),
        (json!({"op": "split-edge", "edge": 4294967295u32}), &["split-edge", "`edge`"]),
        (json!({"op": "split-edge", "edge": 4294967296u64}), &["split-edge", "`edge`"]),
        (json!({"op": "split-edge", "edge": [0]}), &["split-edge", "`edge", "pair"]),
        (json!({"op": "split-edge", "edge": [0, 1, 2]}), &["split-edge", "`edge", "pair"]),
        (
            json!({"op": "split-edge", "edge": [0, 7]}),
            &["split-edge", "`edge`", "no edge joins vertex 0 and vertex 7"],
        ),
        (json!({"op": "split-edge", "edge": [0, 80]}), &["split-edge", "`edge`", "no vertex 80"]),
        (json!({"op": "split-edge", "edge": 0, "t": 1}), &["split-edge", "`t`", "above 0 and below 1"]),
        (json!({"op": "split-edge", "edge": [1, 0], "t": 0}), &["split-edge", "`t`: 0 is out of range"]),
        (
            json!({"op": "collapse-edge", "edge": [1, 0], "t": 2}),
            &["collapse-edge", "`t`: 2 is out of range"],
        ),
        (
            json!({"op": "subdivide-linear", "levels": 10_000_000_000u64}),
            &["`levels`", "too large", "4294967295"],
        ),
        (json!({"op": "transform", "vertices": []}), &["transform", "no vertex was given"]),
        (json!({"op": "set-face-color", "faces": [], "color": "#ff0000"}), &["no face was given"]),
        (json!({"op": "triangulate-faces", "faces": []}), &["no face was given"]),
        (json!({"op": "split-edge", "edge": 0, "t": 1e39}), &["split-edge", "`t`", "finite"]),
        (json!({"op": "split-edge", "edge": 0, "t": null}), &["split-edge", "`t`"]),
        (json!({"op": "split-edge", "edge": 0, "T": 1}), &["split-edge", "`T`", "not a field", "`t`"]),
        (
            json!({"op": "split-edge", "edge": 0, "connect": "some"}),
            &["split-edge", "`connect`", "`some`", "`triangles`"],
        ),
        (json!({"op": "split-edge", "edge": 0, "object": -1}), &["split-edge", "`object`", "-1"]),
        (json!({"op": "split-edge", "edge": 0, "object": 5}), &["split-edge", "`object`", "no object 5"]),
        (
            json!({"op": "set-vertex-position", "vertex": 0}),
            &["set-vertex-position", "`position`", "missing"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 1]}),
            &["set-vertex-position", "`position"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 1, 1e300]}),
            &["set-vertex-position", "`position[2]`", "finite"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": [0, "x", 1]}),
            &["set-vertex-position", "`position[1]`"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": [0, 1], "position": [0, 0, 1]}),
            &["set-vertex-position", "`vertex`"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 8, "position": [0, 0, 1]}),
            &["set-vertex-position", "`vertex`", "no vertex 8"],
        ),
        (
            json!({"op": "set-vertex-position", "position": [0, 0, 1]}),
            &["set-vertex-position", "`vertex`", "missing"],
        ),
        (
            json!({"op": "set-face-color", "faces": [0, 6], "color": "#123456"}),
            &["set-face-color", "`faces[1]`", "no face 6"],
        ),
        (
            json!({"op": "set-face-color", "faces": [0, "a"], "color": "#123456"}),
            &["set-face-color", "`faces[1]`"],
        ),
        (
            json!({"op": "set-face-color", "faces": [0], "color": "red"}),
            &["set-face-color", "`color`", "red", "#rrggbb"],
        ),
        (json!({"op": "set-face-color", "faces": [0]}), &["set-face-color", "`color`", "missing"]),
        (json!({"op": "set-face-color", "color": "#123456"}), &["set-face-color", "`faces`", "missing"]),
        (json!({"op": "triangulate-faces", "faces": [9]}), &["triangulate-faces", "`faces[0]`", "no face 9"]),
        (json!({"op": "triangulate-faces", "method": "magic"}), &["triangulate-faces", "`method`", "magic"]),
        (json!({"op": "subdivide-catmull-clark", "levels": 0}), &["subdivide-catmull-clark", "`levels`"]),
        (
            json!({"op": "subdivide-catmull-clark", "levels": 1.5}),
            &["subdivide-catmull-clark", "`levels`", "1.5"],
        ),
        (
            json!({"op": "subdivide-catmull-clark", "levels": -1}),
            &["subdivide-catmull-clark", "`levels`", "-1"],
        ),
        (
            json!({"op": "subdivide-catmull-clark", "levels": 4000000000u32}),
            &["subdivide-catmull-clark", "`levels`", "from 1 to 12"],
        ),
        (json!({"op": "subdivide-catmull-clark", "boundary": 3}), &["subdivide-catmull-clark", "`boundary`"]),
        (json!({"op": "subdivide-loop", "weights": "heavy"}), &["subdivide-loop", "`weights`", "heavy"]),
        (json!({"op": "new"}), &["new", "`shape`", "missing", "`cube`"]),
        (json!({"op": "new", "shape": "blob"}), &["new", "`shape`", "blob", "`torus`"]),
        (json!({"op": "new", "shape": "cube", "radius": 2}), &["new", "`radius`", "cube", "`size`"]),
        (json!({"op": "new", "shape": "cube", "size": -2}), &["new", "`size`"]),
        (json!({"op": "new", "shape": "cube", "size": "big"}), &["new", "`size`", "big"]),
        (json!({"op": "new", "shape": "cube", "add": 1}), &["new", "`add`"]),
        (json!({"op": "new", "shape": "cube", "object": 0}), &["new", "`object`"]),
        (
            json!({"op": "new", "shape": "grid", "columns": 4096, "rows": 4096}),
            &["new: the shape would have 16\u{a0}777\u{a0}216 faces"],
        ),
        (json!({"op": "activate-object"}), &["activate-object", "`object`", "missing"]),
        (json!({"op": "activate-object", "object": 1}), &["activate-object", "`object`", "no object 1"]),
        (
            json!({"op": "activate-object", "object": 0, "name": ""}),
            &["activate-object", "`name`", "not a field"],
        ),
        (json!({"op": "rename-object"}), &["rename-object", "`name`", "missing"]),
        (json!({"op": "rename-object", "name": "  "}), &["rename-object", "`name`"]),
        (json!({"op": "rename-object", "name": "a\nb"}), &["rename-object", "`name`"]),
        (json!({"op": "set-object-visible", "visible": 1}), &["set-object-visible", "`visible`"]),
        (json!({"op": "join-objects"}), &["join-objects", "only one object"]),
        (json!({"op": "join-objects", "objects": [0]}), &["join-objects", "`objects`", "two"]),
        (json!({"op": "join-objects", "objects": [0, 0]}), &["join-objects", "`objects[1]`", "twice"]),
        (json!({"op": "join-objects", "objects": [0, 3]}), &["join-objects", "`objects[1]`", "no object 3"]),
        (json!({"op": "separate"}), &["separate", "`by`", "one part"]),
        (json!({"op": "separate", "by": "components"}), &["separate", "`by`", "one part"]),
        (json!({"op": "separate", "by": "components", "faces": [1]}), &["separate", "`faces`"]),
        (json!({"op": "separate", "faces": [1, 77]}), &["separate", "`faces[1]`", "no face 77"]),
        (json!({"op": "separate", "faces": [0, 1, 2, 3, 4, 5]}), &["separate", "`faces`", "not all"]),
        (json!({"op": "transform"}), &["transform", "`vertices`", "missing"]),
        (json!({"op": "transform", "vertices": [0], "scale": [1, 2]}), &["transform", "`scale`"]),
        (
            json!({"op": "transform", "vertices": [0], "rotate": {"axis": [0, 0, 0], "degrees": 3}}),
            &["transform", "`rotate.axis`"],
        ),
        (
            json!({"op": "transform", "vertices": [0], "rotate": {"axis": [0, 0, 1]}}),
            &["transform", "`rotate.degrees`", "missing"],
        ),
        (
            json!({"op": "transform", "vertices": [0], "falloff": -1}),
            &["transform", "`falloff`", "0 or more"],
        ),
        (
            json!({"op": "transform", "vertices": [7], "scale": 1e38, "translate": [3e38, 0, 0], "pivot": [-9, 0, 0]}),
            &["transform", "finite"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 0, 0, 0]}),
            &["`position`", "is a list of 4 values where 3 are expected"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 0]}),
            &["`position`", "is a list of 2 values where 3 are expected"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": {}}),
            &["`position`", "an object is not a list of 3 numbers"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": ["NaN", 0, 0]}),
            &["`position[0]`", "NaN is not a finite number"],
        ),
        (
            json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 1e99, 0]}),
            &["`position[1]`", "1e+99 is not a finite number"],
        ),
        (json!({"op": "split-edge", "edge": 0, "t": null}), &["`t`", "null is not a finite number"]),
        (json!({"op": "split-edge", "edge": 0, "t": "x"}), &["`t`", "\"x\" is not a finite number"]),
        (json!({"op": "delete-faces", "faces": 0}), &["`faces`", "0 is not a list"]),
        (
            json!({"op": "simplify", "preserve_boundary": 1}),
            &["`preserve_boundary`", "1 is not true or false"],
        ),
        (json!({"op": "merge-vertices", "vertices": [0]}), &["only vertex 0 is given; choose two or more"]),
        (
            json!({"op": "subdivide-catmull-clark", "levels": 12}),
            &["`levels`", "would have 100\u{a0}663\u{a0}296 faces", "use fewer levels"],
        ),
        (
            json!({"op": "remesh", "edge_length": 1e-9}),
            &["`edge_length`", "more than a million million faces", "use a larger length"],
        ),
    ];
    for (value, parts) in cases {
        let text = refusal(&mut on_cube(), value.clone());
        for part in *parts {
            assert!(text.contains(part), "{value}: {text}: no {part}");
        }
    }
    let error = Command::from_json("{\"op\": ").expect_err("not JSON");
    assert!(error.to_string().contains("JSON"), "{error}");
}

#[test]
fn places_along_an_edge_count_from_the_vertex_named_first() {
    for (edge, x) in [(json!([0, 1]), 0.2), (json!([1, 0]), 0.8)] {
        let mut editor = on_cube();
        run(&mut editor, json!({"op": "split-edge", "edge": edge, "t": 0.2}));
        let split = editor.mesh().expect("a mesh").positions()[8];
        assert!((split - glam::vec3(x, 0.0, 0.0)).length() < 1e-6, "{edge}: {split}");
        editor.undo().expect("free");
        let outcome = run(&mut editor, json!({"op": "collapse-edge", "edge": edge, "t": 0.2}));
        let gone = outcome.removed.ids.expect("local").vertices[0];
        let stays = editor.mesh().expect("a mesh").positions()[1 - gone as usize];
        assert!((stays - glam::vec3(x, 0.0, 0.0)).length() < 1e-6, "{edge}: {stays}");
    }
}

#[test]
fn several_edges_are_split_all_or_none() {
    // Two triangles back to back: splitting an edge meets itself on the other side.
    let back_to_back = build(vec![glam::Vec3::ZERO, glam::Vec3::X, glam::Vec3::Y], &[[0, 1, 2], [0, 2, 1]]);
    let mut editor = Editor::with_mesh("Leaf", back_to_back);
    editor.select_all(Element::Edge);
    let text = refusal(&mut editor, json!({"op": "split-edge"}));
    assert!(text.contains("same vert"), "{text}");
}

#[test]
fn an_empty_document_refuses_in_words() {
    let mut editor = Editor::new();
    for op in [
        json!({"op": "split-edge", "edge": 0}),
        json!({"op": "subdivide-linear"}),
        json!({"op": "delete-object"}),
        json!({"op": "triangulate-faces"}),
    ] {
        let text = refusal(&mut editor, op);
        assert!(text.contains("no object"), "{text}");
    }
    run(&mut editor, json!({"op": "new", "shape": "plane"}));
    assert_eq!(sizes(&editor), [4, 4, 1]);
}
