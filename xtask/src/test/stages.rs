//! The stages of `cargo xtask test`.

use std::env::consts::EXE_SUFFIX;
use std::path::PathBuf;
use std::process::Command;

use super::count::Count;
use crate::measures;
use crate::project::Project;
use crate::setup::{self, Browser, WasmToolchain, browser, npm};
use crate::shell::{self, Result};
use crate::site;

/// The minor version of the newest compiler whose lints this code passes. Warnings of newer ones don't fail a stage.
const NEWEST_LINTED_RUSTC_MINOR: u32 = 96;

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    Fmt,
    Measures,
    Clippy,
    Native,
    Wasm,
    E2e,
}

/// The tools that stages need.
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
        let wasm = if any(&[Stage::Wasm, Stage::E2e]) {
            Some(setup::for_building(project)?)
        } else if any(&[Stage::Clippy]) {
            Some(setup::for_compiling(project)?)
        } else {
            None
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
        .map_err(|_| "the code is not formatted; run `cargo fmt --all`.".to_owned())
}

fn clippy(project: &Project, tools: &Tools, rest: &[String]) -> Result {
    for mut command in [clippy_native(project), clippy_page(project, tools.wasm()?)] {
        shell::run(deny_warnings(command.args(rest)))?;
    }
    Ok(())
}

fn clippy_native(project: &Project) -> Command {
    let mut clippy = cargo(project);
    clippy.args(["clippy", "--workspace", "--all-targets"]);
    clippy
}

/// The page's own code exists on the page's target only.
fn clippy_page(project: &Project, wasm: &WasmToolchain) -> Command {
    let mut clippy = cargo(project);
    clippy.args(["clippy", "--all-targets", "--target", setup::TARGET]).args(site::PACKAGES);
    wasm.choose(&mut clippy);
    clippy
}

fn native(project: &Project, rest: &[String], count: &mut Count) -> Result {
    let mut test = cargo(project);
    test.args(["test", "--no-fail-fast"]);
    if !rest.iter().any(|arg| matches!(arg.as_str(), "-p" | "--package")) {
        test.arg("--workspace");
    }
    if rest.is_empty() {
        // The random sequences of edits, of which a test run by hand does fewer.
        test.env("MESHWRIGHT_EDITS", "1000000");
    }
    counted(test.args(rest), count)
}

fn wasm(project: &Project, tools: &Tools, rest: &[String], count: &mut Count) -> Result {
    let driver = tools.driver.as_ref().ok_or("the browser's driver was not set up.")?;
    let capabilities = project.tools.join("webdriver.json");
    shell::write(&capabilities, &webdriver_json(tools.browser()?))?;
    let mut test = test_in_browser(project, tools.wasm()?);
    test.args(rest);
    test.env("PATH", project.path()?)
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER", "wasm-bindgen-test-runner")
        .env("CHROMEDRIVER", driver)
        .env("WASM_BINDGEN_TEST_WEBDRIVER_JSON", capabilities)
        .env("WASM_BINDGEN_TEST_TIMEOUT", "300");
    counted(&mut test, count)
}

fn test_in_browser(project: &Project, wasm: &WasmToolchain) -> Command {
    let mut test = cargo(project);
    test.args(["test", "--no-fail-fast", "--target", setup::TARGET]);
    test.args(["-p", "meshwright-web", "--lib", "--test", "*"]);
    wasm.choose(&mut test);
    test
}

/// Builds the command line, whose files the page's are compared with.
fn command_line(project: &Project) -> Command {
    let mut build = cargo(project);
    build.args(["build", "-p", "meshwright"]);
    build
}

/// The Cargo runs of the stages, each with its name, as far as they compile.
pub fn builds(project: &Project, wasm: &WasmToolchain) -> [(&'static str, Command); 6] {
    let mut native = cargo(project);
    native.args(["test", "--workspace", "--no-run"]);
    let mut in_browser = test_in_browser(project, wasm);
    in_browser.arg("--no-run");
    [
        ("clippy", clippy_native(project)),
        ("clippy of the page", clippy_page(project, wasm)),
        ("native", native),
        ("wasm", in_browser),
        ("e2e", site::cargo_build(project, wasm, site::Kind::Quick)),
        ("e2e, command line", command_line(project)),
    ]
}

fn e2e(project: &Project, tools: &Tools, rest: &[String], count: &mut Count) -> Result {
    let folder = project.site("test");
    site::build(project, tools.wasm()?, site::Kind::Quick, &folder)?;
    shell::run(&mut command_line(project))?;
    let tests = project.root.join("tests");
    let files = shell::entries(&tests).into_iter().filter(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.ends_with(".test.mjs")
            && (rest.is_empty() || rest.iter().any(|part| name.contains(part.as_str())))
    });
    let files: Vec<_> = files.collect();
    if files.is_empty() {
        return Err(format!("no file among tests/*.test.mjs has `{}` in its name.", rest.join("` or `")));
    }
    let mut node = Command::new("node");
    node.arg("--test-reporter=spec").arg(tests.join("run.mjs")).args(files).current_dir(&tests);
    node.env("MESHWRIGHT_TOOLS", &project.tools)
        .env("MESHWRIGHT_SITE", folder)
        .env("MESHWRIGHT_CLI", project.target.join("debug").join(format!("meshwright{EXE_SUFFIX}")))
        .env("MESHWRIGHT_SHOTS", project.target.join("screenshots"))
        .env("MESHWRIGHT_CHROMIUM", &tools.browser()?.path)
        .env("NO_COLOR", "1")
        .env_remove("FORCE_COLOR");
    counted(&mut node, count)
}

fn cargo(project: &Project) -> Command {
    let mut cargo = shell::cargo();
    cargo.current_dir(&project.root);
    cargo
}

/// Runs tests and counts them.
fn counted(command: &mut Command, count: &mut Count) -> Result {
    match shell::run_reading(command, |line| count.read(line))? {
        true => Ok(()),
        false => Err("the output above says why.".to_owned()),
    }
}

/// Makes warnings errors, unless the compiler is newer than this code has been checked with.
fn deny_warnings(command: &mut Command) -> &mut Command {
    let mut rustc = Command::new("rustc");
    rustc.arg("--version").envs(command.get_envs().filter_map(|(name, value)| Some((name, value?))));
    let version = shell::capture(&mut rustc).unwrap_or_default();
    let minor = version.split('.').nth(1).and_then(|minor| minor.parse::<u32>().ok());
    match minor {
        Some(minor) if minor > NEWEST_LINTED_RUSTC_MINOR => {
            shell::step(format!(
                "{version} is newer than 1.{NEWEST_LINTED_RUSTC_MINOR}: its warnings are shown but do not fail the stage"
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
