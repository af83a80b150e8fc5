//! Reading a job's result in parts.

use editor::formats::NamedBytes;
use editor::{Editor, JobResult, Reading, Wire};
use std::cell::Cell;
use std::io::Read;
use std::ops::ControlFlow;
use std::rc::Rc;

/// Bytes that count how many were read.
struct Counted {
    bytes: Vec<u8>,
    read: Rc<Cell<usize>>,
}

impl Read for Counted {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let at = self.read.get();
        let len = self.bytes[at..].as_ref().read(into)?;
        self.read.set(at + len);
        Ok(len)
    }
}

/// The bytes of the result of opening a mesh of a few megabytes.
fn result() -> Vec<u8> {
    const SIDE: usize = 200;
    let mut text = String::new();
    for at in 0..=SIDE * SIDE {
        text += &format!("v {} {} {}\n", at % SIDE, at / SIDE, at % 7);
    }
    for at in 1..SIDE * (SIDE - 1) {
        text += &format!("f {at} {} {}\n", at + 1, at + SIDE);
    }
    let request = Editor::default().begin_import(vec![NamedBytes::new("strips.obj", text)]);
    request.run(&mut |_| ControlFlow::Continue(())).expect("faces").to_bytes()
}

#[test]
fn a_result_that_is_read_in_parts_is_the_same() {
    let bytes = result();
    let (len, read) = (bytes.len(), Rc::new(Cell::new(0)));
    assert!(len > 4 << 20, "{len}");
    let mut reading = Reading::<JobResult>::new(Counted { bytes: bytes.clone(), read: read.clone() }, len);
    let (part, piece) = (1 << 19, 1 << 20);
    let mut steps = 0;
    let made = loop {
        let before = read.get();
        let done = reading.step(part);
        steps += 1;
        assert!(read.get() - before < part + piece, "one part read {}", read.get() - before);
        if let Some(made) = done {
            break made.expect("its own bytes");
        }
    };
    assert!(steps > 4, "{steps} parts");
    assert_eq!(made.to_bytes(), bytes);
}

#[test]
fn parts_that_are_cut_off_are_refused() {
    let mut bytes = result();
    let len = bytes.len();
    bytes.truncate(len - 1);
    let mut reading = Reading::<JobResult>::new(Counted { bytes, read: Rc::default() }, len);
    let error = std::iter::repeat_with(|| reading.step(1 << 20)).flatten().next().expect("an end");
    assert!(error.is_err());
}
