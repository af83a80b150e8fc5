//! Nothing is lost silently: what files and formats don't keep is said, and files of others stay.

mod common;

use common::*;
use serde_json::json;
use std::path::Path;

/// Converts a file; gives what was said on standard output and on standard error.
fn convert(input: &Path, output: &Path) -> [String; 2] {
    let done = run(&["convert", text(input), text(output)]);
    let said = [done.stdout, done.stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
    assert_eq!(done.status.code(), Some(0), "{said:?}");
    said
}

#[test]
fn small_edits_far_from_the_origin_are_kept() {
    let folder = folder("far");
    // All numbers fit single precision, where neighbours are half a unit apart.
    let square =
        "v 5000000 4000000 0\nv 5000002 4000000 0\nv 5000002 4000002 0\nv 5000000 4000002 0\nf 1 2 3 4\n";
    let file = write(&folder, "square.obj", square);
    let out = folder.join("out.obj");
    let said = run(&[
        "apply",
        text(&file),
        "--do",
        r#"{"op":"transform","vertices":[0],"translate":[0.1,0,0]}"#,
        "-o",
        text(&out),
    ]);
    let printed = String::from_utf8(said.stdout).expect("text");
    assert!(printed.contains("positions count from"), "{printed}");
    let written = std::fs::read_to_string(&out).expect("written");
    let x: f64 = written
        .split_whitespace()
        .skip_while(|&word| word != "v")
        .nth(1)
        .expect("x")
        .parse()
        .expect("a number");
    assert!((x - 5_000_000.1).abs() < 1e-7, "{written}");
    // A model that reaches from the origin to there has no digits to spare, and says so.
    let long = write(&folder, "long.obj", &square.replace("v 5000000 4000000 0", "v 0 0 0"));
    let said = json_of(&[
        "apply",
        text(&long),
        "--json",
        "--do",
        r#"{"op":"transform","vertices":[1],"translate":[0.3,0,0]}"#,
    ]);
    let warning = said["steps"][0]["outcome"]["warnings"][0].as_str().expect("a warning").to_owned();
    assert!(warning.contains("positions are 0.5 apart"), "{warning}");
}

#[test]
fn what_an_obj_loses_on_the_way_is_named() {
    let folder = folder("obj-to-obj");
    let model = "mtllib gone.mtl\no car\ng default\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng empty\ng wheel\nusemtl red\nf 1 2 3\n";
    let file = write(&folder, "a.obj", model);
    let [said, _] = convert(&file, &folder.join("b.obj"));
    assert!(said.contains("gone.mtl, which was not given, so its name is not kept either"), "{said}");
    assert!(said.contains("Groups and objects without faces are left out: empty\n"), "{said}");
    write(&folder, "gone.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    let [said, _] = convert(&file, &folder.join("c.obj"));
    assert!(said.contains("Materials that no face uses are left out: blue\n"), "{said}");
}

#[test]
fn names_that_a_format_has_no_place_for_are_named() {
    let folder = folder("names");
    let cube = write(&folder, "cube.obj", CUBE);
    for (name, is_lost) in [
        ("a.obj", true),
        ("a.ply", true),
        ("a.off", true),
        ("a.stl", true),
        ("a.glb", false),
        ("a.dae", false),
    ] {
        let out = folder.join(name);
        let said = |command: &str| {
            let done = run(&["apply", text(&cube), "--do", command, "-o", text(&out)]);
            assert_eq!(done.status.code(), Some(0));
            String::from_utf8(done.stderr).expect("text")
        };
        let renamed = said(r#"{"op":"rename-object","object":0,"name":"Wheel"}"#);
        assert_eq!(renamed.contains("the name \"Wheel\" is lost"), is_lost, "{name}: {renamed}");
        // An object that is named after its file loses nothing, whatever the output is called.
        let kept = said(r#"{"op":"poke-faces","faces":[0]}"#);
        assert!(!kept.contains("is lost"), "{name}: {kept}");
    }
}

/// Polygons that are drawn with the same cut: two pentagons round an edge whose ends both could join.
#[test]
fn polygons_become_triangles_that_form_a_mesh() {
    let folder = folder("triangles");
    // Two quads share two edges in a row, so that the first diagonal of both is the same.
    let model = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\nf 1 2 3 4\nf 3 2 1 5\nf 5 1 4 3\n";
    let file = write(&folder, "a.obj", model);
    for name in ["a.glb", "a.gltf", "a.stl"] {
        let out = folder.join(name);
        let [_, said] = convert(&file, &out);
        assert!(said.contains("polygons are cut into triangles"), "{said}");
        let back = json_of(&["info", text(&out), "--json"]);
        let texts = back["report"].to_string();
        assert_eq!(back["input"]["faces"], 6, "{name}: {texts}");
        assert_eq!(back["input"]["euler"], 2, "{name}: {texts}");
        assert!(!texts.contains("warning"), "{name}: {texts}");
    }
}

#[test]
fn text_stls_that_were_cut_off_are_named() {
    let folder = folder("cut");
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let whole = format!("solid a\n{facet}endsolid a\n");
    for (name, model, warns) in [
        ("whole.stl", whole.clone(), false),
        ("two.stl", format!("{whole}{}", whole.replace(" 0\n", " 5\n")), false),
        ("between.stl", format!("solid a\n{facet}"), true),
        ("second.stl", format!("{whole}solid b\n{}", facet.replace(" 0\n", " 5\n")), true),
        (
            "inside.stl",
            format!("solid a\n{facet}facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0"),
            true,
        ),
        ("loop.stl", format!("solid a\n{}", facet.replace("endfacet\n", "")), true),
    ] {
        let file = write(&folder, name, &model);
        let report = json_of(&["info", text(&file), "--json"])["report"].to_string();
        assert_eq!(report.contains("\"warning\""), warns, "{name}: {report}");
        assert_eq!(report.contains("cut off"), warns, "{name}: {report}");
    }
}

#[test]
fn files_of_others_are_not_replaced() {
    let folder = folder("others");
    write(&folder, "red.mtl", "newmtl red\nKd 1 0 0\n");
    let file = write(&folder, "a.obj", &format!("mtllib red.mtl\nusemtl red\n{CUBE}"));
    let theirs = write(&folder, "z.mtl", "newmtl theirs\n");
    let said = fails(&["convert", text(&file), text(&folder.join("z.obj"))], 2);
    assert!(said.contains("z.mtl exists but") && said.contains("Nothing was written"), "{said}");
    assert_eq!(std::fs::read_to_string(&theirs).expect("kept"), "newmtl theirs\n");
    assert!(!folder.join("z.obj").exists());
    // A model that is replaced takes its library along.
    write(&folder, "z.obj", "mtllib z.mtl\nv 0 0 0\n");
    convert(&file, &folder.join("z.obj"));
    assert!(std::fs::read_to_string(&theirs).expect("written").contains("newmtl red"));
    // And once more: the same files.
    convert(&file, &folder.join("z.obj"));
    // A file without materials needs no library, so that of others stays.
    std::fs::remove_file(folder.join("z.obj")).expect("there");
    let plain = write(&folder, "plain.obj", CUBE);
    convert(&plain, &folder.join("z.obj"));
    assert!(theirs.exists());
}

#[test]
fn wrong_usage_is_explained_in_plain_words() {
    let folder = folder("usage");
    let cube = write(&folder, "cube.obj", CUBE);
    let poke = r#"{"op":"poke-faces","faces":[0]}"#;
    for times in ["-1", "0", "x", "1.5"] {
        let said = fails(&["apply", text(&cube), "--do", poke, "--repeat", times], 2);
        assert!(said.contains(&format!("--repeat: {times} is not a whole number of 1 or more")), "{said}");
    }
    for distance in ["-1", "nan", "x"] {
        let said = fails(&["info", text(&cube), "--merge-by-distance", distance], 2);
        assert!(said.contains(&format!("--merge-by-distance: {distance} is not a number")), "{said}");
    }
    for command in ["{op:1}", "", "{\"op\":"] {
        let said = fails(&["apply", text(&cube), "--do", command], 2);
        assert!(said.contains("this is not JSON"), "{said}");
        assert!(!said.contains("EOF") && !said.contains("expected"), "{said}");
    }
    let said = fails(&["info", text(&write(&folder, "a.obj", "hello\n"))], 2);
    assert!(said.contains("it has no line for a vertex"), "{said}");
    let said =
        fails(&["info", text(&write(&folder, "a.gltf", &json!({"asset": {"version": ""}}).to_string()))], 2);
    assert!(said.contains("doesn't say which version of glTF it is"), "{said}");
    let nodes = json!({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}]}).to_string();
    let said = fails(&["info", text(&write(&folder, "b.gltf", &nodes))], 2);
    assert!(said.contains("The first fault: node 0 doesn't exist"), "{said}");
}
