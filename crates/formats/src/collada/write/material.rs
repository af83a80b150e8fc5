//! Writing materials: effects of the common profile, with what it has no place for in extra data.
//!
//! Extra data follows other programs where they have something: FCollada's bump maps, Google Earth's double
//! sided faces, Maya's repeats and offsets, 3ds Max's amounts. Colours under textures and rotated textures
//! go to Meshwright's own.

use super::escape::escape;
use crate::collada::effect::OWN_PROFILE;
use crate::file::NamedBytes;
use crate::model::Model;
use crate::model::images::{image_files, written_names};
use crate::model::material::{Material, Property, Rgb};
use crate::model::paint::{own_colors, painted};
use crate::model::texture::{Image, Texture, TextureRole, UvTransform, Wrap};
use crate::text::print::percent_encoded;
use halfedge::Color;
use std::collections::{BTreeSet, HashMap};

/// Whether COLLADA files hold this property of a material.
pub(crate) fn keeps(property: Property) -> bool {
    match property {
        Property::BaseColor
        | Property::Alpha
        | Property::Emissive
        | Property::Specular
        | Property::Ambient
        | Property::Shininess
        | Property::IndexOfRefraction
        | Property::DoubleSided => true,
        Property::Texture(role) => channel(role).is_some(),
        Property::Metallic | Property::Roughness | Property::AlphaMode | Property::MtlStatements => false,
    }
}

/// The element that a texture is in.
fn channel(role: TextureRole) -> Option<&'static str> {
    Some(match role {
        TextureRole::Emissive => "emission",
        TextureRole::Ambient => "ambient",
        TextureRole::BaseColor => "diffuse",
        TextureRole::Specular => "specular",
        TextureRole::Reflection => "reflective",
        TextureRole::Alpha => "transparent",
        TextureRole::Bump | TextureRole::Normal => "bump",
        _ => return None,
    })
}

/// A material as it is written.
struct Entry<'a> {
    name: String,
    /// The colour of its faces; none where they have none.
    color: Option<Color>,
    /// What is known of it besides.
    known: Option<&'a Material>,
}

/// The materials that faces have so far, each once.
pub(super) struct Materials<'a> {
    list: Vec<Entry<'a>>,
    numbers: HashMap<(String, Option<Color>), usize>,
    /// The colours that go under materials' own names.
    own: HashMap<String, Color>,
    /// What is known of materials, by name.
    known: HashMap<&'a str, &'a Material>,
    images: &'a [Image],
    /// The names that images are written under.
    image_names: Vec<String>,
}

impl<'a> Materials<'a> {
    pub(super) fn of(model: &'a Model) -> Self {
        let mut known = HashMap::new();
        for material in &model.materials.list {
            known.entry(material.name.as_str()).or_insert(material);
        }
        Self {
            list: Vec::new(),
            numbers: HashMap::new(),
            own: own_colors(model, str::to_owned),
            known,
            images: &model.materials.images,
            image_names: written_names(&model.materials.images, [format!("{}.dae", model.name).as_str()]),
        }
    }

    /// The number of the material for faces with this label and colour.
    pub(super) fn number(&mut self, label: &str, color: Option<Color>) -> usize {
        let key = (label.to_owned(), color);
        if let Some(&number) = self.numbers.get(&key) {
            return number;
        }
        let number = self.list.len();
        // A material whose faces differ in colour becomes several, named so that they read back as
        // one.
        let name = match color {
            Some(color) if self.own.get(label) != Some(&color) => painted(label, color),
            _ => label.to_owned(),
        };
        self.list.push(Entry { name, color, known: self.known.get(label).copied() });
        self.numbers.insert(key, number);
        number
    }

    /// The element that binds a material to an instance.
    pub(super) fn instance(&self, number: usize) -> String {
        let known = self.list.get(number).and_then(|entry| entry.known);
        let sets: BTreeSet<u32> =
            known.into_iter().flat_map(|known| &known.textures).map(|texture| texture.uv_set).collect();
        let inputs: String = sets
            .iter()
            .map(|set| {
                format!(
                    "<bind_vertex_input semantic=\"UVSET{set}\" input_semantic=\"TEXCOORD\" input_set=\"{set}\"/>"
                )
            })
            .collect();
        format!(
            "<instance_material symbol=\"material{number}\" target=\"#material{number}\">{inputs}</instance_material>"
        )
    }

    /// The textures that are written, each with the image that it shows.
    fn textures(&self) -> impl Iterator<Item = &'a Texture> + '_ {
        let known = self.list.iter().filter_map(|entry| entry.known);
        known.flat_map(|known| &known.textures).filter(|texture| self.is_kept(texture))
    }

    fn is_kept(&self, texture: &Texture) -> bool {
        channel(texture.role).is_some() && self.images.get(texture.image as usize).is_some()
    }

    /// The images of the textures that are written.
    pub(super) fn image_files(&self) -> Vec<NamedBytes> {
        let used = self.textures().map(|texture| texture.image).collect();
        image_files(self.images, &self.image_names, &used)
    }

    /// The libraries of images, effects and materials; nothing where no face has a material.
    pub(super) fn libraries(&self) -> String {
        if self.list.is_empty() {
            return String::new();
        }
        let used: BTreeSet<u32> = self.textures().map(|texture| texture.image).collect();
        let images = used.into_iter().filter_map(|number| {
            let image = self.images.get(number as usize)?;
            let address = address(self.image_names.get(number as usize)?);
            let name = escape(image.file_name());
            Some(format!(
                "<image id=\"image{number}\" name=\"{name}\"><init_from>{address}</init_from></image>\n"
            ))
        });
        let images: String = images.collect();
        let mut out = match images.is_empty() {
            true => String::new(),
            false => format!("<library_images>\n{images}</library_images>\n"),
        };
        out += "<library_effects>\n";
        for (number, entry) in self.list.iter().enumerate() {
            out += &self.effect(number, entry);
        }
        out += "</library_effects>\n<library_materials>\n";
        for (number, entry) in self.list.iter().enumerate() {
            let name = escape(&entry.name);
            out += &format!(
                "<material id=\"material{number}\" name=\"{name}\"><instance_effect url=\"#effect{number}\"/></material>\n"
            );
        }
        out + "</library_materials>\n"
    }

    fn effect(&self, number: usize, entry: &Entry) -> String {
        let plain = Material::default();
        let known = entry.known.unwrap_or(&plain);
        let textures: Vec<&Texture> = known.textures.iter().filter(|texture| self.is_kept(texture)).collect();
        let parameters: String =
            textures.iter().enumerate().map(|(i, texture)| parameters(i, texture)).collect();
        let texture = |role: TextureRole| {
            let found = textures.iter().enumerate().find(|(_, texture)| texture.role == role);
            found.map(|(i, texture)| self::texture(i, texture))
        };
        // Colours whose place a texture has.
        let mut covered = String::new();
        let mut channel = |name: &str, role: TextureRole, color: Option<[f32; 3]>| {
            let color = color.map(|[r, g, b]| format!("<color>{r} {g} {b} 1</color>"));
            let inside = match (texture(role), color) {
                (Some(texture), color) => {
                    covered += &color.map_or(String::new(), |color| format!("<{name}>{color}</{name}>"));
                    texture
                }
                (None, Some(color)) => color,
                (None, None) => return String::new(),
            };
            format!("<{name}>{inside}</{name}>")
        };
        let number_of = |name: &str, value: Option<f32>| {
            value.map_or(String::new(), |value| format!("<{name}><float>{value}</float></{name}>"))
        };
        let srgb = |color: Option<Rgb>| color.map(Rgb::to_srgb);
        let base = match (entry.color, entry.known) {
            // A colour that faces still have is written as it was.
            (Some(color), Some(known)) if color == known.color().unwrap_or(Color::UNPAINTED) => {
                srgb(known.base_color)
            }
            (Some(color), _) => Some(color.0.map(|channel| f32::from(channel) / 255.0)),
            (None, _) => srgb(known.base_color),
        };
        let emission = channel("emission", TextureRole::Emissive, srgb(known.emissive));
        let ambient = channel("ambient", TextureRole::Ambient, srgb(known.ambient));
        let diffuse = channel("diffuse", TextureRole::BaseColor, base);
        let specular = channel("specular", TextureRole::Specular, srgb(known.specular));
        let reflective = channel("reflective", TextureRole::Reflection, None);
        let shininess = number_of("shininess", known.shininess);
        let shader = if specular.is_empty() && shininess.is_empty() { "lambert" } else { "phong" };
        let transparent = match (texture(TextureRole::Alpha), known.alpha) {
            (Some(texture), _) => format!("<transparent opaque=\"A_ONE\">{texture}</transparent>"),
            (None, Some(_)) => {
                "<transparent opaque=\"A_ONE\"><color>1 1 1 1</color></transparent>".to_owned()
            }
            (None, None) => String::new(),
        };
        let transparency = number_of("transparency", known.alpha);
        let refraction = number_of("index_of_refraction", known.index_of_refraction);
        let bump = |role: TextureRole, kind: &str| {
            let bump = texture(role).map(|texture| format!("<bump bumptype=\"{kind}\">{texture}</bump>"));
            bump.map_or(String::new(), |bump| extra("FCOLLADA", &bump))
        };
        let bumps = bump(TextureRole::Bump, "HEIGHTFIELD") + &bump(TextureRole::Normal, "NORMALMAP");
        let own = if covered.is_empty() { String::new() } else { extra(OWN_PROFILE, &covered) };
        let sides = known.double_sided.map_or(String::new(), |both| {
            extra("GOOGLEEARTH", &format!("<double_sided>{}</double_sided>", u8::from(both)))
        });
        format!(
            "<effect id=\"effect{number}\"><profile_COMMON>{parameters}<technique sid=\"common\"><{shader}>{emission}\
             {ambient}{diffuse}{specular}{shininess}{reflective}{transparent}{transparency}{refraction}</{shader}>{bumps}{own}\
             </technique>{sides}</profile_COMMON></effect>\n"
        )
    }
}

/// Extra data of a program.
fn extra(profile: &str, data: &str) -> String {
    format!("<extra><technique profile=\"{profile}\">{data}</technique></extra>")
}

/// The parameters that lead from a texture to its image.
fn parameters(number: usize, texture: &Texture) -> String {
    let image = texture.image;
    let wraps: String = ["wrap_s", "wrap_t"]
        .iter()
        .zip(texture.wrap)
        .map(|(side, wrap)| match wrap {
            Wrap::Repeat => String::new(),
            Wrap::Mirror => format!("<{side}>MIRROR</{side}>"),
            Wrap::Clamp => format!("<{side}>CLAMP</{side}>"),
        })
        .collect();
    format!(
        "<newparam sid=\"surface{number}\"><surface type=\"2D\"><init_from>image{image}</init_from></surface></newparam>\
         <newparam sid=\"sampler{number}\"><sampler2D><source>surface{number}</source>{wraps}</sampler2D></newparam>"
    )
}

/// The element of a texture, with where it lies.
fn texture(number: usize, texture: &Texture) -> String {
    let set = texture.uv_set;
    let mut extras = String::new();
    if let Some(UvTransform { offset: [u, v], rotation, scale: [repeat_u, repeat_v] }) = texture.transform {
        // Maya's v counts from the bottom: 1 - (s (1 - v) + o) = s v + (1 - s - o).
        let is_maya = rotation == 0.0;
        let v = if is_maya { 1.0 - repeat_v - v } else { v };
        let profile = if is_maya { "MAYA" } else { OWN_PROFILE };
        let rotate = if is_maya { String::new() } else { format!("<rotateUV>{rotation}</rotateUV>") };
        extras += &extra(
            profile,
            &format!(
                "<repeatU>{repeat_u}</repeatU><repeatV>{repeat_v}</repeatV><offsetU>{u}</offsetU><offsetV>{v}</offsetV>{rotate}"
            ),
        );
    }
    if texture.scale != 1.0 {
        extras += &extra("MAX3D", &format!("<amount>{}</amount>", texture.scale));
    }
    format!("<texture texture=\"sampler{number}\" texcoord=\"UVSET{set}\">{extras}</texture>")
}

/// The address of an image file. One on a drive is a file's address.
fn address(path: &str) -> String {
    match path.split_once(':') {
        Some((drive, rest)) if drive.len() == 1 => format!("file:///{drive}:{}", percent_encoded(rest)),
        _ => percent_encoded(path),
    }
}
