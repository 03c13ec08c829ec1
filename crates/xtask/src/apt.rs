//! Installing Debian packages.

use std::process::Command;

use crate::error::Error;
use crate::machine::Machine;
use crate::packages::Package;

/// Installs the packages with apt, through sudo when we are not root.
///
/// # Errors
/// When there is no sudo, when apt cannot be started, and when it fails.
pub fn install(missing: &[&Package], machine: &Machine) -> Result<(), Error> {
    let names: Vec<&str> = missing.iter().map(|package| package.name).collect();
    let by_hand = format!("apt-get install {}", names.join(" "));
    if !machine.is_root && !machine.programs.contains("sudo") {
        return Err(Error::NotRoot { command: by_hand });
    }
    eprintln!(
        "Installing them with apt-get{}.",
        if machine.is_root {
            ""
        } else {
            ", through sudo"
        }
    );
    // A list that cannot be refreshed (one dead mirror is enough) is often still
    // good: what decides is whether the packages can be had.
    if !apt(machine, &["update", "-q"])? {
        eprintln!("xtask: apt-get could not refresh its lists; trying with those it has");
    }
    let arguments: Vec<&str> = ["install", "-q", "--yes", "--no-install-recommends"]
        .into_iter()
        .chain(names)
        .collect();
    if apt(machine, &arguments)? {
        Ok(())
    } else {
        Err(Error::Install { command: by_hand })
    }
}

/// Runs apt-get; true when it succeeded.
fn apt(machine: &Machine, arguments: &[&str]) -> Result<bool, Error> {
    let status = apt_command(machine, arguments)
        .status()
        .map_err(|source| Error::Start {
            program: "apt-get".into(),
            source,
        })?;
    Ok(status.success())
}

/// apt-get as root, without questions.
fn apt_command(machine: &Machine, arguments: &[&str]) -> Command {
    let mut command = if machine.is_root {
        Command::new("env")
    } else {
        let mut sudo = Command::new("sudo");
        sudo.arg("env");
        sudo
    };
    command
        .args(["DEBIAN_FRONTEND=noninteractive", "apt-get"])
        .args(arguments)
        // apt's talk goes to stderr: stdout belongs to the game and to the tests.
        .stdout(std::io::stderr());
    command
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;
    use crate::packages::{Purpose, missing};

    #[test]
    fn without_root_and_sudo_it_says_what_to_run() {
        let machine = Machine::default();
        let error = install(&missing(Purpose::Test, &machine), &machine).unwrap_err();
        assert!(matches!(error, Error::NotRoot { .. }));
        assert!(
            error
                .to_string()
                .contains("apt-get install pkg-config libasound2-dev libudev-dev libvulkan1")
        );
    }

    #[test]
    fn sudo_comes_first_only_when_we_are_not_root() {
        let user = apt_command(&Machine::default(), &["update"]);
        assert_eq!(user.get_program(), "sudo");
        let root = apt_command(
            &Machine {
                is_root: true,
                ..Machine::default()
            },
            &["update"],
        );
        assert_eq!(root.get_program(), "env");
        assert_eq!(root.get_args().last().unwrap(), "update");
    }
}
