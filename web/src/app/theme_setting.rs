//! The theme that the user chose, kept for later visits. `web/site/start.js` reads it too.

use egui::{Context, ThemePreference};

use crate::platform::Platform;
use crate::session::Session;

/// The key of the setting.
const SETTING: &str = "theme";

/// Applies the theme of the last visit.
pub(super) fn load(ctx: &Context, platform: &dyn Platform) {
    ctx.set_theme(match platform.load_setting(SETTING).as_deref() {
        Some("light") => ThemePreference::Light,
        Some("dark") => ThemePreference::Dark,
        _ => ThemePreference::System,
    });
}

/// Sets the theme and stores it for later visits.
pub(super) fn choose(session: &mut Session, theme: ThemePreference) {
    session.ctx.set_theme(theme);
    let name = match theme {
        ThemePreference::Light => "light",
        ThemePreference::Dark => "dark",
        ThemePreference::System => "system",
    };
    session.platform.store_setting(SETTING, name);
}
