//! The compressed copies beside the files of a site, which hosts can send as they are.

use std::fs;
use std::io::Write as _;
use std::path::Path;

use crate::shell::{self, Result};

/// The extensions of the copies: Brotli and gzip.
pub const EXTENSIONS: [&str; 2] = ["br", "gz"];

/// Files of these types are compressed already.
const COMPRESSED: [&str; 1] = ["png"];

/// How large a file is, and how large its compressed copies are, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    pub plain: usize,
    pub brotli: usize,
    pub gzip: usize,
}

/// Writes the copies of all files in a folder; returns the sizes of those by their names in the folder.
pub fn all(folder: &Path) -> Result<Vec<(String, Sizes)>> {
    let is_compressed = |path: &Path| {
        path.extension().is_some_and(|extension| COMPRESSED.iter().any(|known| extension == *known))
    };
    let mut sizes = Vec::new();
    for (name, path) in shell::files_below(folder).into_iter().filter(|(_, path)| !is_compressed(path)) {
        let cannot = |error: std::io::Error| format!("{} can't be compressed: {error}.", path.display());
        let bytes = fs::read(&path).map_err(cannot)?;
        let [brotli, gzip] = [brotli(&bytes), gzip(&bytes)].map(|copy| copy.map_err(cannot));
        let (brotli, gzip) = (brotli?, gzip?);
        sizes.push((name, Sizes { plain: bytes.len(), brotli: brotli.len(), gzip: gzip.len() }));
        for (copy, extension) in [brotli, gzip].iter().zip(EXTENSIONS) {
            let mut to = path.clone().into_os_string();
            to.push(format!(".{extension}"));
            fs::write(to, copy).map_err(cannot)?;
        }
    }
    Ok(sizes)
}

fn brotli(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    // The best that it does, in the largest window that every browser takes.
    let parameters = brotli::enc::BrotliEncoderParams {
        quality: 11,
        lgwin: 24,
        size_hint: bytes.len(),
        ..Default::default()
    };
    let mut copy = Vec::new();
    brotli::BrotliCompress(&mut &*bytes, &mut copy, &parameters)?;
    Ok(copy)
}

fn gzip(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use super::*;

    #[test]
    fn copies_hold_what_the_files_do() {
        let folder = std::env::temp_dir().join(format!("meshwright-compress-{}", std::process::id()));
        fs::create_dir_all(folder.join("inner")).expect("folders");
        let text = "half-edge ".repeat(1000);
        for name in ["a.js", "inner/b.css", "picture.png"] {
            fs::write(folder.join(name), &text).expect("a file");
        }
        let sizes = all(&folder).expect("compressed");
        let names: Vec<&str> = sizes.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["a.js", "inner/b.css"]);
        for (name, Sizes { plain, brotli, gzip }) in &sizes {
            assert_eq!(*plain, text.len());
            let copy =
                |extension: &str| fs::read(folder.join(format!("{name}.{extension}"))).expect("a copy");
            let mut back = Vec::new();
            brotli::BrotliDecompress(&mut copy("br").as_slice(), &mut back).expect("brotli");
            assert_eq!(back, text.as_bytes());
            let mut back = String::new();
            flate2::read::GzDecoder::new(copy("gz").as_slice()).read_to_string(&mut back).expect("gzip");
            assert_eq!(back, text);
            assert!(*brotli == copy("br").len() && *gzip == copy("gz").len() && *brotli < plain / 20);
        }
        fs::remove_dir_all(folder).expect("removed");
    }
}
