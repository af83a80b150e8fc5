//! What one unit of the mesh is, as the user chose it, kept for later visits.

use egui::Context;

use crate::platform::Platform;
use crate::session::Session;
use crate::units::LengthUnit;
use crate::widgets::number_box::set_length_unit;

/// The key of the setting.
const SETTING: &str = "length-unit";

/// Takes the unit of the last visit.
pub(super) fn load(ctx: &Context, platform: &dyn Platform) {
    let stored = platform.load_setting(SETTING);
    set_length_unit(ctx, stored.as_deref().and_then(LengthUnit::named).unwrap_or_default());
}

/// Takes a unit and stores it for later visits.
pub(super) fn choose(session: &mut Session, unit: LengthUnit) {
    set_length_unit(&session.ctx, unit);
    session.platform.store_setting(SETTING, unit.name());
}
