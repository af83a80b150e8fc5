//! Every action with its name and description, in one list for menus and the palette.

use editor::ops::FieldKind;
use editor::{OpId, Scope};
use formats::Format;
use halfedge::Element;

use super::action::entry;
pub use super::action::{Action, Entry};
use super::menus::MENUS;

use Action as A;

/// The operations on meshes, which menus and the palette list, in the order of the editor's table. The
/// object list itself offers the operations on objects; a new shape is in the file menu.
pub fn mesh_operations() -> impl Iterator<Item = OpId> {
    let all = OpId::ALL.iter().copied().filter(|id| *id != OpId::New);
    all.filter(|id| matches!(id.spec().scope, Scope::Elements | Scope::Meshes))
}

/// The operations that apply to a selection of this kind, the most used first.
pub fn edits_of(kind: Element) -> Vec<OpId> {
    let mut ids: Vec<OpId> = mesh_operations().filter(|id| id.spec().applies_to(kind)).collect();
    sort_by_use(&mut ids);
    ids
}

/// Sorts operations: the most used first and the destructive last.
pub fn sort_by_use(ids: &mut [OpId]) {
    const FIRST: [OpId; 10] = [
        OpId::Transform,
        OpId::ExtrudeFaces,
        OpId::ExtrudeEdges,
        OpId::InsetFaces,
        OpId::BevelEdges,
        OpId::BevelVertices,
        OpId::LoopCut,
        OpId::Bridge,
        OpId::FillHole,
        OpId::ConnectVertices,
    ];
    const LAST: [OpId; 6] = [
        OpId::CollapseEdge,
        OpId::CollapseFace,
        OpId::DissolveVertex,
        OpId::DissolveEdge,
        OpId::DeleteFaces,
        OpId::DeleteVertices,
    ];
    ids.sort_by_key(|id| {
        let first = FIRST.iter().position(|first| first == id).unwrap_or(FIRST.len());
        (LAST.contains(id), first)
    });
}

/// The operations that select by what elements are like.
pub fn criteria() -> impl Iterator<Item = OpId> {
    // The others have entries of the page's own, which know the kind that the list shows.
    let is_general = |id: &OpId| {
        matches!(id, OpId::SelectElements | OpId::SelectAll | OpId::SelectRelated | OpId::SelectSimilar)
    };
    let has_text = |id: &OpId| id.spec().fields.iter().any(|field| field.kind == FieldKind::Text);
    let of_scope = OpId::ALL.iter().copied().filter(|id| id.spec().scope == Scope::Selection);
    of_scope.filter(move |id| !is_general(id) && !has_text(id) && !hiding().contains(id))
}

/// The operations that hide and show faces.
pub fn hiding() -> [OpId; 3] {
    [OpId::Hide, OpId::Reveal, OpId::Isolate]
}

/// Every action: the menus' entries, then the formats and the operations.
pub fn all() -> impl Iterator<Item = Entry> {
    let operations = mesh_operations().chain(criteria()).chain(hiding());
    menu_entries().chain(formats()).chain(operations.map(of_operation))
}

/// The entries of the menus, without formats and operations.
fn menu_entries() -> impl Iterator<Item = Entry> {
    MENUS.iter().flat_map(|menu| menu.entries.iter().copied().flatten())
}

/// An entry for each format that documents can be saved in.
pub fn formats() -> impl Iterator<Item = Entry> {
    Format::all().filter(|format| format.can_save()).map(of_format)
}

/// The entry for saving in a format.
pub fn of_format(format: Format) -> Entry {
    entry(A::SaveAs(format), format.save_label(), format.description()).synonyms(&["export"])
}

/// The entry of an operation.
pub fn of_operation(id: OpId) -> Entry {
    let spec = id.spec();
    entry(A::Operation(id), spec.label, spec.description).synonyms(spec.synonyms)
}

/// The entry of an action; every action is in a menu.
pub fn describe(action: Action) -> Entry {
    match action {
        A::Operation(id) if id != OpId::New => of_operation(id),
        A::SaveAs(format) => of_format(format),
        // A test checks that no other action is missing.
        _ => menu_entries().find(|entry| entry.action == action).unwrap_or(entry(action, "", "")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_for_settings_are_unique() {
        let mut seen = std::collections::HashMap::new();
        for entry in all() {
            let name = entry.action.name();
            assert!(name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-'), "{name}");
            if let Some(other) = seen.insert(name.clone(), entry.action) {
                panic!("{:?} and {other:?} are both called {name}", entry.action);
            }
        }
        assert_eq!(A::Show(halfedge::Element::Vertex).name(), "show-vertex");
        assert_eq!(A::Operation(OpId::LoopCut).name(), "operation-loop-cut");
    }

    #[test]
    fn every_entry_says_what_it_is() {
        for entry in all() {
            assert!(!entry.label.is_empty() && entry.description.ends_with('.'), "{entry:?}");
            assert_eq!(describe(entry.action).label, entry.label, "{:?} is in the table twice", entry.action);
        }
    }
}
