//! Long random sequences of all edits over the zoo: the mesh is valid after each, each did what it
//! reported, a refused one wrote nothing, and undo and redo go to the bit all the way.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::zoo;
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, Mesh, VertexId};

/// xorshift64*: the same sequence on every machine.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_F491_4F6C_DD1D)
    }

    pub fn below(&mut self, n: usize) -> usize {
        if n == 0 { 0 } else { (self.next() >> 33) as usize % n }
    }

    pub fn unit(&mut self) -> f32 {
        (self.next() >> 40) as f32 / (1 << 24) as f32
    }

    pub fn pick<T: Copy>(&mut self, from: &[T]) -> Option<T> {
        from.get(self.below(from.len())).copied()
    }
}

/// The elements of a mesh, to pick from.
struct Elements {
    vertices: Vec<VertexId>,
    edges: Vec<EdgeId>,
    faces: Vec<FaceId>,
}

impl Elements {
    fn of(mesh: &Mesh) -> Self {
        Self {
            vertices: mesh.vertices().collect(),
            edges: mesh.edges().collect(),
            faces: mesh.faces().collect(),
        }
    }
}

/// What an edit says about itself.
#[derive(Default)]
pub struct Said {
    /// The change of the Euler characteristic, from what was made and removed or from the kind of edit.
    euler: Option<i64>,
    /// The change of the number of boundary loops.
    loops: Option<i64>,
    /// Counts of what was made minus what was removed.
    counts: Option<[i64; 3]>,
}

impl Said {
    fn made(made: &Made) -> Self {
        let change = |a: usize, b: usize| a as i64 - b as i64;
        Self {
            euler: Some(made.euler_change()),
            loops: None,
            counts: Some([
                change(made.vertices.len(), made.removed_vertices.len()),
                change(made.edges.len(), made.removed_edges.len()),
                change(made.faces.len(), made.removed_faces.len()),
            ]),
        }
    }

    /// The surface stays what it is topologically.
    fn same(self) -> Self {
        assert!(self.euler.is_none_or(|change| change == 0), "the edit keeps the Euler characteristic");
        Self { euler: Some(0), loops: Some(0), ..self }
    }
}

pub type Tried = Result<Said, Refusal>;

/// Runs a check and its edit, which must agree.
fn both<T>(
    mesh: &mut Mesh,
    can: impl Fn(&Mesh) -> Result<(), Refusal>,
    edit: impl FnOnce(&mut Mesh) -> Result<T, Refusal>,
    said: impl FnOnce(&T) -> Said,
) -> Tried {
    let allowed = can(mesh);
    match edit(mesh) {
        Ok(made) => {
            allowed.expect("the edit did what the check refused");
            Ok(said(&made))
        }
        Err(refusal) => {
            assert_eq!(allowed, Err(refusal.clone()), "the check and the edit disagree");
            Err(refusal)
        }
    }
}

pub const EDITS: usize = 25;

pub fn one_edit(mesh: &mut Mesh, random: &mut Random, kind: usize) -> Tried {
    let all = Elements::of(mesh);
    let nothing = Refusal::NothingGiven(halfedge::Element::Face);
    let edge = random.pick(&all.edges).ok_or(nothing.clone())?;
    let face = random.pick(&all.faces).ok_or(nothing.clone())?;
    let vertex = random.pick(&all.vertices).ok_or(nothing)?;
    let t = random.unit();
    match kind {
        0 => {
            let connect = [Connect::None, Connect::Triangles, Connect::All][random.below(3)];
            both(
                mesh,
                |m| can_split_edge(m, edge, t, connect),
                |m| split_edge(m, edge, t, connect),
                |made| {
                    let [edges, faces] = [made.edges.len() as i64, made.faces.len() as i64];
                    Said { counts: Some([1, edges, faces]), ..Said::default() }.same()
                },
            )
        }
        1 => both(
            mesh,
            |m| can_flip_edge(m, edge),
            |m| flip_edge(m, edge),
            |()| Said { counts: Some([0, 0, 0]), ..Said::default() }.same(),
        ),
        2 => both(
            mesh,
            |m| can_collapse_edge(m, edge, t),
            |m| collapse_edge(m, edge, t),
            |made| {
                let [edges, faces] = [made.removed_edges.len() as i64, made.removed_faces.len() as i64];
                Said { counts: Some([-1, -edges, -faces]), ..Said::default() }.same()
            },
        ),
        3 => both(mesh, |m| can_collapse_face(m, face), |m| collapse_face(m, face), Said::made),
        4 => {
            let edges: Vec<EdgeId> = mesh.vertex_edges(vertex).collect();
            let (Some(a), Some(b)) = (random.pick(&edges), random.pick(&edges)) else {
                return Ok(unchanged());
            };
            both(
                mesh,
                |m| can_split_vertex(m, vertex, [a, b], None),
                |m| split_vertex(m, vertex, [a, b], None),
                |made| Said::made(made).same(),
            )
        }
        5 => both(
            mesh,
            |m| can_dissolve_vertex(m, vertex),
            |m| dissolve_vertex(m, vertex),
            |made| Said::made(made).same(),
        ),
        6 => {
            let inner: Vec<EdgeId> =
                all.edges.iter().copied().filter(|&e| !mesh.is_boundary_edge(e)).collect();
            let from = if random.below(10) == 0 { &all.edges } else { &inner };
            let edges: Vec<EdgeId> = (0..=random.below(4)).filter_map(|_| random.pick(from)).collect();
            let keep_vertices = random.below(2) == 0;
            both(
                mesh,
                |m| can_dissolve_edges(m, &edges),
                |m| dissolve_edges(m, &edges, keep_vertices),
                |made| Said::made(made).same(),
            )
        }
        7 => {
            let some: Vec<FaceId> = if all.faces.len() > 100 {
                all.faces.iter().copied().filter(|_| random.below(2) == 0).collect()
            } else {
                (0..=random.below(3)).filter_map(|_| random.pick(&all.faces)).collect()
            };
            both(mesh, |m| can_delete_faces(m, &some), |m| delete_faces(m, &some), Said::made)
        }
        8 => both(mesh, |m| can_delete_vertices(m, &[vertex]), |m| delete_vertices(m, &[vertex]), Said::made),
        9 => {
            let count = |made: &Triangulated| {
                let [edges, faces] = [made.edges.len() as i64, made.faces.len() as i64];
                Said { counts: Some([0, edges, faces]), ..Said::default() }.same()
            };
            let by = [Triangulation::Auto, Triangulation::Fan, Triangulation::Ears][random.below(3)];
            both(mesh, |m| can_triangulate_face(m, face, by), |m| triangulate_face(m, face, by), count)
        }
        10 => {
            let some: Vec<FaceId> = (0..=random.below(3)).filter_map(|_| random.pick(&all.faces)).collect();
            both(mesh, |m| can_poke_faces(m, &some), |m| poke_faces(m, &some), |made| Said::made(made).same())
        }
        11 => {
            let corners: Vec<VertexId> = mesh.face_vertices(face).collect();
            let (Some(a), Some(b)) = (random.pick(&corners), random.pick(&corners)) else {
                return Ok(unchanged());
            };
            both(
                mesh,
                |m| can_connect_vertices(m, a, b),
                |m| connect_vertices(m, a, b),
                |_| Said { counts: Some([0, 1, 1]), ..Said::default() }.same(),
            )
        }
        _ => larger_edit(mesh, random, kind, &all, t),
    }
}

fn unchanged() -> Said {
    Said { counts: Some([0, 0, 0]), ..Said::default() }.same()
}

/// Some of the elements: a few, many or all.
fn some<T: Copy>(random: &mut Random, from: &[T]) -> Vec<T> {
    match random.below(8) {
        0 => from.to_vec(),
        1 | 2 => from.iter().copied().filter(|_| random.below(2) == 0).collect(),
        _ => (0..=random.below(5)).filter_map(|_| random.pick(from)).collect(),
    }
}

/// A live edit, then its slide by this amount.
fn slid(mesh: &mut Mesh, live: Result<Live, Refusal>, amount: f32) -> Result<Live, Refusal> {
    let live = live?;
    let used = live.slide.apply(mesh, amount)?;
    assert!(used <= amount && used <= live.slide.limit);
    Ok(live)
}

fn larger_edit(mesh: &mut Mesh, random: &mut Random, kind: usize, all: &Elements, t: f32) -> Tried {
    let edge = all.edges[random.below(all.edges.len())];
    let boundary: Vec<EdgeId> = all.edges.iter().copied().filter(|&e| mesh.is_boundary_edge(e)).collect();
    let loops = mesh.boundary_loops();
    let grouping = [Grouping::Region, Grouping::Individual][random.below(2)];
    let live = |live: &Live| Said::made(&live.made).same();
    match kind {
        12 | 13 => {
            let faces = some(random, &all.faces);
            if kind == 12 {
                let edit = |m: &mut Mesh| slid_extrude(m, &faces, grouping, t - 0.5);
                both(mesh, |m| can_extrude_faces(m, &faces, grouping), edit, live)
            } else {
                let edit = |m: &mut Mesh| {
                    let live = inset_faces(m, &faces, grouping);
                    slid(m, live, t)
                };
                both(mesh, |m| can_inset_faces(m, &faces, grouping), edit, live)
            }
        }
        14 => {
            let edges = some(random, &boundary);
            let edit = |m: &mut Mesh| {
                let live = extrude_edges(m, &edges, Vec3::new(t, 1.0, -t));
                slid(m, live, 1.0)
            };
            both(mesh, |m| can_extrude_edges(m, &edges), edit, live)
        }
        15 => {
            let inner: Vec<EdgeId> =
                all.edges.iter().copied().filter(|&e| !mesh.is_boundary_edge(e)).collect();
            let from = if random.below(10) == 0 { &all.edges } else { &inner };
            let edges = some(random, from);
            let segments = random.below(4) as u32;
            let edit = |m: &mut Mesh| {
                let live = bevel_edges(m, &edges, segments);
                slid(m, live, t)
            };
            both(mesh, |m| can_bevel_edges(m, &edges, segments), edit, live)
        }
        16 => {
            let vertices = some(random, &all.vertices);
            let edit = |m: &mut Mesh| {
                let live = bevel_vertices(m, &vertices);
                slid(m, live, t)
            };
            both(mesh, |m| can_bevel_vertices(m, &vertices), edit, live)
        }
        17 => {
            let cuts = random.below(4) as u32;
            both(
                mesh,
                |m| can_loop_cut(m, edge, cuts, t),
                |m| loop_cut(m, edge, cuts, t),
                |made| Said::made(made).same(),
            )
        }
        18 => {
            let side = random.pick(&loops).unwrap_or(edge.halfedge());
            both(
                mesh,
                |m| can_fill_hole(m, side),
                |m| fill_hole(m, side),
                |made| Said { euler: Some(1), loops: Some(-1), ..Said::made(made) },
            )
        }
        19 => {
            let sides = [random.pick(&loops), random.pick(&loops)].map(|h| h.unwrap_or(edge.halfedge()));
            both(
                mesh,
                |m| can_bridge(m, sides),
                |m| bridge(m, sides),
                |made| Said { euler: Some(0), loops: Some(-2), ..Said::made(made) },
            )
        }
        20 => {
            let vertices: Vec<VertexId> = if random.below(2) == 0 {
                mesh.ends(edge).to_vec()
            } else {
                (0..=random.below(4)).filter_map(|_| random.pick(&all.vertices)).collect()
            };
            let position = [None, Some(Vec3::splat(t))][random.below(2)];
            both(
                mesh,
                |m| can_merge_vertices(m, &vertices, position),
                |m| merge_vertices(m, &vertices, position),
                Said::made,
            )
        }
        21 => {
            // Edges of one loop, often neighbours, or any two.
            let first = random.pick(&boundary).unwrap_or(edge);
            let side = first.halfedges().into_iter().find(|&h| mesh.is_boundary_halfedge(h));
            let other = match (random.below(2), side) {
                (0, Some(side)) => mesh.next(side).edge(),
                _ => random.pick(&boundary).unwrap_or(edge),
            };
            both(mesh, |m| can_weld_edges(m, [first, other]), |m| weld_edges(m, [first, other]), Said::made)
        }
        22 => {
            let edges = some(random, &all.edges);
            both(mesh, |m| can_rip_edges(m, &edges), |m| rip_edges(m, &edges), Said::made)
        }
        23 => {
            // A whole piece, mostly.
            let (piece, _) = mesh.components();
            let chosen = piece[mesh.ends(edge)[0].index()];
            let mut faces: Vec<FaceId> = all
                .faces
                .iter()
                .copied()
                .filter(|&f| piece[mesh.from(mesh.halfedge_of(f)).index()] == chosen)
                .collect();
            if random.below(4) == 0 {
                faces.pop();
            }
            both(mesh, |m| can_flip_orientation(m, &faces), |m| flip_orientation(m, &faces), |()| unchanged())
        }
        _ => {
            let (edges, vertices) = (some(random, &all.edges), some(random, &all.vertices));
            both(
                mesh,
                |m| can_set_crease(m, &edges, &vertices, t * 10.0),
                |m| set_crease(m, &edges, &vertices, t * 10.0),
                |()| unchanged(),
            )
        }
    }
}

fn slid_extrude(mesh: &mut Mesh, faces: &[FaceId], grouping: Grouping, amount: f32) -> Result<Live, Refusal> {
    let live = extrude_faces(mesh, faces, grouping);
    slid(mesh, live, amount)
}

/// How many edits are tried one after the other on a mesh.
const SEQUENCE: usize = 150;

/// Runs `edits` edits from a mesh; gives how many of each kind were made.
fn run(name: &str, start: &Mesh, seed: u64, edits: usize) -> Vec<usize> {
    let mut mesh = start.clone();
    let mut random = Random::new(seed);
    let mut journals = Vec::new();
    let mut done = vec![0; EDITS];
    let mut euler = mesh.euler_characteristic();
    let mut loops = mesh.boundary_loops().len() as i64;
    for step in 0..edits {
        if mesh.face_count() == 0 {
            break;
        }
        // Keep it small: when large, delete the half of it.
        let large = mesh.face_count() > 100;
        let kind = if large { 7 } else { random.below(EDITS) };
        let counts = [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()].map(|n| n as i64);
        mesh.start_recording();
        let tried = one_edit(&mut mesh, &mut random, kind);
        let journal = mesh.finish_recording();
        let at = || format!("{name}, seed {seed}, step {step}, edit {kind}");
        match tried {
            Err(refusal) => {
                assert!(journal.is_empty(), "{}: refused with '{refusal}' after writing", at());
                assert!(!refusal.to_string().is_empty());
            }
            Ok(said) => {
                done[kind] += 1;
                if let Err(defect) = mesh.validate() {
                    panic!("{}: {defect}", at());
                }
                let counts_now =
                    [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()].map(|n| n as i64);
                if let Some(change) = said.counts {
                    let change_now: Vec<i64> = counts.iter().zip(counts_now).map(|(a, b)| b - a).collect();
                    assert_eq!(change.as_slice(), change_now, "{}", at());
                }
                let euler_now = mesh.euler_characteristic();
                let loops_now = mesh.boundary_loops().len() as i64;
                if let Some(change) = said.euler {
                    assert_eq!(euler_now - euler, change, "{}", at());
                }
                if let Some(change) = said.loops {
                    assert_eq!(loops_now - loops, change, "{}", at());
                }
                (euler, loops) = (euler_now, loops_now);
                let touched = journal.touched();
                mesh.validate_near(touched.vertices, touched.faces).unwrap();
                journals.push(journal);
            }
        }
    }
    let end = mesh.clone();
    let mut redo: Vec<_> = Vec::new();
    while let Some(journal) = journals.pop() {
        redo.push(mesh.undo(journal));
    }
    assert!(mesh == *start, "{name}, seed {seed}: undo does not give the mesh back");
    while let Some(journal) = redo.pop() {
        mesh.undo(journal);
    }
    assert!(mesh == end, "{name}, seed {seed}: redo does not give the mesh back");
    done
}

/// MESHWRIGHT_EDITS says how many; `cargo xtask test` runs a million. Each sequence has its
/// own seed, so that as many threads as there are processors make the same edits.
#[test]
fn random_sequences_of_all_edits() {
    let edits: usize = std::env::var("MESHWRIGHT_EDITS").ok().and_then(|n| n.parse().ok()).unwrap_or(20_000);
    let mut zoo = zoo::all();
    for (_, mesh) in &mut zoo {
        zoo::paint(mesh);
    }
    let sequences = edits.div_ceil(SEQUENCE) as u64;
    let next = AtomicU64::new(1);
    let sequences_of_one_thread = || {
        let mut done = vec![0; EDITS];
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed > sequences {
                return done;
            }
            let (name, start) = &zoo[seed as usize % zoo.len()];
            add(&mut done, &run(name, start, seed * 0x9E37_79B9, SEQUENCE));
        }
    };
    let mut done = vec![0; EDITS];
    std::thread::scope(|scope| {
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
        let threads: Vec<_> = (0..threads).map(|_| scope.spawn(sequences_of_one_thread)).collect();
        for thread in threads {
            match thread.join() {
                Ok(its) => add(&mut done, &its),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    println!("{} edits tried; done, by kind: {done:?}", sequences as usize * SEQUENCE);
    assert!(done.iter().all(|&n| n > 0), "an edit was never made: {done:?}");
}

fn add(total: &mut [usize], more: &[usize]) {
    for (total, more) in total.iter_mut().zip(more) {
        *total += more;
    }
}
