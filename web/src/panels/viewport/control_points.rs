//! Picking, dragging, adding and deleting control points in the viewport.

use crate::bezier::{ControlPoint, Player, active, is_flat};
use crate::view::View;
use editor::ops::{BezierInsertPoint, BezierMovePoint};
use editor::{Command, Editor};
use egui::Pos2;
use glam::{Vec3, vec2};

/// The radius around the pointer in which a control point is picked, in points.
const PICK_RADIUS_POINTS: f32 = 11.0;

/// The command that moves a control point to a position.
pub(crate) fn moved(point: ControlPoint, to: Vec3) -> Command {
    let none = BezierMovePoint { point: None, patch: None, row: None, column: None, position: to.to_array() };
    let [id, row_id, column_id] = match point {
        ControlPoint::Curve(at) => [at, 0, 0],
        ControlPoint::Patch { patch, row, column } => [patch, row, column],
    }
    .map(|at| Some(at as u32));
    match point {
        ControlPoint::Curve(_) => BezierMovePoint { point: id, ..none },
        ControlPoint::Patch { .. } => BezierMovePoint { patch: id, row: row_id, column: column_id, ..none },
    }
    .into()
}

/// The control point at a place on the page, with its position. Of several at the same distance, the one
/// nearest to the eye is picked.
pub(crate) fn control_point_at(
    editor: &Editor,
    view: &View,
    player: &Player,
    at: Pos2,
) -> Option<(ControlPoint, Vec3)> {
    let (_, bezier) = active(editor).filter(|(object, _)| object.visible())?;
    let mut best: Option<(f32, f64, ControlPoint, Vec3)> = None;
    for (point, position) in player.points(bezier) {
        let Some(seen) = view.project(position) else { continue };
        let distance = seen.distance(at);
        if distance > PICK_RADIUS_POINTS {
            continue;
        }
        let depth = view.camera.depth(position);
        let better = best.is_none_or(|(other, other_depth, ..)| {
            distance < other - 1.0 || (distance < other + 1.0 && depth < other_depth)
        });
        if better {
            best = Some((distance, depth, point, position));
        }
    }
    best.map(|(_, _, point, position)| (point, position))
}

/// The position of a point dragged from one place on the page to another: in the plane parallel to the
/// screen or, for a flat curve, in the curve's plane.
pub(crate) fn dragged_to(editor: &Editor, view: &View, anchor: Vec3, from: Pos2, to: Pos2) -> Vec3 {
    let flat = active(editor).and_then(|(_, bezier)| bezier.curve()).is_some_and(is_flat);
    let seen = view.project(anchor).unwrap_or(from);
    if flat && let Some(hit) = on_plane(view, seen + (to - from)) {
        return hit;
    }
    let by = to - from;
    view.camera.drag(anchor, vec2(by.x, by.y), view.size())
}

/// The point where the line of sight through a place on the page meets the plane z = 0; none if the line is
/// parallel to the plane.
fn on_plane(view: &View, at: Pos2) -> Option<Vec3> {
    let corner = view.rect.min;
    let ray = view.camera.ray(vec2(at.x - corner.x, at.y - corner.y), view.size());
    let along = -ray.origin.z / ray.direction.z;
    let hit = ray.origin + ray.direction * along;
    let seen = hit.is_finite() && along > 0.0 && ray.direction.z.abs() > 0.05 * ray.direction.length();
    seen.then(|| Vec3::new(hit.x, hit.y, 0.0))
}

/// Adds a control point to the active curve at the pointer: between two points if the pointer is on the
/// line between them, else after the last point.
pub(crate) fn add_control_point_at(editor: &Editor, view: &View, at: Pos2) -> Option<BezierInsertPoint> {
    let curve = active(editor).and_then(|(_, bezier)| bezier.curve())?;
    let mut nearest: Option<(f32, usize, Vec3)> = None;
    for (after, pair) in curve.points.windows(2).enumerate() {
        let &[from, to] = pair else { continue };
        let (Some(a), Some(b)) = (view.project(from), view.project(to)) else {
            continue;
        };
        let along = ((at - a).dot(b - a) / (b - a).length_sq().max(1e-6)).clamp(0.0, 1.0);
        let distance = (a + (b - a) * along).distance(at);
        if distance <= PICK_RADIUS_POINTS && nearest.is_none_or(|(other, ..)| distance < other) {
            nearest = Some((distance, after + 1, from.lerp(to, along)));
        }
    }
    let (index, place) = match nearest {
        Some((_, index, place)) => (index, place),
        None => {
            let &last = curve.points.last()?;
            let from = view.project(last).unwrap_or(at);
            (curve.points.len(), dragged_to(editor, view, last, from, at))
        }
    };
    place.is_finite().then(|| insert_at(index, place))
}

/// Adds a control point after the chosen one, or after the last: for buttons.
pub(crate) fn add_control_point(editor: &Editor, player: &Player) -> Option<BezierInsertPoint> {
    let curve = active(editor).and_then(|(_, bezier)| bezier.curve())?;
    let after = match player.controls.chosen {
        Some(ControlPoint::Curve(at)) => at,
        _ => curve.points.len().saturating_sub(1),
    };
    let &point = curve.points.get(after)?;
    let place = match (curve.points.get(after + 1), after.checked_sub(1).and_then(|i| curve.points.get(i))) {
        (Some(&next), _) => point.midpoint(next),
        // Continues the last step between two points.
        (None, Some(&before)) => point + (point - before),
        (None, None) => point + Vec3::X,
    };
    Some(insert_at(after + 1, place))
}

fn insert_at(index: usize, place: Vec3) -> BezierInsertPoint {
    BezierInsertPoint { index: Some(index as u32), position: place.to_array() }
}
