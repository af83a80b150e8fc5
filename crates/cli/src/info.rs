//! `meshwright info`: print the contents of a file.

use crate::arguments::Info;
use crate::{Failure, files, report};
use formats::Controls;

/// Prints the counts, objects and import report of a file.
pub fn run(task: &Info) -> Result<(), Failure> {
    let read = files::read(&task.file, &task.repairs)?;
    let counts = report::import_counts(&read.import);
    if task.json {
        let answer = serde_json::Value::Object(report::json_start(counts, &read));
        return report::print(&format!("{answer}\n"));
    }
    let mut text = format!("{}\n", task.file.display());
    text += &report::counts_text(counts);
    text +=
        &format!("read in {:.3} s, built in {:.3} s\n", read.read.as_secs_f64(), read.build.as_secs_f64());
    if read.import.objects.len() > 1 {
        text += "objects:\n";
        for object in &read.import.objects {
            let what = match &object.controls {
                None => format!("{} faces", object.mesh.face_count()),
                Some(Controls::Curve(points)) => format!("Bezier curve of {} control points", points.len()),
                Some(Controls::Surface(patches)) => format!("Bezier surface of {} patches", patches.len()),
            };
            text += &format!("  {}: {what}\n", object.name);
        }
    }
    text += &read.import.report.to_string();
    report::print(&text)
}
