//! Files that belong beside another: an OBJ's material libraries, a glTF's buffers.

use crate::format::Format;
use crate::gltf;
use crate::import::NamedBytes;

/// The names of the files that a model says it needs besides itself, as it has them, with folders:
/// relative to its own. A line of an OBJ that may mean one name with blanks or several gives all of
/// them, so not every name need be there. Costs a pass over the file.
pub fn companions(file: &NamedBytes) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut add = |name: &str| {
        let name = name.trim().replace('\\', "/");
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    };
    match Format::detect(file) {
        Some(Format::Obj) => {
            let lines = file.bytes.split(|&b| b == b'\n').map(<[u8]>::trim_ascii_start);
            for rest in lines.filter_map(|line| line.strip_prefix(b"mtllib")) {
                let rest = String::from_utf8_lossy(rest);
                add(&rest);
                rest.split_whitespace().for_each(&mut add);
            }
        }
        Some(Format::Gltf | Format::Glb) => gltf::buffer_names(file).iter().for_each(|name| add(name)),
        _ => {}
    }
    names
}

/// Of the names that [`companions`] gives, those to tell of when only the files that `is_there` says
/// exist: a line that may mean one name with blanks or several has one reading.
pub fn missing<'a>(names: &'a [String], is_there: impl Fn(&str) -> bool) -> Vec<&'a str> {
    let is_named = |part: &str| names.iter().any(|name| name == part);
    let parts = |name: &'a str| name.split_whitespace().filter(move |part| *part != name && is_named(part));
    let is_read_as_parts = |name: &'a str| !is_there(name) && parts(name).any(&is_there);
    let told = |name: &&'a str| {
        let whole = names.iter().find(|other| parts(other).any(|part| part == *name));
        !is_there(name) && !is_read_as_parts(name) && whole.is_none_or(|whole| is_read_as_parts(whole))
    };
    names.iter().map(String::as_str).filter(told).collect()
}

/// Of the files that [`crate::write`] gave, the model as one that opens by itself: a `.gltf` has its data
/// inside, an OBJ does without its materials. None where there are no files.
pub fn alone(files: Vec<NamedBytes>) -> Option<NamedBytes> {
    let mut files = files.into_iter();
    let model = files.next()?;
    match files.next() {
        Some(data) if model.name.ends_with(".gltf") => Some(gltf::with_data(model, &data)),
        _ => Some(model),
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
    fn models_name_the_files_beside_them() {
        let of = |name: &str, text: &str| companions(&NamedBytes::new(name, text));
        assert_eq!(
            of("a.obj", "v 0 0 0\n  mtllib my box.mtl\r\nmtllib sub\\b.mtl\n"),
            ["my box.mtl", "my", "box.mtl", "sub/b.mtl"]
        );
        let gltf = r#"{"asset":{"version":"2.0"},"buffers":[{"uri":"a%20b/c%C3%A9.bin"},{"uri":"data:;base64,AA"},{}]}"#;
        assert_eq!(of("a.gltf", gltf), ["a b/cé.bin"]);
        assert_eq!(of("a.gltf", "{\"asset\": broken"), [""; 0]);
        assert_eq!(of("a.ply", "ply\n"), [""; 0]);
    }
}
