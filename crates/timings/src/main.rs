//! Times each job natively. Prints a line for each: its name, a tab, and the time of its best run in milliseconds.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

use std::time::Instant;

fn main() {
    let runs = std::env::args().nth(1).and_then(|runs| runs.parse().ok()).unwrap_or(5);
    for (name, prepare) in timings::JOBS {
        let mut job = prepare();
        let mut best = f64::INFINITY;
        for _ in 0..runs {
            let start = Instant::now();
            job();
            best = best.min(start.elapsed().as_secs_f64());
        }
        println!("{name}\t{:.1}", best * 1e3);
    }
}
