//! The files that kept documents are saved to, among the settings.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::settings::Settings;

const SETTING: &str = "files";
/// The files of older documents are forgotten.
const MAX_REMEMBERED: usize = 200;

#[derive(Serialize, Deserialize)]
struct Place {
    document: String,
    path: PathBuf,
    /// The code of the format.
    format: String,
}

fn all(settings: &Settings) -> Vec<Place> {
    settings.get(SETTING).and_then(|json| serde_json::from_str(&json).ok()).unwrap_or_default()
}

/// Remembers the path that a document is saved to and the code of its format, or that there is none.
pub fn remember(settings: &mut Settings, document: &str, file: Option<(&Path, &str)>) {
    let mut places = all(settings);
    places.retain(|place| place.document != document);
    places.extend(file.map(|(path, format)| Place {
        document: document.to_owned(),
        path: path.to_owned(),
        format: format.to_owned(),
    }));
    let oldest = places.len().saturating_sub(MAX_REMEMBERED);
    places.drain(..oldest);
    // A path that isn't Unicode can't be written; then saving asks where.
    if let Ok(json) = serde_json::to_string(&places) {
        settings.set(SETTING, &json);
    }
}

/// The path that a document is saved to, and the code of its format.
pub fn recall(settings: &Settings, document: &str) -> Option<(PathBuf, String)> {
    let place = all(settings).into_iter().find(|place| place.document == document)?;
    Some((place.path, place.format))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_newest_files_are_remembered_and_can_be_forgotten() {
        let mut settings = Settings::load(None);
        assert_eq!(recall(&settings, "a"), None);
        remember(&mut settings, "a", Some((Path::new("/models/a.obj"), "obj")));
        remember(&mut settings, "b", Some((Path::new("/models/b.ply"), "ply-text")));
        remember(&mut settings, "a", Some((Path::new("/models/c.stl"), "stl")));
        assert_eq!(recall(&settings, "a"), Some((PathBuf::from("/models/c.stl"), "stl".to_owned())));
        remember(&mut settings, "b", None);
        assert_eq!(recall(&settings, "b"), None);
        for number in 0..MAX_REMEMBERED {
            remember(&mut settings, &number.to_string(), Some((Path::new("/x.off"), "off")));
        }
        assert_eq!(recall(&settings, "a"), None);
        assert!(recall(&settings, "0").is_some());
    }
}
