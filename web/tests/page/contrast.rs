//! Contrast of text and marks in both themes, as the Web Content Accessibility Guidelines 2.2 define it (1.4.3, 1.4.11).

use std::collections::BTreeMap;

use egui::epaint::{ClippedShape, TextShape};
use egui::{Color32, Context, Key, Modifiers, Pos2, Rect, Shape, Theme, Vec2, Visuals, pos2};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::Color;
use meshwright_web::theme;

use crate::page::{DESKTOP, PHONE, Page};

/// The least contrast of text.
const TEXT: f64 = 4.5;
/// The least contrast of marks: selected elements, icons, the focus ring.
const MARKS: f64 = 3.0;

fn luminance(color: Color32) -> f64 {
    let linear = |channel: u8| {
        let c = f64::from(channel) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * linear(color.r()) + 0.7152 * linear(color.g()) + 0.0722 * linear(color.b())
}

pub fn contrast(a: Color32, b: Color32) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// What is seen of a translucent colour over an opaque one.
fn over(front: Color32, back: Color32) -> Color32 {
    let rest = f32::from(255 - front.a()) / 255.0;
    let mix = |front: u8, back: u8| (f32::from(front) + f32::from(back) * rest).round() as u8;
    Color32::from_rgb(mix(front.r(), back.r()), mix(front.g(), back.g()), mix(front.b(), back.b()))
}

fn solid(Color([r, g, b]): Color) -> Color32 {
    Color32::from_rgb(r, g, b)
}

fn visuals(theme: Theme) -> Visuals {
    let ctx = Context::default();
    theme::install(&ctx);
    ctx.style_of(theme).visuals.clone()
}

/// Each text on each background that it is used on.
fn texts(visuals: &Visuals) -> Vec<(String, Color32, Color32)> {
    let (palette, view) = (theme::palette(visuals), theme::viewport(visuals));
    let (text, strong, weak) = (visuals.text_color(), visuals.strong_text_color(), visuals.weak_text_color());
    let mut pairs = Vec::new();
    let mut add = |name: &str, color, places: &[(&str, Color32)]| {
        pairs.extend(places.iter().map(|(place, back)| (format!("{name} on {place}"), color, *back)));
    };
    let panel = ("panels", visuals.panel_fill);
    let window = ("windows", visuals.window_fill);
    let field = ("fields", visuals.extreme_bg_color);
    let (bar, code) = (("bars", palette.bar), ("code", visuals.code_bg_color));
    let stripe = ("striped rows", visuals.faint_bg_color);
    let hovered = ("hovered rows", palette.hovered_row);
    for (name, color) in [("text", text), ("weak text", weak)] {
        add(name, color, &[panel, window, field, bar, stripe, hovered]);
    }
    add("strong text", strong, &[panel, window, bar]);
    add("text", text, &[code]);
    for (name, color) in [
        ("warnings", visuals.warn_fg_color),
        ("errors", visuals.error_fg_color),
        ("links", visuals.hyperlink_color),
        ("success", palette.good),
    ] {
        add(name, color, &[panel, window]);
    }
    for (name, color) in ["x", "y", "z"].into_iter().zip(palette.axes) {
        add(name, color, &[panel, ("the viewport's bottom", solid(view.background_bottom))]);
    }
    add("a label", palette.on_primary, &[("primary buttons", palette.primary)]);
    add("selected text", palette.selected_text, &[("selected rows", palette.selected_row)]);
    add("chosen text", visuals.selection.stroke.color, &[("chosen buttons", visuals.selection.bg_fill)]);
    let widgets = &visuals.widgets;
    for (name, state) in [
        ("idle buttons", &widgets.inactive),
        ("hovered buttons", &widgets.hovered),
        ("pressed buttons", &widgets.active),
        ("open buttons", &widgets.open),
    ] {
        add("a label", state.fg_stroke.color, &[(name, state.weak_bg_fill)]);
    }
    // Keys beside the names of menu entries.
    add("keys", weak, &[("hovered entries", widgets.hovered.weak_bg_fill)]);
    for (name, back) in [
        ("the viewport's top", solid(view.background_top)),
        ("the viewport's bottom", solid(view.background_bottom)),
        ("white faces", Color32::WHITE),
        ("black faces", Color32::BLACK),
    ] {
        add("an overlay's text", text, &[(name, over(palette.overlay, back))]);
    }
    pairs
}

/// Each mark on each background that it is seen against.
fn marks(visuals: &Visuals) -> Vec<(String, Color32, Color32)> {
    let (palette, view) = (theme::palette(visuals), theme::viewport(visuals));
    let scene = [
        ("the viewport's top", solid(view.background_top)),
        ("the viewport's bottom", solid(view.background_bottom)),
    ];
    let controls = [("panels", visuals.panel_fill), ("windows", visuals.window_fill), ("bars", palette.bar)];
    let mut pairs = Vec::new();
    let mut add = |name: &str, color, places: &[(&str, Color32)]| {
        pairs.extend(places.iter().map(|(place, back)| (format!("{name} on {place}"), color, *back)));
    };
    add("selected elements", solid(view.selected), &scene);
    add("hovered elements", solid(view.hovered), &scene);
    add("isolated vertices", solid(view.isolated), &scene);
    add("the focus ring", palette.focus, &controls);
    add("the focus ring", palette.focus, &scene);
    add("icons", visuals.widgets.inactive.fg_stroke.color, &controls);
    pairs
}

#[test]
fn text_and_marks_stand_out_in_both_themes() {
    assert!((contrast(Color32::WHITE, Color32::BLACK) - 21.0).abs() < 1e-9);
    assert!((contrast(Color32::from_rgb(0x76, 0x76, 0x76), Color32::WHITE) - 4.54).abs() < 0.01);
    let mut weak = Vec::new();
    for theme in [Theme::Dark, Theme::Light] {
        let visuals = visuals(theme);
        for (least, pairs) in [(TEXT, texts(&visuals)), (MARKS, marks(&visuals))] {
            for (name, front, back) in pairs {
                let found = contrast(front, back);
                if found < least {
                    weak.push(format!("{theme:?}: {name}: {found:.2} is below {least}: {front:?} {back:?}"));
                }
            }
        }
    }
    assert!(weak.is_empty(), "{}", weak.join("\n"));
}

/// What is behind a letter: the fills of the rectangles below it, over each of the colours that may be below those.
struct Backs {
    fills: Vec<(Rect, Color32)>,
    viewport: Rect,
    /// The lowest colours in the viewport: its background, and models of any colour.
    scene: Vec<Color32>,
    panel: Color32,
}

impl Backs {
    fn at(&self, at: Pos2) -> Vec<Color32> {
        let lowest = if self.viewport.contains(at) { self.scene.clone() } else { vec![self.panel] };
        let fills = || self.fills.iter().filter(|(rect, _)| rect.contains(at));
        lowest.into_iter().map(|lowest| fills().fold(lowest, |back, (_, fill)| over(*fill, back))).collect()
    }
}

/// The letters of a text with their colours: the first and the last of each colour in each row.
fn letters(text: &TextShape) -> Vec<(Pos2, Color32)> {
    let mut found = Vec::new();
    for row in &text.galley.rows {
        let mesh = &row.visuals.mesh;
        let mut of_row: BTreeMap<[u8; 4], Vec<Pos2>> = BTreeMap::new();
        for corners in mesh.vertices[row.visuals.glyph_vertex_range.clone()].chunks_exact(4) {
            let color = match (text.override_text_color, corners[0].color) {
                (Some(color), _) => color,
                (None, Color32::PLACEHOLDER) => text.fallback_color,
                (None, color) => color,
            };
            let middle = corners.iter().fold(Vec2::ZERO, |sum, corner| sum + corner.pos.to_vec2() / 4.0);
            of_row.entry(color.to_array()).or_default().push(text.pos + row.pos.to_vec2() + middle);
        }
        for ([r, g, b, a], places) in of_row {
            let color = Color32::from_rgba_premultiplied(r, g, b, a).gamma_multiply(text.opacity_factor);
            found.extend([places[0], places[places.len() - 1]].map(|at| (at, color)));
        }
    }
    found
}

/// The texts on the screen that stand out too little, each with its least contrast.
fn weak_texts(page: &mut Page, theme: Theme) -> Vec<String> {
    let visuals = page.harness.ctx.style_of(theme).visuals.clone();
    let view = theme::viewport(&visuals);
    let rect = page.app().script().state()["view"]["rect"].clone();
    let [x, y, width, height] = [0, 1, 2, 3].map(|at| rect[at].as_f64().expect("a number") as f32);
    let mut backs = Backs {
        fills: Vec::new(),
        viewport: Rect::from_min_size(pos2(x, y), Vec2::new(width, height)),
        scene: vec![
            solid(view.background_top),
            solid(view.background_bottom),
            Color32::WHITE,
            Color32::BLACK,
        ],
        panel: visuals.panel_fill,
    };
    // What can't be used may be faint.
    let nodes = page.harness.root().children_recursive();
    let disabled: Vec<Rect> =
        nodes.filter(|node| node.accesskit_node().is_disabled()).map(|node| node.rect()).collect();
    let mut weak = Vec::new();
    let mut texts = 0;
    let mut stack: Vec<(Rect, &Shape)> = Vec::new();
    for ClippedShape { clip_rect, shape, .. } in &page.harness.output().shapes {
        stack.push((*clip_rect, shape));
        while let Some((clip, shape)) = stack.pop() {
            match shape {
                Shape::Vec(shapes) => stack.extend(shapes.iter().rev().map(|shape| (clip, shape))),
                Shape::Rect(rect) if rect.blur_width == 0.0 && rect.brush.is_none() => {
                    backs.fills.push((rect.rect.intersect(clip), rect.fill));
                }
                Shape::Text(text) => {
                    let seen =
                        |at: &Pos2| clip.contains(*at) && !disabled.iter().any(|rect| rect.contains(*at));
                    for (at, color) in letters(text).into_iter().filter(|(at, _)| seen(at)) {
                        texts += 1;
                        let of = |back: &Color32| contrast(over(color, *back), *back);
                        let back = backs
                            .at(at)
                            .into_iter()
                            .min_by(|a, b| of(a).total_cmp(&of(b)))
                            .expect("a colour");
                        if of(&back) < TEXT {
                            let words = text.galley.text();
                            weak.push(format!(
                                "{words:?} at {at:?}: {:.2}, {color:?} on {back:?}",
                                of(&back)
                            ));
                        }
                    }
                }
                _ => {}
            }
        }
    }
    assert!(texts > 50, "{texts} texts are on the screen");
    weak
}

#[test]
fn every_text_that_is_drawn_stands_out_in_both_themes() {
    let mut weak = Vec::new();
    for (theme, size) in
        [Theme::Dark, Theme::Light].into_iter().flat_map(|theme| [(theme, DESKTOP), (theme, PHONE)])
    {
        let mut page = Page::themed(size, theme);
        let mut look = |page: &mut Page, state: &str| {
            let found = weak_texts(page, theme);
            weak.extend(found.into_iter().map(|text| format!("{theme:?}, {} wide, {state}: {text}", size.x)));
        };
        look(&mut page, "at the start");
        page.select("halfedge", &[3]);
        look(&mut page, "a half-edge");
        page.select("face", &[1, 2]);
        look(&mut page, "two faces");
        if size == DESKTOP {
            page.harness.get_by_role_and_label(egui::Role::Button, "Undo").hover();
            page.wait();
            look(&mut page, "a hovered tool with its tooltip");
            page.row("Face 1").hover();
            page.run();
            look(&mut page, "a hovered selected row");
            for menu in ["Select", "Mesh", "View"] {
                page.click(menu);
                look(&mut page, menu);
                page.press(Key::Escape);
            }
            for entry in ["Valence", "Group"] {
                page.click("View");
                page.click("Colour by");
                page.click(entry);
                look(&mut page, entry);
            }
            page.click("View");
            page.click("Element numbers");
            let at = page.at([0.0, 0.0, 1.0]);
            page.harness.hover_at(at);
            page.run();
            look(&mut page, "element numbers");
            page.press(Key::E);
            look(&mut page, "an edit that follows the pointer");
            page.press(Key::Escape);
        } else {
            page.click("Operations");
            look(&mut page, "the operations");
            page.click("Menu");
            look(&mut page, "the menu");
            page.press(Key::Escape);
        }
        page.press(Key::I);
        look(&mut page, "the overlay");
        page.press_with(Modifiers::COMMAND, Key::K);
        look(&mut page, "the palette");
        page.find("Find a command").type_text("simplify");
        page.run();
        page.press(Key::Enter);
        look(&mut page, "a form");
        page.press(Key::Escape);
        page.press_with(Modifiers::COMMAND, Key::S);
        look(&mut page, "the save dialog");
        page.press(Key::Escape);
        page.press(Key::F1);
        look(&mut page, "the keys");
        page.press(Key::Escape);
        page.open("broken.obj", "v 0 0\n");
        look(&mut page, "an error");
    }
    assert!(weak.is_empty(), "{} texts: {}", weak.len(), weak.join("\n"));
}
