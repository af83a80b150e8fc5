//! Printed output.

use crate::Failure;
use crate::documents::Read;
use editor::{Counts, Document, Outcome};
use formats::{ImportReport, Model, ReportNote, Severity};
use serde_json::{Map, Value, json};
use std::io::Write;
use std::path::Path;

/// Prints text on standard output. A closed pipe is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    match std::io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::File(format!("standard output can't be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints the warnings of an import report on standard error, and gives the other notes as text: what was read, and
/// what was left out that doesn't affect the mesh.
pub fn notes(path: &Path, report: &ImportReport) -> String {
    let mut others = String::new();
    for ReportNote { severity, text } in report.notes() {
        match severity {
            Severity::Warning => eprintln!("{}: {text}", path.display()),
            Severity::Info => others += &format!("{}: {text}\n", path.display()),
        }
    }
    others
}

/// Prints the warnings of opening a file on standard error, and gives the other notes as text.
pub fn outcome_notes(path: &Path, outcome: &Outcome) -> String {
    let mut report = ImportReport::default();
    for note in &outcome.report {
        match note.severity {
            Severity::Warning => report.warn(note.text.clone()),
            Severity::Info => report.info(note.text.clone()),
        }
    }
    notes(path, &report)
}

/// The total counts of the meshes of a model.
pub fn model_counts(model: &Model) -> Counts {
    model.objects.iter().map(|object| Counts::of(&object.mesh)).sum()
}

/// The total counts of the meshes of a document.
pub fn document_counts(document: &Document) -> Counts {
    document.objects().iter().map(|object| Counts::of(object.mesh())).sum()
}

/// The fields that every JSON answer starts with.
pub fn json_start(counts: Counts, read: &Read) -> Map<String, Value> {
    let mut answer = Map::new();
    answer.insert("input".into(), json!(counts));
    answer.insert("read_seconds".into(), read.read.as_secs_f64().into());
    answer.insert("build_seconds".into(), read.build.as_secs_f64().into());
    answer.insert("report".into(), json!(read.contents.report()));
    answer
}

/// Counts as text, one to a line.
pub fn counts_text(counts: Counts) -> String {
    let lines = [
        ("vertices", counts.vertices as i64),
        ("edges", counts.edges as i64),
        ("half-edges", counts.halfedges as i64),
        ("faces", counts.faces as i64),
        ("boundary loops", counts.boundary_loops as i64),
        ("components", counts.components as i64),
        ("Euler characteristic", counts.euler),
    ];
    lines.iter().map(|(name, count)| format!("{name:<21}{count:>10}\n")).collect()
}

/// Counts as one line of text.
pub fn counts_line(counts: Counts) -> String {
    let count =
        |count: usize, one: &str, more: &str| format!("{count} {}", if count == 1 { one } else { more });
    [
        count(counts.vertices, "vertex", "vertices"),
        count(counts.edges, "edge", "edges"),
        count(counts.faces, "face", "faces"),
        count(counts.boundary_loops, "boundary loop", "boundary loops"),
        count(counts.components, "component", "components"),
    ]
    .join(", ")
}
