//! What the table of formats says of project files. `editor::project` reads and writes them.

use crate::format::{Certainty, FormatInfo, Holds};

/// The bytes that project files start with.
pub const MARK: &[u8; 8] = b"\x89MWP\r\n\x1a\n";

pub(crate) static FORMAT: FormatInfo = FormatInfo {
    code: "meshwright",
    name: "Meshwright project",
    save_label: "Save as Meshwright project…",
    description: "The whole document with its materials, selections, view and history, to go on with later.",
    extensions: &["meshwright"],
    holds: Holds::Documents,
    // The mark without its line ends, so that files that a transfer damaged are recognised too.
    detect: Some((Certainty::Signature, |bytes| bytes.starts_with(b"\x89MWP"))),
    keeps_name: true,
    ..FormatInfo::DEFAULT
};
