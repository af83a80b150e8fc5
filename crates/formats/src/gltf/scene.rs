//! The scene: instances of meshes with their transforms.

use super::json::{Document, MESHES, NODES, Object, SCENES};
use super::names::GENERATOR;
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use glam::DMat4;
use halfedge::words::counted;

/// A mesh that a node shows.
pub(super) struct Instance<'d> {
    pub name: String,
    /// The mesh and its index; `None` for an empty object in a file of ours.
    pub mesh: Option<(usize, Object<'d>)>,
    /// The node; `None` for a mesh that no node shows.
    pub node: Option<Object<'d>>,
    pub transform: DMat4,
}

/// The instances of a document in node order, and the transforms of all nodes.
#[derive(Default)]
pub(super) struct Scene<'d> {
    pub instances: Vec<Instance<'d>>,
    /// The transform of each node to the world; `None` for nodes that can't be placed.
    pub worlds: Vec<Option<DMat4>>,
    /// How many nodes of the scene show no mesh.
    empty_nodes: usize,
}

impl<'d> Scene<'d> {
    /// Reads the default scene, or else the first one; all nodes if there is no scene. If no node shows a
    /// mesh, all meshes become instances.
    pub(super) fn read(document: &'d Document, notes: &mut Notes) -> Self {
        let mut this = Self { worlds: vec![None; document.count(NODES)], ..Self::default() };
        let mut walk = Walk::new(document);
        let roots = walk.roots();
        let scenes = document.count(SCENES);
        let shown = document.root().index_or("scene", 0).unwrap_or(0);
        match document.item(SCENES, shown).or_else(|_| document.item(SCENES, 0)) {
            Ok(scene) => this.show(&mut walk, indices(scene, "nodes"), notes),
            Err(_) => this.show(&mut walk, roots.clone(), notes),
        }
        if scenes > 1 {
            let others = (0..scenes).filter(|&scene| scene != shown);
            let others: Vec<String> = others.map(|scene| document.label(SCENES, scene)).collect();
            let count = counted(others.len(), "scene", "scenes");
            notes.fault(Fault::Scene, format!("{count} besides the one shown: {}", first_few(&others, 6)));
        }
        // Skins may have joints outside the scene.
        walk.all(roots, notes, |index, _, world| {
            if let Some(place) = this.worlds.get_mut(index) {
                *place = Some(world);
            }
        });
        this.note_rest(document, notes);
        this
    }

    fn show(&mut self, walk: &mut Walk<'d>, roots: Vec<usize>, notes: &mut Notes) {
        let document = walk.document;
        let generator = document.root().object("asset").and_then(|asset| asset.text("generator"));
        let is_ours = generator == Some(GENERATOR);
        let mut instances = Vec::new();
        let mut faults = Vec::new();
        walk.all(roots, notes, |index, node, transform| {
            if let Some(place) = self.worlds.get_mut(index) {
                *place = Some(transform);
            }
            let named = |other: Option<&str>| match node.name().or(other) {
                Some(name) => name.to_owned(),
                None => format!("mesh {index}"),
            };
            let mesh = node.index("mesh").and_then(|mesh| match mesh {
                Some(mesh) => document.item(MESHES, mesh).map(|item| Some((mesh, item))),
                None => Ok(None),
            });
            match mesh {
                Ok(Some((number, mesh))) => {
                    let name = node.name().or(mesh.name());
                    let name = name.map_or_else(|| format!("mesh {number}"), str::to_owned);
                    let (mesh, node) = (Some((number, mesh)), Some(node));
                    instances.push(Instance { name, mesh, node, transform });
                }
                Ok(None) if is_ours => {
                    let name = named(None);
                    instances.push(Instance { name, mesh: None, node: Some(node), transform });
                }
                Ok(None) => self.empty_nodes += 1,
                Err(why) => {
                    faults.push(format!("what {} shows: {why}", document.label(NODES, index)));
                }
            }
        });
        faults.into_iter().for_each(|fault| notes.fault(Fault::Scene, fault));
        self.instances = instances;
    }

    /// Notes meshes and nodes that aren't kept, or makes all meshes instances if no node shows one.
    fn note_rest(&mut self, document: &'d Document, notes: &mut Notes) {
        let mut is_shown = vec![false; document.count(MESHES)];
        for (mesh, _) in self.instances.iter().filter_map(|instance| instance.mesh) {
            if let Some(is_shown) = is_shown.get_mut(mesh) {
                *is_shown = true;
            }
        }
        let others = is_shown.iter().enumerate().filter(|(_, is_shown)| !**is_shown).map(|(mesh, _)| mesh);
        if !self.instances.is_empty() {
            for mesh in others {
                let label = document.label(MESHES, mesh);
                notes.fault(Fault::Scene, format!("{label}, which the scene doesn't show"));
            }
            if self.empty_nodes > 0 {
                let nodes = counted(self.empty_nodes, "node", "nodes");
                notes.info(format!("{nodes} of the scene without a mesh not kept"));
            }
            return;
        }
        self.instances = meshes(document);
        if !self.instances.is_empty() && document.count(SCENES) > 0 {
            notes.info("No node of the scene shows a mesh: the meshes are taken as they are");
        }
    }
}

/// All meshes of a document as instances.
pub(super) fn meshes(document: &Document) -> Vec<Instance<'_>> {
    let meshes = document.items(MESHES).enumerate().map(|(number, mesh)| Instance {
        name: mesh.name().map_or_else(|| format!("mesh {number}"), str::to_owned),
        mesh: Some((number, mesh)),
        node: None,
        transform: DMat4::IDENTITY,
    });
    meshes.collect()
}

/// The whole numbers in a list, without any other values.
fn indices(object: Object, key: &str) -> Vec<usize> {
    object.list(key).iter().filter_map(super::json::whole).collect()
}

/// A walk through nodes that visits each at most once.
struct Walk<'d> {
    document: &'d Document,
    is_met: Vec<bool>,
}

impl<'d> Walk<'d> {
    fn new(document: &'d Document) -> Self {
        Self { document, is_met: vec![false; document.count(NODES)] }
    }

    /// The nodes that are no children of others.
    fn roots(&self) -> Vec<usize> {
        let mut is_child = vec![false; self.is_met.len()];
        for child in self.document.items(NODES).flat_map(|node| indices(node, "children")) {
            if let Some(is_child) = is_child.get_mut(child) {
                *is_child = true;
            }
        }
        is_child.iter().enumerate().filter(|(_, is_child)| !**is_child).map(|(node, _)| node).collect()
    }

    /// Visits roots and their descendants in document order, each with its transform to the world. Doesn't
    /// recurse, as files may nest nodes deeply.
    fn all(&mut self, roots: Vec<usize>, notes: &mut Notes, mut visit: impl FnMut(usize, Object<'d>, DMat4)) {
        let document = self.document;
        let mut open: Vec<(usize, DMat4, bool)> =
            roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY, true)).collect();
        while let Some((index, parent, is_root)) = open.pop() {
            let label = || document.label(NODES, index);
            let node = match document.item(NODES, index) {
                Ok(node) => node,
                Err(why) => {
                    notes.fault(Fault::Scene, why);
                    continue;
                }
            };
            // Nodes must form trees; a cycle would never end.
            if self.is_met.get_mut(index).is_none_or(|is_met| std::mem::replace(is_met, true)) {
                if !is_root {
                    notes.fault(Fault::Scene, format!("{} where it is in the scene again", label()));
                }
                continue;
            }
            let world = node.transform().map(|own| parent * own);
            match world {
                Ok(world) if world.is_finite() => {
                    visit(index, node, world);
                    let children = indices(node, "children");
                    open.extend(children.into_iter().rev().map(|child| (child, world, false)));
                }
                Ok(_) => notes.fault(
                    Fault::Scene,
                    format!("{} with what is in it: its transforms give no finite numbers", label()),
                ),
                Err(why) => {
                    notes.fault(Fault::Scene, format!("{} with what is in it: {why}", label()));
                }
            }
        }
    }
}
