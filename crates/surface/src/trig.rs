//! Sine and cosine from additions and multiplications only, which give the same bits on every machine and in
//! WebAssembly. The standard library's differ between systems.

use std::f64::consts::{FRAC_PI_2, TAU};

/// Sine and cosine of `turns` full turns (1 is 360 degrees), each within 1e-15. Quarter turns are exact.
pub(crate) fn sin_cos_turns(turns: f64) -> (f64, f64) {
    let turns = turns - turns.floor();
    let quarters = (turns * 4.0).round();
    let rest = (turns - quarters / 4.0) * TAU;
    let (s, c) = (sin_small(rest), cos_small(rest));
    match quarters as i32 & 3 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// The Taylor series up to x^19, for |x| up to an eighth of a turn: the rest is below 1e-20.
fn sin_small(x: f64) -> f64 {
    debug_assert!(x.abs() <= FRAC_PI_2 / 2.0 + 1e-9);
    let square = x * x;
    let mut sum = 0.0;
    for k in (1..10).rev() {
        let k = f64::from(k);
        sum = (1.0 + sum) * (-square / ((2.0 * k) * (2.0 * k + 1.0)));
    }
    x * (1.0 + sum)
}

fn cos_small(x: f64) -> f64 {
    let square = x * x;
    let mut sum = 0.0;
    for k in (1..11).rev() {
        let k = f64::from(k);
        sum = (1.0 + sum) * (-square / ((2.0 * k - 1.0) * (2.0 * k)));
    }
    1.0 + sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equals_the_standard_library_to_the_last_digits() {
        for i in -1000..3000 {
            let turns = f64::from(i) / 997.0;
            let (s, c) = sin_cos_turns(turns);
            let (es, ec) = (turns * TAU).sin_cos();
            assert!((s - es).abs() < 4e-15 && (c - ec).abs() < 4e-15, "{turns}: {s} {es} {c} {ec}");
        }
        assert_eq!(sin_cos_turns(0.25), (1.0, 0.0));
        assert_eq!(sin_cos_turns(0.5).1, -1.0);
    }
}
