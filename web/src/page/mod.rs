//! The page: the editor on its canvas, and the notices of web/site/start.js while there is no editor.

mod app;
mod browser_keys;
mod graphics;
mod mirror;
mod notice;

use eframe::WebRunner;
use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

use crate::script;
pub(crate) use app::Handle;
use app::PageApp;
use browser_keys::Pressed;
use graphics::Choice;

/// Runs the editor on the canvas with the id `meshwright`, with WebGPU or else WebGL2. If neither works,
/// the page says what is missing.
pub fn start() {
    std::panic::set_hook(Box::new(|info| notice::crashed(&info.to_string())));
    wasm_bindgen_futures::spawn_local(async {
        let Some(canvas) = find_canvas() else {
            return notice::crashed("The page has no canvas with the id `meshwright`.");
        };
        let first = match start_on(canvas.clone(), Choice::Best).await {
            Ok(()) => return,
            Err(reason) => reason,
        };
        // A canvas that has a WebGPU context can't get another kind of context.
        let again = match fresh(&canvas) {
            Ok(canvas) => start_on(canvas, Choice::WebGl2).await,
            Err(error) => Err(error),
        };
        if let Err(second) = again {
            notice::no_graphics(&format!("{}\n{}", describe(&first), describe(&second)));
        }
    });
}

async fn start_on(canvas: HtmlCanvasElement, choice: Choice) -> Result<(), JsValue> {
    let runner = WebRunner::new();
    let handle = Handle::new(runner.clone(), canvas.clone());
    let pressed = Pressed::default();
    let marked = pressed.clone();
    runner
        .start(
            canvas.clone(),
            graphics::options(choice),
            Box::new(|context| Ok(Box::new(PageApp::new(context, marked, script::tell)))),
        )
        .await?;
    // Keys then work before the first click.
    canvas.focus()?;
    script::install(&handle)?;
    script::serve_parent()?;
    browser_keys::listen(handle.clone(), pressed)?;
    if let Some(app) = handle.app() {
        mirror::install(app.ctx(), &canvas)?;
    }
    app::ask_before_leaving(handle)
}

fn find_canvas() -> Option<HtmlCanvasElement> {
    web_sys::window()?.document()?.get_element_by_id("meshwright")?.dyn_into().ok()
}

/// Replaces a canvas by an unused one.
fn fresh(canvas: &HtmlCanvasElement) -> Result<HtmlCanvasElement, JsValue> {
    let copy: HtmlCanvasElement = canvas.clone_node()?.dyn_into()?;
    canvas.replace_with_with_node_1(&copy)?;
    Ok(copy)
}

fn describe(error: &JsValue) -> String {
    crate::platform::browser::describe(error)
}
