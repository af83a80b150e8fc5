//! Texts about commands, made from the operations' [`Spec`](crate::Spec)s: the help of the command
//! line, the types for TypeScript and the operations reference.

mod help;
mod reference;
mod types;
mod words;

pub use help::{operation_help, operations_help};
pub use reference::operations_reference;
pub use types::typescript_types;
