//! Samples of COLLADA.

use super::Becomes::{self, Kept, Named};
use super::Kind::{self, *};
use super::*;

pub fn dae(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let source = |id: &str, values: &str, params: &str| {
        let stride = params.len();
        let count = values.split(' ').count() / stride;
        let params: String =
            params.chars().map(|name| format!("<param name=\"{name}\" type=\"float\"/>")).collect();
        format!(
            "<source id=\"{id}\"><float_array id=\"{id}a\" count=\"{}\">{values}</float_array><technique_common>\
             <accessor source=\"#{id}a\" count=\"{count}\" stride=\"{stride}\">{params}</accessor></technique_common></source>",
            count * stride
        )
    };
    let document = |sources: &str, inputs: &str, primitive: &str, scene: &str, more: &str| {
        let input = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
        let triangles =
            format!("<triangles count=\"1\" material=\"s\">{input}{inputs}<p>0 1 2</p></triangles>");
        let primitive = primitive.replace("<input/>", input);
        file(
            "a.dae",
            format!(
                "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><asset><up_axis>Y_UP</up_axis></asset>{more}\
                 <library_geometries><geometry id=\"g\"><mesh>{}{sources}<vertices id=\"v\"><input semantic=\"POSITION\" \
                 source=\"#p\"/></vertices>{triangles}{primitive}</mesh></geometry></library_geometries>\
                 <library_visual_scenes><visual_scene id=\"vs\">{scene}</visual_scene></library_visual_scenes>\
                 <scene><instance_visual_scene url=\"#vs\"/></scene></COLLADA>",
                source("p", "0 0 0 1 0 0 0 1 0", "XYZ")
            ),
        )
    };
    let bind = "<bind_material><technique_common><instance_material symbol=\"s\" target=\"#m\"/></technique_common></bind_material>";
    let shown = format!(
        "<node id=\"n\" name=\"part\"><instance_geometry url=\"#g\">{bind}</instance_geometry></node>"
    );
    let attribute = |semantic: &str, source: String| {
        let inputs = format!("<input semantic=\"{semantic}\" source=\"#c\" offset=\"0\"/>");
        document(&source, &inputs, "", &shown, "")
    };
    let more = |more: &str| document("", "", "", &shown, more);
    let effect = |parameters: &str, inside: &str| {
        let mut files = more(&format!(
            "<library_images><image id=\"i\"><init_from>a.png</init_from></image></library_images>\
             <library_effects><effect id=\"e\"><profile_COMMON>{parameters}<technique sid=\"c\"><phong>{inside}</phong></technique>\
             </profile_COMMON></effect></library_effects>\
             <library_materials><material id=\"m\" name=\"m\"><instance_effect url=\"#e\"/></material></library_materials>"
        ));
        files.push(image());
        files
    };
    let controller = |inside: &str| {
        let scene = "<node><instance_controller url=\"#c\"/></node>";
        document(
            "",
            "",
            "",
            scene,
            &format!("<library_controllers><controller id=\"c\">{inside}</controller></library_controllers>"),
        )
    };
    Some(match kind {
        Materials => (effect("", "<shininess><float>9</float></shininess>"), Kept(has_roughness)),
        Textures => (
            effect(
                "<newparam sid=\"f\"><surface type=\"2D\"><init_from>i</init_from></surface></newparam>\
                 <newparam sid=\"t\"><sampler2D><source>f</source></sampler2D></newparam>",
                "<diffuse><texture texture=\"t\" texcoord=\"UV\"/></diffuse>",
            ),
            Kept(has_texture),
        ),
        FaceColors => (effect("", "<diffuse><color>1 0 0 1</color></diffuse>"), Kept(has_red_faces)),
        VertexColors => (attribute("COLOR", source("c", "1 0 0 0 1 0 0 0 1", "RGB")), Kept(has_vertex_color)),
        Normals => (attribute("NORMAL", source("c", "0 0 1 0 0 1 0 0 1", "XYZ")), Kept(has_normal)),
        TextureCoordinates => (attribute("TEXCOORD", source("c", "0.5 0.25 0 0 1 1", "ST")), Kept(has_uv)),
        SecondTextureCoordinates => {
            let sources = source("c", "0 0 0 0 1 1", "ST") + &source("d", "0 0 0 0 1 1", "ST");
            let inputs = "<input semantic=\"TEXCOORD\" source=\"#c\" offset=\"0\" set=\"0\"/>\
                          <input semantic=\"TEXCOORD\" source=\"#d\" offset=\"0\" set=\"1\"/>";
            (document(&sources, inputs, "", &shown, ""), Named("1 set of texture coordinates left out"))
        }
        Names => (more(""), Kept(has_name)),
        Skins => (
            controller("<skin source=\"#g\"><joints/><vertex_weights count=\"0\"/></skin>"),
            Named("skeleton"),
        ),
        Morphs => (
            controller(&format!(
                "<morph source=\"#g\"><source id=\"mt\"><IDREF_array id=\"mta\" count=\"1\">g</IDREF_array></source>{}\
                 <targets><input semantic=\"MORPH_TARGET\" source=\"#mt\"/><input semantic=\"MORPH_WEIGHT\" source=\"#mw\"/></targets></morph>",
                source("mw", "0.5", "W")
            )),
            Named("morph targets are not kept"),
        ),
        Animations => (
            more(
                "<library_animations><animation id=\"a\"><source id=\"z\"/></animation></library_animations>",
            ),
            Named("1 animation"),
        ),
        Lines => {
            (document("", "", "<lines count=\"1\"><input/><p>0 1</p></lines>", &shown, ""), Named("lines"))
        }
        Cameras => (more("<library_cameras><camera id=\"c\"/></library_cameras>"), Named("1 camera")),
        Lights => (more("<library_lights><light id=\"l\"/></library_lights>"), Named("1 light")),
        CustomAttributes => {
            (attribute("TEXTANGENT", source("c", "1 0 0 1 0 0 1 0 0", "XYZ")), Named("TEXTANGENT"))
        }
        Metadata => {
            (more("<extra><technique profile=\"X\"><a/></technique></extra>"), Named("double-sided faces: X"))
        }
        Groups | Points => return None,
    })
}
