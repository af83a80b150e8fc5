//! What the worker and the page send each other, as JavaScript values.

use editor::{CommandError, ErrorKind};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};

/// What a worker tells the page.
#[derive(Clone, Debug, PartialEq)]
pub enum Message {
    /// The worker listens: requests sent before this are lost.
    Ready,
    /// A job got further.
    Progress {
        /// The number that came with the request.
        job: u64,
        /// 0 to 1.
        fraction: f32,
    },
    /// A job is done.
    Done {
        /// The number that came with the request.
        job: u64,
        /// An `editor::JobResult` as bytes.
        result: Vec<u8>,
        /// How large the worker's memory has become in bytes.
        memory: f64,
    },
    /// A job failed with a reason for the user.
    Refused {
        /// The number that came with the request.
        job: u64,
        /// The reason.
        refusal: CommandError,
    },
    /// The request made no sense to the worker, which can only be a fault of the program.
    Misunderstood {
        /// The number that came with the request.
        job: u64,
        /// What was wrong with it.
        reason: String,
    },
    /// The worker's program failed and runs no more.
    Crashed {
        /// What the panic said.
        reason: String,
    },
}

impl Message {
    /// The value to post, and the list of what to transfer with it.
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
                let (bytes, buffer) = transferable(result);
                push(&["done".into(), job_to_js(*job), bytes.into(), (*memory).into()]);
                transfer.push(&buffer);
            }
            Self::Refused { job, refusal } => {
                let CommandError { op, field, problem, kind, .. } = refusal;
                push(&["refused".into(), job_to_js(*job), op.into(), field.clone().into(), problem.into()]);
                push(&[kind_to_js(*kind)]);
            }
            Self::Misunderstood { job, reason } => {
                push(&["misunderstood".into(), job_to_js(*job), reason.into()]);
            }
            Self::Crashed { reason } => push(&["crashed".into(), reason.into()]),
        }
        (message.into(), transfer.into())
    }

    /// Reads what [`to_js`](Self::to_js) wrote; `None` for anything else.
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
                let memory = parts.get(3).as_f64()?;
                Some(Self::Done { job: job_from_js(&parts.get(1))?, result: bytes.to_vec(), memory })
            }
            "refused" => {
                let refusal = CommandError {
                    op: parts.get(2).as_string()?,
                    field: parts.get(3).as_string(),
                    problem: parts.get(4).as_string()?,
                    kind: kind_from_js(&parts.get(5))?,
                    advice: None,
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

/// What the page posts for a job: the value, and the list of what to transfer with it.
pub fn request(job: u64, bytes: &[u8]) -> (JsValue, JsValue) {
    let (bytes, buffer) = transferable(bytes);
    (Array::of2(&job_to_js(job), &bytes).into(), Array::of1(&buffer).into())
}

/// Reads what [`request`] wrote.
pub(crate) fn read_request(value: &JsValue) -> Option<(u64, Vec<u8>)> {
    let parts: &Array = value.dyn_ref()?;
    let bytes: Uint8Array = parts.get(1).dyn_into().ok()?;
    Some((job_from_js(&parts.get(0))?, bytes.to_vec()))
}

/// A copy of bytes outside the program's memory, and its buffer, which can be given away.
pub fn transferable(bytes: &[u8]) -> (Uint8Array, JsValue) {
    let array = Uint8Array::new_from_slice(bytes);
    let buffer = array.buffer().into();
    (array, buffer)
}

/// Numbers of jobs count up from 0 and stay far below 2^53.
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
