//! The pictures of the document's materials: decoded one after the other as jobs, and given to the renderer.

use std::sync::Arc;

use editor::{Document, JobId};
use formats::{AlphaMode, Image, Material, Materials, TextureRole, Wrap};
use glam::{Affine2, Mat2, Vec2};
use halfedge::keys;
use viewport::{ColorBy, Look, MaterialLook, Style};

/// The memory on the graphics card that all pictures of a document may take, in bytes.
const MAX_PICTURE_BYTES: u64 = 512 << 20;
/// The longest side of a picture in pixels: a larger one would take too long to copy from the worker in one frame.
const LARGEST_SIDE: u32 = 4096;
/// The shortest to which pictures shrink however many there are.
const SMALLEST_SIDE: u32 = 256;
/// The alpha from which faces show where a picture is mixed with what lies behind.
const BLEND_CUTOFF: f32 = 0.5;

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

/// An image that materials show.
pub(crate) struct Known {
    bytes: Arc<[u8]>,
    /// The picture's number in the renderer.
    pub number: u64,
    pub state: State,
}

impl Known {
    /// The image of the document that it is.
    pub fn image<'m>(&self, materials: &'m Materials) -> Option<&'m Image> {
        let is_it =
            |image: &&Image| image.bytes.as_ref().is_some_and(|bytes| Arc::ptr_eq(bytes, &self.bytes));
        materials.images.iter().find(is_it)
    }
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
        Some(&self.find(image)?.state)
    }

    fn find(&self, image: &Image) -> Option<&Known> {
        let bytes = image.bytes.as_ref()?;
        self.known.iter().find(|known| Arc::ptr_eq(&known.bytes, bytes))
    }

    /// Forgets the images that the document no longer shows, and takes in those that it does now.
    fn follow(&mut self, materials: &Materials) {
        let shown: Vec<&Arc<[u8]>> =
            shown_images(materials).filter_map(|image| image.bytes.as_ref()).collect();
        self.known.retain(|known| shown.iter().any(|bytes| Arc::ptr_eq(bytes, &known.bytes)));
        for bytes in shown {
            if !self.known.iter().any(|known| Arc::ptr_eq(bytes, &known.bytes)) {
                self.last_number += 1;
                self.known.push(Known {
                    bytes: bytes.clone(),
                    number: self.last_number,
                    state: State::Waiting,
                });
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
        let texture = material.texture(TextureRole::BaseColor)?;
        let known = self.find(materials.image(texture)?)?;
        if matches!(known.state, State::Failed(_)) {
            return None;
        }
        Some(viewport::Texture {
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
                Some(AlphaMode::Opaque) | None => 0.0,
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
        let are_there = has_textures(document);
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

/// The images that materials show as their base colour, each once.
fn shown_images(materials: &Materials) -> impl Iterator<Item = &Image> {
    let is_shown = |number: usize| {
        let mut textures = materials.list.iter().filter_map(|m| m.texture(TextureRole::BaseColor));
        textures.any(|texture| texture.image as usize == number)
    };
    materials.images.iter().enumerate().filter(move |(number, _)| is_shown(*number)).map(|(_, image)| image)
}

/// Whether objects have texture coordinates.
pub(crate) fn has_uvs(document: &Document) -> bool {
    document.objects().iter().any(|object| object.mesh().attribute(keys::CORNER_UV).is_some())
}

/// Whether the document has textures to show.
pub(crate) fn has_textures(document: &Document) -> bool {
    shown_images(document.materials()).any(|image| image.bytes.is_some()) && has_uvs(document)
}
