//! `cargo xtask dist`: an archive that runs from anywhere, and a Debian package of the same files.
//!
//! Shaders, fonts, texts and sounds are in the binary; beside it stand its licences and what a desktop wants to know.
//! What was made is unpacked in an empty place and started before it is called good.

use std::borrow::Cow;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::error::Error;
use crate::licences;
use crate::steps::{self, root};

/// The version of everything that is packed.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
/// What the Debian package needs to start, and what it is better with.
const DEPENDS: &str = "libc6 (>= 2.36), libgcc-s1, libasound2, libudev1";
const RECOMMENDS: &str = "libvulkan1, mesa-vulkan-drivers, libegl1, libgl1-mesa-dri, libx11-6, libx11-xcb1, \
                          libxcursor1, libxi6, libxrender1, libxkbcommon-x11-0, libwayland-client0, xdg-utils";

/// A file of the checkout, and where it stands below a prefix such as `/usr`.
const SHARED: [(&str, &str); 3] = [
    (
        "assets/desktop/antipode.desktop",
        "share/applications/antipode.desktop",
    ),
    (
        "assets/icon/antipode.svg",
        "share/icons/hicolor/scalable/apps/antipode.svg",
    ),
    (
        "assets/icon/antipode.png",
        "share/icons/hicolor/256x256/apps/antipode.png",
    ),
];
const DOCUMENTS: [&str; 4] = ["README.md", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT"];

/// Builds the game and packs it. Returns what was made.
///
/// # Errors
/// When a program that is needed fails or is missing, a file cannot be written, or what was packed does not start.
pub fn dist() -> Result<Vec<PathBuf>, Error> {
    let game = steps::build_game()?;
    let out = root().join("target/dist");
    remove(&out)?;
    let name = format!(
        "antipode-{VERSION}-{}-{}",
        std::env::consts::OS,
        std::env::consts::ARCH
    );
    let folder = out.join(&name);
    copy(&game, &folder.join("antipode"))?;
    // The symbols are four fifths of it; a crash names its place by file and line without them.
    run(Command::new("strip").arg(folder.join("antipode")))?;
    for document in DOCUMENTS {
        copy(&root().join(document), &folder.join(document))?;
    }
    let notices = licences::collect(&steps::tree_of("antipode", &[])?);
    write(&folder.join("THIRD-PARTY.txt"), &notices)?;
    for (from, to) in SHARED {
        copy(&root().join(from), &folder.join(to))?;
    }
    let archive = out.join(format!("{name}.tar.gz"));
    pack(&out, &name, &archive)?;
    try_archive(&name, &archive)?;
    let mut made = vec![archive];
    if std::env::consts::OS == "linux" && is_there("dpkg-deb") {
        made.push(debian(&out, &folder)?);
    } else {
        eprintln!("xtask: there is no dpkg-deb here, so no Debian package was made");
    }
    Ok(made)
}

/// Packs a folder of `out`. The same files give the same archive, whoever packs them and when.
///
/// # Errors
/// When tar fails or is missing.
pub fn pack(out: &Path, name: &str, archive: &Path) -> Result<(), Error> {
    let mut tar = Command::new("tar");
    tar.args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner"])
        .args(["--mtime=2026-01-01 00:00:00Z", "--mode=u=rwX,go=rX", "-C"])
        .arg(out)
        .arg("-czf")
        .arg(archive)
        .arg(name)
        // The time of packing stays out of the header, too.
        .env("GZIP", "-n");
    run(&mut tar)
}

/// Unpacks an archive in a new folder of the system's temporary ones, and returns that.
///
/// # Errors
/// When the folder cannot be made, or tar fails.
pub fn unpacked(archive: &Path, folder: &str) -> Result<PathBuf, Error> {
    let elsewhere = std::env::temp_dir().join(format!("{folder}-{}", std::process::id()));
    remove(&elsewhere)?;
    create(&elsewhere)?;
    run(Command::new("tar")
        .arg("-C")
        .arg(&elsewhere)
        .arg("-xzf")
        .arg(archive))?;
    Ok(elsewhere)
}

/// Unpacks the archive elsewhere and plays a script there, with nothing of the checkout in sight.
fn try_archive(name: &str, archive: &Path) -> Result<(), Error> {
    let elsewhere = unpacked(archive, "antipode-dist")?;
    let script = elsewhere.join("first.script");
    write(
        &script,
        "new spherical seed=1 name=First\nsettle\nwait 0.5\nprobe\nsave\nquit\n",
    )?;
    let mut game = Command::new(elsewhere.join(name).join("antipode"));
    game.arg("script")
        .arg(&script)
        .args(["--adapter", "none", "--saves-dir"])
        .arg(elsewhere.join("saves"))
        .current_dir("/")
        .env_clear()
        .env("HOME", &elsewhere);
    let tried = run(&mut game);
    remove(&elsewhere)?;
    tried
}

fn debian(out: &Path, folder: &Path) -> Result<PathBuf, Error> {
    let tree = out.join("debian");
    copy(&folder.join("antipode"), &tree.join("usr/games/antipode"))?;
    for (_, to) in SHARED {
        copy(&folder.join(to), &tree.join("usr").join(to))?;
    }
    let documents = tree.join("usr/share/doc/antipode");
    for document in ["README.md", "CHANGELOG.md"] {
        copy(&folder.join(document), &documents.join(document))?;
    }
    let copyright = ["LICENSE-MIT", "THIRD-PARTY.txt"].map(|file| read(&folder.join(file)));
    let [ours, theirs] = copyright;
    write(
        &documents.join("copyright"),
        &format!(
            "Antipode is licensed under the MIT licence, below, or the Apache licence 2.0\n\
             (/usr/share/common-licenses/Apache-2.0), whichever you choose.\n\n{}\n{}",
            ours?, theirs?
        ),
    )?;
    let architecture = match std::env::consts::ARCH {
        "x86_64" => "amd64",
        "aarch64" => "arm64",
        other => other,
    };
    write(
        &tree.join("DEBIAN/control"),
        &format!(
            "Package: antipode\nVersion: {VERSION}\nArchitecture: {architecture}\nSection: games\n\
             Priority: optional\nMaintainer: The Antipode developers <antipode@localhost>\n\
             Depends: {DEPENDS}\nRecommends: {RECOMMENDS}\n\
             Description: voxel-terrain game in hyperbolic, spherical and flat space\n \
             Walk, dig and build on a ground that bends: the curvature of space is under the\n \
             mouse wheel.\n"
        ),
    )?;
    let package = out.join(format!("antipode_{VERSION}_{architecture}.deb"));
    let mut build = Command::new("dpkg-deb");
    build
        .args(["--build", "--root-owner-group"])
        .arg(&tree)
        .arg(&package);
    // The package says nothing about when it was made.
    build.env("SOURCE_DATE_EPOCH", "1767225600");
    run(&mut build)?;
    remove(&tree)?;
    Ok(package)
}

fn is_there(program: &str) -> bool {
    let output = Command::new(program).arg("--version").output();
    output.is_ok_and(|output| output.status.success())
}

/// Runs a program to its end; what it says on standard error is shown where it fails.
///
/// # Errors
/// When it cannot be started or fails.
pub fn run(command: &mut Command) -> Result<(), Error> {
    let program = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|source| Error::Start {
        program: program.clone(),
        source,
    })?;
    if output.status.success() {
        return Ok(());
    }
    eprint!("{}", String::from_utf8_lossy(&output.stderr));
    let mut typed = vec![program.clone()];
    typed.extend(
        command
            .get_args()
            .map(OsStr::to_string_lossy)
            .map(Cow::into_owned),
    );
    Err(Error::Step {
        name: format!("packing, by {program}"),
        command: typed.join(" "),
    })
}

fn scratch(path: &Path) -> impl FnOnce(std::io::Error) -> Error {
    let path = path.to_owned();
    move |source| Error::Scratch { path, source }
}

fn create(folder: &Path) -> Result<(), Error> {
    fs::create_dir_all(folder).map_err(scratch(folder))
}

/// Removes a folder and all that is in it, if it is there.
///
/// # Errors
/// When it cannot be removed.
pub fn remove(folder: &Path) -> Result<(), Error> {
    match fs::remove_dir_all(folder) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(scratch(folder)(e)),
        _ => Ok(()),
    }
}

/// Copies a file, and makes the folders that it goes into.
///
/// # Errors
/// When the file cannot be read or written.
pub fn copy(from: &Path, to: &Path) -> Result<(), Error> {
    create(to.parent().unwrap_or(to))?;
    fs::copy(from, to).map(drop).map_err(scratch(from))
}

fn read(path: &Path) -> Result<String, Error> {
    fs::read_to_string(path).map_err(scratch(path))
}

/// Writes a text, and makes the folders that it goes into.
///
/// # Errors
/// When it cannot be written.
pub fn write(path: &Path, text: &str) -> Result<(), Error> {
    create(path.parent().unwrap_or(path))?;
    fs::write(path, text).map_err(scratch(path))
}
