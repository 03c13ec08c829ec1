//! The image suite: scripts that the game's own program plays, and how far the pictures that they take are from those
//! that lie beside them, which a software adapter (Mesa's lavapipe) drew.
//!
//! Pictures are taken as a software adapter takes them (one sample a pixel, its shadows, no mirror), whatever draws, so
//! that what is left to differ is how an adapter computes.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use antipode_render::AdapterChoice;
use image::RgbImage;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};

use super::blocks::{Block, worst_block};
use crate::LabError;

/// The scripts, by their files' names without the ending.
pub const SCENES: [&str; 3] = ["euclidean", "hyperbolic", "spherical"];
/// How far the mean of a block may be off, steps of 1/255.
pub const MOST_STEPS: f64 = 3.0;
/// What the expected pictures were taken with.
const OPTIONS: [&str; 4] = ["--size", "256x144", "--view-distance", "2"];
/// Settings whose automatic values depend on what draws, as they are in software.
const SETTINGS: &str = "(schema: 1, settings: {\"msaa\": \"off\", \"shadows\": \"low\", \"rear-mirror\": \"off\", \"preset\": \"software\"})\n";
/// How often is looked whether the game is done.
const LOOK: Duration = Duration::from_millis(20);

/// Who plays the scripts, and where they lie.
#[derive(Clone, Debug)]
pub struct Suite {
    /// The game's program.
    pub game: PathBuf,
    /// The scripts and the expected pictures.
    pub scenes: PathBuf,
    /// What the game draws with.
    pub adapter: AdapterChoice,
    /// How long a script may take.
    pub patience: Duration,
}

/// What a script came to.
#[derive(Clone, Debug)]
pub struct Played {
    /// The adapter that the game drew with, by its own word.
    pub adapter: String,
    /// The pictures, in the order in which the script takes them.
    pub shots: Vec<Shot>,
}

/// A picture that was taken.
#[derive(Clone, Debug)]
pub struct Shot {
    /// Its file's name.
    pub name: String,
    /// What the game drew.
    pub found: RgbImage,
}

/// The pictures that a script takes, by their files' names.
pub fn shots(script: &str) -> impl Iterator<Item = &str> {
    script.lines().filter_map(|line| line.strip_prefix("shot "))
}

fn failed(why: String) -> LabError {
    LabError::Suite(why)
}

impl Suite {
    /// What is missing to draw the suite at all, in a sentence.
    pub fn lacks(&self) -> Option<String> {
        let (game, scenes) = (&self.game, &self.scenes);
        if !game.is_file() {
            return Some(format!(
                "The image suite was not drawn: there is no game at {}. Put the program {} beside the laboratory, or name \
                 it with --game FILE.",
                game.display(),
                super::program("antipode"),
            ));
        }
        let is_there = |scene: &&&str| scenes.join(format!("{scene}.script")).is_file();
        let missing = SCENES.iter().find(|scene| !is_there(scene))?;
        Some(format!(
            "The image suite was not drawn: {} has no {missing}.script. Name the folder of the scripts and their pictures \
             with --scenes DIR; in a checkout it is tests/scenes.",
            scenes.display()
        ))
    }

    /// The script of a scene.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn script(&self, scene: &str) -> Result<String, LabError> {
        let path = self.scenes.join(format!("{scene}.script"));
        fs::read_to_string(&path).map_err(|source| LabError::Read { path, source })
    }

    /// The expected picture of that name.
    ///
    /// # Errors
    /// When it cannot be read.
    pub fn expected(&self, name: &str) -> Result<RgbImage, LabError> {
        picture(&self.scenes.join(name))
    }

    /// Writes a picture as the expected one of that name.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn expect(&self, name: &str, found: &RgbImage) -> Result<(), LabError> {
        let path = self.scenes.join(name);
        let unwritable = |source| LabError::Write {
            path: path.clone(),
            source,
        };
        let file = File::create(&path).map_err(unwritable)?;
        let best = (CompressionType::Best, FilterType::Adaptive);
        let encoder = PngEncoder::new_with_quality(file, best.0, best.1);
        let written = found.write_with_encoder(encoder);
        written.map_err(|e| unwritable(std::io::Error::other(e)))
    }

    /// Plays the script of a scene in an empty folder, which then has its pictures.
    ///
    /// # Errors
    /// When the game cannot be started, fails, takes too long or takes no picture; the words of the game are among the
    /// failure's.
    pub fn play(&self, scene: &str, folder: &Path) -> Result<Played, LabError> {
        let script = self.script(scene)?;
        let settings = folder.join("suite.ron");
        let write = |path: &Path, text: &str| {
            let path = path.to_owned();
            fs::write(&path, text).map_err(|source| LabError::Write { path, source })
        };
        write(&settings, SETTINGS)?;
        let file = folder.join(format!("{scene}.script"));
        // The last line of standard output tells which adapter drew.
        write(&file, &format!("{script}\nprobe\n"))?;
        let [said, complained] = self.run(scene, &file, &settings, folder)?;
        let adapter = adapter_in(&said).ok_or_else(|| {
            failed(format!(
                "The game did not tell its adapter after {scene}.script. {complained}"
            ))
        })?;
        let shots = shots(&script).map(|name| {
            let found = picture(&folder.join(name))?;
            let name = name.to_owned();
            Ok(Shot { name, found })
        });
        Ok(Played {
            adapter,
            shots: shots.collect::<Result<_, LabError>>()?,
        })
    }

    /// Runs the game, and returns what it wrote on standard output and standard error.
    fn run(
        &self,
        scene: &str,
        script: &Path,
        settings: &Path,
        folder: &Path,
    ) -> Result<[String; 2], LabError> {
        let files = ["out", "err"].map(|end| folder.join(format!("{scene}.{end}")));
        let made = |path: &PathBuf| {
            File::create(path).map_err(|source| LabError::Write {
                path: path.clone(),
                source,
            })
        };
        let mut command = Command::new(&self.game);
        command
            .env_remove("ANTIPODE_SAVES")
            .args(["script".as_ref(), script.as_os_str()])
            .args(["--adapter", named(self.adapter)])
            .args(["--config".as_ref(), settings.as_os_str()])
            .args(["--saves-dir".as_ref(), folder.as_os_str()])
            .args(OPTIONS)
            .current_dir(folder)
            .stdin(Stdio::null())
            .stdout(made(&files[0])?)
            .stderr(made(&files[1])?);
        let child = command.spawn().map_err(|e| {
            failed(format!(
                "The game {} could not be started: {e}.",
                self.game.display()
            ))
        })?;
        let status = self.ended(scene, child)?;
        let [said, complained] = files.map(|path| fs::read_to_string(path).unwrap_or_default());
        if status == Some(0) {
            return Ok([said, complained]);
        }
        let words = complained.trim();
        Err(failed(format!(
            "The game failed to play {scene}.script: {words}"
        )))
    }

    /// The exit status of the game, which is stopped where it takes too long.
    fn ended(&self, scene: &str, mut child: Child) -> Result<Option<i32>, LabError> {
        let began = Instant::now();
        while began.elapsed() < self.patience {
            match child.try_wait() {
                Ok(Some(status)) => return Ok(status.code()),
                Ok(None) => thread::sleep(LOOK),
                Err(e) => return Err(failed(format!("The game cannot be waited for: {e}."))),
            }
        }
        // It may have ended meanwhile.
        let _ = child.kill();
        let _ = child.wait();
        Err(failed(format!(
            "The game was stopped: it had not played {scene}.script after {} s.",
            self.patience.as_secs()
        )))
    }
}

fn named(adapter: AdapterChoice) -> &'static str {
    match adapter {
        AdapterChoice::Auto => "auto",
        AdapterChoice::Gpu => "gpu",
        AdapterChoice::Software => "software",
    }
}

/// The adapter in the last probe of what the game wrote.
fn adapter_in(said: &str) -> Option<String> {
    let probe: serde_json::Value = serde_json::from_str(said.lines().last()?).ok()?;
    Some(probe.get("adapter")?.as_str()?.to_owned())
}

fn picture(path: &Path) -> Result<RgbImage, LabError> {
    let unreadable = |e| LabError::Read {
        path: path.to_owned(),
        source: std::io::Error::other(e),
    };
    Ok(image::open(path).map_err(unreadable)?.to_rgb8())
}

/// The block of a picture that is farthest from the expected one.
///
/// # Errors
/// When the pictures differ in size.
pub fn worst(name: &str, found: &RgbImage, expected: &RgbImage) -> Result<Block, LabError> {
    worst_block(found, expected).ok_or_else(|| {
        let [(w, h), (x, y)] = [found, expected].map(RgbImage::dimensions);
        failed(format!(
            "{name} has {w}x{h} pixels, and {x}x{y} were expected."
        ))
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests fail by panicking")]
    use super::*;

    fn suite(game: PathBuf, scenes: PathBuf) -> Suite {
        Suite {
            game,
            scenes,
            adapter: AdapterChoice::Software,
            patience: Duration::from_secs(5),
        }
    }

    #[test]
    fn a_missing_game_or_script_is_a_sentence_that_says_what_to_do() {
        let empty = tempfile::tempdir().unwrap();
        let nowhere = empty.path().join("antipode");
        let lacks = suite(nowhere.clone(), empty.path().to_owned()).lacks();
        assert!(lacks.is_some_and(|it| it.contains("no game at") && it.contains("--game")));
        fs::write(&nowhere, "").unwrap();
        let lacks = suite(nowhere.clone(), empty.path().to_owned()).lacks();
        assert!(lacks.is_some_and(|it| it.contains("euclidean.script") && it.contains("--scenes")));
        for scene in SCENES {
            fs::write(empty.path().join(format!("{scene}.script")), "").unwrap();
        }
        assert_eq!(suite(nowhere, empty.path().to_owned()).lacks(), None);
    }

    /// Plays the first scene by the shell, which takes the file `script` of the folder for its program.
    #[cfg(unix)]
    fn played(program: &str, patience: Duration) -> Result<Played, LabError> {
        let [scenes, work] = [(); 2].map(|()| tempfile::tempdir().unwrap());
        fs::write(scenes.path().join("euclidean.script"), "shot day.png\n").unwrap();
        fs::write(work.path().join("script"), program).unwrap();
        let mut suite = suite(PathBuf::from("/bin/sh"), scenes.path().to_owned());
        suite.patience = patience;
        RgbImage::new(4, 2)
            .save(work.path().join("taken.png"))
            .unwrap();
        suite.play("euclidean", work.path())
    }

    #[cfg(unix)]
    #[test]
    fn a_game_that_fails_or_hangs_is_told_in_its_words_and_stopped() {
        let patience = Duration::from_mins(1);
        let said = |program: &str, patience| played(program, patience).unwrap_err().to_string();
        let words = said("echo 'no such space' >&2; exit 1", patience);
        assert!(words.contains("failed to play euclidean.script: no such space"));
        assert!(said("exit 0", patience).contains("did not tell its adapter"));
        let words = said("echo '{\"adapter\": \"a\"}'", patience);
        assert!(words.contains("day.png cannot be read"), "{words}");
        let words = said("exec sleep 600", Duration::from_millis(100));
        assert!(words.contains("was stopped"), "{words}");
    }

    #[cfg(unix)]
    #[test]
    fn what_a_game_draws_and_with_what_is_taken_over() {
        let program = "mv taken.png day.png; echo '{\"adapter\": \"a card\"}'";
        let played = played(program, Duration::from_mins(1)).unwrap();
        assert_eq!(played.adapter, "a card");
        let shot = &played.shots[0];
        assert_eq!(shot.found.dimensions(), (4, 2));
        let black = RgbImage::new(4, 2);
        assert_eq!(worst(&shot.name, &shot.found, &black).unwrap().steps, 0.0);
        let other = worst(&shot.name, &shot.found, &RgbImage::new(2, 4));
        assert!(other.unwrap_err().to_string().contains("4x2"));
    }

    #[test]
    fn the_adapter_is_read_from_the_last_probe() {
        let said = "{\"adapter\": \"one\"}\n{\"adapter\": \"two\"}\n";
        assert_eq!(adapter_in(said).as_deref(), Some("two"));
        assert_eq!(adapter_in("no probe"), None);
    }
}
