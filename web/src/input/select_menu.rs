//! The Select menu.

use editor::SelectBy;
use editor::ops::Similarity;
use halfedge::Element;

use super::action::{Action as A, Entry, entry};
use super::presets::Preset;

/// The entries; `None` is a separator.
pub(super) const ENTRIES: &[Option<Entry>] = &[
    Some(entry(A::SelectAll, "Select all", "Select every element of the kind in the list.")),
    Some(entry(
        A::AddToSelection,
        "Add to selection",
        "Let clicks and taps add to the selection, or remove from it.",
    )),
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
        entry(A::SelectBy(SelectBy::Shrink), "Shrink", "Deselect the elements beside unselected ones.")
            .synonyms(&["select less", "contract"]),
    ),
    Some(
        entry(A::SelectBy(SelectBy::Linked), "Select linked", "Add everything connected to the selection.")
            .synonyms(&["select island", "connected"]),
    ),
    Some(entry(
        A::LinkedUnder,
        "Select linked under the pointer",
        "Add everything connected to the element under the pointer. Start it with a key.",
    )),
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
        entry(A::Preset(Preset::Triangles), "Select triangles", "Select faces with three corners.")
            .synonyms(&["tris"]),
    ),
    Some(entry(A::Preset(Preset::Quads), "Select quads", "Select faces with four corners.")),
    Some(
        entry(A::Preset(Preset::NGons), "Select n-gons", "Select faces with more than four corners.")
            .synonyms(&["polygons", "faces by sides"]),
    ),
    Some(
        entry(A::Preset(Preset::TowardsView), "Select facing the view", "Select faces that face the viewer.")
            .synonyms(&["front faces", "side"]),
    ),
    Some(
        entry(
            A::Preset(Preset::Similar(Similarity::Count)),
            "Same corners or valence",
            "Select faces with as many corners as the one selected last, or vertices with as many edges.",
        )
        .synonyms(&["select similar"]),
    ),
    Some(
        entry(
            A::Preset(Preset::Similar(Similarity::Size)),
            "Same area or length",
            "Select faces or edges of about the size of the one selected last.",
        )
        .synonyms(&["select similar"]),
    ),
    Some(
        entry(
            A::Preset(Preset::Similar(Similarity::Normal)),
            "Same normal",
            "Select faces parallel to the one selected last.",
        )
        .synonyms(&["select similar", "coplanar"]),
    ),
    Some(
        entry(
            A::Preset(Preset::Similar(Similarity::Color)),
            "Same colour",
            "Select faces with the colour of the one selected last.",
        )
        .synonyms(&["select similar", "same material"]),
    ),
    Some(
        entry(A::NamedSelections, "Named selections…", "Keep selections under names, and select them again.")
            .synonyms(&["vertex groups", "selection sets", "save selection"]),
    ),
    None,
    Some(entry(
        A::SelectTool,
        "Select by clicking",
        "Click in the viewport to select; drag beside the mesh to turn the view.",
    )),
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
    Some(entry(
        A::NextElement,
        "Next element",
        "Select the element after the selected one; after the last comes the first.",
    )),
    Some(entry(
        A::PreviousElement,
        "Previous element",
        "Select the element before the selected one; before the first comes the last.",
    )),
    Some(entry(A::Next, "Next half-edge", "Select the next half-edge around the face.")),
    Some(entry(A::Previous, "Previous half-edge", "Select the half-edge before this one around the face.")),
    Some(entry(A::Twin, "Twin half-edge", "Select the half-edge on the other side of the edge.")),
    Some(entry(A::VertexOf, "Vertex of half-edge", "Select the vertex that the half-edge leaves.")),
    Some(entry(A::EdgeOf, "Edge of half-edge", "Select the edge of the half-edge.")),
    Some(entry(A::FaceOf, "Face of half-edge", "Select the face of the half-edge.")),
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
];
