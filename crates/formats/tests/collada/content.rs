//! Every kind of content either comes back or is named in the report.

use super::common::{self, by_code, mesh, model, read};
use super::{INPUT, document, read_dae};
use formats::Import;
use glam::Vec3;
use halfedge::attribute::Column;
use halfedge::{Color, Mesh, PolygonSoup, keys};

/// A source named `c` of these numbers.
fn source(stride: usize, values: &str) -> String {
    let count = values.split_whitespace().count();
    format!(
        "<source id=\"c\"><float_array id=\"ca\" count=\"{count}\">{values}</float_array><technique_common>\
         <accessor source=\"#ca\" count=\"{}\" stride=\"{stride}\"/></technique_common></source>",
        count / stride
    )
}

/// Two triangles with the corner attribute `c` of this meaning, by these numbers of its values.
fn with_attribute(semantic: &str, source: &str, numbers: [u32; 6]) -> Import {
    let corners: String = [0, 1, 2, 0, 2, 3].iter().zip(numbers).map(|(v, n)| format!("{v} {n} ")).collect();
    let triangles = format!(
        "<triangles>{INPUT}<input semantic=\"{semantic}\" source=\"#c\" offset=\"1\"/><p>{corners}</p></triangles>"
    );
    let text = document("", &triangles, "").replace("<vertices", &format!("{source}<vertices"));
    read_dae(text).expect("readable")
}

#[test]
fn what_is_not_kept_is_named() {
    let triangle = format!("<triangles>{INPUT}<p>0 1 2</p></triangles>");
    let scene = |nodes: &str, more: &str| {
        format!(
            "{more}<library_visual_scenes><visual_scene id=\"vs\">{nodes}</visual_scene></library_visual_scenes>\
             <scene><instance_visual_scene url=\"#vs\"/></scene>"
        )
    };
    let shown = "<node id=\"n\"><instance_geometry url=\"#g\"/></node>";
    let geometry = |inside: &str| {
        scene(
            &format!("{shown}<node id=\"o\"><instance_geometry url=\"#h\"/></node>"),
            &format!(
                "<library_geometries><geometry id=\"h\" name=\"other\">{inside}</geometry></library_geometries>"
            ),
        )
    };
    for (scene, expected) in [
        (
            scene(
                shown,
                "<library_cameras><camera id=\"c\"/></library_cameras><library_lights><light id=\"l\"/><light id=\"m\"/></library_lights>",
            ),
            "Not kept: 1 camera, 2 lights",
        ),
        (
            scene(
                shown,
                "<library_animations><animation id=\"a\"><source id=\"s\"/></animation></library_animations>",
            ),
            "Not kept: 1 animation",
        ),
        (
            scene(shown, "<library_physics_scenes/><library_kinematics_models/>"),
            "Not kept: 1 library of physics scenes, 1 library of kinematics models",
        ),
        (
            scene(&format!("{shown}<node id=\"group\"><node id=\"empty\"/></node>"), ""),
            "show no mesh are not kept: 2",
        ),
        (
            scene(shown, "<library_visual_scenes><visual_scene name=\"second\"/></library_visual_scenes>")
                .replace("id=\"vs\"", "id=\"vs\" name=\"first\""),
            "1 scene besides the one shown: second",
        ),
        (
            scene(
                shown,
                "<library_geometries><geometry name=\"unused\"><mesh/></geometry></library_geometries>",
            ),
            "geometry \"unused\", which no node shows",
        ),
        (
            scene(
                &format!("{shown}<extra><technique profile=\"MAX3D\"/></extra>"),
                "<extra><technique profile=\"OTHER\"/></extra>",
            ),
            "double-sided faces: MAX3D, OTHER",
        ),
        (geometry("<spline/>"), "geometry \"other\": it is a <spline>"),
        (geometry("<brep/>"), "geometry \"other\": it is a <brep>"),
        (
            geometry("<convex_mesh convex_hull_of=\"#g\"/>"),
            "geometry \"other\": it is the convex hull of \"#g\"",
        ),
        (geometry(""), "geometry \"other\": it has no <mesh>"),
        (geometry("<mesh/>"), "geometry \"other\": it has no <vertices>"),
    ] {
        let import = read_dae(document("", &triangle, &scene)).expect("readable");
        assert!(import.report.to_string().contains(expected), "{}\n{scene}", import.report);
        assert_eq!(mesh(&import).face_count(), 1);
    }
    for (asset, expected) in [
        ("<up_axis>W_UP</up_axis>", "Its up axis \"W_UP\" is unknown"),
        ("<unit meter=\"x\"/>", "Its unit of \"x\" metres can't be read"),
        ("<unit meter=\"0,5\"/>", "scaled by 0.5 to metres"),
    ] {
        let import = read_dae(document(asset, &triangle, "")).expect("readable");
        assert!(import.report.to_string().contains(expected), "{}", import.report);
    }
    let text = document("", &triangle, "").replace("<mesh>", "<asset><up_axis>Z_UP</up_axis></asset><mesh>");
    let import = read_dae(text).expect("readable");
    assert!(import.report.to_string().contains("of single elements are not applied: 1"), "{}", import.report);
    let import = with_attribute("TEXTANGENT", &source(3, "1 0 0"), [0; 6]);
    assert!(
        import.report.to_string().contains("The corner attribute TEXTANGENT is not kept"),
        "{}",
        import.report
    );
}

#[test]
fn a_convex_mesh_is_a_mesh() {
    let text = document("", &format!("<triangles>{INPUT}<p>0 1 2</p></triangles>"), "");
    let text = text.replace("<mesh>", "<convex_mesh>").replace("</mesh>", "</convex_mesh>");
    assert_eq!(mesh(&read_dae(text).expect("readable")).face_count(), 1);
}

#[test]
fn accessors_name_and_order_their_components() {
    let positions = |accessor: &str, values: &str| {
        let text = document("", &format!("<triangles>{INPUT}<p>0 1 2</p></triangles>"), "");
        let (before, rest) = text.split_once("<float_array").expect("an array");
        let (_, after) = rest.split_once("</source>").expect("its end");
        let source = format!(
            "<float_array id=\"sa\">{values}</float_array><technique_common>{accessor}</technique_common></source>"
        );
        mesh(&read_dae(format!("{before}{source}{after}")).expect(accessor)).positions().to_vec()
    };
    let params = |names: &[&str]| -> String {
        names
            .iter()
            .map(|name| format!("<param name=\"{name}\" type=\"float\"/>").replace("name=\"\" ", ""))
            .collect()
    };
    let expected = [Vec3::ZERO, Vec3::X, Vec3::Y];
    let plain = "0 0 0 1 0 0 0 1 0";
    for (accessor, values) in [
        ("<accessor source=\"#sa\" count=\"3\" stride=\"3\"/>".to_owned(), plain),
        // Without a stride, without names, without an accessor's own source, with one group for all.
        (format!("<accessor source=\"#sa\" count=\"3\">{}</accessor>", params(&["X", "Y", "Z"])), plain),
        (format!("<accessor source=\"#sa\" count=\"3\" stride=\"3\">{}</accessor>", params(&["", "", ""])), plain),
        ("<accessor source=\"#gone\" count=\"3\" stride=\"3\"/>".to_owned(), plain),
        ("<accessor source=\"#sa\" count=\"3\" stride=\"3\"><param name=\"P\" type=\"float3\"/></accessor>".to_owned(), plain),
        (String::new(), plain),
        // Columns in another order, columns without names between, fewer rows than numbers.
        (format!("<accessor source=\"#sa\" count=\"3\" stride=\"3\">{}</accessor>", params(&["Z", "X", "Y"])), "0 0 0 0 1 0 0 0 1"),
        (format!("<accessor source=\"#sa\" count=\"3\" stride=\"5\">{}</accessor>", params(&["", "X", "Y", "", "Z"])), "9 0 0 9 0 9 1 0 9 0 9 0 1 9 0"),
        ("<accessor source=\"#sa\" count=\"3\" stride=\"3\"/>".to_owned(), "0 0 0 1 0 0 0 1 0 8 8 8"),
    ] {
        assert_eq!(positions(&accessor, values), expected, "{accessor}");
    }
    assert_eq!(
        positions("<accessor source=\"#sa\" count=\"3\" stride=\"2\"/>", "0 0 1 0 0 1"),
        expected,
        "a plane"
    );
}

#[test]
fn colours_of_corners_go_where_they_fit() {
    let colors = |values: &str, numbers: [u32; 6]| {
        let import = with_attribute("COLOR", &source(3, values), numbers);
        let mesh = mesh(&import).clone();
        let vertices: Vec<Vec3> = (0..4).map(|v| mesh.get(keys::VERTEX_COLOR, v)).collect();
        let faces = [mesh.get(keys::FACE_COLOR, 0), mesh.get(keys::FACE_COLOR, 1)];
        (vertices, faces, import.report)
    };
    // Corners of a vertex agree.
    let (vertices, _, report) = colors("1 0 0 0 1 0", [0, 1, 0, 0, 0, 1]);
    assert_eq!(vertices, [Vec3::X, Vec3::Y, Vec3::X, Vec3::Y]);
    assert!(report.is_clean(), "{report}");
    // Corners of a face do.
    let (vertices, faces, report) = colors("1 0 0 0 1 0", [0, 0, 0, 1, 1, 1]);
    assert_eq!(faces, [Color([255, 0, 0]), Color([0, 255, 0])]);
    assert!(vertices.iter().all(|color| color.is_nan()) && report.is_clean(), "{report}");
    // Neither.
    let (vertices, _, report) = colors("1 0 0 0 1 0", [0, 1, 0, 1, 1, 1]);
    assert_eq!(vertices, [Vec3::new(0.5, 0.5, 0.0), Vec3::Y, Vec3::new(0.5, 0.5, 0.0), Vec3::Y]);
    assert!(
        report.to_string().contains("vertices whose corners have different colours have the mean"),
        "{report}"
    );
    // Alpha has no place.
    let import = with_attribute("COLOR", &source(4, "1 0 0 0.5"), [0; 6]);
    assert!(import.report.to_string().contains("the alpha of colours is left out"), "{}", import.report);
}

#[test]
fn colours_of_vertices_come_back() {
    let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE, Vec3::Z];
    for without in [None, Some(3)] {
        let mut soup = PolygonSoup::new(positions.clone(), &[[0, 1, 2], [1, 3, 2]]);
        let color =
            |v: usize| if Some(v) == without { Vec3::NAN } else { Vec3::new(v as f32 / 7.0, 0.1, 1.0) };
        let mut colors: Vec<Vec3> = (0..5).map(color).collect();
        if without.is_some() {
            // A vertex in no face has nowhere to keep one, unless all have one.
            colors[4] = Vec3::NAN;
        }
        soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
        let mesh = Mesh::build(soup).expect("small").mesh;
        let back = read(&common::write(by_code("dae"), &mesh)).expect("readable");
        assert!(common::mesh(&back) == &mesh, "{without:?}");
        assert_eq!(formats::losses(by_code("dae"), &model("", &[("a", &mesh)])), [""; 0]);
    }
}
