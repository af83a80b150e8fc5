//! Symmetry: a mesh that is its own mirror image to the bit stays so, whatever is edited.

mod support;

use editor::halfedge::{Element, Mesh, VertexId};
use editor::{Editor, MessageKind, OpId, Scope, SelectMode};
use glam::Vec3;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::collections::{HashMap, HashSet};
use support::*;

/// Shapes that are their own mirror images across x = 0 and z = 0.
const SHAPES: [&str; 4] = ["cube", "grid", "torus", "quads"];
const AXES: [&str; 3] = ["x", "y", "z"];

/// A shape, moved so that each vertex and its mirror image agree to the bit.
fn make_symmetric(shape: &str, axis: usize) -> Mesh {
    let mut editor = Editor::new();
    match shape {
        // An upright strip of quads and triangles with a boundary, beside the plane and through it.
        "quads" => {
            let xs = [-2.0, -1.25, -0.5, 0.0, 0.5, 1.25, 2.0];
            let at = |x: f32, y: usize| {
                let out = [x, y as f32 * 0.75, 0.3 * x * x - 0.1 * y as f32];
                let mut turned = out;
                turned.rotate_right(axis);
                Vec3::from(turned)
            };
            let positions = (0..4).flat_map(|y| xs.map(|x| at(x, y))).collect();
            let faces: Vec<Vec<u32>> = (0..3u32)
                .flat_map(|y| (0..6u32).map(move |x| y * 7 + x))
                .map(|a| vec![a, a + 1, a + 8, a + 7])
                .collect();
            editor = Editor::with_mesh("Quads", build(positions, &faces));
        }
        _ => drop(run(&mut editor, json!({"op": "new", "shape": shape}))),
    }
    let mut mesh = editor.mesh().expect("a mesh").clone();
    let near = |mesh: &Mesh, at: Vec3| {
        let distance = |v: &VertexId| mesh.position(*v).distance_squared(at);
        mesh.vertices().min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a vertex")
    };
    let all: Vec<VertexId> = mesh.vertices().collect();
    for v in all {
        let mut at = mesh.position(v);
        let image = near(&mesh, mirror(at, axis));
        if image == v {
            at[axis] = 0.0;
        } else if at[axis] < 0.0 {
            at = mirror(mesh.position(image), axis);
        }
        mesh.set_position(v, at);
    }
    assert_symmetric(&mesh, axis, shape);
    mesh
}

/// The symmetric meshes, made once.
fn symmetric(shape: &str, axis: usize) -> Editor {
    static MADE: std::sync::Mutex<Option<HashMap<(String, usize), Mesh>>> = std::sync::Mutex::new(None);
    let mut made = MADE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let made = made.get_or_insert_default().entry((shape.to_owned(), axis));
    Editor::with_mesh("Mesh", made.or_insert_with(|| make_symmetric(shape, axis)).clone())
}

fn mirror(mut at: Vec3, axis: usize) -> Vec3 {
    at[axis] = -at[axis];
    at
}

/// Positions and faces are their own mirror images to the bit.
fn assert_symmetric(mesh: &Mesh, axis: usize, what: &str) {
    // Zero has two signs.
    let bits = |at: Vec3| (at + Vec3::ZERO).to_array().map(f32::to_bits);
    let place = |v: VertexId| bits(mesh.position(v));
    let image = |v: VertexId| bits(mirror(mesh.position(v), axis));
    let mut count: HashMap<[u32; 3], i64> = HashMap::new();
    for v in mesh.vertices() {
        *count.entry(place(v)).or_default() += 1;
        *count.entry(image(v)).or_default() -= 1;
    }
    let odd: Vec<Vec3> =
        mesh.vertices().filter(|v| count[&place(*v)] != 0).map(|v| mesh.position(v)).collect();
    assert_eq!(odd, Vec::<Vec3>::new(), "{what}: positions without a mirror image");
    // A face as the places of its corners, from the least one on, counter-clockwise.
    let from_least = |mut corners: Vec<[u32; 3]>| {
        let least = (0..corners.len()).min_by_key(|at| {
            let mut turned = corners.clone();
            turned.rotate_left(*at);
            turned
        });
        corners.rotate_left(least.unwrap_or(0));
        corners
    };
    let mut faces: HashMap<Vec<[u32; 3]>, i64> = HashMap::new();
    for f in mesh.faces() {
        *faces.entry(from_least(mesh.face_vertices(f).map(place).collect())).or_default() += 1;
        let mut corners: Vec<[u32; 3]> = mesh.face_vertices(f).map(image).collect();
        corners.reverse();
        *faces.entry(from_least(corners)).or_default() -= 1;
    }
    let odd = faces.values().filter(|count| **count != 0).count();
    assert_eq!(odd, 0, "{what}: faces without a mirror image");
}

/// An operation on chosen elements, with amounts; none where the mesh has no such elements.
fn command_of(id: OpId, mesh: &Mesh, picks: &[u32], amount: f32) -> Option<Value> {
    let pick = |element: Element, at: usize| {
        let all: Vec<u32> = match element {
            Element::Vertex => mesh.vertices().map(|v| v.raw()).collect(),
            Element::Edge => mesh.edges().map(|e| e.raw()).collect(),
            Element::Halfedge => mesh
                .edges()
                .flat_map(|e| e.halfedges())
                .filter(|h| mesh.is_boundary_halfedge(*h))
                .map(|h| h.raw())
                .collect(),
            Element::Face => mesh.faces().map(|f| f.raw()).collect(),
        };
        all.get(*picks.get(at)? as usize % all.len().max(1)).copied()
    };
    let many = |element: Element| {
        let mut all: Vec<u32> = (0..picks.len()).filter_map(|at| pick(element, at)).collect();
        all.sort_unstable();
        all.dedup();
        (!all.is_empty()).then_some(all)
    };
    let offset = [amount, 0.5 - amount, amount * 0.5];
    Some(match id {
        OpId::SetVertexPosition => json!({"vertex": pick(Element::Vertex, 0)?, "position": offset}),
        OpId::Transform => {
            json!({"edges": many(Element::Edge)?, "translate": offset, "rotate": {"axis": [1, 2, 3], "degrees": 20.0 * amount}})
        }
        OpId::SetFaceColor => json!({"faces": many(Element::Face)?, "color": "#10a0c8"}),
        OpId::SplitEdge => json!({"edge": pick(Element::Edge, 0)?, "t": 0.1 + 0.8 * amount}),
        OpId::FlipEdge => json!({"edge": pick(Element::Edge, 0)?}),
        OpId::CollapseEdge => json!({"edge": pick(Element::Edge, 0)?, "t": amount}),
        OpId::CollapseFace => json!({"face": pick(Element::Face, 0)?}),
        OpId::DissolveVertex => json!({"vertices": [pick(Element::Vertex, 0)?]}),
        OpId::DissolveEdge => json!({"edges": many(Element::Edge)?}),
        OpId::DeleteFaces => json!({"faces": many(Element::Face)?}),
        OpId::DeleteVertices => json!({"vertices": many(Element::Vertex)?}),
        OpId::TriangulateFaces => json!({"faces": many(Element::Face)?}),
        OpId::PokeFaces => json!({"faces": many(Element::Face)?}),
        OpId::ConnectVertices => {
            let face = mesh.face(pick(Element::Face, 0)?)?;
            let corners: Vec<u32> = mesh.face_vertices(face).map(|v| v.raw()).collect();
            let at = picks[0] as usize % corners.len();
            json!({"vertices": [corners[at], corners[(at + 2) % corners.len()]]})
        }
        OpId::ExtrudeFaces => {
            json!({"faces": many(Element::Face)?, "distance": amount, "mode": if amount < 0.5 { "region" } else { "individual" }})
        }
        OpId::ExtrudeEdges => {
            let boundary: Vec<u32> = (0..picks.len())
                .filter_map(|at| Some(mesh.halfedge(pick(Element::Halfedge, at)?)?.edge().raw()))
                .collect();
            json!({"edges": (!boundary.is_empty()).then_some(boundary)?, "offset": offset})
        }
        OpId::InsetFaces => json!({"faces": many(Element::Face)?, "amount": 0.2 * amount}),
        OpId::BevelEdges => json!({"edges": many(Element::Edge)?, "width": 0.2 * amount, "segments": 2}),
        OpId::BevelVertices => json!({"vertices": many(Element::Vertex)?, "width": 0.2 * amount}),
        OpId::LoopCut => {
            json!({"edge": pick(Element::Edge, 0)?, "cuts": 1 + picks[0] % 3, "t": 0.2 + 0.6 * amount})
        }
        OpId::SlideEdges => json!({"edges": [pick(Element::Edge, 0)?], "amount": amount * 1.5 - 0.75}),
        OpId::SlideVertices => {
            json!({"vertices": many(Element::Vertex)?, "direction": offset, "amount": amount})
        }
        OpId::FillHole => json!({"halfedge": pick(Element::Halfedge, 0)?}),
        OpId::MergeVertices => json!({"vertices": many(Element::Vertex)?}),
        OpId::WeldEdges | OpId::Bridge => return None,
        OpId::SplitVertex => {
            let v = mesh.vertex(pick(Element::Vertex, 0)?)?;
            let edges: Vec<u32> = mesh.outgoing(v).map(|h| h.edge().raw()).collect();
            let [a, b] = [picks[0], picks[0] + 1 + amount as u32].map(|at| edges[at as usize % edges.len()]);
            json!({"vertex": v.raw(), "edges": [a, b]})
        }
        OpId::RipEdges => json!({"edges": many(Element::Edge)?}),
        OpId::FlipOrientation => json!({"faces": many(Element::Face)?}),
        OpId::SetCrease => json!({"edges": many(Element::Edge)?, "sharpness": amount}),
        other => panic!("{} is an operation on elements that this test doesn't know", other.spec().name),
    })
}

/// Whether vertices share a place, as where a deleted face has left a bow-tie.
fn has_doubles(mesh: &Mesh) -> bool {
    let mut places = HashSet::new();
    !mesh.vertices().all(|v| places.insert((mesh.position(v) + Vec3::ZERO).to_array().map(f32::to_bits)))
}

fn operations() -> Vec<OpId> {
    OpId::ALL.iter().copied().filter(|id| id.spec().scope == Scope::Elements).collect()
}

#[test]
fn every_operation_on_elements_can_be_mirrored() {
    for id in operations() {
        assert!(id.spec().field("symmetry").is_some(), "{}", id.spec().name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn symmetric_meshes_stay_symmetric(
        shape in 0..SHAPES.len(),
        axis in 0..3usize,
        steps in prop::collection::vec((any::<prop::sample::Index>(), prop::collection::vec(0..10_000u32, 1..4), 0.0f32..1.0), 1..4),
    ) {
        // The strip has one plane of symmetry, the grid lies in y = 0.
        let axis = if SHAPES[shape] == "grid" && axis == 1 { 0 } else { axis };
        let mut editor = symmetric(SHAPES[shape], axis);
        for (step, (op, picks, amount)) in steps.into_iter().enumerate() {
            let ids = operations();
            let id = ids[op.index(ids.len())];
            let mesh = editor.mesh().expect("a mesh").clone();
            let Some(mut fields) = command_of(id, &mesh, &picks, amount) else { continue };
            // After other edits, rings may cross each other and two faces may share two corners.
            if step > 0 && matches!(id, OpId::LoopCut | OpId::ConnectVertices) {
                continue;
            }
            fields["op"] = id.spec().name.into();
            fields["symmetry"] = AXES[axis].into();
            let what = format!("{} of {fields}", SHAPES[shape]);
            let before = editor.document().clone();
            let outcome = match editor.run(command(fields.clone())) {
                Ok(outcome) => outcome,
                Err(_) => {
                    prop_assert_eq!(editor.document(), &before, "{} was refused and changed something", what);
                    continue;
                }
            };
            validate(&editor);
            let after = editor.mesh().expect("a mesh").clone();
            prop_assert!(!outcome.warnings.iter().any(|note| note.contains("left out")), "{}: {:?}", what, outcome.warnings);
            assert_symmetric(&after, axis, &what);
            // Undo is exact, and the same command gives the same mesh.
            if editor.undo_labels().count() > 0 && after != mesh {
                editor.undo().expect("a step");
                prop_assert_eq!(editor.mesh().expect("a mesh"), &mesh, "{}", &what);
                editor.run(command(fields)).expect("again");
                prop_assert_eq!(editor.mesh().expect("a mesh"), &after, "{}", &what);
            }
            // Of several vertices at one place it can't be said which is whose image.
            if has_doubles(&after) {
                break;
            }
        }
    }

    /// Updates of an edit that follows the pointer give what the last one alone gives.
    #[test]
    fn live_edits_are_mirrored_too(face in 0..18u32, amounts in prop::collection::vec(0.01f32..0.4, 1..5)) {
        let mut live = symmetric("quads", 0);
        live.select(Element::Face, [face], SelectMode::Replace).expect("a face");
        for amount in &amounts {
            live.update_edit(command(json!({"op": "inset-faces", "amount": amount, "symmetry": "x"}))).expect("an inset");
            assert_symmetric(live.mesh().expect("a mesh"), 0, "live");
        }
        live.commit_edit();
        let mut once = symmetric("quads", 0);
        let last = amounts.last().expect("an amount");
        run(&mut once, json!({"op": "inset-faces", "faces": [face], "amount": last, "symmetry": "x"}));
        prop_assert_eq!(live.mesh(), once.mesh());
        live.undo().expect("a step");
        let before = symmetric("quads", 0);
        prop_assert_eq!(live.mesh(), before.mesh());
    }
}

#[test]
fn elements_without_an_image_change_alone_and_it_says_so_once() {
    let mut editor = symmetric("quads", 0);
    run(&mut editor, json!({"op": "set-vertex-position", "vertex": 0, "position": [-2.5, 0.0, 0.0]}));
    let faces = editor.mesh().expect("a mesh").face_count();
    let outcome = run(&mut editor, json!({"op": "poke-faces", "faces": [0, 2], "symmetry": "x"}));
    assert_eq!(outcome.warnings, ["1 element has no mirror image along x and changed alone"]);
    // Face 2 and its image get three faces more each, face 0 alone does.
    assert_eq!(editor.mesh().expect("a mesh").face_count(), faces + 9);
}

#[test]
fn both_sides_of_a_choice_are_one_edit() {
    // Faces on both sides of the plane are extruded as one region, with no wall between them.
    let mut editor = symmetric("quads", 0);
    let before = editor.mesh().expect("a mesh").face_count();
    run(&mut editor, json!({"op": "extrude-faces", "faces": [8], "distance": 0.25, "symmetry": "x"}));
    let mesh = editor.mesh().expect("a mesh");
    assert_eq!(mesh.face_count(), before + 6);
    // A face that is chosen with its image is edited once.
    let mut both = symmetric("quads", 0);
    run(&mut both, json!({"op": "extrude-faces", "faces": [8, 9], "distance": 0.25, "symmetry": "x"}));
    let places = |mesh: &Mesh| -> HashSet<[u32; 3]> {
        mesh.vertices().map(|v| mesh.position(v).to_array().map(f32::to_bits)).collect()
    };
    assert_eq!(places(both.mesh().expect("a mesh")), places(mesh));
}

/// The corners of the faces, sorted.
fn degrees(editor: &Editor) -> Vec<usize> {
    let mesh = editor.mesh().expect("a mesh");
    let mut degrees: Vec<usize> = mesh.faces().map(|f| mesh.face_degree(f)).collect();
    degrees.sort_unstable();
    degrees
}

/// A polygon that is its own mirror image across x = 0: its right half from the bottom up, and what is in the plane.
fn polygon(right: &[[f32; 2]], top: Option<f32>, bottom: Option<f32>) -> Editor {
    let at = |[x, y]: [f32; 2]| Vec3::new(x, y, 0.25 * x * x);
    let mut positions: Vec<Vec3> = right.iter().copied().map(at).collect();
    positions.extend(top.map(|y| at([0.0, y])));
    positions.extend(right.iter().rev().map(|[x, y]| at([-x, *y])));
    positions.extend(bottom.map(|y| at([0.0, y])));
    let face: Vec<u32> = (0..positions.len() as u32).collect();
    Editor::with_mesh("Polygon", build(positions, &[face]))
}

#[test]
fn faces_across_the_plane_are_cut_into_symmetric_triangles_or_refused() {
    let right = [[1.0, 0.0], [1.5, 1.0], [0.75, 2.0]];
    let cut = json!({"op": "triangulate-faces", "faces": [0], "symmetry": "x"});
    // With a corner in the plane at both ends, or at one.
    for (top, bottom, triangles) in [(Some(2.5), Some(-0.5), 6), (Some(2.5), None, 5), (None, Some(-0.5), 5)]
    {
        let mut editor = polygon(&right, top, bottom);
        run(&mut editor, cut.clone());
        assert_eq!(degrees(&editor), vec![3; triangles]);
        assert_symmetric(editor.mesh().expect("a mesh"), 0, "a polygon");
        let all = polygon(&right, top, bottom);
        let mesh = editor.mesh().expect("a mesh");
        for f in mesh.faces() {
            let [a, b, c] = mesh.face_vertices(f).map(|v| mesh.position(v)).collect::<Vec<_>>()[..] else {
                panic!("no triangle")
            };
            assert!((b - a).cross(c - a).z > 0.0, "{f} is turned over");
        }
        assert_eq!(all.mesh().expect("a mesh").vertex_count(), mesh.vertex_count());
    }
    // With none, or with a notch where the triangle across the plane would be.
    for mut editor in
        [polygon(&right, None, None), polygon(&[[1.0, 0.0], [0.2, 1.0], [2.0, 1.5]], Some(2.5), None)]
    {
        let before = editor.document().clone();
        let error = refusal(&mut editor, cut.clone());
        assert!(error.contains("face 0") && error.contains("poke it"), "{error}");
        assert_eq!(editor.document(), &before);
        run(&mut editor, json!({"op": "poke-faces", "faces": [0], "symmetry": "x"}));
        assert_symmetric(editor.mesh().expect("a mesh"), 0, "poked");
    }
}

#[test]
fn edges_of_one_face_are_split_together() {
    // A triangle with its tip in the plane, and a quad across it.
    let mut triangle = polygon(&[[1.0, 0.0]], Some(2.0), None);
    run(&mut triangle, json!({"op": "split-edge", "edge": [0, 1], "t": 0.25, "symmetry": "x"}));
    assert_eq!(degrees(&triangle), [3, 4]);
    assert_symmetric(triangle.mesh().expect("a mesh"), 0, "a triangle");
    for (connect, expected) in [("triangles", vec![6]), ("none", vec![6]), ("all", vec![4, 4])] {
        let mut quad = polygon(&[[1.0, 0.0], [2.0, 1.0]], None, None);
        let both =
            json!({"op": "split-edge", "edge": [0, 1], "t": 0.25, "connect": connect, "symmetry": "x"});
        run(&mut quad, both);
        assert_eq!(degrees(&quad), expected, "{connect}");
        assert_symmetric(quad.mesh().expect("a mesh"), 0, connect);
    }
    // Both chosen, they are split once.
    let mut triangle = polygon(&[[1.0, 0.0]], Some(2.0), None);
    triangle.select(Element::Edge, [0, 1, 2], SelectMode::Replace).expect("edges");
    let edges = triangle.mesh().expect("a mesh").edge_count();
    run(&mut triangle, json!({"op": "split-edge", "symmetry": "x"}));
    let mesh = triangle.mesh().expect("a mesh");
    assert_eq!(mesh.vertex_count(), 6, "{edges} edges");
    assert_symmetric(mesh, 0, "all edges");
}

/// How many vertices, edges and faces an edit of the strip with symmetry adds.
fn added(fields: Value) -> [isize; 3] {
    let mut editor = symmetric("quads", 0);
    let count = |editor: &Editor| {
        let mesh = editor.mesh().expect("a mesh");
        [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()].map(|count| count as isize)
    };
    let before = count(&editor);
    let what = fields.to_string();
    let mut fields = fields;
    fields["symmetry"] = "x".into();
    run(&mut editor, fields);
    validate(&editor);
    assert_symmetric(editor.mesh().expect("a mesh"), 0, &what);
    let after = count(&editor);
    [0, 1, 2].map(|at| after[at] - before[at])
}

#[test]
fn what_is_dissolved_is_dissolved_on_both_sides_and_once_in_the_plane() {
    // The strip has seven vertices in a row, of which 3, 10, 17 and 24 are in the plane.
    let dissolve = |vertex: u32| added(json!({"op": "dissolve-vertex", "vertices": [vertex]}));
    assert_eq!(dissolve(8), [-2, -8, -6], "beside the plane: its image too");
    assert_eq!(dissolve(12), [-2, -8, -6], "from the other side");
    assert_eq!(dissolve(10), [-1, -4, -3], "in the plane: once");
    let dissolve = |edges: Value| added(json!({"op": "dissolve-edge", "edges": edges}));
    assert_eq!(dissolve(json!([[8, 9]])), [0, -2, -2], "its image too");
    assert_eq!(
        dissolve(json!([[9, 10]])),
        [-1, -3, -2],
        "two that meet in the plane, and the vertex between them"
    );
    assert_eq!(dissolve(json!([[10, 17]])), [0, -1, -1], "in the plane: once");
    // The faces of four columns become one across the plane, by one edge in it and one beside it.
    assert_eq!(dissolve(json!([[10, 17], [9, 16]])), [0, -3, -3]);
    assert_eq!(
        dissolve(json!([[10, 17], [9, 16], [11, 18]])),
        [0, -3, -3],
        "images that are chosen count once"
    );
}

#[test]
fn edges_are_split_on_both_sides_and_once_in_the_plane() {
    let split =
        |edge: [u32; 2], t: f32| added(json!({"op": "split-edge", "edge": edge, "t": t, "connect": "none"}));
    assert_eq!(split([8, 9], 0.25), [2, 2, 0], "its image too");
    assert_eq!(split([9, 10], 0.25), [2, 2, 0], "two that meet in the plane");
    assert_eq!(split([10, 17], 0.25), [1, 1, 0], "in the plane: once");
    // An edge across the plane is its own image, so its vertex is in the middle, wherever it was asked for.
    for t in [0.5, 0.25] {
        let mut quad = polygon(&[[1.0, 0.0], [2.0, 1.0]], None, None);
        let across = json!({"op": "split-edge", "edge": [0, 3], "t": t, "connect": "none", "symmetry": "x"});
        run(&mut quad, across);
        let mesh = quad.mesh().expect("a mesh");
        assert_eq!(mesh.vertex_count(), 5, "at {t}");
        assert_eq!(mesh.position(VertexId::new(4)).x, 0.0, "at {t}");
        assert_symmetric(mesh, 0, "a quad");
    }
}

#[test]
fn what_has_no_symmetric_result_is_refused_in_words() {
    // Of two edges of one triangle, the one that is flipped first leaves no triangle for the other.
    let positions =
        [[0.0, 2.0], [-1.0, 0.0], [1.0, 0.0], [-2.0, 1.5], [2.0, 1.5]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let mut editor =
        Editor::with_mesh("Fan", build(positions.to_vec(), &[vec![0, 1, 2], vec![0, 3, 1], vec![0, 2, 4]]));
    let before = editor.document().clone();
    let error = refusal(&mut editor, json!({"op": "flip-edge", "edge": [0, 1], "symmetry": "x"}));
    assert!(error.contains("symmetr") && error.contains("turn symmetry off"), "{error}");
    assert_eq!(editor.document(), &before);
    run(&mut editor, json!({"op": "flip-edge", "edge": [0, 1]}));
    // What wasn't symmetric before the edit need not become so.
    let mut editor = symmetric("quads", 0);
    run(&mut editor, json!({"op": "triangulate-faces", "faces": [1]}));
    run(&mut editor, json!({"op": "split-edge", "edge": [1, 8], "symmetry": "x"}));
}

#[test]
fn edges_that_meet_in_the_plane_collapse_into_it() {
    let mut editor = symmetric("quads", 0);
    // From the vertex in the plane to either side.
    run(&mut editor, json!({"op": "collapse-edge", "edge": [9, 10], "t": 0.3, "symmetry": "x"}));
    let mesh = editor.mesh().expect("a mesh");
    assert_eq!(mesh.vertex_count(), 26);
    assert_symmetric(mesh, 0, "two edges");
}

#[test]
fn vertices_are_merged_on_each_side_or_in_the_plane() {
    let mut editor = symmetric("quads", 0);
    let before = editor.mesh().expect("a mesh").vertex_count();
    run(&mut editor, json!({"op": "merge-vertices", "vertices": [8, 9], "symmetry": "x"}));
    assert_eq!(editor.mesh().expect("a mesh").vertex_count(), before - 2);
    let mut editor = symmetric("quads", 0);
    run(
        &mut editor,
        json!({"op": "merge-vertices", "vertices": [9, 10], "position": [0.1, 0.5, 0.0], "symmetry": "x"}),
    );
    let mesh = editor.mesh().expect("a mesh");
    assert_eq!(mesh.vertex_count(), before - 2);
    assert!(mesh.vertices().any(|v| mesh.position(v) == Vec3::new(0.0, 0.5, 0.0)));
}

#[test]
fn a_symmetry_that_is_no_choice_is_refused() {
    let mut editor = on_cube();
    let error = refusal(&mut editor, json!({"op": "poke-faces", "faces": [0], "symmetry": "w"}));
    assert!(error.contains("symmetry"), "{error}");
    let error = refusal(&mut editor, json!({"op": "smooth", "symmetry": "x"}));
    assert!(error.contains("symmetry"), "{error}");
    assert!(editor.messages().all(|message| message.kind == MessageKind::Error));
}
