//! The pictures of the document's materials: decoded one after the other as jobs, and given to the renderer.

use std::sync::Arc;

use editor::{Document, JobId};
use formats::{AlphaMode, Image, Material, Materials, PictureSource, TextureRole, Wrap};
use glam::{Affine2, Mat2, Vec2};
use halfedge::keys;
use viewport::{ColorBy, Look, MaterialLook, Style};

/// The memory on the graphics card that all pictures of a document may take, in bytes.
const MAX_PICTURE_BYTES: u64 = 512 << 20;
/// The longest side of a picture in pixels: a larger one would take too long to copy from the worker in one frame.
const LARGEST_SIDE: u32 = 4096;
/// The shortest to which pictures shrink however many there are.
const SMALLEST_SIDE: u32 = 256;
/// The alpha from which faces show where a picture is mixed with what lies behind, or where nothing says what alpha means:
/// cut out, leaves and grids look right from every side without being sorted.
const BLEND_CUTOFF: f32 = 0.5;
/// Materials are at least so opaque: some files say that everything is invisible.
const MIN_OPACITY: f32 = 0.1;

/// What is known of an image.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum State {
    /// It waits to be decoded.
    Waiting,
    Decoding(JobId),
    /// It is shown; its size in the file.
    Shown([u32; 2]),
    /// Why it can't be shown.
    Failed(String),
}

/// The contents of the images that a picture is made of: of its colours and of its opacity.
type Contents = [Option<Arc<[u8]>>; 2];

/// A picture that materials show.
pub(crate) struct Known {
    contents: Contents,
    /// The picture's number in the renderer.
    pub number: u64,
    pub state: State,
}

impl Known {
    /// The images of the document that it is made of.
    pub fn source(&self, materials: &Materials) -> PictureSource {
        let [color, alpha] = self.contents.each_ref().map(|bytes| {
            let has_them = |image: &&Image| is_same(image.bytes.as_ref(), bytes.as_ref());
            materials.images.iter().filter(|image| image.bytes.is_some()).find(has_them).cloned()
        });
        PictureSource { color, alpha }
    }
}

fn is_same(a: Option<&Arc<[u8]>>, b: Option<&Arc<[u8]>>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        (a, b) => a.is_none() && b.is_none(),
    }
}

fn are_same(a: &Contents, b: &Contents) -> bool {
    a.iter().zip(b).all(|(a, b)| is_same(a.as_ref(), b.as_ref()))
}

/// The contents of the images that a material shows; none if there are none, or they are missing.
fn contents(materials: &Materials, material: &Material) -> Option<Contents> {
    let of = |role| {
        let image = material.texture(role).and_then(|texture| materials.image(texture));
        image.and_then(|image| image.bytes.clone())
    };
    let color = of(TextureRole::BaseColor);
    // An image whose own alpha is meant is no other one.
    let alpha = of(TextureRole::Alpha).filter(|alpha| !is_same(Some(alpha), color.as_ref()));
    (color.is_some() || alpha.is_some()).then_some([color, alpha])
}

/// The pictures of the document's materials.
#[derive(Default)]
pub(crate) struct Textures {
    pub known: Vec<Known>,
    last_number: u64,
    /// Whether the document has textures to show.
    are_there: bool,
    /// The look before that of a document with textures was chosen for it.
    look_before: Option<Look>,
}

impl Textures {
    /// What is known of an image; none if no material shows it, or its contents are missing.
    pub fn state(&self, image: &Image) -> Option<&State> {
        let bytes = image.bytes.as_ref()?;
        let first = |known: &&Known| {
            let [color, alpha] = &known.contents;
            is_same(color.as_ref().or(alpha.as_ref()), Some(bytes))
        };
        Some(&self.known.iter().find(first)?.state)
    }

    /// Forgets the images that the document no longer shows, and takes in those that it does now.
    fn follow(&mut self, materials: &Materials) {
        let shown: Vec<Contents> =
            materials.list.iter().filter_map(|material| contents(materials, material)).collect();
        self.known.retain(|known| shown.iter().any(|contents| are_same(contents, &known.contents)));
        for contents in shown {
            if !self.known.iter().any(|known| are_same(&contents, &known.contents)) {
                self.last_number += 1;
                self.known.push(Known { contents, number: self.last_number, state: State::Waiting });
            }
        }
    }

    /// Has the shown pictures decoded again, for another device.
    pub fn decode_again(&mut self) {
        for known in &mut self.known {
            if matches!(known.state, State::Shown(_)) {
                known.state = State::Waiting;
            }
        }
    }

    /// How the renderer draws the materials.
    pub fn looks(&self, materials: &Materials) -> viewport::Materials {
        viewport::Materials::new(materials.list.iter().map(|material| MaterialLook {
            name: material.name.clone(),
            color: material.color(),
            texture: self.texture(materials, material),
        }))
    }

    fn texture(&self, materials: &Materials, material: &Material) -> Option<viewport::Texture> {
        let opacity = opacity(material);
        let plain = (opacity < 1.0).then(|| viewport::Texture::plain(opacity));
        let Some(contents) = contents(materials, material) else { return plain };
        let of_color = material.texture(TextureRole::BaseColor).filter(|_| contents[0].is_some());
        let Some(texture) = of_color.or_else(|| material.texture(TextureRole::Alpha)) else { return plain };
        let known = self.known.iter().find(|known| are_same(&contents, &known.contents));
        let Some(known) = known.filter(|known| !matches!(known.state, State::Failed(_))) else {
            return plain;
        };
        Some(viewport::Texture {
            opacity,
            picture: known.number,
            wrap: texture.wrap.map(|wrap| match wrap {
                Wrap::Repeat => viewport::Wrap::Repeat,
                Wrap::Mirror => viewport::Wrap::Mirror,
                Wrap::Clamp => viewport::Wrap::Clamp,
            }),
            transform: texture.transform.map_or(Affine2::IDENTITY, |transform| {
                // As in glTF's KHR_texture_transform: scaled, then turned counter-clockwise, v from the top.
                let turn = Mat2::from_angle(-transform.rotation);
                let scale = Mat2::from_diagonal(Vec2::from_array(transform.scale));
                Affine2::from_mat2_translation(turn * scale, Vec2::from_array(transform.offset))
            }),
            cutoff: match material.alpha_mode {
                Some(AlphaMode::Mask { cutoff }) => cutoff,
                Some(AlphaMode::Blend) => BLEND_CUTOFF,
                Some(AlphaMode::Opaque) => 0.0,
                None if has_alpha(material) => BLEND_CUTOFF,
                None => 0.0,
            },
        })
    }

    /// The longest side in pixels that pictures may have for all of them to fit into memory.
    pub fn largest_side(&self) -> u32 {
        let fits = |side: u32| {
            let bytes = u64::from(side) * u64::from(side) * 16 / 3;
            bytes * self.known.len() as u64 <= MAX_PICTURE_BYTES
        };
        let mut side = LARGEST_SIDE;
        while side > SMALLEST_SIDE && !fits(side) {
            side /= 2;
        }
        side
    }

    /// Updates what is known and the style to the document's materials; returns their looks. A document with textures
    /// shows them; without, the look is again the one before.
    pub fn follow_document(&mut self, style: &mut Style, document: &Document) -> viewport::Materials {
        self.follow(document.materials());
        let is_translucent = |material: &Material| opacity(material) < 1.0;
        let are_there = has_textures(document) || document.materials().list.iter().any(is_translucent);
        if are_there && !self.are_there && style.look != Look::Texture {
            self.look_before = Some(style.look);
            style.look = Look::Texture;
        } else if !are_there {
            style.look = self.chosen_look(style);
            self.look_before = None;
        }
        self.are_there = are_there;
        self.looks(document.materials())
    }

    /// Whether a picture is one of those that the document shows.
    pub fn shows(&self, number: u64) -> bool {
        self.known.iter().any(|known| known.number == number)
    }

    /// Takes a look that the user chose. Textures are part of the paint.
    pub fn choose_look(&mut self, style: &mut Style, look: Look) {
        self.look_before = None;
        style.look = look;
        if look == Look::Texture {
            style.color_by = ColorBy::Paint;
        }
    }

    /// The look that counts as the user's choice.
    pub fn chosen_look(&self, style: &Style) -> Look {
        self.look_before.filter(|_| style.look == Look::Texture).unwrap_or(style.look)
    }
}

/// Whether the alpha of a material's picture is its opacity, though the file says nothing of that: MTL has no other meaning
/// for it.
fn has_alpha(material: &Material) -> bool {
    material.mtl.is_some() || material.texture(TextureRole::Alpha).is_some()
}

/// How opaque a material is apart from its picture.
fn opacity(material: &Material) -> f32 {
    match (material.alpha_mode, material.alpha) {
        (Some(AlphaMode::Opaque | AlphaMode::Mask { .. }), _) | (_, None) => 1.0,
        (_, Some(alpha)) => alpha.clamp(MIN_OPACITY, 1.0),
    }
}

/// Whether objects have texture coordinates.
pub(crate) fn has_uvs(document: &Document) -> bool {
    document.objects().iter().any(|object| object.mesh().attribute(keys::CORNER_UV).is_some())
}

/// Whether the document has textures to show.
pub(crate) fn has_textures(document: &Document) -> bool {
    let materials = document.materials();
    materials.list.iter().any(|material| contents(materials, material).is_some()) && has_uvs(document)
}
