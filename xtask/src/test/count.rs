//! Counts tests from the output of their runners.

use std::ops::AddAssign;

/// How many tests passed, failed and were left out, and the names of those that were.
#[derive(Clone, Default, Debug, PartialEq, Eq)]
pub struct Count {
    pub passed: u32,
    pub failed: u32,
    pub left_out: Vec<String>,
}

impl Count {
    /// The count of a check that has no tests of its own: one.
    pub fn check(passed: bool) -> Self {
        Self { passed: u32::from(passed), failed: u32::from(!passed), left_out: Vec::new() }
    }

    /// Adds what a line of output reports: `test result: ok. 3 passed; 0 failed; …` and `test name ... ignored` from Rust's test
    /// runner, in a browser too, or `ℹ pass 3`, `ℹ fail 0` and `﹣ name (0.1ms) # SKIP` from Node's.
    pub fn read(&mut self, line: &str) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["test", "result:", _, passed, "passed;", failed, "failed;", ..] => {
                self.passed += number(passed);
                self.failed += number(failed);
            }
            ["test", name, "...", "ignored" | "ignored,", ..] => self.left_out.push((*name).to_owned()),
            ["﹣", ..] => self.left_out.push(line.trim_start_matches(['﹣', ' ']).to_owned()),
            ["ℹ", "pass", passed] => self.passed += number(passed),
            ["ℹ", "fail" | "cancelled", failed] => self.failed += number(failed),
            _ => {}
        }
    }
}

impl AddAssign for Count {
    fn add_assign(&mut self, other: Self) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.left_out.extend(other.left_out);
    }
}

fn number(word: &str) -> u32 {
    word.parse().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(lines: &[&str]) -> Count {
        let mut count = Count::default();
        lines.iter().for_each(|line| count.read(line));
        count
    }

    #[test]
    fn adds_up_rust_results() {
        let lines = [
            "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.01s",
            "test result: FAILED. 3 passed; 2 failed; 0 ignored; 0 filtered out",
        ];
        assert_eq!(count(&lines), Count { passed: 15, failed: 2, left_out: Vec::new() });
    }

    #[test]
    fn adds_up_node_results() {
        let lines = ["ℹ tests 5", "ℹ suites 2", "ℹ pass 3", "ℹ fail 1", "ℹ cancelled 1", "ℹ skipped 0"];
        assert_eq!(count(&lines), Count { passed: 3, failed: 2, left_out: Vec::new() });
    }

    #[test]
    fn what_is_left_out_is_named() {
        let lines = [
            "test reads_shared::a_teapot_opens ... ignored, MESHWRIGHT_NO_SHARED is set",
            "test plain ... ok",
            "﹣ real models open (webgpu, small) (0.08ms) # MESHWRIGHT_NO_SHARED is set",
        ];
        assert_eq!(
            count(&lines).left_out,
            [
                "reads_shared::a_teapot_opens",
                "real models open (webgpu, small) (0.08ms) # MESHWRIGHT_NO_SHARED is set",
            ]
        );
    }

    #[test]
    fn other_lines_count_nothing() {
        assert_eq!(count(&["running 3 tests", "test result: odd", "pass 3", ""]), Count::default());
    }
}
