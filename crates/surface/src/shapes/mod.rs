//! The shapes of the operation `new`: y up, centred on the origin, faces outward.

mod platonic;
mod round;

use crate::SurfaceError;
use crate::bezier::{self, Bezier, Curve, Patch};
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup, TooLarge};

/// The most faces of a new shape.
const MAX_SHAPE_FACES: u64 = 4_000_000;

/// A size of a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeField {
    /// The field's name in the command.
    pub name: &'static str,
    /// The default.
    pub default: f64,
    /// The smallest value.
    pub min: f64,
    /// The largest value.
    pub max: f64,
    /// Whether it is a whole number.
    pub whole: bool,
}

/// A kind of shape: its name in the command, its sizes, and functions of their values in order that give the
/// number of faces and build the mesh.
struct Kind {
    name: &'static str,
    fields: &'static [ShapeField],
    faces: fn(&[f64]) -> f64,
    build: fn(&[f64]) -> Result<Mesh, SurfaceError>,
    /// The control points of a Bezier curve or surface, which the mesh shows.
    controls: Option<fn(&[f64]) -> Bezier>,
}

/// A shape with its sizes.
#[derive(Clone)]
pub struct Shape {
    kind: &'static Kind,
    values: Vec<f64>,
}

const fn length(name: &'static str, default: f64) -> ShapeField {
    ShapeField { name, default, min: 1e-6, max: 1e6, whole: false }
}

const fn count(name: &'static str, default: f64, min: f64, max: f64) -> ShapeField {
    ShapeField { name, default, min, max, whole: true }
}

const RADIUS: ShapeField = length("radius", 1.0);
const SEGMENTS: ShapeField = count("segments", 32.0, 3.0, 4096.0);

static KINDS: [Kind; 15] = [
    Kind {
        name: "cube",
        fields: &[length("size", 2.0)],
        faces: |_| 6.0,
        build: platonic::cube,
        controls: None,
    },
    Kind {
        name: "tetrahedron",
        fields: &[RADIUS],
        faces: |_| 4.0,
        build: platonic::tetrahedron,
        controls: None,
    },
    Kind {
        name: "octahedron",
        fields: &[RADIUS],
        faces: |_| 8.0,
        build: platonic::octahedron,
        controls: None,
    },
    Kind {
        name: "icosahedron",
        fields: &[RADIUS],
        faces: |_| 20.0,
        build: platonic::icosahedron,
        controls: None,
    },
    Kind {
        name: "dodecahedron",
        fields: &[RADIUS],
        faces: |_| 12.0,
        build: platonic::dodecahedron,
        controls: None,
    },
    Kind {
        name: "uv-sphere",
        fields: &[RADIUS, SEGMENTS, count("rings", 16.0, 2.0, 4096.0)],
        faces: |v| v[1] * v[2],
        build: round::uv_sphere,
        controls: None,
    },
    Kind {
        name: "ico-sphere",
        fields: &[RADIUS, count("subdivisions", 3.0, 0.0, 8.0)],
        faces: |v| 20.0 * 4f64.powi(v[1] as i32),
        build: platonic::ico_sphere,
        controls: None,
    },
    Kind {
        name: "torus",
        fields: &[
            RADIUS,
            length("tube_radius", 0.4),
            count("segments", 48.0, 3.0, 4096.0),
            count("tube_segments", 24.0, 3.0, 4096.0),
        ],
        faces: |v| v[2] * v[3],
        build: round::torus,
        controls: None,
    },
    Kind {
        name: "cylinder",
        fields: &[RADIUS, length("height", 2.0), SEGMENTS, count("rings", 1.0, 1.0, 4096.0)],
        faces: |v| v[2] * v[3] + 2.0,
        build: round::cylinder,
        controls: None,
    },
    Kind {
        name: "cone",
        fields: &[RADIUS, length("height", 2.0), SEGMENTS],
        faces: |v| v[2] + 1.0,
        build: round::cone,
        controls: None,
    },
    Kind {
        name: "plane",
        fields: &[length("size", 2.0)],
        faces: |_| 1.0,
        build: |v| grid(v[0], 1, 1),
        controls: None,
    },
    Kind {
        name: "grid",
        fields: &[length("size", 2.0), count("columns", 10.0, 1.0, 4096.0), count("rows", 10.0, 1.0, 4096.0)],
        faces: |v| v[1] * v[2],
        build: |v| grid(v[0], v[1] as u32, v[2] as u32),
        controls: None,
    },
    Kind {
        name: "teapot",
        fields: &[length("size", 2.0), count("segments", 8.0, 2.0, 64.0)],
        faces: |v| 32.0 * v[1] * v[1],
        build: teapot,
        controls: None,
    },
    Kind {
        name: "bezier-curve",
        fields: &[length("size", 2.0), count("degree", 3.0, 1.0, 32.0)],
        faces: |_| 0.0,
        build: |v| bezier_curve(v).preview().map_err(too_many_faces),
        controls: Some(bezier_curve),
    },
    Kind {
        name: "bezier-patch",
        fields: &[length("size", 2.0)],
        faces: |v| f64::from(bezier_patch(v).preview_resolution()).powi(2),
        build: |v| bezier_patch(v).preview().map_err(too_many_faces),
        controls: Some(bezier_patch),
    },
];

impl std::fmt::Debug for Shape {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut out = f.debug_struct(self.kind.name);
        for (field, value) in self.kind.fields.iter().zip(&self.values) {
            out.field(field.name, value);
        }
        out.finish()
    }
}

impl PartialEq for Shape {
    fn eq(&self, other: &Self) -> bool {
        self.kind.name == other.kind.name && self.values == other.values
    }
}

impl Shape {
    /// The names of all shapes, in the order of menus.
    pub fn names() -> impl Iterator<Item = &'static str> {
        KINDS.iter().map(|kind| kind.name)
    }

    /// The shape of that name with its default sizes.
    pub fn named(name: &str) -> Option<Self> {
        let kind = KINDS.iter().find(|kind| kind.name == name)?;
        Some(Self { kind, values: kind.fields.iter().map(|field| field.default).collect() })
    }

    /// The shape's name in the command.
    pub fn name(&self) -> &'static str {
        self.kind.name
    }

    /// The shape's sizes, in the order of panels.
    pub fn fields(&self) -> &'static [ShapeField] {
        self.kind.fields
    }

    /// The value of a size, if the shape has it.
    pub fn get(&self, field: &str) -> Option<f64> {
        let at = self.kind.fields.iter().position(|f| f.name == field)?;
        self.values.get(at).copied()
    }

    /// Sets a size.
    ///
    /// # Errors
    /// [`SurfaceError::BadField`] for a value out of range or a count that isn't whole. A field that the shape
    /// doesn't have is ignored: see [`Shape::fields`].
    pub fn set(&mut self, field: &str, value: f64) -> Result<(), SurfaceError> {
        for (spec, slot) in self.kind.fields.iter().zip(&mut self.values) {
            if spec.name != field {
                continue;
            }
            if !(spec.min..=spec.max).contains(&value) || (spec.whole && value.fract() != 0.0) {
                let kind = if spec.whole { "a whole number" } else { "a number" };
                let must_be = format!("{kind} from {} to {}", spec.min, spec.max);
                return Err(SurfaceError::field(spec.name, must_be));
            }
            *slot = value;
        }
        Ok(())
    }

    /// How many faces the shape will have (the teapot's: at most).
    pub fn face_count(&self) -> u64 {
        (self.kind.faces)(&self.values) as u64
    }

    /// The control points, if the shape is a Bezier curve or surface: its mesh is the one that shows them.
    pub fn control_points(&self) -> Option<Bezier> {
        self.kind.controls.map(|controls| controls(&self.values))
    }

    /// Builds the mesh, which is closed except for planes, the teapot and Bezier patches, has no attributes, and is empty for
    /// a curve.
    ///
    /// # Errors
    /// [`SurfaceError::TooManyFaces`]; [`SurfaceError::BadField`] if sizes don't fit together.
    pub fn build(&self) -> Result<Mesh, SurfaceError> {
        let faces = self.face_count();
        if faces > MAX_SHAPE_FACES {
            return Err(SurfaceError::TooManyFaces { faces, limit: MAX_SHAPE_FACES });
        }
        (self.kind.build)(&self.values)
    }
}

fn build_mesh(soup: PolygonSoup) -> Result<Mesh, SurfaceError> {
    Mesh::build(soup).map(|built| built.mesh).map_err(too_many_faces)
}

fn too_many_faces(TooLarge { corners }: TooLarge) -> SurfaceError {
    SurfaceError::TooManyFaces { faces: corners as u64 / 4, limit: MAX_SHAPE_FACES }
}

fn grid(size: f64, columns: u32, rows: u32) -> Result<Mesh, SurfaceError> {
    let mut soup = PolygonSoup::default();
    for j in 0..=rows {
        for i in 0..=columns {
            let x = (f64::from(i) / f64::from(columns) - 0.5) * size;
            let z = (f64::from(j) / f64::from(rows) - 0.5) * size;
            soup.positions.push(Vec3::new(x as f32, 0.0, z as f32));
        }
    }
    let at = |i: u32, j: u32| j * (columns + 1) + i;
    for j in 0..rows {
        for i in 0..columns {
            soup.push_face([at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)]);
        }
    }
    build_mesh(soup)
}

/// The Utah teapot, `size` high.
fn teapot(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let mut patches = bezier::teapot_patches();
    let scale = (values[0] / 3.15) as f32;
    for point in patches.iter_mut().flat_map(|patch| patch.rows.iter_mut().flatten()) {
        *point = Vec3::new(point.x * scale, (point.z - 1.575) * scale, -point.y * scale);
    }
    bezier::tessellate(&patches, values[1] as u32).map(|tessellated| tessellated.mesh).map_err(too_many_faces)
}

/// A curve of `degree` in the plane z = 0, `size` wide. Its control points lie below and above it by turns.
fn bezier_curve(values: &[f64]) -> Bezier {
    let (size, degree) = (values[0], values[1] as u32);
    let point = |i: u32| {
        let x = (f64::from(i) / f64::from(degree) - 0.5) * size;
        let side = if i.is_multiple_of(2) { -0.25 } else { 0.25 };
        Vec3::new(x as f32, (side * size) as f32, 0.0)
    };
    Bezier::Curve(Curve { points: (0..=degree).map(point).collect() })
}

/// A patch over the square of side `size` in the plane y = 0 whose four inner control points are raised.
fn bezier_patch(values: &[f64]) -> Bezier {
    let size = values[0];
    let at = |i: usize| (i as f64 / 3.0 - 0.5) * size;
    let height = |row: usize, column: usize| {
        let is_inner = |i: usize| i == 1 || i == 2;
        if is_inner(row) && is_inner(column) { size * 0.5 } else { 0.0 }
    };
    let point =
        |row: usize, column: usize| Vec3::new(at(column) as f32, height(row, column) as f32, -at(row) as f32);
    Bezier::Surface(vec![Patch {
        rows: std::array::from_fn(|row| std::array::from_fn(|column| point(row, column))),
    }])
}
