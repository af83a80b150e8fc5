//! The window with the documents that the browser keeps.

use std::collections::HashMap;

use egui::{
    Align, Align2, Button, Color32, ColorImage, Context, Key, Layout, Rect, RichText, Role, ScrollArea,
    Sense, StrokeKind, TextEdit, TextStyle, TextWrapMode, TextureHandle, TextureOptions, Ui, Vec2,
    WidgetInfo, WidgetText, pos2, vec2,
};
use halfedge::words::{counted, thousands};
use meshwright_worker::store::{Id, Kept};

use crate::keeping::{OfDocument, Thumbnail};
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use crate::widgets::window::centred;

/// The pictures, and what is being typed.
#[derive(Default)]
pub(crate) struct Documents {
    /// The version of the list that the pictures are of.
    version: u64,
    pictures: HashMap<Id, TextureHandle>,
    /// The document that is being renamed, and the text so far.
    renaming: Option<(Id, String)>,
    /// Whether the list was asked for without its window.
    has_asked: bool,
}

const PICTURE_SIZE: Vec2 = vec2(84.0, 56.0);

/// The tiles of documents in the welcome view.
pub(crate) const MAX_TILES: usize = 3;
const LABEL_HEIGHT: f32 = 22.0;

pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut Documents, out: &mut Requests) {
    let mut open = page.shown.documents;
    let screen = ctx.content_rect();
    centred(ctx, "Recent documents")
        .open(&mut open)
        .default_width(520.0_f32.min(screen.width() - 32.0))
        .show(ctx, |ui| match &page.documents.documents {
            None => {
                ui.label(RichText::new("Reading the list…").weak());
            }
            Some(documents) if documents.is_empty() => {
                let text = "No documents are kept yet. What you open or change is kept by itself, until you delete it.";
                ui.label(RichText::new(text).weak());
            }
            Some(documents) => list(ui, page, documents, own, out),
        });
    if !open && page.shown.documents {
        out.push(Request::Close(crate::shown::Window::Documents));
    }
}

/// The last documents, which the welcome view offers; none if nothing is kept.
pub(crate) fn recent<'a>(page: &'a Page<'_>, own: &mut Documents, out: &mut Requests) -> Vec<&'a Kept> {
    let Some(documents) = &page.documents.documents else {
        if !std::mem::replace(&mut own.has_asked, true) {
            out.push(Request::Document(OfDocument::Refresh));
        }
        return Vec::new();
    };
    documents.iter().filter(|kept| why_not_open(page, kept).is_none()).take(MAX_TILES).collect()
}

/// Shows tiles of documents in a row, of this size.
pub(crate) fn tiles(
    ui: &mut Ui,
    page: &Page<'_>,
    own: &mut Documents,
    shown: Vec<&Kept>,
    size: Vec2,
    out: &mut Requests,
) {
    ui.horizontal(|ui| {
        for kept in shown {
            let name = kept.info.shown_name();
            let (rect, tile) = ui.allocate_exact_size(size, Sense::click());
            tile.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("Open {name}")));
            let visuals = ui.style().interact(&tile);
            let fill = if tile.hovered() { visuals.weak_bg_fill } else { ui.visuals().faint_bg_color };
            ui.painter().rect(rect, 8.0, fill, visuals.bg_stroke, StrokeKind::Inside);
            let room = rect.with_max_y(rect.bottom() - LABEL_HEIGHT).shrink(3.0);
            let picture = Align2::CENTER_CENTER
                .align_size_within_rect(PICTURE_SIZE * (room.height() / PICTURE_SIZE.y), room);
            own.paint(ui, page, kept, picture);
            let label = rect.with_min_y(rect.bottom() - LABEL_HEIGHT).shrink2(vec2(6.0, 2.0));
            // Painted, since `ui.put` would also move the next tile closer.
            let text = WidgetText::from(RichText::new(name).small());
            let text = text.into_galley(ui, Some(TextWrapMode::Truncate), label.width(), TextStyle::Small);
            let at = Align2::CENTER_CENTER.align_size_within_rect(text.size(), label).min;
            ui.painter().galley(at, text, visuals.text_color());
            let changed = about(kept, page.platform.date_ms());
            if tile.on_hover_text(format!("{name}: {changed}")).clicked() {
                out.push(Request::Document(OfDocument::Open(kept.id.clone())));
            }
        }
    });
}

fn list(ui: &mut Ui, page: &Page<'_>, documents: &[Kept], own: &mut Documents, out: &mut Requests) {
    let height = (ui.ctx().content_rect().height() - 180.0).clamp(120.0, 420.0);
    ScrollArea::vertical().max_height(height).auto_shrink([false, true]).show(ui, |ui| {
        for kept in documents {
            ui.push_id(&kept.id, |ui| row(ui, page, kept, own, out));
        }
    });
    ui.separator();
    let bytes: u64 = documents.iter().map(|kept| kept.bytes).sum();
    let take = if documents.len() == 1 { "takes" } else { "take" };
    let text = format!(
        "{} {take} {} of storage. Save important ones to files as well.",
        counted(documents.len(), "document", "documents"),
        size(bytes)
    );
    ui.label(RichText::new(text).small().weak());
}

fn row(ui: &mut Ui, page: &Page<'_>, kept: &Kept, own: &mut Documents, out: &mut Requests) {
    let name = kept.info.shown_name().to_owned();
    let why_not = why_not_open(page, kept);
    ui.horizontal(|ui| {
        let (rect, picture) = ui.allocate_exact_size(PICTURE_SIZE, Sense::click());
        ui.painter().rect_filled(rect, 6.0, ui.visuals().faint_bg_color);
        own.paint(ui, page, kept, rect);
        let opens =
            picture.on_hover_text(why_not.clone().unwrap_or_else(|| format!("Open {name}"))).clicked();
        if opens && why_not.is_none() {
            out.push(Request::Document(OfDocument::Open(kept.id.clone())));
        }
        ui.vertical(|ui| {
            name_field(ui, kept, &name, own, out);
            ui.label(RichText::new(about(kept, page.platform.date_ms())).small().weak());
        });
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let delete = ui.add_enabled_ui(!kept.is_open, |ui| {
                icon_button(ui, Icon::Delete, &format!("Delete {name}"), false)
            });
            let delete = delete.inner.on_hover_text("Delete this document");
            if delete.on_disabled_hover_text("It is open. Open another document first.").clicked() {
                out.push(Request::Document(OfDocument::Delete(kept.id.clone(), name.clone())));
            }
            let copy = ui.button("Duplicate").accessible_name(format!("Duplicate {name}"));
            if copy.on_hover_text("Make a copy of this document").clicked() {
                out.push(Request::Document(OfDocument::Duplicate(kept.id.clone(), format!("{name} copy"))));
            }
            let open = ui.add_enabled(why_not.is_none(), Button::new("Open"));
            let open = open
                .accessible_name(format!("Open document {name}"))
                .on_hover_text(format!("Open {name} instead of the current document, which is kept"));
            if open.on_disabled_hover_text(why_not.unwrap_or_default()).clicked() {
                out.push(Request::Document(OfDocument::Open(kept.id.clone())));
            }
        });
    });
    ui.add_space(4.0);
}

/// The name, which can be typed over.
fn name_field(ui: &mut Ui, kept: &Kept, name: &str, own: &mut Documents, out: &mut Requests) {
    let mut text = match &own.renaming {
        Some((id, text)) if *id == kept.id => text.clone(),
        _ => name.to_owned(),
    };
    let width = (ui.available_width() - 150.0).clamp(90.0, 240.0);
    let field = ui
        .add(TextEdit::singleline(&mut text).desired_width(width))
        .accessible_name(format!("Name of {name}"))
        .on_hover_text("Type another name and press Enter");
    if field.changed() {
        own.renaming = Some((kept.id.clone(), text.clone()));
    }
    if field.lost_focus() && own.renaming.take().is_some() {
        let is_wanted = ui.input(|input| !input.key_pressed(Key::Escape));
        if is_wanted && !text.trim().is_empty() && text.trim() != name {
            out.push(Request::Document(OfDocument::Rename(kept.id.clone(), text.trim().to_owned())));
        }
    }
}

/// Why a document can't be opened now.
fn why_not_open(page: &Page<'_>, kept: &Kept) -> Option<String> {
    if page.jobs.iter().next().is_some() {
        return Some("Wait for the running job, or cancel it.".to_owned());
    }
    let is_here = page.documents.shown.as_ref() == Some(&kept.id);
    is_here.then(|| "It is open here.".to_owned())
}

impl Documents {
    /// Forgets the pictures on the graphics device.
    pub fn forget_pictures(&mut self) {
        self.pictures.clear();
    }

    /// Paints the picture of a document.
    fn paint(&mut self, ui: &Ui, page: &Page<'_>, kept: &Kept, rect: Rect) {
        if std::mem::replace(&mut self.version, page.documents.version) != page.documents.version {
            self.pictures.clear();
        }
        let texture = match self.pictures.get(&kept.id) {
            Some(texture) => Some(texture.clone()),
            None => Thumbnail::from_bytes(&kept.picture).map(|picture| {
                let image = ColorImage::from_rgba_premultiplied(picture.size, &picture.pixels);
                let texture = ui.ctx().load_texture(&kept.id, image, TextureOptions::LINEAR);
                self.pictures.insert(kept.id.clone(), texture.clone());
                texture
            }),
        };
        if let Some(texture) = texture {
            let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            ui.painter().image(texture.id(), rect, all, Color32::WHITE);
        }
    }
}

/// Sizes, and when it changed.
fn about(kept: &Kept, now_ms: f64) -> String {
    let [objects, _, faces] = kept.info.sizes;
    let mut parts = Vec::new();
    if objects != 1 {
        parts.push(counted(objects as usize, "object", "objects"));
    }
    parts.push(counted(faces as usize, "face", "faces"));
    parts.push(size(kept.bytes));
    parts.push(ago(now_ms - kept.info.changed_ms));
    parts.join(" · ")
}

/// How long ago something was.
fn ago(milliseconds: f64) -> String {
    let minutes = (milliseconds / 60_000.0).max(0.0) as usize;
    match minutes {
        0 => "just now".to_owned(),
        1..60 => format!("{} ago", counted(minutes, "minute", "minutes")),
        60..1440 => format!("{} ago", counted(minutes / 60, "hour", "hours")),
        1440..2880 => "yesterday".to_owned(),
        _ => format!("{} days ago", thousands(minutes / 1440)),
    }
}

/// An amount of bytes in words.
fn size(bytes: u64) -> String {
    match bytes {
        0..1_000_000 => format!("{} kB", bytes.div_ceil(1000)),
        _ => format!("{:.1} MB", bytes as f64 / 1e6),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_sizes_read_well() {
        let hours = |hours: f64| ago(hours * 3_600_000.0);
        assert_eq!([hours(0.0), hours(0.02), hours(0.5)], ["just now", "1 minute ago", "30 minutes ago"]);
        assert_eq!([hours(1.9), hours(30.0), hours(72.0)], ["1 hour ago", "yesterday", "3 days ago"]);
        assert_eq!([size(1), size(55_300), size(34_560_000)], ["1 kB", "56 kB", "34.6 MB"]);
    }
}
