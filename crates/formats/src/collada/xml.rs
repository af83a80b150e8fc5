//! The elements of a COLLADA document that the reader looks at, as a tree.
//!
//! Elements with other names are left out together with their content. Nothing recurses and no entity is
//! expanded, so time and memory are linear in the size of the file.

use super::vocabulary::{ATTRIBUTES, ELEMENTS};
use halfedge::words::counted;
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};
use std::borrow::Cow;
use std::collections::HashMap;

/// The fewest bytes of text for each element: a document with more elements is cut off there, so that
/// a file of nothing but tags can't fill the memory.
const MIN_BYTES_PER_ELEMENT: usize = 8;

/// One element.
#[derive(Debug)]
pub(crate) struct Node<'a> {
    pub name: &'static str,
    /// Its place in document order, which tells elements apart.
    pub index: u32,
    attributes: Vec<(&'static str, String)>,
    text: Cow<'a, [u8]>,
    first_child: u32,
    next: u32,
}

/// The whole tree.
pub(crate) struct Document<'a> {
    nodes: Vec<Node<'a>>,
    ids: HashMap<String, u32>,
    /// The file's name without folders, by which references may lead back to the document itself.
    file_name: &'a str,
    /// What of the document is not read, and why.
    pub faults: Vec<String>,
}

/// The index that stands for no node.
const NO_NODE: u32 = u32::MAX;

/// The elements that are open while a document is read, each with its latest child.
struct Open {
    elements: Vec<(u32, u32)>,
    /// How many elements deep the reader is in one that is left out.
    skipped: usize,
}

impl<'a> Document<'a> {
    /// Reads a document up to the first place where it is not well-formed, which `faults` names.
    ///
    /// # Errors
    /// In words, where the root is not `<COLLADA>`.
    pub(crate) fn read(text: &'a str, file_name: &'a str) -> Result<Self, String> {
        let file_name = file_name.rsplit(['/', '\\']).next().unwrap_or(file_name);
        let mut this = Self { nodes: Vec::new(), ids: HashMap::new(), file_name, faults: Vec::new() };
        this.read_elements(text);
        match this.nodes.first() {
            Some(root) if root.name == "COLLADA" => Ok(this),
            _ => Err(match this.faults.first() {
                Some(fault) => format!("nothing of it can be read. Left out is {fault}"),
                None => "its root is not <COLLADA>".to_owned(),
            }),
        }
    }

    fn read_elements(&mut self, text: &'a str) {
        let mut reader = Reader::from_str(text);
        // Programs write names with "&" as they are.
        reader.config_mut().allow_dangling_amp = true;
        let line = |at: u64| {
            let before = text.as_bytes().get(..usize::try_from(at).unwrap_or(0)).unwrap_or_default();
            1 + before.iter().filter(|&&b| b == b'\n').count()
        };
        let max_elements = text.len() / MIN_BYTES_PER_ELEMENT + 1024;
        let mut open = Open { elements: Vec::new(), skipped: 0 };
        let mut unknown_entities = 0;
        loop {
            let event = match reader.read_event() {
                Ok(event) => event,
                Err(error) => {
                    let line = line(reader.error_position());
                    let error = error.to_string().replace(": ", ", ");
                    self.faults
                        .push(format!("everything from line {line} on, not well-formed XML ({error})"));
                    break;
                }
            };
            match event {
                Event::Start(start) => {
                    if open.skipped > 0 || !self.push(&start, &mut open) {
                        open.skipped += 1;
                    } else {
                        open.elements.push((self.nodes.len() as u32 - 1, NO_NODE));
                    }
                }
                Event::Empty(start) => {
                    if open.skipped == 0 {
                        self.push(&start, &mut open);
                    }
                }
                Event::End(_) if open.skipped > 0 => open.skipped -= 1,
                Event::End(_) => drop(open.elements.pop()),
                Event::Text(part) => self.append(part.into_inner(), &open),
                Event::CData(part) => self.append(part.into_inner(), &open),
                Event::GeneralRef(entity) => {
                    match character(entity.resolve_char_ref().ok().flatten(), &entity) {
                        Some(character) => {
                            self.append(Cow::Owned(character.to_string().into_bytes()), &open);
                        }
                        None => unknown_entities += 1,
                    }
                }
                Event::Eof => {
                    if !open.elements.is_empty() || open.skipped > 0 {
                        self.faults
                            .push("the end of the file, which stops in the middle of an element".to_owned());
                    }
                    break;
                }
                Event::DocType(_) | Event::Comment(_) | Event::Decl(_) | Event::PI(_) => {}
            }
            if self.nodes.len() > max_elements {
                let line = line(reader.buffer_position());
                self.faults.push(format!(
                    "everything from line {line} on: there are too many elements for so small a file"
                ));
                break;
            }
        }
        if unknown_entities > 0 {
            let entities = counted(unknown_entities, "entity", "entities");
            self.faults.push(format!("{entities} other than XML's own"));
        }
    }

    /// Adds an element if the reader looks at its name, and returns whether it does.
    fn push(&mut self, start: &BytesStart, open: &mut Open) -> bool {
        let local = start.local_name();
        let Some(&name) = ELEMENTS.iter().find(|name| name.as_bytes() == local.as_ref()) else {
            return false;
        };
        let index = self.nodes.len() as u32;
        let mut attributes = Vec::new();
        for attribute in start.attributes().with_checks(false).flatten() {
            if let Some(&key) = ATTRIBUTES.iter().find(|key| key.as_bytes() == attribute.key.as_ref()) {
                let value = match attribute.normalized_value(XmlVersion::Implicit1_0) {
                    Ok(value) => value.into_owned(),
                    Err(_) => String::from_utf8_lossy(&attribute.value).into_owned(),
                };
                if key == "id" {
                    self.ids.entry(value.clone()).or_insert(index);
                }
                attributes.push((key, value));
            }
        }
        if let Some((parent, latest)) = open.elements.last_mut() {
            let before = if *latest == NO_NODE { *parent } else { *latest };
            if let Some(before_node) = self.nodes.get_mut(before as usize) {
                let link =
                    if *latest == NO_NODE { &mut before_node.first_child } else { &mut before_node.next };
                *link = index;
            }
            *latest = index;
        }
        self.nodes.push(Node {
            name,
            index,
            attributes,
            text: Cow::Borrowed(&[]),
            first_child: NO_NODE,
            next: NO_NODE,
        });
        true
    }

    fn append(&mut self, part: Cow<'a, [u8]>, open: &Open) {
        let Some(&(index, _)) = open.elements.last().filter(|_| open.skipped == 0) else { return };
        let Some(node) = self.nodes.get_mut(index as usize) else { return };
        if node.text.is_empty() {
            node.text = part;
        } else if !part.trim_ascii().is_empty() {
            node.text.to_mut().extend_from_slice(&part);
        }
    }

    /// The root element.
    pub(crate) fn root(&self) -> &Node<'a> {
        const EMPTY: &Node = &Node {
            name: "",
            index: NO_NODE,
            attributes: Vec::new(),
            text: Cow::Borrowed(&[]),
            first_child: NO_NODE,
            next: NO_NODE,
        };
        // `read` makes sure that there is one.
        self.nodes.first().unwrap_or(EMPTY)
    }

    /// The first element directly inside a node.
    pub(crate) fn first_child(&self, node: &Node) -> Option<&Node<'a>> {
        self.nodes.get(node.first_child as usize)
    }

    /// The element after this one in their parent.
    pub(crate) fn next_sibling(&self, node: &Node) -> Option<&Node<'a>> {
        self.nodes.get(node.next as usize)
    }

    /// The elements directly inside a node.
    pub(crate) fn children<'d>(&'d self, node: &Node) -> impl Iterator<Item = &'d Node<'a>> + use<'d, 'a> {
        std::iter::successors(self.first_child(node), |child| self.next_sibling(child))
    }

    /// The elements of this name directly inside a node.
    pub(crate) fn children_named<'d>(
        &'d self,
        node: &Node,
        name: &'static str,
    ) -> impl Iterator<Item = &'d Node<'a>> + use<'d, 'a> {
        self.children(node).filter(move |child| child.name == name)
    }

    /// The first element of this name directly inside a node.
    pub(crate) fn child(&self, node: &Node, name: &str) -> Option<&Node<'a>> {
        self.children(node).find(|child| child.name == name)
    }

    /// The first element at the end of this path of names.
    pub(crate) fn path(&self, node: &Node, path: &[&str]) -> Option<&Node<'a>> {
        let (last, before) = path.split_last()?;
        let mut found = None;
        for name in before {
            found = Some(self.child(found.unwrap_or(node), name)?);
        }
        self.child(found.unwrap_or(node), last)
    }

    /// All elements of this name, in document order.
    pub(crate) fn all<'d>(&'d self, name: &'static str) -> impl Iterator<Item = &'d Node<'a>> + use<'d, 'a> {
        self.nodes.iter().filter(move |node| node.name == name)
    }

    /// The element that a reference like `#id` leads to; none where it is missing or in another document.
    pub(crate) fn target(&self, reference: &str) -> Option<&Node<'a>> {
        let reference = reference.trim();
        let id = match reference.split_once('#') {
            Some((file, id)) if file.is_empty() || self.is_own_file(file) => id,
            Some(_) => return None,
            None => reference,
        };
        self.nodes.get(*self.ids.get(id)? as usize)
    }

    /// Why a reference leads to nothing: `"b.dae#x" is in another file`.
    pub(crate) fn why_missing(&self, reference: &str) -> String {
        let file = reference.trim().split_once('#').map_or("", |(file, _)| file);
        match file.is_empty() || self.is_own_file(file) {
            true => format!("\"{reference}\" doesn't exist"),
            false => format!("\"{reference}\" is in another file"),
        }
    }

    fn is_own_file(&self, file: &str) -> bool {
        file.rsplit(['/', '\\']).next().is_some_and(|base| base == self.file_name)
    }
}

/// The character that an entity stands for: a character reference, or one of XML's own names.
fn character(reference: Option<char>, entity: &[u8]) -> Option<char> {
    reference.or(match entity {
        b"amp" => Some('&'),
        b"lt" => Some('<'),
        b"gt" => Some('>'),
        b"quot" => Some('"'),
        b"apos" => Some('\''),
        _ => None,
    })
}

impl Node<'_> {
    /// The value of an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| *key == name).map(|(_, value)| value.as_str())
    }

    /// The value of an attribute that is a number; none where it is missing or something else.
    pub(crate) fn number(&self, name: &str) -> Option<usize> {
        self.attribute(name)?.trim().parse().ok()
    }

    /// What messages call the element.
    pub(crate) fn label(&self) -> &str {
        let given = |name: &str| self.attribute(name).filter(|value| !value.is_empty());
        given("name").or(given("id")).or(given("sid")).unwrap_or(self.name)
    }

    /// The text directly inside.
    pub(crate) fn text(&self) -> &[u8] {
        &self.text
    }

    /// The text directly inside, without blanks around it.
    pub(crate) fn word(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(self.text.trim_ascii())
    }
}
