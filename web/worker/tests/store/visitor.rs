//! A tab with a store, for tests.

use editor::recovery::{Entry, Event, append_record, read_log};
use meshwright_worker::store::*;

/// When checkpoints are written, in milliseconds since 1970.
pub const NOW_MS: f64 = 1000.0;

/// A tab with a store.
pub struct Visitor {
    documents: Documents<Tab>,
}

impl Visitor {
    pub fn new(disk: &MemoryDisk) -> Self {
        Self { documents: Documents::new(disk.tab()) }
    }

    pub fn ask(&mut self, request: Request, bytes: &[u8]) -> Vec<(Answer, Bytes)> {
        let mut answers = Vec::new();
        let mut tell = |answer, bytes| answers.push((answer, bytes));
        now_or_never(self.documents.handle(request, bytes, &mut tell)).expect("a disk in memory never waits");
        answers
    }

    pub fn checkpoint(&mut self, id: &str, bytes: &[u8]) -> Vec<(Answer, Bytes)> {
        self.checkpoint_at(id, bytes, NOW_MS)
    }

    /// The same, at this time in milliseconds since 1970.
    pub fn checkpoint_at(&mut self, id: &str, bytes: &[u8], now_ms: f64) -> Vec<(Answer, Bytes)> {
        let middle = bytes.len() / 2;
        let mut answers = self.begin_checkpoint(id, &bytes[..middle], now_ms);
        let end = Request::Checkpoint { id: id.into(), is_first: false, is_last: true, log_bytes: 0, now_ms };
        answers.extend(self.ask(end, &bytes[middle..]));
        answers
    }

    /// Writes the first part of a checkpoint.
    pub fn begin_checkpoint(&mut self, id: &str, bytes: &[u8], now_ms: f64) -> Vec<(Answer, Bytes)> {
        let part =
            Request::Checkpoint { id: id.into(), is_first: true, is_last: false, log_bytes: 0, now_ms };
        self.ask(part, bytes)
    }

    /// The checkpoint and the log of a document.
    pub fn open(&mut self, id: &str) -> Result<(Bytes, Bytes, Opened), WhyNot> {
        self.open_or(id, "copy")
    }

    /// The same; the copy gets this name if there must be one.
    pub fn open_or(&mut self, id: &str, copy: &str) -> Result<(Bytes, Bytes, Opened), WhyNot> {
        let mut checkpoint = Bytes::new();
        for (answer, bytes) in self.ask(Request::Open { id: id.into(), copy: copy.into() }, &[]) {
            match answer {
                Answer::Part { opening } if opening == copy => checkpoint.extend(bytes),
                Answer::Discard { opening } if opening == copy => checkpoint.clear(),
                Answer::Opened(opened) => return Ok((checkpoint, bytes, opened)),
                Answer::NotOpened { why, .. } => return Err(why),
                answer => panic!("{answer:?}"),
            }
        }
        panic!("no answer");
    }

    pub fn list(&mut self) -> Vec<Kept> {
        match self.ask(Request::List, &[]).pop() {
            Some((Answer::Listed { documents, .. }, _)) => documents,
            answer => panic!("{answer:?}"),
        }
    }
}

pub fn record(name: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    append_record(&mut bytes, &Entry { event: Event::Name(name.into()), revision: 1 });
    bytes
}

pub fn describe(id: &str, info: Info) -> Request {
    Request::Describe { id: id.into(), info }
}

pub fn info(name: &str) -> Info {
    Info { name: name.into(), is_touched: true, sizes: [1, 8, 6], changed_ms: 5.0, ..Info::default() }
}

/// The names in a log.
pub fn names(log: &[u8]) -> Vec<String> {
    let name = |entry: Entry| match entry.event {
        Event::Name(name) => name,
        event => panic!("{event:?}"),
    };
    read_log(log).entries.into_iter().map(name).collect()
}

/// The answers without their bytes.
pub fn answers(answers: Vec<(Answer, Bytes)>) -> Vec<Answer> {
    answers.into_iter().map(|(answer, _)| answer).collect()
}

/// Keeps a document with one checkpoint and one record.
pub fn keep(visitor: &mut Visitor, id: &str, checkpoint: &[u8]) {
    visitor.ask(Request::Begin(id.into()), &[]);
    visitor.ask(describe(id, info(id)), &[]);
    assert_eq!(answers(visitor.checkpoint(id, checkpoint)), [Answer::Checked(id.into())]);
    visitor.ask(Request::Append(id.into()), &record("one"));
}
