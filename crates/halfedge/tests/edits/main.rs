//! Local edits: each alone, hard cases, and long random sequences of all of them.

mod any_edit;
mod attributes;
mod bevel;
mod cmu462;
mod collapse;
mod dissolve;
mod ears;
mod flip;
mod follow;
mod grow;
mod large;
mod linear;
mod random;
mod refusals;
mod rings;
mod sew;
mod touching;
mod zoo;
