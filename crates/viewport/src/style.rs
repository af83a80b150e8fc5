//! The viewport's style and colours.

use crate::{ColorBy, Mark, Marks, Matcap, Shading};
use halfedge::Color;

/// How objects are shaded, and what else is drawn. Colours are sRGB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// Which normals shade faces.
    pub shading: Shading,
    /// What gives faces their colours.
    pub color_by: ColorBy,
    /// Whether the active object's edges are drawn over its faces.
    pub wireframe: bool,
    /// Whether the active object's vertices are drawn as dots.
    pub vertices: bool,
    /// Whether surfaces are translucent, so that what is behind them shows.
    pub x_ray: bool,
    /// How faces are shaded.
    pub look: Look,
    /// Whether the back sides of faces are left out.
    pub cull: bool,
    /// What is marked.
    pub marks: Marks,
    /// Whether the grid of the ground is drawn.
    pub grid: bool,
    /// Whether objects cast a soft shadow on the ground.
    pub shadow: bool,
    /// The colours.
    pub theme: Theme,
}

/// How faces are shaded. All lights are fixed to the camera, so that what one looks at is lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// A key light from the upper left, a weaker one from the right, a rim light from behind, and a sky that is
    /// brighter than the ground.
    #[default]
    Studio,
    /// The pictures of materials in soft studio light. Faces without one show their colour.
    Texture,
    /// One light at the camera over an ambient light of a fifth (Lambert), as in the courses' viewers.
    Course,
    /// As a sphere of some material looks under studio lights.
    Matcap(Matcap),
    /// Stripes that the surface mirrors: they break where it isn't tangent continuous, and kink where its curvature
    /// isn't continuous.
    Zebra,
    /// The colours themselves, without light.
    Flat,
    /// Faces like the background hide the edges behind them.
    HiddenLine,
    /// Normals as colours: x red, y green, z blue.
    Normals,
    /// Front faces blue, back faces red.
    Orientation,
    /// A chequered pattern where faces have texture coordinates: how these stretch and turn.
    Checker,
}

impl Look {
    /// All, in the order of menus.
    pub const ALL: [Self; 13] = [
        Self::Studio,
        Self::Texture,
        Self::Course,
        Self::Matcap(Matcap::Clay),
        Self::Matcap(Matcap::Pearl),
        Self::Matcap(Matcap::Metal),
        Self::Matcap(Matcap::RedWax),
        Self::Zebra,
        Self::Flat,
        Self::HiddenLine,
        Self::Normals,
        Self::Orientation,
        Self::Checker,
    ];

    /// The name in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Studio => "studio",
            Self::Texture => "texture",
            Self::Course => "course",
            Self::Matcap(Matcap::Clay) => "clay",
            Self::Matcap(Matcap::Pearl) => "pearl",
            Self::Matcap(Matcap::Metal) => "metal",
            Self::Matcap(Matcap::RedWax) => "red-wax",
            Self::Zebra => "zebra",
            Self::Flat => "flat",
            Self::HiddenLine => "hidden-line",
            Self::Normals => "normals",
            Self::Orientation => "orientation",
            Self::Checker => "uv-checker",
        }
    }

    /// The matcap that faces show.
    pub fn matcap(self) -> Option<Matcap> {
        match self {
            Self::Matcap(matcap) => Some(matcap),
            _ => None,
        }
    }
}

impl Style {
    /// Whether faces show what lies at their texture coordinates. Textures belong to the paint: colours that stand for
    /// something else take their place.
    pub(crate) fn wants_uvs(&self) -> bool {
        match self.look {
            Look::Texture => self.color_by == ColorBy::Paint,
            Look::Checker => true,
            _ => false,
        }
    }
}

impl Default for Style {
    fn default() -> Self {
        Self {
            look: Look::Studio,
            x_ray: false,
            cull: false,
            marks: Marks::default(),
            shading: Shading::default(),
            color_by: ColorBy::default(),
            wireframe: true,
            vertices: false,
            grid: true,
            shadow: true,
            theme: Theme::DARK,
        }
    }
}

/// The colours of everything except the faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Theme {
    /// The background at the top of the viewport.
    pub background_top: Color,
    /// The background at the bottom.
    pub background_bottom: Color,
    /// Wireframe edges.
    pub edge: Color,
    /// Vertex dots.
    pub vertex: Color,
    /// Dots of isolated vertices and hidden-line edges, which are seen against the background.
    pub isolated: Color,
    /// Lines of the ground grid.
    pub grid: Color,
    /// The shadow on the ground.
    pub shadow: Color,
    /// How dark the shadow is where a face touches the ground, from 0 to 1.
    pub shadow_strength: f32,
    /// The tint of back faces, mixed in at half strength after darkening to seven tenths.
    pub back_face: Color,
    /// Selected elements.
    pub selected: Color,
    /// The selected element that was selected last.
    pub active: Color,
    /// The element under the pointer.
    pub hovered: Color,
}

impl Theme {
    /// The colour of marks, which are seen on faces more than on the background.
    pub fn mark(mark: Mark) -> Color {
        match mark {
            Mark::Boundary => Color([0x00, 0xa3, 0x4e]),
            Mark::Sharp => Color([0x1f, 0x5c, 0xff]),
            Mark::Seam => Color([0xe8, 0x2c, 0x22]),
            Mark::NonManifold => Color([0xe0, 0x12, 0xbd]),
            Mark::FaceNormals => Color([0x10, 0x9c, 0xb8]),
            Mark::VertexNormals => Color([0x8a, 0x5c, 0xf0]),
        }
    }

    /// Light lines on a dark gradient.
    pub const DARK: Self = Self {
        background_top: Color([0x3a, 0x3f, 0x47]),
        background_bottom: Color([0x1d, 0x20, 0x25]),
        edge: Color([0x12, 0x14, 0x18]),
        vertex: Color([0x12, 0x14, 0x18]),
        isolated: Color([0xd5, 0xdb, 0xe3]),
        grid: Color([0x8a, 0x93, 0xa0]),
        shadow: Color([0x05, 0x06, 0x08]),
        shadow_strength: 0.75,
        back_face: Color([0x50, 0x64, 0xb4]),
        selected: Color([0xff, 0x8c, 0x1a]),
        active: Color([0xff, 0xf6, 0xe6]),
        hovered: Color([0x4f, 0xd8, 0xff]),
    };
    /// Dark lines on a light gradient.
    pub const LIGHT: Self = Self {
        background_top: Color([0xf4, 0xf6, 0xf9]),
        background_bottom: Color([0xdd, 0xe2, 0xe9]),
        edge: Color([0x1e, 0x22, 0x28]),
        vertex: Color([0x1e, 0x22, 0x28]),
        isolated: Color([0x1e, 0x22, 0x28]),
        grid: Color([0x5d, 0x66, 0x73]),
        shadow: Color([0x22, 0x2a, 0x3a]),
        shadow_strength: 0.5,
        back_face: Color([0x50, 0x64, 0xb4]),
        selected: Color([0xd4, 0x58, 0x00]),
        active: Color([0xff, 0xfa, 0xf0]),
        hovered: Color([0x00, 0x82, 0xc4]),
    };
}
