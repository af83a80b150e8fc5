//! Controllers: skins in the pose of their joints, and blended shapes.

use super::common::mesh;
use super::read_dae;
use formats::Import;
use glam::Vec3;
use halfedge::keys;

/// A source with this name and these numbers in groups.
fn source(name: &str, stride: usize, values: &str) -> String {
    let count = values.split_whitespace().count();
    format!(
        "<source id=\"{name}\"><float_array id=\"{name}-a\" count=\"{count}\">{values}</float_array><technique_common>\
         <accessor source=\"#{name}-a\" count=\"{}\" stride=\"{stride}\"/></technique_common></source>",
        count / stride
    )
}

/// A geometry of one triangle with normals along z.
fn geometry(name: &str, positions: &str) -> String {
    format!(
        "<geometry id=\"{name}\"><mesh>{}{}<vertices id=\"{name}-v\"><input semantic=\"POSITION\" source=\"#{name}-p\"/>\
         </vertices><triangles><input semantic=\"VERTEX\" source=\"#{name}-v\" offset=\"0\"/>\
         <input semantic=\"NORMAL\" source=\"#{name}-n\" offset=\"1\"/><p>0 0 1 0 2 0</p></triangles></mesh></geometry>",
        source(&format!("{name}-p"), 3, positions),
        source(&format!("{name}-n"), 3, "0 0 1"),
    )
}

const IDENTITY: &str = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

/// A skin of two joints: vertex 0 follows the first, vertex 1 the second, vertex 2 both by halves, with
/// weights that have to be normalised.
fn skin(names: &str, of: &str) -> String {
    format!(
        "<controller id=\"k\"><skin source=\"#{of}\"><bind_shape_matrix>{IDENTITY}</bind_shape_matrix><source id=\"j\">{names}\
         </source>{}{}<joints><input semantic=\"JOINT\" source=\"#j\"/><input semantic=\"INV_BIND_MATRIX\" source=\"#b\"/></joints>\
         <vertex_weights count=\"3\"><input semantic=\"JOINT\" source=\"#j\" offset=\"0\"/><input semantic=\"WEIGHT\" source=\"#w\" offset=\"1\"/>\
         <vcount>1 1 2</vcount><v>0 0 1 0 0 1 1 1</v></vertex_weights></skin></controller>",
        source("b", 16, &format!("{IDENTITY} {}", IDENTITY.replacen("1 0 0 0", "1 0 0 -4", 1))),
        source("w", 1, "1 0.25"),
    )
}

fn sids() -> &'static str {
    "<Name_array id=\"ja\" count=\"2\">one two</Name_array>"
}

/// Reads a document with these parts.
fn read(geometries: &str, controllers: &str, nodes: &str) -> Import {
    let text = format!(
        "<COLLADA version=\"1.4.1\"><library_geometries>{geometries}</library_geometries><library_controllers>{controllers}\
         </library_controllers><library_visual_scenes><visual_scene id=\"s\">{nodes}</visual_scene></library_visual_scenes>\
         <scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>"
    );
    read_dae(text).expect("readable")
}

/// Two joints: the second one 4 along x where it was bound, and turned by a quarter about z here.
const BONES: &str = "<node id=\"b1\" sid=\"one\" type=\"JOINT\"><translate>0 0 7</translate>\
    <node id=\"b2\" sid=\"two\" type=\"JOINT\"><translate>4 0 0</translate><rotate>1 0 0 90</rotate></node></node>";

fn near(import: &Import, expected: [Vec3; 3]) {
    let found = mesh(import).positions();
    assert!(
        found.iter().zip(expected).all(|(a, b)| a.distance(b) < 1e-5),
        "{found:?} instead of {expected:?}"
    );
}

#[test]
fn joints_place_the_vertices_of_a_skin() {
    let triangle = geometry("g", "0 0 0 4 1 0 0 2 0");
    // The node of the mesh has no say; another skeleton with the same names has neither.
    let other = "<node id=\"other\"><node sid=\"one\"/><node sid=\"two\"/></node>";
    let node = "<node name=\"n\"><translate>99 0 0</translate><instance_controller url=\"#k\"><skeleton>#b1</skeleton>\
        </instance_controller></node>";
    let expected = [
        Vec3::new(0.0, 0.0, 7.0),
        // (0, 1, 0) at the second joint, which turns it to (0, 0, 1).
        Vec3::new(4.0, 0.0, 8.0),
        // Half of (0, 2, 7), half of (0, 0, 9).
        Vec3::new(0.0, 1.0, 8.0),
    ];
    for names in [sids(), "<IDREF_array id=\"ja\" count=\"2\">b1 b2</IDREF_array>"] {
        let import = read(&triangle, &skin(names, "g"), &format!("{other}{BONES}{node}"));
        near(&import, expected);
        let report = import.report.to_string();
        assert!(
            report.contains("\"n\" has the pose of its skeleton") && report.contains("the 2 joints"),
            "{report}"
        );
        assert!(import.report.is_clean(), "{report}");
        let mesh = mesh(&import);
        let corner =
            |v: u32| mesh.halfedges().find(|&h| !mesh.is_boundary_halfedge(h) && mesh.from(h).raw() == v);
        let normal = |v: u32| mesh.get(keys::CORNER_NORMAL, corner(v).expect("a corner").index());
        assert!(
            normal(0).distance(Vec3::Z) < 1e-6 && normal(1).distance(-Vec3::Y) < 1e-6,
            "{} {}",
            normal(0),
            normal(1)
        );
    }
}

#[test]
fn joints_may_be_outside_the_scene() {
    let triangle = geometry("g", "0 0 0 4 1 0 0 2 0");
    let node = "<node name=\"n\"><instance_controller url=\"#k\"><skeleton>#b1</skeleton></instance_controller></node>";
    let joints = format!("</library_controllers><library_nodes>{BONES}</library_nodes><library_controllers>");
    let import = read(&triangle, &(skin(sids(), "g") + &joints), node);
    assert_eq!(mesh(&import).positions()[0], Vec3::Z * 7.0);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn a_skin_without_its_joints_is_as_it_was_bound() {
    let triangle = geometry("g", "0 0 0 4 1 0 0 2 0");
    let node = "<node name=\"n\"><translate>1 0 0</translate><instance_controller url=\"#k\"/></node>";
    let moved = skin(sids(), "g").replacen("1 0 0 0", "1 0 0 10", 1);
    let import = read(&triangle, &moved, node);
    near(&import, [Vec3::X * 11.0, Vec3::new(15.0, 1.0, 0.0), Vec3::new(11.0, 2.0, 0.0)]);
    let report = import.report.to_string();
    assert!(
        report.contains(
            "in the pose in which it was bound to its skeleton, which is not kept: its joint \"one\" is not in the scene"
        ),
        "{report}"
    );
}

/// A morph of `g` with these weights of two other shapes.
fn morph(method: &str, weights: &str) -> String {
    format!(
        "<controller id=\"m\"><morph source=\"#g\" method=\"{method}\"><source id=\"mt\"><IDREF_array id=\"mta\" count=\"2\">h1 h2\
         </IDREF_array></source>{}<targets><input semantic=\"MORPH_TARGET\" source=\"#mt\"/>\
         <input semantic=\"MORPH_WEIGHT\" source=\"#mw\"/></targets></morph></controller>",
        source("mw", 1, weights)
    )
}

#[test]
fn shapes_are_blended_by_their_weights() {
    let shapes = geometry("g", "0 0 0 1 0 0 0 1 0")
        + &geometry("h1", "0 0 4 1 0 4 0 1 4")
        + &geometry("h2", "0 0 0 9 0 0");
    let node = "<node name=\"n\"><instance_controller url=\"#m\"/></node>";
    for (method, weights, expected) in [
        ("NORMALIZED", "0 0", [Vec3::ZERO, Vec3::X, Vec3::Y]),
        ("NORMALIZED", "0.5 0", [Vec3::Z * 2.0, Vec3::new(1.0, 0.0, 2.0), Vec3::new(0.0, 1.0, 2.0)]),
        // The second shape lacks the third vertex.
        ("NORMALIZED", "0 0.5", [Vec3::ZERO, Vec3::X * 5.0, Vec3::Y]),
        ("RELATIVE", "0.5 1", [Vec3::Z * 2.0, Vec3::new(10.5, 0.0, 2.0), Vec3::new(0.0, 1.5, 2.0)]),
    ] {
        let import = read(&shapes, &morph(method, weights), node);
        near(&import, expected);
        assert!(
            import.report.to_string().contains("its morph targets are not kept: h1, h2"),
            "{}",
            import.report
        );
    }
    // A skin of a blended shape.
    let skinned = skin(sids(), "m") + &morph("NORMALIZED", "0.5 0");
    let import =
        read(&shapes, &skinned, &format!("{BONES}<node name=\"n\"><instance_controller url=\"#k\"/></node>"));
    assert!(mesh(&import).positions()[0].distance(Vec3::new(0.0, 0.0, 9.0)) < 1e-5);
    // Controllers in a circle show nothing, and the geometry is left.
    let circle = skin(sids(), "m") + &morph("NORMALIZED", "0 0").replace("#g", "#k");
    let import = read(&geometry("g", "0 0 0 1 0 0 0 1 0"), &circle, node);
    assert!(import.report.to_string().contains("refer to each other in a circle"), "{}", import.report);
    assert_eq!(mesh(&import).face_count(), 1);
}
