//! Images of materials: decoded, and added after the model that names them.

use super::jobs::WaitingFor;
use super::{Editor, MessageKind};
use crate::Task;
use crate::error::CommandError;
use crate::history::Change;
use crate::job::{JobRequest, Work};
use crate::outcome::{Elements, Outcome};
use crate::recovery::Event;
use formats::{NamedBytes, PictureSource, first_few, is_image};

impl Editor {
    /// A job that decodes images of the document's materials, with at most `largest` pixels on a side. It changes
    /// nothing; [`Editor::finish`] gives the picture, or in words why there is none.
    pub fn begin_decode(&mut self, source: PictureSource, largest: u32) -> JobRequest {
        JobRequest { id: self.wait_for(WaitingFor::Decode), work: Work::Decode(source, largest) }
    }

    /// Gives images to the materials that name them, also in place of those they have, as one undo step.
    ///
    /// # Errors
    /// A file is no image, or no material names any of them.
    pub fn take_images(&mut self, files: &[NamedBytes]) -> Result<Outcome, CommandError> {
        let mut materials = self.document.materials.clone();
        let taken = materials.take_images(files);
        let names = |files: &[&str]| first_few(files, 6);
        if taken.is_empty() {
            let all: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
            let problem = match files.iter().find(|file| !is_image(file)) {
                Some(other) => format!("{} is no image", other.name),
                None => format!(
                    "No material names {}: an image goes with a model whose material names its file",
                    names(&all)
                ),
            };
            return Err(self.report(CommandError::refused(Task::Open, problem)));
        }
        self.end_edit();
        let before = self.selection.clone();
        let back = self.apply(vec![Change::Materials(materials)]);
        let taken: Vec<&str> = taken.iter().map(String::as_str).collect();
        let message = format!("Added images to materials: {}", names(&taken));
        self.push_step(format!("Add {}", names(&taken)), back, before);
        self.log(Event::Break);
        self.say(MessageKind::Info, message.clone());
        let left_out = files.iter().filter(|file| !taken.contains(&file.name.as_str()));
        let warnings = left_out.map(|file| format!("{} was left out: no material names it", file.name));
        Ok(Outcome {
            op: Task::AddImages,
            created: Elements::default(),
            removed: Elements::default(),
            message,
            warnings: warnings.collect(),
            report: Vec::new(),
        })
    }
}
