//! How widgets look in the document: their element, ARIA role and attributes.
//!
//! Fields, spin boxes and sliders are native inputs, because assistive technology can set only those. Everything else is
//! a `div` with a role. Where ARIA wants a certain parent (an option in a list box, a tab in a tab list), a widget that
//! has none becomes a button.

use egui::accesskit::{Action, HasPopup, Live, Node, NodeId, Orientation, Role, Toggled};

use super::tree::{Value, Widget};

/// The id of a widget's element in the document.
pub fn element_id(id: NodeId) -> String {
    format!("w{}", id.0)
}

/// What the document shows of a widget.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Element {
    /// The name of the HTML element. An element cannot change it.
    pub tag: &'static str,
    /// The attributes, each once.
    pub attributes: Vec<(&'static str, String)>,
    /// The text inside.
    pub text: String,
    /// The value of an input.
    pub value: Option<String>,
    /// Left, top, width and height in whole CSS pixels; left and top from the corner of the container.
    pub rect: [i32; 4],
    /// What to say when it appears or changes, and whether to interrupt for it.
    pub announcement: Option<(Urgency, String)>,
}

/// How urgent an announcement is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Urgency {
    /// Said when the user is idle: results.
    Polite,
    /// Said at once: errors.
    Assertive,
}

impl Element {
    /// The value of an attribute.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(of, _)| *of == name).map(|(_, value)| value.as_str())
    }

    /// The ARIA role, if it isn't the element's own.
    pub fn role(&self) -> Option<&str> {
        self.attribute("role")
    }

    fn with(&mut self, name: &'static str, value: impl ToString) {
        self.attributes.push((name, value.to_string()));
    }
}

/// Stands in for a role where there is nothing to read.
const HIDDEN: &str = "hidden";

/// The elements of widgets, in their order, without their places.
pub fn elements(widgets: &[Widget<'_>]) -> Vec<Element> {
    let kinds = Kinds::of(widgets);
    let mut elements: Vec<Element> =
        widgets.iter().enumerate().map(|(at, widget)| element(widget, kinds.of_widget(at))).collect();
    name_dialogs(widgets, &mut elements);
    elements
}

/// Names dialogs without a title by the first thing in them.
fn name_dialogs(widgets: &[Widget<'_>], elements: &mut [Element]) {
    for at in 0..elements.len() {
        let is_nameless =
            |element: &Element| element.role() == Some("dialog") && element.attribute("aria-label").is_none();
        if elements.get(at).is_some_and(is_nameless) {
            let inside = widgets.iter().filter(|widget| widget.parent == Some(at));
            let name = inside.map(|widget| widget.name.as_str()).find(|name| !name.is_empty());
            if let Some(element) = elements.get_mut(at) {
                element.with("aria-label", name.unwrap_or("Dialog"));
            }
        }
    }
}

/// The role of each widget, after the check that it suits its container.
struct Kinds(Vec<&'static str>);

impl Kinds {
    fn of(widgets: &[Widget<'_>]) -> Self {
        let mut kinds: Vec<&'static str> = Vec::with_capacity(widgets.len());
        let (mut has_items, mut has_others) = (vec![false; widgets.len()], vec![false; widgets.len()]);
        for widget in widgets {
            let around = widget.parent.and_then(|at| kinds.get(at).copied());
            kinds.push(kind(widget.node, around.unwrap_or_default()));
        }
        // ARIA refuses a menu, a list box or a tab list that has other things inside, or nothing.
        for (widget, kind) in widgets.iter().zip(&kinds) {
            let Some(parent) = widget.parent else { continue };
            let Some(wanted) = kinds.get(parent).map(|parent| items_of(parent)) else { continue };
            let flags = if wanted.contains(kind) { &mut has_items } else { &mut has_others };
            if let Some(flag) = flags.get_mut(parent).filter(|_| !kind.is_empty() && *kind != HIDDEN) {
                *flag = true;
            }
        }
        let fits: Vec<bool> =
            has_items.iter().zip(&has_others).map(|(items, others)| *items && !*others).collect();
        let is_broken = |at: usize| {
            let is_strict = kinds.get(at).is_some_and(|kind| !items_of(kind).is_empty());
            is_strict && !fits.get(at).copied().unwrap_or_default()
        };
        let suited = kinds.iter().zip(widgets).enumerate().map(|(at, (kind, widget))| match *kind {
            _ if is_broken(at) => "group",
            "menuitem" | "option" | "tab" if widget.parent.is_none_or(is_broken) => "button",
            "menuitemcheckbox" if widget.parent.is_none_or(is_broken) => "checkbox",
            "menuitemradio" if widget.parent.is_none_or(is_broken) => "radio",
            kind => kind,
        });
        let suited = suited.collect();
        Self(suited)
    }

    fn of_widget(&self, at: usize) -> &'static str {
        self.0.get(at).copied().unwrap_or_default()
    }
}

/// The roles that a container of items may contain; none for others.
fn items_of(kind: &str) -> &'static [&'static str] {
    match kind {
        "menu" => &["menuitem", "menuitemcheckbox", "menuitemradio", "separator"],
        "listbox" => &["option"],
        "tablist" => &["tab"],
        _ => &[],
    }
}

/// The role of a node inside a container; empty for plain text.
fn kind(node: &Node, around: &str) -> &'static str {
    match (node.role(), around) {
        (Role::Button | Role::DefaultButton | Role::MenuItem, "menu") => "menuitem",
        (Role::CheckBox | Role::Switch | Role::MenuItemCheckBox, "menu") => "menuitemcheckbox",
        (Role::RadioButton | Role::MenuItemRadio, "menu") => "menuitemradio",
        (Role::Button | Role::ListBoxOption, "listbox") => "option",
        (Role::Tab, "tablist") => "tab",
        (Role::CheckBox | Role::MenuItemCheckBox, _) => "checkbox",
        (Role::Switch, _) => "switch",
        (Role::RadioButton | Role::MenuItemRadio, _) => "radio",
        (Role::Link, _) => "link",
        (Role::ComboBox, _) => "combobox",
        (Role::ListBox, _) => "listbox",
        (Role::TabList, _) => "tablist",
        (Role::Menu, _) => "menu",
        (Role::Dialog | Role::AlertDialog | Role::Window, _) => "dialog",
        (Role::Group | Role::MenuBar, _) => "group",
        (Role::Toolbar, _) => "toolbar",
        (Role::Tooltip, _) => "tooltip",
        (Role::Heading, _) => "heading",
        (Role::Image, _) => "img",
        (Role::ProgressIndicator, _) => "progressbar",
        // Only what can be moved by keys is worth reading; a list scrolls with its rows.
        (Role::Splitter, _) if node.supports_action(Action::SetValue) => "separator",
        (Role::Splitter | Role::ScrollBar, _) => HIDDEN,
        (Role::Canvas, _) => "application",
        (Role::Slider, _) => "slider",
        (Role::SpinButton | Role::NumberInput, _) => "spinbutton",
        (Role::MultilineTextInput, _) => "textarea",
        (Role::TextInput | Role::SearchInput, _) => "textbox",
        (Role::Label | Role::Alert | Role::Status | Role::ColumnHeader, _) => "",
        _ if node.supports_action(Action::Click) => "button",
        _ => "",
    }
}

fn element(widget: &Widget<'_>, kind: &'static str) -> Element {
    let node = widget.node;
    let mut element = Element { tag: "div", ..Element::default() };
    element.announcement = announcement(widget);
    let value = widget.value.as_ref().map(words);
    let mut description = vec![node.description().map(str::to_owned)];
    match kind {
        HIDDEN => {
            element.with("aria-hidden", "true");
            return element;
        }
        // Plain text has no name, only its words.
        "" | "heading" | "tooltip" => {
            element.text = widget.name.clone();
            match kind {
                "heading" => element.with("aria-level", 2),
                "tooltip" if element.text.is_empty() => element.with("aria-label", "Tooltip"),
                _ => {}
            }
            if kind.is_empty() {
                return element;
            }
        }
        "textbox" | "textarea" => {
            element.tag = if kind == "textbox" { "input" } else { "textarea" };
            element.value = Some(value.unwrap_or_default());
            if let Some(placeholder) = node.placeholder() {
                element.with("placeholder", placeholder);
            }
        }
        "spinbutton" | "slider" => range(&mut element, node, kind),
        "progressbar" | "separator" => {
            limits(&mut element, node, ["aria-valuemin", "aria-valuemax", "aria-valuenow"]);
            if let Some(Orientation::Vertical) = node.orientation() {
                element.with("aria-orientation", "vertical");
            }
        }
        // The text inside a combo box is its value.
        "combobox" => element.text = value.unwrap_or_default(),
        // What is under the pointer is for those who see it.
        "application" => {}
        // The tooltip of a tab has its count.
        "tab" if node.description().is_some() => {}
        _ => description.insert(0, value),
    }
    if element.tag == "div" {
        element.with("role", kind);
    }
    if !widget.name.is_empty() && element.text != widget.name {
        element.with("aria-label", &widget.name);
    }
    states(&mut element, widget, kind);
    let description: Vec<String> =
        description.into_iter().flatten().filter(|text| !text.is_empty()).collect();
    if !description.is_empty() {
        element.with("aria-description", description.join(". "));
    }
    if node.supports_action(Action::Focus) || node.supports_action(Action::Click) {
        // Not in the browser's own order: the page's keys lead from one to the next.
        element.with("tabindex", -1);
    }
    element
}

/// A native input for a number, which assistive technology can change by steps.
fn range(element: &mut Element, node: &Node, kind: &'static str) {
    element.tag = "input";
    element.with("type", if kind == "slider" { "range" } else { "number" });
    limits(element, node, ["min", "max", ""]);
    element.with("step", node.numeric_value_step().map_or_else(|| "any".to_owned(), |step| step.to_string()));
    if let Some(text) = node.value() {
        element.with("aria-valuetext", text);
    }
    element.value = Some(node.numeric_value().map_or_else(String::new, |value| value.to_string()));
}

fn limits(element: &mut Element, node: &Node, names: [&'static str; 3]) {
    let values = [node.min_numeric_value(), node.max_numeric_value(), node.numeric_value()];
    for (name, value) in names.into_iter().zip(values) {
        // Types of numbers have limits too, which say nothing.
        if let Some(value) = value.filter(|value| !name.is_empty() && value.abs() < 1e15) {
            element.with(name, value);
        }
    }
}

fn states(element: &mut Element, widget: &Widget<'_>, kind: &'static str) {
    let node = widget.node;
    let toggled = node.toggled().map(|toggled| match toggled {
        Toggled::True => "true",
        Toggled::False => "false",
        Toggled::Mixed => "mixed",
    });
    let on = node.is_selected().map(|on| if on { "true" } else { "false" }).or(toggled);
    match kind {
        "checkbox" | "switch" | "radio" | "menuitemcheckbox" | "menuitemradio" => {
            element.with("aria-checked", on.unwrap_or("false"));
        }
        "option" | "tab" => element.with("aria-selected", on.unwrap_or("false")),
        "button" => {
            if let Some(on) = on {
                element.with("aria-pressed", on);
            }
        }
        "listbox" if node.is_multiselectable() => element.with("aria-multiselectable", "true"),
        "dialog" if widget.is_modal => element.with("aria-modal", "true"),
        _ => {}
    }
    let expanded = node.is_expanded().or(widget.popup.map(|_| true));
    match kind {
        "combobox" => element.with("aria-expanded", expanded.unwrap_or(false)),
        "button" | "menuitem" | "link" => {
            if let Some(expanded) = expanded {
                element.with("aria-expanded", expanded);
            }
        }
        _ => {}
    }
    if let Some(popup) = widget.popup {
        element.with("aria-controls", element_id(popup));
    }
    if let (Some(HasPopup::Menu), "button" | "menuitem") = (node.has_popup(), kind) {
        element.with("aria-haspopup", "menu");
    }
    if let ("option", Some(at), Some(size)) = (kind, node.position_in_set(), node.size_of_set()) {
        element.with("aria-posinset", at);
        element.with("aria-setsize", size);
    }
    if node.is_disabled() {
        element.with("aria-disabled", "true");
    }
}

fn announcement(widget: &Widget<'_>) -> Option<(Urgency, String)> {
    let urgency = match widget.node.live()? {
        Live::Off => return None,
        Live::Polite => Urgency::Polite,
        Live::Assertive => Urgency::Assertive,
    };
    let text = widget.node.description().unwrap_or(&widget.name);
    Some((urgency, text.to_owned()))
}

fn words(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => text.clone(),
    }
}
