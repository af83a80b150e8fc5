//! The jobs for JavaScript.

use wasm_bindgen::prelude::wasm_bindgen;

/// The names of the jobs.
#[wasm_bindgen]
pub fn names() -> Vec<String> {
    crate::JOBS.iter().map(|(name, _)| (*name).to_owned()).collect()
}

/// A job whose input has been made.
#[wasm_bindgen]
pub struct Job(crate::Prepared);

#[wasm_bindgen]
impl Job {
    /// The job with this number, or undefined.
    pub fn prepare(number: usize) -> Option<Self> {
        crate::JOBS.get(number).map(|(_, prepare)| Self(prepare()))
    }

    /// Runs the job once.
    pub fn run(&mut self) {
        (self.0)();
    }
}
