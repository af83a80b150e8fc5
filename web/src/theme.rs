//! The colours, sizes and spacing of both themes.

use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, Shadow, Stroke, Style, TextStyle, Theme,
    Visuals, style::ScrollAnimation, vec2,
};

/// Below this width, in points, the side panels become a sheet at the bottom and controls grow for fingers.
pub const NARROW_WIDTH_POINTS: f32 = 720.0;

/// Below this height, in points, the list of steps has to be opened: it would leave too little for the rest.
pub const LOW_HEIGHT_POINTS: f32 = 900.0;

/// The least width of the page, in points: the interface is scaled up no further.
pub const MIN_PAGE_WIDTH: f32 = 380.0;

/// The least width and height of a touch target, in points.
pub const TOUCH_TARGET: f32 = 44.0;

/// The colours that egui's styles have no field for.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// The background of the bars.
    pub bar: Color32,
    /// A selected row, in the colour of selected elements in the viewport.
    pub selected_row: Color32,
    /// Text on a selected row.
    pub selected_text: Color32,
    /// A row under the pointer, here or in the viewport.
    pub hovered_row: Color32,
    /// The background of text over the viewport.
    pub overlay: Color32,
    /// The background of the button that a form or dialog is for.
    pub primary: Color32,
    /// Text on that button.
    pub on_primary: Color32,
    /// The ring around the widget with the keyboard focus.
    pub focus: Color32,
    /// Success.
    pub good: Color32,
    /// The coordinate axes x, y and z.
    pub axes: [Color32; 3],
}

const DARK: Palette = Palette {
    bar: Color32::from_rgb(0x1a, 0x1d, 0x22),
    selected_row: Color32::from_rgb(0x5c, 0x3c, 0x18),
    selected_text: Color32::from_rgb(0xff, 0xdf, 0xb8),
    hovered_row: Color32::from_rgb(0x22, 0x3d, 0x48),
    overlay: Color32::from_rgba_premultiplied(0x12, 0x14, 0x18, 0xd8),
    primary: Color32::from_rgb(0x25, 0x63, 0xb8),
    on_primary: Color32::WHITE,
    focus: Color32::from_rgb(0x4c, 0x9a, 0xff),
    good: Color32::from_rgb(0x5f, 0xc5, 0x82),
    axes: [
        Color32::from_rgb(0xf0, 0x6a, 0x6a),
        Color32::from_rgb(0x7c, 0xc9, 0x5c),
        Color32::from_rgb(0x6a, 0x9d, 0xf5),
    ],
};

const LIGHT: Palette = Palette {
    bar: Color32::from_rgb(0xee, 0xf0, 0xf3),
    selected_row: Color32::from_rgb(0xff, 0xdd, 0xb5),
    selected_text: Color32::from_rgb(0x55, 0x2c, 0x00),
    hovered_row: Color32::from_rgb(0xd5, 0xec, 0xf8),
    overlay: Color32::from_rgba_premultiplied(0xe8, 0xea, 0xed, 0xe8),
    primary: Color32::from_rgb(0x0b, 0x63, 0xce),
    on_primary: Color32::WHITE,
    focus: Color32::from_rgb(0x0b, 0x63, 0xce),
    good: Color32::from_rgb(0x1f, 0x7f, 0x46),
    axes: [
        Color32::from_rgb(0xb0, 0x25, 0x25),
        Color32::from_rgb(0x2f, 0x6d, 0x15),
        Color32::from_rgb(0x24, 0x55, 0xb3),
    ],
};

/// The palette of the current theme.
pub fn palette(visuals: &Visuals) -> &'static Palette {
    if visuals.dark_mode { &DARK } else { &LIGHT }
}

/// The viewport's colours in the current theme.
pub fn viewport(visuals: &Visuals) -> viewport::Theme {
    if visuals.dark_mode { viewport::Theme::DARK } else { viewport::Theme::LIGHT }
}

/// Applies the editor's look to both of egui's themes. Called once.
pub fn install(ctx: &Context) {
    for theme in [Theme::Dark, Theme::Light] {
        let mut style = (*ctx.style_of(theme)).clone();
        style.visuals = visuals(theme);
        sizes(&mut style);
        ctx.set_style_of(theme, style);
    }
}

/// Stops or restores what moves by itself: fading, sliding and smooth scrolling.
pub fn reduce_motion(ctx: &Context, reduces: bool) {
    let default = Style::default();
    ctx.all_styles_mut(|style| {
        style.animation_time = if reduces { 0.0 } else { default.animation_time };
        style.scroll_animation = if reduces { ScrollAnimation::none() } else { default.scroll_animation };
    });
}

fn sizes(style: &mut Style) {
    let fonts = [
        (TextStyle::Small, 11.0, FontFamily::Proportional),
        (TextStyle::Body, 13.0, FontFamily::Proportional),
        (TextStyle::Button, 13.0, FontFamily::Proportional),
        (TextStyle::Heading, 15.0, FontFamily::Proportional),
        (TextStyle::Monospace, 12.0, FontFamily::Monospace),
    ];
    style.text_styles = fonts.map(|(text, size, family)| (text, FontId::new(size, family))).into();
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(6.0, 6.0);
    spacing.button_padding = vec2(8.0, 3.0);
    spacing.interact_size = vec2(36.0, 24.0);
    spacing.window_margin = Margin::same(12);
    spacing.menu_margin = Margin::same(6);
    spacing.combo_width = 120.0;
    spacing.text_edit_width = 160.0;
    spacing.tooltip_width = 320.0;
    style.interaction.tooltip_delay = 0.35;
}

/// Sizes controls for fingers, or for a mouse.
pub fn set_touch(ctx: &Context, touch: bool) {
    if is_for_touch(ctx) == touch {
        return;
    }
    ctx.all_styles_mut(|style| {
        sizes(style);
        if touch {
            let spacing = &mut style.spacing;
            spacing.interact_size = vec2(TOUCH_TARGET, TOUCH_TARGET);
            spacing.button_padding = vec2(12.0, 8.0);
            spacing.icon_width = 20.0;
            spacing.icon_width_inner = 12.0;
        }
    });
    ctx.request_repaint();
}

/// Whether controls are sized for fingers. Then there are no keys, and texts name none.
pub fn is_for_touch(ctx: &Context) -> bool {
    ctx.global_style().spacing.interact_size.y >= TOUCH_TARGET
}

fn visuals(theme: Theme) -> Visuals {
    let dark = theme == Theme::Dark;
    let mut visuals = if dark { Visuals::dark() } else { Visuals::light() };
    let grey = |dark_level: u32, light_level: u32| {
        let [_, r, g, b] = if dark { dark_level } else { light_level }.to_be_bytes();
        Color32::from_rgb(r, g, b)
    };
    let text = grey(0xd9dde3, 0x23272d);
    let strong = grey(0xf4f6f8, 0x0d0f12);
    let line = grey(0x343a43, 0xd3d8de);
    let accent = grey(0x4c9aff, 0x0b63ce);

    visuals.panel_fill = grey(0x21252b, 0xf8f9fb);
    visuals.window_fill = grey(0x262b32, 0xffffff);
    visuals.extreme_bg_color = grey(0x16191d, 0xffffff);
    visuals.faint_bg_color = grey(0x262a31, 0xf1f3f6);
    visuals.code_bg_color = grey(0x2c3139, 0xe9ecf0);
    visuals.window_stroke = Stroke::new(1.0, line);
    visuals.weak_text_color = Some(grey(0xa9b2bd, 0x58616c));
    visuals.warn_fg_color = grey(0xf0b35a, 0x9a5b00);
    visuals.error_fg_color = grey(0xff8080, 0xb3261e);
    visuals.hyperlink_color = accent;
    visuals.selection.bg_fill = grey(0x204d85, 0xcfe3fb);
    visuals.selection.stroke = Stroke::new(1.0, grey(0xe8f1ff, 0x073f86));
    visuals.window_corner_radius = CornerRadius::same(8);
    visuals.menu_corner_radius = CornerRadius::same(6);
    let shadow = |size: u8| Shadow {
        offset: [0, (size / 3) as i8],
        blur: size,
        spread: 0,
        color: Color32::from_black_alpha(if dark { 110 } else { 45 }),
    };
    visuals.window_shadow = shadow(24);
    visuals.popup_shadow = shadow(12);
    visuals.striped = false;
    visuals.slider_trailing_fill = true;

    let widgets = &mut visuals.widgets;
    let corner = CornerRadius::same(4);
    for (state, fill, border, text) in [
        (&mut widgets.noninteractive, grey(0x21252b, 0xf8f9fb), line, text),
        (&mut widgets.inactive, grey(0x30363f, 0xeceff3), grey(0x3d454f, 0xcfd5dc), text),
        (&mut widgets.hovered, grey(0x3b434e, 0xdae0e7), grey(0x515b68, 0xbcc4ce), strong),
        (&mut widgets.active, grey(0x475160, 0xcbd3dd), accent, strong),
        (&mut widgets.open, grey(0x353c46, 0xdfe4ea), line, strong),
    ] {
        state.bg_fill = fill;
        state.weak_bg_fill = fill;
        state.bg_stroke = Stroke::new(1.0, border);
        state.fg_stroke = Stroke::new(1.0, text);
        state.corner_radius = corner;
        state.expansion = 0.0;
    }
    visuals
}
