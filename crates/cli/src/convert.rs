//! `meshwright convert`: save a file in another format.

use crate::arguments::Convert;
use crate::{Failure, files, report};
use editor::{Editor, Outcome};

/// Reads one file and writes another.
pub fn run(task: &Convert) -> Result<(), Failure> {
    let format = files::output_format(&task.output, task.format)?;
    let read = files::read(&task.input, &task.repairs)?;
    let notes = report::notes(&task.input, &read.import.report);
    let mut editor = Editor::new();
    let _: Outcome = editor.open(read.import).map_err(|error| Failure::File(error.to_string()))?;
    files::write(&task.output, format, editor.document())?;
    report::print(&notes)
}
