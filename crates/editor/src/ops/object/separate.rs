//! `separate`: split an object into several.

use crate::MAX_ELEMENTS_AT_ONCE;
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::refs::all;
use crate::ops::{
    Action, FaceRef, Field, FieldKind, NamedMesh, Operation, Scope, Selected, Slot, Spec, Target, WholeMesh,
};
use halfedge::words::thousands;
use halfedge::{Element, FaceId, Mesh, NONE, Progress, keys};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// Split an object into several. The first part stays in the object, and so do isolated vertices.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Separate {
    /// How to divide the object into parts; `faces` where those are given, else connected pieces.
    pub by: Option<By>,
    /// For `By::Faces`: the faces that become an object; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
}

choice! {
    /// How to divide the object into parts.
    pub enum By {
        /// Each connected piece.
        Components = "components" "Connected pieces",
        /// Each face group.
        Groups = "groups" "Face groups",
        /// The given faces, and the rest.
        Faces = "faces" "Selected faces",
    }
}

/// The most objects to make.
const MAX_PARTS: usize = 1000;

impl Operation for Separate {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "separate",
        "Separate",
        "Split an object into several: its connected pieces, its face groups, or some faces and the rest.",
    )
    .synonyms(&["detach", "loose parts", "split object"])
    .fields(&[
        Field::required("by", FieldKind::Choice(By::CHOICES), "How to divide the object into parts")
            .labelled("Separate by")
            .unset("the selected faces, or connected pieces"),
        Field::many("faces", Element::Face, Selected::All, "The faces that become an object"),
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn takes_selection(&self) -> bool {
        self.by == Some(By::Faces)
    }

    fn complete(&mut self, target: &Target<'_>) -> Result<(), Problem> {
        let selected = target.selection;
        let is_some_of_faces = selected.kind() == Element::Face
            && !selected.is_empty()
            && selected.len() < target.mesh.face_count();
        match (self.by, &self.faces) {
            (None, None) if is_some_of_faces => {
                self.by = Some(By::Faces);
                self.faces = Some(selected.ids().map(FaceRef).collect());
            }
            (None, None) => self.by = Some(By::Components),
            (None, Some(_)) => self.by = Some(By::Faces),
            (Some(By::Components | By::Groups), Some(_)) => {
                return Err(Problem::of_field("faces", "goes with \"by\": \"faces\" only"));
            }
            _ => {}
        }
        all(&self.faces, "faces", target.mesh).map(drop)
    }

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl WholeMesh for Separate {
    fn changes_nothing(&self, inputs: &[NamedMesh]) -> Option<&'static str> {
        let faces = || inputs.iter().map(|input| input.mesh.face_count());
        let has_groups = || inputs.iter().any(|input| input.mesh.attribute(keys::FACE_GROUP).is_some());
        let pieces = || inputs.iter().map(|input| input.mesh.components().1).sum::<usize>();
        match self.by {
            _ if faces().all(|count| count == 0) => Some("The mesh has no face."),
            Some(By::Groups) if !has_groups() => Some("No face is in a group."),
            Some(By::Faces | By::Groups) => None,
            // Counting pieces for a greyed button takes a pass over the mesh.
            _ if faces().sum::<usize>() > MAX_ELEMENTS_AT_ONCE || pieces() > 1 => None,
            _ => Some("The mesh is one connected piece. Select the faces to separate first."),
        }
    }

    fn is_for_each_object(&self) -> bool {
        false
    }

    fn compute(
        &self,
        inputs: &[NamedMesh],
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem> {
        let Some(NamedMesh { name, mesh, .. }) = inputs.first() else {
            return Err(Problem::new("there is no mesh to separate"));
        };
        let parts = match self.by {
            Some(By::Faces) => self.parts_by_faces(mesh)?,
            Some(By::Groups) => parts_by_groups(mesh)?,
            Some(By::Components) | None => parts_by_components(mesh),
        };
        if parts.len() < 2 {
            return Err(Problem::field("by", "that makes only one part, which the object is already")
                .advise("The object would stay in one piece: choose another way to separate it."));
        }
        if parts.len() > MAX_PARTS {
            let (count, most) = (thousands(parts.len()), thousands(MAX_PARTS));
            return Err(Problem::field(
                "by",
                format!("that makes {count} objects; at most {most} can be made"),
            ));
        }
        let mut outputs = Vec::with_capacity(parts.len());
        for (at, part) in parts.iter().enumerate() {
            if progress(at as f32 / parts.len() as f32).is_break() {
                return Err(Problem::cancelled());
            }
            let mesh = surface::extract_faces(mesh, &part.faces, at == 0)
                .map_err(|e| Problem::new(e.to_string()))?;
            let name = match &part.name {
                Some(own) => own.clone(),
                None if at == 0 => String::new(),
                None => format!("{name} {}", at + 1),
            };
            outputs.push(NamedMesh::new(name, mesh));
        }
        Ok(outputs)
    }

    fn cost(&self, inputs: &[NamedMesh]) -> usize {
        inputs.iter().map(|input| input.mesh.face_count()).sum()
    }
}

struct Part {
    name: Option<String>,
    faces: Vec<FaceId>,
}

impl Separate {
    fn parts_by_faces(&self, mesh: &Mesh) -> Result<Vec<Part>, Problem> {
        let mut taken = vec![false; mesh.face_capacity()];
        for face in all(&self.faces, "faces", mesh)? {
            if let Some(slot) = taken.get_mut(face.index()) {
                *slot = true;
            }
        }
        let (faces, rest): (Vec<_>, Vec<_>) =
            mesh.faces().partition(|f| taken.get(f.index()).copied().unwrap_or_default());
        if faces.is_empty() || rest.is_empty() {
            return Err(Problem::of_field(
                "faces",
                "must be some of the object's faces, but not all of them",
            )
            .advise("Select some of the object's faces, but not all of them."));
        }
        Ok([rest, faces].map(|faces| Part { name: None, faces }).into())
    }
}

fn parts_by_groups(mesh: &Mesh) -> Result<Vec<Part>, Problem> {
    let Some(groups) = mesh.attribute(keys::FACE_GROUP) else {
        return Err(Problem::field("by", "no face is in a group"));
    };
    let labels = mesh.column(Element::Face, keys::FACE_GROUP.name).map_or(&[][..], |column| &column.labels);
    let name = |group: u32| match labels.get(group as usize) {
        Some(label) => formats::name_of_group(label).to_owned(),
        None if group == NONE => "No group".to_owned(),
        None => format!("Group {group}"),
    };
    Ok(parts(mesh, |f| groups.get(f.index()).copied().unwrap_or(NONE))
        .into_iter()
        .map(|(group, faces)| Part { name: Some(name(group)), faces })
        .collect())
}

fn parts_by_components(mesh: &Mesh) -> Vec<Part> {
    let (piece, _) = mesh.components();
    let of = |f: FaceId| {
        let corner = mesh.to(mesh.halfedge_of(f));
        piece.get(corner.index()).copied().unwrap_or(NONE)
    };
    parts(mesh, of).into_iter().map(|(_, faces)| Part { name: None, faces }).collect()
}

/// The faces by what `key` says of them, in the order of each key's first face.
fn parts(mesh: &Mesh, key: impl Fn(FaceId) -> u32) -> Vec<(u32, Vec<FaceId>)> {
    let mut places: HashMap<u32, usize> = HashMap::new();
    let mut parts: Vec<(u32, Vec<FaceId>)> = Vec::new();
    for f in mesh.faces() {
        let key = key(f);
        let at = *places.entry(key).or_insert_with(|| {
            parts.push((key, Vec::new()));
            parts.len() - 1
        });
        if let Some((_, faces)) = parts.get_mut(at) {
            faces.push(f);
        }
    }
    parts
}
