//! The editor's icons, as lines on a grid of 16 by 16.

use egui::{Color32, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2};

/// One of the editor's icons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// A folder.
    Open,
    /// An arrow into a tray.
    Save,
    /// An arrow turning back.
    Undo,
    /// An arrow turning forward.
    Redo,
    /// The corners of a frame.
    Frame,
    /// A triangle cut into triangles.
    Wireframe,
    /// A ball.
    Smooth,
    /// The letter i in a circle.
    Info,
    /// A magnifying glass.
    Search,
    /// An open eye.
    Eye,
    /// A closed eye.
    EyeClosed,
    /// A cross.
    Close,
    /// Three lines.
    Menu,
    /// A dashed box.
    BoxSelect,
    /// A square cut in four.
    Subdivide,
    /// A waste bin.
    Delete,
    /// An arrowhead to the left.
    Back,
}

type Line = &'static [(f32, f32)];

impl Icon {
    fn lines(self) -> &'static [Line] {
        match self {
            Self::Open => &[
                &[(1.5, 13.0), (1.5, 3.5), (6.0, 3.5), (7.5, 5.5), (13.0, 5.5), (13.0, 7.5)],
                &[(1.5, 13.0), (4.0, 7.5), (15.0, 7.5), (12.5, 13.0), (1.5, 13.0)],
            ],
            Self::Save => &[
                &[(8.0, 1.5), (8.0, 10.0)],
                &[(4.5, 6.5), (8.0, 10.0), (11.5, 6.5)],
                &[(2.0, 10.5), (2.0, 14.0), (14.0, 14.0), (14.0, 10.5)],
            ],
            Self::Undo => &[
                &[(5.5, 2.5), (2.0, 6.0), (5.5, 9.5)],
                &[
                    (2.0, 6.0),
                    (9.5, 6.0),
                    (11.9, 6.6),
                    (13.4, 8.2),
                    (13.9, 10.0),
                    (13.4, 11.8),
                    (11.9, 13.4),
                    (9.5, 14.0),
                    (6.5, 14.0),
                ],
            ],
            Self::Redo => &[
                &[(10.5, 2.5), (14.0, 6.0), (10.5, 9.5)],
                &[
                    (14.0, 6.0),
                    (6.5, 6.0),
                    (4.1, 6.6),
                    (2.6, 8.2),
                    (2.1, 10.0),
                    (2.6, 11.8),
                    (4.1, 13.4),
                    (6.5, 14.0),
                    (9.5, 14.0),
                ],
            ],
            Self::Frame => &[
                &[(2.0, 5.5), (2.0, 2.0), (5.5, 2.0)],
                &[(10.5, 2.0), (14.0, 2.0), (14.0, 5.5)],
                &[(14.0, 10.5), (14.0, 14.0), (10.5, 14.0)],
                &[(5.5, 14.0), (2.0, 14.0), (2.0, 10.5)],
            ],
            Self::Wireframe => &[
                &[(8.0, 1.5), (15.0, 14.0), (1.0, 14.0), (8.0, 1.5)],
                &[(4.5, 7.8), (11.5, 7.8), (8.0, 14.0), (4.5, 7.8)],
            ],
            Self::Smooth => &[&[(4.5, 7.0), (5.4, 5.4), (7.0, 4.5)]],
            Self::Info => &[&[(8.0, 7.2), (8.0, 11.5)], &[(8.0, 4.3), (8.0, 5.1)]],
            Self::Search => &[&[(10.4, 10.4), (14.5, 14.5)]],
            Self::Eye => &[&[
                (1.0, 8.0),
                (3.5, 5.0),
                (8.0, 3.5),
                (12.5, 5.0),
                (15.0, 8.0),
                (12.5, 11.0),
                (8.0, 12.5),
                (3.5, 11.0),
                (1.0, 8.0),
            ]],
            Self::EyeClosed => &[
                &[(1.0, 6.5), (3.5, 9.0), (8.0, 10.5), (12.5, 9.0), (15.0, 6.5)],
                &[(3.5, 9.0), (2.3, 11.2)],
                &[(8.0, 10.5), (8.0, 13.0)],
                &[(12.5, 9.0), (13.7, 11.2)],
            ],
            Self::Back => &[&[(10.0, 3.0), (5.0, 8.0), (10.0, 13.0)]],
            Self::Close => &[&[(3.5, 3.5), (12.5, 12.5)], &[(12.5, 3.5), (3.5, 12.5)]],
            Self::Menu => {
                &[&[(2.0, 4.0), (14.0, 4.0)], &[(2.0, 8.0), (14.0, 8.0)], &[(2.0, 12.0), (14.0, 12.0)]]
            }
            Self::BoxSelect => &[
                &[(2.0, 4.5), (2.0, 2.0), (4.5, 2.0)],
                &[(7.0, 2.0), (9.0, 2.0)],
                &[(11.5, 2.0), (14.0, 2.0), (14.0, 4.5)],
                &[(14.0, 7.0), (14.0, 9.0)],
                &[(14.0, 11.5), (14.0, 14.0), (11.5, 14.0)],
                &[(9.0, 14.0), (7.0, 14.0)],
                &[(4.5, 14.0), (2.0, 14.0), (2.0, 11.5)],
                &[(2.0, 9.0), (2.0, 7.0)],
            ],
            Self::Subdivide => &[
                &[(2.0, 2.0), (14.0, 2.0), (14.0, 14.0), (2.0, 14.0), (2.0, 2.0)],
                &[(8.0, 2.0), (8.0, 14.0)],
                &[(2.0, 8.0), (14.0, 8.0)],
            ],
            Self::Delete => &[
                &[(2.5, 4.0), (13.5, 4.0)],
                &[(6.0, 4.0), (6.0, 2.0), (10.0, 2.0), (10.0, 4.0)],
                &[(4.0, 4.0), (4.6, 14.0), (11.4, 14.0), (12.0, 4.0)],
            ],
        }
    }

    /// A circle in the icon: centre and radius.
    fn circle(self) -> Option<(f32, f32, f32)> {
        match self {
            Self::Smooth | Self::Info => Some((8.0, 8.0, 6.6)),
            Self::Search => Some((6.5, 6.5, 4.8)),
            Self::Eye => Some((8.0, 8.0, 2.0)),
            _ => None,
        }
    }

    /// Draws the icon in the middle of a rectangle, 16 points wide.
    pub fn paint(self, painter: &Painter, rect: Rect, color: Color32) {
        let stroke = Stroke::new(1.4, color);
        let corner = rect.center() - Vec2::splat(8.0);
        let at = |&(x, y): &(f32, f32)| -> Pos2 { pos2(corner.x + x, corner.y + y) };
        for line in self.lines() {
            painter.add(Shape::line(line.iter().map(at).collect(), stroke));
        }
        if let Some((x, y, radius)) = self.circle() {
            painter.circle_stroke(at(&(x, y)), radius, stroke);
        }
    }
}

/// A square button with an icon. `name` is its name in the accessibility tree.
pub fn icon_button(ui: &mut Ui, icon: Icon, name: &str, selected: bool) -> Response {
    let side = ui.spacing().interact_size.y.max(26.0);
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::click());
    response.widget_info(|| {
        if selected {
            WidgetInfo::selected(Role::Button, ui.is_enabled(), true, name)
        } else {
            WidgetInfo::labeled(Role::Button, ui.is_enabled(), name)
        }
    });
    if ui.is_rect_visible(rect) {
        let visuals = ui.style().interact_selectable(&response, selected);
        if selected || response.hovered() || response.has_focus() {
            ui.painter().rect(
                rect,
                visuals.corner_radius,
                visuals.weak_bg_fill,
                visuals.bg_stroke,
                egui::StrokeKind::Inside,
            );
        }
        icon.paint(ui.painter(), rect, visuals.text_color());
    }
    response
}
