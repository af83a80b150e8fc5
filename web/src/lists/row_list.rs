//! A list of rows of equal height, exact at any number of rows.
//!
//! egui's scroll area places row `n` at `n * height` in `f32`, which is off by whole rows above about two
//! million. Here the scroll position is the index of the first visible row plus the hidden fraction of it,
//! and only the visible rows are placed, from the top of the list down.

use egui::{
    Align2, Color32, CornerRadius, EventFilter, FontId, Id, Key, Modifiers, Pos2, Rect, Response, Role,
    Sense, Stroke, StrokeKind, Ui, UiBuilder, Vec2, WidgetInfo, pos2, vec2,
};

use crate::lists::columns::{Align, Column, Row};
use crate::theme;
use crate::widgets::color_button::swatch_outline;

/// The width of the scroll bar, in points.
const BAR_WIDTH_POINTS: f32 = 10.0;

/// The key under which the focused list is remembered.
const FOCUSED: &str = "focused row list";

/// The list that last had the keyboard focus.
pub fn focused(ctx: &egui::Context) -> Option<Id> {
    ctx.data(|data| data.get_temp(Id::unique(FOCUSED)))
}

/// The scroll position and the keyboard cursor of a list, kept from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct RowListState {
    /// The first visible row, plus the hidden fraction of it. An `f64` distinguishes every pixel of up to
    /// 2^40 rows.
    pub(super) top: f64,
    /// The row from which the keyboard moves.
    cursor: Option<usize>,
    /// A row to scroll to when the list is next shown.
    reveal: Option<usize>,
    /// The speed, in rows per second, at which the list still scrolls after a flick.
    pub(super) glide: f64,
}

impl RowListState {
    /// Scrolls a row into view when the list is next shown, by no more than needed.
    pub fn reveal(&mut self, row: usize) {
        self.reveal = Some(row);
        self.cursor = Some(row);
    }

    /// The first visible row.
    pub fn first_row(&self) -> usize {
        self.top as usize
    }
}

/// How a row was picked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picked {
    /// The row.
    pub row: usize,
    /// Whether to extend the selection from the last picked row to this one.
    pub extend: bool,
    /// Whether to add this row, or to remove it if it is selected.
    pub toggle: bool,
}

/// What happened to a list in this frame.
#[derive(Debug)]
pub struct RowListOutput {
    /// The row that was clicked, or reached with the keyboard.
    pub picked: Option<Picked>,
    /// The row under the pointer.
    pub hovered: Option<usize>,
    /// The row that was clicked with the secondary button.
    pub context: Option<usize>,
    /// The visible rows, including partly visible ones.
    pub in_view: std::ops::Range<usize>,
    /// The response of the whole list, for its context menu.
    pub response: Response,
}

/// The content of a row.
pub struct RowContent {
    /// The texts and the swatch.
    pub row: Row,
    /// The name in the accessibility tree, such as "Vertex 12".
    pub name: String,
    /// The values in the accessibility tree.
    pub value: String,
    /// Whether it is selected.
    pub selected: bool,
    /// Whether it is the element under the pointer in the viewport.
    pub hovered: bool,
}

/// A list to show.
pub struct RowList<'a> {
    /// The list's name in the accessibility tree: "Vertices".
    pub label: &'a str,
    /// The columns, starting with the id.
    pub columns: &'a [Column],
    /// The number of rows.
    pub rows: usize,
    /// The height of a row, in points.
    pub row_height: f32,
}

impl RowList<'_> {
    /// Shows the list in all remaining space. Asks `content` only for visible rows.
    pub fn show(
        &self,
        ui: &mut Ui,
        state: &mut RowListState,
        mut content: impl FnMut(usize) -> Option<RowContent>,
    ) -> RowListOutput {
        let font = FontId::monospace(egui::TextStyle::Monospace.resolve(ui.style()).size);
        let char_width = ui.fonts_mut(|fonts| fonts.glyph_width(&font, '0'));
        self.header(ui, char_width);

        let outer = ui.available_rect_before_wrap();
        let id = ui.scope_id().with(("row list", self.label));
        ui.advance_cursor_after_rect(outer);
        let body = Rect::from_min_max(outer.min, pos2(outer.max.x - BAR_WIDTH_POINTS, outer.max.y));
        let bar = Rect::from_min_max(pos2(body.max.x, outer.min.y), outer.max);
        let list = ui.interact(body, id, Sense::click_and_drag());
        list.widget_info(|| WidgetInfo::labeled(Role::ListBox, ui.is_enabled(), self.label));
        ui.ctx().accesskit_node_builder(id, egui::accesskit::Node::set_multiselectable);

        let in_view = f64::from(body.height() / self.row_height).max(1.0);
        let furthest = (self.rows as f64 - in_view).max(0.0);
        let mut output = RowListOutput {
            picked: self.keyboard(ui, &list, state, in_view as usize),
            hovered: None,
            context: None,
            in_view: 0..0,
            response: list.clone(),
        };
        self.scroll(ui, &list, body, state);
        self.scroll_bar(ui, bar, id, state, in_view, furthest);
        if let Some(row) = state.reveal.take() {
            let row = row as f64;
            if row < state.top || row + 1.0 > state.top + in_view {
                // A distant row is centred; a row just out of view is scrolled to the nearest edge.
                state.top = if (row - state.top).abs() > 2.0 * in_view {
                    row - (in_view / 2.0).floor()
                } else if row < state.top {
                    row
                } else {
                    row + 1.0 - in_view
                };
            }
        }
        state.top = state.top.clamp(0.0, furthest);

        let mut rows_ui = ui.new_child(
            UiBuilder::new().id_salt(("rows", self.label)).max_rect(body).accessibility_parent(id),
        );
        rows_ui.shrink_clip_rect(body);
        let first = state.first_row();
        let hidden = (state.top - first as f64) as f32 * self.row_height;
        let mut last = first;
        for row in first..self.rows {
            let y = body.min.y - hidden + (row - first) as f32 * self.row_height;
            if y >= body.max.y {
                break;
            }
            last = row + 1;
            let Some(shown) = content(row) else { continue };
            let rect = Rect::from_min_size(pos2(body.min.x, y), vec2(body.width(), self.row_height));
            if state.cursor == Some(row) {
                let row = id.with(shown.row.id).accesskit_id();
                ui.ctx().accesskit_node_builder(id, |node| node.set_active_descendant(row));
            }
            self.row(&mut rows_ui, rect, id, row, &shown, (&font, char_width), &mut output);
        }
        output.in_view = first..last;
        if let Some(picked) = output.picked {
            state.cursor = Some(picked.row);
        }
        if list.has_focus() {
            ui.data_mut(|data| data.insert_temp(Id::unique(FOCUSED), list.id));
            ui.painter().rect_stroke(
                body.shrink(0.5),
                CornerRadius::same(2),
                Stroke::new(1.0, ui.visuals().selection.stroke.color.gamma_multiply(0.6)),
                egui::StrokeKind::Inside,
            );
        }
        output
    }

    fn header(&self, ui: &mut Ui, char_width: f32) {
        let (mut rect, _) =
            ui.allocate_exact_size(vec2(ui.available_width(), self.row_height), Sense::hover());
        let line = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().hline(rect.x_range(), rect.max.y - 0.5, line);
        // As wide as the rows, which the scroll bar stands beside.
        rect.max.x -= BAR_WIDTH_POINTS;
        let font = FontId::proportional(egui::TextStyle::Small.resolve(ui.style()).size);
        let color = ui.visuals().weak_text_color();
        for (column, cell) in self.columns.iter().zip(cells(self.columns, rect, char_width)) {
            let response = ui.interact(cell, ui.scope_id().with((self.label, column.title)), Sense::HOVER);
            response.widget_info(|| WidgetInfo::labeled(Role::ColumnHeader, true, column.title));
            response.on_hover_text(column.meaning);
            let (at, anchor) = place(cell, column.align);
            ui.painter().text(at, anchor, column.title, font.clone(), color);
        }
    }

    #[allow(clippy::too_many_arguments)]
    fn row(
        &self,
        ui: &mut Ui,
        rect: Rect,
        list: Id,
        row: usize,
        shown: &RowContent,
        (font, char_width): (&FontId, f32),
        output: &mut RowListOutput,
    ) {
        // Not focusable: the list as a whole has the keyboard focus.
        let response = ui.interact(rect, list.with(shown.row.id), Sense::CLICK);
        response.widget_info(|| {
            WidgetInfo::selected(Role::ListBoxOption, ui.is_enabled(), shown.selected, &shown.name)
        });
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_value(shown.value.as_str());
            node.set_selected(shown.selected);
            node.set_position_in_set(row + 1);
            node.set_size_of_set(self.rows);
        });
        if response.hovered() {
            output.hovered = Some(row);
        }
        if response.clicked() {
            let modifiers = ui.input(|i| i.modifiers);
            output.picked = Some(Picked { row, extend: modifiers.shift, toggle: modifiers.command });
            ui.memory_mut(|memory| memory.request_focus(list));
        }
        if response.secondary_clicked() {
            output.context = Some(row);
        }
        output.response |= response.clone();

        let visuals = ui.visuals();
        let palette = theme::palette(visuals);
        let fill = if shown.selected {
            Some(palette.selected_row)
        } else if shown.hovered || response.hovered() {
            Some(palette.hovered_row)
        } else if row % 2 == 1 {
            Some(visuals.faint_bg_color)
        } else {
            None
        };
        if let Some(fill) = fill {
            ui.painter().rect_filled(rect, CornerRadius::ZERO, fill);
        }
        let strong = if shown.selected { palette.selected_text } else { visuals.text_color() };
        let weak = if shown.selected { strong } else { visuals.weak_text_color() };
        for (at, ((column, cell), text)) in
            self.columns.iter().zip(cells(self.columns, rect, char_width)).zip(&shown.row.cells).enumerate()
        {
            let painter = ui.painter().with_clip_rect(cell.intersect(ui.clip_rect()));
            let mut cell = cell;
            if let (0, Some(color)) = (at, shown.row.swatch) {
                let [r, g, b] = color.0;
                let swatch =
                    Rect::from_center_size(pos2(rect.min.x + 12.0, rect.center().y), Vec2::splat(10.0));
                let outline = swatch_outline(ui.visuals());
                let fill = Color32::from_rgb(r, g, b);
                painter.rect(swatch, CornerRadius::same(2), fill, outline, StrokeKind::Inside);
                cell.min.x = swatch.max.x;
            }
            let (position, anchor) = place(cell, column.align);
            painter.text(position, anchor, text, font.clone(), if at == 0 { weak } else { strong });
        }
    }

    fn keyboard(&self, ui: &Ui, list: &Response, state: &mut RowListState, page: usize) -> Option<Picked> {
        if !list.has_focus() || self.rows == 0 {
            return None;
        }
        let filter = EventFilter { vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(list.id, filter));
        let last = self.rows - 1;
        let page = page.saturating_sub(1).max(1);
        let at = state.cursor.map(|row| row.min(last));
        let mut moved = None;
        ui.input_mut(|input| {
            // With Shift first: without it, a pattern matches either way.
            for extend in [true, false] {
                let modifiers = if extend { Modifiers::SHIFT } else { Modifiers::NONE };
                let mut pressed = |key| input.count_and_consume_key(modifiers, key);
                let (up, down) = (pressed(Key::ArrowUp), pressed(Key::ArrowDown));
                let (page_up, page_down) = (pressed(Key::PageUp) * page, pressed(Key::PageDown) * page);
                let (home, end) = (pressed(Key::Home), pressed(Key::End));
                let mut to = at;
                if up + page_up > 0 {
                    to = Some(at.unwrap_or(0).saturating_sub(up + page_up));
                }
                if down + page_down > 0 {
                    // With no cursor yet, the first step down goes to the first row.
                    to = Some(at.map_or(0, |row| row + down + page_down).min(last));
                }
                if home > 0 {
                    to = Some(0);
                }
                if end > 0 {
                    to = Some(last);
                }
                if let Some(row) = to.filter(|_| up + down + page_up + page_down + home + end > 0) {
                    moved = Some(Picked { row, extend, toggle: false });
                }
            }
        });
        if let Some(picked) = moved {
            state.reveal = Some(picked.row);
        }
        moved
    }
}

/// The cells of a row.
fn cells(columns: &[Column], row: Rect, char_width: f32) -> impl Iterator<Item = Rect> {
    let mut x = row.min.x;
    let count = columns.len();
    // In a wide panel all columns grow, so that no space is left at the end.
    let wanted: f32 = columns.iter().map(|c| c.chars * char_width).sum();
    let right = row.max.x - 6.0;
    let stretch = ((right - row.min.x) / wanted.max(1.0)).clamp(0.8, 1.6);
    columns.iter().enumerate().map(move |(at, column)| {
        let left = x;
        x = if at + 1 == count && column.align == Align::Left {
            right
        } else {
            x + column.chars * char_width * stretch
        };
        Rect::from_min_max(pos2(left, row.min.y), pos2(x.min(right), row.max.y))
    })
}

fn place(cell: Rect, align: Align) -> (Pos2, Align2) {
    match align {
        Align::Right => (cell.right_center(), Align2::RIGHT_CENTER),
        Align::Left => (cell.left_center() + vec2(10.0, 0.0), Align2::LEFT_CENTER),
    }
}
