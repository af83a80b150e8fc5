//! The page without panels, as other pages embed it.

use crate::page::Page;
use meshwright_web::app::notices::Notice;
use serde_json::json;

fn embedded(panels: &str) -> Page {
    let mut page = Page::with_parameters(&[("embed", ""), ("panels", panels)]);
    page.run();
    page
}

#[test]
fn an_embedded_page_has_the_parts_that_it_is_asked_for() {
    let parts =
        [("menu", "File"), ("tools", "Lasso"), ("lists", "Go to id"), ("inspector", "Watertight: yes")];
    let whole = Page::new();
    let bare = embedded("");
    for (name, label) in parts {
        assert!(whole.has_part(label), "{label}");
        assert!(!bare.has_part(label), "{label}");
        let page = embedded(name);
        for (other, label) in parts {
            assert_eq!(page.has_part(label), name == other, "{name}: {label}");
        }
    }
    let mut page = embedded("tools,menu,sidebar");
    assert!(page.has_part("Lasso") && page.has("File"));
    assert!(page.has_part("panels that don't exist: sidebar"));
    assert!(page.app().editor().document().objects().len() == 1);
}

#[test]
fn the_viewport_of_an_embedded_page_fills_it() {
    let mut page = embedded("");
    // The cube is framed in the middle of the whole window.
    let corners = page.mesh().positions().to_vec();
    let at: Vec<egui::Pos2> = corners.iter().map(|corner| page.at(corner.to_array())).collect();
    let window = page.harness.ctx.content_rect();
    let cube = egui::Rect::from_points(&at);
    assert!(window.contains_rect(cube) && cube.height() > 0.5 * window.height(), "{cube} in {window}");
    assert!((cube.center() - window.center()).length() < 0.1 * window.height(), "{cube} in {window}");
}

#[test]
fn scripts_are_told_what_happened_once() {
    let mut page = Page::new();
    page.app().script().take_notices();
    assert_eq!(page.app().script().take_notices(), []);
    page.command(json!({ "op": "poke-faces", "faces": [0] }));
    let told = page.app().script().take_notices();
    let change = told.iter().find(|(notice, _)| *notice == Notice::Change).expect("a change");
    assert_eq!(change.1, json!({ "name": "Cube", "dirty": true, "last": "Poke faces" }));
    page.select("face", &[1, 2]);
    let told = page.app().script().take_notices();
    assert_eq!(told, [(Notice::Selection, json!({ "kind": "face", "count": 2 }))]);
    page.outside.hold_jobs();
    page.app().script().run(json!({ "op": "subdivide-catmull-clark", "levels": 6 }), Box::new(|_| {}));
    let told = page.app().script().take_notices();
    let job = told.iter().find(|(notice, _)| *notice == Notice::Job).expect("a job");
    assert_eq!(job.1, json!({ "jobs": [{ "op": "subdivide-catmull-clark", "progress": 0.0 }] }));
    page.outside.release_jobs();
    page.wait();
    let told = page.app().script().take_notices();
    assert!(told.contains(&(Notice::Job, json!({ "jobs": [] }))), "{told:?}");
}
