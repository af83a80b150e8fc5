//! The keys of each preset, in one table. Operations of a family share the keys of the one that is listed.

use editor::{OpId, SelectBy};
use halfedge::Element;
use viewport::{ColorBy, Look, Side};

use super::action::Action as A;
use super::key_preset::KeyPreset;
use crate::transforming::{Gizmo, SnapTo};
use crate::view::pane::Split;

/// An action with its keys in each preset, with spaces between several; menus show the first.
pub(super) type Row = (A, [&'static str; KeyPreset::COUNT]);

#[rustfmt::skip]
pub(super) static ROWS: &[Row] = &[
    // Action                               Course                        Blender                     Maya
    // The browser keeps Ctrl+N.
    (A::New,                               ["Ctrl+Alt+N",                "Ctrl+Alt+N",               "Ctrl+Alt+N"]),
    (A::Open,                              ["Ctrl+O",                    "Ctrl+O",                   "Ctrl+O"]),
    (A::Save,                              ["Ctrl+S",                    "Ctrl+S",                   "Ctrl+S"]),
    (A::Undo,                              ["Ctrl+Z",                    "Ctrl+Z",                   "Ctrl+Z Z"]),
    (A::Redo,                              ["Ctrl+Shift+Z Ctrl+Y",       "Ctrl+Shift+Z Ctrl+Y",      "Ctrl+Shift+Z Ctrl+Y Shift+Z"]),
    // Maya's F9 selects vertices.
    (A::Adjust,                            ["F9",                        "F9",                       ""]),
    (A::Cancel,                            ["Escape",                    "Escape",                   "Escape"]),
    (A::Palette,                           ["Ctrl+K F3",                 "Ctrl+K F3 Space",          "Ctrl+K F3 Space"]),
    (A::Shortcuts,                         ["? F1",                      "? F1",                     "? F1"]),

    (A::Show(Element::Vertex),             ["1",                         "1",                        "F9"]),
    (A::Show(Element::Edge),               ["2",                         "2",                        "F10"]),
    (A::Show(Element::Halfedge),           ["3",                         "4",                        "Alt+F10"]),
    (A::Show(Element::Face),               ["4",                         "3",                        "F11"]),
    (A::SelectAll,                         ["Ctrl+A",                    "A",                        "Ctrl+Shift+A"]),
    (A::SelectNone,                        ["Ctrl+Shift+A",              "Alt+A",                    "Alt+D"]),
    (A::SelectInverse,                     ["Ctrl+I",                    "Ctrl+I",                   "Ctrl+Shift+I"]),
    (A::SelectBy(SelectBy::Grow),          ["Ctrl+= Ctrl++ Ctrl+Numpad+", "Ctrl+Numpad+ Ctrl+= Ctrl++", "Shift+."]),
    (A::SelectBy(SelectBy::Shrink),        ["Ctrl+- Ctrl+Numpad-",       "Ctrl+Numpad- Ctrl+-",      "Shift+,"]),
    (A::SelectBy(SelectBy::Linked),        ["Ctrl+L",                    "Ctrl+L",                   "Ctrl+L"]),
    (A::LinkedUnder,                       ["",                          "L",                        ""]),
    (A::SelectTool,                        ["Shift+Q",                   "W",                        "Q"]),
    (A::BoxSelect,                         ["Shift+B",                   "B",                        "Shift+B"]),
    (A::CircleSelect,                      ["Shift+C",                   "C",                        "Shift+C"]),
    (A::LargerCircle,                      ["]",                         "Numpad+ ]",                "]"]),
    (A::SmallerCircle,                     ["[",                         "Numpad- [",                "["]),
    (A::NextElement,                       ["PageDown",                  "PageDown",                 "PageDown"]),
    (A::PreviousElement,                   ["PageUp",                    "PageUp",                   "PageUp"]),
    (A::Next,                              ["N",                         "Alt+N",                    "N"]),
    (A::Previous,                          ["Shift+N",                   "Alt+Shift+N",              "Shift+N"]),
    (A::Twin,                              ["T",                         "Alt+T",                    "T"]),
    // In the Study layout, with a half-edge selected.
    (A::VertexOf,                          ["V",                         "V",                        "V"]),
    (A::EdgeOf,                            ["Y",                         "Y",                        "Y"]),
    (A::FaceOf,                            ["A",                         "A",                        "A"]),
    (A::GoToId,                            ["Ctrl+G",                    "Ctrl+G",                   "Ctrl+G"]),
    (A::OnlySelected,                      ["O",                         "",                         ""]),
    (A::Operation(OpId::Hide),             ["H",                         "H",                        "Ctrl+H"]),
    (A::Operation(OpId::Reveal),           ["Alt+H",                     "Alt+H",                    "Shift+H"]),
    (A::Operation(OpId::Isolate),          ["/",                         "/",                        "Ctrl+1"]),

    (A::Move,                              ["G",                         "G",                        ""]),
    (A::Rotate,                            ["Shift+R",                   "R",                        ""]),
    (A::Scale,                             ["Shift+D",                   "S",                        ""]),
    (A::Gizmo(Gizmo::Move),                ["",                          "",                         "W"]),
    (A::Gizmo(Gizmo::Rotate),              ["",                          "",                         "E"]),
    (A::Gizmo(Gizmo::Scale),               ["",                          "",                         "R"]),
    (A::Soft,                              ["Shift+O",                   "O",                        "B"]),
    (A::Snap,                              ["Shift+Tab",                 "Shift+Tab",                "Shift+Tab"]),

    // Maya's count while they are held.
    (A::SnapTo(SnapTo::Grid),              ["",                          "",                         "X"]),
    (A::SnapTo(SnapTo::Edge),              ["",                          "",                         "C"]),
    (A::SnapTo(SnapTo::Vertex),            ["",                          "",                         "V"]),
    // All presets paste with Ctrl+V, which is Blender's key for the edits of vertices.
    (A::ElementMenu(Element::Vertex),      ["",                          "Ctrl+Alt+V",               ""]),
    (A::ElementMenu(Element::Edge),        ["",                          "Ctrl+E",                   ""]),
    (A::ElementMenu(Element::Face),        ["",                          "Ctrl+F",                   ""]),

    (A::CursorMenu,                        ["",                          "Shift+S",                  ""]),

    (A::Operation(OpId::ExtrudeFaces),     ["E",                         "E",                        "Ctrl+E"]),
    (A::Operation(OpId::InsetFaces),       ["Shift+I",                   "I",                        "Shift+I"]),
    (A::Operation(OpId::BevelEdges),       ["B",                         "Ctrl+B",                   "Ctrl+B"]),
    (A::Operation(OpId::BevelVertices),    ["Ctrl+Shift+B",              "Ctrl+Shift+B",             "Ctrl+Shift+B"]),
    (A::LoopCutTool,                       ["L",                         "Ctrl+R",                   "Ctrl+Shift+L"]),
    // In Blender, G during a move slides too.
    (A::Operation(OpId::SlideEdges),       ["Shift+V",                   "Shift+V",                  "Shift+V"]),
    (A::Operation(OpId::ConnectVertices),  ["J",                         "J",                        "J"]),
    (A::Operation(OpId::SplitEdge),        ["S",                         "",                         ""]),
    (A::SlideSplit,                        ["Shift+S",                   "",                         ""]),
    (A::Operation(OpId::FlipEdge),         ["F",                         "",                         ""]),
    (A::Operation(OpId::CollapseEdge),     ["C",                         "",                         ""]),
    (A::Operation(OpId::RipEdges),         ["",                          "V",                        ""]),
    (A::Operation(OpId::FillHole),         ["Alt+F",                     "F Alt+F",                  "Alt+F"]),
    (A::Operation(OpId::MergeVertices),    ["Shift+M",                   "M",                        "M"]),
    (A::Operation(OpId::DissolveVertex),   ["Ctrl+X",                    "Ctrl+X",                   "Ctrl+Delete Ctrl+Backspace"]),
    (A::Operation(OpId::DeleteFaces),      ["Delete X",                  "X Delete",                 "Delete Backspace"]),
    (A::Operation(OpId::Separate),         ["Shift+P",                   "P",                        "Shift+P"]),
    (A::Operation(OpId::JoinObjects),      ["Ctrl+J",                    "Ctrl+J",                   "Ctrl+J"]),
    // The browser keeps Ctrl+T, except where the page is installed as an app.
    (A::Operation(OpId::TriangulateFaces), ["Shift+T",                   "Shift+T Ctrl+T",           "Shift+T"]),
    (A::Upsample,                          ["U",                         "",                         ""]),
    (A::Downsample,                        ["D",                         "",                         ""]),
    (A::Resample,                          ["R",                         "",                         ""]),
    (A::LongerEdges,                       ["=",                         "",                         ""]),
    (A::ShorterEdges,                      ["-",                         "",                         ""]),

    (A::NextLevel,                         ["E",                         "E",                        "E"]),
    (A::WholeCurve,                        ["C",                         "C",                        "C"]),
    (A::Play,                              ["K",                         "K",                        "K"]),
    (A::DeletePoint,                       ["Delete X",                  "X Delete",                 "Delete Backspace"]),

    (A::Frame,                             [".",                         "Numpad. .",                "F"]),
    (A::FrameAll,                          ["Shift+. Home",              "Home",                     "A"]),
    (A::ResetView,                         ["Space",                     "Shift+C",                  "Home"]),
    (A::ZoomIn,                            ["Alt+= Numpad+",             "Numpad+ Alt+=",            "= Numpad+ Alt+="]),
    (A::ZoomOut,                           ["Alt+- Numpad-",             "Numpad- Alt+-",            "- Numpad- Alt+-"]),
    (A::LookFrom(Side::Front),             ["Alt+1 Numpad1",             "Numpad1 Alt+1",            "Numpad1 Alt+1"]),
    (A::LookFrom(Side::Back),              ["Alt+Shift+1 Ctrl+Numpad1",  "Ctrl+Numpad1 Alt+Shift+1", "Ctrl+Numpad1 Alt+Shift+1"]),
    (A::LookFrom(Side::Right),             ["Alt+3 Numpad3",             "Numpad3 Alt+3",            "Numpad3 Alt+3"]),
    (A::LookFrom(Side::Left),              ["Alt+Shift+3 Ctrl+Numpad3",  "Ctrl+Numpad3 Alt+Shift+3", "Ctrl+Numpad3 Alt+Shift+3"]),
    (A::LookFrom(Side::Top),               ["Alt+7 Numpad7",             "Numpad7 Alt+7",            "Numpad7 Alt+7"]),
    (A::LookFrom(Side::Bottom),            ["Alt+Shift+7 Ctrl+Numpad7",  "Ctrl+Numpad7 Alt+Shift+7", "Ctrl+Numpad7 Alt+Shift+7"]),
    (A::Views(Split::Four),                ["Ctrl+Alt+Q",                "Ctrl+Alt+Q",               "Ctrl+Alt+Q"]),
    (A::AlignView,                         ["Shift+Numpad7",             "Shift+Numpad7",            "Shift+Numpad7"]),
    (A::Fly,                               ["Shift+`",                   "Shift+`",                  "Shift+`"]),
    (A::Orthographic,                      ["P Alt+5 Numpad5",           "Numpad5 Alt+5",            "Numpad5"]),
    (A::LookMenu,                          ["Z",                         "Z",                        ""]),
    (A::Wireframe,                         ["W",                         "Shift+Z",                  "Alt+5"]),
    (A::XRay,                              ["Alt+X",                     "Alt+Z",                    "Alt+X"]),
    (A::Smooth,                            ["M",                         "",                         ""]),
    (A::Look(Look::HiddenLine),            ["",                          "",                         "4"]),
    (A::Look(Look::Studio),                ["",                          "",                         "5"]),
    (A::ColorBy(ColorBy::Paint),           ["",                          "",                         "6"]),
    (A::Dots,                              ["V",                         "",                         ""]),
    (A::Grid,                              ["Shift+G",                   "",                         ""]),
    (A::Overlay,                           ["I",                         "Alt+I",                    "Alt+I"]),
    (A::LeftPanel,                         ["[",                         "T",                        "["]),
    (A::RightPanel,                        ["]",                         "N",                        "]"]),
];
