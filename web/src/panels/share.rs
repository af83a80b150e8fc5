//! The window with a link that holds the document, and its QR code.

use editor::project::LinkKind;
use egui::{Color32, Context, Image, Label, RichText, ScrollArea, Sense, TextEdit, TextureOptions, Ui, vec2};
use egui::{ColorImage, TextureHandle};
use formats::Format;
use halfedge::words::thousands;
use qrcodegen::{QrCode, QrCodeEcc};

use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::session::sharing::{self, Made};
use crate::theme;
use crate::widgets::controls::primary_button;
use crate::widgets::window::fixed;

/// Up to this length, links work everywhere, even in messages of Discord and in old mail programs.
const SHORT_CHARACTERS: usize = 2_000;
/// Up to this length, most chat and mail programs keep them whole.
const GOOD_CHARACTERS: usize = 8_000;
/// Longer ones are cut by too many programs.
const MAX_CHARACTERS: usize = 32_000;

/// A QR code of more characters can't be read from a screen, though the standard allows 2 953.
const MAX_CODE_CHARACTERS: usize = 2_900;
/// The white frame that a QR code needs, in modules.
const QUIET_MODULES: usize = 4;
/// The side of the picture on the page, in points.
const CODE_POINTS: f32 = 240.0;

/// The picture of the QR code, and the text that it is of.
#[derive(Default)]
pub(crate) struct Code(Option<(String, TextureHandle)>);

pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut Code, out: &mut Requests) {
    if !page.shown.share {
        own.0 = None;
        return;
    }
    let mut open = true;
    let screen = ctx.content_rect();
    fixed(ctx, "Share").open(&mut open).show(ctx, |ui| {
        ui.set_width(400.0_f32.min(screen.width() - 48.0).max(0.0));
        let most = (screen.height() - 96.0).max(120.0);
        // Without a least height, the area would keep the height of its first frames, in which there was no QR code yet.
        let area = ScrollArea::vertical().max_height(most).min_scrolled_height(most);
        area.show(ui, |ui| contents(ui, page, own, out));
    });
    if !open {
        out.push(Request::Close(crate::shown::Window::Share));
    }
}

fn contents(ui: &mut Ui, page: &Page<'_>, own: &mut Code, out: &mut Requests) {
    let made = sharing::link(page.session);
    if made.is_none() {
        out.push(Request::MakeLink);
    }
    match made {
        None => {
            ui.horizontal(|ui| {
                ui.spinner();
                ui.label("Making the link…");
            });
        }
        Some(Made::Failed(reason)) => no_link(ui, page, reason, out),
        Some(Made::TooLarge) => {
            let text = "This document is too large for a link. Save it as a project file, and send that.";
            no_link(ui, page, text, out);
        }
        Some(Made::Link(link)) => {
            let address = page.platform.address().unwrap_or_default() + &link.fragment;
            let characters = address.len();
            if characters > MAX_CHARACTERS {
                let text = format!(
                    "A link to this document would have {} characters; browsers and chat programs bear about {}. Save \
                     it as a project file, and send that.",
                    thousands(characters),
                    thousands(MAX_CHARACTERS)
                );
                return no_link(ui, page, &text, out);
            }
            show_link(ui, page, &address, link.kind, out);
            if characters <= MAX_CODE_CHARACTERS {
                show_code(ui, own, address);
            }
        }
    }
}

/// Says why there is no link, and offers a file.
fn no_link(ui: &mut Ui, page: &Page<'_>, why: &str, out: &mut Requests) {
    ui.add(Label::new(why).wrap());
    ui.add_space(8.0);
    save_button(ui, page, out);
}

fn save_button(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    let entry = actions::of_format(Format::project());
    let why_not = page.why_not(entry.action);
    let button = ui.add_enabled(why_not.is_none(), egui::Button::new(entry.label));
    if button.on_hover_text(entry.description).on_disabled_hover_text(why_not.unwrap_or_default()).clicked() {
        out.push(Request::Close(crate::shown::Window::Share));
        out.act(Action::SaveAs(Format::project()));
    }
}

fn show_link(ui: &mut Ui, page: &Page<'_>, address: &str, kind: LinkKind, out: &mut Requests) {
    let holds = match kind {
        LinkKind::Meshes => "the document itself",
        LinkKind::Commands => "the steps that make the document",
    };
    let text = format!(
        "Whoever opens the link gets a copy of the document. The link holds {holds}: nothing is uploaded, and it works as \
         long as this page is there."
    );
    ui.add(Label::new(text).wrap());
    ui.add_space(6.0);
    let label = ui.label(RichText::new("Link").small().strong()).id;
    let mut shown = address;
    let field =
        TextEdit::singleline(&mut shown).desired_width(f32::INFINITY).font(egui::TextStyle::Monospace);
    ui.add(field).labelled_by(label).on_hover_text("The address of the document; it can't be changed here");
    let (length, is_good) = verdict(address.len());
    let palette = theme::palette(ui.visuals());
    let color = if is_good { palette.good } else { ui.visuals().warn_fg_color };
    ui.add(Label::new(RichText::new(length).color(color)).wrap());
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| {
        let copy = ui.add(primary_button(ui, "Copy link").min_size(vec2(96.0, 28.0)));
        if copy.on_hover_text("Copy the link to the clipboard").clicked() {
            out.push(Request::Copy { text: address.to_owned(), said: "The link was copied." });
        }
        save_button(ui, page, out);
    });
}

/// What to say of a link of this many characters, and whether that is good news.
fn verdict(characters: usize) -> (String, bool) {
    let length = format!("{} characters", thousands(characters));
    if characters <= SHORT_CHARACTERS {
        return (format!("{length}: short enough for every chat and mail program."), true);
    }
    match characters {
        0..=GOOD_CHARACTERS => {
            (format!("{length}: fine for mail and most chat programs; Discord cuts messages at 2 000."), true)
        }
        _ => (
            format!("{length}: browsers open it, but many chat programs cut it. A project file is safer."),
            false,
        ),
    }
}

/// The picture that a telephone's camera reads.
fn show_code(ui: &mut Ui, own: &mut Code, address: String) {
    if own.0.as_ref().is_none_or(|(of, _)| *of != address) {
        own.0 = picture(&address)
            .map(|image| ui.ctx().load_texture("QR code", image, TextureOptions::NEAREST))
            .map(|texture| (address, texture));
    }
    let Some((_, texture)) = &own.0 else { return };
    ui.add_space(8.0);
    ui.vertical_centered(|ui| {
        let [modules, _] = texture.size();
        // A whole number of pixels for each module, so that all have the same size.
        let pixels_per_point = ui.ctx().pixels_per_point();
        let most = CODE_POINTS.max(modules as f32 * 2.0).min(ui.available_width()) * pixels_per_point;
        let per_module = (most / modules as f32).floor().max(1.0);
        let side = per_module * modules as f32 / pixels_per_point;
        let picture = Image::new(texture).fit_to_exact_size(vec2(side, side)).sense(Sense::hover());
        let code = ui.add(picture.alt_text("QR code of the link"));
        code.on_hover_text("Point a phone's camera at it to open the document there");
    });
}

/// A pixel for each module, with a white frame; none if the text is too long.
fn picture(text: &str) -> Option<ColorImage> {
    let code = QrCode::encode_text(text, QrCodeEcc::Low).ok()?;
    let side = code.size() as usize + 2 * QUIET_MODULES;
    let is_dark = |at: usize| {
        let [x, y] = [at % side, at / side].map(|place| place as i32 - QUIET_MODULES as i32);
        code.get_module(x, y)
    };
    let pixels = (0..side * side).map(|at| if is_dark(at) { Color32::BLACK } else { Color32::WHITE });
    Some(ColorImage::new([side, side], pixels.collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_have_a_white_frame_and_finders_in_three_corners() {
        let image = picture("https://example.org/#d=1AAAA").expect("short");
        let [side, _] = image.size;
        let at = |x: usize, y: usize| image.pixels[y * side + x] == Color32::BLACK;
        assert!((0..side).all(|i| !at(i, 3) && !at(3, i) && !at(i, side - 4) && !at(side - 4, i)));
        for (x, y) in [(4, 4), (side - 11, 4), (4, side - 11)] {
            assert!((0..7).all(|i| at(x + i, y) && at(x, y + i) && at(x + i, y + 6) && at(x + 6, y + i)));
        }
        assert!(picture(&"x".repeat(MAX_CODE_CHARACTERS)).is_some());
        assert!(picture(&"x".repeat(3_000)).is_none());
    }

    #[test]
    fn lengths_say_where_they_work() {
        for (characters, part, is_good) in
            [(2_000, "every chat", true), (2_001, "most chat", true), (8_001, "project file", false)]
        {
            let (text, good) = verdict(characters);
            assert!(text.contains(part) && good == is_good, "{text}");
        }
    }
}
