//! Writing a plan.

use super::Plan;
use crate::attribute::{Value, keys};
use crate::edit::Made;
use crate::edit::shared::Blend;
use crate::{Element, Mesh};

impl Plan {
    /// Writes the plan to the mesh that it was made for.
    pub(crate) fn apply(self, mesh: &mut Mesh) -> Made {
        // Values of corners, and of edges that become one, are read before anything is written.
        let values = self.corner_values(mesh);
        let creases = self.creases(mesh);
        self.write_links(mesh);
        let corners = || self.patch.faces.iter().flat_map(|face| &face.corners);
        for (column, values) in values.into_iter().enumerate() {
            for ((value, side), corner) in values.into_iter().zip(&self.sides).zip(corners()) {
                let is_own = matches!(corner.value, Blend::Copy(from) if from == side.raw());
                if let Some(value) = value.filter(|_| !is_own) {
                    mesh.set_value(Element::Halfedge, column, side.index(), value);
                }
            }
        }
        for (edge, crease) in creases {
            if crease > mesh.get(keys::EDGE_CREASE, edge) {
                mesh.set(keys::EDGE_CREASE, edge, crease);
            }
        }
        let Made { removed_vertices, removed_edges, removed_faces, .. } = &self.made;
        for &face in removed_faces {
            mesh.mark(Element::Face, face.raw(), true);
        }
        for &edge in removed_edges {
            mesh.mark(Element::Edge, edge.raw(), true);
        }
        for &v in removed_vertices {
            mesh.mark(Element::Vertex, v.raw(), true);
        }
        self.made
    }

    /// Per column of half-edges: the value of each new corner.
    fn corner_values(&self, mesh: &Mesh) -> Vec<Vec<Option<Value>>> {
        let corners = || self.patch.faces.iter().flat_map(|face| &face.corners);
        let columns = mesh.columns.of(Element::Halfedge).iter();
        columns.map(|column| corners().map(|corner| corner.value.of(column)).collect()).collect()
    }

    /// Existing edges that others become, with the creases of those.
    fn creases(&self, mesh: &Mesh) -> Vec<(usize, f32)> {
        let corners = self.patch.faces.iter().flat_map(|face| &face.corners);
        corners
            .zip(&self.sides)
            .filter_map(|(corner, side)| Some((corner.replaces?.edge(), side.edge().index())))
            .filter(|(replaced, edge)| replaced.index() != *edge && *edge < mesh.edge_capacity())
            .map(|(replaced, edge)| (edge, mesh.get(keys::EDGE_CREASE, replaced.index())))
            .collect()
    }

    /// Adds vertices, edges and faces, and links everything.
    fn write_links(&self, mesh: &mut Mesh) {
        for vertex in &self.patch.vertices {
            let v = mesh.add_vertex(vertex.position);
            mesh.blend_attributes(Element::Vertex, &vertex.value, v.raw());
        }
        for &(u, v, attributes_of) in &self.new_edges {
            let h = mesh.add_edge(u, v);
            if let Some(edge) = attributes_of {
                mesh.copy_attributes(Element::Edge, edge.raw(), h.edge().raw());
            }
        }
        for &(h, u, v) in &self.moved_edges {
            mesh.set_to(h, v);
            mesh.set_to(h.twin(), u);
        }
        for &h in &self.freed_sides {
            mesh.set_face(h, None);
        }
        let mut first = 0;
        for (face, &id) in self.patch.faces.iter().zip(&self.face_ids) {
            let sides = &self.sides[first..first + face.corners.len()];
            first += face.corners.len();
            match face.id {
                Some(id) => mesh.set_face_halfedge(id, sides[0]),
                None => {
                    mesh.add_face(sides[0]);
                    if let Some(other) = face.attributes_of {
                        mesh.copy_attributes(Element::Face, other.raw(), id.raw());
                        mesh.record_face_source(id, other);
                    }
                }
            }
            for (&h, &next) in sides.iter().zip(sides.iter().cycle().skip(1)) {
                mesh.set_face(h, Some(id));
                mesh.link(h, next);
            }
        }
        for &(h, next) in &self.boundary_links {
            mesh.link(h, next);
        }
        for &(h, v) in &self.separated {
            mesh.set_to(h, v);
        }
        for &(v, h) in &self.vertex_halfedges {
            mesh.set_vertex_halfedge(v, Some(h));
        }
    }
}
