//! `meshwright info`: print the contents of a file.

use crate::arguments::Info;
use crate::documents::Contents;
use crate::{Failure, documents, report};
use editor::project::Project;
use formats::Bezier;
use serde_json::{Value, json};

/// Prints the counts, objects and import report of a file.
pub fn run(task: &Info) -> Result<(), Failure> {
    let read = documents::read(&task.file, &task.repairs)?;
    let model = read.contents.model();
    let counts = report::model_counts(&model);
    if task.json {
        let mut answer = report::json_start(counts, &read);
        if let Contents::Project(read) = &read.contents {
            answer.insert("project".into(), about(&read.project));
        }
        return report::print(&format!("{}\n", Value::Object(answer)));
    }
    let mut text = format!("{}\n", task.file.display());
    text += &report::counts_text(counts);
    text +=
        &format!("read in {:.3} s, built in {:.3} s\n", read.read.as_secs_f64(), read.build.as_secs_f64());
    if model.objects.len() > 1 {
        text += "objects:\n";
        for object in &model.objects {
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
    if let Contents::Project(read) = &read.contents {
        text += &about_text(&read.project);
    }
    text += &read.contents.report().to_string();
    report::print(&text)
}

/// What a project holds besides its meshes.
fn about(project: &Project) -> Value {
    let document = project.document();
    let objects = document.objects().iter().map(|object| {
        let named: Vec<&str> = object.named_selections().iter().map(|named| named.name.as_str()).collect();
        json!({
            "name": object.name(),
            "visible": object.visible(),
            "hidden_faces": object.hidden().len(),
            "named_selections": named,
        })
    });
    json!({
        "objects": objects.collect::<Vec<_>>(),
        "materials": document.materials().list.len(),
        "images": document.materials().images.len(),
        "view": project.has_view(),
        "history": project.logged(),
    })
}

fn about_text(project: &Project) -> String {
    let document = project.document();
    let hidden: usize = document.objects().iter().map(|object| object.hidden().len()).sum();
    let named: usize = document.objects().iter().map(|object| object.named_selections().len()).sum();
    let lines = [
        ("materials", document.materials().list.len()),
        ("images", document.materials().images.len()),
        ("hidden faces", hidden),
        ("named selections", named),
        ("changes in its log", project.logged()),
    ];
    lines.iter().map(|(name, count)| format!("{name:<21}{count:>10}\n")).collect()
}
