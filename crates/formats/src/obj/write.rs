//! Writing an OBJ, with its materials in an MTL beside it.

use super::mtl::{self, Entry};
use super::names::{clean, group_lines, spaced};
use crate::file::NamedBytes;
use crate::model::images::{image_files, written_names};
use crate::model::material::Material;
use crate::model::paint::{names_in_use, own_colors, painted};
use crate::model::{Model, NamedMesh};
use crate::soup::hash::Unique;
use crate::text::print::{push_floats, push_integer, push_position};
use glam::{DVec3, Vec2, Vec3};
use halfedge::{Color, Element, Mesh, NONE, keys};
use std::collections::HashMap;

/// Writes the objects into one OBJ, several as `o` sections. If faces have colours or known materials, a
/// second file holds the materials, and more files the images that these use. Read again, one object is
/// the same mesh: numbering, positions to the bit, corners, attributes.
pub(crate) fn write(model: &Model) -> Vec<NamedBytes> {
    let (name, objects) = (&model.name, &model.objects);
    let has_colors = objects.iter().any(|object| shows_colors(&object.mesh));
    let mut known: HashMap<String, &Material> = HashMap::new();
    for material in &model.materials.list {
        known.entry(clean(&material.name)).or_insert(material);
    }
    let is_known = |object: &NamedMesh| {
        !known.is_empty()
            && names_in_use(&object.mesh).into_iter().any(|name| known.contains_key(&clean(name)))
    };
    let has_materials = has_colors || objects.iter().any(is_known);
    let library = format!("{name}.mtl");
    let mut writer =
        Writer { materials: Materials::new(has_colors, own_colors(model, clean)), ..Writer::default() };
    writer.out.extend_from_slice(b"# Written by Meshwright\n");
    if has_materials {
        writer.name_line("mtllib", &clean(&library));
    }
    for object in objects {
        let section = (objects.len() > 1).then(|| clean(&object.name));
        // An empty mesh would leave a file with nothing in it.
        if section.is_none() && object.mesh.vertex_count() == 0 {
            writer.name_line("o", &clean(&object.name));
        }
        writer.object(&object.mesh.to_compact(), model.offset, section);
    }
    let mut files = vec![NamedBytes { name: format!("{name}.obj"), bytes: writer.out }];
    if has_materials {
        let images = &model.materials.images;
        let entry = |named: Named| Entry {
            name: named.name,
            color: has_colors.then_some(named.color),
            known: known.get(&named.label).copied(),
        };
        let entries: Vec<Entry> = writer.materials.list.into_iter().map(entry).collect();
        let names = written_names(images, [format!("{name}.obj").as_str(), &library]);
        let names: Vec<String> = names.iter().map(|name| clean(name)).collect();
        let known = entries.iter().filter_map(|entry| entry.known);
        let used = known.flat_map(|known| &known.textures).map(|texture| texture.image).collect();
        files.push(NamedBytes { name: library, bytes: mtl::write(&entries, &names) });
        files.extend(image_files(images, &names, &used));
    }
    files
}

/// Whether faces have colours that a file has to keep: painted ones, or materials' own.
fn shows_colors(mesh: &Mesh) -> bool {
    let material = mesh.attribute(keys::FACE_MATERIAL);
    let has_material = |face: usize| material.and_then(|m| m.get(face)).is_some_and(|&m| m != NONE);
    mesh.attribute(keys::FACE_COLOR).is_some_and(|colors| {
        mesh.faces()
            .any(|f| has_material(f.index()) || colors.get(f.index()).is_some_and(|&c| c != Color::UNPAINTED))
    })
}

#[derive(Default)]
struct Writer {
    out: Vec<u8>,
    materials: Materials,
    /// How many of each came in earlier objects: numbers count on through the file.
    vertices: u64,
    uvs: u64,
    normals: u64,
}

impl Writer {
    fn line(&mut self, word: &str, values: &[f32]) {
        self.out.extend_from_slice(word.as_bytes());
        push_floats(&mut self.out, values);
        self.out.push(b'\n');
    }

    /// A line of a word and a name; without a name, the word alone, which ends the last one's hold.
    fn name_line(&mut self, word: &str, name: &str) {
        self.out.extend_from_slice(word.as_bytes());
        if !name.is_empty() {
            self.out.push(b' ');
            self.out.extend_from_slice(name.as_bytes());
        }
        self.out.push(b'\n');
    }

    /// One compact mesh; `section` is the name of its `o` line in a file of several.
    fn object(&mut self, mesh: &Mesh, offset: DVec3, section: Option<String>) {
        self.out.reserve(mesh.vertex_count() * 36 + mesh.halfedge_count() * 5);
        if let Some(section) = &section {
            self.name_line("o", section);
        }
        self.positions(mesh, offset);
        let uvs = self.uvs(mesh);
        let normals = self.normals(mesh);
        let mut groups = Groups::new(mesh, section);
        let mut materials = FaceMaterials::new(mesh);
        let smoothing = mesh.attribute(keys::FACE_SMOOTHING);
        let mut current_smoothing = 0;
        let mut corner = 0;
        for f in mesh.faces() {
            groups.enter(f.index(), self);
            if let Some(name) = materials.enter(f.index(), &mut self.materials) {
                let name = name.to_owned();
                self.name_line("usemtl", &name);
            }
            let group = smoothing.and_then(|s| s.get(f.index())).copied().unwrap_or(0);
            if group != current_smoothing {
                current_smoothing = group;
                let text = if group == 0 { "off".to_owned() } else { group.to_string() };
                self.name_line("s", &text);
            }
            self.out.push(b'f');
            for v in mesh.face_vertices(f) {
                self.out.push(b' ');
                push_integer(&mut self.out, self.vertices + u64::from(v.raw()) + 1);
                let number = |list: &[u32]| list.get(corner).copied().filter(|&n| n != NONE).map(u64::from);
                let (uv, normal) = (number(&uvs), number(&normals));
                if let Some(uv) = uv {
                    self.out.push(b'/');
                    push_integer(&mut self.out, self.uvs + uv + 1);
                }
                if let Some(normal) = normal {
                    self.out.extend_from_slice(if uv.is_some() { b"/" } else { b"//" });
                    push_integer(&mut self.out, self.normals + normal + 1);
                }
                corner += 1;
            }
            self.out.push(b'\n');
        }
        // What holds now would hold for the next object too.
        if current_smoothing != 0 {
            self.name_line("s", "off");
        }
        self.vertices += mesh.vertex_count() as u64;
        self.uvs += count(&uvs);
        self.normals += count(&normals);
    }

    fn positions(&mut self, mesh: &Mesh, offset: DVec3) {
        let colors = mesh.attribute(keys::VERTEX_COLOR);
        for (v, position) in mesh.positions().iter().enumerate() {
            self.out.push(b'v');
            push_position(&mut self.out, *position, offset);
            if let Some(color) = colors.and_then(|colors| colors.get(v)).filter(|color| !color.is_nan()) {
                push_floats(&mut self.out, &color.to_array());
            }
            self.out.push(b'\n');
        }
    }

    /// Writes each texture coordinate once; gives each corner's number, or nothing if none has any.
    fn uvs(&mut self, mesh: &Mesh) -> Vec<u32> {
        let Some(column) = mesh.attribute(keys::CORNER_UV) else { return Vec::new() };
        let mut unique = Unique::new();
        mesh.faces()
            .flat_map(|f| mesh.face_halfedges(f))
            .map(|h| {
                let uv = column.get(h.index()).copied().unwrap_or(Vec2::NAN);
                if uv.is_nan() {
                    return NONE;
                }
                let (number, new) = unique.number(uv.to_array());
                if new {
                    self.line("vt", &uv.to_array());
                }
                number
            })
            .collect()
    }

    /// Writes each normal once; gives each corner's number, or nothing if none has any.
    fn normals(&mut self, mesh: &Mesh) -> Vec<u32> {
        let Some(column) = mesh.attribute(keys::CORNER_NORMAL) else { return Vec::new() };
        let mut unique = Unique::new();
        mesh.faces()
            .flat_map(|f| mesh.face_halfedges(f))
            .map(|h| {
                let normal = column.get(h.index()).copied().unwrap_or(Vec3::NAN);
                if normal.is_nan() {
                    return NONE;
                }
                let (number, new) = unique.number(normal.to_array());
                if new {
                    self.line("vn", &normal.to_array());
                }
                number
            })
            .collect()
    }
}

/// How many different numbers, which count from 0.
fn count(numbers: &[u32]) -> u64 {
    numbers.iter().filter(|&&n| n != NONE).max().map_or(0, |&n| u64::from(n) + 1)
}

/// The `o` and `g` lines of one mesh.
struct Groups<'a> {
    values: Option<&'a [u32]>,
    /// The names of each label's lines.
    names: Vec<(String, String)>,
    current: u32,
    /// What the file says now.
    said: (String, String),
}

impl<'a> Groups<'a> {
    fn new(mesh: &'a Mesh, section: Option<String>) -> Self {
        let labels =
            mesh.column(Element::Face, keys::FACE_GROUP.name).map_or(&[][..], |column| &column.labels);
        let names = labels
            .iter()
            .map(|label| {
                let (object, group) = group_lines(label);
                match &section {
                    None => (clean(object), spaced(&clean(group))),
                    // The `o` line is the section's: a label of one alone becomes a group.
                    Some(section) if group.is_empty() => (section.clone(), spaced(&clean(object))),
                    Some(section) => (section.clone(), spaced(&clean(group))),
                }
            })
            .collect();
        Self {
            values: mesh.attribute(keys::FACE_GROUP),
            names,
            current: NONE,
            said: (section.unwrap_or_default(), String::new()),
        }
    }

    fn enter(&mut self, face: usize, writer: &mut Writer) {
        let value = self.values.and_then(|values| values.get(face)).copied().unwrap_or(NONE);
        if value == self.current {
            return;
        }
        let nothing = (if value == NONE { String::new() } else { self.said.0.clone() }, String::new());
        let (object, group) = self.names.get(value as usize).cloned().unwrap_or(nothing);
        if object != self.said.0 {
            writer.name_line("o", &object);
            self.said.1.clear();
        }
        if group != self.said.1 {
            writer.name_line("g", &group);
        }
        self.said = (object, group);
        self.current = value;
    }
}

/// A material of the file: its name there, the colour of its faces, and the name that it is known by,
/// empty where it only stands for a colour.
struct Named {
    name: String,
    color: Color,
    label: String,
}

/// All materials of the file. A material whose faces differ in colour becomes several.
#[derive(Default)]
struct Materials {
    has_colors: bool,
    list: Vec<Named>,
    numbers: HashMap<(String, Option<Color>), usize>,
    /// The colours that go under materials' own names.
    own: HashMap<String, Color>,
}

impl Materials {
    fn new(has_colors: bool, own: HashMap<String, Color>) -> Self {
        Self { has_colors, own, ..Self::default() }
    }

    /// The number of the material of a face with this material (or none, if empty) and colour.
    fn number(&mut self, material: &str, color: Color) -> usize {
        let color_key = self.has_colors.then_some(color);
        if let Some(&number) = self.numbers.get(&(material.to_owned(), color_key)) {
            return number;
        }
        let name = if material.is_empty() {
            painted("", color)
        } else if !self.has_colors || self.own.get(material) == Some(&color) {
            material.to_owned()
        } else {
            painted(material, color)
        };
        let number = self.list.len();
        self.list.push(Named { name, color, label: material.to_owned() });
        self.numbers.insert((material.to_owned(), color_key), number);
        number
    }
}

/// The `usemtl` lines of one mesh.
struct FaceMaterials<'a> {
    values: Option<&'a [u32]>,
    colors: Option<&'a [Color]>,
    labels: Vec<String>,
    current: Option<(u32, Color)>,
    said: Option<usize>,
}

impl<'a> FaceMaterials<'a> {
    fn new(mesh: &'a Mesh) -> Self {
        let labels =
            mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |column| &column.labels);
        Self {
            values: mesh.attribute(keys::FACE_MATERIAL),
            colors: mesh.attribute(keys::FACE_COLOR),
            labels: labels.iter().map(|label| clean(label)).collect(),
            current: None,
            said: None,
        }
    }

    /// The name to say before this face, if it isn't what holds already.
    fn enter<'m>(&mut self, face: usize, materials: &'m mut Materials) -> Option<&'m str> {
        let value = self.values.and_then(|values| values.get(face)).copied().unwrap_or(NONE);
        let color = self.colors.and_then(|colors| colors.get(face)).copied().unwrap_or(Color::UNPAINTED);
        if self.current == Some((value, color)) {
            return None;
        }
        self.current = Some((value, color));
        let label = self.labels.get(value as usize).map_or("", String::as_str);
        let plain = label.is_empty() && color == Color::UNPAINTED;
        // No statement takes a material back, so after one a face without has the plain colour's.
        if plain && self.said.is_none() && materials.list.is_empty() {
            return None;
        }
        let number = materials.number(label, color);
        if self.said == Some(number) {
            return None;
        }
        self.said = Some(number);
        materials.list.get(number).map(|named| named.name.as_str())
    }
}
