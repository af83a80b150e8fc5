//! What the scene shows: its instances of geometries and controllers, placed in the world.

use super::transform;
use super::xml::{Document, Node};
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use glam::DMat4;
use halfedge::words::counted;
use std::collections::HashSet;

/// How many nodes may be visited beyond those that the document has: references repeat nodes.
const MAX_REPEATED_VISITS: usize = 100_000;

/// An instance of a geometry or a controller.
pub(super) struct Instance<'d, 'a> {
    pub name: String,
    /// The `<geometry>` or `<controller>`.
    pub content: &'d Node<'a>,
    /// The element that binds materials and skeletons to it; none for what no node shows.
    pub binding: Option<&'d Node<'a>>,
    pub transform: DMat4,
}

/// A node where a walk through the scene met it.
pub(super) struct Visit<'d, 'a> {
    pub node: &'d Node<'a>,
    /// From its coordinates to those of the world.
    pub world: DMat4,
    /// The number of the visit after those of everything inside the node.
    pub end: usize,
}

/// The instances of a document, in document order.
#[derive(Default)]
pub(super) struct Scene<'d, 'a> {
    pub instances: Vec<Instance<'d, 'a>>,
    /// Every node that was met, in document order.
    pub visits: Vec<Visit<'d, 'a>>,
}

/// A node whose children are being walked through.
struct Frame<'d, 'a> {
    node: &'d Node<'a>,
    next_child: Option<&'d Node<'a>>,
    world: DMat4,
    /// Its visit; none for the scene itself.
    visit: Option<usize>,
}

impl<'d, 'a> Scene<'d, 'a> {
    /// Walks through the scene that the document shows, or else its first one. Where no node shows a mesh,
    /// the geometries themselves are the instances. `axes` lead from the document's coordinates to the
    /// world's.
    pub(super) fn read(document: &'d Document<'a>, axes: DMat4, notes: &mut Notes) -> Self {
        let mut this = Self::default();
        let root = document.root();
        let shown = document
            .path(root, &["scene", "instance_visual_scene"])
            .and_then(|instance| document.target(instance.attribute("url")?))
            .or_else(|| document.path(root, &["library_visual_scenes", "visual_scene"]));
        if let Some(scene) = shown {
            this.walk(document, scene, axes, notes);
            let others: Vec<&str> = document
                .all("visual_scene")
                .filter(|other| other.index != scene.index)
                .map(Node::label)
                .collect();
            if !others.is_empty() {
                let count = counted(others.len(), "scene", "scenes");
                notes
                    .fault(Fault::Scene, format!("{count} besides the one shown: {}", first_few(&others, 6)));
            }
        }
        if this.instances.is_empty() {
            this.instances = geometries(document, axes);
            if shown.is_some() && !this.instances.is_empty() {
                notes.info("No node of the scene shows a mesh, so the geometries are shown as they are");
            }
        } else {
            this.note_empty_nodes(document, notes);
        }
        this.visit_libraries(document, axes);
        this
    }

    /// Visits nodes outside the scene as well where there are skins: some files have skeletons there.
    fn visit_libraries(&mut self, document: &'d Document<'a>, axes: DMat4) {
        if document.all("skin").next().is_none() {
            return;
        }
        let mut outside = Self { instances: Vec::new(), visits: std::mem::take(&mut self.visits) };
        for library in document.all("library_nodes") {
            outside.walk(document, library, axes, &mut Notes::default());
        }
        self.visits = outside.visits;
    }

    /// Walks through everything below `scene`, without recursion: files may nest nodes deeply.
    fn walk(&mut self, document: &'d Document<'a>, scene: &'d Node<'a>, axes: DMat4, notes: &mut Notes) {
        let max_visits = document.all("node").count() + MAX_REPEATED_VISITS;
        let mut path: HashSet<u32> = HashSet::new();
        let first = document.first_child(scene);
        let mut frames = vec![Frame { node: scene, next_child: first, world: axes, visit: None }];
        while let Some(frame) = frames.last_mut() {
            let Some(child) = frame.next_child else {
                path.remove(&frame.node.index);
                let end = self.visits.len();
                if let Some(visit) = frame.visit.and_then(|visit| self.visits.get_mut(visit)) {
                    visit.end = end;
                }
                frames.pop();
                continue;
            };
            frame.next_child = document.next_sibling(child);
            let (parent, world) = (frame.node, frame.world);
            let node = match child.name {
                "node" => child,
                "instance_node" => match target(document, child, &["node"]) {
                    Ok(node) => node,
                    Err(why) => {
                        notes.fault(
                            Fault::Scene,
                            format!("the node that node \"{}\" refers to: {why}", parent.label()),
                        );
                        continue;
                    }
                },
                "instance_geometry" | "instance_controller" => {
                    self.instance(document, parent, child, world, notes);
                    continue;
                }
                _ => continue,
            };
            if path.contains(&node.index) {
                notes.fault(Fault::Scene, format!("node \"{}\" inside itself", node.label()));
                continue;
            }
            if self.visits.len() >= max_visits {
                notes.fault(Fault::Scene, format!("all nodes of the scene after the first {max_visits}"));
                return;
            }
            match transform::of_node(document, node, notes) {
                Ok(own) => {
                    let world = world * own;
                    path.insert(node.index);
                    frames.push(Frame {
                        node,
                        next_child: document.first_child(node),
                        world,
                        visit: Some(self.visits.len()),
                    });
                    self.visits.push(Visit { node, world, end: usize::MAX });
                }
                Err(why) => {
                    notes.fault(Fault::Scene, format!("node \"{}\" with what is in it: {why}", node.label()));
                }
            }
        }
    }

    fn instance(
        &mut self,
        document: &'d Document<'a>,
        node: &Node,
        binding: &'d Node<'a>,
        transform: DMat4,
        notes: &mut Notes,
    ) {
        match target(document, binding, &["geometry", "controller"]) {
            Ok(content) => {
                let is_named = ["name", "id", "sid"].iter().any(|name| node.attribute(name).is_some());
                let name = if is_named { node.label() } else { content.label() }.to_owned();
                self.instances.push(Instance { name, content, binding: Some(binding), transform });
            }
            Err(why) => notes.fault(Fault::Scene, format!("what node \"{}\" shows: {why}", node.label())),
        }
    }

    /// Notes how many nodes show no mesh.
    fn note_empty_nodes(&self, document: &Document, notes: &mut Notes) {
        let shows = |node: &Node| {
            document
                .children(node)
                .any(|child| matches!(child.name, "instance_geometry" | "instance_controller"))
        };
        let empty = self.visits.iter().filter(|visit| !shows(visit.node)).count();
        if empty > 0 {
            notes.info(format!("Nodes of the scene that show no mesh are not kept: {empty}"));
        }
    }
}

/// All geometries of the document as instances.
pub(super) fn geometries<'d, 'a>(document: &'d Document<'a>, axes: DMat4) -> Vec<Instance<'d, 'a>> {
    let geometries = document.all("geometry").filter(|node| has_faces(document, node));
    let instance = |content: &'d Node<'a>| Instance {
        name: content.label().to_owned(),
        content,
        binding: None,
        transform: axes,
    };
    geometries.map(instance).collect()
}

/// Whether a geometry has a mesh of faces, rather than a spline or a solid.
pub(super) fn has_faces(document: &Document, geometry: &Node) -> bool {
    mesh(document, geometry).is_some()
}

/// The mesh of a geometry.
pub(super) fn mesh<'d, 'a>(document: &'d Document<'a>, geometry: &Node) -> Option<&'d Node<'a>> {
    document.child(geometry, "mesh").or_else(|| document.child(geometry, "convex_mesh"))
}

/// The element of one of these names that an instance refers to.
///
/// # Errors
/// In words, where there is none.
fn target<'d, 'a>(
    document: &'d Document<'a>,
    instance: &Node,
    names: &[&str],
) -> Result<&'d Node<'a>, String> {
    let find = |reference: &str| document.target(reference).filter(|node| names.contains(&node.name));
    let url = instance.attribute("url").unwrap_or_default();
    // A proxy stands in for something in another file.
    let found = find(url).or_else(|| find(instance.attribute("proxy")?));
    found.ok_or_else(|| document.why_missing(url))
}
