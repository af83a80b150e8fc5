//! Effects: what the common profile says of a material.

use super::image;
use super::numbers::numbers;
use super::xml::{Document, Node};
use crate::file::NamedBytes;
use crate::model::collector::MaterialCollector;
use crate::model::material::{Material, Rgb};
use crate::model::texture::{Texture, TextureRole, UvTransform, Wrap};
use crate::notes::{Fault, Notes};
use std::borrow::Cow;
use std::collections::HashMap;

/// The profile of Meshwright's own extra data: colours under textures, and what textures have besides.
pub(super) const OWN_PROFILE: &str = "MESHWRIGHT";

/// How often a parameter may refer to another one.
const MAX_PARAMETER_STEPS: usize = 8;

/// Channels of the common profile that are a colour or a texture.
const CHANNELS: [(&str, TextureRole); 6] = [
    ("emission", TextureRole::Emissive),
    ("ambient", TextureRole::Ambient),
    ("diffuse", TextureRole::BaseColor),
    ("specular", TextureRole::Specular),
    ("reflective", TextureRole::Reflection),
    ("transparent", TextureRole::Alpha),
];

/// A material that an effect describes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct EffectMaterial {
    /// Without a name.
    pub material: Material,
    /// For each of its textures, the name under which its texture coordinates are bound.
    pub texcoords: Vec<String>,
}

/// Reads the effect of a material. Its images go to `materials`; `label` names it in notes.
pub(super) fn read(
    document: &Document,
    instance: &Node,
    label: &str,
    files: &[NamedBytes],
    materials: &mut MaterialCollector,
    notes: &mut Notes,
) -> EffectMaterial {
    let mut look = EffectMaterial::default();
    let url = instance.attribute("url").unwrap_or_default();
    let Some(effect) = document.target(url).filter(|node| node.name == "effect") else {
        notes.fault(Fault::Material, format!("\"{label}\": its effect {}", document.why_missing(url)));
        return look;
    };
    let profile = document.child(effect, "profile_COMMON");
    let technique = profile.and_then(|profile| document.child(profile, "technique"));
    if document
        .children(effect)
        .any(|child| child.name.starts_with("profile_") && child.name != "profile_COMMON")
    {
        notes.fault(Fault::Material, format!("\"{label}\": its shader programs are left out"));
    }
    let Some((profile, technique)) = profile.zip(technique) else { return look };
    let is_shader = |node: &&Node| matches!(node.name, "phong" | "blinn" | "lambert" | "constant");
    let shader = document.children(technique).find(is_shader);
    let scopes = [Some(instance), Some(technique), Some(profile), Some(effect)];
    let mut reader = Reader {
        document,
        parameters: Parameters::of(document, scopes.into_iter().flatten()),
        label,
        files,
        materials,
        notes,
        look: &mut look,
    };
    if let Some(shader) = shader {
        reader.shader(shader);
    }
    reader.extras(&[technique, profile, effect], shader);
    look
}

/// The parameters of an effect by name; those of inner scopes come first.
struct Parameters<'d, 'a>(HashMap<&'d str, &'d Node<'a>>);

impl<'d, 'a> Parameters<'d, 'a> {
    fn of(document: &'d Document<'a>, scopes: impl Iterator<Item = &'d Node<'a>>) -> Self {
        let mut all = HashMap::new();
        for parameter in scopes.flat_map(|scope| document.children(scope)) {
            let name = match parameter.name {
                "newparam" => parameter.attribute("sid"),
                "setparam" => parameter.attribute("ref"),
                _ => None,
            };
            if let Some(name) = name {
                all.entry(name).or_insert(parameter);
            }
        }
        Self(all)
    }
}

struct Reader<'r, 'd, 'a> {
    document: &'d Document<'a>,
    parameters: Parameters<'d, 'a>,
    label: &'r str,
    files: &'r [NamedBytes],
    materials: &'r mut MaterialCollector,
    notes: &'r mut Notes,
    look: &'r mut EffectMaterial,
}

impl<'d, 'a> Reader<'_, 'd, 'a> {
    fn fault(&mut self, what: &str) {
        self.notes.fault(Fault::Material, format!("\"{}\": {what}", self.label));
    }

    fn shader(&mut self, shader: &'d Node<'a>) {
        let document = self.document;
        if shader.name == "constant" {
            self.notes.info(format!("Material \"{}\" is unlit in the file, which is not kept", self.label));
        }
        for (name, role) in CHANNELS {
            let Some(texture) = document.path(shader, &[name, "texture"]) else { continue };
            self.texture(role, texture);
        }
        let color = |reader: &Self, name: &str| reader.color(document.child(shader, name)?);
        let rgb =
            |reader: &Self, name: &str| color(reader, name).map(|[r, g, b, _]| Rgb::from_srgb([r, g, b]));
        self.look.material.emissive = rgb(self, "emission");
        self.look.material.ambient = rgb(self, "ambient");
        self.look.material.base_color = rgb(self, "diffuse");
        self.look.material.specular = rgb(self, "specular");
        let number = |reader: &Self, name: &str| reader.number(document.child(shader, name)?);
        self.look.material.shininess = number(self, "shininess");
        self.look.material.index_of_refraction = number(self, "index_of_refraction");
        self.look.material.alpha = self.alpha(shader);
        if number(self, "reflectivity").is_some_and(|amount| amount > 0.0)
            && color(self, "reflective").is_some_and(|[r, g, b, _]| r + g + b > 0.0)
        {
            self.fault("its reflectivity is left out");
        }
    }

    /// Opacity by the transparent colour and the transparency ("COLLADA 1.4.1", 7: determining
    /// transparency).
    fn alpha(&mut self, shader: &'d Node<'a>) -> Option<f32> {
        let document = self.document;
        let transparent = document.child(shader, "transparent");
        let transparency = document.child(shader, "transparency").and_then(|node| self.number(node));
        if transparent.is_none() && transparency.is_none() {
            return None;
        }
        let opaque = transparent.and_then(|node| node.attribute("opaque")).unwrap_or("A_ONE");
        if transparent.is_some_and(|node| document.child(node, "texture").is_some()) {
            if opaque.ends_with("ZERO") {
                self.fault("its alpha texture means transparency in the file and opacity here");
                return None;
            }
            return transparency.filter(|&amount| amount > 0.0).map(|amount| amount.min(1.0));
        }
        let [r, g, b, a] = transparent.and_then(|node| self.color(node)).unwrap_or([1.0; 4]);
        let amount = transparency.unwrap_or(1.0);
        let luminance = 0.212_671 * r + 0.715_16 * g + 0.072_169 * b;
        let alpha = match opaque {
            "A_ZERO" => 1.0 - a * amount,
            "RGB_ZERO" => 1.0 - luminance * amount,
            "RGB_ONE" => luminance * amount,
            _ => a * amount,
        };
        if alpha <= 0.0 {
            // Several programs write transparency inverted, and nobody models what can't be seen.
            self.notes
                .info(format!("Material \"{}\" would be invisible and was taken as opaque", self.label));
            return None;
        }
        Some(alpha.min(1.0))
    }

    /// A colour, or that of the parameter that stands for it. Without alpha it is opaque.
    fn color(&self, channel: &'d Node<'a>) -> Option<[f32; 4]> {
        let is_color = |node: &&Node| matches!(node.name, "color" | "float3" | "float4");
        let found = self.value(channel, is_color)?;
        let values = numbers::<f32>(found.text(), None).values;
        let color = match *values.as_slice() {
            [r, g, b] => [r, g, b, 1.0],
            [r, g, b, a, ..] => [r, g, b, a],
            _ => return None,
        };
        color.iter().all(|channel| channel.is_finite()).then_some(color)
    }

    /// A number, or that of the parameter that stands for it.
    fn number(&self, channel: &'d Node<'a>) -> Option<f32> {
        let found = self.value(channel, |node| node.name == "float")?;
        numbers::<f32>(found.text(), Some(1)).values.first().copied().filter(|number| number.is_finite())
    }

    /// The value of a channel, through the parameters that stand for it.
    fn value(&self, channel: &'d Node<'a>, is_value: impl Fn(&&Node) -> bool) -> Option<&'d Node<'a>> {
        let mut at = channel;
        for _ in 0..MAX_PARAMETER_STEPS {
            if let Some(found) = self.document.children(at).find(|child| is_value(child)) {
                return Some(found);
            }
            let parameter = self.document.child(at, "param")?;
            at = self.parameters.0.get(parameter.attribute("ref")?).copied()?;
        }
        None
    }

    /// Adds a texture, unless its role is taken.
    fn texture(&mut self, role: TextureRole, node: &'d Node<'a>) {
        let document = self.document;
        if self.look.material.texture(role).is_some() {
            return self.fault(&format!("of several textures, one is its {}", role.name()));
        }
        let name = node.attribute("texture").unwrap_or_default();
        let (image, wrap) = self.image(name);
        let image = image.ok_or_else(|| format!("image \"{name}\" doesn't exist"));
        let image = match image.and_then(|image| image::read(document, image, self.files)) {
            Ok(image) => self.materials.add_image(image),
            Err(why) => return self.fault(&format!("its {} is left out: {why}", role.name())),
        };
        let mut texture = Texture { wrap, ..Texture::new(role, image) };
        for technique in self.techniques(node) {
            self.placement(technique, &mut texture);
        }
        self.look.material.textures.push(texture);
        self.look.texcoords.push(node.attribute("texcoord").unwrap_or_default().to_owned());
    }

    /// The image of a sampler, or the one of that id, and how it repeats.
    fn image(&self, name: &'d str) -> (Option<&'d Node<'a>>, [Wrap; 2]) {
        let document = self.document;
        let mut name = Cow::Borrowed(name);
        let mut wrap = [Wrap::Repeat; 2];
        for _ in 0..MAX_PARAMETER_STEPS {
            let Some(parameter) = self.parameters.0.get(name.as_ref()) else { break };
            if let Some(sampler) = document.child(parameter, "sampler2D") {
                wrap = ["wrap_s", "wrap_t"].map(|side| {
                    document.child(sampler, side).map_or(Wrap::Repeat, |side| wrap_of(&side.word()))
                });
                let instance = document.child(sampler, "instance_image");
                if let Some(url) = instance.and_then(|instance| instance.attribute("url")) {
                    return (document.target(url).filter(|node| node.name == "image"), wrap);
                }
            }
            let path: [&[&str]; 3] =
                [&["sampler2D", "source"], &["surface", "init_from"], &["surface", "init_planar", "all"]];
            let Some(next) = path.iter().find_map(|path| document.path(parameter, path)) else { break };
            name = next.attribute("ref").map_or_else(|| next.word(), Cow::Borrowed);
        }
        (document.target(&name).filter(|node| node.name == "image"), wrap)
    }

    /// The techniques of other programs in the extra data of a node.
    fn techniques(&self, node: &Node) -> impl Iterator<Item = &'d Node<'a>> + use<'d, 'a> {
        let document = self.document;
        let extras = document.children_named(node, "extra");
        extras.flat_map(move |extra| document.children_named(extra, "technique"))
    }

    /// What the extra data of a texture says of where it lies: Maya's repeats and offsets, which count
    /// from the bottom, and Meshwright's, which count as [`UvTransform`] does; also 3ds Max's amount.
    fn placement(&mut self, technique: &'d Node<'a>, texture: &mut Texture) {
        let document = self.document;
        let number = |name: &str| {
            let node = document.child(technique, name)?;
            let node = document.child(node, "float").unwrap_or(node);
            numbers::<f32>(node.text(), Some(1)).values.first().copied().filter(|number| number.is_finite())
        };
        texture.scale = number("amount").unwrap_or(texture.scale);
        let repeat = ["repeatU", "repeatV"].map(|name| number(name).unwrap_or(1.0));
        let offset = ["offsetU", "offsetV"].map(|name| number(name).unwrap_or(0.0));
        let rotation = number("rotateUV").unwrap_or(0.0);
        let is_own = technique.attribute("profile") == Some(OWN_PROFILE);
        if (repeat, offset, rotation) != ([1.0; 2], [0.0; 2], 0.0) && (is_own || rotation == 0.0) {
            let [offset_u, offset_v] = offset;
            let offset_v = if is_own { offset_v } else { 1.0 - repeat[1] - offset_v };
            texture.transform = Some(UvTransform { offset: [offset_u, offset_v], rotation, scale: repeat });
        } else if rotation != 0.0 {
            self.fault("the rotation of a texture is left out");
        }
        for (side, wrap) in texture.wrap.iter_mut().enumerate() {
            let is = |names: [&str; 2]| names.get(side).and_then(|name| number(name));
            *wrap = match (is(["mirrorU", "mirrorV"]), is(["wrapU", "wrapV"])) {
                (Some(mirror), _) if mirror != 0.0 => Wrap::Mirror,
                (_, Some(0.0)) => Wrap::Clamp,
                _ => *wrap,
            };
        }
    }

    /// What the extra data of an effect adds: bump maps, whether back faces are shown, and the colours
    /// under textures that Meshwright writes.
    fn extras(&mut self, nodes: &[&'d Node<'a>], shader: Option<&'d Node<'a>>) {
        let document = self.document;
        for node in nodes.iter().copied().chain(shader) {
            for technique in self.techniques(node) {
                if let Some(bump) = document.child(technique, "bump")
                    && let Some(texture) = document.child(bump, "texture")
                {
                    let is_normal = bump.attribute("bumptype").is_some_and(|kind| kind.starts_with("NORMAL"));
                    let role = if is_normal { TextureRole::Normal } else { TextureRole::Bump };
                    self.texture(role, texture);
                }
                if let Some(both) = document.child(technique, "double_sided") {
                    self.look.material.double_sided = Some(matches!(both.word().as_ref(), "1" | "true"));
                }
                if technique.attribute("profile") == Some(OWN_PROFILE) {
                    let color = |name: &str| self.color(document.child(technique, name)?);
                    let rgb = |name: &str| color(name).map(|[r, g, b, _]| Rgb::from_srgb([r, g, b]));
                    let colors = [rgb("emission"), rgb("ambient"), rgb("diffuse"), rgb("specular")];
                    let [emission, ambient, diffuse, specular] = colors;
                    let material = &mut self.look.material;
                    material.emissive = emission.or(material.emissive);
                    material.ambient = ambient.or(material.ambient);
                    material.base_color = diffuse.or(material.base_color);
                    material.specular = specular.or(material.specular);
                }
            }
        }
    }
}

/// How an image repeats by COLLADA's word for it.
fn wrap_of(word: &str) -> Wrap {
    match word {
        "MIRROR" => Wrap::Mirror,
        "CLAMP" | "BORDER" | "NONE" => Wrap::Clamp,
        _ => Wrap::Repeat,
    }
}
