//! The menus of the page's own actions, in one table. The palette lists them too.

use editor::{OpId, SelectBy};
use halfedge::Element;

use super::action::{Action, Entry, entry};
use super::actions;
use super::key_preset::KeyPreset;
use super::presets::Preset;
use super::{select_menu, transform_menu, view_menu};
use crate::units::LengthUnit;

/// A menu; an entry of `None` is a separator.
pub struct Menu {
    /// Which menu.
    pub id: MenuId,
    /// The entries.
    pub entries: &'static [Option<Entry>],
}

/// The menus of the menu bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MenuId {
    /// Files, documents and shapes.
    File,
    /// Undo and redo.
    Edit,
    /// The selection, and what is hidden.
    Select,
    /// Moving, rotating and scaling.
    Transform,
    /// Operations on meshes.
    Mesh,
    /// Operations on Bezier curves and surfaces.
    Bezier,
    /// The camera and how meshes are drawn.
    View,
    /// Help.
    Help,
}

impl MenuId {
    /// The title in the menu bar.
    pub fn title(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::Select => "Select",
            Self::Transform => "Transform",
            Self::Mesh => "Mesh",
            Self::Bezier => "Bezier",
            Self::View => "View",
            Self::Help => "Help",
        }
    }
}

use Action as A;

/// The submenu with the criteria, which continues with the editor's operations.
pub const CRITERIA: &str = "By criterion";

/// The submenus with what is done to a whole mesh in one way or another: the course's own keys and names first, then the
/// editor's operations.
const SUBDIVIDE: &str = "Subdivide";
const SIMPLIFY: &str = "Simplify";
const REMESH: &str = "Remesh";

/// The operations with which a submenu continues.
pub fn continued(title: &str) -> Vec<OpId> {
    match title {
        CRITERIA => actions::criteria().collect(),
        SUBDIVIDE => vec![OpId::SubdivideCatmullClark, OpId::SubdivideLoop, OpId::SubdivideLinear],
        SIMPLIFY => vec![OpId::Simplify],
        REMESH => vec![OpId::Remesh],
        _ => Vec::new(),
    }
}

/// Whether a submenu continues with an operation.
pub fn is_in_submenu(id: OpId) -> bool {
    [SUBDIVIDE, SIMPLIFY, REMESH].into_iter().any(|title| continued(title).contains(&id))
}

/// The submenu that an entry is in, which keeps long menus on small screens.
pub fn submenu(action: Action) -> Option<&'static str> {
    match action {
        A::FrameAll | A::ZoomIn | A::ZoomOut | A::Fly => Some("Zoom and fly"),
        A::ResetView | A::LookFrom(_) | A::AlignView => Some("Look from"),
        A::UpAxis(_) => Some("Up axis"),
        A::Views(_) => Some("Views"),
        A::Camera(_) | A::CameraOfKeys | A::FreeRotation | A::OrbitAbout(_) => Some("Camera style"),
        A::SelectBy(SelectBy::Kind(_)) => Some("Convert to"),
        A::SelectBy(SelectBy::Loops | SelectBy::Rings | SelectBy::Path | SelectBy::Outline) => {
            Some("Loops and paths")
        }
        A::SelectTool
        | A::BoxSelect
        | A::LassoSelect
        | A::CircleSelect
        | A::LargerCircle
        | A::SmallerCircle => Some("Select tool"),
        A::Next | A::Previous | A::Twin | A::VertexOf | A::EdgeOf | A::FaceOf => Some("Half-edge"),
        A::Preset(Preset::Similar(_)) => Some("Similar"),
        A::Preset(_) => Some(CRITERIA),
        A::Upsample => Some(SUBDIVIDE),
        A::Downsample => Some(SIMPLIFY),
        A::Resample | A::LongerEdges | A::ShorterEdges => Some(REMESH),
        A::Show(_) => Some("Show"),
        A::ElementMenu(_) => Some("Menus at the pointer"),
        A::LookMenu => Some("Look"),
        A::CursorMenu => Some("Cursor"),
        A::Expand(_) => Some("Expand to"),
        A::Look(_) | A::HideBacks => Some("Look"),
        A::AutoSmooth(_) => Some("Auto smooth"),
        A::ColorBy(_) => Some("Colour by"),
        A::Mark(_) => Some("Marks"),
        A::Gizmo(_) => Some("Gizmo"),
        A::PivotAt(_) => Some("Pivot"),
        A::Cursor(_) => Some("Cursor"),
        A::Orient(_) => Some("Axes"),
        A::Mirror(_) => Some("Symmetry"),
        A::SnapTo(_) => Some("Snap to"),
        A::Arrange(_) => Some("Layout"),
        A::LengthUnit(_) => Some("Unit of length"),
        A::InterfaceScale(_) => Some("Interface scale"),
        A::UseKeys(_) => Some("Keys"),
        A::SystemTheme | A::LightTheme | A::DarkTheme => Some("Theme"),
        _ => None,
    }
}

/// Other names for the presets of keys.
const KEYS: &[&str] = &["keymap", "shortcuts", "hotkeys", "preset"];

const fn unit(unit: LengthUnit, label: &'static str) -> Option<Entry> {
    let description =
        "Choose what one unit of the mesh is, so that typed lengths may have units. Coordinates stay.";
    Some(entry(A::LengthUnit(unit), label, description).synonyms(&["unit of length", "metric", "imperial"]))
}

/// The menus, left to right. The mesh menu continues with the editor's operations.
pub static MENUS: &[Menu] = &[
    Menu {
        id: MenuId::File,
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
                    "Open a project or a mesh file. You can also drop a file on the page or paste OBJ text.",
                )
                .synonyms(&["import", "load"]),
            ),
            Some(
                entry(
                    A::Documents,
                    "Recent documents…",
                    "List the documents that are kept: open, rename, copy or delete them.",
                )
                .synonyms(&["documents", "history", "recover", "autosave", "my files", "last session"]),
            ),
            Some(
                entry(A::Save, "Save…", "Choose a name and a format, and see what the format can't hold.")
                    .synonyms(&["export", "download"]),
            ),
            Some(
                entry(
                    A::Share,
                    "Share…",
                    "Make a link that holds the document, and a QR code of it. Nothing is uploaded.",
                )
                .synonyms(&["link", "url", "send", "qr code", "publish"]),
            ),
        ],
    },
    Menu {
        id: MenuId::Edit,
        entries: &[
            Some(entry(A::Undo, "Undo", "Undo the last change, of the mesh or of the selection.")),
            Some(entry(A::Redo, "Redo", "Redo the last undone change.")),
            Some(
                entry(A::History, "History", "List the steps by name; click one to go to it.")
                    .synonyms(&["undo history", "steps", "go back"]),
            ),
            Some(
                entry(A::Adjust, "Adjust last operation", "Go to the fields of the last operation.")
                    .synonyms(&["redo panel", "operator panel", "change"]),
            ),
            None,
            Some(entry(
                A::Cancel,
                "Cancel",
                "Cancel a running job or a drag; if there is none, clear the selection.",
            )),
            Some(entry(A::Palette, "Find a command…", "List every command; type to search.")),
            None,
            Some(
                entry(
                    A::UseKeys(KeyPreset::Course),
                    "Course keys",
                    "Single letters for the operations of the courses; a drag beside the mesh orbits.",
                )
                .synonyms(KEYS),
            ),
            Some(
                entry(
                    A::UseKeys(KeyPreset::Blender),
                    "Blender keys",
                    "Keys and mouse as in Blender: the middle button orbits, a drag beside the mesh selects in a box.",
                )
                .synonyms(KEYS),
            ),
            Some(
                entry(
                    A::UseKeys(KeyPreset::Maya),
                    "Maya keys",
                    "Keys and mouse as in Maya: Alt and the buttons move the view, a drag selects in a box.",
                )
                .synonyms(KEYS),
            ),
            Some(entry(A::SystemTheme, "System theme", "Use the system's light or dark theme.")),
            Some(entry(A::LightTheme, "Light theme", "Use dark text on a light page.")),
            Some(entry(A::DarkTheme, "Dark theme", "Use light text on a dark page.")),
            unit(LengthUnit::None, "No unit"),
            unit(LengthUnit::Millimetre, "Millimetres"),
            unit(LengthUnit::Centimetre, "Centimetres"),
            unit(LengthUnit::Metre, "Metres"),
            unit(LengthUnit::Inch, "Inches"),
            unit(LengthUnit::Foot, "Feet"),
        ],
    },
    Menu { id: MenuId::Select, entries: select_menu::ENTRIES },
    Menu { id: MenuId::Transform, entries: transform_menu::ENTRIES },
    Menu {
        id: MenuId::Mesh,
        entries: &[
            Some(
                entry(
                    A::LoopCutTool,
                    "Loop cut at the pointer",
                    "Point at an edge: a click cuts the ring of quads across it and slides the cut. The wheel or a typed number sets the number of cuts.",
                )
                .synonyms(&["insert edge loop", "ring cut"]),
            ),
            Some(entry(
                A::SlideSplit,
                "Split edge at…",
                "Add a vertex to the selected edge and slide it with the pointer.",
            )),
            Some(entry(
                A::ElementMenu(Element::Vertex),
                "Vertex menu",
                "Open a menu of the edits of vertices at the pointer.",
            )),
            Some(entry(
                A::ElementMenu(Element::Edge),
                "Edge menu",
                "Open a menu of the edits of edges at the pointer.",
            )),
            Some(entry(
                A::ElementMenu(Element::Face),
                "Face menu",
                "Open a menu of the edits of faces at the pointer.",
            )),
            None,
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
        ],
    },
    Menu {
        id: MenuId::Bezier,
        entries: &[
            Some(
                entry(
                    A::NewCurve,
                    "New Bezier curve",
                    "Start a new document with a cubic curve. The old one is kept: undo brings it back.",
                )
                .synonyms(&["add curve", "spline", "path"]),
            ),
            Some(
                entry(
                    A::NewPatch,
                    "New Bezier patch",
                    "Start a new document with a surface of 4 by 4 control points. The old one is kept: undo brings it back.",
                )
                .synonyms(&["add surface", "add patch", "bicubic"]),
            ),
            None,
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
    Menu { id: MenuId::View, entries: view_menu::ENTRIES },
    Menu {
        id: MenuId::Help,
        entries: &[
            Some(
                entry(A::Welcome, "Welcome", "Show where to start: files, sample models and shapes.")
                    .synonyms(&["home", "start", "samples", "examples"]),
            ),
            Some(
                entry(A::Guide, "Guide", "Read the guide and the references. They work offline too.")
                    .synonyms(&["help", "manual", "documentation", "tutorial"]),
            ),
            Some(
                entry(
                    A::Shortcuts,
                    "Keyboard shortcuts",
                    "List all keys and mouse gestures, find a key, and change it.",
                )
                .synonyms(&["keys", "hotkeys", "keymap", "preferences"]),
            ),
            Some(entry(A::Messages, "Messages", "List all imports, refusals and results.")),
            Some(entry(A::About, "About Meshwright", "Show the version and the graphics device.")),
            Some(
                entry(
                    A::Update,
                    "Reload with the new version",
                    "Reload the page with the new version of Meshwright. The document is kept.",
                )
                .synonyms(&["update", "upgrade"]),
            ),
        ],
    },
];
