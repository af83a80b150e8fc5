//! The widgets on the screen, as `meshwright.ui()` lists them, read from the accessibility tree that egui
//! builds for every frame and that eframe drops on the web.

use std::collections::HashMap;

use egui::accesskit::{Node, NodeId, Role, Toggled, TreeUpdate};
use egui::{Context, FullOutput, Plugin, Rect, pos2};
use serde::Serialize;

/// A widget that a user or a screen reader can distinguish from others.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UiNode {
    /// AccessKit's role in camel case: `button`, `label`, `spinButton`, `textInput`, `checkBox`...
    pub role: String,
    /// The name: the widget's text, or the text of its label.
    pub name: String,
    /// The value, if there is one: the text of a field, the number of a spin box.
    pub value: Option<Value>,
    /// The description, such as why the widget is disabled.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub description: Option<String>,
    /// The visible part: x, y, width and height in CSS pixels of the page.
    pub rect: [f32; 4],
    /// Whether the widget is disabled.
    pub disabled: bool,
    /// Whether the widget is selected or switched on, if it can be.
    pub selected: Option<bool>,
}

/// The value of a [`UiNode`].
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
/// Add it with [`Context::add_plugin`] and read it with [`UiTree::nodes`]. Costs as much as AccessKit: some
/// microseconds for each widget on the screen.
#[derive(Default)]
pub struct UiTree {
    tree: Option<TreeUpdate>,
    /// The visible part of each widget, by node.
    visible: HashMap<NodeId, Rect>,
    screen: Option<Rect>,
    zoom: f32,
}

impl Plugin for UiTree {
    fn debug_name(&self) -> &'static str {
        "ui tree"
    }

    fn setup(&mut self, ctx: &Context) {
        ctx.enable_accesskit();
    }

    fn output_hook(&mut self, ctx: &Context, output: &mut FullOutput) {
        // Nothing else on the web uses the tree, so it can be taken. A frame without a tree keeps the last
        // one.
        let Some(tree) = output.platform_output.accesskit_update.take() else {
            return;
        };
        self.tree = Some(tree);
        self.zoom = ctx.zoom_factor();
        self.screen = Some(ctx.content_rect());
        self.visible.clear();
        ctx.viewport(|viewport| {
            for (_, widgets) in viewport.prev_pass.widgets.layers() {
                self.visible
                    .extend(widgets.iter().map(|widget| (widget.id.accesskit_id(), widget.interact_rect)));
            }
        });
    }
}

impl UiTree {
    /// The widgets on the screen in reading order; `canvas` is the canvas's corner on the page in CSS
    /// pixels. Costs O(nodes).
    pub fn nodes(&self, canvas: [f32; 2]) -> Vec<UiNode> {
        let (Some(tree), Some(screen)) = (&self.tree, self.screen) else {
            return Vec::new();
        };
        let by_id: HashMap<NodeId, &Node> = tree.nodes.iter().map(|(id, node)| (*id, node)).collect();
        let mut found = Vec::new();
        // Depth first, so that rows come in order, and containers before their contents.
        let mut stack: Vec<NodeId> = tree.tree.iter().map(|info| info.root).collect();
        while let Some(id) = stack.pop() {
            let Some(node) = by_id.get(&id) else { continue };
            stack.extend(node.children().iter().rev());
            if is_scaffolding(node.role()) || node.is_hidden() {
                continue;
            }
            let Some(bounds) = node.bounds() else { continue };
            let bounds = Rect::from_min_max(
                pos2(bounds.x0 as f32, bounds.y0 as f32),
                pos2(bounds.x1 as f32, bounds.y1 as f32),
            );
            let rect =
                self.visible.get(&id).map_or(bounds, |visible| visible.intersect(bounds)).intersect(screen);
            if !rect.is_positive() {
                continue;
            }
            let (name, value) = name_and_value(node, &by_id);
            let zoom = self.zoom;
            found.push(UiNode {
                role: camel_case(node.role()),
                name,
                value,
                description: node.description().map(str::to_owned),
                rect: [
                    canvas[0] + rect.left() * zoom,
                    canvas[1] + rect.top() * zoom,
                    rect.width() * zoom,
                    rect.height() * zoom,
                ],
                disabled: node.is_disabled(),
                selected: node.is_selected().or_else(|| toggled(node)),
            });
        }
        found
    }
}

/// Nodes that only contain others, or are parts of another's text.
fn is_scaffolding(role: Role) -> bool {
    matches!(role, Role::GenericContainer | Role::TextRun | Role::Unknown | Role::Window | Role::Pane)
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

fn toggled(node: &Node) -> Option<bool> {
    match node.toggled()? {
        Toggled::True => Some(true),
        Toggled::False => Some(false),
        Toggled::Mixed => None,
    }
}

fn camel_case(role: Role) -> String {
    let name = format!("{role:?}");
    let mut letters = name.chars();
    letters.next().map(|first| first.to_ascii_lowercase()).into_iter().chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{RawInput, vec2};

    fn frame(ctx: &Context, contents: impl FnMut(&mut egui::Ui)) -> Vec<UiNode> {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, vec2(400.0, 300.0))),
            ..Default::default()
        };
        let mut contents = contents;
        let mut output = ctx.run_ui(input, |ui| {
            egui::CentralPanel::default().show(ui, |ui| contents(ui));
        });
        // Nothing is painted here.
        output.textures_delta.clear();
        ctx.plugin::<UiTree>().lock().nodes([100.0, 10.0])
    }

    fn context() -> Context {
        let ctx = Context::default();
        ctx.add_plugin(UiTree::default());
        ctx
    }

    fn named<'a>(nodes: &'a [UiNode], role: &str, name: &str) -> &'a UiNode {
        nodes
            .iter()
            .find(|node| node.role == role && node.name == name)
            .unwrap_or_else(|| panic!("no {role} called {name:?} in {nodes:#?}"))
    }

    #[test]
    fn lists_widgets_with_names_and_values() {
        let ctx = context();
        let mut x = 2.5;
        let mut text = "abc".to_owned();
        let nodes = frame(&ctx, |ui| {
            ui.label("Position");
            let label = ui.label("x");
            ui.add(egui::DragValue::new(&mut x)).labelled_by(label.id);
            ui.text_edit_singleline(&mut text);
            let _ = ui.selectable_label(true, "Faces");
            ui.add_enabled(false, egui::Button::new("Undo"));
        });
        assert_eq!(named(&nodes, "label", "Position").value, None);
        assert_eq!(named(&nodes, "spinButton", "x").value, Some(Value::Number(2.5)));
        assert_eq!(named(&nodes, "textInput", "").value, Some(Value::Text("abc".to_owned())));
        assert_eq!(named(&nodes, "button", "Faces").selected, Some(true));
        let undo = named(&nodes, "button", "Undo");
        assert!(undo.disabled);
        assert_eq!(undo.selected, None);
        let order: Vec<&str> = nodes.iter().map(|node| node.name.as_str()).collect();
        assert_eq!(order, ["Position", "x", "x", "", "Faces", "Undo"]);
    }

    #[test]
    fn rects_are_in_page_coordinates() {
        let ctx = context();
        let mut seen = Rect::NOTHING;
        ctx.set_zoom_factor(2.0);
        let mut draw = |ui: &mut egui::Ui| seen = ui.button("Open").rect;
        frame(&ctx, &mut draw);
        let nodes = frame(&ctx, &mut draw);
        let [x, y, width, height] = named(&nodes, "button", "Open").rect;
        assert_eq!([x, y], [100.0 + 2.0 * seen.left(), 10.0 + 2.0 * seen.top()]);
        assert_eq!([width, height], [2.0 * seen.width(), 2.0 * seen.height()]);
    }

    #[test]
    fn widgets_scrolled_out_of_view_are_left_out_or_clipped() {
        let ctx = context();
        let nodes = frame(&ctx, |ui| {
            ui.spacing_mut().item_spacing.y = 3.0;
            let area = egui::ScrollArea::vertical().max_height(50.0).min_scrolled_height(50.0);
            area.show(ui, |ui| {
                for row in 0..20 {
                    let _ = ui.add_sized([80.0, 20.0], egui::Button::new(format!("row {row}")));
                }
            });
        });
        let rows = nodes.iter().filter(|node| node.name.starts_with("row"));
        let seen: Vec<(&str, f32)> = rows.map(|row| (row.name.as_str(), row.rect[3])).collect();
        assert_eq!(seen, [("row 0", 20.0), ("row 1", 20.0), ("row 2", 4.0)]);
    }
}
