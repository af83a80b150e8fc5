//! Files in memory.

/// A file in memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NamedBytes {
    /// Its name, with extension; folders in front are allowed.
    pub name: String,
    /// Its contents.
    pub bytes: Vec<u8>,
}

impl NamedBytes {
    /// A file in memory.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), bytes: bytes.into() }
    }

    /// The name without folders and extension, for naming documents and objects.
    pub fn stem(&self) -> &str {
        let base = base_name(&self.name);
        match base.rsplit_once('.') {
            Some((stem, _)) if !stem.is_empty() => stem,
            _ => base,
        }
    }

    /// Whether the name has this extension, in upper or lower case.
    pub(crate) fn has_extension(&self, extension: &str) -> bool {
        self.name.rsplit_once('.').is_some_and(|(_, own)| own.eq_ignore_ascii_case(extension))
    }
}

/// A path's file name, without folders.
pub(crate) fn base_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or_default()
}

/// A path with `/` between folders.
pub(crate) fn with_slashes(path: &str) -> String {
    path.replace('\\', "/")
}

/// The file that a model refers to by this name: the one at that path, or else the one of that name in
/// any folder, in upper or lower case.
pub(crate) fn find<'a>(name: &str, files: &'a [NamedBytes]) -> Option<&'a NamedBytes> {
    let name = with_slashes(name);
    let base = |path: &str| base_name(path).to_lowercase();
    let exact = files.iter().find(|file| with_slashes(&file.name) == name);
    exact.or_else(|| files.iter().find(|file| base(&file.name) == base(&name)))
}
