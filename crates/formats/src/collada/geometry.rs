//! One geometry as one instance shows it, as polygon soup.

use super::controller::{Morph, position_input};
use super::faces::Faces;
use super::material::{Library, Palette};
use super::numbers::Number;
use super::primitive::Primitives;
use super::scene::{Instance, mesh};
use super::source::Source;
use super::xml::{Document, Node};
use crate::notes::{Fault, Notes};
use crate::soup::origin::Origin;
use crate::soup::placement::Placement;
use glam::{DVec3, Vec3};
use halfedge::words::counted;
use halfedge::{NONE, PolygonSoup};

/// A geometry as an instance shows it.
pub(super) struct Shown<'r, 'd, 'a> {
    pub geometry: &'d Node<'a>,
    pub instance: &'r Instance<'d, 'a>,
    pub placement: Placement,
    pub morph: Option<Morph>,
}

/// Reads a geometry, placed and blended. What can't be read is noted.
///
/// # Errors
/// In words, where it has no mesh or its positions can't be read.
pub(super) fn read<'d, 'a>(
    document: &'d Document<'a>,
    shown: &Shown<'_, 'd, 'a>,
    origin: &mut Option<Origin>,
    library: &mut Library<'d, 'a>,
    notes: &mut Notes,
) -> Result<PolygonSoup, String> {
    let Shown { geometry, instance, placement, morph } = shown;
    let label = geometry.label();
    let mesh = mesh(document, geometry).ok_or_else(|| unreadable(document, geometry))?;
    if let Some(hull) = mesh.attribute("convex_hull_of") {
        return Err(format!("it is the convex hull of \"{hull}\", which is not made here"));
    }
    let source = position_input(document, mesh)?;
    let vertices = document.child(mesh, "vertices").ok_or("it has no <vertices>")?;
    let positions = match origin {
        None => positions::<f32>(document, source, label, notes, |i, [x, y, z]| {
            let position = Vec3::new(x, y, z);
            if placement.is_identity() && morph.is_none() {
                return position;
            }
            place(i, position.as_dvec3(), shown).as_vec3()
        }),
        Some(origin) => positions::<f64>(document, source, label, notes, |i, position| {
            origin.place(place(i, position.into(), shown))
        }),
    }?;
    let mut palette = Palette::of(document, instance.binding);
    let mut lines = 0;
    // Primitives with the numbers of their materials in the palette.
    let mut parts: Vec<(&Node, u32)> = Vec::new();
    for primitive in document.children(mesh) {
        match primitive.name {
            "polylist" | "polygons" | "triangles" | "tristrips" | "trifans" => {
                let symbol = primitive.attribute("material");
                parts.push((primitive, symbol.map_or(NONE, |symbol| palette.number(symbol, library, notes))));
            }
            "lines" | "linestrips" => lines += 1,
            _ => {}
        }
    }
    let mut faces = Faces::new(positions, placement);
    let mut primitives = Primitives::new(document, vertices, label, notes);
    // The material of each face.
    let mut numbers: Vec<u32> = Vec::new();
    for (primitive, material) in parts {
        primitives.read(primitive, palette.sets_of(material), &mut faces);
        numbers.resize(faces.soup.face_count(), material);
    }
    let vertex_colors = primitives.vertex_colors();
    if lines > 0 {
        let lines = counted(lines, "set of lines", "sets of lines");
        notes.fault(Fault::Scene, format!("geometry \"{label}\": {lines}; only faces are kept"));
    }
    let columns = palette.columns(&numbers);
    let has_colors = columns.iter().any(|column| column.name == halfedge::keys::FACE_COLOR.name);
    let mut soup = faces.finish(label, vertex_colors.as_deref(), !has_colors, notes);
    soup.face_columns.extend(columns);
    Ok(soup)
}

/// Why a geometry without a mesh can't be read.
fn unreadable(document: &Document, geometry: &Node) -> String {
    let kind = document.children(geometry).find(|child| matches!(child.name, "spline" | "brep"));
    kind.map_or("it has no <mesh>".to_owned(), |kind| {
        format!("it is a <{}>; only meshes are read", kind.name)
    })
}

/// All positions of a source, as `place` places each of them.
fn positions<T: Number>(
    document: &Document,
    source: &str,
    label: &str,
    notes: &mut Notes,
    mut place: impl FnMut(usize, [T; 3]) -> Vec3,
) -> Result<Vec<Vec3>, String> {
    let source = Source::<T>::read(document, source, 3, label, notes)?;
    Ok((0..source.count).map(|i| place(i, source.get(i).unwrap_or_default())).collect())
}

/// The blended position of a vertex in the world.
fn place(vertex: usize, position: DVec3, shown: &Shown) -> DVec3 {
    let blended = shown.morph.as_ref().map_or(position, |morph| morph.blend(vertex, position));
    shown.placement.of(vertex).transform_point3(blended)
}
