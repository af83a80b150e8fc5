//! Texture statements of material libraries: `map_Kd -s 2 2 1 wood.png`.

use crate::model::texture::{Texture, TextureRole, UvTransform, Wrap};

/// The statements that name an image, in the order in which they are written. Of several with one role
/// the first is the one written.
pub(crate) const TEXTURES: [(&str, TextureRole); 15] = [
    ("map_Ka", TextureRole::Ambient),
    ("map_Kd", TextureRole::BaseColor),
    ("map_Ks", TextureRole::Specular),
    ("map_Ke", TextureRole::Emissive),
    ("map_Ns", TextureRole::Shininess),
    ("map_d", TextureRole::Alpha),
    ("map_Bump", TextureRole::Bump),
    ("map_bump", TextureRole::Bump),
    ("bump", TextureRole::Bump),
    ("disp", TextureRole::Displacement),
    ("decal", TextureRole::Decal),
    ("refl", TextureRole::Reflection),
    ("norm", TextureRole::Normal),
    ("map_Pm", TextureRole::Metallic),
    ("map_Pr", TextureRole::Roughness),
];

/// The file name in a texture statement's text, empty where there is none, and what its options say of
/// a texture with this role.
pub(crate) fn parse(role: TextureRole, text: &str) -> (&str, Texture) {
    let mut texture = Texture::new(role, 0);
    let (mut offset, mut scale) = ([0.0, 0.0], [1.0, 1.0]);
    let mut rest = text.trim();
    while rest.starts_with('-') {
        let (option, mut after) = split(rest);
        let (fewest, most) = match option {
            "-blendu" | "-blendv" | "-cc" | "-clamp" | "-texres" | "-bm" | "-boost" | "-imfchan"
            | "-type" => (1, 1),
            "-mm" => (2, 2),
            "-o" | "-s" | "-t" => (1, 3),
            // A file name that starts with a hyphen.
            _ => break,
        };
        let mut values: Vec<&str> = Vec::new();
        while values.len() < most {
            let (word, next) = split(after);
            let is_value = values.len() < fewest || word.parse::<f32>().is_ok();
            // The last word of a statement is the file's name.
            if word.is_empty() || next.is_empty() || !is_value {
                break;
            }
            values.push(word);
            after = next;
        }
        let number = |at: usize| values.get(at)?.parse::<f32>().ok().filter(|value| value.is_finite());
        let pair = |default: [f32; 2]| [number(0).unwrap_or(default[0]), number(1).unwrap_or(default[1])];
        match option {
            "-bm" => texture.scale = number(0).unwrap_or(1.0),
            "-clamp" if values == ["on"] => texture.wrap = [Wrap::Clamp; 2],
            "-o" => offset = pair(offset),
            "-s" => scale = pair(scale),
            _ => {}
        }
        rest = after;
    }
    if (offset, scale) != ([0.0, 0.0], [1.0, 1.0]) {
        // MTL's v counts from the bottom: 1 - (s (1 - v) + o) = s v + (1 - s - o).
        let offset = [offset[0], 1.0 - scale[1] - offset[1]];
        texture.transform = Some(UvTransform { offset, rotation: 0.0, scale });
    }
    (rest, texture)
}

/// The first word and the rest.
fn split(text: &str) -> (&str, &str) {
    text.split_once(char::is_whitespace).map_or((text, ""), |(word, rest)| (word, rest.trim_start()))
}

/// Whether [`statement`] holds how a texture lies on the surface.
pub(crate) fn keeps_placement(texture: &Texture) -> bool {
    texture.uv_set == 0
        && (texture.wrap == [Wrap::Repeat; 2] || texture.wrap == [Wrap::Clamp; 2])
        && (texture.scale == 1.0 || texture.role == TextureRole::Bump)
        && texture.transform.is_none_or(|transform| transform.rotation == 0.0)
}

/// The statement of a texture that shows the image of this name; none where MTL has none for its role.
pub(crate) fn statement(texture: &Texture, image: &str) -> Option<String> {
    let (word, _) = TEXTURES.iter().find(|(_, role)| *role == texture.role)?;
    let mut text = (*word).to_owned();
    if let Some(UvTransform { offset, scale, .. }) = texture.transform {
        let [u, v] = scale;
        text += &format!(" -o {} {} -s {u} {v}", offset[0], 1.0 - v - offset[1]);
    }
    if texture.wrap == [Wrap::Clamp; 2] {
        text += " -clamp on";
    }
    if texture.role == TextureRole::Bump && texture.scale != 1.0 {
        text += &format!(" -bm {}", texture.scale);
    }
    Some(format!("{text} {image}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_come_before_the_file_name() {
        let parsed = |text| parse(TextureRole::Bump, text);
        let plain = Texture::new(TextureRole::Bump, 0);
        assert_eq!(parsed("my wood.png"), ("my wood.png", plain.clone()));
        assert_eq!(parsed("-x.png"), ("-x.png", plain.clone()));
        assert_eq!(parsed("-blendu on -mm 0 1 -type sphere 7.png"), ("7.png", plain.clone()));
        let (name, texture) = parsed("-bm 0.5 -clamp on -o 0.25 0.5 -s 2 3 1 a b.png");
        assert_eq!((name, texture.scale, texture.wrap), ("a b.png", 0.5, [Wrap::Clamp; 2]));
        let transform = UvTransform { offset: [0.25, -2.5], rotation: 0.0, scale: [2.0, 3.0] };
        assert_eq!(texture.transform, Some(transform));
        assert_eq!(parsed("-s 2"), ("2", plain.clone()), "something has to be the name");
        for broken in ["", "-", "-s", "-bm", "-o 1 2"] {
            parsed(broken);
        }
    }

    #[test]
    fn statements_read_back() {
        let transform = Some(UvTransform { offset: [0.25, -2.5], rotation: 0.0, scale: [2.0, 3.0] });
        for (_, role) in TEXTURES {
            let wrap = [Wrap::Clamp; 2];
            let texture = Texture { transform, wrap, ..Texture::new(role, 0) };
            let statement = statement(&texture, "a b.png").expect("a role that MTL has");
            let (_, text) = split(&statement);
            assert_eq!(parse(role, text), ("a b.png", texture));
        }
        assert_eq!(statement(&Texture::new(TextureRole::Occlusion, 0), "a"), None);
    }
}
