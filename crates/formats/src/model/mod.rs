//! What files hold: named meshes with their materials.

pub(crate) mod attributes;
pub(crate) mod collector;
pub(crate) mod images;
pub(crate) mod labels;
pub(crate) mod material;
pub(crate) mod paint;
pub(crate) mod srgb;
pub(crate) mod texture;

use crate::model::material::Materials;
use glam::DVec3;
use halfedge::{Mesh, PolygonSoup};
use std::borrow::Cow;
use std::sync::Arc;
use surface::bezier::Bezier;

/// A mesh with a name. Clones share the mesh, the control points and the soup.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedMesh {
    /// Its name.
    pub name: String,
    /// The mesh: what was read is valid and compact. A Bezier curve's is empty, and so is a surface's as
    /// it was read.
    pub mesh: Arc<Mesh>,
    /// The control points of a Bezier curve or surface, which the mesh shows.
    pub bezier: Option<Arc<Bezier>>,
    /// The faces as they are in the file, where they had to be changed to form a mesh:
    /// [`rebuild`](crate::rebuild) makes a mesh of them in another way.
    pub soup: Option<Arc<PolygonSoup>>,
}

impl NamedMesh {
    /// A mesh without control points or soup.
    pub fn new(name: impl Into<String>, mesh: impl Into<Arc<Mesh>>) -> Self {
        Self { name: name.into(), mesh: mesh.into(), bezier: None, soup: None }
    }

    /// Whether it is a Bezier curve.
    pub(crate) fn is_curve(&self) -> bool {
        self.bezier.as_ref().is_some_and(|bezier| bezier.curve().is_some())
    }
}

/// What one or several files hold together, or what is written as a document.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Its name: that of the first file, without extension. Written files are named after it.
    pub name: String,
    /// The meshes, in the files' order.
    pub objects: Vec<NamedMesh>,
    /// What to add to every position for the coordinates in files: not zero for models so far from the
    /// origin that 32 bits are too few for their coordinates.
    pub offset: DVec3,
    /// The materials that faces have, with the images that these use.
    pub materials: Materials,
}

impl Model {
    /// A model of one mesh, named like the model.
    pub fn of_mesh(name: &str, mesh: impl Into<Arc<Mesh>>) -> Self {
        Self { name: name.to_owned(), objects: vec![NamedMesh::new(name, mesh)], ..Self::default() }
    }

    /// The model without Bezier curves, which have no mesh.
    pub(crate) fn without_curves(&self) -> Cow<'_, Self> {
        if !self.objects.iter().any(NamedMesh::is_curve) {
            return Cow::Borrowed(self);
        }
        let objects = self.objects.iter().filter(|object| !object.is_curve()).cloned().collect();
        Cow::Owned(Self { objects, ..self.clone() })
    }
}
