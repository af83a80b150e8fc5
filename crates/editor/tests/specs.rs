//! The descriptions of operations: their fields and defaults are those of the commands, and their estimates
//! of results are right.

mod support;

use editor::halfedge::{Element, Mesh};
use editor::ops::{Amount, Arity, Counted, Facts, FieldKind, Fill};
use editor::{Begun, Command, Editor, OpId, Scope, SelectMode, Spec};
use proptest::prelude::*;
use serde_json::{Map, Value, json};
use std::collections::HashSet;
use support::*;

fn specs() -> impl Iterator<Item = &'static Spec> {
    OpId::ALL.iter().map(|id| id.spec())
}

/// A command of an operation with these fields only; `new` needs a shape that has the field.
fn with_field(spec: &Spec, field: Option<(&str, Value)>) -> Value {
    let mut value = json!({"op": spec.name});
    if spec.name == "new" {
        let has =
            |shape: &&str, name: &str| surface::Shape::named(shape).is_some_and(|s| s.get(name).is_some());
        let shape = field.as_ref().and_then(|(name, _)| surface::Shape::names().find(|s| has(s, name)));
        value["shape"] = shape.unwrap_or("cube").into();
    }
    if let Some((name, given)) = field {
        value[name] = given;
    }
    value
}

#[test]
fn names_and_labels_are_unique() {
    let (mut names, mut labels) = (HashSet::new(), HashSet::new());
    for spec in specs() {
        assert!(names.insert(spec.name), "{} is there twice", spec.name);
        assert!(labels.insert(spec.label), "{} is there twice", spec.label);
        assert!(spec.label.chars().next().is_some_and(char::is_uppercase), "{}", spec.name);
        assert!(spec.description.ends_with('.'), "{}", spec.name);
        let fields: HashSet<&str> = spec.fields.iter().map(|field| field.name).collect();
        assert_eq!(fields.len(), spec.fields.len(), "{}", spec.name);
        assert!(spec.fields.iter().all(|field| !field.label().is_empty() && !field.description.is_empty()));
        // A key or a tool says which field follows the pointer by what it does.
        let drags: Vec<_> = spec.fields.iter().filter_map(|field| field.drag).collect();
        assert!((1..drags.len()).all(|at| !drags[..at].contains(&drags[at])), "{}", spec.name);
    }
}

#[test]
fn the_member_of_a_family_that_suits_the_selection_stands_for_it() {
    for id in OpId::ALL.iter().filter(|id| id.spec().family.is_some()) {
        for kind in Element::ALL {
            let meant = id.for_selection(kind);
            assert!(id.spec().family.is_some_and(|family| meant.spec().is_of(family)));
            assert!(meant.spec().applies_to(kind) || meant == *id, "{kind}: {}", meant.spec().name);
        }
    }
    assert_eq!(OpId::DeleteFaces.for_selection(Element::Halfedge), OpId::DissolveEdge);
    assert_eq!(OpId::BevelEdges.for_selection(Element::Vertex), OpId::BevelVertices);
    assert_eq!(OpId::SlideEdges.for_selection(Element::Vertex), OpId::SlideVertices);
    assert_eq!(OpId::SlideEdges.for_selection(Element::Halfedge), OpId::SlideEdges);
    assert_eq!(OpId::DissolveVertex.for_selection(Element::Edge), OpId::DissolveEdge);
    assert_eq!(OpId::DissolveEdge.for_selection(Element::Vertex), OpId::DeleteVertices);
    assert_eq!(OpId::SplitEdge.for_selection(Element::Vertex), OpId::SplitEdge);
}

#[test]
fn a_field_of_the_description_is_a_field_of_the_command() {
    for spec in specs() {
        for field in spec.fields {
            // Given a wrong type, the message names it rather than calling it unknown.
            let value = with_field(spec, Some((field.name, json!([[[]]]))));
            let error = Command::from_value(value).expect_err("a wrong type");
            let at = error.field.unwrap_or_default();
            assert!(at.starts_with(field.name), "{}: {}: {at}", spec.name, field.name);
            assert!(!error.problem.contains("not a field of"), "{}: {}", spec.name, field.name);
        }
    }
}

#[test]
fn defaults_are_valid_and_those_of_the_command() {
    let facts = Facts::of(&cube());
    for &id in OpId::ALL {
        let spec = id.spec();
        let mut initial = Map::new();
        for field in spec.fields {
            if let Some(default) = field.default_value() {
                let without = Command::from_value(with_field(spec, None));
                let with = Command::from_value(with_field(spec, Some((field.name, default))));
                assert_eq!(with, without, "{}: {}", spec.name, field.name);
            }
            let is_alternative = field.alternative.is_some()
                && initial
                    .keys()
                    .any(|name| spec.field(name).is_some_and(|other| other.alternative == field.alternative));
            if matches!(field.fill, Fill::Required | Fill::Value(_)) && !is_alternative {
                initial.insert(field.name.to_owned(), field.initial_value(&facts));
            }
            if let FieldKind::Choice(choices) = field.kind {
                for choice in choices {
                    let mut fields = initial.clone();
                    fields.insert(field.name.to_owned(), choice.name.into());
                    if let Err(error) = Command::from_fields(id, fields) {
                        assert_ne!(error.field.as_deref(), Some(field.name), "{}: {error}", spec.name);
                    }
                }
            }
        }
        // What a form starts with is a command.
        let command = Command::from_fields(id, initial.clone());
        let command = command.unwrap_or_else(|error| panic!("{}: {initial:?}: {error}", spec.name));
        assert_eq!(Command::from_value(command.to_value()), Ok(command));
    }
}

#[test]
fn defaults_in_rust_are_those_of_the_description() {
    use editor::ops::*;
    fn check(command: impl Into<Command>, id: OpId) {
        assert_eq!(Ok(command.into()), Command::from_fields(id, Map::new()));
    }
    check(Transform::default(), OpId::Transform);
    check(TriangulateFaces::default(), OpId::TriangulateFaces);
    check(SubdivideCatmullClark::default(), OpId::SubdivideCatmullClark);
    check(SubdivideLoop::default(), OpId::SubdivideLoop);
    check(SubdivideLinear::default(), OpId::SubdivideLinear);
    check(Remesh::default(), OpId::Remesh);
    check(Smooth::default(), OpId::Smooth);
    let ratio = Map::from_iter([("ratio".to_owned(), json!(0.25))]);
    assert_eq!(Ok(Simplify::to_ratio(0.25).into()), Command::from_fields(OpId::Simplify, ratio));
}

/// What a menu entry would run: every field as its form starts, elements from the selection.
fn from_menu(id: OpId, mesh: &Mesh) -> Command {
    let facts = Facts::of(mesh);
    let mut fields = Map::new();
    let mut alternatives = HashSet::new();
    for field in id.spec().fields {
        if matches!(field.fill, Fill::Required)
            && field.alternative.is_none_or(|title| alternatives.insert(title))
        {
            fields.insert(field.name.to_owned(), field.initial_value(&facts));
        }
    }
    Command::from_fields(id, fields).expect("valid")
}

#[test]
fn every_refusal_of_a_menu_entry_is_a_sentence() {
    let mut editors = vec![Editor::new(), on_cube(), on_two(), Editor::with_mesh("Patches", patches())];
    let mut refused = 0;
    for editor in &mut editors {
        for kind in Element::ALL {
            for count in [0, 1, 2, 3] {
                if editor.mesh().is_some() {
                    editor.select(kind, 0..count, SelectMode::Replace).expect("there");
                }
                for &id in OpId::ALL {
                    let command = from_menu(id, editor.mesh().unwrap_or(&Mesh::new()));
                    let Err(error) = editor.can(&command) else { continue };
                    refused += 1;
                    let reason = error.reason();
                    let first = reason.chars().next().expect("not empty");
                    assert!(!first.is_lowercase() && reason.ends_with(['.', '!', '?']), "{reason}");
                    assert!(!reason.contains("is missing"), "{}: {reason}", id.spec().name);
                    is_for_people(&reason);
                    is_for_people(&error.message());
                }
            }
        }
    }
    assert!(refused > 1000, "{refused}");
}

/// Messages on the page name operations and fields by their labels, not as in JSON.
fn is_for_people(message: &str) {
    assert!(!message.contains(['`', '{', '_']), "{message}");
    assert!(message.matches(": ").count() <= 1, "one colon at most: {message}");
    let words: Vec<&str> = message.split(|c: char| !c.is_ascii_alphanumeric() && c != '-').collect();
    for spec in specs().filter(|spec| spec.name.contains('-')) {
        assert!(!words.contains(&spec.name), "{message}");
    }
}

#[test]
fn can_agrees_with_run() {
    for editor in [on_cube(), on_two(), Editor::with_mesh("Patches", patches())] {
        let mesh = editor.mesh().expect("a mesh").clone();
        for kind in Element::ALL {
            for count in [0, 1, 2, 5] {
                for &id in OpId::ALL {
                    let mut editor = Editor::with_mesh("Mesh", mesh.clone());
                    editor.select(kind, 0..count, SelectMode::Replace).expect("there");
                    let command = from_menu(id, &mesh);
                    let can = editor.can(&command);
                    let ran = editor.run(command.clone());
                    let nothing_to_do =
                        can.as_ref().is_err_and(|error| error.kind == editor::ErrorKind::NothingToDo);
                    if nothing_to_do {
                        assert_eq!(editor.undo_labels().count(), 0, "{}", command.to_json());
                    } else if ran.is_ok() {
                        assert_eq!(can, Ok(()), "{}", command.to_json());
                    } else if id.spec().scope == Scope::Elements && count < 2 {
                        // Of several in one step only the first is checked.
                        assert!(can.is_err(), "{}: {ran:?}", command.to_json());
                    }
                }
            }
        }
    }
}

#[test]
fn a_large_selection_is_checked_for_its_kind() {
    let mut editor = Editor::new();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 60, "rows": 60}));
    editor.select_all(Element::Face);
    assert!(editor.selection().len() > Editor::MAX_CHECKED_SELECTION);
    let reason =
        |editor: &Editor, id| editor.can(&from_menu(id, editor.mesh().expect("it"))).map_err(|e| e.reason());
    assert_eq!(reason(&editor, OpId::PokeFaces), Ok(()));
    assert_eq!(reason(&editor, OpId::FlipEdge), Err("Select an edge first.".into()));
    assert_eq!(reason(&editor, OpId::ConnectVertices), Err("Select two vertices first.".into()));
    assert_eq!(reason(&editor, OpId::MergeVertices), Ok(()));
}

/// Random fields of an operation, near enough to what it takes.
fn fields(id: OpId) -> BoxedStrategy<Map<String, Value>> {
    let mut all: BoxedStrategy<Map<String, Value>> = Just(Map::new()).boxed();
    for field in id.spec().fields {
        let value: BoxedStrategy<Value> = match field.kind {
            FieldKind::Elements { arity: Arity::One, .. } => (0_u32..24).prop_map(Value::from).boxed(),
            FieldKind::Elements { arity: Arity::Two, .. } => {
                proptest::array::uniform2(0_u32..24).prop_map(|ids| json!(ids)).boxed()
            }
            FieldKind::Elements { .. } => {
                prop::collection::btree_set(0_u32..24, 1..6).prop_map(|ids| json!(ids)).boxed()
            }
            FieldKind::Number { range, .. } => {
                (-2.0..=2.0).prop_map(move |number| json!(range.nearest(number) as f32)).boxed()
            }
            FieldKind::Integer { range, .. } => {
                let min = *range.whole_bounds().start();
                (min..=min.max(6)).prop_map(Value::from).boxed()
            }
            FieldKind::Vector => proptest::array::uniform3(-2.0_f32..2.0).prop_map(|v| json!(v)).boxed(),
            FieldKind::Choice(choices) => {
                (0..choices.len()).prop_map(move |at| json!(choices[at].name)).boxed()
            }
            FieldKind::Flag => any::<bool>().prop_map(Value::from).boxed(),
            FieldKind::Shape => (0..surface::Shape::names().count())
                .prop_map(|at| json!(surface::Shape::names().nth(at)))
                .boxed(),
            FieldKind::Color => Just(json!("#336699")).boxed(),
            FieldKind::Text => Just(json!("Name")).boxed(),
            _ => continue,
        };
        let often = if field.fill == Fill::Required && field.alternative.is_none() { 0.99 } else { 0.4 };
        all = (all, prop::option::weighted(often, value))
            .prop_map(|(mut fields, value)| {
                if let Some(value) = value {
                    fields.insert(field.name.to_owned(), value);
                }
                fields
            })
            .boxed();
    }
    all
}

fn any_command() -> impl Strategy<Value = Command> {
    (0..OpId::ALL.len())
        .prop_flat_map(|at| (Just(OpId::ALL[at]), fields(OpId::ALL[at])))
        .prop_filter_map("no command", |(id, fields)| Command::from_fields(id, fields).ok())
}

/// A mesh of one polygon with many corners, whose size its face count doesn't show.
fn disk(corners: usize) -> Mesh {
    let at = |i: usize| std::f32::consts::TAU * i as f32 / corners as f32;
    let positions = (0..corners).map(|i| glam::Vec3::new(at(i).cos(), at(i).sin(), 0.0)).collect();
    build(positions, &[(0..corners as u32).collect::<Vec<_>>()])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn cost_and_result_match_what_is_created(command in any_command(), which in 0..3_usize) {
        let mesh = vec![cube(), patches(), disk(40)].swap_remove(which);
        let facts = Facts::of(&mesh);
        let mut editor = Editor::with_mesh("Mesh", mesh.clone());
        let Some(cost) = editor.cost(&command) else { return Ok(()) };
        let before = editor.document().clone();
        let outcome = match editor.run(command.clone()) {
            Ok(outcome) => outcome,
            Err(error) => {
                prop_assert_eq!(editor.document(), &before);
                is_for_people(&error.message());
                return Ok(());
            }
        };
        is_for_people(&outcome.message);
        outcome.warnings.iter().for_each(|warning| is_for_people(warning));
        prop_assert!(outcome.created.faces <= cost, "{} faces, cost {cost}: {}", outcome.created.faces, command.to_json());
        let is_one = editor.document().objects().len() == 1;
        if let (Some(estimate), true) = (command.op.result(&facts), is_one)
            && let Amount::Exactly(count) = estimate.count
        {
            let result = editor.mesh().expect("a mesh");
            let made = match estimate.counted {
                Counted::Faces | Counted::Triangles => result.face_count(),
                Counted::Vertices | Counted::MovedVertices => result.vertex_count(),
            };
            prop_assert_eq!(made, count, "{}", command.to_json());
        }
        // Whatever it did is one step, and what changed nothing is none.
        let steps = editor.undo_labels().count();
        prop_assert!(steps <= 1);
        prop_assert_eq!(steps == 0, editor.document() == &before, "{}", command.to_json());
        if steps == 1 {
            editor.undo().expect("free");
            prop_assert_eq!(editor.document(), &before);
        }
    }
}

#[test]
fn a_polygon_with_many_corners_is_subdivided_as_a_job() {
    for op in ["subdivide-catmull-clark", "subdivide-linear"] {
        let mut editor = Editor::with_mesh("Disk", disk(30_000));
        let begun = editor.begin(command(json!({"op": op}))).expect("free");
        assert!(matches!(begun, Begun::Job(_)), "{op}");
    }
}
