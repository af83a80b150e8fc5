//! The program as users run it: its output, the files it writes and its exit codes.

mod common;

use common::*;
use serde_json::{Value, json};
use std::path::Path;

fixtures::shared_tests!(
    models_have_the_counts_that_their_table_says,
    models_go_through_operations_and_come_back
);

#[test]
fn info_counts() {
    let folder = folder("info");
    let cube = write(&folder, "cube.obj", CUBE);
    let answer = json_of(&["info", text(&cube), "--json"]);
    let counts = json!({"vertices": 8, "edges": 12, "halfedges": 24, "faces": 6,
        "boundary_loops": 0, "components": 1, "euler": 2});
    assert_eq!(answer["input"], counts);
    assert!(answer["read_seconds"].as_f64().expect("a time") >= 0.0);
    assert!(answer["build_seconds"].as_f64().expect("a time") >= 0.0);
    assert!(answer["report"].is_array());
    let keys: Vec<&String> = answer.as_object().expect("an object").keys().collect();
    assert_eq!(keys, ["build_seconds", "input", "read_seconds", "report"]);
    let printed = String::from_utf8(run(&["info", text(&cube)]).stdout).expect("text");
    assert!(printed.contains("faces                         6\n"), "{printed}");
    assert!(printed.contains("Euler characteristic          2\n"), "{printed}");
}

#[test]
fn apply_runs_steps_in_order_and_writes_the_result() {
    let folder = folder("apply");
    let cube = write(&folder, "cube.obj", CUBE);
    let out = folder.join("out.obj");
    let answer = json_of(&[
        "apply",
        text(&cube),
        "--do",
        r#"{"op":"split-edge","edge":[0,1],"connect":"none"}"#,
        "--do",
        r##"{"op":"set-face-color","faces":[0],"color":"#ff0000"}"##,
        "--do",
        r#"{"op":"subdivide-catmull-clark","levels":2}"#,
        "-o",
        text(&out),
        "--json",
        "--repeat",
        "3",
    ]);
    let steps = answer["steps"].as_array().expect("steps");
    let ops: Vec<&str> = steps.iter().map(|step| step["op"].as_str().expect("text")).collect();
    assert_eq!(ops, ["split-edge", "set-face-color", "subdivide-catmull-clark"]);
    assert!(steps.iter().all(|step| step["seconds"].as_f64().expect("a time") >= 0.0));
    assert_eq!(steps[0]["outcome"]["created"]["ids"]["vertices"], json!([8]));
    // Two pentagons among six faces: 26 corners, then four times as many.
    assert_eq!(answer["output"]["faces"], 26 * 4);
    assert_eq!(answer["input"]["faces"], 6);
    let again = json_of(&["info", text(&out), "--json"]);
    assert_eq!(again["input"], answer["output"]);
    assert!(folder.join("out.mtl").is_file(), "colors are written beside");
    let written = std::fs::read_to_string(&out).expect("written");
    assert!(
        written.contains("mtllib out.mtl"),
        "the first lines: {}",
        written.lines().next().unwrap_or_default()
    );
}

#[test]
fn convert_keeps_materials_and_writes_the_mesh_itself_as_json() {
    let folder = folder("convert");
    write(&folder, "paint.mtl", "newmtl red\nKd 1 0 0\n");
    let model = format!("mtllib paint.mtl\nusemtl red\n{CUBE}");
    let model = write(&folder, "cube.obj", &model);
    let out = folder.join("copy.obj");
    assert_eq!(run(&["convert", text(&model), text(&out)]).status.code(), Some(0));
    assert!(std::fs::read_to_string(folder.join("copy.mtl")).expect("written").contains("Kd 1"));

    let dump = folder.join("cube.json");
    assert_eq!(run(&["convert", text(&model), text(&dump)]).status.code(), Some(0));
    let dump: Value = serde_json::from_slice(&std::fs::read(dump).expect("written")).expect("JSON");
    let lengths =
        ["positions", "vertices", "halfedges", "edges", "faces"].map(|k| dump[k].as_array().expect(k).len());
    assert_eq!(lengths, [8, 8, 24, 12, 6]);
    for (h, row) in dump["halfedges"].as_array().expect("rows").iter().enumerate() {
        let at = |i: usize| row[i].as_u64().expect("an id") as usize;
        let (next, twin) = (at(0), at(2));
        assert_eq!(dump["halfedges"][next][1], h, "prev of next");
        assert_eq!(dump["halfedges"][twin][2], h, "twin of twin");
        assert_ne!(dump["halfedges"][twin][3], row[3], "the two sides point to the two ends");
    }
}

#[test]
fn convert_takes_images_along_and_overwrites_no_other_file() {
    let folder = folder("images");
    let out = folder.join("out");
    std::fs::create_dir_all(folder.join("in/sub/tex")).expect("a folder");
    std::fs::create_dir_all(&out).expect("a folder");
    let _ = std::fs::remove_dir_all(out.join("tex"));
    write(&folder, "in/sub/paint.mtl", "newmtl red\nKd 1 0 0\nmap_Kd tex/red.png\nbump bumps.png\n");
    write(&folder, "in/sub/tex/red.png", "red");
    write(&folder, "in/sub/bumps.png", "bumps");
    let model = write(&folder, "in/cube.obj", &format!("mtllib sub/paint.mtl\nusemtl red\n{CUBE}"));
    write(&folder, "out/bumps.png", "another model's");
    let done = run(&["convert", text(&model), text(&out.join("copy.obj"))]);
    assert_eq!(done.status.code(), Some(0));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect(name);
    assert!(read("copy.mtl").contains("map_Kd tex/red.png\nbump bumps.png\n"));
    assert_eq!([read("tex/red.png"), read("bumps.png")], ["red", "another model's"]);
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(said.contains("bumps.png: not written: a different file"), "{said}");
}

#[test]
fn a_format_can_be_chosen_whatever_the_extension() {
    let folder = folder("format");
    let cube = write(&folder, "cube.obj", CUBE);
    let out = folder.join("cube.ply");
    let start = |path: &Path| {
        let bytes = std::fs::read(path).expect("written");
        String::from_utf8_lossy(&bytes[..20]).into_owned()
    };
    assert_eq!(run(&["convert", text(&cube), text(&out)]).status.code(), Some(0));
    assert_eq!(start(&out), "ply\nformat binary_li");
    assert_eq!(run(&["convert", text(&cube), text(&out), "--format", "ply-text"]).status.code(), Some(0));
    assert_eq!(start(&out), "ply\nformat ascii 1.0");
    let op = r#"{"op":"triangulate-faces"}"#;
    let stl = ["apply", text(&cube), "--do", op, "-o", text(&out), "--format", "stl-text"];
    assert_eq!(run(&stl).status.code(), Some(0));
    assert!(start(&out).starts_with("solid "), "{}", start(&out));
}

#[test]
fn files_are_replaced_only_when_all_are_written() {
    let folder = folder("replaced");
    let cube = write(&folder, "cube.obj", &format!("mtllib cube.mtl\nusemtl red\n{CUBE}"));
    write(&folder, "cube.mtl", "newmtl red\nKd 1 0 0\n");
    let old = write(&folder, "out.obj", "v 1 2 3\n");
    // The material library can't be written where a folder has its name.
    std::fs::create_dir(folder.join("out.mtl")).expect("a folder");
    let output = run(&["convert", text(&cube), text(&old)]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("out.mtl can't be written"));
    assert_eq!(std::fs::read_to_string(&old).expect("still there"), "v 1 2 3\n");
    std::fs::remove_dir(folder.join("out.mtl")).expect("the folder");
    assert_eq!(run(&["convert", text(&cube), text(&old)]).status.code(), Some(0));
    let mut names: Vec<_> = std::fs::read_dir(&folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("text"))
        .collect();
    names.sort();
    assert_eq!(names, ["cube.mtl", "cube.obj", "out.mtl", "out.obj"], "no temporary files are left");
}

#[test]
fn refused_commands_exit_with_1_and_write_nothing() {
    let folder = folder("refused");
    let cube = write(&folder, "cube.obj", CUBE);
    let out = folder.join("out.obj");
    for (command, parts) in [
        (r#"{"op":"explode"}"#, ["explode", "no such op"]),
        (r#"{"op":"split-edge","edge":99}"#, ["`edge`", "no edge 99"]),
        (r#"{"op":"split-edge"}"#, ["`edge`", "missing"]),
        (r#"{"op":"subdivide-loop"}"#, ["subdivide-loop", "triangles"]),
        (r#"{"op":"split-edge","edge":0,"speed":3}"#, ["`speed`", "not a field"]),
        (r#"{"op":"subdivide-linear","object":1}"#, ["`object`", "no object 1"]),
        (r#"{"op":"subdivide-linear","levels":30}"#, ["`levels`", "from 1 to 12"]),
        (r#"{"op":"subdivide-linear","levels":12}"#, ["`levels`", "faces"]),
    ] {
        // After a step that succeeds.
        let first = r#"{"op":"subdivide-linear"}"#;
        let error =
            fails(&["apply", text(&cube), "--do", first, "--do", command, "-o", text(&out), "--json"], 1);
        for part in parts {
            assert!(error.contains(part), "{command}: {error}");
        }
        assert!(!out.exists(), "{command}");
    }
}

#[test]
fn bad_usage_and_unreadable_files_exit_with_2() {
    let folder = folder("usage");
    let cube = write(&folder, "cube.obj", CUBE);
    let cube = text(&cube);
    let broken = write(&folder, "broken.obj", "this is not a model\n");
    let missing = folder.join("missing.obj");
    let op = r#"{"op":"triangulate-faces"}"#;
    for (args, part) in [
        (vec![], "The task is missing"),
        (vec!["explode"], "explode"),
        (vec!["info"], "FILE is missing"),
        (vec!["info", cube, cube], "Unexpected argument"),
        (vec!["info", cube, "--do", op], "--do"),
        (vec!["info", cube, "--repeat", "2"], "--repeat"),
        (vec!["info", cube, "--verbose"], "--verbose"),
        (vec!["convert", cube], "OUT is missing"),
        (
            vec!["convert", cube, "out.unknown"],
            "out.unknown: the extension names no format that can be written; use one of .meshwright, .obj, .ply, .stl, ",
        ),
        (vec!["convert", cube, "out.obj", "--json"], "--json"),
        (vec!["info", cube, "--format", "ply"], "--format can't be used with `info`"),
        (vec!["apply", cube, "--do", op, "--format", "ply"], "--format without -o"),
        (
            vec!["convert", cube, "out.ply", "--format", "doc"],
            "the codes are meshwright, obj, ply, ply-text, stl, ",
        ),
        (vec!["apply", cube], "--do"),
        (vec!["apply", cube, "--do"], "--do"),
        (vec!["apply", cube, "--do", "split"], "not JSON"),
        (vec!["apply", cube, "--do", op, "--repeat", "0"], "--repeat"),
        (vec!["apply", cube, "--do", op, "--repeat", "x"], "x"),
        (vec!["apply", cube, "--do", op, "-o", "out"], "out"),
        (vec!["info", text(&missing)], "missing.obj"),
        (vec!["info", text(&broken)], "broken.obj"),
        (vec!["info", text(&folder)], "usage"),
        (vec!["convert", cube, "/nowhere/at/all.obj"], "/nowhere/at/all.obj"),
    ] {
        let error = fails(&args, 2);
        assert!(error.contains(part), "{args:?}: {error}");
    }
}

#[test]
fn warnings_of_an_operation_are_printed() {
    let folder = folder("warnings");
    let cube = write(&folder, "cube.obj", CUBE);
    let output = run(&["apply", text(&cube), "--do", r#"{"op":"simplify","faces":2}"#]);
    assert_eq!(output.status.code(), Some(0));
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(told.contains("simplify: stopped at 4 triangles, not 2"), "{told}");
}

#[test]
fn help_and_version() {
    for (option, part) in
        [("--help", "meshwright apply"), ("-h", "--repeat N"), ("--version", env!("CARGO_PKG_VERSION"))]
    {
        let output = run(&[option]);
        assert_eq!(output.status.code(), Some(0));
        assert!(String::from_utf8_lossy(&output.stdout).contains(part));
    }
}

#[test]
fn help_lists_operations_and_describes_fields() {
    let help = run(&["--help"]).stdout;
    assert_eq!(run(&["help"]).stdout, help);
    let help = String::from_utf8_lossy(&help);
    for id in editor::OpId::ALL {
        assert!(help.contains(&format!("\n  {} ", id.spec().name)), "{}", id.spec().name);
    }
    let output = run(&["help", "split-edge"]);
    assert_eq!(output.status.code(), Some(0));
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(
        told.starts_with("split-edge: ") && told.contains("a number above 0 and below 1; default: 0.5"),
        "{told}"
    );
    for arguments in [&["help", "splice"][..], &["help", "split-edge", "more"], &["help", "--json"]] {
        assert_eq!(run(arguments).status.code(), Some(2), "{arguments:?}");
    }
}

#[test]
fn open_and_export_are_not_operations() {
    let folder = folder("no-operations");
    let cube = write(&folder, "cube.obj", CUBE);
    for (command, part) in [
        (r#"{"op":"open"}"#, "name the input file as the first argument of apply instead"),
        (r#"{"op":"export"}"#, "name the output file with -o instead"),
    ] {
        let output = run(&["apply", text(&cube), "--do", command]);
        assert_eq!(output.status.code(), Some(1));
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(told.contains("is not an operation; ") && told.contains(part), "{told}");
    }
}

/// The table of `../shared/models/README.md`: V, F, boundary edges, non-manifold edges, note.
fn models_have_the_counts_that_their_table_says() {
    let models = fixtures::shared("models");
    let table = std::fs::read_to_string(models.join("README.md")).expect("a table");
    let mut checked = 0;
    for line in table.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, file, v, f, boundary, non_manifold, note, _] = cells.as_slice() else { continue };
        let (Ok(v), Ok(f), Ok(boundary)) = (v.parse::<u64>(), f.parse::<u64>(), boundary.parse::<u64>())
        else {
            continue;
        };
        let path = models.join("common").join(file.trim_matches('`'));
        let answer = json_of(&["info", text(&path), "--json"]);
        let input = &answer["input"];
        assert_eq!(input["faces"], f, "{file}");
        let count = |key: &str| input[key].as_u64().expect("a count");
        if *non_manifold == "0" && !note.contains("non-manifold") {
            assert_eq!(count("vertices"), v, "{file}");
            assert_eq!(count("boundary_loops") == 0, boundary == 0, "{file}");
        } else {
            assert!(count("vertices") >= v, "{file}: vertices are separated, not lost");
        }
        assert_eq!(count("halfedges"), 2 * count("edges"));
        checked += 1;
    }
    assert_eq!(checked, 10);
}

fn models_go_through_operations_and_come_back() {
    let models = fixtures::shared("models/common");
    let folder = folder("models");
    for (name, op, faces) in [
        ("spot_control_mesh.obj", r#"{"op":"subdivide-catmull-clark"}"#, None),
        ("spot.obj", r#"{"op":"subdivide-loop"}"#, Some(5856 * 4)),
        ("spot_quadrangulated.obj", r#"{"op":"triangulate-faces"}"#, Some(5856)),
    ] {
        let out = folder.join(name);
        let model = models.join(name);
        let answer = json_of(&["apply", text(&model), "--do", op, "-o", text(&out), "--json"]);
        if let Some(faces) = faces {
            assert_eq!(answer["output"]["faces"], faces, "{name}");
        }
        let again = json_of(&["info", text(&out), "--json"]);
        assert_eq!(again["input"], answer["output"], "{name}");
    }
}

#[test]
fn bezier_files_tessellate_and_convert() {
    let folder = folder("bezier");
    let mut patch = "1\n".to_owned();
    for row in 0..4 {
        (0..4).for_each(|column| patch += &format!("{column} {row} {} ", column * row));
    }
    let surface = write(&folder, "saddle.bez", &patch);
    let curve = write(&folder, "curve.bzc", "3\n0 0 1 1 2 0\n");

    let answer = json_of(&["info", text(&surface), "--json"]);
    assert_eq!(answer["input"]["faces"], 64);
    assert_eq!(answer["report"][0]["text"], "Read a Bezier surface of 1 patch as BEZ");
    let answer = json_of(&["info", text(&curve), "--json"]);
    assert_eq!(answer["input"]["vertices"], 0);
    assert_eq!(answer["report"][0]["text"], "Read a Bezier curve of 3 control points as BZC");

    let mesh = folder.join("saddle.obj");
    let command = r#"{"op":"bezier-tessellate","resolution":10}"#;
    let answer = json_of(&["apply", text(&surface), "--do", command, "-o", text(&mesh), "--json"]);
    assert_eq!(answer["output"]["faces"], 100);
    let saved = json_of(&["info", text(&mesh), "--json"]);
    assert_eq!((&saved["input"]["vertices"], &saved["input"]["faces"]), (&json!(121), &json!(100)));

    let again = folder.join("again.bez");
    assert_eq!(run(&["convert", text(&surface), text(&again)]).status.code(), Some(0));
    let numbers = |path: &Path| -> Vec<f32> {
        let text = std::fs::read_to_string(path).expect("text");
        text.split_whitespace().map(|word| word.parse().expect("a number")).collect()
    };
    assert_eq!(numbers(&again), numbers(&surface));
    assert!(fails(&["convert", text(&curve), text(&mesh)], 2).contains("save it as BZC"));
    assert!(fails(&["apply", text(&curve), "--do", command], 1).contains("bounds no faces"));
    let wrong = write(&folder, "wrong.bez", "1\n1 2\n3 x");
    assert!(fails(&["info", text(&wrong)], 2).contains("wrong.bez. Line 3: “x” is not a number"));
}

/// Three triangles at one edge, of which two disagree.
const FIN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";

#[test]
fn repairs_are_chosen_on_the_command_line() {
    let folder = folder("repairs");
    let fin = write(&folder, "fin.obj", FIN);
    let faces = |more: &[&str]| {
        let args = [&["info", text(&fin), "--json"][..], more].concat();
        let counts = json_of(&args)["input"].clone();
        (counts["faces"].clone(), counts["components"].clone())
    };
    assert_eq!(faces(&[]), (json!(3), json!(3)));
    assert_eq!(faces(&["--non-manifold", "drop"]), (json!(2), json!(2)));
    assert_eq!(faces(&["--non-manifold", "drop", "--no-orient"]), (json!(2), json!(3)));
    assert_eq!(faces(&["--merge-by-distance", "9"]).0, json!(0));
    let drop = r#"{"op":"repair-import","non_manifold":"drop"}"#;
    let answer = json_of(&["apply", text(&fin), "--do", drop, "--json"]);
    assert_eq!(answer["output"]["faces"], 2);
    let cube = write(&folder, "cube.obj", CUBE);
    assert!(
        fails(&["apply", text(&cube), "--do", drop], 1).contains("nothing was repaired when cube was read")
    );
    assert!(
        fails(&["info", text(&fin), "--non-manifold", "keep"], 2).contains("keep is not separate or drop")
    );
    assert!(fails(&["info", text(&fin), "--merge-by-distance", "-1"], 2).contains("--merge-by-distance"));
}

#[test]
fn files_beside_a_model_are_found() {
    let folder = folder("beside");
    let cube = write(&folder, "cube.obj", &format!("mtllib my colors.mtl\nusemtl red\n{CUBE}"));
    write(&folder, "my colors.mtl", "newmtl red\nKd 1 0 0\n");
    let gltf = folder.join("a b.gltf");
    assert_eq!(run(&["convert", text(&cube), text(&gltf)]).status.code(), Some(0));
    assert!(folder.join("a b.bin").is_file());
    let answer = json_of(&["info", text(&gltf), "--json"]);
    assert_eq!((&answer["input"]["faces"], &answer["input"]["components"]), (&json!(12), &json!(1)));
    let dae = folder.join("cube.dae");
    assert_eq!(run(&["convert", text(&gltf), text(&dae)]).status.code(), Some(0));
    assert!(
        std::fs::read_to_string(&dae).expect("text").contains("<color>1 0 0 1</color>"),
        "the material's colour"
    );
    std::fs::remove_file(folder.join("a b.bin")).expect("there");
    assert!(fails(&["info", text(&gltf)], 2).contains("Open it together with a b.bin, which"));
}

#[test]
fn coordinates_far_from_the_origin_keep_their_digits() {
    let folder = folder("far");
    let roof = "v 4458321.123 5412000.004 12.5\nv 4458323.125 5412000.011 12.25\nv 4458322.12 5412001.006 13\nf 1 2 3\n";
    let input = write(&folder, "roof.obj", roof);
    let output = folder.join("out.off");
    let subdivide = r#"{"op":"subdivide-linear"}"#;
    assert_eq!(run(&["apply", text(&input), "--do", subdivide, "-o", text(&output)]).status.code(), Some(0));
    let written = std::fs::read_to_string(&output).expect("text");
    let first: Vec<f64> =
        written.lines().nth(2).expect("a vertex").split(' ').filter_map(|word| word.parse().ok()).collect();
    assert!((first[0] - 4_458_321.123).abs() < 2e-7 && (first[1] - 5_412_000.004).abs() < 2e-7, "{first:?}");
}

#[test]
fn projects_are_read_written_and_described() {
    let folder = folder("project");
    let cube = write(&folder, "cube.obj", CUBE);
    let project = folder.join("box.meshwright");
    let steps = ["--do", r#"{"op":"poke-faces","faces":[0]}"#, "--do", r#"{"op":"hide","faces":[1]}"#];
    let apply = [&["apply", text(&cube)], &steps[..], &["-o", text(&project), "--json"]].concat();
    assert_eq!(json_of(&apply)["output"]["faces"], 9);
    let answer = json_of(&["info", text(&project), "--json"]);
    assert_eq!(answer["input"]["faces"], 9);
    assert_eq!(answer["project"]["history"], 2, "what was done since the cube was opened");
    assert_eq!(answer["project"]["objects"][0]["hidden_faces"], 1);
    let printed = String::from_utf8(run(&["info", text(&project)]).stdout).expect("text");
    assert!(printed.contains("hidden faces                  1\n"), "{printed}");
    assert!(printed.contains("Read a project saved by Meshwright 0.1.0\n"), "{printed}");

    let copy = folder.join("copy.meshwright");
    assert_eq!(run(&["convert", text(&project), text(&copy)]).status.code(), Some(0));
    let again = json_of(&["info", text(&copy), "--json"]);
    assert_eq!((&again["project"], &again["input"]), (&answer["project"], &answer["input"]));
    let model = folder.join("model.obj");
    assert_eq!(run(&["convert", text(&project), text(&model)]).status.code(), Some(0));
    assert_eq!(json_of(&["info", text(&model), "--json"])["input"], answer["input"]);

    let mut damaged = std::fs::read(&project).expect("written");
    damaged.truncate(200);
    std::fs::write(&project, damaged).expect("writable");
    let refused = run(&["convert", text(&project), text(&folder.join("never.meshwright"))]);
    assert_eq!(refused.status.code(), Some(2));
    let why = String::from_utf8(refused.stderr).expect("text");
    assert!(why.starts_with("Could not open box.meshwright. It is incomplete"), "{why}");
    assert!(!folder.join("never.meshwright").exists());
}
