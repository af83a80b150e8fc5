//! Bridge in the panel.

use crate::page::Page;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use halfedge::Element;

/// Two squares that look at each other.
const SQUARES: &str =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 3\nv 1 0 3\nv 1 1 3\nv 0 1 3\nf 4 3 2 1\nf 5 6 7 8\n";

#[test]
fn a_bridge_is_adjusted_by_its_cuts_and_its_twist() {
    let mut page = Page::new();
    page.open("squares.obj", SQUARES);
    page.select("edge", &[0, 1, 2, 3, 4, 5, 6, 7]);
    page.harness.get_all_by_role_and_label(Role::Button, "Bridge").next().expect("listed").click_accesskit();
    page.run();
    assert_eq!(page.mesh().face_count(), 6);
    let steps = page.undo_labels();
    page.type_into("Cuts", "2");
    assert_eq!(page.mesh().face_count(), 2 + 12);
    let straight = page.mesh().clone();
    page.type_into("Twist", "-1");
    assert_eq!(page.mesh().face_count(), 2 + 12);
    assert_ne!(page.mesh(), &straight);
    assert_eq!(page.undo_labels(), steps, "one step");
    let (kind, ids) = page.selected();
    // The edges of the bands: whoever works on edges goes on with edges.
    assert_eq!(kind, Element::Edge);
    assert!(ids.len() >= 12);
    page.mesh().validate().expect("a valid mesh");
}
