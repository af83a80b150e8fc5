//! The requests of panels. Panels change nothing themselves; the app carries out their requests after the
//! frame is drawn.

use editor::ops::BezierInsertPoint;
use editor::{Command, CommandError, JobId, OpId, SelectMode};
use egui::{Modifiers, Pos2};
use formats::Format;
use glam::Vec3;
use halfedge::Element;
use surface::selecting::Line;

use crate::bezier::Setting;
use crate::input::actions::Action;
use crate::input::shortcut::Shortcut;
use crate::keeping::OfDocument;
use crate::live::edit::Start;
use crate::panels::welcome::Sample;
use crate::session::form::Filled;
use crate::session::toasts::Slot;
use crate::shown::{Sheet, Window};
use crate::view::pane::Pane;

/// A panel's request.
pub(crate) enum Request {
    /// Start an action, as from a menu.
    Act(Action),
    /// Make a view the active one.
    ActivateView(Pane),
    /// Carry out a command, or start its job.
    Run(Command),
    /// Do something with a document that the browser keeps.
    Document(OfDocument),
    /// Show why there is no command to carry out.
    Refuse(CommandError),
    /// Select elements.
    Select { kind: Element, ids: Vec<u32>, mode: SelectMode },
    /// Select or deselect elements as part of a stroke of the circle.
    PaintSelection { kind: Element, ids: Vec<u32>, mode: SelectMode, stroke: u64 },
    /// Extend the selection to this element of a list.
    SelectRange { kind: Element, to: u32 },
    /// Select the line of elements through a half-edge.
    SelectLine { kind: Element, through: u32, line: Line, mode: SelectMode },
    /// Extend the selection by the shortest path to an element.
    SelectPath { kind: Element, to: u32 },
    /// Clear the selection.
    Deselect,
    /// Highlight the element whose row or link is under the pointer.
    Hover(Element, u32),
    /// Show the effect of a command, in place of the ongoing edit's last update.
    UpdateEdit(Command),
    /// Make the ongoing edit one undo step.
    CommitEdit,
    /// Cancel the ongoing edit without a trace.
    CancelEdit,
    /// Commit the ongoing edit when the pointer's button is released.
    CommitEditOnRelease,
    /// Start an edit that follows the pointer.
    StartLive(Start),
    /// Move the edit that follows the pointer to this place.
    LivePointer(Option<Pos2>, Modifiers),
    /// The pointer is over the bar of the edit that follows it, where it doesn't count.
    LivePointerOnBar,
    /// Go on with the edit that follows the pointer from this place, with the same amount.
    TakeUpLive(Pos2),
    /// Turn the wheel by so many notches during the edit that follows the pointer.
    LiveWheel(i32),
    /// Make the radius of the soft selection larger by this length on the screen, in points; 0 when the drag begins.
    WidenSoft(f32),
    /// Limit the edit that follows the pointer to an axis, or no longer.
    LockLive(usize),
    /// Set the count of the edit that follows the pointer.
    SetLiveCount(u32),
    /// Set the amount of the edit that follows the pointer.
    SetLiveAmount(Vec3),
    /// Commit or cancel the edit that follows the pointer.
    EndLive { commit: bool },
    /// End the edit that follows the pointer as Escape and a right-click do.
    AbandonLive,
    /// Show an operation's form.
    OpenForm(OpId),
    /// Show the list of operations again.
    CloseForm,
    /// Close the welcome view.
    CloseWelcome,
    /// Show the welcome view when the page opens, or don't.
    WelcomeAtStart(bool),
    /// Open a sample model.
    OpenSample(Sample),
    /// Start a new document with the shape of this name.
    StartWithShape(&'static str),
    /// Preview an operation with these fields.
    Preview(OpId, Filled),
    /// Remove the preview.
    EndPreview,
    /// Make the preview of an operation with these fields one undo step, or carry the operation out.
    Apply(OpId, Filled),
    /// Run the last operation again with other fields.
    Adjust(Command),
    /// Undo the last edit, and what was selected since.
    UndoEdit,
    /// Go to the state right after this many edits of the history.
    JumpTo(usize),
    /// Change one thing about what the Bezier player shows.
    Play(Setting),
    /// Add a control point to the active curve, and choose it.
    InsertControlPoint(BezierInsertPoint),
    /// Show another sheet of the narrow layout.
    ShowSheet(Sheet),
    /// Close a window.
    Close(Window),
    /// Save the document in a format, under a name without extension. `brings_back_all` says whether opening the
    /// file brings back everything.
    Save { format: Format, name: String, brings_back_all: bool },
    /// Make a link to the document.
    MakeLink,
    /// Copy a text to the clipboard, and say so in these words.
    Copy { text: String, said: &'static str },
    /// Cancel a job.
    CancelJob(JobId),
    /// Change the keys of actions, and store the changes.
    ChangeKeys(Vec<KeyChange>),
    /// Show a warning.
    Warn(String),
    /// Show or hide the details of a toast.
    ToggleToast(Slot),
    /// Dismiss a toast.
    DismissToast(Slot),
}

impl Request {
    /// Whether it can be carried out in the middle of a jump in the history: it changes neither the document nor the
    /// selection, or is about the jump itself.
    pub fn goes_before_jump(&self) -> bool {
        match self {
            Self::Act(action) => matches!(
                action,
                Action::Cancel | Action::Palette | Action::GoToId | Action::Save | Action::SaveAs(_)
            ),
            Self::Hover(..)
            | Self::JumpTo(_)
            | Self::ShowSheet(_)
            | Self::Close(_)
            | Self::CloseWelcome
            | Self::WelcomeAtStart(_)
            | Self::ChangeKeys(_)
            | Self::Copy { .. }
            | Self::CancelJob(_)
            | Self::Warn(_)
            | Self::ToggleToast(_)
            | Self::DismissToast(_) => true,
            _ => false,
        }
    }

    /// Whether it names elements, which are others in another state of the history.
    pub fn names_elements(&self) -> bool {
        matches!(
            self,
            Self::Select { .. }
                | Self::PaintSelection { .. }
                | Self::SelectRange { .. }
                | Self::SelectLine { .. }
                | Self::SelectPath { .. }
        )
    }
}

/// A request that waits for the end of a jump in the history.
pub(crate) struct Waiting {
    pub request: Request,
    /// Whether a key made it.
    pub by_key: bool,
}

/// A change of the keys of the chosen preset.
#[derive(Clone, Debug)]
pub(crate) enum KeyChange {
    /// Give an action these keys.
    Set(Action, Vec<Shortcut>),
    /// Give an action the preset's keys again.
    Reset(Action),
    /// Give every action the preset's keys again.
    ResetAll,
}

/// The requests of a frame, in order.
#[derive(Default)]
pub(crate) struct Requests {
    list: Vec<Request>,
}

impl Requests {
    pub fn push(&mut self, request: Request) {
        self.list.push(request);
    }

    pub fn act(&mut self, action: Action) {
        self.push(Request::Act(action));
    }

    pub fn run(&mut self, command: impl Into<Command>) {
        self.push(Request::Run(command.into()));
    }

    pub fn select(&mut self, kind: Element, ids: impl IntoIterator<Item = u32>, mode: SelectMode) {
        self.push(Request::Select { kind, ids: ids.into_iter().collect(), mode });
    }

    pub fn update_edit(&mut self, command: impl Into<Command>) {
        self.push(Request::UpdateEdit(command.into()));
    }

    pub fn take(&mut self) -> Vec<Request> {
        std::mem::take(&mut self.list)
    }
}
