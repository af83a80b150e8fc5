//! Short messages: what was imported, refused, or failed.

use editor::MessageKind;

use crate::input::actions::Action;

/// A message with what there is to say besides.
#[derive(Clone, Debug)]
pub(crate) struct Toast {
    pub kind: MessageKind,
    pub text: String,
    pub details: Vec<String>,
    pub open: bool,
    /// What can be done about it.
    pub remedy: Option<Action>,
    /// When it goes by itself, on egui's clock; none where the person has to close it.
    until: Option<f64>,
}

/// The messages that are in view.
#[derive(Debug, Default)]
pub struct Toasts {
    list: Vec<Toast>,
}

/// Seconds that a message stays if it needs no action.
const SECONDS_INFO_STAYS: f64 = 6.0;
/// Seconds that a refusal stays.
const SECONDS_REFUSAL_STAYS: f64 = 12.0;
/// More than this would cover the viewport; the messages window has them all.
const MAX_TOASTS: usize = 4;

impl Toasts {
    pub(crate) fn add(&mut self, now: f64, kind: MessageKind, text: String, details: Vec<String>) {
        let stays = if kind == MessageKind::Info { SECONDS_INFO_STAYS } else { SECONDS_REFUSAL_STAYS };
        // The same again only stays longer.
        self.list.retain(|toast| toast.text != text);
        let until = Some(now + stays);
        self.list.push(Toast { kind, text, details, open: false, remedy: None, until });
        if self.list.len() > MAX_TOASTS {
            self.list.remove(0);
        }
    }

    /// Takes back what messages offer; what they say stays.
    pub(crate) fn withdraw(&mut self) {
        for toast in &mut self.list {
            toast.remedy = None;
        }
    }

    /// Offers an action in the message that was said last.
    pub(crate) fn offer(&mut self, remedy: Action) {
        if let Some(toast) = self.list.last_mut() {
            toast.remedy = Some(remedy);
        }
    }

    /// The messages in view, the oldest first.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Toast> {
        self.list.iter()
    }

    /// Drops the messages whose time is over; returns in how many seconds the next one's is.
    pub(crate) fn expire(&mut self, now: f64) -> Option<f64> {
        self.list.retain(|toast| toast.until.is_none_or(|until| until > now));
        self.list.iter().filter_map(|toast| toast.until).reduce(f64::min).map(|next| next - now)
    }

    /// Shows the details of a message, or hides them; from then on the person decides when it goes.
    pub(crate) fn toggle(&mut self, at: usize) {
        if let Some(toast) = self.list.get_mut(at) {
            toast.open = !toast.open;
            toast.until = None;
        }
    }

    /// Removes a message.
    pub(crate) fn dismiss(&mut self, at: usize) {
        if at < self.list.len() {
            self.list.remove(at);
        }
    }
}
