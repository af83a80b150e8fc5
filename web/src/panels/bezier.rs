//! The panel of a Bezier curve or surface: its construction and its control points.

use editor::ops::BezierTessellate;
use editor::{Bezier, OpId};
use egui::{Button, Grid, Label, RichText, ScrollArea, Slider, Ui, vec2};
use glam::Vec3;
use halfedge::words::thousands;

use crate::bezier::{ControlPoint, Controls, Drawn, Setting, active, levels, position};
use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::panels::menu_bar::{explain, menu_item};
use crate::panels::viewport::control_points::moved;
use crate::request::{Request, Requests};
use crate::units::Measure;
use crate::widgets::number_box::number_box;

/// Shows the panel, unless the active object is a mesh.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, tessellation: &mut Option<u32>, out: &mut Requests) {
    let Some((object, bezier)) = active(&page.editor) else { return };
    let name = object.name();
    ui.label(RichText::new(bezier.name()).heading());
    let what = match bezier {
        Bezier::Curve(curve) => match curve.points.len() {
            1 => "one control point".to_owned(),
            count => {
                format!("{} control points, degree {}", thousands(count), thousands(count.saturating_sub(1)))
            }
        },
        Bezier::Surface(patches) => match patches.len() {
            1 => "one patch".to_owned(),
            count => format!("{} patches", thousands(count)),
        },
    };
    ui.add(Label::new(RichText::new(format!("{name}: {what}")).weak()).truncate());
    ui.add_space(4.0);
    construction(ui, page, bezier, out);
    ui.add_space(6.0);
    match bezier {
        Bezier::Curve(curve) => curve_points(ui, page, &curve.points, out),
        Bezier::Surface(patches) => patch_points(ui, page, bezier, patches.len(), out),
    }
    ui.add_space(6.0);
    buttons(ui, page, bezier, tessellation, out);
}

/// The parameters, the level and the play button.
fn construction(ui: &mut Ui, page: &Page<'_>, bezier: &Bezier, out: &mut Requests) {
    let is_curve = bezier.curve().is_some();
    let width = (ui.available_width() - 96.0).max(60.0);
    ui.spacing_mut().slider_width = width;
    let Controls { t, v, .. } = page.player.controls;
    type Parameter = (&'static str, f32, fn(f32) -> Setting);
    let parameters: &[Parameter] =
        if is_curve { &[("t", t, Setting::T)] } else { &[("u", t, Setting::T), ("v", v, Setting::V)] };
    for &(name, mut value, setting) in parameters {
        ui.horizontal(|ui| {
            let label = ui.label(RichText::new(name).strong());
            // The slider must not round the value to its decimals, as that would count as a change while
            // playing.
            let slider =
                Slider::new(&mut value, 0.0..=1.0).custom_formatter(|number, _| format!("{number:.3}"));
            let hint = format!("The parameter {name} of the construction, from 0 to 1");
            if ui.add(slider).labelled_by(label.id).on_hover_text(hint).changed() {
                out.push(Request::Play(setting(value)));
            }
        });
    }
    let last = levels(bezier);
    ui.horizontal(|ui| {
        action_button(
            ui,
            page,
            Action::Play,
            if page.player.controls.playing { "Pause" } else { "Play" },
            out,
        );
        action_button(ui, page, Action::NextLevel, "Next level", out);
        ui.label(format!("{} of {last}", page.player.controls.level))
            .on_hover_text("The number of levels drawn of de Casteljau's construction");
    });
    let level = page.player.controls.level;
    let drawn = bezier.curve().map(|curve| Drawn::of(curve.points.len(), level));
    if let Some(left_out) = drawn.and_then(|drawn| drawn.left_out(level)) {
        ui.add(Label::new(RichText::new(left_out).small().weak()).wrap());
    }
    ui.horizontal(|ui| {
        let action = if is_curve { Action::WholeCurve } else { Action::ControlNets };
        let entry = actions::describe(action);
        let mut on = page.is_on(action).unwrap_or_default();
        if explain(ui.checkbox(&mut on, entry.label), ui, &entry, None).clicked() {
            out.act(action);
        }
    });
    if let Some(patch) = page.player.only_net(bezier) {
        let text = format!("Too many patches to draw all nets; only that of patch {patch} is drawn.");
        ui.add(Label::new(RichText::new(text).small().weak()).wrap());
    }
}

fn action_button(ui: &mut Ui, page: &Page<'_>, action: Action, text: &str, out: &mut Requests) {
    let why_not = page.why_not(action);
    let button = ui.add_enabled(why_not.is_none(), Button::new(text));
    if explain(button, ui, &actions::describe(action), why_not.as_deref()).clicked() {
        out.act(action);
    }
}

/// A curve's control points, each with spin boxes.
fn curve_points(ui: &mut Ui, page: &Page<'_>, points: &[Vec3], out: &mut Requests) {
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
                    let chosen = page.player.controls.chosen == Some(point);
                    let row = Button::selectable(chosen, at.to_string()).min_size(vec2(30.0, 0.0));
                    let row = ui.add(row).accessible_name(format!("Control point {at}"));
                    if row.on_hover_text("Choose this control point").clicked() {
                        choose(if chosen { None } else { Some(point) }, out);
                    }
                    control_point_boxes(ui, page, point, place, &format!("Point {at}"), out);
                });
            }
        },
    );
    ui.horizontal(|ui| {
        action_button(ui, page, Action::AddPoint, "Add point", out);
        action_button(ui, page, Action::DeletePoint, "Delete point", out);
    });
}

/// A patch's control points as a grid to choose from, with spin boxes for the chosen one.
fn patch_points(ui: &mut Ui, page: &Page<'_>, bezier: &Bezier, patches: usize, out: &mut Requests) {
    let choose_patch = |ui: &mut Ui| {
        let label = ui.label(RichText::new("Patch").strong());
        let mut patch = page.player.controls.patch;
        let last = patches.saturating_sub(1);
        let spin = ui
            .add(number_box(ui, &mut patch, Measure::Number).speed(0.1).range(0..=last))
            .labelled_by(label.id);
        if spin.on_hover_text("The patch that the construction is drawn on").changed() {
            out.push(Request::Play(Setting::Patch(patch.min(last))));
        }
        ui.label(RichText::new(format!("of patches 0 to {last}")).weak());
    };
    // Of a single patch there is nothing to choose.
    if patches > 1 {
        ui.horizontal(choose_patch);
    } else {
        ui.label(RichText::new("Control points").strong());
    }
    let patch = page.player.controls.patch;
    Grid::new("control net").spacing(vec2(4.0, 4.0)).show(ui, |ui| {
        for row in 0..4 {
            for column in 0..4 {
                let point = ControlPoint::Patch { patch, row, column };
                let chosen = page.player.controls.chosen == Some(point);
                let button = Button::selectable(chosen, format!("{row}, {column}")).min_size(vec2(48.0, 0.0));
                let button = ui.add(button).accessible_name(format!("Control point {row}, {column}"));
                if button.on_hover_text("Row and column of the patch; click to choose").clicked() {
                    choose(if chosen { None } else { Some(point) }, out);
                }
            }
            ui.end_row();
        }
    });
    let chosen = page.player.controls.chosen.and_then(|point| Some((point, position(bezier, point)?)));
    match chosen {
        Some((point, place)) => {
            ui.horizontal(|ui| control_point_boxes(ui, page, point, place, "Point", out));
        }
        None => {
            ui.label(RichText::new("Choose a control point here or in the viewport.").weak());
        }
    }
}

/// The spin boxes for x, y and z of a control point. A drag or a typed number is one undo step.
fn control_point_boxes(
    ui: &mut Ui,
    page: &Page<'_>,
    point: ControlPoint,
    place: Vec3,
    name: &str,
    out: &mut Requests,
) {
    let speed = page.view.drag_speed();
    let offset = page.editor.document().offset();
    let mut shown = place.as_dvec3() + offset;
    let (mut changed, mut done) = (false, false);
    let width = ((ui.available_width() - 16.0) / 3.0).clamp(44.0, 80.0);
    ui.spacing_mut().item_spacing.x = 4.0;
    for (axis, value) in ["x", "y", "z"].into_iter().zip([&mut shown.x, &mut shown.y, &mut shown.z]) {
        let drag = number_box(ui, value, Measure::Length)
            .speed(speed)
            .range(f64::from(f32::MIN)..=f64::from(f32::MAX))
            .max_decimals(4);
        let spin = ui.add_sized(vec2(width, ui.spacing().interact_size.y), drag);
        let spin = spin.accessible_name(format!("{name} {axis}"));
        changed |= spin.changed();
        // A typed number, or a step by an assistive tool, is an edit of its own.
        done |= spin.drag_stopped() || (spin.changed() && !spin.dragged());
        spin.on_hover_text(format!("Position along {axis}: drag, or click to type"));
    }
    let to = (shown - offset).as_vec3();
    if changed && to.is_finite() {
        out.update_edit(moved(point, to));
    }
    if done {
        choose(Some(point), out);
        out.push(Request::CommitEdit);
    }
}

/// The context menu of the viewport.
pub(crate) fn menu(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
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
        menu_item(ui, page, &actions::describe(action), out);
    }
}

fn buttons(
    ui: &mut Ui,
    page: &Page<'_>,
    bezier: &Bezier,
    tessellation: &mut Option<u32>,
    out: &mut Requests,
) {
    ui.horizontal_wrapped(|ui| match bezier {
        Bezier::Curve(_) => {
            action_button(ui, page, Action::ElevateDegree, "Elevate degree", out);
            action_button(ui, page, Action::SplitCurve, "Split at t", out);
        }
        Bezier::Surface(_) => {
            let mut resolution = tessellation.unwrap_or_else(|| BezierTessellate::default().resolution);
            let label = ui.label("Quads per side");
            let spin = number_box(ui, &mut resolution, Measure::Number)
                .speed(0.1)
                .range(surface::bezier::RESOLUTION_RANGE.whole_bounds());
            if ui.add(spin).labelled_by(label.id).changed() {
                *tessellation = Some(resolution);
            }
            let faces = resolution as usize * resolution as usize * bezier.patches().len();
            let why_not = page.why_not(Action::Operation(OpId::BezierTessellate));
            let button = ui.add_enabled(why_not.is_none(), Button::new("Tessellate"));
            let hint = format!(
                "Replace the control points by a mesh of {}, which every operation can edit",
                crate::lists::columns::counted(halfedge::Element::Face, faces)
            );
            let reason = why_not.unwrap_or_default();
            if button.on_hover_text(hint).on_disabled_hover_text(reason).clicked() {
                out.run(BezierTessellate { resolution });
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

/// Requests that a control point be chosen, or none.
fn choose(point: Option<ControlPoint>, out: &mut Requests) {
    out.push(Request::Play(Setting::Chosen(point)));
}
