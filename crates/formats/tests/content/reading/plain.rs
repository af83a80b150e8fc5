//! Samples of OBJ, PLY, STL and OFF.

use super::Becomes::{self, Kept, Named};
use super::Kind::{self, *};
use super::*;

pub fn obj(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let positions = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let text = |lines: &str| file("a.obj", format!("{positions}{lines}"));
    let with_library = |statement: &str| {
        let mut files = text("mtllib a.mtl\nusemtl m\nf 1 2 3\n");
        files.push(NamedBytes::new("a.mtl", format!("newmtl m\n{statement}\n")));
        files.push(image());
        files
    };
    Some(match kind {
        Materials => (with_library("Ns 9"), Kept(has_roughness)),
        Textures => (with_library("map_Kd a.png"), Kept(has_texture)),
        FaceColors => (with_library("Kd 1 0 0"), Kept(has_red_faces)),
        VertexColors => {
            (file("a.obj", "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n"), Kept(has_vertex_color))
        }
        Normals => (text("vn 0 0 1\nf 1//1 2//1 3//1\n"), Kept(has_normal)),
        TextureCoordinates => (text("vt 0.5 0.25\nf 1/1 2/1 3/1\n"), Kept(has_uv)),
        Groups => (text("g wheel\nf 1 2 3\n"), Kept(|import| has_label(import, keys::FACE_GROUP, "wheel"))),
        Names => (text("o part\nf 1 2 3\n"), Kept(has_name)),
        Lines => (text("f 1 2 3\nl 1 2\n"), Named("line or point element")),
        Points => (text("v 9 9 9\nf 1 2 3\np 4\n"), Kept(has_point)),
        CustomAttributes => (text("f 1 2 3\nquality 1\n"), Named("1 line ignored")),
        // Weights of rational curves.
        Metadata => (file("a.obj", "v 0 0 0 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), Named("fourth coordinate")),
        SecondTextureCoordinates | Skins | Morphs | Animations | Cameras | Lights => return None,
    })
}

pub fn ply(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let with = |vertex: &str, vertex_values: &str, face: &str, face_values: &str, more: &str, rows: &str| {
        file(
            "a.ply",
            format!(
                "ply\nformat ascii 1.0\n{more}element vertex 3\nproperty float x\nproperty float y\nproperty float z\n{vertex}\
                 element face 1\nproperty list uchar int vertex_indices\n{face}{}end_header\n\
                 0 0 0 {vertex_values}\n1 0 0 {vertex_values}\n0 1 0 {vertex_values}\n3 0 1 2 {face_values}\n{rows}",
                if rows.is_empty() {
                    ""
                } else {
                    "element edge 1\nproperty int vertex1\nproperty int vertex2\n"
                }
            ),
        )
    };
    let vertex = |properties: &str, values: &str| with(properties, values, "", "", "", "");
    let face = |properties: &str, values: &str| with("", "", properties, values, "", "");
    const CHANNELS: &str = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    Some(match kind {
        Textures => {
            let mut files = with(
                "property float s\nproperty float t\n",
                "0 0",
                "",
                "",
                "comment TextureFile a.png\n",
                "",
            );
            files.push(image());
            (
                files,
                Kept(|import| {
                    import
                        .model
                        .materials
                        .images
                        .iter()
                        .any(|image| image.name == "a.png" && image.bytes.is_some())
                }),
            )
        }
        Materials => (face("property int material_index\n", "7"), Named("material_index")),
        FaceColors => (face(CHANNELS, "255 0 0"), Kept(has_red_faces)),
        VertexColors => (vertex(CHANNELS, "255 0 0"), Kept(has_vertex_color)),
        Normals => {
            (vertex("property float nx\nproperty float ny\nproperty float nz\n", "0 0 1"), Kept(has_normal))
        }
        TextureCoordinates => (vertex("property float s\nproperty float t\n", "0.5 0.25"), Kept(has_uv)),
        SecondTextureCoordinates => (
            vertex(
                "property float s\nproperty float t\nproperty float s1\nproperty float t1\n",
                "0 0 0.5 0.5",
            ),
            Named("s1, t1"),
        ),
        Lines => (with("", "", "", "", "", "0 1\n"), Named("\"edge\"")),
        CustomAttributes => (
            vertex("property float quality\n", "1"),
            Kept(|import| mesh(import).column(Element::Vertex, "quality").is_some()),
        ),
        Metadata => (with("", "", "", "", "obj_info made by x\n", ""), Named("obj_info")),
        // Vertices in no face.
        Points => (
            file(
                "a.ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n9 9 9\n",
            ),
            Kept(has_point),
        ),
        Groups | Names | Skins | Morphs | Animations | Cameras | Lights => return None,
    })
}

pub fn stl(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let binary = |attribute: u16| {
        let mut bytes = b"COLOR=\xff\xff\xff\xff".to_vec();
        bytes.resize(80, b' ');
        bytes.extend(1u32.to_le_bytes());
        let numbers = [0.0f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        bytes.extend(numbers.into_iter().flat_map(f32::to_le_bytes));
        bytes.extend(attribute.to_le_bytes());
        file("a.stl", bytes)
    };
    Some(match kind {
        // Materialise Magics: red in the low bits, and the high bit for none of its own.
        FaceColors => (binary(0x001f), Kept(has_red_faces)),
        Names => (
            file("a.stl", format!("solid part\n{facet}endsolid part\n")),
            Kept(|import| has_name(import) || has_label(import, keys::FACE_GROUP, "part")),
        ),
        Materials
        | Textures
        | VertexColors
        | Normals
        | TextureCoordinates
        | SecondTextureCoordinates
        | Groups
        | Skins
        | Morphs
        | Animations
        | Lines
        | Points
        | Cameras
        | Lights
        | CustomAttributes
        | Metadata => return None,
    })
}

pub fn off(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let with = |head: &str, values: &str, face: &str| {
        file(
            "a.off",
            format!("{head}\n3 1 0\n0 0 0 {values}\n1 0 0 {values}\n0 1 0 {values}\n3 0 1 2 {face}\n"),
        )
    };
    Some(match kind {
        FaceColors => (with("OFF", "", "255 0 0"), Kept(has_red_faces)),
        VertexColors => (with("COFF", "255 0 0 255", ""), Kept(has_vertex_color)),
        Normals => (with("NOFF", "0 0 1", ""), Kept(has_normal)),
        TextureCoordinates => (with("STOFF", "0.5 0.25", ""), Kept(has_uv)),
        Points => (file("a.off", "OFF\n1 0 0\n9 9 9\n"), Kept(has_point)),
        Lines => {
            (file("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n"), Named("1 face left out"))
        }
        Materials
        | Textures
        | SecondTextureCoordinates
        | Groups
        | Names
        | Skins
        | Morphs
        | Animations
        | Cameras
        | Lights
        | CustomAttributes
        | Metadata => return None,
    })
}
