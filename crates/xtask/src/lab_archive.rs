//! `cargo xtask lab-archive`: the laboratory, the game and the image suite in one archive, for whoever has a graphics card.
//!
//! It is small enough to be sent and needs no network. What was made is unpacked in an empty place, and measures a
//! software adapter there for a moment, before it is called good.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::dist::{self, VERSION};
use crate::error::Error;
use crate::licences;
use crate::steps::{self, SHIPPED, root};

/// Most bytes of the archive.
const MOST_BYTES: u64 = 60_000_000;
/// How to run it, in ten lines.
const README: &str = include_str!("lab_archive.txt");
const LICENCES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];
/// The image suite's scripts and expected pictures, in the checkout.
const SCENES: &str = "tests/scenes";
/// What the laboratory is built without: other people's noise and meshers, which it only measures terrain beside.
const BARE: [&str; 1] = ["--no-default-features"];

/// Builds both programs, as players get them where no other profile is named, and packs them. Returns the archive.
///
/// # Errors
/// When a program that is needed fails or is missing, a file cannot be written, the archive is too large, or what was
/// packed does not measure.
pub fn lab_archive(profile: Option<&str>) -> Result<PathBuf, Error> {
    let profile = profile.unwrap_or(SHIPPED);
    let programs = [
        steps::build_program("antipode", profile, &[])?,
        steps::build_program("antipode-lab", profile, &BARE)?,
    ];
    let out = root().join("target/lab-archive");
    dist::remove(&out)?;
    let name = format!(
        "antipode-lab-{VERSION}-{}-{}",
        std::env::consts::OS,
        std::env::consts::ARCH
    );
    let folder = out.join(&name);
    for program in programs {
        let own = folder.join(program.file_name().unwrap_or_default());
        dist::copy(&program, &own)?;
        dist::run(Command::new("strip").arg(&own))?;
    }
    for (from, to) in contents(root())? {
        dist::copy(&from, &folder.join(to))?;
    }
    dist::write(&folder.join("README.txt"), README)?;
    let trees = [
        steps::tree_of("antipode", &[])?,
        steps::tree_of("antipode-lab", &BARE)?,
    ];
    let notices = licences::collect(&trees.concat());
    dist::write(&folder.join("THIRD-PARTY.txt"), &notices)?;
    let archive = out.join(format!("{name}.tar.gz"));
    dist::pack(&out, &name, &archive)?;
    fits(&archive)?;
    try_archive(&name, &archive)?;
    Ok(archive)
}

/// The files of a checkout that are packed as they are, each with its place in the archive.
fn contents(checkout: &Path) -> Result<Vec<(PathBuf, PathBuf)>, Error> {
    let scenes = checkout.join(SCENES);
    let unreadable = |source| Error::Unreadable {
        path: scenes.clone(),
        source,
    };
    let mut files = LICENCES.map(|it| (checkout.join(it), it.into())).to_vec();
    for entry in fs::read_dir(&scenes).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let is_of_suite = path
            .extension()
            .is_some_and(|it| it == "script" || it == "png");
        if let (true, Some(name)) = (is_of_suite, path.file_name()) {
            let to = Path::new("scenes").join(name);
            files.push((path, to));
        }
    }
    files.sort();
    Ok(files)
}

/// Whether an archive is small enough to be sent.
fn fits(archive: &Path) -> Result<(), Error> {
    let told = fs::metadata(archive).map_err(|source| Error::Scratch {
        path: archive.to_owned(),
        source,
    })?;
    if told.len() <= MOST_BYTES {
        return Ok(());
    }
    Err(Error::TooLarge {
        path: archive.to_owned(),
        bytes: told.len(),
        most_bytes: MOST_BYTES,
    })
}

/// Unpacks the archive elsewhere and measures there, with nothing of the checkout in sight.
fn try_archive(name: &str, archive: &Path) -> Result<(), Error> {
    let elsewhere = dist::unpacked(archive, "antipode-lab-archive")?;
    let mut laboratory = Command::new(elsewhere.join(name).join("antipode-lab"));
    laboratory
        .args(["gpu", "--quick", "--adapter", "software", "--out"])
        .arg(elsewhere.join("report"))
        .current_dir("/")
        .env_clear()
        .env("HOME", &elsewhere);
    let tried = dist::run(&mut laboratory);
    dist::remove(&elsewhere)?;
    tried
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    #[test]
    fn the_archive_has_every_script_and_the_picture_of_each_of_its_shots() {
        let files = contents(root()).unwrap();
        let has = |to: &str| files.iter().any(|(_, own)| own == Path::new(to));
        assert!(files.iter().all(|(from, _)| from.is_file()), "{files:?}");
        let mut shots = 0;
        for space in ["euclidean", "hyperbolic", "spherical"] {
            let script = format!("scenes/{space}.script");
            assert!(has(&script), "{script}");
            let text = fs::read_to_string(root().join("tests").join(script)).unwrap();
            for shot in text.lines().filter_map(|line| line.strip_prefix("shot ")) {
                assert!(has(&format!("scenes/{shot}")), "{shot}");
                shots += 1;
            }
        }
        assert!(LICENCES.iter().all(|it| has(it)));
        assert_eq!(files.len(), LICENCES.len() + 3 + shots, "{files:?}");
    }

    #[test]
    fn the_readme_has_at_most_ten_lines_and_says_what_to_run() {
        assert!(README.lines().count() <= 10, "{README}");
        assert!(README.contains("./antipode-lab gpu") && README.contains("gpu-report"));
    }

    #[test]
    fn an_archive_that_is_too_large_is_refused_with_its_size() {
        let path = std::env::temp_dir().join(format!("xtask-archive-{}", std::process::id()));
        let file = fs::File::create(&path).unwrap();
        file.set_len(MOST_BYTES).unwrap();
        assert!(fits(&path).is_ok());
        file.set_len(MOST_BYTES + 1_000_000).unwrap();
        let words = fits(&path).unwrap_err().to_string();
        fs::remove_file(&path).unwrap();
        assert!(
            words.contains("61.0 MB") && words.contains("60 MB"),
            "{words}"
        );
    }
}
