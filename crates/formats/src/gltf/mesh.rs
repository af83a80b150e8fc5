//! Reading one instance of a mesh.

use super::buffers::Buffers;
use super::draco;
use super::faces::{Corners, Faces, Vertices};
use super::json::{Document, MESHES, Object};
use super::material::{FaceMaterial, Library};
use super::morph::{self, Steps};
use super::names::VERTEX_ID;
use super::primitive::{Mode, Primitive};
use super::rows::Rows;
use super::scene::{Instance, Scene};
use super::skin;
use crate::notes::{Fault, Notes};
use crate::soup::origin::Origin;
use crate::soup::placement::{Placement, Skin};
use glam::DMat4;
use halfedge::PolygonSoup;
use halfedge::words::counted;
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// The most sets of four joints that are read.
const MAX_JOINT_SETS: usize = 8;

/// Reads the meshes of a document.
pub(super) struct MeshReader<'b, 'a> {
    pub document: &'a Document,
    pub buffers: &'b Buffers<'a>,
    pub scene: &'b Scene<'a>,
    pub library: Library<'b, 'a>,
    pub notes: Notes,
    /// How many more corners and vertices may be read: instances can repeat a mesh, and a small file must not
    /// fill the memory that way.
    pub budget: usize,
}

/// The accessors that make up vertices.
type VertexKey = Vec<Option<usize>>;

/// The vertex numbers of a primitive's rows, with their placement.
type Placed = (Vec<u32>, Placement);

/// The state that the primitives of an instance share.
struct Shape {
    transform: DMat4,
    /// The transform of each joint from the bind pose to the world; `None` for a mesh without a skin.
    joints: Option<Vec<DMat4>>,
    /// The weights of morph targets.
    weights: Vec<f64>,
    faces: Faces,
    /// The vertices read so far, by their accessors: primitives often share vertices.
    known: HashMap<VertexKey, Rc<Placed>>,
    /// How many primitives of lines there are.
    lines: usize,
    /// Whether the vertices of lines are read as points.
    keeps_lines: bool,
    /// The names of attributes that the model can't hold.
    left_out: BTreeSet<String>,
}

impl<'a> MeshReader<'_, 'a> {
    /// Reads an instance. Returns `None` after noting why if nothing of it can be read.
    pub(super) fn soup(
        &mut self,
        instance: &Instance<'a>,
        origin: &mut Option<Origin>,
    ) -> Option<PolygonSoup> {
        let Some((number, mesh)) = instance.mesh else { return Some(PolygonSoup::default()) };
        let label = self.document.label(MESHES, number);
        let mut shape = Shape {
            transform: instance.transform,
            joints: self.joints(instance),
            weights: morph::weights(mesh, instance.node, &label, &mut self.notes),
            faces: Faces::new(*origin),
            known: HashMap::new(),
            lines: 0,
            keeps_lines: false,
            left_out: BTreeSet::new(),
        };
        let mut is_read = self.primitives(mesh, &label, &mut shape);
        if !is_read && shape.lines > 0 {
            shape.keeps_lines = true;
            is_read = self.primitives(mesh, &label, &mut shape);
        }
        self.note_left_out(&label, mesh.list("primitives").len(), &shape);
        *origin = shape.faces.origin;
        is_read.then(|| shape.faces.finish(&label, &mut self.notes))
    }

    /// Reads the primitives of a mesh. Returns whether any was kept.
    fn primitives(&mut self, mesh: Object<'a>, label: &str, shape: &mut Shape) -> bool {
        let primitives = mesh.objects("primitives");
        let count = primitives.len();
        let mut is_read = false;
        for (i, object) in primitives.enumerate() {
            let label = if count > 1 { format!("{label}, primitive {i}") } else { label.to_owned() };
            match self.primitive(object, &label, shape) {
                Ok(is_kept) => is_read |= is_kept,
                Err(why) => self.notes.fault(Fault::Faces, format!("{label}: {why}")),
            }
        }
        is_read
    }

    fn note_left_out(&mut self, label: &str, primitives: usize, shape: &Shape) {
        if primitives == 0 {
            self.notes.fault(Fault::Scene, format!("{label}: it has no primitives"));
        }
        if shape.lines > 0 {
            let sets = counted(shape.lines, "set", "sets");
            let kept = if shape.keeps_lines { ", whose vertices are kept" } else { "" };
            let what = format!("{label}: {sets} of lines{kept}; only faces are edited here");
            self.notes.fault(Fault::Scene, what);
        }
        if !shape.left_out.is_empty() {
            let names: Vec<&str> = shape.left_out.iter().map(String::as_str).collect();
            self.notes.fault(Fault::Attribute, format!("{label}: {} left out", names.join(", ")));
        }
    }

    /// The transforms of the joints of an instance's skin.
    fn joints(&mut self, instance: &Instance) -> Option<Vec<DMat4>> {
        let name = &instance.name;
        let joints = match instance.node?.index("skin") {
            Ok(None) => return None,
            Ok(Some(skin)) => skin::joints(self.document, self.buffers, self.scene, skin),
            Err(why) => Err(why),
        };
        match joints {
            Ok(joints) => {
                let count = counted(joints.len(), "joint", "joints");
                self.notes.info(format!(
                    "\"{name}\" has the pose of its skeleton in the scene; the {count} and their weights are not kept"
                ));
                Some(joints)
            }
            Err(why) => {
                let what = format!("\"{name}\" has not the pose of its skeleton, which is not kept: {why}");
                self.notes.fault(Fault::Attribute, what);
                None
            }
        }
    }

    /// Reads a primitive. Returns whether it was kept.
    fn primitive(&mut self, object: Object<'a>, label: &str, shape: &mut Shape) -> Result<bool, String> {
        let primitive = Primitive::open(self.document, self.buffers, object, label, &mut self.notes)?;
        if primitive.mode == Mode::Lines && !shape.keeps_lines {
            shape.lines += 1;
            return Ok(false);
        }
        let positions = primitive.attribute("POSITION")?.ok_or("it has no positions")?;
        let indices = primitive.indices()?;
        self.note_missing(label, "vertices", Some(&positions));
        self.note_missing(label, "indices", indices.as_ref());
        let key = vertex_key(&primitive, shape);
        let known = shape.known.get(&key).map(Rc::clone);
        let corners = indices.as_ref().map_or(positions.count, |indices| indices.count);
        let vertices = if known.is_none() { positions.count } else { 0 };
        self.budget = self
            .budget
            .checked_sub(corners.saturating_add(vertices))
            .ok_or("the scene repeats its meshes too many times, or promises more than the file has")?;
        let ids = self.attribute(&primitive, VERTEX_ID, label).filter(|ids| ids.width == 4);
        let material = self.material(object, label);
        let uv_name = uv_name(&primitive, material.as_deref());
        let used = ["POSITION", "NORMAL", "COLOR_0", &uv_name, if ids.is_some() { VERTEX_ID } else { "" }];
        self.gather_left_out(&primitive, &used, shape);
        let vertices = known.unwrap_or_else(|| {
            let placement = self.placement(&primitive, positions.count, label, shape);
            let vertices = Vertices {
                positions,
                position_steps: self.steps(&primitive, "POSITION", label, shape),
                colors: self.attribute(&primitive, "COLOR_0", label),
                ids,
                placement,
            };
            Rc::new((shape.faces.add_vertices(&vertices), vertices.placement))
        });
        shape.known.insert(key, Rc::clone(&vertices));
        if matches!(primitive.mode, Mode::Points | Mode::Lines) {
            return Ok(true);
        }
        let corners = Corners {
            indices,
            uvs: self.attribute(&primitive, &uv_name, label),
            uv_steps: self.steps(&primitive, &uv_name, label, shape),
            normals: self.attribute(&primitive, "NORMAL", label),
            normal_steps: self.steps(&primitive, "NORMAL", label, shape),
            colors: self.attribute(&primitive, "COLOR_0", label),
            color_steps: self.steps(&primitive, "COLOR_0", label, shape),
        };
        let (numbers, placement) = &*vertices;
        let left_out = shape.faces.add_triangles(primitive.mode, &corners, numbers, placement, material);
        if left_out > 0 {
            let triangles = counted(left_out, "triangle refers", "triangles refer");
            let vertices = counted(numbers.len(), "vertex", "vertices");
            self.notes.fault(Fault::Faces, format!("{label}: {triangles} to others than its {vertices}"));
        }
        Ok(true)
    }

    /// Notes rows beyond the end of their buffer.
    fn note_missing(&mut self, label: &str, what: &str, rows: Option<&Rows>) {
        if let Some(rows) = rows.filter(|rows| rows.missing > 0) {
            let all = rows.count.saturating_add(rows.missing);
            let text = format!("{label}: {} of its {all} {what} lie outside their buffer", rows.missing);
            self.notes.fault(Fault::Faces, text);
        }
    }

    /// The rows of an optional attribute. Notes why if they can't be read.
    fn attribute<'p>(&mut self, primitive: &Primitive<'p, 'a>, name: &str, label: &str) -> Option<Rows<'p>> {
        primitive.attribute(name).unwrap_or_else(|why| {
            self.notes.fault(Fault::Attribute, format!("{label}: {name} left out ({why})"));
            None
        })
    }

    fn steps<'p>(
        &mut self,
        primitive: &Primitive<'p, 'a>,
        name: &str,
        label: &str,
        shape: &Shape,
    ) -> Steps<'p> {
        Steps::read(primitive, &shape.weights, name, label, &mut self.notes)
    }

    fn material(&mut self, primitive: Object, label: &str) -> Option<Rc<FaceMaterial>> {
        let material = primitive.index("material").and_then(|index| {
            let material = index.map(|index| self.library.material(index, &mut self.notes));
            material.transpose()
        });
        material.unwrap_or_else(|why| {
            self.notes.fault(Fault::Attribute, format!("{label}: its material is left out ({why})"));
            None
        })
    }

    /// The placement of a primitive's vertices.
    fn placement(
        &mut self,
        primitive: &Primitive<'_, 'a>,
        count: usize,
        label: &str,
        shape: &Shape,
    ) -> Placement {
        let Some(joints) = &shape.joints else { return Placement::Rigid(shape.transform) };
        let mut sets = Vec::new();
        for set in 0..MAX_JOINT_SETS {
            let mut rows = |name: &str| self.attribute(primitive, &format!("{name}_{set}"), label);
            let Some(pair) = rows("JOINTS").zip(rows("WEIGHTS")) else { break };
            sets.push(pair);
        }
        if sets.is_empty() {
            self.notes.fault(Fault::Attribute, format!("{label}: none of its vertices names a joint"));
            return Placement::Rigid(shape.transform);
        }
        let influences = skin::influences(&sets, count);
        Placement::Skinned(Skin { joints: joints.clone(), rest: shape.transform, influences })
    }

    /// Collects the names of the attributes that are not `used`.
    fn gather_left_out(&mut self, primitive: &Primitive, used: &[&str], shape: &mut Shape) {
        for name in primitive.attributes().filter(|name| !used.contains(name)) {
            let is_joint = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
            if name == "TANGENT" {
                self.notes.info("Tangents are not kept: they follow from normals and texture coordinates");
            } else if !(is_joint && shape.joints.is_some()) {
                shape.left_out.insert(name.to_owned());
            }
        }
    }
}

/// The accessors and the compressed data that make up the vertices of a primitive.
fn vertex_key(primitive: &Primitive, shape: &Shape) -> VertexKey {
    let accessor = |name: &str| primitive.accessor(name).ok().flatten();
    let mut key: VertexKey = ["POSITION", "COLOR_0", VERTEX_ID].map(accessor).to_vec();
    if shape.joints.is_some() {
        let sets =
            (0..MAX_JOINT_SETS).flat_map(|set| ["JOINTS", "WEIGHTS"].map(|name| format!("{name}_{set}")));
        key.extend(sets.map(|name| accessor(&name)));
    }
    let targets = primitive.object.objects("targets").take(shape.weights.len());
    key.extend(targets.map(|target| target.index("POSITION").ok().flatten()));
    let compressed = primitive.object.extension(draco::EXTENSION);
    key.push(compressed.and_then(|compressed| compressed.index("bufferView").ok().flatten()));
    key
}

/// The name of the attribute with the texture coordinates of a material, or of the first set if it is missing.
fn uv_name(primitive: &Primitive, material: Option<&FaceMaterial>) -> String {
    let name = format!("TEXCOORD_{}", material.map_or(0, |material| material.uv_set));
    match primitive.accessor(&name) {
        Ok(None) => "TEXCOORD_0".to_owned(),
        _ => name,
    }
}
