//! The ids of the elements around the pointer.

use egui::{Align2, Color32, FontId, Rect, Ui, vec2};
use halfedge::Element;
use viewport::{Around, elements_near};

use super::Viewport;
use crate::theme;

/// How far from the pointer, in points.
const REACH_POINTS: f32 = 130.0;
/// The most numbers at once.
const MAX_NUMBERS: usize = 60;
/// Room for a short number.
const GAP: glam::Vec2 = glam::Vec2::new(26.0, 14.0);

impl Viewport<'_> {
    /// Draws the ids of the vertices, edges and faces around the pointer, as far as there is room for them.
    pub(super) fn numbers(&mut self, ui: &Ui, rect: Rect) {
        let pointer = ui.ctx().pointer_latest_pos().filter(|at| rect.contains(*at));
        let active = self.session.editor.document().active().filter(|object| object.visible());
        let Some((at, object)) = pointer.zip(active) else { return };
        if !self.view.build_tree_step(object) {
            ui.ctx().request_repaint();
            return;
        }
        let (camera, local, size) = (self.view.camera, self.view.local(at), self.view.size());
        let tree = self.view.tree(object);
        let around = Around { pixel: local, radius: REACH_POINTS, gap: GAP, limit: MAX_NUMBERS };
        let near = elements_near((object.mesh(), tree), &camera, size, around);
        let painter = ui.painter().with_clip_rect(rect);
        let plate = theme::palette(ui.visuals()).overlay;
        let font = FontId::monospace(11.0);
        let mut taken: Vec<Rect> = Vec::new();
        for element in near {
            let (prefix, color) = name(element.kind, ui.visuals().dark_mode);
            let galley = painter.layout_no_wrap(format!("{prefix}{}", element.id), font.clone(), color);
            let place = rect.min + vec2(element.pixel.x, element.pixel.y);
            // Vertices have their numbers beside them, so that the vertex itself stays in view.
            let (anchor, shift) = match element.kind {
                Element::Vertex => (Align2::LEFT_BOTTOM, vec2(4.0, -4.0)),
                _ => (Align2::CENTER_CENTER, vec2(0.0, 0.0)),
            };
            let area = anchor.anchor_size(place + shift, galley.size() + vec2(6.0, 2.0));
            if taken.iter().any(|other| other.intersects(area)) {
                continue;
            }
            taken.push(area);
            painter.rect_filled(area, 3.0, plate);
            painter.galley(area.min + vec2(3.0, 1.0), galley, color);
        }
    }
}

/// The letter in front of the ids of a kind, and their colour.
fn name(kind: Element, is_dark: bool) -> (char, Color32) {
    let [_, r, g, b] = match (kind, is_dark) {
        (Element::Vertex, true) => 0xffd479_u32,
        (Element::Vertex, false) => 0x7a4b00,
        (Element::Edge | Element::Halfedge, true) => 0x8fe39a,
        (Element::Edge | Element::Halfedge, false) => 0x0b6b2b,
        (Element::Face, true) => 0x9ecbff,
        (Element::Face, false) => 0x0b4fa3,
    }
    .to_be_bytes();
    let letter = match kind {
        Element::Vertex => 'v',
        Element::Edge | Element::Halfedge => 'e',
        Element::Face => 'f',
    };
    (letter, Color32::from_rgb(r, g, b))
}
