//! Icons of operations, on the grid of 16 by 16 of [`super::icons`]. What the operation makes or takes is drawn in
//! a second colour.
//!
//! A drawing is a list of parts, separated by `;`. A part is a line through points (`2,2 14,2`), a circle (`o` with
//! centre and radius) or a dot (`*` with centre and radius); a `+` before it makes it a part in the second colour.

use editor::OpId;
use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};

/// The drawing of an operation; empty for those that no list offers.
fn drawing(id: OpId) -> &'static str {
    match id {
        OpId::Transform => "8,2 8,14;2,8 14,8;+6,4 8,2 10,4;+6,12 8,14 10,12;+4,6 2,8 4,10;+12,6 14,8 12,10",
        OpId::SetVertexPosition => "8,1 8,4;8,12 8,15;1,8 4,8;12,8 15,8;+*8,8,2",
        OpId::SetFaceColor => "8,2 11.5,7 12.3,10 11,12.8 8,14 5,12.8 3.7,10 4.5,7 8,2;+*8,10.4,2",
        OpId::SplitEdge => "2,13 14,3;+*8,8,2.2",
        OpId::FlipEdge => "2,2 14,2 14,14 2,14 2,2;+2,2 14,14",
        OpId::CollapseEdge => "1,8 5,8;15,8 11,8;3,6 5,8 3,10;13,6 11,8 13,10;+*8,8,1.8",
        OpId::CollapseFace => "2,2 14,2 14,14 2,14 2,2;+4,4 6,6;+12,4 10,6;+12,12 10,10;+4,12 6,10;+*8,8,1.5",
        OpId::SplitVertex => "5,8 2,3;5,8 2,13;11,8 14,3;11,8 14,13;+5,8 11,8;+*5,8,1.8;+*11,8,1.8",
        OpId::DissolveVertex => "2,8 5,8;11,8 14,8;8,2 8,5;8,11 8,14;+o8,8,2.6",
        OpId::DissolveEdge => "2,3 14,3 14,13 2,13 2,3;+8,3 8,5;+8,7 8,9;+8,11 8,13",
        OpId::DeleteFaces => "2,2 14,2 14,14 2,14 2,2;+5.5,5.5 10.5,10.5;+10.5,5.5 5.5,10.5",
        OpId::DeleteVertices => "1.5,14 6.5,7;14.5,14 9.5,7;1.5,14 14.5,14;+6,2 10,6;+10,2 6,6",
        OpId::TriangulateFaces => "2,2 14,2 14,14 2,14 2,2;+2,14 14,2",
        OpId::PokeFaces => "2,2 14,2 14,14 2,14 2,2;+2,2 14,14;+14,2 2,14",
        OpId::ConnectVertices => "2,4 8,2 14,4 14,12 8,14 2,12 2,4;+2,12 14,4;+*2,12,1.6;+*14,4,1.6",
        OpId::ExtrudeFaces => "3,9.5 13,9.5 13,14 3,14 3,9.5;+8,7 8,1.5;+5.5,4 8,1.5 10.5,4",
        OpId::ExtrudeEdges => "2,13 14,13;2,13 2,8 14,8 14,13;+8,6 8,1.5;+6,3.5 8,1.5 10,3.5",
        OpId::InsetFaces => "2,2 14,2 14,14 2,14 2,2;+5,5 11,5 11,11 5,11 5,5",
        OpId::BevelEdges => "2,14 2,7;7,2 14,2;+2,7 7,2",
        OpId::BevelVertices => "1.5,14 5.5,6;10.5,6 14.5,14;1.5,14 14.5,14;+5.5,6 10.5,6",
        OpId::LoopCut => "2,3 14,3 14,13 2,13 2,3;6,3 6,13;10,3 10,13;+0.5,8 15.5,8",
        OpId::SlideEdges => {
            "2,2 2,14;14,2 14,14;2,8 4,8;12,8 14,8;+8,2 8,14;+6.5,6 4.5,8 6.5,10;+9.5,6 11.5,8 9.5,10"
        }
        OpId::SlideVertices => "2,14 5.5,10.5;10.5,5.5 14,2;+*8,8,2.2;+10,2 14,2 14,6",
        OpId::FillHole => "5,2 11,2 14,5 14,11 11,14 5,14 2,11 2,5 5,2;+*8,8,3.2",
        OpId::Bridge => "3,2 3,14;13,2 13,14;+3,5 13,5;+3,11 13,11",
        OpId::MergeVertices => "2,2.5 6,6.5;14,2.5 10,6.5;8,15 8,11;+*8,8,2.2",
        OpId::WeldEdges => "3,2 6.5,8 3,14;13,2 9.5,8 13,14;+8,2 8,14",
        OpId::RipEdges => "6.5,2 5,14;9.5,2 11,14;+3.5,6 1.5,8 3.5,10;+12.5,6 14.5,8 12.5,10",
        OpId::FlipOrientation => "1.5,8 14.5,8;5,8 5,2;3,4 5,2 7,4;+11,8 11,14;+9,12 11,14 13,12",
        OpId::SetCrease => "1.5,13 14.5,13;+3.5,13 8,3 12.5,13",
        OpId::SubdivideCatmullClark => "5,2 11,2 14,5 14,11 11,14 5,14 2,11 2,5 5,2;+8,2 8,14;+2,8 14,8",
        OpId::SubdivideLoop => "8,2 15,14 1,14 8,2;+4.5,8 11.5,8 8,14 4.5,8",
        OpId::SubdivideLinear => "2,2 14,2 14,14 2,14 2,2;+8,2 8,14;+2,8 14,8",
        OpId::Simplify => "1,13.5 8,2 15,13.5 1,13.5;+8,2 8,13.5",
        OpId::Remesh => "1,12 4.5,4 8,12 11.5,4 15,12 1,12;+4.5,4 11.5,4",
        OpId::Smooth => "1,6 4,2 7,6 10,2 13,6 15,3.5;+1,12 3,10.7 5.5,10.7 8,11.7 10.5,12.7 13,12.7 15,11.4",
        OpId::MergeByDistance => "*6,8,1.5;*10,8,1.5;+o8,8,6",
        OpId::RepairImport => "2,2 14,2 14,14 2,14 2,2;+8,5 8,11;+5,8 11,8",
        OpId::New => "8,1.5 14,4.8 14,11.2 8,14.5 2,11.2 2,4.8 8,1.5;+2,4.8 8,8 14,4.8;+8,8 8,14.5",
        OpId::JoinObjects => "2,2 9,2 9,9 2,9 2,2;+7,7 14,7 14,14 7,14 7,7",
        OpId::Separate => "2,2 6.5,2 6.5,14 2,14 2,2;+9.5,2 14,2 14,14 9.5,14 9.5,2",
        OpId::BezierTessellate => "2,13 3,8 6,4.2 10,4.2 13,8 14,13 2,13;+5,5.5 5,13;+8,4 8,13;+11,5.5 11,13",
        _ => "",
    }
}

/// Draws an operation's icon in the middle of a rectangle, 16 points wide.
pub fn paint(id: OpId, painter: &Painter, rect: Rect, color: Color32, second: Color32) {
    let corner = rect.center() - Vec2::splat(8.0);
    for part in drawing(id).split(';') {
        let (part, color) = part.strip_prefix('+').map_or((part, color), |part| (part, second));
        painter.extend(shape(part, corner, color));
    }
}

fn shape(part: &str, corner: Pos2, color: Color32) -> Option<Shape> {
    let stroke = Stroke::new(1.4, color);
    let round = |text: &str| {
        let numbers: Vec<f32> = text.split(',').filter_map(|number| number.parse().ok()).collect();
        match numbers[..] {
            [x, y, radius] => Some((corner + vec2(x, y), radius)),
            _ => None,
        }
    };
    if let Some(text) = part.strip_prefix('*') {
        return round(text).map(|(center, radius)| Shape::circle_filled(center, radius, color));
    }
    if let Some(text) = part.strip_prefix('o') {
        return round(text).map(|(center, radius)| Shape::circle_stroke(center, radius, stroke));
    }
    let point = |text: &str| {
        let (x, y) = text.split_once(',')?;
        Some(corner + vec2(x.parse().ok()?, y.parse().ok()?))
    };
    let points: Option<Vec<Pos2>> = part.split_whitespace().map(point).collect();
    points.filter(|points| points.len() > 1).map(|points| Shape::line(points, stroke))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::actions;

    #[test]
    fn every_part_is_drawn_within_its_square() {
        let square = Rect::from_min_size(Pos2::ZERO, Vec2::splat(16.0)).expand(1.0);
        for id in actions::mesh_operations().chain([OpId::New]) {
            let drawing = drawing(id);
            assert!(!drawing.is_empty(), "{id:?} has no icon");
            for part in drawing.split(';') {
                let part = part.strip_prefix('+').unwrap_or(part);
                let shape = shape(part, Pos2::ZERO, Color32::WHITE);
                let bounds = shape.map(|shape| shape.visual_bounding_rect());
                assert!(bounds.is_some_and(|bounds| square.contains_rect(bounds)), "{id:?}: {part}");
            }
        }
    }
}
