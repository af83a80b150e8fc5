//! Settings, in a file of JSON.

use std::collections::BTreeMap;
use std::path::PathBuf;

/// Settings by key. Without a place for the file they last as long as the program.
pub struct Settings {
    path: Option<PathBuf>,
    values: BTreeMap<String, String>,
}

impl Settings {
    /// Reads the settings; none of a file that isn't there or isn't JSON.
    pub fn load(path: Option<PathBuf>) -> Self {
        let bytes = path.as_ref().and_then(|path| std::fs::read(path).ok());
        let values = bytes.and_then(|bytes| serde_json::from_slice(&bytes).ok()).unwrap_or_default();
        Self { path, values }
    }

    pub fn get(&self, key: &str) -> Option<String> {
        self.values.get(key).cloned()
    }

    /// Stores a setting at once. Where it can't be written, it lasts as long as the program.
    pub fn set(&mut self, key: &str, value: &str) {
        let before = self.values.insert(key.to_owned(), value.to_owned());
        if before.as_deref() == Some(value) {
            return;
        }
        let Some(path) = &self.path else { return };
        let Ok(bytes) = serde_json::to_vec_pretty(&self.values) else { return };
        if let Some(folder) = path.parent() {
            let _ = std::fs::create_dir_all(folder);
        }
        // Under another name first, so that a crash leaves the old settings or the new ones.
        let part = path.with_extension("part");
        let _ = std::fs::write(&part, bytes).and_then(|()| std::fs::rename(&part, path));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_outlive_the_program_and_damage_is_no_error() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = Some(folder.path().join("deep").join("settings.json"));
        let mut settings = Settings::load(path.clone());
        assert_eq!(settings.get("theme"), None);
        settings.set("theme", "dark");
        settings.set("theme", "light");
        assert_eq!(Settings::load(path.clone()).get("theme").as_deref(), Some("light"));
        std::fs::write(path.as_ref().expect("given"), "{\"theme\"").expect("room");
        assert_eq!(Settings::load(path).get("theme"), None);
    }
}
