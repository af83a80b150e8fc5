//! Isotropic remeshing: triangles with sides of one length.
//!
//! Botsch and Kobbelt: A remeshing approach to multiresolution modeling (2004). Each iteration splits
//! edges longer than 4/3 of the length, collapses those shorter than 4/5, flips edges towards valence 6
//! (4 on the boundary), moves vertices along the surface to the middle of their triangles, and puts them
//! back on the input. Boundaries, edges sharper than the feature angle, seams of corner attributes,
//! creases and borders between materials, groups and colours are kept: their vertices only slide along
//! them by being split off and merged, and where such curves meet they stay.

use crate::pace::Pace;
use crate::trimesh::{TriMesh, next, prev};
use crate::{FaceTree, SurfaceError};
use glam::DVec3;
use halfedge::{FaceId, Mesh, NONE, Progress, keys};

/// How to remesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remesh {
    /// The length of edges, in mesh units; none for the mean of the input's.
    pub edge_length: Option<f64>,
    /// How many rounds.
    pub iterations: u32,
    /// Edges whose faces' normals differ by more than this are kept, in degrees.
    pub feature_angle: f64,
    /// Whether vertices are put back on the input each round.
    pub project: bool,
}

impl Default for Remesh {
    fn default() -> Self {
        Self { edge_length: None, iterations: 5, feature_angle: 45.0, project: true }
    }
}

/// The most triangles that remeshing may make.
const MAX_TRIANGLES: u64 = 8_000_000;
/// How far a triangle's normal may turn in a collapse or flip: acos of this.
const LEAST_COS: f64 = 0.5;

/// Remeshes a surface; the input is untouched. Polygons are cut into triangles first, isolated vertices
/// left out. Triangles have the face attributes of the one they were cut from; corner, vertex and edge
/// attributes are mixed where edges are split and merged. Costs O(iterations x (mesh + result)).
///
/// # Errors
/// [`SurfaceError::BadField`]; [`SurfaceError::TooManyFaces`] beforehand, for an edge length so short;
/// [`SurfaceError::Cancelled`].
pub fn remesh(mesh: &Mesh, options: &Remesh, progress: &mut Progress<'_>) -> Result<Mesh, SurfaceError> {
    let length = options.edge_length.unwrap_or_else(|| crate::measure::mean_edge_length(mesh));
    if !(options.feature_angle > 0.0 && options.feature_angle <= 180.0) {
        return Err(SurfaceError::field("feature_angle", "above 0 and at most 180 degrees"));
    }
    let mut pace = Pace::new(progress);
    pace.at(0.0)?;
    if mesh.face_count() == 0 {
        return Ok(Mesh::new());
    }
    if !(length > 0.0 && length.is_finite()) {
        return Err(SurfaceError::field("edge_length", "a finite number above 0"));
    }
    // An equilateral triangle has sqrt(3)/4 of its side's square.
    let expected = crate::measure::surface_area(mesh) / (length * length * 0.433);
    if expected > MAX_TRIANGLES as f64 {
        return Err(SurfaceError::TooManyFaces { faces: expected as u64, limit: MAX_TRIANGLES });
    }
    let tri = TriMesh::new(mesh);
    let mut work = Work::new(mesh, tri, length, options);
    pace.at(0.05)?;
    for iteration in 0..options.iterations {
        let share = |i: u32| 0.05 + 0.9 * i as f32 / options.iterations as f32;
        let mut part = pace.part(share(iteration), share(iteration + 1));
        work.split_long(&mut part.part(0.0, 0.15))?;
        work.collapse_short(&mut part.part(0.15, 0.35))?;
        work.flip_to_valence(&mut part.part(0.35, 0.55))?;
        work.relax(&mut part.part(0.55, 1.0))?;
    }
    let result = work.tri.to_mesh(mesh);
    pace.at(1.0)?;
    Ok(result)
}

struct Work<'a> {
    source: &'a Mesh,
    tri: TriMesh,
    /// Per half-edge: whether its edge is kept. Boundary edges always are.
    feature: Vec<bool>,
    /// Per vertex: how many kept edges it has.
    features: Vec<u8>,
    /// Per vertex: the face of the input it was last closest to.
    near: Vec<Option<FaceId>>,
    tree: Option<FaceTree>,
    stamps: Vec<u32>,
    stamp: u32,
    /// Squares of the longest and the shortest edge to leave alone, in the frame.
    longest: f64,
    shortest: f64,
}

impl<'a> Work<'a> {
    fn new(mesh: &'a Mesh, tri: TriMesh, length: f64, options: &Remesh) -> Self {
        let length = length / tri.frame.scale;
        let mut work = Self {
            source: mesh,
            feature: vec![false; tri.v.len()],
            features: vec![0; tri.out.len()],
            near: vec![None; tri.out.len()],
            tree: options.project.then(|| FaceTree::new(mesh)),
            stamps: vec![0; tri.out.len()],
            stamp: 0,
            longest: (length * 4.0 / 3.0).powi(2),
            shortest: (length * 4.0 / 5.0).powi(2),
            tri,
        };
        let (_, least_cos) = crate::trig::sin_cos_turns(options.feature_angle / 360.0);
        work.find_features(least_cos);
        for h in 0..work.tri.v.len() {
            let v = work.tri.v[h] as usize;
            work.near[v] = mesh.face(work.tri.face_source[h / 3]);
        }
        work
    }

    fn find_features(&mut self, least_cos: f64) {
        let tri = &self.tri;
        let material = self.source.attribute(keys::FACE_MATERIAL);
        let group = self.source.attribute(keys::FACE_GROUP);
        let color = self.source.attribute(keys::FACE_COLOR);
        let crease = self.source.attribute(keys::EDGE_CREASE);
        for h in 0..tri.v.len() as u32 {
            let across = tri.opp(h);
            let kept = across == NONE || tri.is_seam(h) || {
                let [a, b] = [h, across].map(|h| tri.face_source[h as usize / 3] as usize);
                let sharp = || {
                    let (n, m) = (self.area(h), self.area(across));
                    n.dot(m) < least_cos * n.length() * m.length()
                };
                let creased = || {
                    crease.zip(tri.edge_source.get(h as usize)).is_some_and(|(crease, &e)| {
                        crease.get(e as usize).is_some_and(|&sharpness| sharpness > 0.0)
                    })
                };
                material.is_some_and(|m| m[a] != m[b])
                    || group.is_some_and(|g| g[a] != g[b])
                    || color.is_some_and(|c| c[a] != c[b])
                    || (a != b && sharp())
                    || creased()
            };
            self.feature[h as usize] = kept;
            if kept && (across == NONE || h < across) {
                for v in [tri.from(h), tri.to(h)] {
                    let count = &mut self.features[v as usize];
                    *count = count.saturating_add(1);
                }
            }
        }
        // A curve that turns by more than the feature angle has a corner there.
        for v in 0..tri.out.len() as u32 {
            if self.features[v as usize] != 2 {
                continue;
            }
            let here = tri.at(v);
            let mut directions = [DVec3::ZERO; 2];
            let mut put = |w: u32| directions = [directions[1], (tri.at(w) - here).normalize_or_zero()];
            tri.around(v, |out| {
                if self.feature[out as usize] {
                    put(tri.to(out));
                }
                if tri.turn(out) == NONE {
                    put(tri.apex(out));
                }
            });
            if -directions[0].dot(directions[1]) < least_cos {
                self.features[v as usize] = 3;
            }
        }
    }

    /// Twice the area vector of a half-edge's triangle.
    fn area(&self, h: u32) -> DVec3 {
        let [a, b, c] = [self.tri.from(h), self.tri.to(h), self.tri.apex(h)].map(|v| self.tri.at(v));
        (b - a).cross(c - a)
    }

    fn length_squared(&self, h: u32) -> f64 {
        self.tri.at(self.tri.from(h)).distance_squared(self.tri.at(self.tri.to(h)))
    }

    /// Whether a vertex is where features end, meet or turn into each other.
    fn is_fixed(&self, v: u32) -> bool {
        !matches!(self.features[v as usize], 0 | 2)
    }

    /// Calls `edit` with each edge that exists when its turn comes, those made meanwhile included.
    fn each_edge(
        &mut self,
        pace: &mut Pace<'_, '_>,
        mut edit: impl FnMut(&mut Self, u32),
    ) -> Result<(), SurfaceError> {
        let mut h = 0;
        while h < self.tri.v.len() as u32 {
            if h % 65_536 == 0 {
                pace.at(h as f32 / self.tri.v.len() as f32)?;
            }
            if self.tri.is_alive(h) && self.tri.edge(h) == h {
                edit(self, h);
            }
            h += 1;
        }
        Ok(())
    }

    fn split_long(&mut self, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        self.each_edge(pace, |work, h| {
            while work.length_squared(h) > work.longest {
                let longest = work.longest_near(h);
                work.split(longest);
            }
        })
    }

    /// From an edge on to longer ones of its triangles, up to one that is the longest of both. Cutting
    /// that one first keeps triangles from becoming ever thinner (Rivara 1984).
    fn longest_near(&self, h: u32) -> u32 {
        let (mut best, mut length) = (h, self.length_squared(h));
        loop {
            let at = best;
            for side in [at, self.tri.opp(at)] {
                if side == NONE {
                    continue;
                }
                for other in [next(side), prev(side)] {
                    let squared = self.length_squared(other);
                    if squared > length {
                        (best, length) = (other, squared);
                    }
                }
            }
            if best == at {
                return best;
            }
        }
    }

    /// Cuts an edge in the middle. `h` becomes the half before the middle.
    fn split(&mut self, h: u32) {
        let across = self.tri.opp(h);
        let kept = self.feature[h as usize];
        self.tri.split(h);
        self.features.push(if kept { 2 } else { 0 });
        self.near.push(self.near[self.tri.from(h) as usize]);
        self.stamps.push(0);
        self.feature.resize(self.tri.v.len(), false);
        for side in [h, across] {
            if side != NONE {
                // The cut took the place of the side after, which went to the new triangle.
                let cut = next(side);
                let second = next(self.tri.opp(cut));
                self.feature[second as usize] = kept;
                self.feature[next(second) as usize] = self.feature[cut as usize];
                self.feature[cut as usize] = false;
            }
        }
    }

    fn collapse_short(&mut self, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        self.each_edge(pace, |work, h| {
            if work.length_squared(h) < work.shortest {
                work.collapse(h);
            }
        })
    }

    fn collapse(&mut self, h: u32) {
        let kept = self.feature[h as usize];
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let (on_a, on_b) = (self.features[a as usize] > 0, self.features[b as usize] > 0);
        let (fixed_a, fixed_b) = (self.is_fixed(a), self.is_fixed(b));
        // Which end stays: what is on a feature may only move along it.
        let (h, at) = match (on_a, on_b) {
            (true, true) if !kept || (fixed_a && fixed_b) => return,
            (true, true) if fixed_b => (h, self.tri.at(b)),
            (true, _) => (h, self.tri.at(a)),
            (false, true) => (self.tri.opp(h), self.tri.at(b)),
            (false, false) => (h, (self.tri.at(a) + self.tri.at(b)) * 0.5),
        };
        self.stamp += 1;
        if !self.tri.can_collapse(h, &mut self.stamps, self.stamp) || !self.allows(h, at) {
            return;
        }
        let (a, across) = (self.tri.from(h), self.tri.opp(h));
        let p = self.tri.at(a);
        let q = self.tri.at(self.tri.to(h));
        for side in [h, across] {
            if side != NONE {
                let (left, right) = (self.tri.opp(next(side)), self.tri.opp(prev(side)));
                let kept = [next(side), prev(side)].iter().any(|&k| self.feature[k as usize]);
                for outer in [left, right] {
                    if outer != NONE {
                        self.feature[outer as usize] = kept;
                    }
                }
            }
        }
        let t = if at == p { 0.0 } else { (at - p).length() / (q - p).length() };
        if fixed_b && on_a {
            self.features[a as usize] = self.features[b as usize];
        }
        self.tri.collapse(h, t);
        self.tri.position[a as usize] = at;
    }

    /// Whether merging an edge's ends at a point makes no edge too long and turns no triangle too far.
    fn allows(&self, h: u32, at: DVec3) -> bool {
        let tri = &self.tri;
        let (a, b) = (tri.from(h), tri.to(h));
        let mut good = true;
        for (v, other) in [(a, b), (b, a)] {
            tri.neighbors(v, |w| {
                good &= w == other || tri.at(w).distance_squared(at) <= self.longest;
            });
            tri.around(v, |out| {
                let (x, y) = (tri.to(out), tri.apex(out));
                if x == other || y == other || !good {
                    return;
                }
                let (x, y) = (tri.at(x), tri.at(y));
                let old = (x - tri.at(v)).cross(y - tri.at(v));
                let new = (x - at).cross(y - at);
                good = new.dot(old) > LEAST_COS * new.length() * old.length()
                    || (old == DVec3::ZERO && new != DVec3::ZERO);
            });
        }
        // A kept edge beside the merged one must not land on another one.
        for side in [h, tri.opp(h)] {
            if side != NONE {
                good &= !(self.feature[next(side) as usize] && self.feature[prev(side) as usize]);
            }
        }
        good
    }

    fn flip_to_valence(&mut self, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        let mut valence = vec![0i32; self.tri.out.len()];
        for h in 0..self.tri.v.len() as u32 {
            if self.tri.is_alive(h) {
                valence[self.tri.from(h) as usize] += 1;
                if self.tri.opp(h) == NONE {
                    valence[self.tri.to(h) as usize] += 1;
                }
            }
        }
        // How far from its best valence; half a disc of faces has 4 edges.
        let best = |work: &Self, v: u32| if work.tri.is_boundary_vertex(v) { 4 } else { 6 };
        self.each_edge(pace, |work, h| {
            let across = work.tri.opp(h);
            if work.feature[h as usize] || across == NONE {
                return;
            }
            let ends = [work.tri.from(h), work.tri.to(h)];
            let apexes = [work.tri.apex(h), work.tri.apex(across)];
            let off = |v: u32, by: i32| (valence[v as usize] + by - best(work, v)).pow(2);
            let before: i32 = ends.iter().chain(&apexes).map(|&v| off(v, 0)).sum();
            let after: i32 = ends.iter().map(|&v| off(v, -1)).sum::<i32>()
                + apexes.iter().map(|&v| off(v, 1)).sum::<i32>();
            if after >= before || !work.can_flip(h) {
                return;
            }
            for v in ends {
                valence[v as usize] -= 1;
            }
            for v in apexes {
                valence[v as usize] += 1;
            }
            let [n, p] = [next(h), prev(h)];
            let [m, q] = [next(across), prev(across)];
            let sides = [n, p, m, q].map(|k| work.feature[k as usize]);
            work.tri.flip(h);
            // `TriMesh::flip`: h's triangle has the sides p and m after it, the other q and n.
            for (k, kept) in
                [(next(h), sides[1]), (prev(h), sides[2]), (next(across), sides[3]), (prev(across), sides[0])]
            {
                work.feature[k as usize] = kept;
            }
        })
    }

    fn can_flip(&mut self, h: u32) -> bool {
        let across = self.tri.opp(h);
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let (c, d) = (self.tri.apex(h), self.tri.apex(across));
        let mut joined = false;
        self.tri.neighbors(c, |w| joined |= w == d);
        if joined {
            return false;
        }
        let [a, b, c, d] = [a, b, c, d].map(|v| self.tri.at(v));
        let normal = (b - a).cross(c - a) + (d - a).cross(b - a);
        let faces = |t: DVec3| t.dot(normal) > LEAST_COS * t.length() * normal.length();
        faces((a - c).cross(d - c)) && faces((d - c).cross(b - c))
    }

    /// Moves vertices along the surface to the weighted middle of their triangles, and onto the input.
    fn relax(&mut self, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        let tri = &self.tri;
        let mut moved = tri.position.clone();
        for (v, to) in (0u32..).zip(&mut moved) {
            if tri.out[v as usize] == NONE || self.features[v as usize] > 0 {
                continue;
            }
            let here = tri.at(v);
            let (mut normal, mut sum, mut weights) = (DVec3::ZERO, DVec3::ZERO, 0.0);
            tri.around(v, |out| {
                let (x, y) = (tri.at(tri.to(out)), tri.at(tri.apex(out)));
                let area = (x - here).cross(y - here);
                let weight = area.length();
                normal += area;
                sum += (here + x + y) * weight;
                weights += weight;
            });
            let Some(normal) = normal.try_normalize() else { continue };
            if weights > 0.0 {
                let by = sum / (3.0 * weights) - here;
                *to = here + by - normal * by.dot(normal);
            }
        }
        let count = moved.len();
        let (frame, source, tree, near) = (self.tri.frame, self.source, &self.tree, &mut self.near);
        let (out, features) = (&self.tri.out, &self.features);
        pace.chunks(count, |range| {
            for v in range {
                if out[v] == NONE || features[v] > 0 {
                    continue;
                }
                if let Some(tree) = tree
                    && let Some(hit) = tree.closest_point_near(source, frame.outward(moved[v]), near[v])
                {
                    near[v] = Some(hit.face);
                    moved[v] = frame.inward(hit.point);
                }
            }
        })?;
        // A vertex whose move would turn a triangle over stays this time.
        for v in 0..count as u32 {
            if moved[v as usize] == self.tri.at(v) || self.tri.out[v as usize] == NONE {
                continue;
            }
            let (tri, here, there) = (&self.tri, self.tri.at(v), moved[v as usize]);
            let mut good = true;
            tri.around(v, |out| {
                let (x, y) = (tri.at(tri.to(out)), tri.at(tri.apex(out)));
                let (old, new) = ((x - here).cross(y - here), (x - there).cross(y - there));
                good &= new.dot(old) > 0.0 || old == DVec3::ZERO;
            });
            if good {
                self.tri.position[v as usize] = there;
            }
        }
        Ok(())
    }
}
