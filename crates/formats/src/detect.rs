//! Which format a file has, by what is in it.

use crate::format::Format;
use crate::scan::{Scan, is_text};
use crate::{bezier, collada, gltf, off, stl};

/// How much of a file is looked at, in bytes, where what tells comes near its start.
const HEAD: usize = 64 * 1024;

/// The format of content that is plainly of one, whatever the file is called. Costs a look at the
/// start, but a pass over a file of numbers alone.
pub(crate) fn by_content(bytes: &[u8]) -> Option<Format> {
    if is_ply(bytes) {
        Some(Format::Ply)
    } else if off::is_off(bytes) {
        Some(Format::Off)
    } else if gltf::looks_like(bytes) {
        Some(if bytes.starts_with(b"glTF") { Format::Glb } else { Format::Gltf })
    } else if collada::looks_like(bytes) {
        Some(Format::Collada)
    } else if stl::is_text_stl(bytes) || stl::is_binary(bytes) {
        Some(Format::Stl)
    } else if is_obj(bytes) {
        Some(Format::Obj)
    } else {
        // No OFF without its first word is of just as many numbers as its first one says.
        bezier::kind(bytes)
    }
}

/// Whether the first line is that of a PLY.
fn is_ply(bytes: &[u8]) -> bool {
    let mut scan = Scan::new(bytes.get(..HEAD).unwrap_or(bytes), None);
    scan.word() == Some(b"ply") && !scan.more_on_line()
}

/// Whether one of the first lines that say anything is a vertex, a texture coordinate, a normal or a
/// face of an OBJ.
fn is_obj(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD).unwrap_or(bytes);
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    is_text(head)
        && head
            .split(|&b| b == b'\n' || b == b'\r')
            .map(<[u8]>::trim_ascii)
            .filter(|line| !line.is_empty() && !line.starts_with(b"#"))
            .take(100)
            .any(is_obj_statement)
}

fn is_obj_statement(line: &[u8]) -> bool {
    let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let (least, signs): (usize, &[u8]) = match words.next() {
        Some(b"v" | b"vn") => (3, b"+-.eE"),
        Some(b"vt") => (2, b"+-.eE"),
        Some(b"f") => (3, b"-/"),
        _ => return false,
    };
    let is_number = |word: &[u8]| word.iter().all(|b| b.is_ascii_digit() || signs.contains(b));
    words.take_while(|word| is_number(word)).take(least).count() == least
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::import::NamedBytes;

    fn detect(name: &str, bytes: &[u8]) -> Option<Format> {
        Format::detect(&NamedBytes::new(name, bytes))
    }

    #[test]
    fn formats_are_told_by_name_and_by_content() {
        assert_eq!(detect("a/b.OBJ", b""), Some(Format::Obj));
        assert_eq!(detect("pasted", b"# hello\n\n  v 0 0 0\n"), Some(Format::Obj));
        assert_eq!(detect("pasted.txt", b"\xef\xbb\xbff -1/2 1 1"), Some(Format::Obj));
        assert_eq!(detect("pasted.txt", b"vn 0 0 1\n"), Some(Format::Obj));
        assert_eq!(detect("readme.txt", b"v for vendetta\nf sharp\nv 2\nf 16 bit\nv 1 a b"), None);
        assert_eq!(detect("nothing", b""), None);
    }

    #[test]
    fn content_counts_for_more_than_the_name() {
        assert_eq!(detect("a.obj", b"ply\nformat ascii 1.0\n"), Some(Format::Ply));
        assert_eq!(detect("a.stl", b"# x\nCOFF 3 1 0\n"), Some(Format::Off));
        assert_eq!(detect("a.off", b"solid a b\nfacet normal 0 0 1\n"), Some(Format::Stl));
        assert_eq!(detect("a.off", b"solid a\ncolor 1 0 0\nfacet normal 0 0 1\n"), Some(Format::Stl));
        assert_eq!(detect("a.ply", b"{\"accessors\":[{\"componentType\":5126"), Some(Format::Gltf));
        assert_eq!(detect("a.stl", b"v 0 0 0\n"), Some(Format::Obj));
        assert_eq!(detect("a.obj", b"2\n0 0\n1 1\n"), Some(Format::BezierCurve));
        // An OFF without its first word is one by name only.
        assert_eq!(detect("a.off", b"3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), Some(Format::Off));
    }

    /// A binary STL of triangles side by side that says it has `count`.
    fn binary_stl(count: u32, triangles: u8) -> Vec<u8> {
        let mut bytes = vec![b' '; 80];
        bytes[..5].copy_from_slice(b"solid");
        bytes.extend(count.to_le_bytes());
        for i in 0..triangles {
            let x = f32::from(i);
            for c in [0.0, 0.0, 1.0, x, 0.0, 0.0, x + 1.0, 0.0, 0.0, x, 1.0, 0.0] {
                bytes.extend(c.to_le_bytes());
            }
            bytes.extend([0, 0]);
        }
        bytes
    }

    #[test]
    fn a_binary_stl_is_one_whose_triangles_are_there() {
        let whole = binary_stl(4, 4);
        let with_more = [&whole[..], b"made by x"].concat();
        let with_many_more = [&whole[..], &[1; 500]].concat();
        let without_count = [binary_stl(0, 4), binary_stl(u32::MAX, 4)];
        for bytes in [&whole, &whole[..whole.len() - 7], &whole[..140], &with_more, &with_many_more]
            .into_iter()
            .chain(without_count.iter().map(|bytes| &bytes[..]))
        {
            for name in ["model", "a.stl", "a.obj", "a.glb"] {
                assert_eq!(detect(name, bytes), Some(Format::Stl), "{name}, {} bytes", bytes.len());
            }
        }
        // As long as its count says, whatever its triangles are.
        assert_eq!(
            detect("model", &[vec![1; 80], vec![1, 0, 0, 0], vec![0xff; 50]].concat()),
            Some(Format::Stl)
        );
        // Not what starts elsewhere, has too absurd a count, or none where its first triangle ends.
        for bytes in [&whole[1..], &binary_stl(u32::MAX - 1, 4), &whole[..130], &[0; 284]] {
            assert_eq!(detect("model", bytes), None, "{} bytes", bytes.len());
        }
    }
}
