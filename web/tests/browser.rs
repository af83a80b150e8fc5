//! Tests that need a browser.
#![cfg(target_arch = "wasm32")]

use std::ops::ControlFlow;

use editor::{CommandError, ErrorKind, JobRequest, JobResult, Wire};
use formats::NamedBytes;
use meshwright_web::platform::browser::Browser;
use meshwright_web::platform::{DeviceInfo, Event, Platform};
use meshwright_worker::store::Answer;
use meshwright_worker::{Posted, Received, Request};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::{console_log, wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// eframe takes a pen for a mouse.
#[wasm_bindgen_test]
fn the_page_knows_a_pen_from_a_mouse() {
    let browser = browser_of_page(&egui::Context::default());
    let point = js_sys::Function::new_with_args(
        "event, type",
        "document.body.dispatchEvent(new PointerEvent(event, {pointerType: type, bubbles: true}))",
    );
    assert!(!browser.has_pen());
    for (event, kind, has_pen) in [
        ("pointermove", "pen", true),
        ("pointerdown", "pen", true),
        ("pointermove", "mouse", false),
        ("pointerdown", "pen", true),
        ("pointerdown", "touch", false),
    ] {
        point.call2(&JsValue::NULL, &event.into(), &kind.into()).expect("an event");
        assert_eq!(browser.has_pen(), has_pen, "{event} of a {kind}");
    }
}

/// Ids and counts are `u32` and sizes in bytes fit a page: the memory model that the mesh counts on.
#[wasm_bindgen_test]
fn the_page_has_32_bit_memory() {
    assert_eq!(size_of::<usize>(), 4);
}

#[wasm_bindgen_test]
fn messages_of_the_worker_round_trip() {
    let refusal = |field: Option<&str>, kind| Posted::Refused {
        job: 3,
        refusal: CommandError {
            op: "subdivide-loop".to_owned(),
            field: field.map(str::to_owned),
            problem: "face 7 has 4 corners".to_owned(),
            kind,
            is_of_field: field.is_some(),
            advice: field.map(|field| format!("Look at {field}.")),
        },
    };
    let messages = [
        Posted::Ready,
        Posted::Progress { job: 0, fraction: 0.625 },
        refusal(None, ErrorKind::Refused),
        refusal(Some("levels"), ErrorKind::Internal),
        refusal(Some(""), ErrorKind::Cancelled),
        refusal(Some("edges"), ErrorKind::NothingToDo),
        Posted::Misunderstood { job: 4, reason: "no".to_owned() },
        Posted::Crashed { reason: "over".to_owned() },
    ];
    for message in messages {
        let (value, _) = message.to_js();
        let read = Received::from_js(&value).expect("its own value");
        assert_eq!(format!("{read:?}"), format!("{message:?}"));
    }
    let sent = imported("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let bytes = sent.to_bytes();
    let (value, _) = Posted::Done { job: 1 << 40, result: sent, memory: 1048576.0 }.to_js();
    let read = Received::from_js(&value).expect("its own value");
    let Received::Done { job, mut result, memory } = read else { panic!("{read:?}") };
    assert_eq!((job, memory), (1 << 40, 1048576.0));
    let result = result.step(usize::MAX).expect("all of it").expect("its own bytes");
    assert_eq!(result.to_bytes(), bytes);
}

#[wasm_bindgen_test]
fn other_values_are_not_messages() {
    let values = [
        JsValue::UNDEFINED,
        JsValue::from("ready"),
        js_sys::Array::new().into(),
        js_sys::Array::of1(&"unheard of".into()).into(),
        js_sys::Array::of2(&"done".into(), &1.0.into()).into(),
        js_sys::Array::of3(&"progress".into(), &(-1.0).into(), &0.5.into()).into(),
    ];
    for value in values {
        assert!(Received::from_js(&value).is_none(), "{value:?}");
    }
}

#[wasm_bindgen_test]
fn a_request_travels_in_one_buffer_of_its_own_size() {
    let sent = import_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let request = Request::new(5, &sent);
    let transfer = js_sys::Array::from(&request.transfer);
    assert_eq!(transfer.length(), 1);
    let buffer = js_sys::ArrayBuffer::from(transfer.get(0));
    assert_eq!(buffer.byte_length() as usize, sent.byte_len(), "not the whole memory of the program");
    let (job, read) = Request::read(&request.value).expect("its own value");
    assert_eq!(job, 5);
    assert_eq!(read.expect("its own bytes").to_bytes(), sent.to_bytes());
}

#[wasm_bindgen_test]
fn bytes_that_are_not_a_job_are_misunderstood() {
    let bytes = js_sys::Uint8Array::new_from_slice(&[1, 2, 3]);
    let value = js_sys::Array::of2(&7.0.into(), &bytes).into();
    let (job, read) = Request::read(&value).expect("a number and bytes");
    assert!(job == 7 && read.is_err());
    let value = js_sys::Array::of4(&"done".into(), &7.0.into(), &bytes, &0.0.into()).into();
    let Some(Received::Done { job: 7, mut result, .. }) = Received::from_js(&value) else {
        panic!("{value:?}")
    };
    assert!(result.step(usize::MAX).expect("all of it").is_err());
}

fn import_of(obj: &str) -> JobRequest {
    JobRequest::import(vec![NamedBytes { name: "a.obj".to_owned(), bytes: obj.as_bytes().to_vec() }])
}

fn imported(obj: &str) -> JobResult {
    import_of(obj).run(&mut |_| ControlFlow::Continue(())).expect("an OBJ file")
}

/// The browser as the page has it, with the scripts of the site that it calls.
fn browser_of_page(ctx: &egui::Context) -> Browser {
    const START: &str =
        "window.meshwright ??= { ready: new Promise(() => {}) }; window.meshwrightPage ??= {};";
    for script in [START, include_str!("../site/files.js"), include_str!("../site/offline.js")] {
        js_sys::eval(script).expect("a script of the site");
    }
    Browser::new(ctx, DeviceInfo::default())
}

/// A worker whose script is not there: every job that waits for it fails, saying so.
#[wasm_bindgen_test]
async fn a_worker_that_cannot_start_fails_its_jobs() {
    let ctx = egui::Context::default();
    let mut browser = browser_of_page(&ctx);
    let request = import_of("v 0 0 0\n");
    browser.start_job(1, &request);
    browser.start_job(2, &request);
    browser.start_job(3, &request);
    browser.cancel_job(2);
    let (mut failed, mut keeps_nothing) = (Vec::new(), false);
    for _ in 0..100 {
        for event in browser.poll(&ctx) {
            match event {
                Event::JobDone { job, result: Err(error) } => {
                    assert!(error.problem.contains("could not be started"), "{error}");
                    failed.push(job);
                }
                Event::Store(Answer::Crashed(_), _) => keeps_nothing = true,
                event => panic!("{event:?}"),
            }
        }
        if failed.len() >= 2 && keeps_nothing {
            break;
        }
        sleep(50).await;
    }
    assert_eq!(failed, [1, 3], "a job that was cancelled says nothing more");
    assert!(keeps_nothing, "the worker that keeps documents says so too");
}

async fn sleep(milliseconds: i32) {
    let promise = js_sys::Promise::new(&mut |resolve, _| {
        let window = web_sys::window().unwrap();
        window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, milliseconds).unwrap();
    });
    wasm_bindgen_futures::JsFuture::from(promise).await.unwrap();
}

#[wasm_bindgen_test]
fn settings_persist() {
    let ctx = egui::Context::default();
    let mut browser = browser_of_page(&ctx);
    assert_eq!(browser.load_setting("a test's"), None);
    browser.store_setting("a test's", "1");
    browser.store_setting("a test's", "über");
    let later = browser_of_page(&ctx);
    assert_eq!(later.load_setting("a test's").as_deref(), Some("über"));
    assert_eq!(later.load_setting("a test"), None);
}

#[wasm_bindgen_test]
fn the_clock_advances() {
    let browser = browser_of_page(&egui::Context::default());
    let first = browser.now();
    while browser.now() <= first {}
    assert!(browser.now() - first < 60.0, "seconds, not milliseconds");
}

/// What the worker does with the page's bytes. Says how fast a large OBJ is read in WebAssembly;
/// `cargo xtask test --only wasm -- --release` gives numbers that mean something.
#[wasm_bindgen_test]
fn a_large_obj_goes_through_a_job() {
    let side = 300;
    let text = grid_of_triangles(side);
    let size = text.len() as f64 / 1e6;
    let files = vec![NamedBytes { name: "grid.obj".to_owned(), bytes: text.into_bytes() }];
    let bytes = JobRequest::import(files).to_bytes();
    let request = JobRequest::from_bytes(&bytes).unwrap();
    let clock = web_sys::window().unwrap().performance().unwrap();
    let start = clock.now();
    let mut told = Vec::new();
    let result = request
        .run(&mut |fraction| {
            told.push(fraction);
            ControlFlow::Continue(())
        })
        .unwrap();
    let seconds = (clock.now() - start) / 1000.0;
    console_log!("read and built {} triangles, {size:.1} MB: {:.0} MB/s", 2 * side * side, size / seconds);
    assert!(told.len() > 2 && told.is_sorted(), "{told:?}");
    let import = JobResult::from_bytes(&result.to_bytes()).unwrap().into_import().unwrap();
    let [object] = import.model.objects.as_slice() else { panic!("{} objects", import.model.objects.len()) };
    assert_eq!(object.mesh.vertex_count(), (side + 1) * (side + 1));
    assert_eq!(object.mesh.face_count(), 2 * side * side);
}

fn grid_of_triangles(side: usize) -> String {
    use std::fmt::Write;
    let mut text = String::new();
    for y in 0..=side {
        for x in 0..=side {
            let z = (x * 7 + y * 13) % 101;
            writeln!(
                text,
                "v {}.{:06} {}.{:06} 0.{z:06}",
                x,
                (x * 7919) % 1_000_000,
                y,
                (y * 104_729) % 1_000_000
            )
            .unwrap();
        }
    }
    for y in 0..side {
        for x in 0..side {
            let a = y * (side + 1) + x + 1;
            let (b, c, d) = (a + 1, a + side + 2, a + side + 1);
            writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}").unwrap();
        }
    }
    text
}
