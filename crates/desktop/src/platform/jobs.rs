//! Jobs, one after the other in a thread.

use std::collections::VecDeque;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use editor::{CommandError, ErrorKind, JobRequest, JobResult};
use meshwright_web::platform::Event;

use super::inbox::Inbox;

/// Runs jobs in order.
pub struct Jobs {
    queue: Arc<Queue>,
}

#[derive(Default)]
struct Queue {
    state: Mutex<State>,
    /// Signalled when there is something to do.
    changed: Condvar,
}

#[derive(Default)]
struct State {
    waiting: VecDeque<(u64, JobRequest)>,
    /// The job that runs; none if it was cancelled.
    running: Option<u64>,
    is_over: bool,
}

impl Jobs {
    pub fn new(inbox: Inbox) -> Self {
        let queue = Arc::new(Queue::default());
        let for_thread = queue.clone();
        std::thread::spawn(move || {
            while let Some((job, request)) = for_thread.next() {
                let result = run(&for_thread, job, request, &inbox);
                let mut state = for_thread.lock();
                if state.running.take() == Some(job) {
                    inbox.push(Event::JobDone { job, result });
                }
            }
        });
        Self { queue }
    }

    pub fn start(&self, job: u64, request: JobRequest) {
        self.queue.lock().waiting.push_back((job, request));
        self.queue.changed.notify_one();
    }

    /// Forgets a job. One that runs ends at its next sign of progress.
    pub fn cancel(&self, job: u64) {
        let mut state = self.queue.lock();
        state.waiting.retain(|(waiting, _)| *waiting != job);
        state.running.take_if(|running| *running == job);
    }
}

impl Drop for Jobs {
    fn drop(&mut self) {
        let mut state = self.queue.lock();
        (state.running, state.is_over) = (None, true);
        self.queue.changed.notify_one();
    }
}

impl Queue {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for the next job; none once the program ends.
    fn next(&self) -> Option<(u64, JobRequest)> {
        let mut state = self.lock();
        loop {
            if state.is_over {
                return None;
            }
            if let Some((job, request)) = state.waiting.pop_front() {
                state.running = Some(job);
                return Some((job, request));
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// Runs a job. Its mesh is validated here, because validating takes long.
fn run(queue: &Queue, job: u64, request: JobRequest, inbox: &Inbox) -> Result<JobResult, CommandError> {
    let mut progress = |fraction| {
        if queue.lock().running != Some(job) {
            return ControlFlow::Break(());
        }
        inbox.push(Event::JobProgress { job, fraction });
        ControlFlow::Continue(())
    };
    // A fault in a job is no reason to lose the window.
    let done = catch_unwind(AssertUnwindSafe(|| {
        let mut result = request.run(&mut progress)?;
        result.validate();
        Ok(result)
    }));
    done.unwrap_or_else(|_| {
        let problem = "The job crashed because of a bug in Meshwright. The document is unchanged.";
        Err(CommandError { kind: ErrorKind::Internal, ..CommandError::refused("job", problem) })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use editor::{Begun, Command, Editor};
    use std::time::{Duration, Instant};

    fn on_cube() -> Editor {
        let mut editor = Editor::new();
        editor
            .run(Command::from_json(r#"{"op":"new","shape":"cube"}"#).expect("a command"))
            .expect("a shape");
        editor
    }

    /// A job of an editor of its own.
    fn request(levels: u32) -> JobRequest {
        let command = Command::from_json(&format!(r#"{{"op":"subdivide-linear","levels":{levels}}}"#));
        match on_cube().begin(command.expect("a command")).expect("a cube") {
            Begun::Job(request) => request,
            other => panic!("no job: {other:?}"),
        }
    }

    fn wait_for(inbox: &Inbox, wanted: impl Fn(&Event) -> bool) -> Vec<Event> {
        let (start, mut events) = (Instant::now(), Vec::new());
        while !events.iter().any(&wanted) {
            assert!(start.elapsed() < Duration::from_secs(60), "it did not happen: {events:?}");
            events.extend(inbox.take());
            std::thread::sleep(Duration::from_millis(2));
        }
        events
    }

    fn is_done(job: u64) -> impl Fn(&Event) -> bool {
        move |event| matches!(event, Event::JobDone { job: done, result: Ok(_) } if *done == job)
    }

    #[test]
    fn jobs_report_progress_and_run_in_order() {
        let inbox = Inbox::new(&egui::Context::default());
        let jobs = Jobs::new(inbox.clone());
        jobs.start(1, request(6));
        jobs.start(2, request(6));
        let events = wait_for(&inbox, is_done(2));
        let at = |wanted: &dyn Fn(&Event) -> bool| events.iter().position(wanted).expect("it happened");
        assert!(at(&is_done(1)) < at(&is_done(2)));
        assert!(events.iter().any(|event| matches!(event, Event::JobProgress { job: 2, .. })));
    }

    #[test]
    fn a_cancelled_job_says_nothing_more_and_others_go_on() {
        const LONG: u64 = 1;
        const WAITING: u64 = 2;
        const NEXT: u64 = 3;
        let inbox = Inbox::new(&egui::Context::default());
        let jobs = Jobs::new(inbox.clone());
        jobs.start(LONG, request(9));
        jobs.start(WAITING, request(6));
        jobs.start(NEXT, request(6));
        jobs.cancel(WAITING);
        wait_for(&inbox, |event| matches!(event, Event::JobProgress { job: LONG, .. }));
        jobs.cancel(LONG);
        inbox.take();
        let events = wait_for(&inbox, is_done(NEXT));
        let others =
            events.iter().filter(|event| matches!(event, Event::JobDone { job, .. } if *job != NEXT));
        assert_eq!(others.count(), 0, "{events:?}");
    }
}
