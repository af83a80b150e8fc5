//! From actions, keys and buttons to commands, and from their results back to the person.

use editor::ops::{
    BezierElevateDegree, BezierSplit, Remesh, Simplify, SubdivideCatmullClark, SubdivideLoop, four_digits,
};
use editor::{
    Begun, Command, CommandError, Finished, JobId, JobRequest, JobResult, MessageKind, OpId, SelectMode,
};
use egui::{Context, Event, ThemePreference};
use formats::Format;
use halfedge::Element;

use crate::actions::Action;
use crate::app::{App, ShownKind};
use crate::availability::opens_form;
use crate::bezier;
use crate::keys;
use crate::panels::fields;
use crate::platform::{Fetched, NamedBytes};
use crate::scripting::{Answer, Reply};
use crate::viewport_widget::Tool;

/// The field of remeshing that the keys for longer and shorter edges change.
const EDGE_LENGTH: &str = "edge_length";

/// Yaw and pitch of a view on the plane that flat curves lie in.
const FROM_ABOVE: (f64, f64) = (0.0, 0.0);

impl App {
    /// The document that the page opens on.
    pub(crate) fn open_first(&mut self) {
        // The first shape can't be refused; were it, the page would open empty and say how to go on.
        let shape = fields::initial(OpId::New.spec(), &editor::Facts::default());
        let _ = fields::command(OpId::New, &shape).and_then(|command| self.editor.start_with(command));
        self.follow();
        self.view.frame_all();
    }

    /// What keys start, and pasted text.
    pub(crate) fn keyboard(&mut self, ctx: &Context) {
        if !ctx.text_edit_focused() {
            let pasted = ctx.input_mut(|input| {
                let at = input.events.iter().position(|event| matches!(event, Event::Paste(_)))?;
                match input.events.remove(at) {
                    Event::Paste(text) => Some(text),
                    _ => None,
                }
            });
            if let Some(text) = pasted.filter(|text| !text.trim().is_empty()) {
                self.open_files(vec![NamedBytes::new("Pasted.obj", text.into_bytes())], None);
            }
        }
        if self.palette.open || self.saving.is_open() {
            return;
        }
        // Escape closes an open menu, which egui does by itself.
        let menu = egui::Popup::is_any_open(ctx);
        for action in keys::pressed(ctx, menu, bezier::active(&self.editor).is_some()) {
            self.act(action);
        }
    }

    /// Starts an action, from wherever it was chosen. One that can't be done says why.
    pub(crate) fn act(&mut self, action: Action) {
        let action = match action {
            Action::Operation(id) => Action::Operation(id.for_selection(self.editor.selection().kind())),
            other => other,
        };
        if let Some(reason) = self.why_not(action) {
            // Keys reach actions that menus show greyed.
            if !matches!(action, Action::Cancel) {
                self.toast(MessageKind::Warning, reason, Vec::new());
            }
            return;
        }
        match action {
            Action::Open => self.platform.open_file_dialog(),
            Action::Save => self.show_saving(None),
            Action::SaveAs(format) => self.show_saving(Some(format)),
            Action::Undo => self.step(true),
            Action::Redo => self.step(false),
            Action::Cancel => self.cancel(),
            Action::SelectAll => {
                self.end_preview();
                self.editor.select_all(self.lists.kind.0);
            }
            Action::SelectNone => self.editor.deselect(),
            Action::SelectInverse => self.select_inverse(),
            Action::Show(kind) => self.show_kind(kind),
            Action::Next => self.walk(|mesh, h| mesh.next(h)),
            Action::Twin => self.walk(|_, h| h.twin()),
            Action::GoToId => {
                self.shown.left = true;
                self.shown.sheet.show_lists();
                self.lists.focus_go_to = true;
            }
            Action::OnlySelected => self.lists.only_selected ^= true,
            Action::BoxSelect => {
                self.view.tool = if self.view.tool == Tool::Box { Tool::Orbit } else { Tool::Box };
            }
            Action::Frame => self.view.frame_selection(&self.editor),
            Action::FrameAll => self.view.frame_all(),
            Action::ResetView => self.view.reset(),
            Action::Orthographic => self.view.camera.orthographic ^= true,
            Action::Wireframe => self.view.style.wireframe ^= true,
            Action::Smooth => self.view.style.smooth ^= true,
            Action::Dots => self.view.style.vertices ^= true,
            Action::Grid => self.view.style.grid ^= true,
            Action::Overlay => self.shown.overlay ^= true,
            Action::LeftPanel => self.shown.left ^= true,
            Action::RightPanel => self.shown.right ^= true,
            Action::SystemTheme => self.set_theme(ThemePreference::System),
            Action::LightTheme => self.set_theme(ThemePreference::Light),
            Action::DarkTheme => self.set_theme(ThemePreference::Dark),
            Action::Shortcuts => self.shown.shortcuts ^= true,
            Action::Palette => self.palette.show(),
            Action::Messages => self.shown.messages ^= true,
            Action::About => self.shown.about ^= true,
            Action::Upsample => {
                let command = self.upsampling();
                self.begin(command, None);
            }
            Action::Downsample => self.begin(Simplify::to_ratio(0.25).into(), None),
            Action::Resample => {
                let command = match self.forms.filled(OpId::Remesh) {
                    Some(filled) => fields::command(OpId::Remesh, filled),
                    None => Ok(Remesh::default().into()),
                };
                self.begin_or_refuse(command);
            }
            Action::LongerEdges => self.scale_target_edge(1.1),
            Action::ShorterEdges => self.scale_target_edge(1.0 / 1.1),
            Action::SlideSplit => self.start_live(OpId::SplitEdge),
            Action::NextLevel | Action::Play => {
                if let Some((_, bezier)) = bezier::active(&self.editor) {
                    match action {
                        Action::Play => self.player.play(bezier),
                        _ => self.player.next_level(bezier),
                    }
                }
            }
            Action::WholeCurve => self.player.whole ^= true,
            Action::ControlNets => self.player.nets ^= true,
            Action::AddPoint => self.add_control_point(),
            Action::DeletePoint => self.delete_control_point(),
            Action::ElevateDegree => self.begin(BezierElevateDegree::default().into(), None),
            Action::SplitCurve => self.begin(BezierSplit { t: self.player.t }.into(), None),
            // What has an amount follows the pointer; its form stays in the operations panel.
            Action::Operation(id) if opens_form(id) && id.spec().dragged_field().is_some() => {
                self.start_live(id);
            }
            Action::Operation(id) if opens_form(id) => {
                self.forms.choose(id);
                self.shown.right = true;
                self.shown.sheet.show_operations();
            }
            Action::Operation(id) => self.begin_or_refuse(Command::from_fields(id, Default::default())),
        }
        self.follow();
        self.ctx.request_repaint();
    }

    /// Whether a switch among the actions is on; none for those that are no switches.
    pub(crate) fn is_on(&self, action: Action) -> Option<bool> {
        let style = &self.view.style;
        Some(match action {
            Action::Show(kind) => self.lists.kind.0 == kind,
            Action::OnlySelected => self.lists.only_selected,
            Action::BoxSelect => self.view.tool == Tool::Box,
            Action::Orthographic => self.view.camera.orthographic,
            Action::Wireframe => style.wireframe,
            Action::Smooth => style.smooth,
            Action::Dots => style.vertices,
            Action::Grid => style.grid,
            Action::Overlay => self.shown.overlay,
            Action::LeftPanel => self.shown.left,
            Action::RightPanel => self.shown.right,
            Action::WholeCurve => self.player.whole,
            Action::ControlNets => self.player.nets,
            Action::Play => self.player.playing,
            Action::SystemTheme => self.theme_preference() == ThemePreference::System,
            Action::LightTheme => self.theme_preference() == ThemePreference::Light,
            Action::DarkTheme => self.theme_preference() == ThemePreference::Dark,
            _ => return None,
        })
    }

    fn theme_preference(&self) -> ThemePreference {
        self.ctx.options(|options| options.theme_preference)
    }

    /// The subdivision that the upsample key makes.
    pub(crate) fn upsampling(&self) -> Command {
        let triangles = match (self.survey.found(), self.editor.mesh()) {
            (Some(found), _) => found.triangles_only,
            // Not counted yet: look.
            (None, Some(mesh)) => mesh.faces().all(|f| mesh.face_halfedges(f).take(4).count() == 3),
            (None, None) => false,
        };
        if triangles { SubdivideLoop::default().into() } else { SubdivideCatmullClark::default().into() }
    }

    /// The edge length that resampling aims at, where it was set; else it is the mean of the edges.
    pub(crate) fn target_edge(&self) -> Option<f64> {
        self.forms.filled(OpId::Remesh)?.get(EDGE_LENGTH)?.as_f64()
    }

    fn scale_target_edge(&mut self, factor: f64) {
        let facts = self.facts(OpId::Remesh);
        let now = self.target_edge().or(facts.mean_edge);
        let Some(length) = now.filter(|length| *length > 0.0) else { return };
        let length = four_digits((length * factor).clamp(1e-6, 1e6));
        self.forms.fill(OpId::Remesh, &facts, EDGE_LENGTH, length.into());
    }

    /// Carries out a command that a form made, or says why it made none.
    pub(crate) fn begin_or_refuse(&mut self, command: Result<Command, CommandError>) {
        match command {
            Ok(command) => self.begin(command, None),
            Err(error) => self.refused(&error, None),
        }
    }

    /// Carries out a command, or starts its job.
    pub(crate) fn begin(&mut self, command: Command, reply: Option<Reply>) {
        let (label, is_new) = (command.op.spec().label, command.op.id() == OpId::New);
        match self.editor.begin(command) {
            Ok(Begun::Done(outcome)) => {
                if is_new {
                    self.look_at_new();
                }
                if !outcome.warnings.is_empty() {
                    self.toast(MessageKind::Warning, outcome.message.clone(), outcome.warnings.clone());
                }
                if let Some(reply) = reply {
                    reply(Ok(Answer::Outcome(outcome)));
                }
            }
            Ok(Begun::Job(request)) => self.start(&request, label.to_owned(), reply),
            Err(error) => self.refused(&error, reply),
        }
        self.follow();
    }

    /// Opens files in place of the document, through the worker.
    pub(crate) fn open_files(&mut self, files: Vec<NamedBytes>, reply: Option<Reply>) {
        let label = match files.as_slice() {
            [] => return,
            [file] => format!("Open {}", file.name),
            [file, ..] => format!("Open {} and {} more", file.name, files.len() - 1),
        };
        let request = self.editor.begin_import(files);
        self.start(&request, label, reply);
        self.follow();
    }

    /// Fetches the files that the page's address asks for, and opens them together.
    pub(crate) fn fetch_wanted(&mut self) {
        let wanted = self.platform.wanted();
        let Some(first) = wanted.first() else { return };
        let name = first.split(['?', '#']).next().and_then(|path| path.rsplit('/').next()).unwrap_or(first);
        let id = self.editor.expect_import();
        self.jobs.add(id, format!("Fetch {name}"), None);
        self.platform.fetch(id.0, wanted);
    }

    /// Opens what was fetched, as the rest of the same job; or says why it can't.
    pub(crate) fn fetched(&mut self, job: u64, fetched: Result<Fetched, String>) {
        let id = JobId(job);
        match fetched {
            Ok(Fetched { files, notes }) if self.jobs.iter().any(|running| running.id == id) => {
                self.jobs.note(id, notes);
                self.platform.start_job(job, JobRequest::import_expected(id, files).to_bytes());
            }
            Ok(_) => {}
            Err(text) => {
                self.editor.cancel_job(id);
                self.jobs.take(job);
                self.fail(text);
            }
        }
        self.follow();
    }

    /// Writes the document for a script.
    pub(crate) fn begin_export(&mut self, format: Format, reply: Reply) {
        let request = self.editor.begin_export(format);
        self.start(&request, format!("Write {}", format.name()), Some(reply));
        self.follow();
    }

    pub(crate) fn start(&mut self, request: &JobRequest, label: String, reply: Option<Reply>) {
        let id = request.id();
        self.jobs.add(id, label, reply);
        self.platform.start_job(id.0, request.to_bytes());
    }

    /// Takes in what came of a job.
    pub(crate) fn job_done(&mut self, job: u64, result: Result<Vec<u8>, CommandError>) {
        let Some(running) = self.jobs.take(job) else { return };
        let id = JobId(job);
        let result = result.and_then(|bytes| {
            JobResult::from_bytes(&bytes)
                .map_err(|error| CommandError::refused(&*running.label, error.to_string()))
        });
        let finished = self.editor.finish(id, result.map_err(|error| with_notes(error, &running.notes)));
        self.adjustment_ended(id, finished.is_ok());
        match finished {
            Ok(Finished::Done(mut outcome)) => {
                if outcome.op == "open" {
                    self.look_at_opened();
                    self.say_opened(&outcome);
                } else {
                    if OpId::named(&outcome.op) == Some(OpId::New) {
                        self.look_at_new();
                    }
                    self.toast(MessageKind::Info, outcome.message.clone(), outcome.warnings.clone());
                }
                for note in running.notes {
                    self.editor.say(MessageKind::Warning, note.clone());
                    self.toast(MessageKind::Warning, note.clone(), Vec::new());
                    outcome.warnings.push(note);
                }
                if let Some(reply) = running.reply {
                    reply(Ok(Answer::Outcome(outcome)));
                }
            }
            Ok(Finished::Exported(files)) => match running.reply {
                Some(reply) => reply(Ok(Answer::Files(files))),
                None => self.saved(files, running.saves),
            },
            Err(error) => self.refused(&error, running.reply),
        }
        self.follow();
    }

    /// Looks at what was opened: flat curves from straight above their plane, so that they are seen as
    /// they were drawn.
    fn look_at_opened(&mut self) {
        let flat = |object: &editor::Object| {
            object.bezier().and_then(editor::Bezier::curve).is_some_and(bezier::is_flat)
        };
        let objects = self.editor.document().objects();
        let was_from_above = (self.view.camera.yaw, self.view.camera.pitch) == FROM_ABOVE;
        if !objects.is_empty() && objects.iter().all(flat) {
            (self.view.camera.yaw, self.view.camera.pitch) = FROM_ABOVE;
        } else if was_from_above {
            // What is not flat hides its depth there.
            self.view.reset();
        }
        self.view.frame_when_seen();
        if self.editor.mesh().is_some_and(|mesh| mesh.count(self.lists.kind.0) == 0) {
            // Points without faces: what there is to point at.
            self.lists.kind = ShownKind(Element::Vertex);
        }
        // What was offered for another document has nothing to work on here.
        self.toasts.withdraw();
    }

    /// Looks at a shape that is the whole document; one that was added may be meant for where one looks.
    fn look_at_new(&mut self) {
        if self.editor.document().objects().len() == 1 {
            self.look_at_opened();
        }
    }

    fn say_opened(&mut self, outcome: &editor::Outcome) {
        let kind = if outcome.warnings.is_empty() { MessageKind::Info } else { MessageKind::Warning };
        let mut text = outcome.message.clone();
        match outcome.warnings.len() {
            0 => {}
            1 => text.push_str("; one thing was changed on the way in"),
            many => text.push_str(&format!("; {many} things were changed on the way in")),
        }
        self.toast(kind, text, outcome.warnings.clone());
        if self.editor.document().active().is_some_and(editor::Object::is_repairable) {
            self.offer(Action::Operation(OpId::RepairImport));
        }
    }

    pub(crate) fn refused(&mut self, error: &CommandError, reply: Option<Reply>) {
        match reply {
            Some(reply) => reply(Err(error.to_string())),
            None if error.is_cancelled() => {}
            None => {
                let label = match (OpId::named(&error.op), error.op.as_str()) {
                    (Some(id), _) => id.spec().label,
                    (None, "open") => "Open",
                    (None, "export") => "Save",
                    (None, other) => other,
                };
                self.toast(MessageKind::Error, sentence(label, &error.problem), Vec::new());
            }
        }
    }

    fn step(&mut self, back: bool) {
        let result = if back { self.editor.undo() } else { self.editor.redo() };
        if let Err(error) = result {
            self.refused(&error, None);
        }
    }

    /// Escape: the innermost thing that is going on.
    fn cancel(&mut self) {
        if self.view.cancel_gesture() | self.editor.cancel_edit().is_some() {
            return;
        }
        if self.shown.close_windows() {
            return;
        }
        if let Some(id) = self.jobs.latest() {
            self.cancel_job(id);
        } else if self.view.tool == Tool::Box {
            self.view.tool = Tool::Orbit;
        } else if self.player.chosen.take().is_none() {
            self.editor.deselect();
        }
    }

    fn select_inverse(&mut self) {
        self.end_preview();
        let kind = self.lists.kind.0;
        let Some(mesh) = self.editor.mesh() else { return };
        let selection = self.editor.selection();
        let ids: Vec<u32> = (0..mesh.capacity(kind) as u32)
            .filter(|&id| mesh.exists(kind, id) && !selection.contains(kind, id))
            .collect();
        self.select(kind, ids, SelectMode::Replace);
    }

    /// Shows a kind in the list.
    pub(crate) fn show_kind(&mut self, kind: Element) {
        self.lists.kind = ShownKind(kind);
        self.shown.sheet.show_lists();
    }

    fn walk(&mut self, step: impl Fn(&halfedge::Mesh, halfedge::HalfedgeId) -> halfedge::HalfedgeId) {
        let to = self.selected_halfedge().and_then(|h| Some(step(self.editor.mesh()?, h)));
        if let Some(to) = to {
            self.select(Element::Halfedge, [to.raw()], SelectMode::Replace);
        }
    }

    /// The half-edge that was selected last.
    pub(crate) fn selected_halfedge(&self) -> Option<halfedge::HalfedgeId> {
        let selection = self.editor.selection();
        let id = selection.latest().filter(|_| selection.kind() == Element::Halfedge)?;
        self.editor.mesh()?.halfedge(id)
    }

    /// Selects; an id that went away meanwhile is no error to a person.
    pub(crate) fn select(&mut self, kind: Element, ids: impl IntoIterator<Item = u32>, mode: SelectMode) {
        // A live edit is of what was selected when it began.
        self.end_live(true);
        // Ids of what is only previewed mean nothing once it is taken back.
        if self.end_preview() == Some(false) {
            return;
        }
        if let Err(error) = self.editor.select(kind, ids, mode) {
            self.refused(&error, None);
        }
        self.follow();
    }

    /// Previews an edit while the person drags or spins.
    pub(crate) fn preview(&mut self, command: impl Into<Command>) {
        if let Err(error) = self.editor.update_edit(command.into()) {
            self.refused(&error, None);
        }
        self.follow();
    }

    /// Makes the previewed edit one undo step.
    pub(crate) fn commit_preview(&mut self) {
        self.editor.commit_edit();
        self.follow();
    }

    /// A colour is picked in a popup that has no end of its own: the step is made when the button is
    /// let go.
    pub(crate) fn finish_live_edit(&mut self, ctx: &Context) {
        if self.forms.painting && !ctx.input(|input| input.pointer.any_down()) {
            self.forms.painting = false;
            self.commit_preview();
        }
    }
}

/// What failed, with what is known besides: where a file could not be read without another one, why
/// that is not there.
fn with_notes(mut error: CommandError, notes: &[String]) -> CommandError {
    for note in notes {
        error.problem = format!("{} {note}", sentence_end(&error.problem));
    }
    error
}

/// A text with a full stop behind it, unless it ends like a sentence.
fn sentence_end(text: &str) -> String {
    if text.ends_with(['.', '!', '?']) { text.to_owned() } else { format!("{text}.") }
}

/// "Split edge" and "vertex 3 is …" as one sentence.
fn sentence(label: &str, problem: &str) -> String {
    sentence_end(&format!("{label}: {problem}"))
}
