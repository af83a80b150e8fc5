//! The normals of corners: how faces meet in the picture.

use glam::{DVec3, Vec3};
use halfedge::geometry::face_area_vector;
use halfedge::{Budget, FaceId, HalfedgeId, Mesh, VertexId};
use rustc_hash::FxHashMap;
use surface::normals;

/// Which normals shade faces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shading {
    /// Each face has one normal.
    Flat,
    /// Area-weighted vertex normals are interpolated over faces.
    Smooth,
    /// As smooth, but edges whose faces meet at a greater angle than this, in degrees, stay hard.
    Auto(f32),
}

impl Default for Shading {
    fn default() -> Self {
        Self::Auto(Self::HARD_ANGLE_DEGREES)
    }
}

impl Shading {
    /// The usual angle in degrees above which edges are hard: a cylinder of 12 sides is still round, and so is a
    /// scan, but bevels of two steps and the edges of machine parts show.
    pub const HARD_ANGLE_DEGREES: f32 = 30.0;
}

/// A unit vector in the stream's format, without a texture. Zero stays zero, which shaders take for "no normal".
pub(crate) fn pack(normal: Vec3) -> [i16; 4] {
    let [x, y, z] = (normal * 32767.0).round().to_array().map(|c| c as i16);
    [x, y, z, 0]
}

/// The areas of so many faces take about as long as writing one.
const AREAS_PER_ELEMENT: usize = 4;

/// The normals of a whole mesh's corners, from values that are computed beforehand.
#[derive(Clone, Debug)]
pub(crate) enum WholeNormals {
    Flat,
    /// The packed normals of the vertices.
    Smooth(Vec<[i16; 4]>),
    /// The area vectors of the faces, what is known of the vertices, and when an edge is hard.
    Auto(Vec<DVec3>, Vec<AtVertex>, Hardness),
}

/// What the corners around a vertex have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) enum AtVertex {
    Unknown,
    /// Without a hard edge all have one packed normal.
    Smooth([i16; 4]),
    HasHardEdge,
}

impl WholeNormals {
    /// Normals that are still to be prepared.
    pub fn new(shading: Shading) -> Self {
        match shading {
            Shading::Flat => Self::Flat,
            Shading::Smooth => Self::Smooth(Vec::new()),
            Shading::Auto(degrees) => Self::Auto(Vec::new(), Vec::new(), Hardness::new(degrees)),
        }
    }

    /// Computes more of what normals are made of, as much as the budget allows; returns whether there is any left.
    pub fn prepare(&mut self, mesh: &Mesh, budget: &mut Budget) -> bool {
        match self {
            Self::Flat => false,
            Self::Smooth(packed) => {
                let total = mesh.vertex_capacity();
                let end = packed.len() + budget.take(total.saturating_sub(packed.len()));
                let normal =
                    |v| mesh.vertex(v).map_or([0; 4], |vertex| pack(normals::vertex_normal(mesh, vertex)));
                packed.extend((packed.len() as u32..end as u32).map(normal));
                end < total
            }
            Self::Auto(areas, vertices, _) => {
                let total = mesh.face_capacity();
                let end =
                    areas.len() + budget.take_light(total.saturating_sub(areas.len()), AREAS_PER_ELEMENT);
                let area = |f| mesh.face(f).map_or(DVec3::ZERO, |face| face_area_vector(mesh, face));
                areas.extend((areas.len() as u32..end as u32).map(area));
                vertices.resize(mesh.vertex_capacity(), AtVertex::Unknown);
                end < total
            }
        }
    }

    /// The packed normal of the corner at the start of a half-edge; zero where it has none of its own.
    pub fn at(&mut self, mesh: &Mesh, corner: HalfedgeId) -> [i16; 4] {
        match self {
            Self::Flat => [0; 4],
            Self::Smooth(packed) => packed.get(mesh.from(corner).index()).copied().unwrap_or_default(),
            Self::Auto(areas, vertices, hardness) => {
                let area = |f: FaceId| areas.get(f.index()).copied().unwrap_or_default();
                let v = mesh.from(corner);
                let Some(known) = vertices.get_mut(v.index()) else { return [0; 4] };
                if let AtVertex::Unknown = known {
                    *known = hardness.at_vertex(mesh, v, area);
                }
                match *known {
                    AtVertex::Smooth(packed) => packed,
                    _ => pack(hardness.normal(mesh, corner, area)),
                }
            }
        }
    }
}

/// For more faces than one of so many, values are kept by id: looking them up by number takes longer.
const FACES_PER_LOOKED_UP: usize = 16;

/// Values by id, each computed when it is first asked for.
enum Lazy<T> {
    Few(FxHashMap<usize, T>),
    Many(Vec<Option<T>>),
}

impl<T: Copy> Lazy<T> {
    /// For few of the ids, or for so many.
    fn new(many: Option<usize>) -> Self {
        many.map_or_else(|| Self::Few(FxHashMap::default()), |count| Self::Many(vec![None; count]))
    }

    fn get(&mut self, id: usize, value: impl FnOnce() -> T) -> T {
        match self {
            Self::Few(values) => *values.entry(id).or_insert_with(value),
            Self::Many(values) => match values.get_mut(id) {
                Some(known) => *known.get_or_insert_with(value),
                None => value(),
            },
        }
    }
}

/// The normals of corners around an edit, computed when they are asked for.
pub(crate) struct LocalNormals {
    shading: Shading,
    vertices: Lazy<AtVertex>,
    areas: Lazy<DVec3>,
}

impl LocalNormals {
    /// For an edit that changes so many faces of a mesh.
    pub fn new(shading: Shading, mesh: &Mesh, faces: usize) -> Self {
        let are_many = faces > mesh.face_count() / FACES_PER_LOOKED_UP;
        let of = |capacity: usize| are_many.then_some(capacity);
        Self {
            shading,
            vertices: Lazy::new(of(mesh.vertex_capacity())),
            areas: Lazy::new(of(mesh.face_capacity())),
        }
    }

    /// As [`WholeNormals::at`], to the bit.
    pub fn at(&mut self, mesh: &Mesh, corner: HalfedgeId) -> [i16; 4] {
        match self.shading {
            Shading::Flat => [0; 4],
            Shading::Smooth => {
                let v = mesh.from(corner);
                let smooth = || AtVertex::Smooth(pack(normals::vertex_normal(mesh, v)));
                match self.vertices.get(v.index(), smooth) {
                    AtVertex::Smooth(packed) => packed,
                    _ => [0; 4],
                }
            }
            Shading::Auto(degrees) => {
                let (v, hardness) = (mesh.from(corner), Hardness::new(degrees));
                let areas = &mut self.areas;
                let mut area = |f: FaceId| areas.get(f.index(), || face_area_vector(mesh, f));
                match self.vertices.get(v.index(), || hardness.at_vertex(mesh, v, &mut area)) {
                    AtVertex::Smooth(packed) => packed,
                    _ => pack(hardness.normal(mesh, corner, area)),
                }
            }
        }
    }
}

/// When an edge is hard: the cosine of the greatest angle between faces that are shaded as one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hardness {
    cos: f64,
}

impl Hardness {
    /// Edges whose faces meet at a greater angle than this are hard.
    pub fn new(degrees: f32) -> Self {
        Self { cos: f64::from(degrees).to_radians().cos() }
    }

    /// Whether faces with these area vectors meet at a hard edge. A face without area has no hard edges.
    pub fn is_hard(self, a: DVec3, b: DVec3) -> bool {
        a.dot(b) < self.cos * (a.length_squared() * b.length_squared()).sqrt()
    }

    /// What the corners around a vertex have in common.
    fn at_vertex(self, mesh: &Mesh, vertex: VertexId, mut area: impl FnMut(FaceId) -> DVec3) -> AtVertex {
        let mut sum = DVec3::ZERO;
        for h in mesh.outgoing(vertex) {
            let Some(left) = mesh.face_of(h).map(&mut area) else { continue };
            sum += left;
            if mesh.face_of(h.twin()).map(&mut area).is_some_and(|right| self.is_hard(left, right)) {
                return AtVertex::HasHardEdge;
            }
        }
        AtVertex::Smooth(pack(sum.normalize_or_zero().as_vec3()))
    }

    /// The area-weighted mean normal of the faces around a corner up to the hard edges on both sides.
    fn normal(self, mesh: &Mesh, corner: HalfedgeId, mut area: impl FnMut(FaceId) -> DVec3) -> Vec3 {
        let Some(face) = mesh.face_of(corner) else { return Vec3::ZERO };
        let own = area(face);
        let mut sum = own;
        // Adds the faces in one direction, from one half-edge that leaves the vertex to the next; gives the one
        // that it ends at. Both directions end at the same edge if there is only one hard edge.
        let mut walk = |turn: &dyn Fn(HalfedgeId) -> HalfedgeId| {
            let (mut at, mut last) = (turn(corner), own);
            while let Some(next) = mesh.face_of(at).filter(|_| at != corner).map(&mut area) {
                if self.is_hard(last, next) {
                    break;
                }
                sum += next;
                if next != DVec3::ZERO {
                    last = next;
                }
                at = turn(at);
            }
            at
        };
        if walk(&|h| mesh.prev(h).twin()) != corner {
            walk(&|h| mesh.next(h.twin()));
        }
        sum.normalize_or_zero().as_vec3()
    }
}
