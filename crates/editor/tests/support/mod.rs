//! Helpers for the tests of this crate.
#![allow(dead_code, reason = "each test file uses its own part")]

pub mod contents;
pub mod deeds;
pub mod random;

use editor::halfedge::{Mesh, PolygonSoup};
use editor::{Command, Editor, Outcome};
use glam::Vec3;
use serde_json::{Value, json};

/// A cube of quads: vertices 0..8, faces 0..6.
pub fn cube() -> Mesh {
    let positions =
        (0..8).map(|i| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2 & 1) as f32)).collect();
    let faces: [&[u32]; 6] =
        [&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]];
    build(positions, &faces)
}

/// A square of triangles with a boundary, and a pentagon apart.
pub fn patches() -> Mesh {
    let mut positions: Vec<Vec3> = (0..9).map(|i| Vec3::new((i % 3) as f32, (i / 3) as f32, 0.25)).collect();
    positions.extend((0..5).map(|i| Vec3::new(10.0 + (i as f32).cos(), (i as f32).sin(), 0.0)));
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for y in 0..2 {
        for x in 0..2 {
            let a = y * 3 + x;
            faces.push(vec![a, a + 1, a + 4]);
            faces.push(vec![a, a + 4, a + 3]);
        }
    }
    faces.push((9..14).collect());
    build(positions, &faces)
}

pub fn build<F: AsRef<[u32]>>(positions: Vec<Vec3>, faces: &[F]) -> Mesh {
    let built = Mesh::build(PolygonSoup::new(positions, faces)).expect("small");
    assert_eq!(built.notes, []);
    built.mesh.validate().expect("valid");
    built.mesh
}

/// An editor on a cube.
pub fn on_cube() -> Editor {
    Editor::with_mesh("Cube", cube())
}

/// An editor on a cube and the patches.
pub fn on_two() -> Editor {
    let mut editor = Editor::with_mesh("Cube", cube());
    run(&mut editor, json!({"op": "new", "shape": "grid", "add": true, "columns": 2, "rows": 2}));
    run(&mut editor, json!({"op": "activate-object", "object": 0}));
    editor
}

pub fn command(value: Value) -> Command {
    let command = Command::from_value(value.clone()).unwrap_or_else(|error| panic!("{value}: {error}"));
    // Whatever is read is written as something that reads as the same.
    assert_eq!(Command::from_json(&command.to_json()).expect("its own JSON"), command, "{value}");
    command
}

pub fn run(editor: &mut Editor, value: Value) -> Outcome {
    let outcome = editor.run(command(value.clone())).unwrap_or_else(|error| panic!("{value}: {error}"));
    validate(editor);
    outcome
}

pub fn validate(editor: &Editor) {
    for object in editor.document().objects() {
        object.mesh().validate().expect("valid");
    }
}

/// The refusal of a command that must be refused and change nothing.
pub fn refusal(editor: &mut Editor, value: Value) -> String {
    let document = editor.document().clone();
    let selection = editor.selection().clone();
    let steps = editor.undo_labels().count();
    let error = match Command::from_value(value.clone()) {
        Err(error) => error,
        Ok(command) => editor.run(command).expect_err(&format!("{value} went through")),
    };
    assert_eq!(editor.document(), &document, "{value}");
    assert_eq!(editor.selection(), &selection, "{value}");
    assert_eq!(editor.undo_labels().count(), steps, "{value}");
    error.to_string()
}

/// Vertices, edges and faces of the active object.
pub fn sizes(editor: &Editor) -> [usize; 3] {
    let mesh = editor.mesh().expect("an object");
    [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()]
}
