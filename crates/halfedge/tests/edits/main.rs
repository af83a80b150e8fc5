//! Local edits: each on its own, the hard cases, and long random sequences of all of them.

mod attributes;
mod cmu462;
mod collapse;
mod dissolve;
mod ears;
mod flip;
mod grow;
mod large;
mod random;
mod refusals;
mod rings;
mod sew;
mod touching;
mod zoo;
