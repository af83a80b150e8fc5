//! Commands: an operation and the object it is for, with their JSON form.

use super::json::take_symmetry;
use super::symmetry::{self, Symmetry};
use super::{Action, Op, OpId};
use crate::error::{CommandError, Problem};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

/// A command: an operation, and which object it is for.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// The place of the object in the document's list; none for the active one.
    pub object: Option<usize>,
    /// The axis along which the edit is mirrored. Only operations on elements have one.
    pub symmetry: Symmetry,
    /// What to do.
    pub op: Op,
}

impl Command {
    /// Reads a command's JSON.
    ///
    /// # Errors
    /// Names the op, and the field where one is missing, unknown, of the wrong type or not finite.
    pub fn from_json(text: &str) -> Result<Self, CommandError> {
        let value = serde_json::from_str(text).map_err(|error| {
            CommandError::refused("command", format!("this is not JSON: {}", formats::json_fault(&error)))
        })?;
        Self::from_value(value)
    }

    /// Reads a command from parsed JSON; see [`Command::from_json`].
    pub fn from_value(value: Value) -> Result<Self, CommandError> {
        let Value::Object(mut fields) = value else {
            return Err(CommandError::refused(
                "command",
                "a command is a JSON object such as {\"op\": \"split-edge\", \"edge\": 3}",
            ));
        };
        let fail = |op: &str, problem: Problem| Err(CommandError::of(op, problem));
        let name = match fields.remove("op") {
            Some(Value::String(name)) => name,
            Some(other) => {
                let text = format!("{other} is not the name of an op, in quotes");
                return fail("command", Problem::field("op", text));
            }
            None => return fail("command", Problem::of_field("op", "is missing: it names what to do")),
        };
        let object = match fields.remove("object") {
            None => None,
            Some(value) => match value.as_u64().and_then(|at| usize::try_from(at).ok()) {
                Some(at) => Some(at),
                None => {
                    let text = format!("{value} is not the place of an object (0, 1, …)");
                    return fail(&name, Problem::field("object", text));
                }
            },
        };
        match OpId::named(&name) {
            Some(id) => Ok(Self { object, ..Self::from_fields(id, fields)? }),
            None => Err(CommandError::refused(&*name, unknown(&name))),
        }
    }

    /// A command from an operation's fields: what forms make.
    ///
    /// # Errors
    /// As [`Command::from_json`].
    pub fn from_fields(id: OpId, mut fields: Map<String, Value>) -> Result<Self, CommandError> {
        let of = |problem| CommandError::of(id.spec().name, problem);
        let symmetry = take_symmetry(id.spec(), &mut fields).map_err(of)?;
        let op = id.parse(fields).map_err(of)?;
        Ok(Self { object: None, symmetry, op })
    }

    /// The command's JSON, which reads back as the same command.
    pub fn to_value(&self) -> Value {
        let mut object = Map::new();
        object.insert("op".into(), self.name().into());
        if let Some(at) = self.object {
            object.insert("object".into(), at.into());
        }
        object.extend(self.fields());
        Value::Object(object)
    }

    /// The operation's fields as JSON, those that are set.
    pub fn fields(&self) -> Map<String, Value> {
        let mut fields = match self.op.to_fields() {
            Value::Object(fields) => fields,
            _ => Map::new(),
        };
        if self.symmetry != Symmetry::None {
            fields.insert(symmetry::FIELD_NAME.to_owned(), self.symmetry.name().into());
        }
        fields
    }

    /// The command's JSON as text.
    pub fn to_json(&self) -> String {
        self.to_value().to_string()
    }

    /// The same command with a mirror, where its operation can be mirrored.
    #[must_use]
    pub fn mirrored(self, symmetry: Symmetry) -> Self {
        let can_be = self.op.spec().field(symmetry::FIELD_NAME).is_some();
        if can_be { Self { symmetry, ..self } } else { self }
    }

    /// The op's name.
    pub fn name(&self) -> &'static str {
        self.op.spec().name
    }

    /// Whether the command names no object and is for all of a mesh rather than for some of its
    /// elements or for the list of objects: the command line runs such a command on every object.
    pub fn is_for_whole_meshes(&self) -> bool {
        let whole = match self.op.action() {
            Action::WholeMesh(whole) => whole.is_for_each_object(),
            Action::Local(_) => self.op.is_open() && self.op.is_for_every_element(),
            Action::Document(_) | Action::Select(_) => false,
        };
        self.object.is_none() && whole
    }

    /// The same command for the object at this place of the document's list.
    #[must_use]
    pub fn on(self, object: usize) -> Self {
        Self { object: Some(object), ..self }
    }
}

impl Serialize for Command {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.to_value().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Command {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::from_value(Value::deserialize(deserializer)?).map_err(Error::custom)
    }
}

impl Op {
    /// Whether it works on every element where none is given or selected.
    fn is_for_every_element(&self) -> bool {
        self.spec()
            .fields
            .iter()
            .any(|field| field.fill == super::Fill::Selection(super::Selected::AllOrEvery))
    }
}

/// Says that an op is not known, with the name that looks like it.
fn unknown(name: &str) -> String {
    let near = OpId::ALL
        .iter()
        .map(|id| id.spec().name)
        .find(|known| known.contains(name) || name.contains(known) || known.replace('-', "_") == name);
    match near {
        Some(near) if !name.is_empty() => format!("there is no such op; did you mean `{near}`?"),
        _ => "there is no such op".to_owned(),
    }
}
