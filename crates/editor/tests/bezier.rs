//! Bezier objects: commands on control points, preview meshes, undo, jobs and refusals.

mod support;

use editor::formats::{Format, Import, ImportReport, Model, NamedBytes, NamedMesh};
use editor::halfedge::{Element, Mesh};
use editor::surface::bezier::Curve;
use editor::{Begun, Bezier, Editor, Finished, JobRequest, JobResult, ObjectChange, SelectMode, Wire};
use glam::Vec3;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use support::*;

fixtures::shared_tests!(the_teapot_of_the_course_opens_and_tessellates);

fn open(files: &[(&str, String)]) -> Editor {
    let files: Vec<NamedBytes> =
        files.iter().map(|(name, text)| NamedBytes::new(*name, text.as_str())).collect();
    let import = editor::formats::read(&files, &mut |_| ControlFlow::Continue(())).expect("readable");
    let mut editor = Editor::new();
    editor.open(import).expect("valid");
    validate(&editor);
    editor
}

/// A curve of four control points.
fn on_curve() -> Editor {
    open(&[("curve.bzc", "4\n0 0 1 2 3 2 4 0".into())])
}

/// Two flat patches side by side along x, which share a border.
fn two_patches() -> String {
    let mut text = "2\n".to_owned();
    for patch in 0..2 {
        for row in 0..4 {
            for column in 0..4 {
                text += &format!("{} {row} 0 ", patch * 3 + column);
            }
        }
    }
    text
}

fn on_surface() -> Editor {
    open(&[("flat.bez", two_patches())])
}

fn points(editor: &Editor, object: usize) -> Vec<Vec3> {
    let bezier = editor.document().objects()[object].bezier().expect("a Bezier object");
    match bezier {
        Bezier::Curve(curve) => curve.points.clone(),
        Bezier::Surface(patches) => patches.iter().flat_map(|p| p.rows.as_flattened().to_vec()).collect(),
    }
}

/// Runs a command, then goes back and forth: both ways everything is as it was.
fn there_and_back(editor: &mut Editor, value: Value) {
    let before = editor.document().clone();
    run(editor, value.clone());
    let after = editor.document().clone();
    assert_ne!(before, after, "{value}");
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before, "{value}");
    editor.redo().expect("free");
    assert_eq!(editor.document(), &after, "{value}");
}

#[test]
fn a_curve_opens_with_its_points_and_no_mesh() {
    let mut editor = on_curve();
    assert_eq!(
        points(&editor, 0),
        [(0.0, 0.0), (1.0, 2.0), (3.0, 2.0), (4.0, 0.0)].map(|(x, y)| Vec3::new(x, y, 0.0))
    );
    assert_eq!(editor.mesh(), Some(&Mesh::new()));
    let id = editor.document().objects()[0].id();
    let changes = editor.take_changes();
    assert_eq!(changes.bezier, [id]);
    assert_eq!(changes.of(id), Some(&ObjectChange::Added));
    let state = editor.state();
    assert_eq!(
        state["document"]["objects"][0]["bezier"],
        json!({"kind": "curve", "points": [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 0.0], [4.0, 0.0, 0.0]]})
    );
    assert_eq!(state["document"]["components"], 0);
}

#[test]
fn points_of_a_curve_are_moved_inserted_and_deleted() {
    let mut editor = on_curve();
    editor.take_changes();
    there_and_back(&mut editor, json!({"op": "bezier-move-point", "point": 2, "position": [3, 5, 1]}));
    assert_eq!(points(&editor, 0)[2], Vec3::new(3.0, 5.0, 1.0));
    let changes = editor.take_changes();
    assert_eq!((changes.bezier.len(), changes.objects.len()), (1, 0));
    there_and_back(&mut editor, json!({"op": "bezier-insert-point", "index": 0, "position": [-1, 0, 0]}));
    there_and_back(&mut editor, json!({"op": "bezier-insert-point", "position": [9, 0, 0]}));
    assert_eq!(points(&editor, 0).len(), 6);
    assert_eq!((points(&editor, 0)[0].x, points(&editor, 0)[5].x), (-1.0, 9.0));
    there_and_back(&mut editor, json!({"op": "bezier-delete-point", "index": 1}));
    assert_eq!(points(&editor, 0)[1], Vec3::new(1.0, 2.0, 0.0));
    for _ in 0..4 {
        run(&mut editor, json!({"op": "bezier-delete-point", "index": 0}));
    }
    let text = refusal(&mut editor, json!({"op": "bezier-delete-point", "index": 0}));
    assert!(text.contains("`index`: a curve keeps at least one"), "{text}");
}

#[test]
fn elevation_and_split_keep_the_shape() {
    let mut editor = on_curve();
    let before = Curve { points: points(&editor, 0) };
    there_and_back(&mut editor, json!({"op": "bezier-elevate-degree"}));
    let elevated = Curve { points: points(&editor, 0) };
    assert_eq!(elevated.points.len(), 5);
    there_and_back(&mut editor, json!({"op": "bezier-split", "t": 0.25}));
    assert_eq!(editor.document().objects().len(), 2);
    assert_eq!(editor.document().objects()[1].name(), "curve 2");
    assert_eq!(editor.document().active_index(), 0);
    let [first, rest] = [0, 1].map(|at| Curve { points: points(&editor, at) });
    assert_eq!((first.points.len(), rest.points.len()), (5, 5));
    assert_eq!(first.points.last(), rest.points.first());
    for i in 0..=10 {
        let t = i as f32 / 10.0;
        assert!(elevated.point(t).distance(before.point(t)) < 1e-5);
        assert!(first.point(t).distance(before.point(t * 0.25)) < 1e-5);
        assert!(rest.point(t).distance(before.point(0.25 + t * 0.75)) < 1e-5);
    }
    // Each object has an identity of its own, also after further splits and undo.
    run(&mut editor, json!({"op": "bezier-split", "object": 1}));
    editor.undo().expect("free");
    run(&mut editor, json!({"op": "bezier-split"}));
    run(&mut editor, json!({"op": "new", "shape": "cube", "add": true}));
    let mut ids: Vec<_> = editor.document().objects().iter().map(|object| object.id()).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), 4);
}

#[test]
fn splitting_before_the_active_object_keeps_it_active() {
    let curve = || ("a.bzc", "2\n0 0 1 1".to_owned());
    let mut editor = open(&[curve(), curve()]);
    run(&mut editor, json!({"op": "activate-object", "object": 1}));
    let active = editor.document().active().expect("one").id();
    there_and_back(&mut editor, json!({"op": "bezier-split", "object": 0}));
    assert_eq!(editor.document().active().expect("one").id(), active);
}

#[test]
fn shared_points_of_patches_move_together() {
    let mut editor = on_surface();
    let mesh = editor.mesh().expect("shown").clone();
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (17 * 9, 128));
    editor.take_changes();
    editor.select(Element::Face, [5], SelectMode::Replace).expect("there");
    let value = json!({"op": "bezier-move-point", "patch": 0, "row": 1, "column": 3, "position": [3, 1, 2]});
    there_and_back(&mut editor, value);
    assert_eq!(editor.selection().ids().collect::<Vec<_>>(), [5]);
    let points = points(&editor, 0);
    let moved: Vec<usize> = (0..32).filter(|&i| points[i] == Vec3::new(3.0, 1.0, 2.0)).collect();
    assert_eq!(moved, [7, 16 + 4]);
    let mesh = editor.mesh().expect("shown");
    assert_eq!((mesh.vertex_count(), mesh.face_count(), mesh.boundary_loops().len()), (17 * 9, 128, 1));
    assert!(mesh.positions().iter().any(|p| p.z > 0.4));
    let changes = editor.take_changes();
    let id = editor.document().objects()[0].id();
    assert_eq!(changes.bezier, [id]);
    assert_eq!(changes.of(id), Some(&ObjectChange::Everything));
    assert_eq!(editor.state()["document"]["objects"][0]["bezier"], json!({"kind": "surface", "patches": 2}));
}

#[test]
fn a_drag_is_one_step_and_a_cancelled_drag_is_none() {
    for (mut editor, field) in
        [(on_curve(), json!({"point": 1})), (on_surface(), json!({"patch": 1, "row": 0, "column": 0}))]
    {
        let before = editor.document().clone();
        let to = |z: f32| {
            let mut value = json!({"op": "bezier-move-point", "position": [0.5, 0.5, z]});
            value.as_object_mut().expect("an object").extend(field.as_object().expect("an object").clone());
            command(value)
        };
        for z in [0.5, 1.0, 2.0] {
            editor.update_edit(to(z)).expect("a preview");
            validate(&editor);
        }
        let wrong = command(json!({"op": "bezier-move-point", "point": 77, "position": [0, 0, 0]}));
        let shown = editor.document().clone();
        editor.update_edit(wrong).expect_err("no such point");
        assert_eq!(editor.document(), &shown);
        assert!(editor.is_editing());
        assert_eq!(editor.cancel_edit().as_deref(), Some("Move control point"));
        assert_eq!(editor.document(), &before);
        editor.update_edit(to(1.0)).expect("a preview");
        editor.update_edit(to(2.0)).expect("a preview");
        editor.commit_edit();
        assert_eq!(editor.undo_labels().count(), 2, "opening, and the drag");
        assert!(points(&editor, 0).contains(&Vec3::new(0.5, 0.5, 2.0)));
        editor.undo().expect("free");
        assert_eq!(editor.document(), &before);
    }
    let error =
        on_curve().update_edit(command(json!({"op": "rename-object", "name": "x"}))).expect_err("no drag");
    assert!(error.to_string().contains("can't be dragged"), "{error}");
}

#[test]
fn tessellating_makes_a_mesh_that_everything_edits() {
    let mut editor = on_surface();
    let name = editor.document().objects()[0].name().to_owned();
    for op in ["subdivide-linear", "smooth", "triangulate-faces", "flip-orientation"] {
        let text = refusal(&mut editor, json!({"op": op}));
        assert!(
            text.contains("flat is a Bezier surface; tessellate it first (`bezier-tessellate`)"),
            "{text}"
        );
    }
    let text = refusal(&mut editor, json!({"op": "extrude-faces", "faces": [0], "distance": 1}));
    assert!(text.contains("bezier-tessellate"), "{text}");
    there_and_back(&mut editor, json!({"op": "bezier-tessellate", "resolution": 3}));
    assert_eq!(sizes(&editor), [7 * 4, 7 * 3 + 6 * 4, 18]);
    assert_eq!(editor.document().objects()[0].bezier(), None);
    assert_eq!(editor.document().objects()[0].name(), name);
    run(&mut editor, json!({"op": "extrude-faces", "faces": [0], "distance": 1}));
    let text = refusal(&mut editor, json!({"op": "bezier-tessellate"}));
    assert!(text.contains("flat is a mesh already"), "{text}");
    // Adjusting it takes the same step again.
    let mut editor = on_surface();
    run(&mut editor, json!({"op": "bezier-tessellate", "resolution": 3}));
    editor.adjust(command(json!({"op": "bezier-tessellate", "resolution": 2}))).expect("the last one");
    assert_eq!(sizes(&editor)[2], 8);
}

#[test]
fn tessellating_runs_in_a_worker() {
    let mut editor = on_surface();
    let mut direct = on_surface();
    let value = json!({"op": "bezier-tessellate", "resolution": 100});
    run(&mut direct, value.clone());
    let Begun::Job(request) = editor.begin(command(value)).expect("a surface") else { panic!("20000 faces") };
    let text = refusal(
        &mut editor,
        json!({"op": "bezier-move-point", "patch": 0, "row": 0, "column": 0, "position": [0, 0, 1]}),
    );
    assert!(text.contains("is still running"), "{text}");
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = there.run(&mut |_| ControlFlow::Continue(())).expect("goes through");
    let back = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
    assert!(matches!(editor.finish(request.id(), Ok(back)), Ok(Finished::Done(_))));
    assert_eq!(editor.document(), direct.document());
}

#[test]
fn opening_and_saving_go_through_a_worker() {
    let files = vec![NamedBytes::new("a.bzc", "2\n0 1 2 3"), NamedBytes::new("b.bez", two_patches())];
    let mut editor = Editor::new();
    let request = editor.begin_import(files);
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = there.run(&mut |_| ControlFlow::Continue(())).expect("readable");
    let back = JobResult::from_bytes(&result.to_bytes()).expect("its own bytes");
    assert!(matches!(editor.finish(request.id(), Ok(back)), Ok(Finished::Done(_))));
    assert_eq!((points(&editor, 0).len(), points(&editor, 1).len()), (2, 32));
    assert_eq!(editor.document().objects()[1].mesh().face_count(), 128);
    for (format, object) in
        [(Format::from_code("bzc").expect("a format"), 0), (Format::from_code("bez").expect("a format"), 1)]
    {
        let request = editor.begin_export(format);
        let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
        let result = there.run(&mut |_| ControlFlow::Continue(())).expect("what the format holds");
        let Ok(Finished::Exported(files)) = editor.finish(request.id(), Ok(result)) else { panic!("files") };
        let import = editor::formats::read(&files, &mut |_| ControlFlow::Continue(())).expect("its own");
        assert_eq!(
            import.model.objects[0].bezier.as_ref().map(|bezier| bezier.points()),
            Some(points(&editor, object).to_vec())
        );
    }
}

#[test]
fn refusals_name_the_field_and_the_valid_values() {
    let p = json!([0, 0, 0]);
    let curve: &[(Value, &str)] = &[
        (json!({"op": "bezier-move-point", "position": p}), "`point` is missing"),
        (
            json!({"op": "bezier-move-point", "point": 4, "position": p}),
            "`point`: there is no control point 4; they go from 0 to 3",
        ),
        (json!({"op": "bezier-move-point", "point": -1, "position": p}), "`point`: -1 is not a whole number"),
        (json!({"op": "bezier-move-point", "point": 0, "row": 0, "position": p}), "`row` is for surfaces"),
        (json!({"op": "bezier-move-point", "point": 0, "position": [0, 1e300, 0]}), "`position"),
        (
            json!({"op": "bezier-insert-point", "index": 5, "position": p}),
            "`index`: 5 would leave a gap; it may be 0 to 4",
        ),
        (json!({"op": "bezier-delete-point", "index": 9}), "`index`: there is no control point 9"),
        (json!({"op": "bezier-split", "t": 0}), "`t`: 0 is out of range"),
        (json!({"op": "bezier-split", "t": 1}), "`t`: 1 is out of range"),
        (json!({"op": "bezier-tessellate"}), "curve is a Bezier curve, which bounds no faces"),
        (json!({"op": "smooth"}), "curve is a Bezier curve, which has no vertices"),
        (json!({"op": "bezier-elevate-degree", "object": 3}), "`object`: there is no object 3"),
    ];
    for (value, text) in curve {
        let said = refusal(&mut on_curve(), value.clone());
        assert!(said.contains(text), "{value}: {said}");
    }
    let surface: &[(Value, &str)] = &[
        (
            json!({"op": "bezier-move-point", "patch": 2, "row": 0, "column": 0, "position": p}),
            "`patch`: there is no patch 2; the last one is 1",
        ),
        (
            json!({"op": "bezier-move-point", "patch": 0, "row": 4, "column": 0, "position": p}),
            "`row`: there is no row 4",
        ),
        (json!({"op": "bezier-move-point", "patch": 0, "row": 0, "position": p}), "`column` is missing"),
        (json!({"op": "bezier-move-point", "point": 0, "position": p}), "`point` is for curves"),
        (json!({"op": "bezier-insert-point", "position": p}), "flat is a Bezier surface"),
        (json!({"op": "bezier-elevate-degree"}), "this operation is for curves"),
        (
            json!({"op": "bezier-tessellate", "resolution": 0}),
            "`resolution`: 0 is out of range; it must be from 1 to 256",
        ),
        (json!({"op": "bezier-tessellate", "resolution": 257}), "`resolution`"),
    ];
    for (value, text) in surface {
        let said = refusal(&mut on_surface(), value.clone());
        assert!(said.contains(text), "{value}: {said}");
    }
    let text = refusal(&mut on_cube(), json!({"op": "bezier-delete-point", "index": 0}));
    assert!(text.contains("Cube is a mesh; this op is for Bezier curves and surfaces"), "{text}");
    let text = refusal(&mut Editor::new(), json!({"op": "bezier-elevate-degree"}));
    assert!(text.contains("no object"), "{text}");
    let mut large = open(&[("a.bzc", format!("20001 {}", "1 ".repeat(40_002)))]);
    assert!(
        refusal(&mut large, json!({"op": "bezier-split"}))
            .contains("20\u{a0}001 control points; splitting takes")
    );
}

#[test]
fn a_curve_of_thirty_thousand_points_is_edited_like_any_other() {
    let text: String = (0..30_000).map(|i| format!("\n{i} {}", i % 7)).collect();
    let mut editor = open(&[("large.bzc", format!("30000{text}"))]);
    for op in [
        json!({"op": "bezier-move-point", "point": 29_999, "position": [1, 2, 3]}),
        json!({"op": "bezier-insert-point", "index": 15_000, "position": [1, 2, 3]}),
        json!({"op": "bezier-delete-point", "index": 0}),
        json!({"op": "bezier-elevate-degree"}),
    ] {
        there_and_back(&mut editor, op);
    }
    let curve = editor.document().objects()[0].bezier().and_then(Bezier::curve).expect("a curve");
    assert_eq!(curve.points.len(), 30_001);
}

#[test]
fn many_patches_are_shown_coarsely() {
    let surface =
        |patches: usize| Bezier::from_points(false, vec![Vec3::ZERO; patches * 16]).preview_resolution();
    assert_eq!([1, 312, 313, 5_000, 20_000, 1_000_000].map(surface), [8, 8, 7, 2, 1, 1]);
}

fn the_teapot_of_the_course_opens_and_tessellates() {
    let text = std::fs::read_to_string(fixtures::shared("models/cs184/teapot.bez")).expect("text");
    let mut editor = open(&[("teapot.bez", text)]);
    assert_eq!(editor.document().objects()[0].bezier().map(|b| b.patches().len()), Some(32));
    there_and_back(&mut editor, json!({"op": "bezier-tessellate", "resolution": 10}));
    let mesh = editor.mesh().expect("a mesh");
    assert_eq!(mesh.face_count(), 3200);
    // Four pieces: the body with the bottom, the lid, the handle and the spout. The rim's inside and
    // the lid's edge are open, and the handle and the spout at both ends.
    assert_eq!((mesh.components().1, mesh.boundary_loops().len()), (4, 6));
    // Of each piece: vertices - edges + faces = 1 (a disc) for the body and the lid, 0 (a tube) for
    // the handle and the spout.
    assert_eq!(mesh.euler_characteristic(), 2);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_commands_on_a_curve_undo_to_the_bit(ops in prop::collection::vec((0u8..5, 0u32..8, -9.0f32..9.0), 1..20)) {
        let mut editor = on_curve();
        let mut states = vec![editor.document().clone()];
        for (kind, index, x) in ops {
            let value = match kind {
                0 => json!({"op": "bezier-move-point", "point": index, "position": [x, 1, 2]}),
                1 => json!({"op": "bezier-insert-point", "index": index, "position": [x, 1, 2]}),
                2 => json!({"op": "bezier-delete-point", "index": index}),
                3 => json!({"op": "bezier-split", "t": (x + 9.0) / 18.0}),
                _ => json!({"op": "bezier-elevate-degree"}),
            };
            if editor.run(command(value)).is_ok() {
                states.push(editor.document().clone());
            } else {
                prop_assert_eq!(states.last(), Some(editor.document()));
            }
        }
        for state in states.iter().rev() {
            prop_assert_eq!(state, editor.document());
            editor.undo().expect("free");
        }
    }
}

#[test]
fn control_points_without_a_mesh_get_one_when_opened() {
    let row = [0.0, 1.0, 2.0, 3.0].map(|x| Vec3::new(x, 0.0, 0.0));
    let bezier = Some(std::sync::Arc::new(Bezier::from_points(false, row.repeat(4))));
    let object = NamedMesh { bezier, ..NamedMesh::new("line", Mesh::new()) };
    let model = Model { name: "line".into(), objects: vec![object], ..Model::default() };
    let mut import = Import { model, report: ImportReport::default() };
    let mut editor = Editor::new();
    editor.open(import.clone()).expect("valid");
    validate(&editor);
    editor::show_controls(&mut import).expect("small");
    assert_eq!(editor.mesh(), Some(import.model.objects[0].mesh.as_ref()));
}
