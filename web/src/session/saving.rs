//! Saving a document to the file that it was opened from, or where the user says.

use editor::{JobId, MessageKind};
use formats::Format;

use super::Session;
use crate::platform::store::Id;
use crate::platform::{Download, NamedBytes, Placed, PlacedFile, Source};

/// Opens files that can be written again.
pub(crate) fn open(session: &mut Session, source: Source, files: Vec<NamedBytes>) {
    let model = model_of(source, &files);
    session.in_place.opening = session.open_files(files, None).zip(model);
}

/// Notes that a job opens files, which can be written again if they have a source.
pub(super) fn opening(session: &mut Session, id: JobId, source: Option<Source>, files: &[NamedBytes]) {
    let model = source.and_then(|source| model_of(source, files));
    session.in_place.opening = model.map(|model| (id, model));
}

/// The model among files, if a document can be saved in its format.
fn model_of(source: Source, files: &[NamedBytes]) -> Option<PlacedFile> {
    files.iter().find_map(|file| PlacedFile::new(source, &file.name, Format::detect(file)))
}

/// Notes that a job has opened its files.
pub(crate) fn opened(session: &mut Session, id: JobId) {
    let opened = session.in_place.opening.take_if(|(job, _)| *job == id);
    session.in_place.file = opened.map(|(_, file)| (session.editor.document().origin(), file));
}

/// Goes on saving the shown document to the file of an earlier visit, unless it has another one by now.
pub(crate) fn recalled(session: &mut Session, document: &Id, file: PlacedFile) {
    if session.documents.shown.as_ref() == Some(document) && session.in_place.file.is_none() {
        session.in_place.file = Some((session.editor.document().origin(), file));
    }
}

/// Starts to save the document to the file that it was opened from; false if there is none. `view` goes into project files.
pub(crate) fn save(session: &mut Session, view: String) -> bool {
    // Another document has no claim to the file.
    let Some((_, file)) =
        session.in_place.file.clone().filter(|(of, _)| *of == session.editor.document().origin())
    else {
        return false;
    };
    // One that was cancelled wrote nothing.
    if session.in_place.writing.is_some_and(|id| session.jobs.iter().any(|job| job.id == id)) {
        return true;
    }
    session.platform.ask_to_write(file.source);
    let stem = file.name.rsplit_once('.').map_or(file.name.as_str(), |(stem, _)| stem).to_owned();
    let losses = formats::losses(file.format, &session.editor.document().to_model(&stem));
    if file.format.is_project() {
        session.editor.log_view(view);
    }
    session.in_place.writing = Some(session.save(file.format, stem, losses.is_empty()));
    true
}

/// Writes what a job made of the document: to the file that it was opened from, or for the user to keep anywhere. `saves` is the
/// revision that counts as saved then, if opening the files brings back all of it.
pub(super) fn write(session: &mut Session, id: JobId, mut files: Vec<NamedBytes>, saves: Option<u64>) {
    if session.in_place.writing.take_if(|job| *job == id).is_none() {
        // Saved under a name of its own, from which it is no longer told apart by its origin.
        session.in_place.file = None;
        return hand_out(session, files, saves);
    }
    let Some((_, file)) = &session.in_place.file else { return hand_out(session, files, saves) };
    if let Some(model) = files.first_mut() {
        model.name.clone_from(&file.name);
    }
    let stranger = files.iter().find(|own| !session.platform.can_write(file.source, &own.name));
    if let Some(stranger) = stranger {
        let text = format!(
            "{} is not among the files that were opened, so all files are downloaded. Open it together with {} to save both \
             in place.",
            stranger.name, file.name
        );
        session.warn(text, Vec::new());
        return hand_out(session, files, saves);
    }
    session.in_place.written.push_back((session.editor.document().origin(), saves));
    session.platform.write_back(file.source, files);
}

/// Gives written files to the user.
fn hand_out(session: &mut Session, files: Vec<NamedBytes>, saves: Option<u64>) {
    let names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
    match session.platform.download(files) {
        Download::Done => saved_under(session, &names, saves),
        Download::Asking => {
            let origin = session.editor.document().origin();
            session.in_place.asking.push_back((origin, saves));
        }
    }
}

/// Follows what came of asking the user where files go; none if they changed their mind.
pub(crate) fn placed(session: &mut Session, placed: Option<Result<Placed, String>>) {
    let Some((origin, saves)) = session.in_place.asking.pop_front() else { return };
    match placed {
        None => {}
        Some(Err(problem)) => session.fail(problem),
        Some(Ok(Placed { source, names, notes })) => {
            if !notes.is_empty() {
                session.warn(notes.join(" "), Vec::new());
            }
            if session.editor.document().origin() != origin {
                // Another document was opened since.
                return session.toast(MessageKind::Info, said(&names), Vec::new());
            }
            saved_under(session, &names, saves);
            let file = names.first().and_then(|name| PlacedFile::new(source, name, Format::from_name(name)));
            session.in_place.file = file.map(|file| (origin, file));
        }
    }
}

/// Gives the document the name of the files that it was saved in.
fn saved_under(session: &mut Session, names: &[String], saves: Option<u64>) {
    if let Some((stem, _)) = names.first().and_then(|name| name.rsplit_once('.')) {
        session.editor.rename_document(stem);
    }
    saved(session, names, saves);
}

/// Says that files were written. The document counts as saved if opening them brings back all of it.
fn saved(session: &mut Session, names: &[String], saves: Option<u64>) {
    let mut details = Vec::new();
    match saves {
        Some(revision) => session.editor.mark_saved(revision),
        None => details.push(
            "Opening the file would not bring back everything, so the document still counts as changed."
                .to_owned(),
        ),
    }
    session.tell(said(names), details);
}

fn said(names: &[String]) -> String {
    format!("Saved {}", names.join(" and "))
}

/// Says whether the bytes are in the files.
pub(crate) fn written(session: &mut Session, files: &[String], result: Result<(), String>) {
    let origin = session.editor.document().origin();
    let of_document = session.in_place.written.pop_front().filter(|(of, _)| *of == origin);
    match (result, of_document) {
        (Ok(()), Some((_, saves))) => saved(session, files, saves),
        // Another document was opened since.
        (Ok(()), None) => session.toast(MessageKind::Info, said(files), Vec::new()),
        (Err(reason), _) => session.fail(format!(
            "{} could not be written: {reason}. What was in it is unchanged. Try again, or use File > Save as.",
            files.join(" and ")
        )),
    }
}
