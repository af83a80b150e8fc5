//! Editing and selecting in a split viewport, and the lines between the views.

use crate::looks::picture;
use crate::page::{DESKTOP, Page};
use crate::regions::drag_along;
use crate::views::{QUAD, active, in_four, middle, views};
use egui::{Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect, Theme, Vec2, pos2, vec2};
use egui_kittest::kittest::Queryable;
use glam::Vec3;
use halfedge::{Element, VertexId};

const SIDEWAYS: &str = "Line between the views on the left and on the right";
const UP_AND_DOWN: &str = "Line between the views above and below";

fn rect(page: &mut Page, name: &str) -> Rect {
    views(page).into_iter().find(|view| view.0 == name).expect("the view").1
}

/// Where a point of the scene is in the view of a name.
fn at_in(page: &mut Page, name: &str, point: [f32; 3]) -> Pos2 {
    let at = middle(page, name);
    page.hover(at);
    page.at(point)
}

fn position(page: &mut Page, v: u32) -> Vec3 {
    page.mesh().position(VertexId::new(v as usize))
}

#[test]
fn parallel_views_are_framed_at_one_scale() {
    let mut page = in_four();
    // Long in x, so that the view from the right alone would come nearer.
    page.open("beam.obj", "v -4 0 0\nv 4 0 0\nv 4 1 0\nv -4 1 0\nv 4 0 1\nv -4 0 1\nf 1 2 3 4\nf 1 2 5 6\n");
    for when in ["at first", "again"] {
        if when == "again" {
            let at = middle(&mut page, "Right");
            page.hover(at);
            page.harness.event(crate::page::wheel(MouseWheelUnit::Point, 240.0));
            page.run();
            page.press(Key::Home);
        }
        let [low, high] = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let heights =
            ["Front", "Right"].map(|name| (at_in(&mut page, name, low) - at_in(&mut page, name, high)).y);
        assert!((heights[0] - heights[1]).abs() < 0.1 && heights[0] > 10.0, "{when}: {heights:?}");
        let levels = ["Front", "Right"].map(|name| at_in(&mut page, name, low).y);
        assert!((levels[0] - levels[1]).abs() < 0.5, "{when}: the same height is as high: {levels:?}");
        let lengths = [
            (at_in(&mut page, "Front", [1.0, 0.0, 0.0]) - at_in(&mut page, "Front", low)).x,
            (at_in(&mut page, "Top", [1.0, 0.0, 0.0]) - at_in(&mut page, "Top", low)).x,
        ];
        assert!((lengths[0] - lengths[1]).abs() < 0.1, "{when}: {lengths:?}");
    }
    // Framing in perspective leaves the others.
    let before = at_in(&mut page, "Front", [4.0, 0.0, 0.0]);
    let at = middle(&mut page, "Perspective");
    page.select("vertex", &[0]);
    page.hover(at);
    page.press(Key::Period);
    assert_eq!(at_in(&mut page, "Front", [4.0, 0.0, 0.0]), before);
}

#[test]
fn a_line_between_views_can_be_dragged_and_halves_again() {
    let mut page = in_four();
    let (whole, before) = (page.find("Viewport").rect(), views(&mut page));
    let scale =
        |page: &mut Page| at_in(page, "Front", [1.0, 0.0, 0.0]).x - at_in(page, "Front", [0.0, 0.0, 0.0]).x;
    let scale_before = scale(&mut page);
    let line = before[0].1.right() + 1.0;
    let from = pos2(line, before[0].1.center().y);
    page.drag(from, from - vec2(120.0, 40.0));
    page.drop(from - vec2(120.0, 40.0));
    let after = views(&mut page);
    assert!((after[0].1.width() - (before[0].1.width() - 120.0)).abs() < 2.0, "{after:?}");
    assert_eq!(after[0].1.height(), before[0].1.height(), "it moves sideways only");
    assert!((after[3].1.width() - (before[3].1.width() + 120.0)).abs() < 2.0);
    assert_eq!(after.iter().fold(Rect::NOTHING, |all, view| all.union(view.1)), whole);
    assert!((scale(&mut page) - scale_before).abs() < 0.01, "what is shown stays as large");
    assert!(page.selected().1.is_empty() && active(&mut page) == "Perspective", "it is no gesture in a view");
    // The other line, and where they meet.
    let level = after[0].1.bottom() + 1.0;
    let from = pos2(whole.right() - 60.0, level);
    page.drag(from, from + vec2(0.0, 50.0));
    page.drop(from + vec2(0.0, 50.0));
    assert!((rect(&mut page, "Top").height() - (before[0].1.height() + 50.0)).abs() < 2.0);
    assert!((scale(&mut page) - scale_before).abs() < 0.01, "even if it is less high");
    let meet = rect(&mut page, "Top").max + Vec2::splat(1.0);
    page.drag(meet, meet + vec2(30.0, -20.0));
    page.drop(meet + vec2(30.0, -20.0));
    let met = rect(&mut page, "Top").max;
    assert!((met - meet - vec2(30.0, -20.0)).abs().max_elem() < 2.5, "{met:?} from {meet:?}");
    // No view is dragged away, and a double-click halves.
    page.drag(met + Vec2::splat(1.0), pos2(-50.0, 2000.0));
    page.drop(pos2(-50.0, 2000.0));
    assert!(views(&mut page).iter().all(|view| view.1.size().min_elem() > 90.0));
    let meet = rect(&mut page, "Top").max + Vec2::splat(1.0);
    page.hover(meet);
    for _ in 0..2 {
        for pressed in [true, false] {
            let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
            let event = egui::Event::PointerButton { pos: meet, button, pressed, modifiers };
            page.harness.input_mut().events.push(event);
        }
    }
    page.run();
    assert_eq!(views(&mut page), before);
}

#[test]
fn lines_between_views_take_keys_and_are_kept() {
    let mut page = in_four();
    let before = rect(&mut page, "Top");
    page.find(SIDEWAYS).focus();
    page.run();
    page.press(Key::ArrowLeft);
    page.press(Key::ArrowLeft);
    page.press(Key::ArrowDown);
    assert_eq!(rect(&mut page, "Top").size(), before.size() - vec2(32.0, 0.0));
    page.find(UP_AND_DOWN).focus();
    page.run();
    page.press(Key::ArrowDown);
    assert_eq!(rect(&mut page, "Top").size(), before.size() - vec2(32.0, -16.0));
    let kept = page.outside.setting("layout").expect("a layout");
    let mut again = Page::with_setting(DESKTOP, "layout", &kept);
    assert!((rect(&mut again, "Top").size() - (before.size() - vec2(32.0, -16.0))).length() < 2.5);
    page.press(Key::Enter);
    assert_eq!(rect(&mut page, "Top").size(), before.size() - vec2(32.0, 0.0), "Enter halves");
    // Two views have one line, and a setting that makes no sense is not used.
    page.click("View");
    page.click("Views");
    page.click("Two views");
    assert!(page.has(SIDEWAYS) && !page.has(UP_AND_DOWN));
    let broken = kept.replacen("\"divide\":[", "\"divide\":[7.0,", 1);
    let mut page = Page::with_setting(DESKTOP, "layout", &broken);
    assert_eq!(views(&mut page).len(), 1);
}

#[test]
fn a_lasso_and_the_circle_select_in_the_view_that_they_begin_in() {
    let mut page = in_four();
    page.press_with(Modifiers::ALT, Key::X);
    // Around the upper edge of the cube as the front shows it: with x-ray, four vertices.
    let [left, right] = [[-1.0, 1.0, 1.0], [1.0, 1.0, 1.0]].map(|corner| at_in(&mut page, "Front", corner));
    let path: Vec<Pos2> = [
        left + vec2(-12.0, -12.0),
        right + vec2(12.0, -12.0),
        right + vec2(12.0, 12.0),
        left + vec2(-12.0, 12.0),
    ]
    .into();
    drag_along(&mut page, &path, PointerButton::Secondary, Modifiers::COMMAND);
    let (kind, ids) = page.selected();
    assert_eq!((kind, ids.len()), (Element::Vertex, 4));
    assert!(ids.iter().all(|v| position(&mut page, *v).y > 0.0), "{ids:?}");
    assert_eq!(active(&mut page), "Front");
    // It may leave the view, and goes on as if that was larger.
    let beyond = rect(&mut page, "Right").center();
    let path = [left + vec2(-12.0, 12.0), left + vec2(-12.0, -12.0), beyond - vec2(0.0, 200.0), beyond];
    drag_along(&mut page, &path, PointerButton::Secondary, Modifiers::COMMAND);
    assert_eq!(active(&mut page), "Front");
    let with_right = page.selected().1;
    assert!(with_right.iter().any(|v| position(&mut page, *v).x > 0.0), "{with_right:?}");

    page.press(Key::Escape);
    page.press_with(Modifiers::SHIFT, Key::C);
    let [near, far] = [[1.0, -1.0, 1.0], [1.0, -1.0, -1.0]].map(|corner| at_in(&mut page, "Right", corner));
    drag_along(&mut page, &[near, near.lerp(far, 0.5), far], PointerButton::Primary, Modifiers::NONE);
    let ids = page.selected().1;
    assert_eq!(ids.len(), 4, "through the cube, the lower edge: {ids:?}");
    assert!(ids.iter().all(|v| position(&mut page, *v).y < 0.0));
    assert_eq!(active(&mut page), "Right");
}

#[test]
fn boxes_stay_in_the_view_that_they_begin_in() {
    let mut page = in_four();
    page.press_with(Modifiers::SHIFT, Key::B);
    let front = rect(&mut page, "Front");
    let right = rect(&mut page, "Right");
    // From the left half of the front view far into the view on its right.
    let from = pos2(front.left() + 4.0, front.bottom() - 4.0);
    page.drag(from, right.center());
    page.drop(right.center());
    assert_eq!(active(&mut page), "Front");
    let ids = page.selected().1;
    assert!(ids.len() >= 2 && ids.iter().all(|v| position(&mut page, *v).y < 0.0), "{ids:?}");
}

#[test]
fn a_gizmo_is_dragged_in_each_view() {
    for (name, axis, across) in [("Top", 2, 1), ("Front", 1, 2), ("Right", 1, 0)] {
        let mut page = in_four();
        page.select("vertex", &[0, 1, 2, 3, 4, 5, 6, 7]);
        page.click("Transform");
        page.click("Gizmo");
        page.harness.get_by_label_contains("Move gizmo").click();
        page.run();
        let centre = at_in(&mut page, name, [0.0; 3]);
        let mut end = [0.0; 3];
        end[axis] = 1.0;
        let way = (at_in(&mut page, name, end) - centre).normalized();
        let from = centre + way * 50.0;
        page.drag(from, from + way * 40.0);
        page.drop(from + way * 40.0);
        let moved = (0..8).map(|v| position(&mut page, v)).sum::<Vec3>() / 8.0;
        assert!(moved[axis] > 0.1 && moved[across] == 0.0, "{name}: {moved}");
        assert_eq!(moved.to_array().iter().filter(|part| **part != 0.0).count(), 1, "{name}: {moved}");
        assert_eq!(active(&mut page), name);
        assert_eq!(page.undo_labels().len(), 1, "{name}");
        // By as much as the pointer went.
        let now = at_in(&mut page, name, moved.to_array());
        assert!(now.distance(centre + way * 40.0) < 1.5, "{name}: {now:?}");
    }
}

#[test]
fn an_edit_that_follows_the_pointer_keeps_to_its_view() {
    let mut page = in_four();
    page.select("vertex", &[0, 1, 2, 3, 4, 5, 6, 7]);
    let from = at_in(&mut page, "Front", [0.0; 3]);
    page.press(Key::G);
    page.hover(from + vec2(10.0, 0.0));
    // Over the view on its right, the pointer is as far to the right.
    let beyond = middle(&mut page, "Right");
    page.hover(beyond);
    let moved = (0..8).map(|v| position(&mut page, v)).sum::<Vec3>() / 8.0;
    assert!(moved.x > 1.0 && moved.z.abs() < 1e-5, "to the right in the front view: {moved}");
    page.press(Key::Enter);
    let now = at_in(&mut page, "Front", moved.to_array());
    assert!((now - beyond).x.abs() < 12.0, "{now:?} {beyond:?}");
    // Split or not, it is one step.
    assert_eq!(page.undo_labels().len(), 1);
    page.press_with(QUAD, Key::Q);
    page.press_with(Modifiers::COMMAND, Key::Z);
    assert_eq!(position(&mut page, 0).abs(), Vec3::ONE);
}

#[test]
fn pictures_of_a_divided_viewport() {
    for (theme, name) in [(Theme::Dark, "divided dark"), (Theme::Light, "divided light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.press_with(QUAD, Key::Q);
        page.select("face", &[5]);
        let top = rect(&mut page, "Top");
        let from = pos2(top.right() + 1.0, top.top() + 100.0);
        let before = picture(&mut page, &format!("{name} before"));
        page.drag(from, from - vec2(90.0, 0.0));
        page.drop(from - vec2(90.0, 0.0));
        page.hover(from - vec2(90.0, 0.0));
        let shown = picture(&mut page, name);
        // The line under the pointer lights up, over its whole length.
        let at = rect(&mut page, "Front").right_bottom() + vec2(1.0, -100.0);
        let pixel = |shown: &image::RgbaImage| shown.get_pixel(at.x as u32, at.y as u32).0;
        let blue = |[red, _, blue, _]: [u8; 4]| i32::from(blue) - i32::from(red);
        assert!(blue(pixel(&shown)) > blue(pixel(&before)) + 40, "{name}: {:?}", pixel(&shown));
    }
}
