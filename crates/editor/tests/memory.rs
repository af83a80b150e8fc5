//! The memory that opening a large file takes on its way from the worker to the page.

use editor::formats::NamedBytes;
use editor::{Editor, JobResult, Wire};
use peak_alloc::PeakAlloc;
use std::ops::ControlFlow;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// The side of a grid of a million triangles.
const SIDE: usize = 708;

/// What buffers and the JSON of small blocks may take.
const SMALL_BYTES: usize = 1 << 20;

fn grid_obj() -> String {
    let mut text = String::new();
    for (x, y) in (0..=SIDE).flat_map(|y| (0..=SIDE).map(move |x| (x, y))) {
        text += &format!("v {x} {y} 0\n");
    }
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let v = y * (SIDE + 1) + x + 1;
        text += &format!("f {v} {} {}\nf {v} {} {}\n", v + 1, v + SIDE + 2, v + SIDE + 2, v + SIDE + 1);
    }
    text
}

/// The bytes that are in use after a piece of work beyond those before it, and the most while it ran.
fn measure<T>(work: impl FnOnce() -> T) -> (T, usize, usize) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let made = work();
    (made, MEMORY.current_usage().saturating_sub(before), MEMORY.peak_usage().saturating_sub(before))
}

// One test, because every thread's memory counts.
#[test]
fn a_million_triangles_are_copied_once_on_each_side() {
    let mut editor = Editor::default();
    let request = editor.begin_import(vec![NamedBytes::new("grid.obj", grid_obj())]);
    let result = request.run(&mut |_| ControlFlow::Continue(())).expect("a grid");
    let id = request.id();
    drop(request);
    let len = result.byte_len();
    assert!(len > 50 << 20, "{len} bytes are no million triangles");

    let mut buffer = Vec::with_capacity(len);
    let ((), _, most) = measure(|| result.write_to(&mut buffer).expect("a vector takes everything"));
    assert_eq!(buffer.len(), len);
    assert!(most <= SMALL_BYTES, "writing took {most} bytes besides the buffer of {len}");
    drop(result);

    let (there, kept, most) =
        measure(|| JobResult::read_from(&mut buffer.as_slice(), len).expect("its own bytes"));
    assert!(most < len + len / 10, "reading {len} bytes took {most}, which is more than one copy of them");
    drop(buffer);

    let ((), more, most) = measure(|| {
        editor.finish(id, Ok(there)).expect("waited for");
    });
    assert_eq!(editor.document().objects()[0].mesh().face_count(), 2 * SIDE * SIDE);
    assert!(most + kept < 2 * len, "taking in a mesh of {kept} bytes took {most} more, and {more} stayed");
}
