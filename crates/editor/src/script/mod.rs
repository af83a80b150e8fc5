//! The editor as scripts see it: commands and the state as JSON, and the texts generated from the operations'
//! [`Spec`](crate::Spec)s (the command line's help, the TypeScript types and the operations reference).

mod help;
pub(crate) mod json;
mod reference;
mod state;
mod types;
mod words;

pub use help::{operation_help, operations_help};
pub use reference::operations_reference;
pub use state::{element_kind, element_name};
pub use types::typescript_types;
