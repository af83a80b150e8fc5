//! The welcome view: what to start from, over the lower part of the viewport, so that the model above it can be seen
//! and clicked. It blocks nothing and goes away with the first action.

pub(crate) mod picture;
mod samples;

use std::collections::HashMap;

use egui::{
    Align, Align2, Area, Checkbox, Color32, ColorImage, Context, Event, Frame, Id, Key, Label, Layout,
    Margin, Order, Rect, RichText, Role, ScrollArea, Sense, StrokeKind, TextStyle, TextureHandle,
    TextureOptions, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use crate::input::actions::Action;
use crate::input::keys;
use crate::page_view::Page;
use crate::panels::documents::{Documents, MAX_TILES, recent, tiles};
use crate::panels::shortcuts::key_presets;
use crate::platform::Platform;
use crate::request::{Request, Requests};
use crate::widgets::controls::primary_button;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use picture::Figure;
pub(crate) use samples::Sample;
use samples::{SAMPLES, SHAPES, shape_figure, shape_name};

/// The key of the setting that keeps the welcome view away when the page opens.
pub(crate) const WELCOME_SETTING: &str = "welcome";
const OFF: &str = "off";

/// The pictures of the tiles, and the space that the view takes.
pub(crate) struct Welcome {
    pictures: HashMap<&'static str, TextureHandle>,
    /// The height of the lower part of the viewport that the view covers, in points.
    pub covers: f32,
    /// Whether it is shown when the page opens.
    pub at_start: bool,
}

/// The widest that the view gets.
const MAX_WIDTH: f32 = 760.0;
/// Below this width or height of the viewport the tiles are a strip.
const MIN_WIDTH_OF_GRID: f32 = 560.0;
const MIN_HEIGHT_OF_GRID: f32 = 600.0;
/// The distance from the viewport's edges.
const DISTANCE: f32 = 16.0;
const GAP: f32 = 8.0;
const LABEL_HEIGHT: f32 = 24.0;
/// Narrower tiles show their picture without a label, which would be too small to read.
const MIN_LABELLED_WIDTH: f32 = 44.0;
/// The heights of the pictures of tiles.
const SAMPLE_HEIGHT: f32 = 84.0;
const SHAPE_HEIGHT: f32 = 40.0;
/// The largest text size of a label, as a share of its tile's width: the longest name fits.
const LABEL_PER_TILE_WIDTH: f32 = 0.2;

/// Whether the keys of this frame dismiss the view: any key but those that move the focus or press what has it.
pub(crate) fn is_dismissed_by_key(ctx: &Context) -> bool {
    let is_theirs = ctx.memory(|memory| memory.focused().is_some());
    !is_theirs
        && ctx.input(|input| {
            input
                .events
                .iter()
                .any(|event| matches!(event, Event::Key { key, pressed: true, .. } if *key != Key::Tab))
        })
}

pub(crate) fn show(
    ctx: &Context,
    page: &Page<'_>,
    own: &mut Welcome,
    documents: &mut Documents,
    out: &mut Requests,
) {
    if !page.shown.welcome {
        own.covers = 0.0;
        return;
    }
    let viewport = page.view.area;
    // Beside the tools.
    let beside = page.view.free_area();
    let is_grid = beside.width() >= MIN_WIDTH_OF_GRID && viewport.height() >= MIN_HEIGHT_OF_GRID;
    let distance = if is_grid { DISTANCE } else { GAP };
    let width = (beside.width() - 2.0 * distance).min(MAX_WIDTH);
    if width < 120.0 {
        return;
    }
    let margin = if is_grid { 16 } else { 8 };
    let shown = Area::new(Id::unique("welcome"))
        .order(Order::Middle)
        .pivot(Align2::CENTER_BOTTOM)
        .fixed_pos(beside.center_bottom() - vec2(0.0, distance))
        .show(ctx, |ui| {
            let frame = Frame::window(ui.style()).corner_radius(12).inner_margin(Margin::same(margin));
            frame.show(ui, |ui| {
                ui.set_width(width - 2.0 * f32::from(margin));
                ui.spacing_mut().item_spacing = vec2(GAP, GAP);
                header(ui, is_grid, out);
                if is_grid {
                    samples(ui, own, out);
                    shapes_and_documents(ui, page, own, documents, out);
                    footer(ui, page, own, out);
                } else {
                    strip(ui, own, out);
                }
            });
        });
    let card = shown.response.rect;
    own.covers = viewport.bottom() - card.top();
    let pressed = ctx.input(|input| {
        let pressed = input.pointer.any_pressed();
        input.pointer.interact_pos().filter(|_| pressed)
    });
    let is_on_model = |at| viewport.contains(at) && !card.contains(at) && !egui::Popup::is_any_open(ctx);
    if pressed.is_some_and(is_on_model) {
        out.push(Request::CloseWelcome);
    }
}

fn header(ui: &mut Ui, is_grid: bool, out: &mut Requests) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("Start from").heading());
        if is_grid {
            ui.label(RichText::new("a sample, a shape, or a file dropped on the page").weak());
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let close = icon_button(ui, Icon::Close, "Close welcome", false);
            if close.on_hover_text("Close; Help > Welcome shows it again").clicked() {
                out.push(Request::CloseWelcome);
            }
            let open = ui.add(
                primary_button(ui, "Open file…").min_size(vec2(0.0, ui.spacing().interact_size.y.max(28.0))),
            );
            let hint = keys::tooltip(ui.ctx(), "Open a file from this computer", Action::Open);
            if open.on_hover_text(hint).clicked() {
                out.act(Action::Open);
            }
        });
    });
}

/// The width of each of so many tiles in a row.
fn tile_width(ui: &Ui, count: usize) -> f32 {
    (ui.available_width() - GAP * (count as f32 - 1.0)) / count as f32
}

/// Large tiles of the samples.
fn samples(ui: &mut Ui, own: &mut Welcome, out: &mut Requests) {
    ui.horizontal(|ui| {
        let width = tile_width(ui, SAMPLES.len());
        for sample in SAMPLES {
            sample_tile(ui, own, sample, vec2(width, SAMPLE_HEIGHT), out);
        }
    });
}

/// Small tiles of the shapes, with the last documents beside them: below them, the view would cover the model.
fn shapes_and_documents(
    ui: &mut Ui,
    page: &Page<'_>,
    own: &mut Welcome,
    documents: &mut Documents,
    out: &mut Requests,
) {
    let recent = recent(page, documents, out);
    if recent.is_empty() {
        return shapes(ui, own, out);
    }
    let label = |ui: &mut Ui, text: &str| ui.label(RichText::new(text).small().weak());
    ui.columns_const(|[left, right]| {
        label(left, "Shapes");
        shapes(left, own, out);
        label(right, "Recent documents");
        let size = vec2(tile_width(right, MAX_TILES), SHAPE_HEIGHT + LABEL_HEIGHT);
        tiles(right, page, documents, recent, size, out);
    });
}

fn shapes(ui: &mut Ui, own: &mut Welcome, out: &mut Requests) {
    ui.horizontal(|ui| {
        let width = tile_width(ui, SHAPES.len());
        for name in SHAPES {
            shape_tile(ui, own, name, vec2(width, SHAPE_HEIGHT), out);
        }
    });
}

/// The least width of a tile in a row that scrolls, in points.
const MIN_STRIP_TILE: f32 = 80.0;

/// All tiles in a row that scrolls.
fn strip(ui: &mut Ui, own: &mut Welcome, out: &mut Requests) {
    // The last tile in sight is cut in half, which shows that the row goes on.
    let whole = ((ui.available_width() + GAP) / (MIN_STRIP_TILE + GAP) - 0.5).floor().max(1.0);
    let size = vec2((ui.available_width() - whole * GAP) / (whole + 0.5), 56.0);
    ScrollArea::horizontal().id_salt("welcome strip").auto_shrink([false, true]).show(ui, |ui| {
        ui.horizontal(|ui| {
            for sample in SAMPLES {
                sample_tile(ui, own, sample, size, out);
            }
            for name in SHAPES {
                shape_tile(ui, own, name, size, out);
            }
        });
    });
}

/// The row below the tiles: choices for every visit.
fn footer(ui: &mut Ui, page: &Page<'_>, own: &mut Welcome, out: &mut Requests) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("Keys").small().weak())
            .on_hover_text("The keys and mouse buttons to use; change them later in Edit > Keys");
        key_presets(ui, page.key_preset(), out);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let mut at_start = own.at_start;
            let check = ui.add(Checkbox::new(&mut at_start, RichText::new("Show at start").small()));
            if check.on_hover_text("Show this when the page opens").changed() {
                out.push(Request::WelcomeAtStart(at_start));
            }
            let hint = RichText::new("Click the model or press any key to begin").small().weak();
            ui.add(Label::new(hint).truncate());
        });
    });
}

fn sample_tile(ui: &mut Ui, own: &mut Welcome, sample: Sample, size: Vec2, out: &mut Requests) {
    let hint = format!("{} Opens as a new document.", sample.description);
    let tile = Tile { key: sample.name, label: sample.name.to_owned(), hint, size };
    if tile.show(ui, own, || sample.figure()) {
        out.push(Request::OpenSample(sample));
    }
}

fn shape_tile(ui: &mut Ui, own: &mut Welcome, name: &'static str, size: Vec2, out: &mut Requests) {
    let label = shape_name(name);
    let hint = "Start a new document with this shape.".to_owned();
    let tile = Tile { key: name, label, hint, size };
    if tile.show(ui, own, || shape_figure(name)) {
        out.push(Request::StartWithShape(name));
    }
}

/// A button with a picture above its name.
struct Tile {
    /// What the picture is kept under.
    key: &'static str,
    label: String,
    hint: String,
    /// The size of the part with the picture.
    size: Vec2,
}

impl Tile {
    /// Shows the tile; returns whether it was clicked.
    fn show(self, ui: &mut Ui, own: &mut Welcome, figure: impl FnOnce() -> Figure) -> bool {
        let (rect, response) = ui.allocate_exact_size(self.size + vec2(0.0, LABEL_HEIGHT), Sense::click());
        let name = format!("Start with {}", self.label);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        if ui.is_rect_visible(rect) {
            let visuals = ui.style().interact(&response);
            let fill = if response.hovered() { visuals.weak_bg_fill } else { ui.visuals().faint_bg_color };
            ui.painter().rect(rect, 8.0, fill, visuals.bg_stroke, StrokeKind::Inside);
            let is_labelled = self.size.x >= MIN_LABELLED_WIDTH;
            let room = if is_labelled { Rect::from_min_size(rect.min, self.size) } else { rect };
            let picture = room.shrink2(vec2(if is_labelled { 4.0 } else { 2.0 }, 2.0));
            if let Some(texture) = own.picture(ui, self.key, figure, picture) {
                let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
                ui.painter().image(texture.id(), picture, all, Color32::WHITE);
            }
            let at = rect.center_bottom() - vec2(0.0, LABEL_HEIGHT / 2.0 + 1.0);
            let mut font = TextStyle::Body.resolve(ui.style());
            font.size = font.size.min(self.size.x * LABEL_PER_TILE_WIDTH);
            if is_labelled {
                ui.painter().text(at, Align2::CENTER_CENTER, &self.label, font, visuals.text_color());
            }
        }
        response.on_hover_text(format!("{}. {}", self.label, self.hint)).clicked()
    }
}

impl Welcome {
    pub fn new(platform: &dyn Platform) -> Self {
        let at_start = platform.load_setting(WELCOME_SETTING).as_deref() != Some(OFF);
        Self { pictures: HashMap::new(), covers: 0.0, at_start }
    }

    /// Whether it is shown when the page opens, as the setting has it.
    pub fn setting(&self) -> &'static str {
        if self.at_start { "on" } else { OFF }
    }

    /// Forgets the pictures on the graphics device.
    pub fn forget_pictures(&mut self) {
        self.pictures.clear();
    }

    /// The picture of a tile. It is drawn when the tile is first seen, one in each frame.
    fn picture(
        &mut self,
        ui: &Ui,
        key: &'static str,
        figure: impl FnOnce() -> Figure,
        at: Rect,
    ) -> Option<TextureHandle> {
        let scale = ui.ctx().pixels_per_point();
        let size = [at.width(), at.height()].map(|points| (points * scale).round().max(1.0) as usize);
        let known = self.pictures.get(key).filter(|texture| texture.size() == size);
        if let Some(texture) = known {
            return Some(texture.clone());
        }
        let frame = ui.ctx().cumulative_frame_nr();
        let last = Id::unique("welcome picture");
        if ui.data(|data| data.get_temp::<u64>(last)) == Some(frame) {
            ui.ctx().request_repaint();
            return self.pictures.get(key).cloned();
        }
        ui.data_mut(|data| data.insert_temp(last, frame));
        let bytes = picture::draw(&figure(), size[0], size[1]);
        let image = ColorImage::from_rgba_premultiplied(size, &bytes);
        let texture = ui.ctx().load_texture(key, image, TextureOptions::LINEAR);
        self.pictures.insert(key, texture.clone());
        ui.ctx().request_repaint();
        Some(texture)
    }
}
