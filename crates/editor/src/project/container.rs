//! The container of project files: a header, then named sections, each with its length and a checksum.
//!
//! Sections that a program doesn't know are skipped, so that later versions can add some. Lengths are checked before memory
//! is reserved: what a section may expand to is limited by its stored length and by [`MAX_EXPANDED_BYTES`].

use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;
use std::io::{Read, Write};

/// The bytes that a project file starts with. As in PNG, they show whether a transfer changed line ends or cut off the
/// eighth bit.
pub(super) const MARK: [u8; 8] = *formats::PROJECT_MARK;

/// The version of the container and of its sections.
pub(super) const VERSION: u32 = 1;

/// The name of the last section, which is empty.
const END: &str = "end";

/// The bytes of a section's name, with zeros after it.
const NAME_BYTES: usize = 8;

/// A section's name, encoding, stored and expanded length, and CRC-32.
const HEAD_BYTES: usize = NAME_BYTES + 4 + 8 + 8 + 4;

/// What a section may take in memory, which bounds a document to about ten million triangles.
const MAX_EXPANDED_BYTES: u64 = 1 << 30;

/// What one byte of deflate can stand for at most (RFC 1951: 258 bytes in two bits), rounded up.
const MAX_EXPANSION: u64 = 1040;

/// Stored as it is.
const PLAIN: u32 = 0;
/// Compressed with deflate (RFC 1951), without a header.
const DEFLATE: u32 = 1;

/// The bytes of a file, section by section.
pub(super) struct Sections(Vec<u8>);

impl Sections {
    pub fn new() -> Self {
        Self([&MARK[..], &VERSION.to_le_bytes()].concat())
    }

    /// Adds a section, compressed where that makes it shorter.
    pub fn add(&mut self, name: &str, bytes: &[u8]) {
        let packed = deflate(bytes, Compression::default());
        let (encoding, stored) =
            if packed.len() < bytes.len() { (DEFLATE, &packed[..]) } else { (PLAIN, bytes) };
        let mut head = [0; HEAD_BYTES - 4];
        let (of_name, rest) = head.split_at_mut(NAME_BYTES);
        of_name.iter_mut().zip(name.bytes()).for_each(|(to, from)| *to = from);
        let numbers = [
            &encoding.to_le_bytes()[..],
            &(stored.len() as u64).to_le_bytes(),
            &(bytes.len() as u64).to_le_bytes(),
        ];
        rest.iter_mut().zip(numbers.concat()).for_each(|(to, from)| *to = from);
        self.0.extend_from_slice(&head);
        self.0.extend(checksum(&head, stored).to_le_bytes());
        self.0.extend_from_slice(stored);
    }

    /// The bytes of the file.
    pub fn finish(mut self) -> Vec<u8> {
        self.add(END, &[]);
        self.0
    }
}

fn checksum(head: &[u8], stored: &[u8]) -> u32 {
    let mut checksum = crc32fast::Hasher::new();
    checksum.update(head);
    checksum.update(stored);
    checksum.finalize()
}

/// A section as it is stored.
struct Stored<'a> {
    name: String,
    encoding: u32,
    expanded: u64,
    bytes: &'a [u8],
}

/// The sections of a file.
pub(super) struct Contents<'a>(Vec<Stored<'a>>);

impl<'a> Contents<'a> {
    /// Finds the sections of a file and compares their checksums. Expands nothing.
    ///
    /// # Errors
    /// It is no project file, one of a later version, or damaged: a sentence.
    pub fn of(file: &'a [u8]) -> Result<Self, String> {
        let rest = file.strip_prefix(&MARK).ok_or("it is no Meshwright project")?;
        let (version, mut rest) = rest.split_first_chunk().ok_or_else(cut_off)?;
        let version = u32::from_le_bytes(*version);
        if version > VERSION {
            return Err(format!(
                "it was saved by a later version of Meshwright, in version {version} of the format; this one reads version \
                 {VERSION}. Reload the page to get the latest version"
            ));
        }
        if version == 0 {
            return Err("its version is 0, which no program writes: the file is damaged".to_owned());
        }
        let mut sections: Vec<Stored<'a>> = Vec::new();
        loop {
            let (section, after) = split_section(rest)?;
            rest = after;
            if section.name == END {
                break;
            }
            if sections.iter().any(|other| other.name == section.name) {
                return Err(format!("the section “{}” is there twice: the file is damaged", section.name));
            }
            sections.push(section);
        }
        if !rest.is_empty() {
            return Err("bytes follow after its end: the file is damaged".to_owned());
        }
        Ok(Self(sections))
    }

    /// Takes and expands a section; none if there is none of this name.
    ///
    /// # Errors
    /// It can't be expanded: a sentence.
    pub fn take(&mut self, name: &str) -> Result<Option<Vec<u8>>, String> {
        let Some(at) = self.0.iter().position(|section| section.name == name) else { return Ok(None) };
        let Stored { encoding, expanded, bytes, .. } = self.0.swap_remove(at);
        match encoding {
            PLAIN if bytes.len() as u64 == expanded => Ok(Some(bytes.to_vec())),
            DEFLATE => expand(bytes, expanded).map(Some).map_err(|why| format!("the section “{name}” {why}")),
            _ => Err(format!("the section “{name}” is stored in an unknown way: the file is damaged")),
        }
    }

    /// The names of the sections that were not taken, as text that can be shown.
    pub fn others(&self) -> Vec<String> {
        self.0.iter().map(|section| section.name.clone()).collect()
    }
}

fn cut_off() -> String {
    "it is incomplete: its end is missing. Download or copy the file again".to_owned()
}

fn split_section(bytes: &[u8]) -> Result<(Stored<'_>, &[u8]), String> {
    let (head, rest) = bytes.split_first_chunk::<HEAD_BYTES>().ok_or_else(cut_off)?;
    let (described, expected) = head.split_at(HEAD_BYTES - 4);
    let (name, numbers) = described.split_at(NAME_BYTES);
    let (encoding, lengths) = numbers.split_at(4);
    let (stored, expanded) = lengths.split_at(8);
    let number = |bytes: &[u8]| bytes.iter().rev().fold(0u64, |value, byte| value << 8 | u64::from(*byte));
    let name: String = name.iter().take_while(|byte| **byte != 0).map(|byte| char::from(*byte)).collect();
    let stored = usize::try_from(number(stored)).ok().and_then(|len| rest.split_at_checked(len));
    let (bytes, rest) = stored.ok_or_else(cut_off)?;
    if u64::from(checksum(described, bytes)) != number(expected) {
        return Err("its checksum is wrong: the file is damaged. Download or copy it again".to_owned());
    }
    Ok((Stored { name, encoding: number(encoding) as u32, expanded: number(expanded), bytes }, rest))
}

/// Compresses bytes.
pub(super) fn deflate(bytes: &[u8], level: Compression) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), level);
    // Writing to a vector can't fail.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

/// Expands bytes of which no length is known.
///
/// # Errors
/// They are no such bytes, or stand for more than the limit.
pub(super) fn inflate(bytes: &[u8], limit: u64) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    match DeflateDecoder::new(bytes).take(limit + 1).read_to_end(&mut out) {
        Ok(_) if out.len() as u64 <= limit => Ok(out),
        _ => Err("can't be expanded".to_owned()),
    }
}

/// Expands bytes to exactly this many.
///
/// # Errors
/// They are no such bytes, or stand for more than may be: the rest of a sentence.
fn expand(bytes: &[u8], expanded: u64) -> Result<Vec<u8>, String> {
    if expanded > MAX_EXPANDED_BYTES {
        return Err(format!(
            "takes more than {} MB when expanded, which is too large",
            MAX_EXPANDED_BYTES >> 20
        ));
    }
    if expanded > (bytes.len() as u64).saturating_mul(MAX_EXPANSION) {
        return Err("claims to be longer than it can be: the file is damaged".to_owned());
    }
    let mut out = Vec::with_capacity(expanded as usize);
    let read = DeflateDecoder::new(bytes).take(expanded + 1).read_to_end(&mut out);
    if read.is_err() || out.len() as u64 != expanded {
        return Err("can't be expanded: the file is damaged".to_owned());
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(sections: &[(&str, &[u8])]) -> Vec<u8> {
        let mut file = Sections::new();
        sections.iter().for_each(|(name, bytes)| file.add(name, bytes));
        file.finish()
    }

    /// A file of one section with a valid checksum and these numbers in its head.
    fn forged(encoding: u32, expanded: u64, stored: &[u8]) -> Vec<u8> {
        let head = [
            b"data\0\0\0\0",
            &encoding.to_le_bytes()[..],
            &(stored.len() as u64).to_le_bytes(),
            &expanded.to_le_bytes(),
        ]
        .concat();
        let checksum = checksum(&head, stored).to_le_bytes();
        let end = file(&[]);
        [&end[..12], &head, &checksum, stored, &end[12..]].concat()
    }

    #[test]
    fn sections_come_back_and_unknown_ones_are_named() {
        let zeros = vec![0; 10_000];
        let bytes = file(&[("zeros", &zeros), ("later", b"abc"), ("none", b"")]);
        assert!(bytes.len() < 300, "{}", bytes.len());
        let mut contents = Contents::of(&bytes).expect("its own");
        assert_eq!(contents.take("zeros"), Ok(Some(zeros)));
        assert_eq!(contents.take("none"), Ok(Some(Vec::new())));
        assert_eq!(contents.take("missing"), Ok(None));
        assert_eq!(contents.others(), ["later"]);
    }

    #[test]
    fn later_versions_are_refused_by_their_number() {
        let mut bytes = file(&[]);
        bytes[8] = 2;
        let error = Contents::of(&bytes).err().expect("refused");
        assert!(error.contains("version 2") && error.contains("version 1"), "{error}");
    }

    #[test]
    fn every_truncated_and_every_damaged_file_is_refused() {
        let bytes = file(&[("data", b"some bytes, some bytes"), ("more", &[7; 100])]);
        for len in 0..bytes.len() {
            assert!(Contents::of(&bytes[..len]).is_err(), "{len} bytes");
        }
        for at in 0..bytes.len() {
            for bit in 0..8 {
                let mut bytes = bytes.clone();
                bytes[at] ^= 1 << bit;
                assert!(Contents::of(&bytes).is_err(), "bit {bit} of byte {at}");
            }
        }
        assert!(Contents::of(&[&bytes[..], b"x"].concat()).is_err());
    }

    #[test]
    fn false_lengths_reserve_no_memory() {
        let packed = deflate(&[0; 5000], Compression::best());
        let take = |bytes: &[u8]| Contents::of(bytes).expect("a valid checksum").take("data");
        assert_eq!(take(&forged(DEFLATE, 5000, &packed)), Ok(Some(vec![0; 5000])));
        for expanded in [0, 4999, 5001, u64::MAX, 1 << 30, (1 << 30) + 1] {
            let error = take(&forged(DEFLATE, expanded, &packed)).expect_err("a false length");
            assert!(error.starts_with("the section “data” "), "{error}");
        }
        assert!(take(&forged(PLAIN, 4, b"abc")).is_err());
        assert!(take(&forged(7, 3, b"abc")).is_err());
        assert!(take(&forged(DEFLATE, 3, b"abc")).is_err());
    }
}
