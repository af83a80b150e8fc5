//! Which crates deny code that panics.

use super::source::Source;
use super::{CrateLines, Measure};

/// Denied in every crate that is shipped.
const DENIED: [&str; 4] = ["unwrap_used", "expect_used", "panic", "unreachable"];
/// Denied besides, except where flat columns are indexed by ids of their own mesh.
const DENIED_OUTSIDE_KERNELS: &str = "indexing_slicing";
const KERNELS: [&str; 2] = ["crates/halfedge", "crates/surface"];

/// The crate roots, `src/lib.rs` and `src/main.rs`, that don't deny what input could make panic. A lint table in
/// Cargo.toml would hold for tests too, which fail by panicking.
pub fn roots_that_allow_panics(crates: &[CrateLines]) -> Measure {
    let mut found = Vec::new();
    for one in crates {
        let roots = one.sources.iter().filter(|source| {
            let path = source.path.strip_prefix(&one.name).unwrap_or(&source.path);
            path.ends_with("src/lib.rs") || path.ends_with("src/main.rs")
        });
        let is_kernel = KERNELS.contains(&one.name.as_str());
        let denied = DENIED.into_iter().chain((!is_kernel).then_some(DENIED_OUTSIDE_KERNELS));
        let denied: Vec<&str> = denied.collect();
        for root in roots {
            let missing: Vec<&str> = denied.iter().copied().filter(|lint| !denies(root, lint)).collect();
            if !missing.is_empty() {
                found.push(format!("{}: {}", root.path.display(), missing.join(", ")));
            }
        }
    }
    Measure {
        name: "crate roots that don't deny code that panics".to_owned(),
        value: found.len(),
        limit: 0,
        is_enforced: true,
        details: found,
    }
}

/// Whether a crate root has `#![cfg_attr(not(test), deny(…clippy::lint…))]`.
fn denies(root: &Source, lint: &str) -> bool {
    let all = root.tokens();
    let mut denying = false;
    for (at, token) in all.iter().enumerate() {
        let next_is = |text: &str| all.get(at + 1).is_some_and(|next| next.is(text));
        if token.is("#") && next_is("!") {
            denying = false;
        } else if token.is("deny") || token.is("forbid") {
            denying = true;
        } else if denying && token.is(lint) {
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_denied_counts() {
        let text = "#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::panic))]\n#![allow(clippy::expect_used)]";
        let root = Source::new("src/lib.rs", text);
        assert!(denies(&root, "unwrap_used") && denies(&root, "panic"));
        assert!(!denies(&root, "expect_used"));
    }
}
