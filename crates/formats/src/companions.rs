//! Companion files: files that a model needs besides itself, such as an OBJ's material libraries, their
//! images, and a glTF's buffers.

use crate::file::{NamedBytes, with_slashes};
use crate::formats::Format;

/// The names of the files that a model or a companion file says it needs, as it has them, with folders:
/// relative to its own. A line of an OBJ that may mean one name with blanks or several gives all of
/// them, so not every name need be there. A companion may have companions of its own. Costs a pass over
/// the file.
pub fn companions(file: &NamedBytes) -> Vec<String> {
    let owner = || Format::all().find(|&format| is_companion(file, format));
    let Some(format) = Format::detect(file).or_else(owner) else { return Vec::new() };
    let mut names: Vec<String> = Vec::new();
    for name in (format.info().companions)(file) {
        let name = with_slashes(name.trim());
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Whether a file is by its name a companion file of models of this format.
pub(crate) fn is_companion(file: &NamedBytes, format: Format) -> bool {
    format.info().companion_extensions.iter().any(|(extension, _)| file.has_extension(extension))
}

/// Of the names that [`companions`] gives, those to report as missing when only the files that
/// `is_there` says exist: a line that may mean one name with blanks or several has one reading.
pub fn missing<'a>(names: &'a [String], is_there: impl Fn(&str) -> bool) -> Vec<&'a str> {
    let is_named = |part: &str| names.iter().any(|name| name == part);
    let parts = |name: &'a str| name.split_whitespace().filter(move |part| *part != name && is_named(part));
    let is_read_as_parts = |name: &'a str| !is_there(name) && parts(name).any(&is_there);
    let is_reported = |name: &&'a str| {
        let whole = names.iter().find(|other| parts(other).any(|part| part == *name));
        !is_there(name) && !is_read_as_parts(name) && whole.is_none_or(|whole| is_read_as_parts(whole))
    };
    names.iter().map(String::as_str).filter(is_reported).collect()
}

/// Of the files that [`crate::write`] gave, the model as one file that opens by itself: a `.gltf` with its
/// data inside, an OBJ without its materials. None where there are no files.
pub fn single_file(files: Vec<NamedBytes>) -> Option<NamedBytes> {
    match files.first().and_then(|model| Format::from_name(&model.name)) {
        Some(format) => (format.info().single_file)(files),
        None => files.into_iter().next(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_with_blanks_is_missed_once() {
        let names = companions(&NamedBytes::new("a.obj", "mtllib my box.mtl\nmtllib b.mtl\n"));
        let missed = |there: &[&str]| missing(&names, |name| there.contains(&name)).join(", ");
        assert_eq!(missed(&[]), "my box.mtl, b.mtl");
        assert_eq!(missed(&["my box.mtl"]), "b.mtl");
        assert_eq!(missed(&["box.mtl", "b.mtl"]), "my");
        assert_eq!(missed(&["my", "box.mtl", "b.mtl"]), "");
        assert_eq!(missed(&["my box.mtl", "b.mtl"]), "");
        let one = ["my data.bin".to_owned()];
        assert_eq!(missing(&one, |name| name != "my data.bin"), one, "a glTF's name is one");
    }

    #[test]
    fn models_name_their_companion_files() {
        let of = |name: &str, text: &str| companions(&NamedBytes::new(name, text));
        assert_eq!(
            of("a.obj", "v 0 0 0\n  mtllib my box.mtl\r\nmtllib sub\\b.mtl\n"),
            ["my box.mtl", "my", "box.mtl", "sub/b.mtl"]
        );
        assert_eq!(of("a.mtl", "newmtl a\nKd 1 1 1\nmap_Kd -s 1 1 1 x\\my wood.png\nd"), ["x/my wood.png"]);
        let gltf = r#"{"asset":{"version":"2.0"},"buffers":[{"uri":"a%20b/c%C3%A9.bin"},{"uri":"data:;base64,AA"},{}]}"#;
        assert_eq!(of("a.gltf", gltf), ["a b/cé.bin"]);
        assert_eq!(of("a.gltf", "{\"asset\": broken"), [""; 0]);
        assert_eq!(of("a.ply", "ply\n"), [""; 0]);
    }
}
