//! The editor and the canvas that it is drawn on. The editor outlives its canvas: when the graphics device is lost, it is
//! drawn on a new one.

use std::cell::{Cell, RefCell, RefMut};
use std::rc::Rc;

use eframe::WebRunner;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

use super::app::PageApp;
use super::browser_keys::Pressed;
use super::graphics::{self, Renderer, Trouble, Unusable, WEBGPU_LIMIT_MS};
use super::{mirror, notice};
use crate::app::{App, drawing};
use crate::platform::browser::{address_parameter, describe, load_tab_setting, sleep, store_tab_setting};

/// The parameter of the page's address that names the only renderer to use, and the setting of a tab in which WebGPU failed.
const RENDERER: &str = "renderer";

/// The pauses between attempts to get a device again, in milliseconds: a graphics process that has crashed takes a moment
/// to start.
const PAUSES_MS: [i32; 5] = [0, 500, 1000, 2000, 4000];

/// How often the page looks whether the document is open, in milliseconds.
const OPENING_MS: i32 = 100;

/// A device that is lost more often within this time is not asked for again.
const LOSSES_MS: f64 = 60_000.0;
const MAX_LOSSES: usize = 2;

thread_local! {
    /// The editor of this page, for what graphics devices report: those callbacks can't hold it.
    static PAGE: RefCell<Option<Handle>> = const { RefCell::new(None) };
}

/// Gives scripts and browser events access to the editor between two frames.
#[derive(Clone)]
pub struct Handle {
    inner: Rc<Inner>,
}

struct Inner {
    runner: WebRunner,
    pressed: Pressed,
    /// Tells scripts what happened.
    tell: fn(&mut App),
    app: RefCell<Option<App>>,
    canvas: RefCell<HtmlCanvasElement>,
    /// The only renderer to use, if the address names one.
    forced: Option<Renderer>,
    renderer: Cell<Renderer>,
    /// The number of the attempt to draw. What an earlier device reports is of no interest.
    attempt: Cell<u32>,
    /// Whether the device of this attempt has drawn something.
    has_drawn: Cell<bool>,
    /// Whether another device is needed.
    is_lost: Cell<bool>,
    /// When devices were lost, in milliseconds.
    losses: RefCell<Vec<f64>>,
    on_lost_context: Closure<dyn FnMut()>,
}

impl Handle {
    pub fn new(canvas: HtmlCanvasElement, tell: fn(&mut App)) -> Self {
        let forced = address_parameter(RENDERER).and_then(|name| Renderer::named(&name));
        let handle = Self {
            inner: Rc::new(Inner {
                runner: WebRunner::new(),
                pressed: Pressed::default(),
                tell,
                app: RefCell::default(),
                canvas: RefCell::new(canvas),
                forced,
                renderer: Cell::new(Renderer::WebGpu),
                attempt: Cell::default(),
                has_drawn: Cell::default(),
                is_lost: Cell::default(),
                losses: RefCell::default(),
                on_lost_context: Closure::new(|| {
                    let attempt = with_page(|page| page.inner.attempt.get());
                    report(attempt.unwrap_or_default(), Trouble::Lost(String::new()));
                }),
            }),
        };
        PAGE.with(|page| page.replace(Some(handle.clone())));
        handle
    }

    /// The editor; `None` after a crash, and during a call of the editor itself.
    pub fn app(&self) -> Option<RefMut<'_, App>> {
        if self.inner.runner.has_panicked() {
            return None;
        }
        RefMut::filter_map(self.inner.app.try_borrow_mut().ok()?, Option::as_mut).ok()
    }

    /// The editor, made by `make` if there is none yet.
    pub fn app_or_make(&self, make: impl FnOnce() -> App) -> Option<RefMut<'_, App>> {
        let app = self.inner.app.try_borrow_mut().ok()?;
        Some(RefMut::map(app, |app| app.get_or_insert_with(make)))
    }

    pub fn canvas(&self) -> HtmlCanvasElement {
        self.inner.canvas.borrow().clone()
    }

    /// The canvas's top left corner in CSS pixels of the page.
    pub fn corner(&self) -> [f32; 2] {
        let rect = self.inner.canvas.borrow().get_bounding_client_rect();
        [rect.left() as f32, rect.top() as f32]
    }

    /// Tells scripts what happened.
    pub fn tell_scripts(&self, app: &mut App) {
        (self.inner.tell)(app);
    }

    pub fn pressed(&self) -> &Pressed {
        &self.inner.pressed
    }

    /// Whether nothing can be drawn: the device is gone, and another one was not found yet.
    pub fn is_lost(&self) -> bool {
        let inner = &self.inner;
        inner.is_lost.get()
            || (inner.renderer.get() == Renderer::WebGl2
                && graphics::has_lost_context(&inner.canvas.borrow()))
    }

    /// Whether the device has drawn something.
    pub fn has_drawn(&self) -> bool {
        self.inner.has_drawn.get()
    }

    /// Begins to draw: with WebGPU, or else with WebGL2; or with what the address names.
    ///
    /// # Errors
    /// Nothing works; why not.
    pub async fn begin(&self) -> Result<(), String> {
        let of_tab = load_tab_setting(RENDERER).and_then(|name| Renderer::named(&name));
        let order = match self.inner.forced.or(of_tab) {
            Some(renderer) => vec![renderer],
            None => vec![Renderer::WebGpu, Renderer::WebGl2],
        };
        let mut reasons = Vec::new();
        for renderer in order {
            match self.draw_with(renderer).await {
                Ok(()) => return Ok(()),
                Err(Unusable { why, is_broken }) => {
                    if is_broken {
                        self.fall_back(&why);
                    }
                    reasons.push(format!("{}: {why}", renderer.label()));
                }
            }
        }
        Err(reasons.join("\n"))
    }

    /// The renderer that the address names.
    pub fn forced(&self) -> Option<Renderer> {
        self.inner.forced
    }

    /// Notes that WebGPU doesn't work here, so that a reload doesn't try it again.
    fn fall_back(&self, why: &str) {
        web_sys::console::info_1(&format!("WebGPU is not used: {why}").into());
        if self.inner.forced.is_none() {
            store_tab_setting(RENDERER, Renderer::WebGl2.name());
        }
    }

    /// Draws on a new canvas with this renderer.
    async fn draw_with(&self, renderer: Renderer) -> Result<(), Unusable> {
        let inner = &self.inner;
        let options = graphics::options(renderer).await?;
        let unusable = |error: JsValue| Unusable { why: describe(&error), is_broken: true };
        if inner.attempt.get() > 0 {
            self.renew_canvas().map_err(unusable)?;
        }
        let (attempt, canvas) = (inner.attempt.get() + 1, self.canvas());
        inner.attempt.set(attempt);
        inner.renderer.set(renderer);
        inner.has_drawn.set(renderer == Renderer::WebGl2);
        let listener = inner.on_lost_context.as_ref().unchecked_ref();
        canvas.add_event_listener_with_callback("webglcontextlost", listener).map_err(unusable)?;
        let page = self.clone();
        let make = move |context: &eframe::CreationContext<'_>| {
            if let Some(state) = &context.wgpu_render_state {
                graphics::watch(state, attempt, report);
            }
            Ok(Box::new(PageApp::new(context, page)) as Box<dyn eframe::App>)
        };
        inner.runner.start(canvas.clone(), options, Box::new(make)).await.map_err(unusable)?;
        inner.is_lost.set(false);
        // Keys then work before the first click.
        canvas.focus().map_err(unusable)?;
        let ctx = self.app().map(|app| app.ctx().clone());
        if let Some(ctx) = ctx {
            mirror::show_on(&ctx, &canvas).map_err(unusable)?;
        }
        if renderer == Renderer::WebGpu {
            wasm_bindgen_futures::spawn_local(watch_first_frames(attempt));
        }
        Ok(())
    }

    /// Replaces the canvas by an unused one: a canvas with a context can't get another one.
    fn renew_canvas(&self) -> Result<(), JsValue> {
        let mut canvas = self.inner.canvas.borrow_mut();
        let copy: HtmlCanvasElement = canvas.clone_node()?.dyn_into()?;
        canvas.replace_with_with_node_1(&copy)?;
        *canvas = copy;
        Ok(())
    }

    /// Asks to be told when what was drawn so far is on the screen.
    pub fn await_drawing(&self, queue: &wgpu::Queue) {
        let attempt = self.inner.attempt.get();
        queue.on_submitted_work_done(move || {
            with_page(|page| {
                if page.inner.attempt.get() == attempt {
                    page.inner.has_drawn.set(true);
                    if let Some(app) = page.app() {
                        app.ctx().request_repaint();
                    }
                }
            });
        });
    }

    /// Gets another device, and draws the editor with it.
    async fn recover(self, trouble: Trouble) {
        // WebGL2 reports trouble in the middle of a frame.
        sleep(0).await;
        match self.app() {
            Some(mut app) => drawing::stop(&mut app),
            None => return,
        }
        let order = self.order_after(&trouble);
        let mut reasons = vec![trouble.to_string()];
        for pause_ms in PAUSES_MS {
            sleep(pause_ms).await;
            for &renderer in &order {
                match self.draw_with(renderer).await {
                    Ok(()) => return self.tell(&trouble, renderer).await,
                    Err(Unusable { why, .. }) => reasons.push(format!("{}: {why}", renderer.label())),
                }
            }
        }
        notice::stopped(
            "The graphics have stopped working",
            "The document is unchanged and kept in this browser.\nReload the page to go on. If that doesn't help, restart the \
             browser: a graphics driver that was updated or has crashed often works again then.",
            &reasons.join("\n"),
        );
    }

    /// The renderers to try, in order.
    fn order_after(&self, trouble: &Trouble) -> Vec<Renderer> {
        let (inner, now) = (&self.inner, js_sys::Date::now());
        let mut losses = inner.losses.borrow_mut();
        losses.retain(|at| now - at < LOSSES_MS);
        losses.push(now);
        let current = inner.renderer.get();
        if let Some(forced) = inner.forced {
            return vec![forced];
        }
        let is_lost_often = losses.len() > MAX_LOSSES;
        match trouble {
            Trouble::Lost(_) if !is_lost_often => vec![current, current.other()],
            // It may work again, if the other one doesn't work either.
            Trouble::Lost(_) => vec![current.other(), current],
            Trouble::Fails(_) | Trouble::Hangs => vec![Renderer::WebGl2],
        }
    }

    /// Tells the user what happened.
    async fn tell(&self, trouble: &Trouble, renderer: Renderer) {
        let text = match trouble {
            Trouble::Lost(_) => {
                "The graphics device was lost. The page now draws with another one.".to_owned()
            }
            Trouble::Fails(_) | Trouble::Hangs => {
                self.fall_back(&trouble.to_string());
                format!("WebGPU doesn't work here ({trouble}). The page now draws with {}.", renderer.label())
            }
        };
        // The document of the last visit comes with messages of its own.
        while self.app().is_some_and(|app| app.is_opening()) {
            sleep(OPENING_MS).await;
        }
        if let Some(mut app) = self.app() {
            drawing::say(&mut app, text);
        }
    }
}

fn with_page<T>(body: impl FnOnce(&Handle) -> T) -> Option<T> {
    let page = PAGE.with(|page| page.try_borrow().ok()?.clone())?;
    Some(body(&page))
}

/// Handles trouble with the device of an attempt to draw.
fn report(attempt: u32, trouble: Trouble) {
    with_page(|page| {
        let inner = &page.inner;
        if attempt != inner.attempt.get() || inner.is_lost.get() {
            return;
        }
        if matches!(trouble, Trouble::Fails(_))
            && (inner.renderer.get() == Renderer::WebGl2 || inner.forced.is_some())
        {
            // There is nothing better to draw with.
            web_sys::console::error_1(&trouble.to_string().into());
            return;
        }
        inner.is_lost.set(true);
        wasm_bindgen_futures::spawn_local(page.clone().recover(trouble));
    });
}

/// Reports a device that doesn't draw the first frames in time. A page in the background need not draw.
async fn watch_first_frames(attempt: u32) {
    loop {
        sleep(WEBGPU_LIMIT_MS).await;
        let is_over = with_page(|page| page.inner.attempt.get() != attempt || page.inner.has_drawn.get());
        if is_over != Some(false) {
            return;
        }
        let is_hidden =
            web_sys::window().and_then(|window| window.document()).is_some_and(|document| document.hidden());
        if !is_hidden {
            return report(attempt, Trouble::Hangs);
        }
    }
}
