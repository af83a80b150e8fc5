//! The bar of an edit that follows the pointer: the way to its buttons changes nothing.

use crate::page::Page;
use egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use halfedge::Mesh;

/// An edit of a cube's face whose pointer rests this far from where it began.
fn resting(key: Key) -> (Page, Mesh, Pos2) {
    let mut page = Page::new();
    page.select("face", &[0]);
    let before = page.mesh().clone();
    page.hover_off_middle(vec2(0.0, -60.0));
    page.press(key);
    page.hover_off_middle(vec2(0.0, -60.0));
    page.hover_off_middle(vec2(70.0, -90.0));
    page.wait();
    let wanted = page.mesh().clone();
    assert_ne!(wanted, before);
    let at = page.find("Viewport").rect().center() + vec2(70.0, -90.0);
    (page, wanted, at)
}

/// Moves the pointer without a stop; returns whether the mesh was another on the way.
fn sweep(page: &mut Page, from: Pos2, to: Pos2) -> bool {
    let before = page.mesh().clone();
    let mut changed = false;
    for part in 1..=8 {
        page.harness.hover_at(from + (to - from) * (part as f32 / 8.0));
        page.harness.step();
        changed |= page.mesh() != &before;
    }
    changed
}

fn apply_button(page: &Page) -> Pos2 {
    page.find("Apply").rect().center()
}

fn click(page: &mut Page, at: Pos2) {
    for pressed in [true, false] {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        page.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers });
        page.run();
    }
}

#[test]
fn apply_takes_the_amount_where_the_pointer_rested() {
    // Move, extrude and, with Shift, rotate and scale do so alike.
    for key in [Key::G, Key::E] {
        let (mut page, wanted, from) = resting(key);
        let apply = apply_button(&page);
        assert!(sweep(&mut page, from, apply), "the picture is followed up to the bar");
        page.run();
        assert_eq!(page.mesh(), &wanted, "{key:?}: over the bar the amount is what it was");
        let apply = apply_button(&page);
        page.hover(apply);
        click(&mut page, apply);
        assert!(!page.has("Apply"));
        assert_eq!(page.mesh(), &wanted, "{key:?}");
        assert_eq!(page.undo_labels().len(), 1);
    }
}

#[test]
fn a_pointer_that_crosses_the_bar_goes_on_as_if_there_were_none() {
    let (mut page, _, from) = resting(Key::G);
    let apply = apply_button(&page);
    let beside = apply + vec2(0.0, -150.0);
    sweep(&mut page, from, apply);
    page.run();
    page.hover(beside);
    let crossed = page.mesh().clone();
    let (mut page, _, _) = resting(Key::G);
    page.hover(beside);
    let straight = page.mesh();
    for (a, b) in crossed.positions().iter().zip(straight.positions()) {
        assert!(a.distance(*b) < 1e-4, "{a} and {b}");
    }
}

#[test]
fn what_is_locked_on_the_bar_stays() {
    let (mut page, _, from) = resting(Key::G);
    let start = page.mesh().clone();
    let apply = apply_button(&page);
    sweep(&mut page, from, apply);
    page.run();
    page.click("X");
    page.run();
    let moved = |mesh: &Mesh| {
        let mut all = mesh.positions().iter().zip([0.0_f32; 8]);
        all.any(|(at, _)| at.y.abs() != 1.0 || at.z.abs() != 1.0)
    };
    assert!(moved(&start) && !moved(page.mesh()), "only along x");
    page.press(Key::Escape);
}
