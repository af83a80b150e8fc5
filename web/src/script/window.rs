//! The methods of `window.meshwright`, which scripts call between two frames.
//!
//! - `open(name, bytesOrText)`, `openFiles([{name, content}])`, `run(command)`, `export(format)` and
//!   `exportFiles(format)` return promises, which reject with an `Error` that says why.
//! - `state()`, `element(kind, id)`, `select(kind, ids)`, `undo()`, `redo()`, `cancel()`, `project([x, y,
//!   z])`, `on(event, callback)` and `ui()` return at once, or throw such an `Error`.
//!
//! `ready` is in web/site/start.js, because it exists before the editor does.

use std::cell::RefMut;

use js_sys::{Array, ArrayBuffer, Object, Reflect, Uint8Array};
use wasm_bindgen::prelude::*;

use super::js::{Answer, Settle, error, method, promise, to_js, to_json};
use super::ui_tree;
use crate::access::tree::UiTree;
use crate::app::App;
use crate::page::Handle;
use crate::platform::NamedBytes;
use crate::session::jobs::{Answer as Answered, Reply};

/// Adds the methods to the `window.meshwright` of start.js.
pub(crate) fn install(handle: &Handle) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let api = &Reflect::get(&window, &"meshwright".into())?;

    let at = handle.clone();
    method(api, "open", move |name, content| {
        Ok(promise(|settle| {
            let name = name.as_string().ok_or_else(|| error("open: expected the file's name as a string"))?;
            let file = NamedBytes { name, bytes: content_of(&content)? };
            app(&at)?.script().open(vec![file], reply(settle, Wanted::Model));
            Ok(())
        }))
    })?;

    let at = handle.clone();
    method(api, "openFiles", move |files, _| {
        Ok(promise(|settle| {
            app(&at)?.script().open(files_of(&files)?, reply(settle, Wanted::Model));
            Ok(())
        }))
    })?;

    let at = handle.clone();
    method(api, "run", move |command, _| {
        Ok(promise(|settle| {
            let command = to_json(&command, "run: expected a command such as {op: \"split-edge\", edge: 3}")?;
            app(&at)?.script().run(command, reply(settle, Wanted::Model));
            Ok(())
        }))
    })?;

    let at = handle.clone();
    method(api, "export", move |format, _| {
        Ok(promise(|settle| {
            app(&at)?.script().export(&format_of(&format)?, reply(settle, Wanted::Model));
            Ok(())
        }))
    })?;

    let at = handle.clone();
    method(api, "exportFiles", move |format, _| {
        Ok(promise(|settle| {
            app(&at)?.script().export(&format_of(&format)?, reply(settle, Wanted::AllFiles));
            Ok(())
        }))
    })?;

    let at = handle.clone();
    method(api, "state", move |_, _| to_js(&app(&at)?.script().state()))?;

    let at = handle.clone();
    method(api, "element", move |kind, id| {
        let id =
            id_of(&id).ok_or_else(|| error("element: expected a kind and an id, a whole number from 0"))?;
        to_js(&app(&at)?.script().element(&kind_of(&kind)?, id).map_err(|reason| error(&reason))?)
    })?;

    let at = handle.clone();
    method(api, "select", move |kind, ids| {
        let ids = ids_of(&ids).ok_or_else(|| error("select: expected a kind and an array of ids"))?;
        app(&at)?.script().select(&kind_of(&kind)?, &ids).map_err(|reason| error(&reason))?;
        Ok(JsValue::UNDEFINED)
    })?;

    let at = handle.clone();
    method(api, "undo", move |_, _| label(app(&at)?.script().undo()))?;
    let at = handle.clone();
    method(api, "redo", move |_, _| label(app(&at)?.script().redo()))?;
    let at = handle.clone();
    method(api, "cancel", move |_, _| Ok(JsValue::from(app(&at)?.script().cancel() as f64)))?;

    let at = handle.clone();
    method(api, "project", move |point, _| {
        let expected = "project: expected a point [x, y, z]";
        let refused = || error(expected);
        let point: Vec<f64> = serde_json::from_value(to_json(&point, expected)?).map_err(|_| refused())?;
        let [x, y, z] = point.as_slice() else { return Err(refused()) };
        let mut app = app(&at)?;
        let Some([x, y]) = app.script().project([*x as f32, *y as f32, *z as f32]) else {
            return Ok(JsValue::NULL);
        };
        let (corner, zoom) = (at.corner(), app.ctx().zoom_factor());
        to_js(&[corner[0] + x * zoom, corner[1] + y * zoom])
    })?;

    method(api, "on", |name, callback| super::events::on(&name, callback))?;

    let at = handle.clone();
    method(api, "ui", move |_, _| {
        let tree = app(&at)?.ctx().plugin::<UiTree>();
        let nodes = ui_tree::nodes(&tree.lock(), at.corner());
        to_js(&nodes)
    })
}

fn app(handle: &Handle) -> Result<RefMut<'_, App>, JsValue> {
    handle.app().ok_or_else(|| error("the editor has crashed, or is being called by itself; reload the page"))
}

/// Which of the written files a script gets.
#[derive(Clone, Copy)]
enum Wanted {
    /// The bytes of the model itself.
    Model,
    /// All files with their names: the model may come with materials and data.
    AllFiles,
}

/// Settles a promise with the result of a call.
fn reply(settle: &Settle, wanted: Wanted) -> Reply {
    let settle = settle.clone();
    Box::new(move |result| {
        settle.with(match result {
            Ok(Answered::Outcome(outcome)) => to_js(&outcome),
            Ok(Answered::Files(files)) => match wanted {
                Wanted::Model => {
                    Ok(formats::single_file(files).as_ref().map_or(JsValue::UNDEFINED, bytes_to_js))
                }
                Wanted::AllFiles => {
                    files.iter().map(file_to_js).collect::<Result<Array, _>>().map(Into::into)
                }
            },
            Err(reason) => Err(error(&reason)),
        });
    })
}

fn label(step: Result<Option<String>, String>) -> Answer {
    Ok(step.map_err(|reason| error(&reason))?.map_or(JsValue::NULL, JsValue::from))
}

fn bytes_to_js(file: &NamedBytes) -> JsValue {
    Uint8Array::new_from_slice(&file.bytes).into()
}

fn file_to_js(file: &NamedBytes) -> Answer {
    let object = Object::new();
    Reflect::set(&object, &"name".into(), &file.name.as_str().into())?;
    Reflect::set(&object, &"content".into(), &bytes_to_js(file))?;
    Ok(object.into())
}

/// The files in an array of objects as [`file_to_js`] makes them; the content may also be text or a buffer.
fn files_of(files: &JsValue) -> Result<Vec<NamedBytes>, JsValue> {
    let refused = || error("openFiles: expected an array of {name, content}");
    let files: &Array = files.dyn_ref().filter(|files: &&Array| files.length() > 0).ok_or_else(refused)?;
    let field = |file: &JsValue, name: &str| Reflect::get(file, &name.into()).map_err(|_| refused());
    files
        .iter()
        .map(|file| {
            let name = field(&file, "name")?.as_string().ok_or_else(refused)?;
            Ok(NamedBytes { name, bytes: content_of(&field(&file, "content")?)? })
        })
        .collect()
}

fn format_of(format: &JsValue) -> Result<String, JsValue> {
    format.as_string().ok_or_else(|| error("export: expected a format such as \"obj\""))
}

/// Text, a typed array or a whole buffer.
fn content_of(content: &JsValue) -> Result<Vec<u8>, JsValue> {
    if let Some(text) = content.as_string() {
        return Ok(text.into_bytes());
    }
    if content.has_type::<ArrayBuffer>() {
        return Ok(Uint8Array::new(content).to_vec());
    }
    if ArrayBuffer::is_view(content) {
        let view: &Uint8Array = content.unchecked_ref();
        let bytes = Uint8Array::new_with_byte_offset_and_length(
            &view.buffer(),
            view.byte_offset(),
            view.byte_length(),
        );
        return Ok(bytes.to_vec());
    }
    Err(error("open: expected the content as a string, an ArrayBuffer or a typed array"))
}

fn kind_of(kind: &JsValue) -> Result<String, JsValue> {
    kind.as_string().ok_or_else(|| error("expected a kind: vertex, edge, halfedge or face"))
}

fn id_of(value: &JsValue) -> Option<u32> {
    let id = value.as_f64()?;
    (id >= 0.0 && id <= f64::from(u32::MAX) && id.fract() == 0.0).then_some(id as u32)
}

fn ids_of(value: &JsValue) -> Option<Vec<u32>> {
    let is_list = Array::is_array(value) || ArrayBuffer::is_view(value);
    is_list.then(|| Array::from(value))?.iter().map(|id| id_of(&id)).collect()
}
