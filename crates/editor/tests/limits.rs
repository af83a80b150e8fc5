//! The ends of what commands take: wrong types, ends of ranges, fields that don't go together, extreme sizes, and many
//! elements at once.

mod support;

use editor::halfedge::{Element, Mesh};
use editor::ops::{FieldKind, Fill};
use editor::{Command, Editor, OpId};
use glam::Vec3;
use serde_json::{Map, Value, json};
use std::time::{Duration, Instant};
use support::*;

/// Words of Rust and of its JSON library that no user knows, or that say nothing.
const LEAKS: [&str; 19] = [
    "struct",
    "variant",
    "invalid",
    "serde",
    "sequence",
    "string or map",
    "map with",
    "unit",
    "u32",
    "u64",
    "usize",
    "f32",
    "f64",
    "i64",
    "integer `",
    "floating point",
    "Option",
    "at line",
    "null value",
];

#[test]
fn wrong_types_are_refused_in_plain_words() {
    let wrong = [
        json!(5),
        json!(-1),
        json!(1.5),
        json!(1e300),
        json!("x"),
        json!(""),
        json!("NaN"),
        json!(true),
        json!([]),
        json!([1]),
        json!([1, 2]),
        json!([1, 2, 3, 4]),
        json!(["x", "y", "z"]),
        json!([[1, 2], [3]]),
        json!({}),
        json!({"a": 1}),
        json!({"axis": 1}),
        json!({"axis": [1, 2]}),
        json!({"axis": [0, 0, 1]}),
        json!({"axis": [0, 0, 1], "degrees": "x"}),
        json!({"axis": [0, 0, 1], "degrees": 1, "more": 1}),
    ];
    let mut refused = 0;
    for id in OpId::ALL {
        let spec = id.spec();
        for field in spec.fields {
            for value in &wrong {
                let mut fields = Map::new();
                if spec.name == "new" {
                    fields.insert("shape".into(), "torus".into());
                }
                fields.insert(field.name.into(), value.clone());
                let Err(error) = Command::from_fields(*id, fields) else { continue };
                let text = error.to_string();
                refused += 1;
                assert_eq!(error.kind, editor::ErrorKind::Refused, "not seen before reading: {text}");
                for leak in LEAKS {
                    assert!(!text.contains(leak), "{leak}: {text}");
                }
                assert!(!text.contains(" is an is ") && !text.contains(": is "), "{text}");
                assert!(text.starts_with(&format!("{}: ", spec.name)), "{text}");
            }
        }
    }
    assert!(refused > 1500, "{refused}");
    let said = |value: Value| refusal(&mut on_cube(), value);
    let at = |field: &str, value: Value| {
        let mut command = json!({"op": "transform", "vertices": [0]});
        command[field] = value;
        said(command)
    };
    assert_eq!(
        at("rotate", json!(5)),
        "transform: `rotate`: 5 is not an axis and degrees, as in `{\"axis\": [0, 0, 1], \"degrees\": 90}`"
    );
    assert_eq!(
        at("scale", json!([1, 2])),
        "transform: `scale` is a list of 2 values where 3 are expected; a factor or a list of three is expected"
    );
    assert_eq!(
        said(json!({"op": "triangulate-faces", "method": 5})),
        "triangulate-faces: `method`: 5 is not one of its words, in quotes"
    );
}

/// Fields with which each operation has what it needs besides the selection.
fn needed(id: OpId) -> Map<String, Value> {
    let facts = editor::ops::Facts::of(&cube());
    let mut fields = Map::new();
    let mut alternatives = std::collections::HashSet::new();
    for field in id.spec().fields {
        if field.fill == Fill::Required && field.alternative.is_none_or(|title| alternatives.insert(title)) {
            fields.insert(field.name.to_owned(), field.initial_value(&facts));
        }
    }
    fields
}

#[test]
fn the_ends_of_ranges_are_what_the_descriptions_say() {
    let mut checked = 0;
    // Fields of curves and surfaces are in the tests of those.
    for &id in OpId::ALL.iter().filter(|id| id.spec().scope != editor::Scope::Bezier) {
        for field in id.spec().fields {
            let Some(range) = field.range() else { continue };
            for end in [*range.bounds().start(), *range.bounds().end()] {
                if end.abs() > 1e6 {
                    continue;
                }
                let mut fields = needed(id);
                fields.retain(|name, _| {
                    id.spec().field(name).is_none_or(|other| other.alternative.is_none())
                        || field.alternative.is_none()
                });
                let is_whole = matches!(field.kind, FieldKind::Integer { .. });
                let number = if is_whole { json!(end as i64) } else { json!(end) };
                fields.insert(field.name.to_owned(), number);
                let mut editor = on_cube();
                let element = id.spec().element().unwrap_or(Element::Face);
                editor.select(element, [0], editor::SelectMode::Replace).expect("there");
                let result = Command::from_fields(id, fields).and_then(|command| editor.run(command));
                let refused = result.err().filter(|error| {
                    error.field.as_deref() == Some(field.name) && !error.problem.contains("fit in memory")
                });
                assert_eq!(
                    refused.is_none(),
                    range.contains(end),
                    "{} {} {end}: {refused:?}",
                    id.spec().name,
                    field.name
                );
                checked += 1;
            }
        }
    }
    assert!(checked > 40, "{checked}");
}

#[test]
fn ends_that_change_nothing_change_nothing() {
    let mut editor = on_cube();
    let mesh = editor.mesh().expect("it").clone();
    for value in [
        json!({"op": "smooth", "strength": 0}),
        json!({"op": "smooth", "strength": 0, "method": "taubin", "iterations": 9}),
        json!({"op": "transform", "vertices": [0], "falloff": 0}),
    ] {
        assert!(run(&mut editor, value).message.contains("nothing changed"));
        assert_eq!(editor.mesh(), Some(&mesh));
    }
    // Without a reach, a soft selection moves what is given alone.
    run(&mut editor, json!({"op": "transform", "vertices": [0], "translate": [0, 0, 1], "falloff": 0}));
    let moved =
        mesh.vertices().filter(|&v| editor.mesh().expect("it").position(v) != mesh.position(v)).count();
    assert_eq!(moved, 1);
}

#[test]
fn fields_that_mean_nothing_together_are_refused() {
    let mut editor = on_cube();
    for op in ["hide", "isolate"] {
        for field in ["faces", "edges", "vertices"] {
            let mut value = json!({"op": op});
            value[field] = json!([]);
            let said = refusal(&mut editor, value);
            assert!(said.contains("no face was given"), "{said}");
        }
    }
    let value =
        json!({"op": "transform", "faces": [0, 1], "scale": 2, "individual": true, "pivot": [0, 0, 0]});
    let said = refusal(&mut editor, value.clone());
    assert!(said.contains("`pivot` does not go with `individual`"), "{said}");
    assert!(editor.can(&command(value)).is_err());
}

/// A cube with a grid beside it, times a factor.
fn scaled(factor: f32) -> Mesh {
    let mesh = cube();
    let mut positions: Vec<Vec3> = mesh.positions().to_vec();
    let mut faces: Vec<Vec<u32>> =
        mesh.faces().map(|f| mesh.face_vertices(f).map(|v| v.raw()).collect()).collect();
    positions
        .extend((0..16).map(|i| Vec3::new(3.0 + (i % 4) as f32, (i / 4) as f32, 0.125 * (i % 3) as f32)));
    for i in 0..9 {
        let at = 8 + i / 3 * 4 + i % 3;
        faces.push(vec![at, at + 1, at + 5, at + 4]);
    }
    build(positions.into_iter().map(|p| p * factor).collect(), &faces)
}

/// Squares of very large and very small lengths are out of the range of single precision. Powers of two keep all bits,
/// so that the results are the same but for the size.
#[test]
fn results_do_not_depend_on_the_size_of_the_model() {
    let commands = [
        ("amount", json!({"op": "inset-faces", "faces": [0], "amount": 0.125})),
        (
            "amount",
            json!({"op": "inset-faces", "faces": [0, 1, 7, 8], "amount": 0.125, "mode": "individual"}),
        ),
        ("amount", json!({"op": "inset-faces", "faces": [0], "amount": 64.0})),
        ("width", json!({"op": "bevel-edges", "edges": [[0, 1]], "width": 0.125})),
        ("width", json!({"op": "bevel-edges", "edges": [[0, 1], [1, 3]], "width": 0.125, "segments": 3})),
        ("width", json!({"op": "bevel-edges", "edges": [[13, 14]], "width": 64.0})),
        ("width", json!({"op": "bevel-vertices", "vertices": [0, 13], "width": 0.125})),
        ("distance", json!({"op": "extrude-faces", "faces": [0, 7], "distance": 0.5})),
        (
            "falloff",
            json!({"op": "transform", "vertices": [13], "scale": 2, "rotate": {"axis": [1, 1, 1], "degrees": 30}, "falloff": 1.5}),
        ),
        ("", json!({"op": "loop-cut", "edge": [0, 1], "cuts": 3})),
        ("", json!({"op": "slide-edges", "edges": [[13, 14], [14, 18]], "amount": 0.25})),
        ("", json!({"op": "slide-vertices", "vertices": [0, 13], "direction": [1, 1, 0.5], "amount": 0.25})),
        ("", json!({"op": "triangulate-faces"})),
        ("", json!({"op": "poke-faces", "faces": [0, 7]})),
        ("", json!({"op": "subdivide-catmull-clark", "levels": 2})),
        ("", json!({"op": "smooth", "method": "taubin"})),
        ("", json!({"op": "remesh"})),
        ("", json!({"op": "simplify", "ratio": 0.5})),
        ("max_error", json!({"op": "simplify", "max_error": 0.0625})),
        ("distance", json!({"op": "merge-by-distance", "distance": 1.0625})),
    ];
    for exponent in [70_i8, -70] {
        let factor = f32::from(exponent).exp2();
        for (field, value) in &commands {
            let mut near = Editor::with_mesh("Mesh", scaled(1.0));
            let mut far = Editor::with_mesh("Mesh", scaled(factor));
            let mut large = value.clone();
            if let Some(number) = value.get(field).and_then(Value::as_f64) {
                large[field] = json!(number as f32 * factor);
            }
            let (a, b) = (run(&mut near, value.clone()), run(&mut far, large));
            assert_eq!((a.created, a.removed), (b.created, b.removed), "2^{exponent}: {value}");
            let places = |editor: &Editor, by: f32| -> Vec<Vec3> {
                editor.mesh().expect("it").positions().iter().map(|&p| p * by).collect()
            };
            let (a, b) = (places(&near, 1.0), places(&far, 1.0 / factor));
            for (a, b) in a.iter().zip(&b) {
                assert!(a.distance(*b) <= 1e-5, "2^{exponent}: {value}: {a} is {b}");
            }
        }
    }
}

#[test]
fn dissolving_many_vertices_takes_time_in_proportion() {
    let time = |side: u32| -> Duration {
        let mut editor = Editor::new();
        run(&mut editor, json!({"op": "new", "shape": "grid", "columns": side, "rows": side}));
        let mesh = editor.mesh().expect("it");
        let inner: Vec<u32> =
            mesh.vertices().filter(|&v| !mesh.is_boundary_vertex(v)).map(|v| v.raw()).collect();
        let corners = 4 * side as usize;
        let start = Instant::now();
        run(&mut editor, json!({"op": "dissolve-vertex", "vertices": inner}));
        let time = start.elapsed();
        assert!(sizes(&editor)[0] <= corners + 2 * side as usize, "{:?}", sizes(&editor));
        time
    };
    time(20);
    let (small, large) = (time(50).max(Duration::from_millis(2)), time(200));
    // Sixteen times the vertices; the square would take 256 times as long.
    assert!(large < small * 80, "{small:?} and {large:?}");
}

#[test]
fn remeshing_keeps_the_size_of_meshes_of_large_polygons() {
    let disc = |corners: usize| {
        let angle = |i: usize| std::f32::consts::TAU * i as f32 / corners as f32;
        let positions = (0..corners).map(|i| Vec3::new(angle(i).cos(), angle(i).sin(), 0.0)).collect();
        build(positions, &[(0..corners as u32).collect::<Vec<_>>()])
    };
    for corners in [6, 100, 2000] {
        let mut editor = Editor::with_mesh("Disc", disc(corners));
        run(&mut editor, json!({"op": "remesh"}));
        let faces = sizes(&editor)[2];
        assert!((corners / 8..corners * 8).contains(&faces), "{corners} corners, {faces} triangles");
    }
}
