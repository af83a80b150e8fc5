//! The bars over the viewport: tools and kinds of elements.

use crate::page::{DESKTOP, PHONE, Page};
use crate::viewport::click_at;
use egui::accesskit::{Role, Toggled};
use egui::{Key, Modifiers, Rect, vec2};
use egui_kittest::kittest::{NodeT, Queryable};
use halfedge::Element;

fn is_on(page: &Page, name: &str) -> bool {
    page.find(name).accesskit_node().toggled() == Some(Toggled::True)
}

#[test]
fn a_tool_starts_an_edit_that_follows_the_pointer() {
    let mut page = Page::new();
    page.select("face", &[0]);
    assert!(is_on(&page, "Tool: Select"));
    page.click("Tool: Extrude");
    assert!(is_on(&page, "Tool: Extrude") && !is_on(&page, "Tool: Select"));
    let middle = page.find("Viewport").rect().center();
    page.harness.hover_at(middle);
    page.run();
    page.harness.hover_at(middle + vec2(60.0, 0.0));
    page.run();
    assert_eq!(page.mesh().face_count(), 10);
    click_at(&mut page, middle + vec2(60.0, 0.0), Modifiers::NONE);
    assert_eq!(page.undo_labels().len(), 1);
    assert!(!is_on(&page, "Tool: Extrude"));
}

#[test]
fn a_tool_works_on_the_kind_that_is_selected_or_says_why_it_cannot() {
    let mut page = Page::new();
    let reason = |page: &Page, name: &str| page.find(name).accesskit_node().description();
    assert_eq!(reason(&page, "Tool: Extrude").as_deref(), Some("Select a face first."));
    assert!(page.find("Tool: Extrude").accesskit_node().is_disabled());
    page.select("vertex", &[0]);
    assert!(!page.find("Tool: Bevel").accesskit_node().is_disabled());
    page.click("Tool: Bevel");
    assert!(page.has("Bevel vertices"));
}

#[test]
fn modes_are_toggles_and_control_expands() {
    let mut page = Page::new();
    page.select("face", &[0]);
    assert!(is_on(&page, "Face mode"));
    page.click("Vertex mode");
    assert_eq!(page.selected().0, Element::Vertex);
    assert_eq!(page.selected().1.len(), 4);
    let at = page.find("Edge mode").rect().center();
    click_at(&mut page, at, Modifiers::COMMAND);
    assert_eq!(page.selected().0, Element::Edge);
    assert_eq!(page.selected().1.len(), 8, "all edges that touch the face");
    page.press(Key::Num3);
    assert!(is_on(&page, "Half-edge mode") && !is_on(&page, "Edge mode"));
}

#[test]
fn nothing_goes_through_a_bar() {
    let mut page = Page::new();
    page.select("vertex", &[0]);
    let state = |page: &mut Page| {
        let mut view = page.app().script().state()["view"].clone();
        view["frame_ms"].take();
        view
    };
    let before = state(&mut page);
    // Between two groups of tools there is no button.
    let gap = page.find("Tool: Box").rect().center_bottom() + vec2(0.0, 4.0);
    click_at(&mut page, gap, Modifiers::NONE);
    assert_eq!(page.selected().1, [0], "the click did not deselect");
    page.drag(gap, gap + vec2(100.0, 30.0));
    page.drop(gap + vec2(100.0, 30.0));
    page.harness.hover_at(gap);
    page.run();
    page.turn_wheel(egui::MouseWheelUnit::Point, 120.0);
    assert_eq!(state(&mut page), before, "neither a drag nor the wheel changed the view");
}

#[test]
fn models_are_framed_beside_the_bars() {
    for size in [DESKTOP, PHONE, vec2(1920.0, 1080.0), vec2(1000.0, 640.0)] {
        let mut page = Page::sized(size);
        let bars = ["Tool: Select", "Tool: Extrude", "Vertex mode", "Face mode"];
        let bars: Vec<Rect> = bars.iter().map(|name| page.find(name).rect()).collect();
        let tools = bars[0].union(bars[1]);
        let modes = bars[2].union(bars[3]);
        let corners: Vec<[f32; 3]> = {
            let mesh = page.mesh();
            mesh.vertices().map(|v| mesh.position(v).to_array()).collect()
        };
        let view = page.find("Viewport").rect();
        let seen = corners.into_iter().map(|corner| page.at(corner));
        let seen = seen.fold(Rect::NOTHING, |all, at| all.union(Rect::from_pos(at)));
        assert!(view.contains_rect(seen), "{size}: {seen:?} in {view:?}");
        assert!(
            !seen.intersects(tools) && !seen.intersects(modes),
            "{size}: {seen:?} under {tools:?}, {modes:?}"
        );
        let share = (seen.width() / view.width()).max(seen.height() / view.height());
        assert!(share > 0.45 && share < 0.85, "{size}: the model fills {share} of the viewport");
    }
}

fn hints(page: &Page) -> String {
    let all = page.harness.query_all_by_label_contains("Right button: ");
    let all: Vec<String> = all.filter_map(|node| node.value()).collect();
    all.concat()
}

#[test]
fn the_status_line_names_what_held_keys_snap_to() {
    let mut page = Page::with_parameters(&[("keys", "maya")]);
    page.select("vertex", &[7]);
    page.click("Transform");
    page.click("Move");
    page.hover_off_middle(vec2(0.0, 0.0));
    assert!(hints(&page).contains("X, C, V: snap to the grid, edges, vertices"), "{}", hints(&page));
}

#[test]
fn the_status_line_says_what_the_buttons_do() {
    let mut page = Page::new();
    page.press(Key::Num4);
    assert!(hints(&page).starts_with("Left button: Drag to orbit; "), "{}", hints(&page));
    let middle = page.at([0.0, 0.0, 0.0]);
    page.harness.hover_at(middle);
    page.run();
    assert!(hints(&page).starts_with("Left button: Select this face, drag to orbit; "), "{}", hints(&page));
    page.press_with(Modifiers::SHIFT, Key::B);
    assert!(hints(&page).starts_with("Left button: Drag a box to select; "), "{}", hints(&page));
    page.press(Key::Escape);
    page.harness.event(egui::Event::ModifiersChanged(Modifiers::COMMAND));
    page.run();
    assert!(page.has_part("Left button: Add or remove this face, drag a box; "));
    page.harness.event(egui::Event::ModifiersChanged(Modifiers::NONE));
    page.select("face", &[0]);
    page.click("Tool: Extrude");
    assert!(page.has_part("Left button: Apply; "));
}

#[test]
fn measures_of_the_mesh_and_the_frame_are_in_the_info_overlay() {
    let mut page = Page::new();
    assert!(!page.has_part("Frame: "));
    assert!(
        page.has("Vertices: 8")
            && page.has("Edges: 12")
            && page.has("Faces: 6")
            && page.has("Half-edges: 24")
    );
    page.press(Key::I);
    assert!(
        page.has_part("Euler characteristic 2, boundary loops 0, components 1") && page.has_part("Frame: ")
    );
}

#[test]
fn the_interface_scales_and_the_scale_is_kept() {
    let mut page = Page::new();
    let wide = |page: &mut Page| {
        let view = page.app().script().state()["view"]["rect"].clone();
        view[2].as_f64().expect("a number")
    };
    let at_first = wide(&mut page);
    page.click("View");
    page.click("Interface scale");
    page.click("125 %");
    page.run();
    assert_eq!(page.harness.ctx.zoom_factor(), 1.25);
    assert_eq!(page.outside.setting("scale").as_deref(), Some("125"));
    // Larger panels leave less of the window, in its own pixels, to the viewport.
    let scaled = wide(&mut page);
    assert!((at_first - scaled - 0.25 * (1280.0 - at_first)).abs() < 4.0, "{at_first}, then {scaled}");
    let (v, at) = {
        let corner = page.mesh().position(halfedge::VertexId::new(7)).to_array();
        (7, page.at(corner))
    };
    click_at(&mut page, at, Modifiers::NONE);
    assert_eq!(page.selected().1, [v], "a click means what is under it");
    page.press(Key::F3);
    page.find("Find a command").type_text("100 %");
    page.run();
    page.press(Key::Enter);
    page.run();
    assert!((wide(&mut page) - at_first).abs() < 1.0);
}

#[test]
fn the_scale_of_an_earlier_visit_is_used_if_it_is_one() {
    assert_eq!(Page::with_setting(DESKTOP, "scale", "150").harness.ctx.zoom_factor(), 1.5);
    for nonsense in ["", "large", "0", "99999"] {
        assert_eq!(Page::with_setting(DESKTOP, "scale", nonsense).harness.ctx.zoom_factor(), 1.0);
    }
}

#[test]
fn layouts_open_and_close_panels_and_come_back() {
    let mut page = Page::new();
    let choose = |page: &mut Page, layout: &str| {
        page.click("View");
        page.click("Layout");
        page.click(layout);
        page.run();
    };
    assert!(page.has("Go to id") && !page.has_part("Frame: "), "lists are open at first");
    page.click("View");
    page.click("Layout");
    for layout in ["Model layout", "Study layout"] {
        assert!(!is_on(&page, layout), "{layout} would change what is open");
    }
    page.press(Key::Escape);
    page.press(Key::Escape);
    choose(&mut page, "Model layout");
    assert!(!page.has("Go to id"), "lists are closed");
    let kept = page.outside.setting("layout").expect("it is kept");
    assert!(!Page::with_setting(DESKTOP, "layout", &kept).has("Go to id"), "{kept}");
    page.press(Key::CloseBracket);
    choose(&mut page, "Study layout");
    assert!(page.has("Go to id") && page.has("Filter operations"));
    choose(&mut page, "Model layout");
    assert!(!page.has("Filter operations"), "as it was left");
    choose(&mut page, "Model layout");
    assert!(page.has("Filter operations"), "chosen again, as at first");
    page.press(Key::CloseBracket);
    let kept = page.outside.setting("layout").expect("it is kept");
    let mut page = Page::with_setting(DESKTOP, "layout", &kept);
    assert!(!page.has("Go to id") && !page.has("Filter operations"), "{kept}");
    choose(&mut page, "Study layout");
    choose(&mut page, "Study layout");
    assert!(page.has_part("Frame: "), "a student sees numbers");
}

#[test]
fn the_bar_shows_what_edits_will_do() {
    let mut page = Page::new();
    for name in ["Snap", "Soft selection", "Mirror edits", "X-ray"] {
        assert!(!is_on(&page, name), "{name}");
    }
    page.press_with(Modifiers::SHIFT, Key::O);
    page.press_with(Modifiers::SHIFT, Key::Tab);
    page.click("Mirror edits");
    for name in ["Snap", "Soft selection", "Mirror edits"] {
        assert!(is_on(&page, name), "{name}");
    }
    page.select("vertex", &[7]);
    page.click("Soft selection");
    page.click("Snap");
    page.press(Key::G);
    page.type_text("1");
    page.press(Key::Enter);
    let moved = page.mesh().positions().iter().filter(|at| at.x.abs() != 1.0).count();
    assert_eq!(moved, 2, "the mirror image moves too");
    page.click("Mirror edits");
    assert!(!is_on(&page, "Mirror edits"));
}

#[test]
fn taps_add_to_the_selection_while_add_is_on() {
    let mut page = Page::sized(PHONE);
    page.click("Face mode");
    let faces = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|middle| page.at(middle));
    let [top, front] = faces;
    page.click("Add to selection");
    for (at, count) in [(top, 1), (front, 2), (front, 1), (front, 2)] {
        page.tap(at);
        assert_eq!(page.selected().1.len(), count);
    }
    let beside = page.find("Viewport").rect().left_bottom() + vec2(20.0, -20.0);
    page.tap(beside);
    assert_eq!(page.selected().1.len(), 2, "a near miss keeps the selection");
    page.click("Add to selection");
    page.tap(top);
    assert_eq!(page.selected().1.len(), 1);
}

/// Every control on the screen is large enough for a finger.
fn assert_finger_size(page: &Page, what: &str) {
    for node in page.harness.root().children_recursive() {
        let role = node.accesskit_node().role();
        if !egui::accessibility::is_input(role) || node.accesskit_node().is_disabled() {
            continue;
        }
        let (name, rect) = (node.accesskit_node().label().unwrap_or_default(), node.rect());
        if rect.is_positive() && page.harness.ctx.content_rect().contains_rect(rect) {
            assert!(rect.height() >= 43.5, "{what}: {role:?} {name:?} is {} high", rect.height());
            assert!(rect.width() >= 43.5, "{what}: {role:?} {name:?} is {} wide", rect.width());
        }
    }
}

#[test]
fn on_a_telephone_everything_is_large_enough_for_fingers_and_names_no_key() {
    let mut page = Page::sized(PHONE);
    assert_finger_size(&page, "at the start");
    page.select("vertex", &[0]);
    for tab in ["Inspector", "Operations"] {
        page.click(tab);
        assert_finger_size(&page, tab);
    }
    page.click("Menu");
    for menu in ["View", "Edit"] {
        page.click(menu);
        assert_finger_size(&page, menu);
    }
    assert!(page.has("Undo") && !page.has_part("Ctrl+"), "no keys in menus");
    for name in ["Tool: Select", "Tool: Move", "Add to selection"] {
        assert!(page.has(name));
    }
}

#[test]
fn a_finger_that_rests_draws_no_frames_and_lifting_it_makes_targets_large() {
    let mut page = Page::new();
    let height = |page: &Page| page.find("Undo").rect().height();
    let before = height(&page);
    let middle = page.find("Viewport").rect().center();
    // The harness fails where frames don't end.
    page.touch(middle);
    page.move_finger(middle + vec2(1.0, 0.0));
    assert_eq!(height(&page), before, "nothing moves under the finger");
    page.lift_finger(middle);
    assert!(height(&page) > before);
}

#[test]
fn a_greyed_tool_says_why_when_it_is_tapped() {
    let mut page = Page::sized(PHONE);
    let at = page.find("Tool: Extrude").rect().center();
    page.tap(at);
    assert!(page.has_part("Select a face"), "a toast with the reason");
}

#[test]
fn a_form_on_a_telephone_keeps_its_result_and_buttons_in_sight() {
    let mut page = Page::sized(PHONE);
    let before = page.mesh().clone();
    page.click("Operations");
    for operation in ["Smooth", "Remesh", "Merge by distance"] {
        page.choose(operation);
        page.run();
        let bottom = page.find("Viewport").rect().bottom();
        for name in ["Cancel", operation] {
            let button = page.harness.get_by_role_and_label(Role::Button, name).rect();
            assert!(
                button.top() > bottom && button.bottom() <= PHONE.y - 24.0,
                "{operation}: {name} is at {button:?}"
            );
            assert!(button.height() >= 43.5 && button.width() > 120.0);
        }
        page.harness.get_by_role_and_label(Role::Button, "Cancel").click();
        page.run();
        assert_eq!(page.mesh(), &before, "{operation} leaves no trace");
    }
    page.choose("Smooth");
    page.harness.get_by_role_and_label(Role::Button, "Smooth").click();
    page.run();
    assert_eq!(page.undo_labels(), ["Smooth"]);
}
