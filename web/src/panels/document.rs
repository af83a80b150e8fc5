//! The document's panel, shown while nothing is selected: how large the active object is, what it is made of, and
//! whether it is closed.

use editor::ops::{Kind, SelectBoundary, SelectIsolated, SelectSmallerComponents};
use editor::{Object, SelectMode};
use egui::text::{LayoutJob, TextWrapping};
use egui::{
    Align2, Color32, CursorIcon, Label, Response, RichText, Role, Sense, TextStyle, Ui, WidgetInfo, vec2,
};
use halfedge::words::thousands;
use halfedge::{Element, Mesh, Topology};

use crate::input::actions::Action;
use crate::input::keys;
use crate::lists::columns::counted;
use crate::page_view::Page;
use crate::request::Requests;
use crate::session::sharing;
use crate::theme;
use crate::view::textures::State;

const ROW_HEIGHT: f32 = 20.0;

/// The number of images listed.
const MAX_IMAGES: usize = 12;

/// Shown for a fact that is still being counted.
const COUNTING: &str = "…";

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    ui.scope(|ui| contents(ui, page, out));
}

fn contents(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    let document = page.editor.document();
    let Some(object) = document.active() else {
        ui.label(RichText::new("Empty document").heading());
        let open = keys::how_to(ui.ctx(), Action::Open);
        let hint = format!("Drop a file on the page, {open}, or choose New shape below.");
        ui.add(Label::new(RichText::new(hint).weak()).wrap());
        return;
    };
    ui.spacing_mut().item_spacing.y = 2.0;
    name(ui, document.name());
    let objects = document.objects().len();
    let state = if sharing::is_shared(page.session) {
        "Shared by a link; a change makes it your copy"
    } else if page.editor.is_dirty() {
        "Unsaved changes"
    } else {
        "No unsaved changes"
    };
    let line = if objects > 1 { format!("{objects} objects · {state}") } else { state.to_owned() };
    ui.label(RichText::new(line).small().weak());
    if objects > 1 {
        heading(ui, "Active object");
        fact(ui, "Name", object.name(), "The object that the lists show and operations change");
    }
    let mesh = object.mesh();
    let topology = page.survey.found();
    size(ui, page, object, topology.is_some_and(|found| is_closed(mesh, found)));
    heading(ui, "Elements");
    for (kind, name) in [
        (Element::Vertex, "Vertices"),
        (Element::Edge, "Edges"),
        (Element::Halfedge, "Half-edges"),
        (Element::Face, "Faces"),
    ] {
        fact(ui, name, &thousands(mesh.count(kind)), "How many the object has");
    }
    shape(ui, page, mesh, topology, out);
    images(ui, page);
}

/// The images of materials, with what they lack.
fn images(ui: &mut Ui, page: &Page<'_>) {
    let all = &page.editor.document().materials().images;
    let told: Vec<_> = all
        .iter()
        .filter_map(|image| match (&image.bytes, page.view.textures.state(image)) {
            (None, _) => Some((
                image,
                "missing".to_owned(),
                "A material refers to this file: drop it on the page",
                true,
            )),
            (_, Some(State::Shown([w, h]))) => {
                Some((image, format!("{w} × {h}"), "The image of a material, and its size in pixels", false))
            }
            (_, Some(State::Failed(_))) => Some((
                image,
                "not shown".to_owned(),
                "For the reason, see Help > Messages. The file is kept",
                true,
            )),
            (_, Some(_)) => Some((image, COUNTING.to_owned(), "The image is being loaded", false)),
            (Some(_), None) => None,
        })
        .collect();
    if told.is_empty() {
        return;
    }
    heading(ui, "Images");
    for (image, value, meaning, warns) in told.iter().take(MAX_IMAGES) {
        let color = warns.then_some(ui.visuals().warn_fg_color);
        fact_in(ui, image.file_name(), value, meaning, color);
    }
    if let Some(more) = told.len().checked_sub(MAX_IMAGES).filter(|more| *more > 0) {
        fact(ui, "More images", &thousands(more), "The images that are not listed here");
    }
}

fn size(ui: &mut Ui, page: &Page<'_>, object: &Object, closed: bool) {
    heading(ui, "Size");
    let sizes = page.survey.sizes();
    let dimensions = sizes.map(|sizes| {
        let [x, y, z] = sizes
            .bounds
            .map_or([0.0; 3], |bounds| (bounds.max.as_dvec3() - bounds.min.as_dvec3()).to_array());
        format!("{} × {} × {}", short(x), short(y), short(z))
    });
    let number = |value: Option<f64>| value.map_or_else(|| COUNTING.to_owned(), short);
    let all = dimensions.unwrap_or_else(|| COUNTING.to_owned());
    fact(ui, "Dimensions", &all, "The size along x, y and z, in mesh units");
    if object.mesh().face_count() > 0 {
        let area = sizes.map(|sizes| sizes.area);
        fact(ui, "Surface area", &number(area), "The area of all faces, in square mesh units");
    }
    if closed {
        let volume = sizes.map(|sizes| sizes.volume);
        let meaning = if volume.is_some_and(|volume| volume < 0.0) {
            "The volume inside, in cubic mesh units. It is negative because the faces point inward: flip the orientation"
        } else {
            "The volume inside, in cubic mesh units"
        };
        fact(ui, "Volume", &number(volume), meaning);
    }
}

fn shape(ui: &mut Ui, page: &Page<'_>, mesh: &Mesh, found: Option<Topology>, out: &mut Requests) {
    heading(ui, "Topology");
    let good = theme::palette(ui.visuals()).good;
    let warn = ui.visuals().warn_fg_color;
    let (text, color) = match found {
        None => (COUNTING, None),
        Some(_) if mesh.face_count() == 0 => ("no faces", None),
        Some(found) if is_closed(mesh, found) => ("yes", Some(good)),
        Some(_) => ("no", Some(warn)),
    };
    fact_in(ui, "Watertight", text, "Whether the surface is closed, without a boundary", color);
    let number = |value: Option<usize>| value.map_or_else(|| COUNTING.to_owned(), thousands);
    let loops = number(found.map(|found| found.boundary_loops));
    let meaning = "The closed loops of edges that have a face on one side only";
    if found.is_some_and(|found| found.boundary_loops > 0) {
        if link(ui, "Boundary loops", &loops, &format!("{meaning}. Click to select their edges")) {
            out.run(SelectBoundary { kind: Some(Kind::Edge), mode: SelectMode::Replace });
        }
    } else {
        fact(ui, "Boundary loops", &loops, meaning);
    }
    let components = number(found.map(|found| found.components));
    let isolated = page.survey.sizes().map_or(0, |sizes| sizes.isolated_vertices);
    let meaning = "The pieces that no edge joins";
    let pieces = found.map_or(0, |found| found.components);
    if pieces > 1 {
        // Points are pieces too.
        let kind = if pieces > isolated + 1 { Kind::Face } else { Kind::Vertex };
        if link(ui, "Components", &components, &format!("{meaning}. Click to select all but the largest")) {
            out.run(SelectSmallerComponents { kind: Some(kind), mode: SelectMode::Replace });
        }
    } else {
        fact(ui, "Components", &components, meaning);
    }
    if isolated > 0 {
        let meaning = "Vertices without an edge. Click to select them";
        if link(ui, "Isolated vertices", &thousands(isolated), meaning) {
            out.run(SelectIsolated { mode: SelectMode::Replace });
        }
    }
    let euler = mesh.euler_characteristic();
    fact(ui, "Euler characteristic", &euler.to_string(), "Vertices − edges + faces");
    let genus = found.and_then(|found| genus(found, euler, isolated));
    if let Some(genus) = genus.filter(|_| mesh.face_count() > 0) {
        let meaning = "The number of handles, of all components together: a sphere has none, a torus one";
        fact(ui, "Genus", &thousands(genus), meaning);
    }
}

fn is_closed(mesh: &Mesh, found: Topology) -> bool {
    mesh.face_count() > 0 && found.boundary_loops == 0
}

/// The genus of all components together: χ = 2 c − 2 g − b, with components c and boundary loops b. An isolated
/// vertex is no surface.
fn genus(found: Topology, euler: i64, isolated: usize) -> Option<usize> {
    let surfaces = found.components.checked_sub(isolated)?;
    let handles = 2 * surfaces as i64 - found.boundary_loops as i64 - (euler - isolated as i64);
    usize::try_from(handles).ok().filter(|handles| handles % 2 == 0).map(|handles| handles / 2)
}

/// The document's name as the panel's heading, with its role in the accessibility tree.
fn name(ui: &mut Ui, name: &str) {
    let font = TextStyle::Heading.resolve(ui.style());
    let color = ui.visuals().strong_text_color();
    let job = LayoutJob::simple_singleline(name.to_owned(), font, color);
    let mut job = LayoutJob { wrap: TextWrapping::truncate_at_width(ui.available_width()), ..job };
    job.break_on_newline = false;
    let galley = ui.painter().layout_job(job);
    let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Heading, true, format!("Document: {name}")));
    ui.painter().galley(rect.min, galley, color);
}

/// The heading of a group of facts.
fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(8.0);
    ui.add(Label::new(RichText::new(text).small().strong()).truncate());
}

fn fact(ui: &mut Ui, name: &str, value: &str, meaning: &str) {
    fact_in(ui, name, value, meaning, None);
}

/// A fact whose value is a link to what it counts; returns whether it was clicked.
fn link(ui: &mut Ui, name: &str, value: &str, meaning: &str) -> bool {
    let color = Some(ui.visuals().hyperlink_color);
    row(ui, (name, value, meaning), color, (Role::Link, Sense::click()))
        .on_hover_cursor(CursorIcon::PointingHand)
        .clicked()
}

fn fact_in(ui: &mut Ui, name: &str, value: &str, meaning: &str, color: Option<Color32>) {
    row(ui, (name, value, meaning), color, (Role::Label, Sense::hover()));
}

/// A name on the left and its value on the right, as one node of the accessibility tree.
fn row(
    ui: &mut Ui,
    (name, value, meaning): (&str, &str, &str),
    color: Option<Color32>,
    (role, sense): (Role, Sense),
) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW_HEIGHT), sense);
    response.widget_info(|| WidgetInfo::labeled(role, true, format!("{name}: {value}")));
    let painter = ui.painter();
    let (text, number) = (TextStyle::Body.resolve(ui.style()), TextStyle::Monospace.resolve(ui.style()));
    let color = color.unwrap_or(ui.visuals().text_color());
    let value = painter.text(rect.right_center(), Align2::RIGHT_CENTER, value, number, color);
    let room = rect.with_max_x(value.left() - 8.0);
    painter.with_clip_rect(room.intersect(ui.clip_rect())).text(
        rect.left_center(),
        Align2::LEFT_CENTER,
        name,
        text,
        ui.visuals().weak_text_color(),
    );
    response.on_hover_text(meaning)
}

/// A number with at most four decimals.
fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e7).contains(&size) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// How many elements of which kind are selected: "3 selected faces".
pub(crate) fn selection_title(kind: Element, count: usize) -> String {
    match counted(kind, count).split_once(' ') {
        Some((number, noun)) if count > 1 => format!("{number} selected {noun}"),
        Some((_, noun)) => format!("Selected {noun}"),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases = [
            (2.0, "2"),
            (0.5, "0.5"),
            (-0.00001, "-1.000e-5"),
            (1234.56789, "1234.5679"),
            (0.0, "0"),
            (3e9, "3.000e9"),
        ];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn titles_say_what_is_selected() {
        assert_eq!(selection_title(Element::Face, 1), "Selected face");
        assert_eq!(selection_title(Element::Halfedge, 1200), "1\u{a0}200 selected half-edges");
    }

    #[test]
    fn genus_of_surfaces() {
        let found =
            |boundary_loops, components| Topology { boundary_loops, components, ..Topology::default() };
        assert_eq!(genus(found(0, 1), 2, 0), Some(0), "a sphere");
        assert_eq!(genus(found(0, 1), 0, 0), Some(1), "a torus");
        assert_eq!(genus(found(1, 1), 1, 0), Some(0), "a disk");
        assert_eq!(genus(found(0, 3), 4, 0), Some(1), "two spheres and a torus");
        assert_eq!(genus(found(0, 2), 3, 1), Some(0), "a sphere and a point");
    }
}
