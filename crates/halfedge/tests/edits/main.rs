//! Local edits: each on its own, the hard cases, and long random sequences of all of them.

mod basics;
mod random;
mod zoo;
