//! Lists the system packages that the game and its tests need, and finds those that are missing.
//!
//! The game loads the libraries of graphics and windows at run time and builds
//! without any of them. Only the libraries of sound and gamepads must be there at build time. Where
//! they are missing, the game is built without sound or without gamepads.

use std::fmt::Write as _;

use crate::display::Session;
use crate::machine::Machine;

/// What shows that a package is there.
#[derive(Debug, Clone, Copy)]
enum Sign {
    /// A shared library by its file name.
    Library(&'static str),
    /// A program on the PATH.
    Program(&'static str),
    /// Any Vulkan driver that has something to draw with.
    VulkanDriver,
}

/// A Debian package and the reason for it.
#[derive(Debug)]
pub struct Package {
    /// Its name in Debian and Ubuntu.
    pub name: &'static str,
    sign: Sign,
    why: &'static str,
}

/// What the packages are for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Purpose {
    /// The game itself, on the display there is.
    Play(Session),
    /// Every test, the ones that click in a window included.
    Test,
}

const BUILD: [Package; 3] = [
    program(
        "pkg-config",
        "pkg-config",
        "finds the next two when the game is built",
    ),
    library("libasound2-dev", "libasound.so", "sound (feature `sound`)"),
    library("libudev-dev", "libudev.so", "gamepads (feature `gamepad`)"),
];

/// The features of the game that need a library when it is built, and its file.
const FEATURES: [(&str, &str); 2] = [("sound", "libasound.so"), ("gamepad", "libudev.so")];

const VULKAN: [Package; 2] = [
    library("libvulkan1", "libvulkan.so.1", "finds the graphics driver"),
    Package {
        name: "mesa-vulkan-drivers",
        sign: Sign::VulkanDriver,
        why: "graphics drivers, among them lavapipe, which draws without a graphics card",
    },
];

const X11: [Package; 7] = [
    library("libx11-6", "libX11.so.6", "opens a window on X11"),
    library("libx11-xcb1", "libX11-xcb.so.1", "opens a window on X11"),
    library("libxcursor1", "libXcursor.so.1", "the pointer on X11"),
    library("libxi6", "libXi.so.6", "raw mouse motion on X11"),
    library(
        "libxrender1",
        "libXrender.so.1",
        "the pointer's picture on X11",
    ),
    library("libxfixes3", "libXfixes.so.3", "hides the pointer on X11"),
    library(
        "libxkbcommon-x11-0",
        "libxkbcommon-x11.so.0",
        "the keyboard's layout on X11",
    ),
];

const WAYLAND: [Package; 2] = [
    library(
        "libwayland-client0",
        "libwayland-client.so.0",
        "opens a window on Wayland",
    ),
    library(
        "libxkbcommon0",
        "libxkbcommon.so.0",
        "the keyboard's layout on Wayland",
    ),
];

const TESTING: [Package; 4] = [
    program("xvfb", "Xvfb", "a display in memory for the window tests"),
    program(
        "openbox",
        "openbox",
        "manages the windows of the window tests",
    ),
    program(
        "xdotool",
        "xdotool",
        "presses keys and clicks in the window tests",
    ),
    program(
        "x11-utils",
        "xprop",
        "asks the window manager whether it is ready for the window tests",
    ),
];

const fn library(name: &'static str, file: &'static str, why: &'static str) -> Package {
    Package {
        name,
        sign: Sign::Library(file),
        why,
    }
}

const fn program(name: &'static str, command: &'static str, why: &'static str) -> Package {
    Package {
        name,
        sign: Sign::Program(command),
        why,
    }
}

fn needed(purpose: Purpose) -> Vec<&'static Package> {
    let (x11, wayland, testing) = match purpose {
        Purpose::Play(session) => (session.x11, session.wayland, false),
        Purpose::Test => (true, false, true),
    };
    let mut packages: Vec<_> = BUILD.iter().chain(&VULKAN).collect();
    packages.extend(X11.iter().filter(|_| x11));
    packages.extend(WAYLAND.iter().filter(|_| wayland));
    packages.extend(TESTING.iter().filter(|_| testing));
    packages
}

fn is_present(package: &Package, machine: &Machine) -> bool {
    match package.sign {
        Sign::Library(file) => {
            machine.libraries.contains(file) || machine.debian_packages.contains(package.name)
        }
        Sign::Program(command) => {
            machine.programs.contains(command) || machine.debian_packages.contains(package.name)
        }
        Sign::VulkanDriver => machine.has_vulkan_driver(),
    }
}

/// The packages that `purpose` needs and `machine` lacks.
pub fn missing(purpose: Purpose, machine: &Machine) -> Vec<&'static Package> {
    needed(purpose)
        .into_iter()
        .filter(|package| !is_present(package, machine))
        .collect()
}

/// The features that the game can be built with here, where that is not all of
/// them, and those it has to be built without.
pub fn reduced_features(machine: &Machine) -> Option<(Vec<&'static str>, Vec<&'static str>)> {
    let is_there = |file: &str| {
        let package = BUILD
            .iter()
            .find(|package| matches!(package.sign, Sign::Library(f) if f == file));
        package.is_some_and(|package| is_present(package, machine))
            && is_present(&BUILD[0], machine)
    };
    let (with, without): (Vec<_>, Vec<_>) = FEATURES.iter().partition(|(_, file)| is_there(file));
    let names = |features: Vec<&(&'static str, &str)>| {
        features.into_iter().map(|(name, _)| *name).collect()
    };
    (!without.is_empty()).then(|| (names(with), names(without)))
}

/// Says what is missing and why, one line for each package.
pub fn listing(missing: &[&Package], purpose: Purpose) -> String {
    let what = match purpose {
        Purpose::Play(_) => "the game",
        Purpose::Test => "the tests",
    };
    if missing.is_empty() {
        return format!("Every system package for {what} is here.\n");
    }
    let mut text = format!("Missing system packages for {what}:\n");
    for package in missing {
        line(&mut text, package, "");
    }
    text
}

/// Every package that anything here may need, and whether it is there.
pub fn inventory(machine: &Machine) -> String {
    let mut text = String::new();
    for (heading, packages) in [
        ("Building", BUILD.as_slice()),
        ("Graphics", VULKAN.as_slice()),
        ("A window on X11", X11.as_slice()),
        ("A window on Wayland", WAYLAND.as_slice()),
        ("Tests", TESTING.as_slice()),
    ] {
        let _ = writeln!(text, "{heading}:");
        for package in packages {
            let state = if is_present(package, machine) {
                "here     "
            } else {
                "missing  "
            };
            line(&mut text, package, state);
        }
    }
    text
}

fn line(text: &mut String, package: &Package, state: &str) {
    // Writing to a String cannot fail.
    let _ = match package.sign {
        Sign::Library(file) => {
            writeln!(
                text,
                "  {state}{:<20} {} ({file})",
                package.name, package.why
            )
        }
        Sign::Program(command) => {
            writeln!(
                text,
                "  {state}{:<20} {} ({command})",
                package.name, package.why
            )
        }
        Sign::VulkanDriver => writeln!(text, "  {state}{:<20} {}", package.name, package.why),
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    const HEADLESS: Session = Session {
        x11: false,
        wayland: false,
    };

    fn names(packages: &[&Package]) -> Vec<&'static str> {
        packages.iter().map(|package| package.name).collect()
    }

    fn set(names: &[&str]) -> BTreeSet<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    /// What a machine has on which the game was built.
    fn built() -> Machine {
        Machine {
            libraries: set(&["libasound.so", "libudev.so"]),
            programs: set(&["pkg-config"]),
            ..Machine::default()
        }
    }

    #[test]
    fn without_a_display_only_building_and_graphics_are_needed() {
        let bare = Machine::default();
        assert_eq!(
            names(&missing(Purpose::Play(HEADLESS), &bare)),
            [
                "pkg-config",
                "libasound2-dev",
                "libudev-dev",
                "libvulkan1",
                "mesa-vulkan-drivers"
            ]
        );
    }

    #[test]
    fn a_library_that_cannot_be_had_costs_its_own_feature_alone() {
        assert_eq!(reduced_features(&built()), None);
        let without_sound = Machine {
            libraries: set(&["libudev.so"]),
            ..built()
        };
        assert_eq!(
            reduced_features(&without_sound),
            Some((vec!["gamepad"], vec!["sound"]))
        );
        let bare = Machine::default();
        assert_eq!(
            reduced_features(&bare),
            Some((vec![], vec!["sound", "gamepad"]))
        );
    }

    #[test]
    fn every_feature_that_needs_a_library_is_one_of_the_game() {
        let manifest = include_str!("../../app/Cargo.toml");
        for (feature, _) in FEATURES {
            assert!(manifest.contains(&format!("\n{feature} = [")), "{feature}");
        }
    }

    #[test]
    fn each_display_server_brings_its_own_libraries() {
        let bare = Machine::default();
        let wayland = names(&missing(
            Purpose::Play(Session {
                wayland: true,
                ..HEADLESS
            }),
            &bare,
        ));
        assert!(wayland.contains(&"libwayland-client0") && !wayland.contains(&"libx11-6"));
        let x11 = names(&missing(
            Purpose::Play(Session {
                x11: true,
                ..HEADLESS
            }),
            &bare,
        ));
        assert!(x11.contains(&"libx11-6") && !x11.contains(&"libwayland-client0"));
    }

    #[test]
    fn testing_needs_the_window_tools_and_playing_does_not() {
        let bare = Machine::default();
        let test = names(&missing(Purpose::Test, &bare));
        let play = names(&missing(
            Purpose::Play(Session {
                x11: true,
                wayland: true,
            }),
            &bare,
        ));
        for tool in ["xvfb", "openbox", "xdotool", "x11-utils"] {
            assert!(test.contains(&tool) && !play.contains(&tool), "{tool}");
        }
    }

    #[test]
    fn a_library_counts_by_its_file_or_by_its_package() {
        let by_file = Machine {
            libraries: set(&["libvulkan.so.1", "libasound.so", "libudev.so"]),
            ..built()
        };
        let by_package = Machine {
            debian_packages: set(&["libvulkan1"]),
            ..built()
        };
        for machine in [by_file, by_package] {
            assert_eq!(
                names(&missing(Purpose::Play(HEADLESS), &machine)),
                ["mesa-vulkan-drivers"]
            );
        }
    }

    #[test]
    fn mesa_is_left_out_where_a_card_has_its_driver() {
        let machine = Machine {
            libraries: set(&["libvulkan.so.1", "libasound.so", "libudev.so"]),
            programs: set(&["pkg-config"]),
            vulkan_manifests: set(&["nvidia_icd.json"]),
            graphics_devices: set(&["nvidiactl"]),
            ..Machine::default()
        };
        assert!(missing(Purpose::Play(HEADLESS), &machine).is_empty());
    }

    #[test]
    fn the_listing_has_one_line_and_a_reason_for_each_package() {
        let packages = missing(Purpose::Test, &Machine::default());
        let text = listing(&packages, Purpose::Test);
        assert_eq!(text.lines().count(), packages.len() + 1);
        assert!(text.contains("Xvfb") && text.contains("a display in memory"));
        assert!(listing(&[], Purpose::Test).contains("is here"));
    }

    #[test]
    fn the_inventory_marks_what_is_there() {
        let text = inventory(&Machine {
            programs: set(&["xdotool"]),
            ..Machine::default()
        });
        assert_eq!(text.matches("here   ").count(), 1);
        assert!(text.contains("missing  xvfb"));
    }
}
