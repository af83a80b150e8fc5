//! The page's side of the worker that runs jobs.
//!
//! There is one worker, which runs one job at a time. A running job can't be interrupted from outside, so
//! cancelling it terminates the worker and starts another. A worker whose memory has grown large is also
//! replaced, because WebAssembly memory never shrinks.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::{Rc, Weak};

use editor::{CommandError, ErrorKind, JobRequest, JobResult, Reading};
use meshwright_worker::{Received, Request};
use wasm_bindgen::prelude::*;

use super::inbox::{Inbox, describe};
use super::worker::{Link, script};
use crate::platform::Event;

/// The worker's name.
const WORKER_NAME: &str = "meshwright-worker";

/// What to do after a worker has ended.
const LOST_ADVICE: &str =
    " The document is unchanged. Close other tabs and programs, or take a smaller mesh, and try again.";

/// A worker whose memory has grown past this many bytes is replaced when it is idle.
const MAX_IDLE_MEMORY_BYTES: f64 = (256 << 20) as f64;

/// How many bytes of a result are read in a frame. A million triangles take 60 MB.
const BYTES_READ_PER_FRAME: usize = 8 << 20;

/// Runs jobs in order in a worker.
pub struct Jobs {
    pool: Rc<RefCell<Pool>>,
}

struct Pool {
    inbox: Inbox,
    waiting: VecDeque<(u64, Request)>,
    running: Option<u64>,
    /// The result of the running job, while it is being read.
    arriving: Option<Arriving>,
    worker: Option<Link>,
    /// Whether the worker's program has started; messages sent earlier are lost.
    is_ready: bool,
    /// For the message handlers of later workers.
    this: Weak<RefCell<Pool>>,
}

struct Arriving {
    result: Reading<JobResult>,
    /// The size of the worker's memory in bytes.
    memory: f64,
}

impl Jobs {
    pub fn new(inbox: Inbox) -> Self {
        let pool = Rc::new_cyclic(|this| {
            RefCell::new(Pool {
                inbox,
                waiting: VecDeque::new(),
                running: None,
                arriving: None,
                worker: None,
                is_ready: false,
                this: this.clone(),
            })
        });
        pool.borrow_mut().start_worker();
        Self { pool }
    }

    pub fn start(&self, job: u64, request: &JobRequest) {
        let mut pool = self.pool.borrow_mut();
        pool.waiting.push_back((job, Request::new(job, request)));
        pool.go_on();
    }

    /// Reads more of the result that is arriving. Called once per frame.
    pub fn step(&self) {
        self.pool.borrow_mut().read_more();
    }

    pub fn cancel(&self, job: u64) {
        let mut pool = self.pool.borrow_mut();
        pool.waiting.retain(|(waiting, _)| *waiting != job);
        if pool.running == Some(job) {
            (pool.running, pool.arriving) = (None, None);
            pool.start_worker();
        }
    }
}

impl Pool {
    /// Replaces the worker, if there is one, by a new one.
    fn start_worker(&mut self) {
        (self.worker, self.is_ready) = (None, false);
        match link(&self.this) {
            Ok(link) => self.worker = Some(link),
            Err(error) => self.fail_all(&could_not_start(&describe(&error))),
        }
    }

    /// Sends the next job if the worker is idle.
    fn go_on(&mut self) {
        if self.running.is_some() || self.waiting.is_empty() {
            return;
        }
        if self.worker.is_none() {
            self.start_worker();
        }
        let Some(link) = self.worker.as_ref().filter(|_| self.is_ready) else {
            return;
        };
        let Some((job, request)) = self.waiting.pop_front() else {
            return;
        };
        match link.worker.post_message_with_transfer(&request.value, &request.transfer) {
            Ok(()) => self.running = Some(job),
            Err(error) => {
                self.fail(job, format!("The job could not be sent to the worker: {}.", describe(&error)));
            }
        }
    }

    fn on_message(&mut self, message: Received) {
        match message {
            Received::Ready => {
                self.is_ready = true;
                self.go_on();
            }
            Received::Progress { job, fraction } => self.inbox.push(Event::JobProgress { job, fraction }),
            Received::Done { job, result, memory } => {
                if self.running == Some(job) {
                    self.arriving = Some(Arriving { result, memory });
                    self.inbox.wake();
                }
            }
            Received::Refused { job, refusal } => {
                self.running = None;
                self.inbox.push(Event::JobDone { job, result: Err(refusal) });
                self.go_on();
            }
            Received::Misunderstood { job, reason } => self.misunderstood(job, &reason),
            Received::Crashed { reason } => {
                self.lost(&format!(
                    "The worker has crashed, which is a bug in Meshwright: {}.{LOST_ADVICE}",
                    reason.trim_end_matches('.')
                ));
            }
        }
    }

    fn read_more(&mut self) {
        let (Some(job), Some(arriving)) = (self.running, &mut self.arriving) else { return };
        let Some(read) = arriving.result.step(BYTES_READ_PER_FRAME) else {
            self.inbox.wake();
            return;
        };
        let memory = arriving.memory;
        self.arriving = None;
        match read {
            Ok(result) => {
                self.running = None;
                self.inbox.push(Event::JobDone { job, result: Ok(result) });
                if memory > MAX_IDLE_MEMORY_BYTES {
                    self.start_worker();
                }
                self.go_on();
            }
            Err(error) => self.misunderstood(job, &error.to_string()),
        }
    }

    fn misunderstood(&mut self, job: u64, reason: &str) {
        self.running = None;
        self.fail(
            job,
            format!("The page and its worker did not understand each other: {reason}. Reload the page."),
        );
        self.go_on();
    }

    /// The worker's program ended or never started, without a panic message.
    fn on_error(&mut self, said: Option<String>) {
        if self.is_ready {
            let said = said.map(|said| format!("{}.", said.trim_end_matches('.'))).unwrap_or_default();
            self.lost(&format!(
                "The worker stopped, most likely because the browser gave it no more memory. {said}{LOST_ADVICE}"
            ));
        } else {
            self.worker = None;
            let reason = said.unwrap_or_else(|| format!("{} did not load", script()));
            self.fail_all(&could_not_start(&reason));
        }
    }

    /// Fails the running job and continues with the waiting ones in a new worker.
    fn lost(&mut self, reason: &str) {
        if let Some(job) = self.take_unanswered() {
            self.fail(job, reason.to_owned());
        }
        self.start_worker();
    }

    /// The running job, which the worker won't answer any more. A result that has left the worker still arrives.
    fn take_unanswered(&mut self) -> Option<u64> {
        if self.arriving.is_some() { None } else { self.running.take() }
    }

    fn fail(&self, job: u64, problem: String) {
        let error = CommandError { kind: ErrorKind::Internal, ..CommandError::refused("job", problem) };
        self.inbox.push(Event::JobDone { job, result: Err(error) });
    }

    fn fail_all(&mut self, reason: &str) {
        let running = self.take_unanswered();
        let waiting = std::mem::take(&mut self.waiting);
        for job in running.into_iter().chain(waiting.into_iter().map(|(job, _)| job)) {
            self.fail(job, reason.to_owned());
        }
    }
}

/// Starts a worker for jobs.
fn link(pool: &Weak<RefCell<Pool>>) -> Result<Link, JsValue> {
    let (messages, errors) = (pool.clone(), pool.clone());
    Link::new(
        WORKER_NAME,
        move |message| {
            if let Some(pool) = messages.upgrade()
                && let Some(message) = Received::from_js(&message)
            {
                pool.borrow_mut().on_message(message);
            }
        },
        move |said| {
            if let Some(pool) = errors.upgrade() {
                pool.borrow_mut().on_error(said);
            }
        },
    )
}

fn could_not_start(reason: &str) -> String {
    format!("The worker that runs jobs could not be started: {reason}. Check the connection and try again.")
}
