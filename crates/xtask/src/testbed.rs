//! The surroundings of the tests.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::display::Xvfb;
use crate::error::Error;
use crate::openbox::Openbox;

/// What surrounds the tests: empty places for settings and worlds, a display of
/// their own, and none of the player's. Removed when dropped.
pub struct TestBed {
    scratch: PathBuf,
    // Stopped before the display that it manages.
    manager: Option<Openbox>,
    display: Option<Xvfb>,
}

impl TestBed {
    /// Makes the places and starts the display.
    ///
    /// # Errors
    /// When a directory cannot be made, or Xvfb is there and gives no display.
    pub fn make() -> Result<Self, Error> {
        let scratch = std::env::temp_dir().join(format!("antipode-tests-{}", std::process::id()));
        let bed = Self {
            scratch,
            manager: None,
            display: None,
        };
        let saves = bed.saves();
        fs::create_dir_all(&saves).map_err(|source| Error::Scratch {
            path: saves,
            source,
        })?;
        bed.with_display()
    }

    fn with_display(mut self) -> Result<Self, Error> {
        if !cfg!(target_os = "linux") {
            return Ok(self);
        }
        match Xvfb::start(&self.scratch.join("xvfb.log")) {
            Ok(display) => self.display = Some(display),
            Err(Error::Start { .. }) => {
                eprintln!("xtask: Xvfb is not here, so the window tests have no display");
            }
            Err(other) => return Err(other),
        }
        if let Some(display) = &self.display {
            match Openbox::start(&display.name, &self.scratch) {
                Ok(manager) => self.manager = Some(manager),
                Err(Error::Start { .. }) => {
                    eprintln!(
                        "xtask: openbox is not here, so the window tests have no window manager"
                    );
                }
                Err(other) => return Err(other),
            }
        }
        Ok(self)
    }

    fn saves(&self) -> PathBuf {
        self.scratch.join("saves")
    }

    /// Gives a command these surroundings.
    pub fn surround<'a>(&self, command: &'a mut Command) -> &'a mut Command {
        command
            .env("ANTIPODE_REQUIRE_GPU", "1")
            .env("ANTIPODE_SAVES", self.saves())
            .env("ANTIPODE_CONFIG", self.scratch.join("config"))
            .env_remove("ANTIPODE_TEST_DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("DISPLAY");
        if let Some(display) = &self.display {
            command.env("ANTIPODE_TEST_DISPLAY", &display.name);
        }
        command
    }
}

impl Drop for TestBed {
    fn drop(&mut self) {
        // What cannot be removed is a few kilobytes in the temporary directory.
        let _ = fs::remove_dir_all(&self.scratch);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ffi::OsStr;

    #[test]
    fn tests_see_neither_the_players_worlds_nor_the_players_screen() {
        let bed = TestBed {
            scratch: PathBuf::from("/nowhere/antipode"),
            manager: None,
            display: None,
        };
        let mut command = Command::new("true");
        bed.surround(&mut command);
        let variables: Vec<_> = command.get_envs().collect();
        assert!(variables.contains(&(OsStr::new("DISPLAY"), None)));
        assert!(variables.contains(&(OsStr::new("WAYLAND_DISPLAY"), None)));
        assert!(variables.contains(&(
            OsStr::new("ANTIPODE_SAVES"),
            Some(OsStr::new("/nowhere/antipode/saves"))
        )));
    }
}
