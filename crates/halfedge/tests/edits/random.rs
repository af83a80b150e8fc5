//! Long random sequences of all edits on the meshes of the zoo. After each the mesh is valid and changed as reported;
//! a refused edit writes nothing; undo and redo are exact all the way.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::any_edit::{Kind, edit_any};
use crate::zoo;
use halfedge::Mesh;

/// Random numbers by xorshift64*: the same sequence on every machine.
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

/// The number of edits tried in a sequence.
const SEQUENCE_LENGTH: usize = 150;
/// Meshes with more faces lose half of them at the next edit.
const MAX_FACES: usize = 100;

/// Tries a sequence of edits from a mesh; returns how many of each kind were made.
fn run_sequence(name: &str, start: &Mesh, seed: u64) -> Vec<usize> {
    let mut mesh = start.clone();
    let mut random = Random::new(seed);
    let mut journals = Vec::new();
    let mut done = vec![0; Kind::ALL.len()];
    let mut euler = mesh.euler_characteristic();
    let mut loops = mesh.boundary_loops().len() as i64;
    for step in 0..SEQUENCE_LENGTH {
        if mesh.face_count() == 0 {
            break;
        }
        let is_large = mesh.face_count() > MAX_FACES;
        let kind = if is_large { Kind::DeleteFaces } else { Kind::ALL[random.below(Kind::ALL.len())] };
        let counts = [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()].map(|n| n as i64);
        mesh.start_recording();
        let tried = edit_any(&mut mesh, &mut random, kind);
        let journal = mesh.finish_recording();
        let at = || format!("{name}, seed {seed}, step {step}, {kind:?}");
        match tried {
            Err(refusal) => {
                assert!(journal.is_empty(), "{}: refused with '{refusal}' after writing", at());
                assert!(!refusal.to_string().is_empty());
            }
            Ok(said) => {
                done[kind as usize] += 1;
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

/// `MESHWRIGHT_EDITS` sets the number of edits; `cargo xtask test` runs a million. Each sequence has its own seed, so the
/// edits don't depend on the number of threads.
#[test]
fn random_sequences_of_all_edits() {
    let edits: usize = std::env::var("MESHWRIGHT_EDITS").ok().and_then(|n| n.parse().ok()).unwrap_or(20_000);
    let mut zoo = zoo::all();
    for (_, mesh) in &mut zoo {
        zoo::paint(mesh);
    }
    let sequences = edits.div_ceil(SEQUENCE_LENGTH) as u64;
    let next = AtomicU64::new(1);
    let sequences_of_one_thread = || {
        let mut done = vec![0; Kind::ALL.len()];
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed > sequences {
                return done;
            }
            let (name, start) = &zoo[seed as usize % zoo.len()];
            add(&mut done, &run_sequence(name, start, seed * 0x9E37_79B9));
        }
    };
    let mut done = vec![0; Kind::ALL.len()];
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
    println!("{} edits tried; made, by kind: {done:?}", sequences as usize * SEQUENCE_LENGTH);
    let never = Kind::ALL.into_iter().find(|kind| done[*kind as usize] == 0);
    assert_eq!(never, None, "an edit was never made: {done:?}");
}

fn add(total: &mut [usize], more: &[usize]) {
    for (total, more) in total.iter_mut().zip(more) {
        *total += more;
    }
}
