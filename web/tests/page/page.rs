//! A page to test: the editor in a harness, with access to its surroundings.

use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect, Ui, UiBuilder, Vec2};
use egui_kittest::wgpu::{WgpuTestRenderer, create_render_state, default_wgpu_setup};
use egui_kittest::{Harness, Node, kittest::Queryable};
use halfedge::{Element, Mesh};
use meshwright_web::access::tree::UiTree;
use meshwright_web::app::App;
use meshwright_web::platform::headless::{Headless, Outside};
use meshwright_web::platform::{Event, NamedBytes};
use serde_json::Value;

/// The state of a test's page.
pub struct State {
    app: Option<App>,
    gpu: Option<egui_wgpu::RenderState>,
    outside: Outside,
}

/// A page in a harness.
pub struct Page {
    pub harness: Harness<'static, State>,
    pub outside: Outside,
}

/// The usual size of a window.
pub const DESKTOP: Vec2 = Vec2::new(1280.0, 800.0);
/// A telephone held upright.
pub const PHONE: Vec2 = Vec2::new(390.0, 844.0);

fn frame(ui: &mut Ui, state: &mut State) {
    let ctx = ui.ctx().clone();
    let State { app, gpu, outside } = state;
    let app = app.get_or_insert_with(|| {
        ctx.add_plugin(UiTree::default());
        App::new(&ctx, Box::new(Headless::new(outside.clone())), gpu.take())
    });
    app.logic(&ctx);
    // The harness adds a margin of its own; the page fills its window.
    let window: Rect = ctx.content_rect();
    let mut root = ui.new_child(UiBuilder::new().max_rect(window));
    root.set_clip_rect(window);
    app.ui(&mut root);
}

impl Page {
    /// A page on the cube, without graphics.
    pub fn new() -> Self {
        Self::sized(DESKTOP)
    }

    /// A page of another size.
    pub fn sized(size: Vec2) -> Self {
        Self::build(size, egui::Theme::Dark, false, &[])
    }

    /// The page on a first visit, with the welcome view.
    pub fn welcoming(size: Vec2) -> Self {
        Self::build_with(Outside::default(), size, egui::Theme::Dark, false)
    }

    /// [`Page::welcoming`] that draws.
    pub fn welcoming_drawn(size: Vec2, theme: egui::Theme) -> Self {
        Self::build_with(Outside::default(), size, theme, true)
    }

    /// A first visit whose address names a file.
    pub fn welcoming_wanting(address: &str) -> Self {
        let outside = Outside::default();
        outside.want(address);
        Self::build_with(outside, DESKTOP, egui::Theme::Dark, false)
    }

    /// A page whose address names files to open with.
    pub fn wanting(addresses: &[&str]) -> Self {
        Self::build(DESKTOP, egui::Theme::Dark, false, addresses)
    }

    /// A page in a theme, without graphics.
    pub fn themed(size: Vec2, theme: egui::Theme) -> Self {
        Self::build(size, theme, false, &[])
    }

    /// A page that draws, for pictures.
    pub fn drawn(size: Vec2, theme: egui::Theme) -> Self {
        Self::build(size, theme, true, &[])
    }

    /// A page that finds a setting of an earlier visit.
    pub fn with_setting(size: Vec2, key: &str, value: &str) -> Self {
        let outside = Outside::default();
        outside.set_setting(key, value);
        Self::build_in(outside, size, egui::Theme::Dark, false, &[])
    }

    /// A page whose address has a parameter.
    pub fn with_parameter(name: &str, value: &str) -> Self {
        let outside = Outside::default();
        outside.set_parameter(name, value);
        Self::build_in(outside, DESKTOP, egui::Theme::Dark, false, &[])
    }

    /// A visit to the page in a browser that may have kept something from earlier ones.
    pub fn visit(outside: &Outside) -> Self {
        Self::visit_sized(outside, DESKTOP)
    }

    /// The same in a window of another size.
    pub fn visit_sized(outside: &Outside, size: Vec2) -> Self {
        Self::build_in(outside.clone(), size, egui::Theme::Dark, false, &[])
    }

    /// The same with the settings as they are.
    pub fn first_visit_of(outside: &Outside) -> Self {
        Self::build_with(outside.clone(), DESKTOP, egui::Theme::Dark, false)
    }

    /// [`Page::first_visit_of`] that draws.
    pub fn first_visit_drawn(outside: &Outside, size: Vec2, theme: egui::Theme) -> Self {
        Self::build_with(outside.clone(), size, theme, true)
    }

    /// Reloads the page, as after a crash: nothing is told to the old one.
    pub fn reload(self) -> Self {
        let outside = self.outside.clone();
        drop(self);
        Self::visit(&outside)
    }

    /// A page whose address has several parameters.
    pub fn with_parameters(parameters: &[(&str, &str)]) -> Self {
        let outside = Outside::default();
        parameters.iter().for_each(|(name, value)| outside.set_parameter(name, value));
        Self::build_in(outside, DESKTOP, egui::Theme::Dark, false, &[])
    }

    /// A page whose address has a fragment.
    pub fn linked(fragment: &str) -> Self {
        let outside = Outside::default();
        outside.set_fragment(fragment);
        Self::build_in(outside, DESKTOP, egui::Theme::Dark, false, &[])
    }

    fn build(size: Vec2, theme: egui::Theme, drawn: bool, addresses: &[&str]) -> Self {
        Self::build_in(Outside::default(), size, theme, drawn, addresses)
    }

    fn build_in(outside: Outside, size: Vec2, theme: egui::Theme, drawn: bool, addresses: &[&str]) -> Self {
        addresses.iter().for_each(|address| outside.want(address));
        // Most tests are about what comes after it.
        outside.set_setting("welcome", "off");
        Self::build_with(outside, size, theme, drawn)
    }

    fn build_with(outside: Outside, size: Vec2, theme: egui::Theme, drawn: bool) -> Self {
        let mut page = Self::make(outside, size, theme, drawn);
        page.run();
        page
    }

    /// A page on a screen with this many pixels per point.
    pub fn dense(size: Vec2, pixels_per_point: f32) -> Self {
        let outside = Outside::default();
        outside.set_setting("welcome", "off");
        let mut page = Self::make(outside, size, egui::Theme::Dark, false);
        let viewports = page.harness.input_mut().viewports.values_mut();
        viewports.for_each(|viewport| viewport.native_pixels_per_point = Some(pixels_per_point));
        page.run();
        page
    }

    /// A visit that has not settled: the page may wait for what the browser keeps.
    pub fn begin_visit(outside: &Outside) -> Self {
        let mut page = Self::make(outside.clone(), DESKTOP, egui::Theme::Dark, false);
        page.wait();
        page
    }

    fn make(outside: Outside, size: Vec2, theme: egui::Theme, drawn: bool) -> Self {
        let mut builder =
            Harness::builder().with_size(size).with_theme(theme).with_max_steps(24).with_render_cursor(false);
        let mut state = State { app: None, gpu: None, outside: outside.clone() };
        if drawn {
            let gpu = create_render_state(default_wgpu_setup(), egui_wgpu::RendererOptions::PREDICTABLE);
            state.gpu = Some(gpu.clone());
            builder = builder.renderer(WgpuTestRenderer::from_render_state(gpu));
        }
        let name = if theme == egui::Theme::Dark { "dark" } else { "light" };
        outside.set_setting("theme", name);
        Self { harness: builder.build_ui_state(frame, state), outside }
    }

    pub fn app(&mut self) -> &mut App {
        self.harness.state_mut().app.as_mut().expect("made in the first frame")
    }

    pub fn run(&mut self) {
        self.harness.run();
    }

    /// Lets a second go by: what takes no longer is not shown as going on.
    pub fn wait(&mut self) {
        for _ in 0..4 {
            self.harness.step();
        }
    }

    /// Runs a command as a script would; it must work.
    pub fn command(&mut self, command: Value) {
        let told = std::rc::Rc::new(std::cell::RefCell::new(None));
        let tell = told.clone();
        self.app().script().run(command.clone(), Box::new(move |answer| *tell.borrow_mut() = Some(answer)));
        self.run();
        let answer = told.borrow_mut().take();
        match answer {
            Some(Ok(_)) => {}
            other => panic!("{command}: {other:?}"),
        }
    }

    /// Opens a file as if it was dropped.
    pub fn open(&mut self, name: &str, text: &str) {
        self.outside.push(Event::Files(vec![NamedBytes::new(name, text.as_bytes())]));
        self.run();
    }

    pub fn select(&mut self, kind: &str, ids: &[u32]) {
        self.app().script().select(kind, ids).expect("elements that exist");
        self.run();
    }

    pub fn mesh(&mut self) -> &Mesh {
        self.app().editor().mesh().expect("an object")
    }

    /// The kind and ids that are selected.
    pub fn selected(&mut self) -> (Element, Vec<u32>) {
        let selection = self.app().editor().selection();
        (selection.kind(), selection.ids().collect())
    }

    /// The ids of the hidden faces of the active object.
    pub fn hidden_faces(&mut self) -> Vec<u32> {
        let object = self.app().editor().document().active().expect("an object");
        object.hidden().iter().map(|face| face as u32).collect()
    }

    pub fn undo_labels(&mut self) -> Vec<String> {
        self.app().editor().undo_labels().map(str::to_owned).collect()
    }

    /// Opens an operation's form from the list.
    pub fn choose(&mut self, operation: &str) {
        if self.has("All operations") {
            self.click("All operations");
        }
        // The row may be below what the panel shows.
        self.find(&format!("{operation}…")).click_accesskit();
        self.run();
    }

    /// Shows why operations can't be done now.
    pub fn open_not_now(&mut self) {
        self.harness.get_by_label_contains("Not now").click_accesskit();
        self.run();
    }

    /// Types a number into a field of a form.
    pub fn type_into(&mut self, field: &str, text: &str) {
        self.harness.get_by_role_and_label(Role::SpinButton, field).click();
        self.run();
        self.press_with(Modifiers::COMMAND, Key::A);
        self.harness.event(egui::Event::Text(text.to_owned()));
        self.run();
        self.press(Key::Enter);
    }

    /// Presses the button of an operation's form.
    pub fn apply(&mut self, operation: &str) {
        self.harness.get_by_role_and_label(Role::Button, operation).click();
        self.run();
    }

    pub fn find<'a>(&'a self, label: &'a str) -> Node<'a> {
        self.harness.get_by_label(label)
    }

    pub fn has(&self, label: &str) -> bool {
        self.harness.query_all_by_label(label).next().is_some()
    }

    pub fn has_part(&self, text: &str) -> bool {
        self.harness.query_all_by_label_contains(text).next().is_some()
    }

    pub fn click(&mut self, label: &str) {
        self.find(label).click();
        self.run();
    }

    pub fn press(&mut self, key: egui::Key) {
        self.harness.key_press(key);
        self.run();
    }

    pub fn press_with(&mut self, modifiers: egui::Modifiers, key: egui::Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.run();
    }

    /// A row of the list that is shown.
    pub fn row<'a>(&'a self, name: &'a str) -> Node<'a> {
        self.harness.get_by_role_and_label(egui::accesskit::Role::ListBoxOption, name)
    }

    pub fn has_row(&self, name: &str) -> bool {
        self.harness.query_all_by_role_and_label(egui::accesskit::Role::ListBoxOption, name).next().is_some()
    }

    /// Where a point of the scene is in the window.
    pub fn at(&mut self, point: [f32; 3]) -> egui::Pos2 {
        let [x, y] = self.app().script().project(point).expect("in front of the eye");
        egui::pos2(x, y)
    }

    /// Moves the pointer to a place.
    pub fn hover(&mut self, at: egui::Pos2) {
        self.harness.hover_at(at);
        self.run();
    }

    /// Moves the pointer to the middle of the viewport, and this far from there.
    pub fn hover_off_middle(&mut self, by: Vec2) {
        let middle = self.find("Viewport").rect().center();
        self.hover(middle + by);
    }

    /// Types text.
    pub fn type_text(&mut self, text: &str) {
        self.harness.event(egui::Event::Text(text.to_owned()));
        self.run();
    }

    /// Turns the wheel; upwards is away from the user.
    pub fn turn_wheel(&mut self, unit: egui::MouseWheelUnit, upwards: f32) {
        self.harness.event(wheel(unit, upwards));
        self.run();
    }

    /// Puts a finger on the screen. eframe takes it for a mouse in the first frame, which has the browser's `pointerdown`.
    pub fn touch(&mut self, at: egui::Pos2) {
        self.harness.input_mut().events.push(press(at, true));
        self.run();
        self.finger(egui::TouchPhase::Start, at, [press(at, true)]);
    }

    /// Moves the finger that is on the screen.
    pub fn move_finger(&mut self, to: egui::Pos2) {
        self.finger(egui::TouchPhase::Move, to, [egui::Event::PointerMoved(to)]);
    }

    /// Lifts the finger.
    pub fn lift_finger(&mut self, at: egui::Pos2) {
        self.harness.input_mut().events.push(press(at, false));
        self.run();
        self.finger(egui::TouchPhase::End, at, [press(at, false), egui::Event::PointerGone]);
    }

    /// Taps with a finger.
    pub fn tap(&mut self, at: egui::Pos2) {
        self.touch(at);
        self.lift_finger(at);
    }

    /// What a browser reports of a finger: what it means for the pointer, then the touch.
    fn finger<const N: usize>(&mut self, phase: egui::TouchPhase, pos: egui::Pos2, events: [egui::Event; N]) {
        let (device_id, id) = (egui::TouchDeviceId(0), egui::TouchId(0));
        let touch = egui::Event::Touch { device_id, id, phase, pos, force: None };
        self.harness.input_mut().events.extend(events.into_iter().chain([touch]));
        self.run();
    }

    /// Presses the first button at one place and lets it go at another.
    pub fn drag(&mut self, from: egui::Pos2, to: egui::Pos2) {
        self.harness.hover_at(from);
        self.run();
        self.harness.drag_at(from);
        self.run();
        for part in 1..=4 {
            self.harness.hover_at(from + (to - from) * (part as f32 / 4.0));
            self.run();
        }
    }

    pub fn drop(&mut self, at: egui::Pos2) {
        self.harness.drop_at(at);
        self.run();
    }
}

/// The event of pressing the first button or letting it go.
fn press(pos: egui::Pos2, pressed: bool) -> egui::Event {
    let (button, modifiers) = (egui::PointerButton::Primary, egui::Modifiers::NONE);
    egui::Event::PointerButton { pos, button, pressed, modifiers }
}

/// The event of a turn of the wheel; upwards is away from the user.
pub fn wheel(unit: egui::MouseWheelUnit, upwards: f32) -> egui::Event {
    egui::Event::MouseWheel {
        unit,
        delta: egui::vec2(0.0, upwards),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: egui::Modifiers::NONE,
    }
}
