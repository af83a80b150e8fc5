//! The history: every edit by name, those that were undone below the current one. A click on a step goes there.

use editor::{Changes, Editor, Jump};
use egui::collapsing_header::paint_default_icon;
use egui::{
    Align2, Color32, EventFilter, Key, Label, Modifiers, Panel, Rect, Response, RichText, Role, ScrollArea,
    Sense, Stroke, TextStyle, Ui, UiBuilder, WidgetInfo, pos2, style::ScrollAnimation, vec2,
};

use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::panels::menu_bar::explain;
use crate::request::{Request, Requests};
use crate::theme;

/// The least height of a row with a mouse, in points.
const MIN_ROW_HEIGHT_POINTS: f32 = 24.0;
/// The least height of the open panel, in points.
const MIN_HEIGHT_POINTS: f32 = 96.0;
/// The largest share of the column's height that the panel takes.
const MAX_SHARE_OF_COLUMN: f32 = 0.6;
/// From the left edge of a row to the dots of the steps, in points.
const DOTS_FROM_LEFT_POINTS: f32 = 14.0;
const DOT_RADIUS_POINTS: f32 = 3.5;
const CURRENT_DOT_RADIUS_POINTS: f32 = 5.0;

/// The names of the steps, and how the panel shows them.
#[derive(Default)]
pub(crate) struct HistoryList {
    /// The edits, the oldest first; those that can be redone are last.
    names: Vec<String>,
    /// How many of them are done.
    done: usize,
    /// Whether the first one was made on the document that the page began with.
    is_whole: bool,
    /// The panel's height in points, once it was open.
    pub height: Option<f32>,
    /// Whether the current step has to be scrolled into view.
    reveals: bool,
}

/// Where a step is in time.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Time {
    Done,
    Current,
    Undone,
}

impl HistoryList {
    /// Updates the names to the history.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) {
        if !changes.history {
            return;
        }
        self.names.clear();
        self.names.extend(editor.undo_labels().map(str::to_owned));
        let done = self.names.len();
        let mut undone: Vec<&str> = editor.redo_labels().collect();
        undone.reverse();
        self.names.extend(undone.into_iter().map(str::to_owned));
        self.reveals |= done != self.done;
        (self.done, self.is_whole) = (done, editor.has_whole_history());
    }

    /// The panel at the bottom of a column: its header, and the list if it is open.
    pub fn show(&mut self, ui: &mut Ui, page: &Page<'_>, height: f32, out: &mut Requests) {
        let most = (ui.available_height() * MAX_SHARE_OF_COLUMN).max(MIN_HEIGHT_POINTS);
        let frame = egui::Frame::new();
        let open = page.shown.shows_history();
        if open {
            let panel = Panel::bottom("history").frame(frame).resizable(true);
            let panel = panel.default_size(height.min(most)).size_range(MIN_HEIGHT_POINTS..=most);
            let shown = panel.show(ui, |ui| {
                ui.add_space(4.0);
                self.header(ui, open, out);
                self.list(ui, page, out);
            });
            self.height = Some(shown.response.rect.height().round());
        } else {
            Panel::bottom("closed history").frame(frame).resizable(false).show(ui, |ui| {
                ui.add_space(4.0);
                self.header(ui, open, out);
            });
        }
    }

    fn header(&self, ui: &mut Ui, open: bool, out: &mut Requests) {
        let height = ui.spacing().interact_size.y.max(MIN_ROW_HEIGHT_POINTS);
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "History panel"));
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_expanded(open));
        let icon = response.clone().with_new_rect(Rect::from_center_size(
            pos2(rect.left() + 8.0, rect.center().y),
            vec2(10.0, 10.0),
        ));
        paint_default_icon(ui, if open { 1.0 } else { 0.0 }, &icon);
        let font = TextStyle::Body.resolve(ui.style());
        let at = pos2(rect.left() + 20.0, rect.center().y);
        let strong = ui.visuals().strong_text_color();
        ui.painter().text(at, Align2::LEFT_CENTER, "History", font, strong);
        let undone = self.names.len() - self.done;
        let count = match (self.done, undone) {
            (0, 0) => String::new(),
            (done, 0) => done.to_string(),
            (done, _) => format!("{done} of {}", self.names.len()),
        };
        let small = TextStyle::Small.resolve(ui.style());
        let at = pos2(rect.right() - 4.0, rect.center().y);
        ui.painter().text(at, Align2::RIGHT_CENTER, count, small, ui.visuals().weak_text_color());
        if explain(response, ui, &actions::describe(Action::History), None).clicked() {
            out.act(Action::History);
        }
    }

    /// The steps in all remaining space, the oldest first. Only visible rows are laid out.
    pub fn list(&mut self, ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
        let body = ui.available_rect_before_wrap();
        let id = ui.scope_id().with("history list");
        let list = ui.interact(body, id, Sense::click());
        list.widget_info(|| WidgetInfo::labeled(Role::ListBox, true, "Steps"));
        if let Some(to) = self.keyboard(ui, &list, page.editor.jump()) {
            out.push(Request::JumpTo(to));
        }
        let height = ui.spacing().interact_size.y.max(MIN_ROW_HEIGHT_POINTS);
        let rows = self.names.len() + 1;
        let reveals = std::mem::take(&mut self.reveals);
        let area = ScrollArea::vertical().id_salt("steps").auto_shrink([false, false]);
        let builder = UiBuilder::new().max_rect(body).accessibility_parent(id);
        ui.scope_builder(builder, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            area.show_rows(ui, height, rows, |ui, range| {
                if reveals {
                    let first = ui.max_rect().with_max_y(ui.max_rect().top() + height);
                    let rows_below = self.done as f32 - range.start as f32;
                    let current = first.translate(vec2(0.0, rows_below * height));
                    ui.scroll_to_rect_animation(current, None, ScrollAnimation::none());
                }
                for at in range {
                    self.row(ui, at, height, &list, out);
                }
            });
        });
        if self.names.is_empty() {
            let below = body.with_min_y(body.top() + height + 4.0).shrink2(vec2(8.0, 0.0));
            let hint = if page.shown.touch {
                "Each edit becomes a step here. Tap a step to go back to it."
            } else {
                "Each edit becomes a step here. Click a step to go back to it."
            };
            ui.scope_builder(UiBuilder::new().max_rect(below), |ui| {
                ui.add(Label::new(RichText::new(hint).small().weak()).wrap().selectable(false));
            });
        }
    }

    /// The name of the state after this many edits.
    fn name(&self, at: usize) -> &str {
        match at.checked_sub(1) {
            Some(edit) => self.names.get(edit).map_or("", String::as_str),
            None if self.is_whole => "New document",
            None => "Earlier steps, dropped to save memory",
        }
    }

    fn row(&self, ui: &mut Ui, at: usize, height: f32, list: &Response, out: &mut Requests) {
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
        // Not focusable: the list as a whole has the keyboard focus.
        let response = ui.interact(rect, list.id.with(at), Sense::CLICK);
        let name = if at == 0 {
            format!("Start: {}", self.name(at))
        } else {
            format!("Step {at}: {}", self.name(at))
        };
        let (time, tooltip) = match at.cmp(&self.done) {
            std::cmp::Ordering::Less => (Time::Done, "Go back to this step"),
            std::cmp::Ordering::Equal => (Time::Current, "The current step"),
            std::cmp::Ordering::Greater => (Time::Undone, "Undone: redo up to this step"),
        };
        let is_current = time == Time::Current;
        response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, is_current, &name));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_selected(is_current);
            node.set_position_in_set(at + 1);
            node.set_size_of_set(self.names.len() + 1);
            if time == Time::Undone {
                node.set_value("undone");
            }
        });
        if response.clicked() {
            ui.memory_mut(|memory| memory.request_focus(list.id));
            out.push(Request::JumpTo(at));
        }
        self.paint_row(ui, rect, at, time, response.hovered());
        response.on_hover_text(tooltip);
    }

    /// A step as a dot on a line through all of them: filled once it is done.
    fn paint_row(&self, ui: &Ui, rect: Rect, at: usize, time: Time, hovered: bool) {
        let palette = theme::palette(ui.visuals());
        let fill = if time == Time::Current {
            palette.selected_row
        } else if hovered {
            palette.hovered_row
        } else {
            Color32::TRANSPARENT
        };
        let painter = ui.painter();
        painter.rect_filled(rect, 4.0, fill);
        let (weak, text) = (ui.visuals().weak_text_color(), ui.visuals().text_color());
        let middle = pos2(rect.left() + DOTS_FROM_LEFT_POINTS, rect.center().y);
        let line = |color: Color32| Stroke::new(1.5, color);
        let faint = weak.gamma_multiply(0.45);
        if at > 0 {
            let color = if time == Time::Undone { faint } else { weak };
            painter.vline(middle.x, rect.top()..=middle.y, line(color));
        }
        if at < self.names.len() {
            let color = if time == Time::Done { weak } else { faint };
            painter.vline(middle.x, middle.y..=rect.bottom(), line(color));
        }
        let back = if fill == Color32::TRANSPARENT { ui.visuals().panel_fill } else { fill };
        let color = match time {
            Time::Done => {
                painter.circle_filled(middle, DOT_RADIUS_POINTS, weak);
                text
            }
            Time::Current => {
                painter.circle_filled(middle, CURRENT_DOT_RADIUS_POINTS, palette.selected_text);
                palette.selected_text
            }
            Time::Undone => {
                painter.circle(middle, DOT_RADIUS_POINTS, back, line(weak));
                weak
            }
        };
        let room = rect.with_min_x(middle.x + 14.0).with_max_x(rect.right() - 6.0);
        let font = TextStyle::Body.resolve(ui.style());
        painter.with_clip_rect(room.intersect(ui.clip_rect())).text(
            room.left_center(),
            Align2::LEFT_CENTER,
            self.name(at),
            font,
            color,
        );
    }

    /// Where the keys of the focused list go.
    fn keyboard(&self, ui: &Ui, list: &Response, jump: Option<Jump>) -> Option<usize> {
        if !list.has_focus() {
            return None;
        }
        let filter = EventFilter { vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(list.id, filter));
        // In the middle of a jump, from where it leads.
        let at = match jump {
            Some(jump) if jump.back => self.done.saturating_sub(jump.left),
            jump => self.done + jump.map_or(0, |jump| jump.left),
        };
        let to = ui.input_mut(|input| {
            let mut pressed = |key| input.count_and_consume_key(Modifiers::NONE, key);
            let (up, down) = (pressed(Key::ArrowUp), pressed(Key::ArrowDown));
            if pressed(Key::Home) > 0 {
                return 0;
            }
            if pressed(Key::End) > 0 {
                return self.names.len();
            }
            (at + down).saturating_sub(up).min(self.names.len())
        });
        (to != at).then_some(to)
    }
}
