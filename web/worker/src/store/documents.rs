//! Keeping documents in folders of a disk.

use super::disk::{Disk, Failure, FileLength};
use super::message::{Answer, Bytes, Id, Info, Kept, Opened, Request, WhyNot};
use super::sealed::{PART_BYTES, Sealing, named, numbered, read_newest, read_parts, replace};
use editor::recovery::{new_log, read_log};

const CHECKPOINT: &str = "checkpoint";
const LOG: &str = "log";
const INFO: &str = "info";
const PICTURE: &str = "picture";

/// How long a deleted document can be restored.
const RESTORABLE_MS: f64 = 24.0 * 3600.0 * 1000.0;

/// The store.
#[derive(Debug)]
pub struct Documents<D> {
    disk: D,
    /// The document that this tab shows.
    open: Option<Open>,
}

/// The document that this tab shows, whose folder is locked.
#[derive(Debug)]
struct Open {
    id: Id,
    /// The number of the last checkpoint, complete or not.
    number: u64,
    /// The number of the log that records are added to; none before the first checkpoint, and after a failure.
    log: Option<u64>,
    /// The checkpoint that is being written.
    writing: Option<Sealing>,
}

impl<D: Disk> Documents<D> {
    /// A store on this disk.
    pub fn new(disk: D) -> Self {
        Self { disk, open: None }
    }

    /// Carries out a request.
    pub async fn handle(&mut self, request: Request, bytes: &[u8], tell: &mut dyn FnMut(Answer, Bytes)) {
        match request {
            Request::Open { id, copy } => {
                if let Err(why) = self.open(&id, &copy, tell).await {
                    tell(Answer::NotOpened { id, why }, Bytes::new());
                }
            }
            Request::Begin(id) => {
                let begun = self.begin(&id).await;
                self.tell_failure(begun, tell);
                if self.open.is_none() {
                    tell(Answer::Busy(id), Bytes::new());
                }
            }
            Request::Checkpoint { is_first, is_last, log_bytes } => {
                let end = bytes.len().saturating_sub(usize::try_from(log_bytes).unwrap_or(usize::MAX));
                let (part, log) = bytes.split_at(end);
                let written = self.checkpoint(part, log, is_first, is_last).await;
                if written == Ok(true) {
                    tell(Answer::Checked, Bytes::new());
                }
                self.tell_failure(written.map(drop), tell);
            }
            Request::Append => {
                let appended = self.append(bytes).await;
                self.tell_failure(appended, tell);
            }
            Request::Describe(info) => {
                let described = self.replace_of_open(INFO, &info.to_bytes()).await;
                self.tell_failure(described, tell);
            }
            Request::Picture => {
                // A document without a picture is worth as much.
                let _ = self.replace_of_open(PICTURE, bytes).await;
            }
            Request::List => self.list(tell).await,
            Request::Rename { id, name } => {
                let renames = |info: &mut Info| info.renamed = Some(name.clone());
                self.change_info(&id, renames, tell).await;
            }
            Request::Duplicate { id, copy, name } => {
                let renames = |info: &mut Info| info.renamed = Some(name.clone());
                let copied = match self.copy(&id, &copy).await {
                    Ok(()) => self.edit_info(&copy, renames).await,
                    Err(failure) => Err(failure),
                };
                self.tell_failure(copied, tell);
                self.list(tell).await;
            }
            Request::Delete { id, now_ms } => {
                self.change_info(&id, |info| info.deleted_ms = Some(now_ms), tell).await;
            }
            Request::Restore(id) => self.change_info(&id, |info| info.deleted_ms = None, tell).await,
            // What can't be removed now can be later.
            Request::Sweep { now_ms } => drop(self.sweep(now_ms).await),
        }
    }

    /// Tells that something was not written. Nothing more is, because it would follow what is missing.
    fn tell_failure(&mut self, result: Result<(), Failure>, tell: &mut dyn FnMut(Answer, Bytes)) {
        if let Err(failure) = result {
            if let Some(open) = &mut self.open {
                (open.log, open.writing) = (None, None);
            }
            tell(Answer::Failed(failure), Bytes::new());
        }
    }

    async fn open(
        &mut self,
        id: &str,
        copy: &str,
        tell: &mut dyn FnMut(Answer, Bytes),
    ) -> Result<(), WhyNot> {
        self.close().await;
        if self.disk.files(id).await.map_err(WhyNot::Failed)?.is_empty() {
            return Err(WhyNot::Missing);
        }
        let is_copy = !self.disk.lock(id).await;
        let shown = if is_copy { copy } else { id };
        if is_copy {
            self.copy(id, copy).await.map_err(WhyNot::Failed)?;
            self.edit_info(copy, |info| info.is_touched = false).await.map_err(WhyNot::Failed)?;
            self.disk.lock(copy).await;
        }
        match self.read(shown, tell).await {
            Ok((number, log)) => {
                let valid = read_log(&log);
                let is_cut_off = valid.is_cut_off;
                self.mend_log(shown, number, valid.valid_bytes, is_cut_off).await.map_err(WhyNot::Failed)?;
                let info = self.info(shown).await.map_err(WhyNot::Failed)?;
                let id = shown.to_owned();
                self.open = Some(Open { id: id.clone(), number, log: Some(number), writing: None });
                tell(Answer::Opened(Opened { id, info, is_copy, is_cut_off }), log);
                Ok(())
            }
            Err(why) => {
                self.disk.unlock(shown).await;
                Err(why)
            }
        }
    }

    /// Tells the parts of the newest whole checkpoint, and returns its number and log.
    pub(super) async fn read(
        &mut self,
        folder: &str,
        tell: &mut dyn FnMut(Answer, Bytes),
    ) -> Result<(u64, Bytes), WhyNot> {
        let files = self.disk.files(folder).await.map_err(WhyNot::Failed)?;
        let mut newest = None;
        for (number, file) in numbered(&files, CHECKPOINT) {
            let given = read_parts(&mut self.disk, folder, &file, |part| tell(Answer::Part, part)).await;
            if given.map_err(WhyNot::Failed)? {
                newest = Some(number);
                break;
            }
            tell(Answer::Discard, Bytes::new());
        }
        let number = newest.ok_or(WhyNot::Damaged)?;
        let log = files.iter().find(|file| file.name == named(LOG, number));
        let log = match log {
            Some(file) => self.read_all(folder, file).await.map_err(WhyNot::Failed)?,
            None => Bytes::new(),
        };
        Ok((number, log))
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
            self.disk.append(folder, &log, &new_log()).await
        } else if is_cut_off {
            self.disk.truncate(folder, &log, valid_bytes as u64).await
        } else {
            Ok(())
        }
    }

    /// The newest whole checkpoint among these files, and its number.
    async fn newest_whole(
        &mut self,
        folder: &str,
        files: &[FileLength],
    ) -> Result<Option<(u64, FileLength)>, Failure> {
        for (number, file) in numbered(files, CHECKPOINT) {
            if read_parts(&mut self.disk, folder, &file, drop).await? {
                return Ok(Some((number, file)));
            }
        }
        Ok(None)
    }

    async fn read_all(&mut self, folder: &str, file: &FileLength) -> Result<Bytes, Failure> {
        let mut bytes = Bytes::new();
        loop {
            let part = self.disk.read(folder, &file.name, bytes.len() as u64, PART_BYTES).await?;
            let is_last = part.len() < PART_BYTES;
            bytes.extend(part);
            if is_last {
                return Ok(bytes);
            }
        }
    }

    /// Goes on with a document. If another tab shows it, none is open then.
    async fn begin(&mut self, id: &str) -> Result<(), Failure> {
        if self.open.as_ref().is_none_or(|open| open.id != id) {
            self.close().await;
            if !self.disk.lock(id).await {
                return Ok(());
            }
        }
        self.open = Some(Open { id: id.to_owned(), number: 0, log: None, writing: None });
        let files = self.disk.files(id).await?;
        if let (Some(open), Some((number, _))) = (&mut self.open, numbered(&files, CHECKPOINT).first()) {
            open.number = *number;
        }
        Ok(())
    }

    async fn close(&mut self) {
        if let Some(open) = self.open.take() {
            self.disk.unlock(&open.id).await;
        }
    }

    /// Writes more of a checkpoint, and with its last part the log that begins with these records; returns whether it is
    /// complete.
    async fn checkpoint(
        &mut self,
        bytes: &[u8],
        log: &[u8],
        is_first: bool,
        is_last: bool,
    ) -> Result<bool, Failure> {
        let Some(open) = &mut self.open else { return Ok(false) };
        if is_first {
            if open.writing.is_none() {
                open.number += 1;
            }
            // Earlier ones with this number were not completed.
            self.disk.remove(&open.id, &named(CHECKPOINT, open.number)).await?;
            self.disk.remove(&open.id, &named(LOG, open.number)).await?;
            open.writing = Some(Sealing::default());
        }
        let Some(sealing) = &mut open.writing else { return Ok(false) };
        let name = named(CHECKPOINT, open.number);
        sealing.add(bytes);
        self.disk.append(&open.id, &name, bytes).await?;
        if !is_last {
            return Ok(false);
        }
        let seal = sealing.seal();
        self.disk.append(&open.id, &named(LOG, open.number), &[&new_log(), log].concat()).await?;
        // From here on the new checkpoint counts, with its log.
        self.disk.append(&open.id, &name, &seal).await?;
        (open.writing, open.log) = (None, Some(open.number));
        for file in self.disk.files(&open.id).await? {
            let number = |kind| file.name.strip_prefix(kind)?.strip_prefix('-')?.parse::<u64>().ok();
            if number(CHECKPOINT).or_else(|| number(LOG)).is_some_and(|number| number < open.number) {
                self.disk.remove(&open.id, &file.name).await?;
            }
        }
        Ok(true)
    }

    async fn append(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        match &self.open {
            Some(Open { id, log: Some(number), .. }) => {
                self.disk.append(id, &named(LOG, *number), bytes).await
            }
            // The next checkpoint holds it.
            _ => Ok(()),
        }
    }

    async fn replace_of_open(&mut self, kind: &str, bytes: &[u8]) -> Result<(), Failure> {
        match &self.open {
            Some(open) => replace(&mut self.disk, &open.id, kind, bytes).await,
            None => Ok(()),
        }
    }

    pub(super) async fn info(&mut self, id: &str) -> Result<Info, Failure> {
        let bytes = read_newest(&mut self.disk, id, INFO).await?;
        let info = bytes.and_then(|bytes| serde_json::from_slice(&bytes).ok());
        // Without an info, it is listed without a name rather than not at all.
        Ok(info.unwrap_or_else(|| Info { is_touched: true, ..Info::default() }))
    }

    async fn edit_info(&mut self, id: &str, edit: impl Fn(&mut Info)) -> Result<(), Failure> {
        let mut info = self.info(id).await?;
        edit(&mut info);
        replace(&mut self.disk, id, INFO, &info.to_bytes()).await
    }

    /// Changes what is known about a document that no other tab shows, and tells the list.
    async fn change_info(&mut self, id: &str, edit: impl Fn(&mut Info), tell: &mut dyn FnMut(Answer, Bytes)) {
        let is_open = self.open.as_ref().is_some_and(|open| open.id == id) || !self.disk.lock(id).await;
        if is_open {
            tell(Answer::Refused { id: id.to_owned(), is_open }, Bytes::new());
            return;
        }
        let edited = self.edit_info(id, edit).await;
        self.disk.unlock(id).await;
        if edited.is_err() {
            tell(Answer::Refused { id: id.to_owned(), is_open }, Bytes::new());
        }
        self.list(tell).await;
    }

    /// Copies the newest whole state of a document.
    async fn copy(&mut self, id: &str, copy: &str) -> Result<(), Failure> {
        let files = self.disk.files(id).await?;
        let Some((number, checkpoint)) = self.newest_whole(id, &files).await? else {
            return Err(Failure::Missing);
        };
        for kind in [INFO, PICTURE] {
            if let Some(bytes) = read_newest(&mut self.disk, id, kind).await? {
                replace(&mut self.disk, copy, kind, &bytes).await?;
            }
        }
        if let Some(log) = files.iter().find(|file| file.name == named(LOG, number)) {
            let bytes = self.read_all(id, log).await?;
            self.disk.append(copy, &named(LOG, number), &bytes).await?;
        }
        let mut at = 0;
        while at < checkpoint.bytes {
            let part = self.disk.read(id, &checkpoint.name, at, PART_BYTES).await?;
            if part.is_empty() {
                return Err(Failure::Missing);
            }
            at += part.len() as u64;
            self.disk.append(copy, &checkpoint.name, &part).await?;
        }
        Ok(())
    }

    async fn list(&mut self, tell: &mut dyn FnMut(Answer, Bytes)) {
        match self.listed().await {
            Ok(mut documents) => {
                let picture_bytes = documents.iter().map(|kept| kept.picture.len()).collect();
                let pictures =
                    documents.iter_mut().flat_map(|kept| std::mem::take(&mut kept.picture)).collect();
                tell(Answer::Listed { documents, picture_bytes }, pictures);
            }
            Err(failure) => tell(Answer::Failed(failure), Bytes::new()),
        }
    }

    async fn listed(&mut self) -> Result<Vec<Kept>, Failure> {
        let mut documents = Vec::new();
        for id in self.disk.folders().await? {
            let info = self.info(&id).await?;
            let is_ours = self.open.as_ref().is_some_and(|open| open.id == id);
            let has_checkpoint = |files: &[FileLength]| !numbered(files, CHECKPOINT).is_empty();
            let files = self.disk.files(&id).await?;
            if !info.is_touched || info.deleted_ms.is_some() || !has_checkpoint(&files) {
                continue;
            }
            let is_open = is_ours || !self.disk.lock(&id).await;
            if !is_open {
                self.disk.unlock(&id).await;
            }
            let picture = read_newest(&mut self.disk, &id, PICTURE).await?.unwrap_or_default();
            let bytes = files.iter().map(|file| file.bytes).sum();
            documents.push(Kept { id, info, bytes, is_open, picture });
        }
        documents.sort_by(|a, b| b.info.changed_ms.total_cmp(&a.info.changed_ms));
        Ok(documents)
    }

    async fn sweep(&mut self, now_ms: f64) -> Result<(), Failure> {
        for id in self.disk.folders().await? {
            let is_ours = self.open.as_ref().is_some_and(|open| open.id == id);
            if is_ours || !self.disk.lock(&id).await {
                continue;
            }
            let info = self.info(&id).await?;
            let is_gone = info.deleted_ms.is_some_and(|deleted| now_ms - deleted > RESTORABLE_MS);
            if is_gone || !info.is_touched {
                self.disk.remove_folder(&id).await?;
            }
            self.disk.unlock(&id).await;
        }
        Ok(())
    }
}
