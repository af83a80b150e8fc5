//! Faulty and hostile documents: what can be read is read, and the rest is named.

use super::common::mesh;
use super::{INPUT, document, read_dae};
use formats::Import;

/// The warnings of an import, one a line.
fn warnings(import: &Import) -> String {
    import.report.warnings().collect::<Vec<_>>().join("\n")
}

/// A scene with these nodes.
fn scene(nodes: &str) -> String {
    format!("<library_visual_scenes><visual_scene>{nodes}</visual_scene></library_visual_scenes>")
}

/// The primitive of one triangle.
fn triangle() -> String {
    format!("<triangles>{INPUT}<p>0 1 2</p></triangles>")
}

#[test]
fn missing_and_incomplete_faces_are_reported() {
    let report_of = |primitive: &str| {
        let import = read_dae(document("", primitive, "")).expect(primitive);
        let warnings: Vec<String> = import.report.warnings().map(str::to_owned).collect();
        (mesh(&import).face_count(), warnings.join("\n"))
    };
    for (primitive, faces, says) in [
        (
            format!("<polylist count=\"1\">{INPUT}<p>0 1 2 3</p></polylist>"),
            0,
            "a <polylist> has no <vcount>",
        ),
        (
            format!("<polylist count=\"1\">{INPUT}<vcount>4</vcount><p>0 1 2 3 4</p></polylist>"),
            1,
            "a <polylist> has 1 number in its <p> after the last whole face",
        ),
        (format!("<polylist count=\"2\">{INPUT}</polylist>"), 0, "a <polylist> has none of its 2 faces"),
        (format!("<triangles count=\"12\">{INPUT}</triangles>"), 0, "a <triangles> has none of its 12 faces"),
        (
            format!("<triangles count=\"2\">{INPUT}<p>0 1 2 3 4</p></triangles>"),
            1,
            "a <triangles> has 2 numbers in its <p> after the last whole face",
        ),
        (format!("<tristrips count=\"1\">{INPUT}<p>0 1</p></tristrips>"), 0, "a <tristrips> has 2 numbers"),
        (format!("<trifans count=\"1\">{INPUT}</trifans>"), 0, "a <trifans> has none of its 1 face"),
        (format!("<polygons count=\"1\">{INPUT}</polygons>"), 0, "a <polygons> has none of its 1 face"),
        (
            format!("<polygons count=\"2\">{INPUT}<p>0 1 2</p><ph><h>3 4 5</h></ph></polygons>"),
            1,
            "a <polygons> has a <ph> without <p>",
        ),
    ] {
        let (read, warnings) = report_of(&primitive);
        assert_eq!(read, faces, "{primitive}");
        assert!(warnings.contains("Faces left out: geometry \"shape\": "), "{warnings}");
        assert!(warnings.contains(says), "{warnings} instead of {says}");
    }
    for whole in [
        format!("<polylist count=\"0\">{INPUT}<vcount></vcount><p></p></polylist>"),
        format!("<polylist count=\"0\">{INPUT}</polylist>"),
        format!(
            "<triangles count=\"0\">{INPUT}</triangles><trifans count=\"1\">{INPUT}<p>0 1 2 3</p></trifans>"
        ),
    ] {
        assert_eq!(report_of(&whole).1, "", "{whole}");
    }
    // Many of them, and many instances of one, make a few lines.
    let many = format!("<triangles count=\"1\">{INPUT}</triangles>").repeat(4);
    assert_eq!(report_of(&many).1.lines().count(), 1);
    let many: String = (1..20).map(|i| format!("<triangles count=\"{i}\">{INPUT}</triangles>")).collect();
    assert!(report_of(&many).1.ends_with("13 faults more of this kind"), "{}", report_of(&many).1);
}

#[test]
fn documents_with_nothing_usable_are_refused() {
    for (text, expected) in [
        ("<COLLADA/>", "holds no mesh"),
        ("<COLLADA>&boom;</COLLADA>", "1 entity other than XML's own"),
        ("<!DOCTYPE x [<!ENTITY a \"b\">]><COLLADA>&a;</COLLADA>", "1 entity other than XML's own"),
        ("<COLLADA><asset></COLLADA>", "everything from line 1 on, not well-formed"),
        ("<COLLADA><asset>", "stops in the middle of an element"),
        (
            "<COLLADA version=\"1.3.1\"><library type=\"GEOMETRY\"/></COLLADA>",
            "It is COLLADA 1.3.1. Versions 1.4 and 1.5",
        ),
        ("<html/>", "root is not"),
        ("", "The file is empty."),
    ] {
        let error = read_dae(text).expect_err(text);
        assert!(error.contains(expected), "{error}\n{text}");
    }
    let deep = format!("<COLLADA>{}", "<x>".repeat(100_000));
    assert!(read_dae(deep).expect_err("nothing in it").contains("in the middle of an element"));
}

#[test]
fn a_fault_in_one_primitive_leaves_the_others() {
    for (faulty, expected) in [
        (
            format!("<triangles>{INPUT}<p>0 1 9</p></triangles>"),
            "1 face with a vertex that doesn't exist (of 6)",
        ),
        (
            format!("<triangles>{INPUT}<p>0 1 -1 0 x 2</p></triangles>"),
            "2 faces with a vertex that doesn't exist",
        ),
        (
            format!("<polylist>{INPUT}<vcount>4000000000</vcount><p>0</p></polylist>"),
            "a <polylist> has fewer numbers in its <p> than its <vcount> says (1 face missing)",
        ),
        ("<triangles><p>0 1 2</p></triangles>".to_owned(), "a <triangles> has no <input> for its vertices"),
        (
            format!(
                "<triangles>{INPUT}<input semantic=\"NORMAL\" source=\"#s\" offset=\"999999999\"/><p>0 1 2</p></triangles>"
            ),
            "a <triangles> has an <input> without a readable offset",
        ),
        (
            format!("<triangles count=\"1\">{INPUT}<p>1,0 2,0</p></triangles>"),
            "commas that may be decimal commas or separators",
        ),
    ] {
        let import = read_dae(document("", &format!("{faulty}{}", triangle()), "")).expect(&faulty);
        assert_eq!(mesh(&import).face_count(), 1, "{faulty}");
        assert!(warnings(&import).contains(expected), "{}\n{faulty}", import.report);
    }
}

#[test]
fn a_fault_in_one_attribute_leaves_the_faces() {
    for (input, expected) in [
        (
            "<input semantic=\"NORMAL\" source=\"#q\" offset=\"0\"/>",
            "has no normals: source \"#q\" doesn't exist",
        ),
        ("<input semantic=\"TEXCOORD\" source=\"a.dae#q\" offset=\"0\"/>", "source \"a.dae#q\""),
        ("<input semantic=\"TEXCOORD\" source=\"b.dae#q\" offset=\"0\"/>", "is in another file"),
        ("<input semantic=\"COLOR\" source=\"#v\" offset=\"0\"/>", "has no colours"),
    ] {
        let triangles = format!("<triangles>{INPUT}{input}<p>0 1 2</p></triangles>");
        let import = read_dae(document("", &triangles, "")).expect(input);
        assert_eq!(mesh(&import).face_count(), 1, "{input}");
        assert!(warnings(&import).contains(expected), "{}\n{input}", import.report);
    }
}

#[test]
fn a_fault_in_one_node_leaves_the_others() {
    let good = "<node><translate>0 0 5</translate><instance_geometry url=\"#g\"/></node>";
    let instance = "<instance_geometry url=\"#g\"/>";
    for (faulty, expected) in [
        (
            "<node name=\"n\"><instance_geometry url=\"#x\"/></node>",
            "what node \"n\" shows: \"#x\" doesn't exist",
        ),
        (
            "<node name=\"n\"><instance_controller url=\"#x\"/></node>",
            "what node \"n\" shows: \"#x\" doesn't exist",
        ),
        (
            "<node name=\"n\"><instance_node url=\"b.dae#x\"/></node>",
            "the node that node \"n\" refers to: \"b.dae#x\" is in another file",
        ),
        ("<node id=\"n\"><instance_node url=\"#n\"/></node>", "node \"n\" inside itself"),
        (
            &format!("<node id=\"n\"><skew>1 2 3</skew>{instance}</node>"),
            "its <skew> has 3 numbers instead of 7",
        ),
        (
            &format!("<node id=\"n\"><scale>1 x 3</scale>{instance}</node>"),
            "its <scale> has a number that can't be read",
        ),
        (
            &format!("<node id=\"n\"><scale>1e308 1e308 1</scale><scale>1e308 1 1</scale>{instance}</node>"),
            "no finite numbers",
        ),
        (
            &format!("<node id=\"n\"><scale>1,5 2,5</scale>{instance}</node>"),
            "its <scale> has commas that may be decimal commas",
        ),
    ] {
        let import = read_dae(document("", &triangle(), &scene(&format!("{faulty}{good}")))).expect(faulty);
        assert_eq!(import.model.objects.len(), 1, "{}\n{faulty}", import.report);
        assert_eq!(mesh(&import).positions()[0].z, 5.0, "{faulty}");
        assert!(
            warnings(&import).contains(&format!("Left out: {expected}"))
                || warnings(&import)
                    .contains(&format!("Left out: node \"n\" with what is in it: {expected}"))
                || warnings(&import).contains(expected),
            "{}\n{faulty}",
            import.report
        );
        // Alone, such a node leaves the geometry, which is something to show.
        let import = read_dae(document("", &triangle(), &scene(faulty))).expect(faulty);
        assert_eq!(mesh(&import).positions()[0].z, 0.0, "{faulty}");
        assert!(warnings(&import).contains(expected), "{}\n{faulty}", import.report);
    }
}

#[test]
fn nodes_nest_without_limit_and_repeat_within_one() {
    // Deep nesting is no fault.
    let depth = 20_000;
    let nodes = format!(
        "{}<instance_geometry url=\"#g\"/>{}",
        "<node><translate>0 0 1</translate>".repeat(depth),
        "</node>".repeat(depth)
    );
    let import = read_dae(document("", &triangle(), &scene(&nodes))).expect("readable");
    assert_eq!(f64::from(mesh(&import).positions()[0].z) + import.model.offset.z, f64::from(depth as u32));
    // References that double the scene at every step come to an end.
    let bomb: String = (0..30)
        .map(|i| {
            let next = i + 1;
            format!(
                "<node id=\"n{i}\"><instance_node url=\"#n{next}\"/><instance_node url=\"#n{next}\"/></node>"
            )
        })
        .collect();
    let nodes = format!("{bomb}<node id=\"n30\"><instance_geometry url=\"#g\"/></node>");
    let import = read_dae(document("", &triangle(), &scene(&nodes))).expect("readable");
    assert!(import.model.objects.len() < 50_000, "{}", import.model.objects.len());
    let warnings = warnings(&import);
    assert!(
        warnings.contains("all nodes of the scene after the first") || warnings.contains("too many times"),
        "{warnings}"
    );
}

#[test]
fn a_file_that_breaks_off_keeps_what_came_before() {
    let whole = document("", &triangle(), &scene("<node name=\"n\"><instance_geometry url=\"#g\"/></node>"));
    let cut = whole.find("<library_visual_scenes>").expect("a scene");
    for (end, expected) in
        [("", "the end of the file, which stops in the middle"), ("</geometry>", "not well-formed XML")]
    {
        let import = read_dae(format!("{}{end}", &whole[..cut])).expect("readable");
        assert_eq!(mesh(&import).face_count(), 1);
        assert!(warnings(&import).contains(expected), "{}", import.report);
    }
    // Programs write names with "&" as they are.
    let import = read_dae(whole.replace("\"n\"", "\"a & b\"")).expect("readable");
    assert_eq!(import.model.objects[0].name, "a & b");
}
