//! Writing an OBJ, with its materials in an MTL file.

mod groups;
mod materials;

use crate::file::NamedBytes;
use crate::model::images::{image_files, written_names};
use crate::model::material::Material;
use crate::model::paint::{names_in_use, own_colors};
use crate::model::{Model, NamedMesh};
use crate::obj::mtl::{self, Entry};
use crate::obj::names::clean;
use crate::soup::hash::Unique;
use crate::text::print::{push_floats, push_integer, push_position};
use glam::{DVec3, Vec2, Vec3};
use groups::Groups;
use halfedge::{Color, Mesh, NONE, keys};
use materials::{FaceMaterials, Materials, Named};
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
        // Without this, the file of an empty mesh would be empty.
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

/// Whether faces have colours to write: painted ones, or those of materials.
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
    /// The numbers of elements of earlier objects: numbering continues through the file.
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

    /// Writes a statement of a word and a name; without a name, the word alone, which ends the previous run.
    fn name_line(&mut self, word: &str, name: &str) {
        self.out.extend_from_slice(word.as_bytes());
        if !name.is_empty() {
            self.out.push(b' ');
            self.out.extend_from_slice(name.as_bytes());
        }
        self.out.push(b'\n');
    }

    /// Writes a compact mesh; `section` is the name of its `o` statement in a file of several.
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
            if groups.differs(f.index()) {
                let (object, group) = groups.enter(f.index());
                object.into_iter().for_each(|name| self.name_line("o", &name));
                group.into_iter().for_each(|name| self.name_line("g", &name));
            }
            if materials.differs(f.index())
                && let Some(name) = materials.enter(f.index(), &mut self.materials)
            {
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
        // The current group would apply to the next object, too.
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

    /// Writes each texture coordinate once; returns the number of each corner's, or nothing if no corner has one.
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

    /// Writes each normal once; returns the number of each corner's, or nothing if no corner has one.
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

/// The number of different numbers, which count from 0.
fn count(numbers: &[u32]) -> u64 {
    numbers.iter().filter(|&&n| n != NONE).max().map_or(0, |&n| u64::from(n) + 1)
}
