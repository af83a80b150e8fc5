//! One geometry: its sources and primitives, as polygon soup.

use super::material::Material;
use super::source::{Source, integers, positions, source};
use super::xml::{Document, Node};
use crate::holes;
use crate::obj::runs::Names;
use crate::origin::Origin;
use crate::report::counted;
use crate::soup::is_mirrored;
use glam::{DMat4, Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Color, NONE, PolygonSoup, keys};
use std::collections::HashMap;
use std::rc::Rc;

/// A soup, and what of the geometry is not in it.
#[derive(Default)]
pub(crate) struct Geometry {
    pub soup: PolygonSoup,
    /// Polygons that had holes: how many were cut into triangles round them, and of how many the
    /// holes were filled.
    pub cut: usize,
    pub filled: usize,
    /// Whether the transform mirrors, so that faces go the other way round.
    mirrored: bool,
    /// Lines and splines, which are not kept.
    pub lines: usize,
    /// What primitives lack or have too much of, in sentences.
    pub troubles: Vec<String>,
    /// The numbers of the materials of faces, and those materials.
    face_materials: Vec<u32>,
    materials: Vec<Material>,
    material_numbers: HashMap<Material, u32>,
    /// Sources by name: many primitives may use one.
    sources: HashMap<String, Rc<Source>>,
    uvs: Vec<Vec2>,
    normals: Vec<Vec3>,
}

/// What the numbers of a corner refer to: for each a place in the group of numbers, and a source.
struct Inputs {
    stride: usize,
    vertex: usize,
    uv: Option<(usize, Rc<Source>)>,
    normal: Option<(usize, Rc<Source>)>,
}

impl Geometry {
    /// Reads a geometry for one instance of it.
    ///
    /// # Errors
    /// Names the geometry and what is missing or out of range in it.
    pub(crate) fn read(
        document: &Document,
        geometry: &Node,
        instance: Option<&Node>,
        transform: DMat4,
        origin: &mut Option<Origin>,
    ) -> Result<Self, String> {
        let fail = |what: String| format!("geometry \"{}\": {what}", geometry.label());
        let mesh = document.child(geometry, "mesh").ok_or_else(|| fail("it has no <mesh>".to_owned()))?;
        let mut this = Self { mirrored: is_mirrored(transform), ..Self::default() };
        let vertices =
            document.child(mesh, "vertices").ok_or_else(|| fail("it has no <vertices>".to_owned()))?;
        let input = |semantic: &str| {
            document.children(vertices).find(|input| input.attribute("semantic") == Some(semantic))
        };
        let position = input("POSITION").ok_or_else(|| fail("its vertices have no positions".to_owned()))?;
        this.soup.positions = positions(document, position, transform, origin).map_err(fail)?;
        let binds = instance.and_then(|node| document.path(node, &["bind_material", "technique_common"]));
        let bound: HashMap<&str, &str> = binds
            .into_iter()
            .flat_map(|binds| document.children(binds))
            .filter_map(|bind| Some((bind.attribute("symbol")?, bind.attribute("target")?)))
            .collect();
        for primitive in document.children(mesh) {
            match primitive.name {
                "polylist" | "polygons" | "triangles" | "tristrips" | "trifans" => {
                    let first = this.soup.face_count();
                    let troubles = this.troubles.len();
                    this.primitive(document, vertices, primitive, transform).map_err(fail)?;
                    let count = primitive.attribute("count").and_then(|count| count.parse::<usize>().ok());
                    if first == this.soup.face_count() && troubles == this.troubles.len() && count > Some(0) {
                        let count = count.unwrap_or_default();
                        this.trouble(primitive, &format!("none of its {}", counted(count, "face", "faces")));
                    }
                    if let Some(symbol) = primitive.attribute("material") {
                        let material = Material::find(document, bound.get(symbol).copied(), symbol);
                        let next = this.materials.len() as u32;
                        let number = *this.material_numbers.entry(material.clone()).or_insert(next);
                        if number == next {
                            this.materials.push(material);
                        }
                        this.face_materials.resize(first, NONE);
                        this.face_materials.resize(this.soup.face_count(), number);
                    }
                }
                "lines" | "linestrips" => this.lines += 1,
                _ => {}
            }
        }
        this.columns();
        Ok(this)
    }

    fn primitive(
        &mut self,
        document: &Document,
        vertices: &Node,
        node: &Node,
        transform: DMat4,
    ) -> Result<(), String> {
        let inputs = self.inputs(document, vertices, node)?;
        // Directions turn with the transform's inverse transpose.
        let directions =
            if transform == DMat4::IDENTITY { transform } else { transform.inverse().transpose() };
        let whole = |what: &Node| {
            integers(what).ok_or_else(|| format!("<{}> holds something else than numbers", what.name))
        };
        let mut corners: Vec<u32> = Vec::new();
        match node.name {
            "polylist" => {
                let counts = match document.child(node, "vcount") {
                    Some(counts) => whole(counts)?,
                    None => Vec::new(),
                };
                let Some(indices) = document.child(node, "p") else {
                    return if counts.is_empty() {
                        Ok(())
                    } else {
                        Err("a <polylist> has no <p>".to_owned())
                    };
                };
                let indices = whole(indices)?;
                if document.child(node, "vcount").is_none() && !indices.is_empty() {
                    self.trouble(node, "no <vcount>, which says how many corners each face has");
                    return Ok(());
                }
                let mut rest = indices.as_slice();
                for count in counts {
                    let numbers = (count as usize).saturating_mul(inputs.stride);
                    let Some((face, after)) = rest.split_at_checked(numbers) else {
                        return Err("a <polylist> has fewer indices than its <vcount> says".to_owned());
                    };
                    rest = after;
                    self.face(face, &inputs, directions)?;
                }
                self.left_over(node, rest.len());
            }
            "polygons" => {
                for child in document.children(node) {
                    match child.name {
                        "p" => {
                            let corners = whole(child)?;
                            self.left_over(node, corners.len() % inputs.stride);
                            self.face(&corners, &inputs, directions)?;
                        }
                        "ph" => {
                            let Some(outline) = document.child(child, "p") else {
                                self.trouble(node, "a <ph> without <p>, its outline");
                                continue;
                            };
                            let outline = whole(outline)?;
                            let holes = document.children(child).filter(|part| part.name == "h");
                            let holes = holes.map(whole).collect::<Result<Vec<_>, _>>()?;
                            self.face_with_holes(&outline, &holes, &inputs, directions)?;
                        }
                        _ => {}
                    }
                }
            }
            _ => {
                for part in document.children(node).filter(|child| child.name == "p") {
                    let indices = whole(part)?;
                    let groups: Vec<&[u32]> = indices.chunks_exact(inputs.stride).collect();
                    // Strips and fans use every corner, where there are enough for one triangle.
                    let unused = match node.name {
                        "triangles" => groups.len() % 3,
                        _ if groups.len() < 3 => groups.len(),
                        _ => 0,
                    };
                    self.left_over(node, unused * inputs.stride + indices.len() % inputs.stride);
                    let mut triangle = |parts: [&[u32]; 3]| {
                        corners.clear();
                        parts.iter().for_each(|part| corners.extend_from_slice(part));
                        self.face(&corners, &inputs, directions)
                    };
                    match node.name {
                        "triangles" => {
                            for three in groups.as_chunks::<3>().0 {
                                triangle(*three)?;
                            }
                        }
                        "tristrips" => {
                            for (i, three) in groups.windows(3).enumerate() {
                                let &[a, b, c] = three else { continue };
                                triangle(if i % 2 == 0 { [a, b, c] } else { [b, a, c] })?;
                            }
                        }
                        _ => {
                            let Some(&hub) = groups.first() else { continue };
                            for two in groups.get(1..).unwrap_or_default().windows(2) {
                                let &[b, c] = two else { continue };
                                triangle([hub, b, c])?;
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Notes what a primitive has that is no good: "it has …".
    fn trouble(&mut self, node: &Node, what: &str) {
        self.troubles.push(format!("a <{}> has {what}", node.name));
    }

    /// Notes numbers behind the last whole face of a primitive.
    fn left_over(&mut self, node: &Node, count: usize) {
        if count > 0 {
            let numbers = counted(count, "number", "numbers");
            self.trouble(node, &format!("{numbers} in its <p> that make no whole face"));
        }
    }

    /// Adds a face by the numbers of its corners.
    fn face(&mut self, indices: &[u32], inputs: &Inputs, directions: DMat4) -> Result<(), String> {
        let start = self.soup.corners.len();
        let groups = indices.chunks_exact(inputs.stride);
        let count = groups.len();
        for i in 0..count {
            // Backwards from the same first corner where the transform mirrors.
            let place = if self.mirrored && i > 0 { count - i } else { i };
            let Some(group) = groups.clone().nth(place) else { continue };
            let number = |place: usize| group.get(place).copied().unwrap_or(NONE);
            let vertex = number(inputs.vertex);
            if vertex as usize >= self.soup.positions.len() {
                return Err(format!("a corner refers to vertex {vertex} of {}", self.soup.positions.len()));
            }
            let corner = self.soup.corners.len();
            self.soup.corners.push(vertex);
            if let Some((place, source)) = &inputs.uv {
                let uv = number(*place);
                let value = source.get::<2>(uv as usize).ok_or_else(|| {
                    format!("a corner refers to texture coordinate {uv}, which doesn't exist")
                })?;
                self.uvs.resize(corner, Vec2::NAN);
                self.uvs.push(Vec2::from_array(value));
            }
            if let Some((place, source)) = &inputs.normal {
                let normal = number(*place);
                let value = source
                    .get::<3>(normal as usize)
                    .ok_or_else(|| format!("a corner refers to normal {normal}, which doesn't exist"))?;
                self.normals.resize(corner, Vec3::NAN);
                self.normals.push(direction(Vec3::from_array(value), directions));
            }
        }
        // Two corners are no face; the build would drop it by number.
        if self.soup.corners.len() > start {
            self.soup.face_starts.push(self.soup.corners.len() as u32);
        }
        Ok(())
    }

    /// Adds a polygon with holes as triangles, or its outline alone where it can't be cut.
    fn face_with_holes(
        &mut self,
        outline: &[u32],
        holes: &[Vec<u32>],
        inputs: &Inputs,
        directions: DMat4,
    ) -> Result<(), String> {
        let groups: Vec<&[u32]> = outline
            .chunks_exact(inputs.stride)
            .chain(holes.iter().flat_map(|hole| hole.chunks_exact(inputs.stride)))
            .collect();
        let place = |group: &[u32]| {
            let vertex = group.get(inputs.vertex).copied().unwrap_or(NONE);
            self.soup.positions.get(vertex as usize).copied().unwrap_or(Vec3::NAN)
        };
        let ring =
            |indices: &[u32]| -> Vec<Vec3> { indices.chunks_exact(inputs.stride).map(place).collect() };
        let rings: Vec<Vec<Vec3>> = holes.iter().map(|hole| ring(hole)).collect();
        let Some(triangles) = holes::cut(&ring(outline), &rings) else {
            self.filled += 1;
            return self.face(outline, inputs, directions);
        };
        self.cut += 1;
        let mut corners: Vec<u32> = Vec::with_capacity(3 * inputs.stride);
        for triangle in triangles {
            corners.clear();
            corners.extend(triangle.iter().filter_map(|&i| groups.get(i as usize)).copied().flatten());
            self.face(&corners, inputs, directions)?;
        }
        Ok(())
    }

    /// The source that an input names, read once.
    fn source(&mut self, document: &Document, input: &Node) -> Result<Rc<Source>, String> {
        let name = input.attribute("source").unwrap_or_default();
        if let Some(known) = self.sources.get(name) {
            return Ok(Rc::clone(known));
        }
        let read = Rc::new(source(document, input, |scan| scan.float())?);
        self.sources.insert(name.to_owned(), Rc::clone(&read));
        Ok(read)
    }

    /// What the corners of a primitive refer to.
    fn inputs(&mut self, document: &Document, vertices: &Node, node: &Node) -> Result<Inputs, String> {
        let mut inputs = Inputs { stride: 1, vertex: 0, uv: None, normal: None };
        let mut has_vertex = false;
        let all = || document.children(node).filter(|child| child.name == "input");
        let offset =
            |input: &Node| input.attribute("offset").map_or(Some(0), |offset| offset.parse::<usize>().ok());
        for input in all() {
            let offset =
                offset(input).filter(|&offset| offset < 256).ok_or("an <input> has no readable offset")?;
            inputs.stride = inputs.stride.max(offset + 1);
            match input.attribute("semantic") {
                Some("VERTEX") => {
                    inputs.vertex = offset;
                    has_vertex = true;
                    // Attributes may come with the vertices themselves.
                    for own in document.children(vertices) {
                        match own.attribute("semantic") {
                            Some("NORMAL") => inputs.normal = Some((offset, self.source(document, own)?)),
                            Some("TEXCOORD") => inputs.uv = Some((offset, self.source(document, own)?)),
                            _ => {}
                        }
                    }
                }
                Some("NORMAL") => inputs.normal = Some((offset, self.source(document, input)?)),
                Some("TEXCOORD") if inputs.uv.is_none() => {
                    inputs.uv = Some((offset, self.source(document, input)?))
                }
                _ => {}
            }
        }
        if has_vertex { Ok(inputs) } else { Err(format!("a <{}> has no input for its vertices", node.name)) }
    }

    fn columns(&mut self) {
        let (faces, corners) = (self.soup.face_count(), self.soup.corners.len());
        if !self.uvs.is_empty() {
            self.uvs.resize(corners, Vec2::NAN);
            self.soup
                .corner_columns
                .push(Column::with_values(keys::CORNER_UV, std::mem::take(&mut self.uvs)));
        }
        if !self.normals.is_empty() {
            self.normals.resize(corners, Vec3::NAN);
            self.soup
                .corner_columns
                .push(Column::with_values(keys::CORNER_NORMAL, std::mem::take(&mut self.normals)));
        }
        let mut numbers = std::mem::take(&mut self.face_materials);
        numbers.resize(faces, NONE);
        let material = |number: &u32| self.materials.get(*number as usize);
        // Several materials here may be one by name: different colours of it.
        let mut names = Names::default();
        let of_material: Vec<u32> = self
            .materials
            .iter()
            .map(|material| if material.name.is_empty() { NONE } else { names.number(&material.name) })
            .collect();
        let named: Vec<u32> =
            numbers.iter().map(|&n| of_material.get(n as usize).copied().unwrap_or(NONE)).collect();
        if named.iter().any(|&name| name != NONE) {
            self.soup.face_columns.push(names.column(keys::FACE_MATERIAL, named));
        }
        if numbers.iter().any(|n| material(n).is_some_and(|material| material.color.is_some())) {
            let color = |n: &u32| material(n).and_then(|material| material.color).unwrap_or(Color::UNPAINTED);
            let colors = numbers.iter().map(color).collect();
            self.soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors));
        }
    }
}

/// A transformed direction of unit length; untouched, to the bit, where there is nothing to do.
fn direction(normal: Vec3, transform: DMat4) -> Vec3 {
    if transform == DMat4::IDENTITY {
        return normal;
    }
    transform.transform_vector3(normal.as_dvec3()).normalize_or_zero().as_vec3()
}
