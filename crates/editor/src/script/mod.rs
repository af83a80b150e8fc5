//! Texts about commands, generated from the operations' [`Spec`](crate::Spec)s: the command line's help,
//! the TypeScript types and the operations reference.

mod help;
mod reference;
mod types;
mod words;

pub use help::{operation_help, operations_help};
pub use reference::operations_reference;
pub use types::typescript_types;
