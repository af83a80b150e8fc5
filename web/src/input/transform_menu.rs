//! The Transform menu: moving, rotating and scaling with the pointer, and how they do it.

use super::action::{Action as A, Entry, entry};
use crate::transforming::{CursorAction, Gizmo, Orientation, Pivot, SnapTo, Symmetry};

/// Other names for symmetry.
const MIRROR: &[&str] = &["mirror", "mirror editing"];

/// Other names for the 3D cursor.
const CURSOR: &[&str] = &["3d cursor", "snap", "pivot point"];

/// Its entries.
pub(super) static ENTRIES: &[Option<Entry>] = &[
    Some(
        entry(A::Move, "Move", "Move the selection with the pointer, or by typed numbers.")
            .synonyms(&["grab", "translate"]),
    ),
    Some(
        entry(A::Rotate, "Rotate", "Rotate the selection with the pointer, or by typed degrees.")
            .synonyms(&["turn"]),
    ),
    Some(
        entry(A::Scale, "Scale", "Scale the selection with the pointer, or by a typed factor.")
            .synonyms(&["size"]),
    ),
    None,
    Some(
        entry(A::Gizmo(Gizmo::Move), "Move gizmo", "Show handles that move the selection.")
            .synonyms(&["arrows"]),
    ),
    Some(entry(A::Gizmo(Gizmo::Rotate), "Rotate gizmo", "Show rings that rotate the selection.")),
    Some(entry(A::Gizmo(Gizmo::Scale), "Scale gizmo", "Show handles that scale the selection.")),
    Some(entry(A::Gizmo(Gizmo::Off), "No gizmo", "Show no handles at the selection.")),
    Some(
        entry(A::Snap, "Snap", "Snap moves, turns and sizes; holding Ctrl does the opposite.")
            .synonyms(&["magnet"]),
    ),
    Some(entry(
        A::SnapTo(SnapTo::Steps),
        "Snap to steps",
        "Snap to round steps of length, 5 degrees or a tenth. A key for it snaps while it is held.",
    )),
    Some(entry(
        A::SnapTo(SnapTo::Grid),
        "Snap to grid",
        "Snap moves to round coordinates; rotations and scales snap to steps. A key for it snaps while it is held.",
    )),
    Some(entry(
        A::SnapTo(SnapTo::Vertex),
        "Snap to vertices",
        "Snap what moves to the vertex under the pointer. A key for it snaps while it is held.",
    )),
    Some(entry(
        A::SnapTo(SnapTo::Edge),
        "Snap to edges",
        "Snap what moves to the edge under the pointer. A key for it snaps while it is held.",
    )),
    Some(entry(
        A::SnapTo(SnapTo::Face),
        "Snap to faces",
        "Snap what moves to the face under the pointer. A key for it snaps while it is held.",
    )),
    Some(
        entry(A::Soft, "Soft selection", "Vertices near the selection move too; the wheel changes how far.")
            .synonyms(&["proportional editing"]),
    ),
    Some(entry(
        A::PivotAt(Pivot::Middle),
        "Pivot: median",
        "Rotate and scale about the mean of the selected vertices.",
    )),
    Some(entry(
        A::PivotAt(Pivot::Bounds),
        "Pivot: bounding box",
        "Rotate and scale about the middle of the selection's bounding box.",
    )),
    Some(entry(
        A::PivotAt(Pivot::Active),
        "Pivot: last selected",
        "Rotate and scale about the element selected last.",
    )),
    Some(
        entry(
            A::PivotAt(Pivot::Individual),
            "Pivot: each part",
            "Rotate and scale each connected part about its own middle.",
        )
        .synonyms(&["individual origins"]),
    ),
    Some(entry(A::PivotAt(Pivot::Origin), "Pivot: origin", "Rotate and scale about the origin.")),
    Some(
        entry(A::PivotAt(Pivot::Cursor), "Pivot: cursor", "Rotate and scale about the 3D cursor.")
            .synonyms(CURSOR),
    ),
    Some(
        entry(
            A::Cursor(CursorAction::ToSelection),
            "Cursor to selection",
            "Put the 3D cursor in the middle of the selection, or where the pivot is on it.",
        )
        .synonyms(CURSOR),
    ),
    Some(
        entry(A::Cursor(CursorAction::ToOrigin), "Cursor to origin", "Put the 3D cursor at the origin.")
            .synonyms(CURSOR),
    ),
    Some(
        entry(
            A::Cursor(CursorAction::TakesSelection),
            "Selection to cursor",
            "Move the selection so that its middle is at the 3D cursor.",
        )
        .synonyms(CURSOR),
    ),
    Some(
        entry(
            A::Cursor(CursorAction::Merge),
            "Merge at cursor",
            "Merge the selected vertices into one at the 3D cursor.",
        )
        .synonyms(CURSOR),
    ),
    Some(
        entry(A::Cursor(CursorAction::Show), "Show 3D cursor", "Show or hide the 3D cursor.")
            .synonyms(CURSOR),
    ),
    Some(
        entry(A::CursorMenu, "Cursor menu", "Open the menu of the 3D cursor at the pointer.")
            .synonyms(&["snap menu", "3d cursor"]),
    ),
    Some(entry(
        A::Orient(Orientation::Global),
        "Global axes",
        "Move, rotate and scale along the axes of the mesh.",
    )),
    Some(entry(
        A::Orient(Orientation::Normal),
        "Normal axes",
        "Move, rotate and scale along the selection's normal and across it.",
    )),
    Some(entry(
        A::Orient(Orientation::View),
        "View axes",
        "Move, rotate and scale along the axes of the view.",
    )),
    Some(
        entry(A::Mirror(Symmetry::None), "No symmetry", "Edit the selection only.").synonyms(&["mirror off"]),
    ),
    Some(
        entry(A::Mirror(Symmetry::X), "Symmetry along x", "Mirror edits across the plane x = 0.")
            .synonyms(MIRROR),
    ),
    Some(
        entry(A::Mirror(Symmetry::Y), "Symmetry along y", "Mirror edits across the plane y = 0.")
            .synonyms(MIRROR),
    ),
    Some(
        entry(A::Mirror(Symmetry::Z), "Symmetry along z", "Mirror edits across the plane z = 0.")
            .synonyms(MIRROR),
    ),
];
