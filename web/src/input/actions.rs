//! Everything that menus, keys, buttons and the palette can start, in one table.
//!
//! An action on the document is an operation of the editor. The other actions concern the page: what is
//! shown and what is selected.

use editor::{OpId, Scope};
use formats::Format;
use halfedge::Element;

/// Something the user can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Opens the file dialog.
    Open,
    /// Opens the save dialog.
    Save,
    /// Opens the save dialog with this format chosen.
    SaveAs(Format),
    /// Undoes the last change.
    Undo,
    /// Redoes the last undone change.
    Redo,
    /// Cancels a running job or a drag; if there is none, clears the selection.
    Cancel,
    /// Selects every element of the kind in the list.
    SelectAll,
    /// Clears the selection.
    SelectNone,
    /// Inverts the selection.
    SelectInverse,
    /// Shows one kind of element in the list; clicks in the viewport select that kind too.
    Show(Element),
    /// Selects the next half-edge around the face.
    Next,
    /// Selects the twin of the selected half-edge.
    Twin,
    /// Moves the keyboard focus to the "Go to id" field.
    GoToId,
    /// Shows only selected elements in the list, or all again.
    OnlySelected,
    /// Makes drags in the viewport draw a selection box.
    BoxSelect,
    /// Frames the selection, or everything if nothing is selected.
    Frame,
    /// Frames everything.
    FrameAll,
    /// Restores the initial view.
    ResetView,
    /// Switches between parallel and perspective projection.
    Orthographic,
    /// Switches the drawing of edges over faces.
    Wireframe,
    /// Switches between smooth and flat shading.
    Smooth,
    /// Switches the drawing of vertices as dots.
    Dots,
    /// Switches the ground grid.
    Grid,
    /// Switches the info overlay in the viewport.
    Overlay,
    /// Shows or hides the list on the left.
    LeftPanel,
    /// Shows or hides the inspector on the right.
    RightPanel,
    /// Follows the system's light or dark theme.
    SystemTheme,
    /// The light theme.
    LightTheme,
    /// The dark theme.
    DarkTheme,
    /// Opens or closes the window with all keys.
    Shortcuts,
    /// Opens the command palette.
    Palette,
    /// Opens or closes the window with all messages.
    Messages,
    /// Opens or closes the window about the version and the device.
    About,
    /// Subdivides: Loop on a triangle mesh, Catmull-Clark on others.
    Upsample,
    /// Simplifies to a quarter of the triangles.
    Downsample,
    /// Remeshes to the target edge length.
    Resample,
    /// Increases the target edge length of resampling.
    LongerEdges,
    /// Decreases the target edge length of resampling.
    ShorterEdges,
    /// Splits the selected edge at a point that follows the pointer.
    SlideSplit,
    /// Draws one more level of de Casteljau's construction.
    NextLevel,
    /// Switches between drawing the whole Bezier curve and drawing it up to the construction.
    WholeCurve,
    /// Switches the drawing of a Bezier surface's control nets.
    ControlNets,
    /// Starts or stops moving the construction along the Bezier curve or patch.
    Play,
    /// Adds a control point to the Bezier curve.
    AddPoint,
    /// Deletes the chosen control point.
    DeletePoint,
    /// Adds one control point to the Bezier curve without changing its shape.
    ElevateDegree,
    /// Splits the Bezier curve at the construction's parameter.
    SplitCurve,
    /// Starts an operation on the selection.
    Operation(OpId),
}

/// An action as the interface presents it.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The action.
    pub action: Action,
    /// The name in menus and the palette, in sentence case.
    pub label: &'static str,
    /// One sentence on what the action does.
    pub description: &'static str,
}

const fn entry(action: Action, label: &'static str, description: &'static str) -> Entry {
    Entry { action, label, description }
}

/// A menu; an entry of `None` is a separator.
pub struct Menu {
    /// The title.
    pub title: &'static str,
    /// The entries.
    pub entries: &'static [Option<Entry>],
}

use Action as A;

/// The menus, left to right. The mesh menu continues with the editor's operations.
pub static MENUS: &[Menu] = &[
    Menu {
        title: "File",
        entries: &[
            Some(entry(
                A::Open,
                "Open…",
                "Open a mesh file. You can also drop a file on the page or paste OBJ text.",
            )),
            Some(entry(A::Save, "Save…", "Choose a name and a format, and see what the format can't hold.")),
        ],
    },
    Menu {
        title: "Edit",
        entries: &[
            Some(entry(A::Undo, "Undo", "Undo the last change.")),
            Some(entry(A::Redo, "Redo", "Redo the last undone change.")),
            None,
            Some(entry(
                A::Cancel,
                "Cancel",
                "Cancel a running job or a drag; if there is none, clear the selection.",
            )),
            Some(entry(A::Palette, "Find a command…", "List every command; type to search.")),
        ],
    },
    Menu {
        title: "Select",
        entries: &[
            Some(entry(A::SelectAll, "Select all", "Select every element of the kind in the list.")),
            Some(entry(A::SelectNone, "Select none", "Clear the selection.")),
            Some(entry(
                A::SelectInverse,
                "Invert selection",
                "Select the unselected elements of the kind in the list instead.",
            )),
            Some(entry(A::BoxSelect, "Box select", "Drag in the viewport to select the elements in a box.")),
            None,
            Some(entry(A::Next, "Next half-edge", "Select the next half-edge around the face.")),
            Some(entry(A::Twin, "Twin half-edge", "Select the half-edge on the other side of the edge.")),
            None,
            Some(entry(
                A::Show(Element::Vertex),
                "Vertices",
                "List vertices, and select vertices by clicks in the viewport.",
            )),
            Some(entry(
                A::Show(Element::Edge),
                "Edges",
                "List edges, and select edges by clicks in the viewport.",
            )),
            Some(entry(
                A::Show(Element::Halfedge),
                "Half-edges",
                "List half-edges, and select half-edges by clicks in the viewport.",
            )),
            Some(entry(
                A::Show(Element::Face),
                "Faces",
                "List faces, and select faces by clicks in the viewport.",
            )),
            None,
            Some(entry(A::GoToId, "Go to id…", "Select an element by its id.")),
            Some(entry(A::OnlySelected, "List only selected", "Show only selected elements in the list.")),
        ],
    },
    Menu {
        title: "Mesh",
        entries: &[
            Some(entry(
                A::Upsample,
                "Upsample",
                "Subdivide once: Loop if all faces are triangles, Catmull-Clark otherwise.",
            )),
            Some(entry(A::Downsample, "Downsample", "Simplify to a quarter of the triangles.")),
            Some(entry(
                A::Resample,
                "Resample",
                "Remesh to the target edge length; its default is the mean edge length.",
            )),
            Some(entry(
                A::LongerEdges,
                "Longer target edges",
                "Increase the target edge length of resampling by a tenth.",
            )),
            Some(entry(
                A::ShorterEdges,
                "Shorter target edges",
                "Decrease the target edge length of resampling by a tenth.",
            )),
            Some(entry(
                A::SlideSplit,
                "Split edge at…",
                "Add a vertex to the selected edge and slide it with the pointer.",
            )),
        ],
    },
    Menu {
        title: "Bezier",
        entries: &[
            Some(entry(
                A::NextLevel,
                "Next level",
                "Draw one more level of de Casteljau's construction; after the last, none.",
            )),
            Some(entry(A::Play, "Play", "Move the construction along the curve or patch.")),
            Some(entry(
                A::WholeCurve,
                "Whole curve",
                "Draw the whole curve, not only the part up to the construction.",
            )),
            Some(entry(
                A::ControlNets,
                "Control nets",
                "Draw a surface's control points and the net between them.",
            )),
            None,
            Some(entry(
                A::AddPoint,
                "Add control point",
                "Add a control point after the chosen one, or double-click in the viewport to add one there.",
            )),
            Some(entry(A::DeletePoint, "Delete control point", "Delete the chosen control point.")),
            Some(entry(
                A::ElevateDegree,
                "Elevate degree",
                "Add one control point without changing the curve's shape.",
            )),
            Some(entry(
                A::SplitCurve,
                "Split at t",
                "Split the curve into two that meet at the construction's point.",
            )),
        ],
    },
    Menu {
        title: "View",
        entries: &[
            Some(entry(
                A::Frame,
                "Frame selection",
                "Fit the selection into the view, or everything if nothing is selected.",
            )),
            Some(entry(A::FrameAll, "Frame all", "Fit everything into the view, from the same direction.")),
            Some(entry(A::ResetView, "Reset view", "Restore the initial view.")),
            Some(entry(A::Orthographic, "Parallel projection", "Draw without perspective.")),
            None,
            Some(entry(A::Wireframe, "Wireframe", "Draw edges over faces.")),
            Some(entry(
                A::Smooth,
                "Smooth shading",
                "Shade with normals averaged at vertices instead of one per face.",
            )),
            Some(entry(A::Dots, "Vertex dots", "Draw vertices as dots.")),
            Some(entry(A::Grid, "Ground grid", "Draw a grid on the ground plane, y = 0.")),
            Some(entry(
                A::Overlay,
                "Info overlay",
                "Show the selection and the element under the pointer in the viewport.",
            )),
            None,
            Some(entry(A::LeftPanel, "Element lists", "Show or hide the lists.")),
            Some(entry(A::RightPanel, "Inspector", "Show or hide the inspector and the operations.")),
            None,
            Some(entry(A::SystemTheme, "System theme", "Use the system's light or dark theme.")),
            Some(entry(A::LightTheme, "Light theme", "Use dark text on a light page.")),
            Some(entry(A::DarkTheme, "Dark theme", "Use light text on a dark page.")),
        ],
    },
    Menu {
        title: "Help",
        entries: &[
            Some(entry(A::Shortcuts, "Keyboard shortcuts", "List all keys and mouse gestures.")),
            Some(entry(A::Messages, "Messages", "List all imports, refusals and results.")),
            Some(entry(A::About, "About Meshwright", "Show the version and the graphics device.")),
        ],
    },
];

/// The operations on meshes, which menus and the palette list, in the order of the editor's table. The
/// object list itself offers the operations on objects.
pub fn mesh_operations() -> impl Iterator<Item = OpId> {
    OpId::ALL.iter().copied().filter(|id| matches!(id.spec().scope, Scope::Elements | Scope::Meshes))
}

/// Every action: the menus' entries, then the formats and the operations.
pub fn all() -> impl Iterator<Item = Entry> {
    menu_entries().chain(formats()).chain(mesh_operations().map(of_operation))
}

/// The entries of the menus, without formats and operations.
fn menu_entries() -> impl Iterator<Item = Entry> {
    MENUS.iter().flat_map(|menu| menu.entries.iter().copied().flatten())
}

/// An entry for each format that can be written.
pub fn formats() -> impl Iterator<Item = Entry> {
    Format::all().filter(|format| format.can_write()).map(of_format)
}

/// The entry for saving in a format.
pub fn of_format(format: Format) -> Entry {
    entry(A::SaveAs(format), format.save_label(), format.description())
}

/// The entry of an operation.
pub fn of_operation(id: OpId) -> Entry {
    Entry { action: A::Operation(id), label: id.spec().label, description: id.spec().description }
}

/// The entry of an action; every action is in a menu.
pub fn describe(action: Action) -> Entry {
    match action {
        A::Operation(id) => of_operation(id),
        A::SaveAs(format) => of_format(format),
        // A test checks that no other action is missing.
        _ => menu_entries().find(|entry| entry.action == action).unwrap_or(entry(action, "", "")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_says_what_it_is() {
        for entry in all() {
            assert!(!entry.label.is_empty() && entry.description.ends_with('.'), "{entry:?}");
            assert_eq!(describe(entry.action).label, entry.label, "{:?} is in the table twice", entry.action);
        }
    }
}
