//! Reading a glTF: the scene's nodes that show meshes, each as an object.

use super::accessor::Rows;
use super::document::{Document, Material, Mesh, Node, Primitive, open};
use super::names::{GENERATOR, VERTEX_ID};
use crate::error::ReadError;
use crate::format::reading::{Contents, Reading, Source, build};
use crate::model::labels::Names;
use crate::model::material::Materials;
use crate::model::paint::unpainted;
use crate::model::srgb::to_srgb;
use crate::report::{ImportReport, counted};
use crate::soup::hash::Unique;
use crate::soup::is_mirrored;
use crate::soup::origin::Origin;
use glam::{DMat4, DQuat, Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Color, NONE, PolygonSoup, Progress, keys};
use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

/// Reads one glTF.
pub(crate) fn read(
    source: &Source,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let file = source.file;
    let fail = |message: String| ReadError::file(&file.name, message);
    let (document, buffers) = open(file, source.files).map_err(fail)?;
    let mut instances = Vec::new();
    find(&document, &mut instances).map_err(fail)?;
    if instances.is_empty() {
        return Err(fail("the file holds no mesh".to_owned()));
    }
    let mut report = ImportReport::default();
    let mut objects = Vec::new();
    let (mut left_out, mut corners) = (0, 0);
    let size: usize = buffers.iter().map(|buffer| buffer.len()).sum();
    // Instances of small meshes are fine in any number that fits the memory easily.
    let most = size.saturating_mul(8).max(4_000_000);
    let total = instances.len();
    for (i, (name, mesh, transform)) in instances.into_iter().enumerate() {
        let mut reader = Reader::new(&document, &buffers, transform, most, reading.origin);
        for primitive in mesh.map_or(&[][..], |mesh| &mesh.primitives) {
            reader.primitive(primitive, &mut corners).map_err(fail)?;
        }
        left_out += reader.left_out;
        reading.origin = reader.origin;
        let part = |fraction: f32| (i as f32 + 0.5 + 0.5 * fraction) / total as f32;
        let mut notes = ImportReport::default();
        let mut progress = |fraction| progress(part(fraction));
        let object = build(&name, reader.finish(), &file.name, reading, &mut notes, &mut progress)?;
        report.append(if total > 1 { notes.prefixed(&name) } else { notes });
        objects.push(object);
    }
    if left_out > 0 {
        report.warn(format!(
            "{} of lines left out: only faces are edited here",
            counted(left_out, "set", "sets")
        ));
    }
    Ok(Contents { objects, materials: Materials::default(), report })
}

/// The meshes that the scene's nodes show, with their names and transforms, none for an empty one; if
/// no node does, all meshes as they are.
fn find<'d>(document: &'d Document, out: &mut Vec<(String, Option<&'d Mesh>, DMat4)>) -> Result<(), String> {
    let is_ours = document.asset.generator.as_deref() == Some(GENERATOR);
    let scene = document.scenes.get(document.scene.unwrap_or(0));
    let mut open: Vec<(usize, DMat4)> = scene
        .map_or(&[][..], |scene| &scene.nodes)
        .iter()
        .rev()
        .map(|&node| (node, DMat4::IDENTITY))
        .collect();
    let mut met = vec![false; document.nodes.len()];
    while let Some((index, parent)) = open.pop() {
        let node = document.nodes.get(index).ok_or_else(|| format!("node {index} doesn't exist"))?;
        // Nodes form trees: one that comes back is an error, and would never end.
        if met.get_mut(index).is_none_or(|met| std::mem::replace(met, true)) {
            return Err(format!("node {index} is shown twice"));
        }
        let here = parent * transform(node);
        if let Some(index) = node.mesh {
            let mesh = document.meshes.get(index).ok_or_else(|| format!("mesh {index} doesn't exist"))?;
            out.push((name(node.name.as_ref().or(mesh.name.as_ref()), index), Some(mesh), here));
        } else if is_ours {
            out.push((name(node.name.as_ref(), index), None, here));
        }
        open.extend(node.children.iter().rev().map(|&child| (child, here)));
    }
    if out.is_empty() {
        out.extend(
            document
                .meshes
                .iter()
                .enumerate()
                .map(|(i, mesh)| (name(mesh.name.as_ref(), i), Some(mesh), DMat4::IDENTITY)),
        );
    }
    Ok(())
}

fn name(name: Option<&String>, index: usize) -> String {
    name.filter(|name| !name.is_empty()).cloned().unwrap_or_else(|| format!("mesh {index}"))
}

fn transform(node: &Node) -> DMat4 {
    if let Some(matrix) = &node.matrix {
        return DMat4::from_cols_array(matrix);
    }
    let rotation = node.rotation.map_or(DQuat::IDENTITY, |q| {
        let q = DQuat::from_array(q);
        if q.length() > 0.0 { q.normalize() } else { DQuat::IDENTITY }
    });
    DMat4::from_scale_rotation_translation(
        node.scale.unwrap_or([1.0; 3]).into(),
        rotation,
        node.translation.unwrap_or_default().into(),
    )
}

/// Accessors of what tells vertices apart: positions, colours and numbers.
type Accessors = [Option<usize>; 3];

struct Reader<'a> {
    document: &'a Document,
    buffers: &'a [Cow<'a, [u8]>],
    transform: DMat4,
    origin: Option<Origin>,
    /// How many vertices and corners there may be in all.
    most: usize,
    soup: PolygonSoup,
    /// Vertices by position, colour and number.
    unique: Unique<7>,
    /// The vertices made for each set of accessors.
    vertices: HashMap<Accessors, Rc<Vec<u32>>>,
    colors: Vec<Vec3>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
    materials: Vec<u32>,
    left_out: usize,
}

impl<'a> Reader<'a> {
    fn new(
        document: &'a Document,
        buffers: &'a [Cow<'a, [u8]>],
        transform: DMat4,
        most: usize,
        origin: Option<Origin>,
    ) -> Self {
        Self {
            document,
            buffers,
            transform,
            origin,
            most,
            soup: PolygonSoup::default(),
            unique: Unique::new(),
            vertices: HashMap::new(),
            colors: Vec::new(),
            uvs: Vec::new(),
            normals: Vec::new(),
            materials: Vec::new(),
            left_out: 0,
        }
    }

    fn primitive(&mut self, primitive: &Primitive, met: &mut usize) -> Result<(), String> {
        let mode = primitive.mode.unwrap_or(4);
        // Points are vertices in no face.
        if !matches!(mode, 0 | 4..=6) {
            self.left_out += 1;
            return Ok(());
        }
        let find = |name: &str| {
            let accessor = primitive.attributes.get(name);
            accessor.map(|&accessor| Rows::find(self.document, self.buffers, accessor)).transpose()
        };
        let Some(positions) = find("POSITION")? else { return Ok(()) };
        let (colors, uvs, normals) = (find("COLOR_0")?, find("TEXCOORD_0")?, find("NORMAL")?);
        // What others call by this name may be anything.
        let ids = primitive.attributes.get(VERTEX_ID).copied();
        let ids = ids.and_then(|ids| Rows::find(self.document, self.buffers, ids).ok());
        let ids = ids.filter(|ids| ids.width == 4);
        let indices = primitive.indices.map(|i| Rows::find(self.document, self.buffers, i)).transpose()?;
        let count = indices.as_ref().map_or(positions.count, |indices| indices.count);
        // Primitives often share their vertices, each with some of the faces.
        let key = ["POSITION", "COLOR_0", VERTEX_ID].map(|name| primitive.attributes.get(name).copied());
        let known = self.vertices.get(&key).map(Rc::clone);
        // A small file must not fill the memory by sharing.
        *met += count + if known.is_none() { positions.count } else { 0 };
        if *met > self.most {
            return Err("its meshes use the same data too many times".to_owned());
        }
        let vertices = known.unwrap_or_else(|| {
            let color = |row| colors.as_ref().map(|colors| colors.floats(row));
            let id = |row| ids.as_ref().map_or(0, |ids| u32::from_le_bytes(ids.floats(row).map(|b| b as u8)));
            let vertex = |row| self.vertex(positions.floats(row), color(row), id(row));
            Rc::new((0..positions.count).map(vertex).collect())
        });
        self.vertices.insert(key, Rc::clone(&vertices));
        if mode == 0 {
            return Ok(());
        }
        let index = |i: usize| indices.as_ref().map_or(i as u32, |indices| indices.index(i));
        let faces = count.saturating_sub(2);
        let triangles: Box<dyn Iterator<Item = [usize; 3]>> = match mode {
            4 => Box::new((0..count / 3).map(|i| [i * 3, i * 3 + 1, i * 3 + 2])),
            5 => Box::new((0..faces).map(|i| if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] })),
            _ => Box::new((0..faces).map(|i| [i + 1, i + 2, 0])),
        };
        // Directions turn with the transform's inverse transpose.
        let turn = (self.transform != DMat4::IDENTITY).then(|| self.transform.inverse().transpose());
        // A transform that mirrors turns triangles over, which go the other way round for it.
        let mirrored = is_mirrored(self.transform);
        for [a, b, c] in triangles {
            for corner in if mirrored { [a, c, b] } else { [a, b, c] } {
                let row = index(corner);
                let Some(&vertex) = vertices.get(row as usize) else {
                    return Err(format!("a corner refers to vertex {row} of {}", vertices.len()));
                };
                let at = self.soup.corners.len();
                self.soup.corners.push(vertex);
                if let Some(uvs) = &uvs {
                    // Texture coordinates count from the top here.
                    let [u, v] = uvs.floats(row as usize);
                    self.uvs.resize(at, Vec2::NAN);
                    self.uvs.push(Vec2::new(u, 1.0 - v));
                }
                if let Some(normals) = &normals {
                    let normal = Vec3::from_array(normals.floats(row as usize));
                    let turned = turn
                        .map(|turn| turn.transform_vector3(normal.as_dvec3()).normalize_or_zero().as_vec3());
                    self.normals.resize(at, Vec3::NAN);
                    self.normals.push(turned.unwrap_or(normal));
                }
            }
            self.soup.face_starts.push(self.soup.corners.len() as u32);
            self.materials.push(primitive.material.map_or(NONE, |material| material as u32));
        }
        Ok(())
    }

    fn vertex(&mut self, position: [f32; 3], color: Option<[f32; 3]>, id: u32) -> u32 {
        let position = Vec3::from_array(position);
        let color = color.map_or(Vec3::NAN, |color| Vec3::from_array(color.map(to_srgb)));
        // Adding zero takes the sign off a negative zero.
        let [x, y, z] = (position + Vec3::ZERO).to_array();
        let (number, new) = self.unique.number([x, y, z, color.x, color.y, color.z, f32::from_bits(id)]);
        if new {
            let place = self.transform.transform_point3(position.as_dvec3());
            self.soup.positions.push(match &mut self.origin {
                Some(origin) => origin.place(place),
                None if self.transform == DMat4::IDENTITY => position,
                None => place.as_vec3(),
            });
            self.colors.push(color);
        }
        number
    }

    fn finish(mut self) -> PolygonSoup {
        let corners = self.soup.corners.len();
        if self.colors.iter().any(|color| !color.is_nan()) {
            self.soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, self.colors));
        }
        if !self.uvs.is_empty() {
            self.uvs.resize(corners, Vec2::NAN);
            self.soup.corner_columns.push(Column::with_values(keys::CORNER_UV, self.uvs));
        }
        if !self.normals.is_empty() {
            self.normals.resize(corners, Vec3::NAN);
            self.soup.corner_columns.push(Column::with_values(keys::CORNER_NORMAL, self.normals));
        }
        let materials: Vec<(String, Option<Color>)> = self.document.materials.iter().map(material).collect();
        let mut names = Names::default();
        let numbers: Vec<u32> = materials
            .iter()
            .map(|(name, _)| if name.is_empty() { NONE } else { names.number(name) })
            .collect();
        let named: Vec<u32> =
            self.materials.iter().map(|&m| numbers.get(m as usize).copied().unwrap_or(NONE)).collect();
        if named.iter().any(|&name| name != NONE) {
            self.soup.face_columns.push(names.column(keys::FACE_MATERIAL, named));
        }
        let color = |m: &u32| materials.get(*m as usize).and_then(|(_, color)| *color);
        if self.materials.iter().any(|m| color(m).is_some()) {
            let colors = self.materials.iter().map(|m| color(m).unwrap_or(Color::UNPAINTED)).collect();
            self.soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors));
        }
        self.soup
    }
}

/// A material's name, empty for one that only stands for a colour, and its colour.
fn material(material: &Material) -> (String, Option<Color>) {
    let name = material.name.clone().unwrap_or_default();
    let surface = &material.pbr_metallic_roughness;
    let color = surface
        .base_color_factor
        .filter(|_| surface.base_color_texture.is_none())
        .map(|[r, g, b, _]| Color([r, g, b].map(|c| (to_srgb(c) * 255.0).round().clamp(0.0, 255.0) as u8)));
    match unpainted(&name) {
        Some((plain, paint)) if color == Some(paint) => (plain.to_owned(), color),
        _ => (name, color),
    }
}
