//! Carrying out the actions that menus, keys, buttons and the palette start.

use editor::ops::{
    BezierDeletePoint, BezierElevateDegree, BezierInsertPoint, BezierSplit, Remesh, Reveal, Simplify,
    SubdivideCatmullClark, SubdivideLoop, four_digits,
};
use editor::{Command, OpId, SelectBy, SelectMode};
use egui::ThemePreference;
use formats::Format;
use halfedge::{Element, HalfedgeId, Mesh};

use super::{App, camera, key_settings, layout, length_unit, theme_setting, transforming};
use crate::bezier::{self, ControlPoint};
use crate::input::actions::Action;
use crate::input::availability::{follows_pointer, opens_form};
use crate::keeping::SavedView;
use crate::live::edit::{Live, Start};
use crate::page_view::Page;
use crate::panels::operations::EDGE_LENGTH;
use crate::panels::viewport::ZOOM_PER_NOTCH;
use crate::panels::viewport::control_points::add_control_point;
use crate::session::{form, guide, live, saving, selecting};
use crate::transforming::Gizmo;
use crate::view::{Tool, flying, pane::Split};
use viewport::Shading;

/// How much larger one press of a key makes the selecting circle.
const CIRCLE_RADIUS_FACTOR: f32 = 1.25;

impl App {
    /// The state that panels read.
    pub(super) fn page(&self) -> Page<'_> {
        Page { session: &self.session, shown: &self.shown, view: &self.view, player: &self.player }
    }

    /// Starts an action. If it can't be done, says why.
    pub(super) fn act(&mut self, action: Action) {
        // The key of a move, pressed again while it goes on, slides.
        let is_moving = self.session.by_key && self.session.live.as_ref().is_some_and(Live::is_move);
        let action =
            if is_moving && action == Action::Move { Action::Operation(OpId::SlideEdges) } else { action };
        let action = action.for_selection(self.session.editor.selection().kind());
        // What is still being looked for comes first.
        if !matches!(action, Action::Cancel) {
            selecting::finish_selecting(&mut self.session);
        }
        // Opening dismisses it when a file is picked; it offers the keys itself.
        if !matches!(action, Action::Welcome | Action::Open | Action::UseKeys(_)) {
            self.shown.welcome = false;
        }
        if let Some(reason) = self.page().why_not(action) {
            // Keys can start actions that menus grey out.
            if !matches!(action, Action::Cancel) {
                self.session.warn(reason, Vec::new());
            }
            return;
        }
        let now = self.session.ctx.input(|input| input.time);
        if flying::give_way(&mut self.view, action, now) {
            return;
        }
        let cameras = self.view.cameras();
        if action.moves_view() {
            self.view.activate(self.view.panes.current);
        }
        match action {
            Action::New => self.session.new_document(form::first_shape()),
            Action::ElementMenu(_) | Action::LookMenu | Action::CursorMenu => {
                let at = self.session.ctx.input(|input| input.pointer.latest_pos());
                self.panels.pointer_menu.open(action, at.unwrap_or(self.view.area.center()));
            }
            Action::Open => self.session.platform.open_file_dialog(),
            Action::Save => self.save(),
            Action::SaveAs(format) => self.show_saving(Some(format)),
            Action::Undo => self.session.undo(),
            Action::Redo => self.session.redo(),
            Action::History => self.shown.toggle_history(),
            Action::Adjust => {
                self.panels.forms.adjust_last();
                self.shown.right = true;
                self.shown.sheet.show_operations();
            }
            Action::Cancel => self.cancel(),
            Action::SelectAll => {
                self.panels.end_edits(&mut self.session);
                self.session.editor.select_all(self.shown.kind);
            }
            Action::SelectNone => {
                self.panels.end_edits(&mut self.session);
                self.session.editor.deselect();
            }
            Action::SelectInverse => {
                self.panels.end_edits(&mut self.session);
                self.session.editor.select_inverse(self.shown.kind);
            }
            Action::SelectBy(by) => self.select_further(|editor| editor.begin_select_by(by)),
            Action::LinkedUnder => match self.view.hovered {
                Some((kind, id)) => {
                    self.select(kind, [id], SelectMode::Extend);
                    self.select_further(|editor| editor.begin_select_by(SelectBy::Linked));
                }
                None => self.session.warn("Point at an element first.".to_owned(), Vec::new()),
            },
            Action::Preset(preset) => {
                let [_, _, to_eye] = self.view.camera.axes().map(|axis| -axis);
                self.session.begin(preset.command(to_eye), None);
            }
            Action::NamedSelections => self.shown.named ^= true,
            Action::Share => self.shown.share ^= true,
            Action::Documents => crate::keeping::toggle_list(&mut self.session, &mut self.shown),
            Action::Show(kind) => self.show_kind(kind, false),
            Action::Expand(kind) => self.show_kind(kind, true),
            Action::NextElement => self.step(true),
            Action::PreviousElement => self.step(false),
            Action::Next => self.walk(|mesh, h| mesh.next(h)),
            Action::Previous => self.walk(|mesh, h| mesh.prev(h)),
            Action::Twin => self.walk(|_, h| h.twin()),
            Action::VertexOf => {
                self.select_of_halfedge(|mesh, h| Some((Element::Vertex, mesh.from(h).raw())))
            }
            Action::EdgeOf => self.select_of_halfedge(|_, h| Some((Element::Edge, h.edge().raw()))),
            Action::FaceOf => {
                self.select_of_halfedge(|mesh, h| Some((Element::Face, mesh.face_of(h)?.raw())))
            }
            Action::GoToId => {
                self.shown.left = true;
                self.shown.sheet.show_lists();
                self.panels.lists.focus_go_to = true;
            }
            Action::OnlySelected => self.shown.only_selected ^= true,
            Action::SelectTool => {
                self.view.tool = Tool::Orbit;
                self.session.live_settings.gizmo = Gizmo::Off;
            }
            Action::BoxSelect => self.view.switch_tool(Tool::Box),
            Action::LassoSelect => self.view.switch_tool(Tool::Lasso),
            Action::CircleSelect => self.view.switch_tool(Tool::Circle),
            Action::LoopCutTool => self.view.switch_tool(Tool::LoopCut),
            Action::LargerCircle => self.view.scale_circle(CIRCLE_RADIUS_FACTOR),
            Action::SmallerCircle => self.view.scale_circle(1.0 / CIRCLE_RADIUS_FACTOR),
            Action::Frame => self.view.frame_selection(&self.session.editor),
            Action::FrameAll => self.view.frame_all(),
            Action::ResetView => self.view.reset(),
            Action::ZoomIn => self.view.zoom_step(ZOOM_PER_NOTCH),
            Action::ZoomOut => self.view.zoom_step(1.0 / ZOOM_PER_NOTCH),
            Action::LookFrom(side) => self.view.camera.look_from(side),
            Action::UpAxis(up) => layout::set_up_axis(&mut self.session, &mut self.view, up),
            Action::AlignView => {
                if !self.view.align(&self.session.editor) {
                    let text = "The selection faces no side. Select a face, or elements beside faces.";
                    self.session.warn(text.to_owned(), Vec::new());
                }
            }
            Action::Fly => {
                self.session.end_live(true);
                flying::start(&mut self.view, &self.session.ctx);
            }
            Action::Orthographic => self.view.camera.orthographic ^= true,
            // The same again shows one view.
            Action::Views(split) if self.shown.split == split => self.shown.split = Split::One,
            Action::Views(split) => self.shown.split = split,
            Action::Camera(style) => camera::choose(&mut self.session, &mut self.view, Some(style)),
            Action::CameraOfKeys => camera::choose(&mut self.session, &mut self.view, None),
            Action::FreeRotation => camera::toggle_rotation(&mut self.session, &mut self.view),
            Action::OrbitAbout(about) => camera::orbit_about(&mut self.session, &mut self.view, about),
            Action::Wireframe => self.view.style.wireframe ^= true,
            Action::XRay => self.view.style.x_ray ^= true,
            Action::Smooth | Action::AutoSmooth(_) => {
                let is_on = self.page().is_on(action) == Some(true);
                self.view.style.shading = match action {
                    _ if is_on => Shading::Flat,
                    Action::AutoSmooth(degrees) => Shading::Auto(degrees.into()),
                    _ => Shading::Smooth,
                };
            }
            Action::ColorBy(by) => self.view.style.color_by = by,
            Action::Look(look) => self.view.textures.choose_look(&mut self.view.style, look),
            Action::HideBacks => self.view.style.cull ^= true,
            Action::Mark(mark) => self.view.style.marks = self.view.style.marks.toggled(mark),
            Action::Shadow => self.view.style.shadow ^= true,
            Action::Dots => self.view.style.vertices ^= true,
            Action::Grid => self.view.style.grid ^= true,
            Action::Overlay => self.shown.overlay ^= true,
            Action::Numbers => self.shown.numbers ^= true,
            Action::LeftPanel => self.shown.left ^= true,
            Action::RightPanel => self.shown.right ^= true,
            Action::AddToSelection => self.shown.adds ^= true,
            Action::Arrange(arrangement) => self.arrange(arrangement),
            Action::InterfaceScale(percent) => self.set_scale(percent),
            Action::LengthUnit(unit) => length_unit::choose(&mut self.session, unit),
            Action::SystemTheme => theme_setting::choose(&mut self.session, ThemePreference::System),
            Action::LightTheme => theme_setting::choose(&mut self.session, ThemePreference::Light),
            Action::DarkTheme => theme_setting::choose(&mut self.session, ThemePreference::Dark),
            Action::UseKeys(preset) => key_settings::choose(&mut self.session, preset),
            Action::Welcome => self.shown.welcome ^= true,
            Action::Shortcuts => self.shown.shortcuts ^= true,
            Action::Palette => self.panels.palette.show(),
            Action::Messages => {
                self.shown.messages ^= true;
                self.session.toasts.errors_are_read();
            }
            Action::About => self.shown.about ^= true,
            Action::Guide => guide::open(&mut self.session),
            Action::Update => self.session.platform.update(),
            Action::Upsample => {
                let command = self.upsampling();
                self.session.begin(command, None);
            }
            Action::Downsample => self.session.begin(Simplify::to_ratio(0.25).into(), None),
            Action::Resample => {
                let command = match self.panels.forms.filled(OpId::Remesh) {
                    Some(filled) => form::command(OpId::Remesh, filled),
                    None => Ok(Remesh::default().into()),
                };
                self.session.begin_or_refuse(command);
            }
            Action::LongerEdges => self.scale_target_edge(1.1),
            Action::ShorterEdges => self.scale_target_edge(1.0 / 1.1),
            Action::SlideSplit => self.start_live(OpId::SplitEdge, ""),
            Action::Move => self.start_live(OpId::Transform, "translate"),
            Action::Rotate => self.start_live(OpId::Transform, "rotate"),
            Action::Scale => self.start_live(OpId::Transform, "scale"),
            Action::Soft => live::toggle_soft(&mut self.session, &self.view),
            Action::Gizmo(_) | Action::Snap | Action::SnapTo(_) => transforming::choose(self, action),
            Action::PivotAt(_) | Action::Cursor(_) => transforming::choose(self, action),
            Action::Mirror(_) | Action::Orient(_) => transforming::choose(self, action),
            Action::NewCurve => self.session.new_document(form::shape("bezier-curve")),
            Action::NewPatch => self.session.new_document(form::shape("bezier-patch")),
            Action::NextLevel | Action::Play => {
                if let Some((_, bezier)) = bezier::active(&self.session.editor) {
                    match action {
                        Action::Play => self.player.play(bezier),
                        _ => self.player.next_level(bezier),
                    }
                }
            }
            Action::WholeCurve => self.player.controls.whole ^= true,
            Action::ControlNets => self.player.controls.nets ^= true,
            Action::AddPoint => {
                if let Some(insert) = add_control_point(&self.session.editor, &self.player) {
                    self.insert_control_point(insert);
                }
            }
            Action::DeletePoint => self.delete_control_point(),
            Action::ElevateDegree => self.session.begin(BezierElevateDegree::default().into(), None),
            Action::SplitCurve => self.session.begin(BezierSplit { t: self.player.controls.t }.into(), None),
            // Isolating nothing ends isolating.
            Action::Operation(OpId::Isolate) if self.session.editor.selection().is_empty() => {
                self.session.begin(Reveal::default().into(), None);
            }
            // An operation with an amount follows the pointer; its form stays in the operations panel.
            Action::Operation(id) if follows_pointer(id) => self.start_live(id, ""),
            Action::Operation(id) if opens_form(id) => self.open_form(id),
            Action::Operation(id) => {
                self.session.begin_or_refuse(Command::from_fields(id, Default::default()))
            }
        }
        if action.moves_view() {
            let moved = self.view.cameras();
            self.view.glides.start(cameras, &moved, now);
        }
        self.session.ctx.request_repaint();
    }

    /// Shows an operation's form, and the panel that it is in.
    pub(super) fn open_form(&mut self, id: OpId) {
        self.panels.forms.open(id);
        self.shown.right = true;
        self.shown.sheet.show_operations();
    }

    /// Starts an edit that follows the pointer, which sets this field of the operation.
    fn start_live(&mut self, id: OpId, field: &'static str) {
        self.session.start_live(&Start::new(id, field), &self.view);
    }

    /// The subdivision that the Upsample action runs.
    pub(super) fn upsampling(&self) -> Command {
        let triangles = match (self.session.survey.found(), self.session.editor.mesh()) {
            (Some(found), _) => found.triangles_only,
            // The survey has not counted the corners yet, so the faces are checked here.
            (None, Some(mesh)) => mesh.faces().all(|f| mesh.face_halfedges(f).take(4).count() == 3),
            (None, None) => false,
        };
        if triangles { SubdivideLoop::default().into() } else { SubdivideCatmullClark::default().into() }
    }

    fn scale_target_edge(&mut self, factor: f64) {
        let facts = self.session.facts(OpId::Remesh);
        let now = self.panels.forms.target_edge().or(facts.remeshed_edge());
        let Some(length) = now.filter(|length| *length > 0.0) else { return };
        let length = four_digits((length * factor).clamp(1e-6, 1e6));
        self.panels.forms.fill(OpId::Remesh, &facts, EDGE_LENGTH, length.into());
    }

    /// Saves the document to the file that it was opened from, if the browser allows that, or else opens the save dialog.
    fn save(&mut self) {
        self.end_preview();
        if !saving::save(&mut self.session, SavedView::of(&self.view).to_json()) {
            self.show_saving(None);
        }
    }

    /// Opens the save dialog, in the given format or the one that suits the document.
    fn show_saving(&mut self, format: Option<Format>) {
        // A preview is not saved, so the losses must not count it.
        self.end_preview();
        self.panels.saving.show(self.session.editor.document(), format);
    }

    /// Adds a control point to the active curve and selects it in the panel.
    pub(super) fn insert_control_point(&mut self, insert: BezierInsertPoint) {
        let index = insert.index.unwrap_or_default() as usize;
        let place = insert.position.into();
        self.session.begin(insert.into(), None);
        let point = ControlPoint::Curve(index);
        let exists = bezier::active(&self.session.editor)
            .is_some_and(|(_, bezier)| bezier::position(bezier, point) == Some(place));
        if exists {
            self.player.controls.choose(Some(point));
        }
    }

    /// Deletes the chosen control point of the active curve.
    fn delete_control_point(&mut self) {
        if let Some(ControlPoint::Curve(at)) = self.player.controls.chosen {
            self.session.begin(BezierDeletePoint { index: at as u32 }.into(), None);
            // The next point has taken over the deleted one's index, but was not chosen.
            self.player.controls.choose(None);
        }
    }

    /// Escape: cancels the innermost thing in progress.
    fn cancel(&mut self) {
        if self.session.editor.stop_jump() || selecting::cancel_selecting(&mut self.session) {
            return;
        }
        if self.view.cancel_gesture() | self.session.editor.cancel_edit().is_some() {
            return;
        }
        if self.shown.close_windows() || self.panels.forms.close() {
            return;
        }
        if let Some(id) = self.session.jobs.latest() {
            self.session.cancel_job(id);
        } else if self.view.tool != Tool::Orbit {
            self.view.tool = Tool::Orbit;
        } else if self.player.controls.chosen.take().is_none() {
            self.session.editor.deselect();
        }
    }

    /// Changes the selection by what is selected or under the pointer; says why not where it can't.
    pub(super) fn select_further(
        &mut self,
        select: impl FnOnce(&mut editor::Editor) -> Result<(), editor::CommandError>,
    ) {
        if !self.panels.end_edits(&mut self.session) {
            return;
        }
        if let Err(error) = select(&mut self.session.editor) {
            self.session.refuse(&error);
        }
    }

    /// Shows a kind of element and converts the selection to it.
    fn show_kind(&mut self, kind: Element, touches: bool) {
        if !self.session.editor.selection().is_empty() {
            self.panels.end_edits(&mut self.session);
        }
        self.session.editor.switch_kind(kind, touches);
        self.shown.kind = kind;
    }

    /// Selects the element with the next or the previous id, of the kind in the list.
    fn step(&mut self, forward: bool) {
        let kind = self.shown.kind;
        let selection = self.session.editor.selection();
        let at = selection.latest().filter(|_| selection.kind() == kind);
        let next = self.panels.lists.beside(kind, at, forward);
        if let Some(id) = next {
            self.select(kind, [id], SelectMode::Replace);
        }
    }

    /// Selects what belongs to the selected half-edge.
    fn select_of_halfedge(&mut self, find: impl Fn(&Mesh, HalfedgeId) -> Option<(Element, u32)>) {
        let selected = self.session.selected_halfedge();
        let found = selected.and_then(|h| find(self.session.editor.mesh()?, h));
        if let Some((kind, id)) = found {
            self.select(kind, [id], SelectMode::Replace);
        }
    }

    fn walk(&mut self, step: impl Fn(&Mesh, HalfedgeId) -> HalfedgeId) {
        self.select_of_halfedge(|mesh, h| Some((Element::Halfedge, step(mesh, h).raw())));
    }
}
