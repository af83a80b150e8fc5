//! The group statements of an OBJ.

use crate::obj::names::{clean, group_lines, spaced};
use halfedge::{Element, Mesh, NONE, keys};

/// The `o` and `g` statements of one mesh.
pub(super) struct Groups<'a> {
    values: Option<&'a [u32]>,
    /// The names in the statements of each label.
    names: Vec<(String, String)>,
    current: u32,
    /// The names that apply at this place of the file.
    written: (String, String),
}

impl<'a> Groups<'a> {
    pub(super) fn new(mesh: &'a Mesh, section: Option<String>) -> Self {
        let labels =
            mesh.column(Element::Face, keys::FACE_GROUP.name).map_or(&[][..], |column| &column.labels);
        let names = labels
            .iter()
            .map(|label| {
                let (object, group) = group_lines(label);
                match &section {
                    None => (clean(object), spaced(&clean(group))),
                    // The section has the `o` statement: a label that is one becomes a group.
                    Some(section) if group.is_empty() => (section.clone(), spaced(&clean(object))),
                    Some(section) => (section.clone(), spaced(&clean(group))),
                }
            })
            .collect();
        Self {
            values: mesh.attribute(keys::FACE_GROUP),
            names,
            current: NONE,
            written: (section.unwrap_or_default(), String::new()),
        }
    }

    fn value(&self, face: usize) -> u32 {
        self.values.and_then(|values| values.get(face)).copied().unwrap_or(NONE)
    }

    /// Whether this face is in another group than the one before: most are not.
    #[inline]
    pub(super) fn differs(&self, face: usize) -> bool {
        self.value(face) != self.current
    }

    /// The names of the `o` and `g` statements to write before this face, as far as they change; an empty name
    /// ends the previous one.
    pub(super) fn enter(&mut self, face: usize) -> (Option<String>, Option<String>) {
        let value = self.value(face);
        self.current = value;
        let nothing = (if value == NONE { String::new() } else { self.written.0.clone() }, String::new());
        let (object, group) = self.names.get(value as usize).cloned().unwrap_or(nothing);
        let is_new_object = object != self.written.0;
        if is_new_object {
            // It ends the group, too.
            self.written.1.clear();
        }
        let is_new_group = group != self.written.1;
        self.written = (object.clone(), group.clone());
        (is_new_object.then_some(object), is_new_group.then_some(group))
    }
}
