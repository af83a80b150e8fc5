//! The models that the welcome view offers, all made by the project.

use editor::ops::sentence_case;
use formats::NamedBytes;
use glam::{Vec3, vec3};
use halfedge::Mesh;
use std::fmt::Write as _;
use surface::Shape;
use surface::bezier::{Patch, teapot_patches, tessellate};

use super::picture::Figure;

/// A model that opens as a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sample {
    pub name: &'static str,
    pub description: &'static str,
    model: Model,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Model {
    /// An OFF file with a colour for each face.
    Off(&'static str),
    /// The teapot's Bezier patches.
    Teapot,
}

pub(crate) const SAMPLES: [Sample; 5] = [
    Sample {
        name: "Mug",
        description: "A mug with a handle: a closed surface of genus 1.",
        model: Model::Off(include_str!("../../../samples/mug.off")),
    },
    Sample {
        name: "Fox",
        description: "A low-poly fox, extruded from one box.",
        model: Model::Off(include_str!("../../../samples/fox.off")),
    },
    Sample {
        name: "Chair",
        description: "A chair, extruded from its seat.",
        model: Model::Off(include_str!("../../../samples/chair.off")),
    },
    Sample {
        name: "Pawn",
        description: "A pawn, turned on a lathe.",
        model: Model::Off(include_str!("../../../samples/pawn.off")),
    },
    Sample {
        name: "Teapot",
        description: "The Utah teapot as 32 Bezier patches with their control points.",
        model: Model::Teapot,
    },
];

/// The shapes that the welcome view offers, by their names in the operation `new`.
pub(crate) const SHAPES: [&str; 8] =
    ["cube", "plane", "grid", "uv-sphere", "ico-sphere", "cylinder", "cone", "torus"];

impl Sample {
    /// The sample's file.
    pub fn file(self) -> NamedBytes {
        match self.model {
            Model::Off(text) => NamedBytes::new(format!("{}.off", self.name), text.as_bytes()),
            Model::Teapot => NamedBytes::new(format!("{}.bez", self.name), bezier_file(&teapot()).as_bytes()),
        }
    }

    pub(super) fn figure(self) -> Figure {
        match self.model {
            Model::Off(text) => read(text).unwrap_or_default(),
            Model::Teapot => {
                let made = tessellate(&teapot(), 6);
                made.map(|made| of_mesh(&made.mesh, vec3(0.72, 0.78, 0.88))).unwrap_or_default()
            }
        }
    }
}

/// What a shape's tile says and shows.
pub(super) fn shape_name(name: &str) -> String {
    match name {
        "uv-sphere" => "Sphere".to_owned(),
        other => sentence_case(other),
    }
}

pub(super) fn shape_figure(name: &str) -> Figure {
    let Some(mut shape) = Shape::named(name) else { return Figure::default() };
    // Few enough faces to see in a small picture; a shape without such a size ignores it.
    for (field, count) in [("columns", 4.0), ("rows", 4.0), ("subdivisions", 1.0)] {
        // The values are within the fields' ranges.
        let _ = shape.set(field, count);
    }
    let color = vec3(0.55, 0.68, 0.86);
    let mut figure = shape.build().map(|mesh| of_mesh(&mesh, color)).unwrap_or_default();
    if name == "grid" {
        // Without this it would look like a plane.
        let every_second = figure.polygons.iter_mut().enumerate().filter(|(at, _)| (at / 4 + at) % 2 == 0);
        every_second.for_each(|(_, (_, color))| *color *= 0.72);
    }
    figure
}

/// The teapot with y up, standing on the ground.
fn teapot() -> Vec<Patch> {
    let mut patches = teapot_patches();
    for point in patches.iter_mut().flat_map(|patch| patch.rows.iter_mut().flatten()) {
        *point = vec3(point.x, point.z, -point.y);
    }
    patches
}

/// The patches as a file: their number, and the coordinates of 16 points each.
fn bezier_file(patches: &[Patch]) -> String {
    let mut text = format!("{}\n", patches.len());
    for point in patches.iter().flat_map(|patch| patch.rows.iter().flatten()) {
        let [x, y, z] = point.to_array();
        // Writing to a string can't fail.
        let _ = writeln!(text, "{x} {y} {z}");
    }
    text
}

fn of_mesh(mesh: &Mesh, color: Vec3) -> Figure {
    let corners = |f| mesh.face_vertices(f).map(|v| v.raw()).collect();
    Figure {
        positions: mesh.positions().to_vec(),
        polygons: mesh.faces().map(|f| (corners(f), color)).collect(),
    }
}

/// The polygons of one of the project's own OFF files. The worker's reader is not part of the page's program.
fn read(text: &str) -> Option<Figure> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let mut words = lines.flat_map(str::split_whitespace).skip(1);
    let mut count = || words.next()?.parse::<usize>().ok();
    let (vertices, faces, _) = (count()?, count()?, count()?);
    let mut figure = Figure::default();
    let mut number = || words.next()?.parse::<f32>().ok();
    for _ in 0..vertices {
        figure.positions.push(vec3(number()?, number()?, number()?));
    }
    for _ in 0..faces {
        let corners = number()? as usize;
        let corners: Option<Vec<u32>> = (0..corners).map(|_| number().map(|id| id as u32)).collect();
        let color = vec3(number()?, number()?, number()?) / 255.0;
        figure.polygons.push((corners?, color));
    }
    Some(figure)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::ControlFlow;

    #[test]
    fn every_sample_opens_without_a_change_and_its_picture_shows_it() {
        for sample in SAMPLES {
            let files = [sample.file()];
            let import = formats::read(&files, &mut |_| ControlFlow::Continue(())).expect("a model");
            assert_eq!(import.report.warnings().count(), 0, "{}", sample.name);
            let object = import.model.objects.first().expect("an object");
            let figure = sample.figure();
            if object.bezier.is_none() {
                assert!(object.mesh.topology().boundary_loops == 0, "{} is closed", sample.name);
                assert_eq!(object.mesh.vertex_count(), figure.positions.len(), "{}", sample.name);
                assert_eq!(object.mesh.face_count(), figure.polygons.len(), "{}", sample.name);
                assert!(surface::measure::volume(&object.mesh) > 0.0, "{} faces outward", sample.name);
            }
            let picture = super::super::picture::draw(&figure, 60, 40);
            let opaque = picture.chunks_exact(4).filter(|pixel| pixel[3] == 255).count();
            assert!((100..2000).contains(&opaque), "{}: {opaque} of 2400 pixels", sample.name);
        }
    }

    #[test]
    fn every_shape_is_one_of_the_operation_new() {
        for name in SHAPES {
            assert!(Shape::named(name).is_some(), "{name}");
            assert!(!shape_figure(name).polygons.is_empty(), "{name}");
        }
    }
}
