//! A document that the mirror for screen readers changes, as the page's own document is changed.

use std::collections::HashMap;

use egui::accesskit::NodeId;
use meshwright_web::access::aria::Urgency;
use meshwright_web::access::mirror::{Insertion, Mirror, Patch};
use meshwright_web::access::tree::UiTree;

use crate::page::Page;

/// A document that a mirror changes.
#[derive(Default)]
pub struct Document {
    pub mirror: Mirror,
    pub nodes: HashMap<NodeId, Node>,
    /// The contents of the mirror itself.
    top: Vec<NodeId>,
    pub focus: Option<NodeId>,
    pub said: Vec<(Urgency, String)>,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Node {
    tag: &'static str,
    pub attributes: HashMap<&'static str, String>,
    text: String,
    value: String,
    rect: [i32; 4],
    pub parent: Option<NodeId>,
    inside: Vec<NodeId>,
    placed: bool,
}

impl Document {
    /// Follows the page; returns the number of changes.
    pub fn follow(&mut self, page: &Page) -> usize {
        let tree = page.harness.ctx.plugin::<UiTree>();
        let patches = self.mirror.update(&tree.lock());
        let count = patches.len();
        patches.into_iter().for_each(|patch| self.apply(patch));
        count
    }

    fn node(&mut self, id: NodeId) -> &mut Node {
        self.nodes.get_mut(&id).expect("an element that was created")
    }

    fn list(&mut self, parent: Option<NodeId>) -> &mut Vec<NodeId> {
        match parent {
            Some(parent) => &mut self.node(parent).inside,
            None => &mut self.top,
        }
    }

    fn detach(&mut self, id: NodeId) {
        let node = self.node(id);
        if std::mem::take(&mut node.placed) {
            let parent = node.parent.take();
            // A container that was removed takes its contents along.
            if parent.is_none_or(|parent| self.nodes.contains_key(&parent)) {
                self.list(parent).retain(|other| *other != id);
            }
        }
    }

    pub fn apply(&mut self, patch: Patch) {
        match patch {
            Patch::Create(id, tag) => {
                let before = self.nodes.insert(id, Node { tag, ..Node::default() });
                assert!(before.is_none(), "{id:?} exists");
            }
            Patch::Attribute(id, name, Some(value)) => {
                self.node(id).attributes.insert(name, value);
            }
            Patch::Attribute(id, name, None) => {
                self.node(id).attributes.remove(name).expect("an attribute to remove");
            }
            Patch::Text(id, text) => {
                assert!(self.node(id).inside.is_empty(), "the text would replace what is inside");
                self.node(id).text = text;
            }
            Patch::Value(id, value) => self.node(id).value = value,
            Patch::Rect(id, rect) => self.node(id).rect = rect,
            Patch::Insert(id, Insertion { parent, before }) => {
                self.detach(id);
                let list = self.list(parent);
                let at = before.map_or(list.len(), |before| {
                    list.iter().position(|other| *other == before).expect("the next element is there")
                });
                list.insert(at, id);
                let node = self.node(id);
                (node.parent, node.placed) = (parent, true);
            }
            Patch::Remove(id) => {
                self.detach(id);
                self.nodes.remove(&id);
            }
            Patch::Focus(id) => {
                assert!(id.is_none_or(|id| self.nodes.contains_key(&id)), "the focus is on an element");
                self.focus = id;
            }
            Patch::Announce(urgency, text) => self.said.push((urgency, text)),
        }
    }

    /// The role of an element as ARIA maps it.
    pub fn role(node: &Node) -> &str {
        match (node.tag, node.attributes.get("type").map(String::as_str)) {
            ("input", Some("number")) => "spinbutton",
            ("input", Some("range")) => "slider",
            ("input" | "textarea", _) => "textbox",
            _ => node.attributes.get("role").map_or("", String::as_str),
        }
    }

    pub fn name(node: &Node) -> &str {
        node.attributes.get("aria-label").unwrap_or(&node.text)
    }

    /// The elements of a role and name.
    pub fn all(&self, role: &str, name: &str) -> Vec<&Node> {
        self.nodes.values().filter(|node| Self::role(node) == role && Self::name(node) == name).collect()
    }

    pub fn get(&self, role: &str, name: &str) -> &Node {
        let found = self.all(role, name);
        let roles = || {
            let all = self.nodes.values().map(|node| (Self::role(node), Self::name(node)));
            all.collect::<Vec<_>>()
        };
        assert_eq!(found.len(), 1, "{role} {name:?} among {:#?}", roles());
        found[0]
    }

    /// Fails unless the document is as a new mirror of the page would make it, and as ARIA wants it.
    pub fn check(&mut self, page: &Page, what: &str) {
        self.follow(page);
        let mut fresh = Document::default();
        fresh.follow(page);
        assert_eq!(self.nodes, fresh.nodes, "{what}: changed bit by bit as made at once");
        assert_eq!(self.top, fresh.top, "{what}: order");
        assert_eq!(self.focus, fresh.focus, "{what}: focus");
        for (id, node) in &self.nodes {
            let (role, name) = (Self::role(node), Self::name(node));
            assert!(node.placed, "{what}: {node:?} is in the document");
            let hidden = node.attributes.contains_key("aria-hidden");
            if !hidden && !["", "group", "toolbar", "menu", "listbox", "tablist", "tooltip"].contains(&role) {
                assert!(!name.is_empty(), "{what}: a {role} without a name: {node:?} {}", self.around(*id));
            }
            let around = node.parent.and_then(|parent| self.nodes.get(&parent)).map_or("", Self::role);
            match role {
                "option" => assert_eq!(around, "listbox", "{what}: {name}"),
                "tab" => assert_eq!(around, "tablist", "{what}: {name}"),
                "menuitem" | "menuitemcheckbox" => assert_eq!(around, "menu", "{what}: {name}"),
                _ => {}
            }
        }
    }

    /// Whether no modal dialog keeps the keyboard from an element.
    pub fn is_in_front(&self, node: &Node) -> bool {
        let is_modal = |node: &Node| node.attributes.contains_key("aria-modal");
        let around = std::iter::successors(Some(node), |node| self.nodes.get(&node.parent?));
        around.into_iter().any(is_modal) || !self.nodes.values().any(is_modal)
    }

    fn around(&self, id: NodeId) -> String {
        let mut names = Vec::new();
        let mut at = self.nodes.get(&id).and_then(|node| node.parent);
        while let Some(node) = at.and_then(|id| self.nodes.get(&id)) {
            names.push(format!("{} {:?}", Self::role(node), Self::name(node)));
            at = node.parent;
        }
        names.join(" < ")
    }
}
