//! Every key of every preset does what its row in the table says, and nothing else.

use std::collections::BTreeSet;

use crate::keys::{shortcut, strike_typing};
use crate::page::Page;
use crate::seen::Seen;
use editor::OpId;
use egui::{Vec2, vec2};
use egui_kittest::kittest::Queryable;
use meshwright_web::input::actions::Action;
use meshwright_web::input::key_map::KeyMap;
use meshwright_web::input::key_preset::KeyPreset;
use meshwright_web::input::shortcut::Shortcut;
use meshwright_web::platform::headless::Outside;
use serde_json::json;

/// A window in which no bar hides a switch for want of room.
const LARGE: Vec2 = Vec2::new(1920.0, 1080.0);

/// An action with a page on which it can be done, what is typed after its key, and all that changes.
type Row = (&'static str, fn(&mut Page), &'static str, &'static [&'static str]);

#[rustfmt::skip]
const ROWS: &[Row] = &[
    ("New", face, "", &["history.undo: [\"New shape\"]", "selection.ids: []"]),
    ("Open", face, "", &["file dialogs: 1"]),
    ("Save", face, "", &["field File name: there", "focus: File name"]),
    ("Undo", subdivided, "", &[
        "document.edges: 12",
        "document.faces: 6",
        "document.vertices: 8",
        "history.redo: [\"Subdivide (Catmull-Clark)\"]",
        "history.undo: []",
    ]),
    ("Redo", undone, "", &[
        "document.edges: 48",
        "document.faces: 24",
        "document.vertices: 26",
        "history.redo: []",
        "history.undo: [\"Subdivide (Catmull-Clark)\"]",
    ]),
    ("Cancel", face, "", &["selection.ids: []"]),
    ("Adjust", subdivided, "", &["focus: Levels"]),
    ("LookMenu", face, "", &[
        "switch Clay: false",
        "switch Colours without light: false",
        "switch Face orientation: false",
        "switch Hidden line: false",
        "switch Light at the camera: false",
        "switch Metal: false",
        "switch Normals as colours: false",
        "switch Pearl: false",
        "switch Red wax: false",
        "switch Studio lights: true",
        "switch Textures: false",
        "switch UV checker: false",
        "switch Zebra stripes: false",
        "window Look menu: open",
    ]),
    ("CursorMenu", face, "", &["switch Show 3D cursor: false", "window Cursor menu: open"]),
    ("Palette", face, "", &["field Find a command: there", "focus: Find a command"]),
    ("Shortcuts", face, "", &[
        "field Find by name: there",
        "switch Changed only: false",
        "switch Find by key: false",
        "window Keyboard shortcuts: open",
    ]),

    ("Show(Vertex)", face, "", &[
        "selection.ids: [0,1,2,3]",
        "selection.kind: \"vertex\"",
        "switch Face mode: false",
        "switch Vertex mode: true",
        "view.list: \"vertex\"",
    ]),
    ("Show(Edge)", face, "", &[
        "selection.ids: [0,1,2,3]",
        "selection.kind: \"edge\"",
        "switch Edge mode: true",
        "switch Face mode: false",
        "view.list: \"edge\"",
    ]),
    ("Show(Halfedge)", face, "", &[
        "selection.ids: [0,2,4,6]",
        "selection.kind: \"halfedge\"",
        "switch Face mode: false",
        "switch Half-edge mode: true",
        "switch Half-edges: true",
        "view.list: \"half-edge\"",
    ]),
    ("Show(Face)", vertices_of_face, "", &[
        "selection.ids: [0]",
        "selection.kind: \"face\"",
        "switch Face mode: true",
        "switch Vertex mode: false",
        "view.list: \"face\"",
    ]),
    ("SelectAll", face, "", &["selection.ids: [0,1,2,3,4,5]"]),
    ("SelectNone", face, "", &["selection.ids: []"]),
    ("SelectInverse", face, "", &["selection.ids: [1,2,3,4,5]"]),
    ("SelectBy(Grow)", face, "", &["selection.ids: [0,2,3,4,5]"]),
    ("SelectBy(Shrink)", all_but_one_face, "", &["selection.ids: [1]"]),
    ("SelectBy(Linked)", two_pieces, "", &["selection.ids: [0,1,2,3,4,5]"]),
    ("LinkedUnder", nothing, "", &["selection.ids: [0,1,2,3,4,5,6,7]"]),
    ("SelectTool", box_tool, "", &["switch Tool: Box: false", "switch Tool: Select: true"]),
    ("BoxSelect", face, "", &["switch Tool: Box: true", "switch Tool: Select: false"]),
    ("CircleSelect", face, "", &[
        "largest circle: 33",
        "switch Tool: Circle: true",
        "switch Tool: Select: false",
    ]),
    ("LargerCircle", circle_tool, "", &["largest circle: 41"]),
    ("SmallerCircle", circle_tool, "", &["largest circle: 27"]),
    ("NextElement", face, "", &["selection.ids: [1]"]),
    ("PreviousElement", face, "", &["selection.ids: [5]"]),
    ("Next", halfedge, "", &["selection.ids: [2]"]),
    ("Previous", halfedge, "", &["selection.ids: [6]"]),
    ("Twin", halfedge, "", &["selection.ids: [1]"]),
    ("VertexOf", halfedge_in_study, "", &[
        "selection.kind: \"vertex\"",
        "switch Half-edge mode: false",
        "switch Half-edges: false",
        "switch Vertex mode: true",
        "view.list: \"vertex\"",
    ]),
    ("EdgeOf", halfedge_in_study, "", &[
        "selection.kind: \"edge\"",
        "switch Edge mode: true",
        "switch Half-edge mode: false",
        "switch Half-edges: false",
        "view.list: \"edge\"",
    ]),
    ("FaceOf", halfedge_in_study, "", &[
        "selection.kind: \"face\"",
        "switch Face mode: true",
        "switch Half-edge mode: false",
        "switch Half-edges: false",
        "view.list: \"face\"",
    ]),
    ("GoToId", face, "", &["focus: Go to id"]),
    ("OnlySelected", face, "", &["switch Only selected: true"]),
    ("Operation(Hide)", face, "", &[
        "hidden faces: 1",
        "history.undo: [\"Hide\"]",
        "selection.ids: []",
    ]),
    ("Operation(Reveal)", hidden_face, "", &["hidden faces: 0", "history.undo: [\"Hide\",\"Reveal\"]"]),
    ("Operation(Isolate)", face, "", &["hidden faces: 5", "history.undo: [\"Isolate\"]"]),

    ("Move", face, "1", &[
        "box: [-1.00, -1.00, -1.00] to [2.00, 1.00, 1.00]",
        "history.undo: [\"Move\"]",
    ]),
    ("Rotate", face, "45", &[
        "box: [-1.26, -1.35, -1.63] to [1.26, 1.35, 1.00]",
        "history.undo: [\"Rotate\"]",
    ]),
    ("Scale", face, "2", &[
        "box: [-2.00, -2.00, -1.00] to [2.00, 2.00, 1.00]",
        "history.undo: [\"Scale\"]",
    ]),
    ("Gizmo(Move)", face, "", &["switch Tool: Move: true", "switch Tool: Select: false"]),
    ("Gizmo(Rotate)", face, "", &["switch Tool: Rotate: true", "switch Tool: Select: false"]),
    ("Gizmo(Scale)", face, "", &["switch Tool: Scale: true", "switch Tool: Select: false"]),
    ("Soft", face, "", &["switch Soft selection: true"]),
    ("Snap", face, "", &["switch Snap: true"]),
    ("ElementMenu(Vertex)", face, "", &["window Vertex menu: open"]),
    ("ElementMenu(Edge)", face, "", &["window Edge menu: open"]),
    ("ElementMenu(Face)", face, "", &["window Face menu: open"]),

    ("Operation(ExtrudeFaces)", face, "1", &[
        "box: [-1.00, -1.00, -2.00] to [1.00, 1.00, 1.00]",
        "document.edges: 20",
        "document.faces: 10",
        "document.vertices: 12",
        "history.undo: [\"Extrude faces\"]",
    ]),
    ("Operation(InsetFaces)", face, ".25", &[
        "document.edges: 20",
        "document.faces: 10",
        "document.vertices: 12",
        "history.undo: [\"Inset faces\"]",
    ]),
    ("Operation(BevelEdges)", edge, ".25", &[
        "document.edges: 15",
        "document.faces: 7",
        "document.vertices: 10",
        "history.undo: [\"Bevel edges\"]",
        "selection.ids: [12,13,14,15]",
    ]),
    ("Operation(BevelVertices)", vertex, ".25", &[
        "document.edges: 15",
        "document.faces: 7",
        "document.vertices: 10",
        "history.undo: [\"Bevel vertices\"]",
        "selection.ids: [8,9,10]",
    ]),
    ("LoopCutTool", face, "", &[
        "switch Tool: Loop cut: true",
        "switch Tool: Select: false",
    ]),
    ("Operation(SlideEdges)", edge, ".5", &["history.undo: [\"Slide edges\"]"]),
    ("Operation(ConnectVertices)", two_corners, "", &[
        "document.edges: 13",
        "document.faces: 7",
        "history.undo: [\"Connect vertices\"]",
    ]),
    ("Operation(SplitEdge)", edge, "", &[
        "document.edges: 13",
        "document.vertices: 9",
        "history.undo: [\"Split edge\"]",
        "selection.ids: [0,12]",
    ]),
    ("SlideSplit", edge, ".25", &[
        "document.edges: 13",
        "document.vertices: 9",
        "history.undo: [\"Split edge\"]",
        "selection.ids: [0,12]",
    ]),
    ("Operation(FlipEdge)", edge, "", &["history.undo: [\"Flip edge\"]"]),
    ("Operation(CollapseEdge)", edge, "", &[
        "document.edges: 11",
        "document.vertices: 7",
        "history.undo: [\"Collapse edge\"]",
        "selection.ids: []",
    ]),
    ("Operation(RipEdges)", edges_of_grid, "", &[
        "document.edges: 13",
        "document.vertices: 10",
        "history.undo: [\"New shape\",\"Rip edges\"]",
    ]),
    ("Operation(FillHole)", edges_of_hole, "", &[
        "document.faces: 6",
        "history.undo: [\"Delete faces\",\"Fill hole\"]",
    ]),
    ("Operation(MergeVertices)", ends_of_edge, "", &["field Filter operations: gone", "form Merge vertices: open"]),
    ("Operation(DissolveVertex)", vertex, "", &[
        "document.edges: 9",
        "document.faces: 4",
        "document.vertices: 7",
        "history.undo: [\"Dissolve vertex\"]",
        "selection.ids: []",
    ]),
    ("Operation(DeleteFaces)", face, "", &[
        "document.faces: 5",
        "history.undo: [\"Delete faces\"]",
        "selection.ids: []",
    ]),
    ("Operation(Separate)", face, "", &["field Filter operations: gone", "form Separate: open"]),
    ("Operation(JoinObjects)", two_objects, "", &[
        "box: [-1.00, -1.00, -1.00] to [1.00, 1.00, 1.00]",
        "document.active: 0",
        "history.undo: [\"New shape\",\"Join objects\"]",
        "selection.ids: []",
        "switch Cube: gone",
        "switch Tetrahedron: gone",
    ]),
    ("Operation(TriangulateFaces)", face, "", &[
        "document.edges: 13",
        "document.faces: 7",
        "history.undo: [\"Triangulate\"]",
        "selection.ids: [0,6]",
    ]),
    ("Upsample", face, "", &[
        "document.edges: 48",
        "document.faces: 24",
        "document.vertices: 26",
        "history.undo: [\"Subdivide (Catmull-Clark)\"]",
        "selection.ids: [0,1,2,3]",
    ]),
    ("Downsample", triangles, "", &[
        "box: [-0.72, -0.72, -0.83] to [0.78, 0.79, 0.72]",
        "document.edges: 30",
        "document.faces: 20",
        "document.vertices: 12",
        "history.undo: [\"New shape\",\"Subdivide (Loop)\",\"Simplify\"]",
    ]),
    ("Resample", face, "", &[
        "document.edges: 36",
        "document.faces: 24",
        "document.vertices: 14",
        "history.undo: [\"Remesh\"]",
        "selection.ids: []",
    ]),
    ("LongerEdges", face, "", &["Target edge length of resampling: 2.2"]),
    ("ShorterEdges", face, "", &["Target edge length of resampling: 1.818"]),

    ("NextLevel", curve, "", &["view.bezier.level: 1"]),
    ("WholeCurve", curve, "", &["switch Whole curve: false", "view.bezier.whole: false"]),
    ("Play", curve, "", &[
        "view.bezier.level: 3",
        "view.bezier.playing: true",
        "view.bezier.t: 0.87",
    ]),
    ("DeletePoint", curve_with_a_chosen_point, "", &[
        "history.undo: [\"Open arc\",\"Delete control point\"]",
        "switch Control point 1: false",
        "switch Control point 3: gone",
        "view.bezier.chosen.point: gone",
        "view.bezier.chosen: null",
    ]),

    ("Frame", face, "", &["view.distance: 4.05", "view.target: [0.0,0.0,-1.0]"]),
    ("FrameAll", zoomed_in, "", &["view.distance: 6.03"]),
    ("ResetView", turned, "", &["view.pitch: 0.42", "view.yaw: 0.60"]),
    ("ZoomIn", face, "", &["view.distance: 5.38"]),
    ("ZoomOut", face, "", &["view.distance: 6.75"]),
    ("LookFrom(Front)", face, "", &["view.pitch: 0.00", "view.yaw: 0.00"]),
    ("LookFrom(Back)", face, "", &["view.pitch: 0.00", "view.yaw: 3.14"]),
    ("LookFrom(Right)", face, "", &["view.pitch: 0.00", "view.yaw: 1.57"]),
    ("LookFrom(Left)", face, "", &["view.pitch: 0.00", "view.yaw: 4.71"]),
    ("LookFrom(Top)", face, "", &["view.pitch: 1.57", "view.yaw: 0.00"]),
    ("LookFrom(Bottom)", face, "", &["view.pitch: -1.57", "view.yaw: 0.00"]),
    ("Views(Four)", face, "", &["views: 4"]),
    ("AlignView", face, "", &[
        "view.pitch: 0.00",
        "view.target: [0.0,0.0,-1.0]",
        "view.yaw: 3.14",
    ]),
    ("Fly", face, "", &["W A S D: Fly: said", "focus: Viewport"]),
    ("Orthographic", face, "", &["view.orthographic: true"]),
    ("Wireframe", face, "", &["switch Wireframe: false", "view.wireframe: false"]),
    ("XRay", face, "", &["switch X-ray: true"]),
    ("Smooth", face, "", &[
        "switch Smooth shading: true",
        "view.auto_smooth: null",
        "view.smooth: true",
    ]),
    ("Look(HiddenLine)", face, "", &["view.look: \"hidden-line\""]),
    ("Look(Studio)", hidden_line, "", &["view.look: \"studio\""]),
    ("ColorBy(Paint)", colored_by_valence, "", &["view.color_by: \"paint\""]),
    ("Dots", face, "", &["view.vertices: true"]),
    ("Grid", face, "", &["view.grid: false"]),
    ("Overlay", face, "", &["switch Info overlay: true"]),
    ("LeftPanel", face, "", &[
        "field Go to id: gone",
        "switch Half-edges: gone",
        "switch Only selected: gone",
    ]),
    ("RightPanel", face, "", &["field Filter operations: gone"]),
];

/// Actions whose keys do nothing when they are pressed, and why.
const NOT_PRESSED: &[(&str, &str)] = &[
    ("SnapTo(Grid)", "snaps while it is held: tests/page/held_keys.rs"),
    ("SnapTo(Edge)", "snaps while it is held: tests/page/held_keys.rs"),
    ("SnapTo(Vertex)", "snaps while it is held: tests/page/held_keys.rs"),
];

fn nothing(_: &mut Page) {}

fn face(page: &mut Page) {
    page.select("face", &[0]);
}

fn edge(page: &mut Page) {
    page.select("edge", &[0]);
}

fn vertex(page: &mut Page) {
    page.select("vertex", &[0]);
}

fn halfedge(page: &mut Page) {
    page.select("halfedge", &[0]);
}

fn subdivided(page: &mut Page) {
    page.command(json!({"op": "subdivide-catmull-clark"}));
}

fn undone(page: &mut Page) {
    subdivided(page);
    page.app().script().undo().expect("a step");
    page.run();
}

fn vertices_of_face(page: &mut Page) {
    page.select("vertex", &[0, 1, 2, 3]);
}

fn all_but_one_face(page: &mut Page) {
    page.select("face", &[1, 2, 3, 4, 5]);
}

fn two_objects(page: &mut Page) {
    page.command(json!({"op": "new", "shape": "tetrahedron", "add": true}));
    face(page);
}

fn two_pieces(page: &mut Page) {
    two_objects(page);
    page.command(json!({"op": "join-objects"}));
    face(page);
}

fn ends_of_edge(page: &mut Page) {
    let mesh = page.mesh();
    let ends = mesh.ends(mesh.edge(0).expect("an edge")).map(|v| v.raw());
    page.select("vertex", &ends);
}

fn box_tool(page: &mut Page) {
    face(page);
    page.click("Tool: Box");
}

fn circle_tool(page: &mut Page) {
    face(page);
    page.click("Tool: Circle");
}

fn halfedge_in_study(page: &mut Page) {
    page.click("View");
    page.click("Layout");
    page.harness.get_by_label_contains("Study layout").click();
    page.run();
    halfedge(page);
}

fn hidden_face(page: &mut Page) {
    page.command(json!({"op": "hide", "faces": [2]}));
}

fn two_corners(page: &mut Page) {
    let face = page.mesh().faces().next().expect("a face");
    let corners: Vec<u32> = page.mesh().face_vertices(face).map(|v| v.raw()).collect();
    page.select("vertex", &[corners[0], corners[2]]);
}

fn edges_of_grid(page: &mut Page) {
    page.command(json!({"op": "new", "shape": "grid", "columns": 2, "rows": 2}));
    // The middle vertex and one at the side.
    let [a, b] = [4, 1].map(halfedge::VertexId::new);
    let cut = page.mesh().find_edge(a, b).expect("neighbours").raw();
    page.select("edge", &[cut]);
}

fn edges_of_hole(page: &mut Page) {
    page.command(json!({"op": "delete-faces", "faces": [0]}));
    let mesh = page.mesh();
    let hole: Vec<u32> = mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).map(|e| e.raw()).collect();
    page.select("edge", &hole);
}

fn triangles(page: &mut Page) {
    page.command(json!({"op": "new", "shape": "icosahedron"}));
    page.command(json!({"op": "subdivide-loop"}));
}

fn curve(page: &mut Page) {
    page.open("arc.bzc", "4\n0 0 1 2 3 2 4 0\n");
}

fn curve_with_a_chosen_point(page: &mut Page) {
    curve(page);
    let at = page.at([1.0, 2.0, 0.0]);
    crate::viewport::click_at(page, at, egui::Modifiers::NONE);
}

fn zoomed_in(page: &mut Page) {
    page.turn_wheel(egui::MouseWheelUnit::Line, 3.0);
}

fn turned(page: &mut Page) {
    let corner = page.find("Viewport").rect().left_bottom() + vec2(170.0, -30.0);
    crate::regions::drag_along(
        page,
        &[corner, corner + vec2(60.0, -30.0)],
        egui::PointerButton::Primary,
        egui::Modifiers::ALT,
    );
}

fn hidden_line(page: &mut Page) {
    choose(page, "Look", "Hidden line");
}

fn colored_by_valence(page: &mut Page) {
    choose(page, "Colour by", "Valence");
}

/// Chooses an entry of a submenu of the view menu.
fn choose(page: &mut Page, submenu: &str, entry: &str) {
    page.click("View");
    page.click(submenu);
    page.harness.get_by_label_contains(entry).click();
    page.run();
}

/// Lets what a key starts come to an end; a curve that plays never does.
fn settle(page: &mut Page) {
    page.wait();
    page.wait();
}

/// A page with the keys of a preset, and those that were changed.
fn with_keys(preset: KeyPreset, changed: &serde_json::Value) -> Page {
    let outside = Outside::default();
    outside.set_setting("keys", preset.name());
    outside.set_setting("changed-keys", &changed.to_string());
    // Where everything has room.
    outside.set_setting("welcome", "off");
    Page::visit_sized(&outside, LARGE)
}

/// What changes when a key is pressed on the page of a row.
fn effect(mut page: Page, (_, before, typed, _): &Row, key: Shortcut) -> Vec<String> {
    page.hover_off_middle(Vec2::ZERO);
    before(&mut page);
    page.hover_off_middle(Vec2::ZERO);
    let seen = Seen::read(&mut page);
    strike_typing(&mut page, key);
    settle(&mut page);
    if !typed.is_empty() {
        page.type_text(typed);
        strike_typing(&mut page, shortcut("Enter"));
        settle(&mut page);
    }
    seen.changed(&Seen::read(&mut page))
}

/// Presses every key of a preset; returns the actions whose keys were pressed.
fn press_all(preset: KeyPreset) -> BTreeSet<String> {
    let mut wrong = Vec::new();
    let mut pressed = BTreeSet::new();
    for binding in KeyMap::new(preset).bindings() {
        let name = format!("{:?}", binding.action);
        if NOT_PRESSED.iter().any(|(other, _)| *other == name) {
            continue;
        }
        let row = ROWS.iter().find(|row| row.0 == name);
        let row = row.unwrap_or_else(|| panic!("{name} is in neither list: say what its key does"));
        for key in &binding.keys {
            let changed = effect(with_keys(preset, &json!({})), row, *key);
            if changed != row.3 {
                wrong.push(format!("{name:?} by {}: {changed:#?}", key.text()));
            }
        }
        pressed.insert(name);
    }
    assert!(wrong.is_empty(), "{preset:?}: {}", wrong.join("\n"));
    pressed
}

#[test]
fn every_key_of_the_courses_does_what_it_says() {
    press_all(KeyPreset::Course);
}

#[test]
fn every_key_of_blender_does_what_it_says() {
    press_all(KeyPreset::Blender);
}

#[test]
fn every_key_of_maya_does_what_it_says() {
    press_all(KeyPreset::Maya);
}

#[test]
fn every_row_is_of_an_action_with_a_key() {
    let bound: BTreeSet<String> = KeyPreset::ALL
        .iter()
        .flat_map(|preset| KeyMap::new(*preset).bindings().to_vec())
        .map(|binding| format!("{:?}", binding.action))
        .collect();
    let mut listed = BTreeSet::new();
    for name in ROWS.iter().map(|row| row.0).chain(NOT_PRESSED.iter().map(|row| row.0)) {
        assert!(bound.contains(name), "{name} has no key in any preset");
        assert!(listed.insert(name), "{name} is listed twice");
    }
}

#[test]
fn a_changed_key_works_in_every_preset_and_the_old_one_no_longer() {
    let row = ROWS.iter().find(|row| row.0 == "Operation(InsetFaces)").expect("a row");
    for preset in KeyPreset::ALL {
        let action = Action::Operation(OpId::InsetFaces);
        let old = KeyMap::new(preset).own_keys(action)[0];
        // One that no action has, and one that is another's.
        for new in ["Ctrl+Alt+I", "H"] {
            let changed = json!({preset.name(): {"operation-inset-faces": [new]}});
            assert_eq!(effect(with_keys(preset, &changed), row, shortcut(new)), row.3, "{preset:?}: {new}");
            let by_old = (row.0, row.1, "", row.3);
            assert_eq!(effect(with_keys(preset, &changed), &by_old, old), Vec::<String>::new(), "{preset:?}");
        }
    }
}
