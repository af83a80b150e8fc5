//! What the editor was asked to do.

use crate::OpId;
use serde::{Serialize, Serializer};
use std::fmt;

/// What the editor was asked to do: an operation, or work that is not a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Run an operation.
    Op(OpId),
    /// Open files.
    Open,
    /// Write the document as files.
    Export,
    /// Make a link to the document.
    Share,
    /// Decode an image of a material.
    Decode,
    /// Add images to the materials that name them.
    AddImages,
}

impl Task {
    /// The tasks that are not operations.
    const OTHERS: [Self; 5] = [Self::Open, Self::Export, Self::Share, Self::Decode, Self::AddImages];

    /// The name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Op(id) => id.spec().name,
            Self::Open => "open",
            Self::Export => "export",
            Self::Share => "share",
            Self::Decode => "decode",
            Self::AddImages => "add-images",
        }
    }

    /// The task of this name in JSON.
    pub fn named(name: &str) -> Option<Self> {
        OpId::named(name).map(Self::Op).or_else(|| Self::OTHERS.into_iter().find(|task| task.name() == name))
    }

    /// What messages call it.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Op(id) => id.spec().label,
            Self::Open | Self::Export | Self::Share | Self::Decode | Self::AddImages => self.name(),
        }
    }
}

impl fmt::Display for Task {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl From<Task> for String {
    fn from(task: Task) -> Self {
        task.name().to_owned()
    }
}

impl Serialize for Task {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back_to_tasks() {
        let all = OpId::ALL.iter().map(|id| Task::Op(*id)).chain(Task::OTHERS);
        for task in all {
            assert_eq!(Task::named(task.name()), Some(task));
        }
        assert_eq!(Task::named("fly"), None);
    }
}
