//! The fuzz targets of `fuzz/`, run natively: on every seed as it is, then on damaged ones, always
//! the same. What reading and writing takes of memory is a small multiple of the file.

#[path = "../../../fuzz/targets.rs"]
mod targets;

use fixtures::Random;
use formats::{Format, Model, NamedBytes};
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};
use peak_alloc::PeakAlloc;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::{Mutex, MutexGuard};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Memory is counted for the whole process: one test at a time.
static TURN: Mutex<()> = Mutex::new(());

fn turn() -> MutexGuard<'static, ()> {
    TURN.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// The memory that something takes at most, in bytes.
fn peak(work: impl FnOnce()) -> usize {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    work();
    MEMORY.peak_usage().saturating_sub(before)
}

/// What parsers stumble over, to put anywhere.
const WORDS: [&[u8]; 16] = [
    b"-1",
    b"0",
    b"4294967295",
    b"99999999999999999999",
    b"1e999",
    b"-1e-999",
    b"nan",
    b" ",
    b"\n",
    b"\\\n",
    b"/",
    b"\0",
    b"\xff\xff\xff\xff",
    b"\"",
    b"<",
    b"}",
];

/// A seed with a few things done to it, parts of another among them.
fn damaged(seed: &[u8], other: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.below(6) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(40)).min(bytes.len());
        match random.below(8) {
            0 => drop(bytes.drain(at..end)),
            1 => bytes.truncate(at),
            2 => {
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
            3 => {
                let from = random.below(other.len() + 1);
                let to = (from + random.below(200)).min(other.len());
                bytes.splice(at..end, other[from..to].iter().copied());
            }
            4 | 5 => {
                drop(bytes.splice(at..end.min(at + 3), WORDS[random.below(WORDS.len())].iter().copied()))
            }
            6 => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
            _ => {
                // Another digit in a number.
                if let Some(byte) =
                    bytes.get_mut(at..).and_then(|rest| rest.iter_mut().find(|b| b.is_ascii_digit()))
                {
                    *byte = b'0' + random.below(10) as u8;
                }
            }
        }
    }
    bytes
}

fn seeds(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds");
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(&folder).expect("fuzz/seeds is there") {
        let entry = entry.expect("readable");
        // `any` reads what the others do.
        if target == "any" || entry.file_name() == *target {
            paths.extend(
                std::fs::read_dir(entry.path()).expect("a folder").map(|file| file.expect("readable").path()),
            );
        }
    }
    paths.sort();
    assert!(!paths.is_empty(), "{target} has no seeds");
    paths.iter().map(|path| std::fs::read(path).expect("readable")).collect()
}

/// How many damaged seeds a target is given.
fn rounds() -> usize {
    std::env::var("MESHWRIGHT_FUZZ").ok().and_then(|text| text.parse().ok()).unwrap_or(1500)
}

fn fuzz(target: &str) {
    let _turn = turn();
    let (_, name) = targets::TARGETS.iter().find(|(own, _)| *own == target).expect("a target");
    let seeds = seeds(target);
    for seed in &seeds {
        targets::run(name, seed);
    }
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for round in 0..rounds() {
        let seed = &seeds[round % seeds.len()];
        let other = &seeds[random.below(seeds.len())];
        let bytes = damaged(seed, other, &mut random);
        let mut took = 0;
        let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            took = peak(|| targets::run(name, &bytes))
        }));
        let limit = 200 * bytes.len() + (2 << 20);
        if result.is_err() || took > limit {
            let path = std::env::temp_dir().join(format!("meshwright-fuzz-{target}-{round}"));
            let _ = std::fs::write(&path, &bytes);
            assert!(result.is_ok(), "round {round} panicked; its bytes are in {}", path.display());
            panic!("round {round} took {took} bytes for {}, which are in {}", bytes.len(), path.display());
        }
    }
}

macro_rules! fuzz_tests {
    ($($target:ident),* $(,)?) => {
        $(#[test]
        fn $target() {
            fuzz(stringify!($target));
        })*

        #[test]
        fn every_target_is_run() {
            let run = [$(stringify!($target)),*];
            assert_eq!(targets::TARGETS.map(|(target, _)| target), run);
            let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/fuzz_targets");
            for (target, name) in targets::TARGETS {
                let text = std::fs::read_to_string(folder.join(format!("{target}.rs"))).expect("a target's file");
                assert!(text.contains(&format!("\"{name}\"")), "{target}");
            }
        }
    };
}

fuzz_tests!(any, bezier, collada, gltf, mtl, obj, off, ply, stl);

/// What reading a file takes at most, per byte of it.
fn reading(name: &str, bytes: Vec<u8>) -> f64 {
    let size = bytes.len();
    let files = [NamedBytes::new(name, bytes)];
    let took = peak(|| drop(formats::read(&files, &mut |_| ControlFlow::Continue(()))));
    took as f64 / size as f64
}

/// A grid of `n` x `n` quads.
fn grid(n: u32) -> Mesh {
    let positions =
        (0..=n).flat_map(|y| (0..=n).map(move |x| Vec3::new(x as f32, y as f32, (x * y) as f32 * 0.01)));
    let quads: Vec<[u32; 4]> = (0..n * n)
        .map(|i| {
            let a = i / n * (n + 1) + i % n;
            [a, a + 1, a + n + 2, a + n + 1]
        })
        .collect();
    Mesh::build(PolygonSoup::new(positions.collect(), &quads)).expect("small").mesh
}

#[test]
fn reading_takes_a_small_multiple_of_the_file() {
    let _turn = turn();
    let mesh = grid(200);
    for format in Format::all().filter(|format| format.can_read() && !format.is_bezier()) {
        let mut files = formats::write(format, &Model::of_mesh("a", mesh.clone())).expect("small");
        let file = files.remove(0);
        if format.code() == "gltf" {
            continue;
        }
        let times = reading(&file.name, file.bytes);
        println!("{}: {times:.1} bytes per byte", format.name());
        assert!(times < 7.0, "{}: {times}", format.name());
    }
}

#[test]
fn promises_and_repetition_take_no_more() {
    let _turn = turn();
    let repeated =
        |head: &str, line: &str, times: usize| format!("{head}{}", line.repeat(times)).into_bytes();
    let mut stl = vec![0; 84 + 50];
    stl[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let cases = [
        ("a.obj", repeated("v 0 0 0\n", "f 1 1 1\n", 50_000)),
        ("a.obj", repeated("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "f 1 2 3\n", 50_000)),
        ("a.obj", repeated("", "v 1 2 3\nvt 1\nvn 1 1 1\nf -1/-1/-1 -1 -1\n", 20_000)),
        ("a.obj", repeated("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "o a\ng b\ns 1\nusemtl c\nf 1 2 3\n", 20_000)),
        ("a.obj", repeated("v 0 0 0\n", "f 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n", 20_000)),
        ("a.ply", repeated("ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n", "1\n", 99_999)),
        ("a.ply", repeated("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nelement face 4000000000\nproperty list int int vertex_indices\nend_header\n0\n", "4000000000 ", 9_999)),
        ("a.ply", repeated("ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty uchar q\nend_header\n", "x", 99_999)),
        ("a.off", repeated("OFF 4000000000 4000000000 0\n", "0 0 0\n", 50_000)),
        ("a.off", repeated("OFF 1 4000000000 0\n0 0 0\n", "9000000000 1 ", 50_000)),
        ("a.stl", stl),
        ("a.stl", repeated("solid\n", "facet vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endfacet\n", 20_000)),
        ("a.bez", repeated("4000000000\n", "1 ", 99_999)),
        ("a.bzc", repeated("900\n", "1 ", 99_999)),
        ("a.dae", repeated("<COLLADA>", "<a>", 50_000)),
        ("a.dae", repeated("<COLLADA ", "a=\"\" ", 50_000)),
        ("a.dae", repeated("<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\">]><COLLADA>", "&a;", 50_000)),
        ("a.gltf", br#"{"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,"type":"VEC3","count":4000000000}]}"#.to_vec()),
        ("a.gltf", repeated("{\"asset\":", "[", 99_999)),
    ];
    for (name, bytes) in cases {
        let size = bytes.len();
        let head = String::from_utf8_lossy(&bytes[..60.min(size)]).into_owned();
        let times = reading(name, bytes);
        // Small files have their share of what is there whatever the size.
        let limit = 30.0 + 1e6 / size as f64;
        println!("{name}: {times:.1} bytes per byte");
        assert!(times < limit, "{name} {head:?}: {times}");
    }
}
