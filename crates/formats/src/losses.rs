//! What a format can't hold of a document, said before saving.

use crate::export::ObjectRef;
use crate::format::Format;
use crate::obj::mtl;
use crate::pieces::uniform;
use crate::report::{counted, counted_words};
use crate::weld::Weld;
use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Key};
use halfedge::{Color, Element, Mesh, NONE, keys};
use std::collections::HashSet;

/// What a document can have that some format has no place for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Several objects, each with its name.
    Objects,
    /// Faces with more than three corners.
    Polygons,
    /// Vertices that no face uses.
    LooseVertices,
    FaceColors,
    VertexColors,
    TextureCoordinates,
    Normals,
    Groups,
    Materials,
    Smoothing,
    Creases,
}

impl Part {
    const ALL: [Self; 11] = [
        Self::Objects,
        Self::Polygons,
        Self::LooseVertices,
        Self::FaceColors,
        Self::VertexColors,
        Self::TextureCoordinates,
        Self::Normals,
        Self::Groups,
        Self::Materials,
        Self::Smoothing,
        Self::Creases,
    ];

    /// How many of it the mesh has.
    fn count(self, mesh: &Mesh) -> usize {
        match self {
            Self::Objects => 1,
            Self::Polygons => mesh.faces().filter(|&f| mesh.face_halfedges(f).nth(3).is_some()).count(),
            Self::LooseVertices => mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()).count(),
            Self::FaceColors => count(mesh, keys::FACE_COLOR, |color| color != Color::UNPAINTED),
            Self::VertexColors => count(mesh, keys::VERTEX_COLOR, |color| !color.is_nan()),
            Self::TextureCoordinates => count(mesh, keys::CORNER_UV, |uv| !uv.is_nan()),
            Self::Normals => count(mesh, keys::CORNER_NORMAL, |normal| !normal.is_nan()),
            Self::Groups => count(mesh, keys::FACE_GROUP, |group| group != NONE),
            Self::Materials => count(mesh, keys::FACE_MATERIAL, |material| material != NONE),
            Self::Smoothing => count(mesh, keys::FACE_SMOOTHING, |group| group != 0),
            Self::Creases => {
                count(mesh, keys::EDGE_CREASE, |sharp| sharp > 0.0)
                    + count(mesh, keys::VERTEX_CREASE, |sharp| sharp > 0.0)
            }
        }
    }

    /// What happens to `count` of it in a format that has no place for it.
    fn loss(self, format: &str, count: usize) -> String {
        let n = |one: &str, many: &str| counted(count, one, many);
        match self {
            Self::Objects => format!("{format} holds one mesh: {count} objects become one"),
            Self::Polygons => {
                format!(
                    "{format} holds triangles only: {} cut into triangles",
                    n("polygon is", "polygons are")
                )
            }
            Self::LooseVertices => format!(
                "{format} holds no vertices without faces: {} left out",
                n("vertex is", "vertices are")
            ),
            Self::FaceColors => {
                format!("{format} holds no face colours: those of {} are lost", n("face", "faces"))
            }
            Self::VertexColors => {
                format!("{format} holds no vertex colours: those of {} are lost", n("vertex", "vertices"))
            }
            Self::TextureCoordinates => {
                format!("{format} holds no texture coordinates: those of {} are lost", n("corner", "corners"))
            }
            Self::Normals => {
                format!("{format} holds no corner normals: those of {} are lost", n("corner", "corners"))
            }
            Self::Groups => {
                format!("{format} holds no face groups: those of {} are lost", n("face", "faces"))
            }
            Self::Materials => {
                format!("{format} holds no material names: those of {} are lost", n("face", "faces"))
            }
            Self::Smoothing => {
                format!("{format} holds no smoothing groups: those of {} are lost", n("face", "faces"))
            }
            Self::Creases => format!("{format} holds no creases: {} lost", n("crease is", "creases are")),
        }
    }
}

/// How many existing elements have a value that `counts`.
fn count<T: AttributeType>(mesh: &Mesh, key: Key<T>, counts: impl Fn(T) -> bool) -> usize {
    let Some(values) = mesh.attribute(key) else { return 0 };
    let has = |index: usize| values.get(index).is_some_and(|&value| counts(value));
    match key.element {
        Element::Vertex => mesh.vertices().filter(|v| has(v.index())).count(),
        Element::Edge => mesh.edges().filter(|e| has(e.index())).count(),
        Element::Face => mesh.faces().filter(|f| has(f.index())).count(),
        // Boundary half-edges are no face's corners.
        Element::Halfedge => {
            mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h) && has(h.index())).count()
        }
    }
}

/// What writing these objects in this format would lose, one sentence each; empty where the format
/// holds everything. Costs O(document).
pub fn losses(format: Format, objects: &[ObjectRef]) -> Vec<String> {
    if format.is_bezier() {
        return control_losses(format, objects);
    }
    let name = format.name();
    let controls = objects.iter().filter(|object| object.controls.is_some()).map(|object| {
        let own = object.name;
        if object.is_curve() {
            format!("{name} holds no Bezier curves: {own} is left out")
        } else {
            let faces = counted(object.mesh.face_count(), "face", "faces");
            format!("{name} holds no control points: of {own} the mesh of {faces} is written that shows it")
        }
    });
    let objects: Vec<ObjectRef> = objects.iter().filter(|object| !object.is_curve()).copied().collect();
    let parts = Part::ALL.into_iter().filter(|&part| !format.keeps(part)).filter_map(|part| {
        let count: usize = objects.iter().map(|object| part.count(object.mesh)).sum();
        let enough = if part == Part::Objects { 2 } else { 1 };
        (count >= enough).then(|| part.loss(name, count))
    });
    let materials = material_loss(format, &objects);
    let split = split_losses(format, &objects);
    let merged =
        matches!(format, Format::Stl | Format::StlText).then(|| merged_loss(name, &objects)).flatten();
    let is_far = objects.iter().any(|object| object.offset != glam::DVec3::ZERO);
    let rounded = (is_far && format == Format::Stl).then(|| {
        "STL holds 32 bits for a coordinate: positions so far from the origin are rounded; STL (text) keeps them"
            .to_owned()
    });
    controls.chain(parts).chain(materials).chain(split).chain(merged).chain(rounded).collect()
}

/// What the format doesn't hold of the materials that faces have.
fn material_loss(format: Format, objects: &[ObjectRef]) -> Option<String> {
    let mut met = HashSet::new();
    let mut words: Vec<&str> = Vec::new();
    let mut count = 0;
    for object in objects.iter().filter(|object| !object.materials.is_empty()) {
        let names = mtl::names_in_use(object.mesh);
        for material in &object.materials.list {
            if !names.contains(material.name.as_str()) || !met.insert(material.name.as_str()) {
                continue;
            }
            let before = words.len();
            let lost = material.properties().into_iter().filter(|&property| !format.keeps_property(property));
            words.extend(lost.map(|property| property.name()));
            if let Some(mtl) = material.mtl.as_ref().filter(|_| format != Format::Obj) {
                words.extend(mtl::other_statements(mtl));
            }
            count += usize::from(words.len() > before);
        }
    }
    let words = counted_words(words)?;
    let materials = counted(count, "material", "materials");
    Some(format!("{} holds less of materials: of {materials}, {words} are lost", format.name()))
}

/// What is lost where a format holds triangles by their positions alone: that vertices at one place
/// are different ones.
fn merged_loss(format: &str, objects: &[ObjectRef]) -> Option<String> {
    let mut places = Weld::new();
    let mut count = 0;
    for mesh in objects.iter().map(|object| object.mesh) {
        for v in mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_some()) {
            places.vertex(mesh.position(v));
            count += 1;
        }
    }
    let merged = count - places.positions.len();
    (merged > 0).then(|| {
        format!(
            "{format} holds triangles without shared vertices: {} at the same place as another will be one with it \
             when the file is opened",
            counted(merged, "vertex", "vertices")
        )
    })
}

/// What is lost where a format has a place at vertices for what corners have, and corners of a
/// vertex differ.
fn split_losses(format: Format, objects: &[ObjectRef]) -> Vec<String> {
    let normals = matches!(format, Format::Ply | Format::PlyText | Format::Off);
    let uvs = format == Format::Off;
    let mut losses = Vec::new();
    let mut lose = |part: Part, what: &str, fits: &dyn Fn(&Mesh) -> bool| {
        let count: usize = objects.iter().map(|object| part.count(object.mesh)).sum();
        if count > 0 && !objects.iter().all(|object| fits(object.mesh)) {
            let corners = counted(count, "corner", "corners");
            losses.push(format!(
                "{} holds one {what} for each vertex: those of {corners} are lost",
                format.name()
            ));
        }
    };
    if normals {
        let fits = |mesh: &Mesh| uniform(mesh, keys::CORNER_NORMAL, |n| n.is_nan(), Vec3::ZERO).is_some();
        lose(Part::Normals, "normal", &fits);
    }
    if uvs {
        let fits = |mesh: &Mesh| uniform(mesh, keys::CORNER_UV, |uv| uv.is_nan(), Vec2::ZERO).is_some();
        lose(Part::TextureCoordinates, "texture coordinate", &fits);
    }
    losses
}

/// What a format for Bezier curves or surfaces leaves out.
fn control_losses(format: Format, objects: &[ObjectRef]) -> Vec<String> {
    let name = format.name();
    let (what, wanted) = if format == Format::BezierCurve { ("curves", true) } else { ("surfaces", false) };
    let kept = |object: &&ObjectRef| object.controls.is_some_and(|c| c.is_curve() == wanted);
    let count = objects.iter().filter(kept).count();
    let mut losses: Vec<String> = objects
        .iter()
        .filter(|object| !kept(object))
        .map(|object| format!("{name} holds only Bezier {what}: {} is left out", object.name))
        .collect();
    if count > 1 {
        losses.push(match format {
            Format::BezierCurve => format!("{name} holds one curve: {count} curves go to {count} files"),
            _ => format!("{name} holds one surface: the patches of {count} objects become one"),
        });
    }
    losses
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfedge::PolygonSoup;

    #[test]
    fn losses_name_what_goes() {
        let corners = vec![Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y];
        let mut mesh = Mesh::build(PolygonSoup::new(corners, &[[0, 1, 2, 3]])).expect("small").mesh;
        fn object(mesh: &Mesh) -> ObjectRef<'_> {
            ObjectRef::new("a", mesh)
        }
        assert_eq!(losses(Format::Obj, &[object(&mesh)]), [""; 0]);
        mesh.set(keys::FACE_COLOR, 0, Color([1, 2, 3]));
        mesh.set(keys::EDGE_CREASE, 2, 3.0);
        // On a boundary half-edge: of no face, so not a loss.
        mesh.set(keys::CORNER_UV, 1, Vec2::ONE);
        assert_eq!(losses(Format::Obj, &[object(&mesh)]), ["OBJ holds no creases: 1 crease is lost"]);
        assert_eq!(
            losses(Format::Json, &[object(&mesh), object(&mesh)]),
            [
                "Half-edge JSON holds one mesh: 2 objects become one",
                "Half-edge JSON holds no face colours: those of 2 faces are lost",
                "Half-edge JSON holds no creases: 2 creases are lost",
            ]
        );
    }
}
