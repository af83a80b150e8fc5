//! Keeping documents in folders of a disk: carrying out requests, and writing the document that the tab shows.

use super::disk::{Disk, Failure, FileLength};
use super::listing::RESTORABLE_MS;
use super::message::{Answer, Bytes, Id, Info, MIN_RESTORABLE_MS, Opened, Refusal, Request, WhyNot};
use super::sealed::{Seal, Sealing, named, numbered, seal_of, sealed};
use editor::recovery::{new_log, read_log};

pub(super) const CHECKPOINT: &str = "checkpoint";
pub(super) const LOG: &str = "log";
pub(super) const INFO: &str = "info";
pub(super) const PICTURE: &str = "picture";

/// The store.
#[derive(Debug)]
pub struct Documents<D> {
    pub(super) disk: D,
    /// The document that this tab shows.
    open: Option<Open>,
    /// Another document whose folder this tab has locked to write in it.
    pub(super) changing: Option<Id>,
    /// The latest time that a request named, in milliseconds since 1970.
    pub(super) now_ms: f64,
    /// Why documents may be in a place that can't be read now.
    unreadable: Option<Failure>,
}

/// The document that this tab shows, whose folder is locked.
#[derive(Debug)]
struct Open {
    id: Id,
    /// The number of the log that records are added to; none before the first checkpoint, and after a failure.
    log: Option<u64>,
    /// The checkpoint that is being written, and its number.
    writing: Option<(u64, Sealing)>,
}

impl<D: Disk> Documents<D> {
    /// A store on this disk.
    pub fn new(disk: D) -> Self {
        Self { disk, open: None, changing: None, now_ms: 0.0, unreadable: None }
    }

    /// The same store, for documents that may be in another place, which can't be read now.
    #[must_use]
    pub fn beside_unreadable(self, failure: Option<Failure>) -> Self {
        Self { unreadable: failure, ..self }
    }

    /// Carries out a request.
    pub async fn handle(&mut self, request: Request, bytes: &[u8], tell: &mut dyn FnMut(Answer, Bytes)) {
        match request {
            Request::Open { id, copy } => {
                if let Err(why) = self.open(&id, &copy, tell).await {
                    tell(Answer::NotOpened { opening: copy, why }, Bytes::new());
                }
            }
            Request::Begin(id) => {
                if !self.begin(&id).await {
                    tell(Answer::Busy(id), Bytes::new());
                }
            }
            Request::Checkpoint { id, is_first, is_last, log_bytes, now_ms } => {
                self.pass_time(now_ms);
                let end = bytes.len().saturating_sub(usize::try_from(log_bytes).unwrap_or(usize::MAX));
                let written = self.checkpoint(&id, bytes.split_at(end), is_first, is_last).await;
                if written == Ok(true) {
                    tell(Answer::Checked(id), Bytes::new());
                }
                self.tell_failure(written.map(drop), tell).await;
            }
            Request::Append(id) => {
                let appended = self.append(&id, bytes).await;
                self.tell_failure(appended, tell).await;
            }
            Request::Describe { id, info } => {
                self.pass_time(info.changed_ms);
                let described = self.replace_of_open(&id, INFO, &info.to_bytes()).await;
                self.tell_failure(described, tell).await;
            }
            Request::Picture(id) => {
                // A document without a picture is worth as much.
                let _ = self.replace_of_open(&id, PICTURE, bytes).await;
            }
            Request::List => self.list(tell).await,
            Request::Rename { id, name } => {
                self.change_info(&id, |info| info.renamed = Some(name.clone()), tell).await;
            }
            Request::Duplicate { id, copy, name } => {
                let renames = |info: &mut Info| info.renamed = Some(name.clone());
                match self.copy(&id, &copy, renames).await {
                    Ok(()) => self.disk.unlock(&copy).await,
                    Err(why) => tell(Answer::Refused(Refusal::NotCopied(why)), Bytes::new()),
                }
                self.list(tell).await;
            }
            Request::Delete { id, now_ms } => {
                self.pass_time(now_ms);
                self.change_info(&id, |info| info.deleted_ms = Some(now_ms), tell).await;
            }
            Request::Restore(id) => self.change_info(&id, |info| info.deleted_ms = None, tell).await,
            Request::Sweep { now_ms } => {
                self.pass_time(now_ms);
                self.sweep(now_ms - RESTORABLE_MS).await;
            }
        }
    }

    fn pass_time(&mut self, now_ms: f64) {
        self.now_ms = self.now_ms.max(now_ms);
    }

    /// Whether this tab has locked a folder for more than a look.
    pub(super) fn is_ours(&self, id: &str) -> bool {
        self.shows(id) || self.changing.as_deref() == Some(id)
    }

    /// Whether this tab shows a document.
    pub(super) fn shows(&self, id: &str) -> bool {
        self.open.as_ref().is_some_and(|open| open.id == id)
    }

    /// Tells that something was not written. Nothing more is, because it would follow what is missing. An incomplete
    /// checkpoint is removed: it would take room that the next one needs.
    async fn tell_failure(&mut self, result: Result<(), Failure>, tell: &mut dyn FnMut(Answer, Bytes)) {
        if let Err(failure) = result {
            self.drop_incomplete().await;
            if let Some(open) = &mut self.open {
                open.log = None;
            }
            tell(Answer::Failed(failure), Bytes::new());
        }
    }

    /// Removes the checkpoint that is being written. If that fails, the next complete one removes it.
    async fn drop_incomplete(&mut self) {
        if let Some(open) = &mut self.open
            && let Some((number, _)) = open.writing.take()
        {
            let _ = self.disk.remove(&open.id, &named(CHECKPOINT, number)).await;
            let _ = self.disk.remove(&open.id, &named(LOG, number)).await;
        }
    }

    async fn open(
        &mut self,
        id: &str,
        copy: &str,
        tell: &mut dyn FnMut(Answer, Bytes),
    ) -> Result<(), WhyNot> {
        self.close().await;
        if self.disk.files(id).await?.is_empty() {
            return Err(self.unreadable.clone().map_or(WhyNot::Missing, WhyNot::Failed));
        }
        let is_copy = !self.disk.lock(id).await;
        let shown = if is_copy { copy } else { id };
        if is_copy {
            self.copy(id, copy, |info| info.is_touched = false).await?;
        }
        let opened = self.open_locked(shown, copy, is_copy, tell).await;
        if opened.is_err() {
            self.disk.unlock(shown).await;
        }
        opened
    }

    async fn open_locked(
        &mut self,
        id: &str,
        opening: &str,
        is_copy: bool,
        tell: &mut dyn FnMut(Answer, Bytes),
    ) -> Result<(), WhyNot> {
        let mut told = |part: Option<Bytes>| match part {
            Some(part) => tell(Answer::Part { opening: opening.to_owned() }, part),
            None => tell(Answer::Discard { opening: opening.to_owned() }, Bytes::new()),
        };
        let (number, log) = self.read(id, &mut told).await?;
        let records = read_log(&log);
        if records.is_later {
            return Err(WhyNot::Later);
        }
        let is_cut_off = records.is_cut_off;
        let mended = self.mend_log(id, number, records.valid_bytes, is_cut_off).await;
        let info = self.info(id).await?;
        let log_number = mended.is_ok().then_some(number);
        self.open = Some(Open { id: id.to_owned(), log: log_number, writing: None });
        self.drop_left_behind(id, number).await;
        let opened = Opened { opening: opening.to_owned(), id: id.to_owned(), info, is_copy, is_cut_off };
        tell(Answer::Opened(opened), log);
        // The document is there all the same.
        self.tell_failure(mended, tell).await;
        Ok(())
    }

    /// Removes newer checkpoints that were never completed.
    async fn drop_left_behind(&mut self, id: &str, number: u64) {
        let files = self.disk.files(id).await.unwrap_or_default();
        for (newer, file) in numbered(&files, CHECKPOINT) {
            if newer > number && seal_of(&mut self.disk, id, &file).await == Ok(Seal::None) {
                let _ = self.disk.remove(id, &file.name).await;
                let _ = self.disk.remove(id, &named(LOG, newer)).await;
            }
        }
    }

    /// Makes a log one that records can be added to.
    async fn mend_log(
        &mut self,
        folder: &str,
        number: u64,
        valid_bytes: usize,
        is_cut_off: bool,
    ) -> Result<(), Failure> {
        let log = named(LOG, number);
        if valid_bytes == 0 {
            // The page ended before the log was begun.
            self.disk.remove(folder, &log).await?;
            self.write(folder, &log, &new_log()).await
        } else if is_cut_off {
            self.disk.truncate(folder, &log, valid_bytes as u64).await
        } else {
            Ok(())
        }
    }

    /// Goes on with a document; returns false if another tab shows it, and then none is open.
    async fn begin(&mut self, id: &str) -> bool {
        if self.shows(id) {
            self.drop_incomplete().await;
        } else {
            self.close().await;
            if !self.disk.lock(id).await {
                return false;
            }
        }
        self.open = Some(Open { id: id.to_owned(), log: None, writing: None });
        true
    }

    async fn close(&mut self) {
        self.drop_incomplete().await;
        if let Some(open) = self.open.take() {
            self.disk.unlock(&open.id).await;
        }
    }

    /// Writes more of a checkpoint, and with its last part the log that begins with these records; returns whether it is
    /// complete.
    async fn checkpoint(
        &mut self,
        id: &str,
        (bytes, log): (&[u8], &[u8]),
        is_first: bool,
        is_last: bool,
    ) -> Result<bool, Failure> {
        if !self.shows(id) {
            return Ok(false);
        }
        if is_first {
            self.drop_incomplete().await;
            // Complete or not, what is there stays until this one is complete.
            let number = last_number(&self.disk.files(id).await?) + 1;
            if let Some(open) = &mut self.open {
                open.writing = Some((number, Sealing::default()));
            }
        }
        let Some((number, sealing)) = self.open.as_mut().and_then(|open| open.writing.as_mut()) else {
            return Ok(false);
        };
        let (number, name) = (*number, named(CHECKPOINT, *number));
        sealing.add(bytes);
        let seal = sealing.seal();
        self.write(id, &name, bytes).await?;
        if !is_last {
            return Ok(false);
        }
        self.write(id, &named(LOG, number), &[&new_log(), log].concat()).await?;
        self.write(id, &name, &seal).await?;
        // From here on the new checkpoint counts, with its log.
        if let Some(open) = &mut self.open {
            (open.writing, open.log) = (None, Some(number));
        }
        self.remove_older(id, number).await;
        Ok(true)
    }

    /// Removes older checkpoints and logs. What can't be removed now can be after the next checkpoint.
    async fn remove_older(&mut self, id: &str, number: u64) {
        let files = self.disk.files(id).await.unwrap_or_default();
        for (older, file) in numbered(&files, CHECKPOINT).into_iter().chain(numbered(&files, LOG)) {
            if older < number {
                let _ = self.disk.remove(id, &file.name).await;
            }
        }
    }

    async fn append(&mut self, id: &str, bytes: &[u8]) -> Result<(), Failure> {
        match self.open.as_ref().filter(|open| open.id == id).and_then(|open| open.log) {
            Some(number) => self.write(id, &named(LOG, number), bytes).await,
            // The next checkpoint holds it.
            None => Ok(()),
        }
    }

    async fn replace_of_open(&mut self, id: &str, kind: &str, bytes: &[u8]) -> Result<(), Failure> {
        if self.shows(id) { self.replace(id, kind, bytes).await } else { Ok(()) }
    }

    /// Writes a sealed file of a kind, and then removes older ones.
    pub(super) async fn replace(&mut self, id: &str, kind: &str, bytes: &[u8]) -> Result<(), Failure> {
        let old = numbered(&self.disk.files(id).await?, kind);
        let number = old.first().map_or(0, |(number, _)| *number) + 1;
        let name = named(kind, number);
        let written = self.write(id, &name, &sealed(bytes)).await;
        let removed = if written.is_ok() { old } else { Vec::new() };
        for (_, file) in removed {
            // What can't be removed now can be when the next one is written.
            let _ = self.disk.remove(id, &file.name).await;
        }
        written
    }

    /// Adds bytes to a file. If there is no room, deleted documents make some.
    pub(super) async fn write(&mut self, id: &str, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let written = self.disk.append(id, file, bytes).await;
        if written == Err(Failure::Full) && self.sweep(self.now_ms - MIN_RESTORABLE_MS).await {
            return self.disk.append(id, file, bytes).await;
        }
        written
    }
}

/// The highest number of a checkpoint or a log.
fn last_number(files: &[FileLength]) -> u64 {
    let last = |kind| numbered(files, kind).first().map_or(0, |(number, _)| *number);
    last(CHECKPOINT).max(last(LOG))
}
