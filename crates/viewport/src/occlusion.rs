//! Visibility of many points in a rectangle of the screen.
//!
//! A ray for each of a million points takes seconds. Here all faces are first drawn into a small
//! depth buffer, which decides about most points: far from any silhouette a point is either on the visible
//! surface or well behind it. Only the others need a ray.

use crate::projector::Projector;
use crate::region::ScreenRect;
use glam::{Vec2, Vec3};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{FaceId, Mesh};

/// The most cells along the longer side of the rectangle.
const MAX_CELLS_PER_SIDE: f32 = 1024.0;
/// The most cells that may be visited: with many large faces over each other rays are faster.
const MAX_CELLS_VISITED: usize = 60_000_000;
/// Neighbouring cells whose depths differ by more than this many cell widths show different surfaces.
const MAX_DEPTH_STEP_CELLS: f64 = 24.0;
/// The nearness of empty cells.
const EMPTY_CELL: f32 = f32::NEG_INFINITY;

/// A depth buffer that faces are being drawn into.
pub struct Drawing {
    buffer: Occlusion,
    /// How many more cells may be visited.
    left: usize,
}

/// The depth buffer of a rectangle.
pub struct Occlusion {
    origin: Vec2,
    /// Cells per pixel.
    scale: f32,
    width: usize,
    height: usize,
    /// The [`Projector::nearness`] of the nearest surface at each cell's centre.
    nearness: Vec<f32>,
}

impl Drawing {
    /// How far beyond the rectangle faces count, for points on its edge.
    pub const MARGIN_PX: f32 = 3.0;

    /// Begins a depth buffer. Costs O(cells).
    pub fn new(rect: ScreenRect) -> Self {
        let ScreenRect { min: origin, max } = rect.expand(Self::MARGIN_PX - 1.0);
        let size = max - origin;
        let scale = (MAX_CELLS_PER_SIDE / size.max_element()).min(1.0);
        let (width, height) = ((size.x * scale).ceil() as usize, (size.y * scale).ceil() as usize);
        let nearness = vec![EMPTY_CELL; width * height];
        Self { buffer: Occlusion { origin, scale, width, height, nearness }, left: MAX_CELLS_VISITED }
    }

    /// Draws more faces; none where the buffer is of no use, because a face reaches behind the eye or there is too
    /// much to draw. Costs O(faces + cells covered).
    pub fn draw_faces(mut self, mesh: &Mesh, view: &Projector, faces: &[FaceId]) -> Option<Self> {
        let mut triangulator = PolygonTriangulator::new();
        for &face in faces {
            for &corners in triangulator.triangulate_face(mesh, face) {
                let [Some(a), Some(b), Some(c)] =
                    corners.map(|h| self.buffer.place(view, mesh.position(mesh.from(h))))
                else {
                    return None;
                };
                self.left = self.left.checked_sub(self.buffer.draw([a, b, c]))?;
            }
        }
        Some(self)
    }

    /// The depth buffer, with all faces drawn.
    pub fn finish(self) -> Occlusion {
        self.buffer
    }
}

impl Occlusion {
    /// A point's place in cells and its nearness; none behind the eye.
    fn place(&self, view: &Projector, point: Vec3) -> Option<Vec3> {
        view.project(point).map(|(pixel, depth)| self.cell_of(pixel).extend(view.nearness(depth)))
    }

    fn cell_of(&self, pixel: Vec2) -> Vec2 {
        (pixel - self.origin) * self.scale
    }

    /// Draws a triangle given in cells and nearness; returns the number of cells visited.
    fn draw(&mut self, [a, b, c]: [Vec3; 3]) -> usize {
        // Cells whose centre is in the triangle's bounding box.
        let low = (a.min(b).min(c).truncate() - 0.5).ceil().max(Vec2::ZERO);
        let most = Vec2::new(self.width as f32 - 1.0, self.height as f32 - 1.0);
        let high = (a.max(b).max(c).truncate() - 0.5).floor().min(most);
        if low.x > high.x || low.y > high.y {
            return 1;
        }
        let (ab, ac) = ((b - a).truncate(), (c - a).truncate());
        let area = ab.perp_dot(ac);
        if area == 0.0 || !area.is_finite() {
            return 1;
        }
        let (columns, rows) = (low.x as usize..=high.x as usize, low.y as usize..=high.y as usize);
        for y in rows.clone() {
            let row = self.nearness.get_mut(y * self.width..(y + 1) * self.width).unwrap_or_default();
            for x in columns.clone() {
                let from_a = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) - a.truncate();
                let (v, w) = (from_a.perp_dot(ac) / area, ab.perp_dot(from_a) / area);
                if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
                    let here = a.z + (b.z - a.z) * v + (c.z - a.z) * w;
                    if let Some(cell) = row.get_mut(x)
                        && *cell < here
                    {
                        *cell = here;
                    }
                }
            }
        }
        columns.count() * rows.count()
    }

    /// Whether a point is visible; none where the buffer can't tell, near silhouettes and empty cells.
    pub fn sees(&self, view: &Projector, point: Vec3) -> Option<bool> {
        let (pixel, depth) = view.project(point)?;
        let cell = self.cell_of(pixel);
        let (x, y) = (cell.x as usize, cell.y as usize);
        if cell.x < 1.0 || cell.y < 1.0 || x + 1 >= self.width || y + 1 >= self.height {
            return None;
        }
        let (mut nearest, mut farthest) = (f32::NEG_INFINITY, f32::INFINITY);
        for row in y - 1..=y + 1 {
            for &cell in self.nearness.get(row * self.width + x - 1..row * self.width + x + 2)? {
                nearest = nearest.max(cell);
                farthest = farthest.min(cell);
            }
        }
        if farthest == EMPTY_CELL {
            return None;
        }
        let gap = MAX_DEPTH_STEP_CELLS * view.units_per_pixel(depth) / f64::from(self.scale);
        let [front, back] = [nearest, farthest].map(|n| view.depth_of(n));
        if depth - back > gap {
            // Well behind everything around it.
            return Some(false);
        }
        (back - front < gap && depth <= back).then_some(true)
    }
}
