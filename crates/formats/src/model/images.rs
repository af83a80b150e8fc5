//! Image files that materials use.

use crate::file::{NamedBytes, find, with_slashes};
use crate::model::texture::Image;

/// The image that a model refers to by this name, with its contents where the file was given.
pub(crate) fn image(name: &str, files: &[NamedBytes]) -> Image {
    let bytes = find(name, files).map(|file| file.bytes.as_slice());
    Image {
        name: with_slashes(name),
        media_type: media_type(name, bytes.unwrap_or_default()),
        bytes: bytes.map(Into::into),
    }
}

/// The media type of an image file: by its content, else by its name.
pub(crate) fn media_type(name: &str, bytes: &[u8]) -> Option<String> {
    let kind = match bytes {
        [0x89, b'P', b'N', b'G', ..] => "png",
        [0xff, 0xd8, 0xff, ..] => "jpeg",
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "webp",
        [b'G', b'I', b'F', b'8', ..] => "gif",
        [0xab, b'K', b'T', b'X', b' ', b'2', b'0', ..] => "ktx2",
        [b'D', b'D', b'S', b' ', ..] => "vnd-ms.dds",
        _ => match name.rsplit_once('.')?.1.to_ascii_lowercase().as_str() {
            "png" => "png",
            "jpg" | "jpeg" => "jpeg",
            "webp" => "webp",
            "gif" => "gif",
            "bmp" => "bmp",
            "tga" => "x-tga",
            "tif" | "tiff" => "tiff",
            "ktx2" => "ktx2",
            "dds" => "vnd-ms.dds",
            _ => return None,
        },
    };
    Some(format!("image/{kind}"))
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

#[cfg(test)]
mod tests {
    use super::*;

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
