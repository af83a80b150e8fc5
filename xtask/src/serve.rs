//! `cargo xtask serve`: serves the page on this machine and rebuilds it when a source changes.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use notify::{EventKind, RecommendedWatcher, RecursiveMode, Watcher};
use tiny_http::{Header, Request, Response, Server};

use crate::project::Project;
use crate::setup;
use crate::shell::{self, Result, read, step};
use crate::site::{self, Kind};

const DEFAULT_PORT: u16 = 8080;

/// What the site is built from.
const SOURCES: [&str; 4] = ["Cargo.toml", "Cargo.lock", "crates", "web"];

/// Editors write several files at once, or one in several steps: building waits for this long without a change.
const QUIET: Duration = Duration::from_millis(200);

/// Where tabs ask for the number of the build that is being served.
const BUILD_PATH: &str = "build";
/// The script by which they reload once there is another.
const RELOAD_SCRIPT: &str = "reload.js";
const RELOAD: &str = "\
// Of `cargo xtask serve`: reloads the page once it has been rebuilt.
const build = async () => (await fetch(\"./build\")).text();
const served = await build();
setInterval(async () => { if (await build().catch(() => served) !== served) location.reload(); }, 1000);
";

/// What names the service worker in index.html.
const OFFLINE: &str = "<meta name=\"meshwright-offline\"";

pub fn run(project: &Project, args: &[String]) -> Result {
    let port = port(args)?;
    let wasm = setup::for_building(project)?;
    let server = Server::http(("127.0.0.1", port)).map_err(|error| {
        format!("port {port} can't be served ({error}); choose another one with `--port N`.")
    })?;
    let (_watcher, changes) = watch(project)?;
    let folder = project.site("serve");
    let building = project.site("serve-next");
    let number = Arc::new(AtomicU64::new(0));
    thread::spawn({
        let (folder, number) = (folder.clone(), number.clone());
        move || server.incoming_requests().for_each(|request| answer(request, &folder, &number))
    });
    loop {
        // In another folder, so that no tab gets half of a build.
        let built =
            site::build(project, &wasm, Kind::Quick, &building).and_then(|()| replace(&building, &folder));
        match built {
            Ok(()) => {
                number.fetch_add(1, Ordering::Relaxed);
                step(format!("the page is at http://127.0.0.1:{port}/ (Ctrl+C stops)"));
            }
            // The tab keeps what was built before.
            Err(message) => eprintln!("\nerror: {message}\n"),
        }
        wait(&changes)?;
    }
}

fn port(args: &[String]) -> Result<u16> {
    match args {
        [] => Ok(DEFAULT_PORT),
        [flag, port] if flag == "--port" => {
            port.parse().map_err(|_| format!("`--port` takes a number from 0 to 65535, not `{port}`."))
        }
        _ => Err(format!("`serve` takes `--port N`, not `{}`.", args.join(" "))),
    }
}

/// Sends a message for each change of a source, as long as the watcher lives.
fn watch(project: &Project) -> Result<(RecommendedWatcher, Receiver<()>)> {
    let (changed, changes) = mpsc::channel();
    let cannot = |error: notify::Error| format!("the sources can't be watched for changes: {error}.");
    let mut watcher = notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
        if !event.is_ok_and(|event| matches!(event.kind, EventKind::Access(_))) {
            // Nobody listens only when the program ends.
            let _ = changed.send(());
        }
    })
    .map_err(cannot)?;
    for source in SOURCES {
        watcher.watch(&project.root.join(source), RecursiveMode::Recursive).map_err(cannot)?;
    }
    Ok((watcher, changes))
}

/// Waits for a change, and until the changes end.
fn wait(changes: &Receiver<()>) -> Result {
    let ended = "the sources are no longer watched for changes; start again.";
    changes.recv().map_err(|_| ended.to_owned())?;
    loop {
        match changes.recv_timeout(QUIET) {
            Ok(()) => {}
            Err(RecvTimeoutError::Timeout) => return Ok(()),
            Err(RecvTimeoutError::Disconnected) => return Err(ended.to_owned()),
        }
    }
}

/// Puts a build in the place of the one before, with the script that reloads the page, and without the service worker, which
/// would show the build before.
fn replace(built: &Path, folder: &Path) -> Result {
    let index = built.join("index.html");
    let reload = format!("  <script type=\"module\" src=\"{RELOAD_SCRIPT}\"></script>\n</head>");
    let html = read(&index)?.replace("</head>", &reload);
    let html = html.lines().filter(|line| !line.contains(OFFLINE)).collect::<Vec<_>>().join("\n");
    shell::write(&index, &html)?;
    shell::write(&built.join(RELOAD_SCRIPT), RELOAD)?;
    shell::remove_folder(folder)?;
    fs::rename(built, folder).map_err(|error| format!("{} can't be renamed: {error}.", built.display()))
}

fn answer(request: Request, folder: &Path, number: &AtomicU64) {
    let path = request.url().split(['?', '#']).next().unwrap_or_default().trim_start_matches('/');
    // A tab that has gone needs no answer.
    let _ = match file(folder, path) {
        _ if path == BUILD_PATH => {
            request.respond(uncached(Response::from_string(number.load(Ordering::Relaxed).to_string())))
        }
        Some((path, file)) => {
            let mut response = uncached(Response::from_file(file));
            if let Some(header) = content_type(&path) {
                response.add_header(header);
            }
            request.respond(response)
        }
        None if number.load(Ordering::Relaxed) == 0 => {
            request.respond(Response::from_string("The page is being built.").with_status_code(503))
        }
        None => request.respond(Response::from_string("There is no such file.").with_status_code(404)),
    };
}

/// The file that an address means; those outside the folder are not served.
fn file(folder: &Path, path: &str) -> Option<(PathBuf, File)> {
    let is_plain = |part: &str| !part.is_empty() && !part.starts_with('.') && !part.contains(['\\', ':']);
    let path = if path.is_empty() { "index.html" } else { path };
    let path = path.split('/').all(is_plain).then(|| folder.join(path)).filter(|path| path.is_file())?;
    let file = File::open(&path).ok()?;
    Some((path, file))
}

fn uncached<R: std::io::Read>(response: Response<R>) -> Response<R> {
    match Header::from_bytes("cache-control", "no-store") {
        Ok(header) => response.with_header(header),
        Err(()) => response,
    }
}

fn content_type(path: &Path) -> Option<Header> {
    let kind = match path.extension()?.to_str()? {
        "css" => "text/css; charset=utf-8",
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "png" => "image/png",
        "svg" => "image/svg+xml",
        "wasm" => "application/wasm",
        "webmanifest" => "application/manifest+json",
        _ => "application/octet-stream",
    };
    Header::from_bytes("content-type", kind).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_of_the_folder_are_served() {
        let folder = std::env::temp_dir().join(format!("meshwright-serve-{}", std::process::id()));
        fs::create_dir_all(folder.join("site/embed")).expect("folders");
        for name in ["secret", "site/index.html", "site/embed/a.js", "site/.hidden"] {
            fs::write(folder.join(name), name).expect("a file");
        }
        let site = folder.join("site");
        let served = |path: &str| file(&site, path).map(|(path, _)| path);
        assert_eq!(served(""), Some(site.join("index.html")));
        assert_eq!(served("embed/a.js"), Some(site.join("embed/a.js")));
        for path in ["../secret", "embed/../../secret", "..", "embed", "no.js", ".hidden", "embed//a.js"] {
            assert_eq!(served(path), None, "{path}");
        }
        fs::remove_dir_all(folder).expect("removed");
    }
}
