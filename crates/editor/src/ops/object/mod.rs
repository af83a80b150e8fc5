//! Operations on objects: which there are, what they are called, and what they are made of.

mod activate_object;
mod delete_object;
mod join_objects;
mod new;
mod rename_object;
mod repair_import;
mod separate;
mod set_object_visible;

pub use activate_object::*;
pub use delete_object::*;
pub use join_objects::*;
pub use new::*;
pub use rename_object::*;
pub use repair_import::*;
pub use separate::*;
pub use set_object_visible::*;
