//! Pictures of the page for people to inspect, written to `$CARGO_TARGET_TMPDIR/looks`. The tests check
//! what only a picture can show: the viewport draws the mesh, and nothing extends beyond the window.

use crate::page::{DESKTOP, PHONE, Page};
use egui::Theme;
use egui_kittest::kittest::Queryable;
use serde_json::json;

/// Saves what the page looks like, and gives the picture.
pub fn picture(page: &mut Page, name: &str) -> image::RgbaImage {
    let picture = page.harness.render().expect("a picture");
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("looks");
    std::fs::create_dir_all(&folder).expect("a folder for pictures");
    picture.save(folder.join(format!("{name}.png"))).expect("a picture on disk");
    picture
}

#[test]
fn desktop_in_both_themes() {
    for (theme, name) in [(Theme::Dark, "desktop dark"), (Theme::Light, "desktop light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.select("vertex", &[3]);
        let with = picture(&mut page, name);
        // The vertex is marked where it is: a white-hot core in the selection's orange, not the cube's grey.
        let at = page.mesh().position(page_vertex(3)).to_array();
        let at = page.at(at);
        let core = with.get_pixel(at.x.round() as u32, at.y.round() as u32).0;
        assert!(core[0] > 230 && core[2] > 200, "{name}: {core:?} at {at:?} is not the active element's");
        let pixel = with.get_pixel((at.x - 4.0).round() as u32, at.y.round() as u32).0;
        assert!(pixel[0] > 200 && pixel[2] < 90, "{name}: {pixel:?} at {at:?} is not the selection's orange");
        page.select("face", &[0, 1]);
    }
}

fn page_vertex(id: usize) -> halfedge::VertexId {
    halfedge::VertexId::new(id)
}

#[test]
fn every_kind_of_element_and_every_window() {
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    for (kind, name) in [("edge", "edge"), ("halfedge", "half-edge"), ("face", "face")] {
        page.select(kind, &[2]);
        picture(&mut page, &format!("inspector of a {name}"));
    }
    page.press(egui::Key::Questionmark);
    picture(&mut page, "shortcuts");
    page.press(egui::Key::Escape);
    page.press_with(egui::Modifiers::COMMAND, egui::Key::K);
    picture(&mut page, "palette");
    page.find("Find a command").type_text("edge");
    page.run();
    picture(&mut page, "palette with greyed commands");
    page.press(egui::Key::Escape);
    page.click("Mesh");
    page.click("Edge edits");
    picture(&mut page, "mesh menu");
    page.press(egui::Key::Escape);
    page.click("View");
    picture(&mut page, "view menu");
    page.press(egui::Key::Escape);
    page.press(egui::Key::I);
    page.command(json!({ "op": "new", "shape": "torus", "add": true }));
    page.open("broken.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2 9\nv 1 x 2\n");
    picture(&mut page, "an import with warnings");
}

#[test]
fn several_objects_and_a_refusal() {
    let mut page = Page::drawn(DESKTOP, Theme::Light);
    page.command(json!({ "op": "new", "shape": "torus", "add": true }));
    page.command(json!({ "op": "new", "shape": "ico-sphere", "add": true }));
    page.press_with(egui::Modifiers::COMMAND, egui::Key::A);
    page.press(egui::Key::N);
    picture(&mut page, "objects light");
}

#[test]
fn points_without_faces() {
    for (theme, name) in [(Theme::Dark, "points dark"), (Theme::Light, "points light")] {
        for size in [DESKTOP, PHONE] {
            let mut page = Page::drawn(size, theme);
            let points = (0..40).map(|i| f32::from(i as u8) * 0.4);
            let lines: Vec<String> =
                points.map(|t| format!("v {} {} {}\n", t.cos(), t * 0.1, t.sin())).collect();
            page.open("points.obj", &lines.concat());
            let with = picture(&mut page, &format!("{name} {}", size.x));
            page.press(egui::Key::V);
            picture(&mut page, &format!("{name} {}, dots on", size.x));
            let at = page.at([0.4_f32.cos(), 0.04, 0.4_f32.sin()]);
            let pixel = with.get_pixel(at.x as u32, at.y as u32).0;
            let beside = with.get_pixel(at.x as u32 + 8, at.y as u32).0;
            let differs = (0..3).map(|c| beside[c].abs_diff(pixel[c])).max();
            assert!(differs > Some(100), "{name}: {pixel:?} on {beside:?}");
        }
    }
}

/// A square whose left side is red and whose right side is blue, by its vertices.
const COLORED_SQUARE: &str = "v -1 -1 0 1 0 0\nv 1 -1 0 0 0 1\nv 1 1 0 0 0 1\nv -1 1 0 1 0 0\nf 1 2 3 4\n";

#[test]
fn vertex_colours_are_shown_until_faces_are_painted() {
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    page.open("colours.obj", COLORED_SQUARE);
    page.press_with(egui::Modifiers::ALT, egui::Key::Num1);
    let sides = |page: &mut Page, name: &str| {
        let picture = picture(page, name);
        [-0.9, 0.9].map(|x| {
            let at = page.at([x, 0.3, 0.0]);
            picture.get_pixel(at.x as u32, at.y as u32).0
        })
    };
    let is = |[r, _, b, _]: [u8; 4]| (r > b.saturating_add(60), b > r.saturating_add(60));
    let shown = sides(&mut page, "vertex colours");
    assert_eq!(shown.map(is), [(true, false), (false, true)], "red and blue: {shown:?}");
    for (by, expected) in [
        ("One colour", [(false, false); 2]),
        ("Vertex colours", [(true, false), (false, true)]),
        ("Face colours", [(false, false); 2]),
        ("Paint", [(true, false), (false, true)]),
    ] {
        page.click("View");
        page.click("Colour by");
        page.click(by);
        let shown = sides(&mut page, &format!("coloured by {by}"));
        assert_eq!(shown.map(is), expected, "{by}: {shown:?}");
    }
    page.select("face", &[0]);
    page.command(json!({ "op": "set-face-color", "color": "#00ff00" }));
    page.select("face", &[]);
    for [r, g, b, _] in sides(&mut page, "a painted face with vertex colours") {
        // The pointer may be over the face, which adds some blue.
        assert!(g > 150 && r < 80 && b < 130, "painted green: {r} {g} {b}");
    }
}

#[test]
fn colours_by_measures_and_labels_have_a_legend() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.command(json!({ "op": "new", "shape": "torus" }));
        assert!(!page.has_part("Legend"));
        let by = |page: &mut Page, by: &str| {
            page.click("View");
            page.click("Colour by");
            page.click(by);
            picture(page, &format!("coloured by {by} {name}"));
        };
        by(&mut page, "Gaussian curvature");
        assert!(page.has_part("Legend: Gaussian curvature, 1 / unit², from -"));
        by(&mut page, "Mean curvature");
        by(&mut page, "Valence");
        assert!(page.has_part("Legend: Valence, edges at a vertex, from 1 to 7"));
        by(&mut page, "Face quality");
        assert!(page.has_part("Legend: Face quality, 1 is regular, from 0 to 1"));
        by(&mut page, "Group");
        assert!(page.has_part("Legend: Group, This mesh has no groups"));
        page.open("groups.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\ng left\nf 1 2 3\ng right\nf 1 3 4\n");
        assert!(page.has_part("Legend: Group, left, right"));
        picture(&mut page, &format!("two groups {name}"));
        by(&mut page, "Paint");
        assert!(!page.has_part("Legend"));
    }
}

/// A cube without its top, on whose bottom edge a third face stands.
const BROKEN_BOX: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 1.5 0 1.5\nv 0.5 0 1.5\n\
    f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 4 1 5 8\nf 5 6 9 10\n";

#[test]
fn marks_are_counted_in_the_legend_and_follow_edits() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.open("box.obj", BROKEN_BOX);
        for mark in ["Boundary edges", "Sharp edges", "Texture seams", "Non-manifold places"] {
            page.click("View");
            page.click("Marks");
            page.click(mark);
        }
        picture(&mut page, &format!("marks {name}"));
        assert!(page.has_part("Texture seams: 0"));
        assert!(page.has_part("Non-manifold places: 2"));
        assert!(page.has_part("Boundary edges: 8"));
        page.select("face", &[0]);
        page.command(json!({ "op": "delete-faces" }));
        picture(&mut page, &format!("marks after an edit {name}"));
        assert!(page.has_part("Boundary edges: 10"));
    }
    let mut page = Page::drawn(DESKTOP, Theme::Dark);
    for mark in ["Face normals", "Vertex normals"] {
        page.click("View");
        page.click("Marks");
        page.click(mark);
    }
    picture(&mut page, "normals as lines");
    assert!(page.has_part("Face normals: 6") && page.has_part("Vertex normals: 8"));
}

#[test]
fn numbers_are_shown_around_the_pointer() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.command(json!({ "op": "new", "shape": "ico-sphere" }));
        let at = page.at([0.0, 0.0, 1.0]);
        let viewport = page.harness.get_by_label("Viewport").rect();
        page.harness.hover_at(at);
        page.run();
        let without = picture(&mut page, &format!("no numbers {name}"));
        page.click("View");
        page.click("Element numbers");
        page.harness.hover_at(at);
        page.run();
        let with = picture(&mut page, &format!("numbers {name}"));
        let changed: Vec<(f32, f32)> = with
            .enumerate_pixels()
            .filter(|(x, y, pixel)| without.get_pixel(*x, *y) != *pixel)
            .map(|(x, y, _)| (x as f32, y as f32))
            // The status bar shows the frame time, which differs.
            .filter(|(x, y)| viewport.contains(egui::pos2(*x, *y)))
            .collect();
        assert!(changed.len() > 2000, "{name}: {} pixels of numbers", changed.len());
        let far = changed.iter().filter(|(x, y)| (egui::pos2(*x, *y) - at).length() > 200.0).count();
        assert_eq!(far, 0, "{name}: numbers only around the pointer");
    }
}

#[test]
fn every_look_from_the_view_menu_differs() {
    let looks = [
        "Studio lights",
        "Light at the camera",
        "Clay",
        "Pearl",
        "Metal",
        "Red wax",
        "Zebra stripes",
        "Colours without light",
        "Hidden line",
        "Normals as colours",
        "Face orientation",
    ];
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.command(json!({ "op": "new", "shape": "torus" }));
        page.press(egui::Key::W);
        let mut seen: Vec<(&str, Vec<u8>)> = Vec::new();
        for look in looks {
            page.click("View");
            page.click("Look");
            page.click(look);
            let drawn = picture(&mut page, &format!("look {look} {name}"));
            // The middle of the viewport, left of the tube.
            let pixels = (500..800).flat_map(|x| drawn.get_pixel(x, 400).0).collect();
            for (other, before) in &seen {
                assert_ne!(*before, pixels, "{look} looks like {other}");
            }
            seen.push((look, pixels));
        }
    }
}

#[test]
fn a_job_without_reported_progress() {
    for (theme, size, name) in [(Theme::Dark, DESKTOP, "job dark"), (Theme::Light, PHONE, "job light phone")]
    {
        let mut page = Page::drawn(size, theme);
        let idle = picture(&mut page, name);
        page.outside.hold_jobs();
        page.outside.push(meshwright_web::platform::Event::Files(vec![
            meshwright_web::platform::NamedBytes::new("triangle.obj", b"v 0 0 0\n"),
        ]));
        page.wait();
        let bar = page.harness.get_by_label("Open triangle.obj").rect();
        let going = picture(&mut page, name);
        let drawn = |picture: &image::RgbaImage| -> Vec<[u8; 4]> {
            let y = bar.bottom() as u32 - 2;
            (bar.left() as u32 + 8..bar.right() as u32 - 8).map(|x| picture.get_pixel(x, y).0).collect()
        };
        assert_ne!(drawn(&going), drawn(&idle), "{name}: the bar");
        page.harness.step();
        assert_ne!(drawn(&picture(&mut page, name)), drawn(&going), "{name}: what is in it moves");
    }
}

#[test]
fn telephone_in_both_themes() {
    for (theme, name) in [(Theme::Dark, "phone dark"), (Theme::Light, "phone light")] {
        let mut page = Page::drawn(PHONE, theme);
        page.select("face", &[1]);
        picture(&mut page, name);
        page.click("Inspector");
        picture(&mut page, &format!("{name}, inspector"));
        page.click("Operations");
        picture(&mut page, &format!("{name}, operations"));
    }
}

#[test]
fn selecting_and_x_ray() {
    for (theme, name) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.command(json!({ "op": "new", "shape": "torus" }));
        page.select("face", &(40..120).collect::<Vec<_>>());
        picture(&mut page, &format!("faces selected {name}"));
        page.press_with(egui::Modifiers::ALT, egui::Key::X);
        let glass = picture(&mut page, &format!("x-ray {name}"));
        page.press_with(egui::Modifiers::ALT, egui::Key::X);
        let solid = picture(&mut page, &format!("no x-ray {name}"));
        assert!(glass != solid);
        page.select("edge", &(0..60).collect::<Vec<_>>());
        picture(&mut page, &format!("edges selected {name}"));

        // A lasso and the circle while they are drawn.
        let middle = page.find("Viewport").rect().center();
        let place = |i: f32| middle + egui::Vec2::angled(i * 0.3) * (110.0 + 40.0 * (i * 0.9).sin());
        page.click("Select");
        page.click("Select tool");
        page.click("Lasso select");
        page.harness.hover_at(place(0.0));
        page.harness.drag_at(place(0.0));
        (0..18).for_each(|i| {
            page.harness.hover_at(place(i as f32));
            page.run();
        });
        picture(&mut page, &format!("lasso {name}"));
        page.press(egui::Key::Escape);
        page.drop(place(0.0));
        page.press_with(egui::Modifiers::SHIFT, egui::Key::C);
        page.harness.hover_at(middle);
        page.run();
        page.harness.drag_at(middle);
        page.run();
        picture(&mut page, &format!("circle {name}"));
        page.drop(middle);
    }
    let mut page = Page::drawn(PHONE, Theme::Dark);
    page.press_with(egui::Modifiers::SHIFT, egui::Key::C);
    picture(&mut page, "circle telephone");
}

#[test]
fn the_chosen_patch_of_a_surface_is_marked() {
    let patch = |x: usize| -> String {
        (0..16).map(|i| format!("{} {} {}\n", 3 * x + i % 4, i / 4, (i % 4 * (i / 4)) % 3)).collect()
    };
    for (theme, name) in [(Theme::Dark, "patches dark"), (Theme::Light, "patches light")] {
        let mut page = Page::drawn(DESKTOP, theme);
        page.open("two.bez", &format!("2\n{}{}", patch(0), patch(1)));
        page.type_into("Patch", "1");
        let picture = picture(&mut page, name);
        // Between two control points of each net, where nothing else is drawn.
        let mut net = |x: f32| {
            let at = page.at([x, 0.0, 0.0]);
            picture.get_pixel(at.x.round() as u32, at.y.round() as u32).0
        };
        let (other, chosen) = (net(1.5), net(4.5));
        assert!(chosen[0] > 200 && chosen[2] < 120, "{name}: {chosen:?} is the selection's orange");
        assert!(other[2] > other[0], "{name}: {other:?} is not");
    }
}

#[test]
fn forms_line_up() {
    let mut page = Page::drawn(DESKTOP, Theme::Light);
    page.select("vertex", &[0]);
    for operation in ["Remesh", "Smooth", "Transform"] {
        page.choose(operation);
        picture(&mut page, &format!("form of {operation}"));
    }
    page.choose("Remesh");
    use egui::accesskit::Role;
    let left = |page: &Page, role, label| page.harness.get_by_role_and_label(role, label).rect().left();
    let number = page.harness.get_by_role_and_label(Role::SpinButton, "Iterations").rect();
    let angle = page.harness.get_by_role_and_label(Role::SpinButton, "Feature angle").rect();
    assert_eq!((number.left(), number.width()), (angle.left(), angle.width()));
    for label in ["Stay on surface", "Set Edge length"] {
        assert_eq!(left(&page, Role::CheckBox, label), number.left(), "{label}");
    }
}

#[test]
fn the_bars_at_several_sizes() {
    for (theme, shade) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        for (size, name) in [(egui::vec2(1920.0, 1080.0), "large"), (DESKTOP, "desktop"), (PHONE, "phone")] {
            let mut page = Page::drawn(size, theme);
            page.press(egui::Key::Num4);
            page.select("face", &[1]);
            picture(&mut page, &format!("bars {name} {shade}"));
        }
    }
}

#[test]
fn the_model_is_seen_beside_recent_documents() {
    let mut page = Page::new();
    for shape in ["torus", "ico-sphere", "cube"] {
        page.command(json!({"op": "new", "shape": shape}));
        page.command(json!({"op": "triangulate-faces"}));
        page.outside.advance(6000.0);
        page.run();
    }
    let outside = page.outside.clone();
    drop(page);
    outside.set_setting("welcome", "on");
    for (theme, shade) in [(Theme::Dark, "dark"), (Theme::Light, "light")] {
        for size in [DESKTOP, egui::vec2(1920.0, 1080.0), PHONE] {
            outside.set_setting("document", "");
            outside.open_in_new_tab();
            let mut page = Page::first_visit_drawn(&outside, size, theme);
            picture(&mut page, &format!("welcome back {shade} {}", size.x));
            let viewport = page.find("Viewport").rect();
            let top = page.find("Close welcome").rect().top();
            let share = (viewport.bottom() - top) / viewport.height();
            assert!(share < 0.5, "{size}: the view covers {share} of the viewport");
            if size != PHONE {
                assert!(page.has("Open Cube") && page.has("Open Torus"));
            }
        }
    }
}

#[test]
fn a_first_visit() {
    for (theme, name) in [(Theme::Dark, "welcome dark"), (Theme::Light, "welcome light")] {
        for size in [DESKTOP, egui::vec2(1920.0, 1080.0), PHONE] {
            let mut page = Page::welcoming_drawn(size, theme);
            let with = picture(&mut page, &format!("{name} {}", size.x));
            let tile = page.harness.get_by_label("Start with Mug").rect();
            // The mug's glaze is in its picture.
            let is_glaze = |[r, g, b, _]: [u8; 4]| g > r.saturating_add(30) && b > r.saturating_add(30);
            let (left, top) = (tile.left() as u32, tile.top() as u32);
            let across = left..left + tile.width() as u32;
            let pixels = across.flat_map(|x| (top..top + tile.height() as u32).map(move |y| (x, y)));
            let glazed = pixels.filter(|&(x, y)| is_glaze(with.get_pixel(x, y).0)).count();
            assert!(glazed > 200, "{name} {size}: {glazed} pixels of the mug");
        }
    }
}
