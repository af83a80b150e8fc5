//! Local edits: one by one, on hard cases, and in long random sequences.

mod any_edit;
mod attributes;
mod bevel;
mod bridge;
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
mod slide_along;
mod touching;
mod zoo;
