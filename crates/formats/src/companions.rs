//! Companion files: files that a model needs besides itself, such as an OBJ's material libraries, their
//! images, and a glTF's buffers.

use crate::collada;
use crate::format::{Format, is_material_library};
use crate::gltf;
use crate::import::NamedBytes;
use crate::material::Image;
use crate::obj;

/// The names of the files that a model or a material library says it needs, as it has them, with folders:
/// relative to its own. A line of an OBJ that may mean one name with blanks or several gives all of
/// them, so not every name need be there. A companion may have companions of its own. Costs a pass over
/// the file.
pub fn companions(file: &NamedBytes) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut add = |name: &str| {
        let name = slashed(name.trim());
        if !name.is_empty() && !names.contains(&name) {
            names.push(name);
        }
    };
    if is_material_library(file) {
        obj::mtl::image_names(file).iter().for_each(|name| add(name));
        return names;
    }
    match Format::detect(file) {
        Some(Format::Obj) => {
            let lines = file.bytes.split(|&b| b == b'\n').map(<[u8]>::trim_ascii_start);
            for rest in lines.filter_map(|line| line.strip_prefix(b"mtllib")) {
                let rest = String::from_utf8_lossy(rest);
                add(&rest);
                rest.split_whitespace().for_each(&mut add);
            }
        }
        Some(Format::Collada) => collada::companions(file).iter().for_each(|name| add(name)),
        Some(Format::Gltf | Format::Glb) => gltf::buffer_names(file).iter().for_each(|name| add(name)),
        _ => {}
    }
    names
}

/// A path with `/` between folders.
fn slashed(path: &str) -> String {
    path.replace('\\', "/")
}

/// The given file that a model refers to by this name: the one at that path, or else the one of that
/// name in any folder, in upper or lower case.
pub(crate) fn find<'a>(name: &str, files: &'a [NamedBytes]) -> Option<&'a NamedBytes> {
    let name = slashed(name);
    let base = |path: &str| path.rsplit(['/', '\\']).next().unwrap_or(path).to_lowercase();
    let exact = files.iter().find(|file| slashed(&file.name) == name);
    exact.or_else(|| files.iter().find(|file| base(&file.name) == base(&name)))
}

/// The image that a model refers to by this name, with its contents where the file was given.
pub(crate) fn image(name: &str, files: &[NamedBytes]) -> Image {
    let bytes = find(name, files).map(|file| file.bytes.as_slice());
    Image {
        name: slashed(name),
        media_type: Image::media_type_of(name, bytes.unwrap_or_default()),
        bytes: bytes.map(Into::into),
    }
}

/// The images whose contents are known as files beside a model, under the names by which it refers to
/// them. An image outside the model's folder is left out.
pub(crate) fn image_files<'a>(images: impl Iterator<Item = &'a Image>) -> Vec<NamedBytes> {
    let is_inside = |name: &str| {
        !name.is_empty()
            && !name.contains(':')
            && name.split('/').all(|part| !part.is_empty() && part != "." && part != "..")
    };
    let mut files: Vec<NamedBytes> = Vec::new();
    for image in images.filter(|image| is_inside(&image.name)) {
        if let Some(bytes) = &image.bytes
            && !files.iter().any(|file| file.name == image.name)
        {
            files.push(NamedBytes::new(image.name.as_str(), bytes.to_vec()));
        }
    }
    files
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

    #[test]
    fn images_are_written_only_inside_the_models_folder() {
        let image = |name: &str| Image {
            name: name.to_owned(),
            bytes: Some([1].as_slice().into()),
            ..Image::default()
        };
        let images = ["a.png", "x/b.png", "../c.png", "/d.png", "C:/e.png", "", "a.png"].map(image);
        let without = Image { name: "f.png".to_owned(), ..Image::default() };
        let names: Vec<String> =
            image_files(images.iter().chain([&without])).into_iter().map(|file| file.name).collect();
        assert_eq!(names, ["a.png", "x/b.png"]);
    }
}
