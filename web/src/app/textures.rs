//! Decoding the images of materials, one after the other.

use editor::{JobId, MessageKind};
use formats::{Image, Picture};

use crate::session::Session;
use crate::view::View;
use crate::view::textures::State;

/// Takes decoded pictures, and begins to decode the next image.
pub(super) fn go_on(session: &mut Session, view: &mut View) {
    for (job, result) in std::mem::take(&mut session.decoded) {
        take(session, view, job, result);
    }
    let Some(picture) = &view.picture else { return };
    let largest = view.textures.largest_side().min(picture.largest_side());
    let decoding = view.textures.known.iter_mut().find(|known| matches!(known.state, State::Decoding(_)));
    if let Some(known) = decoding {
        if matches!(known.state, State::Decoding(job) if session.jobs.iter().any(|running| running.id == job))
        {
            return;
        }
        known.state = State::Failed("it was cancelled".to_owned());
        picture.set_materials(view.textures.looks(session.editor.document().materials()));
    }
    let Some(known) = view.textures.known.iter_mut().find(|known| known.state == State::Waiting) else {
        return;
    };
    let source = known.source(session.editor.document().materials());
    let Some(name) = source.images().next().map(|image| image.file_name().to_owned()) else { return };
    let request = session.editor.begin_decode(source, largest);
    known.state = State::Decoding(request.id());
    session.start(&request, format!("Load {name}"), None);
}

/// Takes the result of decoding an image.
fn take(session: &mut Session, view: &mut View, job: JobId, result: Result<Picture, String>) {
    let Some(known) = view.textures.known.iter_mut().find(|known| known.state == State::Decoding(job)) else {
        return;
    };
    let document = session.editor.document();
    let source = known.source(document.materials());
    let name = source.images().next().map_or("An image", Image::file_name).to_owned();
    match result {
        Ok(Picture { size, pixels, original }) => {
            known.state = State::Shown(original);
            let number = known.number;
            if size != original {
                let [[w, h], [full_w, full_h]] = [size, original];
                session.editor.say(
                    MessageKind::Info,
                    format!(
                        "{name} has {full_w} × {full_h} pixels and is shown with {w} × {h}; files are saved with the whole \
                         image"
                    ),
                );
            }
            if let Some(picture) = &view.picture {
                picture.set_picture(number, viewport::Picture { size, pixels });
            }
        }
        Err(reason) => {
            known.state = State::Failed(reason.clone());
            if let Some(picture) = &view.picture {
                picture.set_materials(view.textures.looks(document.materials()));
            }
            session
                .warn(format!("{name} can't be shown: {reason}. It is kept and saved as it is."), Vec::new());
        }
    }
}
