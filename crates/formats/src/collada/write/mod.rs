//! Writing a COLLADA 1.4.1 document: Y up, in metres, one geometry and node for each object.

mod escape;
mod geometry;
mod material;

use crate::file::NamedBytes;
use crate::model::Model;
use escape::escape;
use material::Materials;
pub(crate) use material::keeps;

/// Writes the objects into one document, and the images that their materials use beside it. Read again,
/// they are the same meshes.
pub(crate) fn write(model: &Model) -> Vec<NamedBytes> {
    let mut materials = Materials::of(model);
    let mut geometries = Vec::new();
    let mut nodes = String::new();
    for (number, object) in model.objects.iter().enumerate() {
        let mesh = object.mesh.to_compact();
        let used =
            geometry::write(&mut geometries, number, &object.name, &mesh, model.offset, &mut materials);
        let label = escape(&object.name);
        nodes +=
            &format!("<node id=\"node{number}\" name=\"{label}\"><instance_geometry url=\"#mesh{number}\">");
        if !used.is_empty() {
            nodes += "<bind_material><technique_common>";
            used.into_iter().for_each(|material| nodes += &materials.instance(material));
            nodes += "</technique_common></bind_material>";
        }
        nodes += "</instance_geometry></node>\n";
    }
    let mut out = b"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
        <COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\n\
        <asset><contributor><authoring_tool>Meshwright</authoring_tool></contributor>\
        <created>2000-01-01T00:00:00Z</created><modified>2000-01-01T00:00:00Z</modified>\
        <unit name=\"meter\" meter=\"1\"/><up_axis>Y_UP</up_axis></asset>\n"
        .to_vec();
    out.extend_from_slice(materials.libraries().as_bytes());
    out.extend_from_slice(b"<library_geometries>\n");
    out.extend_from_slice(&geometries);
    out.extend_from_slice(b"</library_geometries>\n<library_visual_scenes><visual_scene id=\"scene\">\n");
    out.extend_from_slice(nodes.as_bytes());
    out.extend_from_slice(
        b"</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene url=\"#scene\"/></scene>\n</COLLADA>\n",
    );
    let mut files = vec![NamedBytes { name: format!("{}.dae", model.name), bytes: out }];
    files.extend(materials.image_files());
    files
}
