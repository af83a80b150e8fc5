//! Files that end with a seal, their length and a checksum: one without is not complete.

use super::disk::{Disk, Failure, FileLength};

/// The mark that a seal starts with, with the version of the format.
const MARK: [u8; 8] = *b"MWseal\0\x01";

/// The mark, the length as `u64` and the CRC-32 as `u32`, little-endian.
pub(super) const SEAL_BYTES: usize = 20;

/// How much is read at once.
pub(super) const PART_BYTES: usize = 4 << 20;

/// The seal of the bytes that were written so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Sealing {
    bytes: u64,
    checksum: crc32fast::Hasher,
}

/// What a file ends with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Seal {
    /// Nothing that this version knows: the file is not complete.
    None,
    /// A seal for a file of this length.
    Ours,
    /// The seal of a later version: later formats too end with the mark and 12 bytes.
    Later,
}

/// What a file ends with. Only [`read_parts`] checks its bytes.
pub(super) async fn seal_of(disk: &mut impl Disk, folder: &str, file: &FileLength) -> Result<Seal, Failure> {
    let Some(len) = file.bytes.checked_sub(SEAL_BYTES as u64) else { return Ok(Seal::None) };
    let found = disk.read(folder, &file.name, len, SEAL_BYTES).await?;
    let Some((found_mark, rest)) = found.split_first_chunk::<8>() else { return Ok(Seal::None) };
    if *found_mark == MARK && rest.starts_with(&len.to_le_bytes()) {
        return Ok(Seal::Ours);
    }
    let ([name @ .., version], [found_name @ .., found_version]) = (MARK, found_mark);
    Ok(if name == *found_name && *found_version > version { Seal::Later } else { Seal::None })
}

impl Sealing {
    pub fn add(&mut self, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        self.checksum.update(bytes);
    }

    pub fn seal(&self) -> [u8; SEAL_BYTES] {
        let mut seal = [0; SEAL_BYTES];
        let (mark, rest) = seal.split_at_mut(MARK.len());
        mark.copy_from_slice(&MARK);
        let (length, checksum) = rest.split_at_mut(size_of::<u64>());
        length.copy_from_slice(&self.bytes.to_le_bytes());
        checksum.copy_from_slice(&self.checksum.clone().finalize().to_le_bytes());
        seal
    }
}

/// Gives what a sealed file holds to `part`, in order, and returns whether the seal is right. What was given is worthless
/// if it isn't.
pub(super) async fn read_parts(
    disk: &mut impl Disk,
    folder: &str,
    file: &FileLength,
    mut part: impl FnMut(Vec<u8>),
) -> Result<bool, Failure> {
    let Some(len) = file.bytes.checked_sub(SEAL_BYTES as u64) else { return Ok(false) };
    let (mut at, mut sealing) = (0, Sealing::default());
    while at < len {
        let wanted = usize::try_from(len - at).unwrap_or(PART_BYTES).min(PART_BYTES);
        let bytes = disk.read(folder, &file.name, at, wanted).await?;
        if bytes.len() != wanted {
            return Ok(false);
        }
        at += wanted as u64;
        sealing.add(&bytes);
        part(bytes);
    }
    Ok(disk.read(folder, &file.name, len, SEAL_BYTES).await? == sealing.seal())
}

/// The name of a numbered file.
pub(super) fn named(kind: &str, number: u64) -> String {
    format!("{kind}-{number}")
}

/// The files of a kind in a folder, such as `info-3` and `info-4`, with their numbers, the newest first.
pub(super) fn numbered(files: &[FileLength], kind: &str) -> Vec<(u64, FileLength)> {
    let number = |file: &FileLength| file.name.strip_prefix(kind)?.strip_prefix('-')?.parse().ok();
    let mut found: Vec<(u64, FileLength)> =
        files.iter().filter_map(|file| Some((number(file)?, file.clone()))).collect();
    found.sort_unstable_by_key(|(number, _)| std::cmp::Reverse(*number));
    found
}

/// How often files are listed again because another tab replaces them meanwhile.
pub(super) const MAX_TRIES: usize = 4;

/// The newest whole file of a kind.
pub(super) async fn read_newest(
    disk: &mut impl Disk,
    folder: &str,
    kind: &str,
) -> Result<Option<Vec<u8>>, Failure> {
    let mut read = Ok(None);
    for _ in 0..MAX_TRIES {
        read = try_read_newest(disk, folder, kind).await;
        if read != Err(Failure::Missing) {
            break;
        }
    }
    read
}

async fn try_read_newest(disk: &mut impl Disk, folder: &str, kind: &str) -> Result<Option<Vec<u8>>, Failure> {
    let files = disk.files(folder).await?;
    for (_, file) in numbered(&files, kind) {
        let mut bytes = Vec::new();
        if read_parts(disk, folder, &file, |part| bytes.extend(part)).await? {
            return Ok(Some(bytes));
        }
    }
    Ok(None)
}

/// These bytes with their seal.
pub(super) fn sealed(bytes: &[u8]) -> Vec<u8> {
    let mut sealing = Sealing::default();
    sealing.add(bytes);
    [bytes, &sealing.seal()].concat()
}
