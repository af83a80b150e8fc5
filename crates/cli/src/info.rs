//! `meshwright info`: print the contents of a file.

use crate::arguments::Info;
use crate::{Failure, files, report};
use formats::Bezier;

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
    if read.import.model.objects.len() > 1 {
        text += "objects:\n";
        for object in &read.import.model.objects {
            let what = match object.bezier.as_deref() {
                None => format!("{} faces", object.mesh.face_count()),
                Some(Bezier::Curve(curve)) => {
                    format!("Bezier curve of {} control points", curve.points.len())
                }
                Some(Bezier::Surface(patches)) => format!("Bezier surface of {} patches", patches.len()),
            };
            text += &format!("  {}: {what}\n", object.name);
        }
    }
    text += &read.import.report.to_string();
    report::print(&text)
}
