//! The editor's icons, as lines on a grid of 16 by 16.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2};

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
    /// A magnet.
    Snap,
    /// A bell.
    Soft,
    /// A triangle on either side of a mirror.
    Symmetry,
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
    /// A plus sign.
    Add,
    /// A face with a corner marked.
    Vertex,
    /// A face with a side marked.
    Edge,
    /// A dashed loop.
    Lasso,
    /// A dashed circle with a dot.
    Circle,
    /// A square behind a square, seen through it.
    XRay,
    /// An arrow along a line.
    Halfedge,
    /// A filled face.
    Face,
    /// The pointer.
    Select,
    /// Arrows in four directions.
    Move,
    /// An arrow around.
    Rotate,
    /// An arrow from a small square outwards.
    Scale,
    /// An arrow up from a plate.
    Extrude,
    /// A square in a square.
    Inset,
    /// A square with one corner cut.
    Bevel,
    /// A line through a square.
    LoopCut,
    /// A line with arrows to both sides.
    Slide,
    /// A point on a line.
    Split,
    /// A square with its diagonal.
    Connect,
    /// A mouse with the left button marked.
    MouseLeft,
    /// A mouse with the wheel marked.
    MouseMiddle,
    /// A mouse with the right button marked.
    MouseRight,
    /// A house.
    Home,
}

type Line = &'static [(f32, f32)];

const SQUARE: Line = &[(2.5, 2.5), (13.5, 2.5), (13.5, 13.5), (2.5, 13.5), (2.5, 2.5)];

/// The outline of a mouse, and the line between its buttons and the rest.
const MOUSE: &[Line] = &[
    &[
        (6.4, 1.4),
        (9.6, 1.4),
        (11.4, 2.2),
        (12.4, 4.2),
        (12.4, 11.4),
        (11.2, 13.6),
        (9.4, 14.6),
        (6.6, 14.6),
        (4.8, 13.6),
        (3.6, 11.4),
        (3.6, 4.2),
        (4.6, 2.2),
        (6.4, 1.4),
    ],
    &[(3.6, 7.0), (12.4, 7.0)],
];

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
            Self::Home => &[
                &[(1.5, 8.0), (8.0, 2.0), (14.5, 8.0)],
                &[(3.5, 6.4), (3.5, 14.0), (12.5, 14.0), (12.5, 6.4)],
                &[(6.5, 14.0), (6.5, 9.5), (9.5, 9.5), (9.5, 14.0)],
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
            Self::Add => &[&[(8.0, 2.5), (8.0, 13.5)], &[(2.5, 8.0), (13.5, 8.0)]],
            Self::Vertex | Self::Edge | Self::Face => &[SQUARE],
            Self::Halfedge => &[&[(1.5, 12.5), (14.5, 12.5)], &[(9.6, 3.6), (14.0, 8.2)]],
            Self::Select => &[&[
                (3.5, 1.8),
                (3.5, 12.6),
                (6.5, 10.0),
                (8.5, 14.4),
                (10.5, 13.5),
                (8.5, 9.2),
                (12.4, 8.8),
                (3.5, 1.8),
            ]],
            Self::Lasso => &[
                &[(6.0, 13.8), (5.2, 11.6), (3.6, 10.8), (2.2, 8.8)],
                &[(1.9, 6.4), (3.2, 4.0), (5.4, 2.6)],
                &[(7.8, 2.1), (10.6, 2.4), (12.8, 3.8)],
                &[(14.0, 5.8), (14.0, 8.2), (12.6, 10.2)],
                &[(10.6, 11.2), (8.0, 11.7), (5.2, 11.6)],
            ],
            Self::Circle => &[
                &[(8.0, 2.0), (10.3, 2.5), (12.2, 3.8)],
                &[(13.5, 5.7), (14.0, 8.0), (13.5, 10.3)],
                &[(12.2, 12.2), (10.3, 13.5), (8.0, 14.0)],
                &[(5.7, 13.5), (3.8, 12.2), (2.5, 10.3)],
                &[(2.0, 8.0), (2.5, 5.7), (3.8, 3.8), (5.7, 2.5)],
            ],
            Self::Snap => &[
                &[(3.0, 2.0), (3.0, 8.0), (4.5, 11.7), (8.0, 13.5), (11.5, 11.7), (13.0, 8.0), (13.0, 2.0)],
                &[(6.0, 2.0), (6.0, 8.0), (6.6, 9.6), (8.0, 10.4), (9.4, 9.6), (10.0, 8.0), (10.0, 2.0)],
                &[(3.0, 2.0), (6.0, 2.0)],
                &[(10.0, 2.0), (13.0, 2.0)],
                &[(3.0, 5.0), (6.0, 5.0)],
                &[(10.0, 5.0), (13.0, 5.0)],
            ],
            Self::Soft => {
                &[&[(1.0, 13.0), (4.8, 11.0), (6.4, 5.4), (8.0, 3.4), (9.6, 5.4), (11.2, 11.0), (15.0, 13.0)]]
            }
            Self::Symmetry => &[
                &[(8.0, 1.5), (8.0, 4.0)],
                &[(8.0, 6.7), (8.0, 9.3)],
                &[(8.0, 12.0), (8.0, 14.5)],
                &[(5.6, 3.5), (5.6, 12.5), (1.5, 12.5), (5.6, 3.5)],
                &[(10.4, 3.5), (10.4, 12.5), (14.5, 12.5), (10.4, 3.5)],
            ],
            Self::XRay => &[
                &[(2.0, 2.0), (10.0, 2.0), (10.0, 10.0), (2.0, 10.0), (2.0, 2.0)],
                &[(6.0, 6.0), (14.0, 6.0), (14.0, 14.0), (6.0, 14.0), (6.0, 6.0)],
            ],
            Self::Move => &[
                &[(8.0, 1.5), (8.0, 14.5)],
                &[(1.5, 8.0), (14.5, 8.0)],
                &[(6.0, 3.5), (8.0, 1.5), (10.0, 3.5)],
                &[(6.0, 12.5), (8.0, 14.5), (10.0, 12.5)],
                &[(3.5, 6.0), (1.5, 8.0), (3.5, 10.0)],
                &[(12.5, 6.0), (14.5, 8.0), (12.5, 10.0)],
            ],
            Self::Rotate => &[
                &[
                    (12.3, 4.8),
                    (13.5, 9.2),
                    (12.7, 11.4),
                    (11.1, 13.1),
                    (8.9, 13.9),
                    (6.6, 13.8),
                    (4.5, 12.7),
                    (3.0, 10.9),
                    (2.4, 8.6),
                    (2.8, 6.3),
                    (4.1, 4.4),
                    (6.1, 3.1),
                    (8.0, 2.8),
                ],
                &[(5.6, 0.8), (8.2, 2.8), (6.0, 5.4)],
            ],
            Self::Scale => &[
                &[(2.0, 9.0), (7.0, 9.0), (7.0, 14.0), (2.0, 14.0), (2.0, 9.0)],
                &[(8.8, 7.2), (14.0, 2.0)],
                &[(9.5, 2.0), (14.0, 2.0), (14.0, 6.5)],
            ],
            Self::Extrude => &[
                &[(5.5, 9.0), (4.5, 9.0), (1.0, 14.0), (11.5, 14.0), (15.0, 9.0), (10.5, 9.0)],
                &[(8.0, 11.0), (8.0, 1.5)],
                &[(5.2, 4.3), (8.0, 1.5), (10.8, 4.3)],
            ],
            Self::Inset => &[
                SQUARE,
                &[(5.8, 5.8), (10.2, 5.8), (10.2, 10.2), (5.8, 10.2), (5.8, 5.8)],
                &[(2.5, 2.5), (5.8, 5.8)],
                &[(13.5, 2.5), (10.2, 5.8)],
                &[(13.5, 13.5), (10.2, 10.2)],
                &[(2.5, 13.5), (5.8, 10.2)],
            ],
            Self::Bevel => &[&[(8.5, 2.5), (13.5, 2.5), (13.5, 13.5), (2.5, 13.5), (2.5, 8.5)]],
            Self::LoopCut => &[SQUARE, &[(5.0, 8.0), (8.0, 5.0)], &[(8.0, 11.0), (11.0, 8.0)]],
            Self::Slide => &[&[(4.5, 6.1), (2.0, 8.0), (4.5, 9.9)], &[(11.5, 6.1), (14.0, 8.0), (11.5, 9.9)]],
            Self::Split => &[&[(1.8, 14.2), (5.9, 10.1)], &[(10.1, 5.9), (14.2, 1.8)]],
            Self::Connect => &[SQUARE],
            Self::MouseLeft | Self::MouseMiddle | Self::MouseRight => MOUSE,
        }
    }

    /// A line of the icon that is drawn twice as thick.
    fn bold_line(self) -> Option<Line> {
        match self {
            Self::Edge => Some(&[(2.5, 2.5), (2.5, 13.5)]),
            Self::Halfedge => Some(&[(1.5, 8.2), (14.5, 8.2)]),
            Self::Bevel => Some(&[(2.5, 8.5), (8.5, 2.5)]),
            Self::LoopCut | Self::Slide => Some(&[(8.0, 1.5), (8.0, 14.5)]),
            Self::Connect => Some(&[(2.5, 13.5), (13.5, 2.5)]),
            _ => None,
        }
    }

    /// A convex area of the icon that is filled.
    fn area(self) -> Option<Line> {
        match self {
            Self::Face => Some(&[(5.0, 5.0), (11.0, 5.0), (11.0, 11.0), (5.0, 11.0)]),
            Self::MouseLeft => {
                Some(&[(3.6, 7.0), (3.6, 4.2), (4.6, 2.2), (6.4, 1.4), (8.0, 1.4), (8.0, 7.0)])
            }
            Self::MouseRight => {
                Some(&[(8.0, 1.4), (9.6, 1.4), (11.4, 2.2), (12.4, 4.2), (12.4, 7.0), (8.0, 7.0)])
            }
            Self::MouseMiddle => Some(&[(6.8, 2.6), (9.2, 2.6), (9.2, 7.0), (6.8, 7.0)]),
            _ => None,
        }
    }

    /// A filled circle in the icon: centre and radius.
    fn dot(self) -> Option<(f32, f32, f32)> {
        match self {
            Self::Vertex => Some((13.0, 3.0, 2.6)),
            Self::Circle => Some((8.0, 8.0, 1.6)),
            _ => None,
        }
    }

    /// A circle in the icon: centre and radius.
    fn circle(self) -> Option<(f32, f32, f32)> {
        match self {
            Self::Smooth | Self::Info => Some((8.0, 8.0, 6.6)),
            Self::Search => Some((6.5, 6.5, 4.8)),
            Self::Eye => Some((8.0, 8.0, 2.0)),
            Self::Split => Some((8.0, 8.0, 2.6)),
            _ => None,
        }
    }

    /// Draws the icon in the middle of a rectangle, 16 points wide.
    pub fn paint(self, painter: &Painter, rect: Rect, color: Color32) {
        self.paint_sized(painter, rect, 16.0, color);
    }

    /// Draws the icon in the middle of a rectangle, `size` points wide.
    pub fn paint_sized(self, painter: &Painter, rect: Rect, size: f32, color: Color32) {
        let scale = size / 16.0;
        let stroke = Stroke::new(1.4, color);
        let corner = rect.center() - Vec2::splat(size / 2.0);
        let at = |&(x, y): &(f32, f32)| -> Pos2 { pos2(corner.x + x * scale, corner.y + y * scale) };
        let placed = |line: Line| line.iter().map(at).collect();
        for line in self.lines() {
            painter.add(Shape::line(placed(line), stroke));
        }
        if let Some(area) = self.area() {
            painter.add(Shape::convex_polygon(placed(area), color, Stroke::NONE));
        }
        if let Some(line) = self.bold_line() {
            painter.add(Shape::line(placed(line), Stroke::new(2.8, color)));
        }
        if let Some((x, y, radius)) = self.dot() {
            painter.circle_filled(at(&(x, y)), radius * scale, color);
        }
        if let Some((x, y, radius)) = self.circle() {
            painter.circle_stroke(at(&(x, y)), radius * scale, stroke);
        }
    }
}
