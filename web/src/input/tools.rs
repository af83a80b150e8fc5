//! The tools of the viewport, in one table: the tool bar is made from it. To add a tool, add a line; its
//! action must be in a menu, which gives it its description and its key.

use editor::OpId;

use super::actions::Action;
use crate::transforming::Gizmo;
use crate::widgets::icons::Icon;

/// A tool of the tool bar.
#[derive(Clone, Copy, Debug)]
pub struct ToolEntry {
    /// The icon.
    pub icon: Icon,
    /// One or two words in sentence case.
    pub label: &'static str,
    /// What the button starts: a mode of the pointer, or an operation, which follows the pointer if it has an
    /// amount.
    pub action: Action,
}

const fn tool(icon: Icon, label: &'static str, action: Action) -> ToolEntry {
    ToolEntry { icon, label, action }
}

const fn operation(icon: Icon, label: &'static str, id: OpId) -> ToolEntry {
    tool(icon, label, Action::Operation(id))
}

/// The tools from top to bottom, in groups.
pub static TOOLS: &[&[ToolEntry]] = &[
    &[
        tool(Icon::Select, "Select", Action::SelectTool),
        tool(Icon::BoxSelect, "Box", Action::BoxSelect),
        tool(Icon::Lasso, "Lasso", Action::LassoSelect),
        tool(Icon::Circle, "Circle", Action::CircleSelect),
    ],
    &[
        tool(Icon::Move, "Move", Action::Gizmo(Gizmo::Move)),
        tool(Icon::Rotate, "Rotate", Action::Gizmo(Gizmo::Rotate)),
        tool(Icon::Scale, "Scale", Action::Gizmo(Gizmo::Scale)),
    ],
    &[
        operation(Icon::Extrude, "Extrude", OpId::ExtrudeFaces),
        operation(Icon::Inset, "Inset", OpId::InsetFaces),
        operation(Icon::Bevel, "Bevel", OpId::BevelEdges),
        tool(Icon::LoopCut, "Loop cut", Action::LoopCutTool),
        operation(Icon::Slide, "Slide", OpId::SlideEdges),
    ],
    &[
        tool(Icon::Split, "Split", Action::SlideSplit),
        operation(Icon::Connect, "Connect", OpId::ConnectVertices),
    ],
];

/// The toggles of how edits behave, beside those of the look. Symmetry has its own button there.
pub static EDIT_TOGGLES: &[(Icon, Action)] = &[(Icon::Snap, Action::Snap), (Icon::Soft, Action::Soft)];

/// The toggles at the right of the viewport's top: how the model looks.
pub static TOGGLES: &[(Icon, Action)] = &[
    (Icon::XRay, Action::XRay),
    (Icon::Wireframe, Action::Wireframe),
    (Icon::Smooth, Action::Smooth),
    (Icon::Info, Action::Overlay),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::actions;

    #[test]
    fn every_tool_is_in_a_menu_and_in_the_bar_once() {
        let tools: Vec<&ToolEntry> = TOOLS.iter().copied().flatten().collect();
        for (at, tool) in tools.iter().enumerate() {
            assert!(actions::all().any(|entry| entry.action == tool.action), "{tool:?} is in no menu");
            let again = tools.iter().skip(at + 1);
            let again = again.filter(|other| other.label == tool.label || other.action == tool.action);
            assert_eq!(again.count(), 0, "{tool:?} is there twice");
        }
    }
}
