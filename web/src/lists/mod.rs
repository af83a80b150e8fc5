//! The lists of vertices, edges, half-edges and faces: exact and smooth at any number of rows.

pub mod columns;
pub mod index;
mod ranked_set;
pub mod row_list;
mod scroll;
