//! Jobs: begun, run elsewhere through bytes, finished or cancelled; and invalid bytes.

mod support;

use editor::formats::{self, Format, NamedBytes};
use editor::halfedge::{Element, Mesh, keys};
use editor::{
    Begun, Command, CommandError, Editor, ErrorKind, Finished, JobRequest, JobResult, SelectMode, Wire,
};
use proptest::prelude::*;
use serde_json::json;
use std::ops::ControlFlow;
use support::*;

fn on(progress: f32) -> ControlFlow<()> {
    assert!((0.0..=1.0).contains(&progress), "{progress}");
    ControlFlow::Continue(())
}

/// Runs a job as a worker does: everything goes through bytes.
fn through_bytes(request: &JobRequest) -> JobResult {
    let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
    assert_eq!((there.id(), there.task()), (request.id(), request.task()));
    let result = there.run(&mut on).expect("a job that succeeds");
    JobResult::from_bytes(&result.to_bytes()).expect("its own bytes")
}

fn job(begun: Begun) -> JobRequest {
    match begun {
        Begun::Job(request) => request,
        Begun::Done(outcome) => panic!("done at once: {outcome:?}"),
        Begun::Selecting => panic!("it selects"),
    }
}

/// A cube with gaps in its ids, and columns of every type.
fn decorated() -> Mesh {
    let mut mesh = cube();
    mesh.set(keys::FACE_COLOR, 2, editor::halfedge::Color([1, 2, 3]));
    mesh.set(keys::EDGE_CREASE, 5, 2.5);
    mesh.set(keys::CORNER_UV, 7, glam::Vec2::new(0.5, -1.0));
    mesh.set(keys::CORNER_NORMAL, 3, glam::Vec3::Y);
    let mut groups =
        editor::halfedge::attribute::Column::with_values(keys::FACE_GROUP, vec![0, 0, 1, 1, 0, 1]);
    groups.labels = vec!["a".into(), "b".into()];
    mesh.insert_column(Element::Face, groups);
    mesh
}

#[test]
fn small_work_is_done_at_once_and_large_work_is_a_job() {
    let mut editor = on_cube();
    let begun = editor.begin(command(json!({"op": "subdivide-linear"}))).expect("a cube");
    assert!(matches!(begun, Begun::Done(_)));
    let request = job(editor.begin(command(json!({"op": "subdivide-linear", "levels": 6}))).expect("a cube"));
    assert_eq!(sizes(&editor)[2], 24, "the document stays as it is");
    assert_eq!(
        editor.jobs().map(|job| (job.id, job.task.name())).collect::<Vec<_>>(),
        [(request.id(), "subdivide-linear")]
    );
    let Finished::Done(outcome) =
        editor.finish(request.id(), Ok(through_bytes(&request))).expect("waited for")
    else {
        panic!("a command")
    };
    assert_eq!(outcome.op.name(), "subdivide-linear");
    assert_eq!(sizes(&editor)[2], 24 * 4096);
    assert_eq!(editor.jobs().count(), 0);
    assert_eq!(editor.undo_labels().count(), 2);
    validate(&editor);
    editor.undo().expect("free");
    assert_eq!(sizes(&editor)[2], 24);
}

#[test]
fn a_large_result_of_a_small_mesh_is_a_job() {
    for (shape, op) in [
        (json!({"shape": "cube"}), json!({"op": "remesh", "edge_length": 0.02})),
        (json!({"shape": "cube"}), json!({"op": "remesh", "iterations": 1000})),
        (json!({"shape": "cube"}), json!({"op": "smooth", "iterations": 10_000})),
        (
            json!({"shape": "uv-sphere"}),
            json!({"op": "bevel-edges", "edges": (0..100).collect::<Vec<u32>>(), "width": 0.1, "segments": 256}),
        ),
        (
            json!({"shape": "grid", "rows": 1, "columns": 100}),
            json!({"op": "loop-cut", "edge": [0, 101], "cuts": 1000}),
        ),
        (json!({"shape": "grid", "rows": 70, "columns": 70}), json!({"op": "simplify", "max_error": 0.01})),
    ] {
        let mut editor = on_cube();
        let mut new = json!({"op": "new"});
        for (field, value) in shape.as_object().expect("fields") {
            new[field] = value.clone();
        }
        run(&mut editor, new);
        let begun = editor.begin(command(op.clone())).unwrap_or_else(|error| panic!("{op}: {error}"));
        assert!(matches!(begun, Begun::Job(_)), "{op} was done at once");
    }
}

#[test]
fn a_job_through_bytes_equals_the_direct_run() {
    for op in [
        json!({"op": "subdivide-catmull-clark", "levels": 6, "boundary": "edge-and-corner"}),
        json!({"op": "subdivide-linear", "levels": 6}),
        json!({"op": "new", "shape": "grid", "columns": 200, "rows": 200}),
    ] {
        let mut direct = Editor::with_mesh("Cube", decorated());
        let mut remote = Editor::with_mesh("Cube", decorated());
        let expected = direct.run(command(op.clone())).expect("goes through");
        let request = job(remote.begin(command(op)).expect("goes through"));
        let Ok(Finished::Done(outcome)) = remote.finish(request.id(), Ok(through_bytes(&request))) else {
            panic!("a command")
        };
        assert_eq!(outcome, expected);
        assert_eq!(remote.document(), direct.document());
        assert_eq!(remote.selection(), direct.selection());
    }
}

#[test]
fn a_large_local_edit_is_a_job_that_keeps_ids_and_selection() {
    let start = || {
        let mut editor = on_cube();
        run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 150}));
        editor.select(Element::Vertex, [3, 70], SelectMode::Replace).expect("there");
        editor
    };
    let (mut direct, mut remote) = (start(), start());
    let expected = direct.run(command(json!({"op": "triangulate-faces"}))).expect("goes through");
    let request = job(remote.begin(command(json!({"op": "triangulate-faces"}))).expect("goes through"));
    let Ok(Finished::Done(outcome)) = remote.finish(request.id(), Ok(through_bytes(&request))) else {
        panic!("a command")
    };
    assert_eq!(outcome, expected);
    assert_eq!(outcome.created.ids.expect("local").faces.len(), 30_000);
    assert_eq!(remote.document(), direct.document());
    assert_eq!(remote.selection().ids().collect::<Vec<_>>(), [3, 70]);
    remote.undo().expect("free");
    assert_eq!(remote.document(), start().document());
}

#[test]
fn an_object_with_a_job_is_not_edited() {
    let mut editor = on_two();
    let steps = editor.undo_labels().count();
    let request = job(editor.begin(command(json!({"op": "subdivide-linear", "levels": 7}))).expect("a cube"));
    for op in [
        json!({"op": "split-edge", "edge": 0}),
        json!({"op": "subdivide-linear"}),
        json!({"op": "delete-object", "object": 0}),
        json!({"op": "join-objects"}),
        json!({"op": "new", "shape": "cube"}),
    ] {
        let text = refusal(&mut editor, op.clone());
        assert!(text.contains("still running on Cube"), "{op}: {text}");
        assert!(text.contains("wait") && text.contains("cancel"), "{text}");
    }
    assert!(editor.update_edit(command(json!({"op": "split-edge", "edge": 0}))).is_err());
    // Others are, and so is what is not the mesh.
    run(&mut editor, json!({"op": "split-edge", "edge": 0, "object": 1}));
    run(&mut editor, json!({"op": "rename-object", "object": 0, "name": "Busy"}));
    run(&mut editor, json!({"op": "new", "shape": "cube", "add": true}));
    assert!(editor.finish(request.id(), Ok(through_bytes(&request))).is_ok());
    assert_eq!(editor.undo_labels().count(), steps + 4);
    assert_eq!(editor.document().objects()[0].mesh().face_count(), 6 * 4usize.pow(7));
    validate(&editor);
}

#[test]
fn undo_waits_for_the_job_on_its_object() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "split-edge", "edge": 0}));
    let request = job(editor.begin(command(json!({"op": "subdivide-linear", "levels": 7}))).expect("a cube"));
    let text = editor.undo().expect_err("busy").to_string();
    assert!(text.starts_with("undo: ") && text.contains("still running"), "{text}");
    assert!(editor.cancel_job(request.id()));
    assert!(!editor.cancel_job(request.id()));
    assert!(editor.undo().expect("free").is_some());
    let error = editor.finish(request.id(), Ok(through_bytes(&request))).expect_err("cancelled");
    assert!(error.is_cancelled());
    assert_eq!(editor.document(), on_cube().document());
}

#[test]
fn a_job_that_is_stopped_or_fails_changes_nothing() {
    let mut editor = on_cube();
    let request = job(editor.begin(command(json!({"op": "subdivide-linear", "levels": 7}))).expect("a cube"));
    let mut calls = 0;
    let stopped = request.run(&mut |_| {
        calls += 1;
        if calls < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    let error = stopped.as_ref().expect_err("stopped");
    assert_eq!(error.kind, ErrorKind::Cancelled);
    assert!(editor.finish(request.id(), stopped).is_err());
    assert_eq!(editor.document(), on_cube().document());
    assert_eq!(editor.jobs().count(), 0);
    assert_eq!(editor.messages().count(), 0, "cancelling is no news");

    let mut editor = on_cube();
    let far = json!({"op": "subdivide-linear", "levels": 12});
    let request = job(editor.begin(command(far)).expect("not computed yet"));
    let failed = request.run(&mut on);
    assert!(editor.finish(request.id(), failed).is_err());
    assert_eq!(editor.document(), on_cube().document());
    assert!(editor.messages().next_back().expect("said").text.contains("fewer levels"));
}

const OBJ: &[u8] = b"o Pyramid\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

#[test]
fn files_open_and_are_written_through_jobs() {
    let mut editor = on_two();
    let before = editor.document().clone();
    let request = editor.begin_import(vec![NamedBytes::new("pyramid.obj", OBJ)]);
    assert_eq!(editor.document(), &before);
    let Ok(Finished::Done(outcome)) = editor.finish(request.id(), Ok(through_bytes(&request))) else {
        panic!("opened")
    };
    assert_eq!((outcome.op.name(), outcome.created.faces), ("open", 5));
    assert_eq!(editor.document().name(), "pyramid");
    assert_eq!(sizes(&editor), [5, 8, 5]);
    assert!(!editor.is_dirty());

    let request = editor.begin_export(Format::default());
    let Ok(Finished::Exported(files)) = editor.finish(request.id(), Ok(through_bytes(&request))) else {
        panic!("exported")
    };
    assert_eq!(files[0].name, "pyramid.obj");
    let again =
        JobRequest::import(files).run(&mut on).expect("its own file").into_import().expect("an import");
    assert_eq!(&again.model.objects[0].mesh.to_soup(), &editor.mesh().expect("it").to_soup());

    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
}

#[test]
fn a_broken_file_leaves_the_document_as_it_was_and_says_why() {
    let mut editor = on_cube();
    let request = editor.begin_import(vec![NamedBytes::new("photo.jpg", [0xff, 0xd8, 0xff, 0xe0])]);
    let failed = request.run(&mut on);
    let error = editor.finish(request.id(), failed).expect_err("no model");
    assert!(error.to_string().starts_with("Could not open photo.jpg. "), "{error}");
    assert_eq!(editor.messages().next_back().expect("said").text, error.to_string());
    assert_eq!(editor.document(), on_cube().document());
}

#[test]
fn a_file_with_nothing_usable_in_it_is_refused() {
    let mut editor = on_cube();
    let request = editor.begin_import(vec![NamedBytes::new("bad.obj", "f 1 2 3\n")]);
    let failed = request.run(&mut on);
    let error = editor.finish(request.id(), failed).expect_err("no vertex").to_string();
    assert!(error.contains("bad. Nothing in it could be used") && error.contains("line 1"), "{error}");
    assert_eq!(editor.document(), on_cube().document());
}

#[test]
fn materials_survive_from_file_to_file() {
    let model = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    let library = "newmtl m\nKd 0.5 0.2 0.2\nmap_Kd wood.png\n";
    let mut editor = Editor::with_mesh("Cube", decorated());
    let before = editor.document().clone();
    let image = NamedBytes::new("wood.png", *b"\x89PNG\0\xff");
    let files = vec![NamedBytes::new("a.obj", model), NamedBytes::new("a.mtl", library), image.clone()];
    let request = editor.begin_import(files);
    editor.finish(request.id(), Ok(through_bytes(&request))).expect("a model");
    assert_eq!(editor.document().materials().list.len(), 1);
    assert_eq!(editor.document().materials().images[0].bytes.as_deref(), Some(image.bytes.as_slice()));
    let request = editor.begin_export(Format::default());
    let Ok(Finished::Exported(files)) = editor.finish(request.id(), Ok(through_bytes(&request))) else {
        panic!("exported")
    };
    assert!(String::from_utf8_lossy(&files[1].bytes).ends_with(library), "{:?}", files[1]);
    assert_eq!(files[2], image);
    editor.run(command(json!({"op": "new", "shape": "cube"}))).expect("a cube");
    assert!(editor.document().materials().is_empty(), "another document");
    editor.undo().expect("free");
    assert_eq!(editor.document().materials().list.len(), 1);
    editor.undo().expect("free");
    assert_eq!(editor.document(), &before);
}

#[test]
fn a_job_adds_its_object_at_the_end_of_a_list_that_became_shorter() {
    let mut editor = on_two();
    run(&mut editor, json!({"op": "activate-object", "object": 1}));
    let add = command(json!({"op": "new", "shape": "grid", "add": true, "columns": 2, "rows": 1}));
    let Ok(Begun::Job(request)) = editor.begin_from(add, 1) else { panic!("a job") };
    editor.jump_to(0).expect("undone");
    assert_eq!(editor.document().objects().len(), 1);
    editor.finish(request.id(), request.run(&mut on)).expect("added");
    let document = editor.document();
    assert_eq!((document.objects().len(), document.active_index()), (2, 1));
    assert_eq!(document.active().expect("the new one").mesh().face_count(), 2);
}

#[test]
fn every_format_survives_transfer_to_the_worker() {
    let mut editor = Editor::with_mesh("Cube", decorated());
    // Projects hold more than a model: `tests/project.rs` is about them.
    for format in Format::all().filter(|format| format.can_write()) {
        let wanted = formats::write(format, &editor.document().to_model("Cube"));
        let request = editor.begin_export_as(format, "Cube".into());
        let there = JobRequest::from_bytes(&request.to_bytes()).expect("its own bytes");
        match (there.run(&mut on), wanted) {
            (Ok(result), Ok(wanted)) => {
                let Ok(Finished::Exported(files)) = editor.finish(request.id(), Ok(result)) else {
                    panic!("{format:?}: exported")
                };
                assert!(files == wanted, "{format:?}");
            }
            (Err(error), Err(wanted)) => {
                assert!(format.is_bezier() && error.to_string().contains(&wanted.message), "{error}");
                editor.finish(request.id(), Err(error)).expect_err("no control points");
            }
            (made, wanted) => panic!("{format:?}: {made:?}, not {wanted:?}"),
        }
    }
}

fn requests() -> Vec<Vec<u8>> {
    let mut editor = Editor::with_mesh("Cube", decorated());
    let run = job(editor.begin(command(json!({"op": "subdivide-linear", "levels": 6}))).expect("a cube"));
    let import = editor.begin_import(vec![NamedBytes::new("a.obj", OBJ)]);
    let export = editor.begin_export(Format::default());
    [run, import, export].map(|request| request.to_bytes()).into()
}

#[test]
fn every_shortened_request_is_refused() {
    for bytes in requests() {
        for len in 0..bytes.len() {
            assert!(JobRequest::from_bytes(&bytes[..len]).is_err(), "{len} of {}", bytes.len());
        }
        assert!(JobResult::from_bytes(&bytes).is_err(), "a request is not a result");
        let longer: Vec<u8> = bytes.iter().copied().chain([0]).collect();
        assert!(JobRequest::from_bytes(&longer).is_err());
    }
}

/// Notes where the large blocks lie that pass through it.
#[derive(Default)]
struct Noted<'a> {
    bytes: &'a [u8],
    places: Vec<(*const u8, usize)>,
}

impl Noted<'_> {
    fn note(&mut self, block: &[u8]) {
        if block.len() > 1 << 16 {
            self.places.push((block.as_ptr(), block.len()));
        }
    }
}

impl std::io::Write for Noted<'_> {
    fn write(&mut self, block: &[u8]) -> std::io::Result<usize> {
        self.note(block);
        Ok(block.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl std::io::Read for Noted<'_> {
    fn read(&mut self, block: &mut [u8]) -> std::io::Result<usize> {
        self.note(block);
        self.bytes.read(block)
    }
}

/// Where the columns of a mesh lie that hold its positions and links.
fn columns(mesh: &Mesh) -> Vec<(*const u8, usize)> {
    let links = mesh.connectivity();
    let lists = [links.vertex_halfedge, links.next, links.prev, links.to, links.face, links.face_halfedge];
    let positions = mesh.positions();
    std::iter::once((positions.as_ptr().cast(), size_of_val(positions)))
        .chain(lists.map(|list| (list.as_ptr().cast(), size_of_val(list))))
        .collect()
}

/// Places in memory with those that follow them without a gap as one.
fn joined(places: &[(*const u8, usize)]) -> Vec<(*const u8, usize)> {
    let mut joined: Vec<(*const u8, usize)> = Vec::new();
    for &(start, len) in places {
        match joined.last_mut() {
            Some((first, before)) if first.wrapping_add(*before) == start => *before += len,
            _ => joined.push((start, len)),
        }
    }
    joined
}

/// Between the worker and the page a mesh is copied twice: from its columns into the buffer, and from
/// the buffer into its columns. So the columns are written as they lie and read to where they stay.
#[test]
fn a_million_triangles_are_written_from_and_read_into_their_columns() {
    let side = 708;
    let mut text = String::new();
    for (row, column) in (0..=side).flat_map(|row| (0..=side).map(move |column| (row, column))) {
        text += &format!("v {column} {row} 0\n");
    }
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        let a = row * (side + 1) + column + 1;
        let (b, c, d) = (a + 1, a + side + 2, a + side + 1);
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    let request = JobRequest::import(vec![NamedBytes::new("grid.obj", text)]);
    let mut result = request.run(&mut on).expect("a file");
    result.validate();
    let mut written = Noted::default();
    result.write_to(&mut written).expect("it takes everything");
    let bytes = result.to_bytes();
    assert_eq!(bytes.len(), result.byte_len());
    let mut read = Noted { bytes: &bytes, places: Vec::new() };
    let received = JobResult::read_from(&mut read, bytes.len()).expect("its own bytes");
    let [sent, received] = [result, received].map(|result| result.into_import().expect("an import"));
    let [sent, received] = [&sent, &received].map(|import| &*import.model.objects[0].mesh);
    assert_eq!(sent.face_count(), 1_002_528);
    assert_eq!(sent, received);
    assert_eq!(written.places, columns(sent));
    // In pieces, so that the page can pause between them.
    assert_eq!(joined(&read.places), columns(received));
    assert!(bytes.len() < sent.bytes() + 4096, "{} for {}", bytes.len(), sent.bytes());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// Damage to a length or to a name is refused. A flipped bit of a number gives another job, which
    /// is read as such: sending it on and reading it again gives the same.
    #[test]
    fn damaged_bytes_are_refused(which in 0usize..3, at in any::<prop::sample::Index>(), bits in 1u8..) {
        let mut bytes = requests().swap_remove(which);
        let at = at.index(bytes.len());
        bytes[at] ^= bits;
        match JobRequest::from_bytes(&bytes) {
            Ok(request) => {
                prop_assert!(at >= 16, "the mark or the first length was damaged");
                let again = request.to_bytes();
                let read = JobRequest::from_bytes(&again).expect("its own bytes");
                prop_assert_eq!(read.to_bytes(), again);
            }
            Err(error) => prop_assert!(error.to_string().starts_with("these bytes are not a job: ")),
        }
    }

    /// Whatever is damaged of a result that was not validated: the document keeps valid meshes only.
    #[test]
    fn damaged_results_are_refused(at in any::<prop::sample::Index>(), bits in 1u8..) {
        let mut editor = Editor::with_mesh("Cube", decorated());
        let before = editor.document().clone();
        let request = editor.begin_import(vec![NamedBytes::new("a.obj", OBJ)]);
        let mut bytes = request.run(&mut on).expect("a file").to_bytes();
        let at = at.index(bytes.len());
        bytes[at] ^= bits;
        if let Ok(result) = JobResult::from_bytes(&bytes) {
            match editor.finish(request.id(), Ok(result)) {
                Ok(_) => validate(&editor),
                Err(error) => {
                    prop_assert_eq!(error.kind, ErrorKind::Internal);
                    prop_assert_eq!(editor.document(), &before);
                }
            }
        }
    }

    #[test]
    fn any_bytes_are_refused(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        prop_assert!(JobRequest::from_bytes(&bytes).is_err());
        prop_assert!(JobResult::from_bytes(&bytes).is_err());
    }

    #[test]
    fn any_text_is_a_command_or_an_error(text in "\\PC*", op in prop::sample::select(
        editor::OpId::ALL.iter().map(|id| id.spec().name).collect::<Vec<_>>()), field in "[a-z]{1,8}") {
        let _ = Command::from_json(&text);
        let value = json!({"op": op, field: text});
        if let Ok(command) = Command::from_value(value) {
            let _ = on_cube().run(command);
        }
    }
}

/// A grid large enough for its operations to be jobs, beside a cube, with a simplification that is the
/// last operation; and a job that adjusts it.
fn adjusting(fields: serde_json::Value) -> (Editor, JobRequest) {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 150, "add": true}));
    run(&mut editor, json!({"op": "simplify", "faces": 30_000}));
    let request = job(editor.adjust(command(fields)).expect("the last one"));
    (editor, request)
}

fn labels(editor: &Editor) -> Vec<String> {
    editor.undo_labels().map(str::to_owned).collect()
}

#[test]
fn a_job_that_changes_nothing_is_no_step() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 150}));
    let before = editor.document().clone();
    let request =
        job(editor.begin(command(json!({"op": "merge-by-distance", "distance": 0.0}))).expect("a grid"));
    let Ok(Finished::Done(outcome)) = editor.finish(request.id(), Ok(through_bytes(&request))) else {
        panic!("a command")
    };
    assert!(outcome.message.ends_with("nothing changed"), "{}", outcome.message);
    assert_eq!(labels(&editor), ["New shape"]);
    // What can be adjusted is still what made the step.
    assert_eq!(editor.last_command().map(Command::name), Some("new"));
    assert_eq!(editor.document(), &before);
}

#[test]
fn an_adjustment_whose_job_changes_nothing_is_adjusted_again() {
    let mut editor = on_cube();
    run(&mut editor, json!({"op": "new", "shape": "grid", "columns": 200, "rows": 150}));
    let grid = editor.document().clone();
    run(&mut editor, json!({"op": "merge-by-distance", "distance": 0.011}));
    let none = command(json!({"op": "merge-by-distance", "distance": 0.0}));
    let request = job(editor.adjust(none).expect("the last one"));
    editor.finish(request.id(), Ok(through_bytes(&request))).expect("waited for");
    assert_eq!((labels(&editor), editor.document()), (vec!["New shape".to_owned()], &grid));
    let again = command(json!({"op": "merge-by-distance", "distance": 0.012}));
    let request = job(editor.adjust(again).expect("still the last one"));
    assert!(editor.cancel_job(request.id()));
    assert_eq!(
        (labels(&editor), editor.document()),
        (vec!["New shape".to_owned()], &grid),
        "the shape stays"
    );
}

#[test]
fn an_adjustment_that_fails_or_is_cancelled_leaves_the_step() {
    for fails in [false, true] {
        let (mut editor, request) = adjusting(json!({"op": "simplify", "faces": 20_000}));
        assert_eq!(editor.redo_labels().count(), 0, "the job keeps the step");
        let ended = if fails {
            let failed = Err(CommandError::refused("simplify", "out of memory"));
            editor.finish(request.id(), failed).is_err()
        } else {
            editor.cancel_job(request.id())
        };
        assert!(ended);
        assert_eq!(labels(&editor), ["New shape", "Simplify"]);
        assert_eq!(sizes(&editor)[2], 30_000);
        let last = editor.last_command().expect("as before").to_value();
        assert_eq!(last["faces"], 30_000);
        editor.undo().expect("free");
        assert_eq!(sizes(&editor)[2], 30_000, "quads");
        validate(&editor);
    }
}

#[test]
fn a_cancelled_adjustment_keeps_the_step_and_what_was_done_meanwhile() {
    let (mut editor, request) = adjusting(json!({"op": "simplify", "faces": 20_000}));
    let cube = editor.document().objects()[0].id();
    let hide = json!({"op": "set-object-visible", "object": 0, "visible": false});
    run(&mut editor, hide);
    assert!(editor.cancel_job(request.id()));
    assert_eq!(labels(&editor), ["New shape", "Show or hide object", "Simplify"]);
    assert!(!editor.document().object(cube).expect("there").visible());
    assert_eq!(sizes(&editor)[2], 30_000);
    validate(&editor);
    editor.undo().expect("free");
    editor.undo().expect("free");
    assert!(editor.document().object(cube).expect("there").visible());
}
