//! Tessellating patches into a mesh with welded borders.
//!
//! A border's points are evaluated from the border's own four control points, always in the same direction, so
//! that two patches with the same border get the same vertices without comparing distances. Control points
//! within a millionth of the surface's size of each other are merged first, since files round them. A border
//! whose control points are all the same is a single vertex: a pole.

use super::patch::{Patch, cubic};
use glam::Vec3;
use halfedge::attribute::Column;
use halfedge::geometry::{MergedPoints, merge_points};
use halfedge::{Mesh, Note, NumberRange, PolygonSoup, TooLarge, keys};
use std::collections::HashMap;

/// The resolutions of [`tessellate`], in quads along a patch's side.
pub const RESOLUTION_RANGE: NumberRange = NumberRange::counts(1, 256);

/// A tessellated surface.
#[derive(Debug)]
pub struct Tessellated {
    /// Quads, and triangles at poles, with the exact normal at each corner in
    /// [`keys::CORNER_NORMAL`].
    pub mesh: Mesh,
    /// What the build had to change, for example where surfaces touch at a point.
    pub notes: Vec<Note>,
}

/// Tessellates each patch into `resolution` x `resolution` quads and welds the borders that patches share. The
/// resolution is clamped to [`RESOLUTION_RANGE`]. Faces are oriented consistently; u x v points outward. Costs
/// O(patches * resolution^2).
///
/// # Errors
/// [`TooLarge`] if ids run out.
pub fn tessellate(patches: &[Patch], resolution: u32) -> Result<Tessellated, TooLarge> {
    let n = RESOLUTION_RANGE.nearest(resolution.into()) as u32;
    if patches.len().saturating_mul(4 * (n * n) as usize) > Mesh::MAX_EDGES {
        return Err(TooLarge { corners: patches.len().saturating_mul(4 * (n * n) as usize) });
    }
    let controls: Vec<Vec3> = patches.iter().flat_map(|patch| patch.rows.as_flattened()).copied().collect();
    let MergedPoints { kept, number } = merge_points(&controls, f64::from(weld_distance(patches)));
    let controls = kept.iter().map(|&i| controls[i as usize]).collect();
    let mut surface = Surface { n, controls, ..Surface::default() };
    for (patch, ids) in patches.iter().zip(number.as_chunks::<4>().0.as_chunks::<4>().0) {
        surface.add(patch, ids);
    }
    let built = Mesh::build(surface.soup())?;
    Ok(Tessellated { mesh: built.mesh, notes: built.notes })
}

#[derive(Default)]
struct Surface {
    n: u32,
    /// The control points, those that are close to each other once.
    controls: Vec<Vec3>,
    positions: Vec<Vec3>,
    /// The vertices of control points at corners and poles of patches.
    corners: HashMap<u32, u32>,
    /// The inner vertices of borders, by their control points in the canonical direction.
    borders: HashMap<[u32; 4], Vec<u32>>,
    faces: Vec<[u32; 4]>,
    normals: Vec<[Vec3; 4]>,
}

impl Surface {
    /// Adds a patch whose control points have these numbers.
    fn add(&mut self, patch: &Patch, ids: &[[u32; 4]; 4]) {
        let n = self.n as usize;
        let column = |i: usize| [ids[0][i], ids[1][i], ids[2][i], ids[3][i]];
        // The borders, each with n + 1 vertices along u or v.
        let bottom = self.border(ids[0]);
        let top = self.border(ids[3]);
        let left = self.border(column(0));
        let right = self.border(column(3));
        let mut grid = vec![0u32; (n + 1) * (n + 1)];
        let mut normals = vec![Vec3::ZERO; (n + 1) * (n + 1)];
        for j in 0..=n {
            for i in 0..=n {
                let at = patch.point(i as f32 / n as f32, j as f32 / n as f32);
                normals[j * (n + 1) + i] = at.normal;
                grid[j * (n + 1) + i] = match (i, j) {
                    (_, 0) => bottom[i],
                    (_, j) if j == n => top[i],
                    (0, _) => left[j],
                    (i, _) if i == n => right[j],
                    _ => self.vertex(at.position),
                };
            }
        }
        for j in 0..n {
            for i in 0..n {
                let quad = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| j * (n + 1) + i);
                self.faces.push(quad.map(|at| grid[at]));
                self.normals.push(quad.map(|at| normals[at]));
            }
        }
    }

    fn vertex(&mut self, position: Vec3) -> u32 {
        self.positions.push(position);
        self.positions.len() as u32 - 1
    }

    fn corner(&mut self, control: u32) -> u32 {
        if let Some(&v) = self.corners.get(&control) {
            return v;
        }
        let v = self.vertex(self.controls[control as usize]);
        self.corners.insert(control, v);
        v
    }

    /// The n + 1 vertices along a border.
    fn border(&mut self, ids: [u32; 4]) -> Vec<u32> {
        let n = self.n as usize;
        let (start, end) = (self.corner(ids[0]), self.corner(ids[3]));
        if ids.iter().all(|&id| id == ids[0]) {
            return vec![start; n + 1];
        }
        let backward = [ids[3], ids[2], ids[1], ids[0]];
        let key = ids.min(backward);
        let inner = match self.borders.get(&key) {
            Some(inner) => inner.clone(),
            None => {
                let p = key.map(|id| self.controls[id as usize]);
                let inner: Vec<u32> = (1..n).map(|i| self.vertex(cubic(p, i as f32 / n as f32).0)).collect();
                self.borders.insert(key, inner.clone());
                inner
            }
        };
        let mut all = vec![start];
        if key == ids {
            all.extend(&inner);
        } else {
            all.extend(inner.iter().rev());
        }
        all.push(end);
        all
    }

    fn soup(self) -> PolygonSoup {
        let mut soup = PolygonSoup { positions: self.positions, ..PolygonSoup::default() };
        let mut normals = Vec::new();
        for (face, face_normals) in self.faces.iter().zip(&self.normals) {
            // Quads with a side at a pole become triangles; with two such sides they vanish.
            let kept: Vec<usize> = (0..4).filter(|&i| face[i] != face[(i + 1) % 4]).collect();
            if kept.len() >= 3 {
                soup.push_face(kept.iter().map(|&i| face[i]));
                normals.extend(kept.iter().map(|&i| face_normals[i]));
            }
        }
        soup.corner_columns.push(Column::with_values(keys::CORNER_NORMAL, normals));
        soup
    }
}

/// The distance within which [`tessellate`] merges control points: a millionth of the longest side of their
/// bounding box.
pub fn weld_distance(patches: &[Patch]) -> f32 {
    let points = || patches.iter().flat_map(|patch| patch.rows.as_flattened());
    let low = points().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = points().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let distance = (1e-6 * (high.as_dvec3() - low.as_dvec3()).max_element()) as f32;
    if distance >= 0.0 { distance } else { 0.0 }
}
