//! The fuzz targets of `fuzz/documents.rs`, run natively: on every seed as it is, then on damaged ones, always the same.
//! `MESHWRIGHT_FUZZ` sets how many of these.

#[path = "../../../fuzz/documents.rs"]
mod documents;

use fixtures::Random;
use std::path::{Path, PathBuf};

/// What readers stumble over, to put anywhere.
const WORDS: [&[u8]; 14] = [
    b"-1",
    b"0",
    b"4294967295",
    b"99999999999999999999",
    b"1e999",
    b"null",
    b"true",
    b"{}",
    b"\"",
    b"\0",
    b"\0\0\0\0",
    b"\xff\xff\xff\xff",
    b"\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01",
    b"\x80\x80\x04",
];

/// A seed with a few things done to it.
fn damaged(seed: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(12)).min(bytes.len());
        match random.below(6) {
            0 => drop(bytes.drain(at..end)),
            1 if random.below(4) == 0 => bytes.truncate(at),
            2 => {
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
            3 => {
                let word = WORDS[random.below(WORDS.len())];
                drop(bytes.splice(at..end.min(at + word.len()), word.iter().copied()));
            }
            4 => {
                // Another digit in a number.
                if let Some(byte) =
                    bytes.get_mut(at..).and_then(|rest| rest.iter_mut().find(|b| b.is_ascii_digit()))
                {
                    *byte = b'0' + random.below(10) as u8;
                }
            }
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte = byte.wrapping_add([1, 2, 255, 128][random.below(4)]);
                }
            }
        }
    }
    bytes
}

fn seeds(target: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds").join(target);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "{target} has no seeds");
    paths.into_iter().map(|path| (path.clone(), std::fs::read(path).expect("readable"))).collect()
}

fn fuzz(target: &str) {
    let rounds = std::env::var("MESHWRIGHT_FUZZ").ok().and_then(|text| text.parse().ok()).unwrap_or(600);
    let seeds = seeds(target);
    for (path, seed) in &seeds {
        assert!(documents::run(target, seed), "{} is not read", path.display());
    }
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for round in 0..rounds {
        let bytes = damaged(&seeds[round % seeds.len()].1, &mut random);
        let result =
            std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| documents::run(target, &bytes)));
        if result.is_err() {
            let path = std::env::temp_dir().join(format!("meshwright-fuzz-{target}-{round}"));
            let _ = std::fs::write(&path, &bytes);
            panic!("round {round} panicked; its bytes are in {}", path.display());
        }
    }
}

macro_rules! fuzz_tests {
    ($($target:ident),*) => {
        $(#[test]
        fn $target() {
            fuzz(stringify!($target));
        })*

        #[test]
        fn every_target_is_run() {
            assert_eq!(documents::TARGETS, [$(stringify!($target)),*]);
            let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/fuzz_targets");
            for target in documents::TARGETS {
                let text = std::fs::read_to_string(folder.join(format!("{target}.rs"))).expect("a target's file");
                assert!(text.contains(&format!("\"{target}\"")), "{target}");
            }
        }
    };
}

fuzz_tests!(commands, document, history, link, project);

/// Every byte of a small document's blocks, with each of its bits changed, behind a checksum that is right.
#[test]
fn every_flipped_bit_behind_the_checksums_is_refused_or_gives_a_valid_document() {
    let (_, seed) = seeds("document").remove(0);
    for at in 0..seed.len() {
        for bit in 0..8 {
            let mut bytes = seed.clone();
            bytes[at] ^= 1 << bit;
            documents::run("document", &bytes);
        }
        documents::run("document", &seed[..at]);
    }
}
