//! The menus of the page's own actions, in one table. The palette lists them too.

use editor::{OpId, SelectBy};
use halfedge::Element;

use super::actions::{Action, Entry, entry};
use super::view_menu;

/// A menu; an entry of `None` is a separator.
pub struct Menu {
    /// The title.
    pub title: &'static str,
    /// The entries.
    pub entries: &'static [Option<Entry>],
}

use Action as A;

/// The submenu that an entry is in, which keeps long menus on small screens.
pub fn submenu(action: Action) -> Option<&'static str> {
    match action {
        A::LookFrom(_) => Some("Look from"),
        A::SelectBy(SelectBy::Kind(_)) => Some("Convert to"),
        A::Show(_) => Some("Show"),
        A::Expand(_) => Some("Expand to"),
        A::Look(_) => Some("Look"),
        A::AutoSmooth(_) => Some("Auto smooth"),
        A::ColorBy(_) => Some("Colour by"),
        A::Mark(_) => Some("Marks"),
        A::SystemTheme | A::LightTheme | A::DarkTheme => Some("Theme"),
        _ => None,
    }
}

/// The menus, left to right. The mesh menu continues with the editor's operations.
pub static MENUS: &[Menu] = &[
    Menu {
        title: "File",
        entries: &[
            Some(
                entry(
                    A::New,
                    "New",
                    "Start a new document with a cube. The old one is kept: undo brings it back.",
                )
                .synonyms(&["new document", "clear", "start over"]),
            ),
            Some(
                entry(
                    A::Operation(OpId::New),
                    "New shape",
                    "Make a cube, a sphere, a torus and the like, in a new document or in this one.",
                )
                .synonyms(OpId::New.spec().synonyms),
            ),
            None,
            Some(
                entry(
                    A::Open,
                    "Open…",
                    "Open a mesh file. You can also drop a file on the page or paste OBJ text.",
                )
                .synonyms(&["import", "load"]),
            ),
            Some(
                entry(A::Save, "Save…", "Choose a name and a format, and see what the format can't hold.")
                    .synonyms(&["export", "download"]),
            ),
        ],
    },
    Menu {
        title: "Edit",
        entries: &[
            Some(entry(A::Undo, "Undo", "Undo the last change, of the mesh or of the selection.")),
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
            Some(entry(A::SelectNone, "Select none", "Clear the selection.").synonyms(&["deselect"])),
            Some(entry(
                A::SelectInverse,
                "Invert selection",
                "Select the unselected elements of the kind in the list instead.",
            )),
            None,
            Some(
                entry(A::SelectBy(SelectBy::Grow), "Grow", "Add the neighbours of the selection.")
                    .synonyms(&["select more", "expand"]),
            ),
            Some(
                entry(
                    A::SelectBy(SelectBy::Shrink),
                    "Shrink",
                    "Deselect the elements beside unselected ones.",
                )
                .synonyms(&["select less", "contract"]),
            ),
            Some(
                entry(
                    A::SelectBy(SelectBy::Linked),
                    "Select linked",
                    "Add everything connected to the selection.",
                )
                .synonyms(&["select island", "connected"]),
            ),
            Some(entry(
                A::SelectBy(SelectBy::Loops),
                "Select loops",
                "Extend the selection along its edge loops, face strips or half-edge loops.",
            )),
            Some(entry(
                A::SelectBy(SelectBy::Rings),
                "Select rings",
                "Extend the selection to the edges side by side across quads.",
            )),
            Some(entry(
                A::SelectBy(SelectBy::Path),
                "Select shortest path",
                "Add the shortest path between the two selected elements.",
            )),
            Some(
                entry(
                    A::SelectBy(SelectBy::Outline),
                    "Select outline",
                    "Select the edges around the selected faces.",
                )
                .synonyms(&["boundary of selection"]),
            ),
            None,
            Some(entry(
                A::SelectBy(SelectBy::Kind(Element::Vertex)),
                "Convert to vertices",
                "Select the vertices of the selection instead.",
            )),
            Some(entry(
                A::SelectBy(SelectBy::Kind(Element::Edge)),
                "Convert to edges",
                "Select the edges of the selection instead.",
            )),
            Some(entry(
                A::SelectBy(SelectBy::Kind(Element::Halfedge)),
                "Convert to half-edges",
                "Select the half-edges of the selection instead.",
            )),
            Some(entry(
                A::SelectBy(SelectBy::Kind(Element::Face)),
                "Convert to faces",
                "Select the faces of the selection instead.",
            )),
            None,
            Some(
                entry(A::BoxSelect, "Box select", "Drag in the viewport to select the elements in a box.")
                    .synonyms(&["border select", "marquee", "rectangle"]),
            ),
            Some(
                entry(A::LassoSelect, "Lasso select", "Draw a line around the elements to select.")
                    .synonyms(&["free selection"]),
            ),
            Some(
                entry(A::CircleSelect, "Circle select", "Paint over the elements to select, with a circle.")
                    .synonyms(&["brush", "paint selection"]),
            ),
            Some(entry(A::LargerCircle, "Larger circle", "Make the selecting circle larger.")),
            Some(entry(A::SmallerCircle, "Smaller circle", "Make the selecting circle smaller.")),
            None,
            Some(entry(A::Next, "Next half-edge", "Select the next half-edge around the face.")),
            Some(entry(A::Twin, "Twin half-edge", "Select the half-edge on the other side of the edge.")),
            None,
            Some(entry(
                A::Show(Element::Vertex),
                "Vertices",
                "List and select vertices. The selection becomes its vertices; switch with Ctrl to expand it.",
            )),
            Some(entry(
                A::Show(Element::Edge),
                "Edges",
                "List and select edges. The selection becomes the edges in it; switch with Ctrl to expand it.",
            )),
            Some(entry(
                A::Show(Element::Halfedge),
                "Half-edges",
                "List and select half-edges. The selection becomes the half-edges in it; switch with Ctrl to expand it.",
            )),
            Some(entry(
                A::Show(Element::Face),
                "Faces",
                "List and select faces. The selection becomes the faces in it; switch with Ctrl to expand it.",
            )),
            Some(entry(
                A::Expand(Element::Vertex),
                "Expand to vertices",
                "List vertices, and select every vertex of the selection.",
            )),
            Some(entry(
                A::Expand(Element::Edge),
                "Expand to edges",
                "List edges, and select every edge that touches the selection.",
            )),
            Some(entry(
                A::Expand(Element::Halfedge),
                "Expand to half-edges",
                "List half-edges, and select every half-edge that touches the selection.",
            )),
            Some(entry(
                A::Expand(Element::Face),
                "Expand to faces",
                "List faces, and select every face that touches the selection.",
            )),
            None,
            Some(entry(A::GoToId, "Go to id…", "Select an element by its id.")),
            Some(entry(A::OnlySelected, "List only selected", "Show only selected elements in the list.")),
        ],
    },
    Menu {
        title: "Mesh",
        entries: &[
            Some(
                entry(
                    A::Upsample,
                    "Upsample (subdivide)",
                    "Subdivide once: Loop if all faces are triangles, Catmull-Clark otherwise.",
                )
                .synonyms(&["subdivide"]),
            ),
            Some(
                entry(A::Downsample, "Downsample (simplify)", "Simplify to a quarter of the triangles.")
                    .synonyms(&["decimate"]),
            ),
            Some(entry(
                A::Resample,
                "Resample (remesh)",
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
    Menu { title: "View", entries: view_menu::ENTRIES },
    Menu {
        title: "Help",
        entries: &[
            Some(
                entry(A::Shortcuts, "Keyboard shortcuts", "List all keys and mouse gestures.")
                    .synonyms(&["keys", "hotkeys"]),
            ),
            Some(entry(A::Messages, "Messages", "List all imports, refusals and results.")),
            Some(entry(A::About, "About Meshwright", "Show the version and the graphics device.")),
        ],
    },
];
