//! A window manager for the display of the window tests: without one nothing is ever minimised, maximised or filled.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::error::Error;

/// Windows without frames, at the screen's corner, so that a window as large as the screen is seen whole.
const SETTINGS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<openbox_config xmlns="http://openbox.org/3.4/rc">
  <applications>
    <application class="*"><decor>no</decor><focus>yes</focus><position force="no"><x>0</x><y>0</y></position></application>
  </applications>
</openbox_config>
"#;

/// The manager of one display, stopped when this is dropped.
#[derive(Debug)]
pub struct Openbox {
    manager: Child,
}

impl Openbox {
    const START_LIMIT: Duration = Duration::from_secs(30);

    /// Starts openbox on a display and waits until it manages it. Its settings and what it has to say go to `folder`.
    ///
    /// # Errors
    /// When its files cannot be written, or it is not installed or does not come up.
    pub fn start(display: &str, folder: &Path) -> Result<Self, Error> {
        let settings = folder.join("openbox.xml");
        let scratch = |path: &Path, source| Error::Scratch {
            path: path.into(),
            source,
        };
        fs::write(&settings, SETTINGS).map_err(|source| scratch(&settings, source))?;
        let log = folder.join("openbox.log");
        let words = File::create(&log).map_err(|source| scratch(&log, source))?;
        let manager = Command::new("openbox")
            .arg("--sm-disable")
            .arg("--config-file")
            .arg(&settings)
            .env("DISPLAY", display)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(words)
            .spawn()
            .map_err(|source| Error::Start {
                program: "openbox".into(),
                source,
            })?;
        let mut openbox = Self { manager };
        let began = Instant::now();
        while !manages(display) {
            let ended = openbox
                .manager
                .try_wait()
                .is_ok_and(|status| status.is_some());
            if ended || began.elapsed() > Self::START_LIMIT {
                return Err(Error::NoWindowManager(log));
            }
            thread::sleep(Duration::from_millis(50));
        }
        Ok(openbox)
    }
}

impl Drop for Openbox {
    fn drop(&mut self) {
        // It may have ended with its display; then there is nothing to stop.
        let _ = self.manager.kill();
        let _ = self.manager.wait();
    }
}

/// A manager names a window of its own on the root window (Extended Window Manager Hints, `_NET_SUPPORTING_WM_CHECK`).
fn manages(display: &str) -> bool {
    let asked = Command::new("xprop")
        .args(["-root", "_NET_SUPPORTING_WM_CHECK"])
        .env("DISPLAY", display)
        .output();
    asked.is_ok_and(|answer| String::from_utf8_lossy(&answer.stdout).contains("window id"))
}
