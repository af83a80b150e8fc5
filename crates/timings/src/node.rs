//! The jobs as JavaScript sees them.

use wasm_bindgen::prelude::wasm_bindgen;

/// The names of the jobs.
#[wasm_bindgen]
pub fn names() -> Vec<String> {
    crate::JOBS.iter().map(|(name, _)| (*name).to_owned()).collect()
}

/// A job with its input.
#[wasm_bindgen]
pub struct Job(crate::Prepared);

#[wasm_bindgen]
impl Job {
    /// The job with this number, or undefined.
    pub fn prepare(number: usize) -> Option<Self> {
        crate::JOBS.get(number).map(|(_, prepare)| Self(prepare()))
    }

    /// Does it once.
    pub fn run(&mut self) {
        (self.0)();
    }
}
