//! Access to the JSON of a document, field by field, so that a fault in one field costs only what needs it.

use crate::text::json_fault::json_fault;
use glam::{DMat4, DQuat};
use serde_json::Value;

/// The largest range of whole numbers that a 64-bit float holds exactly: 2 to the power of 53.
const MAX_WHOLE_NUMBER: f64 = 9_007_199_254_740_992.0;

/// A top-level list of a document: its key, and what messages call one item.
#[derive(Clone, Copy)]
pub(super) struct List {
    key: &'static str,
    one: &'static str,
}

pub(super) const ACCESSORS: List = List { key: "accessors", one: "accessor" };
pub(super) const BUFFERS: List = List { key: "buffers", one: "buffer" };
pub(super) const BUFFER_VIEWS: List = List { key: "bufferViews", one: "buffer view" };
pub(super) const IMAGES: List = List { key: "images", one: "image" };
pub(super) const MATERIALS: List = List { key: "materials", one: "material" };
pub(super) const MESHES: List = List { key: "meshes", one: "mesh" };
pub(super) const NODES: List = List { key: "nodes", one: "node" };
pub(super) const SAMPLERS: List = List { key: "samplers", one: "sampler" };
pub(super) const SCENES: List = List { key: "scenes", one: "scene" };
pub(super) const SKINS: List = List { key: "skins", one: "skin" };
pub(super) const TEXTURES: List = List { key: "textures", one: "texture" };

/// A whole document.
pub(super) struct Document(Value);

impl Document {
    /// # Errors
    /// When the text is not a JSON object.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        // Some programs pad the text with zeros.
        let text = text.trim_end_matches(['\0', ' ']);
        match serde_json::from_str(text) {
            Ok(root @ Value::Object(_)) => Ok(Self(root)),
            Ok(_) => Err("its JSON is no object".to_owned()),
            Err(error) => Err(format!("its JSON can't be read, because {}", json_fault(&error))),
        }
    }

    pub(super) fn root(&self) -> Object<'_> {
        Object(&self.0)
    }

    /// The items of a list; empty if the document has none.
    pub(super) fn items(&self, list: List) -> impl ExactSizeIterator<Item = Object<'_>> {
        self.root().list(list.key).iter().map(Object)
    }

    /// How many items a list has.
    pub(super) fn count(&self, list: List) -> usize {
        self.root().list(list.key).len()
    }

    /// An item of a list by its number.
    ///
    /// # Errors
    /// When there is none.
    pub(super) fn item(&self, list: List, index: usize) -> Result<Object<'_>, String> {
        let item = self.root().list(list.key).get(index).map(Object);
        item.ok_or_else(|| format!("{} {index} doesn't exist", list.one))
    }

    /// What messages call an item: `mesh "chair"`, or `mesh 3` without a name.
    pub(super) fn label(&self, list: List, index: usize) -> String {
        match self.item(list, index).ok().and_then(|item| item.name()) {
            Some(name) => format!("{} \"{name}\"", list.one),
            None => format!("{} {index}", list.one),
        }
    }
}

/// A JSON object. A value of another type counts as an object without fields.
#[derive(Clone, Copy)]
pub(super) struct Object<'d>(&'d Value);

impl<'d> Object<'d> {
    pub(super) fn get(self, key: &str) -> Option<&'d Value> {
        self.0.get(key).filter(|value| !value.is_null())
    }

    /// The names and values of its fields.
    pub(super) fn fields(self) -> impl Iterator<Item = (&'d str, &'d Value)> {
        self.0.as_object().into_iter().flatten().map(|(key, value)| (key.as_str(), value))
    }

    pub(super) fn object(self, key: &str) -> Option<Object<'d>> {
        self.get(key).filter(|value| value.is_object()).map(Object)
    }

    /// The data of an extension.
    pub(super) fn extension(self, name: &str) -> Option<Object<'d>> {
        self.object("extensions")?.object(name)
    }

    /// The items of a list; empty if the field is missing or not a list.
    pub(super) fn list(self, key: &str) -> &'d [Value] {
        self.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
    }

    /// The objects in a list.
    pub(super) fn objects(self, key: &str) -> impl ExactSizeIterator<Item = Object<'d>> {
        self.list(key).iter().map(Object)
    }

    pub(super) fn text(self, key: &str) -> Option<&'d str> {
        self.get(key)?.as_str()
    }

    /// Its name, unless it is empty.
    pub(super) fn name(self) -> Option<&'d str> {
        self.text("name").filter(|name| !name.is_empty())
    }

    pub(super) fn flag(self, key: &str) -> Option<bool> {
        self.get(key)?.as_bool()
    }

    /// A finite number; `None` if the field is missing or anything else.
    pub(super) fn number(self, key: &str) -> Option<f64> {
        self.get(key)?.as_f64().filter(|number| number.is_finite())
    }

    /// A whole number of at least 0; `None` if the field is missing. `3.0` is a whole number.
    ///
    /// # Errors
    /// When the field is anything else.
    pub(super) fn index(self, key: &str) -> Result<Option<usize>, String> {
        let Some(value) = self.get(key) else { return Ok(None) };
        whole(value).map(Some).ok_or_else(|| format!("its \"{key}\" is not a whole number"))
    }

    /// [`index`](Self::index), or `default` if the field is missing.
    pub(super) fn index_or(self, key: &str, default: usize) -> Result<usize, String> {
        Ok(self.index(key)?.unwrap_or(default))
    }

    /// [`index`](Self::index) of a required field.
    pub(super) fn required_index(self, key: &str) -> Result<usize, String> {
        self.index(key)?.ok_or_else(|| format!("it has no \"{key}\""))
    }

    /// A list of `N` finite numbers; `None` if the field is missing.
    ///
    /// # Errors
    /// When the field is anything else.
    pub(super) fn numbers<const N: usize>(self, key: &str) -> Result<Option<[f64; N]>, String> {
        let Some(value) = self.get(key) else { return Ok(None) };
        let numbers: Vec<f64> = value.as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
        let all = <[f64; N]>::try_from(numbers).ok().filter(|all| all.iter().all(|n| n.is_finite()));
        all.map(Some).ok_or_else(|| format!("its \"{key}\" is not {N} numbers"))
    }

    /// The local transform of a node.
    ///
    /// # Errors
    /// When a part of it can't be read.
    pub(super) fn transform(self) -> Result<DMat4, String> {
        if let Some(matrix) = self.numbers::<16>("matrix")? {
            return Ok(DMat4::from_cols_array(&matrix));
        }
        let rotation = self.numbers::<4>("rotation")?.map_or(DQuat::IDENTITY, |rotation| {
            let rotation = DQuat::from_array(rotation);
            if rotation.length() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY }
        });
        Ok(DMat4::from_scale_rotation_translation(
            self.numbers::<3>("scale")?.unwrap_or([1.0; 3]).into(),
            rotation,
            self.numbers::<3>("translation")?.unwrap_or_default().into(),
        ))
    }
}

/// The value as a whole number. Like JSON Schema, accepts 3.0 as an integer.
pub(super) fn whole(value: &Value) -> Option<usize> {
    if let Some(number) = value.as_u64() {
        return usize::try_from(number).ok();
    }
    let number = value.as_f64()?;
    ((0.0..=MAX_WHOLE_NUMBER).contains(&number) && number.fract() == 0.0).then_some(number as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_with_a_zero_fraction_are_whole() {
        let document = Document::parse(r#"{"a": 3.0, "b": 3.5, "c": -1, "d": 1e3, "e": null, "f": "3"}"#);
        let document = document.expect("JSON");
        let root = document.root();
        assert_eq!(root.index("a"), Ok(Some(3)));
        assert_eq!(root.index("d"), Ok(Some(1000)));
        assert_eq!((root.index("e"), root.index("g")), (Ok(None), Ok(None)));
        for key in ["b", "c", "f"] {
            assert_eq!(root.index(key), Err(format!("its \"{key}\" is not a whole number")));
        }
    }

    #[test]
    fn fields_of_other_types_are_missing() {
        let document = Document::parse(r#"{"nodes": [{"name": ""}, 7, {"name": "x"}], "meshes": {}}"#);
        let document = document.expect("JSON");
        assert_eq!((document.count(NODES), document.count(MESHES)), (3, 0));
        assert_eq!([0, 1, 2].map(|i| document.label(NODES, i)), ["node 0", "node 1", "node \"x\""]);
        assert_eq!(document.item(NODES, 3).err().as_deref(), Some("node 3 doesn't exist"));
        let node = document.item(NODES, 1).expect("it is there");
        assert_eq!((node.text("name"), node.transform()), (None, Ok(DMat4::IDENTITY)));
    }
}
