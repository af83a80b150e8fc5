//! The elements of a COLLADA document that matter here, as a tree.
//!
//! Elements of other names are left out with all they hold. Nothing is expanded, nesting and the
//! number of elements are limited, so that time and memory stay linear in the size of the file.

use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::borrow::Cow;
use std::collections::HashMap;

const ELEMENTS: [&str; 60] = [
    "COLLADA",
    "asset",
    "unit",
    "up_axis",
    "library_geometries",
    "geometry",
    "mesh",
    "source",
    "float_array",
    "accessor",
    "technique_common",
    "vertices",
    "input",
    "polylist",
    "polygons",
    "triangles",
    "tristrips",
    "trifans",
    "p",
    "ph",
    "h",
    "vcount",
    "library_effects",
    "effect",
    "profile_COMMON",
    "technique",
    "phong",
    "lambert",
    "blinn",
    "constant",
    "diffuse",
    "color",
    "library_materials",
    "material",
    "instance_effect",
    "library_visual_scenes",
    "visual_scene",
    "node",
    "matrix",
    "translate",
    "rotate",
    "scale",
    "skew",
    "lookat",
    "instance_geometry",
    "bind_material",
    "instance_material",
    "instance_node",
    "library_nodes",
    "instance_controller",
    "library_controllers",
    "controller",
    "skin",
    "scene",
    "instance_visual_scene",
    "lines",
    "linestrips",
    "spline",
    "convex_mesh",
    "morph",
];

const ATTRIBUTES: [&str; 14] = [
    "id", "name", "url", "source", "semantic", "offset", "set", "count", "stride", "material", "symbol",
    "target", "meter", "version",
];

const MAX_DEPTH: usize = 200;

/// One element.
#[derive(Debug, Default)]
pub(crate) struct Node<'a> {
    pub name: &'static str,
    attributes: Vec<(&'static str, String)>,
    text: Cow<'a, [u8]>,
    first_child: u32,
    next: u32,
}

/// The whole tree.
pub(crate) struct Document<'a> {
    nodes: Vec<Node<'a>>,
    ids: HashMap<String, u32>,
}

const NONE: u32 = u32::MAX;

impl<'a> Document<'a> {
    /// Reads a document.
    ///
    /// # Errors
    /// In words, with the place, where it is not well-formed or asks for too much.
    pub(crate) fn read(text: &'a str) -> Result<Self, String> {
        let mut reader = Reader::from_str(text);
        let line = |at: u64| {
            let before = text.as_bytes().get(..usize::try_from(at).unwrap_or(0)).unwrap_or_default();
            1 + before.iter().filter(|&&b| b == b'\n').count()
        };
        let most = text.len() / 8 + 1024;
        let mut this = Self { nodes: Vec::new(), ids: HashMap::new() };
        // The open elements, each with its latest child.
        let mut open: Vec<(u32, u32)> = Vec::new();
        let mut skipped = 0usize;
        loop {
            let event = reader.read_event().map_err(|error| {
                format!("line {}: not well-formed XML: {error}", line(reader.error_position()))
            })?;
            match event {
                Event::Start(start) => {
                    if open.len() + skipped >= MAX_DEPTH {
                        return Err(format!(
                            "line {}: elements are nested more than {MAX_DEPTH} deep",
                            line(reader.buffer_position())
                        ));
                    }
                    if skipped > 0 || !this.push(&start, &mut open)? {
                        skipped += 1;
                    } else {
                        open.push((this.nodes.len() as u32 - 1, NONE));
                    }
                }
                Event::Empty(start) => {
                    if skipped == 0 {
                        this.push(&start, &mut open)?;
                    }
                }
                Event::End(_) => {
                    if skipped > 0 {
                        skipped -= 1;
                    } else {
                        open.pop();
                    }
                }
                Event::Text(part) => this.append(part.into_inner(), skipped, &open),
                Event::CData(part) => this.append(part.into_inner(), skipped, &open),
                Event::GeneralRef(entity) => {
                    let character = match entity.resolve_char_ref() {
                        Ok(Some(character)) => character,
                        _ => match &*entity {
                            b"amp" => '&',
                            b"lt" => '<',
                            b"gt" => '>',
                            b"quot" => '"',
                            b"apos" => '\'',
                            _ => {
                                return Err(format!(
                                    "line {}: an unknown entity",
                                    line(reader.buffer_position())
                                ));
                            }
                        },
                    };
                    this.append(Cow::Owned(character.to_string().into_bytes()), skipped, &open);
                }
                Event::DocType(kind) => {
                    if kind.windows(6).any(|word| word == b"ENTITY") {
                        return Err(
                            "the document defines entities of its own, which are not expanded".to_owned()
                        );
                    }
                }
                Event::Eof => break,
                Event::Comment(_) | Event::Decl(_) | Event::PI(_) => {}
            }
            if this.nodes.len() > most {
                return Err("the document has more elements than its size allows for".to_owned());
            }
        }
        if !open.is_empty() || skipped > 0 {
            return Err("the document ends in the middle of an element".to_owned());
        }
        if this.nodes.first().is_none_or(|node| node.name != "COLLADA") {
            return Err("this is not a COLLADA document: its root is not <COLLADA>".to_owned());
        }
        Ok(this)
    }

    /// Adds an element if its name matters; says whether it does.
    fn push(&mut self, start: &BytesStart, open: &mut [(u32, u32)]) -> Result<bool, String> {
        let local = start.local_name();
        let Some(&name) = ELEMENTS.iter().find(|name| name.as_bytes() == local.as_ref()) else {
            return Ok(false);
        };
        let mut node = Node { name, first_child: NONE, next: NONE, ..Node::default() };
        for attribute in start.attributes() {
            let attribute = attribute.map_err(|error| format!("in <{name}>: {error}"))?;
            if let Some(&key) = ATTRIBUTES.iter().find(|key| key.as_bytes() == attribute.key.as_ref()) {
                let value = attribute
                    .normalized_value(XmlVersion::Implicit1_0)
                    .map_err(|error| format!("in <{name}>: {error}"))?;
                node.attributes.push((key, value.into_owned()));
            }
        }
        let index = self.nodes.len() as u32;
        if let Some(id) = node.attribute("id") {
            self.ids.entry(id.to_owned()).or_insert(index);
        }
        if let Some((parent, latest)) = open.last_mut() {
            let before = if *latest == NONE { *parent } else { *latest };
            if let Some(before_node) = self.nodes.get_mut(before as usize) {
                let link = if *latest == NONE { &mut before_node.first_child } else { &mut before_node.next };
                *link = index;
            }
            *latest = index;
        }
        self.nodes.push(node);
        Ok(true)
    }

    fn append(&mut self, part: Cow<'a, [u8]>, skipped: usize, open: &[(u32, u32)]) {
        let Some(&(index, _)) = open.last().filter(|_| skipped == 0) else { return };
        let Some(node) = self.nodes.get_mut(index as usize) else { return };
        if node.text.is_empty() {
            node.text = part;
        } else if !part.trim_ascii().is_empty() {
            node.text.to_mut().extend_from_slice(&part);
        }
    }

    /// The root element.
    pub(crate) fn root(&self) -> &Node<'a> {
        // There is one: `read` checks.
        self.nodes.first().unwrap_or(
            const {
                &Node {
                    name: "",
                    attributes: Vec::new(),
                    text: Cow::Borrowed(&[]),
                    first_child: NONE,
                    next: NONE,
                }
            },
        )
    }

    /// The elements right inside one.
    pub(crate) fn children<'d>(&'d self, node: &Node) -> impl Iterator<Item = &'d Node<'a>> + use<'d, 'a> {
        let mut next = node.first_child;
        std::iter::from_fn(move || {
            let node = self.nodes.get(next as usize)?;
            next = node.next;
            Some(node)
        })
    }

    /// The first element of this name right inside one.
    pub(crate) fn child(&self, node: &Node, name: &str) -> Option<&Node<'a>> {
        self.children(node).find(|child| child.name == name)
    }

    /// The first at the end of this path of names.
    pub(crate) fn path(&self, node: &Node, path: &[&str]) -> Option<&Node<'a>> {
        let (first, rest) = path.split_first()?;
        let child = self.child(node, first)?;
        if rest.is_empty() { Some(child) } else { self.path(child, rest) }
    }

    /// The element that a reference like `#id` is to.
    pub(crate) fn target(&self, reference: &str) -> Option<&Node<'a>> {
        let id = reference.rsplit_once('#').map_or(reference, |(_, id)| id);
        self.nodes.get(*self.ids.get(id)? as usize)
    }
}

impl Node<'_> {
    /// The value of an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| *key == name).map(|(_, value)| value.as_str())
    }

    /// What to call the element in messages.
    pub(crate) fn label(&self) -> &str {
        self.attribute("name").or(self.attribute("id")).unwrap_or(self.name)
    }

    /// The text right inside.
    pub(crate) fn text(&self) -> &[u8] {
        &self.text
    }
}

/// The text of a file in whichever encoding: UTF-8 or UTF-16 by mark or by its first characters,
/// else Latin-1.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let utf16 = |bytes: &[u8], read: fn([u8; 2]) -> u16| {
        let (units, _) = bytes.as_chunks::<2>();
        char::decode_utf16(units.iter().map(|unit| read(*unit)))
            .map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
            .filter(|&c| c != '\u{feff}')
            .collect::<String>()
    };
    match bytes {
        [0xff, 0xfe, ..] | [b'<', 0, ..] => Cow::Owned(utf16(bytes, u16::from_le_bytes)),
        [0xfe, 0xff, ..] | [0, b'<', ..] => Cow::Owned(utf16(bytes, u16::from_be_bytes)),
        _ => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            match std::str::from_utf8(bytes) {
                Ok(text) => Cow::Borrowed(text),
                Err(_) => Cow::Owned(bytes.iter().map(|&b| char::from(b)).collect()),
            }
        }
    }
}
