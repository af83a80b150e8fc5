//! Saving a file to the user's downloads.

use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::*;
use web_sys::{Blob, BlobPropertyBag, HtmlAnchorElement, Url};

use crate::platform::NamedBytes;

/// How long the browser may take to begin saving; then the copy is released.
const MAX_COPY_MILLISECONDS: i32 = 60_000;

/// Offers one file as a download. Costs a copy of its bytes.
pub fn download(file: &NamedBytes) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let document = window.document().ok_or("there is no document")?;
    let options = BlobPropertyBag::new();
    // A specific type would make some browsers change the file name's extension.
    options.set_type("application/octet-stream");
    let parts = Array::of1(&Uint8Array::new_from_slice(&file.bytes));
    let blob = Blob::new_with_u8_array_sequence_and_options(&parts, &options)?;
    let url = Url::create_object_url_with_blob(&blob)?;
    let link: HtmlAnchorElement = document.create_element("a")?.dyn_into()?;
    link.set_href(&url);
    link.set_download(&file.name);
    link.click();
    let revoke = Closure::once_into_js(move || {
        // Can't fail for the URL created above.
        let _ = Url::revoke_object_url(&url);
    });
    window.set_timeout_with_callback_and_timeout_and_arguments_0(
        revoke.unchecked_ref(),
        MAX_COPY_MILLISECONDS,
    )?;
    Ok(())
}
