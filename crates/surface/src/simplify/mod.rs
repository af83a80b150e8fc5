//! Simplifying by edge collapse in order of the error quadrics.
//!
//! Garland and Heckbert: Surface simplification using quadric error metrics (1997), with weights between
//! areas, which keep the mean distance small, and equal ones, which keep small spikes; with planes that hold
//! boundaries and attribute seams, a faint pull towards the old vertices that decides where the planes leave
//! a direction open, and every collapse checked: the link condition (the result stays a manifold of the same
//! topology), no triangle turned over or flattened.

mod collapse_order;
mod deviation;
mod limit;
mod measurement;
mod quadric;
mod queue;

use crate::SurfaceError;
use crate::face_tree::along_segment;
use crate::pace::Pace;
use crate::trimesh::{Order, Renumbering, TriMesh, area_vector, next, prev};
use glam::DVec3;
use halfedge::{Element, Mesh, NONE, Progress, keys};
use limit::Limit;
use measurement::Measured;
use quadric::Quadric;
use queue::Queue;

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SimplifyTarget {
    /// To this many triangles.
    Faces(usize),
    /// To this share of the triangles, above 0 and up to 1.
    Ratio(f64),
    /// As far as the surface stays within this distance of what it was, in mesh units.
    ///
    /// Each collapse is held to it in one of two ways. The distances that collapses move the surface by,
    /// at most and both ways, are added up; while the sum is within the limit, that holds for every
    /// point. Where the sum is past it, which it is long before the surface is, distances are measured and
    /// have to be within 85 % of the limit. New triangles are quartered until a bound for all points of each
    /// part is within it: from the corners' distances to one triangle of the input, from the part's size,
    /// or, where the parts are smaller than the input's triangles, from the angle between those that its
    /// corners are closest to. The input's triangles are measured at their corners, middles and middles of
    /// sides; where there are few of them, at up to seven times as many points, so that large ones have
    /// them closer together. What is left unproven is an input that bends more than once within a part of
    /// a new triangle that is smaller than its own triangles, or than a 128th of it, and not at any of those
    /// points.
    MaxError(f64),
}

/// What to simplify to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simplify {
    /// How far to go.
    pub target: SimplifyTarget,
    /// Whether boundary vertices stay on the boundary curve, which is simplified by itself; else the
    /// boundary is held as faintly as the surface is.
    pub preserve_boundary: bool,
    /// Whether vertices on seams of corner attributes, such as texture coordinates, stay on them; else
    /// the values beside a seam that moves no longer meet where they did.
    pub preserve_seams: bool,
}

/// A simplified mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Simplified {
    /// The triangles.
    pub mesh: Mesh,
    /// The count that was asked for, where one was.
    pub wanted: Option<usize>,
    /// Whether it stopped early and has seams of corner attributes that were preserved.
    pub has_seams: bool,
}

impl Simplified {
    /// In words, why there are not as few triangles as asked for, if there are not.
    pub fn shortfall(&self) -> Option<String> {
        let (wanted, faces) = (self.wanted?, self.mesh.face_count());
        if faces == wanted {
            return None;
        }
        let closed = self.mesh.boundary_loops().is_empty();
        Some(if faces.checked_sub(1) == Some(wanted) && closed && wanted % 2 == 1 {
            format!("{faces} triangles, not {wanted}: a closed mesh has an even number of them")
        } else if faces < wanted {
            format!("the mesh has only {faces} triangle{}", if faces == 1 { "" } else { "s" })
        } else {
            let seam =
                if self.has_seams { "break a seam of the texture coordinates or normals, " } else { "" };
            format!(
                "stopped at {faces} triangles, not {wanted}: any further collapse would {seam}turn over or \
                 flatten a triangle, close a hole or glue faces together"
            )
        })
    }
}

/// How much a vertex counts as a target of its own against its planes: too little to move a point off
/// its planes, enough to keep it from sliding along them.
const PULL: f64 = 1e-6;
/// How much each face counts besides its area, in mean areas.
const EVEN: f64 = 0.5;
/// How much more than faces the planes count that hold boundaries and seams.
const HOLD: f64 = 100.0;
/// A face may turn by no more than acos of this in one collapse.
const LEAST_COS: f64 = 0.2;
/// Twice the area over the longest side's square: 0.87 for an equilateral triangle. None gets below,
/// unless it was already.
const LEAST_SHAPE: f64 = 0.02;

/// Simplifies a mesh; the input is untouched. Polygons are cut into triangles first, isolated vertices
/// left out. Face attributes stay with the triangles that stay; corner and vertex attributes are mixed
/// where vertices merge, and edges where corner attributes differ are kept like a boundary, if
/// asked. Costs O(n log n) at most: the queue takes O(1) a step.
///
/// # Errors
/// [`SurfaceError::BadField`] for a target out of range; [`SurfaceError::Cancelled`].
pub fn simplify(
    mesh: &Mesh,
    options: &Simplify,
    progress: &mut Progress<'_>,
) -> Result<Simplified, SurfaceError> {
    let mut pace = Pace::new(progress);
    match options.target {
        SimplifyTarget::Ratio(ratio) if !(ratio > 0.0 && ratio <= 1.0) => {
            return Err(SurfaceError::field("ratio", "above 0 and at most 1"));
        }
        SimplifyTarget::MaxError(error) if !(error >= 0.0 && error.is_finite()) => {
            return Err(SurfaceError::field("max_error", "a finite number, 0 or more"));
        }
        _ => {}
    }
    pace.at(0.0)?;
    let mut tri = TriMesh::new(mesh);
    if mesh.columns().of(Element::Face).is_empty() {
        tri.face_source = Vec::new();
    }
    let before = tri.faces;
    let wanted = match options.target {
        SimplifyTarget::Faces(faces) => Some(faces),
        SimplifyTarget::Ratio(ratio) => Some((before as f64 * ratio).round() as usize),
        SimplifyTarget::MaxError(_) => None,
    };
    let mut work = Work::new(mesh, tri, options);
    pace.at(0.05)?;
    collapse_order::to(&mut work, wanted.unwrap_or(0), &mut pace.part(0.1, 0.95))?;
    let tri = work.finish();
    let has_seams = options.preserve_seams
        && wanted.is_some_and(|wanted| tri.faces > wanted)
        && (0..tri.v.len() as u32).any(|h| tri.is_alive(h) && tri.is_seam(h));
    let mesh = tri.into_mesh(mesh);
    pace.at(1.0)?;
    Ok(Simplified { mesh, wanted, has_seams })
}

/// What a vertex is part of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Role {
    /// Nothing but the surface.
    Free,
    /// A boundary or seam that passes through it: it stays on that.
    Curve,
    /// Where such curves meet or end: it stays where it is.
    Fixed,
}

struct Work<'a> {
    source: &'a Mesh,
    tri: TriMesh,
    quadrics: Vec<Quadric>,
    roles: Vec<Role>,
    queue: Queue,
    stamps: Vec<u32>,
    stamp: u32,
    /// Per vertex: whether a collapse at it was refused since its surroundings last changed.
    refused: Vec<bool>,

    preserve_boundary: bool,
    preserve_seams: bool,
    limit: Option<Limit>,
}

/// Where an edge's merged vertex would go, and what it costs.
struct Place {
    cost: f64,
    at: DVec3,
}

impl<'a> Work<'a> {
    fn new(mesh: &'a Mesh, tri: TriMesh, options: &Simplify) -> Self {
        let vertices = tri.out.len();
        let limit = match options.target {
            // Rounding positions to floats must not go past it.
            SimplifyTarget::MaxError(error) => {
                Some(Limit::new(tri.v.len() / 3, vertices, error / tri.frame.scale - 1e-7))
            }
            _ => None,
        };
        let mut work = Self {
            source: mesh,
            quadrics: vec![Quadric::default(); vertices],
            roles: vec![Role::Free; vertices],
            queue: Queue::new(tri.v.len()),
            stamps: vec![0; vertices],
            stamp: 0,
            refused: vec![false; vertices],
            preserve_boundary: options.preserve_boundary,
            preserve_seams: options.preserve_seams,
            limit,
            tri,
        };
        work.add_faces();
        work.add_curves(mesh);
        work
    }

    /// Starts to measure distances. What was removed no longer takes memory then.
    fn measure(&mut self, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        let Some(limit) = &mut self.limit else { return Ok(()) };
        // Below what rounding takes nothing can be measured.
        if limit.distance <= 0.0 {
            return Ok(());
        }
        self.queue.restart(0);
        self.stamps = Vec::new();
        let before = self.tri.out.len();
        let Order { vertices, triangles } = self.tri.put_in_order();
        vertices.apply(&mut self.quadrics);
        vertices.apply(&mut self.roles);
        vertices.apply(&mut self.refused);
        triangles.apply(&mut limit.error);
        let Renumbering(near) = triangles;
        let number = vertices.new_numbers(before);
        // Numbered as the triangles were in the beginning.
        let input = TriMesh::bare(self.source);
        let mut into = std::mem::take(&mut limit.into);
        let merged = |v: u32| {
            let mut v = v as usize;
            while into[v] as usize != v {
                into[v] = into[into[v] as usize];
                v = into[v] as usize;
            }
            number[v]
        };
        let measured = Measured::new(input, &self.tri, near, &limit.error, merged, limit.distance, pace)?;
        limit.measured = Some(measured);
        self.stamps = vec![0; self.tri.out.len()];
        self.stamp = 0;
        self.refused.fill(false);
        self.queue.restart(self.tri.v.len());
        Ok(())
    }

    /// The triangles; everything else goes, to make room for the result.
    fn finish(self) -> TriMesh {
        self.tri
    }

    fn add_faces(&mut self) {
        let tri = &self.tri;
        let faces = || (0..tri.faces as u32).map(|f| tri.places(f));
        let even = EVEN * faces().map(|face| area_vector(&face).length()).sum::<f64>() / tri.faces as f64;
        for (corners, face) in tri.v.chunks_exact(3).zip(faces()) {
            let normal = area_vector(&face);
            let weight = normal.length() + even;
            let plane = match normal.try_normalize() {
                Some(normal) => Quadric::plane(normal, face[0], weight),
                None => Quadric::default(),
            };
            for (&v, p) in corners.iter().zip(face) {
                let q = &mut self.quadrics[v as usize];
                q.add(&plane);
                q.add(&Quadric::point(p, weight * PULL));
            }
        }
    }

    /// Planes that hold boundaries, seams of corner attributes, creases, and borders between materials,
    /// groups and colours; roles of the vertices on the first two.
    fn add_curves(&mut self, mesh: &Mesh) {
        let tri = &self.tri;
        let mut curves = vec![0u8; tri.out.len()];
        let material = mesh.attribute(keys::FACE_MATERIAL);
        let group = mesh.attribute(keys::FACE_GROUP);
        let color = mesh.attribute(keys::FACE_COLOR);
        let crease = mesh.attribute(keys::EDGE_CREASE);
        let differ = |a: u32, b: u32| {
            let [Some(&a), Some(&b)] = [a, b].map(|f| tri.face_source.get(f as usize)) else { return false };
            let (a, b) = (a as usize, b as usize);
            material.is_some_and(|m| m[a] != m[b])
                || group.is_some_and(|g| g[a] != g[b])
                || color.is_some_and(|c| c[a] != c[b])
        };
        let is_creased = |h: u32| {
            crease
                .zip(tri.edge_source.get(h as usize))
                .is_some_and(|(crease, &e)| crease.get(e as usize).is_some_and(|&sharpness| sharpness > 0.0))
        };
        for h in 0..tri.v.len() as u32 {
            let across = tri.opp(h);
            let boundary = across == NONE;
            let seam = !boundary && self.preserve_seams && tri.is_seam(h);
            if !(boundary || seam || differ(h / 3, across / 3) || is_creased(h)) {
                continue;
            }
            let (a, b) = (tri.from(h), tri.to(h));
            let strict = seam || (boundary && self.preserve_boundary);
            if strict {
                // A seam is met from both sides.
                for v in [a, b] {
                    curves[v as usize] = curves[v as usize].saturating_add(if boundary { 2 } else { 1 });
                }
            }
            let (from, to, apex) = (tri.at(a), tri.at(b), tri.at(tri.apex(h)));
            let along = to - from;
            let face = along.cross(apex - from);
            if let Some(normal) = along.cross(face).try_normalize() {
                let hold = if boundary && !self.preserve_boundary { 1.0 } else { HOLD };
                let plane = Quadric::plane(normal, from, along.length_squared() * hold);
                self.quadrics[a as usize].add(&plane);
                self.quadrics[b as usize].add(&plane);
            }
        }
        for (role, &sides) in self.roles.iter_mut().zip(&curves) {
            *role = match sides {
                0 => Role::Free,
                4 => Role::Curve,
                _ => Role::Fixed,
            };
        }
    }

    /// Whether an edge is part of a curve that vertices stay on.
    fn is_curve(&self, h: u32) -> bool {
        if self.tri.opp(h) == NONE {
            self.preserve_boundary
        } else {
            self.preserve_seams && self.tri.is_seam(h)
        }
    }

    /// Where the ends of an edge would merge; none if they may not.
    fn place(&self, h: u32) -> Option<Place> {
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let sum = self.quadrics[a as usize].sum(&self.quadrics[b as usize]);
        let (p, q) = (self.tri.at(a), self.tri.at(b));
        let stay = |at: DVec3| Some(Place { cost: sum.at(at), at });
        let roles = (self.roles[a as usize], self.roles[b as usize]);
        match roles {
            (Role::Free, Role::Free) => {}
            (_, Role::Free) => return stay(p),
            (Role::Free, _) => return stay(q),
            _ if !self.is_curve(h) => return None,
            (Role::Curve, Role::Curve) => {}
            (Role::Fixed, Role::Curve) => return stay(p),
            (Role::Curve, Role::Fixed) => return stay(q),
            (Role::Fixed, Role::Fixed) => return None,
        }
        let middle = (p + q) * 0.5;
        let reach = 4.0 * p.distance_squared(q);
        if let Some(at) = sum.minimum()
            && at.distance_squared(middle) <= reach
        {
            return stay(at);
        }
        [p, q, middle]
            .into_iter()
            .map(|at| Place { cost: sum.at(at), at })
            .reduce(|best, other| if other.cost < best.cost { other } else { best })
    }

    /// Collapses an edge if that leaves a good mesh; says whether it did.
    fn try_collapse(&mut self, h: u32, at: DVec3) -> bool {
        // What is checked is what will be there, rounded.
        let at = self.tri.frame.inward(self.tri.frame.outward(at));
        self.stamp += 1;
        if !at.is_finite()
            || !self.tri.can_collapse(h, &mut self.stamps, self.stamp)
            || !self.keeps_faces(h, at)
        {
            return false;
        }
        let Some(error) = self.new_error(h, at) else { return false };
        let tri = &mut self.tri;
        let (a, b, across) = (tri.from(h), tri.to(h), tri.opp(h));
        // Two edges of each triangle become one. What it will cost is no less than what either does:
        // quadrics only grow.
        let mut joined = [(NONE, 0); 2];
        for (side, joined) in [h, across].into_iter().zip(&mut joined) {
            if side == NONE {
                continue;
            }
            self.queue.remove(tri.edge(side));
            let ranks = [next(side), prev(side)].map(|k| {
                let rank = self.queue.rank_of(tri.edge(k));
                self.queue.remove(tri.edge(k));
                rank
            });
            if let [Some(left), Some(right)] = ranks {
                *joined = (tri.opp(next(side)).min(tri.opp(prev(side))), left.max(right));
            }
        }
        tri.collapse(h, along_segment(tri.at(a), tri.at(b), at));
        tri.put(a, at);
        let merged = self.quadrics[b as usize];
        self.quadrics[a as usize].add(&merged);
        if self.roles[b as usize] == Role::Fixed || self.roles[a as usize] == Role::Free {
            self.roles[a as usize] = self.roles[b as usize];
        }
        self.note_merge(b, a, error);
        for (edge, rank) in joined {
            if edge != NONE {
                self.queue.put(edge, rank);
            }
        }
        let first = self.tri.out[a as usize];
        let mut around = first;
        loop {
            self.put_back(self.tri.edge(around));
            self.retry(self.tri.to(around));
            let after = self.tri.turn(around);
            if after == NONE {
                self.put_back(prev(around));
                self.retry(self.tri.apex(around));
                break;
            }
            if after == first {
                break;
            }
            around = after;
        }
        true
    }

    /// Puts the edges of a vertex whose triangles have changed back in the queue, if one was refused.
    fn retry(&mut self, v: u32) {
        if !std::mem::take(&mut self.refused[v as usize]) {
            return;
        }
        let first = self.tri.out[v as usize];
        let mut around = first;
        loop {
            self.put_back(self.tri.edge(around));
            let after = self.tri.turn(around);
            if after == NONE {
                self.put_back(prev(around));
                break;
            }
            if after == first {
                break;
            }
            around = after;
        }
    }

    /// Whether no triangle around the edge turns over or becomes a sliver when its ends move to `at`.
    fn keeps_faces(&self, h: u32, at: DVec3) -> bool {
        let tri = &self.tri;
        let (a, b) = (tri.from(h), tri.to(h));
        for (v, other) in [(a, b), (b, a)] {
            let here = tri.at(v);
            let mut good = true;
            tri.around(v, |out| {
                let (x, y) = (tri.to(out), tri.apex(out));
                if x == other || y == other || !good {
                    return;
                }
                let (x, y) = (tri.at(x), tri.at(y));
                let old = (x - here).cross(y - here);
                let new = (x - at).cross(y - at);
                let (old_squared, new_squared) = (old.length_squared(), new.length_squared());
                let turned = old.dot(new);
                if turned < 0.0 || turned * turned < LEAST_COS * LEAST_COS * old_squared * new_squared {
                    // A triangle without area faces nowhere.
                    good = old_squared == 0.0 && new_squared > 0.0;
                }
                let rim = x.distance_squared(y);
                let longest = rim.max(x.distance_squared(at)).max(y.distance_squared(at));
                if new_squared < LEAST_SHAPE * LEAST_SHAPE * longest * longest {
                    let was = rim.max(x.distance_squared(here)).max(y.distance_squared(here));
                    good &= new_squared > 0.0 && new_squared * was * was > old_squared * longest * longest;
                }
            });
            if !good {
                return false;
            }
        }
        true
    }
}
