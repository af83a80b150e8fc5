//! Carrying out what the Transform menu chooses: how edits behave, and what is done with the 3D cursor.

use editor::ops::{MergeVertices, Transform};

use super::App;
use crate::input::actions::Action;
use crate::live::place::SelectionPlace;
use crate::transforming::{CursorAction, Pivot};
use crate::view::Tool;

/// Changes a setting, or does something with the cursor.
pub(super) fn choose(app: &mut App, action: Action) {
    let settings = &mut app.session.live_settings;
    match action {
        Action::Gizmo(gizmo) => {
            app.view.tool = Tool::Orbit;
            settings.gizmo = gizmo;
            app.session.place = SelectionPlace::of_selection(&app.session.editor);
        }
        Action::Snap => settings.snaps ^= true,
        Action::SnapTo(to) => settings.snap_to = to,
        Action::PivotAt(pivot) => {
            settings.pivot = pivot;
            app.view.cursor.is_shown |= pivot == Pivot::Cursor;
        }
        Action::Mirror(symmetry) => settings.symmetry = symmetry,
        Action::Orient(orientation) => settings.orientation = orientation,
        Action::Cursor(action) => use_cursor(app, action),
        _ => {}
    }
}

fn use_cursor(app: &mut App, action: CursorAction) {
    let (session, cursor) = (&mut app.session, &mut app.view.cursor);
    let at = cursor.in_scene(&session.editor);
    let middle =
        SelectionPlace::of_selection(&session.editor).map(|place| match session.live_settings.pivot {
            // These are no places of the selection.
            Pivot::Cursor | Pivot::Origin => place.middle,
            pivot => place.pivot(pivot, at),
        });
    match (action, middle) {
        (CursorAction::Show, _) => cursor.is_shown ^= true,
        (CursorAction::ToOrigin, _) => (cursor.at, cursor.is_shown) = (Default::default(), true),
        (CursorAction::ToSelection, Some(middle)) => cursor.place(middle, &session.editor),
        (CursorAction::TakesSelection, Some(middle)) => {
            let translate = (at - middle).to_array();
            session.begin_or_refuse(Ok(Transform { translate, ..Transform::default() }.into()));
        }
        (CursorAction::Merge, _) => {
            let merge = MergeVertices { position: Some(at.to_array()), vertices: None };
            session.begin_or_refuse(Ok(merge.into()));
        }
        // Nothing is selected: the action was refused before.
        (CursorAction::ToSelection | CursorAction::TakesSelection, None) => {}
    }
}
