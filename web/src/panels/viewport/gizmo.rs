//! The gizmo: handles at the selection that move, rotate and scale it, and the marks of an edit in progress.

use editor::OpId;
use egui::{Color32, Pos2, Rect, Shape, Stroke, Ui, Vec2, vec2};
use glam::{Mat3, Vec3};

use crate::live::edit::Live;
use crate::live::edit::Start;
use crate::live::lock::{Lock, axes_of};
use crate::page_view::Page;
use crate::theme;
use crate::transforming::Gizmo;
use crate::view::Gesture;

/// The length of an arrow on the screen.
const ARROW_POINTS: f32 = 84.0;
/// Where the arrows begin, so that the middle stays free.
const ARROW_START_SHARE: f32 = 0.22;
/// The corners of the squares that move in a plane, as parts of an arrow.
const SQUARE: [f32; 2] = [0.32, 0.52];
/// The radii of the rings about the axes and of the one about the direction of view, as parts of an arrow.
const RING_RADIUS_ARROWS: f32 = 0.9;
const VIEW_RING_RADIUS_ARROWS: f32 = 1.15;
const RING_SEGMENTS: usize = 64;
/// The radius of the disc in the middle.
const MIDDLE_POINTS: f32 = 7.0;
/// An arrow that points at the viewer, and a square seen from its edge, can't be dragged.
const MIN_VISIBLE_PART: f32 = 0.15;

/// A part of the gizmo, and the edit that dragging it starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Handle {
    gizmo: Gizmo,
    lock: Lock,
}

/// A handle's shape on the screen.
enum Outline {
    Disc(Pos2),
    Arrow([Pos2; 2]),
    Square(Vec<Pos2>),
    Ring(Vec<Pos2>),
}

impl Handle {
    /// The edit that a drag of the handle starts.
    pub fn start(self, from: Pos2) -> Start {
        let field = match self.gizmo {
            Gizmo::Rotate => "rotate",
            Gizmo::Scale => "scale",
            Gizmo::Off | Gizmo::Move => "translate",
        };
        Start { lock: self.lock, from: Some(from), ..Start::new(OpId::Transform, field) }
    }
}

/// The handle at a place on the page, within a radius in points.
pub(super) fn handle_at(page: &Page<'_>, at: Pos2, radius: f32) -> Option<Handle> {
    nearest(&handles(page), at, radius)
}

fn nearest(handles: &[(Handle, Outline)], at: Pos2, radius: f32) -> Option<Handle> {
    let away = handles.iter().map(|(handle, outline)| (outline.distance(at), *handle));
    let near = away.filter(|(away, _)| *away <= radius);
    near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, handle)| handle)
}

/// Draws the gizmo, or the marks of the edit in progress.
pub(super) fn paint(ui: &Ui, rect: Rect, page: &Page<'_>) {
    let painter = ui.painter().with_clip_rect(rect);
    let colors = theme::palette(ui.visuals()).axes;
    if let Some(live) = &page.live {
        paint_lock(page, &painter, colors);
        paint_rails(page, live, &painter, ui.visuals().hyperlink_color);
        if live.id == OpId::Transform && page.live_settings.soft {
            paint_soft_radius(page, &painter, ui.visuals().strong_text_color());
        }
        return;
    }
    if page.view.gesture == Gesture::SoftRadius {
        return paint_soft_radius(page, &painter, ui.visuals().strong_text_color());
    }
    let pointer =
        ui.input(|input| input.pointer.hover_pos()).filter(|_| !ui.input(|input| input.pointer.any_down()));
    let handles = handles(page);
    let hovered =
        pointer.filter(|at| rect.contains(*at)).and_then(|at| nearest(&handles, at, page.view.pick_radius));
    for (handle, outline) in handles {
        let color = match handle.lock {
            Lock::Free => ui.visuals().strong_text_color(),
            Lock::Along(axis, _) | Lock::Across(axis, _) => {
                colors.get(axis).copied().unwrap_or(ui.visuals().strong_text_color())
            }
        };
        let is_hovered = hovered == Some(handle);
        let color = if is_hovered { ui.visuals().warn_fg_color } else { color };
        outline.paint(&painter, handle.gizmo, color, if is_hovered { 3.5 } else { 2.5 });
    }
    if hovered.is_some() {
        ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
    }
}

/// The gizmo's handles, in the order in which they are drawn.
fn handles(page: &Page<'_>) -> Vec<(Handle, Outline)> {
    let gizmo = page.live_settings.gizmo;
    let (Some(place), Some(frame)) = (page.place, Frame::new(page)) else { return Vec::new() };
    let orientation = page.live_settings.orientation;
    let axes = axes_of(orientation, place.normal, &page.view.camera);
    let handle = |lock| Handle { gizmo, lock };
    let mut all = Vec::new();
    match gizmo {
        Gizmo::Off => {}
        Gizmo::Rotate => {
            all.push((handle(Lock::Free), Outline::Ring(frame.view_ring())));
            for axis in 0..3 {
                all.push((handle(Lock::Along(axis, orientation)), Outline::Ring(frame.ring(axes.col(axis)))));
            }
        }
        Gizmo::Move | Gizmo::Scale => {
            for axis in 0..3 {
                if let Some(square) = frame.square(axes, axis) {
                    all.push((handle(Lock::Across(axis, orientation)), Outline::Square(square)));
                }
                if let Some(arrow) = frame.arrow(axes.col(axis)) {
                    all.push((handle(Lock::Along(axis, orientation)), Outline::Arrow(arrow)));
                }
            }
            all.push((handle(Lock::Free), Outline::Disc(frame.middle)));
        }
    }
    all
}

/// Where the gizmo is, and its scale.
struct Frame<'a> {
    page: &'a Page<'a>,
    anchor: Vec3,
    middle: Pos2,
    /// The length of an arrow in mesh units.
    length: f32,
    towards_viewer: Vec3,
}

impl<'a> Frame<'a> {
    fn new(page: &'a Page<'a>) -> Option<Self> {
        let cursor = page.view.cursor.in_scene(&page.editor);
        let anchor = page.place?.pivot(page.live_settings.pivot, cursor);
        let middle = page.view.project(anchor)?;
        let aside = page.view.camera.drag(anchor, glam::Vec2::X * ARROW_POINTS, page.view.size());
        let length = (aside - anchor).length();
        let [_, _, forward] = page.view.camera.axes();
        let seen = length.is_finite() && length > 0.0;
        seen.then(|| Self { page, anchor, middle, length, towards_viewer: -forward.as_vec3() })
    }

    fn at(&self, offset: Vec3) -> Option<Pos2> {
        self.page.view.project(self.anchor + offset * self.length)
    }

    fn arrow(&self, axis: Vec3) -> Option<[Pos2; 2]> {
        let arrow = [self.at(axis * ARROW_START_SHARE)?, self.at(axis)?];
        (arrow[0].distance(arrow[1]) > MIN_VISIBLE_PART * ARROW_POINTS).then_some(arrow)
    }

    fn square(&self, axes: Mat3, across: usize) -> Option<Vec<Pos2>> {
        if axes.col(across).dot(self.towards_viewer).abs() < MIN_VISIBLE_PART {
            return None;
        }
        let (u, v) = (axes.col((across + 1) % 3), axes.col((across + 2) % 3));
        let [near, far] = SQUARE;
        [(near, near), (far, near), (far, far), (near, far)]
            .iter()
            .map(|(a, b)| self.at(u * *a + v * *b))
            .collect()
    }

    /// The half of the ring about an axis that is in front; of an axis towards the viewer, all of it.
    fn ring(&self, axis: Vec3) -> Vec<Pos2> {
        let u = axis.any_orthonormal_vector();
        let v = axis.cross(u);
        let seen_from_above = axis.dot(self.towards_viewer).abs() > 0.98;
        // The front half is contiguous when it begins where the ring goes behind the middle.
        let start = -u.dot(self.towards_viewer).atan2(v.dot(self.towards_viewer));
        let sweep = if seen_from_above { std::f32::consts::TAU } else { std::f32::consts::PI };
        (0..=RING_SEGMENTS)
            .filter_map(|step| {
                let angle = start + sweep * step as f32 / RING_SEGMENTS as f32;
                self.at((u * angle.cos() + v * angle.sin()) * RING_RADIUS_ARROWS)
            })
            .collect()
    }

    fn view_ring(&self) -> Vec<Pos2> {
        let angle = |step: usize| step as f32 * std::f32::consts::TAU / RING_SEGMENTS as f32;
        (0..=RING_SEGMENTS)
            .map(|step| self.middle + Vec2::angled(angle(step)) * (ARROW_POINTS * VIEW_RING_RADIUS_ARROWS))
            .collect()
    }
}

impl Outline {
    /// The distance of a place from the shape, in points. Shapes with an area are nearer inside.
    fn distance(&self, at: Pos2) -> f32 {
        match self {
            Self::Disc(middle) => (middle.distance(at) - MIDDLE_POINTS).max(-1.0),
            Self::Arrow([from, to]) => to_segment(at, *from, *to),
            Self::Ring(points) => to_line(points, at),
            Self::Square(corners) => {
                let inside = corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| {
                    let (edge, to) = (*b - *a, at - *a);
                    edge.x * to.y - edge.y * to.x
                });
                let sides: Vec<f32> = inside.collect();
                if sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0) {
                    return -0.5;
                }
                let closed: Vec<Pos2> = corners.iter().chain(corners.first()).copied().collect();
                to_line(&closed, at)
            }
        }
    }

    fn paint(&self, painter: &egui::Painter, gizmo: Gizmo, color: Color32, width: f32) {
        match self {
            Self::Disc(middle) => {
                painter.circle(
                    *middle,
                    MIDDLE_POINTS,
                    color.gamma_multiply(0.25),
                    Stroke::new(width * 0.7, color),
                );
            }
            Self::Ring(points) => drop(painter.add(Shape::line(points.clone(), Stroke::new(width, color)))),
            Self::Square(corners) => {
                let fill = color.gamma_multiply(0.3);
                painter.add(Shape::convex_polygon(corners.clone(), fill, Stroke::new(width * 0.5, color)));
            }
            Self::Arrow([from, to]) => {
                painter.line_segment([*from, *to], Stroke::new(width, color));
                let along = (*to - *from).normalized();
                let across = vec2(-along.y, along.x);
                let half = 2.0 + width;
                let head = if gizmo == Gizmo::Scale {
                    [-1.0, 1.0]
                        .iter()
                        .flat_map(|a| {
                            [*to + (along * *a + across * *a) * half, *to + (along * *a - across * *a) * half]
                        })
                        .collect()
                } else {
                    vec![*to + along * 13.0, *to + across * half, *to - across * half]
                };
                painter.add(Shape::convex_polygon(head, color, Stroke::NONE));
            }
        }
    }
}

fn to_line(points: &[Pos2], at: Pos2) -> f32 {
    points.windows(2).fold(f32::INFINITY, |best, pair| match pair {
        [a, b] => best.min(to_segment(at, *a, *b)),
        _ => best,
    })
}

fn to_segment(at: Pos2, from: Pos2, to: Pos2) -> f32 {
    let along = to - from;
    let t = ((at - from).dot(along) / along.length_sq().max(1e-6)).clamp(0.0, 1.0);
    (from + along * t).distance(at)
}

/// Draws the axes that the edit is limited to, through the whole picture.
fn paint_lock(page: &Page<'_>, painter: &egui::Painter, colors: [Color32; 3]) {
    let (Some(live), Some(frame)) = (&page.live, Frame::new(page)) else { return };
    if live.lock == Lock::Free {
        return;
    }
    let axes = live.axes(&page.live_settings);
    for &axis in live.lock.free_axes() {
        // Long, but short enough to stay in front of the eye.
        let reach = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];
        let end = |sign: f32| reach.iter().map_while(|far| frame.at(axes.col(axis) * *far * sign)).last();
        if let (Some(a), Some(b), Some(color)) = (end(-1.0), end(1.0), colors.get(axis)) {
            painter.line_segment([a, b], Stroke::new(1.0, color.gamma_multiply(0.8)));
        }
    }
}

/// Draws the lines along which vertices slide, with the ends that they can reach.
fn paint_rails(page: &Page<'_>, live: &Live, painter: &egui::Painter, color: Color32) {
    for rail in live.rails() {
        if let [Some(from), Some(to)] = rail.map(|point| page.view.project(point)) {
            painter.line_segment([from, to], Stroke::new(1.0, color));
            painter.circle_filled(to, 2.5, color);
        }
    }
}

/// Draws the circle in which the soft selection moves vertices.
fn paint_soft_radius(page: &Page<'_>, painter: &egui::Painter, color: Color32) {
    if let (Some(frame), Some(radius)) = (Frame::new(page), page.live_settings.soft_radius) {
        painter.circle_stroke(frame.middle, radius / frame.length * ARROW_POINTS, Stroke::new(1.0, color));
    }
}
