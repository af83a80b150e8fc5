//! Fades at the ends of what scrolls without a scroll bar: they show that there is more than fits.

use egui::{Color32, Mesh, Painter, Pos2, Rect, Stroke, pos2};

/// The height of a fade, in points.
const FADE_POINTS: f32 = 36.0;
/// Half the width of the arrow in a fade, in points.
const ARROW_POINTS: f32 = 6.0;
/// Less than this beyond an end is not worth a fade, in points.
const MIN_HIDDEN_POINTS: f32 = 4.0;

/// Whether there is more above and below a part of this height of something that is higher and scrolled by `offset`.
fn hidden_ends(height: f32, offset: f32, content: f32) -> [bool; 2] {
    [offset > MIN_HIDDEN_POINTS, content - height - offset > MIN_HIDDEN_POINTS]
}

/// Draws the fades over a part that is scrolled by `offset`. `plate` is the colour of the ground, `mark` that of the arrows.
pub fn paint(painter: &Painter, rect: Rect, offset: f32, content: f32, [plate, mark]: [Color32; 2]) {
    let [above, below] = hidden_ends(rect.height(), offset, content);
    if above {
        fade(painter, rect.with_max_y(rect.top() + FADE_POINTS), -1.0, plate, mark);
    }
    if below {
        fade(painter, rect.with_min_y(rect.bottom() - FADE_POINTS), 1.0, plate, mark);
    }
}

/// A fade to the ground's colour with an arrow, downwards where `way` is 1 and upwards where it is -1.
fn fade(painter: &Painter, rect: Rect, way: f32, plate: Color32, mark: Color32) {
    let (inner, outer) = if way > 0.0 { (rect.top(), rect.bottom()) } else { (rect.bottom(), rect.top()) };
    let [r, g, b, _] = plate.to_srgba_unmultiplied();
    let opaque = Color32::from_rgb(r, g, b);
    let mut mesh = Mesh::default();
    for (y, color) in [(inner, Color32::TRANSPARENT), (outer, opaque)] {
        mesh.colored_vertex(pos2(rect.left(), y), color);
        mesh.colored_vertex(pos2(rect.right(), y), color);
    }
    mesh.add_triangle(0, 1, 2);
    mesh.add_triangle(1, 2, 3);
    painter.add(mesh);
    let tip = pos2(rect.center().x, outer - way * ARROW_POINTS);
    let end = |side: f32| -> Pos2 { pos2(tip.x + side * ARROW_POINTS, tip.y - way * ARROW_POINTS) };
    painter.line(vec![end(-1.0), tip, end(1.0)], Stroke::new(2.0, mark));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fades_show_where_there_is_more() {
        assert_eq!(hidden_ends(100.0, 0.0, 100.0), [false, false]);
        assert_eq!(hidden_ends(100.0, 0.0, 240.0), [false, true]);
        assert_eq!(hidden_ends(100.0, 60.0, 240.0), [true, true]);
        assert_eq!(hidden_ends(100.0, 140.0, 240.0), [true, false]);
    }
}
