//! Toasts: short messages about imports, refusals and failures.

use editor::MessageKind;

use crate::input::actions::Action;

/// A message with optional details.
#[derive(Clone, Debug)]
pub(crate) struct Toast {
    pub kind: MessageKind,
    pub text: String,
    pub details: Vec<String>,
    pub open: bool,
    /// An action that helps.
    pub remedy: Option<Action>,
    /// The time at which it disappears, on egui's clock; none if the user has to close it.
    until: Option<f64>,
}

/// The visible toasts.
#[derive(Debug, Default)]
pub struct Toasts {
    list: Vec<Toast>,
}

/// How long an informative toast stays, in seconds.
const SECONDS_INFO_STAYS: f64 = 6.0;
/// How long a refusal stays, in seconds.
const SECONDS_REFUSAL_STAYS: f64 = 12.0;
/// More toasts would cover the viewport; the messages window lists all messages.
const MAX_TOASTS: usize = 4;

impl Toasts {
    pub(crate) fn add(&mut self, now: f64, kind: MessageKind, text: String, details: Vec<String>) {
        let stays = if kind == MessageKind::Info { SECONDS_INFO_STAYS } else { SECONDS_REFUSAL_STAYS };
        // A repeated message replaces the earlier one and stays longer.
        self.list.retain(|toast| toast.text != text);
        let until = Some(now + stays);
        self.list.push(Toast { kind, text, details, open: false, remedy: None, until });
        if self.list.len() > MAX_TOASTS {
            self.list.remove(0);
        }
    }

    /// Removes the actions that toasts offer; their texts stay.
    pub(crate) fn withdraw(&mut self) {
        for toast in &mut self.list {
            toast.remedy = None;
        }
    }

    /// Offers an action in the latest toast.
    pub(crate) fn offer(&mut self, remedy: Action) {
        if let Some(toast) = self.list.last_mut() {
            toast.remedy = Some(remedy);
        }
    }

    /// The visible toasts, the oldest first.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Toast> {
        self.list.iter()
    }

    /// Removes expired toasts; returns the seconds until the next one expires.
    pub(crate) fn expire(&mut self, now: f64) -> Option<f64> {
        self.list.retain(|toast| toast.until.is_none_or(|until| until > now));
        self.list.iter().filter_map(|toast| toast.until).reduce(f64::min).map(|next| next - now)
    }

    /// Shows or hides the details of a toast, which from then on stays until the user closes it.
    pub(crate) fn toggle(&mut self, at: usize) {
        if let Some(toast) = self.list.get_mut(at) {
            toast.open = !toast.open;
            toast.until = None;
        }
    }

    /// Removes a toast.
    pub(crate) fn dismiss(&mut self, at: usize) {
        if at < self.list.len() {
            self.list.remove(at);
        }
    }
}
