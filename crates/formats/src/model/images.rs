//! Image files that materials use.

use crate::file::{NamedBytes, find, with_slashes};
use crate::model::material::Materials;
use crate::model::texture::Image;
use std::collections::{BTreeSet, HashSet};

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
        [_, _, _, _, b'f', b't', b'y', b'p', b'a', b'v', b'i', b'f', ..] => "avif",
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
            "avif" => "avif",
            "dds" => "vnd-ms.dds",
            _ => return None,
        },
    };
    Some(format!("image/{kind}"))
}

/// Whether a file is an image, by its content or else by its name.
pub fn is_image(file: &NamedBytes) -> bool {
    media_type(&file.name, &file.bytes).is_some()
}

impl Materials {
    /// Gives images their contents from the files that they name, also in place of other contents; returns the names of
    /// the files that were taken. Files are found by their paths or else by their names, in upper or lower case.
    pub fn take_images(&mut self, files: &[NamedBytes]) -> Vec<String> {
        let mut taken = Vec::new();
        for image in &mut self.images {
            let Some(file) = find(&image.name, files).filter(|file| is_image(file)) else { continue };
            image.media_type = media_type(&file.name, &file.bytes);
            image.bytes = Some(file.bytes.as_slice().into());
            if !taken.contains(&file.name) {
                taken.push(file.name.clone());
            }
        }
        taken
    }

    /// The names of the images whose contents are not known.
    pub fn missing_images(&self) -> Vec<&str> {
        self.images.iter().filter(|image| image.bytes.is_none()).map(|image| image.name.as_str()).collect()
    }
}

/// The usual extension of image files of a media type.
pub(crate) fn extension_of(media_type: &str) -> Option<&str> {
    Some(match media_type.strip_prefix("image/")? {
        "jpeg" => "jpg",
        "vnd-ms.dds" => "dds",
        "x-tga" => "tga",
        kind @ ("png" | "webp" | "gif" | "ktx2" | "avif" | "bmp" | "tiff") => kind,
        _ => return None,
    })
}

/// The names under which a model refers to its images: the images' own, or, for one whose contents are
/// written, a name in the model's folder that no other file has. `taken` are the names of the model's
/// other files.
pub(crate) fn written_names<'a>(images: &[Image], taken: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let mut taken: HashSet<String> = taken.into_iter().map(str::to_lowercase).collect();
    let name = |image: &Image| {
        if image.bytes.is_none() {
            return image.name.clone();
        }
        let own = if is_inside(&image.name) { image.name.as_str() } else { image.file_name() };
        let own = if is_inside(own) { own } else { "image" };
        let (stem, extension) = match own.rsplit_once('.') {
            Some((stem, extension)) if !extension.contains('/') => (stem, format!(".{extension}")),
            _ => (own, String::new()),
        };
        let numbered = (2..).map(|number: u32| format!("{stem}-{number}{extension}"));
        let mut names = std::iter::once(own.to_owned()).chain(numbered);
        names.find(|name| taken.insert(name.to_lowercase())).unwrap_or_default()
    };
    images.iter().map(name).collect()
}

/// Whether a path stays in its folder.
fn is_inside(path: &str) -> bool {
    !path.contains([':', '\\']) && path.split('/').all(|part| !matches!(part, "" | "." | ".."))
}

/// The images of these numbers as files, under their [`written_names`]; those whose contents are not
/// known are left out.
pub(crate) fn image_files(images: &[Image], names: &[String], used: &BTreeSet<u32>) -> Vec<NamedBytes> {
    let file = |&number: &u32| {
        let bytes = images.get(number as usize)?.bytes.as_ref()?;
        Some(NamedBytes::new(names.get(number as usize)?.as_str(), bytes.to_vec()))
    };
    used.iter().filter_map(file).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_written_into_the_models_folder_under_different_names() {
        let image = |name: &str| Image {
            name: name.to_owned(),
            bytes: Some([1].as_slice().into()),
            ..Image::default()
        };
        let mut images: Vec<Image> =
            ["a.png", "x/b.png", "../b.png", "/B.png", "C:/y/a.png", "..", "", "model.obj", "x.y/z"]
                .map(image)
                .into();
        images.push(Image { name: "../far.png".to_owned(), ..Image::default() });
        let names = written_names(&images, ["Model.obj"]);
        assert_eq!(
            names,
            [
                "a.png",
                "x/b.png",
                "b.png",
                "B-2.png",
                "a-2.png",
                "image",
                "image-2",
                "model-2.obj",
                "x.y/z",
                "../far.png"
            ]
        );
        let files = image_files(&images, &names, &BTreeSet::from([1, 4, 9, 12]));
        assert_eq!(files.iter().map(|file| file.name.as_str()).collect::<Vec<_>>(), ["x/b.png", "a-2.png"]);
    }
}
