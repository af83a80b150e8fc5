//! The editor as scripts on the page see it: the implementation of `window.meshwright`, independent of
//! JavaScript.

use editor::{Command, JobId, SelectMode};
use formats::Format;
use halfedge::Element;
use serde_json::{Value, json};
use viewport::Shading;

use super::App;
use super::notices::Notice;
use crate::input::keys;
use crate::platform::NamedBytes;
use crate::session::jobs::Reply;
use crate::view::panes::name_of;
use crate::view::textures::State;
use crate::widgets::number_box::length_unit;

/// Script calls between two frames. When they are done, everything is updated to what they changed.
pub struct Script<'a> {
    pub(super) app: &'a mut App,
}

impl Drop for Script<'_> {
    fn drop(&mut self) {
        self.app.follow();
    }
}

impl Script<'_> {
    /// Opens files as if they were dropped on the page. The answer is the outcome, whose warnings list what
    /// the import had to repair.
    pub fn open(&mut self, files: Vec<NamedBytes>, reply: Reply) {
        self.app.session.open_files(files, Some(reply));
    }

    /// Runs a command, in the worker if it takes long.
    pub fn run(&mut self, command: Value, reply: Reply) {
        match Command::from_value(command) {
            Ok(command) => self.app.session.begin(command, Some(reply)),
            Err(error) => reply(Err(error.to_string())),
        }
    }

    /// Writes the document in the format with this code or extension.
    pub fn export(&mut self, format: &str, reply: Reply) {
        match Format::from_code(format).filter(|format| format.can_save()) {
            Some(format) => self.app.session.begin_export(format, reply),
            None => {
                let known: Vec<&str> =
                    Format::all().filter(|format| format.can_save()).map(Format::code).collect();
                reply(Err(format!(
                    "export: {format:?} is not a format that can be written; choose one of {}",
                    known.join(", ")
                )));
            }
        }
    }

    /// The document, selection, history, view, jobs and messages.
    pub fn state(&self) -> Value {
        let mut state = self.app.session.editor.state();
        let jobs: Vec<Value> = self
            .app
            .session
            .editor
            .jobs()
            .map(|job| json!({ "progress": self.app.session.jobs.fraction(job.id), "op": job.task }))
            .collect();
        if let Value::Object(map) = &mut state {
            map.insert("jobs".into(), jobs.into());
            map.insert("view".into(), self.view_state());
        }
        state
    }

    fn view_state(&self) -> Value {
        let bezier = crate::bezier::active(&self.app.session.editor).map(|_| self.app.player.state());
        let (camera, style) = (&self.app.view.camera, &self.app.view.style);
        // In CSS pixels, as everything that scripts are told about places.
        let view = &self.app.view;
        let in_pixels = |rect: egui::Rect| {
            let rect = rect * self.app.session.ctx.zoom_factor();
            [rect.min.x, rect.min.y, rect.width(), rect.height()]
        };
        let views = view.panes().into_iter().map(|pane| {
            let (camera, rect) = view.seen_in(pane);
            let (rect, is_active) = (in_pixels(rect), pane == view.panes.active);
            json!({ "name": name_of(camera), "rect": rect, "active": is_active })
        });
        let views: Vec<Value> = views.collect();
        let keys = keys::map(&self.app.session.ctx);
        let changed: serde_json::Map<String, Value> = keys
            .bindings()
            .iter()
            .filter(|binding| binding.is_changed)
            .map(|binding| {
                let keys: Vec<String> = binding.keys.iter().map(|key| key.text()).collect();
                (binding.action.name(), keys.into())
            })
            .collect();
        json!({
            "renderer": self.app.device().renderer,
            "rect": in_pixels(view.rect),
            "views": views,
            "target": camera.target.to_array(),
            "yaw": camera.yaw,
            "pitch": camera.pitch,
            "roll": camera.roll,
            "distance": camera.distance,
            "orthographic": camera.orthographic,
            "length_unit": length_unit(&self.app.session.ctx).name(),
            "cursor": view.cursor.is_shown.then(|| view.cursor.at.to_array()),
            "wireframe": style.wireframe,
            "smooth": style.shading == Shading::Smooth,
            "auto_smooth": match style.shading {
                Shading::Auto(degrees) => Some(degrees),
                Shading::Flat | Shading::Smooth => None,
            },
            "color_by": style.color_by.name(),
            "vertices": style.vertices,
            "grid": style.grid,
            "numbers": self.app.shown.numbers,
            "look": style.look.name(),
            "textures": self.textures(),
            "back_faces": !style.cull,
            "shadow": style.shadow,
            "marks": style.marks.iter().map(viewport::Mark::name).collect::<Vec<_>>(),
            "list": self.app.shown.kind.to_string(),
            "theme": if self.app.session.ctx.global_style().visuals.dark_mode { "dark" } else { "light" },
            "keys": keys.preset().name(),
            "camera": keys.camera().name(),
            "changed_keys": changed,
            "bezier": bezier,
            "frame_ms": { "median": self.app.session.frames.median(), "worst": self.app.session.frames.worst() },
        })
    }

    /// The images of the document's materials, as far as they are shown or missing.
    fn textures(&self) -> Vec<Value> {
        let images = self.app.session.editor.document().materials().images.iter();
        let told = images.filter_map(|image| {
            let (state, size) = match (&image.bytes, self.app.view.textures.state(image)) {
                (None, _) => ("missing", None),
                (Some(_), None) => return None,
                (_, Some(State::Waiting | State::Decoding(_))) => ("loading", None),
                (_, Some(State::Shown(size))) => ("shown", Some(size)),
                (_, Some(State::Failed(_))) => ("failed", None),
            };
            Some(json!({ "image": image.name, "state": state, "size": size }))
        });
        told.collect()
    }

    /// What happened since the last call, for those who subscribed to it.
    pub fn take_notices(&mut self) -> Vec<(Notice, Value)> {
        self.app.notices.take(&self.app.session)
    }

    /// One element of the active object.
    ///
    /// # Errors
    /// There is no such element, or no such kind.
    pub fn element(&self, kind: &str, id: u32) -> Result<Value, String> {
        self.app.session.editor.element(parse_kind(kind)?, id).map_err(|error| error.to_string())
    }

    /// Replaces the selection by elements of the active object.
    ///
    /// # Errors
    /// An id doesn't exist, or there is no such kind.
    pub fn select(&mut self, kind: &str, ids: &[u32]) -> Result<(), String> {
        let kind = parse_kind(kind)?;
        self.app.panels.end_edits(&mut self.app.session);
        self.app
            .session
            .editor
            .select(kind, ids.iter().copied(), SelectMode::Replace)
            .map_err(|error| error.to_string())?;
        Ok(())
    }

    /// Undoes the last step; returns its label, or none if there is no step.
    ///
    /// # Errors
    /// A job is running on an object that the step would change.
    pub fn undo(&mut self) -> Result<Option<String>, String> {
        self.app.session.editor.undo().map_err(|error| error.to_string())
    }

    /// Redoes the last undone step; otherwise like [`Script::undo`].
    ///
    /// # Errors
    /// A job is running on an object that the step would change.
    pub fn redo(&mut self) -> Result<Option<String>, String> {
        self.app.session.editor.redo().map_err(|error| error.to_string())
    }

    /// Cancels all jobs; returns their number.
    pub fn cancel(&mut self) -> usize {
        let ids: Vec<JobId> = self.app.session.jobs.iter().map(|job| job.id).collect();
        for &id in &ids {
            self.app.session.cancel_job(id);
        }
        ids.len()
    }

    /// The position of a scene point on the canvas, in points from its top left corner; none if the point
    /// is behind the eye.
    pub fn project(&self, point: [f32; 3]) -> Option<[f32; 2]> {
        self.app.view.project(point.into()).map(|at| [at.x, at.y])
    }
}

fn parse_kind(name: &str) -> Result<Element, String> {
    editor::element_kind(name)
        .ok_or_else(|| format!("{name:?} is not a kind of element; use vertex, edge, halfedge or face"))
}
