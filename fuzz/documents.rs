//! The fuzz targets of what the editor reads: project files and links. `cargo fuzz` and the native test
//! `crates/editor/tests/fuzz.rs` both include this file.
//!
//! Checksums refuse nearly all damage, so most targets are what lies behind them: their bytes are wrapped in a file or a
//! link whose checksums are right.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use editor::project::{Link, Project, ReadProject};
use editor::{Command, Editor};

/// The targets.
#[allow(dead_code, reason = "libFuzzer's binaries name their own target")]
pub const TARGETS: [&str; 5] = ["commands", "document", "history", "link", "project"];

/// Reads bytes as a target says. What was read must be valid, at every step of its history, and must come back from what
/// is written of it. Returns whether anything was read.
///
/// # Panics
/// It is not or does not: that is what fuzzing looks for.
pub fn run(target: &str, data: &[u8]) -> bool {
    let read = match target {
        "project" => Project::read(data),
        "document" => Project::read(&file(&[("about", b"{}"), ("document", data)])),
        "history" => Project::read(&with_history(data)),
        "link" => std::str::from_utf8(data).map_err(|_| String::new()).and_then(Link::read),
        "commands" => Link::read(&link(1, data)),
        other => unreachable!("there is no target {other}"),
    };
    let is_read = read.is_ok();
    if let Ok(read) = read {
        check(read);
    }
    is_read
}

fn check(read: ReadProject) {
    for object in read.project.document().objects() {
        object.mesh().validate().expect("a valid mesh");
    }
    let mut editor = Editor::new();
    editor.open_project(read);
    validate(&editor);
    let again = Project::read(&Project::of(&editor).write()).expect("its own file");
    assert!(again.project.document().objects().len() == editor.document().objects().len());
    for at in 0..editor.document().objects().len() {
        if editor.document().objects()[at].is_repairable() {
            let command = format!(r#"{{"op":"repair-import","object":{at}}}"#);
            let _ = editor.run(Command::from_json(&command).expect("a command"));
            validate(&editor);
        }
    }
    while matches!(editor.undo(), Ok(Some(_))) {
        validate(&editor);
    }
    while matches!(editor.redo(), Ok(Some(_))) {
        validate(&editor);
    }
}

fn validate(editor: &Editor) {
    for object in editor.document().objects() {
        object.mesh().validate().expect("a valid mesh");
    }
}

/// A project file of these sections, as they are.
fn file(sections: &[(&str, &[u8])]) -> Vec<u8> {
    let mut file = b"\x89MWP\r\n\x1a\n\x01\0\0\0".to_vec();
    for (name, bytes) in sections.iter().copied().chain([("end", &b""[..])]) {
        let mut head = [0; 28];
        head[..name.len()].copy_from_slice(name.as_bytes());
        head[12..20].copy_from_slice(&(bytes.len() as u64).to_le_bytes());
        head[20..].copy_from_slice(&(bytes.len() as u64).to_le_bytes());
        file.extend(head);
        file.extend(checksum(&[&head, bytes]).to_le_bytes());
        file.extend(bytes);
    }
    file
}

/// A project that was empty at first, whose log has an entry for each line. Selections are empty.
fn with_history(lines: &[u8]) -> Vec<u8> {
    let empty = Project::of(&Editor::new()).write();
    // The document of an empty editor is its start too.
    let document = section(&empty, "document");
    let mut log = b"MWlog\0\0\x01".to_vec();
    for line in lines.split(|byte| *byte == b'\n').filter(|line| !line.is_empty()) {
        let block = |bytes: &[u8]| [&(bytes.len() as u64).to_le_bytes(), bytes].concat();
        let mut entry = [b"MWentry1".to_vec(), block(line)].concat();
        let has = |name: &[u8]| line.windows(name.len()).any(|part| part == name);
        if has(b"\"select\":") || has(b"\"job\":") {
            entry.extend([block(br#"{"kind":3,"latest":null}"#), block(br#""Ids""#), block(b"")].concat());
        }
        let len = (entry.len() as u32).to_le_bytes();
        log.extend(len);
        log.extend(checksum(&[&len, &entry]).to_le_bytes());
        log.extend(entry);
    }
    file(&[("about", b"{}"), ("document", &document), ("start", &document), ("log", &log)])
}

/// The expanded bytes of a section of a file that is known to be right.
fn section(file: &[u8], name: &str) -> Vec<u8> {
    let mut rest = &file[12..];
    while rest.len() >= 32 {
        let stored = u64::from_le_bytes(rest[12..20].try_into().expect("eight bytes")) as usize;
        let (head, bytes) = (&rest[..32], &rest[32..32 + stored]);
        if head[..8].starts_with(name.as_bytes()) {
            let mut out = Vec::new();
            let mut inflater = flate2::read::DeflateDecoder::new(bytes);
            if head[8] == 0 {
                return bytes.to_vec();
            }
            std::io::Read::read_to_end(&mut inflater, &mut out).expect("its own bytes");
            return out;
        }
        rest = &rest[32 + stored..];
    }
    panic!("there is no section {name}")
}

/// A link with these contents.
fn link(kind: u8, contents: &[u8]) -> String {
    let contents = &contents[..contents.len().min(60_000)];
    let len = contents.len() as u16;
    // A single block of deflate that is stored as it is (RFC 1951, 3.2.4).
    let packed = [&[1], &len.to_le_bytes()[..], &(!len).to_le_bytes(), contents].concat();
    let sum = checksum(&[&[kind], &packed]).to_le_bytes();
    format!("#d=1{}", URL_SAFE_NO_PAD.encode([&[kind], &sum[..], &packed].concat()))
}

fn checksum(parts: &[&[u8]]) -> u32 {
    let mut checksum = crc32fast::Hasher::new();
    parts.iter().for_each(|part| checksum.update(part));
    checksum.finalize()
}
