//! Why a command was refused.

use crate::Task;
use crate::ops::Field;
use halfedge::Refusal;
use halfedge::words::sentence;
use serde::Serialize;
use std::fmt;
use surface::SurfaceError;

/// That something could not be opened, and why, in sentences.
pub(crate) fn not_opened(name: &str, why: &str) -> String {
    format!("Could not open {name}. {}", sentence(why))
}

const NOT_SAVED: &str = "Could not save the document.";

/// A command that was not carried out. The document is unchanged.
///
/// Displays as one line: the operation (or that a file could not be opened or saved), the invalid field if
/// there is one, and the problem.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CommandError {
    /// The operation, or what was attempted, such as `open`.
    pub op: String,
    /// The invalid field, with the place in it: `position[1]`.
    pub field: Option<String>,
    /// What is wrong and what to do, in plain words.
    pub problem: String,
    /// The kind of failure.
    pub kind: ErrorKind,
    /// Whether the field is the subject of the problem: "is missing", "has no length".
    #[serde(skip)]
    pub is_of_field: bool,
    /// A sentence that replaces the field and the problem in the interface.
    #[serde(skip)]
    pub advice: Option<String>,
}

/// The kinds of failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ErrorKind {
    /// The command makes no sense or can't be carried out here.
    Refused,
    /// The user cancelled it.
    Cancelled,
    /// The command can run, but would change nothing.
    NothingToDo,
    /// A fault of the editor itself: a result broke a rule of the mesh and was discarded.
    Internal,
}

impl CommandError {
    /// A refusal of an operation, with no invalid field.
    pub fn refused(op: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::of(op, Problem::new(problem))
    }

    pub(crate) fn of(op: impl Into<String>, problem: Problem) -> Self {
        let Problem { field, text, is_of_field, kind, advice } = problem;
        Self { op: op.into(), field, problem: text, kind, is_of_field, advice }
    }

    /// Why the command can't be carried out, as a sentence for a tooltip: "Select an edge first." Fields have
    /// their labels in forms.
    pub fn reason(&self) -> String {
        match (&self.advice, self.labels()) {
            (Some(advice), _) => advice.clone(),
            (None, Some((_, Some(field)))) => sentence(&self.about(&field)),
            (None, _) => sentence(&self.problem),
        }
    }

    /// What a person reads in a message: the reason, with the operation where the reason does not stand alone.
    pub fn message(&self) -> String {
        match (&self.advice, self.labels()) {
            (None, Some((op, Some(field)))) => {
                let separator = if self.is_of_field { ":" } else { "," };
                sentence(&format!("{op}{separator} {}", self.about(&field.to_lowercase())))
            }
            (None, Some((op, None))) => sentence(&format!("{op}: {}", self.problem)),
            (None, None) if self.task() == Some(Task::Export) => {
                format!("{NOT_SAVED} {}", sentence(&self.problem))
            }
            _ => self.reason(),
        }
    }

    /// A field and its problem: "Direction has no length", "Edges: there is no edge 7".
    fn about(&self, field: &str) -> String {
        let colon = if self.is_of_field { "" } else { ":" };
        format!("{field}{colon} {}", self.problem)
    }

    /// What was attempted; none if there is no such task, or the error is of something else.
    fn task(&self) -> Option<Task> {
        Task::named(&self.op)
    }

    /// The labels of the operation and of its invalid field. A problem with elements names them itself, so that
    /// the field's label would only repeat their kind.
    fn labels(&self) -> Option<(&'static str, Option<String>)> {
        let Task::Op(id) = self.task()? else { return None };
        let spec = id.spec();
        let name = self.field.as_deref().and_then(|field| field.split('[').next());
        let field = name.and_then(|name| spec.field(name)).filter(|field| !field.is_target());
        Some((spec.label, field.map(Field::label)))
    }

    /// Whether the user cancelled the command, so that there is nothing to report.
    pub fn is_cancelled(&self) -> bool {
        self.kind == ErrorKind::Cancelled
    }
}

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let op = &self.op;
        match (self.task(), &self.field) {
            // The problem says which file could not be opened.
            (Some(Task::Open), _) => f.write_str(&self.problem),
            (Some(Task::Export), _) => write!(f, "{NOT_SAVED} {}", sentence(&self.problem)),
            (_, Some(field)) => write!(f, "{op}: {}", self.about(&format!("`{field}`"))),
            (_, None) => write!(f, "{op}: {}", self.problem),
        }
    }
}

impl std::error::Error for CommandError {}

/// A problem before the operation's name is added.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    pub field: Option<String>,
    pub text: String,
    /// Whether the field is the subject of the text.
    pub is_of_field: bool,
    pub kind: ErrorKind,
    /// A sentence that replaces the field and the text in the interface.
    pub advice: Option<String>,
}

impl Problem {
    pub fn new(text: impl Into<String>) -> Self {
        Self { field: None, text: text.into(), is_of_field: false, kind: ErrorKind::Refused, advice: None }
    }

    /// A problem of a field, as a clause with a subject of its own: "there is no edge 7".
    pub fn field(field: impl Into<String>, clause: impl Into<String>) -> Self {
        Self { field: Some(field.into()), ..Self::new(clause) }
    }

    /// A problem that has the field as its subject: "is missing".
    pub fn of_field(field: impl Into<String>, predicate: impl Into<String>) -> Self {
        Self { is_of_field: true, ..Self::field(field, predicate) }
    }

    /// Adds a sentence for the interface.
    pub fn advise(self, advice: impl Into<String>) -> Self {
        Self { advice: Some(advice.into()), ..self }
    }

    pub fn nothing_to_do(sentence: &str) -> Self {
        Self { kind: ErrorKind::NothingToDo, ..Self::new(sentence).advise(sentence) }
    }

    pub fn cancelled() -> Self {
        Self { kind: ErrorKind::Cancelled, ..Self::new("cancelled") }
    }

    pub fn internal(text: impl Into<String>) -> Self {
        Self { kind: ErrorKind::Internal, ..Self::new(text) }
    }
}

impl From<Refusal> for Problem {
    fn from(refusal: Refusal) -> Self {
        match refusal {
            Refusal::OutOfRange { field, value, range } => {
                Self::field(field, format!("{value} is out of range; it must be {range}"))
            }
            other => Self::new(other.to_string()),
        }
    }
}

impl From<SurfaceError> for Problem {
    fn from(error: SurfaceError) -> Self {
        match error {
            SurfaceError::Cancelled => Self::cancelled(),
            SurfaceError::BadField { field, must_be } => Self::of_field(field, format!("must be {must_be}")),
            SurfaceError::TooManyFaces { .. }
            | SurfaceError::NotTriangles { .. }
            | SurfaceError::MeetTwice { .. } => Self::new(error.to_string()),
        }
    }
}
