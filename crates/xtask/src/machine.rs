//! Finds what this machine has: shared libraries, programs, Vulkan drivers, packages.
//!
//! Everything is read once into plain data, so that deciding what is missing
//! is a pure function that tests can call with a machine of their own.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A snapshot of what is installed.
#[derive(Debug, Clone, Default)]
pub struct Machine {
    /// File names of the shared libraries that the loader knows.
    pub libraries: BTreeSet<String>,
    /// Names of the programs on the PATH.
    pub programs: BTreeSet<String>,
    /// File names of the Vulkan driver manifests.
    pub vulkan_manifests: BTreeSet<String>,
    /// Device nodes of graphics cards, such as `renderD128` and `nvidiactl`.
    pub graphics_devices: BTreeSet<String>,
    /// Installed Debian packages.
    pub debian_packages: BTreeSet<String>,
    /// `ID` and `ID_LIKE` of the system, in lower case.
    pub families: BTreeSet<String>,
    /// Whether we may install without asking sudo.
    pub is_root: bool,
}

impl Machine {
    /// Reads this machine. Whatever cannot be read counts as absent.
    pub fn look() -> Self {
        Self {
            libraries: libraries(),
            programs: programs(),
            vulkan_manifests: vulkan_manifests(),
            graphics_devices: graphics_devices(),
            debian_packages: installed_packages(&output(
                "dpkg-query",
                &["-W", "-f=${db:Status-Abbrev} ${Package}\n"],
            )),
            families: families(&fs::read_to_string("/etc/os-release").unwrap_or_default()),
            is_root: output("id", &["-u"]).trim() == "0",
        }
    }

    /// Whether `apt-get` installs packages here: Debian, Ubuntu and their kin.
    pub fn uses_apt(&self) -> bool {
        self.programs.contains("apt-get")
            && ["debian", "ubuntu"]
                .iter()
                .any(|family| self.families.contains(*family))
    }

    /// Whether some Vulkan driver will find something to draw with.
    ///
    /// A manifest alone proves nothing: NVIDIA's container images carry one
    /// without a card, and Mesa's Intel and Radeon drivers stand on machines
    /// without either. Only lavapipe needs no device.
    pub fn has_vulkan_driver(&self) -> bool {
        let device = |wanted: &str| {
            self.graphics_devices
                .iter()
                .any(|name| name.starts_with(wanted))
        };
        self.vulkan_manifests.iter().any(|manifest| {
            if manifest.starts_with("lvp_") {
                true
            } else if manifest.starts_with("nvidia") {
                device("nvidia") || device("dxg")
            } else if manifest.starts_with("dzn") {
                device("dxg")
            } else {
                device("renderD")
            }
        })
    }
}

/// Standard output of a program, or nothing when it is not there.
fn output(program: &str, arguments: &[&str]) -> String {
    Command::new(program)
        .args(arguments)
        .output()
        .map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
        .unwrap_or_default()
}

fn libraries() -> BTreeSet<String> {
    // ldconfig lives in /sbin, which an ordinary user's PATH lacks on Debian.
    let cache = ["ldconfig", "/sbin/ldconfig", "/usr/sbin/ldconfig"]
        .iter()
        .map(|program| output(program, &["-p"]))
        .find(|text| !text.is_empty())
        .unwrap_or_default();
    let mut found = cached_libraries(&cache);
    if found.is_empty() {
        for directory in ["/lib", "/usr/lib", "/lib64", "/usr/lib64", "/usr/local/lib"] {
            found.extend(entries(Path::new(directory)));
        }
    }
    found
}

/// The first column of `ldconfig -p`, without its heading.
fn cached_libraries(text: &str) -> BTreeSet<String> {
    text.lines()
        .filter(|line| line.contains("=>"))
        .filter_map(|line| line.split_whitespace().next())
        .map(str::to_owned)
        .collect()
}

fn programs() -> BTreeSet<String> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path)
        .flat_map(|directory| entries(&directory))
        .collect()
}

/// The loader's own search: an explicit list, else the standard places.
fn vulkan_manifests() -> BTreeSet<String> {
    for variable in ["VK_DRIVER_FILES", "VK_ICD_FILENAMES"] {
        if let Some(files) = std::env::var_os(variable) {
            return std::env::split_paths(&files)
                .filter(|file| file.exists())
                .filter_map(|file| file.file_name().map(lossy))
                .collect();
        }
    }
    let mut places: Vec<PathBuf> = ["/etc", "/usr/share", "/usr/local/share", "/usr/local/etc"]
        .iter()
        .map(PathBuf::from)
        .collect();
    if let Some(home) = std::env::var_os("HOME") {
        places.push(Path::new(&home).join(".local/share"));
    }
    if let Some(data) = std::env::var_os("XDG_DATA_DIRS") {
        places.extend(std::env::split_paths(&data));
    }
    places
        .iter()
        .flat_map(|place| entries(&place.join("vulkan/icd.d")))
        .filter(|name| {
            Path::new(name)
                .extension()
                .is_some_and(|extension| extension == "json")
        })
        .collect()
}

fn graphics_devices() -> BTreeSet<String> {
    let mut devices = entries(Path::new("/dev/dri"));
    devices.extend(
        entries(Path::new("/dev"))
            .into_iter()
            .filter(|name| name.starts_with("nvidia") || name == "dxg"),
    );
    devices
}

fn entries(directory: &Path) -> BTreeSet<String> {
    fs::read_dir(directory)
        .map(|entries| {
            entries
                .flatten()
                .map(|entry| lossy(entry.file_name()))
                .collect()
        })
        .unwrap_or_default()
}

fn lossy(name: impl Into<OsString>) -> String {
    name.into().to_string_lossy().into_owned()
}

/// Packages that are installed and configured (`ii`), of dpkg's whole list.
fn installed_packages(text: &str) -> BTreeSet<String> {
    text.lines()
        .filter_map(|line| line.split_once(' '))
        .filter(|(status, _)| status.starts_with("ii"))
        .map(|(_, name)| name.trim().to_owned())
        .collect()
}

/// `ID` and `ID_LIKE` of an os-release file.
fn families(os_release: &str) -> BTreeSet<String> {
    os_release
        .lines()
        .filter_map(|line| line.split_once('='))
        .filter(|(key, _)| *key == "ID" || *key == "ID_LIKE")
        .flat_map(|(_, value)| value.trim_matches(['"', '\'']).split_whitespace())
        .map(str::to_lowercase)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(names: &[&str]) -> BTreeSet<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    fn machine(manifests: &[&str], devices: &[&str]) -> Machine {
        Machine {
            vulkan_manifests: set(manifests),
            graphics_devices: set(devices),
            ..Machine::default()
        }
    }

    #[test]
    fn the_library_cache_is_read_without_its_heading() {
        let text = "123 libs found in cache `/etc/ld.so.cache'\n\
                    \tlibvulkan.so.1 (libc6,x86-64) => /lib/x86_64-linux-gnu/libvulkan.so.1\n\
                    \tlibXi.so.6 (libc6,x86-64) => /lib/x86_64-linux-gnu/libXi.so.6\n";
        assert_eq!(
            cached_libraries(text),
            set(&["libvulkan.so.1", "libXi.so.6"])
        );
    }

    #[test]
    fn only_configured_packages_count_as_installed() {
        let text = "ii  xvfb\nrc  xdotool\nun  openbox\nii  libx11-6\n";
        assert_eq!(installed_packages(text), set(&["xvfb", "libx11-6"]));
    }

    #[test]
    fn derivatives_of_ubuntu_use_apt() {
        let mint = families("NAME=\"Linux Mint\"\nID=linuxmint\nID_LIKE=\"ubuntu debian\"\n");
        assert_eq!(mint, set(&["linuxmint", "ubuntu", "debian"]));
        let apt = Machine {
            families: mint,
            programs: set(&["apt-get"]),
            ..Machine::default()
        };
        assert!(apt.uses_apt());
        let fedora = Machine {
            families: families("ID=fedora\n"),
            ..apt
        };
        assert!(!fedora.uses_apt());
    }

    #[test]
    fn a_manifest_without_its_card_is_no_driver() {
        assert!(!machine(&[], &["renderD128"]).has_vulkan_driver());
        assert!(!machine(&["nvidia_icd.json"], &["renderD128"]).has_vulkan_driver());
        assert!(!machine(&["intel_icd.x86_64.json"], &["card0"]).has_vulkan_driver());
        assert!(machine(&["nvidia_icd.json"], &["nvidiactl"]).has_vulkan_driver());
        assert!(machine(&["radeon_icd.x86_64.json"], &["renderD128"]).has_vulkan_driver());
    }

    #[test]
    fn lavapipe_needs_no_card() {
        assert!(machine(&["lvp_icd.x86_64.json"], &[]).has_vulkan_driver());
    }
}
