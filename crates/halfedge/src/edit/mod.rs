//! Local edits, one per file, each as a pair of functions.
//!
//! `can_x(&mesh, …)` tells whether the edit would leave a valid mesh, and why not. `x(&mut mesh, …)` makes the edit,
//! or refuses for the same reason and changes nothing. The cost is in proportion to the valences and face degrees
//! around the edit, never to the mesh.
//!
//! Edits that can be dragged come in two halves: the edit makes its topology at size zero and returns a [`Slide`],
//! which moves the vertices by any amount. Those that move vertices and nothing else, along a [`Rail`] each, take the
//! amount at once.
//!
//! Attribute values follow: corners and vertices that an edit makes or moves get the values that their faces have
//! there; each edit's text says how. Seams of texture coordinates stay, and none appear.

mod bevel_edges;
mod bevel_vertices;
mod bridge;
mod collapse_edge;
mod collapse_face;
mod connect_vertices;
mod delete_faces;
mod dissolve_around;
mod dissolve_edges;
mod dissolve_vertex;
mod extrude_edges;
mod extrude_faces;
mod fill_hole;
mod flip_edge;
mod flip_orientation;
mod inset_faces;
mod loop_cut;
mod made;
mod merge_vertices;
mod patch;
mod poke_faces;
mod refusal;
mod rip_edges;
mod set_crease;
mod shared;
mod slide;
mod slide_edges;
mod slide_vertices;
mod split_edge;
mod split_vertex;
mod triangulate;
mod weld_edges;

pub use bevel_edges::{BEVEL_SEGMENTS_RANGE, bevel_edges, can_bevel_edges};
pub use bevel_vertices::{bevel_vertices, can_bevel_vertices};
pub use bridge::{
    BRIDGE_CUTS_RANGE, BRIDGE_SMOOTHNESS_RANGE, Bands, bridge, bridge_faces, can_bridge, can_bridge_faces,
};
pub use collapse_edge::{COLLAPSE_T_RANGE, EdgeCollapse, can_collapse_edge, collapse_edge};
pub use collapse_face::{can_collapse_face, collapse_face};
pub use connect_vertices::{Connected, can_connect_vertices, connect_vertices};
pub use delete_faces::{can_delete_faces, can_delete_vertices, delete_faces, delete_vertices};
pub use dissolve_around::{can_dissolve_around, dissolve_around};
pub use dissolve_edges::{can_dissolve_edges, dissolve_edges};
pub use dissolve_vertex::{can_dissolve_vertex, dissolve_vertex};
pub use extrude_edges::{can_extrude_edges, extrude_edges};
pub use extrude_faces::{can_extrude_faces, extrude_faces};
pub use fill_hole::{can_fill_hole, fill_hole};
pub use flip_edge::{can_flip_edge, can_flip_edge_clockwise, flip_edge, flip_edge_clockwise};
pub use flip_orientation::{can_flip_orientation, flip_orientation};
pub use inset_faces::{can_inset_faces, inset_faces};
pub use loop_cut::{LOOP_CUTS_RANGE, can_loop_cut, edge_ring, loop_cut};
pub use made::Made;
pub use merge_vertices::{can_merge_vertices, merge_vertices};
pub use poke_faces::{can_poke_faces, poke_faces};
pub use refusal::Refusal;
pub use rip_edges::{can_rip_edges, rip_edges};
pub use set_crease::{CREASE_SHARPNESS_RANGE, can_set_crease, set_crease};
pub use shared::{Grouping, Rail, SLIDE_AMOUNT_RANGE, check_amount};
pub use slide::{Slide, SlideVertex, SlidingEdit};
pub use slide_edges::{can_slide_edges, edge_rails, slide_edges};
pub use slide_vertices::{best_way, can_slide_vertices, slide_vertices, vertex_rails};
pub use split_edge::{Connect, EdgeSplit, SPLIT_T_RANGE, can_split_edge, split_edge};
pub use split_vertex::{can_split_vertex, split_vertex};
pub use triangulate::{Triangulated, Triangulation, can_triangulate_face, triangulate_face};
pub use weld_edges::{can_weld_edges, weld_edges};
