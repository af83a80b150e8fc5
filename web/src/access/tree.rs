//! The one reading of the accessibility tree that egui builds for every frame and that eframe drops on the web.
//! `meshwright.ui()` lists it for scripts, and the mirror puts it into the document for screen readers.

use std::collections::HashMap;

use egui::accesskit::{Node, NodeId, Role, TreeUpdate};
use egui::{Context, FullOutput, Plugin, Rect, pos2};
use serde::Serialize;

/// A node of the accessibility tree that is on the screen.
#[derive(Clone, Debug)]
pub struct Widget<'a> {
    /// The node's id, which stays the same from frame to frame.
    pub id: NodeId,
    /// The node itself.
    pub node: &'a Node,
    /// The nearest container around it that is read too, by its place in the reading; containers come first.
    pub parent: Option<usize>,
    /// The menu or list that it has opened. It follows as its sibling, because a button contains nothing.
    pub popup: Option<NodeId>,
    /// Whether it is the dialog that keeps the keyboard and the pointer from everything else.
    pub is_modal: bool,
    /// The visible part, in CSS pixels from the canvas's corner; empty for a container of unknown size.
    pub rect: Rect,
    /// The name: the widget's text, or the text of its label.
    pub name: String,
    /// The value, if there is one.
    pub value: Option<Value>,
}

/// The value of a [`Widget`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// The value of a spin box or a slider.
    Number(f64),
    /// The text of a text field.
    Text(String),
}

/// Keeps the accessibility tree of the latest frame.
///
/// Add it with [`Context::add_plugin`] and read it with [`UiTree::read`]. Costs as much as AccessKit: some
/// microseconds for each widget on the screen.
#[derive(Default)]
pub struct UiTree {
    tree: Option<TreeUpdate>,
    /// The visible part of each widget, by node.
    visible: HashMap<NodeId, Rect>,
    screen: Option<Rect>,
    modal: Option<NodeId>,
    zoom: f32,
    version: u64,
}

impl Plugin for UiTree {
    fn debug_name(&self) -> &'static str {
        "ui tree"
    }

    fn setup(&mut self, ctx: &Context) {
        ctx.enable_accesskit();
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        let update = &mut output.platform_output.accesskit_update;
        // Nothing else on the web uses the tree, so it can be taken; on the host, the tests' harness reads it too.
        let tree = if cfg!(target_arch = "wasm32") { update.take() } else { update.clone() };
        // A frame without a tree keeps the last one.
        let Some(tree) = tree else { return };
        let mut visible = HashMap::with_capacity(self.visible.len());
        ctx.viewport(|viewport| {
            for (_, widgets) in viewport.prev_pass.widgets.layers() {
                visible.extend(widgets.iter().map(|widget| (widget.id.accesskit_id(), widget.interact_rect)));
            }
        });
        let (zoom, screen) = (ctx.zoom_factor(), Some(ctx.content_rect()));
        let modal = ctx.memory(|memory| memory.top_modal_layer()).map(|layer| layer.id.accesskit_id());
        // egui lists the same widgets in the same order, so that an unchanged frame compares equal.
        if self.tree.as_ref() == Some(&tree)
            && self.visible == visible
            && (self.zoom, self.screen, self.modal) == (zoom, screen, modal)
        {
            return;
        }
        (self.tree, self.visible) = (Some(tree), visible);
        (self.zoom, self.screen, self.modal) = (zoom, screen, modal);
        self.version += 1;
    }
}

impl UiTree {
    /// Goes up by one with every change of the tree.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// The node with the keyboard focus, or the item of it that the keyboard has reached; none if nothing has the
    /// focus.
    pub fn focus(&self) -> Option<NodeId> {
        let tree = self.tree.as_ref()?;
        let root = tree.tree.as_ref().map(|info| info.root);
        let node = |id: NodeId| tree.nodes.iter().find(|(of, _)| *of == id).map(|(_, node)| node);
        let focused = Some(tree.focus).filter(|focus| Some(*focus) != root)?;
        let item = node(focused)?.active_descendant().filter(|item| node(*item).is_some());
        Some(item.unwrap_or(focused))
    }

    /// The widgets on the screen in reading order, containers before their contents. Costs O(nodes).
    pub fn read(&self) -> Vec<Widget<'_>> {
        let (Some(tree), Some(screen)) = (&self.tree, self.screen) else {
            return Vec::new();
        };
        let by_id: HashMap<NodeId, &Node> = tree.nodes.iter().map(|(id, node)| (*id, node)).collect();
        let root = tree.tree.as_ref().map(|info| info.root);
        let mut found = Vec::new();
        // Depth first, so that rows come in order. With each node: the container around it, and what opened it.
        let mut stack: Vec<(NodeId, Option<usize>, Option<usize>)> =
            root.into_iter().map(|root| (root, None, None)).collect();
        while let Some((id, parent, opener)) = stack.pop() {
            let Some(node) = by_id.get(&id) else { continue };
            let rect = self.visible_rect(id, node, screen);
            let holds = is_container(node.role()) && Some(id) != root;
            let is_read = Some(id) != root
                && !node.is_hidden()
                && !is_scaffolding(node.role())
                && (rect.is_positive() || (node.bounds().is_none() && holds));
            let at = is_read.then_some(found.len());
            let inside = if holds { at.or(parent) } else { parent };
            let opens = if holds { None } else { at.or(opener) };
            stack.extend(node.children().iter().rev().map(|child| (*child, inside, opens)));
            if !is_read {
                continue;
            }
            if let Some(opener) = opener.filter(|_| holds)
                && let Some(opener) = found.get_mut(opener)
            {
                let opener: &mut Widget<'_> = opener;
                opener.popup = Some(id);
            }
            let (name, value) = name_and_value(node, &by_id);
            let rect = if rect.is_positive() { rect * self.zoom } else { Rect::ZERO };
            let is_modal = self.modal == Some(id);
            found.push(Widget { id, node, parent, popup: None, is_modal, rect, name, value });
        }
        found
    }

    fn visible_rect(&self, id: NodeId, node: &Node, screen: Rect) -> Rect {
        let bounds = node.bounds().map(|bounds| {
            Rect::from_min_max(
                pos2(bounds.x0 as f32, bounds.y0 as f32),
                pos2(bounds.x1 as f32, bounds.y1 as f32),
            )
        });
        let rect = match (bounds, self.visible.get(&id)) {
            (Some(bounds), Some(visible)) => visible.intersect(bounds),
            (Some(bounds), None) => bounds,
            (None, Some(visible)) => *visible,
            (None, None) => Rect::NOTHING,
        };
        rect.intersect(screen)
    }
}

/// Nodes that only contain others, or are parts of another's text.
fn is_scaffolding(role: Role) -> bool {
    matches!(role, Role::GenericContainer | Role::TextRun | Role::Unknown | Role::Pane)
}

/// Nodes without bounds of their own that say what belongs together.
fn is_container(role: Role) -> bool {
    matches!(
        role,
        Role::Dialog
            | Role::Group
            | Role::ListBox
            | Role::Menu
            | Role::MenuBar
            | Role::TabList
            | Role::Toolbar
            | Role::Tooltip
            | Role::Window
    )
}

fn name_and_value(node: &Node, by_id: &HashMap<NodeId, &Node>) -> (String, Option<Value>) {
    let text = node.value().map(str::to_owned);
    // egui puts the text of a plain label into its value.
    if matches!(node.role(), Role::Label | Role::Alert | Role::Status | Role::Heading) {
        return match node.label() {
            Some(name) => (name.to_owned(), text.map(Value::Text)),
            None => (text.unwrap_or_default(), None),
        };
    }
    let own = node.label().map(str::to_owned);
    let name = own.unwrap_or_else(|| {
        let labels = node.labelled_by().iter().filter_map(|id| by_id.get(id));
        let texts: Vec<&str> = labels.filter_map(|label| label.label().or_else(|| label.value())).collect();
        texts.join(" ")
    });
    (name, node.numeric_value().map(Value::Number).or(text.map(Value::Text)))
}
