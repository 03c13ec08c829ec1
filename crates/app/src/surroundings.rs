//! Environment variables that the game sets so that the libraries below work and stay quiet.

use std::ffi::OsString;
use std::path::Path;

/// Leaves out the layer by which Mesa puts the session's graphics card first. The game orders adapters by itself.
const NO_DEVICE_SELECT: &str = "NODEVICE_SELECT";

/// Variables to set before anything else runs.
///
/// Mesa's layer asks Wayland for the session's card whenever Wayland could be drawn to, in a window of X11 and without
/// a window, too, and libwayland complains on standard error where it is told of no folder to look for Wayland in.
/// There is nothing to ask then, so the layer is left out, unless the player chooses a card through it.
pub fn amended(variable: impl Fn(&str) -> Option<OsString>) -> Vec<(&'static str, &'static str)> {
    let set = |name| variable(name).filter(|value| !value.is_empty());
    let absolute = |name| set(name).is_some_and(|value| Path::new(&value).is_absolute());
    let reachable = absolute("XDG_RUNTIME_DIR")
        || absolute("WAYLAND_DISPLAY")
        || set("WAYLAND_SOCKET").is_some();
    let chosen = set("DRI_PRIME").is_some() || set("MESA_VK_DEVICE_SELECT").is_some();
    if cfg!(target_os = "linux") && !reachable && !chosen {
        vec![(NO_DEVICE_SELECT, "1")]
    } else {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn amends(variables: &[(&str, &str)]) -> bool {
        let found = amended(|name| {
            let found = variables.iter().find(|(one, _)| *one == name);
            found.map(|(_, value)| OsString::from(value))
        });
        !found.is_empty()
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn wayland_is_not_asked_for_where_it_cannot_be() {
        assert!(amends(&[]));
        assert!(amends(&[("WAYLAND_DISPLAY", "wayland-0")]));
        assert!(amends(&[("XDG_RUNTIME_DIR", ""), ("DISPLAY", ":0")]));
        assert!(!amends(&[("XDG_RUNTIME_DIR", "/run/user/1000")]));
        assert!(!amends(&[("WAYLAND_DISPLAY", "/run/wayland-0")]));
        assert!(
            !amends(&[("DRI_PRIME", "1")]),
            "whoever chooses a card gets it"
        );
    }
}
