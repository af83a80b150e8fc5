//! The widgets on the screen, as `meshwright.ui()` lists them.

use egui::accesskit::{Node, Role, Toggled};
use serde::Serialize;

use crate::access::tree::{UiTree, Value};

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

/// The widgets on the screen in reading order; `canvas` is the canvas's corner on the page in CSS pixels. Costs
/// O(nodes).
pub fn nodes(tree: &UiTree, canvas: [f32; 2]) -> Vec<UiNode> {
    let read = tree.read().into_iter();
    let widgets = read.filter(|widget| widget.node.bounds().is_some() && widget.node.role() != Role::Window);
    widgets
        .map(|widget| UiNode {
            role: camel_case(widget.node.role()),
            name: widget.name,
            value: widget.value,
            description: widget.node.description().map(str::to_owned),
            rect: [
                canvas[0] + widget.rect.left(),
                canvas[1] + widget.rect.top(),
                widget.rect.width(),
                widget.rect.height(),
            ],
            disabled: widget.node.is_disabled(),
            selected: widget.node.is_selected().or_else(|| toggled(widget.node)),
        })
        .collect()
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
    use egui::{Context, RawInput, Rect, vec2};

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
        nodes(&ctx.plugin::<UiTree>().lock(), [100.0, 10.0])
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
