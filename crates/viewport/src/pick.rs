//! Picking: the element under the pointer.

use crate::Camera;
use crate::region::{Region, ScreenRect};
use crate::sight::Sight;
use glam::{Vec2, Vec3};
use halfedge::geometry::BitSet;
use halfedge::{Budget, EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};
use surface::FaceTree;

/// Elements are first looked for within this many pixels, then within twice as many, up to the tolerance: a small or
/// distant model has all its elements within the tolerance.
const FIRST_RADIUS_PX: f32 = 1.0;
/// The most faces whose elements are candidates. Where more are within a pixel, any of them will do.
const MAX_CANDIDATE_FACES: usize = 1 << 12;
/// The most candidates that are tested for being hidden.
const MAX_RAYS: usize = 1 << 10;

/// What to pick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim {
    /// The kind of element.
    pub kind: Element,
    /// How many pixels away a vertex or an edge may be.
    pub radius: f32,
    /// Whether hidden elements are picked too.
    pub through: bool,
}

/// An element under the pointer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    /// Its kind.
    pub element: Element,
    /// Its id.
    pub id: u32,
    /// The distance from the eye in mesh units, for comparing picks in several objects.
    pub distance: f64,
}

/// Picks the element of a kind at a pixel, if there is one.
///
/// A face is picked at the pixel itself. A vertex or edge is the one nearest to the pixel on the screen, within the
/// radius, that isn't hidden, or with `through` whether it is hidden or not; of several in one place, the one in front.
/// An edge counts as hidden if its point nearest to the pixel is. Of an edge's two half-edges, the one of the face at the
/// pixel is picked; outside the surface the boundary one, or that of the face that faces the camera. Pixels are in the
/// unit of `viewport`. Costs O(log mesh + elements within the radius), a ray for each candidate, up to 1024, and for
/// vertices a pass over all of them that looks for isolated ones.
pub fn pick(
    mesh: &Mesh,
    tree: &FaceTree,
    camera: &Camera,
    viewport: Vec2,
    pixel: Vec2,
    aim: Aim,
) -> Option<Picked> {
    let sight = Sight::new(mesh, tree, camera, viewport);
    let under = || tree.hit(mesh, camera.ray(pixel, viewport));
    match aim.kind {
        Element::Face => {
            under().map(|hit| Picked { element: aim.kind, id: hit.face.raw(), distance: hit.distance })
        }
        Element::Vertex => nearest_vertex(&sight, pixel, aim, &Still::All).map(|(v, distance)| Picked {
            element: aim.kind,
            id: v.raw(),
            distance,
        }),
        Element::Edge => {
            nearest_edge(&sight, pixel, aim, &Still::All).map(|(edge, distance)| picked_edge(edge, distance))
        }
        Element::Halfedge => {
            let (edge, distance) = nearest_edge(&sight, pixel, aim, &Still::All)?;
            Some(picked_side(&sight, edge, under().map(|hit| hit.face), distance))
        }
    }
}

/// Picks like [`pick`]; where that finds nothing but a face is seen at the pixel, the vertex, edge or half-edge of this
/// face that is nearest to the pixel, however far away: a click on a model means some element of it. Where no face is
/// seen at the pixel but an edge is within the radius, the face beside this edge.
pub fn pick_nearest(
    mesh: &Mesh,
    tree: &FaceTree,
    camera: &Camera,
    viewport: Vec2,
    pixel: Vec2,
    aim: Aim,
) -> Option<Picked> {
    if let Some(picked) = pick(mesh, tree, camera, viewport, pixel, aim) {
        return Some(picked);
    }
    let sight = Sight::new(mesh, tree, camera, viewport);
    if aim.kind == Element::Face {
        let (edge, distance) = nearest_edge(&sight, pixel, aim, &Still::All)?;
        let side = side_of(&sight, edge, None);
        let face = mesh.face_of(side).or_else(|| mesh.face_of(side.twin()))?;
        return Some(Picked { element: aim.kind, id: face.raw(), distance });
    }
    let face = tree.hit(mesh, camera.ray(pixel, viewport))?.face;
    let mut rays = MAX_RAYS;
    let everywhere = Within { inner: -1.0, outer: f32::INFINITY };
    match aim.kind {
        Element::Vertex => {
            let corners = mesh.face_vertices(face).filter_map(|v| place(&sight, pixel, v));
            first_seen(corners, everywhere, |v, _| sees_vertex(&sight, v, aim, &Still::All), &mut rays)
                .map(|(v, distance)| Picked { element: aim.kind, id: v.raw(), distance })
        }
        _ => {
            let sides = mesh.face_halfedges(face).filter_map(|h| place_edge(&sight, pixel, h.edge()));
            let (edge, distance) = first_seen(
                sides,
                everywhere,
                |e, point| sees_edge(&sight, e, point, aim, &Still::All),
                &mut rays,
            )?;
            Some(match aim.kind {
                Element::Halfedge => picked_side(&sight, edge, Some(face), distance),
                _ => picked_edge(edge, distance),
            })
        }
    }
}

/// An element near the pixel.
struct Candidate<T> {
    /// How far from the pixel its nearest point is, in pixels.
    away: f32,
    /// That point.
    point: Vec3,
    /// The point's depth.
    depth: f64,
    element: T,
}

/// The distances from the pixel at which elements are looked for: more than `inner`, at most `outer`.
#[derive(Clone, Copy)]
struct Within {
    inner: f32,
    outer: f32,
}

fn place(sight: &Sight<'_>, pixel: Vec2, v: VertexId) -> Option<Candidate<VertexId>> {
    let point = sight.mesh.position(v);
    let (at, depth) = sight.view().project(point)?;
    Some(Candidate { away: at.distance(pixel), point, depth, element: v })
}

fn place_edge(sight: &Sight<'_>, pixel: Vec2, edge: EdgeId) -> Option<Candidate<EdgeId>> {
    let segment = sight.segment(edge)?;
    let (t, away) = segment.nearest(pixel);
    let point = sight.point_on(&segment, t);
    Some(Candidate { away, point, depth: sight.view().depth(point), element: edge })
}

/// The elements that are picked: all of them or, while some move, the others. What moves hides nothing.
pub(crate) enum Still<'a> {
    All,
    /// Those without any of these vertices.
    Without(&'a BitSet),
}

impl Still<'_> {
    pub fn vertex(&self, v: VertexId) -> bool {
        match self {
            Self::All => true,
            Self::Without(moved) => !moved.contains(v.index()),
        }
    }

    pub fn face(&self, mesh: &Mesh, f: FaceId) -> bool {
        match self {
            Self::All => true,
            Self::Without(_) => mesh.face_vertices(f).all(|v| self.vertex(v)),
        }
    }
}

/// The distance of a vertex from the eye, unless it is hidden and that matters.
fn sees_vertex(sight: &Sight<'_>, v: VertexId, aim: Aim, still: &Still<'_>) -> Option<f64> {
    let (mesh, point) = (sight.mesh, sight.mesh.position(v));
    if aim.through {
        return sight.distance(point);
    }
    sight.sees(point, |f| mesh.face_vertices(f).any(|w| w == v) || !still.face(mesh, f))
}

fn sees_edge(sight: &Sight<'_>, edge: EdgeId, point: Vec3, aim: Aim, still: &Still<'_>) -> Option<f64> {
    if aim.through {
        return sight.distance(point);
    }
    sight.sees_edge_at(edge, point, |f| !still.face(sight.mesh, f))
}

pub(crate) fn nearest_vertex(
    sight: &Sight<'_>,
    pixel: Vec2,
    aim: Aim,
    still: &Still<'_>,
) -> Option<(VertexId, f64)> {
    let mesh = sight.mesh;
    // No ray hits an isolated vertex, and no face has it.
    let first = mesh.connectivity().vertex_halfedge.iter().enumerate();
    let alone = first.filter(|(_, h)| **h == halfedge::NONE).filter_map(|(v, _)| mesh.vertex(v as u32));
    let alone: Vec<VertexId> = alone
        .filter(|&v| place(sight, pixel, v).is_some_and(|candidate| candidate.away <= aim.radius))
        .collect();
    nearest(sight, pixel, aim, |faces, within, rays| {
        let mut vertices: Vec<VertexId> = faces.iter().flat_map(|&f| mesh.face_vertices(f)).collect();
        vertices.extend(&alone);
        vertices.sort_unstable();
        vertices.dedup();
        let wanted = vertices.into_iter().filter(|v| still.vertex(*v));
        let candidates = wanted.filter_map(|v| place(sight, pixel, v));
        first_seen(candidates, within, |v, _| sees_vertex(sight, v, aim, still), rays)
    })
}

pub(crate) fn nearest_edge(
    sight: &Sight<'_>,
    pixel: Vec2,
    aim: Aim,
    still: &Still<'_>,
) -> Option<(EdgeId, f64)> {
    nearest(sight, pixel, aim, |faces, within, rays| {
        let mut edges: Vec<EdgeId> =
            faces.iter().flat_map(|&f| sight.mesh.face_halfedges(f)).map(HalfedgeId::edge).collect();
        edges.sort_unstable();
        edges.dedup();
        let wanted = edges.into_iter().filter(|e| sight.mesh.ends(*e).into_iter().all(|v| still.vertex(v)));
        let candidates = wanted.filter_map(|e| place_edge(sight, pixel, e));
        first_seen(candidates, within, |e, point| sees_edge(sight, e, point, aim, still), rays)
    })
}

/// The point of an edge that is nearest to the pixel on the screen; none behind the eye.
pub(crate) fn point_of_edge(sight: &Sight<'_>, pixel: Vec2, edge: EdgeId) -> Option<Vec3> {
    place_edge(sight, pixel, edge).map(|candidate| candidate.point)
}

/// Looks for the nearest element in growing circles. `look` gets the faces near a circle and returns the nearest element
/// in it.
fn nearest<T>(
    sight: &Sight<'_>,
    pixel: Vec2,
    aim: Aim,
    mut look: impl FnMut(&[FaceId], Within, &mut usize) -> Option<T>,
) -> Option<T> {
    let mut within = Within { inner: -1.0, outer: FIRST_RADIUS_PX.min(aim.radius) };
    let mut rays = MAX_RAYS;
    loop {
        let area = Region::brush(pixel, pixel, within.outer).bounds();
        let (faces, is_all) = faces_near(sight, &area);
        if let Some(found) = look(&faces, within, &mut rays) {
            return Some(found);
        }
        if within.outer >= aim.radius || !is_all || rays == 0 {
            return None;
        }
        within = Within { inner: within.outer, outer: (within.outer * 2.0).min(aim.radius) };
    }
}

/// The faces whose box reaches into an area, and whether these are all of them.
fn faces_near(sight: &Sight<'_>, area: &ScreenRect) -> (Vec<FaceId>, bool) {
    let mut faces = Vec::new();
    // A margin for rounding.
    let area = area.expand(0.1);
    let is_left = sight.tree.walk().step(
        sight.tree,
        sight.mesh,
        &mut Budget::new(MAX_CANDIDATE_FACES),
        |bounds| sight.may_overlap(bounds, &area),
        |face| faces.push(face),
    );
    (faces, !is_left)
}

/// The nearest of the candidates that is seen, and its distance from the eye; takes a ray from `rays` for each.
fn first_seen<T: Copy>(
    candidates: impl Iterator<Item = Candidate<T>>,
    within: Within,
    sees: impl Fn(T, Vec3) -> Option<f64>,
    rays: &mut usize,
) -> Option<(T, f64)> {
    let mut near: Vec<_> = candidates.filter(|c| c.away > within.inner && c.away <= within.outer).collect();
    near.sort_by(|a, b| a.away.total_cmp(&b.away).then(a.depth.total_cmp(&b.depth)));
    for candidate in near {
        *rays = rays.checked_sub(1)?;
        if let Some(distance) = sees(candidate.element, candidate.point) {
            return Some((candidate.element, distance));
        }
    }
    None
}

fn picked_edge(edge: EdgeId, distance: f64) -> Picked {
    Picked { element: Element::Edge, id: edge.raw(), distance }
}

fn picked_side(sight: &Sight<'_>, edge: EdgeId, under: Option<FaceId>, distance: f64) -> Picked {
    Picked { element: Element::Halfedge, id: side_of(sight, edge, under).raw(), distance }
}

/// The half-edge of an edge to pick while the pointer is over the face `under`.
fn side_of(sight: &Sight<'_>, edge: EdgeId, under: Option<FaceId>) -> HalfedgeId {
    let mesh = sight.mesh;
    let sides = edge.halfedges();
    let over = |h: &HalfedgeId| under.is_some() && mesh.face_of(*h) == under;
    let outside = |h: &HalfedgeId| mesh.is_boundary_halfedge(*h);
    let towards = |h: &HalfedgeId| {
        let face = mesh.face_of(*h).filter(|f| !sight.tree.hidden().contains(f.index()));
        face.is_some_and(|f| {
            let to_eye = if sight.camera.orthographic {
                -sight.camera.axes()[2]
            } else {
                sight.camera.eye() - mesh.position(mesh.from(*h)).as_dvec3()
            };
            halfedge::geometry::face_area_vector(mesh, f).dot(to_eye) > 0.0
        })
    };
    let found = sides
        .into_iter()
        .find(over)
        .or_else(|| sides.into_iter().find(outside))
        .or_else(|| sides.into_iter().find(towards));
    found.unwrap_or(edge.halfedge())
}
