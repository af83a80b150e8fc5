//! A colour button whose picker has named, typable controls like any other.

use egui::{
    Color32, Popup, PopupCloseBehavior, Response, Role, Sense, Slider, Stroke, StrokeKind, Ui, Visuals,
    WidgetInfo, vec2,
};
use halfedge::Color;

use super::controls::text_field;

/// Initial colours: the grey of unpainted faces, then around the colour wheel.
const SWATCHES: [[u8; 3]; 12] = [
    [0xc8, 0xc8, 0xc8],
    [0xff, 0xff, 0xff],
    [0x40, 0x40, 0x40],
    [0x8a, 0x5a, 0x3c],
    [0xe0, 0x4f, 0x4f],
    [0xf0, 0x8c, 0x3a],
    [0xf2, 0xc9, 0x4c],
    [0x6f, 0xbf, 0x4b],
    [0x3f, 0xb8, 0xa5],
    [0x4c, 0x9a, 0xff],
    [0x7d, 0x6a, 0xe8],
    [0xd7, 0x62, 0xb8],
];

/// Shows the colour on a button; a click opens the picker. Returns whether the colour changed.
pub fn color_button(ui: &mut Ui, name: &str, rgb: &mut [u8; 3]) -> (Response, bool) {
    let size = vec2(44.0, ui.spacing().interact_size.y);
    let (rect, button) = ui.allocate_exact_size(size, Sense::click());
    button.widget_info(|| WidgetInfo::labeled(Role::ColorWell, ui.is_enabled(), name));
    let shown = Color(*rgb).to_hex();
    ui.ctx().accesskit_node_builder(button.id, |node| node.set_value(shown));
    let stroke = ui.style().interact(&button).fg_stroke;
    ui.painter().rect(rect.shrink(1.0), 4.0, color32(*rgb), stroke, StrokeKind::Inside);

    let before = *rgb;
    Popup::menu(&button).close_behavior(PopupCloseBehavior::CloseOnClickOutside).show(|ui| {
        ui.set_width(220.0);
        swatches(ui, rgb);
        sliders(ui, rgb);
        hex(ui, rgb);
    });
    let changed = *rgb != before;
    (button, changed)
}

/// The outline of a colour, which shows it on a background of the same colour too.
pub fn swatch_outline(visuals: &Visuals) -> Stroke {
    Stroke::new(1.0, visuals.text_color().gamma_multiply(0.6))
}

fn swatches(ui: &mut Ui, rgb: &mut [u8; 3]) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
        for color in SWATCHES {
            let (rect, swatch) = ui.allocate_exact_size(vec2(32.0, 24.0), Sense::click());
            let name = Color(color).to_hex();
            swatch.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
            let stroke = if swatch.hovered() || swatch.has_focus() {
                ui.visuals().widgets.hovered.fg_stroke
            } else {
                swatch_outline(ui.visuals())
            };
            ui.painter().rect(rect, 4.0, color32(color), stroke, StrokeKind::Inside);
            if swatch.on_hover_text(name).clicked() {
                *rgb = color;
            }
        }
    });
}

fn sliders(ui: &mut Ui, rgb: &mut [u8; 3]) {
    // Grey has no hue, and black no saturation: the sliders' last values are kept beside the colour.
    let kept = ui.scope_id().with("hue");
    let mut hsv = ui
        .data(|data| data.get_temp::<[f32; 3]>(kept))
        .filter(|hsv| rgb_of(*hsv) == *rgb)
        .unwrap_or_else(|| hsv_of(*rgb));
    let mut changed = false;
    ui.spacing_mut().slider_width = 110.0;
    egui::Grid::new("sliders").num_columns(2).show(ui, |ui| {
        for ((name, most), value) in
            [("Hue", 360.0), ("Saturation", 100.0), ("Brightness", 100.0)].into_iter().zip(&mut hsv)
        {
            let label = ui.label(name);
            // Rounded before the slider rounds it; otherwise showing a colour would change it.
            let mut shown = (*value * most).round();
            let slider = Slider::new(&mut shown, 0.0..=most).max_decimals(0).smart_aim(false);
            if ui.add(slider).labelled_by(label.id).changed() {
                *value = shown / most;
                changed = true;
            }
            ui.end_row();
        }
    });
    if changed {
        *rgb = rgb_of(hsv);
    }
    ui.data_mut(|data| data.insert_temp(kept, hsv));
}

/// Hue, saturation and brightness of an sRGB colour, from 0 to 1 each; of the sRGB values, as in other colour pickers,
/// not of the light that they stand for.
fn hsv_of(rgb: [u8; 3]) -> [f32; 3] {
    let [r, g, b] = rgb.map(|channel| f32::from(channel) / 255.0);
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let chroma = most - least;
    if chroma == 0.0 {
        return [0.0, 0.0, most];
    }
    let sixths = if most == r {
        (g - b) / chroma
    } else if most == g {
        2.0 + (b - r) / chroma
    } else {
        4.0 + (r - g) / chroma
    };
    [(sixths / 6.0).rem_euclid(1.0), chroma / most, most]
}

/// The sRGB colour of a hue, a saturation and a brightness.
fn rgb_of([hue, saturation, brightness]: [f32; 3]) -> [u8; 3] {
    let channel = |offset: f32| {
        let along = (offset + hue * 6.0).rem_euclid(6.0);
        let less = saturation * along.min(4.0 - along).clamp(0.0, 1.0);
        (brightness * (1.0 - less) * 255.0).round() as u8
    };
    [channel(5.0), channel(3.0), channel(1.0)]
}

fn hex(ui: &mut Ui, rgb: &mut [u8; 3]) {
    let typed = ui.scope_id().with("typed");
    ui.horizontal(|ui| {
        let label = ui.label("Hex");
        let mut text = ui.data(|data| data.get_temp::<String>(typed)).unwrap_or_else(|| Color(*rgb).to_hex());
        let field = ui.add(text_field(&mut text).desired_width(90.0)).labelled_by(label.id);
        if field.has_focus() {
            ui.data_mut(|data| data.insert_temp(typed, text));
        } else {
            if field.lost_focus()
                && let Some(color) = Color::from_hex(&format!("#{}", text.trim().trim_start_matches('#')))
            {
                *rgb = color.0;
            }
            ui.data_mut(|data| data.remove::<String>(typed));
        }
        field.on_hover_text("A colour as #rrggbb");
    });
}

fn color32([r, g, b]: [u8; 3]) -> Color32 {
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brightness_is_that_of_the_srgb_values() {
        assert_eq!(hsv_of([0xc8; 3]).map(|value| (value * 100.0).round()), [0.0, 0.0, 78.0]);
        assert_eq!(hsv_of([255, 0, 0]), [0.0, 1.0, 1.0]);
        assert_eq!(hsv_of([0, 128, 128]).map(|value| (value * 360.0).round()), [180.0, 360.0, 181.0]);
        assert_eq!(hsv_of([0, 0, 0]), [0.0, 0.0, 0.0]);
    }

    #[test]
    fn every_colour_comes_back() {
        for value in 0..1_u32 << 15 {
            let rgb = [value >> 10, value >> 5 & 31, value & 31].map(|channel| (channel * 255 / 31) as u8);
            assert_eq!(rgb_of(hsv_of(rgb)), rgb);
        }
    }
}
