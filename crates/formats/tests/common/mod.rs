//! What the tests of all formats share.
#![allow(dead_code, reason = "each test binary uses a part")]

use formats::{Format, Import, NamedBytes, ObjectRef};
use halfedge::Mesh;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// Reads with nobody watching the progress.
pub fn read(files: &[NamedBytes]) -> Result<Import, formats::ReadError> {
    formats::read(files, &mut |_| ControlFlow::Continue(()))
}

/// Reads one text as an OBJ.
pub fn read_obj(text: &str) -> Import {
    read(&[NamedBytes::new("test.obj", text)]).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The one mesh of an import, checked.
pub fn mesh(import: &Import) -> &Mesh {
    assert_eq!(import.objects.len(), 1);
    import.objects[0].mesh.validate().expect("a valid mesh");
    &import.objects[0].mesh
}

/// All objects of an import, to write them again.
pub fn objects(import: &Import) -> Vec<ObjectRef<'_>> {
    import
        .objects
        .iter()
        .map(|object| ObjectRef { offset: import.offset, ..ObjectRef::new(&object.name, &object.mesh) })
        .collect()
}

/// Writes one mesh.
pub fn write(format: Format, mesh: &Mesh) -> Vec<NamedBytes> {
    formats::write(format, "test", &[ObjectRef::new("test", mesh)]).expect("small enough")
}

/// The text of a written file.
pub fn text(file: &NamedBytes) -> &str {
    std::str::from_utf8(&file.bytes).expect("UTF-8")
}

/// Files of the shared models, or nothing, with a line that says so, where they are missing.
pub fn shared(folder: &str, extension: &str) -> Vec<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared").join(folder);
    let Ok(entries) = std::fs::read_dir(&path) else {
        println!("skipped: {} is missing", path.display());
        return Vec::new();
    };
    let mut files: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect();
    files.sort();
    files
}

/// A file from disk.
pub fn load(path: &Path) -> NamedBytes {
    let name = path.file_name().expect("a file").to_string_lossy();
    NamedBytes::new(name, std::fs::read(path).expect("readable"))
}
