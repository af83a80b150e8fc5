//! The size of an operation's result, shown before the operation runs.

use crate::lists::columns::counted;
use crate::page_view::Page;
use crate::session::form::{self, Filled};
use editor::ops::{Amount, Counted, Estimate};
use editor::{Command, Facts, OpId};
use halfedge::Element;
use halfedge::words::thousands;

/// The result of a trial run, for one revision of the document.
#[derive(Clone, Debug)]
pub(crate) struct Tried {
    revision: u64,
    command: Command,
    /// None if the command is refused.
    estimate: Option<Estimate>,
}

/// The size of the result of an operation with these fields, as a sentence; none if it is unknown. A quick operation
/// is tried out for it, unless a preview is coming, which does the same work.
pub(crate) fn show(
    page: &Page<'_>,
    own: &mut Option<Tried>,
    id: OpId,
    filled: &Filled,
    facts: &Facts,
    preview_is_coming: bool,
) -> Option<String> {
    let command = form::command(id, filled).ok()?;
    let estimate = command.op.result(facts)?;
    if let Some(mesh) = page.previewed(id, filled) {
        return words(&estimate.exactly(mesh));
    }
    if matches!(estimate.count, Amount::Exactly(_)) || page.editor.is_editing() || preview_is_coming {
        return words(&estimate);
    }
    match try_out(page, own, &command, estimate) {
        Some(tried) => words(&tried),
        None => words(&estimate),
    }
}

/// The estimate with the exact count from a trial run, if that is quick. Each revision and command is tried
/// once.
fn try_out(
    page: &Page<'_>,
    own: &mut Option<Tried>,
    command: &Command,
    estimate: Estimate,
) -> Option<Estimate> {
    let revision = page.editor.revision();
    let known = own.as_ref();
    if let Some(tried) = known.filter(|tried| tried.revision == revision && tried.command == *command) {
        return tried.estimate;
    }
    let result = if page.editor.is_quick(command) { page.editor.try_out(command) } else { None };
    let estimate = result.map(|mesh| estimate.exactly(&mesh));
    // A command that is refused while a job runs may be accepted once the job is cancelled.
    if estimate.is_some() || page.editor.jobs().next().is_none() {
        *own = Some(Tried { revision, command: command.clone(), estimate });
    }
    estimate
}

/// An estimate as a sentence; none if nothing is known.
fn words(estimate: &Estimate) -> Option<String> {
    let noun = |count: usize| match estimate.counted {
        Counted::Faces => counted(Element::Face, count),
        Counted::Triangles if count == 1 => "1 triangle".to_owned(),
        Counted::Triangles => format!("{} triangles", thousands(count)),
        Counted::Vertices | Counted::MovedVertices => counted(Element::Vertex, count),
    };
    Some(match (estimate.count, estimate.of) {
        // Without anything to start from there is nothing to tell.
        (_, Some(0)) | (Amount::About(0), _) => return None,
        (Amount::Exactly(count), _) if estimate.counted == Counted::MovedVertices => {
            format!("{} will move; counts stay the same", noun(count))
        }
        (Amount::Exactly(count), None) => format!("Result: {}", noun(count)),
        (Amount::Exactly(count), Some(all)) => format!("Result: {} of {}", thousands(count), noun(all)),
        (Amount::About(count), None) => format!("Result: about {}", noun(count)),
        (Amount::About(count), Some(all)) => format!("Result: about {} of {}", thousands(count), noun(all)),
        (Amount::Unknown, Some(all)) => format!("Of {}", noun(all)),
        (Amount::Unknown, None) => return None,
    })
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::bezier::Player;
    use crate::platform::headless::{Headless, Outside};
    use crate::session::Session;
    use crate::shown::Shown;
    use crate::view::View;

    #[test]
    fn what_is_previewed_is_not_tried_out_too() {
        let mut session =
            Session::new(&egui::Context::default(), Box::new(Headless::new(Outside::default())));
        session.open_first();
        let (shown, view, player) = (Shown::default(), View::new(None), Player::default());
        let page = Page { session: &session, shown: &shown, view: &view, player: &player };
        let (id, mut tried) = (OpId::Remesh, None);
        let facts = page.measured_facts();
        let filled = form::initial(id.spec(), &facts);
        let said = show(&page, &mut tried, id, &filled, &facts, true);
        assert!(said.is_some_and(|said| said.contains("about")) && tried.is_none());
        let said = show(&page, &mut tried, id, &filled, &facts, false);
        assert!(said.is_some_and(|said| !said.contains("about")) && tried.is_some());
    }
}
