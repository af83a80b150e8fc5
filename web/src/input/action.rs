//! What a user can start, and how the interface presents it.
//!
//! An action on the document is an operation of the editor. The other actions concern the page: what is
//! shown and what is selected.

use editor::{OpId, SelectBy};
use formats::Format;
use halfedge::Element;
use viewport::{ColorBy, Look, Mark, Side, UpAxis};

use super::camera_style::{CameraStyle, OrbitAbout};
use super::key_preset::KeyPreset;
use super::presets::Preset;
use crate::shown::Arrangement;
use crate::transforming::{CursorAction, Gizmo, Orientation, Pivot, SnapTo, Symmetry};
use crate::units::LengthUnit;
use crate::view::pane::Split;

/// Something the user can start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Starts a new document with a cube.
    New,
    /// Opens a menu of the edits of a kind of element, at the pointer.
    ElementMenu(Element),
    /// Opens a menu of the looks at the pointer.
    LookMenu,
    /// Opens a menu of what the 3D cursor is for, at the pointer.
    CursorMenu,
    /// Goes to the fields of the last operation.
    Adjust,
    /// Opens the file dialog.
    Open,
    /// Opens the save dialog.
    Save,
    /// Opens the save dialog with this format chosen.
    SaveAs(Format),
    /// Opens or closes the window with a link to the document.
    Share,
    /// Undoes the last change.
    Undo,
    /// Redoes the last undone change.
    Redo,
    /// Shows or hides the list of steps.
    History,
    /// Cancels a running job or a drag; if there is none, clears the selection.
    Cancel,
    /// Selects every element of the kind in the list.
    SelectAll,
    /// Makes clicks and taps add to the selection, or remove from it.
    AddToSelection,
    /// Clears the selection.
    SelectNone,
    /// Inverts the selection.
    SelectInverse,
    /// Changes the selection by what is selected.
    SelectBy(SelectBy),
    /// Adds everything connected to the element under the pointer.
    LinkedUnder,
    /// Selects by a command with its fields filled in.
    Preset(Preset),
    /// Opens or closes the window with the named selections.
    NamedSelections,
    /// Shows or hides the list of the documents that the browser keeps.
    Documents,
    /// Shows one kind of element in the list; clicks in the viewport select that kind too. The selection is converted to
    /// what it contains of that kind.
    Show(Element),
    /// Shows one kind of element; the selection is converted to everything of that kind that touches it.
    Expand(Element),
    /// Selects the element after the selected one, of the kind in the list.
    NextElement,
    /// Selects the element before the selected one.
    PreviousElement,
    /// Selects the next half-edge around the face.
    Next,
    /// Selects the half-edge before the selected one around the face.
    Previous,
    /// Selects the twin of the selected half-edge.
    Twin,
    /// Selects the vertex that the selected half-edge leaves.
    VertexOf,
    /// Selects the edge of the selected half-edge.
    EdgeOf,
    /// Selects the face of the selected half-edge.
    FaceOf,
    /// Moves the keyboard focus to the "Go to id" field.
    GoToId,
    /// Shows only selected elements in the list, or all again.
    OnlySelected,
    /// Makes clicks select, and drags beside the mesh turn the view.
    SelectTool,
    /// Makes drags in the viewport draw a selection box.
    BoxSelect,
    /// Makes drags in the viewport draw a line around what they select.
    LassoSelect,
    /// Makes drags in the viewport select with a circle.
    CircleSelect,
    /// Makes a click in the viewport cut the ring of quads there.
    LoopCutTool,
    /// Makes the selecting circle larger.
    LargerCircle,
    /// Makes the selecting circle smaller.
    SmallerCircle,
    /// Frames the selection, or everything if nothing is selected.
    Frame,
    /// Frames everything.
    FrameAll,
    /// Restores the initial view.
    ResetView,
    /// Comes closer by one notch of the wheel.
    ZoomIn,
    /// Goes back by one notch of the wheel.
    ZoomOut,
    /// Looks from a side.
    LookFrom(Side),
    /// Chooses the axis that points upwards in the view.
    UpAxis(UpAxis),
    /// Looks at the selection against its normal.
    AlignView,
    /// Flies through the scene with keys and pointer.
    Fly,
    /// Switches between parallel and perspective projection.
    Orthographic,
    /// Splits the viewport into several views, or shows one again.
    Views(Split),
    /// Moves the camera with the gestures of a style.
    Camera(CameraStyle),
    /// Moves the camera with the gestures that belong to the preset of keys.
    CameraOfKeys,
    /// Switches between turning the view about the up axis and turning it freely.
    FreeRotation,
    /// Chooses what the view turns about.
    OrbitAbout(OrbitAbout),
    /// Switches the drawing of edges over faces.
    Wireframe,
    /// Switches between seeing and selecting through surfaces, and only what is in front.
    XRay,
    /// Switches between smooth and flat shading.
    Smooth,
    /// Switches between flat shading and smooth shading with edges that are hard above this angle, in degrees.
    AutoSmooth(u8),
    /// Chooses what gives faces their colours.
    ColorBy(ColorBy),
    /// Chooses how faces are shaded.
    Look(Look),
    /// Leaves out the backs of faces, or draws them again.
    HideBacks,
    /// Switches the drawing of vertices as dots.
    Dots,
    /// Switches marks of a kind.
    Mark(Mark),
    /// Switches the ground grid.
    Grid,
    /// Switches the shadow on the ground.
    Shadow,
    /// Switches the info overlay in the viewport.
    Overlay,
    /// Switches the ids of the elements around the pointer.
    Numbers,
    /// Shows or hides the list on the left.
    LeftPanel,
    /// Shows or hides the inspector on the right.
    RightPanel,
    /// Arranges the page for modelling or for studying meshes.
    Arrange(Arrangement),
    /// Scales the interface, in percent.
    InterfaceScale(u16),
    /// Says what one unit of the mesh is, for typed lengths.
    LengthUnit(LengthUnit),
    /// Follows the system's light or dark theme.
    SystemTheme,
    /// The light theme.
    LightTheme,
    /// The dark theme.
    DarkTheme,
    /// Takes a preset of keys, and keeps it for later visits.
    UseKeys(KeyPreset),
    /// Shows or hides the welcome view.
    Welcome,
    /// Opens the guide.
    Guide,
    /// Opens or closes the window with all keys.
    Shortcuts,
    /// Opens the command palette.
    Palette,
    /// Opens or closes the window with all messages.
    Messages,
    /// Opens or closes the window about the version and the device.
    About,
    /// Reloads the page with its newer version.
    Update,
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
    /// Moves the selection with the pointer.
    Move,
    /// Rotates the selection with the pointer.
    Rotate,
    /// Scales the selection with the pointer.
    Scale,
    /// Chooses the handles at the selection.
    Gizmo(Gizmo),
    /// Switches snapping.
    Snap,
    /// Chooses what moved elements snap to.
    SnapTo(SnapTo),
    /// Switches soft selection, which moves the vertices around the selection too.
    Soft,
    /// Chooses what rotations and scales leave in place.
    PivotAt(Pivot),
    /// Does something with the 3D cursor.
    Cursor(CursorAction),
    /// Chooses the axes of edits.
    Orient(Orientation),
    /// Sets the axis along which moves, rotations and scales are mirrored.
    Mirror(Symmetry),
    /// Splits the selected edge at a point that follows the pointer.
    SlideSplit,
    /// Starts a document with a Bezier curve.
    NewCurve,
    /// Starts a document with a Bezier patch.
    NewPatch,
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

impl Action {
    /// The action for a selection of this kind: of a family of operations, the member that works on it.
    pub fn for_selection(self, kind: Element) -> Self {
        match self {
            Self::Operation(id) => Self::Operation(id.for_selection(kind)),
            other => other,
        }
    }

    /// Whether it moves the current view, which becomes the active one.
    pub(crate) fn moves_view(self) -> bool {
        matches!(
            self,
            Self::Frame
                | Self::FrameAll
                | Self::ResetView
                | Self::ZoomIn
                | Self::ZoomOut
                | Self::LookFrom(_)
                | Self::AlignView
                | Self::Fly
                | Self::Orthographic
        )
    }

    /// The name in settings: the variant's, in kebab case; an operation's name in commands after `operation-`.
    pub(crate) fn name(self) -> String {
        if let Self::Operation(id) = self {
            return format!("operation-{}", id.spec().name);
        }
        let mut name = String::new();
        for letter in format!("{self:?}").chars() {
            let begins_word = letter.is_ascii_uppercase() || !letter.is_ascii_alphanumeric();
            if begins_word && !name.is_empty() && !name.ends_with('-') {
                name.push('-');
            }
            name.extend(letter.is_ascii_alphanumeric().then(|| letter.to_ascii_lowercase()));
        }
        name.trim_end_matches('-').to_owned()
    }
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
    /// Other programs' names for it, by which the palette finds it too.
    pub synonyms: &'static [&'static str],
}

impl Entry {
    pub(super) const fn synonyms(self, synonyms: &'static [&'static str]) -> Self {
        Self { synonyms, ..self }
    }
}

pub(super) const fn entry(action: Action, label: &'static str, description: &'static str) -> Entry {
    Entry { action, label, description, synonyms: &[] }
}
