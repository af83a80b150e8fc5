//! The page: the editor on its canvas, and the notices of web/site/start.js while there is no editor.

mod app;
mod browser_keys;
mod graphics;
mod handle;
mod mirror;
mod notice;

use wasm_bindgen::prelude::*;
use web_sys::HtmlCanvasElement;

use crate::platform::browser::describe;
use crate::script;
pub(crate) use handle::Handle;

/// Runs the editor on the canvas with the id `meshwright`, with WebGPU or else WebGL2. If neither works,
/// the page says what is missing.
pub fn start() {
    std::panic::set_hook(Box::new(|info| notice::crashed(&info.to_string())));
    wasm_bindgen_futures::spawn_local(async {
        let Some(canvas) = find_canvas() else {
            return notice::crashed("The page has no canvas with the id `meshwright`.");
        };
        let page = Handle::new(canvas, script::tell);
        if let Err(reasons) = page.begin().await {
            return match page.forced() {
                None => notice::no_graphics(&reasons),
                Some(forced) => notice::stopped(
                    &format!("This browser cannot draw with {}", forced.label()),
                    &format!(
                        "The page's address asks for it: it contains “renderer={}”.\nRemove that from the address, and the \
                         page uses what this browser has.",
                        forced.name()
                    ),
                    &reasons,
                ),
            };
        }
        if let Err(error) = serve(&page) {
            notice::crashed(&describe(&error));
        }
    });
}

/// Listens to scripts and keys.
fn serve(page: &Handle) -> Result<(), JsValue> {
    script::install(page)?;
    script::serve_parent()?;
    browser_keys::listen(page.clone())?;
    app::ask_before_leaving(page.clone())
}

fn find_canvas() -> Option<HtmlCanvasElement> {
    web_sys::window()?.document()?.get_element_by_id("meshwright")?.dyn_into().ok()
}
