//! How large a model may be where memory is limited: that of a page ends at 4 GiB, and with it the tab.

use halfedge::words::thousands;

/// The most that may be opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// The largest file in bytes.
    pub file_bytes: u64,
    /// The most corners of faces: three for each triangle.
    pub corners: u64,
}

impl Default for Room {
    /// That of the machine that this program runs on.
    fn default() -> Self {
        if cfg!(target_pointer_width = "32") { Self::BROWSER } else { Self::UNLIMITED }
    }
}

impl Room {
    /// No limit but that of the machine's memory.
    pub const UNLIMITED: Self = Self { file_bytes: u64::MAX, corners: u64::MAX };

    /// In a browser: what is read, built and drawn then stays below 4 GiB in the page and in its worker (`BENCHMARKS.md`).
    pub const BROWSER: Self = Self { file_bytes: 1 << 30, corners: 36_000_000 };

    /// Why so many bytes are too many for a file; none if they fit.
    pub(crate) fn refusal_of_bytes(&self, bytes: u64) -> Option<String> {
        (bytes > self.file_bytes).then(|| {
            let megabytes = |bytes: u64| thousands((bytes >> 20) as usize);
            format!(
                "it has {} MB, and at most {} MB can be opened in a browser. {ADVICE}",
                megabytes(bytes),
                megabytes(self.file_bytes)
            )
        })
    }

    /// Why so many corners are too many; none if they fit.
    pub(crate) fn refusal_of_corners(&self, corners: u64) -> Option<String> {
        (corners > self.corners).then(|| {
            let triangles = |corners: u64| thousands((corners / 3) as usize);
            format!(
                "its faces have as many corners as {} triangles, and at most {} triangles can be opened in a browser. {ADVICE}",
                triangles(corners),
                triangles(self.corners)
            )
        })
    }
}

const ADVICE: &str = "Make it smaller with the command line, which has no such limit: meshwright apply FILE --do \
                      '{\"op\": \"simplify\", \"ratio\": 0.1}' -o SMALLER.ply";
