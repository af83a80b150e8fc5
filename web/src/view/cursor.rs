//! The 3D cursor: a place that edits can turn about and that elements can be moved to.

use editor::Editor;
use glam::{DVec3, Vec3};

/// Where the cursor is, and whether it is drawn. It is kept with the document's view.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Cursor {
    /// The place in the coordinates of files, which include the document's offset.
    pub at: DVec3,
    pub is_shown: bool,
}

impl Cursor {
    /// Puts the cursor at a place of the scene, and shows it.
    pub fn place(&mut self, at: Vec3, editor: &Editor) {
        *self = Self { at: at.as_dvec3() + editor.document().offset(), is_shown: true };
    }

    /// The place in the scene.
    pub fn in_scene(&self, editor: &Editor) -> Vec3 {
        (self.at - editor.document().offset()).as_vec3()
    }
}
