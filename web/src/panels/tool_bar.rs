//! The bars over the viewport: the tools at its side, and the kinds of elements at its top.

use egui::epaint::MarginF32;
use egui::scroll_area::ScrollBarVisibility;
use egui::{Direction, Frame, Layout, Rect, ScrollArea, Sense, Ui, UiBuilder, Vec2, pos2, vec2};
use halfedge::Element;

use crate::input::actions::{self, Action};
use crate::input::tools::{EDIT_TOGGLES, TOGGLES, TOOLS, ToolEntry};
use crate::page_view::Page;
use crate::panels::menu_bar::explain;
use crate::request::Requests;
use crate::theme;
use crate::transforming::Symmetry;
use crate::widgets::icons::Icon;
use crate::widgets::scroll_fade;
use crate::widgets::tool_button::{Label, tool_button, width_beside};

/// The distance of the bars from the viewport's edges and from each other, in points.
const GAP_POINTS: f32 = 8.0;
/// The space between a bar's edge and its buttons, in points.
const PADDING_POINTS: f32 = 4.0;
/// The space between two groups of tools, in points.
const GROUP_POINTS: f32 = 8.0;

/// In a viewport of this width, in points, there is room for the labels of tools.
const LABELLED_TOOLS_WIDTH: f32 = 760.0;
/// The same for the labels of the kinds of elements.
const LABELLED_KINDS_WIDTH: f32 = 480.0;
/// The width of a switch at the top, in points; fingers get squares.
const TOGGLE_WIDTH_POINTS: f32 = 29.0;
/// In a smaller viewport, in points, there are no bars.
const MIN_VIEWPORT: Vec2 = vec2(120.0, 120.0);

/// The kinds of elements, each with its icon and name.
const KINDS: [(Element, Icon, &str); 4] = [
    (Element::Vertex, Icon::Vertex, "Vertex"),
    (Element::Edge, Icon::Edge, "Edge"),
    (Element::Halfedge, Icon::Halfedge, "Half-edge"),
    (Element::Face, Icon::Face, "Face"),
];

/// The shape of a bar's buttons.
#[derive(Clone, Copy)]
struct Shape {
    label: Label,
    /// The size; a width of zero is that of the label.
    size: Vec2,
}

impl Shape {
    const fn new(label: Label, width: f32, height: f32) -> Self {
        Self { label, size: vec2(width, height) }
    }

    fn size_of(self, ui: &Ui, label: &str) -> Vec2 {
        let width = if self.size.x > 0.0 { self.size.x } else { width_beside(ui, label, self.size.y) };
        vec2(width, self.size.y)
    }

    /// The shapes of tools and of kinds in a viewport of this width.
    fn of(width: f32, narrow: bool, touch: bool) -> [Self; 2] {
        if narrow {
            return [Self::new(Label::Below, 56.0, 48.0), Self::new(Label::Below, 56.0, 48.0)];
        }
        let side = if touch { theme::TOUCH_TARGET } else { 36.0 };
        let icon = Self::new(Label::Hidden, side, side);
        let tools = if width < LABELLED_TOOLS_WIDTH { icon } else { Self::new(Label::Beside, 112.0, side) };
        let kinds = if width < LABELLED_KINDS_WIDTH { icon } else { Self::new(Label::Beside, 0.0, side) };
        [tools, kinds]
    }
}

/// Draws the bars over the viewport; returns how much of its sides they cover.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, narrow: bool, out: &mut Requests) -> MarginF32 {
    let area = page.view.area;
    if area.width() < MIN_VIEWPORT.x || area.height() < MIN_VIEWPORT.y {
        return MarginF32::ZERO;
    }
    let inner = area.shrink(GAP_POINTS);
    let [tool_shape, kind_shape] = Shape::of(area.width(), narrow, page.shown.touch);
    let bar_width = tool_shape.size.x + 2.0 * PADDING_POINTS;
    // On a phone the tools are at the right, where the thumb is.
    let (tools_left, kinds_left) = if narrow {
        (inner.right() - bar_width, inner.left())
    } else {
        (inner.left(), inner.left() + bar_width + GAP_POINTS)
    };
    let tools =
        Rect::from_min_max(pos2(tools_left, inner.top()), pos2(tools_left + bar_width, inner.bottom()));
    plate(ui, "tools", tools, Direction::TopDown, |ui| {
        let height = ui.available_height();
        let scrolled = ScrollArea::vertical()
            .max_height(height)
            .scroll_bar_visibility(ScrollBarVisibility::AlwaysHidden)
            .show(ui, |ui| tool_buttons(ui, page, tool_shape, out));
        let colors = [theme::palette(ui.visuals()).overlay, ui.visuals().strong_text_color()];
        let (offset, content) = (scrolled.state.clamped_offset().y, scrolled.content_size.y);
        scroll_fade::paint(ui.painter(), scrolled.inner_rect, offset, content, colors);
    });
    let right = if narrow { tools.left() - GAP_POINTS } else { inner.right() };
    let kinds = Rect::from_min_max(pos2(kinds_left, inner.top()), pos2(right, inner.bottom()));
    let kinds =
        plate(ui, "kinds", kinds, Direction::LeftToRight, |ui| kind_buttons(ui, page, kind_shape, out));
    let room = Rect::from_min_max(pos2(kinds.right() + GAP_POINTS, inner.top()), inner.right_bottom());
    let mut bottom = kinds.bottom();
    if narrow {
        // Only what is on, below the kinds of elements: there is room for no more.
        let on: Vec<Toggle> = edit_toggles(page).into_iter().filter(|toggle| toggle.on).collect();
        if !on.is_empty() {
            let below = Rect::from_min_max(pos2(kinds.left(), bottom + GAP_POINTS), room.right_bottom());
            let size = Vec2::splat(theme::TOUCH_TARGET);
            bottom = plate(ui, "toggles", below, Direction::LeftToRight, |ui| buttons_of(ui, &on, size, out))
                .bottom();
        }
    } else {
        toggles(ui, page, room, kind_shape.size.y, out);
    }
    let covered = MarginF32 { top: bottom - area.top(), ..MarginF32::ZERO };
    if narrow {
        MarginF32 { right: area.right() - tools.left(), ..covered }
    } else {
        MarginF32 { left: tools.right() - area.left(), ..covered }
    }
}

/// A plate over the picture that no click or drag goes through; returns where it is.
fn plate(ui: &mut Ui, name: &str, area: Rect, direction: Direction, contents: impl FnOnce(&mut Ui)) -> Rect {
    let layout = Layout::from_main_dir_and_cross_align(direction, egui::Align::Min);
    let builder =
        UiBuilder::new().id_salt(name).max_rect(area).layout(layout).sense(Sense::CLICK | Sense::DRAG);
    let viewport = ui.max_rect();
    let scope = ui.scope_builder(builder, |ui| {
        ui.set_clip_rect(viewport.intersect(ui.clip_rect()));
        let frame = Frame::new()
            .fill(theme::palette(ui.visuals()).overlay)
            .corner_radius(8)
            .stroke(ui.visuals().window_stroke)
            .inner_margin(PADDING_POINTS);
        let frame = frame.show(ui, |ui| {
            ui.spacing_mut().item_spacing = Vec2::ZERO;
            contents(ui);
        });
        frame.response.rect
    });
    scope.inner
}

fn tool_buttons(ui: &mut Ui, page: &Page<'_>, shape: Shape, out: &mut Requests) {
    for (at, group) in TOOLS.iter().enumerate() {
        if at > 0 {
            ui.add_space(GROUP_POINTS);
        }
        for tool in *group {
            tool_row(ui, page, tool, shape, out);
        }
    }
}

fn tool_row(ui: &mut Ui, page: &Page<'_>, tool: &ToolEntry, shape: Shape, out: &mut Requests) {
    let action = tool.action.for_selection(page.selecting_kind());
    let why_not = page.why_not(action);
    let name = format!("Tool: {}", tool.label);
    let on = page.is_on(action).unwrap_or_else(|| page.is_live(action));
    let button = ui.add_enabled_ui(why_not.is_none(), |ui| {
        tool_button(ui, tool.icon, (tool.label, shape.label), &name, on, shape.size)
    });
    // A finger can't hover to read why the tool is greyed: a tap says it.
    let asks = page.shown.touch && why_not.is_some() && is_tapped(ui, button.inner.rect);
    if explain(button.inner, ui, &actions::describe(action), why_not.as_deref()).clicked() || asks {
        out.act(action);
    }
}

/// Whether the visible part of a rectangle was tapped, and nothing that lies over it.
fn is_tapped(ui: &Ui, rect: Rect) -> bool {
    let tap = ui.input(|input| input.pointer.interact_pos().filter(|_| input.pointer.primary_clicked()));
    tap.is_some_and(|at| {
        rect.intersect(ui.clip_rect()).contains(at) && ui.ctx().layer_id_at(at) == Some(ui.layer_id())
    })
}

/// A switch at the top of the viewport.
struct Toggle {
    icon: Icon,
    /// Its name in the accessibility tree.
    name: &'static str,
    on: bool,
    /// What a click does.
    action: Action,
    /// What its tooltip describes.
    described: Action,
}

impl Toggle {
    fn new(page: &Page<'_>, icon: Icon, action: Action) -> Self {
        let on = page.is_on(action).unwrap_or(false);
        Self { icon, name: actions::describe(action).label, on, action, described: action }
    }
}

/// The switches for how edits behave.
fn edit_toggles(page: &Page<'_>) -> Vec<Toggle> {
    let mut toggles: Vec<Toggle> =
        EDIT_TOGGLES.iter().map(|(icon, action)| Toggle::new(page, *icon, *action)).collect();
    let symmetry = page.live_settings.symmetry;
    let on = symmetry != Symmetry::None;
    toggles.push(Toggle {
        icon: Icon::Symmetry,
        name: "Mirror edits",
        on,
        action: Action::Mirror(if on { Symmetry::None } else { Symmetry::X }),
        described: Action::Mirror(if on { symmetry } else { Symmetry::X }),
    });
    toggles
}

/// The switches for how edits behave and for how the model looks, at the right of an area. Where there is no room for all,
/// those that are off give way first.
fn toggles(ui: &mut Ui, page: &Page<'_>, room: Rect, side: f32, out: &mut Requests) {
    let looks = || TOGGLES.iter().map(|(icon, action)| Toggle::new(page, *icon, *action));
    let edits = || edit_toggles(page).into_iter();
    let width = if page.shown.touch { side } else { TOGGLE_WIDTH_POINTS };
    let ways: [Vec<Toggle>; 3] = [
        edits().chain(looks()).collect(),
        edits().filter(|toggle| toggle.on).chain(looks()).collect(),
        edits().filter(|toggle| toggle.on).collect(),
    ];
    for shown in ways {
        let left = room.right() - width * shown.len() as f32 - 2.0 * PADDING_POINTS;
        if left >= room.left() && !shown.is_empty() {
            let size = vec2(width, side);
            plate(ui, "toggles", room.with_min_x(left), Direction::LeftToRight, |ui| {
                buttons_of(ui, &shown, size, out);
            });
            return;
        }
    }
}

fn buttons_of(ui: &mut Ui, toggles: &[Toggle], size: Vec2, out: &mut Requests) {
    for toggle in toggles {
        let button = tool_button(ui, toggle.icon, ("", Label::Hidden), toggle.name, toggle.on, size);
        if explain(button, ui, &actions::describe(toggle.described), None).clicked() {
            out.act(toggle.action);
        }
    }
}

/// The kinds of elements that a click selects.
fn kind_buttons(ui: &mut Ui, page: &Page<'_>, shape: Shape, out: &mut Requests) {
    for (kind, icon, label) in KINDS {
        let action = Action::Show(kind);
        let on = page.shown.kind == kind;
        let name = format!("{label} mode");
        let button = tool_button(ui, icon, (label, shape.label), &name, on, shape.size_of(ui, label));
        if explain(button, ui, &actions::describe(action), None).clicked() {
            let expands = ui.input(|input| input.modifiers.command);
            out.act(if expands { Action::Expand(kind) } else { action });
        }
    }
    if page.shown.touch {
        ui.add_space(GROUP_POINTS);
        let entry = actions::describe(Action::AddToSelection);
        let on = page.shown.adds;
        let size = shape.size_of(ui, "Add");
        let button = tool_button(ui, Icon::Add, ("Add", shape.label), entry.label, on, size);
        if explain(button, ui, &entry, None).clicked() {
            out.act(entry.action);
        }
    }
}
