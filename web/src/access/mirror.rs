//! The mirror of the accessibility tree: what has to change in the document for it to show the tree.

use std::collections::{HashMap, HashSet};

use egui::Rect;
use egui::accesskit::NodeId;

use super::aria::{Element, Urgency, elements};
use super::tree::{UiTree, Widget};

/// A change of the document. Changes are to be made in order.
#[derive(Clone, Debug, PartialEq)]
pub enum Patch {
    /// Create an element of this HTML name, outside the document.
    Create(NodeId, &'static str),
    /// Set an attribute, or remove it.
    Attribute(NodeId, &'static str, Option<String>),
    /// Set the text inside an element, which has no elements inside.
    Text(NodeId, String),
    /// Set the value of an input.
    Value(NodeId, String),
    /// Move and size an element: left, top, width and height in CSS pixels.
    Rect(NodeId, [i32; 4]),
    /// Put an element in its place.
    Insert(NodeId, Insertion),
    /// Remove an element and all that is left inside.
    Remove(NodeId),
    /// Move the focus of assistive technology.
    Focus(Option<NodeId>),
    /// Say something.
    Announce(Urgency, String),
}

/// A place for an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Insertion {
    /// The container; none for the mirror itself.
    pub parent: Option<NodeId>,
    /// The element in the container that follows; none at the end.
    pub before: Option<NodeId>,
}

/// What the document shows.
#[derive(Default)]
pub struct Mirror {
    version: Option<u64>,
    shown: HashMap<NodeId, Shown>,
    /// The contents of each container in order; of the mirror itself under `None`.
    children: HashMap<Option<NodeId>, Vec<NodeId>>,
    focus: Option<NodeId>,
    /// The name of the widget with the focus, for the field in which the browser takes text.
    focus_name: String,
}

/// An element in the document.
struct Shown {
    element: Element,
    parent: Option<NodeId>,
}

impl Mirror {
    /// The name of the widget with the focus.
    pub fn focus_name(&self) -> &str {
        &self.focus_name
    }

    /// The versions of the tree begin again.
    pub fn forget_version(&mut self) {
        self.version = None;
    }

    /// The value of an input was changed in the document, so the tree's value has to be set again.
    pub fn forget_value(&mut self, id: NodeId) {
        if let Some(shown) = self.shown.get_mut(&id) {
            shown.element.value = None;
        }
        self.version = None;
    }

    /// What to change to show the tree. Costs nothing if the tree is the one that is shown, else O(nodes).
    pub fn update(&mut self, tree: &UiTree) -> Vec<Patch> {
        if self.version == Some(tree.version()) {
            return Vec::new();
        }
        // What is there from the start is no news.
        let is_first = self.shown.is_empty();
        self.version = Some(tree.version());
        let widgets = tree.read();
        let mut wanted = elements(&widgets);
        place_inside(&widgets, &mut wanted);

        let mut patches = Vec::new();
        let mut children: HashMap<Option<NodeId>, Vec<NodeId>> = HashMap::new();
        let mut created = HashSet::new();
        let mut announced = Vec::new();
        for (widget, element) in widgets.iter().zip(wanted) {
            let id = widget.id;
            let parent = widget.parent.and_then(|at| widgets.get(at)).map(|parent| parent.id);
            children.entry(parent).or_default().push(id);
            let old = self.shown.get(&id).filter(|old| old.element.tag == element.tag);
            if old.is_none() {
                if self.shown.contains_key(&id) {
                    patches.push(Patch::Remove(id));
                }
                patches.push(Patch::Create(id, element.tag));
                created.insert(id);
            }
            let said = old.and_then(|old| old.element.announcement.as_ref());
            if let Some((urgency, text)) = element.announcement.clone()
                && said.is_none_or(|(_, said)| *said != text)
                && !is_first
                && !text.is_empty()
            {
                announced.push(Patch::Announce(urgency, text));
            }
            change(id, old.map(|old| &old.element), &element, &mut patches);
            self.shown.insert(id, Shown { element, parent });
        }
        self.arrange(&children, &created, &mut patches);
        let gone: Vec<NodeId> = self.gone(&children);
        for id in gone {
            self.shown.remove(&id);
            patches.push(Patch::Remove(id));
        }
        self.children = children;
        self.update_focus(tree, &widgets, &mut patches);
        patches.extend(announced);
        patches
    }

    /// The elements that are not wanted any more.
    fn gone(&self, children: &HashMap<Option<NodeId>, Vec<NodeId>>) -> Vec<NodeId> {
        let kept: HashSet<NodeId> = children.values().flatten().copied().collect();
        self.shown.keys().filter(|id| !kept.contains(id)).copied().collect()
    }

    /// Puts elements into their containers in the right order, moving as few as possible where rows come and go.
    fn arrange(
        &self,
        children: &HashMap<Option<NodeId>, Vec<NodeId>>,
        created: &HashSet<NodeId>,
        patches: &mut Vec<Patch>,
    ) {
        for (parent, wanted) in children {
            let is_new = parent.is_some_and(|id| created.contains(&id));
            let empty = Vec::new();
            let before = if is_new { &empty } else { self.children.get(parent).unwrap_or(&empty) };
            if before == wanted && !wanted.iter().any(|id| created.contains(id)) {
                continue;
            }
            let inside: HashSet<NodeId> = wanted.iter().copied().collect();
            let stays = |id: &NodeId| inside.contains(id) && !created.contains(id);
            let stayed: Vec<NodeId> = before.iter().copied().filter(|id| stays(id)).collect();
            let was_here: HashSet<NodeId> = stayed.iter().copied().collect();
            let mut moved = HashSet::new();
            let mut next = stayed.iter().copied().peekable();
            for id in wanted {
                while next.peek().is_some_and(|at| moved.contains(at)) {
                    next.next();
                }
                if next.peek() == Some(id) {
                    next.next();
                    continue;
                }
                if was_here.contains(id) {
                    moved.insert(*id);
                }
                let place = Insertion { parent: *parent, before: next.peek().copied() };
                patches.push(Patch::Insert(*id, place));
            }
        }
    }

    fn update_focus(&mut self, tree: &UiTree, widgets: &[Widget<'_>], patches: &mut Vec<Patch>) {
        // Without a focus, keys go to the viewport.
        let viewport = || widgets.iter().find(|widget| widget.node.role() == egui::Role::Canvas);
        let focused = tree.focus().and_then(|focus| widgets.iter().find(|widget| widget.id == focus));
        let focused = focused.or_else(viewport);
        self.focus_name = focused.map(|widget| widget.name.clone()).unwrap_or_default();
        let focus = focused.map(|widget| widget.id);
        if focus != self.focus {
            self.focus = focus;
            patches.push(Patch::Focus(focus));
        }
    }

    /// The container of an element, if it is in one.
    pub fn parent(&self, id: NodeId) -> Option<NodeId> {
        self.shown.get(&id)?.parent
    }
}

/// Places elements in their containers, and gives containers without a size that of their contents.
fn place_inside(widgets: &[Widget<'_>], elements: &mut [Element]) {
    let mut areas: Vec<Rect> = widgets.iter().map(|widget| widget.rect).collect();
    for (at, widget) in widgets.iter().enumerate().rev() {
        let (Some(area), Some(parent)) = (areas.get(at).copied(), widget.parent) else { continue };
        let has_size = widgets.get(parent).is_some_and(|parent| parent.rect.is_positive());
        if let Some(around) = areas.get_mut(parent).filter(|_| !has_size) {
            *around = if around.is_positive() { around.union(area) } else { area };
        }
    }
    for ((at, widget), element) in widgets.iter().enumerate().zip(elements) {
        let Some(area) = areas.get(at) else { continue };
        let corner = |area: &Rect| [area.left().round() as i32, area.top().round() as i32];
        let [x, y] = corner(area);
        let [left, top] = widget.parent.and_then(|parent| areas.get(parent)).map_or([0, 0], corner);
        element.rect = [x - left, y - top, area.width().round() as i32, area.height().round() as i32];
    }
}

/// What to change for an element to become another.
fn change(id: NodeId, old: Option<&Element>, new: &Element, patches: &mut Vec<Patch>) {
    for (name, value) in &new.attributes {
        if old.and_then(|old| old.attribute(name)) != Some(value.as_str()) {
            patches.push(Patch::Attribute(id, name, Some(value.clone())));
        }
    }
    for (name, _) in old.iter().flat_map(|old| &old.attributes) {
        if new.attribute(name).is_none() {
            patches.push(Patch::Attribute(id, name, None));
        }
    }
    if old.map_or("", |old| old.text.as_str()) != new.text {
        patches.push(Patch::Text(id, new.text.clone()));
    }
    if let Some(value) = &new.value
        && old.and_then(|old| old.value.as_ref()) != Some(value)
    {
        patches.push(Patch::Value(id, value.clone()));
    }
    if old.map(|old| old.rect) != Some(new.rect) {
        patches.push(Patch::Rect(id, new.rect));
    }
}
