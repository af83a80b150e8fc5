//! `can`, `run`, a job and the history say the same of a command that changes nothing.

mod support;

use editor::formats::NamedBytes;
use editor::halfedge::{Mesh, PolygonSoup};
use editor::{Begun, Command, Editor, ErrorKind, Finished, OpId, Outcome};
use glam::Vec3;
use proptest::prelude::*;
use serde_json::{Map, Value, json};
use std::ops::ControlFlow;
use support::random::any_command;
use support::*;

/// Carries out a command as a job.
fn as_job(editor: &mut Editor, command: Command) -> Outcome {
    match editor.begin_from(command, 0).expect("free") {
        Begun::Done(outcome) => outcome,
        Begun::Selecting => panic!("it selects"),
        Begun::Job(request) => {
            let result = request.run(&mut |_| ControlFlow::Continue(()));
            match editor.finish(request.id(), result).expect("free") {
                Finished::Done(outcome) => outcome,
                other => panic!("{other:?}"),
            }
        }
    }
}

fn tetrahedron() -> Editor {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "tetrahedron"}));
    editor
}

/// Vertices without faces.
fn points() -> Mesh {
    let soup = PolygonSoup::new::<[u32; 0]>(vec![Vec3::new(1.5, 2.0, 3.0), Vec3::ONE], &[]);
    Mesh::build(soup).expect("small").mesh
}

/// Each of the two vertices turns the other one about itself, so that their moves cancel out.
#[test]
fn moves_that_cancel_out_are_no_step() {
    let mut editor = Editor::new();
    let path = fixtures::fixture("obj-cases/cube.obj");
    let bytes = std::fs::read(path).expect("readable");
    let request = editor.begin_import(vec![NamedBytes::new("cube.obj", bytes)]);
    let import = request.run(&mut |_| ControlFlow::Continue(()));
    editor.finish(request.id(), import).expect("an OBJ file");
    run(&mut editor, json!({"op": "split-edge", "edge": 5}));
    let before = editor.document().clone();
    let steps = editor.undo_labels().count();
    let turn = json!({
        "op": "transform", "vertices": [5, 6], "individual": true, "falloff": 2,
        "rotate": {"axis": [-2.886_174_678_802_490_2, 1.949_013_233_184_814_5, 0], "degrees": 90},
    });
    let outcome = run(&mut editor, turn);
    assert_eq!(editor.document(), &before);
    assert_eq!(editor.undo_labels().count(), steps);
    assert!(outcome.message.ends_with("nothing changed"), "{}", outcome.message);
}

#[test]
fn vertices_without_faces_stay_where_can_says_that_there_is_nothing_to_do() {
    let mut idle = 0;
    for &id in OpId::ALL {
        let mut editor = Editor::with_mesh("Points", points());
        let mut fields = Map::new();
        if id == OpId::Simplify {
            fields.insert("ratio".into(), json!(0.5));
        }
        let Ok(command) = Command::from_fields(id, fields) else { continue };
        let nothing_to_do = editor.can(&command).is_err_and(|error| error.kind == ErrorKind::NothingToDo);
        if !nothing_to_do {
            continue;
        }
        idle += 1;
        let before = editor.document().clone();
        let Ok(outcome) = editor.run(command.clone()) else { continue };
        assert!(outcome.message.ends_with("nothing changed"), "{}: {}", command.name(), outcome.message);
        assert_eq!(editor.document(), &before, "{}", command.name());
        assert_eq!(as_job(&mut editor, command), outcome);
        assert_eq!(editor.document(), &before);
    }
    assert!(idle >= 5, "{idle}");
}

#[test]
fn a_job_that_changes_nothing_has_the_outcome_of_a_run() {
    for value in [
        json!({"op": "triangulate-faces"}),
        json!({"op": "slide-vertices", "vertices": [0], "direction": [1, 0, 0], "amount": 0}),
        json!({"op": "smooth", "iterations": 1, "strength": 0}),
    ] {
        let at_once = tetrahedron().run(command(value.clone())).expect("free");
        let as_job = as_job(&mut tetrahedron(), command(value.clone()));
        assert_eq!(as_job, at_once, "{value}");
    }
}

#[test]
fn remeshing_with_a_far_vertex_is_a_job() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 1e9, 0]}));
    let remesh = command(json!({"op": "remesh", "edge_length": 1000.0}));
    assert!(matches!(editor.begin(remesh.clone()), Ok(Begun::Job(_))));
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [0, 1e9, 0]}));
    let refused = editor.run(remesh).expect_err("too many faces").to_string();
    assert!(refused.contains("faces") && refused.contains("use a larger length"), "{refused}");
    let cost = editor.cost(&command(json!({"op": "remesh", "iterations": 1}))).expect("a mesh");
    let outcome = run(&mut editor, json!({"op": "remesh", "iterations": 1}));
    assert!(outcome.created.faces <= cost, "{} faces, cost {cost}", outcome.created.faces);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// After any commands, a step is a change and a change is a step, and a job does what a run does.
    #[test]
    fn a_step_is_a_change(commands in prop::collection::vec(any_command(), 1..5), turn in any_turn()) {
        let mut editor = on_two();
        let mut other = on_two();
        for value in commands.into_iter().chain([turn]) {
            let command = command(value.clone());
            let (before, steps) = (editor.document().clone(), editor.undo_labels().count());
            let Ok(outcome) = editor.run(command.clone()) else {
                prop_assert_eq!(editor.document(), &before);
                continue;
            };
            let is_step = editor.undo_labels().count() != steps;
            prop_assert_eq!(is_step, editor.document() != &before, "{}", value);
            prop_assert_eq!(as_job(&mut other, command), outcome, "{}", value);
            prop_assert_eq!(other.document().objects().len(), editor.document().objects().len());
        }
    }
}

/// Rotations and scales of a few vertices, which often overlap.
fn any_turn() -> impl Strategy<Value = Value> {
    let ids = prop::collection::vec(0u32..9, 1..4);
    (ids, any::<bool>(), prop::option::of(0f32..3.0), prop::sample::select(vec![0f32, 90.0, 180.0, 360.0])).prop_map(
        |(vertices, individual, falloff, degrees)| {
            let rotate = json!({"axis": [0, 0, 1], "degrees": degrees});
            json!({
                "op": "transform", "vertices": vertices, "individual": individual, "falloff": falloff.unwrap_or(0.0),
                "rotate": rotate,
            })
        },
    )
}
