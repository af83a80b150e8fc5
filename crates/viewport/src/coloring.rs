//! The colours of faces: which of a mesh's colours, labels or measures its corners show.

use crate::Materials;
use crate::id_set::IdSet;
use crate::materials::{FaceTexture, TEXTURES_PER_DRAW};
use crate::ramp::{Ramp, end_of_range, label_color};
use glam::{Vec2, Vec3};
use halfedge::{Budget, Color, Element, FaceId, HalfedgeId, Mesh, VertexId, keys};
use std::collections::BTreeSet;
use std::sync::Arc;
use surface::curvature::{gaussian_curvature, mean_curvature};
use surface::measure::face_quality;

/// A vertex's curvature takes about as long as this many other elements.
const ELEMENTS_PER_CURVATURE: usize = 4;
/// Of so many faces most decide which valence is regular.
const SAMPLED_FACES: usize = 1000;

/// What gives faces their colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ColorBy {
    /// Painted faces show their paint, the others the colours of their vertices where the mesh has them, or else
    /// their material's.
    #[default]
    Paint,
    /// Every face shows its own colour.
    Face,
    /// Every face shows the colours of its vertices.
    Vertex,
    /// All faces are as if unpainted.
    Uniform,
    /// Each material has a colour that differs from the others.
    Material,
    /// Each group has a colour that differs from the others.
    Group,
    /// The number of edges at vertices.
    Valence,
    /// The Gaussian curvature at vertices.
    GaussianCurvature,
    /// The mean curvature at vertices.
    MeanCurvature,
    /// How close faces are to regular polygons.
    Quality,
}

impl ColorBy {
    /// All, in the order of menus.
    pub const ALL: [Self; 10] = [
        Self::Paint,
        Self::Face,
        Self::Vertex,
        Self::Uniform,
        Self::Material,
        Self::Group,
        Self::Valence,
        Self::GaussianCurvature,
        Self::MeanCurvature,
        Self::Quality,
    ];

    /// The name in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paint => "paint",
            Self::Face => "face",
            Self::Vertex => "vertex",
            Self::Uniform => "uniform",
            Self::Material => "material",
            Self::Group => "group",
            Self::Valence => "valence",
            Self::GaussianCurvature => "gaussian-curvature",
            Self::MeanCurvature => "mean-curvature",
            Self::Quality => "quality",
        }
    }

    fn label_key(self) -> Option<halfedge::attribute::Key<u32>> {
        match self {
            Self::Material => Some(keys::FACE_MATERIAL),
            Self::Group => Some(keys::FACE_GROUP),
            _ => None,
        }
    }

    /// The curvature that it shows.
    fn curvature(self) -> Option<fn(&Mesh, VertexId) -> f64> {
        match self {
            Self::GaussianCurvature => Some(gaussian_curvature),
            Self::MeanCurvature => Some(mean_curvature),
            _ => None,
        }
    }
}

/// What colours stand for.
#[derive(Clone, Debug, PartialEq)]
pub enum Legend {
    /// Numbers.
    Ramp(Ramp),
    /// Labels, and faces without one in grey.
    Labels(Vec<(String, Color)>),
}

/// The colours and textures of a mesh's corners.
#[derive(Clone, Debug, Default)]
pub struct Coloring {
    by: ColorBy,
    /// The looks of the document's materials.
    materials: Arc<Materials>,
    /// The colour and the texture of each label of the mesh's materials; none for a material that the document
    /// doesn't have.
    of_labels: Vec<(Option<Color>, Option<u16>)>,
    /// Whether texture coordinates are wanted, and whether there are any.
    wants_uvs: bool,
    has_uvs: bool,
    /// The labels that colours stand for.
    labels: Vec<String>,
    /// The curvature of each vertex.
    values: Vec<f32>,
    /// The number of vertices whose curvature is known.
    measured: usize,
    ramp: Option<Ramp>,
}

impl Coloring {
    /// How a mesh is coloured, and textured if `wants_uvs`. Costs O(labels); what costs more is done in
    /// [`Coloring::measure`].
    pub fn new(mesh: &Mesh, by: ColorBy, wants_uvs: bool, materials: &Arc<Materials>) -> Self {
        let labels = |key: halfedge::attribute::Key<u32>| {
            mesh.column(Element::Face, key.name).map_or(&[][..], |column| &column.labels)
        };
        let of_label = |label: &String| (materials.color(label), materials.texture(label));
        let made = Self {
            by,
            materials: materials.clone(),
            of_labels: labels(keys::FACE_MATERIAL).iter().map(of_label).collect(),
            wants_uvs,
            has_uvs: false,
            labels: by.label_key().map_or(Vec::new(), |key| labels(key).to_vec()),
            values: Vec::new(),
            measured: 0,
            ramp: match by {
                ColorBy::Valence => {
                    let regular = regular_valence(mesh);
                    Some(Ramp::diverging(regular - 3.0, regular + 3.0))
                }
                ColorBy::Quality => Some(Ramp::sequential(0.0, 1.0)),
                _ => None,
            },
        };
        Self { has_uvs: made.needs_uvs(mesh), ..made }
    }

    /// Whether corners need texture coordinates, if only for translucent faces, which are drawn as those with textures are.
    fn needs_uvs(&self, mesh: &Mesh) -> bool {
        self.wants_uvs && (has_uvs(mesh) || !self.translucent_passes().is_empty())
    }

    /// What gives the colours.
    pub fn by(&self) -> ColorBy {
        self.by
    }

    /// Whether the colours are still as the document's materials have them and textures are there if wanted.
    pub(crate) fn fits(&self, by: ColorBy, wants_uvs: bool, materials: &Arc<Materials>) -> bool {
        let is_current = !wants_uvs || Arc::ptr_eq(&self.materials, materials);
        (self.by, self.wants_uvs) == (by, wants_uvs) && is_current
    }

    /// Whether corners have texture coordinates.
    pub(crate) fn has_uvs(&self) -> bool {
        self.has_uvs
    }

    /// Whether texture coordinates are wanted that the mesh has only had since an edit.
    pub(crate) fn misses_uvs(&self, mesh: &Mesh) -> bool {
        self.wants_uvs && !self.has_uvs && has_uvs(mesh)
    }

    /// The passes in which the mesh's textures are drawn; the first one draws faces without a texture too.
    pub(crate) fn passes(&self) -> BTreeSet<usize> {
        let textures = self.of_labels.iter().filter_map(|(_, texture)| *texture);
        textures.map(|texture| usize::from(texture) / TEXTURES_PER_DRAW).chain([0]).collect()
    }

    /// The passes with textures of translucent faces.
    pub(crate) fn translucent_passes(&self) -> BTreeSet<usize> {
        let textures = self.of_labels.iter().filter_map(|(_, texture)| *texture);
        let translucent = textures.filter(|texture| self.materials.is_translucent(*texture));
        translucent.map(|texture| usize::from(texture) / TEXTURES_PER_DRAW).collect()
    }

    /// What the colours stand for; none for colours of the mesh itself, and until all is measured.
    pub fn legend(&self) -> Option<Legend> {
        if self.by.label_key().is_some() {
            let labels = self.labels.iter().enumerate();
            return Some(Legend::Labels(labels.map(|(i, label)| (label.clone(), label_color(i))).collect()));
        }
        self.ramp.map(Legend::Ramp)
    }

    /// Whether a vertex's colour changes with its neighbours.
    pub(crate) fn depends_on_neighbours(&self) -> bool {
        self.by == ColorBy::Valence || self.by.curvature().is_some()
    }

    /// Begins to measure anew. The range of colours stays, so that colours don't jump.
    pub(crate) fn restart(&mut self, mesh: &Mesh) {
        self.measured = 0;
        self.has_uvs = self.needs_uvs(mesh);
    }

    /// Measures more vertices, as many as the budget allows; returns whether there are any left.
    pub(crate) fn measure(&mut self, mesh: &Mesh, budget: &mut Budget) -> bool {
        let (Some(curvature), total) = (self.by.curvature(), mesh.vertex_capacity()) else { return false };
        if self.measured >= total {
            return false;
        }
        if budget.is_spent() {
            return true;
        }
        self.values.resize(total, f32::NAN);
        let elements = (total - self.measured).saturating_mul(ELEMENTS_PER_CURVATURE);
        let end = self.measured + budget.take(elements).div_ceil(ELEMENTS_PER_CURVATURE);
        for at in self.measured..end {
            let value = mesh.vertex(at as u32).map_or(f64::NAN, |v| curvature(mesh, v));
            if let Some(place) = self.values.get_mut(at) {
                *place = value as f32;
            }
        }
        self.measured = end;
        if end < total {
            return true;
        }
        if self.ramp.is_none() {
            let end = end_of_range(&self.values);
            self.ramp = Some(Ramp::diverging(-end, end));
        }
        false
    }

    /// Measures the vertices of these faces again, and the new ones.
    pub(crate) fn follow(&mut self, mesh: &Mesh, faces: &[FaceId]) {
        let Some(curvature) = self.by.curvature() else { return };
        self.values.resize(mesh.vertex_capacity(), f32::NAN);
        self.measured = self.values.len();
        let faces = faces.iter().filter(|f| mesh.has_face(**f));
        let mut vertices = IdSet::default();
        faces.flat_map(|f| mesh.face_vertices(*f)).for_each(|v| vertices.insert(v.index()));
        for v in vertices.iter() {
            if let Some(place) = self.values.get_mut(v) {
                *place = curvature(mesh, VertexId::new(v)) as f32;
            }
        }
    }

    /// Whether a face's colour was chosen for it, rather than for its material.
    fn is_painted(&self, mesh: &Mesh, face: FaceId, color: Color) -> bool {
        color != self.of_face(mesh, face).0.unwrap_or(Color::UNPAINTED)
    }

    /// The colour and the texture of a face's material.
    fn of_face(&self, mesh: &Mesh, face: FaceId) -> (Option<Color>, Option<u16>) {
        let label = mesh.get(keys::FACE_MATERIAL, face.index()) as usize;
        self.of_labels.get(label).copied().unwrap_or_default()
    }

    /// The texture of a face whose corners these are.
    pub(crate) fn texture(
        &self,
        mesh: &Mesh,
        face: FaceId,
        uvs: &[Vec2],
        corners: &[HalfedgeId],
    ) -> FaceTexture {
        let is_placed = |h: &HalfedgeId| uvs.get(h.index()).is_some_and(|uv| !uv.is_nan());
        let (color, texture) = self.of_face(mesh, face);
        match texture.filter(|texture| self.materials.is_plain(*texture)) {
            Some(plain) if self.has_uvs => FaceTexture::plain(plain),
            _ if !self.has_uvs || !corners.iter().all(is_placed) => FaceTexture::NONE,
            _ => FaceTexture::of(color, texture),
        }
    }

    /// The colours of one face.
    pub(crate) fn face<'m>(&'m self, mesh: &'m Mesh, columns: &Columns<'m>, face: FaceId) -> FaceColors<'m> {
        let own = columns.faces.and_then(|colors| colors.get(face.index()).copied());
        let own = own.unwrap_or(Color::UNPAINTED);
        let one = |color| FaceColors { face: color, corners: Corners::Alike };
        let of_vertices = |color| FaceColors {
            face: color,
            corners: columns.vertices.map_or(Corners::Alike, Corners::Colors),
        };
        match self.by {
            ColorBy::Uniform => one(Color::UNPAINTED),
            ColorBy::Face => one(own),
            ColorBy::Vertex => of_vertices(Color::UNPAINTED),
            ColorBy::Paint if self.is_painted(mesh, face, own) => one(own),
            ColorBy::Paint => of_vertices(own),
            ColorBy::Material | ColorBy::Group => {
                let label = self.by.label_key().map_or(halfedge::NONE, |key| mesh.get(key, face.index()));
                one(if label == halfedge::NONE { Color::UNPAINTED } else { label_color(label as usize) })
            }
            ColorBy::Quality => {
                one(self.ramp.map_or(Color::UNPAINTED, |ramp| ramp.color(face_quality(mesh, face) as f32)))
            }
            ColorBy::Valence | ColorBy::GaussianCurvature | ColorBy::MeanCurvature => {
                let corners = match self.ramp {
                    Some(ramp) if self.by == ColorBy::Valence => Corners::Valence(mesh, ramp),
                    Some(ramp) => Corners::Values(&self.values, ramp),
                    None => Corners::Alike,
                };
                FaceColors { face: Color::UNPAINTED, corners }
            }
        }
    }
}

fn has_uvs(mesh: &Mesh) -> bool {
    mesh.attribute(keys::CORNER_UV).is_some()
}

/// The valence of regular vertices: six among triangles, else four.
fn regular_valence(mesh: &Mesh) -> f32 {
    let sample = mesh.faces().take(SAMPLED_FACES);
    let (triangles, all) = sample.fold((0, 0), |(triangles, all), face| {
        (triangles + usize::from(mesh.face_degree(face) == 3), all + 1)
    });
    if triangles * 2 > all { 6.0 } else { 4.0 }
}

/// The columns of a mesh that colours and textures come from, looked up once.
#[derive(Clone, Copy)]
pub(crate) struct Columns<'m> {
    faces: Option<&'m [Color]>,
    vertices: Option<&'m [Vec3]>,
    /// Texture coordinates; empty where the mesh has none.
    pub uvs: &'m [Vec2],
}

impl<'m> Columns<'m> {
    pub fn new(mesh: &'m Mesh) -> Self {
        Self {
            faces: mesh.attribute(keys::FACE_COLOR),
            vertices: mesh.attribute(keys::VERTEX_COLOR),
            uvs: mesh.attribute(keys::CORNER_UV).unwrap_or_default(),
        }
    }
}

/// The colours of one face's corners.
pub(crate) struct FaceColors<'m> {
    face: Color,
    corners: Corners<'m>,
}

/// Where the colours of corners come from.
enum Corners<'m> {
    /// The face.
    Alike,
    /// The vertices' own colours; where one is missing, the face.
    Colors(&'m [Vec3]),
    /// The number of edges at the vertices.
    Valence(&'m Mesh, Ramp),
    /// A measure of the vertices.
    Values(&'m [f32], Ramp),
}

impl FaceColors<'_> {
    /// The colour of the corner at a vertex.
    pub fn at(&self, vertex: VertexId) -> [u8; 3] {
        match self.corners {
            Corners::Alike => self.face.0,
            Corners::Colors(colors) => {
                let own = colors.get(vertex.index()).filter(|color| !color.is_nan());
                let byte = |c: f32| (c.clamp(0.0, 1.0) * 255.0).round() as u8;
                own.map_or(self.face.0, |color| color.to_array().map(byte))
            }
            Corners::Valence(mesh, ramp) => ramp.color(mesh.valence(vertex) as f32).0,
            Corners::Values(values, ramp) => {
                ramp.color(values.get(vertex.index()).copied().unwrap_or(f32::NAN)).0
            }
        }
    }
}
