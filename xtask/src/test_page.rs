//! The page as tests open it: what Trunk makes of index.html, made without Trunk. One Cargo run builds page and worker
//! with the dependencies that the tests inside the browser have built already, and no tool has to be installed for it.

use std::path::Path;
use std::process::Command;

use crate::project::Project;
use crate::setup::{TARGET, WasmToolchain};
use crate::shell::{self, Result, read};
use crate::worker_name;

const PAGE: &str = "meshwright-web";
const WORKER: &str = "meshwright-worker";

/// The packages that exist on the page's target only, as Cargo takes them.
pub const PACKAGES: [&str; 4] = ["-p", PAGE, "-p", WORKER];

/// Compiles the page and its worker.
pub fn cargo_build(project: &Project, wasm: &WasmToolchain) -> Command {
    let mut cargo = shell::cargo();
    cargo.args(["build", "--target", TARGET, "--bins"]).args(PACKAGES).current_dir(&project.root);
    wasm.choose(&mut cargo);
    cargo
}

/// Builds the page into a folder of its own.
pub fn build(project: &Project, wasm: &WasmToolchain, site: &Path) -> Result {
    shell::run(&mut cargo_build(project, wasm))?;

    shell::remove_folder(site)?;
    shell::make_folder(site)?;
    for program in [PAGE, WORKER] {
        let built = project.target.join(TARGET).join("debug").join(format!("{program}.wasm"));
        let mut bind = Command::new(project.tools_bin().join("wasm-bindgen"));
        bind.args(["--target", "web", "--no-typescript", "--out-dir"]).arg(site).arg(built);
        shell::run(&mut bind)?;
    }
    let loader = format!("import init from './{WORKER}.js';\nawait init();\n");
    shell::write(&site.join(format!("{WORKER}_loader.js")), &loader)?;
    let (html, copies) = take_copies(&read(&project.root.join("index.html"))?);
    for from in copies {
        copy(&project.root.join(&from), site)?;
    }
    shell::write(&site.join("index.html"), &page_html(&html)?)?;
    worker_name::name_by_content(site)
}

/// index.html without the directives that copy files and folders into the site, and what they copy.
fn take_copies(source: &str) -> (String, Vec<String>) {
    let (mut html, mut copies) = (source.to_owned(), Vec::new());
    for directive in
        ["<link data-trunk rel=\"copy-dir\" href=\"", "<link data-trunk rel=\"copy-file\" href=\""]
    {
        while let Some((before, rest)) = html.split_once(directive)
            && let Some((from, after)) = rest.split_once("\">")
        {
            copies.push(from.to_owned());
            html = format!("{before}{after}");
        }
    }
    (html, copies)
}

/// Copies a file, or a folder with its files, into a folder.
fn copy(from: &Path, folder: &Path) -> Result {
    let to = folder.join(from.file_name().unwrap_or_default());
    if !from.is_dir() {
        let copied = std::fs::copy(from, &to);
        return copied.map(drop).map_err(|error| format!("{} can't be copied: {error}.", from.display()));
    }
    shell::make_folder(&to)?;
    shell::entries(from).iter().try_for_each(|entry| copy(entry, &to))
}

/// index.html with what Trunk's directives stand for in their place: the folder that URLs start from, and a script
/// that starts the page. The worker is started by the page.
fn page_html(source: &str) -> Result<String> {
    let base = "<base data-trunk-public-url>";
    if !source.contains(base) {
        return Err(format!("index.html has no `{base}`, which the build of the page for tests replaces."));
    }
    let mut html = source.replace(base, "<base href=\"./\">");
    let mut programs = 0;
    while let Some((before, rest)) = html.split_once("<link data-trunk rel=\"rust\"")
        && let Some((link, after)) = rest.split_once('>')
    {
        let script = if link.contains("data-type=\"worker\"") {
            String::new()
        } else {
            format!("<script type=\"module\">import init from \"./{PAGE}.js\"; await init();</script>")
        };
        html = format!("{before}{script}{after}");
        programs += 1;
    }
    if programs != 2 || html.contains("data-trunk") {
        return Err(
            "index.html has other Trunk directives than one link for the page and one for the worker: \
            xtask/src/test_page.rs has to know them too."
                .to_owned(),
        );
    }
    Ok(html)
}

#[cfg(test)]
mod tests {
    use super::*;

    const INDEX: &str = include_str!("../../index.html");

    #[test]
    fn directives_are_replaced() {
        let (rest, copies) = take_copies(INDEX);
        assert!(copies.contains(&"web/embed".to_owned()), "{copies:?}");
        let html = page_html(&rest).expect("a page");
        assert!(html.contains("<base href=\"./\">"));
        assert_eq!(html.matches("import init from \"./meshwright-web.js\"").count(), 1);
        assert!(!html.contains("data-trunk") && !html.contains("rel=\"rust\""));
        assert!(
            html.contains("content=\"./meshwright-worker_loader.js\""),
            "the page starts the worker by it"
        );
    }

    #[test]
    fn a_directive_that_is_not_known_is_an_error() {
        let index = take_copies(INDEX).0;
        let more = index.replace("</head>", "<link data-trunk rel=\"css\" href=\"a.css\"></head>");
        assert!(page_html(&more).is_err());
        assert!(page_html(&index.replace("data-trunk-public-url", "")).is_err());
    }
}
