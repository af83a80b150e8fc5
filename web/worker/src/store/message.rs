//! What the page asks the store to do, and the answers.

use super::disk::Failure;
use serde::{Deserialize, Serialize};
#[cfg(target_arch = "wasm32")]
use {
    js_sys::{Array, Uint8Array},
    serde::de::DeserializeOwned,
    wasm_bindgen::{JsCast, JsValue},
};

/// A kept document's identity: letters and digits.
pub type Id = String;

/// The bytes that travel beside a request or an answer.
pub type Bytes = Vec<u8>;

/// What the list of documents says about one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Info {
    /// Its name.
    pub name: String,
    /// The name that it was given in the list since it was last open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub renamed: Option<String>,
    /// The numbers of objects, vertices and faces.
    pub sizes: [u64; 3],
    /// When it last changed, in milliseconds since 1970.
    pub changed_ms: f64,
    /// Whether something was done in it. Others are not listed, and removed once they are closed.
    pub is_touched: bool,
    /// When it was deleted, in milliseconds since 1970. It can be restored for a while.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deleted_ms: Option<f64>,
}

impl Info {
    /// As JSON.
    pub(super) fn to_bytes(&self) -> Bytes {
        // These fields can't fail to be written.
        serde_json::to_vec(self).unwrap_or_default()
    }

    /// The name to show.
    pub fn shown_name(&self) -> &str {
        self.renamed.as_ref().unwrap_or(&self.name)
    }
}

/// A document in the list.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Kept {
    /// Its identity.
    pub id: Id,
    /// What is known about it.
    pub info: Info,
    /// The room that it takes, in bytes.
    pub bytes: u64,
    /// Whether it is open, in this tab or another one.
    pub is_open: bool,
    /// A picture of it, as the page writes them; empty if there is none.
    #[serde(skip)]
    pub picture: Bytes,
}

/// A request of the page. Requests are carried out in order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Reads a document and goes on with it. Answered by [`Answer::Part`]s and [`Answer::Opened`], or by
    /// [`Answer::NotOpened`]. If another tab shows it, a copy is made and opened.
    Open {
        /// The document.
        id: Id,
        /// What the copy is called: a new identity for each request, by which its answers are told from those of others.
        copy: Id,
    },
    /// Goes on with a document that is new or was open before. Its next checkpoint has to follow. Answered by
    /// [`Answer::Busy`] if another tab shows it.
    Begin(Id),
    /// The next bytes of a checkpoint are beside this. Answered by [`Answer::Checked`] after the last. This and the next
    /// three do nothing for another document than the open one.
    Checkpoint {
        /// The document.
        id: Id,
        /// Whether the checkpoint begins here. An earlier one that was not completed is forgotten.
        is_first: bool,
        /// Whether it is complete.
        is_last: bool,
        /// How many of the bytes, at the end, are the first records of the log that continues it: of a complete one only.
        log_bytes: u64,
        /// The time, in milliseconds since 1970.
        now_ms: f64,
    },
    /// The next records of the document's log are beside this.
    Append(Id),
    /// Replaces what is known about the document.
    Describe {
        /// The document.
        id: Id,
        /// What is known.
        info: Info,
    },
    /// Replaces the document's picture by that beside this.
    Picture(Id),
    /// Asks for the list of documents: [`Answer::Listed`].
    List,
    /// Gives a document another name.
    Rename {
        /// The document.
        id: Id,
        /// Its new name.
        name: String,
    },
    /// Makes a copy of a document.
    Duplicate {
        /// The document.
        id: Id,
        /// What the copy is called.
        copy: Id,
        /// The copy's name.
        name: String,
    },
    /// Deletes a document that is not open. It can be restored for a day, but where there is no more room only for
    /// [`MIN_RESTORABLE_MS`].
    Delete {
        /// The document.
        id: Id,
        /// The time, in milliseconds since 1970.
        now_ms: f64,
    },
    /// Brings back a deleted document.
    Restore(Id),
    /// Removes documents that nothing was done in, those that were deleted a day ago, and what was left incomplete then.
    Sweep {
        /// The time, in milliseconds since 1970.
        now_ms: f64,
    },
}

/// How long a deleted document can be restored even if its room is needed.
pub const MIN_RESTORABLE_MS: f64 = 20.0 * 1000.0;

/// A document that was opened.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Opened {
    /// What the copy was to be called in [`Request::Open`].
    pub opening: Id,
    /// The document; the copy, if one was made.
    pub id: Id,
    /// What is known about it.
    pub info: Info,
    /// Whether another tab shows the document, and this is a copy.
    pub is_copy: bool,
    /// Whether the end of the log was damaged and cut off.
    pub is_cut_off: bool,
}

/// Why a document could not be opened.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum WhyNot {
    /// It is not there: the browser or the user has removed it.
    Missing,
    /// None of its checkpoints is whole.
    Damaged,
    /// A later version of this program wrote it. It is left as it is.
    Later,
    /// It could not be read.
    Failed(Failure),
}

impl From<Failure> for WhyNot {
    fn from(failure: Failure) -> Self {
        Self::Failed(failure)
    }
}

/// Why something that the list asked for was not done.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Refusal {
    /// Another tab shows the document.
    IsOpen,
    /// It could not be changed.
    NotChanged(Failure),
    /// It could not be copied.
    NotCopied(WhyNot),
    /// The list could not be read.
    NotListed(Failure),
}

/// An answer of the store.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Answer {
    /// The store is listening; requests that were sent earlier are lost.
    Ready,
    /// The next bytes of the checkpoint of the document that is being opened are beside this.
    Part {
        /// What the copy was to be called in [`Request::Open`].
        opening: Id,
    },
    /// What was sent of the checkpoint is damaged. The parts of an older one follow, if there is one.
    Discard {
        /// What the copy was to be called in [`Request::Open`].
        opening: Id,
    },
    /// A document is open. Its log is beside this.
    Opened(Opened),
    /// A document could not be opened.
    NotOpened {
        /// What the copy was to be called in [`Request::Open`].
        opening: Id,
        /// Why.
        why: WhyNot,
    },
    /// Another tab shows the document that was to be begun.
    Busy(Id),
    /// The last checkpoint of this document is complete.
    Checked(Id),
    /// Something could not be written. Nothing is kept until the next checkpoint begins.
    Failed(Failure),
    /// The list of documents, the last changed first. Their pictures are beside this, with these lengths.
    Listed {
        /// The documents.
        documents: Vec<Kept>,
        /// The lengths of their pictures in bytes.
        picture_bytes: Vec<usize>,
    },
    /// Something asked for in the list could not be done.
    Refused(Refusal),
    /// The store's program ended with this message.
    Crashed(String),
}

/// A request or an answer as a JavaScript value, and the list of objects to transfer with it.
#[cfg(target_arch = "wasm32")]
pub fn to_js(head: &impl Serialize, bytes: &[u8]) -> (JsValue, JsValue) {
    // These types can't fail to be written as JSON.
    let head = serde_json::to_string(head).unwrap_or_default();
    let array = Uint8Array::from(bytes);
    let transfer = Array::of1(&array.buffer());
    (Array::of2(&head.into(), &array).into(), transfer.into())
}

/// Reads what [`to_js`] wrote; none for anything else.
#[cfg(target_arch = "wasm32")]
pub fn from_js<T: DeserializeOwned>(value: &JsValue) -> Option<(T, Bytes)> {
    let parts: &Array = value.dyn_ref()?;
    let head = serde_json::from_str(&parts.get(0).as_string()?).ok()?;
    let bytes: Uint8Array = parts.get(1).dyn_into().ok()?;
    Some((head, bytes.to_vec()))
}
