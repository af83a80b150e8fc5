//! Skins: vertices placed by the joints of a skeleton, in the pose that the scene has.

use super::numbers::numbers;
use super::scene::{Instance, Scene};
use super::source::Source;
use super::transform;
use super::xml::{Document, Node};
use crate::notes::{Fault, Notes};
use crate::soup::placement::{Influences, Placement, Skin};
use glam::DMat4;
use halfedge::words::counted;
use std::collections::HashMap;
use std::ops::Range;

/// How many roots of skeletons are looked at for an instance.
const MAX_SKELETON_ROOTS: usize = 16;

/// The placement of a skinned instance: in the pose that its joints have in the scene, or in the bind pose
/// where the skin or a joint can't be read. Notes which.
pub(super) fn place(
    document: &Document,
    skin: &Node,
    instance: &Instance,
    scene: &Joints,
    notes: &mut Notes,
) -> Placement {
    let bind_shape = document
        .child(skin, "bind_shape_matrix")
        .map_or(Ok(DMat4::IDENTITY), |node| transform::matrix(node, notes));
    let bind_shape = bind_shape.unwrap_or_else(|why| {
        notes.fault(Fault::Attribute, format!("the bind shape of \"{}\" left out: {why}", instance.name));
        DMat4::IDENTITY
    });
    let rest = instance.transform * bind_shape;
    match pose(document, skin, instance, scene, bind_shape, notes) {
        Ok(skin) => {
            let joints = counted(skin.joints.len(), "joint", "joints");
            notes.info(format!(
                "\"{}\" has the pose of its skeleton in the scene; the {joints} and their weights are not kept",
                instance.name
            ));
            Placement::Skinned(Skin { rest, ..skin })
        }
        Err(why) => {
            notes.fault(
                Fault::Attribute,
                format!(
                    "\"{}\" is in the pose in which it was bound to its skeleton, which is not kept: {why}",
                    instance.name
                ),
            );
            Placement::Rigid(rest)
        }
    }
}

fn pose(
    document: &Document,
    skin: &Node,
    instance: &Instance,
    scene: &Joints,
    bind_shape: DMat4,
    notes: &mut Notes,
) -> Result<Skin, String> {
    let label = instance.name.as_str();
    let joints = document.child(skin, "joints").ok_or("it has no <joints>")?;
    let names = source_of(document, joints, "JOINT").ok_or("its joints have no names")?;
    let names = document.target(names).ok_or("the names of its joints don't exist")?;
    let inverse_binds = source_of(document, joints, "INV_BIND_MATRIX");
    let inverse_binds =
        inverse_binds.map(|source| Source::<f64>::read(document, source, 16, label, notes)).transpose()?;
    let roots = scene.below_roots(document, instance);
    let array = document.children(names).find(|child| matches!(child.name, "Name_array" | "IDREF_array"));
    let array = array.ok_or("its joints have no names")?;
    let mut transforms = Vec::new();
    for (i, name) in array.word().split_whitespace().enumerate() {
        let world = scene.world(document, name, array.name == "IDREF_array", &roots);
        let world = world.ok_or_else(|| format!("its joint \"{name}\" is not in the scene"))?;
        let inverse_bind = inverse_binds.as_ref().and_then(|source| source.group(i)?.first_chunk::<16>());
        let inverse_bind = inverse_bind.map_or(DMat4::IDENTITY, |m| DMat4::from_cols_array(m).transpose());
        let whole = world * inverse_bind * bind_shape;
        if !whole.is_finite() {
            return Err(format!("its joint \"{name}\" has no finite transform"));
        }
        transforms.push(whole);
    }
    let weights = document.child(skin, "vertex_weights").ok_or("it has no <vertex_weights>")?;
    let influences = influences(document, weights, label, notes)?;
    Ok(Skin { joints: transforms, rest: DMat4::IDENTITY, influences })
}

/// The source that the input of this meaning names.
fn source_of<'d>(document: &'d Document, parent: &Node, semantic: &str) -> Option<&'d str> {
    let mut inputs = document.children_named(parent, "input");
    inputs.find(|input| input.attribute("semantic") == Some(semantic))?.attribute("source")
}

fn influences(
    document: &Document,
    weights: &Node,
    label: &str,
    notes: &mut Notes,
) -> Result<Influences, String> {
    let mut stride = 1;
    let (mut joint_offset, mut weight_offset) = (0, 0);
    for input in document.children_named(weights, "input") {
        let offset = input.number("offset").filter(|&offset| offset < 256).ok_or("an input has no offset")?;
        stride = stride.max(offset + 1);
        match input.attribute("semantic") {
            Some("JOINT") => joint_offset = offset,
            Some("WEIGHT") => weight_offset = offset,
            _ => {}
        }
    }
    let source = source_of(document, weights, "WEIGHT").ok_or("its joints have no weights")?;
    let source = Source::<f32>::read(document, source, 1, label, notes)?;
    let text = |name: &str| document.child(weights, name).map_or(&[][..], |node| node.text());
    let indices = numbers::<u32>(text("v"), None).values;
    let mut groups = indices.chunks_exact(stride);
    let mut influences = Influences { starts: vec![0], list: Vec::new() };
    for count in numbers::<u32>(text("vcount"), None).values {
        for group in groups.by_ref().take(count as usize) {
            let at = |offset: usize| group.get(offset).copied().unwrap_or(halfedge::NONE);
            let [weight] = source.get(at(weight_offset) as usize).unwrap_or_default();
            if weight.is_finite() && weight > 0.0 {
                influences.list.push((at(joint_offset), weight));
            }
        }
        influences.starts.push(influences.list.len() as u32);
    }
    Ok(influences)
}

/// The nodes of a scene by the names that skins know joints by.
pub(super) struct Joints<'s, 'd, 'a> {
    scene: &'s Scene<'d, 'a>,
    /// Visits by sid, in order.
    by_sid: HashMap<&'d str, Vec<usize>>,
    /// The first visit of each node.
    by_node: HashMap<u32, usize>,
}

impl<'s, 'd, 'a> Joints<'s, 'd, 'a> {
    pub(super) fn of(scene: &'s Scene<'d, 'a>) -> Self {
        let mut this = Self { scene, by_sid: HashMap::new(), by_node: HashMap::new() };
        for (i, visit) in scene.visits.iter().enumerate() {
            this.by_node.entry(visit.node.index).or_insert(i);
            if let Some(sid) = visit.node.attribute("sid") {
                this.by_sid.entry(sid).or_default().push(i);
            }
        }
        this
    }

    /// The visits below the roots of the skeletons that an instance names.
    fn below_roots(&self, document: &Document, instance: &Instance) -> Vec<Range<usize>> {
        let skeletons =
            instance.binding.into_iter().flat_map(|node| document.children_named(node, "skeleton"));
        let roots =
            skeletons.take(MAX_SKELETON_ROOTS).filter_map(|skeleton| document.target(&skeleton.word()));
        let visits = roots.filter_map(|root| self.by_node.get(&root.index).copied());
        visits.filter_map(|root| Some(root..self.scene.visits.get(root)?.end)).collect()
    }

    /// The transform to the world of the joint of this name, one below `roots` first. Programs mix up ids
    /// and sids.
    fn world(&self, document: &Document, name: &str, is_id: bool, roots: &[Range<usize>]) -> Option<DMat4> {
        let by_sid = || {
            let visits = self.by_sid.get(name)?;
            let below = |root: &Range<usize>| {
                let first = visits.partition_point(|&visit| visit < root.start);
                visits.get(first).filter(|&visit| root.contains(visit))
            };
            roots.iter().find_map(below).or(visits.first())
        };
        let by_id = || self.by_node.get(&document.target(name)?.index);
        let visit = if is_id { by_id().or_else(by_sid) } else { by_sid().or_else(by_id) };
        Some(self.scene.visits.get(*visit?)?.world)
    }
}
