//! Debian packages, on machines that have them.

use std::process::Command;

use crate::shell::{self, Result, find, step};

/// Whether packages can be installed without asking for a password.
pub fn available() -> bool {
    find("apt-get").is_some() && prefix().is_some()
}

/// Installs the packages that are missing.
pub fn install(packages: &[&str]) -> Result {
    let missing: Vec<&str> = packages.iter().copied().filter(|package| !installed(package)).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let Some(prefix) = prefix() else {
        return Err(format!(
            "installing packages takes root: run `sudo apt-get install {}`.",
            missing.join(" ")
        ));
    };
    step(format!("installing Debian packages: {}", missing.join(" ")));
    let apt = |args: &[&str]| {
        let mut words = prefix.iter().copied().chain(["apt-get", "-qq"]).chain(args.iter().copied());
        let mut command = Command::new(words.next().unwrap_or("apt-get"));
        command.args(words).env("DEBIAN_FRONTEND", "noninteractive");
        command
    };
    shell::run(&mut apt(&["update"]))?;
    let install = ["install", "-y", "--no-install-recommends"];
    shell::run(&mut apt(&[&install, missing.as_slice()].concat()))
}

fn installed(package: &str) -> bool {
    shell::capture(Command::new("dpkg-query").args(["-W", "-f=${Status}", package]))
        .is_some_and(|status| status == "install ok installed")
}

/// The words that run a command as root; `None` where that takes a password.
pub fn prefix() -> Option<&'static [&'static str]> {
    if shell::capture(Command::new("id").arg("-u"))? == "0" {
        return Some(&[]);
    }
    shell::capture(Command::new("sudo").args(["-n", "true"])).map(|_| ["sudo", "-n"].as_slice())
}
