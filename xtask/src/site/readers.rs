//! The page's program holds no readers of files: only the worker opens them.

use std::fs;
use std::path::Path;

use super::weight;
use crate::shell::Result;

/// Crates that only readers of models and images call.
const READERS: [&str; 3] = ["draco_core", "meshoptimizer_rs", "zune_jpeg"];

/// Refuses the page's module, which has the names of its functions still, where readers have become part of it.
pub fn refuse_module(module: &Path) -> Result {
    let bytes = fs::read(module).map_err(|error| format!("{} can't be read: {error}.", module.display()))?;
    refuse(&weight::by_crate(&bytes)?)
}

fn refuse(weights: &[(String, usize)]) -> Result {
    let is_reader = |(name, bytes): &&(String, usize)| *bytes > 0 && READERS.contains(&name.as_str());
    match weights.iter().find(is_reader) {
        None => Ok(()),
        Some((name, bytes)) => Err(format!(
            "the page's program holds {bytes} bytes of {name}, which only the worker needs: what the page calls reaches \
             `formats::read`, `formats::write` or `Picture::decode` (`twiggy paths` says how). Do that in a job."
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_with_readers_is_refused() {
        let weights = |crates: &[(&str, usize)]| {
            crates.iter().map(|(name, bytes)| ((*name).to_owned(), *bytes)).collect::<Vec<_>>()
        };
        assert!(refuse(&weights(&[("egui", 90), ("draco_core", 0)])).is_ok());
        let refusal = refuse(&weights(&[("egui", 90), ("draco_core", 7)])).expect_err("refused");
        assert!(refusal.contains("7 bytes of draco_core"), "{refusal}");
    }
}
