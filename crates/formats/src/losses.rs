//! What a format can't hold of a model, for telling the user before saving.

use crate::format::loss::Part;
use crate::format::{FormatInfo, Holds};
use crate::formats::Format;
use crate::model::material::Property;
use crate::model::paint::names_in_use;
use crate::model::texture::Texture;
use crate::model::{Model, NamedMesh};
use crate::obj::mtl;
use crate::report::counted_words;
use halfedge::words::{counted, thousands};
use std::collections::HashSet;

/// The losses of writing a model in this format, one sentence each; empty if the format holds everything.
/// Costs O(model).
pub fn losses(format: Format, model: &Model) -> Vec<String> {
    let info = format.info();
    if format.is_project() {
        return Vec::new();
    }
    if info.holds != Holds::Meshes {
        return control_point_losses(info, model);
    }
    let name = format.name();
    let object_name = name_loss(info, &model.objects.iter().collect::<Vec<_>>(), model);
    let control_points = model.objects.iter().filter(|object| object.bezier.is_some()).map(|object| {
        let own = &object.name;
        if object.is_curve() {
            format!("{name} holds no Bezier curves: {own} is left out")
        } else {
            let faces = counted(object.mesh.face_count(), "face", "faces");
            format!("{name} holds no control points: {own} is written as the mesh of {faces} that shows it")
        }
    });
    let meshes = model.without_curves();
    let parts = Part::ALL.into_iter().filter(|part| info.lacks.contains(part)).filter_map(|part| {
        let count: usize = meshes.objects.iter().map(|object| part.count(&object.mesh)).sum();
        let enough = if part == Part::Objects { 2 } else { 1 };
        (count >= enough).then(|| part.loss(name, count))
    });
    let others = parts.chain(material_loss(info, &meshes)).chain((info.losses)(&meshes));
    control_points.chain(object_name).chain(others).collect()
}

/// The loss of the name of an object that is alone in its file.
fn name_loss(format: &FormatInfo, objects: &[&NamedMesh], model: &Model) -> Option<String> {
    let [object] = objects else { return None };
    (!format.keeps_name && object.name != model.name).then(|| {
        format!("{} names a single object after its file: the name \"{}\" is lost", format.name, object.name)
    })
}

/// The properties of used materials that the format doesn't hold.
fn material_loss(format: &FormatInfo, model: &Model) -> Option<String> {
    let mut words: Vec<&str> = Vec::new();
    let mut count = 0;
    let in_use: HashSet<&str> = model.objects.iter().flat_map(|object| names_in_use(&object.mesh)).collect();
    for material in &model.materials.list {
        if !in_use.contains(material.name.as_str()) {
            continue;
        }
        let is_kept = |property: Property| (format.keeps_property)(property);
        if material.mtl.is_some() && is_kept(Property::MtlStatements) {
            // Its statements are written as they stand.
            continue;
        }
        let before = words.len();
        let lost = material.properties().into_iter().filter(|&property| !is_kept(property));
        words.extend(lost.map(|property| property.name()));
        let is_misplaced = |texture: &&Texture| {
            is_kept(Property::Texture(texture.role)) && !(format.keeps_placement)(texture)
        };
        let misplaced = material.textures.iter().filter(is_misplaced).count();
        words.extend(std::iter::repeat_n("texture placement", misplaced));
        words.extend(material.mtl.iter().flat_map(mtl::other_statements));
        count += usize::from(words.len() > before);
    }
    let words = counted_words(words)?;
    let materials = counted(count, "material", "materials");
    Some(format!("{} holds less of materials: of {materials}, {words} are lost", format.name))
}

/// The losses in a format for Bezier curves or surfaces.
fn control_point_losses(format: &FormatInfo, model: &Model) -> Vec<String> {
    let (name, holds) = (format.name, format.holds.name());
    let is_kept = |is_curve: bool| is_curve == (format.holds == Holds::Curves);
    let (kept, lost): (Vec<_>, Vec<_>) = model
        .objects
        .iter()
        .partition(|object| object.bezier.as_ref().is_some_and(|bezier| is_kept(bezier.curve().is_some())));
    let lost = lost.iter().map(|object| format!("{name} holds only {holds}: {} is left out", object.name));
    let mut losses: Vec<String> = lost.collect();
    losses.extend(name_loss(format, &kept, model));
    let count = kept.len();
    if count > 1 {
        losses.push(match format.holds {
            Holds::Curves => format!(
                "{name} holds one curve: {} go to {} files",
                counted(count, "curve", "curves"),
                thousands(count)
            ),
            _ => format!(
                "{name} holds one surface: the patches of {} become one",
                counted(count, "object", "objects")
            ),
        });
    }
    losses
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec2, Vec3};
    use halfedge::{Color, Mesh, PolygonSoup, keys};

    #[test]
    fn losses_name_what_goes() {
        let corners = vec![Vec3::ZERO, Vec3::X, Vec3::ONE, Vec3::Y];
        let mut mesh = Mesh::build(PolygonSoup::new(corners, &[[0, 1, 2, 3]])).expect("small").mesh;
        let losses = |code: &str, meshes: &[&Mesh]| {
            let objects = meshes.iter().map(|&mesh| NamedMesh::new("a", mesh.clone())).collect();
            let name = "a".to_owned();
            losses(Format::from_code(code).expect("a format"), &Model { name, objects, ..Model::default() })
        };
        assert_eq!(losses("obj", &[&mesh]), [""; 0]);
        for (code, lost) in [("obj", true), ("ply", true), ("stl-text", true), ("glb", false), ("dae", false)]
        {
            let model = Model { name: "b".to_owned(), ..Model::of_mesh("a", mesh.clone()) };
            let losses = super::losses(Format::from_code(code).expect("a format"), &model).join("\n");
            assert_eq!(losses.contains("the name \"a\" is lost"), lost, "{code}: {losses}");
        }
        mesh.set(keys::FACE_COLOR, 0, Color([1, 2, 3]));
        mesh.set(keys::EDGE_CREASE, 2, 3.0);
        // On a boundary half-edge: of no face, so not a loss.
        mesh.set(keys::CORNER_UV, 1, Vec2::ONE);
        assert_eq!(losses("obj", &[&mesh]), ["OBJ holds no creases: 1 crease is lost"]);
        assert_eq!(
            losses("json", &[&mesh, &mesh]),
            [
                "Half-edge JSON holds one mesh: 2 objects become one",
                "Half-edge JSON holds no face colours: those of 2 faces are lost",
                "Half-edge JSON holds no creases: 2 creases are lost",
            ]
        );
    }
}
