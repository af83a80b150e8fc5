//! Which parts of the page are open.

use halfedge::Element;
use serde::{Deserialize, Serialize};

use crate::embedding::Parts;
use crate::view::pane::Split;

/// Arrangements of the page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Arrangement {
    /// Tools and viewport first.
    Model,
    /// The lists and the half-edge inspector open.
    #[default]
    Study,
}

/// Which parts of the page are open, and the kind of element that it shows.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// The kind of element in the list, which clicks in the viewport select.
    pub kind: Element,
    /// Whether the list shows only selected elements.
    pub only_selected: bool,
    /// The parts that the page has at all.
    pub parts: Parts,
    pub left: bool,
    pub right: bool,
    /// Whether the list of steps is open, in the panel on the right.
    pub history: bool,
    /// The same in a low window.
    pub history_in_low: bool,
    pub overlay: bool,
    /// The welcome view over the viewport.
    pub welcome: bool,
    /// Whether the document of the last visit is being opened.
    pub is_opening: bool,
    /// Whether the ids of the elements around the pointer are shown.
    pub numbers: bool,
    pub shortcuts: bool,
    pub messages: bool,
    pub about: bool,
    /// The window with the named selections.
    pub named: bool,
    /// The window with the link to the document.
    pub share: bool,
    /// The window with the documents that the browser keeps.
    pub documents: bool,
    /// Whether clicks and taps add to the selection, or remove from it.
    pub adds: bool,
    /// Whether the window is too narrow for panels beside the viewport.
    pub narrow: bool,
    /// Whether the window is so low that the list of steps has to be opened.
    pub low: bool,
    /// Whether controls are for fingers: on a telephone, or once a finger touched the page.
    pub touch: bool,
    /// Whether the user chose how the page is arranged.
    pub is_arranged: bool,
    /// How the page is arranged.
    pub arrangement: Arrangement,
    /// How the viewport is split where there is room.
    pub split: Split,
    /// The size of texts and controls that the user chose, in percent.
    pub scale_percent: u16,
    /// The sheet of the narrow layout.
    pub sheet: Sheet,
}

impl Default for Shown {
    fn default() -> Self {
        Self {
            kind: Element::Vertex,
            only_selected: false,
            parts: Parts::default(),
            left: true,
            right: true,
            history: true,
            history_in_low: false,
            overlay: false,
            welcome: false,
            is_opening: false,
            numbers: false,
            shortcuts: false,
            messages: false,
            about: false,
            named: false,
            share: false,
            documents: false,
            adds: false,
            narrow: false,
            low: false,
            touch: false,
            is_arranged: false,
            arrangement: Arrangement::default(),
            split: Split::default(),
            scale_percent: 100,
            sheet: Sheet::default(),
        }
    }
}

/// A window over the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Window {
    Shortcuts,
    Messages,
    About,
    Named,
    Share,
    Documents,
}

impl Shown {
    /// Closes all open windows; returns whether there were any.
    pub fn close_windows(&mut self) -> bool {
        let windows = [
            &mut self.shortcuts,
            &mut self.messages,
            &mut self.about,
            &mut self.named,
            &mut self.share,
            &mut self.documents,
        ];
        windows.into_iter().filter_map(|open| std::mem::take(open).then_some(())).count() > 0
    }

    /// Whether the list of steps is shown.
    pub fn shows_history(&self) -> bool {
        if self.narrow {
            self.sheet.tab == Tab::History && !self.sheet.closed
        } else {
            self.right && if self.low { self.history_in_low } else { self.history }
        }
    }

    /// Shows or hides the list of steps, with the panel that it is in.
    pub fn toggle_history(&mut self) {
        let shows = !self.shows_history();
        if self.narrow {
            self.sheet = Sheet { tab: Tab::History, closed: !shows };
        } else {
            let open = if self.low { &mut self.history_in_low } else { &mut self.history };
            *open = shows;
            self.right |= shows;
        }
    }

    /// Closes one window.
    pub fn close(&mut self, window: Window) {
        match window {
            Window::Shortcuts => self.shortcuts = false,
            Window::Messages => self.messages = false,
            Window::About => self.about = false,
            Window::Named => self.named = false,
            Window::Share => self.share = false,
            Window::Documents => self.documents = false,
        }
    }
}

/// The tabs in the sheet of the narrow layout.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Tab {
    /// The lists.
    #[default]
    Lists,
    /// The inspector.
    Inspector,
    /// The operations.
    Operations,
    /// The steps.
    History,
}

/// The sheet of the narrow layout: which tab it shows, and whether it is closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Sheet {
    pub tab: Tab,
    pub closed: bool,
}

impl Sheet {
    pub fn show_lists(&mut self) {
        *self = Self { tab: Tab::Lists, closed: false };
    }

    pub fn show_operations(&mut self) {
        *self = Self { tab: Tab::Operations, closed: false };
    }
}
