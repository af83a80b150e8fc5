//! The mirror images that symmetric edits found, kept for the next update of an ongoing edit.

use crate::document::ObjectId;
use halfedge::Mesh;
use surface::MirrorImages;

/// The images of an object's elements at a revision of the document.
#[derive(Debug, Default)]
pub(super) struct KeptImages(Option<(ObjectId, u64, MirrorImages)>);

impl KeptImages {
    /// The images known of this mesh, if the last ones are of it; else new ones.
    pub fn take(&mut self, mesh: &Mesh, id: ObjectId, revision: u64, axis: usize) -> MirrorImages {
        match self.0.take() {
            Some((of, at, images)) if of == id && at == revision && images.axis() == axis => images,
            _ => MirrorImages::new(mesh, axis),
        }
    }

    /// Keeps images for the next edit of the same revision.
    pub fn keep(&mut self, id: ObjectId, revision: u64, images: MirrorImages) {
        self.0 = Some((id, revision, images));
    }
}
