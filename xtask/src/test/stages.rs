//! The stages of `cargo xtask test`.

use std::path::PathBuf;
use std::process::Command;

use super::count::Count;
use crate::measures;
use crate::page;
use crate::project::Project;
use crate::setup::{self, Browser, WasmToolchain, browser, npm};
use crate::shell::{self, Result};

/// The newest compiler whose lints this code is kept clean of. A newer one's warnings fail nothing.
const LINTS_OF: u32 = 96;

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    Fmt,
    Measures,
    Clippy,
    Native,
    Wasm,
    E2e,
}

/// What the stages take.
pub struct Tools {
    wasm: Option<WasmToolchain>,
    browser: Option<Browser>,
    driver: Option<PathBuf>,
}

impl Tools {
    /// Installs what is missing for these stages.
    pub fn ensure(project: &Project, stages: &[Stage]) -> Result<Self> {
        let any = |of: &[Stage]| stages.iter().any(|stage| of.contains(stage));
        if any(&[Stage::Fmt, Stage::Clippy]) {
            setup::for_linting()?;
        }
        if any(&[Stage::Native]) {
            browser::ensure_native_graphics();
        }
        let wasm = match any(&[Stage::Clippy, Stage::Wasm, Stage::E2e]) {
            true => Some(setup::for_building(project)?),
            false => None,
        };
        let browser = match any(&[Stage::Wasm, Stage::E2e]) {
            true => Some(browser::ensure(project)?),
            false => None,
        };
        let driver = match &browser {
            Some(browser) if any(&[Stage::Wasm]) => Some(browser::ensure_driver(project, browser)?),
            _ => None,
        };
        if any(&[Stage::E2e]) {
            npm::ensure(project)?;
        }
        Ok(Self { wasm, browser, driver })
    }
}

impl Stage {
    pub const ALL: [Self; 6] = [Self::Fmt, Self::Measures, Self::Clippy, Self::Native, Self::Wasm, Self::E2e];

    pub fn name(self) -> &'static str {
        match self {
            Self::Fmt => "fmt",
            Self::Measures => "measures",
            Self::Clippy => "clippy",
            Self::Native => "native",
            Self::Wasm => "wasm",
            Self::E2e => "e2e",
        }
    }

    pub fn named(name: &str) -> Result<Self> {
        Self::ALL.into_iter().find(|stage| stage.name() == name).ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("there is no stage `{name}`; the stages are {names}.")
        })
    }

    pub fn run(self, project: &Project, tools: &Tools, rest: &[String]) -> (Count, Result) {
        let mut count = Count::default();
        let result = match self {
            Self::Fmt => fmt(project, rest),
            Self::Measures => measures::run(project),
            Self::Clippy => clippy(project, tools, rest),
            Self::Native => native(project, rest, &mut count),
            Self::Wasm => wasm(project, tools, rest, &mut count),
            Self::E2e => e2e(project, tools, rest, &mut count),
        };
        if matches!(self, Self::Fmt | Self::Measures | Self::Clippy) {
            count = Count::check(result.is_ok());
        }
        (count, result)
    }
}

fn fmt(project: &Project, rest: &[String]) -> Result {
    shell::run(cargo(project).args(["fmt", "--all", "--check"]).args(rest))
        .map_err(|_| "the formatting differs; `cargo fmt --all` puts it right.".to_owned())
}

fn clippy(project: &Project, tools: &Tools, rest: &[String]) -> Result {
    let mut native = cargo(project);
    native.args(["clippy", "--workspace", "--all-targets"]).args(rest);
    shell::run(deny_warnings(&mut native))?;
    // The page's own code exists on the page's target only.
    let mut page = cargo(project);
    page.args(["clippy", "--all-targets", "--target", setup::TARGET]).args(PAGE_PACKAGES).args(rest);
    shell::run(deny_warnings(tools.wasm()?.choose(&mut page)))
}

fn native(project: &Project, rest: &[String], count: &mut Count) -> Result {
    let mut test = cargo(project);
    test.args(["test", "--no-fail-fast"]);
    if !rest.iter().any(|arg| matches!(arg.as_str(), "-p" | "--package")) {
        test.arg("--workspace");
    }
    counted(test.args(rest), count)?;
    if rest.is_empty() { many_edits(project, count) } else { Ok(()) }
}

/// The random sequences of edits, as many as only optimised code gets through in a minute or two.
fn many_edits(project: &Project, count: &mut Count) -> Result {
    let mut test = cargo(project);
    test.args([
        "test",
        "--release",
        "-p",
        "halfedge",
        "--test",
        "edits",
        "random_sequences",
        "--",
        "--nocapture",
    ]);
    counted(test.env("MESHWRIGHT_EDITS", "1000000"), count)
}

fn wasm(project: &Project, tools: &Tools, rest: &[String], count: &mut Count) -> Result {
    let driver = tools.driver.as_ref().ok_or("the browser's driver was not set up.")?;
    let capabilities = project.tools.join("webdriver.json");
    shell::write(&capabilities, &webdriver_json(tools.browser()?))?;
    let mut test = cargo(project);
    test.args([
        "test",
        "--no-fail-fast",
        "--target",
        setup::TARGET,
        "-p",
        "meshwright-web",
        "--lib",
        "--test",
        "*",
    ]);
    test.args(rest);
    test.env("PATH", project.path()?)
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", "wasm-bindgen-test-runner")
        .env("CHROMEDRIVER", driver)
        .env("WASM_BINDGEN_TEST_WEBDRIVER_JSON", capabilities)
        .env("WASM_BINDGEN_TEST_TIMEOUT", "300");
    counted(tools.wasm()?.choose(&mut test), count)
}

fn e2e(project: &Project, tools: &Tools, rest: &[String], count: &mut Count) -> Result {
    let site = project.site("test");
    page::build(project, tools.wasm()?, &site)?;
    let folder = project.root.join("tests");
    let files = shell::entries(&folder).into_iter().filter(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.ends_with(".test.mjs")
            && (rest.is_empty() || rest.iter().any(|part| name.contains(part.as_str())))
    });
    let files: Vec<_> = files.collect();
    if files.is_empty() {
        return Err(format!("no file of tests/*.test.mjs has `{}` in its name.", rest.join("` or `")));
    }
    let mut node = Command::new("node");
    node.args(["--test", "--test-reporter=spec", "--test-timeout=900000"]).args(files).current_dir(&folder);
    node.env("MESHWRIGHT_TOOLS", &project.tools)
        .env("MESHWRIGHT_SITE", site)
        .env("MESHWRIGHT_SHOTS", project.target.join("screenshots"))
        .env("MESHWRIGHT_CHROMIUM", &tools.browser()?.path)
        .env("NO_COLOR", "1")
        .env_remove("FORCE_COLOR");
    counted(&mut node, count)
}

const PAGE_PACKAGES: [&str; 4] = ["-p", "meshwright-web", "-p", "meshwright-worker"];

fn cargo(project: &Project) -> Command {
    let mut cargo = shell::cargo();
    cargo.current_dir(&project.root);
    cargo
}

/// Runs tests and adds up what they print.
fn counted(command: &mut Command, count: &mut Count) -> Result {
    match shell::run_reading(command, |line| count.read(line))? {
        true => Ok(()),
        false => Err("its output is above.".to_owned()),
    }
}

/// Makes warnings errors, unless the command's compiler has lints that this code has never met.
fn deny_warnings(command: &mut Command) -> &mut Command {
    let mut rustc = Command::new("rustc");
    rustc.arg("--version").envs(command.get_envs().filter_map(|(name, value)| Some((name, value?))));
    let version = shell::capture(&mut rustc).unwrap_or_default();
    let minor = version.split('.').nth(1).and_then(|minor| minor.parse::<u32>().ok());
    match minor {
        Some(minor) if minor > LINTS_OF => {
            shell::step(format!(
                "{version} is newer than 1.{LINTS_OF}: its warnings are shown and fail nothing"
            ));
            command
        }
        _ => command.args(["--", "-D", "warnings"]),
    }
}

fn webdriver_json(browser: &Browser) -> String {
    let path = browser.path.to_string_lossy().replace('\\', "\\\\").replace('"', "\\\"");
    format!(
        "{{\"goog:chromeOptions\": {{\"binary\": \"{path}\", \"args\": \
         [\"--headless\", \"--no-sandbox\", \"--disable-gpu\", \"--disable-dev-shm-usage\"]}}}}\n"
    )
}

impl Tools {
    fn wasm(&self) -> Result<&WasmToolchain> {
        self.wasm.as_ref().ok_or_else(|| "the wasm toolchain was not set up.".to_owned())
    }

    fn browser(&self) -> Result<&Browser> {
        self.browser.as_ref().ok_or_else(|| "the browser was not set up.".to_owned())
    }
}
