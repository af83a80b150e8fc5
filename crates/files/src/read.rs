//! Reading a model and the files that it names.

use formats::NamedBytes;
use std::path::Path;

/// Reads a model, with its companion files as far as they exist: the model first.
///
/// # Errors
/// The model can't be read, in words that name it.
pub fn read(path: &Path) -> Result<Vec<NamedBytes>, String> {
    let model = read_bytes(path)?;
    let mut files = companions(path, &model);
    files.insert(0, model);
    Ok(files)
}

/// Reads one file, named without its folder.
///
/// # Errors
/// The file can't be read, in words that name it.
pub fn read_bytes(path: &Path) -> Result<NamedBytes, String> {
    let bytes = std::fs::read(path).map_err(|error| format!("{} can't be read: {error}", path.display()))?;
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    Ok(NamedBytes { name, bytes })
}

/// The companion files of a model that exist, and theirs, such as the images that material libraries name. The import
/// report names the missing ones.
#[must_use]
pub fn companions(path: &Path, model: &NamedBytes) -> Vec<NamedBytes> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let of = |folder: &Path, file: &NamedBytes| -> Vec<NamedBytes> {
        let there = |name: String| {
            let place = folder.join(&name);
            let bytes = place.is_file().then(|| std::fs::read(&place).ok())??;
            Some(NamedBytes { name, bytes })
        };
        formats::companions(file).into_iter().filter_map(there).collect()
    };
    let mut files = of(folder, model);
    for at in 0..files.len() {
        let Some(file) = files.get(at) else { continue };
        let place = folder.join(&file.name);
        let more = of(place.parent().unwrap_or(folder), file);
        for file in more {
            if files.iter().all(|known| known.name != file.name) {
                files.push(file);
            }
        }
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_model_comes_with_its_companions_and_theirs() {
        let folder = tempfile::tempdir().expect("a folder");
        let put = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).expect("room");
        put("box.obj", "mtllib box.mtl\nmtllib gone.mtl\nv 0 0 0\n");
        put("box.mtl", "newmtl wood\nmap_Kd wood.png\n");
        put("wood.png", "not looked into");
        put("other.mtl", "newmtl other\n");
        let names = |path: &Path| -> Vec<String> {
            read(path).expect("a model").into_iter().map(|file| file.name).collect()
        };
        assert_eq!(names(&folder.path().join("box.obj")), ["box.obj", "box.mtl", "wood.png"]);
        let why = read(&folder.path().join("none.obj")).expect_err("no such file");
        assert!(why.contains("none.obj can't be read: "), "{why}");
    }
}
