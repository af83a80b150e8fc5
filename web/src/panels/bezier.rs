//! The panel of a Bezier curve or surface: where its construction is, and its control points.

use editor::ops::BezierTessellate;
use editor::{Bezier, OpId};
use egui::{Button, DragValue, Grid, Label, RichText, ScrollArea, Slider, Ui, vec2};
use glam::Vec3;

use crate::actions::{self, Action};
use crate::app::App;
use crate::bezier::{ControlPoint, Drawn, active, levels, moved, position};
use crate::panels::menu_bar::explain;

impl App {
    /// The panel; nothing where the active object is a mesh.
    pub(crate) fn bezier_panel(&mut self, ui: &mut Ui) {
        let Some((object, bezier)) = active(&self.editor) else { return };
        let (name, bezier) = (object.name().to_owned(), bezier.clone());
        ui.label(RichText::new(bezier.name()).heading());
        let what = match &bezier {
            Bezier::Curve(curve) => match curve.points.len() {
                1 => "one control point".to_owned(),
                count => format!("{count} control points, degree {}", count.saturating_sub(1)),
            },
            Bezier::Surface(patches) => match patches.len() {
                1 => "one patch".to_owned(),
                count => format!("{count} patches"),
            },
        };
        ui.add(Label::new(RichText::new(format!("{name}: {what}")).weak()).truncate());
        ui.add_space(4.0);
        self.construction(ui, &bezier);
        ui.add_space(6.0);
        match &bezier {
            Bezier::Curve(curve) => self.curve_points(ui, &curve.points),
            Bezier::Surface(patches) => self.patch_points(ui, &bezier, patches.len()),
        }
        ui.add_space(6.0);
        self.bezier_buttons(ui, &bezier);
    }

    /// Sliders, the level, and playing.
    fn construction(&mut self, ui: &mut Ui, bezier: &Bezier) {
        let is_curve = bezier.curve().is_some();
        let width = (ui.available_width() - 96.0).max(60.0);
        ui.spacing_mut().slider_width = width;
        let parameters: &mut [(&str, &mut f32)] = match is_curve {
            true => &mut [("t", &mut self.player.t)],
            false => &mut [("u", &mut self.player.t), ("v", &mut self.player.v)],
        };
        let mut moved = false;
        for (name, value) in parameters {
            ui.horizontal(|ui| {
                let label = ui.label(RichText::new(*name).strong());
                // A limit to its decimals would round what playing sets, and call that a change.
                let slider =
                    Slider::new(&mut **value, 0.0..=1.0).custom_formatter(|number, _| format!("{number:.3}"));
                let hint = format!("Where the construction is drawn: {name} from 0 to 1");
                moved |= ui.add(slider).labelled_by(label.id).on_hover_text(hint).changed();
            });
        }
        if moved {
            self.player.playing = false;
        }
        let last = levels(bezier);
        ui.horizontal(|ui| {
            self.bezier_button(ui, Action::Play, if self.player.playing { "Pause" } else { "Play" });
            self.bezier_button(ui, Action::NextLevel, "Next level");
            ui.label(format!("{} of {last}", self.player.level))
                .on_hover_text("How many levels of de Casteljau's construction are drawn");
        });
        let level = self.player.level;
        let drawn = bezier.curve().map(|curve| Drawn::of(curve.points.len(), level));
        if let Some(left_out) = drawn.and_then(|drawn| drawn.left_out(level)) {
            ui.add(Label::new(RichText::new(left_out).small().weak()).wrap());
        }
        ui.horizontal(|ui| {
            let action = if is_curve { Action::WholeCurve } else { Action::ControlNets };
            let entry = actions::describe(action);
            let mut on = self.is_on(action).unwrap_or_default();
            if explain(ui.checkbox(&mut on, entry.label), ui, &entry, None).clicked() {
                self.act(action);
            }
        });
        if let Some(patch) = self.player.only_net(bezier) {
            let text = format!("Of so many patches only the net of the one below, {patch}, is drawn.");
            ui.add(Label::new(RichText::new(text).small().weak()).wrap());
        }
    }

    fn bezier_button(&mut self, ui: &mut Ui, action: Action, text: &str) {
        let why_not = self.why_not(action);
        let button = ui.add_enabled(why_not.is_none(), Button::new(text));
        if explain(button, ui, &actions::describe(action), why_not.as_deref()).clicked() {
            self.act(action);
        }
    }

    /// A curve's control points, each with spin boxes.
    fn curve_points(&mut self, ui: &mut Ui, points: &[Vec3]) {
        ui.label(RichText::new("Control points").strong());
        let height = ui.spacing().interact_size.y;
        ScrollArea::vertical().id_salt("control points").max_height(7.5 * (height + 6.0)).show_rows(
            ui,
            height,
            points.len(),
            |ui, rows| {
                for at in rows {
                    let Some(&place) = points.get(at) else { continue };
                    let point = ControlPoint::Curve(at);
                    ui.horizontal(|ui| {
                        let chosen = self.player.chosen == Some(point);
                        let row = Button::selectable(chosen, at.to_string()).min_size(vec2(30.0, 0.0));
                        let row = ui.add(row).accessible_name(format!("Control point {at}"));
                        if row.on_hover_text("Choose this control point").clicked() {
                            self.player.choose(if chosen { None } else { Some(point) });
                        }
                        self.control_point_boxes(ui, point, place, &format!("Point {at}"));
                    });
                }
            },
        );
        ui.horizontal(|ui| {
            self.bezier_button(ui, Action::AddPoint, "Add point");
            self.bezier_button(ui, Action::DeletePoint, "Delete point");
        });
    }

    /// A patch's control points as a grid to choose from, and spin boxes for the chosen one.
    fn patch_points(&mut self, ui: &mut Ui, bezier: &Bezier, patches: usize) {
        ui.horizontal(|ui| {
            let label = ui.label(RichText::new("Patch").strong());
            let mut patch = self.player.patch;
            let last = patches.saturating_sub(1);
            let spin = ui.add(DragValue::new(&mut patch).speed(0.1).range(0..=last)).labelled_by(label.id);
            if spin.on_hover_text("The patch that the construction is drawn on").changed() {
                self.player.patch = patch.min(last);
                self.player.chosen = None;
            }
            ui.label(RichText::new(format!("of 0 to {last}")).weak());
        });
        let patch = self.player.patch;
        Grid::new("control net").spacing(vec2(4.0, 4.0)).show(ui, |ui| {
            for row in 0..4 {
                for column in 0..4 {
                    let point = ControlPoint::Patch { patch, row, column };
                    let chosen = self.player.chosen == Some(point);
                    let button =
                        Button::selectable(chosen, format!("{row}, {column}")).min_size(vec2(48.0, 0.0));
                    let button = ui.add(button).accessible_name(format!("Control point {row}, {column}"));
                    if button.on_hover_text("Row and column of the patch; click to choose").clicked() {
                        self.player.choose(if chosen { None } else { Some(point) });
                    }
                }
                ui.end_row();
            }
        });
        let chosen = self.player.chosen.and_then(|point| Some((point, position(bezier, point)?)));
        match chosen {
            Some((point, place)) => {
                ui.horizontal(|ui| self.control_point_boxes(ui, point, place, "Point"));
            }
            None => {
                ui.label(RichText::new("Choose a control point here or in the viewport.").weak());
            }
        }
    }

    /// x, y and z of a control point. A drag or a typed number is one undo step.
    fn control_point_boxes(&mut self, ui: &mut Ui, point: ControlPoint, place: Vec3, name: &str) {
        let speed = self.view.drag_speed();
        let mut to = place;
        let (mut changed, mut done) = (false, false);
        let width = ((ui.available_width() - 16.0) / 3.0).clamp(44.0, 80.0);
        ui.spacing_mut().item_spacing.x = 4.0;
        for (axis, value) in ["x", "y", "z"].into_iter().zip([&mut to.x, &mut to.y, &mut to.z]) {
            let drag = DragValue::new(value)
                .speed(speed)
                .range(f32::MIN..=f32::MAX)
                .max_decimals(4)
                .update_while_editing(false);
            let spin = ui.add_sized(vec2(width, ui.spacing().interact_size.y), drag);
            let spin = spin.accessible_name(format!("{name} {axis}"));
            changed |= spin.changed();
            // Typed numbers, and steps of assistive tools, are whole edits of their own.
            done |= spin.drag_stopped() || (spin.changed() && !spin.dragged());
            spin.on_hover_text(format!("Position along {axis}: drag, or click to type"));
        }
        if changed && to.is_finite() {
            self.preview(moved(point, to));
        }
        if done {
            self.player.choose(Some(point));
            self.commit_preview();
        }
    }

    /// What a right click in the viewport offers.
    pub(crate) fn bezier_menu(&mut self, ui: &mut Ui) {
        ui.set_min_width(200.0);
        for action in [
            Action::AddPoint,
            Action::DeletePoint,
            Action::ElevateDegree,
            Action::SplitCurve,
            Action::NextLevel,
            Action::WholeCurve,
            Action::ControlNets,
            Action::Operation(OpId::BezierTessellate),
            Action::FrameAll,
        ] {
            self.menu_item(ui, &actions::describe(action));
        }
    }

    fn bezier_buttons(&mut self, ui: &mut Ui, bezier: &Bezier) {
        ui.horizontal_wrapped(|ui| match bezier {
            Bezier::Curve(_) => {
                self.bezier_button(ui, Action::ElevateDegree, "Elevate degree");
                self.bezier_button(ui, Action::SplitCurve, "Split at t");
            }
            Bezier::Surface(_) => {
                let mut resolution =
                    self.forms.tessellation.unwrap_or_else(|| BezierTessellate::default().resolution);
                let label = ui.label("Quads per side");
                let spin =
                    DragValue::new(&mut resolution).speed(0.1).range(1..=surface::bezier::MAX_RESOLUTION);
                if ui.add(spin).labelled_by(label.id).changed() {
                    self.forms.tessellation = Some(resolution);
                }
                let faces = resolution as usize * resolution as usize * bezier.patches().len();
                let why_not = self.why_not(Action::Operation(OpId::BezierTessellate));
                let button = ui.add_enabled(why_not.is_none(), Button::new("Tessellate"));
                let hint = format!(
                    "Makes a mesh of {} that everything can edit; the control points are given up",
                    crate::lists::columns::counted(halfedge::Element::Face, faces)
                );
                let reason = why_not.unwrap_or_default();
                if button.on_hover_text(hint).on_disabled_hover_text(reason).clicked() {
                    self.begin(BezierTessellate { resolution }.into(), None);
                }
            }
        });
        ui.add_space(2.0);
        let hint = match bezier {
            Bezier::Curve(_) => "Drag a control point to move it; double-click to add one.",
            Bezier::Surface(_) => "Drag a control point to move it.",
        };
        ui.add(Label::new(RichText::new(hint).small().weak()).wrap());
    }
}
