//! The bytes of a log: a header, then records, each with its length and a checksum.
//!
//! A record that was cut off by a crash or damaged on the disk fails its checksum. It and everything after it is left
//! out, because later entries build on it.

use super::entry::Entry;
use super::snapshot::SNAPSHOT_MARK;
use crate::job::Wire;

/// The mark and the version that a log starts with.
const HEADER: [u8; 8] = *b"MWlog\0\0\x01";

/// The bytes before a record's entry: its length and its CRC-32, little-endian.
const RECORD_HEAD_BYTES: usize = 8;

/// The entries of a log, and how much of it they take.
#[derive(Debug, Default, PartialEq)]
pub struct Records {
    /// The entries up to the first damaged one.
    pub entries: Vec<Entry>,
    /// The bytes that they take: cut the log off here before appending to it.
    pub valid_bytes: usize,
    /// Whether bytes follow that are no entry.
    pub is_cut_off: bool,
    /// Whether these bytes are whole, but written by a later version: they must stay as they are.
    pub is_later: bool,
}

/// Whether a snapshot or a log begins as those of a later version do.
pub fn is_of_later_version(bytes: &[u8]) -> bool {
    let is_later = |mark: [u8; 8]| {
        let ([name @ .., version], Some([found @ .., found_version])) = (mark, bytes.first_chunk::<8>())
        else {
            return false;
        };
        name == *found && *found_version > version
    };
    is_later(HEADER) || is_later(SNAPSHOT_MARK)
}

/// The bytes of a log without entries.
pub fn new_log() -> Vec<u8> {
    HEADER.to_vec()
}

/// Appends an entry to the bytes of a log.
pub fn append_record(log: &mut Vec<u8>, entry: &Entry) {
    let bytes = entry.to_bytes();
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(&(bytes.len() as u32).to_le_bytes());
    checksum.update(&bytes);
    log.extend((bytes.len() as u32).to_le_bytes());
    log.extend(checksum.finalize().to_le_bytes());
    log.extend(bytes);
}

/// Reads a log up to its first damaged record, or the first that only a later version can read. Costs O(bytes); never
/// fails.
pub fn read_log(log: &[u8]) -> Records {
    let Some(mut rest) = log.strip_prefix(&HEADER) else {
        let is_later = is_of_later_version(log);
        return Records { is_cut_off: !log.is_empty(), is_later, ..Records::default() };
    };
    let (mut entries, mut is_later) = (Vec::new(), false);
    while let Some((entry, after)) = split_record(rest) {
        // A whole record that can't be read is one that this version doesn't know.
        let Ok(entry) = Entry::from_bytes(entry) else {
            is_later = true;
            break;
        };
        entries.push(entry);
        rest = after;
    }
    Records { entries, valid_bytes: log.len() - rest.len(), is_cut_off: !rest.is_empty(), is_later }
}

/// The bytes of the first entry and those after it; none if it is damaged.
fn split_record(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let (head, rest) = bytes.split_at_checked(RECORD_HEAD_BYTES)?;
    let (len, checksum) = head.split_first_chunk::<4>()?;
    let (entry, after) = rest.split_at_checked(u32::from_le_bytes(*len) as usize)?;
    let mut expected = crc32fast::Hasher::new();
    expected.update(len);
    expected.update(entry);
    (expected.finalize().to_le_bytes() == checksum).then_some((entry, after))
}
