//! Decoding images, and images that come after their model.

use formats::{Image, NamedBytes, Picture, PictureError, PictureSource, is_image};
use image::{ColorType, ExtendedColorType, ImageEncoder, ImageFormat};
use std::io::Cursor;
use std::ops::ControlFlow;

fn image(name: &str, bytes: &[u8]) -> Image {
    Image { name: name.to_owned(), media_type: None, bytes: Some(bytes.into()) }
}

fn decode(name: &str, bytes: &[u8], largest: u32) -> Result<Picture, PictureError> {
    Picture::decode(&PictureSource::of(image(name, bytes)), largest, &mut |_| ControlFlow::Continue(()))
}

#[test]
fn opacity_comes_from_another_image() {
    let colors = encoded(ImageFormat::Png, [2, 2], &[10, 20, 30, 255].repeat(4));
    let both = |color: Option<&[u8]>, alpha: &[u8]| {
        let source = PictureSource {
            color: color.map(|bytes| image("color.png", bytes)),
            alpha: Some(image("alpha.png", alpha)),
        };
        Picture::decode(&source, 8, &mut |_| ControlFlow::Continue(())).expect("pictures")
    };
    let pixels = |picture: &Picture| -> Vec<[u8; 4]> {
        picture.pixels.chunks(4).take(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect()
    };
    // Grey, of another size: black on the left, white on the right.
    let grey: Vec<u8> = (0..16).flat_map(|i| if i % 4 < 2 { [0, 0, 0, 255] } else { [255; 4] }).collect();
    let grey = encoded(ImageFormat::Png, [4, 4], &grey);
    let cut = both(Some(&colors), &grey);
    assert_eq!(cut.size, [2, 2]);
    assert_eq!(pixels(&cut), [[10, 20, 30, 0], [10, 20, 30, 255]].repeat(2));
    // Alpha counts more than brightness.
    let clear: Vec<u8> = (0..4).flat_map(|i| [255, 255, 255, 60 * i]).collect();
    let clear = encoded(ImageFormat::Png, [2, 2], &clear);
    assert_eq!(
        pixels(&both(Some(&colors), &clear)).iter().map(|pixel| pixel[3]).collect::<Vec<_>>(),
        [0, 60, 120, 180]
    );
    // Without colours it is white.
    let white = both(None, &clear);
    assert_eq!(pixels(&white)[1], [255, 255, 255, 60]);
    let damaged =
        PictureSource { color: Some(image("color.png", &colors)), alpha: Some(image("a.png", b"no")) };
    assert!(Picture::decode(&damaged, 8, &mut |_| ControlFlow::Continue(())).is_err());
}

/// Red and green above, blue and a half transparent white below.
const FOUR: [[u8; 4]; 4] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 128]];

fn encoded(format: ImageFormat, size: [u32; 2], pixels: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let [width, height] = size;
    if format == ImageFormat::Jpeg {
        let rgb: Vec<u8> = pixels.chunks(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        let encoder = image::codecs::jpeg::JpegEncoder::new_with_quality(&mut bytes, 100);
        encoder.write_image(&rgb, width, height, ExtendedColorType::Rgb8).expect("a picture");
        return bytes;
    }
    image::write_buffer_with_format(
        &mut Cursor::new(&mut bytes),
        pixels,
        width,
        height,
        ColorType::Rgba8,
        format,
    )
    .expect("a picture");
    bytes
}

#[test]
fn each_kind_is_decoded_from_its_top_left_by_its_content() {
    for (format, name) in [
        (ImageFormat::Png, "a.png"),
        (ImageFormat::WebP, "named.png"),
        (ImageFormat::Bmp, "a.bmp"),
        (ImageFormat::Tga, "a.TGA"),
        (ImageFormat::Png, "no extension"),
    ] {
        let bytes = encoded(format, [2, 2], FOUR.as_flattened());
        let picture = decode(name, &bytes, 4096).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!((picture.size, picture.original), ([2, 2], [2, 2]), "{name}");
        assert_eq!(&picture.pixels[..16], FOUR.as_flattened(), "{name}");
        assert_eq!(picture.pixels.len(), 20, "{name}: the picture and its mean");
    }
    // Its blocks of 8 x 8 hold one colour each.
    let quarters: Vec<u8> = (0..256).flat_map(|i| FOUR[i / 128 * 2 + i % 16 / 8]).collect();
    let picture = decode("a.jpg", &encoded(ImageFormat::Jpeg, [16, 16], &quarters), 4096).expect("a JPEG");
    for (at, expected) in [(0, FOUR[0]), (15, FOUR[1]), (240, FOUR[2])] {
        let pixel = &picture.pixels[at * 4..at * 4 + 4];
        assert!(pixel.iter().zip(expected).all(|(a, b)| a.abs_diff(b) < 30), "{at}: {pixel:?}");
    }
}

#[test]
fn large_pictures_are_shown_smaller_and_bombs_are_refused() {
    let wide = encoded(ImageFormat::Png, [600, 20], &[7; 600 * 20 * 4]);
    let picture = decode("a.png", &wide, 256).expect("large");
    assert_eq!((picture.size, picture.original), ([150, 5], [600, 20]));
    // A PNG that says it is huge, as its first bytes do; what follows doesn't matter.
    let mut bomb = encoded(ImageFormat::Png, [2, 2], FOUR.as_flattened());
    bomb[16..24].copy_from_slice(&[0, 0, 0xff, 0xff, 0, 0, 0xff, 0xff]);
    let crc = crc(&bomb[12..29]);
    bomb[29..33].copy_from_slice(&crc.to_be_bytes());
    let error = decode("a.png", &bomb, 4096).expect_err("a bomb");
    assert!(error.to_string().contains("65535 × 65535 pixels"), "{error}");
}

/// The checksum of a chunk of a PNG.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(
            crc ^ u32::from(*byte),
            |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 },
        )
    })
}

#[test]
fn what_cannot_be_decoded_is_said_in_words() {
    let png = encoded(ImageFormat::Png, [2, 2], FOUR.as_flattened());
    for (name, bytes, expected) in [
        ("a.png", &png[..40], "damaged"),
        ("a.png", &b"\x89PNG\r\n\x1a\n"[..], "damaged"),
        ("a.jpg", &b"\xff\xd8\xff"[..], "damaged"),
        ("a.png", &b""[..], "damaged"),
        ("a.gif", &b"GIF89a"[..], "it is of the kind GIF, and PNG, JPEG, WebP, BMP and TGA can be shown"),
        ("a.dds", &b"DDS "[..], "of the kind DDS"),
        ("a", &b"what?"[..], "no image of a known kind"),
    ] {
        let error = decode(name, bytes, 4096).expect_err(name);
        let PictureError::Unreadable(why) = error else { panic!("{name} was cancelled") };
        assert!(why.contains(expected), "{name}: {why}");
    }
    for cut in 0..png.len() {
        // Without a panic; the last bytes only end the file.
        let _ = decode("a.png", &png[..cut], 4096);
    }
    let absent = Image { name: "a.png".to_owned(), ..Image::default() };
    let error = Picture::decode(&PictureSource::of(absent), 4096, &mut |_| ControlFlow::Continue(()));
    assert_eq!(error, Err(PictureError::Unreadable("its file was not given".to_owned())));
    let image = Image { name: "a.png".to_owned(), media_type: None, bytes: Some(png.into()) };
    let cancelled = Picture::decode(&PictureSource::of(image), 4096, &mut |_| ControlFlow::Break(()));
    assert_eq!(cancelled, Err(PictureError::Cancelled));
}

/// A square with a material that names `wood.png`.
fn model() -> [NamedBytes; 2] {
    [
        NamedBytes::new(
            "a.obj",
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nusemtl wood\nf 1/1 2/1 3/1\n",
        ),
        NamedBytes::new("a.mtl", "newmtl wood\nmap_Kd tex\\wood.png\n"),
    ]
}

#[test]
fn a_missing_image_is_named_and_can_come_later() {
    let mut import = formats::read(&model(), &mut |_| ControlFlow::Continue(())).expect("a model");
    let report = import.report.to_string();
    assert!(
        report.contains("Image files that its materials refer to were not given: tex/wood.png\n"),
        "{report}"
    );
    assert_eq!(import.model.materials.missing_images(), ["tex/wood.png"]);

    let png = encoded(ImageFormat::Png, [2, 2], FOUR.as_flattened());
    let file = NamedBytes::new("WOOD.png", png.clone());
    let other = NamedBytes::new("other.png", png.clone());
    assert!(is_image(&file) && !is_image(&model()[0]) && !is_image(&model()[1]));
    assert_eq!(import.model.materials.take_images(&[other]), [""; 0]);
    assert_eq!(import.model.materials.take_images(&[file]), ["WOOD.png"]);
    assert!(import.model.materials.missing_images().is_empty());
    // What is written then has the image, and reads back with it.
    for code in ["obj", "gltf", "glb", "dae", "ply"] {
        let format = formats::Format::from_code(code).expect("a format");
        let files = formats::write(format, &import.model).expect("written");
        let back = formats::read(&files, &mut |_| ControlFlow::Continue(())).expect("read");
        let images = &back.model.materials.images;
        assert_eq!(images.len(), 1, "{code}");
        assert_eq!(images[0].bytes.as_deref(), Some(png.as_slice()), "{code}");
        assert!(back.report.is_clean(), "{code}: {}", back.report);
    }
}
