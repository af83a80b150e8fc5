//! A kept document as a project file, for when the page's program has crashed and can't save it.

use super::disk::Disk;
use super::documents::Documents;
use super::message::{Bytes, WhyNot};
use editor::Wire;
use editor::formats::NamedBytes;
use editor::project::Project;
use editor::recovery::{Event, Snapshot, read_log};
use std::fmt;

const LATER: &str = "A later version of Meshwright wrote the document.";

impl<D: Disk> Documents<D> {
    /// A document as a project file, whoever shows it. Without the log, it is the document as it was at its last checkpoint.
    ///
    /// # Errors
    /// A sentence that says why there is none.
    pub async fn rescue(&mut self, id: &str, repeats_log: bool) -> Result<NamedBytes, String> {
        let mut checkpoint = Bytes::new();
        let mut take = |part| match part {
            Some(part) => checkpoint.extend::<Bytes>(part),
            None => checkpoint.clear(),
        };
        let read = self.read(id, &mut take).await.map_err(|why| match why {
            WhyNot::Missing | WhyNot::Damaged => "This browser has no whole copy of the document.".to_owned(),
            WhyNot::Later => LATER.to_owned(),
            WhyNot::Failed(failure) => unreadable(&failure),
        });
        let (_, log) = read?;
        if repeats_log && read_log(&log).is_later {
            return Err(LATER.to_owned());
        }
        let info = self.info(id).await.unwrap_or_default();
        let log = repeats_log.then_some(log.as_slice());
        project_of(&checkpoint, log.unwrap_or_default(), info.renamed.as_deref())
    }
}

/// The project that a checkpoint and a log make. What can't be repeated of the log is left out.
fn project_of(checkpoint: &[u8], log: &[u8], name: Option<&str>) -> Result<NamedBytes, String> {
    let snapshot = Snapshot::from_bytes(checkpoint).map_err(unreadable)?;
    let mut editor = snapshot.into_editor();
    for entry in read_log(log).entries {
        if let Event::View(view) = &entry.event {
            editor.log_view(view.clone());
        }
        if editor.replay(entry).is_err() {
            break;
        }
    }
    editor.end_replay();
    if let Some(name) = name {
        editor.rename_document(name);
    }
    Ok(Project::of(&editor).file())
}

/// Says why the document can't be read.
pub(super) fn unreadable(why: impl fmt::Display) -> String {
    format!("The copy in this browser can't be read: {why}.")
}
