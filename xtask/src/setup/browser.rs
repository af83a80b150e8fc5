//! A Chromium and its driver, for tests that run in a browser.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::apt;
use crate::project::Project;
use crate::shell::{self, Result, find, step};

/// The npm package that fetches browsers where there are no Debian packages.
const FETCHER: &str = "@puppeteer/browsers@2.10.0";

const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
const MACOS: &str = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";

/// A browser that tests can drive.
pub struct Browser {
    pub path: PathBuf,
    /// Its major version.
    major: String,
}

impl Browser {
    fn at(path: PathBuf) -> Option<Self> {
        let major = major_version(&path)?;
        Some(Self { path, major })
    }
}

/// Finds a browser, or installs one.
pub fn ensure(project: &Project) -> Result<Browser> {
    if let Some(browser) = find_browser(project) {
        step(format!("browser: {} is there", browser.path.display()));
        return Ok(browser);
    }
    if apt::available() {
        apt::install(&["chromium", "chromium-driver"])?;
    } else {
        fetch(project, "chrome@stable");
    }
    find_browser(project).ok_or_else(|| {
        "a Chromium or Chrome is missing: install one, or name it in the variable CHROMIUM.".to_owned()
    })
}

/// Finds the browser's driver, or installs it.
pub fn ensure_driver(project: &Project, browser: &Browser) -> Result<PathBuf> {
    if let Some(path) = find_driver(project, browser) {
        step(format!("browser driver: {} is there", path.display()));
        return Ok(path);
    }
    if apt::available() && browser.path.starts_with("/usr/bin") {
        apt::install(&["chromium-driver"])?;
    } else {
        fetch(project, &format!("chromedriver@{}", browser.major));
    }
    find_driver(project, browser).ok_or_else(|| {
        format!(
            "a ChromeDriver {} is missing, the version of {}: install it, or name it in the variable CHROMEDRIVER.",
            browser.major,
            browser.path.display()
        )
    })
}

/// Installs a Vulkan driver where there is none, for tests that draw without a browser.
pub fn ensure_native_graphics() {
    if env::consts::OS != "linux" || has_vulkan_driver() {
        return;
    }
    if !apt::available() || apt::install(&["mesa-vulkan-drivers"]).is_err() {
        step(
            "no Vulkan driver: native tests that draw will fail; install your system's `mesa-vulkan-drivers`",
        );
    }
}

fn has_vulkan_driver() -> bool {
    ["/usr/share/vulkan/icd.d", "/etc/vulkan/icd.d"]
        .iter()
        .any(|folder| !shell::entries(Path::new(folder)).is_empty())
}

fn find_browser(project: &Project) -> Option<Browser> {
    let named = env::var_os("CHROMIUM").map(PathBuf::from);
    let usual = NAMES.iter().filter_map(|name| find(name)).chain([PathBuf::from(MACOS)]);
    named.into_iter().chain(usual).chain(fetched(project, "chrome")).find_map(Browser::at)
}

fn find_driver(project: &Project, browser: &Browser) -> Option<PathBuf> {
    let named = env::var_os("CHROMEDRIVER").map(PathBuf::from);
    let candidates = named.into_iter().chain(find("chromedriver")).chain(fetched(project, "chromedriver"));
    candidates.into_iter().find(|path| major_version(path).as_ref() == Some(&browser.major))
}

/// `156` from `Chromium 156.0.8078.79 built on Debian`.
fn major_version(path: &Path) -> Option<String> {
    if !path.is_file() {
        return None;
    }
    let text = shell::capture(Command::new(path).arg("--version"))?;
    let version = text.split_whitespace().find(|word| word.starts_with(|c: char| c.is_ascii_digit()))?;
    version.split('.').next().map(str::to_owned)
}

/// Tries to fetch a browser or driver into the tools folder. The caller checks whether it is there.
fn fetch(project: &Project, what: &str) {
    step(format!("browser: fetching {what}"));
    let npx = if cfg!(windows) { "npx.cmd" } else { "npx" };
    let mut command = Command::new(npx);
    command.args(["--yes", FETCHER, "install", what, "--path"]).arg(browsers(project));
    if let Err(message) = shell::run(&mut command) {
        step(message);
    }
}

fn browsers(project: &Project) -> PathBuf {
    project.tools.join("browsers")
}

/// The fetched programs of a name: `browsers/chrome/linux-156.0.1/chrome-linux64/chrome`.
fn fetched(project: &Project, name: &str) -> Vec<PathBuf> {
    let file = format!("{name}{}", env::consts::EXE_SUFFIX);
    let builds = shell::entries(&browsers(project).join(name));
    let folders = builds.iter().rev().flat_map(|build| shell::entries(build));
    folders.map(|folder| folder.join(&file)).filter(|path| path.is_file()).collect()
}
