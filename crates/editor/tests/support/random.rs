//! Random commands.

use editor::halfedge::Element;
use proptest::prelude::*;
use serde_json::{Value, json};

/// Some local edit of one or a few elements.
pub fn any_edit() -> impl Strategy<Value = Value> {
    let id = 0u32..40;
    let ids = || prop::collection::vec(0u32..40, 1..4);
    let pair = || prop::array::uniform2(0u32..40);
    let mode = prop::sample::select(vec!["region", "individual"]);
    prop_oneof![
        id.clone().prop_map(|e| json!({"op": "flip-edge", "edge": e})),
        (id.clone(), 0f32..=1.0).prop_map(|(e, t)| json!({"op": "collapse-edge", "edge": e, "t": t})),
        id.clone().prop_map(|f| json!({"op": "collapse-face", "face": f})),
        (id.clone(), pair()).prop_map(|(v, e)| json!({"op": "split-vertex", "vertex": v, "edges": e})),
        id.clone().prop_map(|v| json!({"op": "dissolve-vertex", "vertex": v})),
        id.clone().prop_map(|e| json!({"op": "dissolve-edge", "edge": e})),
        ids().prop_map(|f| json!({"op": "delete-faces", "faces": f})),
        ids().prop_map(|v| json!({"op": "delete-vertices", "vertices": v})),
        id.clone().prop_map(|f| json!({"op": "triangulate-faces", "faces": [f], "method": "ear"})),
        ids().prop_map(|f| json!({"op": "poke-faces", "faces": f})),
        pair().prop_map(|v| json!({"op": "connect-vertices", "vertices": v})),
        (ids(), -1f32..1.0, mode.clone())
            .prop_map(|(f, d, m)| json!({"op": "extrude-faces", "faces": f, "distance": d, "mode": m})),
        ids().prop_map(|e| json!({"op": "extrude-edges", "edges": e, "offset": [0, 0, 1]})),
        (ids(), 0f32..1.0, mode)
            .prop_map(|(f, a, m)| json!({"op": "inset-faces", "faces": f, "amount": a, "mode": m})),
        (ids(), 0f32..1.0, 1u32..4)
            .prop_map(|(e, w, s)| json!({"op": "bevel-edges", "edges": e, "width": w, "segments": s})),
        (ids(), 0f32..1.0).prop_map(|(v, w)| json!({"op": "bevel-vertices", "vertices": v, "width": w})),
        (id.clone(), 1u32..3).prop_map(|(e, c)| json!({"op": "loop-cut", "edge": e, "cuts": c})),
        (ids(), -1f32..1.0).prop_map(|(e, a)| json!({"op": "slide-edges", "edges": e, "amount": a})),
        (ids(), -1f32..1.0).prop_map(
            |(v, a)| json!({"op": "slide-vertices", "vertices": v, "direction": [1, 2, 0], "amount": a})
        ),
        (0u32..80).prop_map(|h| json!({"op": "fill-hole", "halfedge": h})),
        (prop::collection::vec(0u32..80, 2..5), 0u32..3, -3i32..4)
            .prop_map(|(h, c, t)| json!({"op": "bridge", "halfedges": h, "cuts": c, "twist": t})),
        (prop::collection::vec(0u32..20, 2..5), 0u32..3)
            .prop_map(|(f, c)| json!({"op": "bridge", "faces": f, "cuts": c})),
        ids().prop_map(|v| json!({"op": "merge-vertices", "vertices": v})),
        pair().prop_map(|e| json!({"op": "weld-edges", "edges": e})),
        ids().prop_map(|e| json!({"op": "rip-edges", "edges": e})),
        Just(json!({"op": "flip-orientation"})),
        (ids(), 0f32..10.0).prop_map(|(e, s)| json!({"op": "set-crease", "edges": e, "sharpness": s})),
    ]
}

/// Some command: ids and places are often those of nothing, so that refusals are among them.
pub fn any_command() -> impl Strategy<Value = Value> {
    let id = 0u32..40;
    prop_oneof![
        (id.clone(), prop::array::uniform3(-9f32..9.0))
            .prop_map(|(v, p)| json!({"op": "set-vertex-position", "vertex": v, "position": p})),
        (id.clone(), 0.1f32..0.9, prop::sample::select(vec!["none", "triangles", "all"]))
            .prop_map(|(e, t, c)| json!({"op": "split-edge", "edge": e, "t": t, "connect": c})),
        prop::collection::vec(id.clone(), 1..4)
            .prop_map(|f| json!({"op": "set-face-color", "faces": f, "color": "#0a0b0c"})),
        id.clone().prop_map(|f| json!({"op": "triangulate-faces", "faces": [f]})),
        Just(json!({"op": "triangulate-faces"})),
        any_edit(),
        Just(json!({"op": "subdivide-linear"})),
        (0usize..3).prop_map(|o| json!({"op": "subdivide-catmull-clark", "object": o})),
        (0usize..3, 0.2f32..1.0).prop_map(|(o, r)| json!({"op": "simplify", "object": o, "ratio": r})),
        (0usize..3, 0.4f32..2.0)
            .prop_map(|(o, l)| json!({"op": "remesh", "object": o, "edge_length": l, "iterations": 2})),
        (0usize..3, 1u32..4).prop_map(|(o, i)| json!({"op": "smooth", "object": o, "iterations": i})),
        (0usize..3, 0f32..1.0)
            .prop_map(|(o, d)| json!({"op": "merge-by-distance", "object": o, "distance": d})),
        Just(json!({"op": "new", "shape": "grid", "columns": 2, "rows": 1, "add": true})),
        Just(json!({"op": "new", "shape": "tetrahedron"})),
        (0usize..4).prop_map(|o| json!({"op": "activate-object", "object": o})),
        (0usize..4).prop_map(|o| json!({"op": "delete-object", "object": o})),
        (0usize..4).prop_map(|o| json!({"op": "rename-object", "object": o, "name": "Thing"})),
        (0usize..3, any::<bool>())
            .prop_map(|(o, v)| json!({"op": "set-object-visible", "object": o, "visible": v})),
        Just(json!({"op": "join-objects"})),
        Just(json!({"op": "separate", "by": "components"})),
        prop::collection::vec(id.clone(), 1..4).prop_map(|f| json!({"op": "separate", "faces": f})),
        (prop::collection::vec(id, 1..4), 0.5f32..3.0).prop_map(
            |(v, r)| json!({"op": "transform", "vertices": v, "translate": [0.5, 0.25, 0], "falloff": r})
        ),
    ]
}

pub fn any_element() -> impl Strategy<Value = Element> {
    prop::sample::select(Element::ALL.to_vec())
}
