//! Several views in the viewport.

use crate::looks::picture;
use crate::page::{DESKTOP, PHONE, Page};
use crate::viewport::click_at;
use egui::{Key, Modifiers, Rect, Theme, pos2, vec2};
use halfedge::Element;
use serde_json::Value;

pub const QUAD: Modifiers = Modifiers { alt: true, ..Modifiers::COMMAND };

/// The views: name, rectangle, and whether it is the active one.
pub fn views(page: &mut Page) -> Vec<(String, Rect, bool)> {
    let state = page.app().script().state()["view"]["views"].clone();
    let number = |value: &Value| value.as_f64().expect("a number") as f32;
    let read = |view: &Value| {
        let rect: Vec<f32> = view["rect"].as_array().expect("a rectangle").iter().map(number).collect();
        let rect = Rect::from_min_size(pos2(rect[0], rect[1]), vec2(rect[2], rect[3]));
        (view["name"].as_str().expect("a name").to_owned(), rect, view["active"] == true)
    };
    state.as_array().expect("views").iter().map(read).collect()
}

fn names(page: &mut Page) -> Vec<String> {
    views(page).into_iter().map(|(name, ..)| name).collect()
}

pub fn active(page: &mut Page) -> String {
    views(page).into_iter().find(|view| view.2).expect("an active view").0
}

/// The middle of the view of a name.
pub fn middle(page: &mut Page, name: &str) -> egui::Pos2 {
    views(page).into_iter().find(|view| view.0 == name).expect("the view").1.center()
}

pub fn in_four() -> Page {
    let mut page = Page::new();
    page.press_with(QUAD, Key::Q);
    page
}

#[test]
fn a_key_splits_the_viewport_into_four_views_and_back() {
    let mut page = Page::new();
    assert_eq!(views(&mut page).len(), 1);
    page.press_with(QUAD, Key::Q);
    assert_eq!(names(&mut page), ["Top", "Perspective", "Front", "Right"]);
    assert!(
        ["Top", "Perspective", "Front", "Right"].into_iter().all(|name| page.has(name)),
        "they are named"
    );
    let whole = page.find("Viewport").rect();
    for (name, rect, _) in views(&mut page) {
        assert!(whole.contains_rect(rect), "{name}");
        page.hover(rect.center());
        let ends = [[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]].map(|corner| page.at(corner.map(|c: f32| c * 0.5)));
        assert!(ends.iter().all(|at| rect.contains(*at)), "{name} frames the cube: {ends:?} in {rect:?}");
    }
    page.press_with(QUAD, Key::Q);
    assert_eq!(views(&mut page).len(), 1);
    page.click("View");
    page.click("Views");
    page.click("Two views");
    assert_eq!(names(&mut page), ["Perspective", "Front"]);
}

#[test]
fn clicks_keys_and_drags_act_in_the_view_under_the_pointer() {
    let mut page = in_four();
    page.press(Key::Num4);
    let top = middle(&mut page, "Top");
    page.hover(top);
    assert_eq!(active(&mut page), "Perspective", "pointing activates nothing");
    let name = page.find("Viewport").value().expect("an element under the pointer");
    click_at(&mut page, top, Modifiers::NONE);
    let (kind, faces) = page.selected();
    assert_eq!((kind, faces.len()), (Element::Face, 1));
    assert_eq!(name, format!("Face {}", faces[0]), "hovering showed what the click took");
    let normal = |page: &mut Page, face: u32| {
        let mesh = page.mesh();
        halfedge::geometry::face_area_vector(mesh, halfedge::FaceId::new(face as usize)).normalize()
    };
    assert!(normal(&mut page, faces[0]).y > 0.9, "the face on top");
    assert_eq!(active(&mut page), "Top");
    let right = middle(&mut page, "Right");
    click_at(&mut page, right, Modifiers::NONE);
    let face = page.selected().1[0];
    assert!(normal(&mut page, face).x > 0.9, "the face on the right");
    // A key looks from another side in the view under the pointer only.
    let front = middle(&mut page, "Front");
    page.hover(front);
    page.press_with(Modifiers::ALT | Modifiers::SHIFT, Key::Num1);
    assert_eq!(names(&mut page), ["Top", "Perspective", "Back", "Right"]);
    assert_eq!(active(&mut page), "Back", "what was acted in is active");
    // A drag turns one view.
    let beside = views(&mut page)[3].1.right_bottom() - vec2(20.0, 90.0);
    page.drag(beside, beside + vec2(-40.0, 10.0));
    page.drop(beside + vec2(-40.0, 10.0));
    assert_eq!(names(&mut page), ["Top", "Perspective", "Back", "Parallel"]);
}

#[test]
fn boxes_and_moves_belong_to_the_view_that_they_begin_in() {
    let mut page = in_four();
    let (_, rect, _) = views(&mut page)[2].clone();
    page.press_with(Modifiers::SHIFT, Key::B);
    let from = rect.right_bottom() - vec2(4.0, 4.0);
    let to = pos2(rect.center().x, rect.top() + 4.0);
    page.drag(from, to);
    page.drop(to);
    page.press(Key::Escape);
    let (kind, ids) = page.selected();
    assert_eq!(kind, Element::Vertex);
    let mesh = page.mesh().clone();
    let at = |v: &u32| mesh.position(halfedge::VertexId::new(*v as usize));
    // Those behind lie on the outline, where either may count as seen.
    assert!(ids.len() >= 2 && ids.iter().all(|v| at(v).x > 0.0), "{ids:?}");
    // A move in the view from above leaves the height.
    page.hover(rect.center());
    let top = middle(&mut page, "Top");
    page.hover(top);
    page.press(Key::G);
    page.hover(top + vec2(30.0, 20.0));
    page.press(Key::Enter);
    for v in ids {
        let by = page.mesh().position(halfedge::VertexId::new(v as usize)) - at(&v);
        assert!(by.x > 0.01 && by.z > 0.01 && by.y.abs() < 1e-5, "{by}");
    }
}

#[test]
fn one_view_shows_the_active_one_and_the_split_is_kept() {
    let mut page = in_four();
    let front = middle(&mut page, "Front");
    click_at(&mut page, front, Modifiers::NONE);
    page.press_with(QUAD, Key::Q);
    assert_eq!(names(&mut page), ["Front"]);
    page.press_with(QUAD, Key::Q);
    assert_eq!(names(&mut page), ["Top", "Perspective", "Front", "Right"]);
    let kept = page.outside.setting("layout").expect("a layout");
    let mut page = Page::with_setting(DESKTOP, "layout", &kept);
    assert_eq!(names(&mut page), ["Top", "Perspective", "Front", "Right"]);
    // A new document is framed in each.
    page.open("far.obj", "v 100 0 0\nv 101 0 0\nv 100 1 1\nf 1 2 3\n");
    for (name, rect, _) in views(&mut page) {
        page.hover(rect.center());
        assert!(rect.contains(page.at([100.0, 0.0, 0.0])), "{name}");
    }
}

#[test]
fn a_phone_shows_one_view_and_says_why() {
    let mut page = Page::sized(PHONE);
    page.press_with(QUAD, Key::Q);
    assert_eq!(views(&mut page).len(), 1);
    assert!(page.has_part("There is room for one view only."));
}

#[test]
fn a_views_name_is_a_menu_that_turns_it() {
    let mut page = in_four();
    page.click("Right");
    page.click("Left view");
    assert_eq!(names(&mut page), ["Top", "Perspective", "Front", "Left"]);
    assert_eq!(active(&mut page), "Left");
}

#[test]
fn pictures_of_four_views() {
    for (theme, size, name) in [
        (Theme::Dark, DESKTOP, "four views dark"),
        (Theme::Light, DESKTOP, "four views light"),
        (Theme::Dark, vec2(1920.0, 1080.0), "four views large dark"),
        (Theme::Light, vec2(1920.0, 1080.0), "four views large light"),
    ] {
        let mut page = Page::drawn(size, theme);
        page.press_with(QUAD, Key::Q);
        page.select("face", &[0]);
        let shown = picture(&mut page, name);
        // Each view has the cube in its middle, not the background of its corner.
        for (view, rect, _) in views(&mut page) {
            let pixel = |at: egui::Pos2| shown.get_pixel(at.x as u32, at.y as u32).0;
            let corner = rect.right_bottom() - vec2(6.0, rect.height() * 0.5);
            assert_ne!(pixel(rect.center()), pixel(corner), "{name}: {view}");
        }
    }
}
