//! Counting tests from what the runners print.

use std::ops::AddAssign;

/// How many tests passed and failed.
#[derive(Clone, Copy, Default, Debug, PartialEq, Eq)]
pub struct Count {
    pub passed: u32,
    pub failed: u32,
}

impl Count {
    /// A check that is not made of tests counts as one.
    pub fn check(passed: bool) -> Self {
        Self { passed: u32::from(passed), failed: u32::from(!passed) }
    }

    /// Adds what a line says: `test result: ok. 3 passed; 0 failed; …` from Rust's test runner, in a browser too,
    /// or `ℹ pass 3` and `ℹ fail 0` from Node's.
    pub fn read(&mut self, line: &str) {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words.as_slice() {
            ["test", "result:", _, passed, "passed;", failed, "failed;", ..] => {
                self.passed += number(passed);
                self.failed += number(failed);
            }
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
        assert_eq!(count(&lines), Count { passed: 15, failed: 2 });
    }

    #[test]
    fn adds_up_node_results() {
        let lines = ["ℹ tests 5", "ℹ suites 2", "ℹ pass 3", "ℹ fail 1", "ℹ cancelled 1", "ℹ skipped 0"];
        assert_eq!(count(&lines), Count { passed: 3, failed: 2 });
    }

    #[test]
    fn other_lines_count_nothing() {
        assert_eq!(count(&["running 3 tests", "test result: odd", "pass 3", ""]), Count::default());
    }
}
