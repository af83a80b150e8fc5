//! `meshwright convert`: save a file in another format.

use crate::arguments::Convert;
use crate::documents::Contents;
use crate::{Failure, documents, report};
use editor::{Editor, Outcome};

/// Reads one file and writes another.
pub fn run(task: &Convert) -> Result<(), Failure> {
    let format = documents::output_format(&task.output, task.format)?;
    let read = documents::read(&task.input, &task.repairs)?;
    let mut notes = report::notes(&task.input, read.contents.report());
    let is_project = matches!(read.contents, Contents::Project(_));
    let mut editor = Editor::new();
    let outcome: Outcome =
        read.contents.open_in(&mut editor).map_err(|error| Failure::File(error.to_string()))?;
    if is_project {
        // Only opening it tells whether its history can be repeated.
        notes = report::outcome_notes(&task.input, &outcome);
    }
    documents::write(&task.output, format, &editor)?;
    report::print(&notes)
}
