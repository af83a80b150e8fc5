//! Operations on objects: which there are, what they are called, and what they are made of.

mod activate_object;
mod delete_object;
mod join_objects;
mod new;
mod rename_object;
mod repair_import;
mod separate;
mod set_object_visible;

pub use activate_object::ActivateObject;
pub use delete_object::DeleteObject;
pub use join_objects::JoinObjects;
pub use new::New;
pub use rename_object::RenameObject;
pub use repair_import::RepairImport;
pub use separate::{By, Separate};
pub use set_object_visible::SetObjectVisible;
