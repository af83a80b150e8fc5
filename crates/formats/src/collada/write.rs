//! Writing a COLLADA 1.4.1 document: Y up, in metres, one geometry and node for each object.

use crate::export::ObjectRef;
use crate::hash::Unique;
use crate::import::NamedBytes;
use crate::obj::names::{own_colors, painted};
use crate::text::{push_float, push_integer};
use glam::DVec3;
use halfedge::attribute::{AttributeType, Key};
use halfedge::{Color, Element, Mesh, NONE, keys};
use std::collections::HashMap;

/// Writes the objects into one document. Read again, they are the same meshes.
pub(crate) fn write(name: &str, objects: &[ObjectRef]) -> Vec<NamedBytes> {
    let own = own_colors(objects, str::to_owned);
    let mut materials = Materials { own, ..Materials::default() };
    let mut geometries = Vec::new();
    let mut nodes = String::new();
    for (number, object) in objects.iter().enumerate() {
        let mesh = object.mesh.to_compact();
        let used = geometry(&mut geometries, number, object.name, &mesh, object.offset, &mut materials);
        let label = escape(object.name);
        nodes +=
            &format!("<node id=\"node{number}\" name=\"{label}\"><instance_geometry url=\"#mesh{number}\">");
        if !used.is_empty() {
            nodes += "<bind_material><technique_common>";
            for material in used {
                nodes += &format!(
                    "<instance_material symbol=\"material{material}\" target=\"#material{material}\"/>"
                );
            }
            nodes += "</technique_common></bind_material>";
        }
        nodes += "</instance_geometry></node>\n";
    }
    let mut out = b"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
        <COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n\
        <asset><contributor><authoring_tool>Meshwright</authoring_tool></contributor>\
        <created>2000-01-01T00:00:00Z</created><modified>2000-01-01T00:00:00Z</modified>\
        <unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n"
        .to_vec();
    let mut push = |text: &str| out.extend_from_slice(text.as_bytes());
    if !materials.list.is_empty() {
        push("<library_effects>\n");
        for (i, (_, color)) in materials.list.iter().enumerate() {
            let [r, g, b] = color.unwrap_or(Color::UNPAINTED).0.map(|c| f32::from(c) / 255.0);
            let diffuse = if color.is_some() {
                format!("<diffuse><color>{r} {g} {b} 1</color></diffuse>")
            } else {
                String::new()
            };
            push(&format!(
                "<effect id=\"effect{i}\"><profile_COMMON><technique sid=\"common\"><lambert>{diffuse}</lambert>\
                 </technique></profile_COMMON></effect>\n"
            ));
        }
        push("</library_effects>\n<library_materials>\n");
        for (i, (label, _)) in materials.list.iter().enumerate() {
            push(&format!(
                "<material id=\"material{i}\" name=\"{}\"><instance_effect url=\"#effect{i}\"/></material>\n",
                escape(label)
            ));
        }
        push("</library_materials>\n");
    }
    push("<library_geometries>\n");
    out.extend_from_slice(&geometries);
    out.extend_from_slice(b"</library_geometries>\n<library_visual_scenes><visual_scene id=\"scene\">\n");
    out.extend_from_slice(nodes.as_bytes());
    out.extend_from_slice(b"</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene url=\"#scene\"/></scene>\n</COLLADA>\n");
    vec![NamedBytes { name: format!("{name}.dae"), bytes: out }]
}

/// Materials with the names and colours to write, each once.
#[derive(Default)]
struct Materials {
    list: Vec<(String, Option<Color>)>,
    numbers: HashMap<(String, Option<Color>), usize>,
    /// The colours that go under materials' own names.
    own: HashMap<String, Color>,
}

impl Materials {
    fn number(&mut self, label: &str, color: Option<Color>) -> usize {
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
        self.list.push((name, color));
        self.numbers.insert(key, number);
        number
    }
}

/// Text as it can stand in an element or a quoted attribute.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// Writes a geometry; gives the materials it uses.
fn geometry(
    out: &mut Vec<u8>,
    number: usize,
    name: &str,
    mesh: &Mesh,
    offset: DVec3,
    materials: &mut Materials,
) -> Vec<usize> {
    let id = format!("mesh{number}");
    out.extend_from_slice(format!("<geometry id=\"{id}\" name=\"{}\"><mesh>\n", escape(name)).as_bytes());
    let positions = format!("{id}-positions");
    if offset == DVec3::ZERO {
        source(out, &positions, "X Y Z", mesh.positions().iter().map(|p| p.to_array()));
    } else {
        source(out, &positions, "X Y Z", mesh.positions().iter().map(|p| (p.as_dvec3() + offset).to_array()));
    }
    let normals =
        corner_source(out, &format!("{id}-normals"), "X Y Z", mesh, keys::CORNER_NORMAL, |n| n.to_array());
    let uvs = corner_source(out, &format!("{id}-uvs"), "S T", mesh, keys::CORNER_UV, |uv| uv.to_array());
    out.extend_from_slice(
        format!("<vertices id=\"{id}-vertices\"><input semantic=\"POSITION\" source=\"#{id}-positions\"/></vertices>\n").as_bytes(),
    );
    // Faces stay in order: a new list starts wherever the material changes, or whether corners
    // have attributes.
    let labels =
        mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |column| &column.labels);
    let colors = mesh.attribute(keys::FACE_COLOR);
    let mut runs: Vec<Run> = Vec::new();
    let mut corner = 0;
    for f in mesh.faces() {
        let label = labels.get(mesh.get(keys::FACE_MATERIAL, f.index()) as usize).map_or("", String::as_str);
        let color = colors.and_then(|colors| colors.get(f.index())).copied();
        let plain = label.is_empty() && color.is_none_or(|color| color == Color::UNPAINTED);
        let degree = mesh.face_degree(f);
        let has = |numbers: &[u32]| {
            numbers.get(corner..corner + degree).is_some_and(|numbers| numbers.iter().all(|&n| n != NONE))
        };
        let run = Run {
            material: (!plain).then(|| materials.number(label, color)),
            normals: has(&normals),
            uvs: has(&uvs),
            first_face: f.index(),
            first_corner: corner,
        };
        if runs.last().is_none_or(|last| !last.goes_on_with(&run)) {
            runs.push(run);
        }
        corner += degree;
    }
    for (i, run) in runs.iter().enumerate() {
        let end = runs.get(i + 1).map_or(mesh.face_count(), |next| next.first_face);
        polylist(out, &id, mesh, run, end, &normals, &uvs);
    }
    out.extend_from_slice(b"</mesh></geometry>\n");
    let mut used: Vec<usize> = runs.iter().filter_map(|run| run.material).collect();
    used.sort_unstable();
    used.dedup();
    used
}

/// Faces in a row that one list holds.
struct Run {
    material: Option<usize>,
    normals: bool,
    uvs: bool,
    first_face: usize,
    first_corner: usize,
}

impl Run {
    fn goes_on_with(&self, other: &Self) -> bool {
        (self.material, self.normals, self.uvs) == (other.material, other.normals, other.uvs)
    }
}

fn polylist(out: &mut Vec<u8>, id: &str, mesh: &Mesh, run: &Run, end: usize, normals: &[u32], uvs: &[u32]) {
    let material = run.material.map_or(String::new(), |material| format!(" material=\"material{material}\""));
    let mut head = format!(
        "<polylist count=\"{}\"{material}><input semantic=\"VERTEX\" source=\"#{id}-vertices\" offset=\"0\"/>",
        end - run.first_face
    );
    let mut offset = 1;
    for (there, semantic, part) in [(run.normals, "NORMAL", "normals"), (run.uvs, "TEXCOORD", "uvs")] {
        if there {
            head += &format!("<input semantic=\"{semantic}\" source=\"#{id}-{part}\" offset=\"{offset}\"/>");
            offset += 1;
        }
    }
    out.extend_from_slice(head.as_bytes());
    let faces = || (run.first_face..end).map(halfedge::FaceId::new);
    out.extend_from_slice(b"<vcount>");
    for f in faces() {
        push_integer(out, mesh.face_degree(f) as u64);
        out.push(b' ');
    }
    out.extend_from_slice(b"</vcount><p>");
    for (corner, v) in (run.first_corner..).zip(faces().flat_map(|f| mesh.face_vertices(f))) {
        push_integer(out, u64::from(v.raw()));
        out.push(b' ');
        for (there, numbers) in [(run.normals, normals), (run.uvs, uvs)] {
            if let Some(&number) = numbers.get(corner).filter(|_| there) {
                push_integer(out, u64::from(number));
                out.push(b' ');
            }
        }
    }
    out.extend_from_slice(b"</p></polylist>\n");
}

fn source<F: zmij::Float, const N: usize>(
    out: &mut Vec<u8>,
    id: &str,
    params: &str,
    rows: impl ExactSizeIterator<Item = [F; N]>,
) {
    let count = rows.len();
    out.extend_from_slice(
        format!("<source id=\"{id}\"><float_array id=\"{id}-array\" count=\"{}\">", count * N).as_bytes(),
    );
    for value in rows.flatten() {
        push_float(out, value);
        out.push(b' ');
    }
    let params: String = params.split(' ').map(|p| format!("<param name=\"{p}\" type=\"float\"/>")).collect();
    out.extend_from_slice(
        format!(
            "</float_array><technique_common><accessor source=\"#{id}-array\" count=\"{count}\" stride=\"{N}\">{params}\
             </accessor></technique_common></source>\n"
        )
        .as_bytes(),
    );
}

/// Writes the different values of a corner column as a source; gives each corner's number, faces
/// in order. Nothing where no corner has a value.
fn corner_source<T: AttributeType, const N: usize>(
    out: &mut Vec<u8>,
    id: &str,
    params: &str,
    mesh: &Mesh,
    key: Key<T>,
    array: impl Fn(T) -> [f32; N],
) -> Vec<u32> {
    let Some(column) = mesh.attribute(key) else { return Vec::new() };
    let mut unique = Unique::new();
    let mut rows: Vec<[f32; N]> = Vec::new();
    let numbers: Vec<u32> = mesh
        .faces()
        .flat_map(|f| mesh.face_halfedges(f))
        .map(|h| {
            let value = array(column.get(h.index()).copied().unwrap_or(key.default));
            if value.iter().any(|c| c.is_nan()) {
                return NONE;
            }
            let (number, new) = unique.number(value);
            if new {
                rows.push(value);
            }
            number
        })
        .collect();
    if rows.is_empty() {
        return Vec::new();
    }
    source(out, id, params, rows.into_iter());
    numbers
}
