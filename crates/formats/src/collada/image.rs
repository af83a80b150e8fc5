//! Images: files that effects refer to, or bytes in the document.

use super::xml::{Document, Node};
use crate::file::NamedBytes;
use crate::model::images;
use crate::model::texture::Image;
use crate::text::print::percent_decoded;

/// The image of an `<image>` element, with its contents where the document or one of `files` has them.
///
/// # Errors
/// In words, where it refers to nothing.
pub(super) fn read(document: &Document, image: &Node, files: &[NamedBytes]) -> Result<Image, String> {
    let init = document.child(image, "init_from");
    let hex = document.child(image, "data").or_else(|| document.child(init?, "hex"));
    if let Some(bytes) = hex.and_then(|hex| from_hex(hex.text())) {
        let media_type = images::media_type("", &bytes);
        let extension = media_type.as_deref().and_then(|kind| kind.strip_prefix("image/"));
        let extension = extension.map_or(String::new(), |kind| format!(".{}", kind.replace("jpeg", "jpg")));
        return Ok(Image {
            name: format!("{}{extension}", image.label().replace(['/', '\\'], "_")),
            media_type,
            bytes: Some(bytes.into()),
        });
    }
    let name = name(document, image).ok_or("it names no file")?;
    Ok(images::image(&name, files))
}

/// The names of the files that a document's images are in.
pub(super) fn names(document: &Document) -> Vec<String> {
    document.all("image").filter_map(|image| name(document, image)).collect()
}

/// The path in an image's address.
fn name(document: &Document, image: &Node) -> Option<String> {
    // COLLADA 1.5 has the address one element deeper.
    let init = document.child(image, "init_from")?;
    let address = document.child(init, "ref").unwrap_or(init).word();
    let path = ["file:///", "file://", "./"].iter().find_map(|start| address.strip_prefix(start));
    let path = path.unwrap_or(&address);
    // "/C:/a.png" is on a drive, and nothing is above the root.
    let is_relative = |rest: &&str| rest.get(1..2) == Some(":") || rest.starts_with("../");
    let path = path.strip_prefix('/').filter(is_relative).unwrap_or(path);
    (!path.is_empty()).then(|| percent_decoded(path).replace('\\', "/"))
}

/// Bytes out of hexadecimal digits with blanks anywhere; none where there is anything else.
fn from_hex(text: &[u8]) -> Option<Vec<u8>> {
    let digits = text.iter().filter(|byte| !byte.is_ascii_whitespace());
    let digits: Vec<u8> = digits
        .map(|&digit| char::from(digit).to_digit(16).map(|digit| digit as u8))
        .collect::<Option<_>>()?;
    let (pairs, rest) = digits.as_chunks::<2>();
    (rest.is_empty() && !pairs.is_empty()).then(|| pairs.iter().map(|[high, low]| high * 16 + low).collect())
}
