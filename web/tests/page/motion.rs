//! Moves of the camera that take time: eased ones, and flying.

use crate::looks::picture;
use crate::page::{DESKTOP, Page, wheel};
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Theme, vec2};
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use serde_json::Value;

fn view(page: &mut Page) -> Value {
    page.app().script().state()["view"].clone()
}

fn number(view: &Value, name: &str) -> f64 {
    view[name].as_f64().expect("a number")
}

fn target(view: &Value) -> DVec3 {
    let [x, y, z]: [f64; 3] = serde_json::from_value(view["target"].clone()).expect("a point");
    DVec3::new(x, y, z)
}

/// Where the eye is.
fn eye(page: &mut Page) -> DVec3 {
    let view = view(page);
    let (yaw, pitch) = (number(&view, "yaw"), number(&view, "pitch"));
    let back = DVec3::new(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
    target(&view) + back * number(&view, "distance")
}

/// One frame at a time in seconds, with these events.
fn frame_at(page: &mut Page, seconds: f64, events: Vec<Event>) {
    let input = page.harness.input_mut();
    input.time = Some(seconds);
    input.events.extend(events);
    page.harness.step();
}

fn key(key: Key, pressed: bool, modifiers: Modifiers) -> Event {
    Event::Key { key, physical_key: None, pressed, repeat: false, modifiers }
}

/// Where the lines of the axis widget end: as the camera is painted, not as it is.
fn painted(page: &Page) -> Vec<Pos2> {
    let names = ["View from the front", "View from the right", "View from above"];
    names.map(|name| page.find(name).rect().center()).into()
}

/// The page at rest, with the time that its next frames begin at.
fn resting() -> (Page, f64) {
    let mut page = Page::new();
    frame_at(&mut page, 100.0, Vec::new());
    frame_at(&mut page, 100.1, Vec::new());
    (page, 101.0)
}

/// Whether the last frame asked for another at once.
fn is_restless(page: &Page) -> bool {
    page.harness.output().viewport_output.values().any(|viewport| viewport.repaint_delay.is_zero())
}

#[test]
fn a_view_from_a_side_is_reached_at_once_and_painted_on_the_way() {
    let (mut page, t) = resting();
    let before = painted(&page);
    frame_at(&mut page, t, vec![key(Key::Num3, true, Modifiers::ALT)]);
    let there = view(&mut page);
    assert_eq!((number(&there, "yaw"), number(&there, "pitch")), (std::f64::consts::FRAC_PI_2, 0.0));
    let mut places = vec![painted(&page)];
    assert_eq!(places[0], before, "the first frame shows where it begins");
    for step in [0.05, 0.1, 0.19] {
        assert!(is_restless(&page));
        frame_at(&mut page, t + step, Vec::new());
        places.push(painted(&page));
        assert_eq!(view(&mut page)["yaw"], there["yaw"]);
    }
    frame_at(&mut page, t + 0.21, Vec::new());
    let end = painted(&page);
    let away = |places: &Vec<Pos2>| places.iter().zip(&end).map(|(a, b)| a.distance(*b)).sum::<f32>();
    assert!(places.windows(2).all(|pair| away(&pair[0]) > away(&pair[1])), "it comes nearer: {places:?}");
    assert!(away(&places[2]) > 0.5 && away(&places[3]) < 1.0);
    frame_at(&mut page, t + 0.3, Vec::new());
    assert_eq!(painted(&page), end);
    assert!(!is_restless(&page), "nothing is repainted once it is there");
}

#[test]
fn input_ends_a_move_and_another_one_begins_where_it_is() {
    let (mut page, t) = resting();
    frame_at(&mut page, t, vec![key(Key::Num3, true, Modifiers::ALT)]);
    frame_at(&mut page, t + 0.05, Vec::new());
    let on_the_way = painted(&page);
    // Another move goes on from what is seen.
    frame_at(&mut page, t + 0.05, vec![key(Key::Num7, true, Modifiers::ALT)]);
    assert_eq!(painted(&page), on_the_way);
    frame_at(&mut page, t + 0.1, Vec::new());
    assert_ne!(painted(&page), on_the_way);
    // What is pressed means the view as it is.
    let at = page.find("Viewport").rect().left_bottom() + vec2(120.0, -60.0);
    let press = |pressed| {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        Event::PointerButton { pos: at, button, pressed, modifiers }
    };
    frame_at(&mut page, t + 0.11, vec![Event::PointerMoved(at), press(true)]);
    let pressed = painted(&page);
    frame_at(&mut page, t + 0.12, vec![press(false)]);
    frame_at(&mut page, t + 0.5, Vec::new());
    assert_eq!(painted(&page), pressed);
}

#[test]
fn with_less_motion_views_jump() {
    let (mut page, t) = resting();
    page.outside.reduce_motion(true);
    let before = painted(&page);
    frame_at(&mut page, t, vec![key(Key::Num3, true, Modifiers::ALT)]);
    let jumped = painted(&page);
    assert_ne!(jumped, before);
    frame_at(&mut page, t + 0.3, Vec::new());
    assert_eq!(painted(&page), jumped);
}

#[test]
fn keys_and_pointer_fly_and_escape_goes_back() {
    let mut page = Page::new();
    let middle = page.find("Viewport").rect().center();
    page.hover(middle);
    page.press(Key::P);
    let before = view(&mut page);
    assert_eq!(before["orthographic"], true);
    page.press_with(Modifiers::SHIFT, Key::Backtick);
    assert_eq!(view(&mut page)["orthographic"], false, "there is no flying without perspective");
    assert!(page.has_part("W A S D: Fly") && page.has_part("Esc: Go back"), "the status line says how");
    // The pointer turns the eye where it is.
    let start = eye(&mut page);
    let yaw = number(&view(&mut page), "yaw");
    page.hover(middle + vec2(40.0, 0.0));
    assert!(eye(&mut page).distance(start) < 1e-9);
    let turned = (yaw - number(&view(&mut page), "yaw")).rem_euclid(std::f64::consts::TAU);
    assert!(turned > 0.05 && turned < 1.0, "to the right: {turned}");
    // Keys move it while they are held, and don't do what they do otherwise.
    let mesh = page.mesh().clone();
    let fly = |page: &mut Page, keys: &[Key], modifiers| {
        let from = eye(page);
        page.harness.input_mut().events.extend(keys.iter().map(|k| key(*k, true, modifiers)));
        page.harness.input_mut().events.insert(0, Event::ModifiersChanged(modifiers));
        (0..3).for_each(|_| page.harness.step());
        assert!(is_restless(page), "it flies on");
        page.harness.input_mut().events.extend(keys.iter().map(|k| key(*k, false, Modifiers::NONE)));
        page.harness.input_mut().events.push(Event::ModifiersChanged(Modifiers::NONE));
        page.run();
        eye(page) - from
    };
    let forward = (target(&view(&mut page)) - eye(&mut page)).normalize();
    let ahead = fly(&mut page, &[Key::W], Modifiers::NONE);
    assert!(ahead.normalize().dot(forward) > 0.999, "{ahead}");
    let fast = fly(&mut page, &[Key::W], Modifiers::SHIFT);
    assert!((fast.length() / ahead.length() - 4.0).abs() < 0.2, "{fast} {ahead}");
    let back = fly(&mut page, &[Key::ArrowDown], Modifiers::NONE);
    assert!(back.normalize().dot(forward) < -0.999);
    let up = fly(&mut page, &[Key::E], Modifiers::NONE);
    assert!(up.y > 0.0 && up.x.abs() + up.z.abs() < 1e-9, "{up}");
    let right = fly(&mut page, &[Key::D], Modifiers::NONE);
    assert!(right.y.abs() < 1e-9 && forward.cross(right.normalize()).y < -0.9, "{right}");
    assert!(fly(&mut page, &[Key::A], Modifiers::NONE).distance(-right) < 1e-9);
    // The wheel changes the speed and doesn't zoom.
    let (from, distance) = (eye(&mut page), number(&view(&mut page), "distance"));
    page.harness.event(wheel(MouseWheelUnit::Point, 120.0));
    page.run();
    assert_eq!((eye(&mut page), number(&view(&mut page), "distance")), (from, distance));
    assert!(page.has_part("Wheel: Speed 125 %"));
    let faster = fly(&mut page, &[Key::W], Modifiers::NONE);
    assert!((faster.length() / ahead.length() - 1.25).abs() < 0.05, "{faster} {ahead}");
    page.press(Key::S);
    page.press(Key::X);
    page.press(Key::F);
    assert_eq!(page.mesh(), &mesh);
    page.press(Key::Escape);
    let after = view(&mut page);
    for name in ["target", "yaw", "pitch", "distance", "orthographic"] {
        assert_eq!(after[name], before[name], "{name}");
    }
    assert!(!page.has_part("W A S D"));
    page.press(Key::Num4);
    page.hover(middle);
    assert_eq!(page.find("Viewport").value().unwrap_or_default().split(' ').next(), Some("Face"));
}

#[test]
fn a_flight_ends_where_the_eye_is_by_enter_a_click_or_another_action() {
    let mut page = Page::new();
    let middle = page.find("Viewport").rect().center();
    for way in 0..4 {
        page.press(Key::Space);
        page.hover(middle);
        page.click("View");
        page.click("Zoom and fly");
        page.harness.get_by_label_contains("Fly Shift").click();
        page.run();
        page.hover(middle - vec2(60.0, 20.0));
        page.hover(middle - vec2(30.0, 10.0));
        let (flown, turned) = (eye(&mut page), number(&view(&mut page), "yaw"));
        match way {
            0 => page.press(Key::Enter),
            1 => crate::viewport::click_at(&mut page, middle - vec2(30.0, 10.0), Modifiers::NONE),
            2 => page.press_with(Modifiers::COMMAND, Key::K),
            _ => {
                let pos = middle - vec2(30.0, 10.0);
                for pressed in [true, false] {
                    let (button, modifiers) = (PointerButton::Secondary, Modifiers::NONE);
                    page.harness.event(Event::PointerButton { pos, button, pressed, modifiers });
                }
                page.run();
            }
        }
        let after = number(&view(&mut page), "yaw");
        if way == 3 {
            assert_ne!(after, turned, "a right-click goes back");
            assert!(!page.has_part("Isolate"), "and opens no menu");
        } else {
            assert_eq!(after, turned, "{way}");
            assert!(eye(&mut page).distance(flown) < 1e-6, "{way}");
        }
        assert!(!page.has_part("W A S D"), "{way}");
        assert!(page.selected().1.is_empty(), "the click has selected nothing");
        page.hover(middle);
        assert_eq!(number(&view(&mut page), "yaw"), after, "the pointer turns nothing any longer");
        page.press(Key::Escape);
    }
    // From now on the view turns about what is in its middle.
    page.press(Key::Space);
    page.hover(middle);
    page.press_with(Modifiers::SHIFT, Key::Backtick);
    page.press(Key::Enter);
    let at = target(&view(&mut page)).as_vec3();
    assert!((at.abs().max_element() - 1.0).abs() < 1e-3, "on the surface of the cube: {at}");
}

#[test]
fn flying_says_what_it_takes() {
    let mut page = Page::sized(crate::page::PHONE);
    page.press_with(Modifiers::SHIFT, Key::Backtick);
    assert!(page.has_part("Flying needs a keyboard and a mouse."));
    assert!(!page.has_part("W A S D"));
}

#[test]
fn pictures_of_a_flight() {
    for (theme, name) in [(Theme::Dark, "flying dark"), (Theme::Light, "flying light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        let middle = page.find("Viewport").rect().center();
        page.hover(middle);
        page.press_with(Modifiers::SHIFT, Key::Backtick);
        let shown = picture(&mut page, name);
        // The mark in the middle: a light line with a dark one around it.
        let bright = |by: egui::Vec2| {
            let at = middle + by;
            shown.get_pixel(at.x as u32, at.y as u32).0.iter().take(3).map(|c| u32::from(*c)).sum::<u32>()
        };
        assert!(bright(vec2(6.0, 0.0)) > bright(vec2(6.0, 1.5)) + 60, "{name}");
    }
}
