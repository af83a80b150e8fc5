//! Closing the window: at once when nothing would be lost, else when the last changes are kept or the user says so.

use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;
use std::time::{Duration, Instant};

use egui::{Context, ViewportCommand};
use rfd::{AsyncMessageDialog, MessageButtons, MessageDialogResult, MessageLevel};

/// How long closing waits for changes that are being written before it asks.
const MAX_WAIT: Duration = Duration::from_secs(5);
/// How often it looks meanwhile.
const LOOK_AGAIN: Duration = Duration::from_millis(50);

const CLOSE_ANYWAY: &str = "Close anyway";
const STAY: &str = "Stay";

/// What closing waits for.
#[derive(Debug, Default)]
pub enum Closing {
    /// Nobody closes the window.
    #[default]
    No,
    /// The last changes are being written since then.
    Waiting(Instant),
    /// The user is asked, and answers whether to close.
    Asking(Receiver<bool>),
    /// The window closes.
    Yes,
}

impl Closing {
    /// Looks once a frame whether the window is to be closed and may be.
    pub fn follow(&mut self, ctx: &Context, would_lose_changes: bool) {
        let is_asked = ctx.input(|input| input.viewport().close_requested());
        if is_asked && !matches!(self, Self::Yes) {
            if would_lose_changes {
                ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            }
            if matches!(self, Self::No) {
                *self = Self::Waiting(Instant::now());
            }
        }
        self.go_on(would_lose_changes, Instant::now(), ask);
        match self {
            Self::No => {}
            Self::Yes if is_asked && !would_lose_changes => {}
            Self::Yes => ctx.send_viewport_cmd(ViewportCommand::Close),
            Self::Waiting(_) | Self::Asking(_) => ctx.request_repaint_after(LOOK_AGAIN),
        }
    }

    fn go_on(&mut self, would_lose_changes: bool, now: Instant, ask: impl FnOnce() -> Receiver<bool>) {
        match self {
            Self::Waiting(_) if !would_lose_changes => *self = Self::Yes,
            Self::Waiting(since) if now.duration_since(*since) > MAX_WAIT => *self = Self::Asking(ask()),
            Self::Asking(answer) => match answer.try_recv() {
                Ok(true) => *self = Self::Yes,
                Ok(false) => *self = Self::No,
                Err(TryRecvError::Empty) => {}
                // Without a dialog, nobody could ever answer.
                Err(TryRecvError::Disconnected) => *self = Self::Yes,
            },
            Self::No | Self::Waiting(_) | Self::Yes => {}
        }
    }
}

/// Asks whether to close although changes would be lost.
fn ask() -> Receiver<bool> {
    let (answer, answered) = channel();
    // Some systems show dialogs only from the thread of the window; waiting is fine in any.
    let dialog = AsyncMessageDialog::new()
        .set_level(MessageLevel::Warning)
        .set_title("Close Meshwright?")
        .set_description("The last changes are neither saved to a file nor kept.")
        .set_buttons(MessageButtons::OkCancelCustom(CLOSE_ANYWAY.to_owned(), STAY.to_owned()))
        .show();
    thread::spawn(move || {
        let closes = match pollster::block_on(dialog) {
            MessageDialogResult::Custom(label) => label == CLOSE_ANYWAY,
            result => result == MessageDialogResult::Ok,
        };
        // The window may have closed meanwhile.
        let _ = answer.send(closes);
    });
    answered
}

#[cfg(test)]
mod tests {
    use super::*;

    fn never() -> Receiver<bool> {
        panic!("nobody should be asked")
    }

    #[test]
    fn a_window_with_nothing_to_lose_closes_at_once() {
        let mut closing = Closing::Waiting(Instant::now());
        closing.go_on(false, Instant::now(), never);
        assert!(matches!(closing, Closing::Yes));
    }

    #[test]
    fn it_waits_for_changes_that_are_being_written() {
        let since = Instant::now();
        let mut closing = Closing::Waiting(since);
        closing.go_on(true, since + Duration::from_secs(1), never);
        assert!(matches!(closing, Closing::Waiting(_)));
        closing.go_on(false, since + Duration::from_secs(2), never);
        assert!(matches!(closing, Closing::Yes));
    }

    #[test]
    fn it_asks_when_they_can_not_be_written_and_does_what_is_answered() {
        for (answer, closes) in [(true, true), (false, false)] {
            let since = Instant::now();
            let mut closing = Closing::Waiting(since);
            let (answers, answered) = channel();
            closing.go_on(true, since + MAX_WAIT * 2, || answered);
            assert!(matches!(closing, Closing::Asking(_)));
            closing.go_on(true, since + MAX_WAIT * 3, never);
            assert!(matches!(closing, Closing::Asking(_)), "it waits for the answer");
            answers.send(answer).unwrap();
            closing.go_on(true, since + MAX_WAIT * 3, never);
            assert_eq!(matches!(closing, Closing::Yes), closes);
            assert_eq!(matches!(closing, Closing::No), !closes);
        }
    }

    #[test]
    fn a_window_that_nobody_closes_stays() {
        let mut closing = Closing::No;
        closing.go_on(true, Instant::now(), never);
        assert!(matches!(closing, Closing::No));
    }
}
