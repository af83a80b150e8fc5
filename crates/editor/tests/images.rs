//! Images of materials: decoded as jobs, and added after their model.

use editor::formats::{self, NamedBytes, Picture, PictureSource};
use editor::{Editor, Finished, JobRequest, JobResult, Wire};
use std::ops::ControlFlow;

const TGA: [u8; 22] = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 0x28, 30, 20, 10, 255];

/// An editor with a triangle whose material names `wood.tga`, which isn't there.
fn editor() -> Editor {
    let files = [
        NamedBytes::new("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nusemtl wood\nf 1/1 2/1 3/1\n"),
        NamedBytes::new("a.mtl", "newmtl wood\nmap_Kd wood.tga\n"),
    ];
    let mut editor = Editor::new();
    editor.open(formats::read(&files, &mut |_| ControlFlow::Continue(())).expect("a model")).expect("valid");
    editor.take_changes();
    editor
}

#[test]
fn an_image_is_added_to_the_material_that_names_it_as_one_step() {
    let mut editor = editor();
    let revision = editor.revision();
    for (name, expected) in
        [("stone.tga", "No material names stone.tga"), ("wood.txt", "wood.txt is no image")]
    {
        let error = editor.take_images(&[NamedBytes::new(name, TGA)]).expect_err(name);
        assert!(error.problem.contains(expected), "{error}");
    }
    assert_eq!((editor.revision(), editor.take_changes().materials), (revision, false));

    let files = [NamedBytes::new("folder/WOOD.TGA", TGA), NamedBytes::new("stone.tga", TGA)];
    let outcome = editor.take_images(&files).expect("named");
    assert_eq!(outcome.warnings, ["stone.tga was left out: no material names it"]);
    let has_image = |editor: &Editor| editor.document().materials().missing_images().is_empty();
    assert!(has_image(&editor) && editor.is_dirty() && editor.take_changes().materials);
    assert_eq!(editor.undo_labels().last(), Some("Add folder/WOOD.TGA"));
    editor.undo().expect("idle");
    assert!(!has_image(&editor) && editor.take_changes().materials);
    editor.redo().expect("idle");
    assert!(has_image(&editor));
}

/// Runs a job as a worker does, through bytes.
fn run(request: &JobRequest) -> Result<JobResult, editor::CommandError> {
    let request = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    let result = request.run(&mut |_| ControlFlow::Continue(()))?;
    Ok(JobResult::from_bytes(&result.to_bytes()).expect("its own bytes"))
}

#[test]
fn decoding_is_a_job_that_changes_nothing() {
    let mut editor = editor();
    editor.take_images(&[NamedBytes::new("wood.tga", TGA)]).expect("named");
    let revision = editor.revision();
    let image = editor.document().materials().images[0].clone();
    let request = editor.begin_decode(PictureSource::of(image.clone()), 64);
    assert_eq!(editor.jobs().map(|job| job.task).collect::<Vec<_>>(), [editor::Task::Decode]);
    let finished = editor.finish(request.id(), run(&request)).expect("a picture");
    let Finished::Decoded(Picture { size, pixels, original }) = finished else { panic!("{finished:?}") };
    assert_eq!((size, original, pixels), ([1, 1], [1, 1], vec![10, 20, 30, 255]));

    let damaged = formats::Image { bytes: Some(TGA[..19].into()), ..image.clone() };
    let request = editor.begin_decode(PictureSource::of(damaged.clone()), 64);
    let messages = editor.messages().len();
    let error = editor.finish(request.id(), run(&request)).expect_err("damaged");
    assert!(error.problem.contains("damaged"), "{error}");
    assert_eq!((editor.revision(), editor.messages().len()), (revision, messages));

    // The opacity from an image whose brightness is 19 of 255, and from one that is missing.
    let both = PictureSource { color: Some(image.clone()), alpha: Some(image.clone()) };
    let request = editor.begin_decode(both, 64);
    let finished = editor.finish(request.id(), run(&request)).expect("a picture");
    let Finished::Decoded(Picture { pixels, .. }) = finished else { panic!("{finished:?}") };
    assert_eq!(pixels, [10, 20, 30, 18]);
    let missing = formats::Image { bytes: None, ..image.clone() };
    let request = editor.begin_decode(PictureSource { color: Some(image), alpha: Some(missing) }, 64);
    assert!(editor.finish(request.id(), run(&request)).is_err());
}
