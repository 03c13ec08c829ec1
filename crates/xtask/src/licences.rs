//! The notices of everything that is built into the game, as their licences ask for.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;
use crate::steps;

/// Files that hold a licence or a notice begin with one of these, in capitals or not.
const NOTICES: [&str; 5] = ["license", "licence", "copying", "notice", "copyright"];

/// A package that is built in.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Package {
    name: String,
    version: String,
    licence: String,
    repository: String,
}

/// Names, licences and notices of all packages of a tree of cargo's, and of fonts and other files that are not ours.
pub fn collect(tree: &str) -> String {
    let packages: Vec<_> = packages(tree);
    let mut text = String::from(
        "Antipode is built with the work of many others. These are the parts, and their terms.\n\n",
    );
    for package in &packages {
        let Package {
            name,
            version,
            licence,
            repository,
        } = package;
        text += &[name, " ", version, ": ", licence, ". ", repository, "\n"].concat();
    }
    text += "\nThe fonts are Noto Sans SC, under the SIL Open Font License, and those of egui.\n";
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for notice in ["assets/fonts/OFL.txt"] {
        if let Ok(text) = fs::read_to_string(steps::root().join(notice)) {
            texts.entry(text).or_default().push("Noto Sans SC".into());
        }
    }
    for package in &packages {
        for notice in folders(package).iter().flat_map(|folder| notices(folder)) {
            let of = format!("{} {}", package.name, package.version);
            let names = texts.entry(notice).or_default();
            if !names.contains(&of) {
                names.push(of);
            }
        }
    }
    for (notice, names) in &texts {
        let rule = "-".repeat(80);
        text += &[
            "\n",
            &rule,
            "\n",
            &names.join(", "),
            "\n\n",
            notice.trim(),
            "\n",
        ]
        .concat();
    }
    text
}

/// Where the list that the game shows stands in the checkout.
const COMPONENTS: &str = "assets/licences/components.txt";

/// Remakes the list of all packages that the game shows: a line each of name, version and licence.
///
/// # Errors
/// When cargo cannot tell what is built in, or the file cannot be written.
pub fn remake_list() -> Result<PathBuf, Error> {
    let path = steps::root().join(COMPONENTS);
    fs::write(&path, list(&steps::tree_of("antipode", &[])?)).map_err(|source| Error::Scratch {
        path: path.clone(),
        source,
    })?;
    Ok(path)
}

fn list(tree: &str) -> String {
    let line = |package: &Package| {
        format!(
            "{} {} · {}\n",
            package.name, package.version, package.licence
        )
    };
    packages(tree).iter().map(line).collect()
}

/// The packages that `cargo tree` lists, one a line as `name vX.Y.Z (...)|licence|repository`, but for our own.
fn packages(tree: &str) -> Vec<Package> {
    let mut packages: Vec<_> = tree.lines().filter_map(package).collect();
    packages.sort();
    packages.dedup();
    packages
}

fn package(line: &str) -> Option<Package> {
    let mut parts = line.split('|');
    let mut words = parts.next()?.split_whitespace();
    let (name, version) = (words.next()?, words.next()?.strip_prefix('v')?);
    let licence = parts.next()?.trim();
    // Ours stand in the checkout.
    (!words.any(|word| word.contains(&*steps::root().to_string_lossy()))).then(|| Package {
        name: name.to_owned(),
        version: version.to_owned(),
        licence: licence.to_owned(),
        repository: parts
            .next()
            .unwrap_or_default()
            .trim()
            .trim_end_matches(" (*)")
            .to_owned(),
    })
}

/// Where cargo keeps the sources of a package.
fn folders(package: &Package) -> Vec<PathBuf> {
    let home = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".cargo")));
    let registries = home.and_then(|home| fs::read_dir(home.join("registry/src")).ok());
    let folder = format!("{}-{}", package.name, package.version);
    let of = |registry: fs::DirEntry| registry.path().join(&folder);
    registries
        .into_iter()
        .flatten()
        .flatten()
        .map(of)
        .filter(|path| path.is_dir())
        .collect()
}

fn notices(folder: &Path) -> Vec<String> {
    let is_notice = |path: &PathBuf| {
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        NOTICES.iter().any(|notice| name.starts_with(notice))
    };
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<_> = files.map(|file| file.path()).filter(is_notice).collect();
    paths.sort();
    paths
        .iter()
        .filter_map(|path| fs::read_to_string(path).ok())
        .collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]

    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn the_game_lists_what_is_built_in() {
        let shown = fs::read_to_string(steps::root().join(COMPONENTS)).unwrap();
        let tree = steps::tree_of("antipode", &[]).unwrap();
        assert!(shown == list(&tree), "run `cargo xtask licences`");
        assert!(shown.contains("wgpu ") && shown.lines().count() > 50);
    }

    #[test]
    fn packages_are_told_once_and_ours_are_left_out() {
        let tree = format!(
            "antipode v0.1.0 ({}/crates/app)|MIT OR Apache-2.0|\n\
             glam v0.33.1|MIT OR Apache-2.0|https://example.org/glam\n\
             serde_derive v1.0.1 (proc-macro)|MIT|https://example.org/serde\n\
             glam v0.33.1|MIT OR Apache-2.0|https://example.org/glam (*)\n",
            steps::root().display()
        );
        let found = packages(&tree);
        assert_eq!(found.len(), 2);
        assert_eq!(found[0].name, "glam");
        assert_eq!(found[0].repository, "https://example.org/glam");
        assert_eq!(found[1].version, "1.0.1");
    }
}
