//! Regions of the screen: what a box, a lasso or a brush covers.

use glam::Vec2;

/// The height of a lasso's bands, in the unit of the viewport: each lists the sides that reach into it.
const BAND_HEIGHT_POINTS: f32 = 4.0;
/// The most bands of a lasso.
const MAX_BANDS: usize = 4096;

/// A rectangle of the viewport, edges included, in the unit of its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenRect {
    /// The top left corner.
    pub min: Vec2,
    /// The bottom right corner.
    pub max: Vec2,
}

/// A connected region of the viewport, in the unit of its size.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    bounds: ScreenRect,
    shape: Shape,
}

#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Rect,
    Lasso(Lasso),
    Brush(Brush),
}

/// A closed polygon. Inside is what it goes around at least once.
#[derive(Clone, Debug, PartialEq)]
struct Lasso {
    points: Vec<Vec2>,
    /// The height of a band.
    band: f32,
    /// The sides that reach into each band, from the top down.
    bands: Vec<Vec<u32>>,
}

/// What a disc covers on its way from one place to another.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Brush {
    from: Vec2,
    to: Vec2,
    radius: f32,
}

/// The part of a segment that is inside something, as fractions of its length.
type Part = [f32; 2];

impl ScreenRect {
    /// The rectangle with these two points as opposite corners, in either order.
    pub fn between(a: Vec2, b: Vec2) -> Self {
        Self { min: a.min(b), max: a.max(b) }
    }

    /// The smallest rectangle around some points; inside out without any.
    pub(crate) fn around(points: impl IntoIterator<Item = Vec2>) -> Self {
        let empty = Self { min: Vec2::INFINITY, max: Vec2::NEG_INFINITY };
        points.into_iter().fold(empty, |all, p| Self { min: all.min.min(p), max: all.max.max(p) })
    }

    /// The rectangle with a margin on each side.
    pub(crate) fn expand(&self, by: f32) -> Self {
        Self { min: self.min - by, max: self.max + by }
    }

    pub(crate) fn contains(&self, p: Vec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// The part of a segment inside (Liang and Barsky 1984).
    fn clip(&self, [a, b]: [Vec2; 2]) -> Option<Part> {
        let along = b - a;
        let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
        for axis in 0..2 {
            let (start, step) = (a[axis], along[axis]);
            if step == 0.0 {
                if start < self.min[axis] || start > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (t0, t1) = ((self.min[axis] - start) / step, (self.max[axis] - start) / step);
            enter = enter.max(t0.min(t1));
            leave = leave.min(t0.max(t1));
        }
        (enter <= leave).then_some([enter, leave])
    }
}

impl Region {
    /// A rectangle.
    pub fn rect(rect: ScreenRect) -> Self {
        Self { bounds: rect, shape: Shape::Rect }
    }

    /// What a closed line through these points goes around; where it crosses itself, all loops count. Costs O(points
    /// + bands that its sides cross).
    pub fn lasso(points: Vec<Vec2>) -> Self {
        let bounds = ScreenRect::around(points.iter().copied());
        Self { bounds, shape: Shape::Lasso(Lasso::new(points, bounds)) }
    }

    /// What a disc covers on its way from one place to another.
    pub fn brush(from: Vec2, to: Vec2, radius: f32) -> Self {
        let bounds = ScreenRect::between(from, to).expand(radius);
        Self { bounds, shape: Shape::Brush(Brush { from, to, radius }) }
    }

    /// The smallest rectangle around it.
    pub fn bounds(&self) -> ScreenRect {
        self.bounds
    }

    /// Whether a point is inside.
    pub fn contains(&self, p: Vec2) -> bool {
        self.bounds.contains(p)
            && match &self.shape {
                Shape::Rect => true,
                Shape::Lasso(lasso) => lasso.contains(p, self.bounds.min.y),
                Shape::Brush(brush) => brush.contains(p),
            }
    }

    /// The parts of a segment inside, in order, as fractions of its length.
    pub fn clip(&self, segment: [Vec2; 2]) -> Vec<[f32; 2]> {
        let Some(within) = self.bounds.clip(segment) else { return Vec::new() };
        match &self.shape {
            Shape::Rect => vec![within],
            Shape::Lasso(lasso) => lasso.clip(segment, within, self.bounds.min.y),
            Shape::Brush(brush) => brush.clip(segment).into_iter().collect(),
        }
    }

    /// Some point inside or on the edge.
    pub(crate) fn anchor(&self) -> Vec2 {
        match &self.shape {
            Shape::Rect => (self.bounds.min + self.bounds.max) * 0.5,
            Shape::Lasso(lasso) => lasso.points.first().copied().unwrap_or_default(),
            Shape::Brush(brush) => brush.from,
        }
    }
}

impl Lasso {
    fn new(points: Vec<Vec2>, bounds: ScreenRect) -> Self {
        let height = bounds.max.y - bounds.min.y;
        if !height.is_finite() || points.len() < 3 {
            return Self { points: Vec::new(), band: BAND_HEIGHT_POINTS, bands: Vec::new() };
        }
        let count = ((height / BAND_HEIGHT_POINTS).ceil() as usize).clamp(1, MAX_BANDS);
        let mut lasso =
            Self { points, band: (height / count as f32).max(1e-6), bands: vec![Vec::new(); count] };
        for side in 0..lasso.points.len() as u32 {
            let [a, b] = lasso.side(side);
            let rows = lasso.rows(a.y.min(b.y), a.y.max(b.y), bounds.min.y);
            for band in lasso.bands.get_mut(rows).unwrap_or_default() {
                band.push(side);
            }
        }
        lasso
    }

    /// The side that begins at a point.
    fn side(&self, at: u32) -> [Vec2; 2] {
        let at = at as usize;
        let point = |i: usize| self.points.get(i % self.points.len().max(1)).copied().unwrap_or_default();
        [point(at), point(at + 1)]
    }

    /// The bands between two heights; `top` is where the first one begins.
    fn rows(&self, low: f32, high: f32, top: f32) -> std::ops::Range<usize> {
        let last = self.bands.len().saturating_sub(1);
        let row = |y: f32| (((y - top) / self.band).max(0.0) as usize).min(last);
        row(low)..(row(high) + 1).min(self.bands.len())
    }

    fn sides_between(&self, low: f32, high: f32, top: f32) -> impl Iterator<Item = [Vec2; 2]> {
        let bands = self.bands.get(self.rows(low, high, top)).unwrap_or_default();
        bands.iter().flatten().map(|&side| self.side(side))
    }

    /// How often the polygon goes around a point isn't zero: the sides that cross the line to its right, down less up.
    fn contains(&self, p: Vec2, top: f32) -> bool {
        let turns: i32 = self
            .sides_between(p.y, p.y, top)
            .map(|[a, b]| {
                let is_left = (b - a).perp_dot(p - a);
                match (a.y <= p.y, b.y <= p.y) {
                    (true, false) if is_left > 0.0 => 1,
                    (false, true) if is_left < 0.0 => -1,
                    _ => 0,
                }
            })
            .sum();
        turns != 0
    }

    fn clip(&self, [a, b]: [Vec2; 2], [enter, leave]: Part, top: f32) -> Vec<Part> {
        let along = b - a;
        let at = |t: f32| a + along * t;
        let mut cuts = vec![enter, leave];
        let heights = [at(enter).y, at(leave).y];
        for [p, q] in self.sides_between(heights[0].min(heights[1]), heights[0].max(heights[1]), top) {
            let side = q - p;
            let across = along.perp_dot(side);
            if across != 0.0 {
                let (t, s) = ((p - a).perp_dot(side) / across, (p - a).perp_dot(along) / across);
                if (0.0..=1.0).contains(&s) && t > enter && t < leave {
                    cuts.push(t);
                }
            }
        }
        cuts.sort_by(f32::total_cmp);
        let mut parts: Vec<Part> = Vec::new();
        for pair in cuts.windows(2) {
            let &[from, to] = pair else { continue };
            if !self.contains(at((from + to) * 0.5), top) {
                continue;
            }
            match parts.last_mut() {
                Some(last) if last[1] == from => last[1] = to,
                _ => parts.push([from, to]),
            }
        }
        parts
    }
}

impl Brush {
    fn contains(&self, p: Vec2) -> bool {
        let along = self.to - self.from;
        let t = ((p - self.from).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
        p.distance_squared(self.from + along * t) <= self.radius * self.radius
    }

    /// The shape is convex: the part is from where a disc at an end or the rectangle between them is entered first to
    /// where one is left last.
    fn clip(&self, segment: [Vec2; 2]) -> Option<Part> {
        let along = self.to - self.from;
        let way = along.try_normalize().unwrap_or(Vec2::X);
        let turned = |p: Vec2| Vec2::new((p - self.from).dot(way), way.perp_dot(p - self.from));
        let between =
            ScreenRect { min: Vec2::new(0.0, -self.radius), max: Vec2::new(along.length(), self.radius) };
        let discs = [self.from, self.to].map(|middle| clip_by_disc(segment, middle, self.radius));
        let parts = discs.into_iter().chain([between.clip(segment.map(turned))]).flatten();
        parts.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }
}

/// The part of a segment inside a disc.
fn clip_by_disc([a, b]: [Vec2; 2], middle: Vec2, radius: f32) -> Option<Part> {
    let (along, start) = (b - a, a - middle);
    let (square, half, rest) =
        (along.length_squared(), along.dot(start), start.length_squared() - radius * radius);
    if square == 0.0 {
        return (rest <= 0.0).then_some([0.0, 1.0]);
    }
    let root = (half * half - square * rest).max(0.0).sqrt();
    if half * half < square * rest {
        return None;
    }
    let [enter, leave] = [(-half - root) / square, (-half + root) / square];
    (leave >= 0.0 && enter <= 1.0).then(|| [enter.max(0.0), leave.min(1.0)])
}
