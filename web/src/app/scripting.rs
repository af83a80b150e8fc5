//! The editor as scripts on the page see it: what `window.meshwright` is made of, without the
//! JavaScript.

use editor::{Command, JobId, SelectMode};
use formats::Format;
use halfedge::Element;
use serde_json::{Value, json};

use super::App;
use crate::panels::save;
use crate::platform::{DeviceInfo, NamedBytes};
use crate::session::jobs::Reply;

impl App {
    /// The graphics device.
    pub fn device(&self) -> DeviceInfo {
        self.session.platform.device()
    }

    /// Opens files as if they were dropped on the page; answers the outcome, with what an import
    /// had to repair in its warnings.
    pub fn script_open(&mut self, files: Vec<NamedBytes>, reply: Reply) {
        self.open_files(files, Some(reply));
    }

    /// Carries out a command, in the worker where it takes long.
    pub fn script_run(&mut self, command: Value, reply: Reply) {
        match Command::from_value(command) {
            Ok(command) => self.begin(command, Some(reply)),
            Err(error) => reply(Err(error.to_string())),
        }
    }

    /// Writes the document in a format: its extension, or `ply-text` and `stl-text`.
    pub fn script_export(&mut self, format: &str, reply: Reply) {
        match save::coded(format) {
            Some(format) => self.begin_export(format, reply),
            None => {
                let known: Vec<String> =
                    Format::ALL.into_iter().filter(|f| f.can_write()).map(save::code).collect();
                reply(Err(format!(
                    "export: {format:?} is no format to write; there are {}",
                    known.join(", ")
                )));
            }
        }
    }

    /// The document, selection, history, view, jobs and messages.
    pub fn script_state(&self) -> Value {
        let mut state = self.session.editor.state();
        let jobs: Vec<Value> = self
            .session
            .editor
            .jobs()
            .map(|job| json!({ "progress": self.session.jobs.fraction(job.id), "op": job.op }))
            .collect();
        if let Value::Object(map) = &mut state {
            map.insert("jobs".into(), jobs.into());
            map.insert("view".into(), self.view_state());
        }
        state
    }

    fn view_state(&self) -> Value {
        let bezier = crate::bezier::active(&self.session.editor).map(|_| self.player.state());
        let (camera, style) = (&self.view.camera, &self.view.style);
        let rect = self.view.rect();
        json!({
            "renderer": self.device().renderer,
            "rect": [rect.min.x, rect.min.y, rect.width(), rect.height()],
            "target": camera.target.to_array(),
            "yaw": camera.yaw,
            "pitch": camera.pitch,
            "distance": camera.distance,
            "orthographic": camera.orthographic,
            "wireframe": style.wireframe,
            "smooth": style.smooth,
            "vertices": style.vertices,
            "grid": style.grid,
            "list": self.shown.kind.to_string(),
            "theme": if self.session.ctx.global_style().visuals.dark_mode { "dark" } else { "light" },
            "bezier": bezier,
            "frame_ms": { "median": self.session.frames.median(), "worst": self.session.frames.worst() },
        })
    }

    /// One element of the active object.
    ///
    /// # Errors
    /// There is no such element, or no such kind.
    pub fn script_element(&self, kind: &str, id: u32) -> Result<Value, String> {
        self.session.editor.element(parse_kind(kind)?, id).map_err(|error| error.to_string())
    }

    /// Selects elements of the active object in place of what is selected.
    ///
    /// # Errors
    /// An id that doesn't exist, or no such kind.
    pub fn script_select(&mut self, kind: &str, ids: &[u32]) -> Result<(), String> {
        let kind = parse_kind(kind)?;
        self.end_preview();
        self.session
            .editor
            .select(kind, ids.iter().copied(), SelectMode::Replace)
            .map_err(|error| error.to_string())?;
        self.follow();
        Ok(())
    }

    /// Undo the last step; returns its label, or none where there is none.
    ///
    /// # Errors
    /// A job runs on what the step would change.
    pub fn script_undo(&mut self) -> Result<Option<String>, String> {
        let label = self.session.editor.undo().map_err(|error| error.to_string());
        self.follow();
        label
    }

    /// Redo the last undone step; otherwise like [`App::script_undo`].
    ///
    /// # Errors
    /// A job runs on what the step would change.
    pub fn script_redo(&mut self) -> Result<Option<String>, String> {
        let label = self.session.editor.redo().map_err(|error| error.to_string());
        self.follow();
        label
    }

    /// Cancels all jobs; gives how many there were.
    pub fn script_cancel(&mut self) -> usize {
        let ids: Vec<JobId> = self.session.jobs.iter().map(|job| job.id).collect();
        for &id in &ids {
            self.cancel_job(id);
        }
        ids.len()
    }

    /// Where a point of the scene is on the canvas, in points from its top left corner; none behind
    /// the eye.
    pub fn script_project(&self, point: [f32; 3]) -> Option<[f32; 2]> {
        self.view.project(point.into()).map(|at| [at.x, at.y])
    }
}

fn parse_kind(name: &str) -> Result<Element, String> {
    editor::element_kind(name)
        .ok_or_else(|| format!("{name:?} is no kind of element; they are vertex, edge, halfedge and face"))
}
