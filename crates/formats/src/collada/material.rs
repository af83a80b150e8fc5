//! Materials: what the faces of primitives have, and how a document's materials get there.

use super::effect::{self, Look};
use super::notes::{Fault, Notes};
use super::primitive::UvSets;
use super::xml::{Document, Node};
use crate::file::NamedBytes;
use crate::model::labels::Names;
use crate::model::material::{Material, Materials};
use crate::model::paint::unpainted;
use crate::model::texture::TextureRole;
use crate::report::first_few;
use halfedge::attribute::Column;
use halfedge::{Color, NONE, keys};
use std::collections::HashMap;
use std::rc::Rc;

/// What the faces of one material have.
#[derive(Debug, PartialEq)]
struct Paint {
    /// The material's name; empty for one that only stands for a colour.
    name: String,
    /// The diffuse colour, if there is one.
    color: Option<Color>,
    /// For each texture its role and the name under which its texture coordinates are bound.
    texcoords: Vec<(TextureRole, String)>,
}

/// The materials of a document that faces have so far.
pub(super) struct Library<'d, 'a> {
    document: &'d Document<'a>,
    files: &'d [NamedBytes],
    materials: Materials,
    /// The places of materials in the list by name.
    numbers: HashMap<String, usize>,
    /// How often a name is taken, with numbers behind it.
    copies: HashMap<String, usize>,
    /// What `<material>` elements stand for, by their index in the document.
    paints: HashMap<u32, Rc<Paint>>,
}

impl<'d, 'a> Library<'d, 'a> {
    pub(super) fn new(document: &'d Document<'a>, files: &'d [NamedBytes]) -> Self {
        Self {
            document,
            files,
            materials: Materials::default(),
            numbers: HashMap::new(),
            copies: HashMap::new(),
            paints: HashMap::new(),
        }
    }

    /// The materials that faces have. Names the images and materials that the document doesn't get.
    pub(super) fn finish(self, notes: &mut Notes) -> Materials {
        let absent = self.materials.images.iter().filter(|image| image.bytes.is_none());
        let absent: Vec<&str> = absent.map(|image| image.name.as_str()).collect();
        if !absent.is_empty() {
            notes.info(format!(
                "Image files that its materials refer to were not given: {}",
                first_few(&absent, 6)
            ));
        }
        let unused = self.document.all("material").filter(|node| !self.paints.contains_key(&node.index));
        let unused: Vec<&str> = unused.map(Node::label).collect();
        if !unused.is_empty() {
            notes.info(format!("Materials that no face has are left out: {}", first_few(&unused, 6)));
        }
        self.materials
    }

    /// What a `<material>` element stands for.
    fn paint(&mut self, node: &'d Node<'a>, notes: &mut Notes) -> Rc<Paint> {
        if let Some(known) = self.paints.get(&node.index) {
            return Rc::clone(known);
        }
        let label = node.label();
        let look = match self.document.child(node, "instance_effect") {
            Some(instance) => {
                effect::read(self.document, instance, label, self.files, &mut self.materials, notes)
            }
            None => Look::default(),
        };
        let color = look.material.color();
        let roles: Vec<TextureRole> = look.material.textures.iter().map(|texture| texture.role).collect();
        let texcoords = roles.into_iter().zip(look.texcoords).collect();
        let name = match unpainted(label) {
            // A material made for painted faces: theirs is the one that it was made from.
            Some((plain, paint)) if color == Some(paint) => {
                if !plain.is_empty() && !self.numbers.contains_key(plain) {
                    self.add(plain, look.material);
                }
                plain.to_owned()
            }
            _ => self.add(label, look.material),
        };
        let paint = Rc::new(Paint { name, color, texcoords });
        self.paints.insert(node.index, Rc::clone(&paint));
        paint
    }

    /// Adds a material, and returns the name that it has: its own unless a different material has that one.
    /// Materials that are no more than a colour share a name.
    fn add(&mut self, label: &str, mut material: Material) -> String {
        material.name = label.to_owned();
        if let Some(known) = self.numbers.get(label).and_then(|&number| self.materials.list.get(number)) {
            if *known == material || (is_color(known) && is_color(&material)) {
                return material.name;
            }
            let mut number = self.copies.get(label).copied().unwrap_or(1);
            while self.numbers.contains_key(&material.name) {
                number += 1;
                material.name = format!("{label}.{number}");
            }
            self.copies.insert(label.to_owned(), number);
        }
        let name = material.name.clone();
        self.numbers.insert(name.clone(), self.materials.list.len());
        self.materials.list.push(material);
        name
    }
}

/// Whether a material says no more than a colour.
fn is_color(material: &Material) -> bool {
    let name = material.name.clone();
    *material == Material { name, base_color: material.base_color, ..Material::default() }
}

/// The materials of one instance, by the symbols that primitives have for them.
pub(super) struct Palette<'d, 'a> {
    document: &'d Document<'a>,
    /// The elements that bind materials, by symbol.
    bound: HashMap<&'d str, &'d Node<'a>>,
    /// The materials so far, with the sets of texture coordinates that they use.
    list: Vec<(Rc<Paint>, UvSets)>,
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
        let (paint, sets) = match self.document.target(target).filter(|node| node.name == "material") {
            Some(node) => {
                let paint = library.paint(node, notes);
                let sets = self.uv_sets(&paint, bind);
                (paint, sets)
            }
            None => {
                if bind.is_some() {
                    notes.fault(
                        Fault::Material,
                        format!("\"{symbol}\": material {}", self.document.why_missing(target)),
                    );
                }
                let paint = Paint { name: symbol.to_owned(), color: None, texcoords: Vec::new() };
                (Rc::new(paint), UvSets::default())
            }
        };
        let number = self.list.len() as u32;
        self.list.push((paint, sets));
        self.numbers.insert(symbol.to_owned(), number);
        number
    }

    /// The sets of texture coordinates that a material's textures use, as far as they are bound: corners have
    /// one, so that of the base colour counts.
    fn uv_sets(&self, paint: &Paint, bind: Option<&Node<'a>>) -> UvSets {
        let set = |texcoord: &str| {
            let mut inputs = self.document.children_named(bind?, "bind_vertex_input");
            let input = inputs.find(|input| input.attribute("semantic") == Some(texcoord))?;
            Some(input.number("input_set").unwrap_or(0))
        };
        let is_base = |role: TextureRole| role == TextureRole::BaseColor;
        let main = paint.texcoords.iter().find(|(role, _)| is_base(*role)).or(paint.texcoords.first());
        let main = main.and_then(|(_, texcoord)| set(texcoord));
        let others = paint.texcoords.iter().filter_map(|(role, texcoord)| {
            let other = set(texcoord).filter(|&other| Some(other) != main)?;
            Some((other, format!("\"{}\": its {}", paint.name, role.name())))
        });
        UvSets { main, others: others.collect() }
    }

    /// The sets of texture coordinates that a material uses.
    pub(super) fn sets_of(&self, number: u32) -> Option<&UvSets> {
        self.list.get(number as usize).map(|(_, sets)| sets)
    }

    /// Columns of faces with these materials.
    pub(super) fn columns(&self, numbers: &[u32]) -> Vec<Column> {
        let mut columns = Vec::new();
        let paint = |number: &u32| self.list.get(*number as usize).map(|(paint, _)| paint);
        // Several materials here may be one by name: different colours of it.
        let mut names = Names::default();
        let name = |(paint, _): &(Rc<Paint>, _)| match paint.name.as_str() {
            "" => NONE,
            name => names.number(name),
        };
        let of_paint: Vec<u32> = self.list.iter().map(name).collect();
        let named: Vec<u32> =
            numbers.iter().map(|&n| of_paint.get(n as usize).copied().unwrap_or(NONE)).collect();
        if named.iter().any(|&name| name != NONE) {
            columns.push(names.column(keys::FACE_MATERIAL, named));
        }
        if numbers.iter().any(|n| paint(n).is_some_and(|paint| paint.color.is_some())) {
            let color = |n: &u32| paint(n).and_then(|paint| paint.color).unwrap_or(Color::UNPAINTED);
            columns.push(Column::with_values(keys::FACE_COLOR, numbers.iter().map(color).collect()));
        }
        columns
    }
}
