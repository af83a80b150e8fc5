//! Primitives: lists of polygons, triangles, strips and fans.

use super::faces::{Faces, Input, Inputs};
use super::numbers::numbers;
use super::source::Source;
use super::xml::{Document, Node};
use crate::notes::{Fault, Notes};
use halfedge::words::counted;
use std::collections::HashMap;
use std::rc::Rc;

/// The largest offset of an input.
const MAX_OFFSET: usize = 255;

/// The sets of texture coordinates that a material uses.
#[derive(Debug, Default)]
pub(super) struct UvSets {
    /// The one that corners should have, if that is known.
    pub main: Option<usize>,
    /// Further ones, each with what uses it: "\"wood\": its emissive texture".
    pub others: Vec<(usize, String)>,
}

/// Reads the primitives of one mesh.
pub(super) struct Primitives<'r, 'd, 'a> {
    document: &'d Document<'a>,
    /// The `<vertices>` of the mesh.
    vertices: &'d Node<'a>,
    /// What notes call the geometry.
    label: &'d str,
    /// Sources read so far, by name and width: primitives share them. None for those that can't be read.
    sources: HashMap<(&'d str, usize), Option<Rc<Source>>>,
    notes: &'r mut Notes,
}

/// An attribute that corners have, before its source is read.
struct Candidate<'d> {
    set: usize,
    offset: usize,
    source: &'d str,
}

impl<'r, 'd, 'a> Primitives<'r, 'd, 'a> {
    pub(super) fn new(
        document: &'d Document<'a>,
        vertices: &'d Node<'a>,
        label: &'d str,
        notes: &'r mut Notes,
    ) -> Self {
        Self { document, vertices, label, sources: HashMap::new(), notes }
    }

    /// Adds the faces of a primitive. `uv_sets` are the sets of texture coordinates that its material uses.
    pub(super) fn read(&mut self, node: &Node<'a>, uv_sets: Option<&UvSets>, faces: &mut Faces) {
        let inputs = match self.inputs(node, uv_sets) {
            Ok(inputs) => inputs,
            Err(why) => return self.fault(node, &why),
        };
        let (before, first) = (self.notes.count(), faces.soup.face_count());
        match node.name {
            "polylist" => self.polylist(node, &inputs, faces),
            "polygons" => self.polygons(node, &inputs, faces),
            _ => self.triangles(node, &inputs, faces),
        }
        let count = node.number("count").unwrap_or(0);
        if count > 0
            && faces.soup.face_count() == first
            && self.notes.count() == before
            && !faces.has_faults()
        {
            self.fault(node, &format!("none of its {}", counted(count, "face", "faces")));
        }
    }

    /// Notes what is wrong with a primitive: "it has …".
    fn fault(&mut self, node: &Node, what: &str) {
        let label = self.label;
        self.notes.fault(Fault::Faces, format!("geometry \"{label}\": a <{}> has {what}", node.name));
    }

    /// Notes numbers behind the last whole face.
    fn left_over(&mut self, node: &Node, count: usize) {
        if count > 0 {
            let numbers = counted(count, "number", "numbers");
            self.fault(node, &format!("{numbers} in its <p> after the last whole face"));
        }
    }

    /// The numbers in an element of a primitive. Unreadable ones stand for nothing that exists.
    fn numbers(&mut self, node: &Node, list: &Node) -> Vec<u32> {
        let read = numbers::<u32>(list.text(), None);
        if let Err(why) = read.note_commas(self.notes) {
            self.fault(node, &format!("a <{}> with {why}", list.name));
        }
        read.values
    }

    fn polylist(&mut self, node: &Node, inputs: &Inputs, faces: &mut Faces) {
        let counts = self.document.child(node, "vcount");
        let has_counts = counts.is_some();
        let counts = counts.map_or(Vec::new(), |counts| self.numbers(node, counts));
        let Some(list) = self.document.child(node, "p") else {
            if !counts.is_empty() {
                self.fault(node, "no <p>");
            }
            return;
        };
        let indices = self.numbers(node, list);
        if !has_counts && !indices.is_empty() {
            return self.fault(node, "no <vcount>, which says how many corners each face has");
        }
        let mut rest = indices.as_slice();
        for (i, &count) in counts.iter().enumerate() {
            let numbers = (count as usize).saturating_mul(inputs.stride);
            let Some((face, after)) = rest.split_at_checked(numbers) else {
                let missing = counted(counts.len() - i, "face", "faces");
                return self.fault(
                    node,
                    &format!("fewer numbers in its <p> than its <vcount> says ({missing} missing)"),
                );
            };
            rest = after;
            faces.add(face, inputs);
        }
        self.left_over(node, rest.len());
    }

    fn polygons(&mut self, node: &Node, inputs: &Inputs, faces: &mut Faces) {
        let document = self.document;
        for child in document.children(node) {
            match child.name {
                "p" => {
                    let corners = self.numbers(node, child);
                    self.left_over(node, corners.len() % inputs.stride);
                    faces.add(&corners, inputs);
                }
                "ph" => {
                    let Some(outline) = document.child(child, "p") else {
                        self.fault(node, "a <ph> without <p>, its outline");
                        continue;
                    };
                    let outline = self.numbers(node, outline);
                    let holes = document.children_named(child, "h");
                    let holes: Vec<Vec<u32>> = holes.map(|hole| self.numbers(node, hole)).collect();
                    faces.add_with_holes(&outline, &holes, inputs);
                }
                _ => {}
            }
        }
    }

    /// Triangles, strips and fans.
    fn triangles(&mut self, node: &Node, inputs: &Inputs, faces: &mut Faces) {
        let mut corners: Vec<u32> = Vec::new();
        for list in self.document.children_named(node, "p") {
            let indices = self.numbers(node, list);
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
                faces.add(&corners, inputs);
            };
            match node.name {
                "triangles" => groups.as_chunks::<3>().0.iter().for_each(|three| triangle(*three)),
                "tristrips" => {
                    for (i, three) in groups.windows(3).enumerate() {
                        let &[a, b, c] = three else { continue };
                        triangle(if i % 2 == 0 { [a, b, c] } else { [b, a, c] });
                    }
                }
                _ => {
                    let Some((hub, rim)) = groups.split_first() else { continue };
                    for two in rim.windows(2) {
                        let &[b, c] = two else { continue };
                        triangle([hub, b, c]);
                    }
                }
            }
        }
    }

    /// What the corners of a primitive refer to.
    ///
    /// # Errors
    /// What the primitive has that keeps it from being read.
    fn inputs(&mut self, node: &Node<'a>, uv_sets: Option<&UvSets>) -> Result<Inputs, String> {
        let document = self.document;
        let mut stride = 1;
        let mut vertex = None;
        let (mut uvs, mut normals, mut colors) = (Vec::new(), Vec::new(), Vec::new());
        let mut add = |notes: &mut Notes, input: &'d Node<'a>, offset: usize| {
            let source = input.attribute("source").unwrap_or_default();
            let candidate = Candidate { set: input.number("set").unwrap_or(0), offset, source };
            match input.attribute("semantic").unwrap_or_default() {
                "TEXCOORD" => uvs.push(candidate),
                "NORMAL" => normals.push(candidate),
                "COLOR" => colors.push(candidate),
                "VERTEX" | "POSITION" => {}
                other => notes.info(format!("The corner attribute {other} is not kept")),
            }
        };
        // Old files call the offset "idx".
        let offset_of = |input: &Node| match input.attribute("offset").or(input.attribute("idx")) {
            None => Some(0),
            Some(text) => text.trim().parse::<usize>().ok().filter(|&offset| offset <= MAX_OFFSET),
        };
        for input in document.children_named(node, "input") {
            let offset = offset_of(input).ok_or("an <input> without a readable offset")?;
            stride = stride.max(offset + 1);
            add(self.notes, input, offset);
            if input.attribute("semantic") == Some("VERTEX") {
                vertex = Some(offset);
            }
        }
        let vertex = vertex.ok_or("no <input> for its vertices")?;
        // Attributes may come with the vertices themselves.
        for input in document.children_named(self.vertices, "input") {
            add(self.notes, input, vertex);
        }
        let uv = self.pick(uvs, uv_sets, 2, "texture coordinates");
        let normal = self.pick(normals, None, 3, "normals");
        let color = self.pick(colors, None, 4, "colours");
        Ok(Inputs { stride, vertex, uv, normal, color })
    }

    /// The attribute of the main set, else that of the lowest one; notes the others. `what` names its values.
    fn pick(
        &mut self,
        mut candidates: Vec<Candidate<'d>>,
        uv_sets: Option<&UvSets>,
        width: usize,
        what: &str,
    ) -> Option<Input> {
        let wanted = uv_sets.and_then(|sets| sets.main);
        candidates.sort_by_key(|candidate| (Some(candidate.set) != wanted, candidate.set));
        let (first, others) = candidates.split_first()?;
        let differs = |other: &&Candidate| (other.source, other.offset) != (first.source, first.offset);
        for (set, user) in uv_sets.map_or(&[][..], |sets| &sets.others) {
            if others.iter().filter(differs).any(|other| other.set == *set) {
                let uses = "uses another set of texture coordinates, which corners don't have here";
                self.notes.fault(Fault::Material, format!("{user} {uses}"));
            }
        }
        let others = others.iter().filter(differs).count();
        let label = self.label;
        if others > 0 {
            let others = counted(others, "set", "sets");
            self.notes.fault(
                Fault::Attribute,
                format!("geometry \"{label}\": {others} of {what} left out (corners have one here)"),
            );
        }
        self.source(first.source, width, what).map(|source| (first.offset, source))
    }

    /// The source of this name, read once; a note says where its `what` can't be read.
    fn source(&mut self, name: &'d str, width: usize, what: &str) -> Option<Rc<Source>> {
        if let Some(known) = self.sources.get(&(name, width)) {
            return known.clone();
        }
        let label = self.label;
        let source = match Source::read(self.document, name, width, label, self.notes) {
            Ok(source) => Some(Rc::new(source)),
            Err(why) => {
                self.notes.fault(Fault::Attribute, format!("geometry \"{label}\" has no {what}: {why}"));
                None
            }
        };
        self.sources.insert((name, width), source.clone());
        source
    }

    /// The colours that come with the vertices themselves.
    pub(super) fn vertex_colors(&mut self) -> Option<Rc<Source>> {
        let mut inputs = self.document.children_named(self.vertices, "input");
        let input = inputs.find(|input| input.attribute("semantic") == Some("COLOR"))?;
        self.source(input.attribute("source").unwrap_or_default(), 4, "colours")
    }
}
