//! The mirror of the accessibility tree in the document: a layer of invisible elements over the canvas, each where its
//! widget is.
//!
//! It is always there: a page can't find out whether a screen reader listens, and asking would leave out those who can't
//! see the question. The keyboard focus stays on the canvas, which takes all keys, and `aria-activedescendant` tells
//! assistive technology which element has it. The layer lets the pointer through.

use std::cell::RefCell;
use std::collections::{HashMap, VecDeque};

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};
use egui::{Context, Event, FullOutput, Key, Modifiers, Plugin, RawInput};
use wasm_bindgen::prelude::*;
use web_sys::{
    Document, Element, EventTarget, HtmlCanvasElement, HtmlElement, HtmlInputElement, HtmlTextAreaElement,
};

use crate::access::aria::{Urgency, element_id};
use crate::access::mirror::{Insertion, Mirror, Patch};
use crate::access::tree::UiTree;

thread_local! {
    /// The layer of this page. Plugins can't hold elements, which belong to their thread.
    static LAYER: RefCell<Option<Layer>> = const { RefCell::new(None) };
}

/// Keeps the layer like the tree. Add it after [`UiTree`].
pub struct Mirroring;

impl Plugin for Mirroring {
    fn debug_name(&self) -> &'static str {
        "mirror"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        with_layer(|layer| {
            input.events.extend(layer.requests.pop_front().unwrap_or_default());
            if !layer.requests.is_empty() {
                ctx.request_repaint();
            }
        });
    }

    fn output_hook(&mut self, ctx: &Context, _output: &mut FullOutput) {
        let tree = ctx.plugin::<UiTree>();
        with_layer(|layer| {
            for patch in layer.mirror.update(&tree.lock()) {
                // A document that refuses a change leaves the page usable; the next change is tried again.
                let _ = layer.apply(patch);
            }
        });
    }
}

fn with_layer(body: impl FnOnce(&mut Layer)) {
    LAYER.with(|layer| {
        if let Ok(mut layer) = layer.try_borrow_mut()
            && let Some(layer) = layer.as_mut()
        {
            body(layer);
        }
    });
}

/// Mirrors the page on this canvas; index.html has the elements to fill.
pub fn show_on(ctx: &Context, canvas: &HtmlCanvasElement) -> Result<(), JsValue> {
    // eframe puts the input that takes text right after the canvas.
    let text_input = canvas.next_element_sibling().filter(|next| next.tag_name() == "INPUT");
    if let Some(input) = &text_input {
        input.set_attribute("aria-label", TEXT_ENTRY)?;
        input.set_attribute("tabindex", "-1")?;
    }
    let mut is_installed = false;
    with_layer(|layer| {
        is_installed = true;
        layer.mirror.forget_version();
        (layer.canvas, layer.ctx, layer.text_input) = (canvas.clone(), ctx.clone(), text_input.clone());
    });
    ctx.request_repaint();
    if is_installed { Ok(()) } else { install(ctx, canvas, text_input) }
}

fn install(ctx: &Context, canvas: &HtmlCanvasElement, text_input: Option<Element>) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or("there is no document")?;
    let by_id = |id: &str| document.get_element_by_id(id).ok_or_else(|| format!("there is no #{id}"));
    let root = by_id("mirror")?;
    let layer = Layer {
        ctx: ctx.clone(),
        polite: by_id("said")?,
        assertive: by_id("alerted")?,
        canvas: canvas.clone(),
        text_input,
        root: root.clone(),
        elements: HashMap::new(),
        mirror: Mirror::default(),
        requests: VecDeque::new(),
        document,
    };
    LAYER.with(|slot| slot.replace(Some(layer)));
    for (name, handle) in [
        ("click", Layer::clicked as fn(&mut Layer, NodeId, &EventTarget)),
        ("focusin", Layer::focused),
        ("input", Layer::changed),
    ] {
        let listener = Closure::<dyn FnMut(web_sys::Event)>::new(move |event: web_sys::Event| {
            let Some(target) = event.target() else { return };
            let Some(id) = target.dyn_ref::<Element>().and_then(node_id) else { return };
            with_layer(|layer| {
                handle(layer, id, &target);
                layer.ctx.request_repaint();
            });
            // Keys belong to the canvas.
            with_canvas(|canvas| drop(canvas.focus()));
        });
        root.add_event_listener_with_callback(name, listener.as_ref().unchecked_ref())?;
        // The listener lives as long as the page.
        listener.forget();
    }
    Ok(())
}

/// Calls `body` with the canvas while the layer is free, because the focus moves through other listeners.
fn with_canvas(body: impl FnOnce(HtmlCanvasElement)) {
    let canvas = LAYER.with(|layer| layer.try_borrow().ok()?.as_ref().map(|layer| layer.canvas.clone()));
    if let Some(canvas) = canvas {
        body(canvas);
    }
}

const TEXT_ENTRY: &str = "Text entry";

/// The elements in the document.
struct Layer {
    document: Document,
    ctx: Context,
    canvas: HtmlCanvasElement,
    /// The browser's field for text, in which eframe takes what is typed into any field.
    text_input: Option<Element>,
    root: Element,
    /// What is said when the user is idle.
    polite: Element,
    /// What is said at once.
    assertive: Element,
    elements: HashMap<NodeId, Element>,
    mirror: Mirror,
    /// Events for the coming frames.
    requests: VecDeque<Vec<Event>>,
}

impl Layer {
    fn apply(&mut self, patch: Patch) -> Result<(), JsValue> {
        match patch {
            Patch::Create(id, tag) => {
                let element = self.document.create_element(tag)?;
                element.set_id(&element_id(id));
                self.elements.insert(id, element);
            }
            Patch::Attribute(id, name, Some(value)) => self.element(id)?.set_attribute(name, &value)?,
            Patch::Attribute(id, name, None) => self.element(id)?.remove_attribute(name)?,
            Patch::Text(id, text) => self.element(id)?.set_text_content(Some(&text)),
            Patch::Value(id, value) => set_value(self.element(id)?, &value),
            Patch::Rect(id, [left, top, width, height]) => {
                let style = format!("left:{left}px;top:{top}px;width:{width}px;height:{height}px");
                // Not the attribute, which the page's security policy forbids.
                if let Some(element) = self.element(id)?.dyn_ref::<HtmlElement>() {
                    element.style().set_css_text(&style);
                }
            }
            Patch::Insert(id, Insertion { parent, before }) => {
                let parent = parent.map_or(Ok(&self.root), |parent| self.element(parent))?;
                let before = before.map(|before| self.element(before)).transpose()?;
                parent.insert_before(self.element(id)?, before.map(AsRef::as_ref))?;
            }
            Patch::Remove(id) => {
                if let Some(element) = self.elements.remove(&id) {
                    element.remove();
                }
            }
            Patch::Focus(id) => {
                for holder in [Some(self.canvas.as_ref()), self.text_input.as_ref()].into_iter().flatten() {
                    let holder: &Element = holder;
                    match id {
                        Some(id) => holder.set_attribute("aria-activedescendant", &element_id(id))?,
                        None => holder.remove_attribute("aria-activedescendant")?,
                    }
                }
                if let Some(input) = &self.text_input {
                    let name = self.mirror.focus_name();
                    input.set_attribute("aria-label", if name.is_empty() { TEXT_ENTRY } else { name })?;
                }
            }
            Patch::Announce(urgency, text) => {
                let region = match urgency {
                    Urgency::Polite => &self.polite,
                    Urgency::Assertive => &self.assertive,
                };
                // The same words again are no change, unless a space follows.
                let again = region.text_content().as_deref() == Some(text.as_str());
                region.set_text_content(Some(&if again { format!("{text}\u{a0}") } else { text }));
            }
        }
        Ok(())
    }

    fn element(&self, id: NodeId) -> Result<&Element, JsValue> {
        self.elements.get(&id).ok_or_else(|| JsValue::from("no such element"))
    }

    /// Assistive technology has activated an element.
    fn clicked(&mut self, id: NodeId, target: &EventTarget) {
        let is_field = value_of(target).is_some();
        self.request(id, if is_field { Action::Focus } else { Action::Click }, None);
    }

    /// Assistive technology has moved the focus to an element; a row's focus is its list's.
    fn focused(&mut self, id: NodeId, target: &EventTarget) {
        let is_row = target.dyn_ref::<Element>().and_then(|element| element.get_attribute("role"));
        let list = self.mirror.parent(id).filter(|_| is_row.as_deref() == Some("option"));
        self.request(list.unwrap_or(id), Action::Focus, None);
    }

    /// Assistive technology has changed the value of a field.
    fn changed(&mut self, id: NodeId, target: &EventTarget) {
        let Some((value, is_number)) = value_of(target) else { return };
        self.mirror.forget_value(id);
        if is_number {
            if let Ok(number) = value.parse() {
                self.request(id, Action::SetValue, Some(ActionData::NumericValue(number)));
            }
            return;
        }
        // egui's fields know no such request: replace the text by keys, once the field has the focus.
        self.request(id, Action::Focus, None);
        let press =
            |key, modifiers| Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers };
        let replace = if value.is_empty() { press(Key::Delete, Modifiers::NONE) } else { Event::Text(value) };
        self.requests.push_back(Vec::new());
        self.requests.push_back(vec![press(Key::A, Modifiers::COMMAND), replace]);
    }

    fn request(&mut self, id: NodeId, action: Action, data: Option<ActionData>) {
        let request = ActionRequest { action, target_tree: TreeId::ROOT, target_node: id, data };
        self.requests.push_back(vec![Event::AccessKitActionRequest(request)]);
    }
}

fn node_id(element: &Element) -> Option<NodeId> {
    element.id().strip_prefix('w')?.parse().ok().map(NodeId)
}

fn set_value(element: &Element, value: &str) {
    if let Some(input) = element.dyn_ref::<HtmlInputElement>() {
        input.set_value(value);
    } else if let Some(area) = element.dyn_ref::<HtmlTextAreaElement>() {
        area.set_value(value);
    }
}

/// The value of a field, and whether it is a number.
fn value_of(target: &EventTarget) -> Option<(String, bool)> {
    if let Some(area) = target.dyn_ref::<HtmlTextAreaElement>() {
        return Some((area.value(), false));
    }
    let input: &HtmlInputElement = target.dyn_ref()?;
    Some((input.value(), matches!(input.type_().as_str(), "number" | "range")))
}
