//! Files that end early, hold nonsense, or are damaged.

use super::common::{by_code, mesh, read, write};
use super::{painted, sample};
use formats::NamedBytes;
use proptest::prelude::*;

const ALL: [&str; 5] = ["ply", "ply-text", "off", "stl", "stl-text"];

#[test]
fn early_ends_and_nonsense_are_told() {
    let report = |name: &str, bytes: &[u8]| match read(&[NamedBytes::new(name, bytes)]) {
        Ok(import) => {
            mesh(&import);
            import.report.to_string()
        }
        Err(error) => error.to_string(),
    };
    let ply = write(by_code("ply"), &sample()).remove(0).bytes;
    assert!(report("a.ply", &ply[..ply.len() - 10]).contains("The file ends early: 2 of 3 rows"));
    assert!(
        report("a.ply", b"ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n")
            .contains("Read 0 vertices")
    );
    assert!(
        report(
            "a.ply",
            b"ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty int x\nend_header\n1 2"
        )
        .contains("ends early: 2 of 99\u{a0}999\u{a0}999\u{a0}999")
    );
    assert!(
        report("a.ply", b"ply\nformat ebcdic 1.0\n").contains("Line 2 of the header: the format is none of")
    );
    assert!(report("a.ply", b"hello").contains("first line is not \"ply\""));
    assert!(report("a.stl", b"hello").contains("shorter than the head"));
    assert!(report("a.stl", &[b'x'; 84]).contains("none of its 2\u{a0}021\u{a0}161\u{a0}080 triangles"));
    assert!(
        report("a.stl", b"solid\nfacet\nvertex 1 2 3\nendfacet\nvertex 1").contains("none of its triangles")
    );
    assert!(report("a.off", b"OFF BINARY\n").contains("binary OFF"));
    assert!(report("a.off", b"OFF\nx").contains("don't come first"));
    assert!(
        report("a.off", b"OFF 2000000000 4000000000 1\n0 0 0")
            .contains("1 of 2\u{a0}000\u{a0}000\u{a0}000 vertices and 0 of 4\u{a0}000\u{a0}000\u{a0}000")
    );
    assert!(report("a.off", b"OFF 3 1 1\n0 0 0 1 0 0 0 1 0\n4000000000 0 1 2").contains("1 face left out"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn damaged_files_never_panic(
        format in prop::sample::select(ALL.map(by_code).to_vec()),
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0u8..4), 1..8),
    ) {
        let mut bytes = write(format, &painted()).remove(0).bytes;
        for (at, value, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = value,
                1 => bytes.truncate(at),
                2 => { bytes.remove(at); }
                _ => bytes.insert(at, value),
            }
        }
        for name in ["a", "a.ply", "a.stl", "a.off"] {
            if let Ok(import) = read(&[NamedBytes::new(name, bytes.clone())]) {
                mesh(&import);
            }
        }
    }
}
