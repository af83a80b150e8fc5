//! Live edits: move, rotate, scale, extrude, inset, bevel, slide and the place of a split follow the pointer. A click or
//! Enter makes the edit one undo step; Escape or a right-click cancels it without a trace. Typed numbers replace the
//! pointer; axis keys limit the edit to an axis or a plane.

use editor::ops::Drag;
use editor::{Editor, OpId};
use egui::{Context, Modifiers, Pos2};
use halfedge::Element;

use super::edit::update_edit;
use crate::input::key_preset::KeyPreset;
use crate::input::keys;
use crate::live::edit::{Live, Snap, Start};
use crate::live::edit_keys::Ending;
use crate::live::place::{self, SelectionPlace};
use crate::live::pointer::Sight;
use crate::live::slide::Track;
use crate::session::Session;
use crate::transforming::{Pivot, Settings, SnapTo, Symmetry};
use crate::view::View;
use crate::widgets::number_box::length_unit;
use viewport::Aim;

/// The radius around the pointer in which elements snap, in points.
const SNAP_RADIUS_POINTS: f32 = 18.0;
/// The soft selection's first radius, on the screen, in points.
const SOFT_RADIUS_POINTS: f32 = 90.0;

impl Session {
    /// Starts a live edit of the selection. Except for a split, nothing changes until the pointer moves.
    pub fn start_live(&mut self, start: &Start, view: &View) {
        self.end_live(false);
        self.end_preview();
        let place = match start.ring {
            Some(cut) => SelectionPlace::of_edge(&self.editor, cut.edge),
            None => SelectionPlace::of_selection(&self.editor),
        };
        let Some(place) = place else { return };
        let pointer = self.ctx.input(|input| input.pointer.latest_pos());
        let track = match Track::of_selection(&self.editor, start.id, view, pointer) {
            Ok(track) => track,
            Err(refusal) => return self.warn(format!("This can't slide: {refusal}."), Vec::new()),
        };
        let pivot = if start.id == OpId::Transform { self.live_settings.pivot } else { Pivot::Middle };
        let cursor = view.cursor.in_scene(&self.editor);
        let anchor = place.pivot(pivot, cursor);
        if start.ring.is_none() {
            self.place = Some(place);
        }
        self.live = Live::new(start, place, [anchor, cursor], track, (view, length_unit(&self.ctx)));
        let selection = self.editor.selection();
        if self.live_settings.pivot == Pivot::Individual
            && let Some(live) = self.live.as_mut().filter(|live| live.id == OpId::Transform)
            && let Some(name) = match selection.kind() {
                Element::Face => Some("faces"),
                Element::Edge => Some("edges"),
                Element::Vertex | Element::Halfedge => None,
            }
        {
            // The parts are those of the elements, not of their vertices.
            live.given.insert(name.to_owned(), selection.ids().collect::<Vec<u32>>().into());
        }
        if self.live_settings.soft
            && let Some(live) = &self.live
        {
            fit_soft_radius(&mut self.live_settings, live, view);
        }
        if self.live.as_ref().is_some_and(Live::does_something) {
            self.show_live();
        }
    }

    /// Makes the live edit one undo step, or cancels it without a trace.
    pub fn end_live(&mut self, apply: bool) {
        let Some(live) = self.live.take() else { return };
        if apply && live.refused.is_none() {
            self.editor.commit_edit();
            // The bar has shown where the amount was limited; which elements have no mirror image it has not.
            if self.live_settings.symmetry != Symmetry::None && !live.warnings.is_empty() {
                self.warn(format!("{}: {}", live.label(), live.warnings.join("; ")), Vec::new());
            }
        } else {
            self.editor.cancel_edit();
        }
    }

    /// Shows the live edit in the document.
    fn show_live(&mut self) {
        let Some(live) = &self.live else { return };
        if !live.does_something() {
            // The amount is back at zero: the document is unchanged, and the edit continues.
            self.editor.cancel_edit();
            if let Some(live) = &mut self.live {
                (live.in_document, live.refused) = (false, None);
            }
            return;
        }
        let command = live.command(&self.live_settings);
        let result = command.and_then(|command| update_edit(self, command));
        if let Some(live) = &mut self.live {
            live.in_document = self.editor.is_editing();
            (live.warnings, live.refused) = match result {
                Ok(outcome) => (outcome.warnings, None),
                Err(error) => (Vec::new(), Some(error.reason())),
            };
        }
    }

    /// Handles the keys of a live edit, which come before all others. Returns whether an edit is in progress
    /// after them.
    pub fn live_keys(&mut self, ctx: &Context, view: &View) -> bool {
        let Some(live) = &mut self.live else { return false };
        if live.in_document && !self.editor.is_editing() {
            // An undo or a script ended the edit.
            self.live = None;
            return false;
        }
        let (changed, ending) = live.take_keys(ctx, &self.live_settings);
        if changed {
            live.update(&self.live_settings, view, Snap::default());
            self.show_live();
        }
        match ending {
            Some(Ending::Apply) => self.end_live(true),
            Some(Ending::Cancel) => abandon(self),
            None => {}
        }
        self.live.is_some()
    }

    /// Updates the amount from the pointer over the viewport.
    pub fn live_pointer(&mut self, pointer: Option<Pos2>, modifiers: Modifiers, view: &mut View) {
        let settings = self.live_settings;
        let held = keys::held_snap(&self.ctx);
        let now = self.ctx.input(|input| input.time);
        let (Some(live), Some(at)) = (&mut self.live, pointer) else { return };
        let is_other = std::mem::replace(&mut live.held_snap, held) != held && live.follows;
        if !live.follow_pointer(at, view, &settings, modifiers, now) && !is_other {
            return;
        }
        let snaps = held.is_some() || settings.snaps != modifiers.command;
        let snap_to = held.unwrap_or(settings.snap_to);
        let snap = match snap_to {
            _ if !snaps => Snap::Nothing,
            SnapTo::Steps => Snap::Steps,
            SnapTo::Grid => Snap::Grid,
            SnapTo::Vertex => snap_to_element(&self.editor, live, Element::Vertex, at, view),
            SnapTo::Edge => snap_to_element(&self.editor, live, Element::Edge, at, view),
            SnapTo::Face => snap_to_element(&self.editor, live, Element::Face, at, view),
        };
        let before = live.amount();
        live.update(&settings, view, snap);
        if live.amount() != before {
            self.show_live();
        }
    }

    /// Changes the live edit and the settings it goes by, and shows the result.
    pub fn change_live(&mut self, change: impl FnOnce(&mut Live, &mut Settings)) {
        let Some(live) = &mut self.live else { return };
        let before = (live.amount(), self.live_settings);
        change(live, &mut self.live_settings);
        if (live.amount(), self.live_settings) != before {
            self.show_live();
        }
    }
}

/// Shows the amount where the pointer last rested, while the pointer is over the edit's bar.
pub(crate) fn rest_on_bar(session: &mut Session) {
    let now = session.ctx.input(|input| input.time);
    if session.live.as_mut().is_some_and(|live| live.go_to_bar(now)) {
        session.show_live();
    }
}

/// Ends the live edit as Escape and a right-click do: without a trace, except that a loop cut may stay.
pub(crate) fn abandon(session: &mut Session) {
    let stays = keeps_cut(session);
    if stays {
        session.change_live(|live, _| live.set_to_rest());
    }
    session.end_live(stays);
}

/// Whether Escape and a right-click end only the slide of a loop cut and leave the cut in the middle, as in Blender.
pub(crate) fn keeps_cut(session: &Session) -> bool {
    let is_cut = session.live.as_ref().is_some_and(|live| live.id == OpId::LoopCut);
    is_cut && keys::map(&session.ctx).preset() == KeyPreset::Blender
}

/// Switches soft selection; an edit in progress shows it at once.
pub(crate) fn toggle_soft(session: &mut Session, view: &View) {
    if session.live.is_none() {
        session.live_settings.soft ^= true;
    }
    session.change_live(|live, settings| {
        settings.soft ^= true;
        fit_soft_radius(settings, live, view);
    });
}

/// Sets the soft selection's radius where there is none yet.
fn fit_soft_radius(settings: &mut Settings, live: &Live, view: &View) {
    settings.soft_radius.get_or_insert_with(|| live.sight(view).units_per_point() * SOFT_RADIUS_POINTS);
}

/// Makes the soft selection's radius larger by a length on the screen, in points, and switches soft selection on. 0 begins: it
/// finds where the selection is.
pub(crate) fn widen_soft(session: &mut Session, view: &View, by: f32) {
    if by == 0.0 || session.place.is_none() {
        session.place = SelectionPlace::of_selection(&session.editor);
    }
    let Some(place) = session.place else { return };
    let anchor = place.pivot(session.live_settings.pivot, view.cursor.in_scene(&session.editor));
    let unit = Sight { camera: &view.camera, size: view.size(), anchor }.units_per_point();
    let settings = &mut session.live_settings;
    settings.soft = true;
    let radius = settings.soft_radius.unwrap_or(unit * SOFT_RADIUS_POINTS);
    settings.soft_radius = Some((radius + by * unit).clamp(unit, unit * 1e5));
}

/// The point of the elements of a kind under the pointer that moved elements snap to. Other edits don't.
fn snap_to_element(editor: &Editor, live: &mut Live, kind: Element, at: Pos2, view: &mut View) -> Snap {
    let shown = editor.document().active().filter(|object| object.visible());
    let Some(object) = shown.filter(|_| live.drag == Drag::Offset) else { return Snap::Nothing };
    let (camera, local, size) = (view.camera, view.local(at), view.size());
    let aim = Aim { kind, radius: SNAP_RADIUS_POINTS, through: false };
    let moved = live.moved.get_or_insert_with(|| place::selected_vertices(editor));
    let target = viewport::snap((object.mesh(), view.tree(object)), &camera, size, local, aim, moved);
    target.map_or(Snap::Nothing, Snap::To)
}
