//! What the user is told about the documents that are kept, by a browser or on a desktop.

use meshwright_worker::store::{Failure, Refusal, WhyNot};

/// Said when writing works again after a failure.
pub(super) const KEPT_AGAIN: &str = "Changes are kept again.";

/// Said when the store's worker ended and another one goes on.
pub(super) const STORE_CRASHED: &str =
    "The worker that keeps documents ended and was started again. Nothing was lost.";

/// What to do about a document of a later version.
const GET_LATER: &str = "It is unchanged. Reload the page, or update the program, to get that version.";

/// Said when a document is open twice.
pub(super) const IS_COPY: &str = "This document is open in another tab or window, so this one shows a copy of it. \
                                  Changes here don't reach the other one.";

/// Said when a document of the list can't take the place of one that is being changed.
pub(super) const NOT_OPENED_NOW: &str = "The document was not opened because you changed this one in the meantime. \
                                         Open it again from File > Recent documents.";

/// Said when the document before the last one is opened.
pub(super) const NOT_ON_DISK: &str =
    "The last document was not completely written before Meshwright ended, so this is the one before it.";

/// Said after a document was deleted from the list.
pub(super) fn deleted(name: &str) -> String {
    format!("Deleted {name}.")
}

/// Said when something that the list asked for was not done.
pub(super) fn refused(refusal: &Refusal) -> String {
    match refusal {
        Refusal::IsOpen => "Another tab or window shows this document. Close it there first.".to_owned(),
        Refusal::NotChanged(failure) => format!("The document was not changed: {failure}."),
        Refusal::NotCopied(why) => format!("The document was not duplicated: {}.", reason(why)),
        Refusal::NotListed(failure) => format!("The list of documents can't be read: {failure}."),
    }
}

fn reason(why: &WhyNot) -> String {
    match why {
        WhyNot::Missing => Failure::Missing.to_string(),
        WhyNot::Damaged => "its copy on the disk is damaged or incomplete".to_owned(),
        WhyNot::Later => "a later version of Meshwright wrote it".to_owned(),
        WhyNot::Failed(failure) => failure.to_string(),
    }
}

/// Why a document can't be opened.
pub(super) fn not_opened(why: &WhyNot) -> String {
    match why {
        WhyNot::Missing => {
            "The last document is gone: what was kept of it has been removed from the storage. Save documents \
             to files to keep them safe."
                .to_owned()
        }
        WhyNot::Later => format!("{} {GET_LATER}", unreadable(&reason(why))),
        _ => unreadable(&reason(why)),
    }
}

/// Why a document can't be read.
pub(super) fn unreadable(why: &str) -> String {
    format!("The last document can't be opened: {why}.")
}

/// Why changes are not kept, and what to do.
pub(super) fn not_kept(failure: &Failure) -> String {
    let advice = match failure {
        Failure::Full => "Delete documents that you no longer need, or save this one to a file.",
        _ => "Save the document to a file before you close Meshwright.",
    };
    format!("Changes are not kept: {failure}. {advice}")
}

/// Said when the last changes were not completely written.
pub(super) fn not_written(missing: usize) -> String {
    let (changes, were, they_are) = match missing {
        1 => ("change".to_owned(), "was", "it is"),
        _ => (format!("{missing} changes"), "were", "they are"),
    };
    format!(
        "The last {changes} {were} not completely written before Meshwright ended, so {they_are} missing."
    )
}

/// The end of a recovery that could not repeat everything.
pub(super) fn not_repeated(why: &str, missing: usize) -> String {
    let changes = if missing == 1 { "change".to_owned() } else { format!("{missing} changes") };
    format!(
        "The last {changes} could not be repeated: {why}. This is a copy without them. The original stays in File > \
         Recent documents."
    )
}
