//! The web worker: runs long jobs on its own copy of the mesh, so that the page never freezes.

#[cfg(target_arch = "wasm32")]
fn main() {
    use wasm_bindgen::JsCast;
    let Ok(scope) = js_sys::global().dyn_into::<web_sys::DedicatedWorkerGlobalScope>() else {
        return;
    };
    // Nobody is left to tell when the page has gone.
    let _ = scope.post_message(&"Meshwright worker is ready.".into());
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program runs in a browser, as the page's worker.");
    std::process::exit(2);
}
