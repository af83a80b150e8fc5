//! What the list of documents shows and does, and removing what is no longer needed.

use super::disk::{Disk, Failure, FileLength};
use super::documents::{CHECKPOINT, Documents, INFO, PICTURE};
use super::message::{Answer, Bytes, Info, Kept, Refusal};
use super::sealed::{Seal, numbered, read_newest, seal_of};

/// How long a deleted document can be restored, and how long a document stays that no checkpoint was completed of.
pub(super) const RESTORABLE_MS: f64 = 24.0 * 3600.0 * 1000.0;

impl<D: Disk> Documents<D> {
    pub(super) async fn list(&mut self, tell: &mut dyn FnMut(Answer, Bytes)) {
        match self.listed().await {
            Ok(mut documents) => {
                let picture_bytes = documents.iter().map(|kept| kept.picture.len()).collect();
                let pictures =
                    documents.iter_mut().flat_map(|kept| std::mem::take(&mut kept.picture)).collect();
                tell(Answer::Listed { documents, picture_bytes }, pictures);
            }
            Err(failure) => tell(Answer::Refused(Refusal::NotListed(failure)), Bytes::new()),
        }
    }

    async fn listed(&mut self) -> Result<Vec<Kept>, Failure> {
        let mut documents = Vec::new();
        for id in self.disk.folders().await? {
            match self.kept(&id).await {
                Ok(kept) => documents.extend(kept),
                // Another tab has just removed it.
                Err(Failure::Missing) => {}
                Err(failure) => return Err(failure),
            }
        }
        documents.sort_by(|a, b| b.info.changed_ms.total_cmp(&a.info.changed_ms));
        Ok(documents)
    }

    /// What the list shows of a document; none if it doesn't show it.
    async fn kept(&mut self, id: &str) -> Result<Option<Kept>, Failure> {
        let info = self.info(id).await?;
        let files = self.disk.files(id).await?;
        if !info.is_touched || info.deleted_ms.is_some() || !self.has_complete(id, &files).await? {
            return Ok(None);
        }
        let is_open = self.is_ours(id) || !self.disk.lock(id).await;
        if !is_open {
            self.disk.unlock(id).await;
        }
        let picture = read_newest(&mut self.disk, id, PICTURE).await?.unwrap_or_default();
        let bytes = files.iter().map(|file| file.bytes).sum();
        Ok(Some(Kept { id: id.to_owned(), info, bytes, is_open, picture }))
    }

    /// Whether a checkpoint is complete, so that there is something to open.
    async fn has_complete(&mut self, id: &str, files: &[FileLength]) -> Result<bool, Failure> {
        for (_, file) in numbered(files, CHECKPOINT) {
            if seal_of(&mut self.disk, id, &file).await? != Seal::None {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Changes what is known about a document that no tab shows, and tells the list.
    pub(super) async fn change_info(
        &mut self,
        id: &str,
        edit: impl Fn(&mut Info),
        tell: &mut dyn FnMut(Answer, Bytes),
    ) {
        if self.shows(id) || !self.disk.lock(id).await {
            tell(Answer::Refused(Refusal::IsOpen), Bytes::new());
            return;
        }
        self.changing = Some(id.to_owned());
        let edited = self.edit_info(id, edit).await;
        self.changing = None;
        self.disk.unlock(id).await;
        if let Err(failure) = edited {
            tell(Answer::Refused(Refusal::NotChanged(failure)), Bytes::new());
        }
        self.list(tell).await;
    }

    async fn edit_info(&mut self, id: &str, edit: impl Fn(&mut Info)) -> Result<(), Failure> {
        if self.disk.files(id).await?.is_empty() {
            return Err(Failure::Missing);
        }
        let mut info = self.info(id).await?;
        edit(&mut info);
        let written = self.replace(id, INFO, &info.to_bytes()).await;
        if written != Err(Failure::Full) {
            return written;
        }
        // Deleting has to work where there is no room at all. The picture is drawn again when the document is next open.
        for (_, file) in numbered(&self.disk.files(id).await?, PICTURE) {
            self.disk.remove(id, &file.name).await?;
        }
        self.replace(id, INFO, &info.to_bytes()).await
    }

    /// Removes documents that nothing was done in, those that were deleted before a time, and what was left incomplete for
    /// a day. Returns whether that made room. What can't be removed now can be later.
    pub(super) async fn sweep(&mut self, deleted_before_ms: f64) -> bool {
        let mut has_removed = false;
        for id in self.disk.folders().await.unwrap_or_default() {
            if self.is_ours(&id) || !self.disk.lock(&id).await {
                continue;
            }
            if self.is_needless(&id, deleted_before_ms).await == Ok(true) {
                has_removed |= self.disk.remove_folder(&id).await.is_ok();
            }
            self.disk.unlock(&id).await;
        }
        has_removed
    }

    async fn is_needless(&mut self, id: &str, deleted_before_ms: f64) -> Result<bool, Failure> {
        let info = self.info(id).await?;
        if let Some(deleted_ms) = info.deleted_ms {
            return Ok(deleted_ms < deleted_before_ms);
        }
        if !self.disk.has_locks() {
            // Another tab may show it.
            return Ok(false);
        }
        let is_old = info.changed_ms < self.now_ms - RESTORABLE_MS;
        let files = self.disk.files(id).await?;
        Ok(!info.is_touched || (is_old && !self.has_complete(id, &files).await?))
    }
}
