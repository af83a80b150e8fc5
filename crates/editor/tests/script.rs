//! The texts generated from the operations' descriptions, and the files that contain them.

use editor::{OpId, script};
use std::path::Path;

/// Compares a file of the repository with the text it should hold; with `MESHWRIGHT_UPDATE=1` writes it.
fn check_file(path: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    if std::env::var_os("MESHWRIGHT_UPDATE").is_some() {
        std::fs::write(&path, text).expect("a folder to write to");
    }
    let held = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(
        held == text,
        "{} is out of date; run `MESHWRIGHT_UPDATE=1 cargo test -p editor --test script`",
        path.display()
    );
}

#[test]
fn the_operations_reference_is_up_to_date() {
    check_file("docs/operations.md", &script::operations_reference());
}

#[test]
fn the_types_are_up_to_date() {
    check_file("web/meshwright.d.ts", &script::typescript_types());
}

#[test]
fn every_operation_and_field_is_described() {
    let (list, reference) = (script::operations_help(), script::operations_reference());
    let types = script::typescript_types();
    assert_eq!(list.lines().count(), OpId::ALL.len());
    for id in OpId::ALL {
        let spec = id.spec();
        assert!(list.contains(&format!("  {} ", spec.name)), "{}", spec.name);
        assert!(reference.contains(&format!("\n### `{}`\n", spec.name)), "{}", spec.name);
        assert!(types.contains(&format!("\n  op: \"{}\";\n", spec.name)), "{}", spec.name);
        let help = script::operation_help(*id);
        for field in spec.fields {
            assert!(help.contains(&format!("\n  {}\n", field.name)), "{}: {}", spec.name, field.name);
            assert!(help.contains(field.description), "{}: {}", spec.name, field.name);
        }
    }
}

#[test]
fn fields_are_described_with_values_and_defaults() {
    let split = script::operation_help(OpId::SplitEdge);
    assert!(split.contains("a number above 0 and below 1; default: 0.5"), "{split}");
    assert!(split.contains("an edge by id or by [a, b], the vertices at its ends"), "{split}");
    assert!(split.contains("one of \"triangles\", "), "{split}");
    let simplify = script::operation_help(OpId::Simplify);
    assert!(simplify.contains("exactly one of these is required"), "{simplify}");
    let new = script::operation_help(OpId::New);
    assert!(new.contains("one of \"cube\", ") && new.contains("; required"), "{new}");
    assert!(new.contains("default: 0.4 for torus"), "{new}");
}
