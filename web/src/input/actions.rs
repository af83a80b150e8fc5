//! Everything that a menu, a key, a button or the palette can start, in one table.
//!
//! An action on the mesh is an operation of the editor's command list; the others are about the
//! page itself: what is shown and what is selected.

use editor::{OpId, Scope};
use formats::Format;
use halfedge::Element;

/// Something a person can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Picks a file to open.
    Open,
    /// Asks how to save the document, and saves it.
    Save,
    /// The same, with a format to begin with.
    SaveAs(Format),
    /// Takes the last step back.
    Undo,
    /// Makes the step again that was taken back.
    Redo,
    /// Stops what runs, ends a drag without a trace, or else selects nothing.
    Cancel,
    /// Selects every element of the kind that the list shows.
    SelectAll,
    /// Selects nothing.
    SelectNone,
    /// Selects what is not selected.
    SelectInverse,
    /// Shows one kind of element in the list, which is also what clicks in the viewport select.
    Show(Element),
    /// From a half-edge to the next around its face.
    Next,
    /// From a half-edge to the other side of its edge.
    Twin,
    /// Puts the keyboard into the "Go to id" field.
    GoToId,
    /// Shows only selected elements in the list, or all again.
    OnlySelected,
    /// Drags on the viewport draw a box that selects.
    BoxSelect,
    /// Looks at the selection, or at everything.
    Frame,
    /// Looks at everything.
    FrameAll,
    /// Back to the first view.
    ResetView,
    /// Parallel instead of perspective projection.
    Orthographic,
    /// Edges drawn over faces.
    Wireframe,
    /// Smooth instead of flat shading.
    Smooth,
    /// Vertices drawn as dots.
    Dots,
    /// The ground grid.
    Grid,
    /// What is under the pointer, written into the viewport.
    Overlay,
    /// The list on the left.
    LeftPanel,
    /// The inspector on the right.
    RightPanel,
    /// Follows the system's light or dark theme.
    SystemTheme,
    /// The light theme.
    LightTheme,
    /// The dark theme.
    DarkTheme,
    /// The window with all keys.
    Shortcuts,
    /// The command palette.
    Palette,
    /// The messages so far.
    Messages,
    /// What the page runs on.
    About,
    /// Loop on a triangle mesh, Catmull-Clark on others.
    Upsample,
    /// Simplifies to a quarter of the triangles.
    Downsample,
    /// Remeshes to the target edge length.
    Resample,
    /// Makes the target edge length of resampling larger.
    LongerEdges,
    /// Makes the target edge length of resampling smaller.
    ShorterEdges,
    /// Splits the selected edge where the pointer slides to.
    SlideSplit,
    /// Draws one level more of de Casteljau's construction.
    NextLevel,
    /// The whole Bezier curve, or only as far as the construction.
    WholeCurve,
    /// A Bezier surface's control nets.
    ControlNets,
    /// Moves along the Bezier curve or patch.
    Play,
    /// Adds a control point to the Bezier curve.
    AddPoint,
    /// Takes the chosen control point away.
    DeletePoint,
    /// Gives the Bezier curve one control point more, and the same shape.
    ElevateDegree,
    /// Splits the Bezier curve where the construction is.
    SplitCurve,
    /// An operation of the editor, on the selection.
    Operation(OpId),
}

/// How an action is presented.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// What it starts.
    pub action: Action,
    /// Its name in menus and the palette, in sentence case.
    pub label: &'static str,
    /// One sentence on what it does.
    pub description: &'static str,
}

const fn entry(action: Action, label: &'static str, description: &'static str) -> Entry {
    Entry { action, label, description }
}

/// A menu with its entries; none is a separating line.
pub struct Menu {
    /// Its title.
    pub title: &'static str,
    /// What is in it.
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
                "Opens a mesh file. Dropping a file on the page or pasting OBJ text works too.",
            )),
            Some(entry(
                A::Save,
                "Save…",
                "Saves the document under a name, in any of the formats, and says what a format can't hold.",
            )),
        ],
    },
    Menu {
        title: "Edit",
        entries: &[
            Some(entry(A::Undo, "Undo", "Undo the last change.")),
            Some(entry(A::Redo, "Redo", "Redo the last undone change.")),
            None,
            Some(entry(A::Cancel, "Cancel", "Stops a running job or a drag, or else clears the selection.")),
            Some(entry(A::Palette, "Find a command…", "Lists every command; type to search.")),
        ],
    },
    Menu {
        title: "Select",
        entries: &[
            Some(entry(A::SelectAll, "Select all", "Selects every element of the kind that the list shows.")),
            Some(entry(A::SelectNone, "Select none", "Clears the selection.")),
            Some(entry(
                A::SelectInverse,
                "Invert selection",
                "Selects what is not selected, of the kind that the list shows.",
            )),
            Some(entry(
                A::BoxSelect,
                "Box select",
                "Drags on the viewport draw a box that selects what is in it.",
            )),
            None,
            Some(entry(
                A::Next,
                "Next half-edge",
                "From the selected half-edge to the next around its face.",
            )),
            Some(entry(
                A::Twin,
                "Twin half-edge",
                "From the selected half-edge to the other side of its edge.",
            )),
            None,
            Some(entry(
                A::Show(Element::Vertex),
                "Vertices",
                "Lists vertices; clicks in the viewport select vertices.",
            )),
            Some(entry(A::Show(Element::Edge), "Edges", "Lists edges; clicks in the viewport select edges.")),
            Some(entry(
                A::Show(Element::Halfedge),
                "Half-edges",
                "Lists half-edges; clicks in the viewport select half-edges.",
            )),
            Some(entry(A::Show(Element::Face), "Faces", "Lists faces; clicks in the viewport select faces.")),
            None,
            Some(entry(A::GoToId, "Go to id…", "Finds an element by its number.")),
            Some(entry(A::OnlySelected, "List only selected", "Shows only selected elements in the list.")),
        ],
    },
    Menu {
        title: "Mesh",
        entries: &[
            Some(entry(
                A::Upsample,
                "Upsample",
                "Subdivides once: Loop where all faces are triangles, Catmull-Clark otherwise.",
            )),
            Some(entry(A::Downsample, "Downsample", "Simplifies to a quarter of the triangles.")),
            Some(entry(
                A::Resample,
                "Resample",
                "Remeshes to the target edge length, which is the mean of the edges until it is changed.",
            )),
            Some(entry(
                A::LongerEdges,
                "Longer target edges",
                "Makes the target edge length of resampling a tenth larger.",
            )),
            Some(entry(
                A::ShorterEdges,
                "Shorter target edges",
                "Makes the target edge length of resampling a tenth smaller.",
            )),
            Some(entry(
                A::SlideSplit,
                "Split edge at…",
                "Puts a new vertex on the selected edge and lets it slide along with the pointer.",
            )),
        ],
    },
    Menu {
        title: "Bezier",
        entries: &[
            Some(entry(
                A::NextLevel,
                "Next level",
                "Draws one level more of de Casteljau's construction; after the last, none.",
            )),
            Some(entry(A::Play, "Play", "Moves the construction along the curve or patch.")),
            Some(entry(
                A::WholeCurve,
                "Whole curve",
                "Draws the whole curve, or only as far as the construction has come.",
            )),
            Some(entry(
                A::ControlNets,
                "Control nets",
                "Draws the control points of a surface and their net.",
            )),
            None,
            Some(entry(
                A::AddPoint,
                "Add control point",
                "Adds a control point after the chosen one. Double-clicking in the viewport adds one there.",
            )),
            Some(entry(A::DeletePoint, "Delete control point", "Takes the chosen control point away.")),
            Some(entry(
                A::ElevateDegree,
                "Elevate degree",
                "Gives the curve one control point more without changing its shape.",
            )),
            Some(entry(
                A::SplitCurve,
                "Split at t",
                "Makes two curves of it that meet where the construction is.",
            )),
        ],
    },
    Menu {
        title: "View",
        entries: &[
            Some(entry(
                A::Frame,
                "Frame selection",
                "Looks at the selection, or at everything where nothing is selected.",
            )),
            Some(entry(A::FrameAll, "Frame all", "Looks at everything, from the same direction.")),
            Some(entry(A::ResetView, "Reset view", "Back to the first view.")),
            Some(entry(A::Orthographic, "Parallel projection", "Draws without perspective.")),
            None,
            Some(entry(A::Wireframe, "Wireframe", "Draws edges over faces.")),
            Some(entry(
                A::Smooth,
                "Smooth shading",
                "Shades with normals averaged at vertices instead of one per face.",
            )),
            Some(entry(A::Dots, "Vertex dots", "Draws vertices as dots.")),
            Some(entry(A::Grid, "Ground grid", "Draws the ground plane, y = 0.")),
            Some(entry(
                A::Overlay,
                "Info overlay",
                "Writes what is under the pointer and what is selected into the viewport.",
            )),
            None,
            Some(entry(A::LeftPanel, "Element lists", "Shows or hides the lists.")),
            Some(entry(A::RightPanel, "Inspector", "Shows or hides the inspector and the operations.")),
            None,
            Some(entry(A::SystemTheme, "Theme of the system", "Light or dark as the system is.")),
            Some(entry(A::LightTheme, "Light theme", "Dark text on a light page.")),
            Some(entry(A::DarkTheme, "Dark theme", "Light text on a dark page.")),
        ],
    },
    Menu {
        title: "Help",
        entries: &[
            Some(entry(A::Shortcuts, "Keyboard shortcuts", "Lists all keys and what the mouse does.")),
            Some(entry(A::Messages, "Messages", "Lists what was imported, refused and done.")),
            Some(entry(A::About, "About Meshwright", "The version and what the page runs on.")),
        ],
    },
];

/// The operations that menus and the palette list, in the order of the editor's table: those on
/// meshes. The ones on objects are in the object list itself.
pub fn mesh_operations() -> impl Iterator<Item = OpId> {
    OpId::ALL.iter().copied().filter(|id| matches!(id.spec().scope, Scope::Elements | Scope::Meshes))
}

/// Every action with its name: the menus' entries, then the formats and the operations.
pub fn all() -> impl Iterator<Item = Entry> {
    menu_entries().chain(formats()).chain(mesh_operations().map(of_operation))
}

/// The entries of the menus, without formats and operations.
fn menu_entries() -> impl Iterator<Item = Entry> {
    MENUS.iter().flat_map(|menu| menu.entries.iter().copied().flatten())
}

/// Saving in each format that can be written.
pub fn formats() -> impl Iterator<Item = Entry> {
    Format::all().filter(|format| format.can_write()).map(of_format)
}

/// Saving in a format.
pub fn of_format(format: Format) -> Entry {
    entry(A::SaveAs(format), format.save_label(), format.description())
}

/// An operation as a menu shows it.
pub fn of_operation(id: OpId) -> Entry {
    Entry { action: A::Operation(id), label: id.spec().label, description: id.spec().description }
}

/// How an action is presented; every action is in a menu.
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
