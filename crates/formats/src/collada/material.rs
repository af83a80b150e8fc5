//! Materials: what the faces of primitives have, and how a document's materials get there.

use super::effect::{self, EffectMaterial};
use super::primitive::UvSets;
use super::xml::{Document, Node};
use crate::file::NamedBytes;
use crate::model::collector::{MaterialCollector, Paint, face_columns};
use crate::model::material::Materials;
use crate::model::texture::TextureRole;
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use halfedge::attribute::Column;
use std::collections::HashMap;
use std::rc::Rc;

/// A material of the document, as faces have it.
struct Bound {
    paint: Paint,
    /// For each texture its role and the name under which its texture coordinates are bound.
    texcoords: Vec<(TextureRole, String)>,
}

/// The materials of a document that faces have so far.
pub(super) struct Library<'d, 'a> {
    document: &'d Document<'a>,
    files: &'d [NamedBytes],
    materials: MaterialCollector,
    /// What `<material>` elements stand for, by their index in the document.
    known: HashMap<u32, Rc<Bound>>,
}

impl<'d, 'a> Library<'d, 'a> {
    pub(super) fn new(document: &'d Document<'a>, files: &'d [NamedBytes]) -> Self {
        Self { document, files, materials: MaterialCollector::default(), known: HashMap::new() }
    }

    /// The materials that faces have. Names those that the document doesn't get.
    pub(super) fn finish(self, notes: &mut Notes) -> Materials {
        let materials = self.materials.finish();
        let unused = self.document.all("material").filter(|node| !self.known.contains_key(&node.index));
        let unused: Vec<&str> = unused.map(Node::label).collect();
        if !unused.is_empty() {
            notes.info(format!("Materials that no face uses are left out: {}", first_few(&unused, 6)));
        }
        materials
    }

    /// What a `<material>` element stands for.
    fn material(&mut self, node: &'d Node<'a>, notes: &mut Notes) -> Rc<Bound> {
        if let Some(known) = self.known.get(&node.index) {
            return Rc::clone(known);
        }
        let label = node.label();
        let look = match self.document.child(node, "instance_effect") {
            Some(instance) => {
                effect::read(self.document, instance, label, self.files, &mut self.materials, notes)
            }
            None => EffectMaterial::default(),
        };
        let roles: Vec<TextureRole> = look.material.textures.iter().map(|texture| texture.role).collect();
        let texcoords = roles.into_iter().zip(look.texcoords).collect();
        let bound = Rc::new(Bound { paint: self.materials.add(label, look.material), texcoords });
        self.known.insert(node.index, Rc::clone(&bound));
        bound
    }
}

/// The materials of one instance, by the symbols that primitives have for them.
pub(super) struct Palette<'d, 'a> {
    document: &'d Document<'a>,
    /// The elements that bind materials, by symbol.
    bound: HashMap<&'d str, &'d Node<'a>>,
    /// The materials so far, with the sets of texture coordinates that they use.
    list: Vec<(Rc<Bound>, UvSets)>,
    numbers: HashMap<String, u32>,
}

impl<'d, 'a> Palette<'d, 'a> {
    /// The materials that primitives of an instance may name.
    pub(super) fn of(document: &'d Document<'a>, binding: Option<&Node<'a>>) -> Self {
        let binds = binding.and_then(|node| document.path(node, &["bind_material", "technique_common"]));
        let bound = binds
            .into_iter()
            .flat_map(|binds| document.children_named(binds, "instance_material"))
            .filter_map(|bind| Some((bind.attribute("symbol")?, bind)))
            .collect();
        Self { document, bound, list: Vec::new(), numbers: HashMap::new() }
    }

    /// The number of the material that a symbol stands for: the one bound to it, or the one of that id.
    pub(super) fn number(&mut self, symbol: &str, library: &mut Library<'d, 'a>, notes: &mut Notes) -> u32 {
        if let Some(&number) = self.numbers.get(symbol) {
            return number;
        }
        let bind = self.bound.get(symbol).copied();
        let target = bind.and_then(|bind| bind.attribute("target")).unwrap_or(symbol);
        let (material, sets) = match self.document.target(target).filter(|node| node.name == "material") {
            Some(node) => {
                let material = library.material(node, notes);
                let sets = self.uv_sets(&material, bind);
                (material, sets)
            }
            None => {
                if bind.is_some() {
                    notes.fault(
                        Fault::Material,
                        format!("\"{symbol}\": material {}", self.document.why_missing(target)),
                    );
                }
                let paint = Paint { name: symbol.to_owned(), color: None };
                (Rc::new(Bound { paint, texcoords: Vec::new() }), UvSets::default())
            }
        };
        let number = self.list.len() as u32;
        self.list.push((material, sets));
        self.numbers.insert(symbol.to_owned(), number);
        number
    }

    /// The sets of texture coordinates that a material's textures use, as far as they are bound: corners have
    /// one, so that of the base colour counts.
    fn uv_sets(&self, material: &Bound, bind: Option<&Node<'a>>) -> UvSets {
        let set = |texcoord: &str| {
            let mut inputs = self.document.children_named(bind?, "bind_vertex_input");
            let input = inputs.find(|input| input.attribute("semantic") == Some(texcoord))?;
            Some(input.number("input_set").unwrap_or(0))
        };
        let is_base = |role: TextureRole| role == TextureRole::BaseColor;
        let main = material.texcoords.iter().find(|(role, _)| is_base(*role)).or(material.texcoords.first());
        let main = main.and_then(|(_, texcoord)| set(texcoord));
        let others = material.texcoords.iter().filter_map(|(role, texcoord)| {
            let other = set(texcoord).filter(|&other| Some(other) != main)?;
            Some((other, format!("\"{}\": its {}", material.paint.name, role.name())))
        });
        UvSets { main, others: others.collect() }
    }

    /// The sets of texture coordinates that a material uses.
    pub(super) fn sets_of(&self, number: u32) -> Option<&UvSets> {
        self.list.get(number as usize).map(|(_, sets)| sets)
    }

    /// Columns of faces with these materials.
    pub(super) fn columns(&self, numbers: &[u32]) -> Vec<Column> {
        let paints: Vec<&Paint> = self.list.iter().map(|(bound, _)| &bound.paint).collect();
        face_columns(&paints, numbers)
    }
}
