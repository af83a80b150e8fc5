//! The benchmark itself, which needs a host.

use std::cell::RefCell;
use std::fmt::Write as _;
use std::rc::Rc;

use egui::{
    Context, Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, UiBuilder, Vec2, pos2, vec2,
};
use egui_kittest::wgpu::{create_render_state, default_wgpu_setup};
use egui_wgpu::{RenderState, ScreenDescriptor, wgpu};
use meshwright_web::access::mirror::Mirror;
use meshwright_web::access::tree::UiTree;
use meshwright_web::app::App;
use meshwright_web::platform::headless::{Headless, Outside};
use meshwright_web::platform::{Event as PlatformEvent, NamedBytes};
use meshwright_web::script::ui_tree;
use rustix::time::{ClockId, clock_gettime};
use serde_json::{Value, json};

const WINDOW: Vec2 = Vec2::new(1280.0, 800.0);
const SECONDS_PER_FRAME: f64 = 1.0 / 60.0;
/// More frames than this are taken for a page that never comes to rest.
const MAX_FRAMES: usize = 3000;
const ROWS: usize = 500;
const COLUMNS: usize = 1000;
const CTRL: Modifiers = Modifiers::COMMAND;
const NONE: Modifiers = Modifiers::NONE;

/// The page without a browser.
struct Page {
    ctx: Context,
    app: App,
    outside: Outside,
    gpu: RenderState,
    mirror: Mirror,
    time: f64,
    /// Whether frames are drawn, which takes long in software; otherwise only the last one of an action is.
    draws: bool,
    /// Whether the last frame asked for another.
    is_restless: bool,
    /// The actions to run have one of these in their name; all if there is none.
    chosen: Vec<String>,
}

/// The processor time of this thread, in milliseconds.
fn now_ms() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    time.tv_sec as f64 * 1e3 + time.tv_nsec as f64 / 1e6
}

impl Page {
    fn new(chosen: Vec<String>) -> Self {
        let outside = Outside::default();
        outside.start_clock();
        outside.set_setting("welcome", "off");
        outside.set_setting("theme", "dark");
        let gpu = create_render_state(default_wgpu_setup(), egui_wgpu::RendererOptions::PREDICTABLE);
        let ctx = Context::default();
        ctx.add_plugin(UiTree::default());
        let app = App::new(&ctx, Box::new(Headless::new(outside.clone())), Some(gpu.clone()));
        let mut page = Self {
            ctx,
            app,
            outside,
            gpu,
            mirror: Mirror::default(),
            time: 0.0,
            draws: true,
            is_restless: true,
            chosen,
        };
        page.rest();
        page
    }

    /// One frame; returns its time in milliseconds.
    fn frame(&mut self, events: Vec<Event>) -> f64 {
        self.time += SECONDS_PER_FRAME;
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, WINDOW)),
            time: Some(self.time),
            events,
            focused: true,
            ..RawInput::default()
        };
        let started = now_ms();
        let app = &mut self.app;
        let mut output = self.ctx.run_ui(input, |ui| {
            let ctx = ui.ctx().clone();
            app.logic(&ctx);
            let window = ctx.content_rect();
            let mut root = ui.new_child(UiBuilder::new().max_rect(window));
            root.set_clip_rect(window);
            app.ui(&mut root);
        });
        let shapes = self.ctx.tessellate(std::mem::take(&mut output.shapes), output.pixels_per_point);
        self.mirror.update(&self.ctx.plugin::<UiTree>().lock());
        self.update_textures(&mut output.textures_delta);
        if self.draws {
            self.paint(&shapes, output.pixels_per_point);
        }
        let took = now_ms() - started;
        self.is_restless = output.viewport_output.values().any(|viewport| viewport.repaint_delay.is_zero());
        if !self.draws && !self.is_restless {
            self.paint(&shapes, output.pixels_per_point);
        }
        // What drawing in software takes is not the page's.
        let _ = self.gpu.device.poll(wgpu::PollType::wait_indefinitely());
        took
    }

    fn update_textures(&self, textures: &mut egui::TexturesDelta) {
        let mut renderer = self.gpu.renderer.write();
        for (id, images) in textures.set.drain() {
            for image in images {
                renderer.update_texture(&self.gpu.device, &self.gpu.queue, id, &image);
            }
        }
        for id in textures.free.drain() {
            renderer.free_texture(&id);
        }
    }

    fn paint(&self, shapes: &[egui::ClippedPrimitive], pixels_per_point: f32) {
        let (device, queue) = (&self.gpu.device, &self.gpu.queue);
        let screen =
            ScreenDescriptor { size_in_pixels: [WINDOW.x as u32, WINDOW.y as u32], pixels_per_point };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut renderer = self.gpu.renderer.write();
        let mut commands = renderer.update_buffers(device, queue, &mut encoder, shapes, &screen);
        commands.push(encoder.finish());
        queue.submit(commands);
    }

    /// Frames until the page is at rest.
    fn rest(&mut self) -> (usize, f64, f64) {
        let (mut frames, mut longest, mut total) = (0, 0.0_f64, 0.0);
        while self.is_restless && frames < MAX_FRAMES {
            let took = self.frame(Vec::new());
            (frames, longest, total) = (frames + 1, longest.max(took), total + took);
        }
        (frames, longest, total)
    }

    /// Measures frames with these events, one list for each frame, and those until the page is at rest.
    fn watch(&mut self, what: &str, frames: Vec<Vec<Event>>) {
        let (mut longest, mut total, count) = (0.0_f64, 0.0, frames.len());
        for events in frames {
            let took = self.frame(events);
            (longest, total) = (longest.max(took), total + took);
        }
        let (more, longest_after, total_after) = self.rest();
        let (longest, total) = (longest.max(longest_after), total + total_after);
        let selection = self.app.editor().selection();
        let note = match selection.len() {
            0 => String::new(),
            len => format!("{len} {} selected", selection.kind()),
        };
        let mark = if longest > 16.0 { "!" } else { " " };
        println!("| {what:<52} | {longest:7.1} {mark} | {total:8.1} | {:4} | {note}", count + more);
    }

    fn is_chosen(&self, group: &str) -> bool {
        self.chosen.is_empty() || self.chosen.iter().any(|word| group.contains(word.as_str()))
    }

    fn key(&mut self, what: &str, modifiers: Modifiers, key: Key) {
        self.watch(what, vec![press(modifiers, key)]);
    }

    fn quietly(&mut self, modifiers: Modifiers, key: Key) {
        self.frame(press(modifiers, key));
        self.rest();
    }

    /// Runs a command as a script does; what its job takes isn't measured.
    fn run(&mut self, command: Value) {
        let failed = Rc::new(RefCell::new(None));
        let tell = failed.clone();
        let reply = Box::new(move |answer: Result<_, String>| *tell.borrow_mut() = answer.err());
        self.app.script().run(command, reply);
        self.is_restless = true;
        self.rest();
        if let Some(problem) = failed.borrow().as_ref() {
            println!("{problem}");
        }
    }

    /// Runs a command whose job is done elsewhere, and measures what remains for the page.
    fn watch_command(&mut self, what: &str, command: Value) {
        self.outside.hold_jobs();
        let started = now_ms();
        self.app.script().run(command, Box::new(|_| {}));
        let first = now_ms() - started;
        self.is_restless = true;
        let (_, before, _) = self.rest();
        self.outside.release_jobs();
        let name = format!("{what} (asking {:.1})", first.max(before));
        self.watch(&name, vec![Vec::new()]);
    }

    fn widget(&mut self, name: &str) -> Pos2 {
        let plugin = self.ctx.plugin::<UiTree>();
        let tree = plugin.lock();
        let nodes = ui_tree::nodes(&tree, [0.0, 0.0]);
        let node = nodes.iter().find(|node| node.name == name).unwrap_or_else(|| panic!("no {name}"));
        let [x, y, width, height] = node.rect;
        pos2(x + width / 2.0, y + height / 2.0)
    }

    fn middle(&mut self) -> Pos2 {
        self.widget("Viewport")
    }
}

fn press(modifiers: Modifiers, key: Key) -> Vec<Event> {
    let event = |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
    vec![
        Event::ModifiersChanged(modifiers),
        event(true),
        event(false),
        Event::ModifiersChanged(Modifiers::NONE),
    ]
}

fn button(at: Pos2, button: PointerButton, pressed: bool, modifiers: Modifiers) -> Event {
    Event::PointerButton { pos: at, button, pressed, modifiers }
}

fn moved(at: Pos2) -> Vec<Event> {
    vec![Event::PointerMoved(at)]
}

/// A drag along points, one frame for each.
fn drag(points: &[Pos2], with: PointerButton, modifiers: Modifiers) -> Vec<Vec<Event>> {
    let (first, last) = (points[0], points[points.len() - 1]);
    let mut frames = vec![
        vec![Event::ModifiersChanged(modifiers), Event::PointerMoved(first)],
        vec![button(first, with, true, modifiers)],
    ];
    frames.extend(points.iter().map(|at| moved(*at)));
    frames.push(vec![button(last, with, false, modifiers)]);
    frames.push(vec![Event::ModifiersChanged(Modifiers::NONE)]);
    frames
}

fn click(at: Pos2) -> Vec<Vec<Event>> {
    drag(&[at], PointerButton::Primary, NONE)
}

/// A sheet of a million triangles in waves that hide each other.
fn waves() -> String {
    let mut text = String::new();
    let size = |at: usize, of: usize| at as f32 / of as f32 * 2.0 - 1.0;
    for row in 0..=ROWS {
        for column in 0..=COLUMNS {
            let (x, y) = (size(column, COLUMNS), size(row, ROWS));
            let _ = writeln!(text, "v {x} {} {y}", 0.1 * (x * 9.0).sin() * (y * 7.0).cos());
        }
    }
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let at = row * (COLUMNS + 1) + column + 1;
            let (right, below) = (at + 1, at + COLUMNS + 1);
            let _ = writeln!(text, "f {at} {below} {right}\nf {right} {below} {}", below + 1);
        }
    }
    text
}

pub fn run() {
    let chosen = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let mut page = Page::new(chosen);
    println!("| {:<52} | {:>9} | {:>8} | {:>4} |", "action", "longest", "total", "n");
    println!("|{:-<54}|{:-<11}|{:-<10}|{:-<6}|", "", "", "", "");
    let text = waves();
    page.outside.push(PlatformEvent::Files(vec![NamedBytes::new("waves.obj", text.as_bytes())]));
    page.outside.hold_jobs();
    page.watch("opening: asking", vec![Vec::new()]);
    page.outside.release_jobs();
    page.watch("opening: the mesh arrives", vec![Vec::new()]);
    type Measure = fn(&mut Page);
    let groups: [(&str, Measure); 10] = [
        ("rest", rest),
        ("views", views),
        ("pick", pick),
        ("region", regions),
        ("select", select),
        ("hide", hide),
        ("lists", lists),
        ("live", live),
        ("save", save),
        ("history", history),
    ];
    for (name, measure) in groups {
        if page.is_chosen(name) {
            page.draws = matches!(name, "rest" | "views");
            measure(&mut page);
            page.quietly(NONE, Key::Escape);
            page.quietly(NONE, Key::Escape);
        }
    }
}

fn rest(page: &mut Page) {
    page.watch("a frame at rest", vec![Vec::new()]);
    let at = page.middle();
    page.frame(moved(pos2(640.0, 2.0)));
    page.rest();
    page.watch("a frame with the pointer over the menu bar", vec![moved(pos2(641.0, 2.0))]);
    let corner = at + vec2(-200.0, 240.0);
    let points: Vec<Pos2> = (0..10).map(|i| corner + vec2(6.0, 2.0) * i as f32).collect();
    page.watch("orbiting, 10 frames", drag(&points, PointerButton::Middle, NONE));
    page.quietly(NONE, Key::Space);
}

/// What each view costs: the same frames in one view, in two, and in four.
fn views(page: &mut Page) {
    let at = page.middle();
    // In the view in perspective, which is there in each case, beside the mesh.
    let corner = at + vec2(30.0, -60.0);
    let points: Vec<Pos2> = (0..10).map(|i| corner + vec2(6.0, 2.0) * i as f32).collect();
    for (name, keys) in [("one view", None), ("four views", Some((CTRL | Modifiers::ALT, Key::Q)))] {
        keys.into_iter().for_each(|(modifiers, key)| page.quietly(modifiers, key));
        page.watch(&format!("views: a frame at rest, {name}"), vec![Vec::new()]);
        let orbit = drag(&points, PointerButton::Middle, NONE);
        page.watch(&format!("views: orbiting, 10 frames, {name}"), orbit);
        page.key(&format!("views: from the right, {name}"), Modifiers::ALT, Key::Num3);
        page.quietly(NONE, Key::Space);
    }
    page.quietly(CTRL | Modifiers::ALT, Key::Q);
}

fn pick(page: &mut Page) {
    let at = page.middle();
    page.watch("pick: the pointer is first over the mesh", vec![moved(at)]);
    for (key, kind) in
        [(Key::Num1, "vertex"), (Key::Num2, "edge"), (Key::Num3, "half-edge"), (Key::Num4, "face")]
    {
        page.quietly(NONE, key);
        let hovers: Vec<_> = (0..20).map(|i| moved(at + vec2(7.0, 3.0) * i as f32)).collect();
        page.watch(&format!("pick: hover over a {kind}, 20 frames"), hovers);
        page.watch(&format!("pick: click on a {kind}"), click(at + vec2(11.0, 5.0)));
    }
}

fn regions(page: &mut Page) {
    let at = page.middle();
    let (least, most) = (at - vec2(190.0, 150.0), at + vec2(0.0, 300.0));
    let ring: Vec<Pos2> = (0..60)
        .map(|i| at + Vec2::angled(i as f32 * 0.1) * (120.0 + 40.0 * (i as f32 * 0.9).sin()))
        .collect();
    for through in ["visible", "through"] {
        for (key, kind) in [(Key::Num1, "vertices"), (Key::Num2, "edges"), (Key::Num4, "faces")] {
            page.quietly(NONE, key);
            page.quietly(NONE, Key::Escape);
            let frames = drag(&[least, at, most], PointerButton::Primary, CTRL);
            page.watch(&format!("region: a box over half the {kind}, {through}"), frames);
            page.quietly(NONE, Key::Escape);
            page.watch(
                &format!("region: a lasso of {kind}, {through}"),
                drag(&ring, PointerButton::Secondary, CTRL),
            );
            page.quietly(NONE, Key::Escape);
            page.quietly(Modifiers::SHIFT, Key::C);
            page.watch(
                &format!("region: a stroke of the circle over {kind}, {through}"),
                drag(&ring[..30], PointerButton::Primary, NONE),
            );
            page.quietly(Modifiers::SHIFT, Key::C);
        }
        page.quietly(Modifiers::ALT, Key::X);
    }
}

/// Selects the half of the faces with lower ids.
fn half(page: &mut Page, kind: &str) {
    let count = page.app.editor().mesh().map_or(0, |mesh| {
        mesh.count(match kind {
            "vertex" => halfedge::Element::Vertex,
            "edge" => halfedge::Element::Edge,
            _ => halfedge::Element::Face,
        })
    });
    let ids: Vec<u32> = (0..count as u32 / 2).collect();
    page.app.script().select(kind, &ids).expect("elements that exist");
    page.is_restless = true;
    page.rest();
}

fn select(page: &mut Page) {
    for (key, kind) in [(Key::Num1, "vertex"), (Key::Num2, "edge"), (Key::Num4, "face")] {
        page.quietly(NONE, key);
        page.key(&format!("select: all ({kind})"), CTRL, Key::A);
        page.key("select: none", CTRL | Modifiers::SHIFT, Key::A);
        half(page, kind);
        page.key("select: invert", CTRL, Key::I);
        page.key("select: undo of a selection", CTRL, Key::Z);
        page.key("select: redo of a selection", CTRL | Modifiers::SHIFT, Key::Z);
        page.key("select: grow", CTRL, Key::Equals);
        page.key("select: shrink", CTRL, Key::Minus);
        page.app.script().select(kind, &[7]).expect("an element");
        page.key("select: linked", CTRL, Key::L);
    }
    page.quietly(NONE, Key::Num4);
    half(page, "face");
    for (key, to) in
        [(Key::Num2, "edges"), (Key::Num3, "half-edges"), (Key::Num1, "vertices"), (Key::Num4, "faces")]
    {
        page.key(&format!("select: half converted to {to}"), NONE, key);
    }
    page.key("select: half expanded to edges", CTRL, Key::Num2);
    page.app.script().select("edge", &[7]).expect("an edge");
    page.watch_command("select: loop", json!({"op": "select-related", "by": "loops"}));
    page.app.script().select("vertex", &[0, 500_000]).expect("vertices");
    page.watch_command("select: shortest path", json!({"op": "select-related", "by": "path"}));
    page.watch_command("select: sharp edges", json!({"op": "select-sharp-edges"}));
    page.watch_command("select: by area", json!({"op": "select-by-area", "compare": "more", "area": 4e-6}));
    page.watch_command("select: non-planar", json!({"op": "select-non-planar"}));
    page.watch_command("select: boundary", json!({"op": "select-boundary", "kind": "vertex"}));
}

fn hide(page: &mut Page) {
    page.quietly(NONE, Key::Num4);
    half(page, "face");
    page.key("hide: half of the faces", NONE, Key::H);
    page.key("hide: undo", CTRL, Key::Z);
    page.key("hide: redo", CTRL | Modifiers::SHIFT, Key::Z);
    page.key("hide: reveal", Modifiers::ALT, Key::H);
    half(page, "face");
    page.key("hide: isolate half", NONE, Key::Slash);
    page.key("hide: isolate again", NONE, Key::Slash);
    page.quietly(CTRL, Key::A);
    page.key("hide: everything", NONE, Key::H);
    page.key("hide: reveal everything", Modifiers::ALT, Key::H);
    page.quietly(NONE, Key::Num1);
    half(page, "vertex");
    page.key("hide: the faces of half of the vertices", NONE, Key::H);
    page.key("hide: all that is left", CTRL, Key::A);
    page.key("hide: reveal", Modifiers::ALT, Key::H);
}

fn lists(page: &mut Page) {
    for (key, kind) in
        [(Key::Num2, "edges"), (Key::Num3, "half-edges"), (Key::Num4, "faces"), (Key::Num1, "vertices")]
    {
        page.key(&format!("lists: {kind}"), NONE, key);
    }
    half(page, "face");
    page.quietly(NONE, Key::H);
    for (key, kind) in
        [(Key::Num2, "edges"), (Key::Num3, "half-edges"), (Key::Num4, "faces"), (Key::Num1, "vertices")]
    {
        page.key(&format!("lists: {kind}, half hidden"), NONE, key);
    }
    let row = page.widget("Vertices") + vec2(0.0, 300.0);
    let hovers: Vec<_> = (0..10).map(|i| moved(row + vec2(0.0, 21.0 * i as f32))).collect();
    page.watch("lists: hover, 10 frames", hovers);
    let wheel = |_| {
        vec![Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            delta: vec2(0.0, -300.0),
            phase: egui::TouchPhase::Move,
            source: egui::MouseWheelSource::Wheel,
            modifiers: NONE,
        }]
    };
    page.watch("lists: wheel, 10 frames", (0..10).map(wheel).collect());
    page.quietly(CTRL, Key::A);
    page.key("lists: only selected", NONE, Key::O);
    page.watch("lists: only selected, wheel, 10 frames", (0..10).map(wheel).collect());
    page.quietly(NONE, Key::O);
    page.quietly(Modifiers::ALT, Key::H);
}

fn live(page: &mut Page) {
    let at = page.middle();
    let path: Vec<_> = (1..10).map(|i| moved(at + vec2(3.0, 5.0) * i as f32)).collect();
    page.quietly(NONE, Key::Num1);
    let edit = |page: &mut Page, what: &str| {
        page.frame(moved(at));
        page.rest();
        page.key(&format!("live: move of {what}, G"), NONE, Key::G);
        page.watch(&format!("live: move of {what}, 9 frames"), path.clone());
        page.key(&format!("live: move of {what}, Enter"), NONE, Key::Enter);
        page.key(&format!("live: move of {what}, undo"), CTRL, Key::Z);
    };
    page.app.script().select("vertex", &[250_000]).expect("a vertex");
    edit(page, "one vertex");
    half(page, "vertex");
    edit(page, "half");
    page.quietly(Modifiers::SHIFT, Key::O);
    edit(page, "half, soft");
    page.quietly(Modifiers::SHIFT, Key::O);
}

fn save(page: &mut Page) {
    page.key("save: the dialog opens", CTRL, Key::S);
    page.quietly(NONE, Key::Escape);
    page.key("save: the dialog opens again", CTRL, Key::S);
    page.quietly(NONE, Key::Escape);
    page.run(json!({"op": "set-face-color", "faces": [3], "color": "#ff0000"}));
    page.key("save: the dialog opens after an edit", CTRL, Key::S);
    page.quietly(NONE, Key::Escape);
}

fn history(page: &mut Page) {
    page.quietly(NONE, Key::Num1);
    page.quietly(CTRL, Key::A);
    page.watch_command("history: everything moved", json!({"op": "transform", "translate": [0.1, 0, 0]}));
    page.key("history: undo of the move", CTRL, Key::Z);
    page.key("history: redo of the move", CTRL | Modifiers::SHIFT, Key::Z);
    page.quietly(CTRL, Key::A);
    for _ in 0..40 {
        page.quietly(NONE, Key::G);
        page.frame(vec![Event::Text("1".to_owned())]);
        page.quietly(NONE, Key::Enter);
    }
    let edits = page.app.editor().undo_labels().count();
    let at = page.widget("Steps");
    page.frame(vec![Event::PointerMoved(at)]);
    for frame in click(page.widget(&format!("Step {edits}: Transform"))) {
        page.frame(frame);
    }
    page.rest();
    page.key("history: back over 40 moves of everything", NONE, Key::Home);
    page.key("history: forward over 40 moves of everything", NONE, Key::End);
}
