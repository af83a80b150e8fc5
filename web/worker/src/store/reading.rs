//! Reading and copying kept documents.

use super::disk::{Disk, Failure, FileLength};
use super::documents::{CHECKPOINT, Documents, INFO, LOG, PICTURE};
use super::message::{Bytes, Info, WhyNot};
use super::sealed::{MAX_TRIES, PART_BYTES, Seal, named, numbered, read_newest, read_parts, seal_of};
use editor::recovery::{is_of_later_version, read_log};

impl<D: Disk> Documents<D> {
    /// Tells the parts of the newest whole checkpoint, and returns its number and log. None means that the parts so far are
    /// worthless.
    pub(super) async fn read(
        &mut self,
        folder: &str,
        tell: &mut dyn FnMut(Option<Bytes>),
    ) -> Result<(u64, Bytes), WhyNot> {
        let files = self.disk.files(folder).await?;
        let (number, _) = self.newest_whole(folder, &files, tell).await?;
        Ok((number, self.log(folder, &files, number).await?))
    }

    /// Tells the parts of the newest whole checkpoint among these files, and returns its number and file.
    async fn newest_whole(
        &mut self,
        folder: &str,
        files: &[FileLength],
        tell: &mut dyn FnMut(Option<Bytes>),
    ) -> Result<(u64, FileLength), WhyNot> {
        for (number, file) in numbered(files, CHECKPOINT) {
            match seal_of(&mut self.disk, folder, &file).await? {
                Seal::Ours => {}
                Seal::Later => return Err(WhyNot::Later),
                Seal::None => continue,
            }
            let mut is_later = None;
            let give = |part: Bytes| {
                is_later.get_or_insert_with(|| is_of_later_version(&part));
                tell(Some(part));
            };
            if read_parts(&mut self.disk, folder, &file, give).await? {
                return if is_later == Some(true) { Err(WhyNot::Later) } else { Ok((number, file)) };
            }
            tell(None);
        }
        Err(WhyNot::Damaged)
    }

    /// The log that follows a checkpoint; empty if there is none.
    async fn log(&mut self, folder: &str, files: &[FileLength], number: u64) -> Result<Bytes, Failure> {
        let mut bytes = Bytes::new();
        let Some(file) = files.iter().find(|file| file.name == named(LOG, number)) else {
            return Ok(bytes);
        };
        loop {
            let part = self.disk.read(folder, &file.name, bytes.len() as u64, PART_BYTES).await?;
            let is_last = part.len() < PART_BYTES;
            bytes.extend(part);
            if is_last {
                return Ok(bytes);
            }
        }
    }

    pub(super) async fn info(&mut self, id: &str) -> Result<Info, Failure> {
        let bytes = read_newest(&mut self.disk, id, INFO).await?;
        let info = bytes.and_then(|bytes| serde_json::from_slice(&bytes).ok());
        // Without an info, it is listed without a name rather than not at all.
        Ok(info.unwrap_or_else(|| Info { is_touched: true, ..Info::default() }))
    }

    /// Copies the newest whole state of a document into a folder that stays locked, so that no other tab takes it for one
    /// that was left behind. If that fails, nothing stays of it.
    pub(super) async fn copy(
        &mut self,
        id: &str,
        copy: &str,
        edit: impl Fn(&mut Info),
    ) -> Result<(), WhyNot> {
        self.disk.lock(copy).await;
        self.changing = Some(copy.to_owned());
        let mut copied = self.try_copy(id, copy, &edit).await;
        for _ in 1..MAX_TRIES {
            // Another tab may have replaced what was being read.
            if !matches!(copied, Err(WhyNot::Failed(Failure::Missing | Failure::Other(_)))) {
                break;
            }
            let _ = self.disk.remove_folder(copy).await;
            copied = self.try_copy(id, copy, &edit).await;
        }
        if copied.is_err() {
            let _ = self.disk.remove_folder(copy).await;
            self.disk.unlock(copy).await;
        }
        self.changing = None;
        copied
    }

    async fn try_copy(&mut self, id: &str, copy: &str, edit: &impl Fn(&mut Info)) -> Result<(), WhyNot> {
        let files = self.disk.files(id).await?;
        if files.is_empty() {
            return Err(WhyNot::Missing);
        }
        let (number, checkpoint) = self.newest_whole(id, &files, &mut drop).await?;
        let mut log = self.log(id, &files, number).await?;
        let records = read_log(&log);
        if records.is_later {
            return Err(WhyNot::Later);
        }
        // The tab that shows the document may just be writing a record.
        log.truncate(records.valid_bytes);
        let mut info = self.info(id).await?;
        edit(&mut info);
        self.replace(copy, INFO, &info.to_bytes()).await?;
        if let Some(picture) = read_newest(&mut self.disk, id, PICTURE).await? {
            self.replace(copy, PICTURE, &picture).await?;
        }
        self.write(copy, &named(LOG, number), &log).await?;
        let mut at = 0;
        while at < checkpoint.bytes {
            let part = self.disk.read(id, &checkpoint.name, at, PART_BYTES).await?;
            if part.is_empty() {
                return Err(WhyNot::Failed(Failure::Missing));
            }
            at += part.len() as u64;
            self.write(copy, &checkpoint.name, &part).await?;
        }
        Ok(())
    }
}
