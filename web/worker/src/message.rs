//! The messages between the worker and the page, as JavaScript values.
//!
//! A job and its result travel in a buffer that is transferred, not copied: the sender copies its mesh into
//! the buffer, and the receiver copies it out. See [`editor::Wire`].

use editor::{BadBytes, CommandError, ErrorKind, JobRequest, JobResult, Reading, Wire};
use js_sys::{Array, Uint8Array};
use std::io::{self, BufReader, BufWriter, Read, Write};
use wasm_bindgen::{JsCast, JsValue};

/// A message from the worker to the page. The worker posts results whole ([`Posted`]); the page reads them in parts
/// ([`Received`]).
#[derive(Debug)]
pub enum Message<R> {
    /// The worker is listening; requests sent earlier are lost.
    Ready,
    /// A job made progress.
    Progress {
        /// The number that came with the request.
        job: u64,
        /// The completed fraction, 0 to 1.
        fraction: f32,
    },
    /// A job is done.
    Done {
        /// The number that came with the request.
        job: u64,
        /// Its result.
        result: R,
        /// The size of the worker's memory in bytes.
        memory: f64,
    },
    /// A job failed with a reason for the user.
    Refused {
        /// The number that came with the request.
        job: u64,
        /// The reason.
        refusal: CommandError,
    },
    /// One side could not read the other's message, which is always a fault of the program.
    Misunderstood {
        /// The number that came with the request.
        job: u64,
        /// Why.
        reason: String,
    },
    /// The worker's program panicked and has stopped.
    Crashed {
        /// The panic's message.
        reason: String,
    },
}

/// A message that the worker posts.
pub type Posted = Message<JobResult>;

/// A message that the page receives.
pub type Received = Message<Reading<JobResult>>;

impl Posted {
    /// The value to post, and the list of objects to transfer with it.
    pub fn to_js(&self) -> (JsValue, JsValue) {
        let message = Array::new();
        let transfer = Array::new();
        let push = |values: &[JsValue]| {
            for value in values {
                message.push(value);
            }
        };
        match self {
            Self::Ready => push(&["ready".into()]),
            Self::Progress { job, fraction } => {
                push(&["progress".into(), job_to_js(*job), (*fraction).into()]);
            }
            Self::Done { job, result, memory } => {
                let bytes = to_array(result);
                push(&["done".into(), job_to_js(*job), (&bytes).into(), (*memory).into()]);
                transfer.push(&bytes.buffer());
            }

            Self::Refused { job, refusal } => {
                let CommandError { op, field, problem, kind, is_of_field, advice } = refusal;
                push(&["refused".into(), job_to_js(*job), op.into(), field.clone().into(), problem.into()]);
                push(&[kind_to_js(*kind), (*is_of_field).into(), advice.clone().into()]);
            }
            Self::Misunderstood { job, reason } => {
                push(&["misunderstood".into(), job_to_js(*job), reason.into()]);
            }
            Self::Crashed { reason } => push(&["crashed".into(), reason.into()]),
        }
        (message.into(), transfer.into())
    }
}

impl Received {
    /// Reads a value written by [`Posted::to_js`]; `None` for anything else.
    pub fn from_js(value: &JsValue) -> Option<Self> {
        let parts: &Array = value.dyn_ref()?;
        match parts.get(0).as_string()?.as_str() {
            "ready" => Some(Self::Ready),
            "progress" => Some(Self::Progress {
                job: job_from_js(&parts.get(1))?,
                fraction: parts.get(2).as_f64()? as f32,
            }),
            "done" => {
                let bytes: Uint8Array = parts.get(2).dyn_into().ok()?;
                let len = bytes.length() as usize;
                Some(Self::Done {
                    job: job_from_js(&parts.get(1))?,
                    result: Reading::new(BufReader::new(Cursor { array: bytes, at: 0 }), len),
                    memory: parts.get(3).as_f64()?,
                })
            }
            "refused" => {
                let refusal = CommandError {
                    op: parts.get(2).as_string()?,
                    field: parts.get(3).as_string(),
                    problem: parts.get(4).as_string()?,
                    kind: kind_from_js(&parts.get(5))?,
                    is_of_field: parts.get(6).as_bool()?,
                    advice: parts.get(7).as_string(),
                };
                Some(Self::Refused { job: job_from_js(&parts.get(1))?, refusal })
            }
            "misunderstood" => Some(Self::Misunderstood {
                job: job_from_js(&parts.get(1))?,
                reason: parts.get(2).as_string()?,
            }),
            "crashed" => Some(Self::Crashed { reason: parts.get(1).as_string()? }),
            _ => None,
        }
    }
}

/// A job, ready to be posted to the worker, in memory outside the program's own.
pub struct Request {
    /// The value to post.
    pub value: JsValue,
    /// The list of objects to transfer with it.
    pub transfer: JsValue,
}

impl Request {
    /// Copies a job into a buffer.
    pub fn new(job: u64, request: &JobRequest) -> Self {
        let bytes = to_array(request);
        let transfer = Array::of1(&bytes.buffer()).into();
        Self { value: Array::of2(&job_to_js(job), &bytes).into(), transfer }
    }

    /// Reads a posted value: the job's number, and the job or why it can't be read. `None` for anything
    /// that is not a request.
    pub fn read(value: &JsValue) -> Option<(u64, Result<JobRequest, BadBytes>)> {
        let parts: &Array = value.dyn_ref()?;
        let bytes: Uint8Array = parts.get(1).dyn_into().ok()?;
        Some((job_from_js(&parts.get(0))?, from_array(&bytes)))
    }
}

/// Copies a value into its own JavaScript buffer, which can be transferred.
fn to_array(value: &impl Wire) -> Uint8Array {
    // WebAssembly addresses have 32 bits.
    let array = Uint8Array::new_with_length(u32::try_from(value.byte_len()).unwrap_or(u32::MAX));
    // The array is large enough, so writing can't fail.
    let mut out = BufWriter::new(Cursor { array: array.clone(), at: 0 });
    let _ = value.write_to(&mut out).and_then(|()| out.flush());
    drop(out);
    array
}

fn from_array<T: Wire>(array: &Uint8Array) -> Result<T, BadBytes> {
    let mut from = BufReader::new(Cursor { array: array.clone(), at: 0 });
    T::read_from(&mut from, array.length() as usize)
}

/// A position in a JavaScript array. The buffered writer and reader around it collect small blocks, to
/// avoid a JavaScript call for each, and pass large ones on.
struct Cursor {
    array: Uint8Array,
    at: u32,
}

impl Cursor {
    /// The next part of the array, at most `len` bytes long.
    fn advance(&mut self, len: usize) -> Uint8Array {
        let left = self.array.length() - self.at;
        let end = self.at + u32::try_from(len).map_or(left, |len| len.min(left));
        let part = self.array.subarray(self.at, end);
        self.at = end;
        part
    }
}

impl Write for Cursor {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let part = self.advance(bytes.len());
        let len = part.length() as usize;
        if let Some(bytes) = bytes.get(..len) {
            part.copy_from(bytes);
        }
        Ok(len)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Read for Cursor {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let part = self.advance(bytes.len());
        let len = part.length() as usize;
        if let Some(bytes) = bytes.get_mut(..len) {
            part.copy_to(bytes);
        }
        Ok(len)
    }
}

/// Job numbers count up from 1 and stay far below 2^53.
fn job_to_js(job: u64) -> JsValue {
    (job as f64).into()
}

fn job_from_js(value: &JsValue) -> Option<u64> {
    value.as_f64().filter(|job| *job >= 0.0).map(|job| job as u64)
}

const KINDS: [(ErrorKind, &str); 4] = [
    (ErrorKind::Refused, "refused"),
    (ErrorKind::Cancelled, "cancelled"),
    (ErrorKind::NothingToDo, "nothing-to-do"),
    (ErrorKind::Internal, "internal"),
];

fn kind_to_js(kind: ErrorKind) -> JsValue {
    KINDS.iter().find(|(known, _)| *known == kind).map_or(JsValue::NULL, |(_, name)| (*name).into())
}

fn kind_from_js(value: &JsValue) -> Option<ErrorKind> {
    let name = value.as_string()?;
    KINDS.iter().find(|(_, known)| *known == name).map(|(kind, _)| *kind)
}
