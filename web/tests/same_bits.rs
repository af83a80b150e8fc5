//! The same meshes, to the bit, natively and in WebAssembly. This file runs in both; its expected values
//! were computed once.

use std::ops::ControlFlow;

use editor::{Command, Editor};
use formats::NamedBytes;
use halfedge::Mesh;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[cfg(target_arch = "wasm32")]
wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);

/// A slanted box with a triangulated lid that is open on one side: quads, triangles, a boundary,
/// and numbers with all their bits in use.
const OBJ: &str = "\
v 0.1 -0.2 0.3
v 1.7 0.05 -0.13
v 1.93 1.41 0.27
v -0.11 1.3 0.77
v 0.21 -0.37 1.9
v 1.57 0.111 2.3
v 2.03 1.23 1.87
v -0.07 1.61 2.19
f 4 3 2 1
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 5 6 7
f 5 7 8
";

fn opened() -> Editor {
    let mut editor = Editor::new();
    let files = vec![NamedBytes { name: "box.obj".to_owned(), bytes: OBJ.into() }];
    let import = formats::read(&files, &mut |_| ControlFlow::Continue(())).unwrap();
    editor.open(import).unwrap();
    editor
}

/// FNV-1a over the bits of the positions and the links of every half-edge, in order.
fn hash(mesh: &Mesh) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut add = |word: u32| {
        for byte in word.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    };
    for vertex in mesh.vertices() {
        for x in mesh.position(vertex).to_array() {
            add(x.to_bits());
        }
    }
    for halfedge in mesh.halfedges() {
        add(mesh.next(halfedge).raw());
        add(mesh.to(halfedge).raw());
    }
    hash
}

fn after(commands: &[&str]) -> (usize, u64) {
    let mut editor = opened();
    for command in commands {
        editor.run(Command::from_json(command).unwrap()).unwrap();
    }
    let mesh = editor.mesh().unwrap();
    mesh.validate().unwrap();
    (mesh.face_count(), hash(mesh))
}

#[test]
fn catmull_clark() {
    assert_eq!(after(&[r#"{"op": "subdivide-catmull-clark", "levels": 4}"#]), (1408, 0xa169_dea9_ab03_b4f2));
}

#[test]
fn catmull_clark_with_sharp_corners() {
    let command = r#"{"op": "subdivide-catmull-clark", "levels": 3, "boundary": "edge-and-corner"}"#;
    assert_eq!(after(&[command]), (352, 0xcbdd_03b5_c86c_aac6));
}

#[test]
fn loop_on_triangles() {
    let commands = [r#"{"op": "triangulate-faces"}"#, r#"{"op": "subdivide-loop", "levels": 4}"#];
    assert_eq!(after(&commands), (2560, 0x2d29_fcca_7fde_9df0));
}

/// The open box with enough triangles to work on.
const FINE: [&str; 2] = [r#"{"op": "triangulate-faces"}"#, r#"{"op": "subdivide-loop", "levels": 3}"#];

#[test]
fn simplified() {
    let [triangles, fine] = FINE;
    assert_eq!(
        after(&[triangles, fine, r#"{"op": "simplify", "ratio": 0.2}"#]),
        (128, 0xc8e4_9a52_ae4f_1daa)
    );
    let command = r#"{"op": "simplify", "max_error": 0.02, "preserve_boundary": false}"#;
    assert_eq!(after(&[triangles, fine, command]), (126, 0x7037_b221_0bc8_3265));
}

#[test]
fn remeshed() {
    assert_eq!(
        after(&[r#"{"op": "remesh", "edge_length": 0.2, "iterations": 10}"#]),
        (882, 0x4b90_be18_807c_9646)
    );
}

#[test]
fn smoothed() {
    let [triangles, fine] = FINE;
    let laplacian = r#"{"op": "smooth", "iterations": 5}"#;
    let taubin = r#"{"op": "smooth", "iterations": 5, "method": "taubin"}"#;
    assert_eq!(after(&[triangles, fine, laplacian, taubin]), (640, 0x3d44_d22d_024e_e719));
}

#[test]
fn split_without_smoothing_and_merged() {
    let commands =
        [r#"{"op": "subdivide-linear", "levels": 3}"#, r#"{"op": "merge-by-distance", "distance": 0.15}"#];
    assert_eq!(after(&commands), (330, 0x55ac_4470_7fc6_4dd6));
}

#[test]
fn creased() {
    let commands = [
        r#"{"op": "set-crease", "edges": [0, 1, 2, 3, 4], "vertices": [5], "sharpness": 1.7}"#,
        r#"{"op": "subdivide-catmull-clark", "levels": 3}"#,
    ];
    assert_eq!(after(&commands), (352, 0xcfed_d729_aaf4_7c14));
}

#[test]
fn edited() {
    let commands = [
        r#"{"op": "extrude-faces", "faces": [1, 2], "distance": 0.3}"#,
        r#"{"op": "inset-faces", "faces": [3], "amount": 0.1}"#,
        r#"{"op": "bevel-edges", "edges": [0], "width": 0.1, "segments": 3}"#,
        r#"{"op": "transform", "vertices": [0, 1], "rotate": {"axis": [1, 2, 3], "degrees": 33}, "falloff": 1.5}"#,
        r#"{"op": "triangulate-faces", "method": "ear"}"#,
    ];
    assert_eq!(after(&commands), (43, 0x25c2_22ac_2357_766d));
}

#[test]
fn shapes() {
    for (shape, expected) in [
        ("uv-sphere", (512, 0x73f2_efb7_2829_fbc1)),
        ("torus", (1152, 0x11f7_9c71_50f0_7869)),
        ("dodecahedron", (12, 0x561d_9106_24e6_50c5)),
        ("teapot", (2048, 0x0b4c_f9ba_1a74_264a)),
    ] {
        let command = format!(r#"{{"op": "new", "shape": "{shape}"}}"#);
        assert_eq!(after(&[&command]), expected, "{shape}");
    }
}
