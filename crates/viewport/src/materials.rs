//! What the document's materials look like: their colours, and the pictures that they show.

use glam::{Affine2, Vec2};
use halfedge::Color;
use std::collections::HashMap;

/// How a material is drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaterialLook {
    /// Its name, to which the labels of faces refer.
    pub name: String,
    /// Its colour. A face in its material's colour isn't painted.
    pub color: Option<Color>,
    /// What its faces show besides their colour, where they have texture coordinates.
    pub texture: Option<Texture>,
}

/// A picture and how it lies on faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texture {
    /// The picture, as given to [`Renderer::set_picture`](crate::Renderer::set_picture).
    pub picture: u64,
    /// What lies beyond its edges along u and v.
    pub wrap: [Wrap; 2],
    /// How texture coordinates are moved before the picture is looked up. Here v counts from its top.
    pub transform: Affine2,
    /// Faces are cut away where the picture's alpha is less; 0 keeps all.
    pub cutoff: f32,
    /// Below 1, what lies behind shows through the faces.
    pub opacity: f32,
}

/// The picture of faces that show none.
const NO_PICTURE: u64 = u64::MAX;

impl Texture {
    /// A picture that repeats.
    pub fn new(picture: u64) -> Self {
        let transform = Affine2::IDENTITY;
        Self { picture, wrap: [Wrap::Repeat; 2], transform, cutoff: 0.0, opacity: 1.0 }
    }

    /// No picture: faces that show their colour, of this opacity. They need no texture coordinates.
    pub fn plain(opacity: f32) -> Self {
        Self { opacity, ..Self::new(NO_PICTURE) }
    }

    fn is_plain(&self) -> bool {
        self.picture == NO_PICTURE
    }

    fn is_translucent(&self) -> bool {
        self.opacity < 1.0
    }
}

/// What lies beyond a picture's edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The picture again.
    #[default]
    Repeat,
    /// The picture mirrored.
    Mirror,
    /// The pixels of its edge.
    Clamp,
}

/// The looks of a document's materials by name.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Materials {
    by_name: HashMap<String, (Option<Color>, Option<u16>)>,
    textures: Vec<Texture>,
}

impl Materials {
    /// Of several of one name the first counts.
    pub fn new(looks: impl IntoIterator<Item = MaterialLook>) -> Self {
        let mut all = Self::default();
        for MaterialLook { name, color, texture } in looks {
            let number = texture.and_then(|texture| all.number(texture));
            all.by_name.entry(name).or_insert((color, number));
        }
        all
    }

    /// The number of a texture, which materials that are drawn alike share; none if there are too many.
    fn number(&mut self, texture: Texture) -> Option<u16> {
        let known = self.textures.iter().position(|known| *known == texture);
        let number = known.unwrap_or(self.textures.len());
        if number > MAX_TEXTURES {
            return None;
        }
        if known.is_none() {
            self.textures.push(texture);
        }
        Some(number as u16)
    }

    /// Whether what lies behind faces of a texture shows through.
    pub(crate) fn is_translucent(&self, texture: u16) -> bool {
        self.textures.get(usize::from(texture)).is_some_and(Texture::is_translucent)
    }

    /// Whether a texture is of faces that show no picture.
    pub(crate) fn is_plain(&self, texture: u16) -> bool {
        self.textures.get(usize::from(texture)).is_some_and(Texture::is_plain)
    }

    /// The textures, by their numbers.
    pub(crate) fn textures(&self) -> &[Texture] {
        &self.textures
    }

    /// The colour of a material.
    pub(crate) fn color(&self, name: &str) -> Option<Color> {
        self.by_name.get(name)?.0
    }

    /// The number of a material's texture.
    pub(crate) fn texture(&self, name: &str) -> Option<u16> {
        self.by_name.get(name)?.1
    }
}

/// Textures that one draw can show.
pub(crate) const TEXTURES_PER_DRAW: usize = 8;
/// More textures than this are left out: their numbers have to fit into a corner's mark.
const MAX_TEXTURES: usize = 10_000;

const BLACK: Color = Color([0; 3]);
const WHITE: Color = Color([255; 3]);

/// The texture of one face.
pub(crate) struct FaceTexture {
    /// What its corners say of it: 0 if it has no texture coordinates, 1 if it shows no texture, from 2 the number of
    /// its texture. `textured.wgsl` has the same numbers.
    pub mark: i16,
    /// The colour that stands for no colour, so that the texture shows as it is.
    blank: Option<Color>,
}

impl FaceTexture {
    /// Without texture coordinates.
    pub const NONE: Self = Self { mark: 0, blank: None };

    /// With texture coordinates, and the colour and texture of the face's material.
    pub fn of(color: Option<Color>, texture: Option<u16>) -> Self {
        let Some(number) = texture else { return Self { mark: 1, blank: None } };
        let blank = match color {
            None => Color::UNPAINTED,
            // Some programs write black where a texture gives the colour.
            Some(BLACK) => BLACK,
            Some(_) => WHITE,
        };
        Self { blank: Some(blank), ..Self::plain(number) }
    }

    /// With a texture that is no picture.
    pub fn plain(number: u16) -> Self {
        Self { mark: 2 + number as i16, blank: None }
    }

    /// What the texture is multiplied by at a corner of this colour.
    pub fn tint(&self, color: [u8; 3]) -> [u8; 3] {
        if self.blank == Some(Color(color)) { WHITE.0 } else { color }
    }
}

/// Missing texture coordinates, as `textured.wgsl` knows them.
pub(crate) const MISSING_UV: [f32; 2] = [-1e9; 2];

/// Texture coordinates as the graphics card has them: v counts from the top.
pub(crate) fn from_top(uv: Vec2) -> [f32; 2] {
    if uv.is_nan() { MISSING_UV } else { [uv.x, 1.0 - uv.y] }
}
