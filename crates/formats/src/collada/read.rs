//! Reading a COLLADA document: the scene's instances, each as an object.

use super::geometry::Geometry;
use super::transform;
use super::xml::{Document, Node, decode};
use crate::import::{ImportedObject, NamedBytes, ReadError, Reading, build};
use crate::report::{ImportReport, counted};
use glam::DMat4;
use halfedge::Progress;
use std::collections::HashSet;

/// Whether the file starts like a COLLADA document.
pub(crate) fn looks_like(bytes: &[u8]) -> bool {
    let head = decode(bytes.get(..4096).unwrap_or(bytes));
    head.trim_start().starts_with('<') && head.contains("<COLLADA")
}

/// An instance of a geometry, found in the scene.
struct Instance<'d, 'a> {
    name: String,
    geometry: &'d Node<'a>,
    /// What binds materials to it.
    binding: Option<&'d Node<'a>>,
    transform: DMat4,
}

/// Reads one document: an object for each instance, or for each geometry if no scene has any.
pub(crate) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(Vec<ImportedObject>, ImportReport), ReadError> {
    let fail = |message: String| ReadError::file(&file.name, message);
    let text = decode(&file.bytes);
    let document = Document::read(&text).map_err(|why| match looks_like(&file.bytes) {
        true => fail(why),
        false => ReadError::not_a(file, "a COLLADA document", &why),
    })?;
    if progress(0.3).is_break() {
        return Err(ReadError::Cancelled);
    }
    let mut report = ImportReport::default();
    let (axes, note) = transform::of_document(&document);
    if let Some(note) = note {
        report.info(note);
    }
    let mut scene = Scene { document: &document, instances: Vec::new(), visits: 0, skins: 0 };
    scene.find(axes).map_err(fail)?;
    if scene.skins > 0 {
        report.info("Skeletons and shapes to blend to are not kept: meshes are as they were modelled");
    }
    if scene.instances.is_empty() {
        return Err(fail("the document holds no mesh".to_owned()));
    }
    let mut objects = Vec::new();
    let mut troubles = Vec::new();
    let mut corners = 0;
    let (mut cut, mut filled, mut lines) = (0, 0, 0);
    let total = scene.instances.len();
    for (i, instance) in scene.instances.iter().enumerate() {
        let (node, binding, transform) = (instance.geometry, instance.binding, instance.transform);
        let geometry =
            Geometry::read(&document, node, binding, transform, &mut reading.origin).map_err(fail)?;
        // Instances may repeat a geometry; a small file must not fill the memory that way.
        corners += geometry.soup.corners.len() + geometry.soup.positions.len();
        if corners > file.bytes.len().saturating_mul(8).max(4_000_000) {
            return Err(fail("its scene repeats its meshes too many times".to_owned()));
        }
        cut += geometry.cut;
        filled += geometry.filled;
        lines += geometry.lines;
        let label = node.label();
        troubles.extend(geometry.troubles.iter().map(|what| format!("geometry \"{label}\": {what}")));
        let part = |fraction: f32| 0.3 + 0.7 * (i as f32 + fraction) / total as f32;
        let mut notes = ImportReport::default();
        let mut progress = |fraction| progress(part(fraction));
        let object = build(&instance.name, geometry.soup, &file.name, reading, &mut notes, &mut progress)?;
        report.append(if total > 1 { notes.prefixed(&instance.name) } else { notes });
        objects.push(object);
    }
    report_troubles(troubles, &mut report);
    if cut > 0 {
        report.info(format!(
            "{} with holes cut into triangles: faces have one outline here",
            counted(cut, "polygon", "polygons")
        ));
    }
    if filled > 0 {
        report.warn(format!(
            "The holes of {} were filled: they don't lie inside it, apart from each other",
            counted(filled, "polygon", "polygons")
        ));
    }
    if lines > 0 {
        report
            .warn(format!("{} of lines left out: only faces are edited here", counted(lines, "set", "sets")));
    }
    Ok((objects, report))
}

/// Warns of the first few faces that are not there in full; instances of a geometry repeat them.
fn report_troubles(troubles: Vec<String>, report: &mut ImportReport) {
    const SHOWN: usize = 6;
    let mut met = HashSet::new();
    for trouble in troubles {
        if !met.contains(&trouble) && met.len() < SHOWN {
            report.warn(format!("Faces left out: {trouble}"));
        }
        met.insert(trouble);
    }
    if met.len() > SHOWN {
        let more = counted(met.len() - SHOWN, "primitive", "primitives");
        report.warn(format!("Faces left out: {more} more of the same kind"));
    }
}

struct Scene<'d, 'a> {
    document: &'d Document<'a>,
    instances: Vec<Instance<'d, 'a>>,
    visits: usize,
    skins: usize,
}

impl<'d, 'a> Scene<'d, 'a> {
    fn find(&mut self, axes: DMat4) -> Result<(), String> {
        let document = self.document;
        let root = document.root();
        let scene = document
            .path(root, &["scene", "instance_visual_scene"])
            .and_then(|instance| document.target(instance.attribute("url")?))
            .or_else(|| document.path(root, &["library_visual_scenes", "visual_scene"]));
        if let Some(scene) = scene {
            self.nodes(scene, axes, 0)?;
        }
        if self.instances.is_empty() {
            let libraries = document.children(root).filter(|child| child.name == "library_geometries");
            for geometry in libraries.flat_map(|library| document.children(library)) {
                if document.child(geometry, "mesh").is_some() {
                    let name = geometry.label().to_owned();
                    self.instances.push(Instance { name, geometry, binding: None, transform: axes });
                }
            }
        }
        Ok(())
    }

    /// The instances in the nodes inside `parent`. Nodes may refer to nodes: the number of visits
    /// is limited.
    fn nodes(&mut self, parent: &'d Node<'a>, transform: DMat4, depth: usize) -> Result<(), String> {
        self.visits += 1;
        if depth > 64 || self.visits > 100_000 {
            return Err("the nodes of its scene refer to each other without end".to_owned());
        }
        let document = self.document;
        for child in document.children(parent) {
            let target = || child.attribute("url").and_then(|url| document.target(url));
            match child.name {
                "node" => {
                    let here = transform * transform::of_node(document, child)?;
                    self.nodes(child, here, depth + 1)?;
                }
                "instance_node" => {
                    if let Some(node) = target().filter(|node| node.name == "node") {
                        let here = transform * transform::of_node(document, node)?;
                        self.nodes(node, here, depth + 1)?;
                    }
                }
                "instance_geometry" => {
                    let url = child.attribute("url").unwrap_or_default();
                    let geometry = target().filter(|node| node.name == "geometry").ok_or_else(|| {
                        format!("node \"{}\" shows geometry \"{url}\", which doesn't exist", parent.label())
                    })?;
                    self.instance(parent, child, geometry, transform);
                }
                "instance_controller" => {
                    self.skins += 1;
                    let skin = target().and_then(|controller| document.child(controller, "skin"));
                    let source = skin.and_then(|skin| document.target(skin.attribute("source")?));
                    if let Some(geometry) = source.filter(|node| node.name == "geometry") {
                        self.instance(parent, child, geometry, transform);
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn instance(&mut self, node: &Node, binding: &'d Node<'a>, geometry: &'d Node<'a>, transform: DMat4) {
        // Splines and such are geometries too.
        if self.document.child(geometry, "mesh").is_some() {
            let name = if node.name == "node" { node.label() } else { geometry.label() }.to_owned();
            self.instances.push(Instance { name, geometry, binding: Some(binding), transform });
        }
    }
}
