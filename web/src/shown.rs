//! Which parts of the page are open.

use halfedge::Element;

/// Which parts of the page are open, and which kind of element it is about.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// The kind of element that the list shows and clicks in the viewport select.
    pub kind: Element,
    /// The list shows selected elements only.
    pub only_selected: bool,
    pub left: bool,
    pub right: bool,
    pub overlay: bool,
    pub shortcuts: bool,
    pub messages: bool,
    pub about: bool,
    /// The sheet of the narrow layout.
    pub sheet: Sheet,
}

impl Default for Shown {
    fn default() -> Self {
        Self {
            kind: Element::Vertex,
            only_selected: false,
            left: true,
            right: true,
            overlay: false,
            shortcuts: false,
            messages: false,
            about: false,
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
}

impl Shown {
    /// Closes the windows that are open; returns whether there were any.
    pub fn close_windows(&mut self) -> bool {
        let any = self.shortcuts || self.messages || self.about;
        (self.shortcuts, self.messages, self.about) = (false, false, false);
        any
    }

    /// Closes one window.
    pub fn close(&mut self, window: Window) {
        match window {
            Window::Shortcuts => self.shortcuts = false,
            Window::Messages => self.messages = false,
            Window::About => self.about = false,
        }
    }
}

/// What the sheet of the narrow layout shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tab {
    /// The lists.
    #[default]
    Lists,
    /// The inspector.
    Inspector,
    /// The operations.
    Operations,
}

/// The sheet of the narrow layout: which tab, and whether it is put away.
#[derive(Clone, Copy, Debug, Default)]
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
